// The current shapes of marks with a `data-on` attribute: lines over the visible part of the figure, circles, arcs.

import {dot, quarterTurn} from './closure.js';
import {along, apart, leastVector, minus} from './path.js';
/** @typedef {import('./held_marks.js').HeldMarks} HeldMarks */
/** @typedef {import('./held_marks.js').Hold} Hold */
/** @typedef {import('./types.js').Spot} Spot */

/** Lines extend over the visible part of the figure. Lengths in mm. */
const leastLine = 1, largestRound = 1e4, shortestArc = 16, sameLine = 0.3;

export class HeldShapes {
    /** @param {HeldMarks} held */
    constructor(held) {
        this.held = held;
    }
    /**
     * The visible part of a line.
     * @param {Spot} at
     * @param {Spot} e
     */
    seen(at, e) {
        const [left, top, width, height] = this.held.view.shownRoom, rim = 1;
        let [from, to] = [-Infinity, Infinity];
        for (const [x, dx, low, high] of [
            [at.x, e.x, left + rim, left + width - rim],
            [at.y, e.y, top + rim, top + height - rim],
        ]) {
            if (dx === 0 && (x < low || x > high)) return {from: 0, to: 0};
            if (dx === 0) continue;
            const [a, b] = [(low - x) / dx, (high - x) / dx];
            from = Math.max(from, Math.min(a, b));
            to = Math.min(to, Math.max(a, b));
        }
        return {from, to};
    }
    /**
     * @param {Spot} at
     * @param {Spot} e
     * @param {number} from
     * @param {number} to
     */
    piece(at, e, from, to) {
        const seen = this.seen(at, e), [a, b] = [Math.max(from, seen.from), Math.min(to, seen.to)];
        return b - a < leastLine ? '' : [a, b].map((t, i) => `${'ML'[i]}${written(along(at, t, e))}`).join('');
    }
    /**
     * Forces with a common line of action as drawn may have several elsewhere.
     * @param {Hold} hold
     */
    linesNow({on, beyond}) {
        const middle = on.indexOf('');
        const lines = on.slice(0, middle).flatMap((force) => this.held.axes([force, force]) ?? []);
        const places = [...lines.map(({at}) => at), ...on.slice(middle + 1).flatMap((name) =>
            this.held.place(name) ?? [])];
        const off = (/** @type {Spot} */ at, /** @type {{at: Spot, n: Spot}} */ line) =>
            Math.abs(dot(minus(at, line.at), line.n));
        const several = lines.filter(
            (line, i) =>
                !lines
                    .slice(0, i)
                    .some((known) => off(line.at, known) < sameLine && Math.abs(dot(line.e, known.n)) < 1e-3),
        );
        return several
            .map((line) => {
                const reached = places
                    .filter((at) => off(at, line) < sameLine)
                    .map((at) => dot(minus(at, line.at), line.e));
                return this.piece(line.at, line.e, Math.min(...reached) - beyond, Math.max(...reached) + beyond);
            })
            .join('');
    }
    /** @param {Hold} hold */
    segmentNow({on, beyond}) {
        const [a, b] = on.map((name) => this.held.place(name)), e = this.held.direction(on);
        return a && b && e ? this.piece(a, e, -beyond, apart(a, b) + beyond) : '';
    }
    /** @param {Hold} hold */
    wholeLineNow({form, on}) {
        const at = this.held.place(on[0]), e = this.held.direction(on);
        return at && e ? this.piece(at, form === 'normal' ? quarterTurn(e) : e, -Infinity, Infinity) : '';
    }
    /** @param {string[]} on */
    circleNow(on) {
        const [a, b] = on.map((name) => this.held.place(name));
        return a && b ? round({x: (a.x + b.x) / 2, y: (a.y + b.y) / 2}, apart(a, b) / 2) : '';
    }
    /** @param {string[]} on */
    arcNow(on) {
        const [centre, at] = on.map((name) => this.held.place(name)), radius = centre && at ? apart(centre, at) : 0;
        if (!centre || !at || radius === 0 || radius > largestRound) return '';
        const [left, top, width, height] = this.held.view.shownRoom;
        const isWhole = centre.x - radius > left && centre.x + radius < left + width && centre.y - radius > top &&
            centre.y + radius < top + height;
        if (isWhole) return round(centre, radius);
        const half = Math.min(Math.PI, Math.max(shortestArc / radius, 0.4)),
            toward = Math.atan2(at.y - centre.y, at.x - centre.x);
        const steps = Array.from({length: 33}, (_, i) => toward + half * (i / 16 - 1));
        const spots = steps.map((angle) => along(centre, radius, {x: Math.cos(angle), y: Math.sin(angle)}));
        return `M${spots.map(written).join('L')}`;
    }
}

/** @param {Spot} at */
export function written({x, y}) {
    return `${x.toFixed(4)} ${y.toFixed(4)}`;
}
/**
 * @param {Spot} centre
 * @param {number} radius
 */
function round(centre, radius) {
    if (radius < leastVector || radius > largestRound) return '';
    const [a, b] = [1, -1].map((side) => written({x: centre.x + side * radius, y: centre.y})), r = radius.toFixed(4);
    return `M${a}A${r} ${r} 0 0 1 ${b}A${r} ${r} 0 0 1 ${a}Z`;
}
