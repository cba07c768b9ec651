// The polygons beside the canvas, as the engine draws them.
import type {Bench} from './bench';
import {byId, html} from './dom';
import {word} from './words';

/** A picture of an SVG document; the page holds it as long as it is shown. */
export function picture(text: string, name: string) {
    const address = URL.createObjectURL(new Blob([text], {type: 'image/svg+xml'}));
    const image = html('img', {src: address, alt: name, class: 'figure'});
    image.addEventListener('load', () => URL.revokeObjectURL(address));
    image.addEventListener('error', () => URL.revokeObjectURL(address));
    return image;
}

export class Figures {
    readonly root = byId('figures');
    /** What is shown, so that what has not changed stays. */
    shown: Record<string, string> = {};

    constructor(readonly bench: Bench) {
        bench.on(['answer'], () => this.show());
        bench.on(['file'], () => bench.answer ?? this.clear());
    }
    /** Another file was opened. */
    clear() {
        this.shown = {};
        this.root.replaceChildren();
    }
    show() {
        const {answer} = this.bench;
        if (!answer || answer.faults.length > 0) return void this.root.classList.add('old');
        if (!answer.values) return;
        this.root.classList.toggle('old', 'isOld' in answer);
        const figures = answer.figures ?? {};
        if (Object.keys(figures).length === 0) {
            this.shown = {};
            this.root.replaceChildren(html('p', {class: 'empty'}, this.why()));
            return;
        }
        if (JSON.stringify(figures) === JSON.stringify(this.shown)) return;
        this.shown = figures;
        this.root.replaceChildren(
            ...Object.entries(figures).map(([name, text]) =>
                html(
                    'figure',
                    {},
                    html('figcaption', {}, word(`figure_${name}`)),
                    picture(text, word(`figure_${name}`))
                )
            )
        );
    }
    /** Why there is no polygon yet. */
    why() {
        const {answer, model} = this.bench;
        if (model.hasJoints && model.drivers.length === 0 && model.loads.length === 0) return word('no_figures_yet');
        const [first] = answer?.unsolved ?? [];
        return first ? `${first.what}: ${first.why}` : word('no_figures_yet');
    }
}
