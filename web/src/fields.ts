// Rows of the panel: a name and a value that is typed as the file has it (a number, a quantity, a formula), or chosen.
import {html} from './dom.js';
import {typed} from './edit.js';
import {word} from './words.js';

/** @typedef {import('./bench.js').Bench} Bench */

let fields = 0;

/**
 * A value as it is typed.
 * @param {any} value
 */
export function asTyped(value) {
    return value === undefined || value === null
        ? ''
        : typeof value === 'object'
          ? JSON.stringify(value)
          : String(value);
}
/**
 * @param {string} name
 * @param {HTMLElement} control
 * @param {string} [unit]
 */
export function row(name, control, unit = '') {
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
 * @param {string} name
 * @param {string} value
 * @param {(value: any, text: string) => void} change what was typed, as the file has it
 * @param {{unit?: string, id?: string, text?: boolean, hint?: string}} more text: a text whatever is typed
 */
export function field(name, value, change, {unit = '', id = '', text = false, hint = ''} = {}) {
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
/**
 * @param {string} name
 * @param {string} value
 * @param {[string, string][]} choices value and text
 * @param {(value: string) => void} change
 * @param {string} [id]
 */
export function choice(name, value, choices, change, id = '') {
    const select = html('select', {id: id || null, onchange: () => change(select.value)},
        ...choices.map(([each, text]) => html('option', {value: each, selected: each === value}, text)));
    return row(name, select);
}
/**
 * @param {string} name
 * @param {boolean} isOn
 * @param {(isOn: boolean) => void} change
 */
export function tick(name, isOn, change) {
    const input = html('input', {
        type: 'checkbox',
        checked: isOn,
        id: `field-${++fields}`,
        onchange: () => change(input.checked)
    });
    return html('div', {class: 'row tick'}, input, html('label', {for: input.id}, name));
}
/**
 * @param {string | Node} name
 * @param {string} text
 * @param {string} [look]
 */
export const told = (name, text, look = '') =>
    html('div', {class: 'row'}, html('span', {}, name), html('span', {class: `value ${look}`}, text));
/**
 * @param {string} text
 * @param {() => void} act
 * @param {string} [id]
 */
export const button = (text, act, id = '') => html('button', {type: 'button', onclick: act, id: id || null}, text);
/** @param {string} text */
export const heading = (text) => html('h2', {}, text);

/**
 * A field for one value of the file, by its path; emptied, the member is taken away if it may be absent.
 * @param {Bench} bench
 * @param {string} name
 * @param {(string | number)[]} path
 * @param {{unit?: string, id?: string, optional?: boolean, text?: boolean}} more
 */
export function fileField(bench, name, path, {unit = '', id = '', optional = false, text = false} = {}) {
    const value = bench.document.lastJson?.plainAt(path);
    return field(name, asTyped(value), (typedValue, asText) => bench.edit((edit) => {
        if (asText.trim() === '' && optional) edit.remove(path);
        else if (/^\s*[[{]/.test(asText) && isJson(asText)) edit.set(path, JSON.parse(asText));
        else edit.set(path, typedValue);
    }), {unit, id, text, hint: word('formula_hint')});
}
/** @param {string} text */
function isJson(text) {
    try {
        JSON.parse(text);
        return true;
    } catch {
        return false;
    }
}
