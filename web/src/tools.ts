// The tools: each takes what the pointer or the keyboard picks, one target after the other, and changes the file.
import type {Bench} from './bench';
import {type Edit, rounded, roundedSpot, type Spot} from './edit';
import {Model} from './model';
import {angle, distance} from './placing';
import {barNear, type Target} from './snap';

export const pointerTo = (list: string, key: string | number) => Model.pointer([list, key]);

/**
 * The point of a target; where there is none it is made: exactly on a bar, on a wheel, at an angle, or at its
 * coordinates.
 */
export function pointAt(edit: Edit, target: Target, name?: string, from = '') {
    if (target.point && edit.model.point(target.point)) return target.point;
    if (target.form) return edit.addPoint(target.form, target.at, name);
    if (target.bar) {
        const {from: start, to, body} = target.bar, away = rounded(distance(edit.spots[start], target.at));
        const made = edit.addPoint({from: start, to, distance: away}, target.at, name);
        edit.addPointToBody(made, body);
        return made;
    }
    const form = target.snapped === 'angle' && from ? {
        from,
        distance: rounded(distance(edit.spots[from], target.at)),
        angle: rounded(angle(edit.spots[from], target.at))
    } : roundedSpot(target.at);
    const made = edit.addPoint(form, target.at, name);
    if (target.wheel) edit.addPointToBody(made, target.wheel.body);
    return made;
}

export class Tool {
    /** The points picked so far. */
    picked: string[] = [];

    constructor(readonly bench: Bench) {}
    /** Its name, in the texts `tool_NAME` and `hint_NAME`. */
    static tool = '';
    static key = '';
    get name() {
        return (this.constructor as typeof Tool).tool;
    }
    /** Where a line begins that is being drawn. */
    from(): Spot | null {
        const last = this.picked[this.picked.length - 1];
        return last ? this.bench.spots[last] ?? null : null;
    }
    pick(target: Target) {
        void target;
    }
    begin(point: string) {
        this.picked = [point];
    }
    /** Ends what was begun. */
    cancel() {
        this.picked = [];
    }
    edit(change: (edit: Edit) => string | null | undefined | void) {
        this.bench.edit(change);
    }
    /**
     * Of a tool that joins two points: the first is begun with, the second ends it.
     * @param join what is selected then
     * @param name of new points
     */
    pickTwo(target: Target, join: (edit: Edit, first: string, second: string) => string, name?: string) {
        this.edit((edit) => {
            const point = pointAt(edit, target, name), [first] = this.picked;
            if (!first || first === point || !edit.model.point(first)) {
                this.begin(point);
                return pointerTo('points', point);
            }
            this.cancel();
            return join(edit, first, point);
        });
    }
}

