// What can be done to a mechanism, each as a change of the file's text: add points, links, joints, drivers and loads.
import {type Json, type JsonText, Literal, type Path} from './json_text';
import {type JointItem, Model} from './model';
import type {Wheel} from './snap';
import {withPoint} from './words';

/** Coordinates in the file's unit of length */
export type Spot = [number, number];
export type Spots = Record<string, Spot>;

/** A number with the digits that a drawing needs. */
export function rounded(value: number) {
    return Number(value.toFixed(Math.max(0, Math.min(9, 5 - Math.floor(Math.log10(Math.abs(value) || 1))))));
}
export const roundedSpot = (at: Spot): Spot => [rounded(at[0]), rounded(at[1])];
/** What was typed: a number with its digits, or a text for quantities and formulas. */
export function typed(text: string) {
    const trimmed = withPoint(text.trim());
    return /^-?(0|[1-9]\d*)(\.\d+)?([eE][+-]?\d+)?$/.test(trimmed) ? new Literal(trimmed) : trimmed;
}
/** A body's name as files write it: 2 where it is a number. */
export const bodyValue = (name: string) => (/^(0|[1-9]\d{0,8})$/.test(name) ? Number(name) : name);

/** The bodies that meet where a point lies, by it or by another point at its place; none, if joints join them there. */
export function unjoinedAt(model: Model, spots: Spots, point: string) {
    const [x, y] = spots[point] ?? [NaN, NaN];
    const there = model.points.map(({name}) => name)
        .filter((name) => name === point || (spots[name]?.[0] === x && spots[name][1] === y));
    const bodies = [...new Set(there.flatMap((name) => model.bodiesAt(name)))];
    const joined = new Set(model.joints.filter((each) => there.includes(each.point)).flatMap((each) => each.bodies));
    return bodies.length < 2 || bodies.every((each) => joined.has(each)) ? [] : bodies;
}

/** A file's text while several changes are made that belong together. */
export class Edit {
    readonly spots: Spots;
    model: Model;

    /** @param spots where the points are now */
    constructor(public json: JsonText, spots: Spots) {
        this.spots = {...spots};
        this.model = new Model(json);
    }
    get text() {
        return this.json.text;
    }
    take(json: JsonText) {
        if (json === this.json) return;
        this.json = json;
        this.model = new Model(json);
    }
    set(path: Path, value: Json) {
        this.take(this.json.set(path, value));
    }
    add(path: Path, value: Json) {
        if (!this.json.at(path)) this.take(this.json.set(path, []));
        this.take(this.json.add(path, value));
    }
    remove(path: Path) {
        this.take(this.json.remove(path));
    }

