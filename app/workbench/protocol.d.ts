// The protocol of the workbench's engine (answer.hpp): what a page asks, and what it is answered. Both engines, the
// native program and the one in WebAssembly, answer the same bytes.

/** What to put into the answer. Faults and remarks are always there. */
export type Want =
    /** `length`, `points`, `directions`: where everything is. Also of a file with faults, as far as it is sound. */
    | 'position'
    /** `mobility`: freedoms counted; null where the file has faults, or has no joints. */
    | 'mobility'
    /** `results`: the document of `kinegraph solve --format json`. */
    | 'results'
    /** `values`: the named results in the file's units. */
    | 'values'
    /** `sentences`: the worked solution, in words. */
    | 'sentences'
    /** `names`: the figures that can be drawn alone. */
    | 'names'
    /** `sheet`, `question`, `answers`: pages as SVG, as `kinegraph solve -o OUT.svg` with `--sheet`. */
    | 'sheet' | 'question' | 'answers'
    /** `tex`: the sheet as LaTeX. */
    | 'tex'
    /** `cycle`: the rows of `kinegraph sweep -o OUT.csv`. */
    | 'cycle'
    /** `geogebra`: the construction in the archive that `kinegraph solve -o OUT.ggb` writes. */
    | 'geogebra'
    /** `live`: the live page, one HTML document with its own Content-Security-Policy. */
    | 'live'
    /** `imported`: the mechanism file of a link of PMKS+, which the text is; nothing else is answered then. */
    | 'import'
    /** `words`: the texts of the page in the language of the options, by key. */
    | 'words'
    /** `policy`: what a page that shows live pages in a frame must allow in its Content-Security-Policy. */
    | 'policy';

export interface Request {
    /** The text of the mechanism file; any text may be sent. '' where only words or the policy are wanted. */
    text: string;
    /** Its name without folders, for messages and title blocks. */
    name: string;
    want: Want[];
    /** Figures to draw alone, by name, as `--figure`; one that this mechanism does not have is left out. */
    figures?: string[];
    /** The options of `solve`, under the names of docs/batch.md ("lang", "theme", "paper", "set", "with" …). */
    options?: Record<string, unknown>;
}

export interface Fault {
    /** JSON pointer; '' is the whole file. */
    where: string;
    /** Counted from 1, in characters; absent where the fault has no place. */
    line?: number;
    column?: number;
    /** One line: what is wrong, then what to do. `fault` and `remedy` are its two parts, if it has two. */
    text: string;
    fault?: string;
    remedy?: string;
}

export interface Mobility {
    gruebler: number;
    effective: number;
    repeated: number;
    verdict: 'mechanism' | 'isostatic' | 'hyperstatic' | string;
}

export interface Value {
    name: string;
    /** In `unit`, which is the file's unit of this quantity; '' for a bare number. */
    value: number;
    unit: string;
}

export interface Answer {
    /** All faults of the file, in its order; none: it was solved as far as was wanted. */
    faults: Fault[];
    /** What was probably forgotten, or what is worth knowing. What to do is said by the page's tools, as in `why`. */
    remarks: string[];
    /** Results that are not determined, each with the reason. Empty unless something solved was wanted. */
    unsolved: {what: string; why: string}[];
    title: string;
    /** Absent where the text is no mechanism file at all. */
    counts?: {bodies: number; joints: number; drivers: number};
    /** The file's unit of length, and its size in metres. */
    length?: {unit: string; si: number};
    /** Coordinates in the file's unit of length. A point with a fault is absent. */
    points?: Record<string, [number, number]>;
    /**
     * Directions of joints (the guide, or the common tangent of a contact), loads and drivers that have one, by JSON
     * pointer ("/joints/3"), in radians from +x, counter-clockwise.
     */
    directions?: Record<string, number>;
    mobility?: Mobility | null;
    /** A document as text: its bytes are those of the program. */
    results?: string;
    values?: Value[];
    sentences?: string[];
    names?: string[];
    figures?: Record<string, string>;
    sheet?: string[];
    question?: string[];
    answers?: string[];
    tex?: string;
    cycle?: string;
    geogebra?: string;
    live?: string;
    /** Remarks say what was rounded, changed or left out. */
    imported?: string;
    words?: Record<string, string>;
    /** Sources by hash, "'sha256-…'", for script-src and style-src. */
    policy?: {script: string; style: string};
    /** A fault of ours: the request could not be answered. */
    failure?: string;
}
