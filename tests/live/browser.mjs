// Chromium by its own protocol, over two pipes: no package beside it is needed.
import {spawn} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

/** A headless browser with one tab. */
export class Browser {
    static async start(program = process.env.CHROMIUM ?? 'chromium') {
        const home = mkdtempSync(join(tmpdir(), 'live-'));
        const process_ = spawn(program, [
            '--headless=new', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage', '--no-first-run', '--disable-extensions',
            '--disable-background-networking', '--remote-debugging-pipe', `--user-data-dir=${home}`, 'about:blank',
        ], {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
        const browser = new Browser(process_, home);
        await new Promise((resolve, reject) => {
            process_.on('error', () => reject(new Error(`${program} does not start: install Debian's chromium`)));
            process_.on('spawn', resolve);
        });
        const {targetInfos} = await browser.send('Target.getTargets');
        const page = targetInfos.find((each) => each.type === 'page');
        ({sessionId: browser.session} = await browser.send('Target.attachToTarget', {targetId: page.targetId, flatten: true}));
        for (const domain of ['Page', 'Runtime', 'Log']) await browser.send(`${domain}.enable`);
        return browser;
    }

    constructor(process_, home) {
        this.process = process_;
        this.home = home;
        this.session = undefined;
        this.next = 1;
        this.waiting = new Map();
        /** What the page said to the console, and what was refused. */
        this.messages = [];
        let read = '';
        process_.stdio[4].on('data', (data) => {
            read += data;
            for (let end = read.indexOf('\0'); end >= 0; end = read.indexOf('\0')) {
                this.hear(JSON.parse(read.slice(0, end)));
                read = read.slice(end + 1);
            }
        });
    }
    hear({id, method, params, result, error}) {
        if (id !== undefined) {
            const {resolve, reject} = this.waiting.get(id);
            this.waiting.delete(id);
            if (error) reject(new Error(error.message));
            else resolve(result);
        } else if (method === 'Runtime.consoleAPICalled') {
            this.messages.push(params.args.map((each) => each.value ?? each.description).join(' '));
        } else if (method === 'Runtime.exceptionThrown') {
            this.messages.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
        } else if (method === 'Log.entryAdded') {
            this.messages.push(params.entry.text);
        } else if (method === 'Page.loadEventFired') {
            this.loaded?.();
        }
    }
    send(method, params = {}) {
        const id = this.next++;
        this.process.stdio[3].write(`${JSON.stringify({id, method, params, sessionId: this.session})}\0`);
        return new Promise((resolve, reject) => this.waiting.set(id, {resolve, reject}));
    }

    async open(url, {width = 1280, height = 900, dark = false} = {}) {
        await this.send('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: 1, mobile: false});
        await this.send('Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value: dark ? 'dark' : 'light'}]});
        const loaded = new Promise((resolve) => (this.loaded = resolve));
        await this.send('Page.navigate', {url});
        await loaded;
    }
    /** The value of an expression in the page. */
    async run(expression) {
        const {result, exceptionDetails} = await this.send('Runtime.evaluate', {expression, returnByValue: true, awaitPromise: true});
        if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
        return result.value;
    }
    async key(key, text = '') {
        const code = {Tab: 9, Enter: 13, ' ': 32, Home: 36, ArrowLeft: 37, ArrowRight: 39, Escape: 27, PageDown: 34, PageUp: 33}[key];
        const of = {key, windowsVirtualKeyCode: code, ...text ? {text} : {}};
        await this.send('Input.dispatchKeyEvent', {type: 'keyDown', ...of});
        await this.send('Input.dispatchKeyEvent', {type: 'keyUp', ...of});
    }
    async mouse(type, x, y) {
        await this.send('Input.dispatchMouseEvent', {type, x, y, button: 'left', buttons: type === 'mouseReleased' ? 0 : 1, clickCount: 1});
    }
    async screenshot(full = false) {
        const {data} = await this.send('Page.captureScreenshot', {format: 'png', captureBeyondViewport: full});
        return Buffer.from(data, 'base64');
    }
    async close() {
        const gone = new Promise((resolve) => this.process.on('exit', resolve));
        this.process.kill('SIGKILL');  // nothing of it is kept
        await gone;
        rmSync(this.home, {recursive: true, force: true, maxRetries: 5});
    }
}
