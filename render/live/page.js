// The page: handles the reader's input. Owns the motion, which all figures follow.

class Page {
    constructor() {
        this.data = JSON.parse(/** @type {HTMLElement} */ (document.getElementById('data')).textContent ?? '');
        this.language = document.documentElement.lang;
        this.motion = this.data.moving ? new Motion(this.data.moving) : null;
        this.step = -1;  // all steps
        this.isPlaying = false;
        /** @type {Record<string, FigureView[]>} */
        this.views = {};
        /**
         * Areas that the figures may cover over the range of a driver, by language and driver.
         * @type {Map<string, Map<SVGSVGElement, number[]>>}
         */
        this.rooms = new Map();
        /** @type {Course | null} */
        this.shownWay = null;
        this.ruler = new Ruler(this);
        this.exercise = new Exercise(this);
        this.traces = new Traces(this);
        this.panel = new Panel(this);
        this.teller = new Teller(this);
        this.sheets = [...document.querySelectorAll('main')];
        /** @type {Record<string, {cell: Element, column: number, text: string}[]>} */
        this.allCells = {};
        this.completeDrawings();
    }
    /** Drawings that are equal in the languages of the page were sent with the first only. */
    completeDrawings() {
        const sent = document.querySelectorAll('main:first-of-type .figures svg *');
        for (const stand of document.querySelectorAll('[data-as]')) {
            stand.replaceWith(sent[Number(stand.getAttribute('data-as'))].cloneNode(true));
        }
    }

    start() {
        this.wireReading();
        if (this.motion) this.wireMoving(this.motion);
        this.setLanguage(this.language);
        if (this.motion) this.chooseDriver(0);
        document.documentElement.dataset.ready = 'true';
    }

    /** @param {string} key */
    word(key) {
        return this.data.words[this.language][key];
    }
    /** @returns {HTMLElement} */
    get sheet() {
        return /** @type {HTMLElement} */ (this.sheets.find((each) => each.lang === this.language));
    }
    /**
     * @param {string} id
     * @returns {any}
     */
    at(id) {
        return document.getElementById(id);
    }
    /** Cells of values that follow the mechanism, in the current language. */
    get cells() {
        return this.allCells[this.language] ??= [...this.sheet.querySelectorAll('td[data-column]')].map(
            (cell) => ({cell, column: Number(cell.getAttribute('data-column')), text: ''}));
    }
    /** Figures of the current language. */
    get figures() {
        return this.views[this.language] ?? [];
    }

    // --- state of the page
    // --------------------------------------------------------------------------------------------

    /** The state that the next version of this page starts from. */
    whereItIs() {
        const theme = this.at('theme');
        return {
            language: this.language,
            step: this.step,
            theme: theme ? theme.value : '',
            fit: this.motion ? this.at('fit').checked : true,
            driver: this.motion ? this.course.name : '',
            at: this.motion && !this.motion.isDrawn ? this.motion.at : null,
        };
    }
    /**
     * Restores the state as far as possible: the file may have changed.
     * @param {ReturnType<Page['whereItIs']>} from
     */
    takeUp(from) {
        const theme = this.at('theme');
        if (theme) {
            theme.value = from.theme;
            theme.onchange();
        }
        this.setLanguage(from.language);
        if (this.motion) {
            this.at('fit').checked = from.fit;
            const driver = this.motion.data.courses.findIndex((course) => course.name === from.driver);
            if (driver >= 0) this.chooseDriver(driver);
            if (driver >= 0 && from.at !== null) this.moveTo(from.at);
        }
        this.showStep(Math.min(from.step, this.says.length - 1), false);
    }

    // --- language, theme ---------------------------------------------------------------------------------------------

