// The exercise: the student draws the next line of a polygon: its start, direction and length. The line is compared
// with the construction; a wrong one is reported as a wrong point, direction, sense or length. Only in the drawn
// position, one polygon at a time. Nothing is sent.

/**
 * @typedef {{statement: number, kind: 'vector' | 'line', name: string, from: Spot, by: Spot}} Task
 * name: of the vector drawn, or of the vector on the line; by: the vector, or the line's direction, mm on paper
 * @typedef {{name: string, along: Spot}} Direction a unit vector on paper
 */

/** Tolerances: degrees, mm, share of the length. */
const straightEnough = 2, longEnough = 1, shareEnough = 0.02;

/**
 * The lines of a polygon in drawing order: known vectors, and the lines on which the others lie.
 * @param {FigureView} view
 * @param {(statement: number) => Set<string>} unknownIn names of the vectors of unknown magnitude in a statement
 * @returns {Task[]}
 */
function tasksOf(view, unknownIn) {
    /** @type {Spot[]} */
    const known = [];
    const isSame = (/** @type {Spot} */ a) => (/** @type {Spot} */ b) => apart(a, b) < samePlace;
    const isKnown = (/** @type {Spot} */ at) => known.some(isSame(at));
    const {vectors, lines} = drawnIn(view);
    known.push(...vectors.filter(({statement}) => statement < 0).flatMap(({ends}) => ends));
    const statements = [...new Set([...vectors, ...lines].map(({statement}) => statement))].filter((each) => each >= 0);
    /** @type {Task[]} */
    const tasks = [];
    for (const statement of statements.sort((a, b) => a - b)) {
        const ofIt = vectors.filter((each) => each.statement === statement),
            on = lines.filter((each) => each.statement === statement);
        const unknown = unknownIn(statement);
        const isMet = (/** @type {Spot} */ at) => on.some(({points}) => points.slice(1).some(isSame(at)));
        for (const {name, ends: [tail, tip]} of ofIt) {
            if (isMet(tail) || isMet(tip) || unknown.has(name) || (isKnown(tail) && isKnown(tip))) continue;
            tasks.push({statement, kind: 'vector', name, from: tail, by: minus(tip, tail)});
            known.push(tail, tip);
        }
        for (const {points, direction} of on) {
            const from = points.find(isKnown);
            if (!from || (points.length > 1 && points.every(isKnown))) continue;
            const lying = ofIt.find(({ends}) =>
                ends.every((at) => Math.abs(dot(minus(at, from), quarterTurn(direction))) < samePlace),
            );
            tasks.push({statement, kind: 'line', name: lying?.name ?? '', from, by: direction});
        }
        // Of a force only the line of action is known: it is drawn through the end that is known.
        for (const {name, ends} of ofIt) {
            const from = ends.find(isKnown);
            if (!unknown.has(name) || on.length > 0 || !from || ends.every(isKnown)) continue;
            tasks.push({statement, kind: 'line', name, from, by: unitOf(minus(ends[1], ends[0]))});
        }
        known.push(...on.flatMap(({points}) => points), ...ofIt.flatMap(({ends}) => ends));
    }
    return tasks;
}

/**
 * Vectors and lines of a polygon on paper; statement −1: given.
 * @param {FigureView} view
 */
function drawnIn(view) {
    const vectors = [...view.group.querySelectorAll(':scope > g.vector')].flatMap((node) => {
        const name = node.getAttribute('data-name') ?? '',
            ends = view.vector(name);
        return ends && apart(...ends) > longEnough
            ? [{statement: Number(node.getAttribute('data-statement') ?? -1), name, ends}]
            : [];
    });
    const lines = view.motion.data.plans[0].lines
        .filter(([figure]) => figure === view.id)
        .flatMap(([, name, statement]) => {
            const line = view.line(name);
            return line ? [{statement, points: line.points, direction: line.direction}] : [];
        });
    return {vectors, lines};
}

/**
 * The fault of a line; empty if it is right.
 * @param {Task} task
 * @param {Spot} from
 * @param {Spot} to
 * @returns {'' | 'wrong_point' | 'wrong_direction' | 'wrong_sense' | 'too_long' | 'too_short'}
 */
