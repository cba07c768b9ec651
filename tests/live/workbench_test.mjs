// The workbench in Chromium: mechanisms are built by mouse, by keyboard alone and by touch; what is saved is what
// was drawn. node workbench_test.mjs PROGRAM EXAMPLES
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync, readdirSync, rmSync, statSync, writeFileSync} from 'node:fs';
import net from 'node:net';
import {createRequire} from 'node:module';
import {join} from 'node:path';
import {after, before, beforeEach, test} from 'node:test';
import {deflateRawSync} from 'node:zlib';
import {compiled} from '../../web/compiled.mjs';
import {unpacked} from '../geogebra/interpreter.mjs';
import {close, messages, open, page, protocol, run} from './browser.mjs';
import {
    cleanUp,
    clickAt,
    crossTo,
    dragFromTo,
    file,
    fill,
    folder,
    onScreen,
    ready,
    serve,
    settled,
    text,
    tool,
    until
} from './workbench.mjs';

const [program, examples] = process.argv.slice(2);
const path = join(folder, 'drawn.json'), exampleText = (name) => readFileSync(join(examples, name), 'utf8');
const axe = createRequire(import.meta.url).resolve('axe-core');
let address;

before(async () => ({address} = await serve(program, path)));
after(async () => {
    await close();
    cleanUp();
});
beforeEach(() => rmSync(path, {force: true}));
async function begin(size) {
    page.removeAllListeners('dialog');
    page.on('dialog', (dialog) => dialog.accept());
    await open('about:blank');
    await open(address, size);
    await ready();
    await settled();
}
const save = async () => {
    await page.keyboard.press('Control+s');
    await until('!workbench.document.isChanged');
};
const solved = (name) =>
    JSON.parse(
        execFileSync(program, ['solve', name, '--format', 'json', '-o', '-'], {
            encoding: 'utf8',
            stdio: ['ignore', 'pipe', 'ignore']
        })
    );
/** The results of two files whose points and bodies have other names but the same order. */
function assertSameMotion(one, other) {
    const near = (a, b, what) =>
        assert.ok(Math.abs(a - b) <= 1e-9 * Math.max(1, Math.abs(b)), `${what}: ${a} instead of ${b}`);
    for (const key of ['points', 'bodies']) {
        const [left, right] = [one, other].map((each) => Object.entries(each[key]));
        assert.equal(left.length, right.length);
        for (const [name, values] of left)
            for (const [what, value] of Object.entries(values))
                [value].flat().forEach((each, i) => near(each, [other[key][name][what]].flat()[i], `${name} ${what}`));
    }
}

test('the four-bar of the README is built by mouse, and saved solves to the same results', async () => {
    await begin();
    await tool('link');
    await clickAt([0, 0]);
    await clickAt([20, 30]);
    await clickAt([160, 80]);
    await clickAt([150, 0]);
    await page.keyboard.press('Escape');
    await tool('ground');
    await clickAt([0, 0]);
    await clickAt([150, 0]);
    await tool('driver');
    await clickAt([10, 15]);
    await settled();
    await fill('omega', '-120 rpm');
    // Names and lengths, in the panel.
    await tool('select');
    for (const [at, name] of [[[0, 0], 'O2'], [[150, 0], 'O4'], [[20, 30], 'A'], [[160, 80], 'B']]) {
        await clickAt(at);
        await fill('name', name);
    }
    const middle = ([a, b], [c, d]) => [(a + c) / 2, (b + d) / 2];
    await clickAt(middle([0, 0], [20, 30]));
    await fill('length-O2-A', '40');
    await fill('angle-O2-A', '60');
    const spots = () => run('workbench.spots');
    await clickAt(middle((await spots()).A, (await spots()).B));
    await fill('length-A-B', '150');
    await clickAt(middle((await spots()).O4, (await spots()).B));
    await fill('length-B-O4', '80');
    const built = await file();
    assert.deepEqual(built.points.A, {from: 'O2', distance: 40, angle: 60});
    assert.deepEqual(built.points.B, {meet: [{circle: 'A', radius: 150}, {circle: 'O4', radius: 80}], side: 'left'});
    assert.match(await page.locator('#status').textContent(), /^✓ solved in \d+ ms, check agrees/);
    assert.equal(await page.locator('#figures figure').count(), 2);
    await save();
    assert.equal(readFileSync(path, 'utf8'), await text());
    assertSameMotion(solved(path), solved(join(examples, 'four_bar.json')));
    assert.deepEqual(messages, []);
});

test('the lesson leads to a four-bar in six steps, each of which goes on when it is done', async () => {
    await begin();
    await page.locator('#more').click();
    await page.locator('#begin-lesson').click();
    const step = async () => Number(/\d/.exec(await page.locator('#lesson-where').textContent())?.[0] ?? 0);
    const asked = () => page.locator('.asked').click();
    assert.equal(await step(), 1);
    await asked();
    for (const at of [[0, 0], [20, 30], [120, 70], [110, 0]]) await clickAt(at);
    await page.keyboard.press('Escape');
    assert.equal(await step(), 2);
    await asked();
    for (const at of [[0, 0], [110, 0]]) await clickAt(at);
    assert.equal(await step(), 3);
    await asked();
    await clickAt([10, 15]);
    await settled();
    assert.equal(await step(), 4);
    assert.match(await page.locator('#status').textContent(), /^✓ solved/);
    await asked();
    const [a, b] = Object.keys((await file()).points);
    await clickAt([10, 15]);
    await fill(`length-${a}-${b}`, '40');
    assert.equal(await step(), 5);
    await asked();
    assert.equal(await step(), 6);
    await asked();
    assert.match(await page.locator('#lesson-text').textContent(), /That was all/);
    assert.equal(await page.locator('.asked').count(), 0);
    await page.locator('#lesson-end').click();
    assert.equal(await page.locator('#lesson').isVisible(), false);
    assert.deepEqual(messages, []);
});

