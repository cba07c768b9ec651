// The engine of the static site: WebAssembly in a worker (worker.js). What it cannot answer in a minute is given
// up, and the worker started anew, so that a hostile file does not stop the page.
import type {Answer, Request} from '../../app/workbench/protocol';
import type {Engine} from '../src/engine';

const longest = 60_000;  // ms
const languages = ['en', 'it', 'fr', 'de', 'es'];

/** A worker, and those who wait for its answers, in the order of their requests. */
class WorkerEngine implements Engine {
    readonly save = null;
    waiting: ((answer: Answer) => void)[] = [];
    worker: Worker | undefined;

    constructor() {
        this.start();
    }
    start() {
        this.worker = new Worker('worker.js');
        this.worker.addEventListener('message', ({data}) => this.waiting.shift()?.(data));
        this.worker.addEventListener('error', ({message}) => this.restart(message));
    }
    restart(why: string) {
        this.worker?.terminate();
        for (const answer of this.waiting.splice(0))
            answer({faults: [], remarks: [], unsolved: [], title: '', failure: why});
        this.start();
    }
    /** The site has no file of its own. */
    file() {
        return Promise.resolve(null);
    }
    answer(request: Request): Promise<Answer> {
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

export function open(): Engine {
    document.documentElement.lang =
        navigator.languages.map((each) => each.slice(0, 2)).find((each) => languages.includes(each)) ?? 'en';
    // Where it is refused (a private window, say) the site needs the network.
    if ('serviceWorker' in navigator) navigator.serviceWorker.register('offline.js').catch(() => {});
    return new WorkerEngine();
}
