// JSON as text: where each value stands, and edits that change nothing else of the text.

export interface Node {
    kind: 'object' | 'array' | 'string' | 'number' | 'word';
    start: number;
    end: number;
    members: Member[];
    items: Node[];
    value: Json;
}
export interface Member {
    key: string;
    start: number;
    keyEnd: number;
    value: Node;
}
/**
 * A value of the user's file, which may be any JSON: it is read by what it has, never trusted. `unknown` would ask for
 * a test at each step of a path that the engine has already judged.
 */
// eslint-disable-next-line @typescript-eslint/no-explicit-any
export type Json = any;
export type Path = (string | number)[];

const deepest = 64, longestNumber = 2048;

/** A text that is no JSON; `at`: the offset of the fault. */
export class NotJson extends Error {
    constructor(readonly at: number) {
        super('no JSON');
    }
}

/** Reads a text once, from its beginning to its end. */
class Reader {
    at: number;

    constructor(readonly text: string) {
        this.at = text.startsWith('\uFEFF') ? 1 : 0;
    }
    whole(): Node {
        const value = this.value(0);
        this.skip();
        if (this.at < this.text.length) throw new NotJson(this.at);
        return value;
    }
    skip() {
        while (' \t\r\n'.includes(this.text[this.at]) && this.at < this.text.length) ++this.at;
    }
    takes(sign: string) {
        this.skip();
        if (this.text[this.at] !== sign) return false;
        ++this.at;
        return true;
    }
    expect(sign: string) {
        if (!this.takes(sign)) throw new NotJson(this.at);
    }
    /** To the end of a string; what stands in it JSON.parse checks. */
    skipString() {
        const {text} = this;
        for (++this.at; this.at < text.length && text[this.at] !== '"'; ++this.at)
            if (text[this.at] === '\\') ++this.at;
        ++this.at;
    }
    value(depth: number): Node {
        if (depth > deepest) throw new NotJson(this.at);
        this.skip();
        const sign = this.text[this.at];
        if (sign === '{') return this.object(depth);
        if (sign === '[') return this.array(depth);
        const start = this.at;
        if (sign === '"') this.skipString();
        else
            this.at +=
                /^(?:-?\d[\d.eE+-]*|true|false|null)/.exec(this.text.slice(start, start + longestNumber))?.[0].length ??
                0;
        const kind = sign === '"' ? 'string' : /[-\d]/.test(sign) ? 'number' : 'word';
        try {
            return {
                kind,
                start,
                end: this.at,
                members: [],
                items: [],
                value: JSON.parse(this.text.slice(start, this.at))
            };
        } catch {
            throw new NotJson(start);
        }
    }
    object(depth: number): Node {
        const node: Node = {kind: 'object', start: this.at++, end: 0, members: [], items: [], value: null};
        if (!this.takes('}')) {
            do {
                this.skip();
                if (this.text[this.at] !== '"') throw new NotJson(this.at);
                const key = this.value(depth + 1);
                this.expect(':');
                node.members.push({key: key.value, start: key.start, keyEnd: key.end, value: this.value(depth + 1)});
            } while (this.takes(','));
            this.expect('}');
        }
        node.end = this.at;
        return node;
    }
    array(depth: number): Node {
        const node: Node = {kind: 'array', start: this.at++, end: 0, members: [], items: [], value: null};
        if (!this.takes(']')) {
            do {
                node.items.push(this.value(depth + 1));
            } while (this.takes(','));
            this.expect(']');
        }
        node.end = this.at;
        return node;
    }
}

/** The value of a node as JavaScript has it. */
export function plain(node: Node | undefined): Json {
    if (!node) return undefined;
    if (node.kind === 'array') return node.items.map(plain);
    if (node.kind !== 'object') return node.value;
    return Object.fromEntries(node.members.map(({key, value}) => [key, plain(value)]));
}

/** A value on one line, as files are written by hand: {"from": "A", "distance": 40}. */
export function written(value: Json): string {
    if (value instanceof Literal) return value.text;
    if (Array.isArray(value)) return `[${value.map(written).join(', ')}]`;
    if (value === null || typeof value !== 'object') return JSON.stringify(value);
    return `{${Object.entries(value).map(([key, each]) => `${JSON.stringify(key)}: ${written(each)}`).join(', ')}}`;
}

