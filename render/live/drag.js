// Dragging a moving point: the mechanism goes to the position in which the point is nearest to the pointer. Dragging a
// load of a structure: it gets the size and the direction that the pointer shows.

import {dot} from './closure.js';
import {scaledBy} from './given.js';
import {along, apart, leastVector, minus} from './path.js';
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./held_marks.js').Handle} Handle */
/** @typedef {import('./held_marks.js').HeldMarks} HeldMarks */
/** @typedef {import('./motion.js').Motion} Motion */
/** @typedef {import('./page.js').Page} Page */
/** @typedef {import('./types.js').Spot} Spot */

export class Dragging {
    /**
     * @param {Page} page
     * @param {SVGSVGElement} svg
     * @param {Motion} motion
     */
    constructor(page, svg, motion) {
        this.page = page;
        this.svg = svg;
        this.motion = motion;
    }
    /** @param {PointerEvent} event */
    spotOf(event) {
        const matrix = this.svg.getScreenCTM();
        return matrix ? new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse()) : null;
    }
    wire() {
        const {page, svg} = this;
        /** @type {((at: Spot) => void) | null} */
        let held = null;
        svg.addEventListener('pointerdown', (event) => {
            const at = this.spotOf(event);
            if (!at || page.ruler.isOn || page.mode === 'try') return;
            held = this.loadAt(at) ?? this.pointAt(at);
            if (!held) return;
            page.pause();
            svg.setPointerCapture(event.pointerId);
            svg.classList.add('holding');
            event.preventDefault();
        });
        // On a joint or a load a touch drags it, elsewhere it scrolls the page.
        svg.addEventListener('touchstart', (event) => {
            if (held) event.preventDefault();
        }, {passive: false});
        svg.addEventListener('pointermove', (event) => {
            const at = this.spotOf(event);
            if (held && at) held(at);
        });
        const leave = () => {
            held = null;
            svg.classList.remove('holding');
            for (const view of page.figures) if (view.held) view.held.isKept = false;
            if (this.motion.isStill) page.show();
        };
        svg.addEventListener('pointerup', leave);
        svg.addEventListener('pointercancel', leave);
    }
    /**
     * What a pointer on a moving point does.
     * @param {Spot} at
     */
    pointAt(at) {
        const {page, svg, motion} = this;
        const figure = page.figures.find((each) => each.svg === svg && each.isMechanism && !each.isFree &&
            each.follows);
        const point = figure ? nearestMoving(figure, motion, at) : -1;
        if (!figure || point < 0 || motion.isStill) return null;
        const path = page.pathOf(point), {samples} = page.course;
        let sample = samples.reduce((best, each, i) =>
            Math.abs(each.at - motion.at) < Math.abs(samples[best].at - motion.at) ? i : best, 0);
        return (/** @type {Spot} */ to) => {
            const closes = !page.course.startsAtLimit && !page.course.endsAtLimit;
            const near = nearestOnPath(path, figure.unpaper(to), sample, closes);
            sample = near.sample;
            const {samples: all} = page.course, next = all[Math.min(sample + 1, all.length - 1)];
            page.moveTo(all[sample].at + near.share * (next.at - all[sample].at));
        };
    }
    /**
     * What a pointer on a load does: it turns it, and changes its size where that is drawn to scale.
     * @param {Spot} at
     */
    loadAt(at) {
        const {page, svg, motion} = this, reach = 6, beside = 2;
        const off = (/** @type {Handle} */ {at: fixed, free}) => {
            const [from, to] = [fixed(), free()];
            if (!from || !to) return Infinity;
            const e = minus(to, from), t = dot(minus(at, from), e) / dot(e, e);
            const across = apart(at, along(from, Math.min(Math.max(t, 0), 1), e));
            return apart(at, to) < reach ? Math.min(apart(at, to), across) : t > 0.3 && across < beside ? across :
                Infinity;
        };
        const all = page.figures.filter((view) => view.svg === svg && view.held).flatMap((view) =>
            (view.held?.handles ?? []).map((handle) => ({held: /** @type {HeldMarks} */ (view.held), handle,
                by: off(handle)})));
        const best = all.sort((a, b) => a.by - b.by)[0];
        if (!best || best.by === Infinity) return null;
        const {held, handle} = best, setting = motion.turning(handle.given), scale = handle.scale();
        held.isKept = true;
        return (/** @type {Spot} */ to) => {
            const from = handle.at(), {value, direction = 0} = motion.data.settings[setting];
            if (!from || apart(from, to) < leastVector) return;
            const by = scaledBy(handle.sense, minus(to, from));
            const size = scale > 0 ? Math.hypot(by.x, by.y) * scale : motion.settings[setting];
            page.drive.turnLoad(setting, Math.max(size, 1e-6 * value), Math.atan2(-by.y, by.x) - direction);
        };
    }
}

/**
 * The moving point under the pointer; −1: none.
 * @param {FigureView} figure
 * @param {Motion} motion
 * @param {Spot} at
 */
function nearestMoving(figure, motion, at) {
    let best = -1, least = 6;
    motion.data.points.forEach(([body], i) => {
        const off = body === 0 ? least : apart(figure.point(i), at);
        if (off < least) [best, least] = [i, off];
    });
    return best;
}

/**
 * The place of a path nearest to the pointer and near the previous one, so that a path that crosses itself is followed
 * in order.
 * @param {Spot[]} path
 * @param {Spot} at
 * @param {number} before
 * @param {boolean} closes
 */
function nearestOnPath(path, at, before, closes) {
    const count = path.length - 1, reach = Math.ceil(count / 6);
    let best = {sample: Math.min(before, count - 1), share: 0}, least = Infinity;
    for (let k = before - reach; k <= before + reach; ++k) {
        const i = closes ? (k % count + count) % count : k;
        if (i < 0 || i >= count) continue;
        const step = minus(path[i + 1], path[i]), size = dot(step, step);
        const share = size > 0 ? Math.min(Math.max(dot(minus(at, path[i]), step) / size, 0), 1) : 0;
        const off = apart(along(path[i], share, step), at);
        if (off < least) [best, least] = [{sample: i, share}, off];
    }
    return best;
}