    /** @param {string} language */
    setLanguage(language) {
        this.language = language;
        document.documentElement.lang = language;
        for (const sheet of this.sheets) sheet.hidden = sheet.lang !== language;
        for (const node of document.querySelectorAll('[data-word]')) {
            const main = node.closest('main');
            const words = this.data.words[main ? main.lang : language];
            node.textContent = words[/** @type {HTMLElement} */ (node).dataset.word ?? ''];
        }
        this.at('language').value = language;
        document.title = this.sheet.querySelector('h1')?.textContent ?? '';
        this.bindFigures();
        if (this.ruler.isOn) this.ruler.turn(true);
        this.showStep(this.step, false);
        if (this.motion) this.traces.draw();
        document.dispatchEvent(new Event('languagechosen'));
        this.reachTables();
    }
    /** Makes a table that is wider than the screen focusable, so that keys can scroll it. */
    reachTables() {
        for (const table of this.sheet.querySelectorAll('table')) {
            if (table.scrollWidth > table.clientWidth) table.tabIndex = 0;
            else table.removeAttribute('tabindex');
        }
    }
    /** Binds the figures of a language when they are first shown, in the drawn position. */
    bindFigures() {
        const {motion} = this;
        if (!motion || this.views[this.language]) return;
        const here = {at: motion.at, index: motion.courses.indexOf(motion.course)}, {settings, isDrawn} = motion;
        motion.toDrawn();
        const svgs = [...this.sheet.querySelectorAll('.figures svg')];
        this.views[this.language] = svgs.flatMap((svg, i) => {
            const info = this.data.figures[this.language][i], own = /** @type {SVGSVGElement} */ (svg);
            const figures = [...svg.querySelectorAll('g.figure:not([data-figure=detail])')];
            const groups = figures.filter((group) => !group.parentElement?.closest('g.figure'));
            for (const node of svg.querySelectorAll('g.detail, g.figure[data-figure=detail]'))
                node.classList.add('still');
            const views = groups.map((group) => new FigureView(own, group, info, motion, this.data.names));
            const follow = views.length > 0 && views.every((view) => view.follows);
            svg.classList.toggle('following', follow);
            if (follow) views.forEach((view) => view.bind());
            const rows = rowsOf(views);
            // Twice: the first pass does not know the heights of the tables below the others.
            for (let times = 0; follow && times < 2; ++times) views.forEach((view) => view.takeRoom(views, rows));
            return views;
        });
        if (isDrawn) return;
        motion.give(settings);
        motion.moveTo(motion.courses[here.index], here.at);
    }

    // --- reading -----------------------------------------------------------------------------------------------------