test('a four-bar is built by keyboard alone', async () => {
    await begin();
    await page.locator('#canvas').focus();
    await page.keyboard.press('l');
    for (const place of ['0, 0', '40 < 60']) {
        await page.keyboard.type(place);
        await page.keyboard.press('Enter');
    }
    await crossTo([100, 70]);
    await page.keyboard.press('Enter');
    await crossTo([110, 0]);
    await page.keyboard.press('Enter');
    await page.keyboard.press('Escape');
    await page.keyboard.press('g');
    await page.keyboard.press('Enter');
    await crossTo([0, 0]);
    await page.keyboard.press('Enter');
    await page.keyboard.press('d');
    await crossTo([0, 0]);
    await page.keyboard.press('Enter');
    await settled();
    const built = await file();
    assert.deepEqual(Object.values(built.points)[1], {from: Object.keys(built.points)[0], distance: 40, angle: 60});
    assert.equal(Object.keys(built.bodies).length, 3);
    assert.equal(built.joints.length, 4);
    assert.equal((await run('workbench.answer.mobility')).effective, 1);
    assert.match(await page.locator('#status').textContent(), /^✓ solved/);
    // The selected point moves by the grid; Delete removes it and what hangs on it.
    await page.keyboard.press('v');
    await crossTo([100, 70]);
    await page.keyboard.press('Enter');
    const before_ = await run('workbench.spots'),
        name = (await run('workbench.selection')).split('/')[2],
        grid = await run('workbench.view.grid');
    await page.keyboard.press('ArrowRight');
    await settled();
    assert.ok(Math.abs((await run('workbench.spots'))[name][0] - before_[name][0] - grid) < 1e-9);
    await page.keyboard.press('Delete');
    assert.equal(Object.keys((await file()).bodies).length, 1);
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    assert.deepEqual(await file(), built);
    await page.keyboard.press('Control+y');
    await page.keyboard.press('Control+y');
    assert.equal(Object.keys((await file()).bodies).length, 1);
    assert.deepEqual(messages, []);
});

test('a slider-crank with a weight and a force is built by mouse', async () => {
    await begin();
    await tool('link');
    for (const at of [[-80, 0], [-50, 40], [70, 0]]) await clickAt(at);
    await page.keyboard.press('Escape');
    await tool('ground');
    await clickAt([-80, 0]);
    await tool('slider');
    await clickAt([70, 0]);
    await clickAt([110, 0]);
    await tool('driver');
    await clickAt([-65, 20]);
    await tool('weight');
    await clickAt([10, 20]);
    await tool('load');
    await dragFromTo([70, 0], [20, 0]);
    await tool('select');
    await page.keyboard.press('Escape');
    await settled();
    const built = await file(), [first, second, third] = Object.keys(built.points);
    assert.deepEqual(built.joints[built.joints.length - 1], {prismatic: third, bodies: [4, 1], along: 0});
    assert.equal(built.masses['3'].mass, 1);
    assert.deepEqual(built.loads, [{force: 'F1', pin: third, magnitude: 100, along: 180}]);
    assert.equal(built.points[built.masses['3'].centre].from, second);
    // What balances is asked for at the driver.
    await page.getByRole('button', {name: 'Driver of 2'}).click();
    await page.getByLabel('Find what balances the loads here').check();
    await settled();
    assert.match(await page.locator('#status').textContent(), /^✓ solved/);
    // The length of the rod keeps the slider on its guide.
    await page.locator('#canvas').focus();
    await page.keyboard.press('Escape');
    await page.getByRole('button', {name: 'Link 3', exact: true}).click();
    await fill(`length-${second}-${third}`, '140');
    const {meet} = (await file()).points[third];
    assert.deepEqual(meet, [{circle: second, radius: 140}, {line: [70, 0], angle: 0}]);
    assert.deepEqual((await run('workbench.answer')).faults, []);
    assert.ok(first);
    assert.deepEqual(messages, []);
});

/** Takes places by the cross of the canvas, with Enter; Escape ends what is drawn. */
async function enterAt(...places) {
    for (const at of places) {
        await crossTo(at);
        await page.keyboard.press('Enter');
    }
}
const near = (value, wanted, what = '') =>
    assert.ok(Math.abs(value - wanted) < 1e-9 * Math.max(1, Math.abs(wanted)), `${what}: ${value}, not ${wanted}`);
const valuesByName = async () =>
    Object.fromEntries((await run('workbench.answer.values')).map(({name, value}) => [name, value]));
/** The forces in the bars of a truss of five points on a span of 160, height 60, with 100 N in the middle below. */
async function isTruss() {
    await settled();
    assert.match(await page.locator('#status').textContent(), /^✓ solved/);
    const values = await valuesByName(), [a, b, c, d, e] = Object.keys((await file()).points);
    const bar = (one, other) => values[`bar ${one}${other}`];
    // By hand: 50 N in each support; the slanting bars rise 60 over 50 and 60 over 30.
    near(bar(a, b), -50 * Math.hypot(50, 60) / 60);
    near(bar(a, e), 50 * 50 / 60);
    near(bar(b, e), 50 * Math.hypot(30, 60) / 60);
    near(bar(b, c), -(50 * 50 / 60 + 50 * 30 / 60));
    near(bar(c, d), bar(a, b));
}
const round = [[-80, 0], [-30, 60], [30, 60], [80, 0], [0, 0], [-80, 0]];

test('a truss on a roller is built by mouse, and its bars have their forces', async () => {
    await begin();
    await tool('link');
    for (const at of round) await clickAt(at);
    await page.keyboard.press('Escape');
    await dragFromTo([0, 0], [-30, 60]);
    await dragFromTo([0, 0], [30, 60]);
    await tool('ground');
    await clickAt([-80, 0]);
    await tool('roller');
    await clickAt([80, 0]);
    await tool('load');
    await clickAt([0, 0]);
    await clickAt([0, -50]);
    await isTruss();
    assert.ok(await numbersApart() > 24);
    assert.equal(await run('getSelection().toString()'), '');
    const {joints} = await file();
    assert.equal(joints.filter((each) => each.contact).length, 1);
    assert.deepEqual(messages, []);
});

