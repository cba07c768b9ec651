// Dragging a moving point: the mechanism goes to the position in which the point is nearest to the pointer.

import {dot} from './closure.js';
import {along, apart, minus} from './path.js';
/** @typedef {import('./figures.js').FigureView} FigureView */
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
    wire() {
        const {page, svg, motion} = this;
        /** @type {{point: number, path: Spot[], sample: number} | null} */
        let held = null;
        const view = () =>
            page.figures.find((each) => each.svg === svg && each.isMechanism && !each.isFree && each.follows);
        const spotOf = (/** @type {PointerEvent} */ event) => {
            const matrix = svg.getScreenCTM();
            return matrix ? new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse()) : null;
        };
        svg.addEventListener('pointerdown', (event) => {
            const figure = view(), at = spotOf(event);
            if (!figure || !at || page.ruler.isOn || page.mode === 'try') return;
            const point = nearestMoving(figure, motion, at);
            if (point < 0) return;
            page.pause();
            const path = page.pathOf(point), {samples} = page.course;
            const sample = samples.reduce((best, each, i) =>
                Math.abs(each.at - motion.at) < Math.abs(samples[best].at - motion.at) ? i : best, 0);
            held = {point, path, sample};
            svg.setPointerCapture(event.pointerId);
            svg.classList.add('holding');
            event.preventDefault();
        });
        // On a joint a touch drags it, elsewhere it scrolls the page.
        svg.addEventListener('touchstart', (event) => {
            if (held) event.preventDefault();
        }, {passive: false});
        svg.addEventListener('pointermove', (event) => {
            const figure = view(), at = spotOf(event);
            if (!held || !figure || !at) return;
            const near = nearestOnPath(
                held.path,
                figure.unpaper(at),
                held.sample,
                !page.course.startsAtLimit && !page.course.endsAtLimit,
            );
            held.sample = near.sample;
            const {samples} = page.course, next = samples[Math.min(near.sample + 1, samples.length - 1)];
            page.moveTo(samples[near.sample].at + near.share * (next.at - samples[near.sample].at));
        });
        const leave = () => {
            held = null;
            svg.classList.remove('holding');
        };
        svg.addEventListener('pointerup', leave);
        svg.addEventListener('pointercancel', leave);
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
