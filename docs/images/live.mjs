// What the live pages of docs/gallery.md look like on a screen and on a phone: node docs/images/live.mjs, from the
// repository's root, after docs/make_pages.sh; make.sh calls both. A picture above 60 KB is named, and the status is 1.
import {statSync, writeFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {close, open, protocol, run} from '../../tests/live/browser.mjs';

async function picture(name, page, options, act) {
    await open(`file://${resolve('docs/live', `${page}.html`)}`, options);
    await run(`${act}, null`);
    const file = `docs/images/${name}.png`;
    const {width, height, scale = 1} = options, clip = {x: 0, y: 0, width, height, scale};
    const {data} = await protocol.send('Page.captureScreenshot', {format: 'png', clip});
    writeFileSync(file, Buffer.from(data, 'base64'));
    if (statSync(file).size > 60 * 1024) {
        console.log(`${file} is larger than 60 KB`);
        process.exitCode = 1;
    }
}
const longer = `(() => {
    const [, input] = [...kinegraph.panel.inputs].find(([, each]) => each.parentElement.textContent.startsWith('O₂O₄'));
    kinegraph.setMode('given');
    input.value = '165';
    input.dispatchEvent(new Event('input'));
})()`;
await picture('live_wide', 'four_bar', {width: 1280, height: 900, scale: 0.6}, `${longer}, kinegraph.moveTo(0.8)`);
await picture('live_dark', 'watt_six_bar', {width: 1280, height: 780, dark: true, scale: 0.45}, 'kinegraph.showStep(16)');
await picture('live_phone', 'cam_roller_follower', {width: 390, height: 780, dark: true}, 'kinegraph.showStep(2), kinegraph.moveTo(0.6)');
await picture('live_try', 'four_bar', {width: 390, height: 780}, `(() => {
    document.getElementById('try').click();
    const list = document.getElementById('try-direction');
    list.value = [...list.options].find((each) => each.text === '⟂ O₂A').value;
    kinegraph.exercise.pen.aim();
    document.getElementById('try-check').click();
})()`);
await close();
