// The panel of properties: of what is selected, otherwise of the whole mechanism.
import type {Bench} from './bench';
import {byId, html} from './dom';
import {unjoinedAt} from './edit';
import {asTyped, button, choice, field, fileField, heading, told} from './fields';
import {bodyFields, driverFields, jointFields, loadFields, massFields} from './inspector_parts';
import type {Json} from './json_text';
import {deleteSelected} from './keys';
import {angle, distance, formOf, forms, placeBy, setAngle, setDistance} from './placing';
import {rename} from './references';
import {pointerTo} from './tools';
import {numberText, word} from './words';

export class Inspector {
    readonly root = byId('properties');

    constructor(readonly bench: Bench) {
        bench.on(['file', 'answer', 'selection'], () => this.show());
    }
    /** Shows it anew; what is typed at the moment stays. */
    show() {
        const active = document.activeElement,
            isIn = active instanceof HTMLElement && this.root.contains(active);
        if (
            isIn &&
            active instanceof HTMLInputElement &&
            active.type !== 'checkbox' &&
            active.value !== active.defaultValue
        )
            return;
        const id = isIn ? active.id : '',
            selected = this.bench.selected();
        this.root.replaceChildren(...(selected ? this.ofSelected(selected) : this.ofMechanism()));
        if (id) document.getElementById(id)?.focus();
    }
    ofSelected({list, key, path, form}: NonNullable<ReturnType<Bench['selected']>>) {
        const {bench} = this, name = String(key);
        const parts = list === 'points' ? this.ofPoint(name, form) : list === 'bodies' ? bodyFields(bench, name) :
            list === 'joints' ? jointFields(bench, Number(key)) : list === 'drivers' ? driverFields(bench, path, form) :
                list === 'loads' ? loadFields(bench, path, form) : list === 'masses' ? massFields(bench, name) : [];
        const remove = button(word('remove'), () => deleteSelected(bench), 'delete');
        remove.classList.add('danger');
        return [...parts, html('div', {class: 'acts'}, remove)];
    }
    ofPoint(name: string, form: Json) {
        const {bench} = this, {model} = bench, path = ['points', name], kind = formOf(form), others = model.points
            .map((each) => each.name).filter((each) => each !== name && !model.dependsOn(each, name));
        const rows = [heading(word('point', name)), renameField(bench, 'point', name)];
        rows.push(
            choice(
                word('placed_by'),
                kind,
                forms
                    .filter(
                        (each) => each === kind || each === 'coordinates' || others.length > (each === 'polar' ? 0 : 1)
                    )
                    .map((each) => [each, word(`by_${each}`)]),
                (wanted) => bench.edit((edit) => placeBy(edit, name, wanted)),
                'placed-by'
            )
        );
        rows.push(...this.ofPlacing(kind, form, path, others));
        const acts = html('div', {class: 'acts'});
        if (bench.selection && !model.isGround(name))
            acts.append(button(word('make_ground'), () => bench.edit((edit) => edit.addGround(name)), 'make-ground'));
        if (unjoinedAt(model, bench.spots, name).length > 0)
            acts.append(button(word('pin_together'), () => bench.edit((edit) => edit.pinTogether(name)), 'pin'));
        if (acts.hasChildNodes()) rows.push(acts);
        rows.push(
            ...links(
                bench,
                word('carried_by'),
                model
                    .bodiesAt(name)
                    .filter((each) => model.bodyNamed(each))
                    .map((each) => [word('link', each), pointerTo('bodies', each)])
            )
        );
        rows.push(
            ...links(
                bench,
                word('joints'),
                model.joints
                    .filter((each) => each.point === name)
                    .map((each) => [word(`kind_${each.kind.replace('-', '_')}`), each.pointer])
            )
        );
        return rows;
    }
    /**
     * The fields of one form of a point.
     * @param others points that it may refer to
     */
    ofPlacing(kind: string, form: Json, path: (string | number)[], others: string[]) {
        const {bench} = this, {unit} = bench.model;
        const ofPoint = (text: string, at: (string | number)[]) =>
            choice(
                text,
                asTyped(bench.document.lastJson?.plainAt(at)),
                others.map((each) => [each, each]),
                (value) => bench.edit((edit) => edit.set(at, value))
            );
        const from = () => ofPoint(word('from'), [...path, 'from']), to = () => ofPoint(word('to'), [...path, 'to']);
        const far = () => fileField(bench, word('distance'), [...path, 'distance'], {unit, id: 'distance'});
        if (kind === 'coordinates')
            return ['x', 'y'].map((axis, i) => fileField(bench, axis, [...path, i], {unit, id: axis}));
        if (kind === 'polar')
            return [from(), far(), fileField(bench, word('angle'), [...path, 'angle'], {unit: '°', id: 'angle'})];
        if (kind === 'online')
            return [from(), to(),
                'ratio' in form ? fileField(bench, word('ratio'), [...path, 'ratio'], {id: 'ratio'}) : far()];
        return kind === 'meet' ? this.ofMeet(form, path, ofPoint) : [];
    }
    ofMeet(form: Json, path: (string | number)[], ofPoint: (text: string, at: (string | number)[]) => HTMLElement) {
        const {bench} = this, {unit} = bench.model;
        const rows = form.meet.flatMap((curve: Json, i: number) => {
            const at = [...path, 'meet', i];
            if (curve?.circle !== undefined)
                return [
                    typeof curve.circle === 'string'
                        ? ofPoint(word('circle_about'), [...at, 'circle'])
                        : told(word('circle_about'), asTyped(curve.circle)),
                    fileField(bench, word('radius'), [...at, 'radius'], {unit, id: `radius-${i}`})
                ];
            const rest = Object.keys(curve ?? {}).filter((each) => each !== 'line');
            return [
                told(word('line_through'), asTyped(curve?.line)),
                ...rest.map((each) => fileField(bench, word(`line_${each}`), [...at, each]))
            ];
        });
        if (typeof form.side === 'string') {
            const sides = /^(left|right)$/.test(form.side) ? ['left', 'right'] : ['ahead', 'behind'];
            rows.push(
                choice(
                    word('side'),
                    form.side,
                    sides.map((each) => [each, word(`side_${each}`)]),
                    (value) => bench.edit((edit) => edit.set([...path, 'side'], value))
                )
            );
        }
        if (form.near) rows.push(fileField(bench, word('near'), [...path, 'near']));
        return rows;
    }
    ofMechanism() {
        const {bench} = this,
            {model, answer} = bench,
            title = model.file.title,
            language = bench.inquiry.language;
        const ofTitle =
            title && typeof title === 'object'
                ? ['title', language in title ? language : (Object.keys(title)[0] ?? 'en')]
                : ['title'];
        const rows = [
            heading(word('mechanism')),
            fileField(bench, word('title'), ofTitle, {id: 'title', text: true}),
            choice(
                word('unit_of_length'),
                model.unit,
                ['mm', 'cm', 'm', 'in', 'ft'].map((each) => [each, each]),
                (value) => bench.edit((edit) => edit.set(['units', 'length'], value)),
                'unit'
            )
        ];
        if (answer?.counts && model.movingBodies.length > 0)
            rows.push(told(word('bodies_joints'), `${answer.counts.bodies} · ${answer.counts.joints}`));
        if (answer?.mobility && model.movingBodies.length > 0)
            rows.push(freedom(bench, answer.mobility.effective, answer.counts?.drivers ?? 0));
        if (model.file.gravity)
            rows.push(fileField(bench, word('gravity'), ['gravity'], {id: 'gravity', optional: true}));
        rows.push(...this.parameters(), ...this.values(), ...this.list());
        return rows;
    }
    parameters() {
        const {bench} = this, names = Object.keys(bench.model.file.parameters ?? {});
        const rows = names.length > 0 ? [heading(word('parameters'))] : [];
        return [...rows, ...names.map((each) => fileField(bench, each, ['parameters', each]))];
    }
    values() {
        const values = this.bench.answer?.values ?? [];
        const wanted = values.filter(({name}) => /^(omega|alpha) |^v \S+$|^M|^effort|^bar /.test(name)).slice(0, 12);
        if (wanted.length === 0) return [];
        return [
            heading(word('values')),
            ...wanted.map(({name, value, unit}) => told(symbolOf(name), `${numberText(value, 4)} ${unit}`))
        ];
    }
    /** Everything that can be selected, for those who do not point. */
    list() {
        const {bench} = this, {model} = bench;
        const parts = [...model.points.map(({name}) => [word('point', name), pointerTo('points', name)]),
            ...model.movingBodies.map(({name}) => [word('link', name), pointerTo('bodies', name)]),
            ...model.joints.map(({kind, name, pointer}) => [
                `${word(`kind_${kind.replace('-', '_')}`)} ${name}`,
                pointer
            ]),
            ...model.drivers.map(({form, pointer}) => [word('driver_of', asTyped(form.body ?? form.joint)), pointer]),
            ...model.masses.map(({body}) => [word('weight_of', body), pointerTo('masses', body)]),
            ...model.loads.map(({form, pointer}) => [
                word('load', asTyped(form.force ?? form.couple ?? form.spring ?? form.distributed)),
                pointer
            ])
        ];
        return links(bench, word('parts'), parts as [string, string][]);
    }
}

