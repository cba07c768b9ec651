// The plot of a value over the driver's range, with axes, ticks, units, and the stops and poles of the range; and the
// path of a point on the mechanism. Each is drawn once for a range; a mark runs along.

import {fill, unscored} from './exercise.js';
import {drawn} from './measure.js';
/** @typedef {import('./motion.js').Motion} Motion */
/** @typedef {import('./page.js').Page} Page */
/** @typedef {import('./types.js').Column} Column */

/** The place of the curve in the drawing, mm. */
const plotLeft = 16, plotTop = 8, plotWide = 100, plotTall = 52;
/** A pole is sought by so many halvings between two samples. */
const halvings = 20;

/** @typedef {{at: number, value: number | null}} PlotSpot the value in the column's unit */

export class Plot {
    /**
     * @param {Page} page
     * @param {Motion} motion
     * @param {number} index of the column
     */
    constructor(page, motion, index) {
        this.page = page;
        this.motion = motion;
        this.index = index;
        this.column = motion.data.columns[index];
        const {course} = page, {samples} = course, here = {at: motion.at, isDrawn: motion.isDrawn};
        /** @type {PlotSpot[]} */
        this.spots = samples.map(({at}) => ({at, value: this.valueAt(at)}));
        /** Where the value grows without limit and changes its sign. */
        this.poles = this.spots.slice(1).flatMap((after, i) => this.poleBetween(this.spots[i], after) ?? []);
        if (here.isDrawn) motion.toDrawn(course);
        else motion.moveTo(course, here.at);
        const known = this.spots.flatMap(({value}) => value ?? []);
        this.isEmpty = known.length === 0;
        const [low, high] = this.isEmpty ? [0, 1] : rangeOf(known, this.poles.length > 0);
        this.steps = roundSteps(low, high, 5);
        this.low = Math.min(low, this.steps[0]);
        this.high = Math.max(high, this.steps[this.steps.length - 1]);
        this.from = samples[0].at;
        this.to = samples[samples.length - 1].at;
    }
    /** @param {number} at */
    valueAt(at) {
        const {motion, page, index} = this, value = motion.moveTo(page.course, at) ? motion.value(index) : null;
        return value === null ? null : value / this.column.size;
    }
    /**
     * Between two signs a zero has values that shrink, a pole values that grow, as it is approached.
     * @param {PlotSpot} before
     * @param {PlotSpot} after
     */
    poleBetween(before, after) {
        if (before.value === null || after.value === null || before.value * after.value >= 0) return null;
        let [a, b] = [{at: before.at, value: before.value}, {at: after.at, value: after.value}];
        for (let i = 0; i < halvings; ++i) {
            const at = (a.at + b.at) / 2, value = this.valueAt(at);
            if (value === null || value === 0) break;
            if (value * a.value > 0) a = {at, value};
            else b = {at, value};
        }
        const grows = Math.min(Math.abs(a.value), Math.abs(b.value)) > 4 * Math.max(Math.abs(before.value),
            Math.abs(after.value));
        return grows ? (a.at + b.at) / 2 : null;
    }
    /** @param {number} at */
    x(at) {
        return plotLeft + (plotWide * (at - this.from)) / (this.to - this.from);
    }
    /** @param {number} value */
    y(value) {
        return plotTop + (plotTall * (this.high - value)) / (this.high - this.low);
    }

