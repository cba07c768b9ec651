// The areas that figures may cover over the range of a driver, so that nothing leaves its drawing and scales stay.

/** @typedef {import('./drive.js').Drive} Drive */
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./motion.js').Motion} Motion */

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
