// Marks with a `data-on` attribute (written by render/backends/svg.cpp): forces and their lines of action, points of
// concurrency, arms, strings, curvature, Joukowsky's lever. The attribute names places and vectors of the plans, and
// the mark is moved to them; nothing is bound by its position in the drawing.

import {dot, quarterTurn, unitOf} from './closure.js';
import {along, apart, minus} from './path.js';
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./types.js').Spot} Spot */

/**
 * @typedef {{form: string, on: string[], beyond: number, unit: number}} Hold
 * @typedef {{given: number, at: () => Spot | null, free: () => Spot | null, sense: number, scale: () => number}} Handle
 *   of a vector that can be dragged: the index of the given; the end that stays, and the free one; +1: it leads to the
 *   free end; SI units for a mm, 0: only its direction is drawn
 */

/** As engine/solution/bindings.cpp writes them. */
export const tipOfVector = /^p(\d+)>(.+)>([^>]+)$/;
const placeOnBody = /^b(\d+) (\S+) (\S+)$/, tipOfDisplacement = /^d(\d+) (\d+) (\S+)$/,
    ofPosition = /^([ptg]\d+|b\d+ \S+ \S+|d\d+ \d+ \S+)$/;

/**
 * @param {Element} node
 * @returns {Hold}
 */
export function holdOf(node) {
    const [form, ...on] = JSON.parse(node.getAttribute('data-on') ?? '[""]');
    return {
        form,
        on,
        beyond: Number(node.getAttribute('data-beyond') ?? 0),
        unit: Number(node.getAttribute('data-number') ?? 0),
    };
}