/** Of the numbers of bodies on the canvas, the smallest distance, pixels. */
const numbersApart = () => run(`(() => {
    const at = [...document.querySelectorAll('#canvas .tag circle')].map((each) => [each.cx, each.cy].map((one) => one.baseVal.value));
    return Math.min(...at.flatMap(([x, y], i) => at.slice(i + 1).map(([u, v]) => Math.hypot(x - u, y - v))));
})()`);
test('a geared five-bar is built by mouse: links are pinned to wheels where these are clicked', async () => {
    await begin();
    await tool('gear');
    for (const at of [[-40, 0], [40, 0]]) await clickAt(at);
    await tool('ground');
    for (const at of [[-40, 0], [40, 0]]) await clickAt(at);
    await tool('link');
    for (const at of [[-20, 20], [0, 80], [60, 30]]) await clickAt(at);
    await page.keyboard.press('Escape');
    await settled();
    assert.match(await page.locator('#status').textContent(), /^✓ solved/);
    await tool('driver');
    await clickAt([-60, -10]);
    await settled();
    const {bodies, points, drivers} = await file(), [first, second] = Object.keys(bodies);
    assert.deepEqual(drivers, [{body: Number(first), omega: 10}]);
    assert.deepEqual([bodies[first].length, bodies[second].length], [2, 2]);
    assert.deepEqual([points[bodies[first][1]], points[bodies[second][1]]], [[-20, 20], [60, 30]]);
    near((await valuesByName())[`omega ${second}`], -10);
    assert.deepEqual(messages, []);
});

test('a pin that was drawn on a bar becomes the pin of a slot in it', async () => {
    await begin();
    await tool('link');
    for (const at of [[0, -80], [60, 90]]) await clickAt(at);
    await page.keyboard.press('Escape');
    for (const at of [[0, 0], [39, 31]]) await clickAt(at);
    await page.keyboard.press('Escape');
    await tool('ground');
    for (const at of [[0, -80], [0, 0]]) await clickAt(at);
    const pin = (await run('workbench.model.points')).at(-1).name;
    await tool('slot');
    await clickAt((await run('workbench.spots'))[pin]);
    await clickAt([0, -80]);
    await tool('driver');
    await clickAt([20, 16]);
    await settled();
    const {bodies, joints} = await file(), [rocker, crank] = Object.keys(bodies);
    assert.deepEqual(joints.filter((each) => Object.values(each)[0] === pin),
        [{'pin-slot': pin, bodies: [Number(crank), Number(rocker)], along: [bodies[rocker][0], pin]}]);
    assert.equal(bodies[rocker].includes(pin), false);
    assert.match(await page.locator('#status').textContent(), /^✓ solved/);
    assert.deepEqual(messages, []);
});

test('a planet wheel on its arm, and a lever on a spring from a fixed place, are built by mouse', async () => {
    await begin();
    await tool('link');
    for (const at of [[0, 0], [60, 0]]) await clickAt(at);
    await page.keyboard.press('Escape');
    await tool('ground');
    await clickAt([0, 0]);
    await tool('gear');
    for (const at of [[0, 0], [60, 0]]) await clickAt(at);
    await settled();
    const {bodies, joints} = await file(), [arm, sun, planet] = Object.keys(bodies).map(Number);
    assert.deepEqual(joints.map(({bodies: all}) => all), [[1, arm, sun], [arm, planet], [sun, planet]]);
    assert.equal((await run('workbench.answer.mobility')).effective, 2);
    assert.match(await page.locator('#status').textContent(), /^✓ solved|2 not driven/);
    // The sun is held, the arm turns with 10: the planet, as large, turns with 20.
    await tool('ground');
    await clickAt([-15, -10]);
    await tool('driver');
    await clickAt([40, 1]);
    await settled();
    near((await valuesByName())[`omega ${planet}`], 20);

    await begin();
    await tool('link');
    for (const at of [[-80, 0], [80, 0]]) await clickAt(at);
    await page.keyboard.press('Escape');
    await tool('ground');
    await clickAt([-80, 0]);
    await tool('spring');
    for (const at of [[0, 0], [0, -60]]) await clickAt(at);
    await settled();
    const lever = await file();
    assert.deepEqual(lever.loads.map(({spring, bodies: pair}) => [spring, pair]), [['S1', [2, 1]]]);
    const {faults, remarks} = await run('workbench.answer');
    assert.deepEqual([faults, remarks], [[], []]);
    assert.deepEqual(messages, []);
});

test('a truss is built by the keyboard alone', async () => {
    await begin();
    await page.locator('#canvas').focus();
    await page.keyboard.press('l');
    await enterAt(...round);
    await page.keyboard.press('Escape');
    for (const top of [[-30, 60], [30, 60]]) {
        await enterAt([0, 0], top);
        await page.keyboard.press('Escape');
    }
    await page.keyboard.press('g');
    await enterAt([-80, 0]);
    await page.keyboard.press('u');
    await enterAt([80, 0]);
    await page.keyboard.press('f');
    await enterAt([0, 0], [0, -50]);
    await isTruss();
    assert.deepEqual(messages, []);
});

test('a slider-crank is built by the keyboard alone', async () => {
    await begin();
    await page.locator('#canvas').focus();
    await page.keyboard.press('l');
    await enterAt([-80, 0], [-50, 40], [70, 0]);
    await page.keyboard.press('Escape');
    await page.keyboard.press('g');
    await enterAt([-80, 0]);
    await page.keyboard.press('s');
    await enterAt([70, 0], [70, 0]);
    await page.keyboard.press('d');
    await enterAt([-80, 0]);
    await settled();
    const [, , third] = Object.keys((await file()).points);
    assert.match(await page.locator('#status').textContent(), /^✓ solved/);
    // omega 10: the pin moves with (−400, 300) mm/s; the rod from (−50, 40) to (70, 0) turns by 300/−120 = −2.5.
    near((await valuesByName())[`vx ${third}`], (-400 - 2.5 * 40) / 1000);
    assert.deepEqual(messages, []);
});

