// The live page, in node and in Chromium: that its interpreter says what the sweep says, that its figures follow and come back,
// and that a reader's hand and keys do what they should; then `kinegraph watch`.   node live_test.mjs PROGRAM EXAMPLES
import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import {createRequire} from 'node:module';
import {existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';
import {fileURLToPath} from 'node:url';
import {close, messages, open as openAt, page as tab, protocol, run as see} from './browser.mjs';
import {differences, kindOf, readPage} from './page.mjs';
import './cam_test.mjs';
import './watch_test.mjs';

const [program, examples] = process.argv.slice(2);
/** A mechanism of ours, with an angle of a plate, a root and a zero among its parameters. */
const pressFile = fileURLToPath(new URL('press.json', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'live-test-'));
after(async () => {
    await close();
    rmSync(folder, {recursive: true, force: true});
});

const run = (...words) => execFileSync(program, words, {stdio: ['ignore', 'pipe', 'ignore']});
function pageOf(name, file = join(examples, `${name}.json`), ...options) {
    const out = join(folder, `${name}.html`);
    if (!existsSync(out)) {
        const {status} = spawnSync(program, ['solve', file, ...options, '-o', out]);
        assert.ok([0, 3].includes(status), `${file}: status ${status}`);  // 3: some of it has no answer, as at a dead point
    }
    return out;
}
/** The page as it opens, at its first step. */
async function openToRead(path, options) {
    await openAt(`file://${path}`, options);
    assert.equal(await see('document.documentElement.dataset.ready'), 'true');
}
/** The page with all of its figures, moving where it can. */
async function open(path, options) {
    await openToRead(path, options);
    await see(`kinegraph.setMode('move'), kinegraph.stage.setApart(true)`);
}
const quiet = () => assert.deepEqual(messages, []);

// --- the interpreter ----------------------------------------------------------------------------------------------------------

/** The rows of an example's cycle; null where nothing moves it alone. Status 3 says that rows are left out. */
function sweepOf(name) {
    const words = ['sweep', join(examples, `${name}.json`), '--steps', '72', '-o', '-', '--format', 'json'];
    const {status, stdout} = spawnSync(program, words, {maxBuffer: 1e8});
    return stdout.length > 0 && [0, 3].includes(status) ? JSON.parse(stdout) : null;
}

test('every value of every example in 72 positions is the sweep\'s', () => {
    const names = readdirSync(examples).filter((file) => file.endsWith('.json')).map((file) => file.slice(0, -5));
    let moving = 0;
    for (const name of names) {
        const sweep = sweepOf(name);
        if (!sweep) continue;
        ++moving;
        const page = readPage(pageOf(name));
        const found = differences(page, sweep);
        assert.deepEqual(found.missing, [], name);
        assert.ok(found.compared >= 60 * page.data.moving.columns.length, `${name}: ${found.compared} values`);
        assert.ok(found.worst.share <= 1e-9, `${name}: ${JSON.stringify(found.worst)}`);
        assert.ok(Buffer.byteLength(page.html) <= ({four_bar: 330e3, exam_2001: 640e3}[name] ?? 1e6), name);
    }
    assert.ok(moving >= 50, `${moving} examples`);
});

test('three times the load is three times the forces, and nothing else', () => {
    const {data, Motion} = readPage(pageOf('cutting_force')), motion = new Motion(data.moving);
    const load = motion.data.settings.findIndex(({name}) => name === 'F_cut');
    const values = () => motion.data.columns.map((_, i) => motion.value(i));
    const once = values();
    motion.settings[load] *= 3;
    motion.moveTo(motion.course, 0);
    const thrice = values();
    motion.data.columns.forEach(({name}, i) => {
        const factor = /^(Fx|Fy|M|effort) /.test(name) ? 3 : 1;
        assert.ok(Math.abs(thrice[i] - factor * once[i]) <= 1e-9 * Math.max(Math.abs(once[i]), 1), name);
    });
    assert.ok(once.some((value, i) => Math.abs(thrice[i] - value) > 1));
});

// --- other lengths --------------------------------------------------------------------------------------------------------------

/** A page's motion with settings by name; in the units of the panel. */
function changed(name, file, values) {
    const page = readPage(pageOf(name, file)), {settings} = page.data.moving, motion = new page.Motion(page.data.moving);
    for (const each of Object.keys(values)) assert.ok(settings.some((setting) => setting.name === each), each);
    const isClosed = motion.give(settings.map(({name: each, value, size}) => each in values ? values[each] * size : value));
    return {page, motion, isClosed};
}
for (const [name, values] of [
    ['four_bar', {r: 45, l: 160, d: 140, n: -90}], ['slider_crank', {r: 60, e: -15, w: 8}], ['quick_return', {r: 70, h: 160}],
    ['exam', {l: 700, a: 450, w: -2}], ['six_bar', {r: 45, x: 250}], ['planetary_train', {m: 3}],
    ['press', {gamma: 50, c: 110, r: 40, F: 500}],
]) {
    test(`${name} with ${JSON.stringify(values)} is what the file with them is`, () => {
        const file = name === 'press' ? pressFile : join(examples, 'variants', `${name}.json`);
        const {page, motion, isClosed} = changed(`variant_${name}`, file, values);
        assert.ok(isClosed);
        const {columns, settings} = page.data.moving, unit = (each) => settings.find((setting) => setting.name === each).unit;
        const set = Object.entries(values).flatMap(([each, value]) => ['--set', `${each}=${value} ${unit(each)}`]);
        const sweep = JSON.parse(run('sweep', file, ...set, '--steps', '36', '-o', '-', '--format', 'json'));
        const largest = new Map(), offsets = new Map();
        let compared = 0;
        columns.forEach((column) => {
            const k = sweep.columns.indexOf(column.name);
            const sizes = sweep.rows.map((row) => Math.abs(row[k]));
            if (k >= 0) largest.set(kindOf(column), Math.max(largest.get(kindOf(column)) ?? 1e-3, ...sizes));
        });
        for (const row of sweep.rows) {
            assert.ok(motion.moveTo(motion.courses[0], row[0]), String(row[0]));
            columns.forEach((column, i) => {
                const k = sweep.columns.indexOf(column.name), value = motion.value(i);
                if (k < 0 || value === null) return;  // where a verdict drowns in doubles only the drawn lengths are known exactly
                let off = value - row[k];
                if (column.kind === 'slid' || column.kind === 'angle') {  // counted from where the file draws it
                    if (!offsets.has(i)) offsets.set(i, off);
                    off -= offsets.get(i);
                }
                ++compared;
                assert.ok(Math.abs(off) <= 1e-9 * largest.get(kindOf(column)), `${column.name} at ${row[0]}: ${value}, ${row[k]}`);
            });
        }
        const common = columns.filter(({name: each}) => sweep.columns.includes(each));
        assert.ok(compared >= 0.95 * sweep.rows.length * common.length, String(compared));
    });
}

test('bars are as long as they are told to be, the crank that turned then rocks, and what cannot close changes nothing', () => {
    const {page, motion, isClosed} = changed('four_bar', undefined, {O2A: 60, O2O4: 190});
    assert.ok(isClosed);
    const {points} = page.data.names, at = (name) => motion.read.points[points.findIndex(({label}) => label === name)];
    const length = (a, b) => 1000 * Math.hypot(at(a).x - at(b).x, at(a).y - at(b).y);
    const [course] = motion.courses;
    assert.ok(course.startsAtLimit && course.endsAtLimit);
    for (const where of [course.from, 0, course.to]) {
        assert.ok(motion.moveTo(course, where));
        for (const [a, b, wanted] of [['O_2', 'A', 60], ['A', 'B', 150], ['O_4', 'B', 80], ['O_2', 'O_4', 190]]) {
            assert.ok(Math.abs(length(a, b) - wanted) < 1e-8, `${a}${b} ${length(a, b)}`);
        }
    }
    // At its limits rod and rocker are in line: 230 from A to O4.
    const reach = Math.acos((190 ** 2 + 60 ** 2 - 230 ** 2) / (2 * 190 * 60));
    motion.moveTo(course, course.to);
    assert.ok(Math.abs(Math.atan2(at('A').y, at('A').x) - reach) < 1e-4);
    const before = [motion.at, ...motion.settings, length('A', 'B')];
    const {settings} = page.data.moving, rocker = settings.findIndex(({name}) => name === 'BO4');
    assert.equal(motion.give(motion.settings.map((value, i) => i === rocker ? 0.5 : value)), false);
    assert.deepEqual([motion.at, ...motion.settings, length('A', 'B')], before);
    const values = (of) => of.data.columns.map((_, i) => of.value(i)), fresh = changed('four_bar', undefined, {}).motion;
    for (const each of [motion, fresh]) each.toDrawn();
    assert.equal(motion.courses[0].endsAtLimit, false);
    assert.deepEqual(values(motion), values(fresh));
});

// --- no work piles up, as it is drawn -----------------------------------------------------------------------------------------------

for (const name of ['watt_six_bar', 'exam_2001']) {
    test(`the frames of ${name} change as many attributes the second time as the first`, async (t) => {
        await protocol.send('Performance.enable', {timeDomain: 'threadTicks'});
        await open(pageOf(name));
        const spent = async () => {
            const {metrics} = await protocol.send('Performance.getMetrics');
            return 1000 * metrics.find((each) => each.name === 'ScriptDuration').value;
        };
        const frames = 24;
        const changes = () => see(`new Promise((done) => {
            const {samples} = kinegraph.course;
            let changes = 0;
            const observer = new MutationObserver((records) => (changes += records.length));
            observer.observe(document.body, {attributes: true, childList: true, characterData: true, subtree: true});
            const frame = (i) => i < ${frames} ? setTimeout(() => (kinegraph.moveTo(samples[3 * i].at + 0.001), frame(i + 1)))
                : setTimeout(() => (observer.disconnect(), done(changes)));
            frame(0);
        })`);
        await changes();  // the first frame begins where the drawing stands, the others where the last one ended
        const before = await spent();
        const first = await changes(), again = await changes();
        t.diagnostic(`${((await spent() - before) / (2 * frames)).toFixed(2)} ms of script and ${first / frames} changes a frame`);
        await protocol.send('Performance.disable');
        assert.ok(first > frames, `${first} changes`);
        assert.equal(again, first);
        quiet();
    });
}

test('as drawn, every figure on the screen is the one of the sheet', async (t) => {
    await open(pageOf('watt_six_bar'), {width: 1600, height: 1200});
    await see('kinegraph.moveTo(1), document.getElementById("drawn").click()');
    const dpi = 150;
    for (const figure of ['mechanism', 'centres', 'velocity', 'acceleration']) {
        const sheet = join(folder, `${figure}.png`), shown = join(folder, `${figure}-live.png`);
        run('solve', join(examples, 'watt_six_bar.json'), '--figure', figure, '-o', sheet, '--dpi', String(dpi));
        const png = readFileSync(sheet), [width, height] = [png.readUInt32BE(16), png.readUInt32BE(20)];
        await see(`(() => {
            const svg = document.querySelector('main:not([hidden]) [data-figure-name=${figure}] svg'), {style} = svg;
            document.body.style.visibility = 'hidden';
            style.cssText = 'visibility: visible; position: fixed; left: 0; top: 0; z-index: 9; height: auto; width: ' +
                svg.viewBox.baseVal.width * ${dpi} / 25.4 + 'px';
        })()`);
        writeFileSync(shown, await tab.screenshot({clip: {x: 0, y: 0, width, height}}));
        await see(`document.querySelector('main:not([hidden]) [data-figure-name=${figure}] svg').style.cssText = ''`);
        const {status, stdout, stderr} = spawnSync(program, ['diff', sheet, shown, '--threshold', '1%'], {encoding: 'utf8'});
        t.diagnostic(`${figure}: ${stdout.trim()}${stderr.trim()}`);
        assert.equal(status, 0, figure);
    }
    quiet();
});

// --- the page -----------------------------------------------------------------------------------------------------------------

test('pressure and width of a contact grow with its force as the crank turns, to what is solved there', async () => {
    await open(pageOf('cam_and_roller', join(examples, 'joint_contact/cam_and_roller.json')));
    const told = () => see(`[...document.querySelectorAll('main:not([hidden]) figure[data-figure-name=pressure-P] text.number')]
        .map((each) => each.textContent)`);
    const svg = () => see(`document.querySelector('figure[data-figure-name=pressure-P] svg').outerHTML
        .replace(/(<text[^>]* class="number"[^>]*>)[^<]*/g, '$1')`), drawn = await svg();
    await see(`kinegraph.moveTo(kinegraph.course.samples[20].at)`);
    const turn = await see(`kinegraph.motion.value(0)`), there = JSON.parse(readFileSync(join(examples, 'joint_contact/cam_and_roller.json'), 'utf8'));
    const [x, y] = [33 * Math.cos(turn), 33 * Math.sin(turn)], height = y + Math.sqrt(55 ** 2 - x ** 2);
    Object.assign(there.points, {C: [x, y], R: [0, height], H: [0, height + 36]});
    const file = join(folder, 'cam_there.json');
    writeFileSync(file, JSON.stringify(there));
    const solved = String(run('solve', file));
    const value = (symbol) => Number(new RegExp(`^ *${symbol}  .*? ([\\d.]+) (?:MPa|mm) `, 'm').exec(solved)[1]);
    const shown = (await told()).map(parseFloat);
    assert.equal(shown.length, 3);
    [value('p_0'), value('p_m'), value('b')].forEach((wanted, i) =>
        assert.ok(Math.abs(shown[i] - wanted) < 1e-3 * wanted, `${shown[i]}, not ${wanted}`));
    assert.equal(await see(`document.querySelector('figure[data-figure-name=pressure-P] .note').hidden`), true);
    await see(`kinegraph.moveTo(kinegraph.course.samples[0].at)`);
    assert.deepEqual(await svg(), drawn);
    quiet();
});

test('figures follow the slider and come back as they were', async () => {
    await open(pageOf('watt_six_bar'));
    const drawing = 'kinegraph.sheet.querySelector(".figures").innerHTML';
    const before = await see(drawing);
    const moved = await see(`(() => {
        const slider = document.getElementById('position');
        slider.value = String(Math.PI / 3);
        slider.dispatchEvent(new Event('input'));
        const at = document.querySelector('[data-figure-name=velocity] [data-name=v_B] line.axis');
        const length = Math.hypot(at.x2.baseVal.value - at.x1.baseVal.value, at.y2.baseVal.value - at.y1.baseVal.value);
        const {motion, figures} = kinegraph;
        const view = figures.find((each) => each.id === 'velocity');
        const names = motion.data.columns.map((column) => column.name);
        const v = Math.hypot(motion.value(names.indexOf('vx B')), motion.value(names.indexOf('vy B')));
        return {length, wanted: v / view.scale, where: document.getElementById('where').textContent,
            shown: document.querySelector('td[data-column="' + names.indexOf('omega 6') + '"]').textContent,
            omega: motion.value(names.indexOf('omega 6'))};
    })()`);
    assert.equal(moved.where, '60°');
    assert.ok(Math.abs(moved.length - moved.wanted) < 1e-4 * moved.wanted, JSON.stringify(moved));
    assert.ok(Math.abs(Number(moved.shown.replace('−', '-')) - moved.omega) < 1e-5 * Math.abs(moved.omega));
    assert.notEqual(await see(drawing), before);
    await see('document.getElementById("drawn").click()');
    assert.equal(await see(drawing), before);
    quiet();
});

test('plays only when asked, and stops', async () => {
    const at = 'kinegraph.motion.at';
    assert.equal(await see(at), 0);
    await see('document.getElementById("play").click()');
    await see(`new Promise((done) => {
        const look = () => ${at} > 0.1 ? done() : requestAnimationFrame(look);
        look();
    })`);
    await see('document.getElementById("play").click()');
    const stopped = await see(at);
    assert.ok(stopped > 0);
    await see('new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))');
    assert.equal(await see(at), stopped);
    quiet();
});

test('a joint is dragged along its path', async () => {
    await open(pageOf('four_bar'));
    const spot = (turn) => `(() => {
        const figure = kinegraph.figures[0], path = kinegraph.pathOf(kinegraph.data.names.points.findIndex((each) => each.label === 'A'));
        const samples = kinegraph.course.samples, i = samples.findIndex((each) => each.at >= ${turn} - 1e-9);
        const at = new DOMPoint(figure.paper(path[i]).x, figure.paper(path[i]).y).matrixTransform(figure.svg.getScreenCTM());
        return [at.x, at.y];
    })()`;
    const [x, y] = await see(spot(0));
    await tab.mouse.move(x, y);
    await tab.mouse.down();
    for (const turn of [0.2, 0.4, 0.6, 0.8]) await tab.mouse.move(...await see(spot(turn)));
    await tab.mouse.up();
    const at = await see('kinegraph.motion.at');
    assert.ok(Math.abs(at - 0.8) < 0.1, String(at));
    quiet();
});

test('a finger drags a joint, scrolls elsewhere, and takes a step', async () => {
    await open(pageOf('four_bar'), {width: 390, height: 780});
    await see('kinegraph.figures[0].svg.scrollIntoView({block: "center"})');
    const spot = (turn) => `(() => {
        const figure = kinegraph.figures[0], path = kinegraph.pathOf(kinegraph.data.names.points.findIndex((each) => each.label === 'A'));
        const {samples} = kinegraph.course, at = figure.paper(path[samples.findIndex((each) => each.at >= ${turn} - 1e-9)]);
        const {x, y} = new DOMPoint(at.x, at.y).matrixTransform(figure.svg.getScreenCTM());
        return {x, y};
    })()`;
    const touch = (type, ...touchPoints) => protocol.send('Input.dispatchTouchEvent', {type, touchPoints});
    const scrolled = await see('scrollY');
    await touch('touchStart', await see(spot(0)));
    for (const turn of [0.1, 0.2, 0.3, 0.4, 0.5]) await touch('touchMove', await see(spot(turn)));
    await touch('touchEnd');
    assert.ok(Math.abs(await see('kinegraph.motion.at') - 0.5) < 0.1);
    assert.equal(await see('scrollY'), scrolled);
    for (const [action, step] of [['next', 1], ['next', 2], ['back', 1]]) {
        const {x, y, width, height} = await see(`document.querySelector('[data-action=${action}]').getBoundingClientRect().toJSON()`);
        assert.ok(width >= 44 && height >= 44, `${action} ${width} × ${height}`);
        if (step === 1 && action === 'next') await see('kinegraph.showStep(0)');
        await tab.touchscreen.tap(x + width / 2, y + height / 2);
        assert.equal(await see('kinegraph.step'), step);
    }
    quiet();
});

for (const name of ['four_bar', 'exam_2001', 'watt_six_bar', 'slider_crank', 'quick_return', 'jansen_leg', 'whitworth', 'scotch_yoke',
    'stephenson_1_driver_2', 'inverted_slider_crank']) {
    test(`labels of ${name} keep off bars in 72 positions`, async (t) => {
        await open(pageOf(name));
        const found = await see(`(() => {
            const view = kinegraph.figures.find(({info}) => info.name === 'mechanism'), rim = 0.3;  // the box of a word is wider than its ink
            const labels = [...view.group.querySelectorAll('g.label')].filter((each) => !each.closest('.dimension'));
            const hidden = () => labels.filter((each) => getComputedStyle(each).visibility !== 'hidden').map((label) => {
                const {x, y, width, height} = label.getBBox(), {e: right, f: down} = label.transform.baseVal.consolidate()?.matrix ?? {e: 0, f: 0};
                const box = {left: x + right + rim, right: x + right + width - rim, top: y + down + rim, bottom: y + down + height - rim};
                return {name: label.dataset.label, by: view.links.bars().reduce((sum, bar) => sum + lengthWithin(...bar, box), 0)};
            });
            const sheet = Math.max(...hidden().map(({by}) => by)), {samples} = kinegraph.course, worst = {name: '', by: 0};
            const [from, to] = [samples[0].at, samples[samples.length - 1].at];
            let seen = 0;
            for (let i = 0; i < 72; ++i) {
                kinegraph.moveTo(from + (to - from) * (i + 0.37) / 72);
                for (const each of hidden()) {
                    ++seen;
                    if (each.by > worst.by) Object.assign(worst, each, {at: kinegraph.motion.at});
                }
            }
            return {sheet, worst, seen};
        })()`);
        t.diagnostic(JSON.stringify(found));
        assert.ok(found.seen > 300, String(found.seen));
        assert.ok(found.worst.by <= found.sheet + 0.5, JSON.stringify(found));
        quiet();
    });
}

test('limits are stops with their reason', async () => {
    await open(pageOf('five_bar'));
    await see('document.querySelector("#stops button").click()');
    assert.match(await see('document.getElementById("reason").textContent'), /dead point/);
    quiet();
});

test('steps by keys, announced, each with its sentence and its strokes', async () => {
    await openToRead(pageOf('four_bar'));
    await tab.keyboard.press('ArrowRight');
    await tab.keyboard.press('PageDown');
    await tab.keyboard.press('PageUp');
    assert.match(await see('document.getElementById("announcement").textContent'), /^Step 2 of \d+: \S/);
    await tab.keyboard.press('Escape');
    assert.equal(await see('document.querySelectorAll("svg .later").length'), 0);
    const number = await see('document.querySelector("[data-figure-name=velocity] g.vector").dataset.statement');
    const lit = await see(`kinegraph.teller.light('${number}'),
        [...document.querySelectorAll('main:not([hidden]) .lit')].map((each) => each.tagName)`);
    assert.ok(lit.includes('LI') && lit.includes('g'), lit.join());
    quiet();
});

test('where another program holds the same vectors are there', async () => {
    await open(pageOf('exam_2001'));
    const shown = await see(`(() => {
        const vectors = () => [...document.querySelectorAll('main:not([hidden]) [data-figure-name=velocity] g.vector')]
            .filter((each) => getComputedStyle(each).visibility === 'visible').map((each) => each.dataset.name);
        const drawn = vectors(), {samples} = kinegraph.course;
        return {drawn, elsewhere: samples.filter(({plan}, i) => i % 6 === 1 && plan > 0).map(({at}) => (kinegraph.moveTo(at), vectors()))};
    })()`);
    assert.ok(shown.elsewhere.length > 2 && shown.drawn.includes('v_B'));
    // And those that only the other program draws, each once.
    for (const vectors of shown.elsewhere) {
        assert.deepEqual(shown.drawn.filter((name) => !vectors.includes(name)), []);
        assert.equal(new Set(vectors).size, vectors.length, vectors.join());
    }
    quiet();
});

test('a vector lights its sentence, its rows and its body, and says what it is worth where the mechanism is', async () => {
    const lit = (figure, name) => see(`kinegraph.moveTo(0.12), (() => {
        const node = document.querySelector('main:not([hidden]) [data-figure-name=${figure}] [data-name="${name}"]');
        node.dispatchEvent(new PointerEvent('pointerover', {bubbles: true}));
        const all = [...document.querySelectorAll('main:not([hidden]) .lit')];
        return {rows: all.filter((each) => each.tagName === 'TR').map((each) => each.firstElementChild.textContent),
            said: all.some((each) => each.tagName === 'LI'),
            links: [...new Set(all.map((each) => each.dataset.id).filter((id) => id?.startsWith('link-')))],
            text: node.querySelector('title').textContent};
    })()`);
    const value = (...names) => see(`Math.hypot(...${JSON.stringify(names)}.map((name) =>
        kinegraph.motion.value(kinegraph.motion.data.columns.findIndex((each) => each.name === name))))`);
    await open(pageOf('exam_2001'));
    const v = await lit('velocity', 'v_B');
    assert.deepEqual([v.rows, v.links, v.said], [['vB x', 'vB y'], ['link-3'], true]);
    assert.ok(Math.abs(parseFloat(v.text.slice(6)) - await value('vx B', 'vy B')) < 1e-3, v.text);
    const force = await lit('body-3', 'F_43');
    assert.deepEqual([force.rows, force.links, force.said], [['F43 x', 'F43 y'], ['link-3'], true]);
    assert.ok(Math.abs(parseFloat(force.text.slice(7)) - await value('Fx B 4 on 3', 'Fy B 4 on 3')) < 1e-2, force.text);
    quiet();
});

test('the keyboard reaches every control, and the focus is seen', async () => {
    const seen = [];
    await see('document.activeElement.blur(), document.getElementById("menu-button").click()');
    for (let i = 0; i < 40; ++i) {
        await tab.keyboard.press('Tab');
        const {id, outline} = await see(`(({activeElement: node}) =>
            ({id: node.id, outline: node === document.body ? '' : getComputedStyle(node).outlineStyle}))(document)`);
        seen.push(outline === 'none' ? `${id} unseen` : id);
    }
    const tabs = ['mode-move', 'mode-steps', 'try', 'mode-results', 'mode-given'];
    for (const id of [...tabs, 'play', 'position', 'drawn', 'fit', 'previous', 'next', 'language', 'theme', 'values', 'trace', 'plot',
        'hall', 'menu-button', 'ruler', 'print']) {
        assert.ok(seen.includes(id), `${id} in ${seen.join()}`);
    }
    assert.ok(seen.every((id) => !id.endsWith('unseen')), seen.join());
    await tab.keyboard.press('Escape');
    assert.equal(await see('document.getElementById("menu").hidden'), true);
});

test('a ruler measures in mm and in the unit of the figure, by hand and by keys', async () => {
    const text = 'document.querySelector(".ruler text").textContent';
    await open(pageOf('four_bar'));
    await see('document.getElementById("ruler").click()');
    assert.match(await see(text), /^[\d.]+ mm ≙ [\d.]+ mm, 0°$/);
    // Over v_A of the velocity polygon from end to end, by hand: it snaps to them.
    const ends = await see(`(() => {
        const view = kinegraph.figures.find((each) => each.id === 'velocity');
        view.svg.scrollIntoView({block: 'center'});
        return view.vector('v_A').map((at) => new DOMPoint(at.x + 0.4, at.y).matrixTransform(view.svg.getScreenCTM()))
            .map(({x, y}) => [x, y]);
    })()`);
    await tab.mouse.move(...ends[0]);
    await tab.mouse.down();
    await tab.mouse.move(...ends[1]);
    await tab.mouse.up();
    assert.equal(await see(text), '100.5 mm ≙ 0.503 m/s, −30°');
    await see('document.querySelectorAll(".ruler .handle")[1].focus()');
    await tab.keyboard.press('ArrowRight');
    assert.match(await see(text), /^100\.7 mm/);
    await tab.keyboard.press('PageDown');
    assert.match(await see(text), /m\/s²/);
    await tab.keyboard.press('Escape');
    assert.equal(await see('document.querySelectorAll(".ruler").length'), 0);
    quiet();
});

test('values stand beside vectors when they are asked for, and follow', async () => {
    const shown = `[...document.querySelectorAll(
        'main:not([hidden]) [data-figure-name=velocity] g.label text')].map((each) => each.textContent)`;
    assert.deepEqual(await see(shown), []);
    await see('document.getElementById("values").click()');
    assert.deepEqual(await see(shown), ['= 0.5027 m/s', '= 0.1963 m/s', '= 0.3828 m/s']);
    const moved = await see(`kinegraph.moveTo(1), ${shown}.map((text) => parseFloat(text.slice(2)))`);
    const wanted = await see(`(() => {
        const {motion} = kinegraph, at = (name) => motion.value(motion.data.columns.findIndex((column) => column.name === name));
        return Math.hypot(at('vx B'), at('vy B'));
    })()`);
    assert.ok(Math.abs(moved[2] - wanted) < 1e-4, `${moved} ${wanted}`);
    await see('document.getElementById("values").click(), document.getElementById("drawn").click()');
    assert.deepEqual(await see(shown), []);
    quiet();
});

test('a path and a plot run along', async () => {
    await see(`(() => {
        for (const [id, text] of [['trace', 'B'], ['plot', 'ω₄ [rad/s]']]) {
            const list = document.getElementById(id);
            list.value = [...list.options].find((each) => each.text === text).value;
            list.dispatchEvent(new Event('change'));
        }
    })()`);
    // B is on its path, and the mark on the curve says the value there.
    for (const at of [0, 1, 2.5]) {
        const {off, caption, omega} = await see(`(() => {
            kinegraph.moveTo(${at});
            const mark = document.querySelector('.trace circle'), path = document.querySelector('.trace path');
            const here = {x: mark.cx.baseVal.value, y: mark.cy.baseVal.value}, {motion} = kinegraph;
            const spots = spotsOf(parsePath(path.getAttribute('d')));
            const off = Math.min(...spots.map((each) => apart(each, here)));
            return {off, caption: document.querySelector('.plot figcaption').textContent,
                omega: kinegraph.numberText(motion.value(motion.data.columns.findIndex(({name}) => name === 'omega 4')))};
        })()`);
        assert.ok(off < 2.5, String(off));
        assert.equal(caption, `ω₄ = ${omega} rad/s`);
    }
    await see(`for (const id of ['trace', 'plot']) document.getElementById(id).value = '', document.getElementById(id).onchange()`);
    assert.equal(await see('document.querySelectorAll(".trace, .plot").length'), 0);
    quiet();
});

test('a plot has axes with ticks and units, the stops of the way, and breaks at a pole', async () => {
    await openToRead(pageOf('whitworth'));
    const plot = (name, text) => see(`(() => {
        kinegraph.setMode('move');
        const list = document.getElementById('plot'), {drive} = kinegraph;
        list.value = [...list.options].find((each) => each.text.startsWith('${text}')).value;
        list.dispatchEvent(new Event('change'));
        const svg = document.querySelector('.plot svg'), curve = svg.querySelector('.curve').getAttribute('d');
        return {texts: [...svg.querySelectorAll('text')].map(({textContent}) => textContent), pieces: curve.split('M').length - 1,
            stops: svg.querySelectorAll('.stop').length, ticks: svg.querySelectorAll('.tick').length,
            isNumber: !/NaN|Infinity/.test(svg.outerHTML), shown: svg.getBoundingClientRect().height > 60};
    })()`);
    const whole = await plot('whitworth', 'ω');
    assert.ok(whole.isNumber && whole.shown && whole.ticks >= 4 && whole.stops === 0 && whole.pieces === 1, JSON.stringify(whole));
    assert.ok(whole.texts.some((text) => /^ω\S* \[rad\/s\]$/.test(text)) && whole.texts.includes('turn of the driver [°]'), whole.texts.join());
    await openToRead(pageOf('five_bar'));
    const limited = await plot('five_bar', 'ω');
    assert.ok(limited.isNumber && limited.stops >= 2, JSON.stringify(limited));
    quiet();
});

test('the angle of the crank stands beside its turn', async () => {
    await openToRead(pageOf('four_bar'));
    const said = 'document.getElementById("angle").textContent';
    assert.equal(await see(said), 'φ₂ = 60°');
    assert.equal(await see(`kinegraph.moveTo(Math.PI / 2), ${said}`), 'φ₂ = 150°');
    assert.equal(await see('document.getElementById("where").textContent'), '90°');
    await see('kinegraph.moveTo(0)');
});

test('no name stands twice in the modules, which the page has as one script', () => {
    const modules = fileURLToPath(new URL('../../render/live/', import.meta.url)), names = [];
    for (const file of readdirSync(modules).filter((each) => each.endsWith('.js') && each !== 'watch.js')) {
        for (const [, name] of readFileSync(join(modules, file), 'utf8').matchAll(/^(?:export )?(?:class|function|const|let) (\w+)/gm)) names.push(name);
    }
    assert.ok(names.length > 60);
    assert.deepEqual(names.filter((name, i) => names.indexOf(name) !== i), []);
});

test('what is given can be changed, and what the file gives comes back', async () => {
    await open(pageOf('four_bar'));
    const names = ['omega 3', 'vx B', 'alpha 4', 'x B'];
    const values = () => see(`${JSON.stringify(names)}.map((each) => {
        const {motion} = kinegraph;
        return motion.value(motion.data.columns.findIndex(({name}) => name === each));
    })`);
    const drawing = 'kinegraph.sheet.querySelector(".figures").innerHTML';
    await see('document.getElementById("drawn").click()');
    const first = await values(), picture = await see(drawing);
    const speed = await see(`(() => {
        const input = document.querySelector('#givens input'), speed = Number(input.value);
        input.value = String(2 * speed);
        input.dispatchEvent(new Event('input'));
        return speed;
    })()`);
    assert.equal(speed, -120);  // rpm, as the file writes it
    const twice = await values();
    [2, 2, 4, 1].forEach((factor, i) => assert.ok(Math.abs(twice[i] - factor * first[i]) <= 1e-9 * Math.abs(twice[i]), names[i]));
    await see('kinegraph.setLanguage("it"), kinegraph.setLanguage("en")');
    assert.deepEqual(await values(), twice);
    await see('document.getElementById("drawn").click()');
    assert.deepEqual(await values(), first);
    assert.equal(await see(drawing), picture);
    quiet();
});

test('a length is changed in the panel, what cannot close is told, and bars reach from joint to joint', async () => {
    await open(pageOf('four_bar'));
    const drawing = 'kinegraph.sheet.querySelector(".figures").innerHTML', picture = await see(drawing);
    const write = (name, value) => see(`(() => {
        const [, input] = [...kinegraph.panel.inputs].find(([, each]) => each.parentElement.textContent.startsWith('${name} '));
        input.value = '${value}';
        input.dispatchEvent(new Event('input'));
        return {said: document.getElementById('reason').textContent, isRefused: input.getAttribute('aria-invalid') === 'true'};
    })()`);
    assert.deepEqual(await write('O₂A', 60), {said: '', isRefused: false});
    assert.deepEqual(await write('O₂O₄', 190), {said: '', isRefused: false});
    assert.equal(await see('document.querySelectorAll("#stops button").length'), 2);
    const ends = await see(`kinegraph.moveTo(0.7), ['O_2', 'A', 'B', 'O_4'].map((label) => {
        const view = kinegraph.figures[0], at = view.point(kinegraph.data.names.points.findIndex((each) => each.label === label));
        const spots = [...view.group.querySelectorAll('.link path')].flatMap((path) => {
            const spots = spotsOf(parsePath(path.getAttribute('d')));
            return spots.map(({x, y}) => new DOMPoint(x, y).matrixTransform(view.svg.getCTM().inverse().multiply(path.getCTM())));
        });
        return spots.filter((spot) => apart(spot, at) < 0.01).length;
    })`);
    assert.deepEqual(ends, [1, 2, 2, 1]);
    const refused = await write('BO₄', 0.5);
    assert.ok(refused.isRefused);
    assert.match(refused.said, /does not close/);
    await see('document.getElementById("drawn").click()');
    assert.equal(await see('document.querySelectorAll("#stops button").length'), 0);
    assert.equal(await see(drawing), picture);
    quiet();
});

test('a parameter that the page cannot follow is named with the reason, in both languages', async () => {
    await open(pageOf('press', pressFile));
    const told = (language) => see(`kinegraph.setLanguage('${language}'),
        [...document.querySelectorAll('#givens p')].map((each) => each.textContent)`);
    const english = await told('en'), italian = await told('it');
    assert.equal(english.length, 3);
    assert.match(english[0], /only says in which position the mechanism is drawn; the slider moves it to others: phi\./);
    assert.match(english[1], /In the file only.*: l\.$/);
    assert.match(english[2], /zero.*: e\.$/);
    assert.match(italian[0], /^Non si cambia qui.*la barra lo porta in altre: phi\.$/);
    assert.match(italian[1], /^Solo nel file.*: l\.$/);
    await see('kinegraph.setLanguage("en")');
    quiet();
});

test('the sides of loops reach from body to body, and close', async () => {
    await open(pageOf('slider_crank_long_crank'));
    const varied = [];
    for (const share of [0.35, 0.7]) {
        const sides = await see(`kinegraph.moveTo(kinegraph.course.from + ${share} * (kinegraph.course.to - kinegraph.course.from)), (() => {
            const view = kinegraph.figures.find(({info}) => info.name === 'loops');
            return [...view.group.querySelectorAll('g.side')].map((side) => {
                const {on} = holdOf(side), [a, b] = [view.held.place(on[0]), view.held.place(on[2])];
                const tip = spotsOf(parsePath([...side.querySelectorAll('path')].find((each) => each.getAttribute('fill') !== 'none').getAttribute('d')))[0];
                return {name: side.dataset.name, drawn: Number(side.dataset.value), length: apart(a, b) * view.scale, off: apart(tip, b), a, b,
                    seen: getComputedStyle(side).visibility};
            });
        })()`);
        assert.ok(sides.length >= 3);
        for (const side of sides) assert.ok(side.off < 0.01 && side.seen === 'visible', JSON.stringify(side));
        // Each end is one of another side; crank and rod keep their lengths.
        const ends = sides.flatMap(({a, b}) => [a, b]);
        for (const end of ends) assert.ok(ends.filter((each) => Math.hypot(each.x - end.x, each.y - end.y) < 0.01).length > 1);
        assert.ok(sides.filter(({drawn, length}) => Math.abs(drawn - length) < 1e-9).length >= 2, JSON.stringify(sides));
        varied.push(...sides.filter(({drawn, length}) => Math.abs(drawn - length) > 1e-3));
    }
    assert.ok(varied.length > 0);
    quiet();
});

for (const [name, figure] of [['scara', 'moving-axes']]) {
    test(`the vectors on moving axes of ${name} are those of the position`, async () => {
        const path = pageOf(name);
        await open(path);
        const at = await see('kinegraph.course.samples[Math.floor(kinegraph.course.samples.length / 3)].at');
        const other = join(folder, `${name}_at.html`);
        run('solve', join(examples, `${name}.json`), '--at', `${at * 180 / Math.PI} deg`, '-o', other);
        const wanted = Object.fromEntries([...readFileSync(other, 'utf8').matchAll(/<g[^>]*data-name="([va]_(?:rel|cor))"[^>]*data-value="([^"]*)"/g)]
            .map(([, vector, value]) => [vector, Number(value)]));
        const found = await see(`kinegraph.moveTo(${at}), (() => {
            const view = kinegraph.figures.find(({info}) => info.name.startsWith('${figure}'));
            return [...view.group.querySelectorAll('g.vector')].map((each) => {
                const [a, b] = endsOf(each.querySelector('line.axis'));
                return [each.dataset.name, apart(a, b) * Number(each.dataset.scale)];
            });
        })()`);
        assert.ok(found.length >= 2);
        for (const [vector, value] of found) assert.ok(Math.abs(value - wanted[vector]) < 1e-4 * Math.max(1, wanted[vector]), `${vector} ${value} ${wanted[vector]}`);
        quiet();
    });
}

test('virtual displacements are the tangents of the ways of their points, of a mechanism that no driver of the file moves', async () => {
    await open(pageOf('virtual_work'));
    const found = await see(`(() => {
        const {motion, course, figures} = kinegraph, view = figures.find(({info}) => info.name.startsWith('displacements'));
        const at = course.from + 0.4 * (course.to - course.from), step = 1e-5;
        return [...view.group.querySelectorAll('g.displacement')].map((arrow) => {
            const point = Number(holdOf(arrow).on[0].slice(1)), place = (turn) => (kinegraph.moveTo(turn), motion.read.points[point]);
            const [a, b] = [place(at - step), place(at + step)], {x, y} = (place(at), motion.displacement(point, 0));
            const [tail, , tip] = holdOf(arrow).on.map((name) => view.held.place(name)), drawn = minus(tip, tail);
            return {name: arrow.dataset.name, seen: getComputedStyle(arrow).visibility, size: Math.hypot(x, y),
                off: Math.hypot((b.x - a.x) / (2 * step) - x, (b.y - a.y) / (2 * step) - y), lean: drawn.x * y + drawn.y * x};
        });
    })()`);
    assert.ok(found.length >= 4);
    for (const each of found) assert.ok(each.seen === 'visible' && each.off < 1e-6 * each.size && Math.abs(each.lean) < 1e-6 * each.size * 100,
        JSON.stringify(each));
    quiet();
});

test('velocities stand on the mechanism where it is', async () => {
    await open(pageOf('exam_2001'));
    const found = await see(`kinegraph.moveTo(0.15), (() => {
        const {motion, figures} = kinegraph, view = figures.find(({info}) => info.name === 'velocities');
        const at = (name) => motion.value(motion.data.columns.findIndex((column) => column.name === name));
        const axis = view.group.querySelector('[data-name=v_B] line.axis'), of = (name) => axis[name].baseVal.value;
        const here = view.point(kinegraph.data.names.points.findIndex(({label}) => label === 'B')), scale = view.vectorScale;
        return [of('x1') - here.x, of('y1') - here.y,
            (of('x2') - of('x1')) * scale - at('vx B'), (of('y1') - of('y2')) * scale - at('vy B')];
    })()`);
    assert.ok(found.every((each) => Math.abs(each) < 1e-4), found.join());
    quiet();
});

for (const [name, figures, at] of [
    ['exam_2001', ['lines-of-action', 'body-1', 'body-2', 'body-3', 'body-4', 'body-5', 'joukowsky'], [-0.2, 0.12, 0.4]],
    ['engine_inertia_gas', ['lines-of-action', 'body-2', 'body-3', 'body-4', 'joukowsky'], [0.9, 2.5, 5]],
    ['coupler_curve', ['curvature-3'], [0.5, 2, 4]],
    ['slider_on_moving_guide', [], [0.3]],
]) {
    test(`forces and curvature of ${name} hang on what they say, there and elsewhere`, async () => {
        await open(pageOf(`${name}_held`, join(examples, `${name}.json`), '--with', 'joukowsky'));
        const held = await see(`kinegraph.figures.filter((each) => each.held).map(({info}) => info.name)`);
        for (const each of figures) assert.ok(held.includes(each), `${each} of ${held}`);
        // Put where it says, in the drawn position, every mark but the lines that are cut elsewhere stays where the sheet has it.
        const off = await see(`kinegraph.figures.filter((each) => each.held).flatMap((view) => {
            const nodes = [...view.group.querySelectorAll("[data-on]")].filter((each) => !each.dataset.number && !each.dataset.beyond &&
                !/^\\["(line|through|normal|circle|arc)/.test(each.dataset.on));
            const places = () => nodes.map((each) => each.getBoundingClientRect());
            const drawn = places();
            view.held.take(false);
            view.follow(view.viewBox);
            const now = places(), mm = view.svg.getScreenCTM().a;
            view.restore();
            return nodes.map((each, i) => [view.id + each.dataset.on, Math.max(...['left', 'top', 'right', 'bottom'].map((side) =>
                Math.abs(drawn[i][side] - now[i][side]))) / mm]).filter(([, by]) => !(by < 0.05));
        })`);
        assert.deepEqual(off, []);
        const still = `[...document.querySelectorAll('main:not([hidden]) [data-on].still')].map((each) => each.dataset.on)`;
        assert.deepEqual(await see(still), []);
        for (const turn of at) {
            // Arrows are the forces of the record; what is said to be on a line is on it; a foot is square.
            const wrong = await see(`kinegraph.moveTo(${turn}), kinegraph.figures.filter(({held}) => held).flatMap((view) => {
                const {held} = view, wrong = [], seen = (node) => getComputedStyle(node).visibility === 'visible';
                const told = (what, by) => by < 0.01 || wrong.push(view.id + ' ' + what + ' ' + by);
                for (const node of view.group.querySelectorAll('[data-on]:not(.label)')) {
                    const {form, on} = holdOf(node), axis = node.querySelector(':scope > line.axis');
                    if (form === 'arrow' && on.length === 2 && axis && seen(node)) {
                        const [a, b] = endsOf(axis), {motion} = view, element = motion.held(on[1])[1], replay = motion.replays[motion.plan];
                        const along = {x: (b.x - a.x) * held.scale - replay.x(element), y: (a.y - b.y) * held.scale - replay.y(element)};
                        told(on[1], Math.hypot(along.x, along.y) / held.scale);
                        // Where another stands on the same line it is 2.2 mm beside it.
                        const off = Math.abs(dot(minus(a, held.place(on[0])), quarterTurn(held.direction([on[1]]))));
                        told('on its line', Math.min(off, Math.abs(off - 2.2)));
                    }
                    if (form !== 'line' || !seen(node)) continue;
                    const spots = spotsOf(parsePath(node.getAttribute('d')));
                    for (const force of on.slice(0, on.indexOf(''))) {
                        const axes = held.axes([force, force]);
                        if (!axes) continue;
                        const lies = (k) => [0, 1].map((j) => Math.abs(dot(minus(spots[2 * k + j], axes.at), axes.n)));
                        told('line of ' + force, Math.min(...Array.from({length: spots.length / 2}, (_, k) => Math.max(...lies(k)))));
                    }
                }
                return wrong;
            })`);
            assert.deepEqual(wrong, []);
        }
        await see('document.getElementById("drawn").click()');
        quiet();
    });
}

test('forces cut free at the joints are those of the sweep', async () => {
    await open(pageOf('exam_2001'));
    // F_43 on body 3 at B, F_54 on body 4 at C, the effort's couple.
    const off = await see(`kinegraph.moveTo(0.12), [['body-3', 'F_43', 'B 4 on 3'], ['body-4', 'F_54', 'C 5 on 4']].map(([id, name,
        column]) => {
        const view = kinegraph.figures.find((each) => each.id === id), {motion} = view;
        const [a, b] = endsOf(view.group.querySelector('[data-name="' + name + '"] line.axis'));
        const of = (letter) => motion.value(motion.data.columns.findIndex((each) => each.name === 'F' + letter + ' ' + column));
        return Math.hypot((b.x - a.x) * view.held.scale - of('x'), (a.y - b.y) * view.held.scale - of('y'));
    })`);
    assert.ok(off.every((each) => each < 1e-4), off.join());
    const couple = await see(`(() => {
        const label = document.querySelector('main:not([hidden]) [data-figure-name=body-1] [data-label^="M_C = "] .number');
        const {motion} = kinegraph;
        return [parseFloat(label.textContent.slice(2).replace('−', '-')), motion.value(motion.data.columns.findIndex(({name}) => name === 'effort C'))];
    })()`);
    // With the sign of the table at its arrow.
    assert.ok(Math.abs(couple[0] - couple[1]) < 1e-3 * Math.abs(couple[1]), couple.join());
    quiet();
});

test('polygons of one drawing keep apart, to one scale, and the bar of another scale is left out', async () => {
    const {boxes, scales, room, bar} = await see(`kinegraph.moveTo(0.1), (() => {
        const views = kinegraph.figures.filter(({info}) => info.name === 'forces'), [view] = views;
        return {boxes: views.map((each) => boxOf(each.extent())), scales: views.map(({scale}) => scale), room: view.shownRoom,
            bar: [...view.svg.querySelectorAll(':scope > path')].filter((each) => /^M[^A]*Z$/.test(each.getAttribute('d')))
                .map((each) => getComputedStyle(each).visibility)};
    })()`);
    assert.equal(boxes.length, 2);
    assert.equal(scales[0], scales[1]);
    assert.ok(boxes[0].right < boxes[1].left, JSON.stringify(boxes));
    for (const {left, right, top, bottom} of boxes) {
        assert.ok(left > room[0] && right < room[0] + room[2] && top > room[1] && bottom < room[1] + room[3]);
    }
    assert.ok(bar.length > 0 && bar.every((each) => each === 'hidden'), bar.join());
    quiet();
});

// Where it is drawn its rod is nearly in line with the load: forces that lie on each other stand side by side, polygons are flat.
const pumpFile = fileURLToPath(new URL('pump.json', import.meta.url)), elsewhere = 126 * Math.PI / 180;

test('strokes of polygons close where vectors are no longer in one line, with whole heads and labels of their own', async () => {
    await open(pageOf('pump', pumpFile));
    for (const language of ['en', 'it']) {
        const wrong = await see(`kinegraph.setLanguage('${language}'), kinegraph.moveTo(${elsewhere}), (() => {
            const wrong = [], seen = (node) => getComputedStyle(node).visibility === 'visible';
            for (const view of kinegraph.figures.filter(({isMechanism, held}) => !isMechanism && !held)) {
                for (const node of view.group.querySelectorAll(':scope > g.vector')) {
                    const name = node.dataset.name, ends = view.vector(name), paths = [...node.querySelectorAll('path')].filter(seen);
                    if (paths.length === 0 || apart(...ends) < 8) continue;
                    const spots = paths.map((path) => spotsOf(parsePath(path.getAttribute('d'))));
                    const off = Math.min(...spots[0].map((at) => apart(at, ends[0])));
                    if (off > 0.02) wrong.push(view.id + ' ' + name + ' begins ' + off);
                    const head = paths.findIndex((path) => path.getAttribute('fill') !== 'none');
                    if (head < 0) continue;
                    if (apart(spots[head][0], ends[1]) > 0.02) wrong.push(view.id + ' ' + name + ' ends elsewhere');
                    if (apart(spots[head][1], spots[head][3]) < 1.5) wrong.push(view.id + ' ' + name + ' has no head');
                }
                const boxes = [...view.group.querySelectorAll(':scope > g.label:not([transform*=rotate])')].filter(seen).map((label) =>
                    ({name: label.dataset.label, box: label.getBoundingClientRect()}));
                boxes.forEach((a, i) => boxes.slice(i + 1).forEach((b) => {
                    const wide = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
                    const tall = Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top);
                    const least = Math.min(a.box.width * a.box.height, b.box.width * b.box.height);
                    if (wide > 0 && tall > 0 && wide * tall > 0.25 * least) wrong.push(view.id + ': ' + a.name + ' on ' + b.name);
                }));
            }
            return wrong;
        })()`);
        assert.deepEqual(wrong, []);
    }
    quiet();
});

test('polygons of several bodies have rooms of their own, and a polygon takes the larger part of its room', async () => {
    await open(pageOf('pump', pumpFile));
    const found = await see(`kinegraph.moveTo(${elsewhere}), (() => {
        const several = kinegraph.figures.filter(({info}) => info.name === 'forces');
        return {
            boxes: several.map((view) => boxOf(view.extent())), titles: several.map(({area: {title}}) => {
                const [node] = title.nodes, box = node.getBBox(), to = node.transform.baseVal.consolidate().matrix;
                return box.y + to.f + box.height;
            }),
            shares: kinegraph.figures.filter(({info}) => ['velocity', 'acceleration'].includes(info.name)).map((view) => {
                const box = boxOf(view.extent()), [, , width, height] = view.shownRoom;
                return Math.max((box.right - box.left) / width, (box.bottom - box.top) / height);
            }),
        };
    })()`);
    const [upper, lower] = found.boxes;
    assert.equal(found.boxes.length, 2);
    assert.ok(upper.bottom < lower.top, JSON.stringify(found.boxes));
    assert.ok(found.titles[0] < upper.top && upper.bottom < found.titles[1] && found.titles[1] < lower.top, JSON.stringify(found));
    assert.ok(found.shares.every((share) => share > 0.5), found.shares.join());
    quiet();
});

test('a guide is as long as its slider goes, the scale bar stands below, and what a detail names keeps its name', async () => {
    await open(pageOf('pump', pumpFile));
    // Numbers that are seen elsewhere alone keep what they said last.
    const drawing = `kinegraph.sheet.querySelector('.figures').innerHTML.replace(/(<text class="number"[^>]*>)[^<]*/g, '$1')`;
    const picture = await see(drawing);
    const found = await see(`kinegraph.moveTo(${elsewhere}), (() => {
        const view = kinegraph.figures.find(({info}) => info.name === 'mechanism'), d = (node) => spotsOf(parsePath(node.getAttribute('d')));
        const slider = view.point(kinegraph.data.names.points.findIndex(({label}) => label === 'D'));
        const rails = [...view.group.querySelectorAll('.ground path')].map((node) => boxOf(d(node))).filter(({left, right}) => right - left > 20);
        const links = [...view.group.querySelectorAll('g.link')].map((node) => node.getBoundingClientRect().bottom);
        const [bar] = view.measures, polygon = kinegraph.figures.find(({info}) => info.name === 'velocity');
        const names = [...polygon.group.querySelectorAll('[data-label=v_D]')].filter((node) => getComputedStyle(node).visibility === 'visible');
        return {slider: slider.x, rails, links, bar: bar.getBoundingClientRect().top, names: names.length};
    })()`);
    assert.ok(found.rails.length >= 2 && found.rails.every(({left, right}) => left < found.slider && found.slider < right),
        JSON.stringify(found));
    assert.ok(found.links.every((bottom) => bottom < found.bar), JSON.stringify(found));
    assert.equal(found.names, 1);
    assert.deepEqual(await see('[...document.getElementById("plot").options].map(({text}) => text).filter((text) => /^(M_m|effort)/.test(text))'),
        ['M_m [N m]']);
    await see('document.getElementById("drawn").click()');
    assert.equal(await see(drawing), picture);
    quiet();
});

// --- the exercise ---------------------------------------------------------------------------------------------------------------

const verdict = 'document.getElementById("try-verdict").textContent', score = 'document.getElementById("try-score").textContent';
const choose = (id, text) => see(`(() => {
    const list = document.getElementById('${id}');
    list.value = [...list.options].find((each) => each.text === '${text}').value;
    list.dispatchEvent(new Event('change'));
})()`);
const judge = () => see(`document.getElementById('try-check').click(), ${verdict}`);
const isSeen = (number) => see(`[...document.querySelectorAll('main:not([hidden]) [data-figure-name=velocity] [data-statement="${number}"]')].every(
    (each) => getComputedStyle(each).visibility !== 'hidden')`);
async function begin(name, options) {
    await openToRead(pageOf(name), options);
    await see('document.getElementById("try").click()');
}

test('an exercise tells direction, sense, length, point, name and order apart, and counts', async () => {
    await begin('four_bar');
    assert.deepEqual(await see('[...document.getElementById("try-name").options].map(({text}) => text)'),
        ['v_A', 'the line of v_BA', 'the line of v_B']);
    assert.equal(await isSeen(6), false);
    assert.equal(await see('getComputedStyle(document.querySelector("main:not([hidden]) .columns")).display'), 'none');
    // What begins in a point that is not there yet comes later.
    await choose('try-name', 'the line of v_BA');
    assert.equal(await judge(), 'Too early: the line of v_BA begins in a point that is not found yet. First comes v_A.');
    await choose('try-name', 'v_A');
    await choose('try-direction', '∥ O₂A');
    assert.equal(await judge(), 'The direction is wrong: v_A is ⟂ O₂A, and this line is 90° off.');
    await choose('try-direction', '⟂ O₂A');
    assert.match(await judge(), /mm too short|sense is wrong/);
    // Along the direction by keys, too far, and to the other side.
    await see(`document.querySelector('.student .handle').focus()`);
    const press = async (key, times) => {
        for (let i = 0; i < times; ++i) {
            const event = `new KeyboardEvent('keydown', {key: '${key}', shiftKey: true, bubbles: true})`;
            await see(`document.activeElement.dispatchEvent(${event})`);
        }
    };
    await press('ArrowRight', 40);
    const tooLong = await judge(), drawn = parseFloat(await see('document.getElementById("try-length").textContent'));
    assert.match(tooLong, /^Direction and sense are right, but by the scale it is \S+ mm too long\.$/);
    assert.ok(Math.abs(parseFloat(tooLong.match(/is (\S+) mm/)[1]) - (drawn - 100.53)) < 0.6, `${tooLong} ${drawn}`);
    await press('ArrowLeft', 60);
    assert.equal(await judge(), 'The direction of v_A is right, its sense is wrong.');
    await see('document.getElementById("try-hint").click()');
    assert.match(await see(verdict), /normal to O2A/);
    assert.ok(await see('document.querySelectorAll("#try-verdict sub").length') >= 3);
    // By hand, to its end; begun anew, so that the end is on the screen.
    await choose('try-point', 'oᵥ');
    const [from, to] = await see(`(() => {
        const {view, tasks, pen: {handle}} = kinegraph.exercise, matrix = view.svg.getScreenCTM(), [task] = tasks;
        return [handle.at, along(task.from, 1, task.by)].map((at) => new DOMPoint(at.x, at.y).matrixTransform(matrix))
            .map(({x, y}) => [x, y]);
    })()`);
    await tab.mouse.move(...from);
    await tab.mouse.down();
    await tab.mouse.move(...to);
    await tab.mouse.up();
    assert.match(await judge(), /^Right/);
    assert.equal(await see(score), 'Score 0.5 of 3');
    assert.equal(await isSeen(6), true);
    // The line of v_BA begins in a; the line of v_B is not it. Either may come first.
    await choose('try-point', 'oᵥ');
    await choose('try-direction', '⟂ AB');
    assert.equal(await judge(), 'It goes through the wrong point: the line of v_BA does not begin in oᵥ.');
    await choose('try-direction', '⟂ BO₄');
    assert.equal(await judge(), 'This is the line of v_B, not the line of v_BA.');
    await choose('try-name', 'the line of v_B');
    await choose('try-direction', '⟂ BO₄');
    assert.match(await judge(), /^Right/);
    assert.equal(await isSeen(7), false);
    await choose('try-point', 'a');
    await choose('try-direction', '⟂ AB');
    await press('ArrowDown', 4);
    assert.equal(await judge(), 'The polygon is complete.');
    assert.equal(await isSeen(7), true);
    assert.equal(await see(score), 'Score 2.5 of 3');
    const report = await see('[...document.querySelectorAll("#report tr")].map((row) => [...row.cells].map(({textContent}) => textContent))');
    assert.equal(report.length, 5);
    assert.deepEqual(report[1].filter((_, i) => i !== 3), ['v_A', '5', '1', '0.5']);
    assert.equal(report[4][4], '2.5');
    await see('kinegraph.setLanguage("it")');
    assert.equal(await see(score), 'Punti 2,5 su 3');
    await see('kinegraph.setLanguage("en"), document.getElementById("mode-move").click()');
    assert.equal(await see('document.querySelectorAll(".student, svg .later").length'), 0);
    assert.equal(await see('performance.getEntriesByType("resource").length'), 0);
    quiet();
});

test('an early error of 5 mm, carried through correct lines, costs once', async () => {
    await begin('four_bar');
    const found = await see(`(() => {
        const {exercise} = kinegraph, said = [], text = () => document.getElementById('try-verdict').textContent;
        const draw = (task, by) => {
            exercise.pen.choosePoint();
            const place = exercise.choices.pointsKnown(exercise.view).findIndex((each) => apart(each.at, task.from) < 0.02);
            document.getElementById('try-point').value = String(place);
            exercise.pen.choosePoint();
            exercise.pen.drag(along(task.from, 1, by));
            exercise.check();
            said.push(text());
        };
        const [first] = exercise.tasks, right = exercise.tasks[1].from;
        draw(first, scaledBy(1 + 5 / Math.hypot(first.by.x, first.by.y), first.by));
        document.getElementById('try-keep').click();
        const moved = apart(exercise.tasks[1].from, right), bA = exercise.view.vector('v_BA');
        for (const i of [1, 2]) draw(exercise.tasks[i], scaledBy(20, exercise.tasks[i].by));
        // The polygon that stands there is the student's, and closes.
        const [o, b] = exercise.view.vector('v_B');
        return {said, moved, points: exercise.points, open: apart(bA[1], b)};
    })()`);
    assert.match(found.said[0], /it is 5 mm too long/);
    assert.equal(found.said[1], 'It agrees with what you have drawn. Now the next one.');
    assert.ok(Math.abs(found.moved - 5) < 1e-6, String(found.moved));
    assert.ok(found.open < 1e-6);
    assert.deepEqual(found.points, [0, 1, 1]);
    // Afterwards the figure is the sheet's again.
    assert.equal(await see(`kinegraph.setMode('steps'), kinegraph.motion.isOwn`), false);
    quiet();
});

test('a whole exercise is done by the keyboard alone', async () => {
    await begin('four_bar');
    const active = () => see('document.activeElement.id || document.activeElement.getAttribute("class")');
    const reach = async (id) => {
        for (let i = 0; i < 60 && await active() !== id; ++i) await tab.keyboard.press('Tab');
        assert.equal(await active(), id);
    };
    const pick = async (id, text) => {
        await reach(id);
        for (let i = 0; i < 20; ++i) {
            if (await see(`document.getElementById('${id}').selectedOptions[0].text`) === text) return;
            await tab.keyboard.press('ArrowDown');
        }
        assert.fail(`${text} is not in ${id}`);
    };
    await pick('try-direction', '⟂ O₂A');
    await reach('handle');
    const length = async () => parseFloat(await see('document.getElementById("try-length").textContent'));
    for (let i = 0; i < 60 && await length() < 96; ++i) await tab.keyboard.press('Shift+ArrowRight');
    for (let i = 0; i < 60 && await length() < 100.4; ++i) await tab.keyboard.press('ArrowRight');
    await tab.keyboard.press('Enter');
    assert.match(await see(verdict), /^Right/);
    for (const [point, direction] of [['a', '⟂ AB'], ['oᵥ', '⟂ BO₄']]) {
        await pick('try-point', point);
        await pick('try-direction', direction);
        await reach('try-check');
        await tab.keyboard.press('Enter');
    }
    assert.equal(await see(verdict), 'The polygon is complete.');
    assert.equal(await see(score), 'Score 3 of 3');
    quiet();
});

for (const name of ['exam_2001', 'watt_six_bar', 'quick_return', 'slider_crank', 'jansen_leg']) {
    test(`every line of ${name} can be drawn, from a point that is there`, async () => {
        await open(pageOf(name));
        const done = await see(`(() => {
            const {exercise} = kinegraph, counts = [];
            kinegraph.setMode('try');
            for (const view of exercise.polygons) {
                exercise.take(view.id);
                for (const task of exercise.tasks) {
                    document.getElementById('try-name').onchange();
                    const points = exercise.choices.pointsKnown(exercise.view),
                        place = points.findIndex((each) => apart(each.at, task.from) < 0.02);
                    document.getElementById('try-point').value = String(place);
                    exercise.pen.choosePoint();
                    exercise.pen.drag(along(task.from, task.kind === 'line' ? 20 : 1, task.by));
                    exercise.check();
                }
                counts.push([view.id, exercise.tasks.length, exercise.points.reduce((sum, each) => sum + each, 0)]);
            }
            return counts;
        })()`);
        assert.ok(done.length >= 1);
        for (const [polygon, tasks, points] of done) assert.equal(points, tasks, polygon);
        assert.ok(done.some(([, tasks]) => tasks >= 3), JSON.stringify(done));
        quiet();
    });
}

test('the words of a button can be read under the pointer', async () => {
    await openToRead(pageOf('four_bar'));
    for (const [mode, id] of [['steps', 'next'], ['try', 'try-check']]) {
        await see(`kinegraph.setMode('${mode}')`);
        await tab.hover(`#${id}`);
        const {color, backgroundColor} = await see(`(({color, backgroundColor}) => ({color, backgroundColor}))(
            getComputedStyle(document.getElementById('${id}')))`);
        const shades = [color, backgroundColor].map((each) => Math.max(...each.match(/[\d.]+/g).slice(0, 3).map(Number)));
        assert.ok(Math.abs(shades[0] - shades[1]) > 120, `${id}: ${color} on ${backgroundColor}`);
    }
    quiet();
});

test('speaks both languages', async () => {
    await openToRead(pageOf('four_bar'));
    const [english, italian] = await see(`['en', 'it'].map((language) => {
        kinegraph.setLanguage(language);
        return document.getElementById('next').textContent + kinegraph.says[0].textContent + document.documentElement.lang;
    })`);
    assert.match(english, /^Next.*en$/);
    assert.match(italian, /^Avanti.*it$/);
    for (const language of ['it', 'en', 'it']) {
        assert.deepEqual(await see(`kinegraph.setLanguage('${language}'), [...document.querySelectorAll('[data-word]')]
            .filter((each) => !each.closest('main[hidden]'))
            .filter((each) => each.textContent !== kinegraph.data.words['${language}'][each.dataset.word])
            .map((each) => each.outerHTML)`), []);
    }
    quiet();
});

test('figures have names for those who hear them, and no id comes twice', async () => {
    const page = await see(`(() => {
        const ids = [...document.querySelectorAll('[id]')].map((each) => each.id);
        return {twice: ids.filter((id, i) => ids.indexOf(id) !== i),
            mute: [...document.querySelectorAll('.figures > figure > svg')].filter((svg) => !svg.getAttribute('aria-label')).length,
            nameless: [...document.querySelectorAll('button, select, input')].filter((each) => !each.textContent.trim() &&
                !each.labels?.[0]?.textContent.trim() && !each.getAttribute('aria-label')).map((each) => each.id)};
    })()`);
    assert.deepEqual(page, {twice: [], mute: 0, nameless: []});
});

test('axe finds nothing', async () => {
    const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');  // tests/run installs it
    const states = [
        ['exam_2001', {dark: false, width: 390}, ''], ['four_bar', {dark: false}, 'kinegraph.setMode("try")'],
        ['four_bar', {dark: true}, 'kinegraph.showStep(6), kinegraph.ruler.turn(true)'], ['four_bar', {dark: true}, 'kinegraph.hall.turn(true)'],
        ['four_bar', {dark: true, width: 390}, 'kinegraph.moveTo(1), kinegraph.setMode("given"), document.getElementById("values").click()'],
        ['four_bar', {dark: false, width: 195, height: 422}, 'document.getElementById("menu-button").click()'],
        ['sluice_gate', {dark: true}, 'kinegraph.setMode("results")'], ['exam_2001', {dark: false}, 'kinegraph.setMode("move")'],
    ];
    for (const [name, options, act] of states) {
        await openToRead(pageOf(name), options);
        await see(act || '0');
        await see(axe);
        const found = await see(`axe.run(document, {resultTypes: ['violations']}).then(({violations}) =>
            violations.map(({id, nodes}) => id + ': ' + nodes[0].html.slice(0, 120)))`);
        assert.deepEqual(found, [], `${name} ${JSON.stringify(options)} ${act}`);
    }
});

test('names are text, whatever they say, and nothing is loaded', async () => {
    const file = JSON.parse(readFileSync(join(examples, 'four_bar.json'), 'utf8'));
    file.title = '</script><img src=x onerror="document.title=1">';
    const text = JSON.stringify(file).replaceAll('"O4"', '"<b onclick=alert(1)>"').replaceAll('"B"', '"javascript:alert(1)"');
    const hostile = join(folder, 'hostile.json');
    writeFileSync(hostile, text);
    const path = pageOf('hostile', hostile);
    await open(path);
    assert.equal(await see('document.querySelector("h1").textContent'), file.title);
    assert.equal(await see('document.querySelectorAll("img, b[onclick], a, iframe, link").length'), 0);
    assert.equal(await see('performance.getEntriesByType("resource").length'), 0);
    assert.match(readFileSync(path, 'utf8'), /default-src 'none'; script-src 'sha256-[^' ]+'; style-src 'sha256-[^' ]+'; base-uri 'none'/);
    quiet();
});

test('a structure without a driver has the values of its file with other loads', () => {
    const file = JSON.parse(readFileSync(join(examples, 'beam.json'), 'utf8'));
    file.loads[0].value = [0, -7.5];
    const other = join(folder, 'other_beam.json');
    writeFileSync(other, JSON.stringify(file));
    const [given, wanted] = [readPage(pageOf('beam')), readPage(pageOf('other_beam', other))].map(({data, Motion}) => new Motion(data.moving));
    const values = (motion) => motion.data.columns.map((_, i) => motion.value(i)), first = values(given);
    const load = given.data.settings.findIndex(({name}) => name === 'F_P');
    assert.ok(given.give(given.settings.map((value, i) => i === load ? 7500 : value)));
    const now = values(given), expected = values(wanted), most = Math.max(...expected.map(Math.abs));
    assert.ok(now.length >= 3);
    now.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) <= 1e-9 * most, `${given.data.columns[i].name}: ${value}, ${expected[i]}`));
    assert.ok(now.some((value, i) => Math.abs(value - first[i]) > 1000));
    given.toDrawn();
    assert.deepEqual(values(given), first);
});

