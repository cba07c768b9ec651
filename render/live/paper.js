// Where the elements of the program stand on the paper of a figure: points, vectors, lines, by name, in mm.

import {unitOf} from './closure.js';
import {apart, minus} from './path.js';
/** @typedef {import('./motion.js').Motion} Motion */
/** @typedef {import('./types.js').Spot} Spot */

/**
 * @typedef {{name: string, layer: string, origin: [number, number], places?: number, labels: string[][],
 *   isMechanism?: boolean, isStacked?: boolean, isHeld?: boolean, mayBeHeld?: boolean, hasNoTasks?: boolean,
 *   findsForces?: boolean, isLever?: boolean, isOfOne?: boolean, mayRest?: boolean, vectorsLike?: string,
 *   freeBody?: string, prefix?: string, loaded?: {joint: number, power: number}}} FigureInfo
 *   as InPage in the table of figures; freeBody: id of its body, empty for a pin; loaded: a figure of the contact at a
 *   joint, and the power of its load with which it grows
 * @typedef {{vectors: Map<string, number[]>, spots: Map<string, number>, lines: Map<string, {line: number, points:
 *   number[]}>}} Drawn
 * @typedef {{bodies: {id: string, label: string}[], joints: {id: string, point: number, turnsWith: number, bodies:
 *   [number, number]}[], points: {label: string}[], centres: Record<string, string>,
 *   units?: Record<string, number>}} Names
 *   units: SI units in those of figures that are others
 */

export class Paper {
    /** @type {Map<number, Drawn>} */
    plans = new Map();
    /**
     * By the name of a vector of this figure: its key in the plans.
     * @type {Map<string, string>}
     */
    keys = new Map();

