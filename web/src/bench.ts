// The workbench: the file, what the engine says of it, what is selected, and the tool in hand. Everything else
// listens to it.
import type {Answer} from '../../app/workbench/protocol';
import {MechanismDocument} from './document';
import {Edit, type Spots} from './edit';
import type {Engine} from './engine';
import {Inquiry} from './inquiry';
import {JsonText, pathOf} from './json_text';
import {Model} from './model';
import type {Target} from './snap';
import type {Tool} from './tools';
import {View} from './view';

export type Topic = 'file' | 'answer' | 'selection' | 'tool' | 'cursor' | 'view' | 'mode';

export class Bench {
    readonly document = new MechanismDocument();
    model = new Model(null);
    readonly view = new View();
    spots: Spots = {};
    directions: Record<string, number> = {};
    answer: Answer | null = null;
    /** What is selected, a JSON pointer. */
    selection: string | null = null;
    tool: Tool | null = null;
    cursor: Target | null = null;
    snaps = true;
    mode = 'build';
    readonly listeners = new Map<Topic, (() => void)[]>();
    readonly inquiry: Inquiry;
    isToFit: boolean | undefined;

    constructor(readonly engine: Engine) {
        this.inquiry = new Inquiry(this);
        this.document.selected = () => this.selection;
        this.document.listeners.push((selection) => this.onText(selection));
    }
    on(topics: Topic[], listener: () => void) {
        for (const topic of topics) this.listeners.set(topic, [...this.listeners.get(topic) ?? [], listener]);
    }
    tell(topic: Topic) {
        this.listeners.get(topic)?.forEach((each) => each());
    }
    onText(selection: string | null | undefined) {
        this.model = new Model(this.document.lastJson);
        if (selection !== undefined) this.selection = selection;
        if (this.selection !== null && !this.selected()) this.selection = null;
        this.inquiry.ask();
        this.tell('file');
    }
    /** @param answer the newest, of the text as it is */
    onAnswer(answer: Answer) {
        this.answer = answer;
        if (answer.points) {
            this.spots = answer.points;
            this.directions = answer.directions ?? {};
        }
        this.tell('answer');
    }
    /**
     * Opens a text as the file.
     * @param base what the file on disk has
     */
    open(text: string, name: string, base: string | null) {
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
     */
    edit(change: (edit: Edit) => string | null | undefined | void, joins = '') {
        const {json} = this.document;
        if (!json) return;
        const edit = new Edit(json, this.spots), selection = change(edit);
        this.spots = edit.spots;
        if (selection !== undefined) this.selection = selection;
        this.document.change(edit.text, joins);
        this.tell('selection');
    }
    select(pointer: string | null) {
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
    take(tool: Tool | null) {
        this.tool?.cancel();
        this.tool = tool;
        this.tell('tool');
    }
    setMode(mode: string) {
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

/** A mechanism that was just begun. */
export const emptyFile = (title: string) => new JsonText(`{
  "kinegraph": 1,
  "title": "",
  "units": {"length": "mm"},
  "frame": 1,
  "points": {},
  "bodies": {},
  "joints": []
}
`).set(['title'], title).text;
