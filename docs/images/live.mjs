// The live pages of docs/gallery.md, and what they look like on a screen and on a phone: node docs/images/live.mjs PROGRAM, from
// the repository's root; make.sh calls it. A picture above 60 KB is named, and the status is 1.
import {execFileSync} from 'node:child_process';
import {statSync, writeFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {close, open, protocol, run} from '../../tests/live/browser.mjs';

const [program] = process.argv.slice(2);
for (const name of ['four_bar', 'watt_six_bar', 'cam_roller_follower']) {
    execFileSync(program, ['solve', `examples/${name}.json`, '-o', `docs/live/${name}.html`], {stdio: ['ignore', 'ignore', 'ignore']});
}

async function picture(name, page, options, act) {
    await open(`file://${resolve('docs/live', `${page}.html`)}`, options);
    await run(`${act}, null`);
    const file = `docs/images/${name}.png`;
    const {width, height, scale = 1} = options, clip = {x: 0, y: await run('scrollY'), width, height, scale};
    const {data} = await protocol.send('Page.captureScreenshot', {format: 'png', clip});
    writeFileSync(file, Buffer.from(data, 'base64'));
    if (statSync(file).size > 60 * 1024) {
        console.log(`${file} is larger than 60 KB`);
        process.exitCode = 1;
    }
}
const longer = `(() => {
    const [, input] = [...kinegraph.panel.inputs].find(([, each]) => each.parentElement.textContent.startsWith('O₂O₄'));
    document.getElementById('givens').open = true;
    input.value = '165';
    input.dispatchEvent(new Event('input'));
})()`;
await picture('live_wide', 'four_bar', {width: 1280, height: 900, scale: 0.6}, `${longer}, kinegraph.moveTo(0.8)`);
await picture('live_dark', 'watt_six_bar', {width: 1280, height: 780, dark: true, scale: 0.55}, 'kinegraph.moveTo(1)');
await picture('live_phone', 'cam_roller_follower', {width: 390, height: 780, dark: true}, 'kinegraph.moveTo(0.6), scrollTo(0, 330)');
await picture('live_try', 'four_bar', {width: 390, height: 780}, `(() => {
    document.getElementById('try').click();
    const list = document.getElementById('try-direction');
    list.value = [...list.options].find((each) => each.text === '⟂ O₂A').value;
    kinegraph.exercise.aim();
    document.getElementById('try-check').click();
})()`);
await close();