    wireReading() {
        this.at('previous').onclick = () =>
            this.showStep(this.step < 0 ? this.says.length - 1 : Math.max(this.step - 1, 0));
        this.at('next').onclick = () =>
            this.showStep(this.step < 0 ? 0 : Math.min(this.step + 1, this.says.length - 1));
        this.at('all').onclick = () => this.showStep(-1);
        this.at('print').onclick = () => window.print();
        this.at('language').onchange = () => this.setLanguage(this.at('language').value);
        this.at('ruler').onclick = () => this.ruler.turn(!this.ruler.isOn);
        const theme = this.at('theme');
        if (theme) {
            theme.onchange = () => {
                if (theme.value) document.documentElement.dataset.theme = theme.value;
                else delete document.documentElement.dataset.theme;
            };
        }
        document.addEventListener('keydown', (event) => this.onKey(event));
        window.addEventListener('resize', () => this.reachTables());
        for (const sheet of this.sheets) {
            sheet.addEventListener('pointerover', (event) => {
                this.light(this.saidAt(event.target));
                this.teller.tell(event.target);
            });
            sheet.addEventListener('pointerdown', (event) => {
                const svg = /** @type {SVGSVGElement | null} */ (
                    /** @type {Element} */ (event.target).closest('.figures svg')
                );
                if (svg && this.ruler.isOn) this.ruler.begin(svg, event);
                else if (svg) this.exercise.touch(svg, event);
            });
            sheet.addEventListener('pointerleave', () => {
                this.light(null);
                this.teller.tell(null);
            });
            sheet.addEventListener('click', (event) => {
                const sentence = /** @type {Element} */ (event.target).closest('li[data-says]');
                if (sentence) this.showStep(this.says.indexOf(/** @type {HTMLElement} */ (sentence)));
            });
        }
    }
    /**
     * The sentences of the visible sheet, in order.
     * @returns {HTMLElement[]}
     */
    get says() {
        return [...this.sheet.querySelectorAll('li[data-says]')].map((each) => /** @type {HTMLElement} */ (each));
    }
    /** @param {KeyboardEvent} event */
    onKey(event) {
        const target = /** @type {HTMLElement} */ (event.target);
        if (event.ctrlKey || event.metaKey || event.altKey || target.matches('input, select')) return;
        if (event.key === 'Escape' && this.exercise.isOn) this.exercise.end();
        else if (event.key === 'Escape' && this.ruler.isOn) this.ruler.turn(false);
        if (this.exercise.isOn) return;
        const actions = /** @type {Record<string, () => void>} */ ({
            'ArrowRight': () => this.at('next').click(),
            'n': () => this.at('next').click(),
            'ArrowLeft': () => this.at('previous').click(),
            'p': () => this.at('previous').click(),
            'Escape': () => this.showStep(-1),
            'Home': () => this.showStep(0),
            'End': () => this.showStep(this.says.length - 1),
            ' ': () => this.at('play')?.click(),
            '0': () => this.at('drawn')?.click(),
            'm': () => this.at('ruler').click(),
            'v': () => this.at('values')?.click(),
        });
        const action = actions[event.key];
        if (!action || (event.key === ' ' && target.matches('button'))) return;
        event.preventDefault();
        action();
    }
    /**
     * The number of the statement of a sentence or stroke.
     * @param {EventTarget | null} target
     */
    saidAt(target) {
        const node = target instanceof Element ? target.closest('[data-statement], [data-says]') : null;
        return node && (node.getAttribute('data-statement') ?? node.getAttribute('data-says'));
    }
    /**
     * Highlights the strokes of a sentence, or the sentence of a stroke.
     * @param {string | null} number
     */
    light(number) {
        for (const node of this.sheet.querySelectorAll('.lit')) node.classList.remove('lit');
        if (number === null) return;
        for (const node of this.sheet.querySelectorAll(`[data-statement="${number}"], [data-says="${number}"]`))
            node.classList.add('lit');
    }
    /**
     * @param {number} step −1: all
     * @param {boolean} announced
     */
    showStep(step, announced = true) {
        const {says} = this;
        this.step = says.length > 0 ? step : -1;
        const number = (/** @type {HTMLElement} */ each) => Number(each.dataset.says);
        const now = this.step < 0 ? Infinity : number(says[this.step]);
        says.forEach((each, i) => {
            each.classList.toggle('now', i === this.step);
            if (i === this.step) each.setAttribute('aria-current', 'step');
            else each.removeAttribute('aria-current');
        });
        for (const svg of this.sheet.querySelectorAll('.figures svg')) svg.classList.toggle('reading', this.step >= 0);
        for (const node of this.sheet.querySelectorAll('svg [data-statement]')) {
            const drawn = Number(node.getAttribute('data-statement'));
            node.classList.toggle('now', drawn === now);
            node.classList.toggle('past', this.step >= 0 && drawn < now);
            node.classList.toggle('later', this.step >= 0 && drawn > now);
        }
        const where =
            this.step < 0
                ? ''
                : this.word('step')
                      .replace('{0}', String(this.step + 1))
                      .replace('{1}', String(says.length));
        this.at('step').textContent = where;
        if (!announced || this.step < 0) return;
        says[this.step].scrollIntoView({block: 'nearest'});
        this.announce(`${where}: ${spoken(says[this.step])}`);
    }
    /**
     * Hides the strokes and sentences of a statement and of those after it.
     * @param {number} statement
     */
    hideFrom(statement) {
        for (const svg of this.sheet.querySelectorAll('.figures svg')) svg.classList.add('reading');
        for (const node of this.sheet.querySelectorAll('svg [data-statement], li[data-says]')) {
            const number = Number(node.getAttribute('data-statement') ?? node.getAttribute('data-says'));
            node.classList.remove('now', 'past');
            node.classList.toggle('later', number >= statement);
        }
    }
    /**
     * Shows the controls of the exercise instead of those for motion and reading.
     * @param {boolean} isOn
     */
    showTrying(isOn) {
        document.documentElement.classList.toggle('trying', isOn);
        this.at('trying').hidden = !isOn;
        this.at('moving').hidden = isOn;
        this.at('try').setAttribute('aria-pressed', String(isOn));
        this.at('try').textContent = this.word(isOn ? 'end_trying' : 'begin_trying');
        for (const id of ['previous', 'next', 'all', 'step']) this.at(id).hidden = isOn;
        if (!isOn) for (const node of document.querySelectorAll('li.later')) node.classList.remove('later');
    }
    /**
     * The current scale of a figure: units of the quantity for a millimetre.
     * @param {SVGSVGElement} svg
     */
    scaleOf(svg) {
        const view = this.figures.find((each) => each.svg === svg), group = svg.querySelector('g.figure');
        const shown = view?.scales[0];
        return shown ? {scale: shown.now, unit: shown.unit} :
            {scale: Number(group?.getAttribute('data-scale') ?? 0), unit: group?.getAttribute('data-unit') ?? ''};
    }
    /** @param {string} words */
    announce(words) {
        this.at('announcement').textContent = words;
    }

