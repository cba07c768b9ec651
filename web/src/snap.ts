// What the pointer means: a point that is there, a place exactly on a bar, a whole angle, a node of the grid.
import {rounded} from './edit.js';
import {angle, distance} from './placing.js';
import {word} from './words.js';

/**
 * @typedef {import('./edit.js').Spot} Spot
 * @typedef {import('./edit.js').Spots} Spots
 * @typedef {import('./model.js').Model} Model
 * @typedef {import('./view.js').View} View
 * @typedef {{body: string, centre: string}} Wheel
 * @typedef {{at: Spot, point: string, bar: {body: string, from: string, to: string} | null, says: string,
 *     snapped: string, wheel?: Wheel | null}} Target
 *     at: where; point: the point that is meant, or ''; bar: the bar on which it lies; wheel: the disc on which it lies
 */

const reach = 14, barReach = 9;

/**
 * The segments between the points of a body, as they are drawn.
 * @param {Model} model
 * @param {string} body
 * @param {Spots} spots
 */
export function bars(model, body, spots) {
    const points = model.pointsOf(body).filter((each) => spots[each]);
    if (points.length === 2) return [[points[0], points[1]]];
    return points.map((each, i) => [each, points[(i + 1) % points.length]]).filter(([a, b]) => a !== b);
}

/**
 * @param {Model} model
 * @param {Spots} spots
 * @param {View} view
 * @param {Spot} at
 * @param {string} [except]
 */
export function pointNear(model, spots, view, at, except = '') {
    let best = '', least = reach / view.scale;
    for (const {name} of model.points) {
        const away = spots[name] && name !== except ? distance(spots[name], at) : Infinity;
        if (away < least) [best, least] = [name, away];
    }
    return best;
}
/**
 * @param {Model} model
 * @param {Spots} spots
 * @param {View} view
 * @param {Spot} at
 */
export function barNear(model, spots, view, at) {
    let best = null, least = barReach / view.scale;
    for (const {name} of model.movingBodies) {
        for (const [from, to] of bars(model, name, spots)) {
            const [a, b] = [spots[from], spots[to]], length = distance(a, b);
            if (length === 0) continue;
            const t = ((at[0] - a[0]) * (b[0] - a[0]) + (at[1] - a[1]) * (b[1] - a[1])) / length ** 2;
            /** @type {Spot} */
            const foot = [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
            const away = t > 0.02 && t < 0.98 ? distance(foot, at) : Infinity;
            if (away < least) [best, least] = [{body: name, from, to, ratio: t, foot}, away];
        }
    }
    return best;
}

/**
 * The smallest disc of a moving body that holds a place.
 * @param {Model} model
 * @param {Spots} spots
 * @param {Spot} at
 * @returns {Wheel | null}
 */
export function wheelAt(model, spots, at) {
    let best = null, least = Infinity;
    for (const {form, point, bodies} of model.joints) {
        for (const body of bodies.filter((each) => each !== model.frame)) {
            const centre = model.centreOf(form, body);
            if (!spots[centre] || !spots[point]) continue;
            const radius = distance(spots[centre], spots[point]);
            if (radius < least && distance(spots[centre], at) < radius) [best, least] = [{body, centre}, radius];
        }
    }
    return best;
}

/**
 * @param {Model} model
 * @param {Spots} spots
 * @param {View} view
 * @param {Spot} at where the pointer is
 * @param {{from?: Spot | null, except?: string, isFree?: boolean, onBars?: boolean}} how
     *     from: where a line begins whose angle counts; isFree: no snapping
 * @returns {Target}
 */
export function snap(model, spots, view, at, {from = null, except = '', isFree = false, onBars = true} = {}) {
    const point = pointNear(model, spots, view, at, except);
    if (point) return {at: spots[point], point, bar: null, says: point, snapped: 'point'};
    const bar = onBars && !isFree ? barNear(model, spots, view, at) : null;
    if (bar) return {at: bar.foot, point: '', bar, says: `${bar.from}${bar.to}`, snapped: 'bar'};
    if (isFree) return {at, point: '', bar: null, says: '', snapped: ''};
    const onGrid = snapToGrid(view, at, from), wheel = onBars ? wheelAt(model, spots, onGrid.at) : null;
    return wheel ? {...onGrid, wheel, says: word('link', wheel.body)} : onGrid;
}
/**
 * A node of the grid, or a whole angle from where a line begins.
 * @param {View} view
 * @param {Spot} at
 * @param {Spot | null} from
 * @returns {Target}
 */
function snapToGrid({grid}, at, from) {
    /** @type {Spot} */
    const node = [rounded(Math.round(at[0] / grid) * grid), rounded(Math.round(at[1] / grid) * grid)];
    if (from && distance(from, at) > 0) {
        const turned = Math.round(angle(from, at) / 15) * 15, away = distance(from, at), rad = (turned * Math.PI) / 180;
        const off = Math.abs(angle(from, at) - turned);
        const length = rounded(Math.round(away / grid) * grid);
        if (off < 2.5 && length > 0 && turned % 90 !== 0)
            return {
                at: [from[0] + length * Math.cos(rad), from[1] + length * Math.sin(rad)],
                point: '',
                bar: null,
                says: '',
                snapped: 'angle'
            };
    }
    return {at: node, point: '', bar: null, says: '', snapped: 'grid'};
}
