// node web/tests/site_test.mjs SITE: the static site in Chromium, as a visitor has it: it answers, keeps its
// policy, says nothing to the console, asks no other host, and goes on without a network. Prints sizes and times.
import assert from 'node:assert/strict';
import {createServer} from 'node:http';
import {readFileSync, readdirSync, statSync} from 'node:fs';
import {extname, join, normalize} from 'node:path';
import {after, before, test} from 'node:test';
import {gzipSync} from 'node:zlib';
import {chromium} from '../../tests/live/node_modules/playwright-core/index.mjs';

const [site] = process.argv.slice(2), most = 3e6;  // bytes of the first load
const types = {
    '.css': 'text/css',
    '.html': 'text/html',
    '.js': 'text/javascript',
    '.json': 'application/json',
    '.svg': 'image/svg+xml',
    '.webmanifest': 'application/manifest+json',
    '.zst': 'application/zstd'
};
const asked = [], messages = [];
let server, address, browser, context, page;

before(async () => {
    server = createServer((request, response) => {
        const path = normalize(new URL(request.url, 'http://localhost').pathname),
            file = join(site, path.endsWith('/') ? `${path}index.html` : path);
        asked.push(path);
        if (path === '/course.html') {
            response.writeHead(200, {'Content-Type': 'text/html'});
            return void response.end(
                '<!DOCTYPE html><link rel="icon" href="data:,"><title>A course</title>' +
                    '<iframe width="800" height="500" src="./?compact&file=examples/four_bar.json"></iframe>'
            );
        }
        try {
            const body = readFileSync(file);
            response.writeHead(200, {
                'Content-Type': types[extname(file)] ?? 'text/plain',
                // A worker has the policy that it is sent with.
                'Content-Security-Policy': path.endsWith('worker.js')
                    ? "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'"
                    : "frame-ancestors 'self'"
            });
            response.end(body);
        } catch {
            response.writeHead(404).end();
        }
    });
    await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
    address = `http://127.0.0.1:${server.address().port}/`;
    browser = await chromium.launch({
        executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
        args: ['--disable-gpu', '--disable-dev-shm-usage']
    });
    context = await browser.newContext();
    page = await context.newPage();
    context.on('console', (message) => messages.push(message.text()));
    context.on('weberror', (error) => messages.push(String(error.error())));
    context.on('request', (request) => asked.push(request.url()));
});
after(async () => {
    await browser.close();
    server.close();
    server.closeAllConnections();
});

/** Waits for a truth in the page. (Its policy forbids the eval of playwright's own waiting.) */
async function until(condition, where = page) {
    for (const end = performance.now() + 60_000; performance.now() < end;) {
        if (await where.evaluate(condition)) return;
        await new Promise((resolve) => setTimeout(resolve, 10));
    }
    throw new Error(`${condition} has not come`);
}
const isReady = () => until(() => document.documentElement.dataset.ready === 'true');
/** What the page's engine answers, and how long it took, ms. */
const ask = (example, want) => page.evaluate(async ([path, wanted]) => {
    const text = await (await fetch(path)).text(), start = performance.now();
    const answer = await workbench.engine.answer({text, name: path.split('/').at(-1), want: wanted});
    return {answer, ms: performance.now() - start};
}, [example, want]);

