// The lines of a polygon that a student draws, and what is wrong with a line. Lengths in mm on paper. Knows no page.

import {dot, quarterTurn, unitOf} from './closure.js';
import {scaledBy} from './given.js';
import {apart, minus, samePlace} from './path.js';
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./types.js').Spot} Spot */

/**
 * @typedef {{statement: number, kind: 'vector' | 'line', name: string, from: Spot, by: Spot, ends: Spot[], line:
 * string}} Task
 * name: of the vector drawn, or of the vector on the line; by: the vector, or the line's direction; ends: vertices on
 * it; line: its name in the record, if it has one
 * @typedef {{kind: '' | 'not_through' | 'not_along' | 'wrong_sense' | 'too_long' | 'too_short', by: number}} Fault
 * by: degrees, mm
 */

/** On paper a line is as good as a sharp pencil: half a millimetre, at every vertex that it leads to. */
export const pencil = 0.5;
/** A shorter line says nothing about a direction, mm. */
const leastLineDrawn = 1;

/**
 * The lines of a polygon in drawing order: known vectors, and the lines on which the others lie.
 * @param {FigureView} view
 * @param {(statement: number) => Set<string>} unknownIn names of the vectors of unknown magnitude in a statement
 * @returns {Task[]}
 */
export function tasksOf(view, unknownIn) {
    /** @type {Spot[]} */
    const known = [];
    const isSame = (/** @type {Spot} */ a) => (/** @type {Spot} */ b) => apart(a, b) < samePlace;
    const isKnown = (/** @type {Spot} */ at) => known.some(isSame(at));
    const {vectors, lines} = drawnIn(view);
    known.push(...vectors.filter(({statement}) => statement < 0).flatMap(({ends}) => ends));
    const statements = [...new Set([...vectors, ...lines].map(({statement}) => statement))].filter((each) => each >= 0);
    /** @type {Task[]} */
    const tasks = [];
    for (const statement of statements.sort((a, b) => a - b)) {
        const ofIt = vectors.filter((each) => each.statement === statement),
            on = lines.filter((each) => each.statement === statement);
        const unknown = unknownIn(statement);
        const isMet = (/** @type {Spot} */ at) => on.some(({points}) => points.slice(1).some(isSame(at)));
        for (const {name, ends: [tail, tip]} of ofIt) {
            if (isMet(tail) || isMet(tip) || unknown.has(name) || (isKnown(tail) && isKnown(tip))) continue;
            tasks.push({statement, kind: 'vector', name, from: tail, by: minus(tip, tail), ends: [tail, tip],
                line: ''});
            known.push(tail, tip);
        }
        for (const {name: line, points, direction} of on) {
            const from = points.find(isKnown);
            if (!from || (points.length > 1 && points.every(isKnown))) continue;
            const lying = ofIt.find(({ends}) =>
                ends.every((at) => Math.abs(dot(minus(at, from), quarterTurn(direction))) < samePlace),
            );
            const ends = [from, ...points, ...lying?.ends ?? []];
            tasks.push({statement, kind: 'line', name: lying?.name ?? '', from, by: direction, ends, line});
        }
        // Of a force only the line of action is known: it is drawn through the end that is known.
        for (const {name, ends} of ofIt) {
            const from = ends.find(isKnown);
            if (!unknown.has(name) || on.length > 0 || !from || ends.every(isKnown)) continue;
            tasks.push({statement, kind: 'line', name, from, by: unitOf(minus(ends[1], ends[0])), ends, line: ''});
        }
        known.push(...on.flatMap(({points}) => points), ...ofIt.flatMap(({ends}) => ends));
    }
    return tasks;
}

/**
 * Vectors and lines of a polygon on paper; statement −1: given.
 * @param {FigureView} view
 */
function drawnIn(view) {
    const vectors = [...view.group.querySelectorAll(':scope > g.vector')].flatMap((node) => {
        const name = node.getAttribute('data-name') ?? '',
            ends = view.vector(name);
        return ends && apart(...ends) > leastLineDrawn
            ? [{statement: Number(node.getAttribute('data-statement') ?? -1), name, ends}]
            : [];
    });
    const lines = view.motion.data.plans[0].lines
        .filter(([figure]) => figure === view.id)
        .flatMap(([, name, statement]) => {
            const line = view.line(name);
            return line ? [{name, statement, points: line.points, direction: line.direction}] : [];
        });
    return {vectors, lines};
}

/**
 * The tasks that lead to the point in which a task begins; empty: the point is there from the beginning.
 * @param {Task} task
 * @param {Task[]} tasks
 */
export function leadingTo(task, tasks) {
    const before = tasks.slice(0, tasks.indexOf(task)).filter(({statement, kind}) => kind === 'vector' ||
        statement < task.statement);
    const makes = before.filter(({ends, from}) => apart(from, task.from) > samePlace && ends.some((at) => apart(at,
        task.from) < samePlace));
    // A point is known by the first that leads to it; where lines meet, by all of them.
    const [first] = makes;
    return first ? makes.filter(({statement, kind}) => statement === first.statement && kind === first.kind) : [];
}

/**
 * The fault of a line from one point to another.
 * @param {Task} task
 * @param {Spot} from
 * @param {Spot} to
 * @returns {Fault}
 */
export function faultOf(task, from, to) {
    const by = minus(to, from), size = apart(from, to), wanted = Math.hypot(task.by.x, task.by.y);
    const good = scaledBy(1 / wanted, task.by), fault = (/** @type {Fault['kind']} */ kind, off = 0) => ({kind,
        by: off});
    if (size < leastLineDrawn) return fault('too_short', Math.max(wanted - size, leastLineDrawn));
    const own = scaledBy(1 / size, by);
    const angle = Math.abs(Math.atan2(dot(own, quarterTurn(good)), dot(own, good))) * 180 / Math.PI,
        off = Math.min(angle, 180 - angle);
    if (task.kind === 'line') {
        // Any line that passes through the vertices is this line, wherever it begins.
        const distance = (/** @type {Spot} */ at) => Math.abs(dot(minus(at, from), quarterTurn(own)));
        if (Math.max(...task.ends.map(distance)) <= pencil) return fault('');
        const span = Math.max(10, ...task.ends.map((at) => apart(at, task.from)));
        return span * Math.sin(off * Math.PI / 180) > pencil ? fault('not_along', off) : fault('not_through');
    }
    const isOpposite = apart(from, task.ends[1]) <= pencil && apart(to, task.ends[0]) <= pencil;
    if (isOpposite) return fault('wrong_sense');
    if (apart(from, task.from) > pencil) return fault('not_through');
    if (Math.min(size, wanted) * Math.sin(off * Math.PI / 180) > pencil) return fault('not_along', off);
    if (dot(by, task.by) < 0) return fault('wrong_sense');
    if (Math.abs(size - wanted) <= pencil) return fault('');
    return fault(size > wanted ? 'too_long' : 'too_short', Math.abs(size - wanted));
}
