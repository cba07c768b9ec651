// Draws the mechanism while it is built: what the file says, where the engine places it.
import {drawDrivers, drawLoads, drawMasses, gap} from './canvas_loads.js';
import {drawPlacing} from './canvas_places.js';
import {svg} from './dom.js';
import {Model} from './model.js';
import {distance} from './placing.js';
import {bars} from './snap.js';
import * as symbols from './symbols.js';
import {Tags, ends, isStraight} from './tags.js';

/**
 * @typedef {import('./edit.js').Spot} Spot
 * @typedef {import('./edit.js').Spots} Spots
 * @typedef {import('./view.js').View} View
 * @typedef {{model: Model, spots: Spots, directions: Record<string, number>,
 *     selection: string | null, faulty: Set<string>}} Scene
 *     selection and faulty: JSON pointers
 */

const looks = 5;

/**
 * A contact of which the file says the tangent only, with the frame.
 * @param {import('./model.js').JointItem} joint
 * @param {string} frame
 */
const isRoller = ({kind, form, bodies}, frame) => kind === 'contact' && !form.profiles && bodies.includes(frame);
/**
 * The angle by which a support is turned so that it stands against what it pushes.
 * @param {any} pushes
 * @param {number} turned of the tangent, on the screen
 */
function standing(pushes, turned) {
    const [x, y] = Array.isArray(pushes) ? pushes.map(Number) : [0, 0];
    return x * Math.sin(turned) + y * Math.cos(turned) < 0 ? turned + Math.PI : turned;
}

