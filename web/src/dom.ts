// Elements made from words and attributes; texts are always texts, never markup.

const svgSpace = 'http://www.w3.org/2000/svg';

/** A listener of events of any kind: as a method it may ask for the kind that it listens to. */
type Listener = {listen(event: Event): unknown}['listen'];
/** true: without a value; false, null, undefined: absent; a function: a listener, by its name `onclick`, say. */
type Attributes = Record<string, string | number | boolean | null | undefined | Listener>;

function dressed<T extends Element>(element: T, attributes: Attributes, children: (Node | string)[]): T {
    for (const [name, value] of Object.entries(attributes)) {
        if (typeof value === 'function') element.addEventListener(name.slice(2), value);
        else if (value === true) element.setAttribute(name, '');
        else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, String(value));
    }
    element.append(...children);
    return element;
}
export const html = <K extends keyof HTMLElementTagNameMap>(
    tag: K, attributes: Attributes = {}, ...children: (Node | string)[]
): HTMLElementTagNameMap[K] => dressed(document.createElement(tag), attributes, children);
export const svg = <K extends keyof SVGElementTagNameMap>(
    tag: K, attributes: Attributes = {}, ...children: (Node | string)[]
): SVGElementTagNameMap[K] => dressed(document.createElementNS(svgSpace, tag), attributes, children);

/** The element of an id, which index.html has. */
export function byId<T extends Element = HTMLElement>(id: string): T {
    const found = document.getElementById(id);
    if (!found) throw new Error(`no #${id}`);
    return found as Element as T;
}
/** Offers bytes as a file. */
export function download(blob: Blob, name: string) {
    const address = URL.createObjectURL(blob);
    html('a', {href: address, download: name}).click();
    setTimeout(() => URL.revokeObjectURL(address), 10000);
}
