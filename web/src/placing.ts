// How a point is placed: lengths and angles that are typed become the forms of the file (from, meet), on the same
// side as drawn.
import {type Edit, rounded, roundedSpot, type Spot} from './edit';
import {type Json, Literal} from './json_text';

export const distance = (from: Spot, to: Spot) => Math.hypot(to[0] - from[0], to[1] - from[1]);
/** Degrees from +x. */
export const angle = (from: Spot, to: Spot) => (Math.atan2(to[1] - from[1], to[0] - from[0]) * 180) / Math.PI;
/** Whether q lies to the left of the way from a to b. */
const isLeft = (a: Spot, b: Spot, q: Spot) => (b[0] - a[0]) * (q[1] - a[1]) - (b[1] - a[1]) * (q[0] - a[0]) >= 0;

const isPolar = (form: Json) => form && !Array.isArray(form) && form.from && 'distance' in form && !form.to;
const isMeet = (form: Json) => form && Array.isArray(form.meet);

/** Which end moves when the distance of two points is set; '' where neither can. */
export function movingEnd(edit: Edit, p: string, q: string) {
    const {model} = edit;
    const canMove = (point: string, other: string) =>
        !model.dependsOn(other, point) && freedomOf(model.point(point)?.form, other) > 0;
    const index = (name: string) => model.points.findIndex((each) => each.name === name);
    const order = [[q, p], [p, q]].sort(([a], [b]) =>
        Number(model.isGround(a)) - Number(model.isGround(b)) || index(b) - index(a));
    return order.find(([point, other]) => canMove(point, other))?.[0] ?? '';
}
/** How much of a point's place may still be chosen, if its distance from `other` is. */
function freedomOf(form: Json, other: string) {
    if (Array.isArray(form)) return 2;
    if (isPolar(form)) return form['relative to'] && form.from !== other ? 0 : 1;
    if (isMeet(form)) return form.meet.some((each: Json) => each?.circle === other) ? 1 : 0;
    return form?.from === other && 'distance' in form ? 1 : 0;
}

/**
 * Sets the distance of two points. The point that moves keeps what the file says of it besides: another distance
 * makes it
 * the meet of two circles, a guide on which it slides the meet of a circle and a line. False where neither can move.
 */
export function setDistance(edit: Edit, p: string, q: string, length: Json) {
    const moving = movingEnd(edit, p, q), other = moving === p ? q : p;
    if (moving === '') return false;
    const path = ['points', moving],
        form = edit.model.point(moving)?.form,
        at = edit.spots[moving],
        from = edit.spots[other];
    if (!at || !from) return false;
    if (isMeet(form)) {
        const i = form.meet.findIndex((each: Json) => each?.circle === other);
        edit.set([...path, 'meet', i, 'radius'], length);
    } else if (isPolar(form) && form.from !== other) {
        const first = {circle: form.from, radius: keep(edit, [...path, 'distance'])},
            centre = edit.spots[form.from];
        edit.set(path, {
            meet: [first, {circle: other, radius: length}],
            side: isLeft(centre, from, at) ? 'left' : 'right'
        });
    } else if (!Array.isArray(form)) {
        edit.set([...path, 'distance'], length);
    } else {
        const guide = edit.model.joints.find(
            (each) => each.kind === 'prismatic' && each.point === moving && !isOfPoints(each.form.along)
        );
        if (guide)
            edit.set(path, {
                meet: [
                    {circle: other, radius: length},
                    {line: roundedSpot(at), angle: keep(edit, [...guide.path, 'along'])}
                ],
                near: roundedSpot(at)
            });
        else edit.set(path, {from: other, distance: length, angle: rounded(angle(from, at))});
    }
    return true;
}
const isOfPoints = (along: Json) => Array.isArray(along);

/** Sets the direction from one point to another; it becomes one at a distance and an angle. */
export function setAngle(edit: Edit, p: string, q: string, degrees: Json) {
    const path = ['points', q], form = edit.model.point(q)?.form;
    if (isPolar(form) && form.from === p && !form['relative to']) return edit.set([...path, 'angle'], degrees);
    edit.set(path, {from: p, distance: rounded(distance(edit.spots[p], edit.spots[q])), angle: degrees});
}
/** The value of a path as it stands, with its digits. */
function keep(edit: Edit, path: (string | number)[]) {
    return new Literal(edit.json.rawAt(path) ?? '0');
}

/** Whether a point can be dragged: its place follows from no other point alone. */
export function canDrag(form: Json) {
    if (Array.isArray(form)) return form.every((each) => typeof each === 'number');
    return isPolar(form) && !form['relative to'] && typeof form.angle === 'number' && typeof form.distance === 'number';
}

/** Moves a point, within what the file says of it: a point at a distance turns about the other. */
export function moveTo(edit: Edit, point: string, to: Spot) {
    const form = edit.model.point(point)?.form, path = ['points', point];
    if (!canDrag(form)) return;
    if (Array.isArray(form)) {
        edit.set(path, roundedSpot(to));
        edit.spots[point] = to;
        return;
    }
    const from = edit.spots[form.from];
    if (!from) return;
    const turned = Math.round(angle(from, to));
    edit.set([...path, 'angle'], turned);
    edit.spots[point] = [
        from[0] + form.distance * Math.cos((turned * Math.PI) / 180),
        from[1] + form.distance * Math.sin((turned * Math.PI) / 180)
    ];
}

/** The forms in which a point may be placed. */
export const forms = ['coordinates', 'polar', 'online', 'meet'] as const;
export function formOf(form: Json): string {
    if (Array.isArray(form)) return 'coordinates';
    if (isMeet(form)) return 'meet';
    return form?.to ? 'online' : 'polar';
}
/** Places a point where it is, in another form. */
export function placeBy(edit: Edit, point: string, wanted: string) {
    const at = edit.spots[point], path = ['points', point], others = edit.model.points.map(({name}) => name)
        .filter((each) => edit.spots[each] && !edit.model.dependsOn(each, point));
    if (!at) return;
    const nearest = [...others].sort((a, b) => distance(edit.spots[a], at) - distance(edit.spots[b], at));
    const [a, b] = nearest;
    if (wanted === 'coordinates') edit.set(path, roundedSpot(at));
    else if (wanted === 'polar' && a)
        edit.set(path, {
            from: a,
            distance: rounded(distance(edit.spots[a], at)),
            angle: rounded(angle(edit.spots[a], at))
        });
    else if (wanted === 'online' && b) edit.set(path, {from: a, to: b, distance: rounded(distance(edit.spots[a], at))});
    else if (wanted === 'meet' && b)
        edit.set(path, {meet: [a, b].map((each) => ({circle: each, radius: rounded(distance(edit.spots[each], at))})),
            side: isLeft(edit.spots[a], edit.spots[b], at) ? 'left' : 'right'});
}
