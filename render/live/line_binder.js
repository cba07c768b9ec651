// Binds single strokes of a figure: construction lines, vertices, lines through centres; finds the scale bar.

import {dot, quarterTurn, unitOf} from './closure.js';
import {along, apart, boxOf, leastVector, mappedPath, minus, parsePath, samePlace, spotsOf} from './path.js';
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./path.js').Segment} Segment */
/** @typedef {import('./types.js').Spot} Spot */

export class LineBinder {
    /** @param {FigureView} view */
    constructor(view) {
        this.view = view;
    }
    /**
     * Beside the figures of a drawing: a half-filled bar, its outline and its label.
     * @param {Element} node
     */
    bindScaleBar(node) {
        const d = node.tagName === 'path' && node.getAttribute('fill') !== 'none' ? node.getAttribute('d') ?? '' : '';
        const spots = /^M[^A]*Z$/.test(d) ? spotsOf(parsePath(d)) : [], box = boxOf(spots);
        if (spots.length !== 4 || box.bottom - box.top > 2) return;
        for (let next = node, k = 0; next && k < 4; next = /** @type {Element} */ (next.nextElementSibling), ++k) {
            this.view.measures.push(next);
            this.view.scaleBar.push(next);
        }
    }
    /**
     * A single stroke: a construction line, a disc at a vertex, the scale bar.
     * @param {Element} node
     */
    bindPath(node) {
        const segments = parsePath(node.getAttribute('d') ?? '');
        const spots = spotsOf(segments), box = boxOf(spots);
        const name = this.vertexAt(box.centre);
        if (segments.some(({letter}) => letter === 'A') && name !== null) {
            const drawn = box.centre;
            this.view.bindings.push(() => {
                const now = this.view.spot(name);
                this.view.marks.show(node, now !== null);
                if (now) this.view.marks.translate(node, minus(now, drawn));
            });
        } else if (spots.length === 2 && node.hasAttribute('data-statement')) {
            this.bindLine(node, segments, spots);
        } else if (node.hasAttribute('data-statement')) {
            node.classList.add('still');
        } else {
            this.view.measures.push(node);
        }
    }
    /** @param {Spot} at */
    vertexAt(at) {
        const own = this.view.isMechanism ? '' : this.view.id;
        for (const [figure, name] of this.view.motion.data.plans[0].spots) {
            const spot = figure === own ? this.view.spot(name) : null;
            if (spot && apart(spot, at) < samePlace) return name;
        }
        return null;
    }
    /**
     * The construction line through all of the points.
     * @param {Spot[]} spots
     * @param {string | null} statement
     */
    lineThrough(spots, statement) {
        const own = this.view.isMechanism ? '' : this.view.id;
        for (const [figure, name, said] of this.view.motion.data.plans[0].lines) {
            if (figure !== own || (statement !== null && String(said) !== statement)) continue;
            const line = this.view.line(name);
            if (!line) continue;
            const off = (/** @type {Spot} */ at) =>
                Math.abs(dot(minus(at, line.points[0]), quarterTurn(line.direction)));
            if (spots.every((at) => off(at) < samePlace)) return {name, line};
        }
        return null;
    }
    /**
     * @param {Element} node
     * @param {Segment[]} segments
     * @param {Spot[]} spots
     */
    bindLine(node, segments, spots) {
        const found = this.lineThrough(spots, node.closest('[data-statement]')?.getAttribute('data-statement') ?? null);
        if (!found) return this.bindBetweenVertices(node, segments, spots);
        const {name, line} = found;
        const ends = spots.map((at) => {
            const distances = line.points.map((point) => apart(point, at));
            const nearest = distances.indexOf(Math.min(...distances));
            return {nearest, beyond: dot(minus(at, line.points[nearest]), line.direction)};
        });
        const sense = Math.sign(dot(minus(line.points[line.points.length - 1], line.points[0]), line.direction));
        this.view.bindings.push(() => {
            const now = this.view.line(name);
            const fits = now !== null && ends.every(({nearest}) => nearest < now.points.length);
            this.view.marks.show(node, fits);
            if (!fits) return;
            // If the points change their order along the line, so do its ends.
            const turned =
                Math.sign(dot(minus(now.points[now.points.length - 1], now.points[0]), now.direction)) * sense < 0
                    ? -1
                    : 1;
            const places = ends.map(({nearest, beyond}) => along(now.points[nearest], turned * beyond, now.direction));
            let next = 0;
            this.view.marks.set(node, 'd', mappedPath(segments, () => places[next++]));
        });
    }
    /**
     * The image of a link whose points are collinear: it goes from vertex to vertex.
     * @param {Element} node
     * @param {Segment[]} segments
     * @param {Spot[]} spots
     */
    bindBetweenVertices(node, segments, spots) {
        const names = spots.flatMap((at) => this.vertexAt(at) ?? []);
        if (names.length < spots.length) return node.classList.add('still');
        this.view.bindings.push(() => {
            const places = names.flatMap((name) => this.view.spot(name) ?? []);
            this.view.marks.show(node, places.length === names.length);
            let next = 0;
            if (places.length === names.length) this.view.marks.set(node, 'd', mappedPath(segments, () =>
                places[next++]));
        });
    }
    /**
     * A line of Aronhold and Kennedy, which contains centres.
     * @param {Element} node
     * @param {Segment[]} segments
     * @param {Spot[]} spots
     */
    bindThroughCentres(node, segments, spots) {
        const toward = unitOf(minus(spots[1], spots[0]));
        const on = Object.values(this.view.names.centres).flatMap((name) => {
            const at = this.view.spot(name);
            return at && Math.abs(dot(minus(at, spots[0]), quarterTurn(toward))) < samePlace ? [{name, at}] : [];
        });
        on.sort((a, b) => dot(minus(a.at, b.at), toward));
        const first = on[0], last = on[on.length - 1];
        if (on.length < 2 || apart(first.at, last.at) < 1) return node.classList.add('still');
        const ends = spots.map((at) => {
            const nearest = apart(at, first.at) < apart(at, last.at) ? first : last;
            return {name: nearest.name, beyond: dot(minus(at, nearest.at), toward)};
        });
        this.view.bindings.push(() => {
            const [from, to] = [this.view.spot(first.name), this.view.spot(last.name)];
            const fits = from !== null && to !== null && apart(from, to) > leastVector;
            this.view.marks.show(node, fits);
            if (!fits) return;
            const now = unitOf(minus(to, from));
            const places = ends.map(({name, beyond}) => along(name === first.name ? from : to, beyond, now));
            let next = 0;
            this.view.marks.set(node, 'd', mappedPath(segments, () => places[next++]));
        });
    }
}