test('what is clamped, a couple, discs that slide and a law have tools', async () => {
    await begin();
    await tool('link');
    for (const at of [[0, 0], [100, 0]]) await clickAt(at);
    await page.keyboard.press('Escape');
    await tool('ground');
    await clickAt([0, 0]);
    await tool('weld');
    await clickAt([0, 0]);
    await tool('couple');
    await clickAt([50, 0]);
    await settled();
    const [a] = Object.keys((await file()).points);
    assert.deepEqual((await file()).joints, [{weld: a, bodies: [1, 2]}]);
    assert.match(await page.locator('#status').textContent(), /^✓ solved/);
    near((await valuesByName())[`C ${a} 1 on 2`], -10);

    await begin();
    await tool('contact');
    for (const at of [[0, 0], [60, 0]]) await clickAt(at);
    await settled();
    const {joints: [contact], points} = await file(), [p, q, at] = Object.keys(points);
    assert.deepEqual(contact, {contact: at, bodies: [2, 3], profiles: {2: {circle: p}, 3: {circle: q}}});

    await begin();
    await tool('link');
    for (const each of [[0, 0], [40, 30]]) await clickAt(each);
    await page.keyboard.press('Escape');
    await tool('ground');
    await clickAt([0, 0]);
    await tool('driver');
    await clickAt([20, 15]);
    await page.locator('#by-law').click();
    await settled();
    assert.deepEqual((await file()).drivers, [{body: 2, law: {form: 'cycloidal', turn: '90°', time: '1 s'}}]);
    assert.deepEqual((await run('workbench.answer')).faults, []);
    assert.deepEqual(messages, []);
});

test('a disc slides on a bar that is clicked, a profile is changed in the panel, and a link gets a colour', async () => {
    await begin();
    await tool('link');
    for (const at of [[0, 0], [100, 20]]) await clickAt(at);
    await page.keyboard.press('Escape');
    await tool('contact');
    await clickAt([50, 60]);
    await clickAt([40, 8]);
    await settled();
    const built = await file(), [a, b, centre, contact] = Object.keys(built.points);
    assert.deepEqual(built.points[contact],
        {meet: [{line: a, to: b}, {line: centre, perpendicular: [a, b]}]});
    assert.deepEqual(built.joints, [
        {contact, bodies: [3, 2], profiles: {3: {circle: centre}, 2: {line: [a, b]}}}]);
    const at = await run(`workbench.spots['${contact}']`);
    near(at[1] / at[0], 0.2);
    near((60 - at[1]) * 0.2, at[0] - 50);
    await tool('select');
    await run(`workbench.select('/joints/0')`);
    await page.locator('#profile-2').selectOption('tip');
    assert.deepEqual((await file()).joints[0].profiles[2], {tip: true});
    await page.locator('#profile-2').selectOption('line');
    assert.deepEqual((await file()).joints[0].profiles[2], {line: [a, b]});

    await run(`workbench.select('/bodies/2')`);
    const plainText = await text(), bar = () => run(`getComputedStyle(document.querySelector('#canvas .bar')).stroke`);
    await page.locator('#colour').fill('#7a1fa2');
    await settled();
    assert.deepEqual((await file()).bodies[2], {points: [a, b], colour: '#7a1fa2'});
    assert.equal(await bar(), 'rgb(122, 31, 162)');
    assert.deepEqual((await run('workbench.answer')).faults, []);
    await page.locator('#colour-of-theme').click();
    await settled();
    assert.deepEqual((await file()).bodies[2], [a, b]);
    assert.notEqual(await bar(), 'rgb(122, 31, 162)');
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    assert.equal(await text(), plainText, 'a colour that is chosen is one step of the history');
    assert.deepEqual(messages, []);
});

test('a field that was taken is undone with the file; a comma marks decimals where the language does', async () => {
    rmSync(path, {force: true});
    const {process: german, address: there} = await serve(program, path, '--lang', 'de');
    await open(there);
    await ready();
    await page.locator('#canvas').focus();
    await page.keyboard.press('l');
    for (const place of ['0,5; 0', '=10 + 30 < 60', '-20, 10']) {
        await page.keyboard.type(place);
        await page.keyboard.press('Enter');
    }
    await settled();
    const [a, b, c] = Object.keys((await file()).points), {points} = await file();
    assert.deepEqual([points[a], points[b], points[c]],
        [[0.5, 0], {from: a, distance: '=10 + 30', angle: 60}, [-20, 10]]);
    await run(`workbench.select('/bodies/2')`);
    for (const [typed, length] of [['1,5', 1.5], ['4,25 cm', '4.25 cm'], ['= 2*20 mm', '= 2*20 mm'], ['3.5', 3.5]]) {
        await fill(`length-${a}-${b}`, typed);
        assert.equal((await file()).points[b].distance, length);
        await page.keyboard.press('Control+z');
        await settled();
        assert.deepEqual((await file()).points, points, typed);
    }
    german.kill();
    assert.deepEqual(messages, []);
});

test('the selected point shows on the drawing how the file places it', async () => {
    await begin();
    await run(`workbench.open(${JSON.stringify(exampleText('four_bar.json'))}, 'four_bar.json', null)`);
    await settled();
    const shown = (point) => run(`new Promise((done) => {
        workbench.select('/points/${point}');
        requestAnimationFrame(() => requestAnimationFrame(() => done({
            notes: [...document.querySelectorAll('.placing text')].map((each) => each.textContent.trim()),
            arcs: document.querySelectorAll('.placing .curve').length})));
    })`);
    assert.deepEqual(await shown('B'), {notes: ['150 mm', '80 mm'], arcs: 2});
    assert.deepEqual(await shown('A'), {notes: ['40 mm  ∠ 60°'], arcs: 0});
    assert.deepEqual(await shown('O2'), {notes: [], arcs: 0});
    assert.deepEqual(messages, []);
});

