// The path of a point on the mechanism, drawn once for a range, with a mark at the current position; and the plot.

import {fill, unscored} from './exercise.js';
import {drawn} from './measure.js';
import {Plot} from './plot.js';
/** @typedef {import('./motion.js').Motion} Motion */
/** @typedef {import('./page.js').Page} Page */
/** @typedef {import('./types.js').Column} Column */

/**
 * The name as on the sheet.
 * @param {Column} column
 */
export function nameOf({name, symbol}) {
    return unscored(symbol || name);
}

export class Traces {
    /** @param {Page} page */
    constructor(page) {
        this.page = page;
        /** @type {(() => void)[]} */
        this.marks = [];
    }
    wire() {
        for (const id of ['trace', 'plot']) this.page.at(id).onchange = () => this.draw();
    }
    /** @param {Motion} motion */
    fillLists(motion) {
        const {page} = this, trace = page.at('trace'), plot = page.at('plot');
        const none = ['', page.word('none')];
        const points = motion.data.points.flatMap(([body], i) => body === 0 ? [] :
            [[String(i), unscored(page.data.names.points[i].label)]]);
        fill(trace, [none, ...points], trace.value);
        fill(plot, [none, ...motion.data.columns.map((column, i) =>
            [String(i), column.unit === '' ? nameOf(column) : `${nameOf(column)} [${column.unit}]`])], plot.value);
    }
    /** Draws for the current language and driver. */
    draw() {
        const {page} = this, {motion} = page;
        for (const node of document.querySelectorAll('g.trace, figure.plot')) node.remove();
        this.marks = [];
        if (!motion) return;
        this.fillLists(motion);
        if (page.at('trace').value !== '') this.drawTrace(Number(page.at('trace').value));
        if (page.at('plot').value !== '') this.drawPlot(motion, Number(page.at('plot').value));
        page.stage.show();
    }
    get isTraced() {
        return this.page.at('trace').value !== '';
    }
    /** @param {number} point */
    drawTrace(point) {
        const {page} = this, path = page.pathOf(point);
        for (const view of page.figures.filter(({info}) => info.name === 'mechanism')) {
            const group = drawn(view.svg, 'g', {class: 'trace'});
            const spots = path.map((at) => view.paper(at)).map(({x, y}) => `${x.toFixed(3)} ${y.toFixed(3)}`);
            drawn(group, 'path', {d: `M${spots.join('L')}`});
            const mark = drawn(group, 'circle', {r: 1.2});
            this.marks.push(() => {
                const at = view.point(point);
                mark.setAttribute('cx', at.x.toFixed(3));
                mark.setAttribute('cy', at.y.toFixed(3));
            });
        }
    }
    /**
     * @param {Motion} motion
     * @param {number} index of the column
     */
    drawPlot(motion, index) {
        const {page} = this, plot = new Plot(page, motion, index), place = page.sheet.querySelector('.figures');
        if (!plot.isEmpty && place) this.marks.push(plot.draw(place));
    }
    show() {
        for (const mark of this.marks) mark();
    }
}
