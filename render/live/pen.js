// The line that a student draws: from a vertex, along a chosen direction or by hand, to an end that is dragged or moved
// by keys.

import {dot, unitOf} from './closure.js';
import {drawn, Handle, measured, putLine, spotUnder} from './measure.js';
import {along, apart, minus} from './path.js';
/** @typedef {import('./exercise.js').Exercise} Exercise */
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./types.js').Spot} Spot */

export class Pen {
    /** @param {Exercise} exercise */
    constructor(exercise) {
        this.exercise = exercise;
        /** @type {Handle | null} */
        this.handle = null;
        this.from = {x: 0, y: 0};
    }
    /** @param {FigureView} view */
    layLine(view) {
        const group = /** @type {Element} */ (this.exercise.group);
        for (const {at} of this.exercise.choices.pointsKnown(view))
            drawn(group, 'circle', {cx: at.x.toFixed(3), cy: at.y.toFixed(3), r: 1.1, class: 'vertex'});
        drawn(group, 'line', {class: 'own'});
        this.handle = new Handle(group, view.svg, this.exercise.page.word('line_end'), (at) => this.drag(at));
        this.handle.node.addEventListener('keydown', (event) => {
            if (/** @type {KeyboardEvent} */ (event).key === 'Enter') this.exercise.check();
        });
        this.choosePoint();
    }
    choosePoint() {
        const {view} = this.exercise;
        if (!view || !this.handle) return;
        const {x, y, width, height} = view.svg.viewBox.baseVal;
        this.from = this.exercise.choices.pointsKnown(view)[Number(this.exercise.page.at('try-point').value)].at;
        const toward = minus({x: x + width / 2, y: y + height / 2}, this.from), far = Math.hypot(toward.x, toward.y);
        this.handle.put(along(this.from, 10, far > 1 ? unitOf(toward) : {x: 1, y: 0}));
        this.aim();
    }
    /** @returns {Spot | null} */
    get chosenDirection() {
        const {value} = this.exercise.page.at('try-direction');
        return value === '' ? null : this.exercise.choices.directions()[Number(value)].along;
    }
    /** Turns the line to the chosen direction; its length, and if possible its sense, stay. */
    aim() {
        const {handle, from} = this, e = this.chosenDirection;
        if (!handle) return;
        const size = Math.max(apart(handle.at, from), 10);
        this.drag(e ? along(from, dot(minus(handle.at, from), e) < 0 ? -size : size, e) : handle.at);
    }
    /**
     * Moves the end, along the chosen direction if there is one.
     * @param {Spot} at
     */
    drag(at) {
        const {page, view} = this.exercise, {handle, from} = this, e = this.chosenDirection;
        if (!view || !handle) return;
        handle.put(e ? along(from, dot(minus(at, from), e), e) : at);
        putLine(/** @type {Element} */ (this.exercise.group?.querySelector('.own')), from, handle.at);
        const written = (/** @type {number} */ value) => page.numberText(value);
        page.at('try-length').textContent = this.exercise.tasks[this.exercise.now]?.kind === 'vector' ?
            measured(apart(from, handle.at), view.drawnScale / view.inUnit, view.unit, written) : '';
    }
    /**
     * If there is a vertex under the pointer, the line starts there.
     * @param {SVGSVGElement} svg
     * @param {PointerEvent} event
     */
    touch(svg, event) {
        const {view} = this.exercise;
        if (!this.exercise.isOn || view?.svg !== svg || !this.handle) return;
        const at = spotUnder(svg, event), points = this.exercise.choices.pointsKnown(view);
        const near = points.findIndex((each) => apart(each.at, at) < 3);
        if (near < 0) return;
        this.exercise.page.at('try-point').value = String(near);
        this.choosePoint();
    }
}
