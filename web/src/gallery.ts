// The examples, each with its drawing, which the engine makes when it comes into view.
import {byId, html} from './dom.js';
import {picture} from './figures.js';

/**
 * @typedef {import('./bench.js').Bench} Bench
 * @typedef {{path: string, title: string | Record<string, string>}} Example
 */

export class Gallery {
    /**
     * @param {Bench} bench
     * @param {import('./files.js').Files} files
     */
    constructor(bench, files) {
        this.bench = bench;
        this.files = files;
        /** @type {HTMLDialogElement} */
        this.dialog = byId('gallery');
        /** @type {HTMLInputElement} */
        this.search = byId('gallery-search');
        this.search.addEventListener('input', () => this.filter());
        this.observer = new IntersectionObserver(
            (entries) =>
                entries
                    .filter((each) => each.isIntersecting)
                    .forEach(({target}) => {
                        this.observer.unobserve(target);
                        this.queue = this.queue.then(() => this.draw(/** @type {HTMLElement} */ (target)));
                    }),
            {rootMargin: '200px'}
        );
        /** One drawing after the other, so that the file's own answers come between. */
        this.queue = Promise.resolve();
    }
    async open() {
        this.dialog.showModal();
        if (this.isFilled) return;
        this.isFilled = true;
        /** @type {Example[]} */
        const all = await (await fetch('examples.json')).json();
        byId('gallery-list').replaceChildren(...all.map((each) => this.card(each)));
    }
    /** @param {Example} example */
    card({path, title}) {
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
    /** @param {HTMLElement} card */
    async draw(card) {
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
    /** @param {string} path */
    async choose(path) {
        const text = await (await fetch(path)).text();
        this.dialog.close();
        await this.files.openExample(text, path.slice(path.lastIndexOf('/') + 1));
    }
    filter() {
        const wanted = this.search.value.trim().toLowerCase();
        for (const card of this.dialog.querySelectorAll('.card'))
            /** @type {HTMLElement} */ (card).hidden =
                wanted !== '' &&
                !`${card.textContent} ${/** @type {HTMLElement} */ (card).dataset.path}`.toLowerCase().includes(wanted);
    }
}
