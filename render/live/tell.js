// Highlights what belongs to the vector under the pointer: its body on the mechanism, its rows in the table of values,
// and its current value beside its name.

import {holdOf} from './held_marks.js';
import {drawn} from './measure.js';
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./page.js').Page} Page */
/** @typedef {import('./paper.js').Names} Names */

export class Teller {
    /** @param {Page} page */
    constructor(page) {
        this.page = page;
        /** @type {Element | null} */
        this.written = null;
    }
    /** @returns {Names} */
    get names() {
        return this.page.data.names;
    }
    /**
     * The number of the statement of a sentence or stroke.
     * @param {EventTarget | null} target
     */
    saidAt(target) {
        const node = target instanceof Element ? target.closest('[data-statement], [data-says]') : null;
        return node && (node.getAttribute('data-statement') ?? node.getAttribute('data-says'));
    }
    /**
     * Highlights the strokes of a sentence, or the sentence of a stroke.
     * @param {string | null} number
     */
    light(number) {
        for (const node of this.page.sheet.querySelectorAll('.lit')) node.classList.remove('lit');
        if (number === null) return;
        for (const node of this.page.sheet.querySelectorAll(`[data-statement="${number}"], [data-says="${number}"]`))
            node.classList.add('lit');
    }
    /** @param {EventTarget | null} target the node under the pointer */
    tell(target) {
        const {page} = this, {motion} = page;
        this.written?.remove();
        this.written = null;
        const node = target instanceof Element ? target.closest('g.vector, g.force') : null;
        const view = node && page.figures.find(({group}) => group.contains(node));
        if (!node || !view || !motion) return;
        const name = node.getAttribute('data-name') ?? '';
        const points = this.pointsOf(name), bodies = this.bodiesOf(name);
        motion.data.columns.forEach((column, i) => {
            const isPoint = points.includes(column.point) && column.name[0] === name[0];
            const isForce =
                bodies.length === 2
                && (column.name.endsWith(` ${bodies[0]} on ${bodies[1]}`)
                    || column.name.endsWith(` ${bodies[1]} on ${bodies[0]}`));
            if (isPoint || isForce)
                page.sheet.querySelector(`td[data-column="${i}"]`)?.closest('tr')?.classList.add('lit');
        });
        const own = bodies.length === 2 ? this.names.bodies.findIndex(({label}) => label === bodies[1]) :
            points.length > 0 ? motion.data.points[points[0]][0] : -1;
        const {id} = this.names.bodies[own] ?? {};
        if (own > 0)
            for (const link of page.sheet.querySelectorAll(`[data-id="link-${CSS.escape(id)}"]`))
                link.classList.add('lit');
        this.write(node, view, name);
    }
    /**
     * "v_B", "a_B^n": B; none for a vector of C relative to B.
     * @param {string} name
     * @returns {number[]}
     */
    pointsOf(name) {
        const rest = /^[va]_/.test(name) ? name.slice(2).replace(/\^.*|\*/g, '') : '';
        const {points} = this.names, labels = points.map(({label}) => label.replace('_', ''));
        const whole = labels.indexOf(rest.replace('_', ''));
        return rest !== '' && whole >= 0 ? [whole] : [];
    }
    /**
     * "F_32": bodies 3 and 2 (of 3 on 2).
     * @param {string} name
     * @returns {string[]}
     */
    bodiesOf(name) {
        const {bodies} = this.names, rest = name.startsWith('F_') ? name.slice(2) : '';
        for (const {label} of bodies) {
            const on = rest.startsWith(label) ? rest.slice(label.length) : '';
            if (bodies.some((each) => each.label === on)) return [label, on];
        }
        return [];
    }
    /**
     * @param {Element} node
     * @param {FigureView} view
     * @param {string} name
     */
    write(node, view, name) {
        const {page} = this, {held} = view, on = held && node.hasAttribute('data-on') ? holdOf(node).on : null;
        const isForce = held !== null && on !== null && on.length === 2 && holdOf(node).form === 'arrow';
        const size = isForce ? held.sizeOf(on) / held.inUnit : view.sizeOf(name);
        if (size === null || !(size >= 0)) return;
        const said = `= ${page.numberText(Number(size.toPrecision(4)))} ${isForce ? held.unit : view.unit}`;
        const title = node.querySelector(':scope > title');  // the browser's tooltip
        if (title) title.textContent = `${name} ${said}`;
        const label = [...view.group.querySelectorAll('g.label')].find(
            (each) => each.getAttribute('data-label') === name,
        );
        if (!label || label.querySelector('text')) return;
        const box = /** @type {SVGGraphicsElement} */ (label).getBBox();
        this.written = drawn(label, 'text', {x: box.x + box.width + 0.6, y: box.y + 0.75 * box.height});
        this.written.textContent = said;
    }
}
