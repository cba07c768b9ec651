// The file that is edited: its text, its name, what was saved last, and the history of its changes.
import {JsonText} from './json_text.js';

/** @typedef {{text: string, selection: string | null}} Moment */

const mostMoments = 1000, mostCharacters = 2e7;

export class MechanismDocument {
    constructor() {
        this.text = '';
        this.name = '';
        /**
         * What the file on disk has; null: it does not exist yet.
         * @type {string | null}
         */
        this.base = null;
        /** What was opened or saved last: the text is changed where it differs. */
        this.kept = '';
        /** @type {Moment[]} */
        this.past = [];
        /** @type {Moment[]} */
        this.future = [];
        /** The name of a change that the next one of the same name joins, as while something is dragged. */
        this.joins = '';
        /** @type {JsonText | null} */
        this.json = null;
        /**
         * The text as it was last when it was JSON.
         * @type {JsonText | null}
         */
        this.lastJson = null;
        /**
         * What is selected, so that undoing brings it back.
         * @type {() => string | null}
         */
        this.selected = () => null;
        /** @type {((selection: string | null | undefined) => void)[]} */
        this.listeners = [];
    }
    /**
     * Begins with another file.
     * @param {string} text
     * @param {string} name
     * @param {string | null} base
     */
    open(text, name, base) {
        this.past = [];
        this.future = [];
        this.joins = '';
        this.name = name;
        this.base = base;
        this.kept = text;
        this.lastJson = null;
        this.take(text, null);
    }
    /**
     * Changes the text. Changes that follow each other with the same `joins` are one step of the history.
     * @param {string} text
     * @param {string} [joins]
     */
    change(text, joins = '') {
        if (text === this.text) return;
        if (joins === '' || joins !== this.joins) this.past.push({text: this.text, selection: this.selected()});
        this.joins = joins;
        this.future = [];
        this.forget();
        this.take(text);
    }
    /** Ends what joins: the next change is a step of its own. */
    rest() {
        this.joins = '';
    }
    forget() {
        let characters = this.past.reduce((sum, {text}) => sum + text.length, 0);
        while (this.past.length > mostMoments || (characters > mostCharacters && this.past.length > 1))
            characters -= this.past.shift()?.text.length ?? 0;
    }
    undo() {
        this.go(this.past, this.future);
    }
    redo() {
        this.go(this.future, this.past);
    }
    /**
     * @param {Moment[]} from
     * @param {Moment[]} to
     */
    go(from, to) {
        const moment = from.pop();
        if (!moment) return;
        to.push({text: this.text, selection: this.selected()});
        this.joins = '';
        this.take(moment.text, moment.selection);
    }
    /**
     * The file on disk, or a copy that was taken away, has this text now.
     * @param {string} text
     */
    saved(text) {
        this.base = text;
        this.kept = text;
    }
    get isChanged() {
        return this.text !== this.kept;
    }
    /**
     * @param {string} text
     * @param {string | null} [selection] undefined: it stays
     */
    take(text, selection) {
        this.text = text;
        try {
            this.json = new JsonText(text);
            if (this.json.root.kind !== 'object') this.json = null;
        } catch {
            this.json = null;
        }
        if (this.json) this.lastJson = this.json;
        this.listeners.forEach((each) => each(selection));
    }
}
