// node web/site.mjs MODULE SITE: makes the folder of the static site: the workbench's page (web/src) with
// WebAssembly as its engine (web/site), the examples, and a list of all files for use without a network.
import {execFileSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {cpSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {compiled} from './compiled.mjs';

const top = dirname(dirname(fileURLToPath(import.meta.url)));
const [module, site] = process.argv.slice(2);
if (!module || !site) throw new Error('usage: node web/site.mjs MODULE SITE');

/**
 * @param {string} text
 * @param {Record<string, string>} by what stands there, and what takes its place
 */
function replaced(text, by) {
    for (const [old, now] of Object.entries(by)) {
        if (!text.includes(old)) throw new Error(`"${old}" is missing`);
        text = text.replaceAll(old, now);
    }
    return text;
}
/** Files below a folder, by their paths within it. */
const below = (/** @type {string} */ folder) =>
    readdirSync(folder, {recursive: true, withFileTypes: true})
        .filter((each) => each.isFile())
        .map((each) => join(each.parentPath ?? each.path, each.name).slice(folder.length + 1))
        .sort();

/** Makes one script of a module and of all that it imports, for the browsers that docs/web.md names. */
const bundle = (/** @type {string} */ from, /** @type {string} */ to, /** @type {string[]} */ ...more) =>
    execFileSync('esbuild', [
        join(top, 'web', from), '--bundle', '--minify', '--format=iife', '--target=chrome95,firefox102,safari15.2',
        '--log-level=warning', `--outfile=${join(site, to)}`, ...more,
    ], {stdio: ['ignore', 'inherit', 'inherit']});

rmSync(site, {recursive: true, force: true});
mkdirSync(site, {recursive: true});
for (const folder of ['src', 'site'])
    for (const path of below(join(top, 'web', folder)))
        if (!path.endsWith('.ts')) cpSync(join(top, 'web', folder, path), join(site, path));
bundle('site/page.ts', 'main.js');
bundle('site/worker.ts', 'worker.js');
// Packed here and not left to the server: few compress as well, and some compress not at all.
execFileSync('zstd', ['-q', '-f', '--ultra', '-22', module, '-o', join(site, 'kinegraph.wasm.zst')]);

// A frame with the live page inherits the policy of this one, so its script and style are named here.
const {openModule} = await compiled('site/module.ts');
const answer = await openModule(await WebAssembly.compile(readFileSync(module)));
const {policy} = JSON.parse(answer(JSON.stringify({text: '', name: '', want: ['policy']})));
writeFileSync(
    join(site, 'index.html'),
    replaced(readFileSync(join(site, 'index.html'), 'utf8'), {
        '{language}': 'en',
        "script-src 'self' {script};": 
            `script-src 'self' 'wasm-unsafe-eval' ${policy.script}; worker-src 'self'; manifest-src 'self';`,
        '{style}': policy.style,
        '<link rel="stylesheet" href="style.css">':
            '<link rel="manifest" href="manifest.webmanifest">\n<link rel="stylesheet" href="style.css">'
    })
);

const examples = below(join(top, 'examples'))
    .filter((path) => /^([a-z_]+\/)?[a-z0-9_]+\.json$/.test(path))
    .map((path) => `examples/${path}`);
/** @type {{path: string, title: any}[]} */
const listed = [];
/** What only the program solves (docs/web.md): such a file is not offered. */
const isOfTheProgram = (/** @type {any} */ file) => file.cam || file.motion?.point;
for (const path of examples) {
    const text = readFileSync(join(top, path), 'utf8'), file = JSON.parse(text);
    if (!file.kinegraph || isOfTheProgram(file)) continue;
    mkdirSync(dirname(join(site, path)), {recursive: true});
    writeFileSync(join(site, path), text);
    listed.push({path, title: file.title ?? ''});
}
writeFileSync(join(site, 'examples.json'), JSON.stringify(listed));

const files = below(site);
const hash = createHash('sha256');
for (const path of files) hash.update(path).update(readFileSync(join(site, path)));
bundle('site/offline.ts', 'offline.js',
    `--define:siteVersion=${JSON.stringify(hash.digest('hex').slice(0, 16))}`,
    `--define:siteFiles=${JSON.stringify(['./', ...files.filter((path) => path !== 'index.html')])}`);
