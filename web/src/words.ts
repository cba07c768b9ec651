// The page's texts, in the language of the reader; the engine has them (lang/*.txt).

let words: Record<string, string> = {};

let marksByComma = false;

/** @param language of the reader */
export function setWords(all: Record<string, string>, language: string) {
    words = all;
    marksByComma = language !== 'en';
}
/**
 * A number as the reader's language writes it: −12,57.
 * @param digits significant ones
 */
export function numberText(value: number, digits: number) {
    const text = String(Number(value.toPrecision(digits))).replace('-', '−');
    return marksByComma ? text.replace('.', ',') : text;
}
/**
 * What was typed, with the decimal point of files: "1,5 cm" is "1.5 cm" where the language marks decimals by a comma.
 */
export const withPoint = (text: string) =>
    marksByComma ? text.replace(/^([-+]?\d+),(\d+(?:[eE][-+]?\d+)?\s*(?:[^\d\s,;].*)?)$/, '$1.$2') : text;
/** A text with its places {0}, {1} filled. */
export function word(key: string, ...parts: (string | number)[]) {
    return (words[key] ?? key).replace(/\{(\d)\}/g, (place, i) => String(parts[i] ?? place));
}
/** Fills what the page has under data-word (text), data-label (name) and data-hint (title). */
export function dress(root: ParentNode) {
    for (const each of root.querySelectorAll('[data-word]'))
        each.textContent = word((each as HTMLElement).dataset.word ?? '');
    for (const each of root.querySelectorAll('[data-label]')) {
        const text = word((each as HTMLElement).dataset.label ?? '');
        each.setAttribute('aria-label', text);
        if (each.matches('button')) each.setAttribute('title', text);
        if (each.matches('input')) each.setAttribute('placeholder', text);
    }
}
