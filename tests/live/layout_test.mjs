// The page laid out for its screen: at every step its figure and its sentence are in view, at the sizes of projectors, laptops and
// phones, and at 200 % zoom; Next and Back within reach; hall mode.
// node layout_test.mjs PROGRAM EXAMPLES
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {close, messages, open, page as tab, run} from './browser.mjs';

const [program, examples] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'layout-test-'));
const names = ['four_bar', 'exam_2001', 'sluice_gate'], steps = {four_bar: 16, exam_2001: 52, sluice_gate: 7};
const pageOf = (name) => join(folder, `${name}.html`);
before(() => names.forEach((name) => execFileSync(program, ['solve', join(examples, `${name}.json`), '-o', pageOf(name)], {stdio: 'ignore'})));
after(async () => {
    await close();
    rmSync(folder, {recursive: true, force: true});
});

/** In the page: what of a node is cut off by the window or by what scrolls; null: nothing. */
const cutOff = `(node) => {
    const box = node.getBoundingClientRect(), limits = [{left: 0, top: 0, right: innerWidth, bottom: innerHeight}];
    for (let each = node.parentElement; each; each = each.parentElement) {
        if (getComputedStyle(each).overflowY !== 'visible') limits.push(each.getBoundingClientRect());
    }
    const isIn = limits.every(({left, top, right, bottom}) =>
        box.left >= left - 1 && box.top >= top - 1 && box.right <= right + 1 && box.bottom <= bottom + 1);
    return box.width > 0 && box.height > 0 && isIn ? null : JSON.stringify([box, ...limits]);
}`;
/** In the page: goes through all steps by its button, and tells what is not in view. */
const lookAtSteps = `(async () => {
    const cutOff = ${cutOff}, faults = [], button = (action) => document.querySelector('[data-action=' + action + ']');
    let step = 0;
    for (; step < 200; ++step) {
        await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
        const told = (what, where) => where === null || faults.push([step, what, where]);
        const sentences = document.querySelectorAll('[aria-current=step]'), figures = document.querySelectorAll('[data-shows=step]');
        if (sentences.length !== 1 || figures.length !== 1) faults.push([step, sentences.length, figures.length]);
        for (const node of [...sentences, ...figures, button('next'), button('back'), ...document.querySelectorAll('#position')])
            told(node.id || node.dataset.figureName || 'sentence', cutOff(node));
        for (const cell of sentences[0]?.querySelectorAll('td, th') ?? []) cell.offsetWidth === 0 || told('equation', cutOff(cell));
        for (const letter of sentences[0]?.querySelectorAll('.equation :is(sub, sup, i, b)') ?? []) {
            const {paddingLeft, borderBottomStyle} = getComputedStyle(letter);
            if (paddingLeft !== '0px' || borderBottomStyle !== 'none') faults.push([step, 'letters of a symbol are apart']);
        }
        const {width, height} = figures[0].querySelector('svg.drawing').getBoundingClientRect();
        if (Math.min(width, height) < 60) faults.push([step, 'small figure', width, height]);
        const strokes = [...document.querySelectorAll('[data-shows=step] .now, .shown .now')].filter((each) =>
            getComputedStyle(each).visibility === 'hidden' && each.getBoundingClientRect().width > 0 && !each.closest('.twin, .still, .aside'));
        if (strokes.length > 0) faults.push([step, 'strokes are hidden', strokes[0].outerHTML.slice(0, 100)]);
        if (button('back').disabled !== (step === 0)) faults.push([step, 'back']);
        if (button('next').disabled) break;
        button('next').click();
    }
    const isWider = document.documentElement.scrollWidth > innerWidth || document.body.scrollHeight > innerHeight;
    return {steps: step + 1, faults, isWider};
})()`;
const sizes = [[1024, 768], [1366, 768], [1920, 1080], [390, 844]];
for (const zoom of [1, 2]) {
    for (const [width, height] of sizes) {
        for (const name of names) {
            test(`every step of ${name} has its figure and its sentence in view at ${width} × ${height}, ${100 * zoom} %`, async () => {
                await open(`file://${pageOf(name)}`, {width: Math.floor(width / zoom), height: height / zoom});
                const found = await run(lookAtSteps);
                assert.deepEqual(found.faults, []);
                assert.equal(found.steps, steps[name]);
                assert.equal(found.isWider, false);
                assert.deepEqual(messages, []);
            });
        }
    }
}

