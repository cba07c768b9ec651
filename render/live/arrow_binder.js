// Binds the arrows of a figure to vectors of the program: shafts, heads that keep their shape, lines that lead aside.

import {quarterTurn, unitOf} from './closure.js';
import {endsOf} from './held_marks.js';
import {written} from './held_shapes.js';
import {drawn} from './measure.js';
import {along, apart, headShare, leastHeadWidth, leastVector, mappedPath, minus, parsePath, samePlace,
    spotsOf} from './path.js';
import {localOf} from './room.js';
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./types.js').Spot} Spot */

export class ArrowBinder {
    /** @param {FigureView} view */
    constructor(view) {
        this.view = view;
    }
    /** @param {Element} node */
    bindVector(node) {
        const name = node.getAttribute('data-name') ?? '',
            axis = node.querySelector('line.axis'),
            place = this.view.vector(name);
        if (!place || apart(place[0], place[1]) < leastVector) return node.classList.add('still');
        if (this.view.isMechanism || !axis) return this.bindArrow(node, place, () => this.view.vector(name));
        const whole = endsOf(axis);
        if (node.querySelector('path:not([fill=none])')) this.view.strokes.push(name);
        this.bindLeads(name, place, whole);
        this.bindArrow(node, whole, () => this.view.drawnVector(name));
    }
    /**
     * Thin lines lead from the ends of a vector's place to where it is drawn.
     * @param {string} name
     * @param {[Spot, Spot]} place
     * @param {[Spot, Spot]} whole
     */
    bindLeads(name, place, whole) {
        if (apart(place[0], whole[0]) < samePlace) return;
        for (const node of this.view.group.querySelectorAll(':scope > path')) {
            const [from, to, more] = spotsOf(parsePath(node.getAttribute('d') ?? ''));
            const end = [0, 1].find(
                (i) => to && !more && apart(from, place[i]) < samePlace && apart(to, whole[i]) < samePlace,
            );
            if (end === undefined || this.view.taken.has(node)) continue;
            this.view.taken.add(node);
            this.view.bindings.push(() => {
                const at = this.view.vector(name), by = this.view.asides.get(name);
                this.view.marks.show(node, by !== undefined && at !== null);
                if (at && by) this.view.marks.set(node, 'd', `M${written(at[end])}L${written(along(at[end], 1, by))}`);
            });
        }
    }
    /**
     * The head of an arrow, and the width of its shaft.
     * @param {Element} node
     */
    headOf(node) {
        const isHead = (/** @type {Element} */ path) => path.getAttribute('fill') !== 'none';
        /** @type {Element[]} */
        const all = node.tagName === 'path' ? [node] : [...node.querySelectorAll('path')];
        const [tip, left, , right] = all
            .filter(isHead)
            .flatMap((path) => spotsOf(parsePath(path.getAttribute('d') ?? '')));
        const shaft = Number(all.find((path) => !isHead(path))?.getAttribute('stroke-width') ?? 0);
        return right
            ? {length: apart(tip, along(left, 0.5, minus(right, left))), width: apart(left, right), shaft}
            : null;
    }
    /**
     * The full head of an arrow that was too short for it, taken from another arrow of the drawing.
     * @param {Element} node
     * @param {number} length
     */
    wholeHeadOf(node, length) {
        const own = this.headOf(node), others = [...this.view.svg.querySelectorAll(`g.${node.classList[0]}`)];
        if (!own || own.length < 0.99 * headShare * length) return own;
        return others
            .flatMap((each) => this.headOf(each) ?? [])
            .reduce((most, each) => (each.length > most.length ? each : most), own);
    }
    /**
     * The arrow's head and shaft keep their shape at any length.
     * @param {Element} node an arrow, or a stroke of one
     * @param {[Spot, Spot]} whole
     * @param {() => [Spot, Spot] | null} place
     */
    bindArrow(node, whole, place) {
        const [tail, tip] = whole, length = apart(tail, tip), local = localOf(tail, tip);
        const all = node.tagName === 'path' ? [node] : [...node.querySelectorAll('path')];
        const paths = all.map((path) => ({path, segments: parsePath(path.getAttribute('d') ?? '')}));
        const own = this.headOf(node), full = this.wholeHeadOf(node, length), head = own?.length ?? 0;
        // A resultant has a second head behind the first.
        const ofHeads = paths.filter(({path}) => path.getAttribute('fill') !== 'none')
            .flatMap(({segments}) => spotsOf(segments));
        const heads = Math.max(head, ...ofHeads.map((at) => length - local(at).t));
        const axis = node.querySelector('line.axis');
        this.view.bindings.push(() => {
            const now = place(), size = now ? apart(now[0], now[1]) : 0;
            this.view.marks.show(node, size >= leastVector);
            if (!now || size < leastVector) return;
            const toward = unitOf(minus(now[1], now[0])), across = quarterTurn(toward);
            const share = full ? Math.min(1, headShare * size / full.length) : 1;
            const wide = full ? full.width * Math.max(share, leastHeadWidth) : 1;
            const [long, broad] = own && full ? [share * full.length / head, wide / own.width] : [1, 1];
            const map = (/** @type {Spot} */ at) => {
                const {t, n: side} = local(at), atTail = t < 0.01 || length - t > heads + 1;
                const from = atTail ? now[0] : now[1];
                return along(
                    along(from, atTail ? t : long * (t - length), toward),
                    (atTail ? 1 : broad) * side,
                    across,
                );
            };
            for (const {path, segments} of paths) {
                this.view.marks.set(path, 'd', mappedPath(segments, map));
                if (full && path.getAttribute('fill') === 'none')
                    this.view.marks.set(path, 'stroke-width', String(Math.min(full.shaft, 0.5 * wide)));
            }
            if (axis) this.view.marks.setEnds(axis, ...now);
        });
    }
}

