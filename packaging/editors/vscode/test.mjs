// node test.mjs PROGRAM: the extension without the editor. The manifest names what is there; each snippet, with its
// placeholders as they stand, makes a file that is in order and solves; the live page opens and ends.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import Module, { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const program = process.argv[2];
const folder = mkdtempSync(join(tmpdir(), "kinegraph-vscode-"));
process.on("exit", () => rmSync(folder, { recursive: true }));
const manifest = JSON.parse(readFileSync(join(here, "package.json"), "utf8"));

// --- manifest
const version = execFileSync(program, ["--version"], { encoding: "utf8" }).trim().split(" ")[1];
assert.equal(manifest.version, version, "the extension has the program's version");
const [validation] = manifest.contributes.jsonValidation;
assert.deepEqual(validation.fileMatch, ["*.kinegraph.json"], "as the MIME type of a desktop");
assert.equal(validation.url, "./mechanism.schema.json", "what pack puts there");
const pack = readFileSync(join(here, "pack"), "utf8");
assert.match(pack, /mechanism\.schema\.json/);
const commands = manifest.contributes.commands.map(each => each.command);
assert.ok(commands.length > 0);

// --- snippets: where each goes, and the rest of a file round it. All stand in the forms of the schema.
const base = {
  kinegraph: 1, units: { length: "mm" }, frame: 1,
  points: { O: [0, 0], A: [40, 30], B: [140, 0], C: [100, 0], D: [-10, 50] },
};
const crank = { "2": ["O", "A"] }, hinge = { revolute: "O", bodies: [1, 2] };
const drivers = [{ body: 2, omega: 6 }], effort = [{ couple: "M", body: 2 }];
const slide = { prismatic: "B", bodies: [4, 1], along: 0 };
const rod = { revolute: "A", bodies: [2, 3] }, wrist = { revolute: "B", bodies: [3, 4] };
const sliderCrank = { bodies: { ...crank, "3": ["A", "B"], "4": ["B"] }, joints: [hinge, rod, wrist, slide] };
const loaded = { bodies: crank, joints: [hinge], effort };
const points = { bodies: { "2": ["O", "A", "P"] }, joints: [hinge], drivers };
const lever = { bodies: { ...crank, "3": ["B", "C"] }, drivers };
const round = { O: [0, 0], C: [0, 25], P: [0, 0] };
const gears = { O: [0, 0], A: [0, 0], B: [90, 0], P: [30, 0] };
const without = (all, one) => all.filter(each => each !== one);
/** By prefix: the key under which it stands, and the file without it. */
const places = {
  "kg point": ["points", points],
  "kg body": ["bodies", { ...sliderCrank, bodies: { ...crank, "4": ["B"] }, drivers }],
  "kg joint revolute": ["joints", { ...sliderCrank, joints: without(sliderCrank.joints, rod), drivers }],
  "kg joint prismatic": ["joints", { ...sliderCrank, joints: without(sliderCrank.joints, slide), drivers }],
  "kg joint slot": ["joints", { ...lever, joints: [hinge, { revolute: "C", bodies: [1, 3] }] }],
  "kg joint arc": ["joints", { ...lever, joints: [hinge, { revolute: "C", bodies: [1, 3] }] }],
  "kg joint rolling": ["joints", { points: round, bodies: { "2": ["C"] }, joints: [], drivers }],
  "kg joint contact": ["joints", {
    points: { O: [0, 0], C: [10, 0], P: [10, 25] }, bodies: { "2": ["O", "C"], "3": ["P"] }, drivers,
    joints: [hinge, { prismatic: "P", bodies: [3, 1], along: 90, name: "guide" }],
  }],
  "kg joint gear": ["joints", {
    points: gears, bodies: { "2": ["A"], "3": ["B"] }, drivers,
    joints: [{ revolute: "A", bodies: [1, 2] }, { revolute: "B", bodies: [1, 3] }],
  }],
  "kg joint weld": ["joints", { bodies: { ...crank, "3": ["A", "B"] }, joints: [hinge], drivers }],
  "kg driver body": ["drivers", sliderCrank],
  "kg driver joint": ["drivers", sliderCrank],
  "kg driver point": ["drivers", sliderCrank],
  "kg mass": ["masses", { bodies: crank, joints: [hinge], drivers, effort, "inertia forces": true }],
  "kg load pin": ["loads", {
    bodies: { "2": ["O", "A"], "3": ["A", "B"] },
    joints: [hinge, rod, { revolute: "B", bodies: [1, 3] }],
  }],
  "kg load": ["loads", loaded],
  "kg effort actuator": ["effort", {
    ...sliderCrank, loads: [{ couple: "M1", body: 2, value: 10 }],
  }],
  "kg effort": ["effort", {
    bodies: crank, joints: [hinge], loads: [{ force: "P", body: 2, at: "A", value: [10, -100] }],
  }],
};