export class HeldMarks {
    /** @param {FigureView} view its places must be known */
    constructor(view) {
        this.view = view;
        this.isLever = view.info.isLever === true;
        /** Of forces drawn to scale: N for a mm, as drawn and now; the unit in N of the text of the scale. */
        this.drawnScale = 1;
        this.scale = 1;
        this.unit = '';
        this.inUnit = 1;
        /**
         * Names of the forces drawn to scale.
         * @type {string[]}
         */
        this.forces = [];
        /**
         * By the names of their attribute: ends of the arrows, as drawn and now.
         * @type {Map<string, {drawn: [Spot, Spot], now: () => [Spot, Spot] | null}>}
         */
        this.arrows = new Map();
        /** The largest force drawn to scale, as drawn. */
        this.longest = 0;
        /**
         * Names of places that must be visible in the figure.
         * @type {Set<string>}
         */
        this.places = new Set();
        /**
         * Vectors that a reader may drag.
         * @type {Handle[]}
         */
        this.handles = [];
        /** Whether the scale stays while a vector is dragged. */
        this.isKept = false;
        /** Whether some mark depends on the record, not on the position only. */
        this.isRecorded = [...view.group.querySelectorAll('[data-on]')].some((node) => {
            const {form, on} = holdOf(node);
            return form !== 'body' && on.some((name) => name !== '' && !ofPosition.test(name));
        });
        this.measureScales();
    }
    /** Computes the scale from the longest arrow; for Joukowsky's lever also from the longest ray. */
    measureScales() {
        const {view} = this, all = [...view.group.querySelectorAll('[data-on]')];
        const longest = (/** @type {string} */ form, /** @type {(on: string[]) => number} */ sizeOf) => {
            let scale = 0, most = 0;
            for (const node of all) {
                const {form: own, on} = holdOf(node),
                    axis = own === form ? node.querySelector(':scope > line.axis') : null;
                const size = axis ? sizeOf(on) : 0,
                    length = axis ? apart(...endsOf(axis)) : 0;
                if (size > 0 && length > most) [most, scale] = [length, size / length];
            }
            return scale;
        };
        this.drawnScale = this.scale = longest('arrow', (on) => this.sizeOf(on)) || 1;
        if (this.isLever) {
            view.scale = longest('segment', ([, tip]) => {
                const v = this.vectorOf(view.motion.held(tip)?.[0] ?? -1);
                return v ? Math.hypot(v.x, v.y) : 0;
            });
        }
        const own = all.find((node) => node.matches('g.force')) ?? view.group;
        this.unit = own.getAttribute('data-unit') ?? '';
        this.inUnit = this.drawnScale / Number(own.getAttribute('data-scale') ?? 1);
        const arrows = all.filter((node) => node.matches('g.vector, g.force'));
        this.forces = arrows.map((node) => holdOf(node)).filter(({form, on}) =>
            form === 'arrow' && on.length === 2).map(({on}) => on[1]);
        this.longest = Math.max(0, ...this.forces.map((force) => this.sizeOf(['', force])));
    }
    /**
     * @param {number} element
     * @returns {Spot | null} null: it vanishes
     */
    vectorOf(element) {
        const {motion} = this.view;
        if (element < 0 || motion.plan < 0) return null;
        const replay = motion.replays[motion.plan];
        return {x: replay.x(element), y: replay.y(element)};
    }
    /**
     * On paper.
     * @param {string} name
     * @returns {Spot | null}
     */
    place(name) {
        const {view} = this, {motion} = view;
        if (name === 'o') return view.origin;
        if (name[0] === '/') return this.footOn(name.slice(1));
        if (/^p\d+$/.test(name)) return view.point(Number(name.slice(1)));
        const derived = this.derivedPlace(name);
        if (derived !== undefined) return derived;
        const element = motion.held(name)?.[0] ?? -1;
        if (!this.isLever) {
            const at = motion.spot(element);
            return at && view.paper(at);
        }
        const v = this.vectorOf(element) ?? {x: 0, y: 0};  // a point at rest has its image at the pole
        return motion.held(name) ? view.paper({x: -v.y, y: v.x}) : null;
    }
    /**
     * A place on a body; the tip of a vector that begins at a point; undefined: the name is of the record.
     * @param {string} name
     * @returns {Spot | null | undefined}
     */
    derivedPlace(name) {
        const {view} = this, {motion} = view;
        const onBody = name.match(placeOnBody);
        if (onBody) return view.links.carried(Number(onBody[1]), {x: Number(onBody[2]), y: Number(onBody[3])});
        const displaced = name.match(tipOfDisplacement);
        const tip = name.match(tipOfVector);
        if (!displaced && !tip) return undefined;
        const by = displaced ? motion.displacement(Number(displaced[1]), Number(displaced[2])) :
            motion.held(tip?.[2] ?? '') ? this.vectorOf(motion.held(tip?.[2] ?? '')?.[1] ?? -1) ?? {x: 0, y: 0} : null;
        const scale = view.scale * Number(displaced ? displaced[3] : tip?.[3]);
        const from = view.point(Number(displaced ? displaced[1] : tip?.[1]));
        return by && {x: from.x + by.x / scale, y: from.y - by.y / scale};
    }
    /** @param {string} force */
    footOn(force) {
        const at = this.place(force), e = this.direction([force]);
        return at && e && along(at, dot(minus(this.view.origin, at), e), e);
    }
    /**
     * The magnitude of the vector with the second name, SI.
     * @param {string[]} on
     */
    sizeOf([, name]) {
        const v = this.vectorOf(this.view.motion.held(name)?.[1] ?? -1);
        return v ? Math.hypot(v.x, v.y) : 0;
    }
    /**
     * Unit vector on paper: of a vector, or from place to place.
     * @param {string[]} names
     * @returns {Spot | null}
     */
    direction(names) {
        if (/^[tg]\d+$/.test(names[0])) {
            const {tangents, guides} = this.view.motion.read;
            const {x, y} = (names[0][0] === 't' ? tangents : guides)[Number(names[0].slice(1))];
            return x === 0 && y === 0 ? null : unitOf({x, y: -y});
        }
        const [from, to] = names.length > 1 ? names.map((name) => this.place(name)) : [];
        const v = names.length > 1 ? null : this.vectorOf(this.view.motion.held(names[0])?.[1] ?? -1);
        const by = v ? {x: v.x, y: -v.y} : from && to ? minus(to, from) : null;
        return by && Math.hypot(by.x, by.y) > 0 ? unitOf(by) : null;
    }
    /**
     * A couple, N m.
     * @param {string} name
     */
    couple(name) {
        const {motion} = this.view, element = motion.held(name)?.[2] ?? -1;
        return element < 0 || motion.plan < 0 ? 0 : motion.replays[motion.plan].x(element);
    }
    /**
     * Place and directions; null if one of them is missing.
     * @param {string[]} on
     */
    axes([place, ...names]) {
        const at = this.place(place), e = this.direction(names);
        return at && e ? {at, e, n: quarterTurn(e)} : null;
    }
    /** Call before marks are placed. If figures fill their area, the longest arrow keeps its length. */
    take(/** @type {boolean} */ fits) {
        if (this.isKept) return;
        const sizes = this.forces.map((force) => this.sizeOf(['', force])), most = Math.max(0, ...sizes);
        this.scale = fits && most > 0 && this.longest > 0 ? this.drawnScale * most / this.longest : this.drawnScale;
    }
}

/**
 * @param {Element} axis
 * @returns {[Spot, Spot]}
 */
export function endsOf(axis) {
    const of = (/** @type {string} */ name) => Number(axis.getAttribute(name));
    return [{x: of('x1'), y: of('y1')}, {x: of('x2'), y: of('y2')}];
}
