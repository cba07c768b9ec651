// The examples, each with its drawing, which the engine makes when it comes into view.
import type {Bench} from './bench';
import {byId, html} from './dom';
import {picture} from './figures';
import type {Files} from './files';

export interface Example {
    path: string;
    title: string | Record<string, string>;
}

export class Gallery {
    dialog: HTMLDialogElement = byId('gallery');
    search: HTMLInputElement = byId('gallery-search');
    readonly observer: IntersectionObserver;
    /** One drawing after the other, so that the file's own answers come between. */
    queue: Promise<void>;
    isFilled: boolean | undefined;

    constructor(readonly bench: Bench, readonly files: Files) {
        this.search.addEventListener('input', () => this.filter());
        this.observer = new IntersectionObserver(
            (entries) =>
                entries
                    .filter((each) => each.isIntersecting)
                    .forEach(({target}) => {
                        this.observer.unobserve(target);
                        this.queue = this.queue.then(() => this.draw(target as HTMLElement));
                    }),
            {rootMargin: '200px'}
        );
        this.queue = Promise.resolve();
    }
    async open() {
        this.dialog.showModal();
        if (this.isFilled) return;
        this.isFilled = true;
        const all: Example[] = await (await fetch('examples.json')).json();
        byId('gallery-list').replaceChildren(...all.map((each) => this.card(each)));
        this.filter();  // what was typed while they were fetched
    }
    card({path, title}: Example) {
        const {language} = this.bench.inquiry,
            name = typeof title === 'string' ? title : (title[language] ?? title.en ?? '');
        const card = html(
            'button',
            {type: 'button', class: 'card', 'data-path': path, onclick: () => void this.choose(path)},
            html('span', {class: 'thumb'}),
            html('span', {}, name || path.replace(/^examples\/|\.json$/g, ''))
        );
        this.observer.observe(card);
        return card;
    }
    async draw(card: HTMLElement) {
        if (!this.dialog.open) return this.observer.observe(card);
        const path = card.dataset.path ?? '',
            text = await (await fetch(path)).text(),
            name = path.slice(path.lastIndexOf('/') + 1);
        const {inquiry} = this.bench,
            answer = await this.bench.engine.answer({
                text,
                name,
                want: [],
                figures: ['mechanism'],
                options: {...inquiry.options(), dimensions: 'off'}
            });
        const drawn = answer.figures?.mechanism;
        if (drawn) card.querySelector('.thumb')?.replaceChildren(picture(drawn, ''));
    }
    async choose(path: string) {
        const text = await (await fetch(path)).text();
        this.dialog.close();
        await this.files.openExample(text, path.slice(path.lastIndexOf('/') + 1));
    }
    filter() {
        const wanted = this.search.value.trim().toLowerCase();
        for (const card of this.dialog.querySelectorAll('.card'))
            (card as HTMLElement).hidden =
                wanted !== '' &&
                !`${card.textContent} ${(card as HTMLElement).dataset.path}`.toLowerCase().includes(wanted);
    }
}
