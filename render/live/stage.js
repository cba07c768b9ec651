// The stage: which figures are shown, and where. A figure belongs to a layer (centres, velocities, forces ...), which
// the reader or the step turns on. Drawings of the mechanism share one place: the first is shown as it is, the others
// are laid on it without what both show.

import {boxOf} from './path.js';
import {mostRoomy} from './room.js';
/** @typedef {import('./area.js').Area} Area */
/** @typedef {import('./page.js').Page} Page */
/** @typedef {import('./paper.js').FigureInfo} FigureInfo */

/** @typedef {{node: HTMLElement, name: string, info: FigureInfo}} Staged */

/**
 * A plot is no figure of the solution.
 * @type {FigureInfo}
 */
const plot = {name: 'plot', layer: 'others', origin: [0, 0], labels: []};
/** A figure is not shown lower than this, px; then the stage scrolls. Figures of steps share what there is. */
const leastHeight = 150;
/** Area for each figure of a step, px²; with less only the one that shows the step is there. */
const leastRoom = 36000;

export class Stage {
    /** @param {Page} page */
    constructor(page) {
        this.page = page;
        const all = new Set(this.allFigures().map(({info}) => info.layer).filter((layer) => layer !== ''));
        const isLast = all.delete(plot.layer);
        /** Layers that there are, in the order in which they are offered. */
        this.layers = [...all, ...isLast ? [plot.layer] : []];
        const first = ['velocities', 'accelerations'].filter((layer) => this.layers.includes(layer));
        const next = this.layers.includes('forces') ? ['forces'] : this.layers;
        /** Layers that the reader has turned on. */
        this.chosen = new Set(first.length > 0 ? first : next);
        /**
         * Figures of the step; null: there is none.
         * @type {Set<string> | null}
         */
        this.ofStep = null;
        /**
         * Layers that the reader has added to the step, or taken from it.
         * @type {Map<string, boolean>}
         */
        this.turned = new Map();
        /** @type {Element[]} */
        this.shown = [];
        /**
         * Drawings that are laid on each other, the lowest first.
         * @type {Element[]}
         */
        this.stacked = [];
        this.isApart = false;
    }
    wire() {
        const watcher = new ResizeObserver(() => this.layOut());
        for (const sheet of this.page.sheets) watcher.observe(/** @type {Element} */ (sheet.querySelector('.figures')));
        window.addEventListener('beforeprint', () => this.setApart(true));
        window.addEventListener('afterprint', () => this.setApart(false));
        document.addEventListener('languagechosen', () => this.showChips());
    }
    /**
     * The figures of the current sheet; the plot stands after those that have data.
     * @returns {Staged[]}
     */
    allFigures() {
        const {page} = this, infos = page.data.figures[page.language];
        return [...page.sheet.querySelectorAll('.figures > figure')].map((node, i) => {
            const info = infos[i] ?? plot;
            return {node: /** @type {HTMLElement} */ (node), name: info.name, info};
        });
    }
    /** @param {string} layer */
    isOn(layer) {
        if (!this.ofStep) return this.chosen.has(layer);
        const {ofStep} = this;
        const shows = this.allFigures().some(({info}) => info.layer === layer && ofStep.has(info.name));
        return this.turned.get(layer) ?? shows;
    }
    /** @param {string} layer */
    turn(layer) {
        const isOn = !this.isOn(layer);
        if (this.ofStep) this.turned.set(layer, isOn);
        else if (isOn) this.chosen.add(layer);
        else this.chosen.delete(layer);
        this.show();
    }
    /**
     * All figures, each by itself, as on paper.
     * @param {boolean} isApart
     */
    setApart(isApart) {
        this.isApart = isApart;
        this.show();
    }
    /** @param {Set<string> | null} figures of a step, by name */
    take(figures) {
        const isSame = figures && this.ofStep && [...figures].join() === [...this.ofStep].join();
        this.ofStep = figures;
        if (!isSame) this.turned.clear();
        this.show();
    }
    /** @param {FigureInfo} info */
    isShown(info) {
        const {page, ofStep} = this, {name, layer} = info;
        if (this.isApart) return true;
        if (info === plot) return page.mode === 'move';
        if (page.mode === 'try') return this.isOfTask(info);
        if (!ofStep) return layer === '' || this.chosen.has(layer);
        if (layer === '') return true;
        return this.turned.get(layer) ?? ofStep.has(name);
    }
    /**
     * Of an exercise: the polygon, the mechanism, and its drawing with what the polygon is of, loads among them.
     * @param {FigureInfo} info
     */
    isOfTask(info) {
        const polygon = this.page.exercise.view?.info;
        if (info.layer === '' || info.name === polygon?.name) return true;
        return info.isStacked === true && info.layer === polygon?.layer;
    }

