// Tools of the reader on a figure: ends moved by pointer or keys, a ruler, values beside vectors. Knows figures; of the
// page only the visible figures and the words.

import {along, apart} from './path.js';
/** @typedef {import('./page.js').Page} Page */
/** @typedef {import('./types.js').Spot} Spot */

/** Step of an arrow key, and with the shift key, mm. */
const keyStep = 0.25, longKeyStep = 5;

/**
 * A new element of a drawing, in the namespace of the page's drawings.
 * @param {Element} parent
 * @param {string} tag
 * @param {Record<string, string | number>} attributes
 */
export function drawn(parent, tag, attributes) {
    const {namespaceURI} = /** @type {Element} */ (document.querySelector('svg'));
    const node = /** @type {SVGElement} */ (document.createElementNS(namespaceURI, tag));
    for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, String(value));
    parent.append(node);
    return node;
}

/**
 * @param {Element} line
 * @param {Spot} from
 * @param {Spot} to
 */
export function putLine(line, from, to) {
    for (const [name, value] of Object.entries({x1: from.x, y1: from.y, x2: to.x, y2: to.y}))
        line.setAttribute(name, value.toFixed(3));
}

/**
 * The pointer's position on the drawing, mm.
 * @param {SVGSVGElement} svg
 * @param {MouseEvent} event
 * @returns {Spot}
 */
export function spotUnder(svg, event) {
    const matrix = svg.getScreenCTM();
    return matrix ? new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse()) : {x: 0, y: 0};
}

/**
 * Removes what was laid on a figure.
 * @param {Element | null} group
 */
export function takeAway(group) {
    group?.closest('svg')?.setAttribute('role', 'img');
    group?.remove();
}

/** An end that can be dragged or moved by the arrow keys. */
export class Handle {
    /**
     * @param {Element} parent
     * @param {SVGSVGElement} svg
     * @param {string} name for screen readers
     * @param {(at: Spot, byHand: boolean) => void} onMove
     */
    constructor(parent, svg, name, onMove) {
        this.at = {x: 0, y: 0};
        this.node = drawn(parent, 'circle', {r: 1.6, class: 'handle', tabindex: 0, role: 'button', 'aria-label': name});
        const {node} = this;
        svg.setAttribute('role', 'group');  // an element with controls is no image
        node.addEventListener('pointerdown', (event) => {
            node.setPointerCapture(/** @type {PointerEvent} */ (event).pointerId);
            event.stopPropagation();
        });
        node.addEventListener('pointermove', (event) => {
            const pointer = /** @type {PointerEvent} */ (event);
            if (node.hasPointerCapture(pointer.pointerId)) onMove(spotUnder(svg, pointer), true);
        });
        node.addEventListener('keydown', (event) => {
            const {key, shiftKey} = /** @type {KeyboardEvent} */ (event);
            const by = /** @type {Record<string, Spot>} */ ({
                ArrowLeft: {x: -1, y: 0}, ArrowRight: {x: 1, y: 0}, ArrowUp: {x: 0, y: -1}, ArrowDown: {x: 0, y: 1},
            })[key];
            if (!by) return;
            event.preventDefault();
            event.stopPropagation();
            onMove(along(this.at, shiftKey ? longKeyStep : keyStep, by), false);
        });
    }
    /** @param {Spot} at */
    put(at) {
        this.at = at;
        this.node.setAttribute('cx', at.x.toFixed(3));
        this.node.setAttribute('cy', at.y.toFixed(3));
    }
}

/**
 * "62.4 mm ≙ 0.312 m/s"; on a mechanism its own lengths.
 * @param {number} length mm
 * @param {number} scale
 * @param {string} unit
 * @param {(value: number) => string} written
 */
export function measured(length, scale, unit, written) {
    const paper = `${written(Math.round(length * 10) / 10)} mm`,
        value = Number((length * scale * (unit === 'm' ? 1000 : 1)).toPrecision(3));
    return scale > 0 && unit !== '' ? `${paper} ≙ ${written(value)} ${unit === 'm' ? 'mm' : unit}` : paper;
}

