// Binds the marks with a `data-on` attribute, and their labels, to the places and vectors that the attribute names.

import {dot, quarterTurn} from './closure.js';
import {scaledBy} from './given.js';
import {endsOf, holdOf} from './held_marks.js';
import {HeldForms, isStroke} from './held_forms.js';
import {HeldShapes} from './held_shapes.js';
import {drawn} from './measure.js';
import {along, apart, leastVector, minus} from './path.js';
/** @typedef {import('./held_marks.js').HeldMarks} HeldMarks */
/** @typedef {import('./held_marks.js').Hold} Hold */
/** @typedef {import('./types.js').Spot} Spot */

export class HeldBinder {
    /** @param {HeldMarks} held */
    constructor(held) {
        this.held = held;
        this.shapes = new HeldShapes(held);
        this.forms = new HeldForms(held);
    }
    /** @param {Element} node not a label */
    bind(node) {
        const hold = holdOf(node), {view} = this.held, {on} = hold;
        const paths = node.tagName === 'path' ? [node] : [...node.querySelectorAll('path')];
        const redraw = (/** @type {() => string} */ pathNow) => view.bindings.push(() => {
            const d = pathNow();
            paths.forEach((path, i) => view.marks.show(path, d !== '' && i === 0));
            if (d !== '') view.marks.set(paths[0], 'd', d);
        });
        switch (hold.form) {
            case 'at':
                this.held.places.add(on[0]);
                return view.labels.bindToPlace([node], () => this.held.place(on[0]));
            case 'body':
                return view.links.bindToBody(node, Number(on[0]));
            case 'with':
                return this.bindWith(node, on);
            case 'arrow':
                return on.length > 2 ? this.forms.bindBetween(node, on) : this.bindArrow(node, on);
            case 'couple':
                return this.bindCouple(node, on);
            case 'line':
                return redraw(() => this.shapes.linesNow(hold));
            case 'segment':
                if (on.length > 2) return this.forms.bindBar(node, on);
                if (!isStroke(node)) return this.forms.bindStretch(node, on);
                this.bindAxis(node, on);
                return redraw(() => this.shapes.segmentNow(hold));
            case 'through':
            case 'normal':
                return redraw(() => this.shapes.wholeLineNow(hold));
            case 'circle':
                return redraw(() => this.shapes.circleNow(on));
            case 'arc':
                if (hold.beyond > 0) return this.forms.bindAngle(node, on);
                return redraw(() => this.shapes.arcNow(on));
            default:
                return node.classList.add('still');
        }
    }
    /**
     * @param {Element} node
     * @param {string[]} on
     */
    bindWith(node, on) {
        const {view} = this.held, asDrawn = this.held.axes(on);
        if (!asDrawn) return node.classList.add('still');
        if (on.length === 2) {
            // Of a length that means nothing: only its direction is dragged.
            const {x, y, width, height} = /** @type {SVGGraphicsElement} */ (node).getBBox();
            const off = minus({x: x + width / 2, y: y + height / 2}, asDrawn.at), t = 2 * dot(off, asDrawn.e);
            const free = () => {
                const now = this.held.axes(on);
                return now && along(now.at, t, now.e);
            };
            this.forms.addHandle(node, on[1], () => this.held.place(on[0]), free, Math.sign(t) || 1, () => 0);
        }
        view.bindings.push(() => {
            const now = this.held.axes(on);
            view.marks.show(node, now !== null);
            if (!now) return;
            const c = dot(asDrawn.e, now.e), s = dot(asDrawn.n, now.e);
            const e = now.at.x - c * asDrawn.at.x + s * asDrawn.at.y,
                f = now.at.y - s * asDrawn.at.x - c * asDrawn.at.y;
            view.marks.transform(node, `matrix(${[c, s, -s, c, e, f].map((each) => each.toFixed(6)).join(' ')})`);
        });
    }
    /**
     * An arrow to scale: it keeps its distance from its place, before, behind or beside it.
     * @param {Element} node
     * @param {string[]} on
     */
    bindArrow(node, on) {
        const {view} = this.held, axis = node.querySelector(':scope > line.axis'), known = this.held.axes(on);
        if (!known) return node.classList.add('still');
        const length = this.held.sizeOf(on) / this.held.drawnScale;
        const [tail, tip] = axis ? endsOf(axis) : [known.at, along(known.at, length, known.e)];
        const [begins, ends] = [tail, tip].map((at) => dot(minus(at, known.at), known.e)),
            pulls = Math.abs(begins) <= Math.abs(ends);
        const aside = dot(minus(tail, known.at), known.n);
        const now = () => {
            const here = this.held.axes(on), size = this.held.sizeOf(on) / this.held.scale;
            if (!here || size < leastVector) return null;
            const from = along(along(here.at, pulls ? begins : ends - size, here.e), aside, here.n);
            return /** @type {[Spot, Spot]} */ ([from, along(from, size, here.e)]);
        };
        const whole = /** @type {[Spot, Spot]} */ ([tail, tip]);
        this.forms.addHandle(node, on[1], () => now()?.[pulls ? 0 : 1] ?? null, () => now()?.[pulls ? 1 : 0] ?? null,
            pulls ? 1 : -1, () => this.held.scale);
        this.held.arrows.set(on.join(' '), {drawn: whole, now});
        view.arrows.bindArrow(node, whole, now);
    }
    /**
     * Mirrored if its sense changes.
     * @param {Element} node
     * @param {string[]} on
     */
    bindCouple(node, [place, couple]) {
        const {view} = this.held, asDrawn = this.held.place(place), sense = Math.sign(this.held.couple(couple));
        if (!asDrawn) return node.classList.add('still');
        view.bindings.push(() => {
            const now = this.held.place(place), size = this.held.couple(couple);
            view.marks.show(node, now !== null && size !== 0);
            if (!now) return;
            const by = minus(now, asDrawn), isTurned = Math.sign(size) === -sense;
            view.marks.transform(node, isTurned ?
                `matrix(-1 0 0 1 ${(by.x + 2 * asDrawn.x).toFixed(4)} ${by.y.toFixed(4)})` :
                `translate(${by.x.toFixed(4)} ${by.y.toFixed(4)})`);
        });
    }
    /**
     * @param {Element} node
     * @param {string[]} on
     */
    bindAxis(node, [from, to]) {
        const axis = node.querySelector(':scope > line.axis');
        if (!axis) return;
        this.held.places.add(from).add(to);
        this.held.view.bindings.push(() => {
            const [a, b] = [this.held.place(from), this.held.place(to)];
            if (a && b) this.held.view.marks.setEnds(axis, a, b);
        });
    }
    /**
     * @param {Element} label
     * @param {Element[]} parts
     * @param {Spot} centre
     * @param {DOMRect} box
     */
    bindLabel(label, parts, centre, box) {
        const hold = holdOf(label), {on, form} = hold, {view} = this.held;
        if (hold.unit > 0) this.tellNumber(label, hold);
        if (form === 'at') this.held.places.add(on[0]);
        if (form === 'arc' && hold.beyond > 0) return this.forms.bindAngleLabel(parts, on, centre, box);
        if (form === 'at' || form === 'couple') return view.labels.bindToPlace(parts, () => this.held.place(on[0]));
        const ends = this.sidesOf(hold, centre), whole = this.held.arrows.get(on.join(' '))?.drawn ?? ends();
        if (!whole) return parts.forEach((part) => part.classList.add('still'));
        if (form === 'arrow' && on.length === 2 && hold.unit === 0) {
            view.vectorLabels.push({label, box, value: () => ends() && this.held.sizeOf(on) / this.held.inUnit,
                unit: this.held.unit});
        }
        view.labels.bindBeside(parts, whole, ends, centre, box);
    }
    /**
     * The segment beside which a label stands. Arrows must be bound before.
     * @param {Hold} hold
     * @param {Spot} centre
     * @returns {() => [Spot, Spot] | null}
     */
    sidesOf({form, on}, centre) {
        const arrow = this.held.arrows.get(on.join(' ')), half = 5;
        if (arrow) return arrow.now;
        if (form === 'segment') {
            return () => {
                const [a, b] = on.map((name) => this.held.place(name));
                return a && b ? [a, b] : null;
            };
        }
        const axesNow = () => {
            if (form !== 'normal' && form !== 'arc') return this.held.axes(on);
            const at = this.held.place(on[form === 'arc' ? 1 : 0]), e = this.held.direction(on);
            return at && e ? {at, e: quarterTurn(e), n: scaledBy(-1, e)} : null;
        };
        const asDrawn = axesNow(), t = asDrawn ? dot(minus(centre, asDrawn.at), asDrawn.e) : 0;
        return () => {
            const now = axesNow();
            return now && [along(now.at, t - half, now.e), along(now.at, t + half, now.e)];
        };
    }
    /**
     * Replaces the number in a label by the current value.
     * @param {Element} label
     * @param {Hold} hold
     */
    tellNumber(label, {form, on, unit}) {
        const said = label.getAttribute('data-label') ?? '', name = said.split(' = ')[0], {view} = this.held;
        const glyphs = [...label.querySelectorAll('use')], count = [...name.replace(/[_^ ]/g, '')].length;
        glyphs.slice(count).forEach((glyph) => glyph.classList.add('still'));
        const kept = /** @type {SVGGraphicsElement[]} */ (glyphs.slice(0, count));
        const all = /** @type {SVGGraphicsElement} */ (label).getBBox();
        const right = Math.max(all.x, ...kept.map((glyph) => glyph.getBBox()).map(({x, width}) => x + width));
        const text = drawn(label, 'text', {class: 'number', x: right + 0.8, y: all.y + 0.75 * all.height});
        const symbol = said.slice(name.length + 3).replace(/^[−\d.,]+(?: ?· ?10\S*)? ?/, '');
        view.bindings.push(() => {
            const [a, b] = form === 'segment' || form === 'arc' ? on.map((each) => this.held.place(each)) : [];
            const value =
                form === 'couple'
                    ? this.held.couple(on[1]) / unit
                    : a && b
                      ? (apart(a, b) * view.scale) / unit
                      : this.held.sizeOf(on) / unit;
            text.textContent = `= ${view.written(Number(value.toPrecision(4)))} ${symbol}`;
        });
    }
}
