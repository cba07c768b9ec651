// Moving the mechanism: the driver, its slider, play, stops. Shows what depends on the position.

import {Rooms} from './area.js';
import {Dragging} from './drag.js';
import {unscored} from './exercise.js';
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./motion.js').Motion} Motion */
/** @typedef {import('./page.js').Page} Page */
/** @typedef {import('./paper.js').Names} Names */
/** @typedef {import('./types.js').Course} Course */
/** @typedef {import('./types.js').Spot} Spot */

export class Drive {
    /** @param {Page} page */
    constructor(page) {
        this.page = page;
        this.isPlaying = false;
        /** @type {Course | null} */
        this.shownWay = null;
        this.rooms = new Rooms(this);
        /** @type {Record<string, {cell: Element, column: number, text: string}[]>} */
        this.allCells = {};
    }
    get motion() {
        return this.page.motion;
    }
    /** @returns {Course} */
    get course() {
        const {courses} = /** @type {Motion} */ (this.motion);
        return courses[Number(this.page.at('driver')?.value) || 0];
    }
    /** Cells of values that follow the mechanism, in the current language. */
    get cells() {
        const {page} = this;
        return this.allCells[page.language] ??= [...page.sheet.querySelectorAll('td[data-column]')].map(
            (cell) => ({cell, column: Number(cell.getAttribute('data-column')), text: ''}));
    }
    /** @param {Motion} motion */
    wire(motion) {
        const {page} = this;
        if (!motion.isStill) this.wireWay(motion);
        page.at('drawn').onclick = () => {
            this.pause();
            motion.toDrawn(this.course);
            this.show();
        };
        page.at('fit').onchange = () => this.show();
        page.at('values').onchange = () => this.show();
        page.exercise.wire();
        page.traces.wire();
        page.panel.wire(motion);
        for (const sheet of page.sheets) {
            for (const svg of sheet.querySelectorAll('.figures svg'))
                new Dragging(page, /** @type {SVGSVGElement} */ (svg), motion).wire();
        }
    }
    /**
     * The choice of the driver, the slider, play.
     * @param {Motion} motion
     */
    wireWay(motion) {
        const {page} = this;
        const driver = page.at('driver');
        motion.data.courses.forEach((course, i) => driver.add(new Option(course.name, String(i))));
        driver.parentElement.hidden = motion.data.courses.length < 2;
        driver.onchange = () => this.choose(Number(driver.value));
        const position = page.at('position');
        position.oninput = () => {
            this.pause();
            this.moveTo(this.nearStop(Number(position.value)));
        };
        page.at('play').onclick = () => (this.isPlaying ? this.pause() : this.play());
    }
    /** @param {number} index */
    choose(index) {
        this.pause();
        if (!this.motion?.isStill) this.page.at('driver').value = String(index);
        this.motion?.toDrawn(this.course);
        this.showWay();
        this.page.traces.draw();
    }
    /** Shows the range of the driver with the current givens. */
    showWay() {
        const {course} = this;
        this.shownWay = course;
        this.rooms.clear();
        for (const view of this.page.figures) view.ground.travels.forEach((travel) => Object.assign(travel,
            {from: 0, to: 0}));
        if (this.motion?.isStill) return;
        const position = this.page.at('position');
        position.min = String(course.samples[0].at);
        position.max = String(course.samples[course.samples.length - 1].at);
        position.setAttribute('aria-label', `${this.page.word('position')}: ${course.name}`);
        this.showStops();
    }
    /** A button for each limit and change point of the range. */
    showStops() {
        const {course} = this, stops = this.page.at('stops');
        stops.textContent = '';
        for (const at of this.stops) {
            const button = document.createElement('button');
            button.type = 'button';
            button.textContent = this.positionText(at);
            button.title = this.page.word(course.changePoints.includes(at) ? 'change_point' : 'limit');
            button.onclick = () => {
                this.pause();
                this.moveTo(at);
            };
            stops.append(button, ' ');
        }
    }
    /** Limits and change points of the range. */
    get stops() {
        const {course} = this, {samples} = course;
        return [
            ...course.startsAtLimit ? [samples[0].at] : [], ...course.changePoints,
            ...course.endsAtLimit ? [samples[samples.length - 1].at] : [],
        ];
    }
    /**
     * The slider rests on stops and on the drawn position.
     * @param {number} at
     */
    nearStop(at) {
        const {samples} = this.course, reach = (samples[samples.length - 1].at - samples[0].at) / 250;
        return [...this.stops, 0].find((stop) => Math.abs(stop - at) < reach) ?? at;
    }
    /**
     * Changes a load, or a given velocity.
     * @param {number} setting
     * @param {number} size SI
     * @param {number} turn from its direction as drawn, rad
     */
    turnLoad(setting, size, turn) {
        const {motion} = this;
        if (!motion) return;
        const put = (/** @type {number[]} */ all, /** @type {number} */ value) =>
            all.map((each, i) => i === setting ? value : each);
        motion.give(put(motion.settings, size), put(motion.turns, turn));
        this.show();
    }
    /** @param {number} at */
    moveTo(at) {
        if (!this.motion?.moveTo(this.course, at)) return this.say(this.page.word('out_of_reach'));
        this.show();
    }
    play() {
        this.isPlaying = true;
        this.showPlaying();
        const {course} = this, {samples} = course, from = samples[0].at, to = samples[samples.length - 1].at;
        const turns = !course.startsAtLimit && !course.endsAtLimit;
        let sense = 1, before = performance.now();
        const frame = (/** @type {number} */ now) => {
            if (!this.isPlaying) return;
            let at = (this.motion?.at ?? 0) + sense * (to - from) * Math.min(now - before, 100) / 8000;
            before = now;
            if (turns && at > to) at = from + (at - to);
            if (at >= to || at <= from) sense = at >= to ? -1 : 1;
            this.moveTo(Math.min(Math.max(at, from), to));
            requestAnimationFrame(frame);
        };
        requestAnimationFrame(frame);
    }
    pause() {
        this.isPlaying = false;
        if (this.page.at('play')) this.showPlaying();
    }
    showPlaying() {
        const {page, isPlaying} = this, button = page.at('play');
        button.setAttribute('aria-pressed', String(isPlaying));
        page.name(button, isPlaying ? 'pause' : 'play');
    }

