// Lengths and parameters that a reader may change: updates the numbers of the closure and of the plans, and computes
// each driver's range again, as far as the joints close. Knows no figure.

import {dot, quarterTurn, together, unitOf} from './closure.js';
import {along, apart, minus} from './path.js';
/** @typedef {import('./closure.js').Places} Places */
/** @typedef {import('./replay.js').Replay} Replay */
/** @typedef {import('./types.js').Course} Course */
/** @typedef {import('./types.js').MovingData} MovingData */
/** @typedef {import('./types.js').Sample} Sample */
/** @typedef {import('./types.js').Spot} Spot */

/**
 * Positions on a whole range; distance of the last one from a limit; tolerance of a start; largest error of a start of
 * Newton's method.
 */
const stepsOfWay = 72, shortOfLimit = 1e-6, nearEnough = 0.02, farthestChange = 0.3;

export class Givens {
    /**
     * @param {MovingData} data
     * @param {Places} places as drawn
     * @param {Replay[]} replays
     */
    constructor(data, places, replays) {
        this.data = data;
        this.places = places;
        this.replays = replays;
        const {rows, bodies, points, joints} = data;
        this.drawn = {rows, bodies, points, joints};
        this.kept = JSON.stringify(this.drawn);
        this.effects = data.effects.map(([way, ...terms]) => ({way, terms, value: partOf(data, way).value}));
        const read = places.read();
        this.grounds = data.settings.map(({bar, ends}) =>
            ends && bar === undefined ? ends.map((end) => scaledBy(1 / data.unit, read.points[end])) : null,
        );
        /**
         * By body: maps a place as drawn to the current one (from the body's reference); null: unchanged.
         * @type {(((at: Spot) => Spot) | null)[]}
         */
        this.shapes = bodies.map(() => null);
    }

    /** @param {number} setting */
    isOfPlace(setting) {
        const {ends, parameter} = this.data.settings[setting];
        return Boolean(ends || parameter);
    }
    /**
     * Whether it depends on a parameter of the file; then the parameter is changed instead.
     * @param {number} setting
     */
    follows(setting) {
        return this.data.effects.some(([[list, index]]) => list === 'settings' && index === setting);
    }

    /**
     * Sets these values; writes the values of settings that depend on parameters into them.
     * @param {number[]} values
     */
    put(values) {
        const {data} = this, by = values.map((value, i) => value - data.settings[i].value);
        Object.assign(data, by.every((each) => each === 0) ? this.drawn : JSON.parse(this.kept));
        data.settings.forEach(({bar, value}, i) => {
            const ground = this.grounds[i];
            if (by[i] !== 0 && bar !== undefined) this.stretch(bar, values[i] / value);
            if (by[i] !== 0 && ground) this.carry(ground[1], scaledBy(by[i] / value, minus(ground[1], ground[0])));
        });
        const changed = new Set(), deltas = this.deltas(values);
        for (const {way, terms, value} of this.effects) {
            let now = value;
            for (let k = 0; k < terms.length; k += 3) {
                now += terms[k + 2] * deltas[terms[k]] * (terms[k + 1] < 0 ? 1 : deltas[terms[k + 1]]);
            }
            if (way[0] === 'settings') values[Number(way[1])] = now;
            else partOf(data, way).set(now);
            if (way[2] === 'givens') changed.add(`${way[1]} ${way[3]}`);
        }
        for (const each of changed) {
            const [plan, given] = each.split(' ').map(Number);
            this.replays[plan].give(given, data.plans[plan].givens[given]);
        }
    }
    /**
     * Two for each setting: its increase; for an angle the increases of its cosine and its sine.
     * @param {number[]} values
     */
    deltas(values) {
        return this.data.settings.flatMap(({value, radians}, i) => {
            if (!radians) return [values[i] - value, 0];
            const [now, then] = [values[i] * radians, value * radians];
            return [Math.cos(now) - Math.cos(then), Math.sin(now) - Math.sin(then)];
        });
    }
    /**
     * Scales all places of a body about its reference.
     * @param {number} body
     * @param {number} factor
     */
    stretch(body, factor) {
        this.changeLocals((on, at) => on === body ? scaledBy(factor, at) : at);
    }
    /**
     * Moves what is fixed to the frame at a place.
     * @param {Spot} place
     * @param {Spot} by
     */
    carry(place, by) {
        const there = (/** @type {Spot} */ at) => apart(at, place) < 1e-12;
        this.changeLocals((on, at) => on === 0 && there(at) ? along(at, 1, by) : at);
        this.data.bodies.forEach((body) => {
            if (body[2] < 0 && there({x: body[0], y: body[1]})) body[0] += by.x, body[1] += by.y;
        });
    }
    /** @param {(body: number, at: Spot) => Spot} change */
    changeLocals(change) {
        const write = (/** @type {any} */ into, /** @type {number} */ first, /** @type {number} */ body) => {
            const {x, y} = change(body, {x: into[first], y: into[first + 1]});
            into[first] = x;
            into[first + 1] = y;
        };
        for (const row of this.data.rows) {
            write(row, 3, row[1]);
            write(row, 5, row[2]);
        }
        for (const point of this.data.points) write(point, 1, point[0]);
        for (const {bodies, locals} of this.data.joints) bodies.forEach((body, side) => write(locals[side], 0, body));
    }

