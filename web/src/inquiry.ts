// Asks the engine after every change: first where everything is, then the rest. One question at a time; what became
// old while it was answered is dropped.
import type {Bench} from './bench';
import type {Answer, Want} from '../../app/workbench/protocol';

/** Between a change and the question for figures, ms: while something is dragged they wait. */
const pause = 120;
const shown = ['velocity', 'acceleration', 'forces', 'truss', 'cremona'];

export class Inquiry {
    isAsking = false;
    isStale = false;
    number = 0;
    timer: number | undefined;
    theme = 'colour';
    language = 'en';
    /** How long the engine took for the whole, ms. */
    took = 0;

    constructor(readonly bench: Bench) {}
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
    async once(want: Want[], figures: string[] = []) {
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
    /** One answer besides, for a view of its own. */
    async other(want: Want[], figures: string[] = [], options: Record<string, unknown> = {}) {
        const {text, name} = this.bench.document;
        return this.bench.engine.answer({text, name, want, figures, options: {...this.options(), ...options}});
    }
}

/** What stays on the screen until the next whole answer. */
const kept = ({values, names, figures, unsolved}: Answer) => ({values, names, figures, unsolved, isOld: true});