for (const [name, which, turn] of [['beam', 0, 40], ['beam', 1, -75], ['truss_simple', 0, 130], ['four_force_body', 0, 25]]) {
    test(`a load of ${name} that is turned by ${turn}° gives the values of the file with it turned`, () => {
        const file = JSON.parse(readFileSync(join(examples, `${name}.json`), 'utf8')), load = file.loads[which];
        const page = readPage(pageOf(name)), motion = new page.Motion(page.data.moving), {settings, columns} = motion.data;
        const index = settings.findIndex(({given}) => given === which), {direction, value} = settings[index];
        const unit = settings[index].size, to = direction + turn * Math.PI / 180, size = 1.5 * value;
        for (const each of ['magnitude', 'along']) delete load[each];
        load.value = [size * Math.cos(to) / unit, size * Math.sin(to) / unit];
        const other = join(folder, `${name}_${which}_turned.json`);
        writeFileSync(other, JSON.stringify(file));
        const wanted = readPage(pageOf(`${name}_${which}_turned`, other)), there = new wanted.Motion(wanted.data.moving);
        const put = (all, now) => all.map((each, i) => i === index ? now : each);
        assert.ok(motion.give(put(motion.settings, size), put(motion.turns, to - direction)));
        assert.ok(motion.plan >= 0, 'no program holds');
        const most = Math.max(...columns.map((_, i) => Math.abs(motion.value(i) ?? 0)));
        let compared = 0;
        there.data.columns.forEach(({name: column}, i) => {
            const k = columns.findIndex((each) => each.name === column);
            if (k < 0) return;
            ++compared;
            assert.ok(Math.abs(motion.value(k) - there.value(i)) <= 1e-9 * most, `${column}: ${motion.value(k)}, ${there.value(i)}`);
        });
        assert.ok(compared >= 3, String(compared));
        motion.toDrawn();
        assert.ok(motion.isAsGiven && motion.plan === 0);
    });
}

