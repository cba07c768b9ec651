// node web/tests/memory_test.mjs SITE: the module's memory stays the same over many changes of a file. Each change has
// another length of the crank, as when a point is dragged; every hundredth asks for the whole sheet.
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {compiled} from '../compiled.mjs';

const [site] = process.argv.slice(2);
const {openModule} = await compiled('site/module.ts');
const packed = join(site, 'kinegraph.wasm.zst'), unpacked = execFileSync('zstd', ['-dcq', packed], {maxBuffer: 1 << 28});
const answer = await openModule(await WebAssembly.compile(unpacked));
const text = readFileSync(join(site, 'examples/four_bar.json'), 'utf8'), crank = '"distance": 40';
if (!text.includes(crank)) throw new Error('the example has another crank');
const changes = 10_000, settled = 1_000;

/** @param {number} i */
function change(i) {
    const changed = text.replace(crank, `"distance": ${40 + (i % 997) / 500}`);
    const want = i % 100 === 0 ? ['position', 'results', 'sheet', 'sentences'] : ['position', 'mobility'];
    const {failure, faults, points} = JSON.parse(answer(JSON.stringify({text: changed, name: 'four_bar.json', want})));
    if (failure || faults.length > 0 || !points) throw new Error(failure ?? JSON.stringify(faults));
}
for (let i = 0; i < settled; ++i) change(i);
const before = answer.size();
for (let i = settled; i < changes; ++i) change(i);
console.log(
    `memory after ${settled} changes ${(before / 1e6).toFixed(1)} MB, ` +
        `after ${changes} ${(answer.size() / 1e6).toFixed(1)} MB`
);
if (answer.size() > before) throw new Error('memory grows');
