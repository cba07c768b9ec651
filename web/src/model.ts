// What the text says, as lists that are drawn and edited. It takes any JSON: what is not as it should be is left
// out, and the engine says so.
import {type Json, type JsonText, type Path, plain} from './json_text';

export interface PointItem {
    name: string;
    form: Json;
    path: Path;
}
export interface BodyItem {
    name: string;
    points: string[];
    listPath: Path;
    path: Path;
    /** "#rrggbb", or '': the theme's. */
    colour: string;
    circle: {centre: string} | null;
    isFrame: boolean;
}
export interface JointItem {
    kind: string;
    point: string;
    bodies: string[];
    name: string;
    form: Json;
    path: Path;
    pointer: string;
}
export interface ListItem {
    form: Json;
    path: Path;
    pointer: string;
}
export interface MassItem {
    body: string;
    form: Json;
    path: Path;
}

export const jointKinds = ['revolute', 'prismatic', 'pin-slot', 'rolling', 'contact', 'gear', 'weld'];

const nameOf = (value: Json) => (typeof value === 'string' || typeof value === 'number' ? String(value) : '');
const listOf = (value: Json): Json[] => (Array.isArray(value) ? value : []);
const entriesOf = (value: Json): [string, Json][] =>
    (value && typeof value === 'object' && !Array.isArray(value) ? Object.entries(value) : []);
const step = (name: string) => name.replaceAll('~', '~0').replaceAll('/', '~1');

export class Model {
    readonly file: Json;
    readonly frame: string;
    readonly unit: string;
    readonly points: PointItem[];
    readonly bodies: BodyItem[];
    readonly joints: JointItem[];
    readonly drivers: ListItem[];
    readonly loads: ListItem[];
    readonly masses: MassItem[];
    readonly hasJoints: boolean;

    constructor(readonly json: JsonText | null) {
        const file = json ? plain(json.root) : {};
        this.file = file;
        this.frame = nameOf(file.frame) || '0';
        this.unit = nameOf(file.units?.length) || 'm';
        this.points = json?.at(['points'])?.members.map(({key, value}) =>
            ({name: key, form: plain(value), path: ['points', key]})) ?? [];
        this.bodies = json?.at(['bodies'])?.members.map(({key, value}) => this.body(key, plain(value))) ?? [];
        this.joints = listOf(file.joints).map((form, i) => this.joint(form ?? {}, i)).filter(({kind}) => kind !== '');
        this.drivers = this.list('drivers');
        this.loads = this.list('loads');
        this.masses = entriesOf(file.masses).map(([body, form]) => ({body, form: form ?? {}, path: ['masses', body]}));
        this.hasJoints = Boolean(json?.at(['joints']));
    }
    body(name: string, form: Json): BodyItem {
        const isList = Array.isArray(form), centre = nameOf(form?.circle?.centre), given = nameOf(form?.colour);
        const colour = /^#[0-9a-f]{6}$/i.test(given) ? given.toLowerCase() : '';
        return {name, points: listOf(isList ? form : form?.points).map(nameOf), path: ['bodies', name],
            listPath: isList ? ['bodies', name] : ['bodies', name, 'points'], circle: centre ? {centre} : null,
            colour, isFrame: name === this.frame};
    }
    joint(form: Json, i: number): JointItem {
        const kind = jointKinds.find((each) => each in form) ?? '';
        return {kind, point: nameOf(form[kind]), bodies: listOf(form.bodies).map(nameOf), form, path: ['joints', i],
            name: nameOf(form.name) || nameOf(form[kind]), pointer: `/joints/${i}`};
    }
    list(key: string): ListItem[] {
        return listOf(this.file[key]).map((form, i) => ({form: form ?? {}, path: [key, i], pointer: `/${key}/${i}`}));
    }
    /**
     * The centre of the disc that a body shows at a joint; '': none.
     * @param form of the joint
     */
    centreOf(form: Json, body: string) {
        return nameOf(form.profiles?.[body]?.circle) || this.bodyNamed(body)?.circle?.centre || '';
    }
    point(name: string) {
        return this.points.find((each) => each.name === name);
    }
    bodyNamed(name: string) {
        return this.bodies.find((each) => each.name === name);
    }
    /** The bodies that carry a point, the frame among them. */
    bodiesAt(point: string) {
        const names = this.bodies.filter((each) => each.points.includes(point)).map(({name}) => name);
        for (const joint of this.joints)
            if (joint.point === point && (joint.kind === 'revolute' || joint.kind === 'weld'))
                names.push(...joint.bodies.filter((each) => !names.includes(each)));
        return [...new Set(names)];
    }
    /** The points of a body, with those of its hinges. */
    pointsOf(name: string) {
        const points = [...this.bodyNamed(name)?.points ?? []];
        for (const joint of this.joints)
            if (
                (joint.kind === 'revolute' || joint.kind === 'weld') &&
                joint.bodies.includes(name) &&
                !points.includes(joint.point)
            )
                points.push(joint.point);
        return points;
    }
    hingeAt(point: string) {
        return this.joints.find((each) => each.kind === 'revolute' && each.point === point);
    }
    /** Whether a point is fixed to the frame. */
    isGround(point: string) {
        return this.bodiesAt(point).includes(this.frame);
    }
    get movingBodies() {
        return this.bodies.filter(({isFrame}) => !isFrame);
    }
    /** The points by which a point is placed. */
    static reads(form: Json): string[] {
        if (!form || typeof form !== 'object' || Array.isArray(form)) return [];
        const names = [form.from, form.to, ...listOf(form['relative to'])];
        for (const curve of listOf(form.meet)) {
            if (!curve || typeof curve !== 'object') continue;
            names.push(curve.circle, curve.line, curve.to);
            for (const bearing of [curve.parallel, curve.perpendicular]) names.push(...listOf(bearing));
        }
        return names.filter((each) => typeof each === 'string');
    }
    /** Whether the place of a point depends on another. */
    dependsOn(point: string, other: string, seen: Set<string> = new Set()): boolean {
        if (point === other) return true;
        if (seen.has(point)) return false;
        seen.add(point);
        return Model.reads(this.point(point)?.form).some((each) => this.dependsOn(each, other, seen));
    }
    /** A name that is free: A, B, C … */
    freePointName(first = 'A') {
        const taken = new Set(this.points.map(({name}) => name));
        const letters = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ';
        if (first !== 'A') {
            for (let i = 0; ; ++i) {
                const name = i === 0 ? first : `${first}${i + 1}`;
                if (!taken.has(name)) return name;
            }
        }
        for (let round = 0; ; ++round) {
            for (const letter of letters) {
                const name = round === 0 ? letter : `${letter}${round}`;
                if (letter !== 'O' && letter !== 'G' && !taken.has(name)) return name;
            }
        }
    }
    /** The next number: 2, 3 … */
    freeBodyName() {
        for (let i = 2; ; ++i) {
            const name = String(i);
            if (name !== this.frame && !this.bodyNamed(name)) return name;
        }
    }
    /** A name for a load: F1, F2 … */
    freeLoadName(letter: string) {
        const taken = new Set(
            this.loads.map(
                ({form}) => nameOf(form.force) || nameOf(form.couple) || nameOf(form.spring) || nameOf(form.distributed)
            )
        );
        for (let i = 1; ; ++i) if (!taken.has(`${letter}${i}`)) return `${letter}${i}`;
    }
    /** The pointer of a path. */
    static pointer(path: Path) {
        return path.map((each) => `/${step(String(each))}`).join('');
    }
}