export class Canvas {
    /**
     * @param {SVGSVGElement} root
     * @param {View} view
     */
    constructor(root, view) {
        this.root = root;
        this.view = view;
        this.layers = Object.fromEntries(
            ['grid', 'under', 'bodies', 'joints', 'loads', 'labels', 'over'].map((name) => {
                const layer = svg('g', {class: `layer ${name}`});
                root.append(layer);
                return [name, layer];
            })
        );
    }
    /** @param {Scene} scene */
    draw(scene) {
        this.scene = scene;
        for (const layer of Object.values(this.layers)) layer.replaceChildren();
        this.drawGrid();
        this.drawBodies();
        this.drawJoints();
        this.drawPoints();
        drawDrivers(this, scene);
        drawMasses(this, scene);
        drawLoads(this, scene);
        drawPlacing(this, scene);
    }
    /**
     * @param {string} point
     * @returns {Spot | null}
     */
    spot(point) {
        const at = this.scene?.spots[point];
        return at ? this.view.toScreen(at) : null;
    }
    /**
     * Adds marks under the name of what they show.
     * @param {string} layer
     * @param {string} pointer
     * @param {string} look
     * @param {...Element} marks
     */
    add(layer, pointer, look, ...marks) {
        const states = [
            look,
            this.scene?.selection === pointer ? 'selected' : '',
            this.scene?.faulty.has(pointer) ? 'faulty' : ''
        ];
        const group = svg('g', {class: states.filter(Boolean).join(' '), 'data-of': pointer}, ...marks);
        const [, own] = /^own-([0-9a-f]{6})$/.exec(look.split(' ')[0]) ?? [];
        if (own) group.classList.add('own');
        if (own) group.style.setProperty('--own', `#${own}`);
        this.layers[layer].append(group);
    }
    /** A dot at each node, as a pattern: a path of all dots would be drawn anew in every frame. */
    drawGrid() {
        const {view} = this,
            size = view.grid * view.scale,
            [x, y] = view.toScreen([0, 0]);
        const pattern = svg(
            'pattern',
            {
                id: 'grid-dots',
                patternUnits: 'userSpaceOnUse',
                x: x - size / 2,
                y: y - size / 2,
                width: size,
                height: size
            },
            svg('circle', {class: 'dots', cx: size / 2, cy: size / 2, r: 1})
        );
        const ground = svg('rect', {width: view.width, height: view.height});
        ground.style.fill = 'url(#grid-dots)';
        ground.style.stroke = 'none';
        this.layers.grid.append(pattern, ground, svg('path', {class: 'axes', d: `M${x - 7} ${y}h14M${x} ${y - 7}v14`}));
    }
    /**
     * The look of a body: its colour, as in the figures.
     * @param {string} body
     */
    look(body) {
        const {model} = /** @type {Scene} */ (this.scene),
            index = model.movingBodies.findIndex(({name}) => name === body);
        const own = model.movingBodies[index]?.colour;
        if (own) return `own-${own.slice(1)}`;
        return index < 0 ? 'frame' : `body-${(index % looks) + 1}`;
    }
    drawBodies() {
        const {model} = /** @type {Scene} */ (this.scene), drawn = model.movingBodies.map((body) => ({body,
            at: /** @type {Spot[]} */ (model.pointsOf(body.name).map((each) => this.spot(each)).filter(Boolean))}));
        const tags = new Tags(drawn.map(({at}) => at), model.points.map(({name}) => this.spot(name)));
        for (const {body, at} of drawn) {
            const pointer = Model.pointer(['bodies', body.name]), look = this.look(body.name);
            const inLine = at.length > 2 && isStraight(at);
            if (at.length > 1) this.add('bodies', pointer, look, symbols.link(inLine ? ends(at) : at));
            if (at.length > 1 || body.circle) this.tag(body.name, look, tags.place(at, this.isBelow(body.name)));
        }
    }
    /**
     * Whether the number of a body stands below its bar: where the arrow of its driver is above.
     * @param {string} body
     */
    isBelow(body) {
        const {model} = /** @type {Scene} */ (this.scene),
            driver = model.drivers.find(({form}) => String(form.body) === body);
        const points = model.pointsOf(body),
            pivot = points.find((each) => model.isGround(each)) ?? points[0];
        const at = this.spot(pivot ?? ''),
            tip = this.spot(points.find((each) => each !== pivot) ?? '');
        if (driver && at && tip) return !(parseFloat(driver.form.omega) < 0) === tip[0] >= at[0];
        // Beside a steep bar it stands on the outer side of the mechanism.
        const both = points.map((each) => this.spot(each)).filter(Boolean), [a, b] = /** @type {Spot[]} */ (both);
        if (both.length !== 2 || Math.abs(b[0] - a[0]) > Math.abs(b[1] - a[1])) return false;
        const all = model.points.map(({name}) => this.spot(name)?.[0] ?? a[0]),
            middle = all.reduce((sum, each) => sum + each, 0) / all.length;
        return (a[0] + b[0]) / 2 < middle === (b[1] - a[1]) * (b[0] - a[0]) >= 0;
    }
    /**
     * The number of a body in its circle.
     * @param {string} name
     * @param {string} look
     * @param {Spot} at
     */
    tag(name, look, [x, y]) {
        this.add(
            'labels',
            Model.pointer(['bodies', name]),
            `${look} tag`,
            svg('circle', {cx: x, cy: y, r: 11}),
            svg('text', {x, y: y + 5}, name)
        );
    }
    /**
     * The direction of a joint on the screen, radians.
     * @param {string} pointer
     * @param {any} along
     */
    turned(pointer, along) {
        const {directions, spots} = /** @type {Scene} */ (this.scene);
        if (pointer in directions) return -directions[pointer];
        if (typeof along === 'number') return (-along * Math.PI) / 180;
        if (Array.isArray(along) && spots[along[0]] && spots[along[1]])
            return -Math.atan2(spots[along[1]][1] - spots[along[0]][1], spots[along[1]][0] - spots[along[0]][0]);
        return 0;
    }
    drawJoints() {
        const {model} = /** @type {Scene} */ (this.scene);
        for (const joint of model.joints) {
            const at = this.spot(joint.point);
            if (!at) continue;
            const turned = this.turned(joint.pointer, joint.form.along ?? joint.form.tangent),
                look = this.look(joint.bodies[0] ?? '');
            if (joint.kind === 'prismatic')
                this.add('under', joint.pointer, look, symbols.slider(at, turned, joint.bodies[1] === model.frame));
            else if (joint.kind === 'pin-slot')
                this.add('under', joint.pointer, this.look(joint.bodies[1] ?? ''), symbols.slot(at, turned));
            else if (joint.kind === 'revolute' && joint.bodies.includes(model.frame))
                this.add('under', joint.pointer, 'frame', symbols.ground(at));
            else if (isRoller(joint, model.frame))
                this.add('under', joint.pointer, 'frame', symbols.roller(at, standing(joint.form.pushes, turned)));
            else if (joint.kind !== 'revolute' && joint.kind !== 'weld') this.drawWheels(joint, at, turned);
        }
        for (const point of model.bodyNamed(model.frame)?.points ?? []) {
            const at = this.spot(point);
            if (at && !model.hingeAt(point))
                this.add('under', Model.pointer(['points', point]), 'frame', symbols.ground(at));
        }
    }
    /**
     * @param {import('./model.js').JointItem} joint
     * @param {Spot} at
     * @param {number} turned
     */
    drawWheels(joint, at, turned) {
        const {model} = /** @type {Scene} */ (this.scene);
        let wheels = 0;
        for (const body of joint.bodies) {
            const centre = this.spot(model.centreOf(joint.form, body));
            if (!centre) continue;
            ++wheels;
            this.add(
                'under',
                joint.pointer,
                this.look(body),
                symbols.wheel(centre, distance(centre, at), joint.kind === 'gear')
            );
        }
        const [x, y] = at,
            dx = 40 * Math.cos(turned),
            dy = 40 * Math.sin(turned);
        if (wheels < 2)
            this.add(
                'under',
                joint.pointer,
                'frame',
                svg('path', {class: 'guide', d: `M${x - dx} ${y - dy}L${x + dx} ${y + dy}`})
            );
    }
    drawPoints() {
        const {model} = /** @type {Scene} */ (this.scene);
        for (const {name} of model.points) {
            const at = this.spot(name),
                joint = model.joints.some((each) => each.point === name && each.kind !== 'weld');
            if (!at) continue;
            this.add(
                'joints',
                Model.pointer(['points', name]),
                joint ? 'joint' : 'free',
                joint ? symbols.pin(at) : symbols.dot(at)
            );
            const turned = this.freeWay(name, at);
            this.add('labels', Model.pointer(['points', name]), 'name',
                symbols.label([at[0] + 21 * Math.cos(turned), at[1] + 19 * Math.sin(turned) + 6], name, 'of-point'));
        }
    }
    /**
     * The directions in which something is drawn at a point, radians on the screen.
     * @param {string} point
     * @param {Spot} at
     */
    waysTaken(point, at) {
        const {model, spots} = /** @type {Scene} */ (this.scene), taken = [];
        for (const {name} of model.movingBodies) {
            for (const bar of bars(model, name, spots)) {
                if (!bar.includes(point)) continue;
                const [x, y] = this.spot(bar[0] === point ? bar[1] : bar[0]) ?? at;
                taken.push(Math.atan2(y - at[1], x - at[0]));
            }
        }
        for (const {form} of model.drivers)
            if (model.isGround(point) && model.pointsOf(String(form.body)).includes(point))
                taken.push(...taken.map((each) => each - 1), ...taken.map((each) => each + 1));
        if (model.isGround(point)) taken.push(Math.PI / 2 - 0.4, Math.PI / 2, Math.PI / 2 + 0.4);
        for (const joint of model.joints)
            if (joint.point === point && joint.kind === 'prismatic') taken.push(Math.PI / 2, 0, Math.PI);
        return taken;
    }
    /**
     * The direction from a point in which there is most room, up rather than down.
     * @param {string} point
     * @param {Spot} at
     */
    freeWay(point, at) {
        const taken = this.waysTaken(point, at),
            ways = [-1, -2, -3, 0, -4, 1, 3, 2].map((each) => (each * Math.PI) / 4);
        const room = (/** @type {number} */ way) => Math.min(2, ...taken.map((each) => gap(way, each)));
        return ways.reduce((best, each) => (room(each) > room(best) + 0.1 ? each : best), ways[0]);
    }
    /**
     * What a tool shows while it is used.
     * @param {...Element} marks
     */
    over(...marks) {
        this.layers.over.replaceChildren(...marks);
    }
}
