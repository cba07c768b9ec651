// Replays a program in the browser, operation by operation, and evaluates every guard: engine/board/program.hpp and
// engine/board/replay.cpp in JavaScript, with the same order of operations. Knows no position and no figure.

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
const pointVerbs = new Set(['given_point', 'pole', 'point_at_infinity', 'meet', 'meet_at_infinity', 'carry']);
const lineVerbs = new Set(['through', 'join']);
const scalarVerbs = new Set(
    ['given_scalar', 'ratio', 'product', 'sum', 'difference', 'opposite', 'quotient', 'moment', 'projection']);
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
const drawingPlane = 0, forcePlane = 3;
const zeroBits = 30, vanishingBits = 42;

class Replay {
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
            if (!this.holds(guards[g], guards[g + 1], guards[g + 2], guards[g + 3], guards[g + 4])) return false;
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

    // --- guards ------------------------------------------------------------------------------------------------------

    /**
     * The direction of a vector or a line.
     * @param {number} i
     * @returns {Spot}
     */
    direction(i) {
        return this.isLine(i) ? {x: -this.y(i), y: this.x(i)} : {x: this.x(i), y: this.y(i)};
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
        if (how === byPrecision && isSmall(this.plan.doubtfulBits)) return true;
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
        const plane = this.plan.strokes[5 * a + 1];
        switch (question) {
            case coincide: {
                const far = [a, b].filter((i) => this.w(i) === 0).length;
                if (far === 1) return plain(false);
                if (far === 2) return this.angle({x: this.x(a), y: this.y(a)}, {x: this.x(b), y: this.y(b)});
                return zeroOf([this.x(a) - this.x(b), this.y(a) - this.y(b)], this.largestVector[plane]);
            }
            case parallel: {
                const first = this.isLine(a) && this.x(a) === 0 && this.y(a) === 0;
                const second = this.isLine(b) && this.x(b) === 0 && this.y(b) === 0;
                if (first || second) return plain(first && second);
                return this.angle(this.direction(a), this.direction(b));
            }
            case zeroVector:
                return zeroOf([this.x(a), this.y(a)], this.largestVector[plane]);
            case zeroScalar:
                return zeroOf([this.x(a)], this.besideScalar(plane));
            case onTheLine: {
                if (this.x(b) === 0 && this.y(b) === 0) return plain(this.w(a) === 0);
                const along = this.direction(b);
                if (this.w(a) === 0) return this.angle({x: this.x(a), y: this.y(a)}, along);
                const excess = this.x(b) * this.x(a) + this.y(b) * this.y(a) + this.w(b);
                return zeroOf([excess], magnitude(along) * this.largestVector[plane]);
            }
            case signOf:
                return signAnswer(this.x(a), this.besideScalar(plane));
            case turnSign:
            case alongSign: {
                const beside = magnitude({x: this.x(a), y: this.y(a)}) * magnitude({x: this.x(b), y: this.y(b)});
                return signAnswer(question === turnSign ? this.cross(a, b) : this.dot(a, b), beside);
            }
            default:  // longer
                return plain(this.dot(b, b) < this.dot(a, a));
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
        if (plane === drawingPlane) return this.largestScalar[plane];
        const size = this.largestVector[drawingPlane], vector = this.largestVector[plane];
        return Math.max(this.largestScalar[plane], plane === forcePlane ? vector * size : vector / size);
    }
    /**
     * The magnitude of the vectors whose difference a direction is.
     * @param {number} i
     * @returns {number}
     */
    scaleOf(i) {
        const {strokes} = this.plan;
        switch (this.verb[i]) {
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
                return Math.max(this.largestVector[strokes[5 * i + 1]], magnitude(this.direction(i)));
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
