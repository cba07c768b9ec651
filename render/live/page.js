// The page: the sheets in its languages, the modes, the menu, the keys. Owns the motion, which all figures follow, and
// the parts that handle the reader's input.

import {Drive} from './drive.js';
import {Exercise} from './exercise.js';
import {FigureView} from './figures.js';
import {LoadedView} from './loaded.js';
import {Hall} from './hall.js';
import {Keys} from './keys.js';
import {Ruler} from './measure.js';
import {Motion} from './motion.js';
import {Panel} from './panel.js';
import {Traces} from './plot.js';
import {rowsOf} from './room.js';
import {Stage} from './stage.js';
import {Steps} from './steps.js';
import {Teller} from './tell.js';
/** @typedef {import('./types.js').Course} Course */

/** @typedef {'move' | 'steps' | 'try' | 'results' | 'given'} Mode */

export class Page {
    constructor() {
        this.data = JSON.parse(/** @type {HTMLElement} */ (document.getElementById('data')).textContent ?? '');
        if (this.data.pens) this.data.moving.pens = this.data.pens;
        this.language = document.documentElement.lang;
        this.motion = this.data.moving ? new Motion(this.data.moving) : null;
        /** @type {Mode} */
        this.mode = 'results';
        /** @type {Record<string, FigureView[]>} */
        this.views = {};
        this.sheets = [...document.querySelectorAll('main')];
        this.ruler = new Ruler(this);
        this.exercise = new Exercise(this);
        this.traces = new Traces(this);
        this.panel = new Panel(this);
        this.teller = new Teller(this);
        this.stage = new Stage(this);
        this.steps = new Steps(this);
        this.drive = new Drive(this);
        this.hall = new Hall(this);
        this.keys = new Keys(this);
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
        this.leaveOut();
        this.wireReading();
        this.stage.wire();
        if (this.motion) this.drive.wire(this.motion);
        this.setLanguage(this.language);
        if (this.motion) this.drive.choose(0);
        this.setMode(this.says.length > 0 ? 'steps' : this.motion ? 'move' : 'results');
        document.documentElement.dataset.ready = 'true';
    }
    /** Removes controls that this page has no use for. */
    leaveOut() {
        const {motion, data} = this;
        const has = /** @type {Record<string, boolean>} */ ({
            moving: motion !== null && !motion.isStill,
            record: motion !== null,
            given: motion !== null && motion.data.settings.length + motion.data.fixed.length > 0,
            steps: this.says.length > 0,
            dark: data.dark === true,
        });
        for (const node of document.querySelectorAll('[data-for]')) {
            if (!has[node.getAttribute('data-for') ?? '']) node.remove();
        }
        document.documentElement.classList.toggle('still', has.record && !has.moving);
        document.documentElement.classList.toggle('wordy', !has.record && !has.steps);
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
    /** Figures of the current language. */
    get figures() {
        return this.views[this.language] ?? [];
    }
    get says() {
        return this.steps.says;
    }
    /** The step that is read; −1: all. */
    get step() {
        return this.steps.at;
    }
    /** @returns {Course} */
    get course() {
        return this.drive.course;
    }

    // --- state of the page -------------------------------------------------------------------------------------------

    /** The state that the next version of this page starts from. */
    whereItIs() {
        const theme = this.at('theme');
        return {
            language: this.language,
            mode: this.mode === 'try' ? 'steps' : this.mode,
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
            if (driver >= 0) this.drive.choose(driver);
            if (driver >= 0 && from.at !== null) this.moveTo(from.at);
        }
        this.steps.at = Math.min(from.step, this.says.length - 1);
        this.setMode(/** @type {Mode} */ (from.mode));
    }

    // --- language, mode ----------------------------------------------------------------------------------------------

    /** @param {string} language */
    setLanguage(language) {
        this.language = language;
        document.documentElement.lang = language;
        for (const node of document.querySelectorAll('main, h1'))
            /** @type {HTMLElement} */ (node).hidden = /** @type {HTMLElement} */ (node).lang !== language;
        // The controls stand in the sheet of the language before they are named in it.
        this.sheet.querySelector('.stage')?.prepend(this.at('layers'));
        this.sheet.querySelector(':scope > .text')?.prepend(this.at('panels'));
        for (const node of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('[data-word]'))) {
            const main = node.closest('main');
            node.textContent = this.data.words[main ? main.lang : language][node.dataset.word ?? ''];
        }
        /** @type {NodeListOf<HTMLElement>} */
        const named = document.querySelectorAll('[id][data-label]');
        for (const node of named) this.name(node, node.dataset.label ?? '');
        this.at('language').value = language;
        document.title = document.querySelector('h1:not([hidden])')?.textContent ?? '';
        this.bindFigures();
        this.stage.show();
        if (this.ruler.isOn) this.ruler.turn(true);
        if (this.motion) this.traces.draw();
        document.dispatchEvent(new Event('languagechosen'));
        this.steps.show(this.step, false);
        this.reachTables();
    }
    /**
     * The accessible name of a control, which the pointer sees too.
     * @param {HTMLElement} node
     * @param {string} key
     */
    name(node, key) {
        node.dataset.label = key;
        node.setAttribute('aria-label', this.word(key));
        if (node.matches('button')) node.title = this.word(key);
    }
    /** @param {Mode} mode */
    setMode(mode) {
        const tab = (/** @type {string} */ each) => document.querySelector(`[data-mode="${each}"][role=tab]`);
        if (!tab(mode)) mode = 'results';
        if (mode === this.mode && document.documentElement.dataset.mode) return;
        const wasTrying = this.mode === 'try';
        this.mode = mode;
        if (wasTrying) this.exercise.end();
        document.documentElement.dataset.mode = mode;
        for (const each of document.querySelectorAll('[role=tab]')) each.setAttribute('aria-selected',
            String(each === tab(mode)));
        this.steps.show(this.step, false);
        if (mode === 'try') this.exercise.begin();
        this.reachTables();
    }
    /** Makes a table that is wider than the screen focusable, so that keys can scroll it. */
    reachTables() {
        for (const table of this.sheet.querySelectorAll('table')) {
            if (table.scrollWidth > table.clientWidth) table.tabIndex = 0;
            else table.removeAttribute('tabindex');
        }
        for (const text of this.sheet.querySelectorAll('pre')) {
            // Rows of tables begin with blanks and stay whole; other lines may be broken.
            const rows = (text.textContent ?? '').split('\n').filter((line) => line.startsWith(' '));
            text.style.setProperty('--columns', String(Math.max(40, ...rows.map((row) => row.length))));
        }
    }
    /** Binds the figures of a language when they are first shown, in the drawn position. */
    bindFigures() {
        const {motion} = this;
        if (!motion || this.views[this.language]) return;
        const here = {at: motion.at, index: motion.courses.indexOf(motion.course)}, {settings, isDrawn} = motion;
        motion.toDrawn();
        const svgs = [...this.sheet.querySelectorAll('.figures svg')], place = this.sheet.querySelector('.figures');
        place?.classList.add('binding');
        this.views[this.language] = svgs.flatMap((svg, i) => {
            const info = this.data.figures[this.language][i], own = /** @type {SVGSVGElement} */ (svg);
            const figures = [...svg.querySelectorAll('g.figure:not([data-figure=detail])')];
            const groups = figures.filter((group) => !group.parentElement?.closest('g.figure'));
            for (const node of svg.querySelectorAll('g.detail, g.figure[data-figure=detail]'))
                node.classList.add('still');
            const View = info.loaded ? LoadedView : FigureView;
            const views = groups.map((group) => new View(own, group, info, motion, this.data.names));
            const follow = views.length > 0 && views.every((view) => view.follows);
            svg.classList.toggle('following', follow);
            if (follow) views.forEach((view) => view.bind());
            const rows = rowsOf(views);
            // Twice: the first pass does not know the heights of the tables below the others.
            for (let times = 0; follow && times < 2; ++times) views.forEach((view) => view.area.takeRoom(views, rows));
            return views;
        });
        place?.classList.remove('binding');
        if (isDrawn) return;
        motion.give(settings);
        motion.moveTo(motion.courses[here.index], here.at);
    }