    /**
     * @param {Element} group
     * @param {FigureInfo} info
     * @param {Motion} motion
     * @param {Names} names
     */
    constructor(group, info, motion, names) {
        this.group = group;
        this.info = info;
        this.motion = motion;
        this.names = names;
        this.id = group.getAttribute('data-id') ?? '';
        this.unit = group.getAttribute('data-unit') ?? '';
        /** SI units in the figure's unit. */
        this.inUnit = names.units?.[this.unit] ?? 1;
        /** @type {number} */
        this.drawnScale = Number(group.getAttribute('data-scale') ?? 1) * this.inUnit;
        /** @type {number} */
        this.scale = this.drawnScale;
        /** A free body, or a free pin. */
        this.isFree = info.freeBody !== undefined;
        /** Whether its marks say what they belong to. */
        this.isHeld = info.isHeld === true ||
            (info.mayBeHeld === true && group.querySelector('[data-on]') !== null);
        this.isMechanism = info.isMechanism === true || (this.isHeld && !info.isLever);
        /** SI units of the quantity for a mm of a vector; a drawing of the mechanism may show vectors. */
        this.vectorScale = this.drawnScale;
        if (this.isMechanism) this.drawnScale = this.scale = info.places ?? 1;
        this.origin = this.isMechanism || this.isHeld ? {x: info.origin[0], y: info.origin[1]} : this.poleOf();
        this.drawnOrigin = this.origin;
    }
    toDrawnScale() {
        this.scale = this.drawnScale;
        this.origin = this.drawnOrigin;
    }
    /** The current scale is the one of the drawing: Joukowsky's lever says it by its rays only. */
    takeScale() {
        this.drawnScale = this.scale;
    }
    /**
     * The pole of a polygon, computed from its vectors.
     * @returns {Spot}
     */
    poleOf() {
        /** @type {{name: string, key: string, x: number, y: number}[]} */
        const told = [];
        for (const node of this.group.querySelectorAll(':scope > g.vector')) {
            const name = node.getAttribute('data-name') ?? '', axis = node.querySelector('line.axis');
            // The second vector of a name is "F_3-2" on the sheet, F_3#1 in the plan.
            const own = this.vectorsOf(0).has(name) ? name : name.replace(/-\d+$/, '');
            for (const [key, [element]] of this.vectorsOf(0)) {
                const tail = axis && key.split('#')[0] === own ? this.motion.spot(element) : null;
                if (!axis || !tail) continue;
                const x = Number(axis.getAttribute('x1')) - tail.x / this.scale,
                    y = Number(axis.getAttribute('y1')) + tail.y / this.scale;
                told.push({name, key, x, y});
            }
        }
        // Two polygons may be of one body: the pole on which most vectors agree is the right one.
        const agreeing = told.map((one) => told.filter((other) => apart(one, other) < 0.05));
        const most = agreeing.reduce((best, each) => each.length > best.length ? each : best, []);
        // A vector drawn slightly beside its place, so that it does not cover another, is identified by its name.
        told.forEach(({name, key}) => this.keys.set(name, this.keys.has(name) ? '' : key));
        most.forEach(({name, key}) => this.keys.set(name, key));
        return most.length > 0 ? {x: most[0].x, y: most[0].y} : {x: 0, y: 0};
    }
    /**
     * The point at which the mechanism shows a vector: v_B at B; −1: none.
     * @param {string} name
     */
    pointOf(name) {
        return this.names.points.findIndex(({label}) => label === name.slice(2).replace('*', ''));
    }
    /**
     * Converts SI to mm on paper.
     * @param {Spot} at
     * @returns {Spot}
     */
    paper(at) {
        return {x: this.origin.x + at.x / this.scale, y: this.origin.y - at.y / this.scale};
    }
    /** @param {{left: number, right: number, top: number, bottom: number}} box m, y upwards */
    boxOnPaper({left, right, top, bottom}) {
        const a = this.paper({x: left, y: top}), b = this.paper({x: right, y: bottom});
        return {left: a.x, right: b.x, top: a.y, bottom: b.y};
    }
    /**
     * The same for the figure as drawn.
     * @param {Spot} at
     * @returns {Spot}
     */
    drawnPaper(at) {
        return {x: this.drawnOrigin.x + at.x / this.drawnScale, y: this.drawnOrigin.y - at.y / this.drawnScale};
    }
    /**
     * The elements that a plan draws in this figure, by name.
     * @param {number} plan
     */
    drawnBy(plan) {
        let found = this.plans.get(plan);
        if (found) return found;
        const own = this.isMechanism ? '' : this.id, drawn = this.motion.data.plans[plan];
        const from = this.info.vectorsLike ?? this.id;
        const vectors = drawn?.vectors ?? [], spots = drawn?.spots ?? [], lines = drawn?.lines ?? [];
        found = {
            vectors: new Map(),
            spots: new Map(spots.filter(([figure]) => figure === own).map(([, name, point]) => [name, point])),
            lines: new Map(
                lines.filter(([figure]) => figure === own).map(([, name, , line, ...points]) => [name, {line, points}]),
            ),
        };
        for (const [figure, name, tail, tip] of vectors) {
            if (figure !== from) continue;
            let key = name;
            const known = found.vectors.get(name);
            if (known && known[0] === tail && known[1] === tip) continue;  // of two bodies with a common point
            for (let k = 1; found.vectors.has(key); ++k) key = `${name}#${k}`;
            found.vectors.set(key, [tail, tip]);
        }
        this.plans.set(plan, found);
        return found;
    }
    /**
     * Tail and tip of the vectors of a plan, by name.
     * @param {number} plan
     */
    vectorsOf(plan) {
        return this.drawnBy(plan).vectors;
    }
    /**
     * Tail and tip on paper, in the current position.
     * @param {string} name
     * @returns {[Spot, Spot] | null}
     */
    vector(name) {
        const found = this.vectorsOf(this.motion.plan).get(this.keys.get(name) ?? name);
        const tail = found && this.motion.spot(found[0]), tip = found && this.motion.spot(found[1]);
        if (!tail || !tip) return null;
        if (!this.isMechanism) return [this.paper(tail), this.paper(tip)];
        const point = this.pointOf(name), by = minus(tip, tail);
        if (point < 0) return null;
        const from = this.point(point);
        return [from, {x: from.x + by.x / this.vectorScale, y: from.y - by.y / this.vectorScale}];
    }
    /**
     * A vertex or a centre, on paper.
     * @param {string} name
     * @returns {Spot | null}
     */
    spot(name) {
        const element = this.drawnBy(this.motion.plan).spots.get(name);
        const at = element === undefined ? null : this.motion.spot(element);
        return at && this.paper(at);
    }
    /**
     * The points through which a construction line was drawn, and its direction.
     * @param {string} name
     * @returns {{points: Spot[], direction: Spot} | null}
     */
    line(name) {
        const {motion} = this, found = this.drawnBy(motion.plan).lines.get(name);
        if (!found) return null;
        const points = found.points.map((element) => motion.spot(element)).filter((at) => at !== null);
        const replay = motion.replays[motion.plan], element = found.line;
        const direction = {x: -replay.y(element), y: -replay.x(element)};  // y downwards
        if (points.length === 0 || (direction.x === 0 && direction.y === 0)) return null;
        return {points: points.map((at) => this.paper(/** @type {Spot} */ (at))), direction: unitOf(direction)};
    }
    /**
     * @param {number} point
     * @returns {Spot}
     */
    point(point) {
        return this.paper(this.motion.read.points[point]);
    }
    /**
     * @param {Spot} at mm
     * @returns {Spot}
     */
    unpaper(at) {
        return {x: (at.x - this.origin.x) * this.scale, y: (this.origin.y - at.y) * this.scale};
    }
}
