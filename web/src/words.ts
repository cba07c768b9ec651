// The page's texts, in the language of the reader; the engine has them (lang/*.txt).

/** @type {Record<string, string>} */
let words = {};

let marksByComma = false;

/**
 * @param {Record<string, string>} all
 * @param {string} language of the reader
 */
export function setWords(all, language) {
    words = all;
    marksByComma = language !== 'en';
}
/**
 * A number as the reader's language writes it: −12,57.
 * @param {number} value
 * @param {number} digits significant ones
 */
export function numberText(value, digits) {
    const text = String(Number(value.toPrecision(digits))).replace('-', '−');
    return marksByComma ? text.replace('.', ',') : text;
}
/**
 * What was typed, with the decimal point of files: "1,5 cm" is "1.5 cm" where the language marks decimals by a comma.
 * @param {string} text
 */
export const withPoint = (text) =>
    marksByComma ? text.replace(/^([-+]?\d+),(\d+(?:[eE][-+]?\d+)?\s*(?:[^\d\s,;].*)?)$/, '$1.$2') : text;
/**
 * A text with its places {0}, {1} filled.
 * @param {string} key
 * @param {...(string | number)} parts
 */
export function word(key, ...parts) {
    return (words[key] ?? key).replace(/\{(\d)\}/g, (place, i) => String(parts[i] ?? place));
}
/**
 * Fills what the page has under data-word (text), data-label (name) and data-hint (title).
 * @param {ParentNode} root
 */
export function dress(root) {
    for (const each of root.querySelectorAll('[data-word]'))
        each.textContent = word(/** @type {HTMLElement} */ (each).dataset.word ?? '');
    for (const each of root.querySelectorAll('[data-label]')) {
        const text = word(/** @type {HTMLElement} */ (each).dataset.label ?? '');
        each.setAttribute('aria-label', text);
        if (each.matches('button')) each.setAttribute('title', text);
        if (each.matches('input')) each.setAttribute('placeholder', text);
    }
}