    /**
     * The drivers' ranges with other values, on the same branch; null if the joints do not close, and then nothing
     * changes.
     * @param {Course[]} courses
     * @param {number[]} before
     * @param {number[]} after
     * @param {number} near the current coordinate
     * @returns {Course[] | null}
     */
    waysWith(courses, before, after, near) {
        const ways = courses.map((course) => {
            const off = (/** @type {Sample} */ sample) =>
                Math.min(Math.abs(sample.at), Math.abs(sample.at - near) + 1e-9);
            for (const sample of [...course.samples]
                .sort((a, b) => off(a) - off(b))
                .filter((_, i) => i < 2 || i % 6 === 0)) {
                const q = this.reach(course, sample, before, after);
                if (q) return course.byLaw ? this.timesFrom(course, sample, q) : this.wayFrom(course, sample.at, q);
            }
            return null;
        });
        const all = ways.flatMap((way) => way ?? []);
        if (all.length < ways.length) {
            this.put(before);
            return null;
        }
        this.findShapes();
        return all;
    }
    /**
     * A position at the same coordinate, reached by changing the values in small steps.
     * @param {Course} course
     * @param {Sample} sample
     * @param {number[]} before
     * @param {number[]} after
     */
    reach(course, sample, before, after) {
        let q = sample.q, share = 0, step = 0.25;
        while (share < 1) {
            const next = Math.min(share + step, 1);
            this.put(next === 1 ? after : after.map((value, i) => before[i] + next * (value - before[i])));
            const found = this.places.close(q, sample.coordinate, course.shares) ? [...this.places.q] : null;
            if (found && largest(found, q) < farthestChange) {
                [q, share, step] = [found, next, 0.25];
            } else if ((step /= 2) < 1 / 512) {
                return null;
            }
        }
        return q;
    }
    /**
     * @param {Course} course
     * @param {number} from
     * @param {number[]} q
     * @returns {Course}
     */
    wayFrom(course, from, q) {
        const span = course.to - course.from, whole = 2 * Math.PI;
        const upward = course.turns ? whole : course.endsAtLimit ? 2 * span : course.to - from;
        const up = this.walk(course, from, q, 1, upward, course.turns ? whole : span);
        const isRound = course.turns && !up.isLimit;
        const downward = isRound ? 0 : course.turns ? whole : course.startsAtLimit ? 2 * span : from - course.from;
        const down = this.walk(course, from, q, -1, downward, course.turns ? whole : span);
        const all = [...down.samples.reverse(), {at: from, q}, ...up.samples];
        return {
            ...course,
            changePoints: [],
            startsAtLimit: down.isLimit,
            endsAtLimit: up.isLimit,
            from: all[0].at,
            to: all[all.length - 1].at,
            samples: all.map(({at, q: there}) => ({at, coordinate: at, plan: -1, rate: 0, acceleration: 0, q: there})),
        };
    }
    /**
     * Goes from a position as far as the joints close. It predicts each position and rejects one far from the
     * prediction.
     * @param {Course} course
     * @param {number} from
     * @param {number[]} start
     * @param {number} sense
     * @param {number} most
     * @param {number} way
     */
    walk(course, from, start, sense, most, way) {
        /** @type {{at: number, q: number[]}[]} */
        const samples = [];
        const closed = (/** @type {number[]} */ guess, /** @type {number} */ at) =>
            this.places.close(guess, at, course.shares) ? [...this.places.q] : null;
        const longest = way / stepsOfWay,
            nudge = 1e-4 * longest,
            first = most > 0 ? closed(start, from + sense * nudge) : null;
        let slope = first ? first.map((value, k) => (value - start[k]) / nudge) : start.map(() => 0);
        let gone = 0, q = start, step = longest;
        while (gone < most) {
            const next = gone + step > most - shortOfLimit * way ? most : gone + step, by = next - gone;
            const guess = q.map((value, k) => value + by * slope[k]), found = closed(guess, from + sense * next);
            if (found && largest(found, guess) <= nearEnough) {
                slope = found.map((value, k) => (value - q[k]) / by);
                [q, gone, step] = [found, next, Math.min(2 * step, longest)];
                samples.push({at: from + sense * gone, q});
            } else if ((step = by / 2) < shortOfLimit * way) {
                return {samples, isLimit: true};
            }
        }
        return {samples, isLimit: false};
    }
    /**
     * For a law: the same times, as far as the joints close.
     * @param {Course} course
     * @param {Sample} start
     * @param {number[]} q
     * @returns {Course}
     */
    timesFrom(course, start, q) {
        const middle = course.samples.indexOf(start);
        const go = (/** @type {Sample[]} */ on) => {
            let [before, here] = [q, q];
            /** @type {Sample[]} */
            const found = [];
            for (const sample of on) {
                const guess = here.map((value, k) => 2 * value - before[k]);
                if (!this.places.close(guess, sample.coordinate, course.shares)) break;
                [before, here] = [here, [...this.places.q]];
                if (largest(here, guess) > farthestChange) break;
                found.push({...sample, plan: -1, values: undefined, q: here});
            }
            return found;
        };
        const later = go(course.samples.slice(middle + 1)), earlier = go(course.samples.slice(0, middle).reverse());
        return {...course, samples: [...earlier.reverse(), {...start, plan: -1, values: undefined, q}, ...later]};
    }

