// The current position and its results: computes positions of bodies from a driver's coordinate, givens from positions,
// replays a program with the givens, and reads the values of the columns from its elements. Knows no figure.

import {dot, Places, quarterTurn, unitOf} from './closure.js';
import {Givens} from './given.js';
import {Replay} from './replay.js';
/** @typedef {import('./types.js').Column} Column */
/** @typedef {import('./types.js').Course} Course */
/** @typedef {import('./types.js').MovingData} MovingData */
/** @typedef {import('./types.js').MovingGiven} MovingGiven */
/** @typedef {import('./types.js').Sample} Sample */
/** @typedef {import('./types.js').Spot} Spot */

/** @typedef {{points: Spot[], guides: Spot[], normals: Spot[], tangents: Spot[]}} Read */

export class Motion {
    /** @param {MovingData} data */
    constructor(data) {
        this.data = data;
        for (const {samples} of data.courses) {
            for (const sample of samples) {
                sample.coordinate ??= sample.at;
                sample.rate ??= 0;
                sample.acceleration ??= 0;
            }
        }
        this.places = new Places(data);
        this.replays = data.plans.map((plan) => new Replay(plan, data.size));
        this.helds = data.plans.map(({held}) => new Map(held.map(([name, place, vector, couple, given = -1]) =>
            [name, [place, vector, couple, given]])));
        /** The ranges of the drivers with the current givens. */
        this.courses = data.courses;
        this.course = data.courses[0];
        this.givens = new Givens(data, this.places, this.replays);
        /** As Sample.at. */
        this.at = 0;
        /** Index of the plan that is valid here; −1: none. */
        this.plan = 0;
        /** Current values of MovingData.settings, and how far those with a direction are turned, rad. */
        this.settings = data.settings.map(({value}) => value);
        this.turns = data.settings.map(() => 0);
        /**
         * Virtual displacements of the closure's unknowns in the current position, by driver.
         * @type {Map<number, Float64Array>}
         */
        this.displaced = new Map();
        this.read = this.places.read();
        this.rates = {rate: 0, acceleration: 0};
        this.isDrawn = true;
        /** Whether elements of the record stand where a student has put them. */
        this.isOwn = false;
        /**
         * Values by column that do not come from a plan.
         * @type {(number | null)[] | null}
         */
        this.told = null;
        this.toDrawn();
    }

    /** A structure that nothing drives has one position. */
    get isStill() {
        return this.data.courses[0].samples.length === 1;
    }
    get isAsGiven() {
        return this.data.settings.every(({value}, i) => value === this.settings[i] && this.turns[i] === 0);
    }
    /**
     * Exactly the position of the file, with the current givens.
     * @param {Course} course
     */
    toDrawn(course = this.course) {
        const index = Math.max(this.courses.indexOf(course), 0);
        if (!this.isAsGiven) this.give(this.data.settings.map(({value}) => value), this.turns.map(() => 0));
        course = this.courses[index];
        const {places, data} = this;
        const q = new Float64Array(data.frozen.length);
        for (const [x, y, column] of data.bodies) {
            if (column >= 0) [q[column], q[column + 1]] = [x, y];
        }
        places.set(q);
        this.course = course;
        this.at = 0;
        const sample = course.samples.find((each) => each.at === 0);
        this.rates = {rate: sample?.rate ?? 0, acceleration: sample?.acceleration ?? 0};
        this.read = places.read();
        this.isDrawn = true;
        this.isOwn = false;
        this.told = null;
        this.plan = this.planHere([0]);
    }

    /**
     * The drawn position with some elements elsewhere, and all that follows from them.
     * @param {Map<number, [number, number, number]>} own by element
     */
    putOwn(own) {
        this.toDrawn();
        this.isOwn = own.size > 0;
        if (this.isOwn && this.plan >= 0) this.replays[this.plan].runWith(own);
    }