function faultOf(task, from, to) {
    const by = minus(to, from), size = apart(from, to), wanted = Math.hypot(task.by.x, task.by.y);
    if (apart(from, task.from) > samePlace) return 'wrong_point';
    if (size < longEnough) return 'too_short';
    const across = Math.abs(dot(by, quarterTurn(task.by))) / (size * wanted);
    if (across > Math.sin(straightEnough * Math.PI / 180)) return 'wrong_direction';
    if (task.kind === 'line') return '';
    if (dot(by, task.by) < 0) return 'wrong_sense';
    if (Math.abs(size - wanted) <= Math.max(longEnough, shareEnough * wanted)) return '';
    return size > wanted ? 'too_long' : 'too_short';
}

class Exercise {
    /** @param {Page} page */
    constructor(page) {
        this.page = page;
        this.isOn = false;
        this.figure = '';
        this.next = 0;
        /**
         * By finished task: 1, right at the first try; ½, with help; 0, shown.
         * @type {number[]}
         */
        this.points = [];
        this.isHelped = false;
        /** @type {Element | null} */
        this.group = null;
        /** @type {Handle | null} */
        this.handle = null;
        this.from = {x: 0, y: 0};
    }
    wire() {
        const {page} = this;
        page.at('try').onclick = () => (this.isOn ? this.end() : this.begin());
        page.at('try-figure').onchange = () => this.take(page.at('try-figure').value);
        page.at('try-point').onchange = () => this.choosePoint();
        page.at('try-direction').onchange = () => this.aim();
        page.at('try-check').onclick = () => this.check();
        page.at('try-hint').onclick = () => this.hint();
        page.at('try-show').onclick = () => this.finish(0);
        document.addEventListener('languagechosen', () => this.isOn && this.refresh());
    }
    /** @param {FigureView} view */
    tasksOf(view) {
        return tasksOf(view, (statement) => this.unknownIn(statement, view.id.startsWith('forces')));
    }
    /**
     * Reads the table under a sentence: terms, whether their magnitudes are known, whether their directions are. A
     * sentence on forces names the forces that it finds.
     * @param {number} statement
     * @param {boolean} isOfForces
     */
    unknownIn(statement, isOfForces) {
        const sentence = this.page.sheet.querySelector(`li[data-says="${statement}"]`);
        const table = /** @type {HTMLTableElement | null} */ (sentence?.querySelector('table.equation') ?? null);
        const rows = table
            ? [...table.rows].map((row) => [...row.cells].map((cell) => cell.textContent ?? ''))
            : [[], [], []];
        const names = [...this.page.sheet.querySelectorAll('g.vector')].map(
            (node) => node.getAttribute('data-name') ?? '',
        );
        const unknown = rows[0].filter((_, i) => rows[1][i] === '?' && rows[2][i].startsWith('✓'));
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
        return this.page.figures.find((view) => view.id === this.figure);
    }
    /** @returns {Task[]} */
    get tasks() {
        return this.view ? this.tasksOf(this.view) : [];
    }

    begin() {
        const {page} = this;
        page.pause();
        page.ruler.turn(false);
        page.motion?.toDrawn(page.course);
        page.show();
        const first = this.polygons[0];
        if (!first) return page.announce(page.word('nothing_to_try'));
        this.isOn = true;
        this.take(first.id);
    }
    end() {
        this.isOn = false;
        this.clear();
        this.page.showTrying(false);
        this.page.showStep(-1, false);
    }
    /** @param {string} figure */
    take(figure) {
        this.figure = figure;
        this.next = 0;
        this.points = [];
        this.isHelped = false;
        this.refresh();
        this.view?.svg.scrollIntoView({block: 'center'});
    }
    clear() {
        for (const node of document.querySelectorAll('g.student')) takeAway(node);
        this.group = this.handle = null;
    }