test('a load is dragged by its tip: it turns, and the polygon follows', async () => {
    await open(pageOf('beam'));
    const found = await see(`(() => {
        const view = kinegraph.figures.find(({info}) => info.name === 'body-2'), [handle] = view.held.handles;
        const screen = (at) => (({x, y}) => [x, y])(new DOMPoint(at.x, at.y).matrixTransform(view.svg.getScreenCTM()));
        view.svg.scrollIntoView({block: 'center'});
        const fixed = handle.at(), free = handle.free(), scale = handle.scale();
        return {given: handle.given, from: screen(free), to: screen({x: fixed.x + 0.8 * (free.y - fixed.y), y: free.y}), scale,
            by: {x: handle.sense * 0.8 * (free.y - fixed.y) * scale, y: -handle.sense * (free.y - fixed.y) * scale}};
    })()`);
    await tab.mouse.move(...found.from);
    await tab.mouse.down();
    await tab.mouse.move(...found.to);
    await tab.mouse.up();
    const now = await see(`(() => {
        const {motion} = kinegraph, i = motion.turning(${found.given}), view = kinegraph.figures.find(({id}) => id === 'forces-2');
        const angle = motion.data.settings[i].direction + motion.turns[i], [a, b] = view.vector(motion.data.settings[i].name);
        return {x: motion.settings[i] * Math.cos(angle), y: motion.settings[i] * Math.sin(angle), plan: motion.plan,
            drawn: {x: (b.x - a.x) * view.scale * view.held?.inUnit || (b.x - a.x) * view.scale, y: (a.y - b.y) * view.scale},
            said: kinegraph.panel.directions.get(i).value};
    })()`);
    assert.ok(now.plan >= 0);
    const size = Math.hypot(found.by.x, found.by.y);
    assert.ok(Math.hypot(now.x - found.by.x, now.y - found.by.y) < 0.05 * size, JSON.stringify([found, now]));
    assert.ok(Math.abs(now.drawn.x / now.drawn.y - now.x / now.y) < 1e-6, JSON.stringify(now));
    assert.ok(Math.abs(Number(now.said) * Math.PI / 180 - Math.atan2(now.y, now.x)) < 1e-6);
    quiet();
});

