// Asks the engine after every change: first where everything is, then the rest. One question at a time; what became
// old while it was answered is dropped.

/**
 * @typedef {import('./bench.js').Bench} Bench
 * @typedef {import('../../app/workbench/protocol.js').Want} Want
 * @typedef {import('../../app/workbench/protocol.js').Answer} Answer
 */

/** Between a change and the question for figures, ms: while something is dragged they wait. */
const pause = 120;
const shown = ['velocity', 'acceleration', 'forces', 'truss', 'cremona'];

export class Inquiry {
    /** @param {Bench} bench */
    constructor(bench) {
        this.bench = bench;
        this.isAsking = false;
        this.isStale = false;
        this.number = 0;
        /** @type {number | undefined} */
        this.timer = undefined;
        this.theme = 'colour';
        this.language = 'en';
        /** How long the engine took for the whole, ms. */
        this.took = 0;
    }
    /** The file has changed. */
    ask() {
        ++this.number;
        if (this.isAsking) this.isStale = true;
        else void this.run();
    }
    async run() {
        this.isAsking = true;
        do {
            this.isStale = false;
            await this.once(['position', 'mobility']);
            if (this.isStale) continue;
            await new Promise((resolve) => (this.timer = setTimeout(resolve, pause)));
            if (!this.isStale) await this.once(['position', 'mobility', 'values', 'names', 'results'], this.figures());
        } while (this.isStale);
        this.isAsking = false;
    }
    /** The figures to show beside: those that the last answer had. */
    figures() {
        return shown;
    }
    /**
     * @param {Want[]} want
     * @param {string[]} [figures]
     */
    async once(want, figures = []) {
        const {bench, number} = this, {text, name} = bench.document, began = performance.now();
        const answer = await bench.engine.answer({text, name, want, figures, options: this.options()});
        if (number !== this.number) return;
        if (want.includes('values')) this.took = performance.now() - began;
        else if (bench.answer && answer.faults.length === 0) Object.assign(answer, kept(bench.answer));
        bench.onAnswer(answer);
    }
    options() {
        return {lang: this.language, theme: this.theme};
    }
    /**
     * One answer besides, for a view of its own.
     * @param {Want[]} want
     * @param {string[]} [figures]
     * @param {Record<string, unknown>} [options]
     */
    async other(want, figures = [], options = {}) {
        const {text, name} = this.bench.document;
        return this.bench.engine.answer({text, name, want, figures, options: {...this.options(), ...options}});
    }
}

/**
 * What stays on the screen until the next whole answer.
 * @param {Answer} answer
 */
const kept = ({values, names, figures, unsolved}) => ({values, names, figures, unsolved, isOld: true});
