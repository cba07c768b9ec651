// node web/tests/same_bytes.mjs PROGRAM SITE: what the module answers for every example is, byte for byte, what the
// program writes: the results, the pages of the sheet, each figure. Prints the time of each answer.
import {execFileSync, spawnSync} from 'node:child_process';
import {mkdtempSync, readFileSync, readdirSync, rmSync, existsSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {basename, join} from 'node:path';
import {compiled} from '../compiled.mjs';

const [program, site] = process.argv.slice(2);
if (!program || !site) throw new Error('usage: node web/tests/same_bytes.mjs PROGRAM SITE');
const {openModule} = await compiled('site/module.ts');
const packed = join(site, 'kinegraph.wasm.zst'), unpacked = execFileSync('zstd', ['-dcq', packed], {maxBuffer: 1 << 28});
const answer = await openModule(await WebAssembly.compile(unpacked));
const ask = (request) => JSON.parse(answer(JSON.stringify(request)));

const folder = mkdtempSync(join(tmpdir(), 'kinegraph-web-'));
const paths = JSON.parse(readFileSync(join(site, 'examples.json'), 'utf8')).map(({path}) => path);
const text = (path) => readFileSync(join(site, path), 'utf8');

/** A request of the program (docs/batch.md) for each document, and the module's text of the same. */
const wanted = [];
const times = [];
for (const path of paths) {
    const request = {text: text(path), name: basename(path)}, before = performance.now();
    const whole = ask({...request, want: ['results', 'sheet', 'names']});
    times.push({path, ms: performance.now() - before});
    if (whole.failure) throw new Error(`${path}: ${whole.failure}`);
    const figures = ask({...request, want: [], figures: whole.names ?? []}).figures ?? {};
    const file = join(site, path);
    wanted.push({
        path,
        of: 'the sheet and results',
        request: {file, want: ['json', 'svg']},
        pages: whole.sheet ?? [],
        results: whole.results
    });
    for (const name of whole.names ?? [])
        wanted.push({
            path,
            of: name,
            request: {file, figure: name, want: ['svg']},
            pages: figures[name] === undefined ? [] : [figures[name]]
        });
}
const lines = wanted.map(({request}, i) => JSON.stringify({id: i, ...request, to: join(folder, String(i))})).join('\n');
const run = spawnSync(program, ['batch'], {input: lines, maxBuffer: 1 << 28, encoding: 'utf8'});
if (run.error) throw run.error;
const status = new Map(
    run.stdout
        .split('\n')
        .filter(Boolean)
        .map((line) => JSON.parse(line))
        .map((each) => [each.id, each])
);

const differ = new Map();
let compared = 0, bytes = 0;
const compare = ({path, of}, ours, file) => {
    const theirs = existsSync(file) ? readFileSync(file, 'utf8') : undefined;
    if (ours === undefined && theirs === undefined) return;
    ++compared;
    bytes += ours?.length ?? 0;
    if (ours !== theirs)
        differ.set(path, [...(differ.get(path) ?? []), `${of}: ${basename(file)} ${first(ours, theirs)}`]);
};
/** Where two texts begin to differ. */
function first(a, b) {
    if (a === undefined || b === undefined) return a === undefined ? 'only of the program' : 'only of the module';
    let at = 0;
    while (at < a.length && a[at] === b[at]) ++at;
    const about = (whole) => JSON.stringify(whole.slice(Math.max(0, at - 30), at + 30));
    return `at ${at}: ${about(a)} for ${about(b)}`;
}
wanted.forEach((each, i) => {
    if (!status.has(i)) throw new Error(`the program has no answer for ${each.path}, ${each.of}`);
    const stem = join(folder, String(i));
    const pages = readdirSync(folder).filter((name) => name === `${i}.svg` || name.startsWith(`${i}-`)).length;
    if (each.request.want.includes('json')) compare(each, each.results, `${stem}.json`);
    for (let page = 0; page < Math.max(pages, each.pages.length); ++page)
        compare(each, each.pages[page], page === 0 ? `${stem}.svg` : `${stem}-${page + 1}.svg`);
});
rmSync(folder, {recursive: true});

for (const [path, all] of differ) console.log(`${path} differs\n    ${all.join('\n    ')}`);
times.sort((a, b) => b.ms - a.ms);
console.log(
    `${paths.length} examples, ${compared} documents of ${(bytes / 1e6).toFixed(1)} MB compared: ` +
        `${paths.length - differ.size} examples are the same`
);
console.log(
    `time of an answer: ${(times.reduce((sum, {ms}) => sum + ms, 0) / times.length).toFixed(0)} ms on average, ` +
        'longest ' +
        times
            .slice(0, 5)
            .map(({path, ms}) => `${path} ${ms.toFixed(0)}`)
            .join(', ')
);
if (paths.length < 100 || compared < 3 * paths.length) throw new Error('too little was compared');
process.exit(differ.size === 0 ? 0 : 1);
