// Binds what stands on the frame: it moves only with a changed length. Guides are as long as their slides travel.

import {dot, quarterTurn, unitOf} from './closure.js';
import {scaledBy} from './given.js';
import {along, apart, boxOf, mappedPath, minus, parsePath, samePlace, spotsOf} from './path.js';
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./types.js').Spot} Spot */

export class GroundBinder {
    /**
     * By point on a guide of the frame: its range of travel before and behind the drawn place, mm.
     * @type {Map<number, {from: number, to: number, drawn: Spot, e: Spot}>}
     */
    travels = new Map();

    /** @param {FigureView} view */
    constructor(view) {
        this.view = view;
    }
    /**
     * A mark at a place of the frame stays there, unless a changed length moves the place. False: there is no place so
     * near.
     * @param {Element} node
     * @param {number} reach mm
     */
    bindToGround(node, reach) {
        const spots = spotsOf(parsePath(node.getAttribute('d') ?? ''));
        if (spots.length === 0) return false;
        const point = this.groundAt(boxOf(spots).centre, reach);
        if (point < 0) return this.bindToGuideOfFrame(node, spots, reach);
        const drawn = this.view.point(point);
        this.carry(node, () => minus(this.view.point(point), drawn));
        return true;
    }
    /**
     * A mark that moves only with a changed length.
     * @param {Element} node
     * @param {() => Spot} offset
     */
    carry(node, offset) {
        let wasMoved = false;
        this.view.bindings.push(() => {
            const by = offset(), isMoved = Math.hypot(by.x, by.y) > 1e-9;
            if (isMoved || wasMoved) this.view.marks.translate(node, by);
            wasMoved = isMoved;
        });
    }
    /**
     * The axis of a guide on the frame, and the hatching beside it.
     * @param {Element} node
     * @param {Spot[]} spots
     * @param {number} reach
     */
    bindToGuideOfFrame(node, spots, reach) {
        const {data, read} = this.view.motion,
            {centre} = boxOf(spots);
        const across = (/** @type {number} */ joint) =>
            quarterTurn(unitOf({x: read.guides[joint].x, y: -read.guides[joint].y}));
        const joint = this.view.names.joints.findIndex(
            ({bodies, point}, k) =>
                data.joints[k].point >= 0
                && bodies.includes(0)
                && (read.guides[k].x !== 0 || read.guides[k].y !== 0)
                && Math.abs(dot(minus(centre, this.view.point(point)), across(k))) < reach,
        );
        if (joint < 0) return false;
        const {point} = this.view.names.joints[joint], drawn = this.view.point(point), n = across(joint);
        this.carry(node, () => scaledBy(dot(minus(this.view.point(point), drawn), n), n));
        if (this.view.names.joints[joint].turnsWith === 0) this.stretch(node, point, drawn, scaledBy(-1,
            quarterTurn(n)));
        return true;
    }
    /**
     * Extends a guide over the travel of its slide: a line by its ends, hatching by more strokes.
     * @param {Element} node
     * @param {number} point
     * @param {Spot} drawn
     * @param {Spot} e
     */
    stretch(node, point, drawn, e) {
        const segments = parsePath(node.getAttribute('d') ?? ''), spots = spotsOf(segments);
        if (node.tagName !== 'path' || !segments.every(({letter}, i) => letter === 'ML'[i % 2])) return;
        const at = spots.map((spot) => dot(minus(spot, drawn), e)), count = spots.length;
        if (Math.min(...at) > 0 || Math.max(...at) < 0) return;  // of another place of the frame
        const travel = this.travels.get(point) ?? {from: 0, to: 0, drawn, e};
        this.travels.set(point, travel);
        this.view.bindings.push(() => {
            const {from, to} = travel;
            if (count === 2) {
                const ends = spots.map((spot, i) => along(spot, at[i] < at[1 - i] ? from : to, e));
                return this.view.marks.set(node, 'd', mappedPath(segments, () => /** @type {Spot} */ (ends.shift())));
            }
            // The outermost stroke may be cut, so its neighbour is copied.
            const pitch = count > 7 ? at[4] - at[2] : 0, step = Math.abs(pitch), isUp = pitch > 0;
            if (step < samePlace) return;
            const copies = [
                {pair: isUp ? segments.slice(2, 4) : segments.slice(-4, -2), by: -step, reach: -from},
                {pair: isUp ? segments.slice(-4, -2) : segments.slice(2, 4), by: step, reach: to},
            ].flatMap(({pair, by, reach}) =>
                Array.from({length: Math.floor(reach / step)}, (_, k) =>
                    mappedPath(pair, (spot) => along(spot, (k + 2) * by, e)),
                ),
            );
            this.view.marks.set(node, 'd', mappedPath(segments, (spot) => spot) + copies.join(''));
        });
    }
    /** The travel of points on guides, in one position of the driver. */
    measureTravels() {
        const [, , width, height] = this.view.viewBox;
        for (const [point, travel] of this.travels) {
            const by = dot(minus(this.view.point(point), travel.drawn), travel.e);
            if (Math.abs(by) > width + height) continue;
            travel.from = Math.min(travel.from, by);
            travel.to = Math.max(travel.to, by);
        }
    }
    /**
     * The nearest place of the frame; −1: none.
     * @param {Spot} at
     * @param {number} reach
     */
    groundAt(at, reach) {
        let best = -1, least = reach;
        this.view.motion.data.points.forEach(([body], i) => {
            const off = body === 0 ? apart(this.view.point(i), at) : least;
            if (off < least) [best, least] = [i, off];
        });
        return best;
    }
}