    /**
     * Appends the plot to the figures; returns what moves its mark to the position.
     * @param {Element} place
     */
    draw(place) {
        const {page, column} = this, figure = document.createElement('figure'), name = nameOf(column);
        figure.className = 'plot';
        place.append(figure);
        const area = `0 0 ${plotLeft + plotWide + 6} ${plotTop + plotTall + 14}`;
        const svg = drawn(figure, 'svg', {viewBox: area, class: 'drawing graph', role: 'img', 'aria-label': name});
        this.drawAxes(svg);
        const curve = drawn(svg, 'svg', {x: 0, y: plotTop, width: plotLeft + plotWide, height: plotTall,
            viewBox: `0 ${plotTop} ${plotLeft + plotWide} ${plotTall}`});
        drawn(curve, 'path', {d: this.path(), class: 'curve'});
        const line = drawn(svg, 'line', {y1: plotTop, y2: plotTop + plotTall, class: 'here'}), mark = drawn(svg,
            'circle', {r: 1.2});
        const caption = figure.appendChild(document.createElement('figcaption'));
        return () => {
            const {motion} = this, value = motion.value(this.index), at = this.x(motion.at).toFixed(2);
            for (const end of ['x1', 'x2']) line.setAttribute(end, at);
            const shown = (value ?? 0) / column.size, isIn = value !== null && shown >= this.low && shown <= this.high;
            mark.setAttribute('cx', at);
            mark.setAttribute('cy', this.y(shown).toFixed(2));
            mark.setAttribute('visibility', isIn ? 'inherit' : 'hidden');
            caption.textContent = `${name} = ${value === null ? '–' : page.numberText(shown)} ${column.unit}`;
        };
    }
    /** @param {Element} svg */
    drawAxes(svg) {
        const {page, column} = this, {course} = page, right = plotLeft + plotWide, bottom = plotTop + plotTall;
        const write = (/** @type {string} */ text, /** @type {number} */ x, /** @type {number} */ y,
            /** @type {string} */ anchor) => {
            drawn(svg, 'text', {x: x.toFixed(2), y: y.toFixed(2), 'text-anchor': anchor}).textContent = text;
        };
        for (const step of this.steps) {
            const y = this.y(step);
            drawn(svg, 'path', {d: `M${plotLeft} ${y.toFixed(2)}H${right}`, class: step === 0 ? 'axis' : 'grid'});
            write(page.numberText(step), plotLeft - 1.2, y + 1.1, 'end');
        }
        // As the slider says it: degrees, mm, s.
        const size = course.byLaw ? 1 : course.turns ? Math.PI / 180 : 1e-3;
        for (const step of stepsOfDriver(this.from / size, this.to / size, course.turns && !course.byLaw)) {
            const x = this.x(step * size);
            drawn(svg, 'path', {d: `M${x.toFixed(2)} ${bottom}v1.2`, class: 'tick'});
            write(page.numberText(step), x, bottom + 5, 'middle');
        }
        drawn(svg, 'path', {d: `M${plotLeft} ${plotTop}V${bottom}H${right}`, class: 'axis'});
        for (const at of [...page.drive.stops, ...this.poles])
            drawn(svg, 'path', {d: `M${this.x(at).toFixed(2)} ${plotTop}V${bottom}`, class: 'stop'});
        write(`${nameOf(column)}${column.unit === '' ? '' : ` [${column.unit}]`}`, plotLeft, plotTop - 3, 'start');
        write(page.word(course.byLaw ? 'axis_time' : course.turns ? 'axis_turn' : 'axis_travel'), right,
            bottom + 10.5, 'end');
    }
    /** Broken where there is no value, and at poles. */
    path() {
        const {spots, poles} = this;
        const isBroken = (/** @type {number} */ i) => i === 0 || spots[i - 1].value === null
            || poles.some((at) => at > spots[i - 1].at && at < spots[i].at);
        return spots.map(({at, value}, i) => {
            if (value === null) return '';
            return `${isBroken(i) ? 'M' : 'L'}${this.x(at).toFixed(2)} ${this.y(value).toFixed(2)}`;
        }).join('');
    }
}

/**
 * The range to show, with zero; beside a pole the lower nine tenths of the values.
 * @param {number[]} values
 * @param {boolean} hasPoles
 */
function rangeOf(values, hasPoles) {
    const sizes = values.map(Math.abs).sort((a, b) => a - b), most = sizes[Math.floor(0.9 * (sizes.length - 1))];
    const shown = hasPoles ? values.map((value) => Math.min(Math.max(value, -most), most)) : values;
    const low = Math.min(0, ...shown), high = Math.max(0, ...shown);
    return high > low ? [low, high] : [-1, 1];
}
/**
 * Round numbers that reach from end to end, some so many.
 * @param {number} low
 * @param {number} high
 * @param {number} count
 */
function roundSteps(low, high, count) {
    const rough = (high - low) / count, power = 10 ** Math.floor(Math.log10(rough));
    const step = power * ([1, 2, 5].find((each) => each * power >= rough * 0.999) ?? 10);
    const first = Math.floor(low / step + 1e-9), last = Math.ceil(high / step - 1e-9);
    return Array.from({length: last - first + 1}, (_, i) => Number(((first + i) * step).toPrecision(10)));
}
/**
 * @param {number} from
 * @param {number} to
 * @param {boolean} inDegrees
 */
function stepsOfDriver(from, to, inDegrees) {
    const round = [5, 10, 15, 30, 45, 60, 90].find((step) => (to - from) / step <= 8);
    const steps = inDegrees && round ? Array.from({length: Math.floor(to / round) - Math.ceil(from / round) + 1},
        (_, i) => (Math.ceil(from / round) + i) * round) : roundSteps(from, to, 6);
    return steps.filter((step) => step >= from - 1e-9 && step <= to + 1e-9);
}

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
        for (const view of page.figures.filter(({info}) => info.layer === '')) {
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