for (const name of ['beam', 'truss_roof_wind', 'toggle_clamp', 'excavator_arm', 'exam_2001']) {
    test(`the record of ${name} has each force of its polygons where the sheet draws it`, async () => {
        await open(pageOf(name));
        // A resultant has no record: it is seen where it was drawn only.
        const found = await see(`kinegraph.figures.filter(({id}) => /^(forces|closure)/.test(id)).flatMap((view) =>
            [...view.group.querySelectorAll(':scope > g.vector')].map((node) => {
                const at = view.vector(node.dataset.name), axis = node.querySelector('line.axis');
                const isStill = !at && node.classList.contains('still') && node.dataset.name.startsWith('F_R');
                return axis && !isStill && [view.id, node.dataset.name, at && apart(minus(...at), minus(...endsOf(axis)))];
            }).filter(Boolean))`);
        assert.ok(found.length > 2);
        for (const [figure, vector, off] of found) assert.ok(off !== null && off < 1e-3, `${figure} ${vector}: ${off} mm`);
        quiet();
    });
}

test('a polygon in kN is to the scale that its caption says, and its vectors say their values in kN', async () => {
    await open(pageOf('beam'));
    const found = await see(`[true, false].map((fits) => {
        const {motion} = kinegraph, box = kinegraph.at('fit'), i = motion.data.settings.findIndex(({name}) => name === 'F_P');
        if (box.checked !== fits) box.click();
        kinegraph.drive.turnLoad(i, 1.25 * motion.data.settings[i].value, 0);
        const view = kinegraph.figures.find(({id}) => id === 'forces-2'), [scale] = view.scales;
        return {millimetres: apart(...view.vector('F_P')), drawn: scale.drawn, now: scale.now, unit: scale.unit,
            said: view.sizeOf('F_P'), value: motion.settings[i] / 1000};
    })`);
    for (const {millimetres, now, unit, said, value} of found) {
        assert.equal(unit, 'kN');
        assert.ok(Math.abs(millimetres * now - value) < 1e-9 * value, JSON.stringify(found));
        assert.ok(Math.abs(said - value) < 1e-9 * value);
    }
    assert.equal(found[1].now, found[1].drawn);
    quiet();
});

