// The area of a figure: what it must show, the part of the drawing that it has, scale and origin that fit it there.

import {along, boxOf, minus} from './path.js';
import {companionsOf, shareRoom, total, wellShaped} from './room.js';
/** @typedef {import('./drive.js').Drive} Drive */
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./held_marks.js').HeldMarks} HeldMarks */
/** @typedef {import('./motion.js').Motion} Motion */
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
        const {viewBox, isMechanism, isHeld} = view;
        /**
         * The area for a polygon that fills its space: if it was drawn flat, or beside a detail, its shape may differ
         * elsewhere.
         */
        this.fitRoom = isMechanism || isHeld ? viewBox : wellShaped(viewBox);
    }
    /**
     * All points that it must show here, at the drawing's scale, mm.
     * @returns {Spot[]}
     */
    extent() {
        if (this.view.held && this.view.isHeld) return this.extentHeld(this.view.held);
        if (this.view.isMechanism) {
            // A vector that grows without limit near a dead point may leave the area.
            const [x, y, width, height] = this.view.viewBox, rim = width / 4;
            const arrows = [...this.view.held?.arrows.values() ?? []].flatMap(({now}) => now() ?? []);
            const tips = [...arrows, ...[...this.view.vectorsOf(this.view.motion.plan).keys()].flatMap((name) =>
                this.view.vector(name) ?? [])].filter(
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
        if (views.length > 1 && !this.view.isMechanism && !this.view.isHeld) {
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

/** The areas that figures may cover over the range of a driver, so that nothing leaves its drawing and scales stay. */
export class Rooms {
    /** @param {Drive} drive */
    constructor(drive) {
        this.drive = drive;
        /**
         * By language and driver.
         * @type {Map<string, Map<SVGSVGElement, number[]>>}
         */
        this.known = new Map();
    }
    clear() {
        this.known.clear();
    }
    /**
     * The figure's own area, extended by what it covers over the driver's range: nothing leaves it, and its scale stays
     * constant.
     * @param {FigureView} view
     */
    of(view) {
        const key = `${this.drive.page.language} ${this.drive.course.driver} ${this.drive.page.at('fit').checked}`;
        if (!this.known.has(key)) this.known.set(key, this.measure());
        return this.known.get(key)?.get(view.svg) ?? view.viewBox;
    }
    measure() {
        const motion = /** @type {Motion} */ (this.drive.motion), {course} = this.drive, here = motion.at;
        const most = 1, fits = this.drive.page.at('fit').checked;
        const rooms = new Map(this.drive.page.figures.map((view) => {
            const [x, y, width, height] = view.viewBox;
            return [view.svg, {left: x, top: y, right: x + width, bottom: y + height}];
        }));
        for (const sample of course.samples) {
            if (!motion.moveTo(course, sample.at)) continue;
            for (const view of this.drive.page.figures) {
                if (!view.svg.matches('.following') || (view.isConstructed && motion.plan < 0)) continue;
                const [x, y, width, height] = view.viewBox,
                    room = /** @type {any} */ (rooms.get(view.svg)),
                    margin = view.isFree ? 14 : 8;
                view.scale = view.drawnScale;
                view.origin = view.drawnOrigin;
                view.held?.take(fits);
                view.ground.measureTravels();
                for (const at of view.extent()) {
                    room.left = Math.max(Math.min(room.left, at.x - margin), x - most * width);
                    room.right = Math.min(Math.max(room.right, at.x + margin), x + (1 + most) * width);
                    room.top = Math.max(Math.min(room.top, at.y - margin), y - most * height);
                    room.bottom = Math.min(Math.max(room.bottom, at.y + margin), y + (1 + most) * height);
                }
            }
        }
        motion.moveTo(course, here);
        // The scale bar is below what moves.
        for (const view of this.drive.page.figures) {
            const room = rooms.get(view.svg), [, y, , height] = view.viewBox;
            if (room && view.isMechanism && view.measures.length > 0 && room.bottom > y + height) room.bottom += 8;
        }
        return new Map([...rooms].map(
            ([svg, room]) => [svg, [room.left, room.top, room.right - room.left, room.bottom - room.top]]));
    }
}
