// What the text says, as lists that are drawn and edited. It takes any JSON: what is not as it should be is left
// out, and the engine says so.
import {plain} from './json_text.js';

/**
 * @typedef {import('./json_text.js').JsonText} JsonText
 * @typedef {import('./json_text.js').Path} Path
 * @typedef {{name: string, form: any, path: Path}} PointItem
 * @typedef {{name: string, points: string[], listPath: Path, path: Path, colour: string,
 *     circle: {centre: string} | null, isFrame: boolean}} BodyItem
 *     colour: "#rrggbb", or '': the theme's
 * @typedef {{kind: string, point: string, bodies: string[], name: string, form: any, path: Path,
 *     pointer: string}} JointItem
 * @typedef {{form: any, path: Path, pointer: string}} ListItem
 * @typedef {{body: string, form: any, path: Path}} MassItem
 */

export const jointKinds = ['revolute', 'prismatic', 'pin-slot', 'rolling', 'contact', 'gear', 'weld'];

/** @param {any} value */
const nameOf = (value) => (typeof value === 'string' || typeof value === 'number' ? String(value) : '');
/**
 * @param {any} value
 * @returns {any[]}
 */
const listOf = (value) => (Array.isArray(value) ? value : []);
/**
 * @param {any} value
 * @returns {[string, any][]}
 */
const entriesOf = (value) => (value && typeof value === 'object' && !Array.isArray(value) ? Object.entries(value) : []);
/** @param {string} name */
const step = (name) => name.replaceAll('~', '~0').replaceAll('/', '~1');

export class Model {
    /** @param {JsonText | null} json */
    constructor(json) {
        this.json = json;
        const file = json ? plain(json.root) : {};
        this.file = file;
        this.frame = nameOf(file.frame) || '0';
        this.unit = nameOf(file.units?.length) || 'm';
        /** @type {PointItem[]} */
        this.points = json?.at(['points'])?.members.map(({key, value}) =>
            ({name: key, form: plain(value), path: ['points', key]})) ?? [];
        /** @type {BodyItem[]} */
        this.bodies = json?.at(['bodies'])?.members.map(({key, value}) => this.body(key, plain(value))) ?? [];
        /** @type {JointItem[]} */
        this.joints = listOf(file.joints).map((form, i) => this.joint(form ?? {}, i)).filter(({kind}) => kind !== '');
        this.drivers = this.list('drivers');
        this.loads = this.list('loads');
        /** @type {MassItem[]} */
        this.masses = entriesOf(file.masses).map(([body, form]) => ({body, form: form ?? {}, path: ['masses', body]}));
        this.hasJoints = Boolean(json?.at(['joints']));
    }
    /**
     * @param {string} name
     * @param {any} form
     * @returns {BodyItem}
     */
    body(name, form) {
        const isList = Array.isArray(form), centre = nameOf(form?.circle?.centre), given = nameOf(form?.colour);
        const colour = /^#[0-9a-f]{6}$/i.test(given) ? given.toLowerCase() : '';
        return {name, points: listOf(isList ? form : form?.points).map(nameOf), path: ['bodies', name],
            listPath: isList ? ['bodies', name] : ['bodies', name, 'points'], circle: centre ? {centre} : null,
            colour, isFrame: name === this.frame};
    }
    /**
     * @param {any} form
     * @param {number} i
     * @returns {JointItem}
     */
    joint(form, i) {
        const kind = jointKinds.find((each) => each in form) ?? '';
        return {kind, point: nameOf(form[kind]), bodies: listOf(form.bodies).map(nameOf), form, path: ['joints', i],
            name: nameOf(form.name) || nameOf(form[kind]), pointer: `/joints/${i}`};
    }
    /**
     * @param {string} key
     * @returns {ListItem[]}
     */
    list(key) {
        return listOf(this.file[key]).map((form, i) => ({form: form ?? {}, path: [key, i], pointer: `/${key}/${i}`}));
    }
    /**
     * The centre of the disc that a body shows at a joint; '': none.
     * @param {any} form of the joint
     * @param {string} body
     */
    centreOf(form, body) {
        return nameOf(form.profiles?.[body]?.circle) || this.bodyNamed(body)?.circle?.centre || '';
    }
    /** @param {string} name */
    point(name) {
        return this.points.find((each) => each.name === name);
    }
    /** @param {string} name */
    bodyNamed(name) {
        return this.bodies.find((each) => each.name === name);
    }
    /**
     * The bodies that carry a point, the frame among them.
     * @param {string} point
     */
    bodiesAt(point) {
        const names = this.bodies.filter((each) => each.points.includes(point)).map(({name}) => name);
        for (const joint of this.joints)
            if (joint.point === point && (joint.kind === 'revolute' || joint.kind === 'weld'))
                names.push(...joint.bodies.filter((each) => !names.includes(each)));
        return [...new Set(names)];
    }
    /**
     * The points of a body, with those of its hinges.
     * @param {string} name
     */
    pointsOf(name) {
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
    /** @param {string} point */
    hingeAt(point) {
        return this.joints.find((each) => each.kind === 'revolute' && each.point === point);
    }
    /**
     * Whether a point is fixed to the frame.
     * @param {string} point
     */
    isGround(point) {
        return this.bodiesAt(point).includes(this.frame);
    }
    get movingBodies() {
        return this.bodies.filter(({isFrame}) => !isFrame);
    }
    /**
     * The points by which a point is placed.
     * @param {any} form
     * @returns {string[]}
     */
    static reads(form) {
        if (!form || typeof form !== 'object' || Array.isArray(form)) return [];
        const names = [form.from, form.to, ...listOf(form['relative to'])];
        for (const curve of listOf(form.meet)) {
            if (!curve || typeof curve !== 'object') continue;
            names.push(curve.circle, curve.line, curve.to);
            for (const bearing of [curve.parallel, curve.perpendicular]) names.push(...listOf(bearing));
        }
        return names.filter((each) => typeof each === 'string');
    }
    /**
     * Whether the place of a point depends on another.
     * @param {string} point
     * @param {string} other
     * @param {Set<string>} [seen]
     * @returns {boolean}
     */
    dependsOn(point, other, seen = new Set()) {
        if (point === other) return true;
        if (seen.has(point)) return false;
        seen.add(point);
        return Model.reads(this.point(point)?.form).some((each) => this.dependsOn(each, other, seen));
    }
    /**
     * A name that is free: A, B, C …
     * @param {string} [first]
     */
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
    /**
     * A name for a load: F1, F2 …
     * @param {string} letter
     */
    freeLoadName(letter) {
        const taken = new Set(
            this.loads.map(
                ({form}) => nameOf(form.force) || nameOf(form.couple) || nameOf(form.spring) || nameOf(form.distributed)
            )
        );
        for (let i = 1; ; ++i) if (!taken.has(`${letter}${i}`)) return `${letter}${i}`;
    }
    /**
     * The pointer of a path.
     * @param {Path} path
     */
    static pointer(path) {
        return path.map((each) => `/${step(String(each))}`).join('');
    }
}