    /**
     * Sets other values, as Motion.settings; the coordinate stays if possible. False if the joints do not close; then
     * nothing changes.
     * @param {number[]} settings
     * @param {number[]} turns as Motion.turns
     */
    give(settings, turns = this.turns) {
        const {givens, data} = this, index = this.courses.indexOf(this.course), values = [...settings];
        const differs = (/** @type {number} */ i) => values[i] !== this.settings[i];
        const isFirst = (/** @type {number} */ i) => !givens.isOfPlace(i) || values[i] === data.settings[i].value;
        if (values.every((_, i) => isFirst(i))) {
            givens.put(values);
            givens.shapes.fill(null);
            this.courses = data.courses;
        } else if (values.some((_, i) => differs(i) && givens.isOfPlace(i))) {
            const ways = givens.waysWith(this.courses, this.settings, values, this.at);
            if (!ways) return false;
            this.courses = ways;
        }
        this.settings = values;
        this.turns = turns;
        const course = this.courses[index], {samples} = course;
        this.moveTo(course, Math.min(Math.max(this.at, samples[0].at), samples[samples.length - 1].at));
        return true;
    }
    /**
     * False if the joints do not close; then nothing moves.
     * @param {Course} course
     * @param {number} at
     */
    moveTo(course, at) {
        const {samples} = course;
        if (this.isStill) return this.stand();
        let after = samples.findIndex((sample) => sample.at >= at);
        if (after < 0) after = samples.length - 1;
        const low = samples[Math.max(after - 1, 0)], high = samples[after];
        const nearest = Math.abs(high.at - at) <= Math.abs(at - low.at) ? high : low;
        const place = course.byLaw ? nearest.at : at;
        const share = high.at === low.at ? 1 : Math.min(Math.max((place - low.at) / (high.at - low.at), 0), 1);
        const start = low.q.map((value, k) => value + share * (high.q[k] - value));
        const coordinate = course.byLaw ? nearest.coordinate : at;
        if (!this.places.close(start, coordinate, course.shares)) return false;
        this.course = course;
        this.at = place;
        this.isDrawn = place === 0 && this.isAsGiven;
        this.isOwn = false;
        this.rates = {rate: nearest.rate, acceleration: nearest.acceleration};
        this.read = this.places.read();
        this.told = null;
        const likely = [nearest.plan, low.plan, high.plan];
        this.plan = this.planHere(likely);
        if (this.plan < 0) this.stepAside(course, start, coordinate, likely,
            nearest.at === place && this.isAsGiven ? nearest.values : undefined);
        return true;
    }

    /** The only position, with the current givens. */
    stand() {
        this.isDrawn = this.isAsGiven;
        this.isOwn = false;
        this.told = null;
        this.plan = this.planHere([0]);
        return true;
    }
    /**
     * Where doubles cannot decide a guard, the numbers are those of the exact construction, and the figures are drawn
     * at a coordinate shifted by a millionth of the range.
     * @param {Course} course
     * @param {number[]} start
     * @param {number} coordinate
     * @param {number[]} likely
     * @param {(number | null)[] | undefined} values
     */
    stepAside(course, start, coordinate, likely, values) {
        const told = this.data.columns.map((column, i) => isOfPlace(column) ? this.value(i) : values?.[i] ?? null);
        for (const by of [1e-6, -1e-6]) {
            if (!this.places.close(start, coordinate + by * (course.to - course.from), course.shares)) continue;
            this.read = this.places.read();
            this.plan = this.planHere(likely);
            if (this.plan >= 0) break;
        }
        this.told = told;
    }

    /**
     * The plan whose guards hold; the neighbours' plans are tried first.
     * @param {number[]} likely
     */
    planHere(likely) {
        this.displaced.clear();
        const tried = new Set([this.plan, ...likely]);
        this.replays.forEach((_, i) => tried.add(i));
        likely.forEach((i) => tried.delete(i));
        for (const i of [...new Set(likely), ...tried]) {
            if (i < 0) continue;
            for (const rule of this.data.plans[i].moving) this.replays[i].give(rule.given, this.valueOf(rule, i));
            if (this.replays[i].run()) return i;
        }
        return -1;
    }