test('forces in one upright line have polygons at every position', async () => {
    await open(pageOf('scissor_lift'));
    for (const share of [0, 0.41, 1]) {
        const lengths = await see(`(() => {
            const {samples} = kinegraph.course, [from, to] = [samples[0].at, samples[samples.length - 1].at];
            kinegraph.moveTo(from + (to - from) * ${share});
            return kinegraph.figures.filter(({info}) => info.name === 'forces').flatMap((view) =>
                [...view.keys.keys()].map((name) => apart(...view.vector(name))));
        })()`);
        assert.ok(lengths.length > 5 && lengths.every((each) => each < 300), JSON.stringify(lengths));
    }
    quiet();
});

test('bars of a truss show tension and compression of the load as it is turned', async () => {
    const file = JSON.parse(readFileSync(join(examples, 'truss_simple.json'), 'utf8')), other = join(folder, 'truss_turned.json');
    file.loads[0].value = ['12 kN', 0];
    writeFileSync(other, JSON.stringify(file));
    const wanted = [...readFileSync(pageOf('truss_turned', other), 'utf8').matchAll(/<g class="bar"[^>]*data-name="(\w+)" data-value="([^"]*)"/g)];
    await open(pageOf('truss_simple'));
    const found = await see(`(() => {
        const {motion} = kinegraph, view = kinegraph.figures.find(({info}) => info.name === 'truss');
        const widths = () => [...view.group.querySelectorAll('g.bar')].map((bar) => [bar.dataset.name,
            Number(bar.querySelector('[data-on]').getAttribute('stroke-width'))]);
        const drawn = widths(), index = motion.data.settings.findIndex(({given}) => given === 0);
        kinegraph.drive.turnLoad(index, motion.settings[index], Math.PI / 2);
        return {drawn, now: widths(), plan: motion.plan, pens: motion.data.pens.map(([, width]) => width),
            still: view.group.querySelectorAll('[data-on].still').length};
    })()`);
    assert.ok(found.plan >= 0 && found.now.length > 2);
    assert.equal(found.still, 0);
    assert.ok(found.now.some(([, width], i) => width !== found.drawn[i][1]));
    for (const [bar, width] of found.now) {
        const value = Number(wanted.find(([, name]) => name === bar)[2]), sense = Math.abs(value) < 1e-9 ? 0 : Math.sign(value);
        assert.ok(Math.abs(width - found.pens[sense + 1]) < 1e-9, `${bar} ${value} ${width}`);
    }
    quiet();
});

