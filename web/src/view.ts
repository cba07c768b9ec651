// The part of the plane that the canvas shows: from the file's coordinates, y upwards, to pixels and back.

/** @typedef {import('./edit.js').Spot} Spot */

export class View {
    constructor() {
        this.scale = 3; // pixels for a unit of length
        this.left = 0;
        this.top = 0;
        this.width = 1;
        this.height = 1;
    }
    /**
     * @param {Spot} at
     * @returns {Spot}
     */
    toScreen([x, y]) {
        return [(x - this.left) * this.scale, (this.top - y) * this.scale];
    }
    /**
     * @param {Spot} at
     * @returns {Spot}
     */
    toPlane([x, y]) {
        return [this.left + x / this.scale, this.top - y / this.scale];
    }
    /**
     * @param {number} dx
     * @param {number} dy pixels
     */
    pan(dx, dy) {
        this.left -= dx / this.scale;
        this.top += dy / this.scale;
    }
    /**
     * Zooms about a place on the screen, which stays.
     * @param {number} factor
     * @param {Spot} about
     */
    zoom(factor, about) {
        const [x, y] = this.toPlane(about);
        this.scale = Math.min(1e7, Math.max(1e-7, this.scale * factor));
        this.left = x - about[0] / this.scale;
        this.top = y + about[1] / this.scale;
    }
    /**
     * Shows all these spots.
     * @param {Spot[]} spots
     * @param {number} unit the length that a screen shows where there are none
     */
    fit(spots, unit) {
        const xs = spots.map(([x]) => x), ys = spots.map(([, y]) => y), margin = 90;
        const [left, right] = spots.length > 0 ? [Math.min(...xs), Math.max(...xs)] : [-unit / 2, unit / 2];
        const [bottom, top] = spots.length > 0 ? [Math.min(...ys), Math.max(...ys)] : [-unit / 2, unit / 2];
        const room = (/** @type {number} */ size) => Math.max(size - 2 * margin, size / 3);
        const most = spots.length > 1 ? Infinity : Math.min(this.width, this.height) / unit;
        this.scale = Math.min(
            room(this.width) / Math.max(right - left, 1e-9),
            room(this.height) / Math.max(top - bottom, 1e-9),
            most
        );
        if (!Number.isFinite(this.scale) || this.scale > 1e8) this.scale = Math.min(this.width, this.height) / unit;
        this.left = (left + right) / 2 - this.width / 2 / this.scale;
        this.top = (bottom + top) / 2 + this.height / 2 / this.scale;
    }
    /** The grid: 1, 2 or 5 of a power of ten, some twelve to thirty pixels. */
    get grid() {
        const least = 11 / this.scale, power = 10 ** Math.floor(Math.log10(least));
        return power * (least / power <= 1 ? 1 : least / power <= 2 ? 2 : least / power <= 5 ? 5 : 10);
    }
}