    /**
     * @param {MovingGiven} rule
     * @param {number} plan
     * @returns {number[]}
     */
    valueOf(rule, plan) {
        const {points, guides, normals, tangents} = this.read;
        const between = () => {
            const [from, to] = rule.ends.map((end) => points[end]);
            return {x: to.x - from.x, y: to.y - from.y};
        };
        const as = (/** @type {Spot} */ a, factor = 1) => [factor * a.x, factor * a.y];
        switch (rule.rule) {
            case 'place':
                return [points[rule.index].x, points[rule.index].y, 1];
            case 'guide':
                return as(guides[rule.index]);
            case 'guide_unit':
                return as(unitOf(guides[rule.index]));
            case 'normal':
                return as(normals[rule.index], rule.factor);
            case 'other_normal': {
                const n = normals[rule.index], t = tangents[rule.index], k = 2 * dot(n, t) / dot(t, t);
                return [k * t.x - n.x, k * t.y - n.y];
            }
            case 'tangent':
                return as(tangents[rule.index]);
            case 'between':
                return as(unitOf(between()));
            case 'spring':
                return [rule.factor * (Math.hypot(between().x, between().y) - rule.offset)];
            case 'torsion':
                return [
                    -rule.factor * (rule.offset + this.places.turn[rule.bodies[0]] - this.places.turn[rule.bodies[1]]),
                ];
            case 'setting': {
                const share = this.settings[rule.index] / this.data.settings[rule.index].value;
                return turned(this.data.plans[plan].givens[rule.given].map((each) => share * each),
                    this.turns[rule.index]);
            }
            case 'turned':
                return turned(this.data.plans[plan].givens[rule.given], this.turns[rule.index]);
            case 'rate':
                return [this.rates.rate];
            default:
                return [this.rates.acceleration];
        }
    }

    /**
     * A column's value, SI; null if no plan is valid here, or it does not give the value.
     * @param {number} index
     * @returns {number | null}
     */
    value(index) {
        if (this.told) return this.told[index];
        const column = this.data.columns[index];
        switch (column.kind) {
            case 'angle':
                return this.data.directions[column.body] + this.places.turn[column.body];
            case 'place_x':
                return this.read.points[column.point].x;
            case 'place_y':
                return this.read.points[column.point].y;
            case 'slid':
                return this.places.slid(this.data.joints[column.joint]);
            default:
                return this.result(index);
        }
    }
    /**
     * @param {number} index
     * @returns {number | null}
     */
    result(index) {
        if (this.plan < 0) return null;
        const column = this.data.columns[index], source = this.data.plans[this.plan].sources[index];
        if (source === -2) return null;
        if (source === -1) return 0;
        const replay = this.replays[this.plan];
        if (column.kind === 'along') {
            return dot(this.slidingDirection(column.joint), {x: replay.x(source), y: replay.y(source)});
        }
        return column.component === 'y' ? replay.y(source) : replay.x(source);
    }
    /**
     * The x axis of a slide, or the common tangent of a contact or a curved slot.
     * @param {number} joint
     */
    slidingDirection(joint) {
        const guide = this.read.guides[joint], tangent = this.read.tangents[joint];
        if (guide.x !== 0 || guide.y !== 0) return unitOf(guide);
        return unitOf(tangent.x !== 0 || tangent.y !== 0 ? tangent : quarterTurn(this.read.normals[joint]));
    }
    /**
     * The setting by which a given vector is changed and turned; −1: none.
     * @param {number} given index of the load, or of the given velocity
     */
    turning(given) {
        return given < 0 ? -1 : this.data.settings.findIndex((each) => each.direction !== undefined &&
            each.given === given);
    }
    /**
     * The virtual displacement of a point for a displacement one of a driver's coordinate, m.
     * @param {number} point
     * @param {number} driver
     * @returns {Spot}
     */
    displacement(point, driver) {
        let by = this.displaced.get(driver);
        if (!by) this.displaced.set(driver, by = this.places.displaced(driver));
        const {x, y} = this.places.displacement(point, by);
        return {x: this.data.unit * x, y: this.data.unit * y};
    }
    /**
     * Place, vector and couple of a mark's name in the current plan; −1: it vanishes.
     * @param {string} name
     * @returns {number[] | undefined}
     */
    held(name) {
        return this.plan < 0 ? undefined : this.helds[this.plan].get(name);
    }
    /**
     * The position of an element that is a point; null: at infinity, or not evaluated here.
     * @param {number} element
     * @returns {Spot | null}
     */
    spot(element) {
        if (this.plan < 0 || element < 0) return null;
        const replay = this.replays[this.plan];
        return replay.w(element) === 0 ? null : {x: replay.x(element), y: replay.y(element)};
    }
}

/**
 * A vector turned; scalars stay.
 * @param {number[]} value
 * @param {number} by
 */
function turned(value, by) {
    if (by === 0 || value.length < 2) return value;
    const [c, s] = [Math.cos(by), Math.sin(by)], [x, y] = value;
    return [c * x - s * y, s * x + c * y];
}

/**
 * Whether the position alone determines a column.
 * @param {Column} column
 */
export function isOfPlace(column) {
    return ['angle', 'place_x', 'place_y', 'slid'].includes(column.kind);
}
