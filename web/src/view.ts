// The part of the plane that the canvas shows: from the file's coordinates, y upwards, to pixels and back.
import type {Spot} from './edit';

export class View {
    scale = 3;
    left = 0;
    top = 0;
    readonly width = 1;
    readonly height = 1;

    constructor() {}
    toScreen([x, y]: Spot): Spot {
        return [(x - this.left) * this.scale, (this.top - y) * this.scale];
    }
    toPlane([x, y]: Spot): Spot {
        return [this.left + x / this.scale, this.top - y / this.scale];
    }
    /** @param dy pixels */
    pan(dx: number, dy: number) {
        this.left -= dx / this.scale;
        this.top += dy / this.scale;
    }
    /** Zooms about a place on the screen, which stays. */
    zoom(factor: number, about: Spot) {
        const [x, y] = this.toPlane(about);
        this.scale = Math.min(1e7, Math.max(1e-7, this.scale * factor));
        this.left = x - about[0] / this.scale;
        this.top = y + about[1] / this.scale;
    }
    /**
     * Shows all these spots.
     * @param unit the length that a screen shows where there are none
     */
    fit(spots: Spot[], unit: number) {
        const xs = spots.map(([x]) => x), ys = spots.map(([, y]) => y), margin = 90;
        const [left, right] = spots.length > 0 ? [Math.min(...xs), Math.max(...xs)] : [-unit / 2, unit / 2];
        const [bottom, top] = spots.length > 0 ? [Math.min(...ys), Math.max(...ys)] : [-unit / 2, unit / 2];
        const room = (size: number) => Math.max(size - 2 * margin, size / 3);
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
