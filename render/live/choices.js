// What a student chooses from: the vertices that are there, the directions of the mechanism.

import {quarterTurn, unitOf} from './closure.js';
import {unscored} from './exercise.js';
import {along, apart, minus, samePlace} from './path.js';
import {leadingTo} from './tasks.js';
/** @typedef {import('./exercise.js').Exercise} Exercise */
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./motion.js').Motion} Motion */
/** @typedef {import('./paper.js').Names} Names */
/** @typedef {import('./types.js').Spot} Spot */

/** @typedef {{name: string, along: Spot}} Direction a unit vector on paper */

export class Choices {
    /** @param {Exercise} exercise */
    constructor(exercise) {
        this.exercise = exercise;
    }
    /**
     * Vertices that are there, the pole first.
     * @param {FigureView} view
     * @returns {{name: string, at: Spot}[]}
     */
    pointsKnown(view) {
        const {tasks} = this.exercise;
        const letters = view.motion.data.plans[0].spots.filter(([figure]) => figure === view.id).flatMap(([, name]) => {
            const at = view.spot(name);
            return at ? [{name: unscored(name), at}] : [];
        });
        const drawnVectors = [...view.group.querySelectorAll(':scope > g.vector:not(.later)')].flatMap((node) => {
            const name = node.getAttribute('data-name') ?? '', ends = view.vector(name);
            return ends ? [{name, ends}] : [];
        });
        const own = tasks.filter(({kind}, i) => kind === 'vector' && this.exercise.done.has(i))
            .map(({name, from, by}) => ({name, ends: [from, along(from, 1, by)]}));
        const places = [
            ...tasks.filter((each) => leadingTo(each, tasks).length === 0).map(({from}) => from),
            ...[...drawnVectors, ...own].flatMap(({ends}) => ends),
            ...tasks.filter((each) => this.exercise.isReady(each, tasks)).map(({from}) => from),
        ];
        /** @type {{name: string, at: Spot}[]} */
        const points = [];
        for (const at of places) {
            if (points.some((each) => apart(each.at, at) < samePlace)) continue;
            const letter = letters.find((each) => apart(each.at, at) < samePlace)?.name;
            const tip = [...drawnVectors, ...own].find(({ends}) => apart(ends[1], at) < samePlace)?.name;
            const name =
                letter
                ?? (tip === undefined
                    ? this.exercise.page.word('start')
                    : this.exercise.page.word('tip_of').replace('{0}', unscored(tip)));
            points.push({name, at});
        }
        return points;
    }
    /**
     * Directions along and perpendicular to the lines of the mechanism.
     * @returns {Direction[]}
     */
    directions() {
        const {page} = this.exercise, {data} = page, motion = /** @type {Motion} */ (page.motion);
        /** @type {Direction[]} */
        const found = [];
        const add = (/** @type {string} */ name, /** @type {Spot} */ by) => {
            if (Math.hypot(by.x, by.y) < 1e-9) return;
            const e = unitOf({x: by.x, y: -by.y});
            found.push({name: `∥ ${name}`, along: e}, {name: `⟂ ${name}`, along: quarterTurn(e)});
        };
        const {points, guides} = motion.read, {joints} = /** @type {Names} */ (data.names);
        const label = (/** @type {number} */ point) => unscored(data.names.points[point].label);
        joints.forEach((one, i) =>
            joints.slice(i + 1).forEach((other) => {
                if (!one.bodies.some((body) => body > 0 && other.bodies.includes(body))) return;
                add(label(one.point) + label(other.point), minus(points[other.point], points[one.point]));
            }),
        );
        joints.forEach(
            ({point, turnsWith}, k) =>
                turnsWith >= 0 && add(page.word('guide').replace('{0}', label(point)), guides[k]),
        );
        found.push(
            {name: page.word('horizontal'), along: {x: 1, y: 0}},
            {name: page.word('vertical'), along: {x: 0, y: 1}},
        );
        return found;
    }
}
