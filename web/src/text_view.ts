// The file as text, beside the drawing: what is written there is drawn, what is drawn is written; faults at their
// lines.
import type {Fault} from '../../app/workbench/protocol';
import type {Bench} from './bench';
import {byId, html} from './dom';
import {pathOf} from './json_text';
import {word} from './words';

export class TextView {
    area: HTMLTextAreaElement = byId('text');
    readonly lines = byId('lines');
    readonly faults = byId('faults');

    constructor(readonly bench: Bench) {
        this.area.addEventListener('input', () => bench.document.change(this.area.value, 'typing'));
        this.area.addEventListener('blur', () => bench.document.rest());
        this.area.addEventListener('scroll', () => (this.lines.scrollTop = this.area.scrollTop));
        this.area.addEventListener('keydown', (event) => this.indent(event));
        bench.on(['file'], () => this.showText());
        bench.on(['file', 'answer'], () => this.showFaults());
        bench.on(['selection'], () => this.showSelection());
    }
    showText() {
        const {text} = this.bench.document;
        if (this.area.value === text) return;
        const {scrollTop} = this.area;
        this.area.value = text;
        this.area.scrollTop = scrollTop;
    }
    /** A line break keeps the indentation. */
    indent(event: KeyboardEvent) {
        if (event.key !== 'Enter' || event.ctrlKey) return;
        const before = this.area.value.slice(0, this.area.selectionStart),
            line = before.slice(before.lastIndexOf('\n') + 1);
        const blanks = /^ */.exec(line)?.[0] ?? '';
        if (blanks === '') return;
        event.preventDefault();
        this.area.setRangeText(`\n${blanks}`, this.area.selectionStart, this.area.selectionEnd, 'end');
        this.bench.document.change(this.area.value, 'typing');
    }
    showFaults() {
        const {
                answer,
                document: {text}
            } = this.bench,
            faults = answer?.failure ? [{where: '', text: answer.failure}] : (answer?.faults ?? []);
        const marked = new Set(faults.map(({line}) => line)),
            count = text.split('\n').length;
        this.lines.replaceChildren(
            ...Array.from({length: Math.min(count, 20000)}, (_, i) =>
                html('span', {class: marked.has(i + 1) ? 'faulty' : ''}, String(i + 1))
            )
        );
        this.lines.scrollTop = this.area.scrollTop;
        this.faults.replaceChildren(...faults.map((each) => html('li', {}, this.faultButton(each))));
        this.faults.hidden = faults.length === 0;
        this.area.setAttribute('aria-invalid', String(faults.length > 0));
    }
    faultButton({where, line, text, fault, remedy}: Fault) {
        const place = line ? `${word('line', line)} ${where}` : where;
        const parts =
            fault && remedy
                ? [html('span', {}, fault), html('span', {class: 'remedy'}, remedy)]
                : [html('span', {}, text)];
        return html(
            'button',
            {type: 'button', onclick: () => this.goTo(where, line)},
            html('span', {class: 'place'}, place),
            ...parts
        );
    }
    /** Selects the place in the text, and what it belongs to. */
    goTo(pointer: string, line?: number) {
        const range = this.rangeOf(pointer) ?? this.rangeOfLine(line ?? 1);
        this.bench.tell('mode');
        byId('tab-file').click();
        this.area.focus();
        this.area.setSelectionRange(range[0], range[1]);
        this.scrollTo(range[0]);
    }
    rangeOf(pointer: string) {
        const {json} = this.bench.document;
        if (!json) return null;
        const path = pathOf(json, pointer);
        while (path.length > 0) {
            const node = json.at(path), last = path[path.length - 1];
            if (node) {
                const member = json.at(path.slice(0, -1))?.members.find(({key}) => key === last);
                return [member?.start ?? node.start, node.end];
            }
            path.pop();
        }
        return null;
    }
    rangeOfLine(line: number) {
        const lines = this.area.value.split('\n'),
            start = lines.slice(0, line - 1).reduce((sum, each) => sum + each.length + 1, 0);
        return [start, start + (lines[line - 1]?.length ?? 0)];
    }
    scrollTo(at: number) {
        const line = this.area.value.slice(0, at).split('\n').length,
            height = parseFloat(getComputedStyle(this.area).lineHeight);
        this.area.scrollTop = Math.max(0, (line - 4) * height);
    }
    /** Shows where the text says what is selected on the canvas. */
    showSelection() {
        if (document.activeElement === this.area || this.bench.selection === null) return;
        const range = this.rangeOf(this.bench.selection);
        if (!range) return;
        this.area.setSelectionRange(range[0], range[1]);
        this.scrollTo(range[0]);
    }
}
