// Who names whom in a file: renaming changes every name, deleting takes away what cannot stand alone.
import {bodyValue, type Edit, roundedSpot} from './edit';
import type {Json, Node, Path} from './json_text';
import {Model} from './model';

/** Under these keys stands the name of a point, or an array or pair of them. */
const ofPoints = new Set([
    'from',
    'to',
    'circle',
    'line',
    'centre',
    'at',
    'revolute',
    'prismatic',
    'pin-slot',
    'rolling',
    'contact',
    'gear',
    'weld',
    'arc',
    'pin',
    'between',
    'along',
    'parallel',
    'perpendicular',
    'relative to',
    'tangent',
    'points',
    'relative motion',
    'translating with'
]);
const ofBodies = new Set(['body', 'bodies', 'arm', 'observer']);

/** Every place where a point (or a body) of this name is meant. */
export function places(edit: Edit, kind: 'point' | 'body', name: string) {
    const found: Path[] = [],
        keys = kind === 'point' ? ofPoints : ofBodies;
    const isName = (node: Node) =>
        (node.kind === 'string' || (kind === 'body' && node.kind === 'number')) && String(node.value) === name;
    /** @param meant whether a name here is one of these */
    const walk = (node: Node, path: Path, meant: boolean) => {
        if (isName(node)) {
            if (meant) found.push(path);
            return;
        }
        node.items.forEach((each, i) => walk(each, [...path, i], meant));
        for (const {key, value} of node.members) {
            const inCouple =
                kind === 'body' &&
                (key === 'relative to' || key === 'from') &&
                (path[0] === 'drivers' || path[0] === 'effort');
            const inBodies = kind === 'point' && path[0] === 'bodies' && path.length === 1;
            walk(
                value,
                [...path, key],
                inBodies || inCouple || (keys.has(key) && !(kind === 'point' && key === 'from' && path[0] === 'effort'))
            );
        }
    };
    for (const {key, value} of edit.json.root.members)
        if (!['title', 'units', 'ask', 'vary', 'require', 'parameters'].includes(key))
            walk(value, [key], key === 'frame' && kind === 'body');
    return found;
}

/** Whether a name can be given; the engine says more. */
export function isFree(edit: Edit, kind: 'point' | 'body', name: string) {
    const taken = kind === 'point' ? edit.model.points : edit.model.bodies;
    return name !== '' && !/[,\p{Cc}]| on /u.test(name) && !taken.some((each) => each.name === name) &&
        !(kind === 'body' && name === edit.model.frame);
}
export function rename(edit: Edit, kind: 'point' | 'body', from: string, to: string) {
    if (!isFree(edit, kind, to)) return false;
    // From the end, so that what was found keeps its place.
    for (const path of places(edit, kind, from).reverse()) {
        // "2" stays a text where it was one.
        const isText = edit.json.at(path)?.kind === 'string' && bodyValue(from) !== from;
        edit.set(path, kind === 'body' && !isText ? bodyValue(to) : to);
    }
    edit.take(edit.json.rename([kind === 'point' ? 'points' : 'bodies', from], to));
    if (kind === 'body' && edit.json.at(['masses', from])) edit.take(edit.json.rename(['masses', from], to));
    if (kind === 'body')
        edit.model.joints.forEach(
            ({path}) =>
                edit.json.at([...path, 'profiles', from]) &&
                edit.take(edit.json.rename([...path, 'profiles', from], to))
        );
    if (kind === 'point' && edit.spots[from]) edit.spots[to] = edit.spots[from];
    return true;
}

/** Takes elements of a list away, the last first. */
function removeFrom(edit: Edit, key: string, goes: (form: Json) => boolean) {
    const list = edit.model.file[key];
    if (!Array.isArray(list)) {
        if (list && key === 'effort' && goes(list)) edit.remove([key]);
        return;
    }
    for (let i = list.length - 1; i >= 0; --i) if (list[i] && goes(list[i])) edit.remove([key, i]);
}
/** Whether a form names something under these keys. */
const names = (form: Json, keys: Set<string>, name: string) =>
    Object.entries(form).some(
        ([key, value]) =>
            keys.has(key) &&
            [value]
                .flat(3)
                .some((each) => (typeof each === 'string' || typeof each === 'number') && String(each) === name)
    );

export function removeBody(edit: Edit, name: string) {
    removeFrom(edit, 'drivers', (form) => names(form, new Set(['body', 'relative to']), name));
    removeFrom(edit, 'loads', (form) => names(form, ofBodies, name));
    removeFrom(edit, 'effort', (form) => names(form, new Set(['body', 'from']), name));
    removeFrom(edit, 'find', (form) => typeof form === 'object' && names(form, ofBodies, name));
    for (let i = edit.model.joints.length - 1; i >= 0; --i) {
        const joint = edit.model.joints[i];
        if (!joint.bodies.includes(name)) continue;
        if (joint.bodies.length > 2) edit.remove([...joint.path, 'bodies', joint.bodies.indexOf(name)]);
        else removeJoint(edit, i);
    }
    edit.remove(['masses', name]);
    edit.remove(['bodies', name]);
    tidy(edit);
}
/** A frame's pin stays the frame's. */
export function removeJoint(edit: Edit, index: number) {
    const joint = edit.model.joints[index];
    removeFrom(edit, 'drivers', (form) => String(form.joint ?? '') === joint.name);
    removeFrom(edit, 'effort', (form) => String(form.joint ?? '') === joint.name);
    const others = edit.model.joints.filter(
        (each) => each !== joint && each.kind === 'revolute' && each.point === joint.point
    );
    if (joint.kind === 'revolute' && others.length === 0)
        removeFrom(edit, 'loads', (form) => String(form.pin ?? '') === joint.name);
    edit.remove(joint.path);
}
/** What was placed by the point keeps its place, by coordinates. */
export function removePoint(edit: Edit, name: string) {
    for (const each of edit.model.points)
        if (Model.reads(each.form).includes(name) && edit.spots[each.name])
            edit.set(each.path, roundedSpot(edit.spots[each.name]));
    for (let i = edit.model.joints.length - 1; i >= 0; --i)
        if (names(edit.model.joints[i].form, ofPoints, name)) removeJoint(edit, i);
    removeFrom(edit, 'drivers', (form) => names(form, ofPoints, name));
    removeFrom(edit, 'loads', (form) => names(form, ofPoints, name));
    removeFrom(edit, 'effort', (form) => names(form, new Set(['at', 'along']), name));
    removeFrom(edit, 'find', (form) => typeof form === 'object' && names(form, ofPoints, name));
    for (const {body, form} of edit.model.masses) if (form.centre === name) edit.remove(['masses', body]);
    for (const body of edit.model.bodies) {
        const index = body.points.indexOf(name);
        if (index < 0) continue;
        const left = body.points.filter((each) => each !== name);
        // A bar without its other end is no bar any more.
        if (!body.isFrame && left.length < Math.min(2, body.points.length)) removeBody(edit, body.name);
        else edit.remove([...body.listPath, index]);
    }
    edit.remove(['points', name]);
    tidy(edit);
}
/** Takes away lists that became empty. */
function tidy(edit: Edit) {
    for (const key of ['drivers', 'loads', 'effort', 'masses']) {
        const node = edit.json.at([key]);
        if (node && node.kind !== 'string' && node.items.length + node.members.length === 0) edit.remove([key]);
    }
    const frame = edit.model.bodyNamed(edit.model.frame);
    if (frame && frame.points.length === 0 && !frame.circle) edit.remove(frame.path);
}
