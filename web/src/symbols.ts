// The marks of the canvas, after ISO 3952: pins, grounds, bars, plates, sliders, wheels, springs, forces. Pixels, y
// downwards.
import {svg} from './dom';
import type {Spot} from './edit';

const through = (spots: Spot[]) =>
    spots.map(([x, y], i) => `${i === 0 ? 'M' : 'L'}${x.toFixed(1)} ${y.toFixed(1)}`).join('');

export const pin = (at: Spot) => svg('circle', {class: 'pin', cx: at[0], cy: at[1], r: 6});
/** A point that is no pin. */
export const dot = (at: Spot) => svg('circle', {class: 'dot', cx: at[0], cy: at[1], r: 4});
export function ground([x, y]: Spot) {
    const hatch = [-14, -7, 0, 7, 14].map((i) => `M${x + i} ${y + 22}l-6 7`).join('');
    return svg(
        'g',
        {class: 'ground'},
        svg('path', {class: 'base', d: `M${x} ${y}l-11 22h22z`}),
        svg('path', {d: `M${x - 18} ${y + 22}h36${hatch}`})
    );
}
/** A support on rollers, below the point where `turned` is 0. */
export function roller([x, y]: Spot, turned: number) {
    const wheels = [-7, 7].map((i) => svg('circle', {class: 'base', cx: i, cy: 25, r: 3.5}));
    return svg(
        'g',
        {class: 'ground', transform: `translate(${x} ${y}) rotate(${(turned * 180) / Math.PI})`},
        svg('path', {class: 'base', d: 'M0 0l-11 21h22z'}),
        ...wheels,
        svg('path', {d: 'M-20 29h40M-14 29l-6 7M-7 29l-6 7M0 29l-6 7M7 29l-6 7M14 29l-6 7'})
    );
}
/** Two spots: a bar; more: a plate with its outline. */
export function link(spots: Spot[]) {
    const sorted = spots.length > 3 ? hull(spots) : spots;
    return svg('path', {class: spots.length > 2 ? 'plate' : 'bar', d: through(sorted) + (spots.length > 2 ? 'Z' : '')});
}
/** The convex hull (Andrew). */
export function hull(spots: Spot[]) {
    const sorted = [...spots].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const half = (all: Spot[]) => {
        const chain: Spot[] = [];
        for (const each of all) {
            while (chain.length > 1) {
                const [a, b] = chain.slice(-2);
                if ((b[0] - a[0]) * (each[1] - a[1]) - (b[1] - a[1]) * (each[0] - a[0]) > 0) break;
                chain.pop();
            }
            chain.push(each);
        }
        return chain.slice(0, -1);
    };
    return [...half(sorted), ...half([...sorted].reverse())];
}
/** A slider on its guide; `turned`: radians on the screen; the frame's guide is hatched. */
export function slider([x, y]: Spot, turned: number, isOfFrame: boolean) {
    const hatch = isOfFrame ? [-40, -28, -16, -4, 8, 20, 32].map((i) => `M${i + 6} 13l-6 7`).join('') : '';
    return svg(
        'g',
        {class: 'slider', transform: `translate(${x} ${y}) rotate(${(turned * 180) / Math.PI})`},
        svg('path', {class: 'guide', d: `M-46 13h92${hatch}`}),
        svg('rect', {class: 'block', x: -19, y: -12, width: 38, height: 24, rx: 2})
    );
}
export const slot = ([x, y]: Spot, turned: number) =>
    svg('rect', {
        class: 'slot',
        x: -44,
        y: -9,
        width: 88,
        height: 18,
        rx: 9,
        transform: `translate(${x} ${y}) rotate(${(turned * 180) / Math.PI})`
    });
export const wheel = (centre: Spot, radius: number, isGear: boolean) =>
    svg('circle', {class: isGear ? 'wheel gear' : 'wheel', cx: centre[0], cy: centre[1], r: radius});
/** An arrow whose tip is at `to`. */
export function arrow(from: Spot, to: Spot, kind: string) {
    const turned = Math.atan2(to[1] - from[1], to[0] - from[0]);
    const wing = (by: number) =>
        `${to[0] - 11 * Math.cos(turned + by)} ${to[1] - 11 * Math.sin(turned + by)}`;
    return svg(
        'g',
        {class: `arrow ${kind}`},
        svg('path', {d: through([from, to])}),
        svg('path', {class: 'head', d: `M${to[0]} ${to[1]}L${wing(0.3)}L${wing(-0.3)}Z`})
    );
}
/**
 * The sense of a driver about a pivot, beside its bar: counter-clockwise where positive.
 * @param beside the direction of the bar on the screen, radians
 */
export function spin([x, y]: Spot, isPositive: boolean, beside = -1) {
    const radius = 34,
        sign = isPositive ? -1 : 1;
    const spot = (turned: number, away = radius) =>
        `${(x + away * Math.cos(turned)).toFixed(1)} ${(y + away * Math.sin(turned)).toFixed(1)}`;
    const start = beside + sign * 0.4,
        end = beside + sign * 1.4;
    return svg(
        'g',
        {class: 'arrow driver'},
        svg('path', {d: `M${spot(start)}A${radius} ${radius} 0 0 ${isPositive ? 0 : 1} ${spot(end)}`}),
        svg('path', {
            class: 'head',
            d: `M${spot(end + sign * 0.28)}L${spot(end, radius - 5.5)}L${spot(end, radius + 5.5)}Z`
        })
    );
}
export function spring(from: Spot, to: Spot) {
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]), turned = Math.atan2(to[1] - from[1], to[0] - from[0]);
    const coil = Math.min(length * 0.7, 120), start = (length - coil) / 2, turns = 6;
    let d = `M0 0H${start}`;
    for (let i = 0; i < turns; ++i) d += `l${coil / turns / 4} -8l${coil / turns / 2} 16l${coil / turns / 4} -8`;
    return svg('path', {
        class: 'spring',
        d: `${d}H${length}`,
        transform: `translate(${from[0]} ${from[1]}) rotate(${(turned * 180) / Math.PI})`
    });
}
export const weight = ([x, y]: Spot) =>
    svg(
        'g',
        {class: 'weight'},
        svg('circle', {cx: x, cy: y, r: 8}),
        svg('path', {
            class: 'head',
            d: `M${x} ${y}V${y - 8}A8 8 0 0 1 ${x + 8} ${y}ZM${x} ${y}V${y + 8}A8 8 0 0 1 ${x - 8} ${y}Z`
        })
    );
/** A name beside a spot, its digits as an index: O₂. */
export function label(at: Spot, name: string, kind: string) {
    const match = /^(\D+)(\d+)$/.exec(name);
    return svg('text', {class: `label ${kind}`, x: at[0], y: at[1]}, match ? match[1] : name,
        ...(match ? [svg('tspan', {class: 'index', dy: 4}, match[2])] : []));
}