    /** @param {number} at */
    positionText(at) {
        const {course} = this;
        const written = (/** @type {number} */ value, /** @type {number} */ digits) =>
            value.toLocaleString(this.page.language, {maximumFractionDigits: digits}).replace('-', '−');
        if (course.byLaw) return `${written(at, 3)} s`;
        return course.turns ? `${written(at * 180 / Math.PI, 2)}°` : `${written(at * 1000, 2)} mm`;
    }
    /**
     * The angle of the crank, "φ₂ = 120°", beside its turn from the drawn position; of other drivers none.
     * @param {Motion} motion
     */
    angleText(motion) {
        const {page, course} = this,
            body = page.data.names.bodies.findIndex((/** @type {Names['bodies'][0]} */ {label}) =>
            label === course.name);
        const index = motion.data.columns.findIndex((column) => column.kind === 'angle' && column.body === body);
        const value = index < 0 || !course.turns ? null : motion.value(index);
        if (value === null) return '';
        const {symbol, name, size, unit} = motion.data.columns[index];
        return `${unscored(symbol || name)} = ${page.numberText(Number((value / size).toFixed(2)))}${unit}`;
    }
    /**
     * The position, in numbers and in words.
     * @param {Motion} motion
     */
    showWhere(motion) {
        const {course} = this, {samples} = course;
        this.page.at('position').value = String(motion.at);
        this.page.at('where').textContent = this.positionText(motion.at);
        this.page.at('angle').textContent = this.angleText(motion);
        const isNear = (/** @type {number} */ at) =>
            Math.abs(at - motion.at) < 1e-6 * Math.abs(course.to - course.from);
        const atLimit =
            (course.startsAtLimit && isNear(samples[0].at))
            || (course.endsAtLimit && isNear(samples[samples.length - 1].at));
        if (course.changePoints.some(isNear)) this.say(this.page.word('change_point'));
        else if (atLimit) this.say(this.page.word('limit'));
        else this.say(motion.plan < 0 ? this.page.word('no_construction') : '');
    }
    /** Updates all that depends on the position. */
    show() {
        const {motion} = this;
        if (!motion) return;
        if (this.course !== this.shownWay) this.showWay();
        if (motion.isStill) this.say(motion.plan < 0 ? this.page.word('no_construction') : '');
        else this.showWhere(motion);
        this.page.panel.show(motion);
        // What is hidden follows when it is shown.
        const {page} = this, figures = page.figures.filter(({svg}) => svg.closest('.shown'));
        const written = (/** @type {number} */ value) => page.numberText(value);
        /**
         * Boxes of labels in drawings that lie on each other, m.
         * @type {ReturnType<FigureView['labels']['placed']['boxes']>}
         */
        const known = [];
        for (const view of figures) {
            const isStacked = page.stage.stacked.some((node) => node.contains(view.svg));
            view.written = written;
            view.crowd.others = isStacked ? known.map((box) => view.boxOnPaper(box)) : [];
            this.showFigure(view, motion);
            view.showValues(page.at('values').checked, written);
            if (isStacked) known.push(...view.labels.placed.boxes());
        }
        for (const node of page.stage.shown) page.stage.fitOverlay(node);
        this.page.ruler.show();
        this.page.traces.show();
        for (const each of this.cells) {
            const value = motion.value(each.column);
            const text = value === null ? '–' : this.page.numberText(value / motion.data.columns[each.column].size);
            if (each.text !== text) each.cell.textContent = each.text = text;
        }
        for (const note of this.page.sheet.querySelectorAll(':scope > .text .note'))
            /** @type {HTMLElement} */ (note).hidden = motion.isDrawn;
    }
    /** @param {string} words */
    say(words) {
        if (this.page.at('reason').textContent !== words) this.page.at('reason').textContent = words;
    }
    /**
     * @param {FigureView} view
     * @param {Motion} motion
     */
    showFigure(view, motion) {
        const {note} = view, canFollow = view.svg.matches('.following') && (!view.isConstructed || motion.plan >= 0);
        note.hidden = motion.isDrawn || canFollow;
        view.svg.classList.toggle('as-drawn', !motion.isDrawn && !canFollow);
        if ((motion.isDrawn && !motion.isOwn) || !canFollow) {
            view.restore();
            // So that a path is fully visible, and the figure stays in place when the motion begins.
            if (view.info.layer === '' && this.page.traces.isTraced)
                view.svg.setAttribute('viewBox', this.rooms.of(view).join(' '));
            view.held?.take(false);
            view.labels.placed.makeWay();
            return this.sayScale(view);
        }
        const fits = this.page.at('fit').checked && !view.isMechanism && !motion.isOwn;
        view.held?.take(this.page.at('fit').checked && !motion.isOwn);
        // Polygons of one drawing have one scale.
        const together = fits ? this.page.figures.filter(({svg}) => svg === view.svg) : [];
        const to = fits ? view.area.fitted(Math.max(...together.map((each) => each.area.shrinkage()))) : undefined;
        view.area.placeCompanions(fits);
        view.follow(motion.isOwn ? view.viewBox : fits ? view.area.fitRoom : this.rooms.of(view), to);
        this.sayScale(view);
    }
    /** @param {FigureView} view */
    sayScale(view) {
        const scale = view.captionOfScale;
        if (!scale) return;
        scale.dataset.drawn ??= scale.innerHTML;
        if (view.scales.every(({now, drawn: as}) => now === as)) {
            if (view.saysOtherScale) scale.innerHTML = scale.dataset.drawn;
            view.saysOtherScale = false;
        } else {
            view.saysOtherScale = true;
            const said = view.scales.map(({now, unit}) =>
                `1 mm ≙ ${this.page.numberText(Number(now.toPrecision(3)))} ${unit}`).join(';  ');
            if (scale.textContent !== said) scale.textContent = said;
        }
    }
    /**
     * The path of a point over the driver's range, m.
     * @param {number} point
     * @returns {Spot[]}
     */
    pathOf(point) {
        const motion = /** @type {Motion} */ (this.motion), here = motion.at;
        const path = this.course.samples.map((sample) => {
            motion.places.set(sample.q);
            return motion.places.read().points[point];
        });
        motion.moveTo(this.course, here);
        return path;
    }
}