/**
 * Arrows of vectors that are zero in the drawn position, which therefore has none: they look like the arrows that are
 * there, and are seen only where the vector is not zero.
 */
export class AbsentArrows {
    /** @param {FigureView} view whose own arrows are bound */
    constructor(view) {
        this.view = view;
    }
    add() {
        const {view} = this, {plans} = view.motion.data;
        for (let plan = 1; plan < plans.length; ++plan) {
            if (view.isFree) this.addForces(plans[plan]);
            else if (!view.isMechanism && !view.isHeld) this.addVectors(plan);
        }
    }
    /**
     * Of a polygon.
     * @param {number} plan
     */
    addVectors(plan) {
        const {view} = this;
        for (const [name] of view.vectorsOf(plan)) {
            if (view.keys.has(name)) continue;
            const node = this.copyOf([...view.group.querySelectorAll(':scope > g.vector')], name);
            if (!node) return;
            view.keys.set(name, name);
            view.strokes.push(name);
            this.bind(node, name, () => view.drawnVector(name));
        }
    }
    /**
     * On a body cut free.
     * @param {import('./types.js').Plan} plan
     */
    addForces(plan) {
        const {view} = this, held = /** @type {import('./held_marks.js').HeldMarks} */ (view.held);
        for (const [name, , , , , figure, symbol] of plan.held) {
            const key = `${name} ${name}`;
            if (figure !== view.info.name || symbol === undefined || held.arrows.has(key)) continue;
            const node = this.copyOf([...view.svg.querySelectorAll('g.vector, g.force')], symbol);
            if (!node) return;
            const now = () => {
                const here = held.axes([name, name]), size = held.sizeOf(['', name]) / held.scale;
                return here && /** @type {[Spot, Spot]} */ ([here.at, along(here.at, size, here.e)]);
            };
            held.forces.push(name);
            held.arrows.set(key, {drawn: endsOf(/** @type {Element} */ (node.querySelector('line.axis'))), now});
            view.taken.add(node);
            this.bind(node, symbol, now);
        }
    }
    /**
     * A copy of an arrow with a head, for another vector.
     * @param {Element[]} arrows
     * @param {string} name
     */
    copyOf(arrows, name) {
        const model = arrows.find((each) => each.querySelector('line.axis') &&
            each.querySelector('path:not([fill=none])'));
        const node = /** @type {Element | undefined} */ (model?.cloneNode(true));
        if (!model || !node) return null;
        for (const attribute of ['data-id', 'data-on', 'data-statement', 'data-value']) node.removeAttribute(attribute);
        node.querySelector('title')?.remove();
        node.setAttribute('data-name', name);
        node.classList.add('number');  // shown only away from the drawn position
        model.parentElement?.append(node);
        return node;
    }
    /**
     * @param {Element} node
     * @param {string} name
     * @param {() => [Spot, Spot] | null} place
     */
    bind(node, name, place) {
        const {view} = this, axis = endsOf(/** @type {Element} */ (node.querySelector('line.axis')));
        view.arrows.bindArrow(node, axis, place);
        const middle = along(axis[0], 0.5, minus(axis[1], axis[0])), [letter, low = ''] = name.split('_');
        const text = drawn(/** @type {Element} */ (node.parentElement), 'text',
            {class: 'number symbol', x: middle.x.toFixed(3), y: (middle.y - 1.5).toFixed(3)});
        drawn(text, 'tspan', {'font-style': 'italic'}).textContent = letter;
        drawn(text, 'tspan', {dy: 1, 'font-size': 2.6}).textContent = low;
        const box = /** @type {SVGTextElement} */ (text).getBBox();
        view.labels.bindBeside([text], axis, place, {x: box.x + box.width / 2, y: box.y + box.height / 2}, box);
    }
}
