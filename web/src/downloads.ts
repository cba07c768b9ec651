// What can be taken away: the file, results, the sheet as pictures, and print.
import {archiveOf} from './archive.js';
import {byId, download, html} from './dom.js';
import {picture} from './figures.js';
import {word} from './words.js';

/** @typedef {import('./bench.js').Bench} Bench */

/**
 * What the engine writes as one text: how it is asked for, and the file that it becomes.
 * @typedef {{type: string, ending: string, options?: Record<string, string>}} File
 * @type {Record<string, File & {want: 'results' | 'tex' | 'cycle' | 'live' | 'geogebra'}>}
 */
const documents = {
    results: {want: 'results', type: 'text/plain', ending: '_results.json'},
    tex: {want: 'tex', type: 'text/plain', ending: '.tex'},
    cycle: {want: 'cycle', type: 'text/csv', ending: '.csv'},
    html: {want: 'live', type: 'text/html', ending: '.html', options: {theme: 'colour'}},
    geogebra: {want: 'geogebra', type: 'application/zip', ending: '.ggb'}
};
/** Dots for a unit of the picture: 96 dpi times three. */
const sharpness = 3;

/** @param {Bench} bench */
const stem = (bench) => (bench.document.name || 'mechanism').replace(/\.json$/, '');

/**
 * @param {string} text
 * @returns {Promise<Blob>}
 */
async function pngOf(text) {
    const image = picture(text, '');
    await image.decode();
    const canvas = html('canvas', {width: image.naturalWidth * sharpness, height: image.naturalHeight * sharpness});
    const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    pen.fillStyle = '#fff';
    pen.fillRect(0, 0, canvas.width, canvas.height);
    pen.drawImage(image, 0, 0, canvas.width, canvas.height);
    return new Promise((resolve, reject) =>
        canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('no picture'))), 'image/png')
    );
}
/**
 * The pages of the sheet on white paper.
 * @param {Bench} bench
 */
async function pages(bench) {
    const answer = await bench.inquiry.other(['sheet'], [], {theme: 'colour'});
    return answer.sheet ?? [];
}
/**
 * @param {Bench} bench
 * @param {string} kind
 * @param {(text: string) => void} say what the reader is told where there is nothing to take
 */
export async function take(bench, kind, say) {
    const name = stem(bench),
        text = (/** @type {string} */ each, /** @type {string} */ type) => new Blob([each], {type});
    if (kind === 'json') return download(text(bench.document.text, 'application/json'), `${name}.json`);
    const document_ = documents[kind];
    if (document_) {
        const answer = await bench.inquiry.other([document_.want], [], document_.options ?? {});
        const found = answer[document_.want];
        if (!found) return say(answer.faults.map((each) => each.text)[0] ?? word('engine_lost'));
        const blob = kind === 'geogebra' ? archiveOf('geogebra.xml', found) : text(found, document_.type);
        return download(blob, name + document_.ending);
    }
    if (kind === 'print') return print(bench);
    for (const [i, page] of (await pages(bench)).entries()) {
        const file = i === 0 ? name : `${name}-${i + 1}`;
        if (kind === 'svg') download(text(page, 'image/svg+xml'), `${file}.svg`);
        else download(await pngOf(page), `${file}.png`);
    }
}
/**
 * Prints the sheet; the browser makes a PDF of it too.
 * @param {Bench} bench
 */
async function print(bench) {
    const paper = byId('paper'), images = (await pages(bench)).map((page) => picture(page, ''));
    await Promise.all(images.map((each) => each.decode()));
    paper.replaceChildren(...images);
    window.print();
}
