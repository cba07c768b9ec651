// Replays a program in the browser, operation by operation, and evaluates every guard: engine/board/program.hpp and
// engine/board/replay.cpp in JavaScript, with the same order of operations. Knows no position and no figure.

import {Guards} from './guards.js';
/** @typedef {import('./types.js').Plan} Plan */

/** In the order of Verb. */
const verbs = [
    'given_point',
    'given_vector',
    'given_scalar',
    'pole',
    'vector_between',
    'perpendicular',
    'direction_of_line',
    'point_at_infinity',
    'through',
    'join',
    'meet',
    'meet_at_infinity',
    'carry',
    'add',
    'subtract',
    'negate',
    'scale',
    'turn',
    'ratio',
    'product',
    'sum',
    'difference',
    'opposite',
    'quotient',
    'moment',
    'projection',
    'arm',
];
const lineVerbs = new Set(['through', 'join']);
const scalarVerbs = new Set(
    ['given_scalar', 'ratio', 'product', 'sum', 'difference', 'opposite', 'quotient', 'moment', 'projection']);
export const drawingPlane = 0;

export class Replay {
    /**
     * @param {Plan} plan
     * @param {number} size of the drawing, m
     */
    constructor(plan, size) {
        this.plan = plan;
        this.size = size;
        const count = plan.strokes.length / 5;
        this.count = count;
        this.cells = new Float64Array(3 * count);
        this.verb = Array.from({length: count}, (_, i) => verbs[plan.strokes[5 * i]]);
        this.elementOfGiven = new Map();
        for (let i = 0; i < count; ++i) {
            if (plan.strokes[5 * i + 4] >= 0) this.elementOfGiven.set(plan.strokes[5 * i + 4], i);
        }
        this.largestVector = [0, 0, 0, 0];
        this.largestScalar = [0, 0, 0, 0];
        this.guards = new Guards(this);
        plan.givens.forEach((value, given) => this.give(given, value));
    }
    /**
     * @param {number} given
     * @param {number[]} value
     */
    give(given, value) {
        const element = this.elementOfGiven.get(given);
        if (element !== undefined) this.put(element, value[0], value[1] ?? 0, value[2] ?? 0);
    }
    /**
     * @param {number} i
     * @param {number} x
     * @param {number} y
     * @param {number} w
     */
    put(i, x, y, w) {
        this.cells[3 * i] = x;
        this.cells[3 * i + 1] = y;
        this.cells[3 * i + 2] = w;
    }
    /** @param {number} i */
    x(i) {
        return this.cells[3 * i];
    }
    /** @param {number} i */
    y(i) {
        return this.cells[3 * i + 1];
    }
    /** @param {number} i */
    w(i) {
        return this.cells[3 * i + 2];
    }
    /** @param {number} i */
    isLine(i) {
        return lineVerbs.has(this.verb[i]);
    }
    /** Whether every guard holds; evaluation stops at the first that does not. */
    run() {
        const {strokes, guards} = this.plan;
        this.largestVector = [this.size, 0, 0, 0];
        this.largestScalar = [0, 0, 0, 0];
        for (const element of this.elementOfGiven.values()) this.note(element);
        let next = 0;
        const until = (/** @type {number} */ end) => {
            for (; next < end; ++next) {
                if (strokes[5 * next + 4] >= 0) continue;
                this.carryOut(next, strokes[5 * next + 2], strokes[5 * next + 3]);
                if (this.verb[next] !== 'pole') this.note(next);
            }
        };
        for (let g = 0; g < guards.length; g += 6) {
            until(guards[g + 5]);
            if (!this.guards.holds(guards[g], guards[g + 1], guards[g + 2], guards[g + 3], guards[g + 4])) return false;
        }
        until(this.count);
        return true;
    }
    /**
     * Carries out all strokes, whatever the guards say, with some elements put elsewhere.
     * @param {Map<number, [number, number, number]>} own by element
     */
    runWith(own) {
        const {strokes} = this.plan;
        for (let i = 0; i < this.count; ++i) {
            const put = own.get(i);
            if (put) this.put(i, ...put);
            else if (strokes[5 * i + 4] < 0) this.carryOut(i, strokes[5 * i + 2], strokes[5 * i + 3]);
        }
    }
    /**
     * Updates the largest magnitude in the element's plane, for comparisons.
     * @param {number} i
     */
    note(i) {
        const plane = this.plan.strokes[5 * i + 1], verb = this.verb[i];
        if (lineVerbs.has(verb)) return;
        if (scalarVerbs.has(verb)) {
            this.largestScalar[plane] = Math.max(this.largestScalar[plane], Math.abs(this.x(i)));
        } else if (plane !== drawingPlane) {
            this.largestVector[plane] = Math.max(this.largestVector[plane], Math.abs(this.x(i)), Math.abs(this.y(i)));
        }
    }
    /**
     * @param {number} i
     * @param {number} a
     * @param {number} b
     */
    carryOut(i, a, b) {
        switch (this.verb[i]) {
            case 'pole':
                return this.put(i, 0, 0, 1);
            case 'vector_between':
                return this.put(i, this.x(b) - this.x(a), this.y(b) - this.y(a), 0);
            case 'perpendicular':
            case 'turn':
                return this.put(i, -this.y(a), this.x(a), 0);
            case 'direction_of_line':
                return this.put(i, -this.y(a), this.x(a), 0);
            case 'point_at_infinity':
                return this.put(i, this.x(a), this.y(a), 0);
            case 'through':
                return this.lineThrough(i, a, this.x(b), this.y(b));
            case 'join':
                return this.join(i, a, b);
            case 'meet':
                return this.meet(i, a, b);
            case 'meet_at_infinity': {
                const line = this.x(a) === 0 && this.y(a) === 0 ? b : a;
                return this.put(i, -this.y(line), this.x(line), 0);
            }
            case 'carry':
                return this.put(i, this.x(a) + this.x(b), this.y(a) + this.y(b), 1);
            case 'add':
                return this.put(i, this.x(a) + this.x(b), this.y(a) + this.y(b), 0);
            case 'subtract':
                return this.put(i, this.x(a) - this.x(b), this.y(a) - this.y(b), 0);
            case 'negate':
                return this.put(i, -this.x(a), -this.y(a), 0);
            case 'scale':
                return this.put(i, this.x(a) * this.x(b), this.x(a) * this.y(b), 0);
            default:
                return this.carryOutScalar(i, a, b);
        }
    }
    /**
     * @param {number} i
     * @param {number} a
     * @param {number} b
     */
    carryOutScalar(i, a, b) {
        switch (this.verb[i]) {
            case 'ratio':
                return this.put(i, this.ratio(a, b), 0, 0);
            case 'product':
                return this.put(i, this.x(a) * this.x(b), 0, 0);
            case 'sum':
                return this.put(i, this.x(a) + this.x(b), 0, 0);
            case 'difference':
                return this.put(i, this.x(a) - this.x(b), 0, 0);
            case 'opposite':
                return this.put(i, -this.x(a), 0, 0);
            case 'quotient':
                return this.put(i, this.x(a) / this.x(b), 0, 0);
            case 'moment':
                return this.put(i, this.cross(a, b), 0, 0);
            case 'projection':
                return this.put(i, this.dot(a, b), 0, 0);
            default: {  // arm
                const share = -this.x(a) / this.dot(b, b);
                return this.put(i, share * -this.y(b), share * this.x(b), 0);
            }
        }
    }
    /**
     * @param {number} i
     * @param {number} p
     * @param {number} dx
     * @param {number} dy
     */
    lineThrough(i, p, dx, dy) {
        if (this.w(p) === 0) return this.put(i, 0, 0, 1);
        return this.put(i, -dy, dx, dy * this.x(p) - dx * this.y(p));
    }
    /**
     * @param {number} i
     * @param {number} p
     * @param {number} q
     */
    join(i, p, q) {
        if (this.w(p) === 0 && this.w(q) === 0) return this.put(i, 0, 0, 1);
        if (this.w(p) === 0) return this.lineThrough(i, q, this.x(p), this.y(p));
        if (this.w(q) === 0) return this.lineThrough(i, p, this.x(q), this.y(q));
        return this.lineThrough(i, p, this.x(q) - this.x(p), this.y(q) - this.y(p));
    }
    /**
     * @param {number} i
     * @param {number} l
     * @param {number} m
     */
    meet(i, l, m) {
        const w = this.x(l) * this.y(m) - this.y(l) * this.x(m);
        this.put(
            i,
            (this.y(l) * this.w(m) - this.w(l) * this.y(m)) / w,
            (this.w(l) * this.x(m) - this.x(l) * this.w(m)) / w,
            1,
        );
    }
    /**
     * @param {number} a
     * @param {number} b
     */
    ratio(a, b) {
        if (this.x(b) === 0) return this.y(a) / this.y(b);
        if (this.y(b) === 0) return this.x(a) / this.x(b);
        return this.dot(a, b) / this.dot(b, b);
    }
    /**
     * @param {number} a
     * @param {number} b
     */
    cross(a, b) {
        return this.x(a) * this.y(b) - this.y(a) * this.x(b);
    }
    /**
     * @param {number} a
     * @param {number} b
     */
    dot(a, b) {
        return this.x(a) * this.x(b) + this.y(a) * this.y(b);
    }
}