for (const name of ['beam', 'sluice_gate', 'truss_simple']) {
    test(`every line of the polygons of ${name}, which nothing drives, can be drawn`, async () => {
        await openToRead(pageOf(name));
        const done = await see(`(() => {
            const {exercise} = kinegraph;
            kinegraph.setMode('try');
            return exercise.polygons.map((view) => {
                exercise.take(view.id);
                for (const task of exercise.tasks) {
                    const place = exercise.choices.pointsKnown(exercise.view).findIndex((each) => apart(each.at, task.from) < 0.02);
                    document.getElementById('try-point').value = String(place);
                    exercise.pen.choosePoint();
                    exercise.pen.drag(along(task.from, task.kind === 'line' ? 20 : 1, task.by));
                    exercise.check();
                }
                return [exercise.tasks.length, exercise.points.reduce((sum, each) => sum + each, 0)];
            });
        })()`);
        assert.ok(done.length >= 1);
        for (const [tasks, points] of done) assert.equal(points, tasks);
        quiet();
    });
}

const relaxedFile = fileURLToPath(new URL('relaxed.json', import.meta.url));

test('a force that is zero as drawn has an arrow where it is not, and its polygon closes', async () => {
    await open(pageOf('relaxed', relaxedFile));
    const look = (turn) => see(`kinegraph.moveTo(${turn}), (() => {
        const seen = (node) => getComputedStyle(node).visibility === 'visible', view = kinegraph.figures.find(({id}) => id === 'forces-4');
        const arrows = [...view.group.querySelectorAll('g.vector')].filter(seen);
        const by = arrows.map((each) => endsOf(each.querySelector('line.axis'))).map(([a, b]) => minus(b, a));
        const own = view.group.querySelector('[data-name=F_s]'), [a, b] = endsOf(own.querySelector('line.axis'));
        return {isSeen: seen(own), value: (b.x - a.x) * view.scale, open: Math.hypot(total(by.map(({x}) => x)), total(by.map(({y}) => y))),
            labels: [...view.group.querySelectorAll('text.symbol')].filter(seen).map(({textContent}) => textContent)};
    })()`);
    for (const turn of [0.6, 2, 4]) {
        const found = await look(turn), x = 50 * Math.cos(turn + Math.atan2(40, 30)) + 120;
        assert.ok(found.isSeen, String(turn));
        assert.ok(Math.abs(found.value - 0.5 * (150 - x)) < 1e-3, `${found.value} at ${turn}`);
        assert.ok(found.open < 0.01, String(found.open));
        assert.deepEqual(found.labels, ['Fs']);
    }
    await see('document.getElementById("drawn").click()');
    assert.equal(await see(`[...document.querySelectorAll('main:not([hidden]) [data-name=F_s], text.symbol')]
        .filter((each) => getComputedStyle(each).visibility === 'visible').length`), 0);
    quiet();
});

