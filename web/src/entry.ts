// The line in which places are typed: "150, 0" are coordinates, "40 < 60" a length and an angle from the last point.
import {byId} from './dom.js';
import {typed} from './edit.js';
import {Literal} from './json_text.js';
import {SelectTool} from './tools.js';

/** @typedef {import('./bench.js').Bench} Bench */

/** @param {any} value */
const numberOf = (value) => (value instanceof Literal ? Number(value.text) : NaN);

/**
 * What was typed, as a target; null: neither form.
 * @param {string} text
 * @param {string} from the point where a line begins
 * @param {import('./edit.js').Spots} spots
 */
export function targetOf(text, from, spots) {
    const polar = text.split('<'), pair = text.split(text.includes(';') ? ';' : ',');
    const none = {point: '', bar: null, says: '', snapped: ''};
    if (polar.length === 2 && from && polar.every((each) => each.trim())) {
        const [length, turned] = polar.map((each) => typed(each.replace(/°\s*$/, ''))), start = spots[from] ?? [0, 0];
        const rad = ((numberOf(turned) || 0) * Math.PI) / 180, away = numberOf(length) || 0;
        /** @type {[number, number]} */
        const at = [start[0] + away * Math.cos(rad), start[1] + away * Math.sin(rad)];
        return {...none, at, form: {from, distance: length, angle: turned}};
    }
    if (pair.length === 2 && pair.every((each) => each.trim())) {
        const form = pair.map(typed);
        return {...none, at: /** @type {[number, number]} */ (form.map((each) => numberOf(each) || 0)), form};
    }
    return null;
}

export class Entry {
    /**
     * @param {Bench} bench
     * @param {SVGSVGElement} canvas
     */
    constructor(bench, canvas) {
        /** @type {HTMLInputElement} */
        this.input = byId('entry');
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
