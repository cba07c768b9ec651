// Evaluates the guards of a program that is replayed: whether its predicates have the verdicts that they had, in
// doubles.
// As engine/board/replay.cpp.

import {drawingPlane} from './replay.js';
/** @typedef {import('./replay.js').Replay} Replay */
/** @typedef {import('./types.js').Spot} Spot */

/** In the order of Guard::Question. */
const coincide = 0,
    parallel = 1,
    zeroVector = 2,
    zeroScalar = 3,
    onTheLine = 4,
    signOf = 5,
    turnSign = 6,
    alongSign = 7;
const byPrecision = 2;
const forcePlane = 3;
const zeroBits = 30, vanishingBits = 42;

export class Guards {
    /** @param {Replay} replay */
    constructor(replay) {
        this.replay = replay;
    }
    /**
     * The direction of a vector or a line.
     * @param {number} i
     * @returns {Spot}
     */
    direction(i) {
        return this.replay.isLine(i) ? {x: -this.replay.y(i), y: this.replay.x(i)} : {x: this.replay.x(i),
            y: this.replay.y(i)};
    }
    /**
     * A difference that was zero may show the rounding of its terms; one that was not must not vanish.
     * @param {number} question
     * @param {number} how
     * @param {number} a
     * @param {number} b
     * @param {number} verdict
     */
    holds(question, how, a, b, verdict) {
        const now = this.answer(question, a, b);
        const zero = question <= onTheLine ? 1 : 0;
        const isSmall = (/** @type {number} */ bits) => now.exact || now.excess * 2 ** bits <= now.unit;
        if (how === byPrecision && isSmall(this.replay.plan.doubtfulBits)) return true;
        if (verdict !== zero) return now.verdict === verdict && (now.exact || !isSmall(vanishingBits));
        if (now.verdict === zero || (!now.exact && isSmall(zeroBits))) return true;
        return question === parallel && !now.exact && now.excess * 2 ** zeroBits <= this.slack(a, b);
    }
    /**
     * @param {number} question
     * @param {number} a
     * @param {number} b
     */
    answer(question, a, b) {
        const plane = this.replay.plan.strokes[5 * a + 1];
        switch (question) {
            case coincide: {
                const far = [a, b].filter((i) => this.replay.w(i) === 0).length;
                if (far === 1) return plain(false);
                if (far === 2) return this.angle({x: this.replay.x(a), y: this.replay.y(a)}, {x: this.replay.x(b),
                    y: this.replay.y(b)});
                return zeroOf([this.replay.x(a) - this.replay.x(b), this.replay.y(a) - this.replay.y(b)],
                    this.replay.largestVector[plane]);
            }
            case parallel: {
                const first = this.replay.isLine(a) && this.replay.x(a) === 0 && this.replay.y(a) === 0;
                const second = this.replay.isLine(b) && this.replay.x(b) === 0 && this.replay.y(b) === 0;
                if (first || second) return plain(first && second);
                return this.angle(this.direction(a), this.direction(b));
            }
            case zeroVector:
                return zeroOf([this.replay.x(a), this.replay.y(a)], this.replay.largestVector[plane]);
            case zeroScalar:
                return zeroOf([this.replay.x(a)], this.besideScalar(plane));
            case onTheLine: {
                if (this.replay.x(b) === 0 && this.replay.y(b) === 0) return plain(this.replay.w(a) === 0);
                const along = this.direction(b);
                if (this.replay.w(a) === 0) return this.angle({x: this.replay.x(a), y: this.replay.y(a)}, along);
                const {replay} = this, excess = replay.x(b) * replay.x(a) + replay.y(b) * replay.y(a) + replay.w(b);
                return zeroOf([excess], magnitude(along) * this.replay.largestVector[plane]);
            }
            case signOf:
                return signAnswer(this.replay.x(a), this.besideScalar(plane));
            case turnSign:
            case alongSign: {
                const beside = magnitude({x: this.replay.x(a),
                    y: this.replay.y(a)}) * magnitude({x: this.replay.x(b), y: this.replay.y(b)});
                return signAnswer(question === turnSign ? this.replay.cross(a, b) : this.replay.dot(a, b), beside);
            }
            default:  // longer
                return plain(this.replay.dot(b, b) < this.replay.dot(a, a));
        }
    }
    /**
     * @param {Spot} d
     * @param {Spot} e
     */
    angle(d, e) {
        return zeroOf([d.x * e.y - d.y * e.x], magnitude(d) * magnitude(e));
    }
    /** @param {number} plane */
    besideScalar(plane) {
        if (plane === drawingPlane) return this.replay.largestScalar[plane];
        const size = this.replay.largestVector[drawingPlane], vector = this.replay.largestVector[plane];
        return Math.max(this.replay.largestScalar[plane], plane === forcePlane ? vector * size : vector / size);
    }
    /**
     * The magnitude of the vectors whose difference a direction is.
     * @param {number} i
     * @returns {number}
     */
    scaleOf(i) {
        const {strokes} = this.replay.plan;
        switch (this.replay.verb[i]) {
            case 'given_vector':
                return magnitude(this.direction(i));
            case 'through':
                return this.scaleOf(strokes[5 * i + 3]);
            case 'perpendicular':
            case 'turn':
            case 'negate':
            case 'direction_of_line':
                return this.scaleOf(strokes[5 * i + 2]);
            default:
                return Math.max(this.replay.largestVector[strokes[5 * i + 1]], magnitude(this.direction(i)));
        }
    }
    /**
     * @param {number} a
     * @param {number} b
     */
    slack(a, b) {
        return Math.max(this.scaleOf(a) * magnitude(this.direction(b)), magnitude(this.direction(a)) * this.scaleOf(b));
    }
}

/** @param {Spot} a */
function magnitude(a) {
    return Math.max(Math.abs(a.x), Math.abs(a.y));
}
/** @param {boolean} yes */
function plain(yes) {
    return {verdict: yes ? 1 : 0, exact: true, excess: 0, unit: 0};
}
/**
 * @param {number[]} excess
 * @param {number} unit
 */
function zeroOf(excess, unit) {
    const isZero = excess.every((each) => each === 0);
    return {verdict: isZero ? 1 : 0, exact: isZero, excess: Math.max(...excess.map(Math.abs)), unit};
}
/**
 * @param {number} value
 * @param {number} unit
 */
function signAnswer(value, unit) {
    const verdict = value === 0 ? 0 : value < 0 ? -1 : 1;
    return {verdict, exact: verdict === 0, excess: Math.abs(value), unit};
}
