// What the pointer means: a point that is there, a place exactly on a bar, a whole angle, a node of the grid.
import {rounded, type Spot, type Spots} from './edit';
import type {Json} from './json_text';
import type {Model} from './model';
import {angle, distance} from './placing';
import type {View} from './view';
import {word} from './words';

export interface Wheel {
    body: string;
    centre: string;
}
export interface Target {
    at: Spot;
    /** The point that is meant, or ''. */
    point: string;
    /** The bar on which it lies. */
    bar: {body: string, from: string, to: string} | null;
    says: string;
    snapped: string;
    /** The disc on which it lies. */
    wheel?: Wheel | null;
    /** How the point is placed, where it was typed. */
    form?: Json;
}

const reach = 14, barReach = 9;

/** The segments between the points of a body, as they are drawn. */
export function bars(model: Model, body: string, spots: Spots) {
    const points = model.pointsOf(body).filter((each) => spots[each]);
    if (points.length === 2) return [[points[0], points[1]]];
    return points.map((each, i) => [each, points[(i + 1) % points.length]]).filter(([a, b]) => a !== b);
}

export function pointNear(model: Model, spots: Spots, view: View, at: Spot, except = '') {
    let best = '', least = reach / view.scale;
    for (const {name} of model.points) {
        const away = spots[name] && name !== except ? distance(spots[name], at) : Infinity;
        if (away < least) [best, least] = [name, away];
    }
    return best;
}
export function barNear(model: Model, spots: Spots, view: View, at: Spot) {
    let best = null, least = barReach / view.scale;
    for (const {name} of model.movingBodies) {
        for (const [from, to] of bars(model, name, spots)) {
            const [a, b] = [spots[from], spots[to]], length = distance(a, b);
            if (length === 0) continue;
            const t = ((at[0] - a[0]) * (b[0] - a[0]) + (at[1] - a[1]) * (b[1] - a[1])) / length ** 2;
            const foot: Spot = [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
            const away = t > 0.02 && t < 0.98 ? distance(foot, at) : Infinity;
            if (away < least) [best, least] = [{body: name, from, to, ratio: t, foot}, away];
        }
    }
    return best;
}

/** The smallest disc of a moving body that holds a place. */
export function wheelAt(model: Model, spots: Spots, at: Spot): Wheel | null {
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
 * @param at where the pointer is
 * @param how *     from: where a line begins whose angle counts; isFree: no snapping
 */
export function snap(
    model: Model, spots: Spots, view: View, at: Spot,
    {from = null, except = '', isFree = false, onBars = true}:
        {from?: Spot | null, except?: string, isFree?: boolean, onBars?: boolean} = {}
): Target {
    const point = pointNear(model, spots, view, at, except);
    if (point) return {at: spots[point], point, bar: null, says: point, snapped: 'point'};
    const bar = onBars && !isFree ? barNear(model, spots, view, at) : null;
    if (bar) return {at: bar.foot, point: '', bar, says: `${bar.from}${bar.to}`, snapped: 'bar'};
    if (isFree) return {at, point: '', bar: null, says: '', snapped: ''};
    const onGrid = snapToGrid(view, at, from), wheel = onBars ? wheelAt(model, spots, onGrid.at) : null;
    return wheel ? {...onGrid, wheel, says: word('link', wheel.body)} : onGrid;
}
/** A node of the grid, or a whole angle from where a line begins. */
function snapToGrid({grid}: View, at: Spot, from: Spot | null): Target {
    const node: Spot = [rounded(Math.round(at[0] / grid) * grid), rounded(Math.round(at[1] / grid) * grid)];
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
