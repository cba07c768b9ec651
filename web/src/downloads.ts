// What can be taken away: the file, results, the sheet as pictures, and print.
import {archiveOf} from './archive';
import type {Bench} from './bench';
import {byId, download, html} from './dom';
import {picture} from './figures';
import {word} from './words';

/** What the engine writes as one text: how it is asked for, and the file that it becomes. */
export interface File {
    type: string;
    ending: string;
    options?: Record<string, string>;
}
const documents: Record<string, File & {want: 'results' | 'tex' | 'cycle' | 'live' | 'geogebra'}> = {
    results: {want: 'results', type: 'text/plain', ending: '_results.json'},
    tex: {want: 'tex', type: 'text/plain', ending: '.tex'},
    cycle: {want: 'cycle', type: 'text/csv', ending: '.csv'},
    html: {want: 'live', type: 'text/html', ending: '.html', options: {theme: 'colour'}},
    geogebra: {want: 'geogebra', type: 'application/zip', ending: '.ggb'}
};
/** Dots for a unit of the picture: 96 dpi times three. */
const sharpness = 3;

const stem = (bench: Bench) => (bench.document.name || 'mechanism').replace(/\.json$/, '');

async function pngOf(text: string): Promise<Blob> {
    const image = picture(text, '');
    await image.decode();
    const canvas = html('canvas', {width: image.naturalWidth * sharpness, height: image.naturalHeight * sharpness});
    const pen = canvas.getContext('2d') as CanvasRenderingContext2D;
    pen.fillStyle = '#fff';
    pen.fillRect(0, 0, canvas.width, canvas.height);
    pen.drawImage(image, 0, 0, canvas.width, canvas.height);
    return new Promise((resolve, reject) =>
        canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('no picture'))), 'image/png')
    );
}
/** The pages of the sheet on white paper. */
async function pages(bench: Bench) {
    const answer = await bench.inquiry.other(['sheet'], [], {theme: 'colour'});
    return answer.sheet ?? [];
}
/** @param say what the reader is told where there is nothing to take */
export async function take(bench: Bench, kind: string, say: (text: string) => void) {
    const name = stem(bench),
        text = (each: string, type: string) => new Blob([each], {type});
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
/** Prints the sheet; the browser makes a PDF of it too. */
async function print(bench: Bench) {
    const paper = byId('paper'), images = (await pages(bench)).map((page) => picture(page, ''));
    await Promise.all(images.map((each) => each.decode()));
    paper.replaceChildren(...images);
    window.print();
}