/** A value that keeps its digits: the text of a number, as typed or as the file has it. */
export class Literal {
    constructor(readonly text: string) {}
}

/** A text that is JSON, and edits of it. It does not change: each edit makes another. */
export class JsonText {
    readonly root: Node;

    constructor(readonly text: string) {
        this.root = new Reader(text).whole();
    }
    at(path: Path): Node | undefined {
        let node: Node | undefined = this.root;
        for (const step of path) {
            node = typeof step === 'number' ? node.items[step] : node.members.find((each) => each.key === step)?.value;
            if (!node) return undefined;
        }
        return node;
    }
    plainAt(path: Path) {
        return plain(this.at(path));
    }
    /** The text of a value, with its digits. */
    rawAt(path: Path) {
        const node = this.at(path);
        return node ? this.text.slice(node.start, node.end) : undefined;
    }
    spliced(start: number, end: number, by: string) {
        return new JsonText(this.text.slice(0, start) + by + this.text.slice(end));
    }
    /** Sets what the path leads to; what is missing on the way is added. */
    set(path: Path, value: Json): JsonText {
        const node = this.at(path);
        if (node) {
            const by = written(value);
            return this.text.slice(node.start, node.end) === by ? this : this.spliced(node.start, node.end, by);
        }
        const last = path[path.length - 1], parents = path.slice(0, -1);
        const parent = this.at(parents);
        if (parent) return typeof last === 'number' ? this.add(parents, value) : this.insert(parents, last, value);
        return this.set(parents, typeof last === 'number' ? [] : {}).set(path, value);
    }
    /** Adds a member at the end of an object. */
    insert(path: Path, key: string, value: Json) {
        return this.append(path, `${JSON.stringify(key)}: ${written(value)}`);
    }
    /** Adds an element at the end of an array. */
    add(path: Path, value: Json) {
        return this.append(path, written(value));
    }
    append(path: Path, text: string) {
        const node = this.at(path) as Node;
        const last = node.kind === 'object' ? node.members[node.members.length - 1] : node.items[node.items.length - 1];
        const indent = this.indentOf(node.start), open = node.start + 1;
        if (!last) {
            const by = path.length > 1 ? text : `\n${indent}  ${text}\n${indent}`;
            return this.spliced(open, node.end - 1, by);
        }
        const end = 'value' in last && 'key' in last ? last.value.end : last.end;
        const isTall = this.text.slice(node.start, last.start).includes('\n');
        const lineStart = this.text.lastIndexOf('\n', end) + 1;
        if (isTall) return this.spliced(end, end, `,\n${this.indentOf(last.start)}${text}`);
        const fits = end - lineStart + text.length < 110;
        return this.spliced(end, end, fits ? `, ${text}` : `,\n${indent}  ${text}`);
    }
    /** The blanks at the beginning of a line. */
    indentOf(at: number) {
        const start = this.text.lastIndexOf('\n', at - 1) + 1;
        return /^[ \t]*/.exec(this.text.slice(start))?.[0] ?? '';
    }
    /** Removes a member or an element, with its comma. */
    remove(path: Path) {
        const parent = this.at(path.slice(0, -1)), last = path[path.length - 1];
        if (!parent) return this;
        const all: {start: number, end: number}[] = parent.kind === 'array' ? parent.items :
            parent.members.map(({start, value}) => ({start, end: value.end}));
        const index = parent.kind === 'array' ? Number(last) : parent.members.findIndex(({key}) => key === last);
        if (index < 0 || index >= all.length) return this;
        if (all.length === 1) return this.spliced(parent.start + 1, parent.end - 1, '');
        if (index + 1 < all.length) return this.spliced(all[index].start, all[index + 1].start, '');
        return this.spliced(all[index - 1].end, all[index].end, '');
    }
    /** Gives a member another key. */
    rename(path: Path, key: string) {
        const member = this.at(path.slice(0, -1))?.members.find((each) => each.key === path[path.length - 1]);
        return member ? this.spliced(member.start, member.keyEnd, JSON.stringify(key)) : this;
    }
}

/** The path of a JSON pointer in a text. */
export function pathOf(json: JsonText, pointer: string): Path {
    const path: Path = [];
    for (const step of pointer.split('/').slice(1)) {
        const key = step.replaceAll('~1', '/').replaceAll('~0', '~');
        path.push(json.at(path)?.kind === 'array' ? Number(key) : key);
    }
    return path;
}
