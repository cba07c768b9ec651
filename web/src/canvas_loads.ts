// Drivers, weights and loads on the canvas.
import type {Canvas, Scene} from './canvas';
import {svg} from './dom';
import type {Spot} from './edit';
import type {Json} from './json_text';
import {Model} from './model';
import * as symbols from './symbols';

/** The angle between two directions. */
export function gap(a: number, b: number) {
    const turned = Math.abs(a - b) % (2 * Math.PI);
    return Math.min(turned, 2 * Math.PI - turned);
}
export function drawDrivers(canvas: Canvas, scene: Scene) {
    const {model} = scene;
    for (const {form, pointer} of model.drivers) {
        const rate = parseFloat(form.omega ?? form.speed ?? form.law?.turn ?? 1) || 1, body = String(form.body ?? '');
        if (form.joint !== undefined) {
            const joint = model.joints.find((each) => each.name === String(form.joint)),
                at = canvas.spot(joint?.point ?? '');
            if (joint && at)
                push(canvas, pointer, at, canvas.turned(joint.pointer, joint.form.along) + (rate < 0 ? Math.PI : 0));
            continue;
        }
        const pivot = model.pointsOf(body).find((each) => model.isGround(each)) ?? model.pointsOf(body)[0],
            at = canvas.spot(form.at ?? pivot ?? '');
        const tip = canvas.spot(model.pointsOf(body).find((each) => each !== pivot) ?? '');
        const beside = at && tip ? Math.atan2(tip[1] - at[1], tip[0] - at[0]) : -1;
        if (at) canvas.add('loads', pointer, 'drive', symbols.spin(at, rate >= 0, beside));
    }
}
/** An arrow beside a slider that is driven. */
function push(canvas: Canvas, pointer: string, [x, y]: Spot, turned: number) {
    const from = [x - 22 * Math.sin(-turned), y - 22 * Math.cos(turned)] as Spot;
    canvas.add(
        'loads',
        pointer,
        'drive',
        symbols.arrow(from, [from[0] + 46 * Math.cos(turned), from[1] + 46 * Math.sin(turned)], 'driver')
    );
}
export function drawMasses(canvas: Canvas, scene: Scene) {
    const {model} = scene;
    for (const {body, form} of model.masses) {
        const at = canvas.spot(form.centre ?? '');
        if (at) canvas.add('loads', Model.pointer(['masses', body]), canvas.look(body), symbols.weight(at));
    }
}
export function drawLoads(canvas: Canvas, scene: Scene) {
    const {model} = scene;
    for (const {form, pointer} of model.loads) {
        const between = Array.isArray(form.between)
            ? form.between.map((each: string) => canvas.spot(each))
            : [];
        if (between.length === 2 && between[0] && between[1]) {
            canvas.add('under', pointer, 'load', symbols.spring(between[0], between[1]));
            continue;
        }
        const pin = model.joints.find((each) => each.name === String(form.pin)),
            at = canvas.spot(form.at ?? pin?.point ?? '');
        if (at && form.force !== undefined) drawForce(canvas, form, pointer, at, String(form.at ?? pin?.point ?? ''));
        else if (form.couple !== undefined) drawCouple(canvas, scene, form, pointer);
        else if (form.distributed !== undefined) drawDistributed(canvas, form, pointer);
    }
}
function drawForce(canvas: Canvas, form: Json, pointer: string, at: Spot, point: string) {
    const turned = canvas.turned(pointer, form.along), length = 62, sign = parseFloat(form.magnitude) < 0 ? -1 : 1;
    const taken = canvas.waysTaken(point, at), heads = turned + (sign < 0 ? Math.PI : 0);
    const room = (way: number) => Math.min(3, ...taken.map((each) => gap(way, each)));
    // The arrow ends at the point, or begins there where bars are in the way.
    const isPull = room(heads + Math.PI) < 0.7 && room(heads) > 0.7;
    const along = (away: number) =>
        [at[0] + away * Math.cos(heads), at[1] + away * Math.sin(heads)] as Spot;
    const [tail, tip] = isPull ? [along(8), along(length)] : [along(-length), along(-9)],
        end = isPull ? along(length + 6) : along(-length - 6);
    canvas.add(
        'loads',
        pointer,
        'load',
        symbols.arrow(tail, tip, 'force'),
        symbols.label([end[0] + 12, end[1] + 4], String(form.force), 'of-load')
    );
}
function drawCouple(canvas: Canvas, {model}: Scene, form: Json, pointer: string) {
    const at = canvas.spot(model.pointsOf(String(form.body))[0] ?? '');
    if (at) canvas.add('loads', pointer, 'load', symbols.spin([at[0], at[1] - 4], !(parseFloat(form.value) < 0)));
}
function drawDistributed(canvas: Canvas, form: Json, pointer: string) {
    const from = canvas.spot(form.from ?? ''),
        to = canvas.spot(form.to ?? ''),
        turned = canvas.turned(pointer, form.along);
    if (!from || !to) return;
    const back = (at: Spot) =>
        [at[0] - 34 * Math.cos(turned), at[1] - 34 * Math.sin(turned)] as Spot;
    const marks = [0, 0.25, 0.5, 0.75, 1].map((t) => {
        const at = [from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])] as Spot;
        return symbols.arrow(back(at), at, 'force');
    });
    const [a, b] = [back(from), back(to)];
    canvas.add('loads', pointer, 'load', svg('path', {class: 'edge', d: `M${a}L${b}`}), ...marks);
}
