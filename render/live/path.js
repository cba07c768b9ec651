// Paths and points on paper, mm: parsing, mapping, boxes. Knows no figure.

/** @typedef {import('./types.js').Spot} Spot */

/** @typedef {{letter: string, numbers: number[]}} Segment */

/**
 * @param {string} d
 * @returns {Segment[]}
 */
export function parsePath(d) {
    return (d.match(/[MLCAZ][^MLCAZ]*/g) ?? []).map((part) => ({
        letter: part[0],
        numbers: part.slice(1).split(/[ ,]+/).filter((each) => each !== '').map(Number),
    }));
}

/**
 * @param {Segment[]} segments
 * @param {(at: Spot) => Spot} map must be rigid if there are arcs
 */
export function mappedPath(segments, map) {
    const spot = (/** @type {number} */ x, /** @type {number} */ y) => {
        const at = map({x, y});
        return `${at.x.toFixed(4)} ${at.y.toFixed(4)}`;
    };
    return segments.map(({letter, numbers}) => {
        if (letter === 'A') return `A${numbers.slice(0, 5).join(' ')} ${spot(numbers[5], numbers[6])}`;
        const parts = [];
        for (let i = 0; i < numbers.length; i += 2) parts.push(spot(numbers[i], numbers[i + 1]));
        return letter + parts.join(' ');
    }).join('');
}

/**
 * The points of a path.
 * @param {Segment[]} segments
 * @returns {Spot[]}
 */
export function spotsOf(segments) {
    /** @type {Spot[]} */
    const spots = [];
    for (const {letter, numbers} of segments) {
        for (let i = letter === 'A' ? 5 : 0; i + 1 < numbers.length; i += 2)
            spots.push({x: numbers[i], y: numbers[i + 1]});
    }
    return spots;
}

/** @param {Spot[]} spots */
export function boxOf(spots) {
    const xs = spots.map((at) => at.x), ys = spots.map((at) => at.y);
    const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    return {left, right, top, bottom, centre: {x: (left + right) / 2, y: (top + bottom) / 2}};
}

/**
 * @param {Spot} a
 * @param {Spot} b
 * @returns {Spot}
 */
export function minus(a, b) {
    return {x: a.x - b.x, y: a.y - b.y};
}
/**
 * a + t·b.
 * @param {Spot} a
 * @param {number} t
 * @param {Spot} b
 * @returns {Spot}
 */
export function along(a, t, b) {
    return {x: a.x + t * b.x, y: a.y + t * b.y};
}
/**
 * @param {Spot} a
 * @param {Spot} b
 */
export function apart(a, b) {
    return Math.hypot(a.x - b.x, a.y - b.y);
}

/** Points nearer than this are the same, mm. */
export const samePlace = 0.02;
/** Shorter vectors are not drawn, mm. */
export const leastVector = 0.05;
/** Share of an arrow that its head may take, and its least width, mm, as in render/page/shapes.cpp. */
export const headShare = 0.6, leastHeadWidth = 0.35;
