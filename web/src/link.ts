// A link that holds the whole mechanism, compressed, behind the #: it is never sent to a server.

const mark = '#m=';
/** The most that a link may unfold to, bytes: more is no mechanism that anybody drew. */
export const mostBytes = 1 << 20;
const mostCharacters = 1 << 19;

/** @param {Uint8Array} bytes */
function base64url(bytes) {
    let text = '';
    for (let i = 0; i < bytes.length; i += 4096) text += String.fromCharCode(...bytes.subarray(i, i + 4096));
    return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}
/** @param {string} text */
function bytesOf(text) {
    return Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (each) => each.charCodeAt(0));
}
/**
 * The fragment of a text.
 * @param {string} text
 */
export async function fragmentOf(text) {
    const packed = new Blob([text])
        .stream()
        .pipeThrough(new /** @type {any} */ (globalThis).CompressionStream('deflate-raw'));
    return mark + base64url(new Uint8Array(await new Response(packed).arrayBuffer()));
}
/**
 * The text of a fragment; null: it holds none, or one that is damaged or too large.
 * @param {string} fragment
 */
export async function textOf(fragment) {
    const packed = fragment.slice(mark.length);
    if (!fragment.startsWith(mark) || packed.length > mostCharacters || !/^[\w-]*$/.test(packed)) return null;
    try {
        const stream = new Blob([bytesOf(packed)])
            .stream()
            .pipeThrough(new /** @type {any} */ (globalThis).DecompressionStream('deflate-raw'));
        const reader = stream.getReader(),
            parts = [];
        for (let size = 0; ;) {
            const {done, value} = await reader.read();
            if (done) break;
            size += value.length;
            if (size > mostBytes) {
                await reader.cancel();
                return null;
            }
            parts.push(value);
        }
        return new TextDecoder('utf-8', {fatal: true}).decode(await new Blob(parts).arrayBuffer());
    } catch {
        return null;
    }
}
/** @param {string} fragment */
export const isLink = (fragment) => fragment.startsWith(mark);
