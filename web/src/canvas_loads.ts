// Drivers, weights and loads on the canvas.
import {svg} from './dom.js';
import {Model} from './model.js';
import * as symbols from './symbols.js';

/**
 * @typedef {import('./canvas.js').Canvas} Canvas
 * @typedef {import('./canvas.js').Scene} Scene
 * @typedef {import('./edit.js').Spot} Spot
 */

/**
 * The angle between two directions.
 * @param {number} a
 * @param {number} b
 */
export function gap(a, b) {
    const turned = Math.abs(a - b) % (2 * Math.PI);
    return Math.min(turned, 2 * Math.PI - turned);
}
/**
 * @param {Canvas} canvas
 * @param {Scene} scene
 */
export function drawDrivers(canvas, scene) {
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
/**
 * An arrow beside a slider that is driven.
 * @param {Canvas} canvas
 * @param {string} pointer
 * @param {Spot} at
 * @param {number} turned
 */
function push(canvas, pointer, [x, y], turned) {
    const from = /** @type {Spot} */ ([x - 22 * Math.sin(-turned), y - 22 * Math.cos(turned)]);
    canvas.add(
        'loads',
        pointer,
        'drive',
        symbols.arrow(from, [from[0] + 46 * Math.cos(turned), from[1] + 46 * Math.sin(turned)], 'driver')
    );
}
/**
 * @param {Canvas} canvas
 * @param {Scene} scene
 */
export function drawMasses(canvas, scene) {
    const {model} = scene;
    for (const {body, form} of model.masses) {
        const at = canvas.spot(form.centre ?? '');
        if (at) canvas.add('loads', Model.pointer(['masses', body]), canvas.look(body), symbols.weight(at));
    }
}
/**
 * @param {Canvas} canvas
 * @param {Scene} scene
 */
export function drawLoads(canvas, scene) {
    const {model} = scene;
    for (const {form, pointer} of model.loads) {
        const between = Array.isArray(form.between)
            ? form.between.map((/** @type {string} */ each) => canvas.spot(each))
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
/**
 * @param {Canvas} canvas
 * @param {any} form
 * @param {string} pointer
 * @param {Spot} at
 * @param {string} point
 */
function drawForce(canvas, form, pointer, at, point) {
    const turned = canvas.turned(pointer, form.along), length = 62, sign = parseFloat(form.magnitude) < 0 ? -1 : 1;
    const taken = canvas.waysTaken(point, at), heads = turned + (sign < 0 ? Math.PI : 0);
    const room = (/** @type {number} */ way) => Math.min(3, ...taken.map((each) => gap(way, each)));
    // The arrow ends at the point, or begins there where bars are in the way.
    const isPull = room(heads + Math.PI) < 0.7 && room(heads) > 0.7;
    const along = (/** @type {number} */ away) =>
        /** @type {Spot} */ ([at[0] + away * Math.cos(heads), at[1] + away * Math.sin(heads)]);
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
/**
 * @param {Canvas} canvas
 * @param {Scene} scene
 * @param {any} form
 * @param {string} pointer
 */
function drawCouple(canvas, {model}, form, pointer) {
    const at = canvas.spot(model.pointsOf(String(form.body))[0] ?? '');
    if (at) canvas.add('loads', pointer, 'load', symbols.spin([at[0], at[1] - 4], !(parseFloat(form.value) < 0)));
}
/**
 * @param {Canvas} canvas
 * @param {any} form
 * @param {string} pointer
 */
function drawDistributed(canvas, form, pointer) {
    const from = canvas.spot(form.from ?? ''),
        to = canvas.spot(form.to ?? ''),
        turned = canvas.turned(pointer, form.along);
    if (!from || !to) return;
    const back = (/** @type {Spot} */ at) =>
        /** @type {Spot} */ ([at[0] - 34 * Math.cos(turned), at[1] - 34 * Math.sin(turned)]);
    const marks = [0, 0.25, 0.5, 0.75, 1].map((t) => {
        const at = /** @type {Spot} */ ([from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])]);
        return symbols.arrow(back(at), at, 'force');
    });
    const [a, b] = [back(from), back(to)];
    canvas.add('loads', pointer, 'load', svg('path', {class: 'edge', d: `M${a}L${b}`}), ...marks);
}
