// The exercise: the student draws the lines of a polygon, in any order in which they can be drawn: start, direction,
// sense and length. Each is judged by what the student's own earlier lines imply. Only in the drawn position, one
// polygon at a time. Nothing is sent.

/** @typedef {{name: string, along: Spot}} Direction a unit vector on paper */

class Exercise {
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
        /** @type {Handle | null} */
        this.handle = null;
        this.from = {x: 0, y: 0};
        this.report = new Report(page);
    }
    wire() {
        const {page} = this;
        page.at('try-figure').onchange = () => this.take(page.at('try-figure').value);
        page.at('try-name').onchange = () => this.choose(Number(page.at('try-name').value));
        page.at('try-point').onchange = () => this.choosePoint();
        page.at('try-direction').onchange = () => this.aim();
        page.at('try-check').onclick = () => this.check();
        page.at('try-hint').onclick = () => this.hint();
        page.at('try-show').onclick = () => this.finish(0, 'shown');
        page.at('try-keep').onclick = () => this.keep();
        this.report.wire();
        document.addEventListener('languagechosen', () => this.isOn && this.refresh());
    }
    /** @param {FigureView} view */
    tasksOf(view) {
        return tasksOf(view, (statement) => this.unknownIn(statement, view.id.startsWith('forces')));
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
            (view) => !view.isMechanism && !view.held && view.follows && view.id !== 'closure',
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
        this.group = this.handle = null;
    }

    // --- the page ----------------------------------------------------------------------------------------------------

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
        fill(page.at('try-point'), this.pointsKnown(view).map(({name}, i) => [String(i), name]), '0');
        const directions = this.directions().map(({name}, i) => [String(i), name]);
        fill(page.at('try-direction'), [['', page.word('by_hand')], ...directions], '');
        this.layLine(view);
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
        this.page.hideStatements((statement) => own.has(statement) ? open.includes(statement) : statement > first);
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

    // --- the choices -------------------------------------------------------------------------------------------------

    /**
     * Vertices that are there, the pole first.
     * @param {FigureView} view
     * @returns {{name: string, at: Spot}[]}
     */
    pointsKnown(view) {
        const {tasks} = this;
        const letters = view.motion.data.plans[0].spots.filter(([figure]) => figure === view.id).flatMap(([, name]) => {
            const at = view.spot(name);
            return at ? [{name: unscored(name), at}] : [];
        });
        const drawnVectors = [...view.group.querySelectorAll(':scope > g.vector:not(.later)')].flatMap((node) => {
            const name = node.getAttribute('data-name') ?? '', ends = view.vector(name);
            return ends ? [{name, ends}] : [];
        });
        const own = tasks.filter(({kind}, i) => kind === 'vector' && this.done.has(i))
            .map(({name, from, by}) => ({name, ends: [from, along(from, 1, by)]}));
        const places = [
            ...tasks.filter((each) => leadingTo(each, tasks).length === 0).map(({from}) => from),
            ...[...drawnVectors, ...own].flatMap(({ends}) => ends),
            ...tasks.filter((each) => this.isReady(each, tasks)).map(({from}) => from),
        ];
        /** @type {{name: string, at: Spot}[]} */
        const points = [];
        for (const at of places) {
            if (points.some((each) => apart(each.at, at) < samePlace)) continue;
            const letter = letters.find((each) => apart(each.at, at) < samePlace)?.name;
            const tip = [...drawnVectors, ...own].find(({ends}) => apart(ends[1], at) < samePlace)?.name;
            const name =
                letter
                ?? (tip === undefined
                    ? this.page.word('start')
                    : this.page.word('tip_of').replace('{0}', unscored(tip)));
            points.push({name, at});
        }
        return points;
    }
    /**
     * Whether the point in which a task begins is there.
     * @param {Task} task
     * @param {Task[]} tasks
     */
    isReady(task, tasks) {
        return leadingTo(task, tasks).every((each) => this.done.has(tasks.indexOf(each)));
    }
    /**
     * Directions along and perpendicular to the lines of the mechanism.
     * @returns {Direction[]}
     */
    directions() {
        const {page} = this, {data} = page, motion = /** @type {Motion} */ (page.motion);
        /** @type {Direction[]} */
        const found = [];
        const add = (/** @type {string} */ name, /** @type {Spot} */ by) => {
            if (Math.hypot(by.x, by.y) < 1e-9) return;
            const e = unitOf({x: by.x, y: -by.y});
            found.push({name: `∥ ${name}`, along: e}, {name: `⟂ ${name}`, along: quarterTurn(e)});
        };
        const {points, guides} = motion.read, {joints} = /** @type {Names} */ (data.names);
        const label = (/** @type {number} */ point) => unscored(data.names.points[point].label);
        joints.forEach((one, i) =>
            joints.slice(i + 1).forEach((other) => {
                if (!one.bodies.some((body) => body > 0 && other.bodies.includes(body))) return;
                add(label(one.point) + label(other.point), minus(points[other.point], points[one.point]));
            }),
        );
        joints.forEach(
            ({point, turnsWith}, k) =>
                turnsWith >= 0 && add(page.word('guide').replace('{0}', label(point)), guides[k]),
        );
        found.push(
            {name: page.word('horizontal'), along: {x: 1, y: 0}},
            {name: page.word('vertical'), along: {x: 0, y: 1}},
        );
        return found;
    }

    // --- the student's line ------------------------------------------------------------------------------------------

    /** @param {FigureView} view */
    layLine(view) {
        const group = /** @type {Element} */ (this.group);
        for (const {at} of this.pointsKnown(view))
            drawn(group, 'circle', {cx: at.x.toFixed(3), cy: at.y.toFixed(3), r: 1.1, class: 'vertex'});
        drawn(group, 'line', {class: 'own'});
        this.handle = new Handle(group, view.svg, this.page.word('line_end'), (at) => this.drag(at));
        this.handle.node.addEventListener('keydown', (event) => {
            if (/** @type {KeyboardEvent} */ (event).key === 'Enter') this.check();
        });
        this.choosePoint();
    }
    choosePoint() {
        const {view} = this;
        if (!view || !this.handle) return;
        const {x, y, width, height} = view.svg.viewBox.baseVal;
        this.from = this.pointsKnown(view)[Number(this.page.at('try-point').value)].at;
        const toward = minus({x: x + width / 2, y: y + height / 2}, this.from), far = Math.hypot(toward.x, toward.y);
        this.handle.put(along(this.from, 10, far > 1 ? unitOf(toward) : {x: 1, y: 0}));
        this.aim();
    }
    /** @returns {Spot | null} */
    get chosenDirection() {
        const {value} = this.page.at('try-direction');
        return value === '' ? null : this.directions()[Number(value)].along;
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
        const {page, view, handle, from} = this, e = this.chosenDirection;
        if (!view || !handle) return;
        handle.put(e ? along(from, dot(minus(at, from), e), e) : at);
        putLine(/** @type {Element} */ (this.group?.querySelector('.own')), from, handle.at);
        const written = (/** @type {number} */ value) => page.numberText(value);
        page.at('try-length').textContent = this.tasks[this.now]?.kind === 'vector' ?
            measured(apart(from, handle.at), view.drawnScale, view.unit, written) : '';
    }
    /**
     * If there is a vertex under the pointer, the line starts there.
     * @param {SVGSVGElement} svg
     * @param {PointerEvent} event
     */
    touch(svg, event) {
        const {view} = this;
        if (!this.isOn || view?.svg !== svg || !this.handle) return;
        const at = spotUnder(svg, event), points = this.pointsKnown(view);
        const near = points.findIndex((each) => apart(each.at, at) < 3);
        if (near < 0) return;
        this.page.at('try-point').value = String(near);
        this.choosePoint();
    }

    // --- the verdict -------------------------------------------------------------------------------------------------

    check() {
        const {page, tasks, handle} = this, task = tasks[this.now];
        if (!handle || !task) return;
        const missing = leadingTo(task, tasks).find((each) => !this.done.has(tasks.indexOf(each)));
        ++this.attempts;
        if (missing) return this.tell(this.filled('too_early', this.nameOf(task), this.nameOf(missing)));
        const fault = faultOf(task, this.from, handle.at);
        if (fault.kind === '') return this.finish(this.attempts === 1 && this.hints === 0 ? 1 : 0.5,
            this.own.size > 0 ? 'carried' : 'right');
        const other = tasks.find((each, i) => i !== this.now && !this.done.has(i) && each.kind === task.kind &&
            this.isReady(each, tasks) && faultOf(each, this.from, handle.at).kind === '');
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
                this.pointsKnown(/** @type {FigureView} */ (this.view))[Number(page.at('try-point').value)].name);
        if (kind !== 'not_along') return this.filled(kind, kind === 'wrong_sense' ? name : off);
        const wanted = this.directions().find(({along: e}) => Math.abs(dot(e, quarterTurn(unitOf(task.by)))) < 1e-6);
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
        this.tell(sentence ? spoken(sentence) : this.page.word('no_hint'));
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

    // --- the student's own construction ------------------------------------------------------------------------------

    /**
     * The element that the student's line puts elsewhere, and its value; null: the record has none.
     * @param {Task} task
     * @returns {[number, [number, number, number]] | null}
     */
    ownElement(task) {
        const {view, handle, from} = this;
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
function unscored(name) {
    const lowered = /** @type {Record<string, string>} */ ({v: 'ᵥ', a: 'ₐ'});
    const low = (/** @type {string} */ each) => lowered[each] ?? '₀₁₂₃₄₅₆₇₈₉'[Number(each)];
    return name.replace(/_(\d+|[va]$)/g, (_, digits) => [...digits].map(low).join(''));
}

/**
 * @param {HTMLSelectElement} list
 * @param {string[][]} options value and text
 * @param {string} chosen
 */
function fill(list, options, chosen) {
    list.textContent = '';
    for (const [value, text] of options) list.add(new Option(text, value));
    list.value = chosen;
}
