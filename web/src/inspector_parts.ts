// The properties of links, joints, drivers, loads and weights.
import type {Bench} from './bench';
import {html} from './dom';
import {bodyValue, type Edit} from './edit';
import {asTyped, button, choice, fileField, heading, row, tick, told} from './fields';
import {links, renameField, spanFields} from './inspector';
import type {Json, Path} from './json_text';
import type {JointItem} from './model';
import {bars} from './snap';
import {pointerTo} from './tools';
import {word} from './words';

export function bodyFields(bench: Bench, name: string) {
    const {model} = bench,
        points = model.pointsOf(name),
        driver = model.drivers.find(({form}) => String(form.body) === name);
    const rows = [heading(word('link', name)), renameField(bench, 'body', name)];
    for (const [p, q] of bars(model, name, bench.spots).slice(0, 4)) rows.push(...spanFields(bench, p, q));
    const others = model.points.map((each) => each.name).filter((each) => !points.includes(each));
    if (others.length > 0) {
        const add = (edit: Edit, point: string) => {
            const carried = edit.model.bodiesAt(point);
            edit.addPointToBody(point, name);
            if (carried.length > 0) edit.addHinge(point, [...carried, name]);
        };
        const select: HTMLSelectElement = html('select', {
            id: 'add-point', onchange: () => select.value && bench.edit((edit) => add(edit, select.value))
        }, html('option', {value: ''}, '…'), ...others.map((each) => html('option', {value: each}, each)));
        rows.push(row(word('add_point'), select));
    }
    rows.push(...colourFields(bench, name));
    const acts = html('div', {class: 'acts'});
    if (!driver) acts.append(button(word('drive_it'), () => bench.edit((edit) => {
        edit.addDriver(name);
        return pointerTo('drivers', edit.model.drivers.length - 1);
    }), 'drive'));
    rows.push(acts, ...links(bench, word('points'), points.map((each) => [each, pointerTo('points', each)])));
    if (driver) rows.push(...links(bench, word('driver'), [[word('driver_of', name), driver.pointer]]));
    if (model.masses.some(({body}) => body === name))
        rows.push(...links(bench, word('weight'), [[word('weight_of', name), pointerTo('masses', name)]]));
    return rows;
}

/** The colour of a body, and the way back to the theme's. */
function colourFields(bench: Bench, name: string) {
    const own = bench.model.bodyNamed(name)?.colour ?? '';
    const give = (colour: string, joins = '') =>
        bench.edit((edit) => edit.setColour(name, colour), joins);
    const input = html('input', {type: 'color', id: 'colour', value: own || lookOf(name)});
    input.addEventListener('input', () => give(input.value, `colour ${name}`));
    input.addEventListener('change', () => {
        // From here on the field may be shown anew.
        input.defaultValue = input.value;
        bench.document.rest();
        bench.tell('selection');
    });
    const back = button(word('colour_of_theme'), () => give(''), 'colour-of-theme');
    return [row(word('colour'), input), ...own ? [html('div', {class: 'acts'}, back)] : []];
}
/** The colour in which a body is drawn. */
function lookOf(name: string) {
    const drawn = document.querySelector(`#canvas [data-of="${CSS.escape(pointerTo('bodies', name))}"]`);
    const look = drawn ? getComputedStyle(drawn).getPropertyValue('--look').trim() : '';
    return /^#[0-9a-f]{6}$/i.test(look) ? look : '#808080';
}

export function jointFields(bench: Bench, index: number) {
    const joint = bench.model.joints.find((each) => each.path[1] === index);
    if (!joint) return [];
    const rows = [
        heading(`${word(`kind_${joint.kind.replace('-', '_')}`)} ${joint.name}`),
        told(word('joins'), joint.bodies.join(' · '))
    ];
    for (const key of ['along', 'tangent', 'pressure angle', 'pushes'])
        if (key in joint.form)
            rows.push(
                fileField(bench, word(`joint_${key.replace(' ', '_')}`), [...joint.path, key], {
                    id: `joint-${key.replace(' ', '-')}`
                })
            );
    if (['rolling', 'contact', 'gear'].includes(joint.kind))
        rows.push(...joint.bodies.flatMap((body) => profileFields(bench, joint, body)));
    rows.push(fileField(bench, word('name'), [...joint.path, 'name'], {optional: true, text: true}));
    rows.push(...links(bench, word('points'), [[joint.point, pointerTo('points', joint.point)]]));
    return rows;
}

