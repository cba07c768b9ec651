// Rows of the panel: a name and a value that is typed as the file has it (a number, a quantity, a formula), or chosen.
import type {Bench} from './bench';
import {html} from './dom';
import {typed} from './edit';
import type {Json} from './json_text';
import {word} from './words';

let fields = 0;

/** A value as it is typed. */
export function asTyped(value: Json) {
    return value === undefined || value === null
        ? ''
        : typeof value === 'object'
          ? JSON.stringify(value)
          : String(value);
}
export function row(name: string, control: HTMLElement, unit = '') {
    const id = control.id || `field-${++fields}`;
    control.id = id;
    return html(
        'div',
        {class: 'row'},
        html('label', {for: id}, name),
        html('span', {class: 'control'}, control, html('span', {class: 'unit'}, unit))
    );
}
/**
 * @param change what was typed, as the file has it
 * @param more text: a text whatever is typed
 */
export function field(
    name: string, value: string, change: (value: Json, text: string) => void,
    {unit = '', id = '', text = false, hint = ''}: {unit?: string, id?: string, text?: boolean, hint?: string} = {}
) {
    const input = html('input', {
        value,
        id: id || null,
        autocomplete: 'off',
        spellcheck: 'false',
        title: hint || null,
        inputmode: text ? 'text' : null
    });
    const take = () => {
        if (input.value === value) return;
        // From here on the field may be shown anew.
        input.defaultValue = input.value;
        change(text ? input.value : typed(input.value), input.value);
    };
    input.addEventListener('change', take);
    input.addEventListener('keydown', (event) => {
        if (event.key === 'Escape') {
            input.value = value;
            event.stopPropagation();
        }
    });
    return row(name, input, unit);
}
/** @param choices value and text */
export function choice(
    name: string, value: string, choices: [string, string][], change: (value: string) => void, id = ''
) {
    const select: HTMLSelectElement = html('select', {id: id || null, onchange: () => change(select.value)},
        ...choices.map(([each, text]) => html('option', {value: each, selected: each === value}, text)));
    return row(name, select);
}
export function tick(name: string, isOn: boolean, change: (isOn: boolean) => void) {
    const input: HTMLInputElement = html('input', {
        type: 'checkbox',
        checked: isOn,
        id: `field-${++fields}`,
        onchange: () => change(input.checked)
    });
    return html('div', {class: 'row tick'}, input, html('label', {for: input.id}, name));
}
export const told = (name: string | Node, text: string, look = '') =>
    html('div', {class: 'row'}, html('span', {}, name), html('span', {class: `value ${look}`}, text));
export const button = (text: string, act: () => void, id = '') =>
    html('button', {type: 'button', onclick: act, id: id || null}, text);
export const heading = (text: string) => html('h2', {}, text);

/** A field for one value of the file, by its path; emptied, the member is taken away if it may be absent. */
export function fileField(
    bench: Bench, name: string, path: (string | number)[],
    {unit = '', id = '', optional = false, text = false}:
        {unit?: string, id?: string, optional?: boolean, text?: boolean} = {}
) {
    const value = bench.document.lastJson?.plainAt(path);
    return field(name, asTyped(value), (typedValue, asText) => bench.edit((edit) => {
        if (asText.trim() === '' && optional) edit.remove(path);
        else if (/^\s*[[{]/.test(asText) && isJson(asText)) edit.set(path, JSON.parse(asText));
        else edit.set(path, typedValue);
    }), {unit, id, text, hint: word('formula_hint')});
}
function isJson(text: string) {
    try {
        JSON.parse(text);
        return true;
    } catch {
        return false;
    }
}
