// What the tests of the workbench share: the program that serves it, and hands that draw with real mouse and keys.
import {spawn} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {page, run} from './browser.mjs';

export const folder = mkdtempSync(join(tmpdir(), 'workbench-test-'));
/** Programs that were started. */
const programs = [];

/** Serves a file, and gives the address. */
export async function serve(program, file, ...more) {
    const process = spawn(program, ['edit', file, ...more], {stdio: ['ignore', 'pipe', 'pipe']});
    programs.push(process);
    const address = await new Promise((resolve) => process.stdout.once('data', (line) => resolve(String(line).trim())));
    return {process, address};
}
export function cleanUp() {
    programs.forEach((each) => each.kill('SIGKILL'));
    rmSync(folder, {recursive: true, force: true});
}
/** Waits for a truth in the page. (Its policy forbids the eval of playwright's own waiting.) */
export async function until(expression) {
    for (let i = 0; i < 600; ++i) {
        if (await run(expression)) return;
        await new Promise((resolve) => setTimeout(resolve, 25));
    }
    throw new Error(`${expression} has not come`);
}
/** The page has begun; the engine has answered for the text as it is. */
export const ready = () => until(`document.documentElement.dataset.ready === 'true'`);
export const settled = () => until('!workbench.inquiry.isAsking && workbench.answer !== null');
/** Where a place of the plane is on the screen. */
export async function onScreen([x, y]) {
    const box = await page.locator('#canvas').boundingBox();
    const [u, v] = await page.evaluate((at) => window.workbench.view.toScreen(at), [x, y]);
    return [box.x + u, box.y + v];
}
export const clickAt = async (at) => page.mouse.click(...await onScreen(at));
export async function dragFromTo(from, to) {
    await page.mouse.move(...await onScreen(from));
    await page.mouse.down();
    await page.mouse.move(...await onScreen([(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]));
    await page.mouse.move(...await onScreen(to));
    await page.mouse.up();
}
export const tool = (name) => page.click(`[data-tool=${name}]`);
export const file = async () => JSON.parse(await run('workbench.document.text'));
export const text = () => run('workbench.document.text');
/** Types into a field of the panel, and leaves it by Enter. */
export async function fill(id, value) {
    await page.locator(`#properties [id="${id}"]`).fill(value);
    await page.keyboard.press('Enter');
    await settled();
}
/** Moves the cross of the canvas to a place by the arrow keys. */
export async function crossTo([x, y]) {
    const grid = await run('workbench.view.grid');
    const [fromX, fromY] = await run(
        'workbench.cursor?.at ?? workbench.view.toPlane([workbench.view.width / 2, workbench.view.height / 2])'
    );
    const steps = (from, to, less, more) =>
        Array.from({length: Math.abs(Math.round(to / grid) - Math.round(from / grid))}, () =>
            to < from ? less : more
        );
    for (const key of [...steps(fromX, x, 'ArrowLeft', 'ArrowRight'), ...steps(fromY, y, 'ArrowDown', 'ArrowUp')])
        await page.keyboard.press(key);
}