    // --- moving ------------------------------------------------------------------------------------------------------

    /** @param {Motion} motion */
    wireMoving(motion) {
        const driver = this.at('driver');
        motion.data.courses.forEach((course, i) => driver.add(new Option(course.name, String(i))));
        driver.parentElement.hidden = motion.data.courses.length < 2;
        driver.onchange = () => this.chooseDriver(Number(driver.value));
        const position = this.at('position');
        position.oninput = () => {
            this.pause();
            this.moveTo(Number(position.value));
        };
        this.at('play').onclick = () => (this.isPlaying ? this.pause() : this.play());
        this.at('drawn').onclick = () => {
            this.pause();
            motion.toDrawn(this.course);
            this.show();
        };
        this.at('fit').onchange = () => this.show();
        this.at('values').onchange = () => this.show();
        this.exercise.wire();
        this.traces.wire();
        this.panel.wire(motion);
        for (const sheet of this.sheets) {
            for (const svg of sheet.querySelectorAll('.figures svg'))
                this.wireDragging(/** @type {SVGSVGElement} */ (svg), motion);
        }
    }
    /** @returns {Course} */
    get course() {
        const {courses} = /** @type {Motion} */ (this.motion);
        return courses[Number(this.at('driver').value) || 0];
    }
    /** @param {number} index */
    chooseDriver(index) {
        this.pause();
        this.at('driver').value = String(index);
        this.motion?.toDrawn(this.course);
        this.showWay();
        this.traces.draw();
    }
    /** Shows the range of the driver with the current givens. */
    showWay() {
        const {course} = this, position = this.at('position');
        this.shownWay = course;
        this.rooms.clear();
        for (const view of this.figures) view.travels.forEach((travel) => Object.assign(travel, {from: 0, to: 0}));
        position.min = String(course.samples[0].at);
        position.max = String(course.samples[course.samples.length - 1].at);
        position.setAttribute('aria-label', `${this.word('position')}: ${course.name}`);
        this.showStops();
    }
    /** A button for each limit and change point of the range. */
    showStops() {
        const {course} = this, {samples} = course, stops = this.at('stops');
        stops.textContent = '';
        const ends = [
            ...course.startsAtLimit ? [samples[0].at] : [], ...course.changePoints,
            ...course.endsAtLimit ? [samples[samples.length - 1].at] : [],
        ];
        for (const at of ends) {
            const button = document.createElement('button');
            button.type = 'button';
            button.textContent = this.positionText(at);
            button.title = this.word(course.changePoints.includes(at) ? 'change_point' : 'limit');
            button.onclick = () => {
                this.pause();
                this.moveTo(at);
            };
            stops.append(button, ' ');
        }
    }
    /** @param {number} at */
    moveTo(at) {
        if (!this.motion?.moveTo(this.course, at)) return this.say(this.word('out_of_reach'));
        this.show();
    }
    play() {
        this.isPlaying = true;
        this.at('play').textContent = this.word('pause');
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
        if (this.at('play')) this.at('play').textContent = this.word('play');
    }

