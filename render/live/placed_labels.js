// The labels of a figure where they are now, so that those of a drawing laid on another keep off that one's.

import {along, minus} from './path.js';
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./types.js').Spot} Spot */

/** @typedef {{parts: Element[], centre: Spot, size: {width: number, height: number}, by: Spot}} Placed */

/** A label that is hidden less than this is not moved, mm². */
const coveredArea = 0.3;

export class PlacedLabels {
    /** @param {FigureView} view */
    constructor(view) {
        this.view = view;
        /**
         * Labels, and how far each is from its place as drawn.
         * @type {Placed[]}
         */
        this.all = [];
    }
    /**
     * @param {Element[]} parts
     * @param {Spot | null} centre
     * @param {{width: number, height: number} | null} size
     * @returns {Placed}
     */
    note(parts, centre = null, size = null) {
        const {x, y, width, height} = /** @type {SVGGraphicsElement} */ (parts[0]).getBBox();
        const placed = {parts, centre: centre ?? {x: x + width / 2, y: y + height / 2}, size: size ?? {width, height},
            by: {x: 0, y: 0}};
        this.all.push(placed);
        return placed;
    }
    /** Labels that are seen. */
    get seen() {
        return this.all.filter(({parts: [label]}) => !label.matches('.twin') &&
            (this.view.svg.matches('.moved') ? !label.matches('.still') && this.view.marks.isShown(label) :
                !label.matches('.number')));
    }
    /** The boxes of labels that are seen, m. */
    boxes() {
        return this.seen.map(({centre, size: {width, height}, by}) => {
            const [a, b] = [-1, 1].map((side) => this.view.unpaper({x: centre.x + by.x + side * width / 2,
                y: centre.y + by.y + side * height / 2}));
            return {left: a.x, right: b.x, top: a.y, bottom: b.y};
        });
    }
    /**
     * In the drawn position labels stand where the sheet has them, except those that lie on labels of the drawing
     * below.
     */
    makeWay() {
        const {crowd, marks, links} = this.view, seen = this.seen;
        seen.forEach((each) => (each.by = {x: 0, y: 0}));
        const boxAt = (/** @type {Placed} */ {centre, size: {width, height}}) => ({left: centre.x - width / 2,
            right: centre.x + width / 2, top: centre.y - height / 2, bottom: centre.y + height / 2});
        crowd.clear([]);
        const covered = seen.filter((each) => crowd.price(boxAt(each), 0) > coveredArea);
        if (covered.length === 0) return;
        crowd.clear([...links.bars()]);
        for (const each of seen) if (!covered.includes(each)) crowd.boxes.push(boxAt(each));
        for (const each of covered) {
            const turns = Array.from({length: 12}, (_, i) => i * Math.PI / 6);
            const places = [each.centre, ...[2, 4, 6, 9, 13].flatMap((far) => turns.map((turn) =>
                along(each.centre, far, {x: Math.cos(turn), y: Math.sin(turn)})))];
            const at = crowd.best(places, each.size);
            each.by = minus(at, each.centre);
            for (const part of each.parts) marks.translate(part, each.by);
        }
    }
}
