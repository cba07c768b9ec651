// The path of a point on the mechanism, and the plot of a value over the driver's range. Both are drawn once for a
// range, with a mark at the current position.

/**
 * The name as on the sheet.
 * @param {Column} column
 */
function nameOf({name, symbol}) {
    return unscored(symbol ?? name);
}

class Traces {
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
        const {page} = this, {course} = page, {samples} = course, column = motion.data.columns[index];
        const here = {at: motion.at, isDrawn: motion.isDrawn};
        const values = samples.map(({at}) => {
            const value = motion.moveTo(course, at) ? motion.value(index) : null;
            return value === null ? null : value / column.size;
        });
        if (here.isDrawn) motion.toDrawn(course);
        else motion.moveTo(course, here.at);
        const known = values.flatMap((value) => value ?? []);
        if (known.length === 0) return;
        const low = Math.min(0, ...known),
            high = Math.max(0, ...known),
            wide = 100,
            tall = 50,
            span = high - low || 1;
        const x = (/** @type {number} */ at) =>
            (wide * (at - samples[0].at)) / (samples[samples.length - 1].at - samples[0].at);
        const y = (/** @type {number} */ value) => (tall * (high - value)) / span;
        const figure = document.createElement('figure');
        figure.className = 'plot';
        page.sheet.querySelector('.figures')?.append(figure);
        const svg = drawn(figure, 'svg', {viewBox: '-4 -8 108 66', role: 'img', 'aria-label': nameOf(column)});
        let d = '';
        values.forEach((value, i) => {
            if (value === null) return;
            const isFirst = i === 0 || values[i - 1] === null;
            d += `${isFirst ? 'M' : 'L'}${x(samples[i].at).toFixed(2)} ${y(value).toFixed(2)}`;
        });
        drawn(svg, 'path', {d: `M0 ${y(0)}H${wide}M0 0V${tall}`, class: 'axis'});
        drawn(svg, 'path', {d, class: 'curve'});
        const words = (/** @type {number} */ at, /** @type {number} */ value) => {
            drawn(svg, 'text', {x: 1, y: at}).textContent =
                `${page.numberText(Number(value.toPrecision(4)))} ${column.unit}`;
        };
        words(-1.5, high);
        if (low < 0) words(tall + 5, low);
        const mark = drawn(svg, 'circle', {r: 1.2}), line = drawn(svg, 'line', {y1: 0, y2: tall});
        const caption = document.createElement('figcaption');
        figure.append(caption);
        this.marks.push(() => {
            const value = motion.value(index), at = x(motion.at).toFixed(2);
            for (const name of ['x1', 'x2']) line.setAttribute(name, at);
            mark.setAttribute('cx', at);
            mark.setAttribute('cy', y((value ?? 0) / column.size).toFixed(2));
            mark.setAttribute('visibility', value === null ? 'hidden' : 'inherit');
            const told = value === null ? '–' : page.numberText(value / column.size);
            caption.textContent = `${nameOf(column)} = ${told} ${column.unit}`;
        });
    }
    show() {
        for (const mark of this.marks) mark();
    }
}