    /** Shows the figures, and brings those that were hidden to the position. */
    show() {
        const {page} = this, all = this.allFigures();
        for (const {node, info} of all) node.classList.toggle('shown', this.isShown(info));
        if (!this.isApart) this.showMechanism(all);
        const shown = all.filter(({node}) => node.matches('.shown'));
        this.shown = [true, false].flatMap((isFirst) =>
            shown.filter(({info}) => (info.isStacked === true) === isFirst).map(({node}) => node));
        this.showChips();
        this.stack(all);
        this.layOut();
        page.show();
    }
    /**
     * The bare mechanism stands alone or under a layer that does not name its points.
     * @param {Staged[]} all
     */
    showMechanism(all) {
        const bare = all.find(({info}) => info.layer === '')?.node, known = new Set(bare ? labelsOf(bare) : []);
        const over = all.filter(({node, info}) => node !== bare && info.isStacked && node.matches('.shown'));
        const names = over.some(({node}) => labelsOf(node).filter((label) =>
            known.has(label)).length >= known.size / 2);
        bare?.classList.toggle('shown', over.length === 0 || (!names && this.infoOf(bare).places !== undefined));
    }
    showChips() {
        const {page, layers} = this, place = page.at('layers');
        if (place.childElementCount !== layers.length) {
            place.textContent = '';
            for (const layer of layers.length > 1 ? layers : []) {
                const chip = place.appendChild(document.createElement('button'));
                Object.assign(chip, {type: 'button', onclick: () => this.turn(layer)});
            }
        }
        [...place.children].forEach((chip, i) => {
            chip.textContent = page.word(`layer_${layers[i]}`);
            chip.setAttribute('aria-pressed', String(this.isOn(layers[i])));
        });
    }

    // --- drawings of the mechanism on each other ---------------------------------------------------------------------

    /** @param {Staged[]} all */
    stack(all) {
        const drawings = all.filter(({node, info}) => info.isStacked && node.matches('.shown'));
        const placed = this.isApart ? [] : drawings.filter(({node}) => this.infoOf(node).places);
        this.stacked = placed.length > 1 ? placed.map(({node}) => node) : [];
        const [under, ...over] = this.stacked, known = new Set(under ? labelsOf(under) : []);
        // A name with a number stands where the layer has it, beside the layer's arrows; other names where the lowest
        // has
        // them, which has no room for two scale bars either.
        const numbers = new Set(over.flatMap(labelsOf).filter((label) => label?.includes(' = ')));
        for (const {node} of all) {
            const isOver = over.includes(node);
            node.classList.toggle('overlay', isOver);
            for (const label of node.querySelectorAll('g.label')) {
                const name = label.getAttribute('data-label');
                const isTwin = isOver ? known.has(name) && !numbers.has(name) : node === under && numbers.has(name);
                label.classList.toggle('twin', isTwin);
            }
            for (const mark of node.querySelectorAll('svg > g.text, svg > path, svg > rect'))
                mark.classList.toggle('twin', isOver);
        }
        for (const view of this.page.figures) {
            // The scale bar of the lowest: its place may be another's, and its scale is in the caption.
            const isUnder = view.svg.closest('figure') === this.stacked[0];
            for (const mark of view.scaleBar) mark.classList.toggle('beneath', isUnder);
        }
        for (const {node} of all) this.fitOverlay(node);
    }
    /**
     * @param {Element} node
     * @returns {FigureInfo}
     */
    infoOf(node) {
        const {page} = this;
        return page.data.figures[page.language][this.allFigures().findIndex((each) => each.node === node)];
    }
    /**
     * The area of a drawing: its own, and if it is laid on others the common one. Call when areas have changed.
     * @param {Element} node
     */
    fitOverlay(node) {
        const {stacked} = this, svg = node.querySelector('svg.drawing');
        if (!svg || (!stacked.includes(node) && !svg.matches('.fitted'))) return;
        const own = this.areaOf(node);
        svg.classList.toggle('fitted', stacked.includes(node));
        if (!stacked.includes(node)) return svg.setAttribute('viewBox', own.join(' '));
        const {origin, places = 1} = this.infoOf(node);
        const areas = stacked.map((other) => {
            const info = this.infoOf(other), [x, y, width, height] = this.areaOf(other),
                k = (info.places ?? 1) / places;
            const left = origin[0] + (x - info.origin[0]) * k, top = origin[1] + (y - info.origin[1]) * k;
            return [{x: left, y: top}, {x: left + width * k, y: top + height * k}];
        });
        const {left, right, top, bottom} = boxOf(areas.flat());
        svg.setAttribute('viewBox', [left, top, right - left, bottom - top].map((each) => each.toFixed(3)).join(' '));
    }
    /**
     * Left, top, width, height in mm, without other drawings.
     * @param {Element} node
     */
    areaOf(node) {
        const svg = /** @type {SVGSVGElement} */ (node.querySelector('svg.drawing'));
        svg.dataset.area ??= svg.getAttribute('viewBox') ?? '';
        return this.page.figures.find((view) => view.svg === svg)?.shownRoom ?? svg.dataset.area.split(' ').map(Number);
    }

