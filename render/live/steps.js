// Reading step by step: which sentence and which strokes are shown, and in which figures.

import {fill} from './exercise.js';
/** @typedef {import('./page.js').Page} Page */
/** @typedef {import('./stage.js').Staged} Staged */

export class Steps {
    /** @param {Page} page */
    constructor(page) {
        this.page = page;
        /** −1: all steps. */
        this.at = 0;
    }
    /**
     * The sentences of the visible sheet, in order.
     * @returns {HTMLElement[]}
     */
    get says() {
        return [...this.page.sheet.querySelectorAll('li[data-says]')].map((each) => /** @type {HTMLElement} */ (each));
    }
    wire() {
        const {page} = this;
        if (!page.at('previous')) return;
        page.at('previous').onclick = () => this.go(this.at < 0 ? this.says.length - 1 : Math.max(this.at - 1, 0));
        page.at('next').onclick = () => this.go(Math.min(this.at + 1, this.says.length - 1));
        page.at('all').onclick = () => this.go(this.at < 0 ? 0 : -1);
        page.at('chapter').onchange = () => this.go(Number(page.at('chapter').value));
        document.addEventListener('languagechosen', () => this.fillChapters());
        new ResizeObserver(() => this.fitSentence()).observe(document.body);
    }
    /** @param {number} step */
    go(step) {
        this.page.setMode('steps');
        this.show(step);
    }
    /** Chapters by the number of their first step. */
    fillChapters() {
        const {page, says} = this, list = page.at('chapter');
        const chapters = [...page.sheet.querySelectorAll('.chapter')].map((chapter, i) => {
            const first = /** @type {HTMLElement} */ (chapter.querySelector('li'));
            const name = (chapter.querySelector('h2')?.textContent ?? '').replace(/^[^:]*:\s*/, '');
            return [String(says.indexOf(first)), `${i + 1} ${name.charAt(0).toUpperCase()}${name.slice(1)}`];
        });
        fill(list, chapters, list.value);
    }
    /** @param {HTMLElement} sentence */
    static numberOf(sentence) {
        return Number(sentence.dataset.says);
    }
    /**
     * @param {number} step −1: all
     * @param {boolean} announced
     */
    show(step, announced = true) {
        const {page, says} = this;
        this.at = says.length > 0 ? Math.min(step, says.length - 1) : -1;
        const reads = page.mode === 'steps' && this.at >= 0, sentence = reads ? says[this.at] : null;
        says.forEach((each) => {
            each.classList.toggle('now', each === sentence);
            if (each === sentence) each.setAttribute('aria-current', 'step');
            else each.removeAttribute('aria-current');
        });
        this.mark(sentence ? Steps.numberOf(sentence) : null);
        const open = sentence?.closest('.chapter');
        for (const chapter of page.sheet.querySelectorAll('.chapter')) chapter.classList.toggle('open', !open ||
            chapter === open);
        for (const list of page.sheet.querySelectorAll('.steps')) list.classList.toggle('read', reads);
        document.documentElement.classList.toggle('all', page.mode === 'steps' && !reads);
        this.showFigures(sentence);
        const where = this.showWhere(open ?? null);
        if (!sentence) return;
        this.fitSentence();
        if (announced) page.announce(`${where}: ${spoken(sentence)}`);
    }
    /**
     * The strokes of a statement, of those before it, of the next, and of later ones.
     * @param {number | null} now null: all alike
     */
    mark(now) {
        const {page, says} = this, next = now === null ? null : says[this.at + 1];
        const coming = next ? Steps.numberOf(next) : -1;
        for (const svg of page.sheet.querySelectorAll('.figures svg')) svg.classList.toggle('reading', now !== null);
        for (const node of page.sheet.querySelectorAll('svg [data-statement]')) {
            const drawn = Number(node.getAttribute('data-statement'));
            node.classList.toggle('now', drawn === now);
            node.classList.toggle('past', now !== null && drawn < now);
            node.classList.toggle('later', now !== null && drawn > now);
            node.classList.toggle('next', now !== null && drawn === coming);
        }
    }
    /**
     * Hides strokes and sentences by their statement.
     * @param {(statement: number) => boolean} isHidden
     */
    hideStatements(isHidden) {
        for (const svg of this.page.sheet.querySelectorAll('.figures svg')) svg.classList.add('reading');
        for (const node of this.page.sheet.querySelectorAll('svg [data-statement], li[data-says]')) {
            node.classList.remove('now', 'past', 'next');
            node.classList.toggle('later',
                isHidden(Number(node.getAttribute('data-statement') ?? node.getAttribute('data-says'))));
        }
    }
    /**
     * The position in words, and the buttons that lead on.
     * @param {Element | null} chapter
     */
    showWhere(chapter) {
        const {page, says} = this, {at} = this;
        if (!page.at('step')) return '';
        const put = (/** @type {string} */ key, /** @type {number} */ i, /** @type {number} */ count) =>
            page.word(key).replace('{0}', String(i)).replace('{1}', String(count));
        const own = [...chapter?.querySelectorAll('li') ?? []];
        page.at('step').textContent = at < 0 || !chapter ? '' :
            put('step_of_chapter', own.indexOf(/** @type {HTMLLIElement} */ (says[at])) + 1, own.length);
        if (own.length > 0) page.at('chapter').value = String(says.indexOf(own[0]));
        page.at('all').setAttribute('aria-pressed', String(at < 0));
        page.at('previous').disabled = page.mode === 'steps' && at <= 0;
        page.at('next').disabled = page.mode === 'steps' && at === says.length - 1;
        return at < 0 ? '' : put('step', at + 1, says.length);
    }

