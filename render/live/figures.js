// A figure of the sheet that follows the mechanism. Each mark of the drawing is bound once to what it moves with (a
// body, a place, a vector of the program, a line). Away from the drawn position, marks without a binding are hidden,
// since nothing may be shown that was not constructed. In the drawn position it is the sheet's figure, unchanged.

import {Area} from './area.js';
import {AbsentArrows, ArrowBinder} from './arrow_binder.js';
import {scaledBy} from './given.js';
import {GroundBinder} from './ground_binder.js';
import {HeldBinder} from './held_binder.js';
import {HeldMarks} from './held_marks.js';
import {LabelBinder} from './label_binder.js';
import {LineBinder} from './line_binder.js';
import {LinkBinder} from './link_binder.js';
import {Marks} from './marks.js';
import {drawn} from './measure.js';
import {Paper} from './paper.js';
import {along, apart, boxOf, minus, parsePath, spotsOf} from './path.js';
import {Crowd, setSideBySide} from './room.js';
/** @typedef {import('./motion.js').Motion} Motion */
/** @typedef {import('./paper.js').FigureInfo} FigureInfo */
/** @typedef {import('./paper.js').Names} Names */
/** @typedef {import('./types.js').Spot} Spot */

/** A figure of a drawing; a drawing may contain several. */
export class FigureView extends Paper {
    /**
     * Valid only at the drawing's scale: the scale bar, and what is bound to nothing.
     * @type {Element[]}
     */
    measures = [];
    /**
     * The scale bar alone.
     * @type {Element[]}
     */
    scaleBar = [];
    /** @type {(() => void)[]} */
    bindings = [];
    /** @type {{label: Element, box: DOMRect, value: () => number | null, unit: string}[]} */
    vectorLabels = [];
    /** @type {(value: number) => string} */
    written = String;
    tellsValues = false;
    /**
     * A free body stays in place: its points, and the middle of them as drawn.
     * @type {{points: number[], middle: Spot} | null}
     */
    own = null;
    /**
     * Arrows of a polygon in drawing order; the offset of each that is drawn beside its place.
     * @type {string[]}
     */
    strokes = [];
    /** @type {Map<string, Spot>} */
    asides = new Map();
    /**
     * Labels placed after all others, so that they avoid them.
     * @type {(() => void)[]}
     */
    placings = [];
    crowd = new Crowd();
    isBound = false;
    saysOtherScale = false;
    /** Leaders, which move with their labels. */
    taken = new Set();
    marks = new Marks();
    arrows = new ArrowBinder(this);
    lines = new LineBinder(this);
    labels = new LabelBinder(this);
    links = new LinkBinder(this);
    ground = new GroundBinder(this);

