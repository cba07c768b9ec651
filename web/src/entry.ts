// The line in which places are typed: "150, 0" are coordinates, "40 < 60" a length and an angle from the last point.
import type {Bench} from './bench';
import {byId} from './dom';
import {type Spots, typed} from './edit';
import {type Json, Literal} from './json_text';
import {SelectTool} from './tools';

const numberOf = (value: Json) => (value instanceof Literal ? Number(value.text) : NaN);

/**
 * What was typed, as a target; null: neither form.
 * @param from the point where a line begins
 */
export function targetOf(text: string, from: string, spots: Spots) {
    const polar = text.split('<'), pair = text.split(text.includes(';') ? ';' : ',');
    const none = {point: '', bar: null, says: '', snapped: ''};
    if (polar.length === 2 && from && polar.every((each) => each.trim())) {
        const [length, turned] = polar.map((each) => typed(each.replace(/\u00b0\s*$/, '')));
        const start = spots[from] ?? [0, 0];
        const rad = ((numberOf(turned) || 0) * Math.PI) / 180, away = numberOf(length) || 0;
        const at: [number, number] = [start[0] + away * Math.cos(rad), start[1] + away * Math.sin(rad)];
        return {...none, at, form: {from, distance: length, angle: turned}};
    }
    if (pair.length === 2 && pair.every((each) => each.trim())) {
        const form = pair.map(typed);
        return {...none, at: form.map((each) => numberOf(each) || 0) as [number, number], form};
    }
    return null;
}

export class Entry {
    input: HTMLInputElement = byId('entry');

    constructor(bench: Bench, canvas: SVGSVGElement) {
        this.input.addEventListener('keydown', (event) => {
            if (event.key === 'Escape') {
                this.input.value = '';
                canvas.focus();
            }
            if (event.key !== 'Enter') return;
            const {tool} = bench,
                picked = tool?.picked ?? [],
                target = targetOf(this.input.value, picked[picked.length - 1] ?? '', bench.spots);
            this.input.setAttribute('aria-invalid', String(!target));
            if (!target || !tool) return;
            this.input.value = '';
            tool.pick(target);
            canvas.focus();
            bench.tell('cursor');
        });
        this.input.addEventListener('input', () => this.input.removeAttribute('aria-invalid'));
        // A digit on the canvas begins it.
        canvas.addEventListener('keydown', (event) => {
            const draws = bench.tool && !(bench.tool instanceof SelectTool);
            if (!draws || event.ctrlKey || event.metaKey || event.altKey || !/^[-\d.<=]$/.test(event.key)) return;
            event.preventDefault();
            event.stopImmediatePropagation();
            this.input.value = event.key;
            this.input.focus();
        });
        bench.on(['tool'], () => (this.input.hidden = !bench.tool || bench.tool instanceof SelectTool));
    }
}
