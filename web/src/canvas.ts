// Draws the mechanism while it is built: what the file says, where the engine places it.
import {drawDrivers, drawLoads, drawMasses, gap} from './canvas_loads';
import {drawPlacing} from './canvas_places';
import {svg} from './dom';
import type {Spot, Spots} from './edit';
import type {Json} from './json_text';
import {type JointItem, Model} from './model';
import {distance} from './placing';
import {bars} from './snap';
import * as symbols from './symbols';
import {Tags, ends, isStraight} from './tags';
import type {View} from './view';

export interface Scene {
    model: Model;
    spots: Spots;
    directions: Record<string, number>;
    /** JSON pointers, as are those that are faulty. */
    selection: string | null;
    faulty: Set<string>;
}

const looks = 10;

/** A contact of which the file says the tangent only, with the frame. */
const isRoller = ({kind, form, bodies}: JointItem, frame: string) =>
    kind === 'contact' && !form.profiles && bodies.includes(frame);
/**
 * The angle by which a support is turned so that it stands against what it pushes.
 * @param turned of the tangent, on the screen
 */
function standing(pushes: Json, turned: number) {
    const [x, y] = Array.isArray(pushes) ? pushes.map(Number) : [0, 0];
    return x * Math.sin(turned) + y * Math.cos(turned) < 0 ? turned + Math.PI : turned;
}

export class Canvas {
    readonly layers: Record<string, SVGGElement>;
    scene: Scene | undefined;

    constructor(readonly root: SVGSVGElement, readonly view: View) {
        this.layers = Object.fromEntries(
            ['grid', 'under', 'bodies', 'joints', 'loads', 'labels', 'over'].map((name) => {
                const layer = svg('g', {class: `layer ${name}`});
                root.append(layer);
                return [name, layer];
            })
        );
    }
    draw(scene: Scene) {
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
    spot(point: string): Spot | null {
        const at = this.scene?.spots[point];
        return at ? this.view.toScreen(at) : null;
    }
    /** Adds marks under the name of what they show. */
    add(layer: string, pointer: string, look: string, ...marks: Element[]) {
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
    /** The look of a body: its colour, as in the figures. */
    look(body: string) {
        const {model} = this.scene as Scene,
            index = model.movingBodies.findIndex(({name}) => name === body);
        const own = model.movingBodies[index]?.colour;
        if (own) return `own-${own.slice(1)}`;
        return index < 0 ? 'frame' : `body-${(index % looks) + 1}`;
    }
    drawBodies() {
        const {model} = this.scene as Scene, drawn = model.movingBodies.map((body) => ({body,
            at: model.pointsOf(body.name).map((each) => this.spot(each)).filter(Boolean) as Spot[]}));
        const tags = new Tags(drawn.map(({at}) => at), model.points.map(({name}) => this.spot(name)));
        for (const {body, at} of drawn) {
            const pointer = Model.pointer(['bodies', body.name]), look = this.look(body.name);
            const inLine = at.length > 2 && isStraight(at);
            if (at.length > 1) this.add('bodies', pointer, look, symbols.link(inLine ? ends(at) : at));
            if (at.length > 1 || body.circle) this.tag(body.name, look, tags.place(at, this.isBelow(body.name)));
        }
    }
    /** Whether the number of a body stands below its bar: where the arrow of its driver is above. */
    isBelow(body: string) {
        const {model} = this.scene as Scene,
            driver = model.drivers.find(({form}) => String(form.body) === body);
        const points = model.pointsOf(body),
            pivot = points.find((each) => model.isGround(each)) ?? points[0];
        const at = this.spot(pivot ?? ''),
            tip = this.spot(points.find((each) => each !== pivot) ?? '');
        if (driver && at && tip) return !(parseFloat(driver.form.omega) < 0) === tip[0] >= at[0];
        // Beside a steep bar it stands on the outer side of the mechanism.
        const both = points.map((each) => this.spot(each)).filter(Boolean), [a, b] = both as Spot[];
        if (both.length !== 2 || Math.abs(b[0] - a[0]) > Math.abs(b[1] - a[1])) return false;
        const all = model.points.map(({name}) => this.spot(name)?.[0] ?? a[0]),
            middle = all.reduce((sum, each) => sum + each, 0) / all.length;
        return (a[0] + b[0]) / 2 < middle === (b[1] - a[1]) * (b[0] - a[0]) >= 0;
    }
    /** The number of a body in its circle. */
    tag(name: string, look: string, [x, y]: Spot) {
        this.add(
            'labels',
            Model.pointer(['bodies', name]),
            `${look} tag`,
            svg('circle', {cx: x, cy: y, r: 11}),
            svg('text', {x, y: y + 5}, name)
        );
    }
    /** The direction of a joint on the screen, radians. */
    turned(pointer: string, along: Json) {
        const {directions, spots} = this.scene as Scene;
        if (pointer in directions) return -directions[pointer];
        if (typeof along === 'number') return (-along * Math.PI) / 180;
        if (Array.isArray(along) && spots[along[0]] && spots[along[1]])
            return -Math.atan2(spots[along[1]][1] - spots[along[0]][1], spots[along[1]][0] - spots[along[0]][0]);
        return 0;
    }
    drawJoints() {
        const {model} = this.scene as Scene;
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
    drawWheels(joint: JointItem, at: Spot, turned: number) {
        const {model} = this.scene as Scene;
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
        const {model} = this.scene as Scene;
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
    /** The directions in which something is drawn at a point, radians on the screen. */
    waysTaken(point: string, at: Spot) {
        const {model, spots} = this.scene as Scene, taken = [];
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
    /** The direction from a point in which there is most room, up rather than down. */
    freeWay(point: string, at: Spot) {
        const taken = this.waysTaken(point, at),
            ways = [-1, -2, -3, 0, -4, 1, 3, 2].map((each) => (each * Math.PI) / 4);
        const room = (way: number) => Math.min(2, ...taken.map((each) => gap(way, each)));
        return ways.reduce((best, each) => (room(each) > room(best) + 0.1 ? each : best), ways[0]);
    }
    /** What a tool shows while it is used. */
    over(...marks: Element[]) {
        this.layers.over.replaceChildren(...marks);
    }
}
