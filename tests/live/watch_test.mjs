// `kinegraph watch`: that it answers the page and nothing else, whatever it is asked and however many ask; that the page follows
// the file, keeps its place, and shows what is wrong. Run by live_test.mjs, in whose browser it looks.
import assert from 'node:assert/strict';
import {spawn, spawnSync} from 'node:child_process';
import {mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync} from 'node:fs';
import net from 'node:net';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {messages, open, run} from './browser.mjs';

const [program, examples] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'watch-test-'));
const file = join(folder, 'four_bar.json'), good = readFileSync(join(examples, 'four_bar.json'), 'utf8');
let watch, address, said = '';

before(async () => {
    writeFileSync(file, good);
    writeFileSync(join(folder, 'secret.txt'), 'not to be read');
    watch = spawn(program, ['watch', file], {stdio: ['ignore', 'pipe', 'pipe']});
    watch.stderr.on('data', (text) => (said += text));
    address = await new Promise((resolve) => watch.stdout.once('data', (line) => resolve(new URL(String(line).trim()))));
});
after(async () => {
    watch.kill('SIGKILL');
    rmSync(folder, {recursive: true, force: true});
});

/** What is answered to these bytes; empty where nothing is. */
function ask(bytes, port = address.port) {
    return new Promise((resolve) => {
        const socket = net.connect(port, '127.0.0.1', () => socket.write(bytes));
        let heard = '';
        socket.on('data', (data) => (heard += data));
        socket.on('error', () => resolve(heard));
        socket.on('close', () => resolve(heard));
    });
}
const host = () => `Host: 127.0.0.1:${address.port}\r\n`;
const statusOf = (answer) => Number(answer.match(/^HTTP\/1\.1 (\d+)/)?.[1] ?? 0);
const get = (target, more = '') => ask(`GET ${target} HTTP/1.1\r\n${host()}${more}\r\n`);
const news = async () => JSON.parse((await get(`${address.pathname}news`)).split('\r\n\r\n')[1]);
/** Waits for a truth; a busy machine has its time, and a page that gives way to the next is asked again. */
async function until(isTrue, what) {
    for (let i = 0; i < 400; ++i) {
        try {
            if (await isTrue()) return;
        } catch (error) {
            if (!/context was destroyed/.test(String(error))) throw error;
        }
        await new Promise((resolve) => setTimeout(resolve, 50));
    }
    assert.fail(`${what} has not come`);
}

