// A small interpreter of what a .ggb file says, written from GeoGebra's manual: commands and expressions evaluated in
// their order, with points, vectors, lines and circles as floats. It shares nothing with the program.

/** The files of an archive whose members are stored, not compressed. */
export function unpacked(bytes) {
  const files = {};
  let at = 0;
  while (bytes.readUInt32LE(at) === 0x04034b50) {
    if (bytes.readUInt16LE(at + 8) !== 0) throw new Error("a compressed member");
    const size = bytes.readUInt32LE(at + 18), name = bytes.readUInt16LE(at + 26), extra = bytes.readUInt16LE(at + 28);
    const begin = at + 30 + name + extra;
    files[bytes.toString("utf8", at + 30, at + 30 + name)] = bytes.subarray(begin, begin + size);
    at = begin + size;
  }
  return files;
}

const entities = { "&lt;": "<", "&gt;": ">", "&quot;": '"', "&apos;": "'", "&amp;": "&" };
const plain = text => text.replace(/&(lt|gt|quot|apos|amp);/g, each => entities[each]).replace(/&#(x?)([0-9a-f]+);/gi,
  (_, hex, digits) => String.fromCodePoint(parseInt(digits, hex ? 16 : 10)));

/** [{name, attributes, children}], checked to be nested. */
function parsed(xml) {
  const root = { name: "", attributes: {}, children: [] }, open = [root];
  for (const [, end, name, rest, empty] of xml.matchAll(/<(\/?)([A-Za-z][A-Za-z0-9]*)((?:\s+[A-Za-z0-9]+="[^"]*")*)\s*(\/?)>/g)) {
    if (end) {
      if (open.pop().name !== name) throw new Error(`</${name}> closes another element`);
      continue;
    }
    const attributes = {};
    for (const [, key, value] of rest.matchAll(/([A-Za-z0-9]+)="([^"]*)"/g)) attributes[key] = plain(value);
    const element = { name, attributes, children: [] };
    open.at(-1).children.push(element);
    if (!empty) open.push(element);
  }
  if (open.length !== 1) throw new Error("an element is left open");
  return root;
}
const first = (element, name) => element.children.find(each => each.name === name);

/** The steps of a construction: {label, command, inputs} or {label, text}, with what is said of the look. */
export function construction(xml) {
  const all = first(first(parsed(xml), "geogebra"), "construction").children, steps = [];
  for (let i = 0; i < all.length; i += 2) {
    const [made, element] = [all[i], all[i + 1]];
    if (element.name !== "element") throw new Error("an object without a look");
    const step = { type: element.attributes.type, label: element.attributes.label,
      caption: first(element, "caption")?.attributes.val, shown: first(element, "show").attributes.object === "true",
      free: first(element, "coords") !== undefined, pauses: first(element, "breakpoint") !== undefined };
    if (made.name === "command") {
      step.command = made.attributes.name;
      step.inputs = Object.values(first(made, "input").attributes);
      if (first(made, "output").attributes.a0 !== step.label) throw new Error("another object's look");
    } else {
      step.text = made.attributes.exp;
      step.kind = made.attributes.type;
      if (made.attributes.label !== step.label) throw new Error("another object's look");
    }
    steps.push(step);
  }
  return steps;
}

const point = (x, y) => ({ kind: "point", x, y });
const vector = (x, y) => ({ kind: "vector", x, y });
const dot = (a, b) => a.x * b.x + a.y * b.y;
const cross = (a, b) => a.x * b.y - a.y * b.x;
const minus = (a, b) => vector(a.x - b.x, a.y - b.y);
const plus = (a, b, s = 1) => point(a.x + s * b.x, a.y + s * b.y);
const length = a => Math.hypot(a.x, a.y);

function met(a, b) {
  if (a.kind === "line" && b.kind === "line") {
    const w = cross(a.along, b.along);
    return [plus(a.through, a.along, cross(minus(b.through, a.through), b.along) / w)];
  }
  if (a.kind === "line") [a, b] = [b, a];
  if (b.kind === "line") {
    const along = dot(minus(a.centre, b.through), b.along) / dot(b.along, b.along);
    const foot = plus(b.through, b.along, along), off = length(minus(foot, a.centre));
    const half = Math.sqrt(Math.max(0, a.radius ** 2 - off ** 2)) / length(b.along);
    return [plus(foot, b.along, half), plus(foot, b.along, -half)];
  }
  const between = minus(b.centre, a.centre), distance = length(between);
  const along = (a.radius ** 2 - b.radius ** 2 + distance ** 2) / (2 * distance);
  const half = Math.sqrt(Math.max(0, a.radius ** 2 - along ** 2));
  const foot = plus(a.centre, between, along / distance), across = vector(-between.y, between.x);
  return [plus(foot, across, half / distance), plus(foot, across, -half / distance)];
}

/** Intersections of circles come in either order: GeoGebra's own is not relied on. */
const commands = flips => ({
  Line: (p, q) => ({ kind: "line", through: p, along: q.kind === "vector" ? q : minus(q, p) }),
  Circle: (centre, radius) => ({ kind: "circle", centre, radius }),
  Vector: (p, q) => minus(q, p),
  UnitVector: v => vector(v.x / length(v), v.y / length(v)),
  PerpendicularVector: v => vector(-v.y, v.x),
  Intersect: (a, b, which = 1) => {
    const all = met(a, b);
    return all[all.length === 1 ? 0 : (which - 1) ^ (flips ? 1 : 0)];
  },
  Segment: (p, q) => ({ kind: "segment", p, q }),
  Polygon: (...corners) => ({ kind: "polygon", corners }),
});
const functions = {
  x: v => v.x, y: v => v.y, cos: Math.cos, sin: Math.sin,
  Distance: (p, q) => length(minus(p, q)), If: (condition, one, other) => (condition ? one : other),
};

function sum(a, b, sign) {
  if (typeof a === "number") return a + sign * b;
  const kind = a.kind === "point" && b.kind === "point" && sign < 0 ? "vector"
    : a.kind === "point" || b.kind === "point" ? "point" : "vector";
  return { kind, x: a.x + sign * b.x, y: a.y + sign * b.y };
}
function product(a, b) {
  if (typeof a === "number" && typeof b === "number") return a * b;
  if (typeof a === "number") return { kind: b.kind, x: a * b.x, y: a * b.y };
  return typeof b === "number" ? product(b, a) : dot(a, b);
}

/** A recursive descent over one expression. */
function evaluated(text, values, call) {
  const tokens = text.match(/\d+(?:\.\d+)?(?:E[-+]?\d+)?|[\p{L}][\p{L}\d]*(?:_\{[^}]*\})?|[-+*/(),<>]/gu) ?? [];
  if (tokens.join("") !== text.replace(/\s/g, "")) throw new Error(`cannot be read: ${text}`);
  let at = 0;
  const eat = token => tokens[at] === token && ++at > 0;
  const need = token => {
    if (!eat(token)) throw new Error(`${token} is missing in ${text}`);
  };
  const list = () => {
    const all = [comparison()];
    while (eat(",")) all.push(comparison());
    need(")");
    return all;
  };
  function atom() {
    if (eat("-")) return product(-1, atom());
    if (eat("(")) {
      const all = list();
      return all.length === 1 ? all[0] : point(...all);
    }
    const token = tokens[at++];
    if (/^\d/.test(token)) return Number(token);
    if (eat("(")) return call(token, list());
    if (!(token in values)) throw new Error(`${token} is not defined before ${text}`);
    return values[token];
  }
  function term() {
    let value = atom();
    for (;;) {
      if (eat("*")) value = product(value, atom());
      else if (eat("/")) value = product(value, 1 / atom());
      else return value;
    }
  }
  function expression() {
    let value = term();
    for (;;) {
      if (eat("+")) value = sum(value, term(), 1);
      else if (eat("-")) value = sum(value, term(), -1);
      else return value;
    }
  }
  function comparison() {
    const value = expression();
    if (eat("<")) return value < expression();
    return eat(">") ? value > expression() : value;
  }
  const value = comparison();
  if (at !== tokens.length) throw new Error(`more than an expression: ${text}`);
  return value;
}

/** The value of each label. `moved`: free points at other places, by label. */
export function evaluate(steps, moved = {}, flips = false) {
  const values = Object.create(null), known = commands(flips);
  const call = (name, inputs) => {
    const own = known[name] ?? functions[name];
    if (!own) throw new Error(`no command is called ${name}`);
    return own(...inputs);
  };
  for (const step of steps) {
    if (step.label in values) throw new Error(`${step.label} is defined twice`);
    if (step.type === "text") continue;
    let value = step.command ? known[step.command](...step.inputs.map(each => evaluated(each, values, call)))
      : evaluated(step.text, values, call);
    if (step.kind) value = { ...value, kind: step.kind };
    if (step.label in moved) value = point(...moved[step.label]);
    const kind = { numeric: "number", conic: "circle" }[step.type] ?? step.type;
    const is = typeof value === "number" ? "number" : value?.kind;
    if (is !== kind) throw new Error(`${step.label} is a ${is}, not a ${kind}`);
    if (/^\p{Lu}/u.test(step.label) !== (kind === "point")) throw new Error(`${step.label} is no label of a ${kind}`);
    values[step.label] = value;
  }
  return values;
}