test('a window that is turned or made smaller shows all of what it showed', async () => {
    await begin({width: 1366, height: 768});
    await run(`workbench.open(${JSON.stringify(exampleText('four_bar.json'))}, 'four_bar.json', null)`);
    await settled();
    for (const [width, height] of [[820, 1180], [390, 844], [844, 390], [1366, 768]]) {
        await page.setViewportSize({width, height});
        await until('workbench.seesAll() && Math.abs(workbench.view.width - document.getElementById("canvas").clientWidth) < 1');
    }
    assert.deepEqual(messages, []);
});

test('by touch: points are placed, two fingers zoom', async () => {
    await begin({width: 390, height: 844});
    await page.locator('[data-tool=link]').tap();
    for (const at of [[-80, 0], [0, 60], [80, 0]]) await page.touchscreen.tap(...await onScreen(at));
    assert.equal(Object.keys((await file()).bodies).length, 2);
    const scale = await run('workbench.view.scale'),
        [x, y] = await onScreen([0, 0]);
    const touch = (type, gap) =>
        protocol.send('Input.dispatchTouchEvent', {
            type,
            touchPoints:
                type === 'touchEnd'
                    ? []
                    : [
                          {x: x - gap, y, id: 1},
                          {x: x + gap, y, id: 2}
                      ]
        });
    await touch('touchStart', 30);
    for (const gap of [40, 50, 60]) await touch('touchMove', gap);
    await touch('touchEnd', 0);
    assert.ok(await run('workbench.view.scale') > 1.5 * scale);
    assert.equal(Object.keys((await file()).bodies).length, 2);
    assert.deepEqual(messages, []);
});

test('the text is the mechanism, both ways, and a fault stands at its place', async () => {
    await begin();
    await page.locator('#tab-file').click();
    const good = exampleText('four_bar.json'), area = page.locator('#text');
    await area.fill(good);
    await settled();
    assert.equal(await page.locator('[data-of="/points/B"]').count() > 0, true);
    const broken = good.replace('"radius": 80', '"radius": 8');
    await area.fill(broken);
    await settled();
    const fault = page.locator('#faults button');
    assert.match(await fault.textContent(), /^Line \d+ \/points\/B.*do not meet/);
    const line = broken.slice(0, broken.indexOf('"B":')).split('\n').length;
    assert.equal(await page.locator('#lines .faulty').textContent(), String(line));
    assert.match(await page.locator('#status').textContent(), /^Fault: /);
    await fault.click();
    assert.match(await area.evaluate((each) => each.value.slice(each.selectionStart, each.selectionEnd)), /^"B":/);
    await area.fill(broken.slice(0, 100));
    await settled();
    assert.match(await fault.textContent(), /JSON/);
    // What was drawn last stays while the text is broken.
    assert.equal(await page.locator('[data-of="/points/O2"]').count() > 0, true);
    await area.fill('<img src=x onerror=alert(1)>'.repeat(3));
    await settled();
    assert.equal(await page.locator('#faults img').count(), 0);
    // An edit on the canvas changes its own text alone.
    await area.fill(good);
    await settled();
    await tool('select');
    await dragFromTo([150, 0], [160, 0]);
    await settled();
    const from = await text();
    assert.match(from, /"O4": \[1[56]\d(\.\d+)?, (0|-?\d+(\.\d+)?)\]/);
    assert.equal(from.replace(/"O4": \[[^\]]*\]/, '"O4": [150, 0]'), good);
    assert.deepEqual(messages, []);
});