test('the first load is at most 3 MB, whatever the server compresses by', () => {
    const files = readdirSync(site)
        .filter((name) => statSync(join(site, name)).isFile())
        .map((name) => ({isModule: name.endsWith('.zst'), bytes: readFileSync(join(site, name))}));
    assert.equal(files.filter(({isModule}) => isModule).length, 1);
    const sum = (size) => files.reduce((all, file) => all + size(file), 0);
    // The module is sent as it is: no server makes it smaller.
    const gzip = sum(({isModule, bytes}) => (isModule ? bytes : gzipSync(bytes)).length);
    const plain = sum(({bytes}) => bytes.length);
    console.log(`first load ${(plain / 1e6).toFixed(2)} MB, by gzip ${(gzip / 1e6).toFixed(2)} MB`);
    assert.ok(plain < most, `${plain} bytes`);
});
test('the page opens and its engine answers', async () => {
    const start = performance.now();
    await page.goto(address);
    await isReady();
    console.log(`usable after ${(performance.now() - start).toFixed(0)} ms`);
    for (const example of ['examples/four_bar.json', 'examples/exam_2001.json']) {
        await ask(example, ['position']); // the functions are compiled as they are called
        for (const want of [
            ['position'],
            ['position', 'mobility', 'results', 'values', 'sentences', 'names', 'sheet']
        ]) {
            const times = [];
            for (let i = 0; i < 5; ++i) {
                const {answer, ms} = await ask(example, want);
                assert.equal(answer.failure, undefined);
                assert.deepEqual(answer.faults, []);
                if (want.includes('sheet')) assert.match(answer.sheet[0], /^<\?xml|^<svg/);
                times.push(ms);
            }
            console.log(`${example} ${want.join(' ')}: ${times.sort((a, b) => a - b)[2].toFixed(0)} ms`);
        }
    }
});
test('a file with faults has them named, and any text is answered', async () => {
    const answers = await page.evaluate(() =>
        Promise.all(
            ['', '{', '{"kinegraph": 1}', '[[[['.repeat(100_000), '\u0000'].map((text) =>
                workbench.engine.answer({text, name: 'any.json', want: ['position', 'results']})
            )
        )
    );
    for (const answer of answers) assert.equal(answer.failure, undefined);
    assert.ok(answers.slice(1).every(({faults}) => faults.length > 0));
});
test('what is opened takes the place of all that was there', async () => {
    await page.evaluate(async () => {
        const text = await (await fetch('examples/four_bar.json')).text();
        workbench.open(text, 'four_bar.json', text);
    });
    await until(() => document.querySelector('#figures figure') !== null);
    await page.evaluate(() => workbench.open('{"points": ', 'broken.json', null));
    await until(() => (workbench.answer?.faults.length ?? 0) > 0);
    assert.equal(await page.evaluate(() => workbench.model.points.length), 0);
    assert.equal(await page.locator('#figures figure').count(), 0);
    assert.match(await page.locator('#status').textContent(), /1, .*12/);
});
test('a link holds the whole mechanism', async () => {
    const text = await page.evaluate(async () => {
        const linked = await (await fetch('examples/exam_2001.json')).text();
        workbench.open(linked, 'exam_2001.json', linked);
        return linked;
    });
    await page.click('#link');
    await until(() => location.hash.startsWith('#m='));
    const fragment = await page.evaluate(() => location.hash);
    const other = await context.newPage();
    await other.goto(address + fragment);
    await until(() => document.documentElement.dataset.ready === 'true', other);
    assert.equal(await other.evaluate(() => workbench.document.text), text);
    await other.close();
});
test('a page of others has a mechanism to move in a frame', async () => {
    const course = await context.newPage();
    await course.goto(`${address}course.html`);
    const frame = course.frames()[1];
    await until(() => document.querySelector('#shown iframe') !== null, frame);
    assert.equal(await frame.evaluate(() => document.documentElement.dataset.mode), 'move');
    assert.equal(await frame.locator('#acts').isVisible(), false);
    assert.equal(await frame.locator('#edit-here').getAttribute('href'), `${address}?file=examples%2Ffour_bar.json`);
    await course.close();
});
test('the policy allows what the page has, and no more', async () => {
    const policy = await page.evaluate(
        () => document.querySelector('meta[http-equiv="Content-Security-Policy"]').content
    );
    assert.match(policy, /^default-src 'none';/);
    assert.doesNotMatch(policy, /unsafe-inline|'unsafe-eval'|\*|https?:/);
    assert.match(policy, /script-src 'self' 'wasm-unsafe-eval'/);
});
test('without a network it works as before', async () => {
    await page.evaluate(() => navigator.serviceWorker.ready);
    await until(() => navigator.serviceWorker.controller !== null);
    server.closeAllConnections();
    await new Promise((resolve) => server.close(resolve));
    await page.reload();
    await isReady();
    const {answer} = await ask('examples/slider_crank.json', ['results', 'sheet']);
    assert.ok(answer.sheet.length > 0 && answer.results.length > 0);
});
test('nothing was said to the console, and no other host was asked', () => {
    assert.deepEqual(messages, []);
    assert.ok(asked.length > 10);
    for (const each of asked.filter((url) => !/^(blob|data|about):/.test(url)))
        assert.ok(each.startsWith('/') || each.startsWith(address), each);
});