    // --- input -------------------------------------------------------------------------------------------------------

    wireReading() {
        this.steps.wire();
        this.hall.wire();
        this.at('print').onclick = () => window.print();
        this.at('language').onchange = () => this.setLanguage(this.at('language').value);
        this.at('ruler').onclick = () => this.ruler.turn(!this.ruler.isOn);
        for (const tab of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('[role=tab]')))
            tab.onclick = () => (this.setMode(/** @type {Mode} */ (tab.dataset.mode ?? 'try')),
                this.keys.openMenu(false));
        this.keys.wire();
        const theme = this.at('theme');
        if (theme) {
            theme.onchange = () => {
                if (theme.value) document.documentElement.dataset.theme = theme.value;
                else delete document.documentElement.dataset.theme;
            };
        }
        window.addEventListener('resize', () => this.reachTables());
        for (const sheet of this.sheets) this.wireSheet(sheet);
    }
    /** @param {HTMLElement} sheet */
    wireSheet(sheet) {
        sheet.addEventListener('pointerover', (event) => {
            this.teller.light(this.teller.saidAt(event.target));
            this.teller.tell(event.target);
        });
        sheet.addEventListener('pointerdown', (event) => {
            const target = /** @type {Element} */ (event.target);
            const svg = /** @type {SVGSVGElement | null} */ (target.closest('.figures svg'));
            if (svg && this.ruler.isOn) this.ruler.begin(svg, event);
            else if (svg) this.exercise.pen.touch(svg, event);
        });
        sheet.addEventListener('pointerleave', () => {
            this.teller.light(null);
            this.teller.tell(null);
        });
        sheet.addEventListener('click', (event) => {
            const sentence = /** @type {Element} */ (event.target).closest('li[data-says]');
            if (sentence) this.showStep(this.says.indexOf(/** @type {HTMLElement} */ (sentence)));
        });
    }
    /**
     * @param {number} step −1: all
     * @param {boolean} announced
     */
    showStep(step, announced = true) {
        if (this.says.length > 0) this.setMode('steps');
        this.steps.show(step, announced);
    }
    /** @param {string} words */
    announce(words) {
        this.at('announcement').textContent = words;
    }

    // --- moving ------------------------------------------------------------------------------------------------------

    /** @param {number} at */
    moveTo(at) {
        this.drive.moveTo(at);
    }
    pause() {
        this.drive.pause();
    }
    /** Updates all that depends on the position. */
    show() {
        this.drive.show();
    }
    /** @param {number} point */
    pathOf(point) {
        return this.drive.pathOf(point);
    }
    /** @param {number} value */
    numberText(value) {
        const size = Math.abs(value);
        const text =
            size !== 0 && (size < 1e-3 || size >= 1e6) ? value.toExponential(4) : String(Number(value.toPrecision(6)));
        return text.replace('.', this.data.words[this.language].decimal_mark).replace('-', '−');
    }
}
