// The file that is edited: its text, its name, what was saved last, and the history of its changes.
import {JsonText} from './json_text';

export interface Moment {
    text: string;
    selection: string | null;
}

const mostMoments = 1000, mostCharacters = 2e7;

export class MechanismDocument {
    text = '';
    name = '';
    /** What the file on disk has; null: it does not exist yet. */
    base: string | null = null;
    /** What was opened or saved last: the text is changed where it differs. */
    kept = '';
    past: Moment[] = [];
    future: Moment[] = [];
    /** The name of a change that the next one of the same name joins, as while something is dragged. */
    joins = '';
    json: JsonText | null = null;
    /** The text as it was last when it was JSON. */
    lastJson: JsonText | null = null;
    /** What is selected, so that undoing brings it back. */
    selected: () => string | null = () => null;
    listeners: ((selection: string | null | undefined) => void)[] = [];

    /** Begins with another file. */
    open(text: string, name: string, base: string | null) {
        this.past = [];
        this.future = [];
        this.joins = '';
        this.name = name;
        this.base = base;
        this.kept = text;
        this.lastJson = null;
        this.take(text, null);
    }
    /** Changes the text. Changes that follow each other with the same `joins` are one step of the history. */
    change(text: string, joins = '') {
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
    go(from: Moment[], to: Moment[]) {
        const moment = from.pop();
        if (!moment) return;
        to.push({text: this.text, selection: this.selected()});
        this.joins = '';
        this.take(moment.text, moment.selection);
    }
    /** The file on disk, or a copy that was taken away, has this text now. */
    saved(text: string) {
        this.base = text;
        this.kept = text;
    }
    get isChanged() {
        return this.text !== this.kept;
    }
    /** @param selection undefined: it stays */
    take(text: string, selection?: string | null) {
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
