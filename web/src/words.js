// The page's texts, in the language of the reader; the engine has them (lang/*.txt).

/** @type {Record<string, string>} */
let words = {};

/** @param {Record<string, string>} all */
export function setWords(all) {
    words = all;
}
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
