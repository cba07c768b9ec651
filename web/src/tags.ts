// Where the numbers of bodies stand: beside the middle of a bar, within a plate, off other bars and numbers.
import type {Spot} from './edit';
import {distance} from './placing';

/** Pixels: from a bar to its number; between two numbers; from a number to a bar or a pin of others. */
const away = 24, apart = 25, clear = 17;
/** Places along a bar, the best first. */
const shares = [0.5, 0.36, 0.64, 0.24, 0.76];

export function isStraight(at: Spot[]) {
    const [a, b] = ends(at),
        length = distance(a, b) || 1;
    return at.every(
        (each) => Math.abs((b[0] - a[0]) * (each[1] - a[1]) - (b[1] - a[1]) * (each[0] - a[0])) / length < 1.5
    );
}
/** The two spots farthest apart. */
export function ends(at: Spot[]): [Spot, Spot] {
    let best = [at[0], at[1]] as [Spot, Spot];
    for (const a of at) for (const b of at) if (distance(a, b) > distance(...best)) best = [a, b];
    return best;
}
function distanceTo(at: Spot, [a, b]: [Spot, Spot]) {
    const [dx, dy] = [b[0] - a[0], b[1] - a[1]], square = dx * dx + dy * dy || 1;
    const t = Math.max(0, Math.min(1, ((at[0] - a[0]) * dx + (at[1] - a[1]) * dy) / square));
    return distance(at, [a[0] + t * dx, a[1] + t * dy]);
}

export class Tags {
    readonly bars: [Spot, Spot][];
    readonly points: Spot[];
    /** Numbers that have their place. */
    taken: Spot[] = [];

    /**
     * @param bodies the points of each
     * @param points all points
     */
    constructor(bodies: Spot[][], points: (Spot | null)[]) {
        this.bars = bodies.filter((at) => at.length > 1).map(ends);
        this.points = points.filter(Boolean) as Spot[];
    }
    /**
     * The place of a body's number.
     * @param isBelow the side that is better
     */
    place(at: Spot[], isBelow: boolean): Spot {
        const places = placesOf(at, isBelow), faults = places.map((each) => this.faults(each));
        const best = places[faults.indexOf(Math.min(...faults))];
        this.taken.push(best);
        return best;
    }
    /** How many things a number would stand on; another number is the worst. */
    faults(at: Spot) {
        return 3 * this.taken.filter((each) => distance(each, at) < apart).length +
            this.points.filter((each) => distance(each, at) < clear).length +
            this.bars.filter((each) => distanceTo(at, each) < clear).length;
    }
}
/** Where a body's number may stand, the best first. */
function placesOf(at: Spot[], isBelow: boolean): Spot[] {
    if (at.length === 0) return [[-100, -100]];
    if (at.length > 2 && !isStraight(at)) return [[0, 1].map((axis) =>
        at.reduce((sum, each) => sum + each[axis], 0) / at.length)].map(([x, y]) => [x, y]);
    const [a, b] = at.length > 1 ? ends(at) : [at[0], at[0]], length = distance(a, b) || 1;
    const preferred = b[0] - a[0] < 0 !== isBelow ? 1 : -1;
    return shares.flatMap((share) => [preferred, -preferred].map((sign) => [
        a[0] + share * (b[0] - a[0]) - (sign * away * (b[1] - a[1])) / length,
        a[1] + share * (b[1] - a[1]) + (sign * away * (b[0] - a[0])) / length
    ] as Spot));
}
