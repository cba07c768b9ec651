// A link that holds the whole mechanism, compressed, behind the #: it is never sent to a server.

const mark = '#m=';
/** The most that a link may unfold to, bytes: more is no mechanism that anybody drew. */
export const mostBytes = 1 << 20;
const mostCharacters = 1 << 19;

function base64url(bytes: Uint8Array) {
    let text = '';
    for (let i = 0; i < bytes.length; i += 4096) text += String.fromCharCode(...bytes.subarray(i, i + 4096));
    return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}
function bytesOf(text: string) {
    return Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (each) => each.charCodeAt(0));
}
/** A stream of the browser's by which a link is packed or unpacked; TypeScript 4.8 does not know them. */
function packing(name: 'CompressionStream' | 'DecompressionStream') {
    const streams = globalThis as unknown as
        Record<string, new (format: string) => ReadableWritablePair<Uint8Array, Uint8Array>>;
    return new streams[name]('deflate-raw');
}
/** The fragment of a text. */
export async function fragmentOf(text: string) {
    const packed = new Blob([text])
        .stream()
        .pipeThrough(packing('CompressionStream'));
    return mark + base64url(new Uint8Array(await new Response(packed).arrayBuffer()));
}
/** The text of a fragment; null: it holds none, or one that is damaged or too large. */
export async function textOf(fragment: string) {
    const packed = fragment.slice(mark.length);
    if (!fragment.startsWith(mark) || packed.length > mostCharacters || !/^[\w-]*$/.test(packed)) return null;
    try {
        const stream = new Blob([bytesOf(packed)])
            .stream()
            .pipeThrough(packing('DecompressionStream'));
        const reader = stream.getReader(),
            parts: Uint8Array[] = [];
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
export const isLink = (fragment: string) => fragment.startsWith(mark);