    // --- places ------------------------------------------------------------------------------------------------------

    /** Columns and rows in which the figures are largest. */
    layOut() {
        const place = /** @type {HTMLElement} */ (this.page.sheet.querySelector('.figures'));
        const all = this.shown.filter((node) => !node.matches('.overlay'));
        if (all.length === 0 || place.clientWidth === 0) return;
        // A small screen has room for the figure of the step only.
        const isCrowded = this.ofStep !== null && place.clientWidth * place.clientHeight < leastRoom * all.length;
        const isMain = (/** @type {Element} */ node) => node.matches('[data-shows]');
        const main = this.stacked.some(isMain) ? this.stacked : this.shown.filter(isMain);
        for (const {node} of this.allFigures()) node.classList.toggle('aside', isCrowded && !main.includes(node));
        const cells = isCrowded ? all.filter((node) => main.includes(node)) : all;
        const least = this.page.mode === 'steps' && this.ofStep ? 0 : leastHeight;
        // A caption takes more lines in a narrow column: the places are chosen anew until captions are as they were.
        for (let round = 0, before = ''; round < 4; ++round) {
            const shapes = cells.map((node) => cellShape(node, isMain(node)));
            const captions = shapes.map(({caption}) => caption).join();
            if (captions === before) break;
            before = captions;
            const {clientWidth, clientHeight} = place;
            this.put(place, cells, mostRoomy(shapes, clientWidth - 24, clientHeight - 8, least, !this.ofStep), least);
        }
        // So that keys can scroll it.
        if (place.scrollHeight > place.clientHeight + 1) place.tabIndex = 0;
        else place.removeAttribute('tabindex');
    }
    /**
     * @param {HTMLElement} place
     * @param {Element[]} cells
     * @param {import('./room.js').Places} places
     * @param {number} least height of a figure
     */
    put(place, cells, {wide, tall, at}, least) {
        const parts = (/** @type {number[]} */ all) => all.map((part) => (100 * part).toFixed());
        place.style.gridTemplateColumns = parts(wide).map((part) => `minmax(0, ${part}fr)`).join(' ');
        place.style.gridTemplateRows = parts(tall).map((part) => `minmax(${least}px, ${part}fr) auto`).join(' ');
        const set = (/** @type {Element} */ node, /** @type {number} */ i) => {
            const [row, column, rows] = at[i], {style} = /** @type {HTMLElement} */ (node);
            style.gridArea = `${2 * row + 1} / ${column + 1} / span ${2 * rows} / span 1`;
        };
        cells.forEach(set);
        const under = cells.indexOf(this.stacked[0]);
        for (const node of under < 0 ? [] : this.stacked.slice(1)) set(node, under);
    }
}

/** @param {Element} drawing */
function labelsOf(drawing) {
    return [...drawing.querySelectorAll('g.label')].map((label) => label.getAttribute('data-label'));
}

/**
 * @param {Element} node
 * @param {boolean} isMain
 */
function cellShape(node, isMain) {
    const area = node.querySelector('svg')?.getAttribute('viewBox') ?? '';
    const [, , width, height] = area.split(' ').map(Number);
    const caption = /** @type {HTMLElement | null} */ (node.querySelector('figcaption'))?.offsetHeight ?? 0;
    return {width, height, caption, isMain};
}