test('it is for this machine alone, under a name that nobody guesses', async () => {
    assert.equal(address.hostname, '127.0.0.1');
    assert.match(address.pathname, /^\/[0-9a-f]{32}\/$/);
    await until(async () => (await news()).page === 1, 'a page');
    const page = await get(address.pathname);
    assert.equal(statusOf(page), 200);
    assert.match(page, /Cache-Control: no-store\r\n/);
    assert.match(page, /frame-ancestors 'none'/);
    assert.match(page, /connect-src 'self'; base-uri 'none'/);
    const onDisk = spawnSync(program, ['solve', file, '-o', '-', '--format', 'html'], {encoding: 'utf8', maxBuffer: 1e7}).stdout;
    assert.doesNotMatch(onDisk, /connect-src|fetch\(/);
    assert.match(await get(`/${address.pathname}`), /404/);
});

test('bad requests are refused, and what comes after them is answered', async () => {
    const path = () => address.pathname;
    const cases = [
        [`GET / HTTP/1.1\r\n${host()}\r\n`, 404],
        [`GET ${path()}../../etc/passwd HTTP/1.1\r\n${host()}\r\n`, 404],
        [`GET /../../../../../etc/passwd HTTP/1.1\r\n${host()}\r\n`, 404],
        [`GET ${path()}%2e%2e/secret.txt HTTP/1.1\r\n${host()}\r\n`, 404],
        [`GET ${path()}secret.txt HTTP/1.1\r\n${host()}\r\n`, 404],
        [`GET ${path()}four_bar.json HTTP/1.1\r\n${host()}\r\n`, 404],
        [`GET file://${file} HTTP/1.1\r\n${host()}\r\n`, 404],
        [`GET ${path()}?x=1 HTTP/1.1\r\n${host()}\r\n`, 404],
        [`GET ${path()}\0 HTTP/1.1\r\n${host()}\r\n`, 400],
        [`GET ${path()} HTTP/1.1\r\nHost: evil.example\r\n\r\n`, 403],
        [`GET ${path()} HTTP/1.1\r\nHost: evil.example:${address.port}\r\n\r\n`, 403],
        [`GET ${path()} HTTP/1.1\r\nHost: 127.0.0.1.evil.example:${address.port}\r\n\r\n`, 403],
        [`GET ${path()} HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n`, 403],
        [`GET ${path()} HTTP/1.1\r\n\r\n`, 400],
        [`GET ${path()} HTTP/1.1\r\n${host()}${host()}\r\n`, 400],
        [`GET ${path()}news HTTP/1.1\r\n${host()}Origin: https://evil.example\r\n\r\n`, 403],
        [`GET ${path()}news HTTP/1.1\r\n${host()}Origin: null\r\n\r\n`, 403],
        [`GET ${path()}news HTTP/1.1\r\n${host()}Origin: http://127.0.0.1:1\r\n\r\n`, 403],
        [`GET ${path()}news HTTP/1.1\r\n${host()}Origin: http://127.0.0.1:${address.port}\r\n\r\n`, 200],
        [`GET ${path()}news HTTP/1.1\r\nHOST: localhost:${address.port}\r\n\r\n`, 200],
        [`HEAD ${path()} HTTP/1.1\r\n${host()}\r\n`, 200],
        [`POST ${path()} HTTP/1.1\r\n${host()}Content-Length: 3\r\n\r\nabc`, 405],
        [`PUT ${path()} HTTP/1.1\r\n${host()}Content-Length: 99999999\r\n\r\n${'x'.repeat(300000)}`, 405],
        [`CONNECT evil.example:443 HTTP/1.1\r\n${host()}\r\n`, 404],
        [`GET ${path()} HTTP/3.0\r\n${host()}\r\n`, 505],
        [`GET ${path()}\r\n${host()}\r\n`, 400],
        [`GET  ${path()} HTTP/1.1\r\n${host()}\r\n`, 400],
        ['\r\n\r\n', 400],
        [`GET ${path()} HTTP/1.1\r\n${host()} folded: x\r\n\r\n`, 400],
        [`GET ${path()} HTTP/1.1\r\n${host()}no colon\r\n\r\n`, 400],
        [`GET ${path()} HTTP/1.1\r\n${host()}X: ${'a'.repeat(20000)}\r\n\r\n`, 431],
        [`GET /${'a'.repeat(200000)} HTTP/1.1\r\n${host()}\r\n`, 431],
        [`GET ${path()} HTTP/1.1\r\n${'X: y\r\n'.repeat(3000)}\r\n`, 431],
        [Buffer.from('16030100a5010000a1030352', 'hex').toString('latin1') + '\r\n\r\n', 400],
    ];
    for (const [bytes, status] of cases) assert.equal(statusOf(await ask(bytes)), status, bytes.slice(0, 120));
    assert.equal(statusOf(await get(address.pathname)), 200);
});

test('neither half requests nor a thousand connections keep it from answering', async () => {
    const half = Array.from({length: 1000}, (_, i) => {
        const socket = net.connect(address.port, '127.0.0.1');
        socket.on('error', () => {});
        socket.on('connect', () => socket.write(i % 2 === 0 ? `GET ${address.pathname} HTTP/1.1\r\nHost: 12` : ''));
        return socket;
    });
    await new Promise((resolve) => setTimeout(resolve, 200));
    for (let i = 0; i < 5; ++i) assert.equal(statusOf(await get(address.pathname)), 200);
    const slow = net.connect(address.port, '127.0.0.1');
    slow.on('error', () => {});
    slow.write('GET /');
    // A head that comes byte by byte has no more time than one that does not come.
    const drops = setInterval(() => slow.write('a'), 300);
    const told = await new Promise((resolve) => {
        slow.once('data', (data) => resolve(statusOf(String(data))));
        slow.once('close', () => resolve(0));
    });
    clearInterval(drops);
    assert.equal(told, 408);
    half.forEach((socket) => socket.destroy());
    const answers = await Promise.all(Array.from({length: 100}, () => get(`${address.pathname}news`)));
    assert.ok(answers.every((answer) => statusOf(answer) === 200));
});

test('the page follows the file, keeps its place, and shows what is wrong as long as it is', async () => {
    await open(String(address));
    assert.equal(await run('document.documentElement.dataset.ready'), 'true');
    await run(`kinegraph.setLanguage('it'), kinegraph.moveTo(0.5), kinegraph.showStep(3)`);
    const faults = 'document.getElementById("faults").hidden ? "" : document.getElementById("faults").textContent';

    const spoilt = good.replace('"body"', '"bdoy<img src=x onerror=alert(1)>"');
    assert.notEqual(spoilt, good);
    writeFileSync(file, spoilt);
    await until(async () => /bdoy<img/.test(await run(faults)), 'the fault');
    const line = spoilt.slice(0, spoilt.indexOf('bdoy')).split('\n').length;
    assert.match(await run(faults), new RegExp(`^Il file contiene errori.*Riga ${line}, colonna \\d+: /`));
    assert.match(said, new RegExp(`four_bar\\.json: .*line ${line}, column`));
    assert.equal(await run('document.querySelectorAll("img").length'), 0);
    assert.equal(await run('kinegraph.motion.at'), 0.5);  // what was there stays

    writeFileSync(file, `${good.slice(0, 200)}`);
    await until(async () => /non è JSON/.test(await run(faults)), 'the other fault');
    rmSync(file);
    await until(async () => /non si può leggere/.test(await run(faults)), 'that the file is gone');

    const title = JSON.parse(good);
    title.title = 'Saved again </script><b>';
    writeFileSync(`${file}~`, JSON.stringify(title));
    renameSync(`${file}~`, file);
    await until(async () => (await run('window.kinegraph?.data.served ?? 0')) === 2, 'the page');
    await until(() => run('document.documentElement.dataset.ready === "true"'), 'the page');
    const kept = await run('[kinegraph.language, kinegraph.motion.at, kinegraph.step, document.querySelector("h1").textContent]');
    assert.deepEqual(kept, ['it', 0.5, 3, title.title]);
    assert.equal(await run(faults), '');
    assert.deepEqual(messages, []);
});

test('Ctrl-C ends it, as it should; a port that is taken and a file that is none are told', async () => {
    const taken = spawnSync(program, ['watch', file, '--port', address.port], {encoding: 'utf8'});
    assert.equal(taken.status, 4);
    assert.match(taken.stderr, new RegExp(`^kinegraph: port ${address.port} .*choose another`));
    for (const none of ['-', folder, join(folder, 'none.json')]) {
        assert.equal(spawnSync(program, ['watch', none], {encoding: 'utf8'}).status, 2, none);
    }
    const ended = new Promise((resolve) => watch.on('exit', (status) => resolve(status)));
    watch.kill('SIGINT');
    assert.equal(await ended, 0);
});

test('a file that was never right has a page of faults in the language asked for, and then its page', async (t) => {
    const other = join(folder, 'other.json');
    writeFileSync(other, '{');
    const second = spawn(program, ['watch', other, '--lang', 'fr'], {stdio: ['ignore', 'pipe', 'ignore']});
    const at = await new Promise((resolve) => second.stdout.once('data', (text) => resolve(String(text).trim())));
    t.after(() => second.kill('SIGKILL'));
    await open(at);
    await until(() => run('/apparaîtra dès.*ligne 1/.test(document.getElementById("faults").textContent)'), 'the fault');
    writeFileSync(other, good);
    await until(() => run('window.kinegraph?.data.served === 1'), 'the page');
    await open('about:blank'); // a page that still asks its server would report to the next test that nobody answers
    second.kill('SIGTERM');
    assert.equal(await new Promise((resolve) => second.on('exit', resolve)), 0);
});