/** In the page: the largest area, mm², that a label of a layer shares with one of another layer. */
const labelsOnEachOther = `(() => {
    const rim = 0.3, all = [...document.querySelectorAll('main:not([hidden]) figure.shown svg.fitted g.label')].filter((each) =>
        !each.closest('.twin, .dimension, .detail, .still') && getComputedStyle(each).visibility !== 'hidden').map((each) => {
        const {left, right, top, bottom} = each.getBoundingClientRect(), mm = each.ownerSVGElement.getScreenCTM().a;
        return {figure: each.closest('figure'), name: each.dataset.label, left: left / mm + rim, right: right / mm - rim,
            top: top / mm + rim, bottom: bottom / mm - rim};
    });
    const worst = {area: 0, names: ''};
    all.forEach((a, i) => all.slice(i + 1).filter((b) => b.figure !== a.figure).forEach((b) => {
        const wide = Math.min(a.right, b.right) - Math.max(a.left, b.left), tall = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
        if (wide > 0 && tall > 0 && wide * tall > worst.area) Object.assign(worst, {area: wide * tall, names: a.name + ' on ' + b.name});
    }));
    return {...worst, count: all.length};
})()`;
for (const name of ['four_bar', 'exam_2001']) {
    test(`layers of ${name} lie exactly on each other, and their labels do not`, async (t) => {
        await open(`file://${pageOf(name)}`, {width: 1366, height: 768});
        await run(`kinegraph.setMode('move'), ['centres', 'velocities'].forEach((each) => kinegraph.stage.isOn(each) || kinegraph.stage.turn(each))`);
        assert.ok(await run('kinegraph.stage.stacked.length') > 1);
        const {samples} = {samples: await run('kinegraph.course.samples.map(({at}) => at)')};
        let most = {area: 0};
        for (let i = -1; i < 12; ++i) {
            if (i >= 0) await run(`kinegraph.moveTo(${samples[0] + (samples[samples.length - 1] - samples[0]) * (i + 0.37) / 12})`);
            const boxes = await run(`kinegraph.stage.stacked.map((each) => {
                const view = kinegraph.figures.find(({svg}) => each.contains(svg)), {x, y} = view.point(0);
                return (({x, y}) => [x, y])(new DOMPoint(x, y).matrixTransform(view.svg.getScreenCTM()));
            })`);
            for (const [x, y] of boxes) assert.ok(Math.hypot(x - boxes[0][0], y - boxes[0][1]) < 0.5, JSON.stringify(boxes));
            const found = await run(labelsOnEachOther);
            assert.ok(found.count > 8);
            if (found.area > most.area) most = found;
        }
        t.diagnostic(JSON.stringify(most));
        assert.ok(most.area < 1, JSON.stringify(most));
        assert.deepEqual(messages, []);
    });
}

test('hall mode shows one statement and announces the next strokes; a remote control goes on and back', async () => {
    await open(`file://${pageOf('four_bar')}`, {width: 1280, height: 720});
    await run('kinegraph.showStep(6), document.getElementById("hall").click()');
    await tab.mouse.move(300, 300);
    const look = () => run(`({
        sentences: [...document.querySelectorAll('main:not([hidden]) li')].filter((each) => each.offsetHeight > 0).length,
        size: parseFloat(getComputedStyle(document.querySelector('li.now')).fontSize), step: kinegraph.step,
        next: [...document.querySelectorAll('.shown svg .next')].filter((each) => getComputedStyle(each).visibility === 'visible').length,
        pointer: (({width, left}) => ({width, left}))(document.getElementById('pointer').getBoundingClientRect()),
        cut: [document.querySelector('li.now'), document.querySelector('[data-shows=step]')].map(${cutOff}),
    })`);
    const at6 = await look();
    assert.equal(at6.sentences, 1);
    assert.ok(at6.size >= 26, String(at6.size));
    assert.ok(at6.next > 3, String(at6.next));
    assert.ok(at6.pointer.width > 25 && Math.abs(at6.pointer.left + at6.pointer.width / 2 - 300) < 1, JSON.stringify(at6.pointer));
    assert.deepEqual(at6.cut, [null, null]);
    await tab.keyboard.press('PageDown');
    assert.equal((await look()).step, 7);
    await tab.keyboard.press('PageUp');
    assert.equal((await look()).step, 6);
    await tab.keyboard.press('Escape');
    assert.equal(await run('document.querySelectorAll(".hall, #pointer").length'), 0);
    assert.deepEqual(messages, []);
});

test('printed, nothing is cut and no control is left', async () => {
    await open(`file://${pageOf('exam_2001')}`, {width: 1024, height: 700});
    await run('kinegraph.showStep(20), dispatchEvent(new Event("beforeprint"))');
    await tab.emulateMedia({media: 'print'});
    const found = await run(`({
        controls: [...document.querySelectorAll('button, select, input')].filter((each) => each.offsetHeight > 0).map(({id}) => id),
        figures: document.querySelectorAll('main:not([hidden]) .figures > figure').length,
        printed: [...document.querySelectorAll('main:not([hidden]) .figures > figure svg.drawing')].filter((each) => each.clientHeight > 40).length,
        cut: [...document.querySelectorAll('main:not([hidden]) :is(td, th, pre, li, h2, figcaption, svg.drawing)')].filter((each) => {
            const {left, right, width} = each.getBoundingClientRect();
            return width > 0 && (left < -1 || right > innerWidth + 1 || each.scrollWidth > each.clientWidth + 1 && each.clientWidth > 0);
        }).map((each) => each.outerHTML.slice(0, 80)),
        hidden: [...document.querySelectorAll('main:not([hidden]) svg .later')].filter((each) => getComputedStyle(each).visibility === 'hidden').length,
        sentences: [...document.querySelectorAll('main:not([hidden]) li')].filter((each) => each.offsetHeight > 0).length,
    })`);
    await tab.emulateMedia({media: 'screen'});
    assert.deepEqual(found, {controls: [], figures: 15, printed: 15, cut: [], hidden: 0, sentences: 52});
    await run('dispatchEvent(new Event("afterprint"))');
    assert.deepEqual(messages, []);
});
