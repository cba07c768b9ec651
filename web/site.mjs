// node web/site.mjs MODULE SITE: makes the folder of the static site: the workbench's page (web/src) with
// WebAssembly as its engine (web/site), the examples, and a list of all files for use without a network.
import {createHash} from 'node:crypto';
import {cpSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {openModule} from './site/module.js';

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

rmSync(site, {recursive: true, force: true});
mkdirSync(site, {recursive: true});
cpSync(join(top, 'web/src'), site, {recursive: true});
cpSync(join(top, 'web/site'), site, {recursive: true});
rmSync(join(site, 'served_engine.js'));
cpSync(module, join(site, 'kinegraph.wasm'));

// A frame with the live page inherits the policy of this one, so its script and style are named here.
const answer = await openModule(await WebAssembly.compile(readFileSync(module)));
const {policy} = JSON.parse(answer(JSON.stringify({text: '', name: '', want: ['policy']})));
writeFileSync(
    join(site, 'index.html'),
    replaced(readFileSync(join(site, 'index.html'), 'utf8'), {
        '{language}': 'en',
        'data-engine="served"': 'data-engine="worker"',
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

const files = below(site).filter((path) => path !== 'offline.js');
const hash = createHash('sha256');
for (const path of files) hash.update(path).update(readFileSync(join(site, path)));
writeFileSync(join(site, 'offline.js'), replaced(readFileSync(join(site, 'offline.js'), 'utf8'), {
    '{version}': hash.digest('hex').slice(0, 16),
    "['{files}']": JSON.stringify(['./', ...files.filter((path) => path !== 'index.html')]),
}));