/** The text that stands there when no placeholder is changed; the first of several choices. */
function expanded(body) {
  const text = [body].flat().join("\n");
  return text.replace(/\$\{\d+:([^}]*)\}/g, "$1").replace(/\$\{\d+\|([^,|]*)[^|]*\|\}/g, "$1");
}

function run(name, file) {
  const path = join(folder, "snippet.kinegraph.json");
  writeFileSync(path, JSON.stringify(file));
  for (const command of ["check", "solve"]) {
    try {
      execFileSync(program, [command, path], { encoding: "utf8", stdio: "pipe" });
    } catch (error) {
      assert.fail(`${name}: ${command}: status ${error.status}: ${error.stderr}\n${JSON.stringify(file)}`);
    }
  }
}

for (const { path } of manifest.contributes.snippets) assert.equal(path, "./snippets/kinegraph.json");
const snippets = Object.entries(JSON.parse(readFileSync(join(here, "snippets/kinegraph.json"), "utf8")));
const used = new Set();
for (const [name, { prefix, body }] of snippets) {
  const text = expanded(body);
  assert.doesNotMatch(text, /\$/, `${name}: a placeholder is left`);
  if (prefix === "kg mechanism") {
    run(name, JSON.parse(text));
    continue;
  }
  const place = Object.keys(places).filter(each => prefix.startsWith(each)).sort((a, b) => b.length - a.length)[0];
  assert.ok(place, `${prefix} has a place`);
  used.add(place);
  const [key, rest] = places[place];
  const file = structuredClone({ ...base, ...rest });
  if (["points", "bodies", "masses"].includes(key)) {
    file[key] = { ...file[key], ...JSON.parse(`{${text}}`) };
  } else {
    file[key] = [...(file[key] ?? []), JSON.parse(text)];
  }
  run(name, file);
}
assert.ok(snippets.length > 25);
assert.deepEqual([...used].sort(), Object.keys(places).sort());

// --- the live page, with an editor of a few lines
const opened = [], errors = [], registered = new Map();
const file = join(folder, "crank.kinegraph.json");
writeFileSync(file, expanded(snippets[0][1].body));
const settings = { program, language: "de" };
const editor = {
  commands: { registerCommand: (name, call) => (registered.set(name, call), { dispose() {} }) },
  env: { openExternal: async address => opened.push(address) },
  Uri: { parse: text => text },
  window: {
    activeTextEditor: { document: { isUntitled: false, uri: { scheme: "file", fsPath: file } } },
    showErrorMessage: message => errors.push(message),
  },
  workspace: { getConfiguration: () => ({ get: key => settings[key] }) },
};
const load = Module._load;
Module._load = (name, ...more) => (name === "vscode" ? editor : load(name, ...more));
const extension = createRequire(import.meta.url)("./extension.js");
extension.activate({ subscriptions: [] });
assert.deepEqual([...registered.keys()].sort(), commands.sort());
await registered.get("kinegraph.preview")();
assert.deepEqual(errors, []);
const page = await fetch(opened[0]);
assert.equal(page.status, 200);
assert.match(await page.text(), /<html[^>]* lang="de"/);
extension.deactivate();
for (let tries = 0; tries < 100 && (await fetch(opened[0]).catch(() => null)); ++tries)
  await new Promise(resolve => setTimeout(resolve, 50));
await assert.rejects(fetch(opened[0]), "the program has ended");
settings.program = join(folder, "missing");
await registered.get("kinegraph.preview")();
assert.match(errors[0], /kinegraph\.program/);
console.log(`${snippets.length} snippets, the manifest and the live page are in order`);
