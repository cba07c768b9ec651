// The workbench: the file, what the engine says of it, what is selected, and the tool in hand. Everything else
// listens to it.
import {MechanismDocument} from './document.js';
import {Edit} from './edit.js';
import {Inquiry} from './inquiry.js';
import {JsonText, pathOf} from './json_text.js';
import {Model} from './model.js';
import {View} from './view.js';

/**
 * @typedef {import('./edit.js').Spots} Spots
 * @typedef {import('../../app/workbench/protocol.js').Answer} Answer
 * @typedef {import('./tools.js').Tool} Tool
 * @typedef {'file' | 'answer' | 'selection' | 'tool' | 'cursor' | 'view' | 'mode'} Topic
 */

export class Bench {
    /** @param {import('./engine.js').Engine} engine */
    constructor(engine) {
        this.engine = engine;
        this.document = new MechanismDocument();
        this.model = new Model(null);
        this.view = new View();
        /** @type {Spots} */
        this.spots = {};
        /** @type {Record<string, number>} */
        this.directions = {};
        /** @type {Answer | null} */
        this.answer = null;
        /**
         * What is selected, a JSON pointer.
         * @type {string | null}
         */
        this.selection = null;
        /** @type {Tool | null} */
        this.tool = null;
        /** @type {import('./snap.js').Target | null} */
        this.cursor = null;
        this.snaps = true;
        this.mode = 'build';
        /** @type {Map<Topic, (() => void)[]>} */
        this.listeners = new Map();
        this.inquiry = new Inquiry(this);
        this.document.selected = () => this.selection;
        this.document.listeners.push((selection) => this.onText(selection));
    }
    /**
     * @param {Topic[]} topics
     * @param {() => void} listener
     */
    on(topics, listener) {
        for (const topic of topics) this.listeners.set(topic, [...this.listeners.get(topic) ?? [], listener]);
    }
    /** @param {Topic} topic */
    tell(topic) {
        this.listeners.get(topic)?.forEach((each) => each());
    }
    /** @param {string | null | undefined} selection */
    onText(selection) {
        this.model = new Model(this.document.lastJson);
        if (selection !== undefined) this.selection = selection;
        if (this.selection !== null && !this.selected()) this.selection = null;
        this.inquiry.ask();
        this.tell('file');
    }
    /** @param {Answer} answer the newest, of the text as it is */
    onAnswer(answer) {
        this.answer = answer;
        if (answer.points) {
            this.spots = answer.points;
            this.directions = answer.directions ?? {};
        }
        this.tell('answer');
    }
    /**
     * Opens a text as the file.
     * @param {string} text
     * @param {string} name
     * @param {string | null} base what the file on disk has
     */
    open(text, name, base) {
        this.tool?.cancel();
        this.selection = null;
        this.spots = {};
        this.directions = {};
        this.answer = null;
        this.isToFit = true;
        this.document.open(text, name, base);
    }
    /**
     * Changes the file; `change` returns what is selected then (undefined: as before). While the text is no
     * JSON nothing is drawn.
     * @param {(edit: Edit) => string | null | undefined | void} change
     * @param {string} [joins]
     */
    edit(change, joins = '') {
        const {json} = this.document;
        if (!json) return;
        const edit = new Edit(json, this.spots), selection = change(edit);
        this.spots = edit.spots;
        if (selection !== undefined) this.selection = selection;
        this.document.change(edit.text, joins);
        this.tell('selection');
    }
    /** @param {string | null} pointer */
    select(pointer) {
        this.selection = pointer;
        this.tell('selection');
    }
    /** What is selected: its kind, its path, its value. */
    selected() {
        const json = this.document.lastJson;
        if (!json || this.selection === null) return null;
        const path = pathOf(json, this.selection), node = json.at(path);
        return node && path.length === 2 ? {list: String(path[0]), key: path[1], path, form: json.plainAt(path)} : null;
    }
    /** @param {Tool | null} tool */
    take(tool) {
        this.tool?.cancel();
        this.tool = tool;
        this.tell('tool');
    }
    /** @param {string} mode */
    setMode(mode) {
        this.mode = mode;
        this.tell('mode');
    }
    /** Whether all points are in view. */
    seesAll() {
        const {view, model, spots} = this;
        return model.points.every(({name}) => {
            const [x, y] = spots[name] ? view.toScreen(spots[name]) : [0, 0];
            return x >= 0 && y >= 0 && x <= view.width && y <= view.height;
        });
    }
    fit() {
        const length = {m: 0.5, cm: 40, mm: 300, in: 16, ft: 2}[this.model.unit] ?? 1;
        this.view.fit(this.model.points.map(({name}) => this.spots[name]).filter(Boolean), length);
        this.tell('view');
    }
}

/**
 * A mechanism that was just begun.
 * @param {string} title
 */
export const emptyFile = (title) => new JsonText(`{
  "kinegraph": 1,
  "title": "",
  "units": {"length": "mm"},
  "frame": 1,
  "points": {},
  "bodies": {},
  "joints": []
}
`).set(['title'], title).text;
