// The lesson: a four-bar in six steps. Each says what to do and shows where; the next comes when it is done.
import {byId} from './dom.js';
import {word} from './words.js';

/** @typedef {import('./bench.js').Bench} Bench */

/**
 * What each step points at, and when it is done; `before`: the file's text as the step began.
 * @type {{at: string, isDone: (bench: Bench, before: string) => boolean}[]}
 */
const steps = [
    {at: '[data-tool=link]', isDone: ({model}) => model.movingBodies.length >= 3},
    {
        at: '[data-tool=ground]',
        isDone: ({model}) => model.points.filter(({name}) => model.isGround(name)).length >= 2
    },
    {at: '[data-tool=driver]', isDone: ({model}) => model.drivers.length > 0},
    {at: '[data-tool=select]', isDone: ({document}, before) => document.text !== before},
    {at: '#go-move', isDone: ({mode}) => mode === 'move'},
    {at: '#go-steps', isDone: ({mode}) => mode === 'steps'}
];

export class Lesson {
    /** @param {Bench} bench */
    constructor(bench) {
        this.bench = bench;
        /** −1: none is given; the number of steps: all are done. */
        this.step = -1;
        this.before = '';
        byId('lesson-end').addEventListener('click', () => this.end());
        bench.on(['file', 'mode'], () => this.look());
    }
    begin() {
        this.bench.setMode('build');
        this.take(0);
    }
    end() {
        this.take(-1);
        byId('canvas').focus();
    }
    /** Goes on where a step is done. */
    look() {
        while (steps[this.step]?.isDone(this.bench, this.before)) this.take(this.step + 1);
    }
    /** @param {number} step */
    take(step) {
        this.step = step;
        this.before = this.bench.document.text;
        for (const each of document.querySelectorAll('.asked')) each.classList.remove('asked');
        if (steps[step]) document.querySelector(steps[step].at)?.classList.add('asked');
        byId('lesson').hidden = step < 0;
        if (step < 0) return;
        const isLast = step === steps.length;
        byId('lesson-where').textContent = isLast ? '' : word('lesson_step', step + 1, steps.length);
        byId('lesson-text').textContent = word(isLast ? 'lesson_done' : `lesson_${step + 1}`);
    }
}