test('what is missing is said by the tools of the page, not by the keys of the file', async () => {
    await begin();
    const advice = page.locator('#advice'), status = page.locator('#status');
    const given = JSON.parse(exampleText('four_bar.json'));
    const opened = async (change) => {
        const file_ = structuredClone(given);
        change(file_);
        await page.evaluate((mine) => window.workbench.open(mine, 'mine.json', null), JSON.stringify(file_));
        await settled();
        const said = await page.evaluate(async (mine) => {
            const all = [];
            for (const lang of ['en', 'it', 'fr', 'de', 'es']) {
                const {remarks, unsolved} = await window.workbench.engine.answer({
                    text: mine, name: 'mine.json', want: ['position', 'mobility', 'values'], options: {lang}
                });
                all.push(...remarks, ...unsolved.map(({why}) => why));
            }
            return all;
        }, JSON.stringify(file_));
        for (const each of said) assert.doesNotMatch(each, /["{]/);
        assert.doesNotMatch(await status.textContent() + await advice.textContent(), /["{]/);
        return said.length;
    };
    const withoutHinge = (...points) => (file_) =>
        (file_.joints = file_.joints.filter(({revolute}) => !points.includes(revolute)));
    assert.ok(await opened((file_) => delete file_.drivers) > 0);
    assert.match(await status.textContent(), /1 not driven$/);
    assert.match(await advice.textContent(), /^Choose Driver \(D\)/);
    assert.ok(await opened((file_) => file_.drivers.push({body: 4, omega: 1}, {body: 3, omega: 1})) > 0);
    assert.match(await advice.textContent(), /3 drivers for 1 freedom.*press Delete/);
    assert.ok(await opened(withoutHinge('O2', 'O4')) > 0);
    assert.match(await advice.textContent(), /choose Ground pivot \(G\)/);
    assert.equal(await opened((file_) =>
        (file_.loads = [{force: 'F', body: 3, at: 'B', magnitude: 10, along: -90}])), 0);
    assert.match(await advice.textContent(), /^To find the forces/);
    // What is advised can be done, and mends it.
    assert.ok(await opened(withoutHinge('B')) > 0);
    assert.match(await advice.textContent(), /select B and press “Pin the links together”/);
    await run(`workbench.select('/points/B')`);
    await page.locator('#pin').click();
    await settled();
    assert.match(await status.textContent(), /^✓ solved/);
    assert.equal(await page.locator('#pin').count(), 0);
    assert.deepEqual((await file()).joints.at(-1), {revolute: 'B', bodies: [3, 4]});
    // A fault's remedy, which is of the file, stands where the file is shown.
    await opened((file_) => (file_.points.B = {meet: file_.points.B.meet}));
    assert.match(await status.textContent(), /^Fault: the circles meet twice\. What to do stands in File\.$/);
    assert.match(await page.locator('#faults').textContent(), /"side"/);
    assert.deepEqual(messages, []);
});

test('a file that was changed elsewhere is not written over unasked', async () => {
    writeFileSync(path, exampleText('four_bar.json'));
    await begin();
    assert.equal(await text(), exampleText('four_bar.json'));
    const elsewhere = exampleText('slider_crank.json');
    await page.locator('#title').fill('Mine');
    await page.keyboard.press('Enter');
    writeFileSync(path, elsewhere);
    await page.keyboard.press('Control+s');
    await page.locator('#question').waitFor();
    await page.getByRole('button', {name: 'Cancel'}).click();
    assert.equal(readFileSync(path, 'utf8'), elsewhere);
    await page.keyboard.press('Control+s');
    await page.locator('#question-yes').click();
    await until('!workbench.document.isChanged');
    assert.equal(readFileSync(path, 'utf8'), await text());
    assert.equal(JSON.parse(readFileSync(path, 'utf8')).title.en, 'Mine');
});

test('every example opens, shows no word of the page, and is unchanged when saved', async () => {
    await begin();
    const all = readdirSync(examples, {recursive: true})
        .filter((each) => each.endsWith('.json') && statSync(join(examples, each)).isFile())
        .filter((each) => 'kinegraph' in JSON.parse(exampleText(each)));
    assert.ok(all.length > 80);
    const listed = (await run(`fetch('examples.json').then((each) => each.json())`)).map((each) => each.path);
    assert.deepEqual(listed.sort(), all.map((each) => `examples/${each}`).sort());
    for (const each of all) {
        const given = exampleText(each);
        await page.evaluate(([given_, name]) => window.workbench.open(given_, name, given_), [given, each]);
        await settled();
        assert.equal(await text(), given, each);
        const {faults, failure} = await run('workbench.answer');
        assert.equal(failure, undefined);
        // The file of a cam is for another command.
        if (!('cam' in JSON.parse(given))) assert.deepEqual(faults, [], each);
        const points = Object.keys(JSON.parse(given).points ?? {});
        if (points.length > 0)
            assert.equal(
                await page.evaluate(
                    (name) => document.querySelectorAll(`[data-of="/points/${CSS.escape(name)}"]`).length > 0,
                    points[0]
                ),
                true,
                each
            );
    }
    assert.deepEqual(messages, []);
});

test('a link opens what it holds; a hostile one is said and does no harm', async () => {
    const linkOf = (content) => `#m=${deflateRawSync(content).toString('base64url')}`;
    const visit = async (fragment) => {
        await open('about:blank');
        await open(address + fragment);
        await ready();
    };
    await visit(linkOf(exampleText('slider_crank.json')));
    assert.equal(await text(), exampleText('slider_crank.json'));
    const bad = [
        linkOf(' '.repeat(5e7)),
        '#m=AAAA',
        '#m=not~deflate',
        `#m=${'A'.repeat(600000)}`,
        linkOf(Buffer.from([0xff, 0xfe, 0xfd]))
    ];
    for (const each of bad) {
        await visit(each);
        assert.match(await page.locator('#notice').textContent(), /holds no mechanism/);
        assert.equal(JSON.parse(await text()).title, 'Untitled mechanism');
    }
    for (const each of [
        '['.repeat(300000),
        '{"points": {"<b>": [0, 0]}, "title": "</script><script>alert(1)</script>"}',
        '{"__proto__": {"a": 1}, "points": {"__proto__": [0, 0]}}',
        '[]',
        '1'
    ]) {
        await visit(linkOf(each));
        await settled();
        assert.equal(await text(), each);
        assert.equal(await run('({}).a'), undefined);
    }
    assert.deepEqual(messages, []);
});

const pmks = '2P.Fe.K,0.1011.MA,A,0,0,0.GB,B,0,Fe,0.KC,C,ku,0,0.GD,D,0RF,Oj,0.HP,P,0,Fe,0,CD,C,D..' +
    'YRAB,AB,Fe,Fe,0,7q,c5cae9,A,B,,.YRCD,CD,Fe,Fe,9q,CN,303e9f,C,D,,.YPBP,BP,Fe,0,0,0,,B,P,,...N_r';
test('a link of PMKS+ is opened from the menu, by pasting and as a file, and what it changed is said', async () => {
    const paste = (what) => page.evaluate((text_) => {
        const clipboardData = new DataTransfer();
        clipboardData.setData('text/plain', text_);
        document.body.dispatchEvent(new ClipboardEvent('paste', {clipboardData, bubbles: true}));
    }, what);
    const fromMenu = async () => {
        await page.locator('#more').click();
        await page.locator('#from-pmks').click();
        await page.locator('#import-text').fill(`https://app.pmksplus.com/?${pmks}`);
        await page.locator('#import [value=yes]').click();
    };
    const byProgram = execFileSync(program, ['import', `?${pmks}`], {encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore']});
    const asFile = () => page.locator('#picker').setInputFiles(
        {name: 'crank.txt', mimeType: 'text/plain', buffer: Buffer.from(pmks)});
    for (const bring of [fromMenu, () => paste(` ${pmks}\n`), asFile]) {
        await begin();
        await bring();
        await page.locator('#question').waitFor();
        assert.match(await page.locator('#question-text').textContent(), /three decimals/);
        await page.locator('#question-yes').click();
        await until('workbench.model.points.length === 7');
        await settled();
        assert.match(await page.locator('#status').textContent(), /^✓ solved/);
        assert.equal(await text(), byProgram);
    }
    await paste(pmks.slice(0, -30) + pmks.slice(-20));
    await until(`!document.getElementById('notice').hidden`);
    assert.match(await page.locator('#notice').textContent(), /cut off or changed/);
    assert.deepEqual(messages, []);
});

/** Numbers from 0 to 1 that are the same in each run. */
function* random(seed) {
    for (let state = seed;;) {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        yield state / 2 ** 32;
    }
}
test('links and texts that anybody may send are answered, whatever stands in them', async (t) => {
    await begin();
    const count = Number(process.env.KINEGRAPH_LINKS ?? 1500), dice = random(37), next = (most) => Math.floor(dice.next().value * most);
    const packed = (what) => `#m=${deflateRawSync(what).toString('base64url')}`;
    const good = ['four_bar.json', 'exam_2001.json', 'planetary_train.json'].map(exampleText);
    const letters = '0123456789ABCXYZabcxyz_-.,{}[]":?&%# \\\u0000é∞';
    const changed = (what) => {
        let now = what;
        for (let i = 0; i <= next(4); ++i) {
            const at = next(now.length + 1), length = next(2) ? next(8) : 0, twice = now.slice(at, at + next(40));
            const put = [letters[next(letters.length)], '', twice, '9'.repeat(next(30)), '['.repeat(next(200))][next(5)];
            now = now.slice(0, at) + put + now.slice(at + length);
        }
        return now;
    };
    const links = Array.from({length: count}, (_, i) => {
        const from = good[i % good.length];
        return i % 3 === 0 ? {link: changed(packed(from))} : i % 3 === 1 ? {link: packed(changed(from))} :
            {pmks: changed(i % 2 ? pmks : `https://app.pmksplus.com/?${pmks}`)};
    });
    const {textOf} = await compiled('src/link.ts'), all = [];
    for (const each of links) {
        const start = performance.now(), opened = each.link === undefined ? null : await textOf(each.link);
        all.push({...each, opened, took: performance.now() - start});
    }
    const slowest = await page.evaluate(async (all_) => {
        const found = {ms: 0, text: '', opened: 0, imported: 0, solved: 0};
        for (const {link, pmks: sent, opened, took} of all_) {
            const start = performance.now() - took;
            const asked = sent === undefined ? opened : sent;
            const want = sent === undefined ? ['position', 'mobility', 'values'] : ['import'];
            const answer = asked === null ? null : await workbench.engine.answer({text: asked, name: 'any.json', want});
            if (answer?.failure) throw new Error(`${answer.failure}: ${asked}`);
            if (opened !== null) ++found.opened;
            if (answer?.imported) ++found.imported;
            if (answer?.values) ++found.solved;
            const ms = performance.now() - start;
            if (ms > found.ms) Object.assign(found, {ms, text: asked ?? link});
        }
        return found;
    }, all);
    t.diagnostic(`${count} links: ${slowest.opened} opened, ${slowest.solved} solved, ${slowest.imported} imported, ` +
        `the slowest took ${slowest.ms.toFixed(0)} ms`);
    assert.ok(slowest.ms < 5000, slowest.text);
    assert.ok(slowest.opened > count / 4 && slowest.solved > 0);
    // Some of them as a visitor meets them, in the address and pasted.
    for (const {link, pmks: sent} of links.slice(0, 60)) {
        await page.evaluate(([hash, text_]) => {
            if (hash) return void (location.hash = hash);
            const clipboardData = new DataTransfer();
            clipboardData.setData('text/plain', text_);
            document.body.dispatchEvent(new ClipboardEvent('paste', {clipboardData, bubbles: true}));
        }, [link ?? '', sent ?? '']);
        await settled();
        if (await page.locator('#question').isVisible()) await page.locator('#question [value=no]').click();
    }
    assert.equal(await page.locator('script:not([src]), #faults img, [onerror]').count(), 0);
    assert.deepEqual(messages, []);
});

test('it serves its page and its parts alone, to this machine alone, and takes requests of bounded size', async () => {
    writeFileSync(path, exampleText('four_bar.json'));
    writeFileSync(join(folder, 'secret.json'), '{}');
    const {port, pathname} = new URL(address),
        host = `Host: 127.0.0.1:${port}\r\n`;
    const ask = (bytes) =>
        new Promise((resolve) => {
            const socket = net.connect(Number(port), '127.0.0.1', () => socket.write(bytes));
            let heard = '';
            socket.on('data', (data) => (heard += data));
            socket.on('error', () => resolve(heard));
            socket.on('close', () => resolve(heard));
        });
    const post = (target, body, more = '') =>
        `POST ${target} HTTP/1.1\r\n${host}${more}Content-Length: ${Buffer.byteLength(body)}\r\n\r\n${body}`;
    const cases = [
        [`GET ${pathname} HTTP/1.1\r\n${host}\r\n`, 200],
        [`GET ${pathname}main.js HTTP/1.1\r\n${host}\r\n`, 200],
        [`GET ${pathname}examples/four_bar.json HTTP/1.1\r\n${host}\r\n`, 200],
        [`GET / HTTP/1.1\r\n${host}\r\n`, 404],
        [`GET ${pathname}secret.json HTTP/1.1\r\n${host}\r\n`, 404],
        [`GET ${pathname}../secret.json HTTP/1.1\r\n${host}\r\n`, 404],
        [`GET ${pathname}examples/../main.js HTTP/1.1\r\n${host}\r\n`, 404],
        [`GET ${pathname}answer HTTP/1.1\r\n${host}\r\n`, 405],
        [post(`${pathname}main.js`, '{}'), 405],
        [post('/answer', '{}'), 404],
        [post(`${pathname}answer`, '{}', 'Origin: https://evil.example\r\n'), 403],
        [post(`${pathname}save`, '{"text": "x", "base": null}', 'Origin: https://evil.example\r\n'), 403],
        [post(`${pathname}answer`, '{}').replace(/127.0.0.1/, 'evil.example'), 403],
        [`POST ${pathname}answer HTTP/1.1\r\n${host}\r\n`, 411],
        [`POST ${pathname}answer HTTP/1.1\r\n${host}Content-Length: 99999999\r\n\r\n`, 413],
        [`POST ${pathname}answer HTTP/1.1\r\n${host}Content-Length: -1\r\n\r\n`, 400],
        [`POST ${pathname}answer HTTP/1.1\r\n${host}Content-Length: 1x\r\n\r\n`, 400],
        [`POST ${pathname}answer HTTP/1.1\r\n${host}Transfer-Encoding: chunked\r\n\r\n0\r\n\r\n`, 411],
        [post(`${pathname}answer`, '{}'), 200],
        [post(`${pathname}answer`, '['.repeat(200000)), 200],
        [post(`${pathname}answer`, '"'), 200],
        [post(`${pathname}save`, '{"text": 1}'), 400],
        [post(`${pathname}save`, '{"text": "x", "base": "other"}'), 409]
    ];
    for (const [bytes, status] of cases)
        assert.match(await ask(bytes), new RegExp(`^HTTP/1.1 ${status} `), bytes.slice(0, 120));
    assert.equal(readFileSync(path, 'utf8'), exampleText('four_bar.json'));
    // One that gives up its question keeps nobody waiting.
    const long = post(
        `${pathname}answer`,
        JSON.stringify({text: exampleText('exam_2001.json'), name: 'x', want: ['live', 'sheet']})
    );
    for (let i = 0; i < 20; ++i)
        net.connect(Number(port), '127.0.0.1', function send() {
            this.write(long, () => this.destroy());
        });
    assert.match(await ask(post(`${pathname}answer`, '{"text": "", "want": ["words"]}')), /"untitled"/);
});

test('the modes show the solution: the live page in its tabs, the sheet as the program draws it', async () => {
    writeFileSync(path, exampleText('four_bar.json'));
    await begin();
    for (const mode of ['move', 'steps', 'try']) {
        await page.locator(`#go-${mode}`).click();
        const frame = page.frameLocator('#shown iframe');
        await frame.locator(`html[data-mode=${mode}]`).waitFor();
        assert.equal(await frame.locator('h1').first().isHidden(), true);
    }
    await page.locator('#go-sheet').click();
    await page.locator('#shown img').first().waitFor();
    const answer = await run(
        `workbench.engine.answer({text: workbench.document.text, name: 'four_bar.json',
            want: ['sheet', 'results', 'live'], options: {}})`
    );
    const told = (...more) =>
        execFileSync(program, ['solve', join(examples, 'four_bar.json'), '-o', '-', ...more], {encoding: 'utf8'});
    assert.equal(answer.sheet[0], told('--format', 'svg'));
    assert.equal(answer.results, told('--format', 'json'));
    assert.equal(answer.live, told('--format', 'html'));
    await page.locator('#go-build').click();
    assert.equal(await page.locator('#canvas').isVisible(), true);
    assert.deepEqual(messages, []);
});

test('an example is chosen by its picture; what is shown is taken away as SVG, PNG, TikZ, HTML, JSON, CSV and GeoGebra', async () => {
    await begin();
    let goesOn;
    const typed = new Promise((resolve) => (goesOn = resolve));
    await page.route('**/examples.json', async (route) => {
        await typed;  // the examples arrive after what is typed
        await route.continue();
    });
    await page.locator('#examples').click();
    await page.locator('#gallery-search').fill('whitworth');
    goesOn();
    const card = page.locator('.card:visible');
    await card.first().waitFor();
    assert.equal(await card.count(), 1);
    await card.locator('img').waitFor();
    await card.click();
    await until('workbench.document.name === "whitworth.json"');  // it is fetched first
    await settled();
    assert.equal(await text(), exampleText('whitworth.json'));
    const taken = async (kind) => {
        await page.locator('#more').click();
        const [file_] = await Promise.all([page.waitForEvent('download'), page.locator(`[data-take=${kind}]`).click()]);
        return {name: file_.suggestedFilename(), bytes: readFileSync(await file_.path())};
    };
    const told = (command, format) =>
        execFileSync(program, [command, join(examples, 'whitworth.json'), '-o', '-', '--format', format], {
            encoding: 'utf8',
            maxBuffer: 1e8,
            stdio: ['ignore', 'pipe', 'ignore']
        });
    for (const [kind, command, format] of [
        ['svg', 'solve', 'svg'],
        ['tex', 'solve', 'tex'],
        ['html', 'solve', 'html'],
        ['results', 'solve', 'json'],
        ['cycle', 'sweep', 'csv']
    ]) {
        const {name, bytes} = await taken(kind);
        assert.match(name, /^whitworth/);
        assert.equal(String(bytes), told(command, format), kind);
    }
    const archive = await taken('geogebra'), written = join(folder, 'whitworth.ggb');
    assert.equal(archive.name, 'whitworth.ggb');
    execFileSync(program, ['solve', join(examples, 'whitworth.json'), '-o', written], {stdio: 'ignore'});
    assert.deepEqual(unpacked(archive.bytes), unpacked(readFileSync(written)));
    assert.equal(String((await taken('json')).bytes), exampleText('whitworth.json'));
    const png = (await taken('png')).bytes;
    assert.equal(png.subarray(1, 4).toString(), 'PNG');
    assert.ok(png.readUInt32BE(16) > 2000);
    assert.deepEqual(messages, []);
});

test('the page speaks the language that is asked for', async (t) => {
    const french = await serve(program, join(folder, 'autre.json'), '--lang', 'fr');
    t.after(() => french.process.kill('SIGTERM'));
    await open(french.address);
    await ready();
    assert.equal(await page.locator('#go-build').textContent(), 'Construire');
    const seen = await run(
        `document.body.innerText +
            [...document.querySelectorAll('[aria-label]')].map((each) => each.getAttribute('aria-label')).join(' ')`
    );
    assert.doesNotMatch(seen, /\\~|\{\d\}|[a-z]_[a-z]/);
});

test('axe finds nothing, in light and dark, wide and on a phone, in each panel', async () => {
    writeFileSync(path, exampleText('four_bar_weights.json'));
    for (const size of [{width: 1366, height: 768}, {width: 390, height: 844, dark: true}]) {
        await begin(size);
        await page.evaluate(readFileSync(axe, 'utf8'));
        for (const act of ['#tab-properties', '#tab-file', '[data-tool=link]', '#more']) {
            await page.locator(act).click();
            const found = await run('axe.run(document, {resultTypes: ["violations"]})');
            assert.deepEqual(
                found.violations.map(({id, nodes}) => [id, nodes.map(({html}) => html.slice(0, 120))]),
                [],
                act
            );
        }
    }
});
