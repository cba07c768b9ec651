// Marks with a `data-on` attribute that change their shape: arrows from place to place, springs, angles, bars of
// trusses.

import {dot, quarterTurn, unitOf} from './closure.js';
import {tipOfVector} from './held_marks.js';
import {written} from './held_shapes.js';
import {along, apart, leastVector, mappedPath, minus, parsePath, spotsOf} from './path.js';
import {localOf} from './room.js';
/** @typedef {import('./held_marks.js').HeldMarks} HeldMarks */
/** @typedef {import('./types.js').Spot} Spot */

/**
 * Whether a mark is a single straight stroke.
 * @param {Element} node
 */
export function isStroke(node) {
    return node.tagName === 'path' && spotsOf(parsePath(node.getAttribute('d') ?? '')).length === 2;
}

const turn = 2 * Math.PI;
/**
 * The least turn from an angle to another.
 * @param {number} from
 * @param {number} to
 */
function turnBetween(from, to) {
    return ((to - from + Math.PI) % turn + turn) % turn - Math.PI;
}

export class HeldForms {
    /** @param {HeldMarks} held */
    constructor(held) {
        this.held = held;
    }
    /**
     * An arrow from place to place.
     * @param {Element} node
     * @param {string[]} on
     */
    bindBetween(node, on) {
        const {held} = this, [from, , to] = on, now = () => {
            const [a, b] = [held.place(from), held.place(to)];
            return a && b ? /** @type {[Spot, Spot]} */ ([a, b]) : null;
        };
        const whole = now();
        if (!whole || apart(...whole) < leastVector) return node.classList.add('still');
        held.places.add(from).add(to);
        held.arrows.set(on.join(' '), {drawn: whole, now});
        held.view.arrows.bindArrow(node, whole, now);
        const [, , vector, scale] = to.match(tipOfVector) ?? [];
        if (vector)
            this.addHandle(node, vector, () => now()?.[0] ?? null, () => now()?.[1] ?? null, 1,
                () => held.view.scale * Number(scale));
    }
    /**
     * A vector that the reader may drag, if the file gives it and it can be turned.
     * @param {Element} node
     * @param {string} name
     * @param {() => Spot | null} at
     * @param {() => Spot | null} free
     * @param {number} sense
     * @param {() => number} scale
     */
    addHandle(node, name, at, free, sense, scale) {
        const {motion} = this.held.view, given = motion.held(name)?.[3] ?? -1;
        if (motion.turning(given) < 0) return;
        node.classList.add('grip');
        this.held.handles.push({given, at, free, sense, scale});
    }
    /**
     * Between its places it is stretched, near them it keeps its shape.
     * @param {Element} node
     * @param {string[]} on
     */
    bindStretch(node, on) {
        const {view} = this.held, ends = () => on.map((name) => this.held.place(name)), [a, b] = ends();
        if (!a || !b) return node.classList.add('still');
        const whole = apart(a, b), local = localOf(a, b), rim = Math.min(0.15 * whole, 3);
        const all = node.tagName === 'path' ? [node] : [...node.querySelectorAll('path')];
        const paths = all.map((path) => ({path, segments: parsePath(path.getAttribute('d') ?? '')}));
        view.bindings.push(() => {
            const [from, to] = ends(), size = from && to ? apart(from, to) : 0;
            view.marks.show(node, size > 2 * rim);
            if (!from || !to || size <= 2 * rim) return;
            const e = unitOf(minus(to, from)), n = quarterTurn(e), k = (size - 2 * rim) / (whole - 2 * rim);
            const map = (/** @type {Spot} */ at) => {
                const {t, n: side} = local(at);
                const gone = t < rim ? t : t > whole - rim ? size - whole + t : rim + k * (t - rim);
                return along(along(from, gone, e), side, n);
            };
            for (const {path, segments} of paths) view.marks.set(path, 'd', mappedPath(segments, map));
        });
    }
    /**
     * The angle from the direction of x to that of the second place, on paper; and about which place.
     * @param {string[]} on
     */
    angleOf(on) {
        const [at, to] = on.map((name) => this.held.place(name));
        return at && to && apart(at, to) > leastVector ? {at, angle: Math.atan2(to.y - at.y, to.x - at.x)} : null;
    }
    /**
     * An arc that ends where its head, a mark of its own, begins.
     * @param {Element} node
     * @param {string[]} on
     */
    bindAngle(node, on) {
        const {view} = this.held, asDrawn = this.angleOf(on);
        const spots = spotsOf(parsePath(node.getAttribute('d') ?? ''));
        if (!asDrawn || spots.length < 2) return node.classList.add('still');
        const from = asDrawn.at, radius = apart(spots[0], from), isHead = node.getAttribute('fill') !== 'none';
        const angles = spots.map((at) => Math.atan2(at.y - from.y, at.x - from.x));
        const sense = Math.sign(turnBetween(angles[0], angles[Math.floor(angles.length / 2)]) || 1);
        const round = (/** @type {number} */ angle) => sense * ((sense * angle % turn + turn) % turn);
        const gap = round(asDrawn.angle) - round(angles[angles.length - 1]);
        view.bindings.push(() => {
            const now = this.angleOf(on);
            view.marks.show(node, now !== null);
            if (!now) return;
            if (isHead) {
                const by = (now.angle - asDrawn.angle) * 180 / Math.PI, shift = minus(now.at, from);
                return view.marks.transform(node,
                    `translate(${written(shift)}) rotate(${by.toFixed(4)} ${from.x} ${from.y})`);
            }
            const whole = round(now.angle) - gap, steps = Array.from({length: 25}, (_, i) => whole * i / 24);
            view.marks.set(node, 'd', `M${steps.map((angle) =>
                written(along(now.at, radius, {x: Math.cos(angle), y: Math.sin(angle)}))).join('L')}`);
        });
    }
    /**
     * A bar of a truss: its line says whether it is in tension or in compression.
     * @param {Element} node
     * @param {string[]} on
     */
    bindBar(node, [from, to, force]) {
        const {held} = this, {marks, motion} = held.view, [a, b] = [held.place(from), held.place(to)];
        const pens = motion.data.pens, width = Number(node.getAttribute('stroke-width'));
        if (!a || !b || !pens) return;
        const senseNow = () => {
            const v = held.vectorOf(motion.held(force)?.[1] ?? -1);
            return v ? Math.sign(dot({x: v.x, y: -v.y}, minus(b, a))) : 0;
        };
        const drawnWidth = pens[senseNow() + 1][1];
        held.view.bindings.push(() => {
            const [stroke, size] = pens[senseNow() + 1];
            marks.set(node, 'stroke', stroke);
            marks.set(node, 'stroke-width', String(size * width / drawnWidth));
        });
    }
    /**
     * In the middle of its angle.
     * @param {Element[]} parts
     * @param {string[]} on
     * @param {Spot} centre
     * @param {DOMRect} box
     */
    bindAngleLabel(parts, on, centre, box) {
        const {view} = this.held, asDrawn = this.angleOf(on);
        if (!asDrawn) return parts.forEach((part) => part.classList.add('still'));
        const off = minus(centre, asDrawn.at), far = Math.hypot(off.x, off.y);
        const middle = turnBetween(asDrawn.angle / 2, Math.atan2(off.y, off.x));
        const isOther = Math.abs(middle) > Math.PI / 2;  // of the angle that is more than half a turn
        view.labels.placeLabel(parts, centre, box, () => {
            const now = this.angleOf(on);
            if (!now) return [];
            const toward = now.angle / 2 + (isOther ? Math.PI : 0);
            return [0, 0.35, -0.35].flatMap((aside) => [far, 1.3 * far, 0.7 * far].map((reach) =>
                along(now.at, reach, {x: Math.cos(toward + aside), y: Math.sin(toward + aside)})));
        });
    }
}