    /**
     * The maps of Givens.shapes: a bar is scaled between its places and keeps its length beyond them; a plate follows
     * three of its places.
     */
    findShapes() {
        const {data} = this;
        this.shapes = data.bodies.map((_, body) => {
            const pairs = [{from: {x: 0, y: 0}, to: {x: 0, y: 0}}];
            /** @type {(on: number, was: number[], is: number[], first: number) => void} */
            const see = (on, was, is, first) => {
                if (on === body)
                    pairs.push({from: {x: was[first], y: was[first + 1]}, to: {x: is[first], y: is[first + 1]}});
            };
            data.points.forEach((point, i) => see(point[0], this.drawn.points[i], point, 1));
            data.rows.filter(([kind]) => kind === together).forEach((row) => {
                const drawn = this.drawn.rows[data.rows.indexOf(row)];
                see(row[1], drawn, row, 3);
                see(row[2], drawn, row, 5);
            });
            if (pairs.every(({from, to}) => apart(from, to) < 1e-14)) return null;
            return shapeOf(pairs);
        });
    }
}

/**
 * @param {{from: Spot, to: Spot}[]} pairs
 * @returns {((at: Spot) => Spot) | null}
 */
function shapeOf(pairs) {
    const [first] = pairs;
    const far = pairs.reduce(
        (best, each) => (apart(each.from, first.from) > apart(best.from, first.from) ? each : best),
        first,
    );
    const a = minus(far.from, first.from),
        size = Math.hypot(a.x, a.y);
    if (size === 0) return (at) => along(at, 1, minus(first.to, first.from));
    const e = unitOf(a),
        n = quarterTurn(e),
        b = minus(far.to, first.to),
        longer = Math.hypot(b.x, b.y) - size,
        f = unitOf(b);
    const off = (/** @type {{from: Spot}} */ {from}) => Math.abs(dot(minus(from, first.from), n));
    const third = pairs.reduce((best, each) => (off(each) > off(best) ? each : best), first);
    const across = quarterTurn(f),
        lean = dot(minus(third.from, first.from), e),
        rise = dot(minus(third.from, first.from), n);
    const isPlate = Math.abs(rise) > 1e-9;
    const c = isPlate ? scaledBy(1 / rise, minus(third.to, along(first.to, lean / size, b))) : across;
    return (at) => {
        const t = dot(minus(at, first.from), e), s = dot(minus(at, first.from), n);
        const gone = isPlate ? t * (1 + longer / size) : t + longer * Math.min(Math.max(t / size, 0), 1);
        return along(along(first.to, gone, f), s, c);
    };
}

/**
 * @param {number} factor
 * @param {Spot} a
 * @returns {Spot}
 */
export function scaledBy(factor, a) {
    return {x: factor * a.x, y: factor * a.y};
}
/**
 * @param {ArrayLike<number>} a
 * @param {ArrayLike<number>} b
 */
function largest(a, b) {
    let most = 0;
    for (let k = 0; k < a.length; ++k) most = Math.max(most, Math.abs(a[k] - b[k]));
    return most;
}
/**
 * A number of the data, by its path.
 * @param {any} data
 * @param {any[]} way
 */
function partOf(data, way) {
    const last = way[way.length - 1], holder = way.slice(0, -1).reduce((part, step) => part[step], data);
    return {
        value: /** @type {number} */ (holder[last]),
        set(/** @type {number} */ value) {
            holder[last] = value;
        },
    };
}
