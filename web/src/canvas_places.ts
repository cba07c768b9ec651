// How the selected point is placed, as the file has it: the circles and lines on which it lies, the point from which
// it is measured, with the lengths and angles that are given.
import type {Canvas, Scene} from './canvas';
import {svg} from './dom';
import type {Spot} from './edit';
import type {Json} from './json_text';
import {Model} from './model';

/** Pixels: half the arc of a circle that is shown, and a line beyond its point. */
const halfArc = 70, beyond = 60;

export function drawPlacing(canvas: Canvas, scene: Scene) {
    const {model, selection} = scene, point = model.points.find(({path}) => Model.pointer(path) === selection);
    const at = point && canvas.spot(point.name), form = point?.form;
    if (!at || !form || Array.isArray(form)) return;
    const place = (of: Json) => placeOf(canvas, of), given = (value: Json) =>
        value === undefined ? '' : typeof value === 'number' ? `${value} ${model.unit}` : String(value);
    const marks = [];
    const from = place(form.from), to = place(form.to);
    if (from && to) marks.push(line(from, at), ...note(from, at, given(form.distance) || ratioOf(form)));
    else if (from)
        marks.push(line(from, at), ...note(from, at, [given(form.distance), angleOf(form.angle)].join('  ')));
    for (const curve of Array.isArray(form.meet) ? form.meet : []) {
        const centre = place(curve?.circle), through = place(curve?.line);
        if (centre) marks.push(line(centre, at), arc(centre, at), ...note(centre, at, given(curve.radius)));
        else if (through) marks.push(line(through, at, beyond), ...note(through, at, angleOf(curve.angle)));
    }
    canvas.layers.loads.append(svg('g', {class: 'placing'}, ...marks));
}
const ratioOf = (form: Json) => (form.ratio === undefined ? '' : `× ${form.ratio}`);
const angleOf = (angle: Json) => (angle === undefined ? '' : `∠ ${typeof angle === 'number' ? `${angle}°` : angle}`);
/** A point by its name or its coordinates, on the screen. */
function placeOf(canvas: Canvas, of: Json): Spot | null {
    if (typeof of === 'string') return canvas.spot(of);
    const isPlace = Array.isArray(of) && of.length === 2 && of.every((each) => typeof each === 'number');
    return isPlace ? canvas.view.toScreen(of as Spot) : null;
}
/** @param more pixels on each side */
function line(from: Spot, to: Spot, more = 0) {
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
    const [dx, dy] = [((to[0] - from[0]) * more) / length, ((to[1] - from[1]) * more) / length];
    return svg('path', {d: `M${from[0] - dx} ${from[1] - dy}L${to[0] + dx} ${to[1] + dy}`});
}
/** The circle about a centre, near a spot on it. */
function arc(centre: Spot, at: Spot) {
    const radius = Math.hypot(at[0] - centre[0], at[1] - centre[1]);
    const turned = Math.atan2(at[1] - centre[1], at[0] - centre[0]);
    const [start, end] = [-1, 1].map((way) => way * Math.min(halfArc / (radius || 1), 1)).map((by) =>
        `${centre[0] + radius * Math.cos(turned + by)} ${centre[1] + radius * Math.sin(turned + by)}`);
    return svg('path', {class: 'curve', d: `M${start}A${radius} ${radius} 0 0 1 ${end}`});
}
/** What is given, beside a line, nearer to its beginning: the number of a body stands in the middle. */
function note(from: Spot, to: Spot, says: string) {
    if (says.trim() === '') return [];
    const isSteep = Math.abs(to[1] - from[1]) > Math.abs(to[0] - from[0]);
    const [x, y] = [0.7 * from[0] + 0.3 * to[0], 0.7 * from[1] + 0.3 * to[1]];
    return [svg('text', {x: isSteep ? x + 16 : x, y: isSteep ? y : y + 26, class: isSteep ? 'beside' : ''}, says)];
}