    /** @param {number} at */
    positionText(at) {
        const {course} = this;
        const written = (/** @type {number} */ value, /** @type {number} */ digits) =>
            value.toLocaleString(this.language, {maximumFractionDigits: digits}).replace('-', '−');
        if (course.byLaw) return `${written(at, 3)} s`;
        return course.turns ? `${written(at * 180 / Math.PI, 2)}°` : `${written(at * 1000, 2)} mm`;
    }
    /** Updates all that depends on the position. */
    show() {
        const {motion} = this;
        if (!motion) return;
        const {course} = this, {samples} = course;
        if (course !== this.shownWay) this.showWay();
        this.at('position').value = String(motion.at);
        this.at('where').textContent = this.positionText(motion.at);
        const isNear = (/** @type {number} */ at) =>
            Math.abs(at - motion.at) < 1e-6 * Math.abs(course.to - course.from);
        const atLimit =
            (course.startsAtLimit && isNear(samples[0].at))
            || (course.endsAtLimit && isNear(samples[samples.length - 1].at));
        if (course.changePoints.some(isNear)) this.say(this.word('change_point'));
        else if (atLimit) this.say(this.word('limit'));
        else this.say(motion.plan < 0 ? this.word('no_construction') : '');
        this.panel.show(motion);
        for (const view of this.figures) this.showFigure(view, motion);
        for (const view of this.figures) view.written = (value) => this.numberText(value);
        for (const view of this.figures) view.showValues(this.at('values').checked, (value) => this.numberText(value));
        this.ruler.show();
        this.traces.show();
        for (const each of this.cells) {
            const value = motion.value(each.column);
            const text = value === null ? '–' : this.numberText(value / motion.data.columns[each.column].size);
            if (each.text !== text) each.cell.textContent = each.text = text;
        }
        for (const note of this.sheet.querySelectorAll('.text .note'))
            /** @type {HTMLElement} */ (note).hidden = motion.isDrawn;
    }
    /** @param {string} words */
    say(words) {
        if (this.at('reason').textContent !== words) this.at('reason').textContent = words;
    }
    /** @param {number} value */
    numberText(value) {
        const size = Math.abs(value);
        const text =
            size !== 0 && (size < 1e-3 || size >= 1e6) ? value.toExponential(4) : String(Number(value.toPrecision(6)));
        return (this.language === 'it' ? text.replace('.', ',') : text).replace('-', '−');
    }
    /**
     * @param {FigureView} view
     * @param {Motion} motion
     */
    showFigure(view, motion) {
        const {note} = view, canFollow = view.svg.matches('.following') && (!view.isConstructed || motion.plan >= 0);
        note.hidden = motion.isDrawn || canFollow;
        view.svg.classList.toggle('as-drawn', !motion.isDrawn && !canFollow);
        if (motion.isDrawn || !canFollow) {
            view.restore();
            // So that a path is fully visible, and the figure stays in place when the motion begins.
            if (view.info.name === 'mechanism' && this.traces.isTraced)
                view.svg.setAttribute('viewBox', this.roomOf(view).join(' '));
            view.held?.take(false);
            return this.sayScale(view);
        }
        const fits = this.at('fit').checked && !view.isMechanism;
        view.held?.take(this.at('fit').checked);
        // Polygons of one drawing have one scale.
        const together = fits ? this.figures.filter(({svg}) => svg === view.svg) : [];
        const to = fits ? view.fitted(Math.max(...together.map((each) => each.shrinkage()))) : undefined;
        view.placeCompanions(fits);
        view.follow(fits ? view.fitRoom : this.roomOf(view), to);
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
            scale.textContent = view.scales.map(({now, unit}) =>
                `1 mm ≙ ${this.numberText(Number(now.toPrecision(3)))} ${unit}`).join(';  ');
        }
    }
    /**
     * The figure's own area, extended by what it covers over the driver's range: nothing leaves it, and its scale stays
     * constant.
     * @param {FigureView} view
     */
    roomOf(view) {
        const key = `${this.language} ${this.course.driver} ${this.at('fit').checked}`;
        if (!this.rooms.has(key)) this.rooms.set(key, this.measureRooms());
        return this.rooms.get(key)?.get(view.svg) ?? view.viewBox;
    }
    measureRooms() {
        const motion = /** @type {Motion} */ (this.motion), {course} = this, here = motion.at;
        const most = 1, fits = this.at('fit').checked;
        const rooms = new Map(this.figures.map((view) => {
            const [x, y, width, height] = view.viewBox;
            return [view.svg, {left: x, top: y, right: x + width, bottom: y + height}];
        }));
        for (const sample of course.samples) {
            if (!motion.moveTo(course, sample.at)) continue;
            for (const view of this.figures) {
                if (!view.svg.matches('.following') || (view.isConstructed && motion.plan < 0)) continue;
                const [x, y, width, height] = view.viewBox,
                    room = /** @type {any} */ (rooms.get(view.svg)),
                    margin = view.isFree ? 14 : 8;
                view.scale = view.drawnScale;
                view.origin = view.drawnOrigin;
                view.held?.take(fits);
                view.measureTravels();
                for (const at of view.extent()) {
                    room.left = Math.max(Math.min(room.left, at.x - margin), x - most * width);
                    room.right = Math.min(Math.max(room.right, at.x + margin), x + (1 + most) * width);
                    room.top = Math.max(Math.min(room.top, at.y - margin), y - most * height);
                    room.bottom = Math.min(Math.max(room.bottom, at.y + margin), y + (1 + most) * height);
                }
            }
        }
        motion.moveTo(course, here);
        // The scale bar is below what moves.
        for (const view of this.figures) {
            const room = rooms.get(view.svg), [, y, , height] = view.viewBox;
            if (room && view.isMechanism && view.measures.length > 0 && room.bottom > y + height) room.bottom += 8;
        }
        return new Map([...rooms].map(
            ([svg, room]) => [svg, [room.left, room.top, room.right - room.left, room.bottom - room.top]]));
    }

    // --- dragging ----------------------------------------------------------------------------------------------------

    /**
     * Dragging a moving point: the mechanism goes to the position in which the point is nearest to the pointer.
     * @param {SVGSVGElement} svg
     * @param {Motion} motion
     */
    wireDragging(svg, motion) {
        /** @type {{point: number, path: Spot[], sample: number} | null} */
        let held = null;
        const view = () =>
            this.figures.find((each) => each.svg === svg && each.isMechanism && !each.isFree && each.follows);
        const spotOf = (/** @type {PointerEvent} */ event) => {
            const matrix = svg.getScreenCTM();
            return matrix ? new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse()) : null;
        };
        svg.addEventListener('pointerdown', (event) => {
            const figure = view(), at = spotOf(event);
            if (!figure || !at || this.ruler.isOn || this.exercise.isOn) return;
            const point = nearestMoving(figure, motion, at);
            if (point < 0) return;
            this.pause();
            const path = this.pathOf(point), {samples} = this.course;
            const sample = samples.reduce((best, each, i) =>
                Math.abs(each.at - motion.at) < Math.abs(samples[best].at - motion.at) ? i : best, 0);
            held = {point, path, sample};
            svg.setPointerCapture(event.pointerId);
            svg.classList.add('holding');
            event.preventDefault();
        });
        // On a joint a touch drags it, elsewhere it scrolls the page.
        svg.addEventListener('touchstart', (event) => {
            if (held) event.preventDefault();
        }, {passive: false});
        svg.addEventListener('pointermove', (event) => {
            const figure = view(), at = spotOf(event);
            if (!held || !figure || !at) return;
            const near = nearestOnPath(
                held.path,
                figure.unpaper(at),
                held.sample,
                !this.course.startsAtLimit && !this.course.endsAtLimit,
            );
            held.sample = near.sample;
            const {samples} = this.course, next = samples[Math.min(near.sample + 1, samples.length - 1)];
            this.moveTo(samples[near.sample].at + near.share * (next.at - samples[near.sample].at));
        });
        const leave = () => {
            held = null;
            svg.classList.remove('holding');
        };
        svg.addEventListener('pointerup', leave);
        svg.addEventListener('pointercancel', leave);
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

