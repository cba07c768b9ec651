// node geogebra_test.mjs PROGRAM EXAMPLES: the constructions for GeoGebra of all examples, evaluated by an interpreter
// of their own, give the program's results; with a point dragged, those of the file with that point moved.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { construction, evaluate, unpacked } from "./interpreter.mjs";

const [program, examples] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "kinegraph-geogebra-"));
process.on("exit", () => rmSync(folder, { recursive: true }));

/** The construction and the results of a file; null where it is refused, with the message in `refusals`. */
const refusals = [];
function solved(path, name) {
  const [ggb, json] = ["ggb", "json"].map(ending => join(folder, `out.${ending}`));
  const run = spawnSync(program, ["solve", path, "-o", ggb, "-o", json], { encoding: "utf8" });
  if (run.status !== 0 && run.status !== 3) {
    refusals.push(`${name}: ${run.stderr}`);
    return null;
  }
  const files = unpacked(readFileSync(ggb));
  assert.deepEqual(Object.keys(files), ["geogebra.xml"]);
  const steps = construction(files["geogebra.xml"].toString("utf8"));
  return { steps, results: JSON.parse(readFileSync(json, "utf8")) };
}

const close = (found, wanted, size) => Math.abs(found - wanted) <= 1e-7 * Math.max(size, Math.abs(wanted));
const letters = name => name.replace(/[^A-Za-z0-9]/g, "");

/** How many of the program's results the values have; every difference fails. */
function compared({ steps, results }, values, name) {
  let count = 0;
  const same = (what, found, wanted, size) => {
    assert.ok(close(found, wanted, size), `${name}: ${what}: ${found}, not ${wanted}`);
    ++count;
  };
  const sizes = { v: 0, a: 0 };
  for (const { velocity, acceleration } of Object.values(results.points ?? {})) {
    sizes.v = Math.max(sizes.v, Math.hypot(...(velocity ?? [0])));
    sizes.a = Math.max(sizes.a, Math.hypot(...(acceleration ?? [0])));
  }
  const span = Math.max(...Object.values(results.points).flatMap(each => each.at.map(Math.abs)), 1e-9);
  for (const step of steps) {
    const value = values[step.label], centre = /^P_\{(.+)\}$/.exec(step.caption ?? "");
    const part = /^([va])_\{(.+)\}$/.exec(step.caption ?? "");
    if (step.type === "point" && step.caption in results.points) {
      const { at } = results.points[step.caption];
      same(step.caption, value.x, at[0], span);
      same(step.caption, value.y, at[1], span);
    } else if (step.type === "point" && centre) {
      const [, { at }] = Object.entries(results["instant centres"]).find(([key]) => key.replace(",", "") === centre[1]);
      same(step.caption, value.x, at[0], span);
      same(step.caption, value.y, at[1], span);
    } else if (step.type === "vector" && part && part[2] in results.points) {
      const wanted = results.points[part[2]][part[1] === "v" ? "velocity" : "acceleration"];
      const scale = values[`scale_{${part[1]}}`];
      if (!wanted) continue;
      same(step.caption, value.x / scale, wanted[0], sizes[part[1]]);
      same(step.caption, value.y / scale, wanted[1], sizes[part[1]]);
    }
  }
  for (const [body, { omega, alpha }] of Object.entries(results.bodies ?? {})) {
    for (const [letter, wanted, size] of [["ω", omega, sizes.v / span], ["α", alpha, sizes.a / span]]) {
      const value = values[`${letter}_{${letters(body)}}`];
      if (value !== undefined && wanted !== undefined && wanted !== null)
        same(`${letter} ${body}`, value, wanted, size);
    }
  }
  return count;
}

/** What does not depend on numbers: labels, commands, inputs. */
const frameOf = steps => JSON.stringify(steps.filter(each => each.type !== "text")
  .map(each => [each.label, each.command, each.inputs, each.kind && !each.free ? each.text?.replace(/[\d.E-]+/g, "") : ""]));

let exported = 0, values = 0, dragged = 0, others = 0;
for (const file of readdirSync(examples).filter(each => each.endsWith(".json")).sort()) {
  const path = join(examples, file), found = solved(path, file);
  if (!found) continue;
  ++exported;
  const count = compared(found, evaluate(found.steps), file);
  assert.ok(count >= 2, `${file}: ${count} values are compared`);
  assert.equal(compared(found, evaluate(found.steps, {}, true), file), count, "in whichever order circles meet");
  values += count;
  assert.ok(found.steps.some(each => each.pauses) && found.steps.some(each => each.shown));

  // Drag the first two points that the file gives by numbers.
  const text = JSON.parse(readFileSync(path, "utf8"));
  const size = Math.max(...Object.values(found.results.points).flatMap(each => each.at.map(Math.abs)));
  const free = Object.entries(text.points).filter(([, form]) => Array.isArray(form) && form.every(Number.isFinite));
  for (const [name] of free.slice(0, 2)) {
    const step = found.steps.find(each => each.free && each.caption === name);
    assert.ok(step, `${file}: ${name} can be dragged`);
    const { at } = found.results.points[name];
    const place = [at[0] + 0.0137 * size, at[1] - 0.0071 * size];
    const moved = structuredClone(text);
    moved.points[name] = place.map(each => `${each} m`);
    const other = join(folder, "moved.json");
    writeFileSync(other, JSON.stringify(moved));
    const after = solved(other, `${file} with ${name} moved`);
    if (!after) continue;
    if (frameOf(after.steps) !== frameOf(found.steps)) {
      ++others;  // the moved mechanism has another record: GeoGebra's stays as it was
      continue;
    }
    compared({ steps: found.steps, results: after.results }, evaluate(found.steps, { [step.label]: place }),
      `${file} with ${name} dragged`);
    ++dragged;
  }
}
console.log(`${exported} examples, ${values} values; ${dragged} points dragged, ${others} with another record`);
for (const each of refusals) console.log(each.trim().split("\n").at(-1));
assert.ok(exported > 60 && values > 1500 && dragged > 40 && dragged > 2 * others);