/** ω₃ for "omega 3". */
function symbolOf(name: string) {
    const [, letter, index] = /^(\S+) (.+)$/.exec(name) ?? ['', name, ''];
    const of = {omega: 'ω', alpha: 'α'}[letter] ?? letter;
    return html('span', {}, of, ...index ? [html('sub', {}, index)] : []);
}
function freedom(bench: Bench, effective: number, drivers: number) {
    const left = effective - drivers,
        good = left === 0 && effective > 0;
    const says =
        effective <= 0
            ? word('freedom_none', effective)
            : left > 0
              ? word('freedom_free', effective, left)
              : word('freedom_driven', effective);
    return told(word('freedom'), says, good || (effective === 0 && bench.model.loads.length > 0) ? 'good' : 'open');
}
/** Buttons that select. */
export function links(bench: Bench, title: string, parts: [string, string][]) {
    if (parts.length === 0) return [];
    return [
        heading(title),
        html('div', {class: 'parts'}, ...parts.map(([text, pointer]) => button(text, () => bench.select(pointer))))
    ];
}
export function renameField(bench: Bench, kind: 'point' | 'body', name: string) {
    return field(word('name'), name, (_, text) => bench.edit((edit) => {
        const to = text.trim();
        return rename(edit, kind, name, to) ? pointerTo(kind === 'point' ? 'points' : 'bodies', to) : undefined;
    }), {id: 'name', text: true});
}
/** The length and the direction between two points, as they may be typed. */
export function spanFields(bench: Bench, p: string, q: string) {
    const [a, b] = [bench.spots[p], bench.spots[q]];
    if (!a || !b) return [];
    const shown = (value: number) => String(Number(value.toPrecision(6)));
    return [
        field(
            word('length_of', p, q),
            givenLength(bench, p, q) ?? shown(distance(a, b)),
            (value) =>
                bench.edit((edit) => {
                    if (!setDistance(edit, p, q, value)) byId('status').textContent = word('cannot_set');
                }),
            {unit: bench.model.unit, id: `length-${p}-${q}`, hint: word('formula_hint')}
        ),
        field(
            word('angle_of', p, q),
            shown(angle(a, b)),
            (value) =>
                bench.edit((edit) => {
                    if (!edit.model.dependsOn(p, q)) setAngle(edit, p, q, value);
                }),
            {unit: '°', id: `angle-${p}-${q}`}
        )
    ];
}
/** What the file gives as the distance of two points. */
function givenLength({model}: Bench, p: string, q: string) {
    for (const [point, other] of [[p, q], [q, p]]) {
        const form = model.point(point)?.form;
        if (form && !Array.isArray(form) && form.from === other && 'distance' in form && !form.to)
            return asTyped(form.distance);
        const circle = Array.isArray(form?.meet)
            ? form.meet.find((each: Json) => each?.circle === other)
            : null;
        if (circle) return asTyped(circle.radius);
    }
    return undefined;
}
