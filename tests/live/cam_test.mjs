// The page of a cam: that its true profile touches the follower at every turn and passes nowhere through it, and that
// its numbers are those of the table. Run by live_test.mjs, in whose browser it looks.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';
import {messages, open, page as tab, run} from './browser.mjs';

const [program, examples] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'cam-test-'));
after(() => rmSync(folder, {recursive: true, force: true}));

const disc = JSON.parse(readFileSync(join(examples, 'cams', 'disc_cam.json'), 'utf8'));
const lever = JSON.parse(readFileSync(join(examples, 'cams', 'flat_faced_lever.json'), 'utf8'));
const withFollower = (follower) => ({...disc, cam: {...disc.cam, follower}});
const cams = {
    roller: disc,
    lever,
    clockwise: {...disc, cam: {...disc.cam, omega: '-120 rpm'}},
    flat: withFollower({moves: 'translating', face: 'flat'}),
    edge: withFollower({moves: 'translating', face: 'knife edge', offset: 5}),
    arm: withFollower({moves: 'oscillating', face: 'roller', radius: 8, pivot: [90, 10], arm: 75}),
};

/** In the page: of 73 turns the least gap between the profile, as it is drawn, and the follower, as it is drawn. */
const gaps = `(() => {
    const placesOf = (path) => [...path.getAttribute('d').matchAll(/[ML]([-\\d.e]+) ([-\\d.e]+)/g)]
        .map(([, x, y]) => new DOMPoint(Number(x), Number(y)));
    const moved = (element, places) => {
        const {matrix} = element.transform.baseVal.consolidate();
        return places.map((each) => each.matrixTransform(matrix));
    };
    const cam = document.getElementById('cam'), follower = document.getElementById('follower');
    const profile = placesOf(cam.querySelector('.body')), wheel = follower.querySelector('circle.body');
    const face = follower.querySelector('path.body'), bar = placesOf(follower.querySelector('.bar'));
    const found = [];
    for (let row = 0; row <= 720; row += 10) {
        camPage.show(row);
        const outline = moved(cam, profile);
        let least = Infinity;
        if (face) {
            const [a, b, up] = moved(follower, placesOf(face)), length = Math.hypot(b.x - a.x, b.y - a.y);
            const n = [-(b.y - a.y) / length, (b.x - a.x) / length];
            const side = Math.sign(n[0] * (up.x - a.x) + n[1] * (up.y - a.y));
            for (const each of outline)
                least = Math.min(least, -side * (n[0] * (each.x - a.x) + n[1] * (each.y - a.y)));
        } else {
            const centre = wheel ? new DOMPoint(wheel.cx.baseVal.value, wheel.cy.baseVal.value)
                : camPage.data.pivot ? bar[1] : bar[0];
            const [at] = moved(follower, [centre]), radius = wheel ? wheel.r.baseVal.value : 0;
            for (const each of outline) least = Math.min(least, Math.hypot(each.x - at.x, each.y - at.y) - radius);
        }
        found.push(least);
    }
    return found;
})()`;

for (const [name, cam] of Object.entries(cams)) {
    test(`the cam with ${name} touches its follower at every turn and passes nowhere through it`, async () => {
        const file = join(folder, `${name}.json`), out = join(folder, `${name}.html`);
        writeFileSync(file, JSON.stringify(cam));
        execFileSync(program, ['cam', file, '-o', out], {stdio: 'ignore'});
        await open(`file://${out}`);
        // The drawing is 1000 units wide; the profile has corners half a degree apart, some 4 units.
        const corner = 1.5;
        for (const gap of await run(gaps)) assert.ok(gap > -0.05 && gap < corner, `${name}: ${gap}`);
        const table = execFileSync(program, ['cam', file, '--steps', '72'], {encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore']});
        const rows = table.trim().split('\n').slice(1).map((line) => line.split(',').map(Number));
        const units = await run('[...document.querySelectorAll("#plots td:last-child")].map((each) => each.textContent)');
        const size = {mm: 1e-3, '°': Math.PI / 180, 'm/s': 1, 'm/s²': 1, 'rad/s': 1, 'rad/s²': 1}[units[0]];
        const rises = await run('camPage.data.columns[0]');
        rows.forEach((row, i) => assert.ok(Math.abs(rises[10 * i] * size - row[2]) < 1e-6, `${name}, row ${i}`));
        assert.deepEqual(messages, []);
    });
}

test('the page of a cam is driven by the keyboard, plays, and axe finds nothing', async () => {
    const out = join(folder, 'disc.html');
    execFileSync(program, ['cam', join(examples, 'cams', 'disc_cam.json'), '-o', out, '--lang', 'de'], {stdio: 'ignore'});
    for (const size of [{width: 1366, height: 768}, {width: 390, height: 844}]) {
        await open(`file://${out}`, size);
        await tab.locator('#position').focus();
        await tab.keyboard.press('ArrowRight');
        assert.equal(await run('document.getElementById("where").textContent'), '0,5°');
        const [drawn, drive] = await run(`['.drawing', '#drive'].map((each) => {
            const {top, bottom} = document.querySelector(each).getBoundingClientRect();
            return {top, bottom};
        })`);
        assert.ok(drawn.top >= 0 && drawn.bottom <= drive.top && drive.bottom <= size.height + 1);
    }
    await tab.locator('#play').click();
    // On a machine that does other work the first frames come late.
    for (let i = 0; i < 50 && !(await run('camPage.row') > 2); ++i) await new Promise((resolve) => setTimeout(resolve, 100));
    assert.ok(await run('camPage.row') > 2);
    await tab.locator('#play').click();
    const stopped = await run('camPage.row');
    await new Promise((resolve) => setTimeout(resolve, 100));
    assert.equal(await run('camPage.row'), stopped);
    await run(readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8'));
    assert.deepEqual(await run(`axe.run(document, {resultTypes: ['violations']}).then(({violations}) =>
        violations.map(({id, nodes}) => id + ': ' + nodes.map(({html}) => html).join(' ')))`), []);
    assert.deepEqual(messages, []);
});