    /** Shows the page before the next line. */
    refresh() {
        const {page} = this;
        page.showTrying(true);
        this.clear();
        const {view, tasks} = this;
        if (!view) return this.end();
        fill(
            page.at('try-figure'),
            this.polygons.map((each) => [each.id, each.caption + each.id.replace(/^[^-]*-?/, ' ')]),
            this.figure,
        );
        const task = tasks[this.next],
            isDone = task === undefined;
        page.hideFrom(isDone ? Infinity : task.statement);
        for (const figure of page.sheet.querySelectorAll('.figures > figure')) {
            const isMechanism = figure.getAttribute('data-figure-name') === 'mechanism';
            figure.classList.toggle('aside', !figure.contains(view.svg) && !isMechanism);
        }
        for (const id of ['try-point', 'try-direction', 'try-check', 'try-hint', 'try-show'])
            page.at(id).disabled = isDone;
        const score = this.points.reduce((sum, each) => sum + each, 0);
        page.at('try-score').textContent = page
            .word('score')
            .replace('{0}', page.numberText(score))
            .replace('{1}', String(tasks.length));
        page.at('try-length').textContent = '';
        this.group = drawn(view.svg, 'g', {class: 'student'});
        const ofStatement = tasks.slice(0, this.next).filter((each) => each.statement === task?.statement);
        for (const each of ofStatement) this.drawDone(each, view);
        if (isDone) return this.tell(page.word('all_drawn'), page.at('try-figure'));
        this.ask(task);
        const points = this.pointsKnown(view);
        fill(
            page.at('try-point'),
            points.map(({name}, i) => [String(i), name]),
            '0',
        );
        fill(
            page.at('try-direction'),
            [['', page.word('by_hand')], ...this.directions().map(({name}, i) => [String(i), name])],
            '',
        );
        this.layLine(view);
    }
    /** @param {Task} task */
    ask(task) {
        const word = task.kind === 'vector' ? 'draw_vector' : task.name === '' ? 'draw_line' : 'draw_line_of';
        const [before, after = ''] = this.page.word(word).split('{0}'),
            [letter, low = '', high = ''] = task.name.split('_');
        const node = this.page.at('try-task');
        node.textContent = before;
        for (const [tag, text] of [['i', letter], ['sub', low], ['sup', high]]) {
            if (text === '') continue;
            node.append(document.createElement(tag));
            node.lastChild.textContent = text;
        }
        node.append(after);
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

    // --- the choices
    // --------------------------------------------------------------------------------------------------

    /**
     * Vertices already drawn, the pole first.
     * @param {FigureView} view
     * @returns {{name: string, at: Spot}[]}
     */
    pointsKnown(view) {
        const {tasks} = this, done = tasks.slice(0, this.next), now = tasks[this.next];
        const letters = view.motion.data.plans[0].spots.filter(([figure]) => figure === view.id).flatMap(([, name]) => {
            const at = view.spot(name);
            return at ? [{name: unscored(name), at}] : [];
        });
        const drawnVectors = [...view.group.querySelectorAll(':scope > g.vector:not(.later)')].flatMap((node) => {
            const name = node.getAttribute('data-name') ?? '', ends = view.vector(name);
            return ends ? [{name, ends}] : [];
        });
        const own = done
            .filter((each) => each.kind === 'vector')
            .map(({name, from, by}) => ({name, ends: [from, along(from, 1, by)]}));
        const places = [tasks[0].from, ...[...drawnVectors, ...own].flatMap(({ends}) => ends), now.from];
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

    // --- the student's line
    // -------------------------------------------------------------------------------------------

    /** @param {FigureView} view */
    layLine(view) {
        const group = /** @type {Element} */ (this.group),
            points = this.pointsKnown(view);
        for (const {at} of points)
            drawn(group, 'circle', {cx: at.x.toFixed(3), cy: at.y.toFixed(3), r: 1.1, class: 'vertex'});
        drawn(group, 'line', {class: 'own'});
        this.handle = new Handle(group, view.svg, this.page.word('line_end'), (at) => this.drag(at));
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
        const {kind} = this.tasks[this.next];
        const written = (/** @type {number} */ value) => page.numberText(value);
        page.at('try-length').textContent =
            kind === 'vector' ? measured(apart(from, handle.at), view.drawnScale, view.unit, written) : '';
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

    // --- the verdict
    // --------------------------------------------------------------------------------------------------

    check() {
        if (!this.handle) return;
        const fault = faultOf(this.tasks[this.next], this.from, this.handle.at);
        if (fault === '') return this.finish(this.isHelped ? 0.5 : 1);
        this.isHelped = true;
        this.tell(this.page.word(fault));
    }
    hint() {
        this.isHelped = true;
        const {statement} = this.tasks[this.next];
        const sentence = this.page.says.find((each) => Number(each.dataset.says) === statement);
        this.tell(sentence ? spoken(sentence) : this.page.word('no_hint'));
    }
    /** @param {number} points */
    finish(points) {
        const kind = points > 0 ? 'right' : 'shown';
        this.points.push(points);
        ++this.next;
        this.isHelped = false;
        this.refresh();
        if (this.next < this.tasks.length) this.tell(this.page.word(kind));
    }
    /**
     * @param {string} words
     * @param {HTMLElement} [focus]
     */
    tell(words, focus) {
        this.page.at('try-verdict').textContent = words;
        focus?.focus();
        if (focus) this.page.at('try-task').textContent = '';
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