/**
 * The moving point under the pointer; −1: none.
 * @param {FigureView} figure
 * @param {Motion} motion
 * @param {Spot} at
 */
function nearestMoving(figure, motion, at) {
    let best = -1, least = 6;
    motion.data.points.forEach(([body], i) => {
        const off = body === 0 ? least : apart(figure.point(i), at);
        if (off < least) [best, least] = [i, off];
    });
    return best;
}

/**
 * The place of a path nearest to the pointer and near the previous one, so that a path that crosses itself is followed
 * in order.
 * @param {Spot[]} path
 * @param {Spot} at
 * @param {number} before
 * @param {boolean} closes
 */
function nearestOnPath(path, at, before, closes) {
    const count = path.length - 1, reach = Math.ceil(count / 6);
    let best = {sample: Math.min(before, count - 1), share: 0}, least = Infinity;
    for (let k = before - reach; k <= before + reach; ++k) {
        const i = closes ? (k % count + count) % count : k;
        if (i < 0 || i >= count) continue;
        const step = minus(path[i + 1], path[i]), size = dot(step, step);
        const share = size > 0 ? Math.min(Math.max(dot(minus(at, path[i]), step) / size, 0), 1) : 0;
        const off = apart(along(path[i], share, step), at);
        if (off < least) [best, least] = [{sample: i, share}, off];
    }
    return best;
}

/**
 * A sentence as a screen reader reads it, without its equation's table.
 * @param {Element} sentence
 */
function spoken(sentence) {
    const copy = /** @type {Element} */ (sentence.cloneNode(true));
    for (const table of copy.querySelectorAll('table')) table.remove();
    return copy.textContent ?? '';
}

if (typeof document !== 'undefined') {
    const page = new Page();
    page.start();
    Object.assign(window, {kinegraph: page});
}