/** A ruler on one figure. Its ends snap to points of the figure. */
export class Ruler {
    /** @param {Page} page */
    constructor(page) {
        this.page = page;
        this.isOn = false;
        /** @type {SVGSVGElement | null} */
        this.svg = null;
        /** @type {Element | null} */
        this.group = null;
        /** @type {() => void} */
        this.show = () => {};
    }
    /** @param {boolean} isOn */
    turn(isOn) {
        this.isOn = isOn;
        this.page.at('ruler').setAttribute('aria-pressed', String(isOn));
        for (const svg of document.querySelectorAll('.figures svg')) svg.classList.toggle('measuring', isOn);
        this.lay(isOn ? this.drawings[0] ?? null : null);
        if (isOn) /** @type {HTMLElement | null} */ (this.group?.querySelector('.handle'))?.focus();
    }
    /** @returns {SVGSVGElement[]} */
    get drawings() {
        return [...this.page.sheet.querySelectorAll('.figures svg')].map((svg) => /** @type {SVGSVGElement} */ (svg));
    }
    /**
     * The current scale of a figure: units of the quantity for a millimetre.
     * @param {SVGSVGElement} svg
     */
    scaleOf(svg) {
        const view = this.page.figures.find((each) => each.svg === svg), group = svg.querySelector('g.figure');
        const shown = view?.scales[0];
        return shown ? {scale: shown.now, unit: shown.unit} :
            {scale: Number(group?.getAttribute('data-scale') ?? 0), unit: group?.getAttribute('data-unit') ?? ''};
    }
    /**
     * @param {SVGSVGElement | null} svg
     * @param {[Spot, Spot]} [ends]
     */
    lay(svg, ends) {
        takeAway(this.group);
        this.group = null;
        this.svg = svg;
        this.show = () => {};
        if (!svg) return;
        const {x, y, width, height} = svg.viewBox.baseVal, {page} = this;
        const group = this.group = drawn(svg, 'g', {class: 'ruler'});
        const line = drawn(group, 'line', {}), text = /** @type {SVGTextElement} */ (drawn(group, 'text', {}));
        const from = ends ?? [{x: x + width / 4, y: y + height / 2}, {x: x + 3 * width / 4, y: y + height / 2}];
        const handles = from.map((at, i) => {
            const handle = new Handle(group, svg, page.word('ruler_end'), (to, byHand) => {
                handles[i].put(byHand ? this.snapped(svg, to) : to);
                this.show();
                page.announce(text.textContent ?? '');
            });
            handle.put(ends ? at : this.snapped(svg, at));
            handle.node.addEventListener('keydown', (event) => this.carry(/** @type {KeyboardEvent} */ (event)));
            return handle;
        });
        this.show = () => {
            const [a, b] = handles.map((each) => each.at), figure = this.scaleOf(svg);
            putLine(line, a, b);
            const turn = Math.atan2(a.y - b.y, b.x - a.x) * 180 / Math.PI;
            const length = measured(apart(a, b), figure.scale, figure.unit, (value) => page.numberText(value));
            text.textContent = `${length}, ${page.numberText(Math.round(turn * 10) / 10)}°`;
            const middle = {x: (a.x + b.x) / 2, y: (a.y + b.y) / 2},
                size = text.getBBox().width;
            text.setAttribute(
                'x',
                Math.min(Math.max(middle.x - size / 2, x + 1), Math.max(x + width - size - 1, x + 1)).toFixed(3),
            );
            text.setAttribute('y', Math.max(middle.y - 2.5, y + 5).toFixed(3));
        };
        this.show();
    }
    /**
     * Moves the ruler to the next or the previous figure.
     * @param {KeyboardEvent} event
     */
    carry(event) {
        const by = {PageDown: 1, PageUp: -1}[event.key];
        if (by === undefined || !this.svg) return;
        event.preventDefault();
        const {drawings} = this, count = drawings.length;
        this.lay(drawings[(drawings.indexOf(this.svg) + by + count) % count]);
        this.svg.scrollIntoView({block: 'nearest'});
        /** @type {HTMLElement | null} */ (this.group?.querySelector('.handle'))?.focus();
    }
    /**
     * Starts a new measurement at the pointer.
     * @param {SVGSVGElement} svg
     * @param {PointerEvent} event
     */
    begin(svg, event) {
        const at = this.snapped(svg, spotUnder(svg, event));
        this.lay(svg, [at, at]);
        const end = this.group?.querySelectorAll('.handle')[1];
        end?.setPointerCapture(event.pointerId);
        event.preventDefault();
    }
    /**
     * @param {SVGSVGElement} svg
     * @param {Spot} at
     */
    snapped(svg, at) {
        let best = at,
            least = 1.5;
        for (const spot of this.page.figures
            .filter((view) => view.svg === svg && view.follows)
            .flatMap((view) => view.extent())) {
            if (apart(spot, at) < least) [best, least] = [spot, apart(spot, at)];
        }
        return best;
    }
}
