// The area of a figure: what it must show, the part of the drawing that it has, scale and origin that fit it there.

import {along, boxOf, minus} from './path.js';
import {companionsOf, shareRoom, total, wellShaped} from './room.js';
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./held_marks.js').HeldMarks} HeldMarks */
/** @typedef {import('./room.js').Companion} Companion */
/** @typedef {import('./types.js').Spot} Spot */

export class Area {
    room = {left: 0, top: 0, right: 0, bottom: 0};
    /**
     * If there are several in one drawing.
     * @type {FigureView[][]}
     */
    rows = [];
    /** @type {Companion | undefined} */
    title = undefined;
    /** @type {Companion | undefined} */
    foot = undefined;

    /** @param {FigureView} view */
    constructor(view) {
        this.view = view;
        const {viewBox, isMechanism, held} = view;
        /**
         * The area for a polygon that fills its space: if it was drawn flat, or beside a detail, its shape may differ
         * elsewhere.
         */
        this.fitRoom = isMechanism || held ? viewBox : wellShaped(viewBox);
    }
    /**
     * All points that it must show here, at the drawing's scale, mm.
     * @returns {Spot[]}
     */
    extent() {
        if (this.view.held) return this.extentHeld(this.view.held);
        if (this.view.isMechanism) {
            // A vector that grows without limit near a dead point may leave the area.
            const [x, y, width, height] = this.view.viewBox, rim = width / 4;
            const tips = [...this.view.vectorsOf(this.view.motion.plan).keys()].flatMap((name) =>
                this.view.vector(name) ?? []).filter(
                (at) => at.x > x - rim && at.x < x + width + rim && at.y > y - rim && at.y < y + height + rim);
            return [...this.view.motion.read.points.map((at) => this.view.paper(at)), ...tips];
        }
        return [...this.view.keys.keys()].flatMap((name) => this.view.vector(name) ?? []);
    }
    /**
     * Points of concurrency and poles of curvature may be far away; then they leave the area, as on the sheet.
     * @param {HeldMarks} held
     */
    extentHeld(held) {
        this.view.stayInPlace();
        const [x, y, width, height] = this.view.viewBox,
            rim = width / 4;
        const isNear = (/** @type {Spot} */ at) =>
            at.x > x - rim && at.x < x + width + rim && at.y > y - rim && at.y < y + height + rim;
        const places = [...held.places].flatMap((name) => held.place(name) ?? []);
        if (held.isLever) return places;
        const points = this.view.own ? this.view.own.points : this.view.motion.read.points.map((_, i) => i);
        const arrows = [...held.arrows.values()].flatMap(({now}) => now() ?? []);
        return [...points.map((point) => this.view.point(point)), ...[...places, ...arrows].filter(isNear)];
    }
    /** The box of what it shows, at the drawing's scale, mm. */
    box() {
        const {view} = this, {scale, origin} = view;
        this.view.scale = this.view.drawnScale;
        this.view.origin = this.view.drawnOrigin;
        const spots = this.extent();
        [view.scale, view.origin] = [scale, origin];
        return spots.length > 0 ? boxOf(spots) : null;
    }
    /**
     * The figure's part of the drawing: all of it, or a place in a row. In the drawn position.
     * @param {FigureView[]} views of the drawing, itself among them
     * @param {FigureView[][]} rows
     */
    takeRoom(views, rows) {
        const rim = 12, below = 8, own = this.fitRoom;
        if (views.length > 1 && !this.view.isMechanism && !this.view.held) {
            this.rows = rows;
            [this.title, this.foot] = companionsOf(this.view, views);
            const feet = total(rows.map((row) => Math.max(...row.map(({area: {foot}}) => foot?.height ?? 0))));
            this.fitRoom = [own[0], own[1], own[2], Math.max(own[3], feet + rows.length * (own[2] / 3 + 14))];
        }
        const [x, y, width, height] = this.fitRoom;
        this.room = {left: x + rim, top: y + rim, right: x + width - rim, bottom: y + height - rim - below};
    }
    /**
     * Moves the title and the table with a polygon that has a place in a row.
     * @param {boolean} fits
     */
    placeCompanions(fits) {
        const {room, title, foot} = this,
            centre = (room.left + room.right) / 2;
        const put = (/** @type {Companion | undefined} */ of, /** @type {number} */ left, /** @type {number} */ top) =>
            of?.nodes.forEach((node) =>
                this.view.marks.translate(node, fits ? {x: left - of.left, y: top - of.top} : {x: 0, y: 0}),
            );
        put(title, room.left - 8, room.top - 8);
        if (foot) put(foot, centre - foot.width / 2, room.bottom + 7);
    }
    /** The factor by which it must be smaller than on the sheet to fill its area. */
    shrinkage() {
        if (this.rows.length > 0) return shareRoom(this.rows);
        const box = this.box(), {left, top, right, bottom} = this.room;
        if (!box) return 1e-9;
        return Math.max(
            (box.right - box.left) / Math.max(right - left, 20),
            (box.bottom - box.top) / Math.max(bottom - top, 20),
            1e-9,
        );
    }
    /**
     * Scale and origin that centre the figure in its area.
     * @param {number} k the factor by which it is smaller than on the sheet
     * @returns {{scale: number, origin: Spot}}
     */
    fitted(k) {
        const box = this.box(), {left, top, right, bottom} = this.room;
        if (!box) return {scale: this.view.drawnScale, origin: this.view.drawnOrigin};
        const middle = {x: (left + right) / 2, y: (top + bottom) / 2};
        return {scale: this.view.drawnScale * k, origin: along(middle, -1 / k, minus(box.centre,
            this.view.drawnOrigin))};
    }
}