for (const name of ['motion/circular', 'motion/three_positions', 'contact/ball_on_plane', 'variants/impact']) {
    test(`the page of ${name}, which is no mechanism, opens without a word`, async () => {
        await openToRead(pageOf(name.replace('/', '_'), join(examples, `${name}.json`)));
        assert.ok(await see('document.querySelectorAll("main:not([hidden]) svg[role=img]").length') > 0);
        quiet();
    });
}

test('a file without a driver is read all the same', async () => {
    await open(pageOf('beam'));
    assert.equal(await see('document.getElementById("play")'), null);
    assert.equal(await see('document.getElementById("mode-move")'), null);
    const lengths = await see(`(() => {
        kinegraph.setMode('given');
        const length = (name) => apart(...kinegraph.figures.find(({id}) => id === 'forces-2').vector(name)), before = length('F_P');
        const view = kinegraph.figures.find(({id}) => id === 'forces-2'), input = document.querySelector('#givens input');
        input.value = String(2 * Number(input.value));
        input.dispatchEvent(new Event('input'));
        return {before: before * view.drawnScale, now: length('F_P') * view.scale, hidden: [...document.querySelectorAll('figure .note')].length};
    })()`);
    assert.ok(Math.abs(lengths.now / lengths.before - 2) < 1e-9, JSON.stringify(lengths));
    assert.ok(await see('document.querySelectorAll("main:not([hidden]) svg[role=img]").length') > 0);
    quiet();
});
