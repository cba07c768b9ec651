// The engine of the static site: WebAssembly in a worker (worker.js). What it cannot answer in a minute is given
// up, and the worker started anew, so that a hostile file does not stop the page.

const longest = 60_000;  // ms
const languages = ['en', 'it', 'fr', 'de', 'es'];

/**
 * @typedef {import('../src/engine.js').Request} Request
 * @typedef {import('../src/engine.js').Answer} Answer
 */

/** A worker, and those who wait for its answers, in the order of their requests. */
class Engine {
    constructor() {
        /** @type {((answer: Answer) => void)[]} */
        this.waiting = [];
        this.start();
    }
    start() {
        this.worker = new Worker('worker.js', {type: 'module'});
        this.worker.addEventListener('message', ({data}) => this.waiting.shift()?.(data));
        this.worker.addEventListener('error', ({message}) => this.restart(message));
    }
    /** @param {string} why */
    restart(why) {
        this.worker?.terminate();
        for (const answer of this.waiting.splice(0))
            answer({faults: [], remarks: [], unsolved: [], title: '', failure: why});
        this.start();
    }
    /**
     * @param {Request} request
     * @returns {Promise<Answer>}
     */
    answer(request) {
        return new Promise((resolve) => {
            const timer = setTimeout(() => this.restart('no answer'), longest);
            this.waiting.push((answer) => {
                clearTimeout(timer);
                resolve(answer);
            });
            this.worker?.postMessage(JSON.stringify(request));
        });
    }
}

/** @returns {import('../src/engine.js').Engine} */
export function open() {
    document.documentElement.lang =
        navigator.languages.map((each) => each.slice(0, 2)).find((each) => languages.includes(each)) ?? 'en';
    // Where it is refused (a private window, say) the site needs the network.
    if ('serviceWorker' in navigator) navigator.serviceWorker.register('offline.js').catch(() => {});
    const engine = new Engine();
    return {answer: (request) => engine.answer(request), file: async () => null, save: null};
}