/** What a body shows at a contact: a circle, a straight line, a tip. */
function profileFields(bench: Bench, joint: JointItem, body: string) {
    const form = joint.form.profiles?.[body] ?? {}, path = [...joint.path, 'profiles', body], {model} = bench;
    const kind = ['circle', 'line', 'tip'].find((each) => each in form) ?? '';
    const none = model.bodyNamed(body)?.circle ? 'profile_own' : 'profile_none';
    const kinds: [string, string][] = ['circle', 'line', 'tip'].map((each) => [each, word(`profile_${each}`)]);
    const rows = [choice(
        word('profile_of', body),
        kind,
        [['', word(none)], ...kinds],
        (wanted) => bench.edit((edit) => edit.setProfile(joint, body, wanted)),
        `profile-${body}`
    )];
    if (kind === 'circle')
        rows.push(choice(word('circle_about'), asTyped(form.circle), model.points.map(({name}) => [name, name]),
            (value) => bench.edit((edit) => edit.set([...path, 'circle'], value)), `centre-${body}`));
    if (kind === 'line') rows.push(fileField(bench, word('joint_along'), [...path, 'line'], {id: `line-${body}`}));
    return rows;
}

export function driverFields(bench: Bench, path: Path, form: Json) {
    const slides = form.body === undefined, rows = [heading(word('driver_of', asTyped(form.body ?? form.joint)))];
    if (form.law) return [...rows, fileField(bench, word('law'), [...path, 'law'])];
    if (slides || form.at)
        rows.push(
            fileField(bench, word('speed'), [...path, 'speed'], {id: 'speed'}),
            fileField(bench, word('acceleration'), [...path, 'acceleration'], {optional: true, id: 'acceleration'})
        );
    else
        rows.push(
            fileField(bench, word('omega'), [...path, 'omega'], {unit: 'rad/s', id: 'omega'}),
            fileField(bench, word('alpha'), [...path, 'alpha'], {unit: 'rad/s²', optional: true, id: 'alpha'})
        );
    rows.push(
        html(
            'div',
            {class: 'acts'},
            button(word('drive_by_law'), () => bench.edit((edit) => edit.addLaw(path, form)), 'by-law')
        )
    );
    const isMine = (effort: Json) =>
        effort && (slides ? effort.joint === form.joint : String(effort.body) === String(form.body));
    const {effort} = bench.model.file,
        has = [effort].flat().some(isMine);
    if (bench.model.loads.length + bench.model.masses.length > 0 || has)
        rows.push(
            tick(word('balances'), has, (isOn) =>
                bench.edit((edit) => {
                    if (!isOn) edit.remove(['effort']);
                    else
                        edit.set(
                            ['effort'],
                            slides ? {force: 'Q', joint: form.joint} : {couple: 'M', body: bodyValue(String(form.body))}
                        );
                })
            )
        );
    return rows;
}

export function loadFields(bench: Bench, path: Path, form: Json) {
    const name = asTyped(form.force ?? form.couple ?? form.spring ?? form.distributed),
        rows = [heading(word('load', name))];
    const key = ['force', 'couple', 'spring', 'distributed'].find((each) => each in form) ?? 'force';
    rows.push(fileField(bench, word('name'), [...path, key], {text: true}));
    for (const each of Object.keys(form)) {
        if (
            [
                'force',
                'spring',
                'distributed',
                'couple',
                'body',
                'bodies',
                'at',
                'pin',
                'between',
                'from',
                'to'
            ].includes(each)
        )
            continue;
        rows.push(
            fileField(bench, word(`load_${each.replace(' ', '_')}`), [...path, each], {
                id: `load-${each.replace(' ', '-')}`
            })
        );
    }
    const on = form.pin ?? form.at;
    if (form.body !== undefined)
        rows.push(
            choice(
                word('acts_on'),
                String(form.body),
                bench.model.movingBodies.map(({name: each}) => [each, word('link', each)]),
                (value) => bench.edit((edit) => edit.set([...path, 'body'], bodyValue(value)))
            )
        );
    if (typeof on === 'string') rows.push(told(word('acts_at'), on));
    return rows;
}

export function massFields(bench: Bench, body: string) {
    const path = ['masses', body],
        form = bench.model.masses.find((each) => each.body === body)?.form ?? {};
    return [
        heading(word('weight_of', body)),
        fileField(bench, word('mass'), [...path, 'mass'], {unit: 'kg', id: 'mass'}),
        fileField(bench, word('inertia'), [...path, 'inertia'], {unit: 'kg m²', optional: true, id: 'inertia'}),
        told(word('centre'), asTyped(form.centre)),
        fileField(bench, word('gravity'), ['gravity'], {id: 'gravity', optional: true}),
        tick(word('inertia_forces'), bench.model.file['inertia forces'] === true, (isOn) =>
            bench.edit((edit) => (isOn ? edit.set(['inertia forces'], true) : edit.remove(['inertia forces'])))
        )
    ];
}