    addPoint(form: Json, at: Spot, name?: string) {
        const free = this.model.freePointName(name);
        this.set(['points', free], form);
        this.spots[free] = at;
        return free;
    }
    addPointToBody(point: string, body: string) {
        const {model} = this;
        if (model.pointsOf(body).includes(point)) return;
        const item = model.bodyNamed(body);
        if (item) this.add(item.listPath, point);
        else this.set(['bodies', body], [point]);
    }
    /** A body of these points, hinged to the bodies that carry them already. */
    addBody(points: string[]) {
        const name = this.model.freeBodyName();
        const others = points.map((each) => this.model.bodiesAt(each));
        this.set(['bodies', name], points);
        points.forEach((point, i) => {
            if (others[i].length > 0) this.addHinge(point, [...others[i], name]);
        });
        return name;
    }
    /** A hinge of these bodies at a point; one that is there takes more bodies. */
    addHinge(point: string, bodies: string[]) {
        const there = this.model.hingeAt(point);
        if (!there) return this.add(['joints'], {revolute: point, bodies: bodies.map(bodyValue)});
        for (const body of bodies)
            if (!there.bodies.includes(body)) this.add([...there.path, 'bodies'], bodyValue(body));
    }
    /** Pins the bodies together that meet where a point lies. */
    pinTogether(point: string) {
        const bodies = unjoinedAt(this.model, this.spots, point);
        for (const body of bodies) if (body !== this.model.frame) this.addPointToBody(point, body);
        this.addHinge(point, bodies);
    }
    /** Fixes a point to the frame: a hinge of its bodies, or one of the frame's points where it has none yet. */
    addGround(point: string) {
        const {model} = this, bodies = model.bodiesAt(point).filter((each) => each !== model.frame);
        if (model.isGround(point)) return;
        if (bodies.length > 0) this.addHinge(point, [model.frame, ...bodies]);
        else this.addPointToBody(point, model.frame);
    }
    /**
     * Clamps a wheel to the frame about its centre; the hinge there keeps its other bodies.
     * @returns the index of the joint
     */
    fixWheel({body, centre}: Wheel): number {
        const {frame} = this.model, there = this.model.joints.findIndex(({kind, point, bodies}) =>
            kind === 'weld' && point === centre && bodies.includes(body) && bodies.includes(frame));
        if (there >= 0) return there;
        this.detach(centre, body);
        this.addPointToBody(centre, body);
        this.add(['joints'], {weld: centre, bodies: [frame, body].map(bodyValue)});
        return this.model.joints.length - 1;
    }
    /** A block that slides on a guide of the frame, hinged to the bodies at the point. */
    addSlider(point: string, along: Json) {
        const {model} = this, others = model.bodiesAt(point).filter((each) => each !== model.frame);
        const block = others.length > 0 ? this.addBody([point]) : model.bodiesAt(point)[0] ?? this.addBody([point]);
        this.add(['joints'], {prismatic: point, bodies: [bodyValue(block), bodyValue(model.frame)], along});
        return block;
    }
    /** Takes a point off a body; a hinge that then joins nothing goes. */
    detach(point: string, body: string) {
        const item = this.model.bodyNamed(body), hinge = this.model.hingeAt(point);
        if (item?.points.includes(point)) this.remove([...item.listPath, item.points.indexOf(point)]);
        if (!hinge?.bodies.includes(body)) return;
        if (hinge.bodies.length < 3) this.remove(hinge.path);
        else this.remove([...hinge.path, 'bodies', hinge.bodies.indexOf(body)]);
    }
    /** The pin of a body in the straight slot of another. */
    addSlot(pin: string, body: string, slotted: string, end: string) {
        this.add(['joints'], {'pin-slot': pin, bodies: [bodyValue(body), bodyValue(slotted)], along: [end, pin]});
    }
    /** Two wheels about these centres that touch between them. */
    addWheels(kind: 'gear' | 'rolling' | 'contact', bodies: string[], centres: string[], contact: string) {
        const profiles = Object.fromEntries(bodies.map((each, i) => [each, {circle: centres[i]}]));
        this.add(['joints'], {[kind]: contact, bodies: bodies.map(bodyValue), profiles});
    }
    /**
     * A wheel about a centre that touches a bar of another body: at the foot of the perpendicular.
     * @param wheel the wheel's body
     */
    addWheelOnBar(
        kind: 'gear' | 'rolling' | 'contact', centre: string, wheel: string,
        {body, from, to}: {body: string, from: string, to: string}
    ) {
        const [a, b, c] = [from, to, centre].map((each) => this.spots[each]), dx = b[0] - a[0], dy = b[1] - a[1];
        const t = ((c[0] - a[0]) * dx + (c[1] - a[1]) * dy) / (dx * dx + dy * dy);
        const foot = {meet: [{line: from, to}, {line: centre, perpendicular: [from, to]}]};
        const contact = this.addPoint(foot, [a[0] + t * dx, a[1] + t * dy], 'P');
        const profiles = {[wheel]: {circle: centre}, [body]: {line: [from, to]}};
        this.add(['joints'], {[kind]: contact, bodies: [wheel, body].map(bodyValue), profiles});
        return contact;
    }
    /**
     * What a body shows at a contact.
     * @param kind circle, line, tip; '': the body's own circle
     */
    setProfile(joint: JointItem, body: string, kind: string) {
        const path = [...joint.path, 'profiles', body], points = this.model.pointsOf(body);
        const centre = points.find((each) => each !== joint.point) ?? joint.point;
        const isBar = points.length > 1 && body !== this.model.frame;
        const line = isBar ? points.slice(0, 2) : this.acrossContact(joint, body);
        if (kind === '') this.remove(path);
        else this.set(path, kind === 'circle' ? {circle: centre} : kind === 'line' ? {line} : {tip: true});
    }
    /** The direction of the tangent at a contact, degrees, from what the other body shows there. */
    acrossContact(joint: JointItem, body: string) {
        const other = joint.bodies.find((each) => each !== body) ?? '', at = this.spots[joint.point];
        const from = this.spots[this.model.centreOf(joint.form, other)];
        if (!from || !at) return 0;
        return rounded(((Math.atan2(at[1] - from[1], at[0] - from[0]) * 180) / Math.PI + 90) % 180);
    }
    /**
     * The colour of a body in place of the theme's.
     * @param colour "#rrggbb"; '': the theme's
     */
    setColour(body: string, colour: string) {
        const path = ['bodies', body], form = this.json.plainAt(path);
        if (Array.isArray(form)) {
            if (colour !== '') this.set(path, {points: form, colour});
        } else if (colour !== '') this.set([...path, 'colour'], colour);
        else if (form && Object.keys(form).every((each) => each === 'points' || each === 'colour'))
            this.set(path, form.points ?? []);
        else this.remove([...path, 'colour']);
    }
    /** A support that rolls on the frame, level, and only pushes up; the frame's pin at the point becomes one. */
    addRoller(point: string, body: string) {
        const {model} = this, there = model.hingeAt(point), {frame} = model;
        const support = {
            contact: point, bodies: [body, frame].map(bodyValue), tangent: 0, pushes: [0, 1]
        };
        const others = there ? there.bodies.filter((each) => each !== frame) : [];
        if (!there?.bodies.includes(frame)) this.add(['joints'], support);
        else if (others.length < 2) this.set(there.path, support);
        else {
            this.set([...there.path, 'bodies'], others.map(bodyValue));
            this.add(['joints'], support);
        }
    }
    /** Clamps together the bodies that a hinge joins. */
    addWelds({point, bodies, path}: JointItem) {
        const [first, ...others] = bodies.map(bodyValue);
        others.forEach((each, i) => {
            const weld = {weld: point, bodies: [first, each]};
            if (i === 0) this.set(path, weld);
            else this.add(['joints'], weld);
        });
    }
    /** A couple on a body, counter-clockwise. */
    addCouple(body: string) {
        this.add(['loads'], {couple: this.model.freeLoadName('C'), body: bodyValue(body), value: 10});
    }
    /** Gives a driver a law of motion in place of its rates. */
    addLaw(path: Path, form: Json) {
        const slide = this.model.unit === 'mm' ? '50 mm' : '0.05 m';
        for (const rate of ['omega', 'alpha', 'speed', 'acceleration']) if (rate in form) this.remove([...path, rate]);
        const way = form.body === undefined ? {slide} : {turn: '90°'};
        this.set([...path, 'law'], {form: 'cycloidal', ...way, time: '1 s'});
    }
    addDriver(body: string) {
        this.add(['drivers'], {body: bodyValue(body), omega: 10});
    }
    addSlideDriver(joint: string) {
        this.add(['drivers'], {joint, speed: this.model.unit === 'mm' ? '100 mm/s' : '0.1 m/s'});
    }
    addWeight(body: string, centre: string) {
        this.addPointToBody(centre, body);
        this.set(['masses', body], {mass: 1, centre});
        if (!this.json.at(['gravity'])) this.set(['gravity'], [0, -9.81]);
    }
    /**
     * @param body the one that is loaded; '': the pin
     * @param angle degrees
     */
    addForce(point: string, body: string, magnitude: number, angle: number) {
        const on = body === '' ? {pin: point} : {body: bodyValue(body), at: point};
        this.add(['loads'], {force: this.model.freeLoadName('F'), ...on, magnitude, along: angle});
    }
    /** @param free the free length */
    addSpring(points: string[], bodies: string[], free: number) {
        this.add(['loads'], {spring: this.model.freeLoadName('S'), bodies: bodies.map(bodyValue), between: points,
            stiffness: '1 N/mm', 'free length': rounded(free)});
    }
}