    // --- the figures of a step ---------------------------------------------------------------------------------------

    /** @param {HTMLElement | null} sentence */
    showFigures(sentence) {
        const {page} = this, figures = sentence ? this.figuresOf(sentence) : [];
        const all = page.stage.allFigures(), last = figures[figures.length - 1];
        for (const node of page.sheet.querySelectorAll('[data-shows]')) node.removeAttribute('data-shows');
        const shown = all.find(({name, info}) => last ? name === last : info.layer === '') ?? all[0];
        if (sentence) shown?.node.setAttribute('data-shows', 'step');
        page.stage.take(sentence ? new Set(figures) : null);
    }
    /**
     * A drawing of the mechanism and another figure, by name; last the one that shows the step. What a step does not
     * draw on stands as the steps before it in the chapter left it.
     * @param {HTMLElement} sentence
     * @returns {string[]}
     */
    figuresOf(sentence) {
        const own = [...sentence.closest('.chapter')?.querySelectorAll('li') ?? []];
        const here = own.indexOf(/** @type {HTMLLIElement} */ (sentence));
        const all = this.page.stage.allFigures();
        /** @type {{name: string, count: number, isNow: boolean}[]} */
        const found = [];
        for (const isMechanism of [true, false]) {
            const some = all.filter(({info}) => (info.isStacked === true) === isMechanism);
            for (let i = here; i >= 0; --i) {
                const best = mostDrawn(some, own[i]);
                if (best) found.push({...best, isNow: i === here});
                if (best) break;
            }
        }
        const last = found.filter(({isNow}) => isNow).pop() ?? found[found.length - 1];
        return [...found.filter((each) => each !== last), ...last ? [last] : []].map(({name}) => name);
    }
    /** Smaller letters for a sentence that its place has no room for. */
    fitSentence() {
        const {page} = this, sentence = page.sheet.querySelector('li.now');
        const pane = /** @type {HTMLElement | null} */ (sentence?.closest('.text'));
        if (!sentence || !pane) return;
        const head = this.page.at('reading').offsetHeight + 12;
        for (const size of [1, 0.92, 0.85, 0.78, 0.72, 0.66, 0.6]) {
            pane.style.setProperty('--fit', String(size));
            if (sentence.getBoundingClientRect().height <= pane.clientHeight - head) break;
        }
        // The sentences before it stay in sight as far as there is room.
        const top = sentence.getBoundingClientRect().top - pane.getBoundingClientRect().top;
        pane.scrollTop += top - Math.max(head, (pane.clientHeight - sentence.clientHeight) / 3);
    }
}

/**
 * The figure with the most strokes of a sentence; of several with as many that of a body which it speaks of.
 * @param {Staged[]} figures
 * @param {HTMLElement} sentence
 */
function mostDrawn(figures, sentence) {
    const bodies = (sentence.dataset.bodies ?? '').split(' ');
    const counted = figures.map(({node, name, info}) => ({
        name,
        count: node.querySelectorAll(`[data-statement="${sentence.dataset.says}"]`).length
            + (info.freeBody && bodies.includes(info.freeBody) ? 0.5 : 0),
        // The polygon of one body alone is larger than beside those of others.
        isOfOne: info.isOfOne === true,
    })).filter(({count}) => count >= 1);
    return counted.sort((a, b) => Number(b.isOfOne) - Number(a.isOfOne) || b.count - a.count)[0];
}

/**
 * A sentence as a screen reader reads it, without its equation's table.
 * @param {Element} sentence
 */
export function spoken(sentence) {
    return withoutTables(sentence).textContent ?? '';
}
/** @param {Element} sentence */
export function withoutTables(sentence) {
    const copy = /** @type {Element} */ (sentence.cloneNode(true));
    for (const table of copy.querySelectorAll('table')) table.remove();
    return copy;
}
