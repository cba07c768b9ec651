// Places arrows, labels and polygons without overlaps while the mechanism is away from the drawn position. The sheet
// does this once (render/figures/polygon_parts.cpp, render/page/labels.cpp); here it is done for each position. Returns
// places; owns no marks.
// Last, where figures stand on the screen: in columns and rows of equal ones, or the first at full height beside the
// others, whichever shows them largest.

import {dot, quarterTurn, unitOf} from './closure.js';
import {scaledBy} from './given.js';
import {apart, boxOf, minus} from './path.js';
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./types.js').Spot} Spot */

/** As in polygon_parts.cpp, mm. */
const lanePitch = 2.2, sameLane = 0.4, sharedLength = 1, oneVector = 0.05;

/**
 * The coordinates of a place along a vector and perpendicular to it.
 * @param {Spot} tail
 * @param {Spot} tip
 * @returns {(at: Spot) => {t: number, n: number}}
 */
export function localOf(tail, tip) {
    const e = unitOf(minus(tip, tail)), n = quarterTurn(e);
    return (at) => ({t: dot(minus(at, tail), e), n: dot(minus(at, tail), n)});
}

/**
 * Whether two vectors overlap on one line so far that one would hide the other.
 * @param {[Spot, Spot]} a
 * @param {[Spot, Spot]} b
 */
function hideEachOther(a, b) {
    const length = apart(...a);
    if (length < sharedLength || apart(...b) < sharedLength) return false;
    const [from, to] = b.map(localOf(...a));
    if (Math.abs(from.n) > sameLane || Math.abs(to.n) > sameLane) return false;
    return Math.min(length, Math.max(from.t, to.t)) - Math.max(0, Math.min(from.t, to.t)) > sharedLength;
}

/**
 * Vectors that would cover each other are drawn side by side, all others in their places.
 * @param {FigureView} view
 */
export function setSideBySide(view) {
    /** @type {{ends: [Spot, Spot], number: number, normal: Spot}[]} */
    const lanes = [];
    const all = view.strokes.map((name) => ({name, ends: view.vector(name)}));
    view.asides.clear();
    for (const {name, ends} of all) {
        if (!ends || apart(...ends) < sharedLength) continue;
        const near = lanes.filter((lane) => hideEachOther(lane.ends, ends));
        const same = near.find((lane) => lane.ends.every((end, i) => apart(end, ends[i]) < oneVector));
        let number = same?.number ?? 0;
        for (let n = 1; !same && near.some((lane) => lane.number === number); ++n)
            number = n % 2 === 1 ? (n + 1) / 2 : -n / 2;
        // The first offset is away from the rest of the polygon.
        const beside = total(all.flatMap((each) => each.ends ?? []).map((at) => localOf(...ends)(at).n));
        const normal = near[0]?.normal ?? scaledBy(beside > 0 ? -1 : 1, quarterTurn(unitOf(minus(ends[1], ends[0]))));
        lanes.push({ends, number, normal});
        if (number !== 0) view.asides.set(name, scaledBy(lanePitch * number, normal));
    }
}
/** @param {number[]} all */
export function total(all) {
    return all.reduce((sum, each) => sum + each, 0);
}

/** The boxes of placed labels, and the strokes that labels avoid. */
export class Crowd {
    constructor() {
        /** @type {{left: number, right: number, top: number, bottom: number}[]} */
        this.boxes = [];
        /** @type {Spot[][]} */
        this.strokes = [];
        /**
         * Of labels in drawings on which this one lies.
         * @type {{left: number, right: number, top: number, bottom: number}[]}
         */
        this.others = [];
    }
    /** @param {Spot[][]} strokes */
    clear(strokes) {
        this.boxes = [...this.others];
        this.strokes = strokes.filter((ends) => ends.length === 2);
    }
    /**
     * The first free place for the middle of a label, or else the one that hides least. The place is then occupied.
     * @param {Spot[]} places in order of preference
     * @param {{width: number, height: number}} size
     */
    best(places, {width, height}) {
        let best = null, place = places[0], least = Infinity;
        for (const at of places) {
            const box = {
                left: at.x - width / 2,
                right: at.x + width / 2,
                top: at.y - height / 2,
                bottom: at.y + height / 2,
            };
            const price = this.price(box, least);
            if (price < least) [best, place, least] = [box, at, price];
            if (least === 0) break;
        }
        if (best) this.boxes.push(best);
        return place;
    }
    /**
     * The area of other labels hidden, mm², plus half the length of strokes hidden, mm.
     * @param {{left: number, right: number, top: number, bottom: number}} box
     * @param {number} most a price that is higher need not be exact
     */
    price(box, most) {
        let price = 0;
        for (const {left, right, top, bottom} of this.boxes) {
            const wide = Math.min(right, box.right) - Math.max(left, box.left),
                tall = Math.min(bottom, box.bottom) - Math.max(top, box.top);
            if (wide > 0 && tall > 0) price += wide * tall;
        }
        for (const [a, b] of this.strokes) {
            if (price > most) break;
            price += lengthWithin(a, b, box) / 2;
        }
        return price;
    }
}
/**
 * The length of a stroke within a box, mm.
 * @param {Spot} a
 * @param {Spot} b
 * @param {{left: number, right: number, top: number, bottom: number}} box
 */