    /**
     * @param {SVGSVGElement} svg
     * @param {Element} group
     * @param {FigureInfo} info
     * @param {Motion} motion
     * @param {Names} names
     */
    constructor(svg, group, info, motion, names) {
        super(group, info, motion, names);
        this.svg = svg;
        /** The marks with a data-on attribute. */
        this.held = this.isHeld || group.querySelector('[data-on]') ? new HeldMarks(this) : null;
        this.heldBinder = this.held && new HeldBinder(this.held);
        if (this.held?.isLever) this.takeScale();
        this.viewBox = (svg.getAttribute('viewBox') ?? '').split(' ').map(Number);
        /** The visible area of the drawing: left, top, width, height. */
        this.shownRoom = this.viewBox;
        this.area = new Area(this);
        const figure = svg.closest('figure');
        this.note = /** @type {HTMLElement} */ (figure?.querySelector('.note'));
        this.captionOfScale = /** @type {HTMLElement | null} */ (figure?.querySelector('.scale'));
    }
    /** All points that it must show here. */
    extent() {
        return this.area.extent();
    }
    /** Whether the figure can follow the mechanism. */
    get follows() {
        if (this.isMechanism || this.isHeld) return this.scale > 0;
        return this.keys.size > 0 && ![...this.keys.values()].includes('');
    }
    /** Whether the figure depends on a construction, not on the position only. */
    get isConstructed() {
        return !this.isMechanism || (this.isHeld && this.held?.isRecorded === true);
    }
    /** Units for a mm, now and as drawn; of Joukowsky's lever for velocities and forces. */
    get scales() {
        const {held, unit, scale, drawnScale} = this, forces = held && held.forces.length > 0 ?
            [{now: held.scale / held.inUnit, drawn: held.drawnScale / held.inUnit, unit: held.unit}] : [];
        if (this.isFree) return forces;
        const own = Number(this.group.getAttribute('data-scale') ?? 1);
        return [{now: (own * scale) / drawnScale, drawn: own, unit}, ...forces];
    }
    get caption() {
        return this.group.querySelector('title')?.textContent ?? '';
    }
    /** Shows the figure as drawn. */
    restore() {
        this.marks.restore();
        this.toDrawnScale();
        this.svg.setAttribute('viewBox', this.viewBox.join(' '));
        this.shownRoom = this.viewBox;
        this.svg.classList.remove('moved');
    }
    /**
     * Follows the mechanism; `room`: the area that it may cover.
     * @param {number[]} room
     * @param {{scale: number, origin: Spot}} to
     */
    follow(room, to = {scale: this.drawnScale, origin: this.drawnOrigin}) {
        this.scale = to.scale;
        this.origin = to.origin;
        const isAsDrawn = to.scale === this.drawnScale && this.held?.scale === this.held?.drawnScale;
        for (const node of this.measures) this.marks.show(node, isAsDrawn);
        if (room !== this.shownRoom || !this.svg.matches('.moved')) {
            this.svg.setAttribute('viewBox', room.map((each) => each.toFixed(3)).join(' '));
            this.svg.classList.add('moved');
            this.shownRoom = room;
        }
        if (this.isMechanism) this.measuresToRim(room);
        this.stayInPlace();
        setSideBySide(this);
        const bars = this.isMechanism ? this.links.bars() : [];
        const arrows = [...this.held?.arrows.values() ?? []].map(({now}) => now() ?? []);
        this.crowd.clear([...bars, ...arrows, ...[...this.keys.keys()].map((name) => this.drawnVector(name) ?? [])]);
        for (const update of [...this.bindings, ...this.placings]) update();
    }
    /**
     * Where a vector is drawn: in its place, or beside it.
     * @param {string} name
     * @returns {[Spot, Spot] | null}
     */
    drawnVector(name) {
        const at = this.vector(name), by = this.asides.get(name);
        return at && by ? [along(at[0], 1, by), along(at[1], 1, by)] : at;
    }
    /**
     * Moves the scale bar to the corner of the visible area, away from the mechanism.
     * @param {number[]} room
     */
    measuresToRim([x, y, , height]) {
        const [bar] = this.measures;
        if (!bar || this.svg.querySelectorAll('g.figure').length > 1) return;
        const {left, bottom} = boxOf(spotsOf(parsePath(this.marks.known(bar, 'd').drawn ?? '')));
        const isWidened = x !== this.viewBox[0] || y !== this.viewBox[1] || height !== this.viewBox[3];
        for (const node of this.measures)
            this.marks.translate(node, isWidened ? {x: x + 3 - left, y: y + height - 2 - bottom} : {x: 0, y: 0});
    }
    /** A free body turns, but stays in place. */
    stayInPlace() {
        if (this.own) this.origin = along(this.origin, 1, minus(this.own.middle, this.middleOf(this.own.points)));
    }
    /**
     * On paper.
     * @param {number[]} points
     */
    middleOf(points) {
        const sum = points.map((point) => this.point(point)).reduce((all, each) => along(all, 1, each), {x: 0, y: 0});
        return scaledBy(1 / points.length, sum);
    }
    /** Call once, in the drawn position, while the figure is visible. */
    bind() {
        if (this.isBound) return;
        this.isBound = true;
        // Where nothing moves, what is bound to no force stays true.
        this.svg.classList.toggle('rests', this.motion.isStill && this.info.mayRest === true);
        this.bindHeld();
        this.labels.bindLabels();
        for (const node of [...this.svg.children, ...this.group.children]) this.lines.bindScaleBar(node);
        for (const node of this.group.children) {
            if (this.taken.has(node)) continue;
            if (node.tagName === 'g' && this.isMechanism) this.links.bindRole(node);
            else if (node.matches('g.vector')) this.arrows.bindVector(node);
            else if (node.matches('g.figure')) node.classList.add('still');
            else if (node.tagName === 'path') this.lines.bindPath(node);
            else if (node.matches('g.text:not(.label ~ .text)')) this.measures.push(node);
        }
        new AbsentArrows(this).add();
    }
    /** Binds the marks with a data-on attribute; of a free body also its own marks. */
    bindHeld() {
        const {held, names, motion} = this, binder = this.heldBinder;
        if (!held || !binder) return;
        if (this.isFree) {
            const labels = [...this.group.querySelectorAll('g.label')].map(
                (each) => each.getAttribute('data-label') ?? '',
            );
            const said = new Set(labels.flatMap((each) => each.split(' ≡ ')));
            const body = names.bodies.findIndex(({id}) => this.info.freeBody === id);
            const points = names.points.flatMap(({label}, i) =>
                motion.data.points[i][0] === body || said.has(label) ? [i] : []);
            this.own = points.length > 0 ? {points, middle: this.middleOf(points)} : null;
        }
        for (const node of this.group.querySelectorAll('[data-on]:not(.label, .text)')) {
            if (node.parentElement?.closest('[data-on]')) continue;
            this.taken.add(node);
            binder.bind(node);
        }
    }
    /**
     * Shows or hides the value of each vector beside its name.
     * @param {boolean} isOn
     * @param {(value: number) => string} written
     */
    showValues(isOn, written) {
        if (!isOn && !this.tellsValues) return;
        this.tellsValues = isOn;
        for (const {label, box, value, unit} of this.vectorLabels) {
            let text = label.querySelector('text');
            if (!isOn) {
                text?.remove();
                continue;
            }
            text ??= /** @type {SVGTextElement} */ (
                drawn(label, 'text', {x: box.x + box.width + 0.6, y: box.y + 0.75 * box.height})
            );
            const size = value();
            text.textContent = size === null ? '' : `= ${written(Number(size.toPrecision(4)))} ${unit}`;
        }
    }
    /**
     * The magnitude of a vector in this position, in the figure's unit.
     * @param {string} name
     */
    sizeOf(name) {
        const ends = this.vector(name);
        return ends && (apart(...ends) * (this.isMechanism ? this.vectorScale : this.scale)) / this.inUnit;
    }
}
