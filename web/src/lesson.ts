// The lesson: a four-bar in six steps. Each says what to do and shows where; the next comes when it is done.
import type {Bench} from './bench';
import {byId} from './dom';
import {word} from './words';

/** What each step points at, and when it is done; `before`: the file's text as the step began. */
const steps: {at: string, isDone: (bench: Bench, before: string) => boolean}[] = [
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
    /** −1: none is given; the number of steps: all are done. */
    step = -1;
    before = '';

    constructor(readonly bench: Bench) {
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
    take(step: number) {
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