function lengthWithin(a, b, {left, right, top, bottom}) {
    if (Math.max(a.x, b.x) < left || Math.min(a.x, b.x) > right) return 0;
    if (Math.max(a.y, b.y) < top || Math.min(a.y, b.y) > bottom) return 0;
    const dx = b.x - a.x, dy = b.y - a.y;
    let from = 0, to = 1;
    if (dx !== 0) {
        const one = (left - a.x) / dx, other = (right - a.x) / dx;
        from = Math.max(from, Math.min(one, other));
        to = Math.min(to, Math.max(one, other));
    }
    if (dy !== 0) {
        const one = (top - a.y) / dy, other = (bottom - a.y) / dy;
        from = Math.max(from, Math.min(one, other));
        to = Math.min(to, Math.max(one, other));
    }
    return Math.max(0, to - from) * Math.hypot(dx, dy);
}

/**
 * At least three fifths as tall as wide, and at least as wide as tall: a polygon may be flat only in the drawn
 * position.
 * @param {number[]} room
 */
export function wellShaped([x, y, width, height]) {
    const tall = Math.max(height, 0.6 * width), wide = Math.max(width, 1.2 * tall);
    return [x - (wide - width) / 2, y, wide, tall];
}

/**
 * Rows of the polygons of one drawing, each from left to right.
 * @param {FigureView[]} views in the drawn position
 */
export function rowsOf(views) {
    const all = views.flatMap((view) => ({view, box: view.area.box()})),
        middle = (/** @type {typeof all[0]} */ {box}) => box?.centre.y ?? 0;
    /** @type {(typeof all)[]} */
    const rows = [];
    for (const each of all.sort((a, b) => middle(a) - middle(b))) {
        const last = rows[rows.length - 1];
        // In a row they may have different heights, but none is above another.
        const isBeside = last?.every(
            ({box}) => box && each.box && (box.right < each.box.left || box.left > each.box.right),
        );
        if (isBeside) last.push(each);
        else rows.push([each]);
    }
    return rows.map((row) => row.sort((a, b) => (a.box?.left ?? 0) - (b.box?.left ?? 0)).map(({view}) => view));
}
/** @typedef {{nodes: SVGGraphicsElement[], left: number, top: number, width: number, height: number}} Companion */
/**
 * The companions of a polygon in a drawing with several: its title above it, and the table of its forces below. In the
 * drawn position.
 * @param {FigureView} view
 * @param {FigureView[]} views
 */
export function companionsOf(view, views) {
    const groups = views.map(({group}) => group), title = view.group.previousElementSibling;
    const isTitle = (/** @type {Element} */ node) => groups.some((group) => group.previousElementSibling === node);
    /** @type {Element[]} */
    const below = [];
    for (let next = view.group.nextElementSibling; next && !isTitle(next); next = next.nextElementSibling) {
        if (!view.measures.includes(next)) below.push(next);
    }
    return [title?.matches('g.text') ? [title] : [], below].map((each) => {
        const nodes = /** @type {SVGGraphicsElement[]} */ (each),
            boxes = nodes.map((node) => node.getBBox());
        const {left, right, top, bottom} = boxOf(
            boxes.flatMap(({x, y, width, height}) => [
                {x, y},
                {x: x + width, y: y + height},
            ]),
        );
        if (nodes.length === 0) return {nodes, left: 0, top: 0, width: 0, height: 0};
        return {nodes, left, top, width: right - left, height: bottom - top};
    });
}
/**
 * The common factor by which the polygons of a drawing are smaller than on the sheet. Gives each polygon its own area.
 * @param {FigureView[][]} rows
 */
export function shareRoom(rows) {
    const [x, y, width, height] = rows[0][0].area.fitRoom, rim = 12, between = 14, apartFromFoot = 7;
    const sizes = rows.map((row) => row.map((view) => view.area.box()).map((box) =>
        box ? {x: box.right - box.left, y: box.bottom - box.top} : {x: 0, y: 0}));
    const tall = sizes.map((row) => Math.max(...row.map((size) => size.y)));
    const feet = rows.map((row) => Math.max(...row.map(({area: {foot}}) => foot ? foot.height + apartFromFoot : 0)));
    const freeHeight = Math.max(height - 2 * rim - between * (rows.length - 1) - total(feet), rim);
    // The width of the tables first, the rest in proportion to the widths of the polygons.
    const widths = rows.map((row, i) => {
        const least = row.map(({area: {foot}}) => foot?.width ?? 0),
            free = width - 2 * rim - between * (row.length - 1) - total(least);
        return least.map(
            (each, j) =>
                each + (Math.max(free, 0) * sizes[i][j].x) / Math.max(total(sizes[i].map((size) => size.x)), 1e-9),
        );
    });
    // A polygon whose forces are in line, upright, has no width, and may have none.
    const k = Math.max(
        total(tall) / freeHeight,
        ...sizes.flatMap((row, i) => row.map((size, j) => (size.x > 0 ? size.x / widths[i][j] : 0))),
        1e-9,
    );
    const air = (freeHeight - total(tall) / k) / rows.length;
    let top = y + rim;
    rows.forEach((row, i) => {
        const bottom = top + tall[i] / k + air;
        let left = x + rim;
        row.forEach((view, j) => {
            view.area.room = {left, right: left + widths[i][j], top, bottom};
            left += widths[i][j] + between;
        });
        top = bottom + feet[i] + between;
    });
    return k;
}

// --- figures on the screen -------------------------------------------------------------------------------------------

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
