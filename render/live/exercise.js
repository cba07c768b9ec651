// The exercise: the student draws the lines of a polygon, in any order in which they can be drawn: start, direction,
// sense and length. Each is judged by what the student's own earlier lines imply. Only in the drawn position, one
// polygon at a time. Nothing is sent.

import {Choices} from './choices.js';
import {dot, quarterTurn, unitOf} from './closure.js';
import {drawn, putLine, takeAway} from './measure.js';
import {along, apart, minus} from './path.js';
import {Pen} from './pen.js';
import {Report} from './report.js';
import {total} from './room.js';
import {withoutTables} from './steps.js';
import {faultOf, leadingTo, pencil, tasksOf} from './tasks.js';
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./page.js').Page} Page */
/** @typedef {import('./report.js').Done} Done */
/** @typedef {import('./tasks.js').Fault} Fault */
/** @typedef {import('./tasks.js').Task} Task */

export class Exercise {
    /** @param {Page} page */
    constructor(page) {
        this.page = page;
        this.isOn = false;
        this.figure = '';
        /**
         * By the number of a task that is drawn.
         * @type {Map<number, Done>}
         */
        this.done = new Map();
        this.now = 0;
        this.attempts = 0;
        this.hints = 0;
        this.begun = 0;
        /**
         * Elements of the record that stand where the student has put them.
         * @type {Map<number, [number, number, number]>}
         */
        this.own = new Map();
        /** @type {Element | null} */
        this.group = null;
        this.pen = new Pen(this);
        this.choices = new Choices(this);
        this.report = new Report(page);
    }
    wire() {
        const {page} = this;
        page.at('try-figure').onchange = () => this.take(page.at('try-figure').value);
        page.at('try-name').onchange = () => this.choose(Number(page.at('try-name').value));
        page.at('try-point').onchange = () => this.pen.choosePoint();
        page.at('try-direction').onchange = () => this.pen.aim();
        page.at('try-check').onclick = () => this.check();
        page.at('try-hint').onclick = () => this.hint();
        page.at('try-show').onclick = () => this.finish(0, 'shown');
        page.at('try-keep').onclick = () => this.keep();
        this.report.wire();
        document.addEventListener('languagechosen', () => this.isOn && this.refresh());
    }
    /** @param {FigureView} view */
    tasksOf(view) {
        return tasksOf(view, (statement) => this.unknownIn(statement, view.info.findsForces === true));
    }
    /**
     * Reads the table under a sentence, a row for each term: its sign, name, whether its magnitude is known, whether
     * its
     * direction is. A sentence on forces names the forces that it finds.
     * @param {number} statement
     * @param {boolean} isOfForces
     */
    unknownIn(statement, isOfForces) {
        const sentence = this.page.sheet.querySelector(`li[data-says="${statement}"]`);
        const rows = /** @type {HTMLTableRowElement[]} */ ([...sentence?.querySelectorAll('table.equation tr') ?? []]);
        const names = [...this.page.sheet.querySelectorAll('g.vector')].map((node) =>
            node.getAttribute('data-name') ?? '');
        const unknown = rows.map((row) => [...row.cells].map((cell) => cell.textContent ?? ''))
            .filter(([, , magnitude, direction]) => magnitude === '?' && direction.startsWith('✓')).map(([,
                name]) => name);
        if (isOfForces && sentence) {
            for (const letter of sentence.querySelectorAll('b'))
                unknown.push(`${letter.textContent}${letter.nextSibling?.textContent}`);
        }
        return new Set(names.filter((name) => unknown.includes(name.replaceAll('_', ''))));
    }
    /** Polygons with at least one task. */
    get polygons() {
        const all = this.page.figures.filter(
            (view) => !view.isMechanism && !view.isHeld && view.follows && !view.info.hasNoTasks,
        );
        return all.filter((view) => all.find(({id}) => id === view.id) === view && this.tasksOf(view).length > 0);
    }
    get view() {
        return this.isOn ? this.page.figures.find((view) => view.id === this.figure) : undefined;
    }
    /**
     * As the student's own lines imply them.
     * @returns {Task[]}
     */
    get tasks() {
        return this.view ? this.tasksOf(this.view) : [];
    }
    /** By task in drawing order: 1, right at the first attempt; ½, with help; 0, shown or kept with a fault. */
    get points() {
        return [...this.done.values()].map(({points}) => points);
    }
    begin() {
        const {page} = this;
        page.pause();
        page.ruler.turn(false);
        page.motion?.toDrawn(page.course);
        page.show();
        const first = this.polygons[0];
        this.isOn = first !== undefined;
        if (first) this.take(first.id);
        else this.tell(page.word('nothing_to_try'));
    }
    end() {
        this.clear();
        this.moveOwn(new Map());
        this.isOn = false;
    }
    /** @param {string} figure */
    take(figure) {
        this.figure = figure;
        this.done.clear();
        this.own.clear();
        this.report.hide();
        this.moveOwn(this.own);
        this.page.stage.show();
        this.choose(0);
        this.tell('');
    }
    /** @param {number} task */
    choose(task) {
        this.now = task;
        [this.attempts, this.hints, this.begun] = [0, 0, performance.now()];
        this.refresh();
    }
    clear() {
        for (const node of document.querySelectorAll('g.student')) takeAway(node);
        this.group = this.pen.handle = null;
    }
    /** Shows the page before the next line. */
    refresh() {
        const {page} = this;
        this.clear();
        const {view, tasks} = this;
        if (!view) return;
        fill(
            page.at('try-figure'),
            this.polygons.map((each) => [each.id, each.caption + each.id.replace(/^[^-]*-?/, ' ')]),
            this.figure,
        );
        const isDone = this.done.size === tasks.length;
        this.hide(tasks);
        for (const id of ['try-name', 'try-point', 'try-direction', 'try-check', 'try-hint',
            'try-show']) page.at(id).disabled = isDone;
        page.at('try-keep').hidden = true;
        page.at('try-score').textContent = page
            .word('score')
            .replace('{0}', page.numberText(total(this.points)))
            .replace('{1}', String(tasks.length));
        page.at('try-length').textContent = '';
        this.group = drawn(view.svg, 'g', {class: 'student'});
        tasks.forEach((each, i) => this.done.has(i) && this.drawDone(each, view));
        if (isDone) {
            this.report.show(view.caption, tasks.flatMap((_, i) => this.done.get(i) ?? []));
            return this.tell(page.word('all_drawn'), page.at('report-print'));
        }
        fill(page.at('try-name'), tasks.flatMap((each, i) => this.done.has(i) ? [] : [[String(i),
            this.nameOf(each)]]), String(this.now));
        const points = this.choices.pointsKnown(view).map(({name}) => name);
        fill(page.at('try-point'), points.map((name, i) => [String(i), name]), '0');
        for (const label of view.svg.querySelectorAll('g.label.later'))
            if (points.includes(unscored(label.getAttribute('data-label') ?? ''))) label.classList.remove('later');
        const directions = this.choices.directions().map(({name}, i) => [String(i), name]);
        fill(page.at('try-direction'), [['', page.word('by_hand')], ...directions], '');
        this.pen.layLine(view);
    }
    /**
     * Of a statement the strokes are there when all of its lines are drawn; without lines of its own, when those before
     * it are.
     * @param {Task[]} tasks
     */
    hide(tasks) {
        const open = tasks.filter((_, i) => !this.done.has(i)).map(({statement}) => statement),
            first = Math.min(Infinity, ...open);
        const own = new Set(tasks.map(({statement}) => statement));
        this.page.steps.hideStatements((statement) => own.has(statement) ? open.includes(statement) :
            statement > first);
    }
    /** @param {Task} task */
    nameOf({kind, name}) {
        if (kind === 'vector') return unscored(name);
        return name === '' ? this.page.word('line_alone') : this.page.word('line_of').replace('{0}', unscored(name));
    }
    /**
     * @param {Task} task
     * @param {FigureView} view
     */
    drawDone(task, view) {
        const line = drawn(/** @type {Element} */ (this.group), 'line', {class: `done ${task.kind}`});
        if (task.kind === 'vector') return putLine(line, task.from, along(task.from, 1, task.by));
        const {width} = view.svg.viewBox.baseVal;
        putLine(line, along(task.from, -width / 3, task.by), along(task.from, width / 3, task.by));
    }
    /**
     * Whether the point in which a task begins is there.
     * @param {Task} task
     * @param {Task[]} tasks
     */
    isReady(task, tasks) {
        return leadingTo(task, tasks).every((each) => this.done.has(tasks.indexOf(each)));
    }
    check() {
        const {page, tasks} = this, {handle} = this.pen, task = tasks[this.now];
        if (!handle || !task) return;
        const missing = leadingTo(task, tasks).find((each) => !this.done.has(tasks.indexOf(each)));
        ++this.attempts;
        if (missing) return this.tell(this.filled('too_early', this.nameOf(task), this.nameOf(missing)));
        const fault = faultOf(task, this.pen.from, handle.at);
        if (fault.kind === '') return this.finish(this.attempts === 1 && this.hints === 0 ? 1 : 0.5,
            this.own.size > 0 ? 'carried' : 'right');
        const other = tasks.find((each, i) => i !== this.now && !this.done.has(i) && each.kind === task.kind &&
            this.isReady(each, tasks) && faultOf(each, this.pen.from, handle.at).kind === '');
        this.tell(other ? this.filled('is_other', this.nameOf(task), this.nameOf(other)) : this.sayFault(task, fault));
        page.at('try-keep').hidden = other !== undefined || this.ownElement(task) === null;
    }
    /**
     * What the line should be incident with, and is not.
     * @param {Task} task
     * @param {Fault} fault
     */
    sayFault(task, {kind, by}) {
        const {page} = this, name = this.nameOf(task), off = page.numberText(Number(by.toFixed(by < 10 ? 1 : 0)));
        if (kind === 'not_through')
            return this.filled(kind, name,
                page.at('try-point').selectedOptions[0].text);
        if (kind !== 'not_along') return this.filled(kind, kind === 'wrong_sense' ? name : off);
        const wanted = this.choices.directions().find(({along: e}) => Math.abs(dot(e,
            quarterTurn(unitOf(task.by)))) < 1e-6);
        return wanted ? this.filled(kind, name, wanted.name, off) : this.filled('off_by_angle', name, off);
    }
    /**
     * @param {string} key
     * @param {string[]} values
     */
    filled(key, ...values) {
        return values.reduce((text, value, i) => text.replace(`{${i}}`, value), this.page.word(key));
    }
    hint() {
        ++this.hints;
        const {statement} = this.tasks[this.now];
        const sentence = this.page.says.find((each) => Number(each.dataset.says) === statement);
        if (!sentence) return this.tell(this.page.word('no_hint'));
        this.page.at('try-verdict').replaceChildren(...withoutTables(sentence).childNodes);
    }
    /**
     * @param {number} points
     * @param {string} verdict
     */
    finish(points, verdict) {
        const {page, tasks, now} = this, seconds = Math.round((performance.now() - this.begun) / 1000);
        this.done.set(now, {name: this.nameOf(tasks[now]), attempts: this.attempts, hints: this.hints, seconds,
            points});
        const next = tasks.findIndex((each, i) => !this.done.has(i) && this.isReady(each, tasks));
        this.choose(Math.max(next, 0));
        if (this.done.size < tasks.length) this.tell(page.word(verdict));
    }
    /**
     * The element that the student's line puts elsewhere, and its value; null: the record has none.
     * @param {Task} task
     * @returns {[number, [number, number, number]] | null}
     */
    ownElement(task) {
        const {view} = this, {handle, from} = this.pen;
        if (!view || !handle) return null;
        const plan = view.drawnBy(view.motion.plan), tip = view.unpaper(handle.at), tail = view.unpaper(from);
        if (task.kind === 'vector') {
            const element = plan.vectors.get(view.keys.get(task.name) ?? task.name)?.[1];
            return element === undefined || apart(from, task.from) > pencil ? null : [element, [tip.x, tip.y, 1]];
        }
        const element = plan.lines.get(task.line)?.line, by = minus(tip, tail);
        return element === undefined ? null : [element, [-by.y, by.x, by.y * tail.x - by.x * tail.y]];
    }
    /** Goes on with a line that has a fault: it costs this step, and what follows is judged by it. */
    keep() {
        const {tasks, now} = this, own = this.ownElement(tasks[now]);
        if (!own) return;
        this.own.set(...own);
        this.moveOwn(this.own);
        this.finish(0, 'kept');
    }
    /** @param {Exercise['own']} own */
    moveOwn(own) {
        const {motion} = this.page;
        if (!motion || (own.size === 0 && !motion.isOwn)) return;
        motion.putOwn(own);
        this.page.show();
    }
    /**
     * @param {string} words
     * @param {HTMLElement} [focus]
     */
    tell(words, focus) {
        this.page.at('try-verdict').textContent = words;
        focus?.focus();
    }
}

/**
 * Digits and letters as subscripts of Unicode, for plain text.
 * @param {string} name
 */
export function unscored(name) {
    const lowered = /** @type {Record<string, string>} */ ({v: 'ᵥ', a: 'ₐ'});
    const low = (/** @type {string} */ each) => lowered[each] ?? '₀₁₂₃₄₅₆₇₈₉'[Number(each)];
    return name.replace(/_(\d+|[va]$)/g, (_, digits) => [...digits].map(low).join(''));
}

/**
 * @param {HTMLSelectElement} list
 * @param {string[][]} options value and text
 * @param {string} chosen
 */
export function fill(list, options, chosen) {
    list.textContent = '';
    for (const [value, text] of options) list.add(new Option(text, value));
    list.value = chosen;
}
