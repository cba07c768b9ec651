// A ZIP archive of one file, not compressed (PKWARE's APPNOTE, version 2.0): what a GeoGebra file is.

/** CRC-32 as in ISO 3309, reflected, by the bit: the texts are some 100 kB. */
export function crc32(bytes: Uint8Array) {
    let remainder = 0xffffffff;
    for (const byte of bytes) {
        remainder ^= byte;
        for (let bit = 0; bit < 8; ++bit) remainder = (remainder >>> 1) ^ (remainder & 1 ? 0xedb88320 : 0);
    }
    return ~remainder >>> 0;
}
/** Numbers of two or four bytes, least byte first: [value, size] each. */
function record(fields: [number, number][]) {
    const view = new DataView(new ArrayBuffer(fields.reduce((sum, [, size]) => sum + size, 0)));
    let at = 0;
    for (const [value, size] of fields) {
        if (size === 2) view.setUint16(at, value, true);
        else view.setUint32(at, value, true);
        at += size;
    }
    return new Uint8Array(view.buffer);
}
/** @param name in ASCII */
export function archiveOf(name: string, text: string): Blob {
    const coded = new TextEncoder(), letters = coded.encode(name), bytes = coded.encode(text);
    const version = 20, firstDay = 0x21; // 1 January 1980, so that the same text is the same archive
    const entry: [number, number][] = [
        [version, 2], [0, 2], [0, 2], [0, 2], [firstDay, 2], [crc32(bytes), 4], [bytes.length, 4], [bytes.length, 4],
        [letters.length, 2], [0, 2]
    ];
    const head = record([[0x04034b50, 4], ...entry]);
    const directory = record([[0x02014b50, 4], [version, 2], ...entry, [0, 2], [0, 2], [0, 2], [0, 4], [0, 4]]);
    const end = record([
        [0x06054b50, 4], [0, 2], [0, 2], [1, 2], [1, 2], [directory.length + letters.length, 4],
        [head.length + letters.length + bytes.length, 4], [0, 2]
    ]);
    return new Blob([head, letters, bytes, directory, letters, end], {type: 'application/zip'});
}
