// Binds the labels of a figure to what they name, and places them where they hide least.

import {dot, quarterTurn, unitOf} from './closure.js';
import {endsOf} from './held_marks.js';
import {PlacedLabels} from './placed_labels.js';
import {along, apart, boxOf, leastVector, minus, parsePath, samePlace, spotsOf} from './path.js';
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./types.js').Spot} Spot */

export class LabelBinder {
    /** @param {FigureView} view */
    constructor(view) {
        this.view = view;
        this.placed = new PlacedLabels(view);
    }
    bindLabels() {
        this.bindLabelsOfDetails();
        const isDetailed = this.view.svg.querySelector('[data-figure=detail]') !== null;
        [...this.view.svg.querySelectorAll('g.label')].forEach((label, i) => {
            if (label.closest('.dimension') || label.closest('g.figure') !== this.view.group) return;
            const told = this.view.info.labels[i] ?? [],
                names = told.length > 0 ? told : [label.getAttribute('data-label') ?? ''];
            const box = /** @type {SVGGElement} */ (label).getBBox();
            const centre = {x: box.x + box.width / 2, y: box.y + box.height / 2};
            const parts = this.partsOf(label, centre);
            if (isDetailed && /^[IVX]+$/.test(names[0])) return parts.forEach((part) => part.classList.add('still'));
            if (this.view.held && label.hasAttribute('data-on')) return this.view.heldBinder?.bindLabel(label, parts,
                centre, box);
            this.cutNumber(label);
            const vector = names.find((name) => this.view.vector(name));
            const spot = names.find((name) => this.view.spot(name));
            if (vector !== undefined)
                this.view.vectorLabels.push({label, box, value: () => this.view.sizeOf(vector), unit: this.view.unit});
            if (vector !== undefined) this.bindVectorLabel(parts, vector, centre, box);
            else if (spot !== undefined && !this.view.isMechanism)
                this.bindAround(parts, () => this.view.spot(spot), centre, box);
            else if (spot !== undefined) this.bindToPlace(parts, () => this.view.spot(spot));
            else if (this.view.isMechanism) this.bindMechanismLabel(label, parts, centre, box);
            else this.bindLineLabel(label, centre);
        });
    }
    /**
     * The label of a mark repeated in a detail stands in the detail. Away from the drawn position there is no detail,
     * so a copy of the label stands here.
     */
    bindLabelsOfDetails() {
        if (this.view.isMechanism || this.view.isHeld) return;
        const all = [...this.view.svg.querySelectorAll('g.label')], own = new Set(all.flatMap((label, i) =>
            label.closest('g.figure') === this.view.group ? this.view.info.labels[i] ?? [] : []));
        all.forEach((label, i) => {
            const detail = label.closest('g.figure[data-figure=detail]')?.getAttribute('data-id') ?? '';
            const vector = (this.view.info.labels[i] ?? []).find(
                (name) => this.view.keys.has(name) && !own.has(name) && this.view.vector(name),
            );
            if (vector === undefined || !detail.startsWith(`${this.view.id}-detail`)) return;
            own.add(vector);
            const copy = /** @type {SVGGElement} */ (label.cloneNode(true)),
                box = /** @type {SVGGElement} */ (label).getBBox();
            copy.classList.add('number');  // shown only away from the drawn position
            copy.classList.remove('label');
            this.view.group.append(copy);
            this.bindVectorLabel([copy], vector, {x: box.x + box.width / 2, y: box.y + box.height / 2}, box);
        });
    }
    /**
     * The label, its parts in other colours, and its circle.
     * @param {Element} label
     * @param {Spot} centre
     */
    partsOf(label, centre) {
        const parts = [label];
        for (let next = label.nextElementSibling; next?.matches('g.text'); next = next.nextElementSibling)
            parts.push(next);
        const before = label.previousElementSibling;
        if (before?.tagName === 'path') {
            const box = boxOf(spotsOf(parsePath(before.getAttribute('d') ?? '')));
            if (apart(box.centre, centre) < 1.5 && box.right - box.left < 8) parts.push(before);
        }
        for (const part of leaderBefore(parts[parts.length - 1], centre)) {
            parts.push(part);
            this.view.taken.add(part);
        }
        return parts;
    }
    /**
     * @param {Element[]} parts
     * @param {() => Spot | null} place
     */
    bindToPlace(parts, place) {
        const drawn = place();
        if (!drawn) return parts.forEach((part) => part.classList.add('still'));
        const placed = parts[0].matches('g.label') ? this.placed.note(parts) : null;
        this.view.bindings.push(() => {
            const now = place();
            for (const part of parts) {
                this.view.marks.show(part, now !== null);
                if (now) this.view.marks.translate(part, minus(now, drawn));
            }
            if (placed && now) placed.by = minus(now, drawn);
        });
    }
    /**
     * A vertex's label: it keeps its distance, and goes to a side where it can be read.
     * @param {Element[]} parts
     * @param {() => Spot | null} place
     * @param {Spot} centre
     * @param {{width: number, height: number}} box
     */
    bindAround(parts, place, centre, box) {
        const drawn = place();
        if (!drawn) return parts.forEach((part) => part.classList.add('still'));
        const off = minus(centre, drawn), x = box.width / 2 + 1.2, y = box.height / 2 + 1.2;
        const sides = [off, {x: -off.x, y: off.y}, {x: off.x, y: -off.y}, {x: -off.x, y: -off.y},
            {x, y: 0}, {x: -x, y: 0}, {x: 0, y}, {x: 0, y: -y}, {x, y}, {x: -x, y: -y}, {x, y: -y}, {x: -x, y}];
        this.placeLabel(parts, centre, box, () => {
            const now = place();
            return now ? [1, 1.7].flatMap((far) => sides.map((by) => along(now, far, by))) : [];
        });
    }
    /**
     * A label that belongs to a body, not to a point: at its place, or not far from it.
     * @param {Element[]} parts
     * @param {() => Spot} place
     * @param {Spot} centre
     * @param {{width: number, height: number}} box
     */
    bindNear(parts, place, centre, box) {
        const turns = Array.from({length: 8}, (_, i) => i * Math.PI / 4);
        const offs = [0, ...[3, 6, 10].flatMap((far) => turns.map((turn) => ({x: far * Math.cos(turn),
            y: far * Math.sin(turn)})))];
        // With its circle.
        const size = Math.max(box.width, box.height) + 2, round = {width: size, height: size};
        this.placeLabel(parts, centre, round, () => offs.map((off) => off === 0 ? place() : along(place(), 1,
            /** @type {Spot} */ (off))));
    }
    /**
     * Puts the label where it hides least; if there is no place, hides it.
     * @param {Element[]} parts
     * @param {Spot} centre
     * @param {{width: number, height: number}} box
     * @param {() => Spot[]} placesNow
     */
    placeLabel(parts, centre, box, placesNow) {
        const placed = this.placed.note(parts, centre, box);
        this.view.placings.push(() => {
            const places = placesNow();
            parts.forEach((part) => this.view.marks.show(part, places.length > 0));
            if (places.length === 0) return;
            const by = minus(this.view.crowd.best(places, box), centre);
            placed.by = by;
            parts.forEach((part) => this.view.marks.translate(part, by));
        });
    }
    /**
     * The label keeps its side of the vector and its distance from it.
     * @param {Element[]} parts
     * @param {string} name
     * @param {Spot} centre
     * @param {{width: number, height: number}} box
     */
    bindVectorLabel(parts, name, centre, box) {
        const place = /** @type {[Spot, Spot]} */ (this.view.vector(name));
        if (apart(...place) < leastVector) return this.bindToPlace(parts, () => this.view.vector(name)?.[0] ?? null);
        const axis = this.view.isMechanism
            ? null
            : this.view.group.querySelector(`:scope > g.vector[data-name="${name}"] > line.axis`);
        this.bindBeside(parts, axis ? endsOf(axis) : place, () => this.view.drawnVector(name), centre, box);
    }
    /**
     * The label keeps its side and its distance while it can be read there.
     * @param {Element[]} parts
     * @param {[Spot, Spot]} drawn
     * @param {() => [Spot, Spot] | null} place
     * @param {Spot} centre
     * @param {{width: number, height: number}} box
     */
    bindBeside(parts, drawn, place, centre, box) {
        // A leader started where the label was.
        for (const part of parts) if (this.view.taken.has(part)) part.classList.add('still');
        const middle = (/** @type {[Spot, Spot]} */ [tail, tip]) => ({
            x: (tail.x + tip.x) / 2,
            y: (tail.y + tip.y) / 2,
        });
        const reach = (/** @type {Spot} */ n) => (Math.abs(n.x) * box.width) / 2 + (Math.abs(n.y) * box.height) / 2;
        const length = apart(drawn[0], drawn[1]);
        const e = unitOf(minus(drawn[1], drawn[0])),
            n = quarterTurn(e),
            off = minus(centre, middle(drawn));
        const side = Math.sign(dot(off, n)) || 1,
            share = dot(off, e) / length,
            clearance = Math.abs(dot(off, n)) - reach(n);
        // Beyond an end of a short vector, or at a leader, it would be far from a long one or on it.
        const near = Math.min(Math.max(share, -0.4), 0.4), close = Math.min(Math.max(clearance, 0.8), 2.5);
        const isNear = Math.hypot(off.x, off.y) < length / 2 + 25;  // otherwise it was in a detail
        const sides = [near, 0, 0.3, -0.3].flatMap((part) => [{part, across: side}, {part, across: -side}]);
        this.placeLabel(parts, centre, box, () => {
            const now = place(), size = now ? apart(now[0], now[1]) : 0;
            if (!now || size < leastVector) return [];
            const toward = unitOf(minus(now[1], now[0])),
                across = quarterTurn(toward);
            const beside = (/** @type {number} */ t, /** @type {number} */ by) =>
                along(along(middle(now), t * size, toward), by, across);
            const isAsDrawn = isNear && apart(minus(now[1], now[0]), minus(drawn[1], drawn[0])) < samePlace;
            return isAsDrawn ? [beside(share, side * (clearance + reach(across)))] :
                sides.map((each) => beside(each.part, each.across * (close + reach(across))));
        });
    }
    /**
     * Text along a construction line.
     * @param {Element} label
     * @param {Spot} drawnCentre
     */
    bindLineLabel(label, drawnCentre) {
        const pivot = (label.getAttribute('transform') ?? '').match(/rotate\((\S+) (\S+) (\S+)\)/);
        const centre = pivot ? {x: Number(pivot[2]), y: Number(pivot[3])} : drawnCentre;
        const statement = label.closest('[data-statement]')?.getAttribute('data-statement') ?? null;
        if (statement === null) return;
        let best = null, least = 6;
        for (const [figure, name, said] of this.view.motion.data.plans[0].lines) {
            const line = figure === this.view.id && String(said) === statement ? this.view.line(name) : null;
            const off = line ? Math.abs(dot(minus(centre, line.points[0]), quarterTurn(line.direction))) : least;
            if (line && off < least) [best, least] = [{name, line}, off];
        }
        if (!best) return label.classList.add('still');
        const {name, line} = best;
        const last = line.points.length - 1,
            from = line.points[last];
        const t = dot(minus(centre, from), line.direction),
            n = dot(minus(centre, from), quarterTurn(line.direction));
        const size = /** @type {SVGGElement} */ (label).getBBox(),
            steps = [0, 1, 2, -1, -2].map((k) => k * (size.width / 2 + 1));
        this.view.placings.push(() => {
            const now = this.view.line(name);
            const fits = now !== null && last < now.points.length;
            this.view.marks.show(label, fits);
            if (!fits) return;
            const across = quarterTurn(now.direction), places = steps.flatMap((step) => [n, -n].map((side) =>
                along(along(now.points[last], t + step, now.direction), side, across)));
            const {x: c, y: s} = pivot ? now.direction : {x: 1, y: 0};
            const at = this.view.crowd.best(places, {width: Math.abs(c) * size.width + Math.abs(s) * size.height,
                height: Math.abs(s) * size.width + Math.abs(c) * size.height});
            const degrees = (/** @type {Spot} */ a) => Math.atan2(a.y, a.x) * 180 / Math.PI;
            const own = pivot ? Number(pivot[1]) : 0;
            let turn = degrees(now.direction) - degrees(line.direction);
            const upright = ((own + turn) % 360 + 540) % 360 - 180;  // −180 … 180
            if (Math.abs(upright) > 90) turn += 180;
            this.view.marks.transform(label,
                `translate(${(at.x - centre.x).toFixed(4)} ${(at.y - centre.y).toFixed(4)}) ` +
                                      `rotate(${turn.toFixed(3)} ${centre.x} ${centre.y})`);
        });
    }
    /**
     * @param {Element} label
     * @param {Element[]} parts
     * @param {Spot} centre
     * @param {{width: number, height: number}} box
     */
    bindMechanismLabel(label, parts, centre, box) {
        const text = label.getAttribute('data-label') ?? '';
        const first = text.split(' ≡ ')[0];
        const point = this.view.names.points.findIndex(
            (each, i) => each.label === first && apart(this.view.point(i), centre) < 40,
        );
        const body = this.view.names.bodies.findIndex((each) => each.label === text);
        if (/ = [−\d]/.test(text)) return this.bindNumber(parts, text, centre, box);
        const isBalloon = parts.some((part) => part.tagName === 'path');
        if (isBalloon && body > 0) {
            this.bindNear(parts, () => this.view.links.shaped(body, centre), centre, box);
        } else if (point >= 0) {
            this.bindAround(parts, () => this.view.point(point), centre, box);
        } else {
            const ground = this.view.isFree ? -1 : this.view.ground.groundAt(centre, 25);
            if (ground < 0) parts.forEach((part) => part.classList.add('still'));
            else this.bindToPlace(parts, () => this.view.point(ground));
        }
    }
    /**
     * Hides a label with a number that is no longer true: "ω_2 = 5 rad/s" of a driver stays until it is changed.
     * @param {Element[]} parts
     * @param {string} text
     * @param {Spot} centre
     * @param {{width: number, height: number}} box
     */
    bindNumber(parts, text, centre, box) {
        const {motion} = this.view, {settings} = motion.data, ground = this.view.ground.groundAt(centre, Infinity);
        const setting = settings.findIndex(({name}) => text.startsWith(`${name.replace(/^([ωv]) /, '$1_')} = `));
        if (ground < 0 || setting < 0) return parts.forEach((part) => part.classList.add('still'));
        const off = minus(centre, this.view.point(ground)), down = 10 + box.height;
        const places = [0, off.x, -off.x, box.width, -box.width].flatMap((x) =>
            [down, 2 * down].flatMap((y) => [{x, y}, {x, y: -y}]));
        const sides = [off, {x: -off.x, y: off.y}, ...places];
        this.placeLabel(parts, centre, box, () => {
            const isTrue = motion.settings[setting] === settings[setting].value;
            return isTrue ? sides.map((by) => along(this.view.point(ground), 1, by)) : [];
        });
    }
    /**
     * "P_13  (O_2P_13 = 424 mm)": only the name remains away from the drawn position.
     * @param {Element} label
     */
    cutNumber(label) {
        const [name, number] = (label.getAttribute('data-label') ?? '').split('  (');
        if (number === undefined) return;
        const glyphs = [...name.replace(/[_^ ]/g, '')].length;
        [...label.querySelectorAll('use')].slice(glyphs).forEach((glyph) => glyph.classList.add('still'));
    }
}

/**
 * The line from a label to what it names, and the dot at its end.
 * @param {Element} first of the label
 * @param {Spot} centre
 * @returns {Element[]}
 */
function leaderBefore(first, centre) {
    const disc = first.matches('g.text') ? null : first.previousElementSibling, line = disc?.previousElementSibling;
    if (disc?.tagName !== 'path' || line?.tagName !== 'path') return [];
    const ends = spotsOf(parsePath(line.getAttribute('d') ?? '')),
        end = boxOf(spotsOf(parsePath(disc.getAttribute('d') ?? '')));
    const isLeader = end.right - end.left < 1.2 && ends.length === 2 && apart(end.centre, ends[0]) < samePlace;
    return isLeader && apart(ends[1], centre) < apart(ends[0], centre) ? [disc, line] : [];
}
