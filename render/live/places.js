// Where figures stand: columns and rows of equal figures, or the first at full height beside the others, whichever
// shows them largest.

import {total} from './room.js';

/**
 * @typedef {{width: number, height: number, caption: number, isMain: boolean}} Shape of a figure, mm; its caption, px
 * @typedef {{wide: number[], tall: number[], at: [number, number, number][]}} Places
 * wide, tall: shares of columns and rows; at: of each figure the row, the column, and how many rows it takes
 */

/** Shares of the width that the first figure may have beside the others. */
const shares = [0.35, 0.45, 0.55];

const ones = (/** @type {number} */ count) => /** @type {number[]} */ (Array(count).fill(1));

/**
 * Columns and rows.
 * @param {Shape[]} shapes
 * @param {number} columns
 * @returns {Places}
 */
function inColumns(shapes, columns) {
    const rows = Math.ceil(shapes.length / columns);
    // Beside another the figure that shows the step is the larger.
    const inOne = (/** @type {(shape: Shape) => number} */ part) => shapes.map((shape) =>
        Math.min(Math.max(part(shape), 0.5), 2.5) * (shapes.length > 1 && shape.isMain ? 1.5 : 1));
    return {
        wide: rows > 1 ? ones(columns) : inOne(({width, height}) => width / height),
        tall: columns > 1 ? ones(rows) : inOne(({width, height}) => height / width),
        at: shapes.map((_, i) => [Math.floor(i / columns), i % columns, 1]),
    };
}
/**
 * The first beside the others, which stand in columns and rows.
 * @param {Shape[]} shapes
 * @param {number} columns of the others
 * @param {number} share of the first
 * @returns {Places}
 */
function besideOthers(shapes, columns, share) {
    const rows = Math.ceil((shapes.length - 1) / columns);
    return {
        wide: [share, ...ones(columns).map(() => (1 - share) / columns)],
        tall: ones(rows),
        at: shapes.map((_, i) => i === 0 ? [0, 0, rows] : [Math.floor((i - 1) / columns), 1 + (i - 1) % columns, 1]),
    };
}

/**
 * How large figures are in their places: the mean of the logarithms of their scales, as a sum.
 * @param {Shape[]} shapes
 * @param {Places} places
 * @param {number} width
 * @param {number} height
 * @param {number} least height of a figure
 */
function sizeIn(shapes, {wide, tall, at}, width, height, least) {
    const [across, down] = [width / total(wide), height / total(tall)];
    return total(shapes.map((shape, i) => {
        const [row, column, rows] = at[i], room = down * total(tall.slice(row, row + rows)) - shape.caption;
        return Math.log(Math.min(across * wide[column] / shape.width, Math.max(room, least, 1) / shape.height));
    }));
}

/**
 * The places in which figures of these shapes are largest.
 * @param {Shape[]} shapes
 * @param {number} width
 * @param {number} height
 * @param {number} least height of a figure
 * @param {boolean} hasFirst whether the first may be larger than the others
 * @returns {Places}
 */
export function mostRoomy(shapes, width, height, least, hasFirst) {
    const all = shapes.map((_, i) => inColumns(shapes, i + 1));
    if (hasFirst && shapes.length > 2)
        for (const share of shares)
            for (let columns = 1; columns < shapes.length; ++columns) all.push(besideOthers(shapes, columns, share));
    const sizes = all.map((each) => sizeIn(shapes, each, width, height, least));
    return all[sizes.indexOf(Math.max(...sizes))];
}
