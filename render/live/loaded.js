// A figure of the contact at a joint: pressure and area grow with a power of the load (Hertz), the bodies stay as they
// are. What lies above the origin grows with the load in both directions, what lies below, the plan, in width.

import {dot, quarterTurn} from './closure.js';
import {FigureView} from './figures.js';
import {drawn} from './measure.js';
import {apart, boxOf, mappedPath, minus, parsePath, spotsOf} from './path.js';
/** @typedef {import('./types.js').Spot} Spot */

/** The longest head of an arrow, mm. */
const longestHead = 3.2;

export class LoadedView extends FigureView {
    /** As drawn, in the sense in which the bodies push; 0: not known. */
    drawnLoad = 0;
    /**
     * Tips of arrows, as drawn.
     * @type {Spot[]}
     */
    tips = [];

    get loaded() {
        return this.info.loaded ?? {joint: 0, power: 0};
    }
    get follows() {
        return this.forceColumns.length === 2;
    }
    get isConstructed() {
        return true;
    }
    /** Its scale never changes. */
    get scales() {
        return [];
    }
    /** Columns of the force at the joint: along x, along y. */
    get forceColumns() {
        const {columns} = this.motion.data, {joint} = this.loaded;
        return ['x', 'y'].flatMap((axis) => {
            const at = columns.findIndex((each) => each.kind === 'result' && each.joint === joint &&
                each.component === axis);
            return at < 0 ? [] : [at];
        });
    }
    /** The load here: across the common tangent, of wheels that mesh the whole force; null: not known. */
    load() {
        const [x, y] = this.forceColumns.map((each) => this.motion.value(each)), {joint} = this.loaded;
        if (typeof x !== 'number' || typeof y !== 'number') return null;
        if (this.motion.data.joints[joint].meshes) return Math.hypot(x, y);
        return dot({x, y}, quarterTurn(this.motion.slidingDirection(joint)));
    }
    /** The factor of all lengths; 0: nothing presses here, or it is not known. */
    growth() {
        const load = this.load(), {power} = this.loaded;
        return load === null || this.drawnLoad === 0 ? 0 : Math.max(load / this.drawnLoad, 0) ** power;
    }
    extent() {
        return [];
    }
    bind() {
        if (this.isBound) return;
        this.isBound = true;
        this.drawnLoad = this.load() ?? 0;
        if (this.loaded.power === 0) return;
        const all = [...this.group.querySelectorAll('path')].filter((node) => !node.closest('.label, .text, defs'));
        const shapes = all.map((node) => ({node, d: parsePath(node.getAttribute('d') ?? '')}));
        const isHead = (/** @type {Element} */ node, /** @type {Spot[]} */ spots) =>
            node.getAttribute('fill') !== 'none' && spots.length === 4 && apart(spots[0], spots[2]) < longestHead;
        for (const {node, d} of shapes) if (isHead(node, spotsOf(d))) this.tips.push(spotsOf(d)[0]);
        for (const {node, d} of shapes) this.bindShape(node, d, isHead(node, spotsOf(d)));
        for (const label of this.group.querySelectorAll('g.label')) this.bindValue(label);
    }
    /**
     * Where a place is now.
     * @param {Spot} at as drawn
     * @param {number} by the factor
     */
    grown(at, by) {
        const [x, y] = this.info.origin;
        return {x: x + by * (at.x - x), y: at.y > y ? at.y : y + by * (at.y - y)};
    }
    /**
     * @param {Element} node
     * @param {import('./path.js').Segment[]} d
     * @param {boolean} isHead
     */
    bindShape(node, d, isHead) {
        const spots = spotsOf(d);
        // Heads keep their shape, and shafts end in them.
        const near = (/** @type {Spot} */ at) => isHead ? spots[0] :
            spots.length === 2 ? this.tips.find((tip) => apart(tip, at) < longestHead) : undefined;
        this.bindings.push(() => {
            const by = this.growth();
            this.marks.show(node, by > 0);
            if (by === 0) return;
            this.marks.set(node, 'd', mappedPath(d, (at) => {
                const tip = near(at), to = this.grown(tip ?? at, by);
                return tip ? {x: to.x + at.x - tip.x, y: to.y + at.y - tip.y} : to;
            }));
        });
    }
    /**
     * "p_0 = 326.0 MPa": the number grows too.
     * @param {Element} label
     */
    bindValue(label) {
        const [, name, number, unit] = /^(.* = )(\d+(?:[.,]\d+)?) (.+)$/.exec(label.getAttribute('data-label') ?? '') ??
            [];
        if (number === undefined) return label.classList.add('still');
        const kept = [...name.replace(/[_^ ]/g, '')].length, glyphs = [...label.querySelectorAll('use')];
        const box = /** @type {SVGGElement} */ (label).getBBox(), digit = /** @type {SVGUseElement} */ (glyphs[kept]);
        const centre = {x: box.x + box.width / 2, y: box.y + box.height / 2}, value = Number(number.replace(',', '.'));
        glyphs.slice(kept).forEach((glyph) => glyph.classList.add('still'));
        const text = drawn(label, 'text', {x: digit.getBBox().x, y: digit.y.baseVal.value, class: 'number'});
        this.bindings.push(() => {
            const by = this.growth();
            this.marks.show(label, by > 0);
            this.marks.translate(label, minus(this.grown(centre, by), centre));
            const now = String(Number((value * by).toPrecision(4)));
            text.textContent = `${number.includes(',') ? now.replace('.', ',') : now} ${unit}`;
        });
    }
    follow() {
        for (const update of this.bindings) update();
        this.svg.classList.add('moved');
        const [x, y, width, height] = this.viewBox, by = this.growth();
        const {left, right, top, bottom} = boxOf([{x, y}, {x: x + width, y: y + height},
            this.grown({x, y}, Math.max(by, 1)), this.grown({x: x + width, y: y + height}, Math.max(by, 1))]);
        const room = [left, top, right - left, bottom - top];
        this.svg.setAttribute('viewBox', room.map((each) => each.toFixed(3)).join(' '));
    }
}