export class SelectTool extends Tool {
    static tool = 'select';
    static key = 'v';
}
export class PointTool extends Tool {
    static tool = 'point';
    static key = 'p';
    pick(target: Target) {
        this.edit((edit) => pointerTo('points', pointAt(edit, target)));
    }
}
/** Bars from point to point, each from the end of the last, until the same point is picked again. */
export class LinkTool extends Tool {
    static tool = 'link';
    static key = 'l';
    pick(target: Target) {
        this.edit((edit) => {
            const last = this.picked[this.picked.length - 1] ?? '', point = pointAt(edit, target, 'A', last);
            if (last === point) {
                this.cancel();
                return undefined;
            }
            this.begin(point);
            if (!last || !edit.model.point(last)) return pointerTo('points', point);
            return pointerTo('bodies', edit.addBody([last, point]));
        });
    }
}
export class PlateTool extends Tool {
    static tool = 'plate';
    static key = 'b';
    pick(target: Target) {
        this.edit((edit) => {
            const point = pointAt(edit, target, 'A', this.picked[this.picked.length - 1]);
            if (!this.picked.includes(point)) {
                this.picked.push(point);
                return pointerTo('points', point);
            }
            const points = this.picked;
            this.cancel();
            return points.length > 1 ? pointerTo('bodies', edit.addBody(points)) : undefined;
        });
    }
}
export class GroundTool extends Tool {
    static tool = 'ground';
    static key = 'g';
    pick(target: Target) {
        this.edit((edit) => {
            if (target.wheel) return pointerTo('joints', edit.fixWheel(target.wheel));
            const point = pointAt(edit, target, 'O');
            edit.addGround(point);
            return pointerTo('points', point);
        });
    }
}
/** A point that rolls on the frame. */
export class RollerTool extends Tool {
    static tool = 'roller';
    static key = 'u';
    pick(target: Target) {
        this.edit((edit) => {
            const point = pointAt(edit, target);
            const body = edit.model.bodiesAt(point).find((each) => each !== edit.model.frame);
            if (!body) return pointerTo('points', point);
            edit.addRoller(point, body);
            const support = edit.model.joints.find((each) => each.kind === 'contact' && each.point === point);
            return support?.pointer;
        });
    }
}
/** A hinge whose links are clamped together. */
export class WeldTool extends Tool {
    static tool = 'weld';
    static key = 'x';
    pick(target: Target) {
        const hinge = this.bench.model.joints.find((each) => each.kind === 'revolute' && each.point === target.point);
        if (!hinge || hinge.bodies.length < 2) return;
        this.edit((edit) => {
            edit.addWelds(hinge);
            return hinge.pointer;
        });
    }
}
/** A slider at a point, then the direction of its guide. */
export class SliderTool extends Tool {
    static tool = 'slider';
    static key = 's';
    pick(target: Target) {
        this.edit((edit) => {
            const [first] = this.picked;
            if (!first) {
                this.begin(pointAt(edit, target));
                return pointerTo('points', this.picked[0]);
            }
            this.cancel();
            if (!edit.model.point(first)) return null;
            const turned = distance(edit.spots[first], target.at) === 0 ? 0 : angle(edit.spots[first], target.at);
            edit.addSlider(
                first,
                target.point && target.point !== first ? [first, target.point] : rounded(Math.round(turned / 5) * 5)
            );
            return pointerTo('joints', edit.model.joints.length - 1);
        });
    }
}
/** A pin, then a point of the body with the slot. */
export class SlotTool extends Tool {
    static tool = 'slot';
    static key = 'o';
    pick(target: Target) {
        this.pickTwo(target, (edit, first, point) => {
            const moving = (at: string) =>
                edit.model.bodiesAt(at).filter((each) => each !== edit.model.frame);
            // A pin that was drawn on the bar with the slot leaves it: it is another body's.
            const shared = moving(first).find((each) => moving(point).includes(each));
            if (shared) edit.detach(first, shared);
            const body = moving(first)[0] ?? edit.addBody([first]);
            const slotted = shared ?? moving(point).find((each) => each !== body) ?? edit.addBody([point]);
            edit.addSlot(first, body, slotted, point);
            return pointerTo('joints', edit.model.joints.length - 1);
        });
    }
}
/** The centres of two wheels, which touch half way between them; or a centre, then a bar that the wheel touches. */
export class GearTool extends Tool {
    static tool = 'gear';
    static key = 'e';
    static kind: 'gear' | 'rolling' | 'contact' = 'gear';
    get kind() {
        return (this.constructor as typeof GearTool).kind;
    }
    pick(target: Target) {
        const bodyOf = (edit: Edit, point: string) =>
            edit.model.bodiesAt(point).find((body) => body !== edit.model.frame) ?? edit.addBody([point]);
        const [centre] = this.picked, {bar, point: there} = target;
        if (centre && bar && !there && !this.bench.model.pointsOf(bar.body).includes(centre))
            return this.edit((edit) => {
                this.cancel();
                return pointerTo('points', edit.addWheelOnBar(this.kind, centre, bodyOf(edit, centre), bar));
            });
        this.pickTwo({...target, wheel: null}, (edit, first, point) => {
            // Wheels at the ends of an arm are bodies of their own.
            const carried = [first, point].map((each) => edit.model.bodiesAt(each)), [one, other] = carried;
            const arms = one.filter((each) => other.includes(each) && each !== edit.model.frame);
            const bodies = [first, point].map((each, i) => arms.length === 0 ? bodyOf(edit, each) :
                carried[i].find((body) => body !== edit.model.frame && !arms.includes(body)) ?? edit.addBody([each]));
            const [a, b] = [edit.spots[first], edit.spots[point]];
            const contact = edit.addPoint(
                {from: first, to: point, ratio: 0.5},
                [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2],
                'P'
            );
            edit.addWheels(this.kind, bodies, [first, point], contact);
            return pointerTo('points', contact);
        }, 'O');
    }
}
export class RollingTool extends GearTool {
    static tool = 'rolling';
    static key = 'r';
    static kind: 'gear' | 'rolling' | 'contact' = 'rolling';
}
/** Two discs that slide on each other: a cam and its follower. */
export class ContactTool extends GearTool {
    static tool = 'contact';
    static key = 'c';
    static kind: 'gear' | 'rolling' | 'contact' = 'contact';
}
/** The body that is meant: that of the bar, or of the point. */
function bodyAt(bench: Bench, target: Target) {
    const {model} = bench,
        moving = (point: string) => model.bodiesAt(point).filter((each) => each !== model.frame);
    return (
        target.bar?.body ?? barNear(model, bench.spots, bench.view, target.at)?.body ?? moving(target.point)[0] ??
        target.wheel?.body ?? ''
    );
}
export class DriverTool extends Tool {
    static tool = 'driver';
    static key = 'd';
    pick(target: Target) {
        this.edit((edit) => {
            const slide = edit.model.joints.find((each) => each.kind === 'prismatic' && each.point === target.point);
            const body = bodyAt(this.bench, target);
            if (slide) edit.addSlideDriver(slide.name);
            else if (body) edit.addDriver(body);
            else return undefined;
            return pointerTo('drivers', edit.model.drivers.length - 1);
        });
    }
}
export class WeightTool extends Tool {
    static tool = 'weight';
    static key = 'w';
    pick(target: Target) {
        const body = bodyAt(this.bench, target);
        if (!body) return;
        this.edit((edit) => {
            const centre = target.bar ? pointAt(edit, target, 'G') : target.point || pointAt(edit, target, 'G');
            edit.addWeight(body, centre);
            return pointerTo('masses', body);
        });
    }
}
/** The point where a force acts, then where it comes from or goes to. */
export class LoadTool extends Tool {
    static tool = 'load';
    static key = 'f';
    pick(target: Target) {
        this.edit((edit) => {
            const [first] = this.picked;
            if (!first || !edit.model.point(first)) {
                this.begin(pointAt(edit, target));
                return pointerTo('points', this.picked[0]);
            }
            this.cancel();
            const bodies = edit.model.bodiesAt(first), moving = bodies.filter((each) => each !== edit.model.frame);
            if (moving.length === 0) return pointerTo('points', first);
            const at = edit.spots[first],
                turned = distance(at, target.at) === 0 ? -90 : angle(at, target.at);
            edit.addForce(
                first,
                bodies.length > 1 && edit.model.hingeAt(first) ? '' : moving[0],
                100,
                rounded(Math.round(turned / 5) * 5)
            );
            return pointerTo('loads', edit.model.loads.length - 1);
        });
    }
}
/** The link on which a couple acts. */
export class CoupleTool extends Tool {
    static tool = 'couple';
    static key = 'm';
    pick(target: Target) {
        const body = bodyAt(this.bench, target);
        if (!body) return;
        this.edit((edit) => {
            edit.addCouple(body);
            return pointerTo('loads', edit.model.loads.length - 1);
        });
    }
}
/** The two points that a spring joins. */
export class SpringTool extends Tool {
    static tool = 'spring';
    static key = 'k';
    pick(target: Target) {
        this.pickTwo(target, (edit, first, point) => {
            // What no link carries is a fixed place.
            const free = [first, point].filter((each) => edit.model.bodiesAt(each).length === 0);
            if (free.length === 1) edit.addGround(free[0]);
            const [a, b] = [edit.model.bodiesAt(first), edit.model.bodiesAt(point)];
            const pair = a.flatMap((one) => b.map((other) => [one, other])).find(([one, other]) => one !== other);
            if (!pair) return pointerTo('points', point);
            edit.addSpring([first, point], pair, 0.8 * distance(edit.spots[first], edit.spots[point]));
            return pointerTo('loads', edit.model.loads.length - 1);
        });
    }
}

export const tools = [
    SelectTool,
    PointTool,
    LinkTool,
    PlateTool,
    GroundTool,
    RollerTool,
    WeldTool,
    SliderTool,
    SlotTool,
    GearTool,
    RollingTool,
    ContactTool,
    DriverTool,
    WeightTool,
    LoadTool,
    CoupleTool,
    SpringTool
];
