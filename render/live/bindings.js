// Marks with a `data-on` attribute (written by render/backends/svg.cpp): forces and their lines of action, points of
// concurrency, arms, strings, curvature, Joukowsky's lever. The attribute names places and vectors of the plans, and
// the mark is moved to them; nothing is bound by its position in the drawing.

/** Names of forms as in render/ink/holds.cpp. Lines extend over the visible part of the figure. Lengths in mm. */
const leastLine = 1, largestRound = 1e4, shortestArc = 16, sameLine = 0.3;

/** @typedef {{form: string, on: string[], beyond: number, unit: number}} Hold */

/**
 * @param {Element} node
 * @returns {Hold}
 */
function holdOf(node) {
    const [form, ...on] = JSON.parse(node.getAttribute('data-on') ?? '[""]');
    return {
        form,
        on,
        beyond: Number(node.getAttribute('data-beyond') ?? 0),
        unit: Number(node.getAttribute('data-number') ?? 0),
    };
}

class HeldMarks {
    /** @param {FigureView} view its places must be known */
    constructor(view) {
        this.view = view;
        this.isLever = view.info.name === 'joukowsky';
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
        this.forces = arrows.map((node) => holdOf(node)).filter(({form}) => form === 'arrow').map(({on}) => on[1]);
        this.longest = Math.max(0, ...this.forces.map((force) => this.sizeOf(['', force])));
    }

    // --- positions of names
    // -------------------------------------------------------------------------------------------

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
        const element = motion.held(name)?.[0] ?? -1;
        if (!this.isLever) {
            const at = motion.spot(element);
            return at && view.paper(at);
        }
        const v = this.vectorOf(element) ?? {x: 0, y: 0};  // a point at rest has its image at the pole
        return motion.held(name) ? view.paper({x: -v.y, y: v.x}) : null;
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

    // --- following ---------------------------------------------------------------------------------------------------

    /** Call before marks are placed. If figures fill their area, the longest arrow keeps its length. */
    take(/** @type {boolean} */ fits) {
        const sizes = this.forces.map((force) => this.sizeOf(['', force])), most = Math.max(0, ...sizes);
        this.scale = fits && most > 0 && this.longest > 0 ? this.drawnScale * most / this.longest : this.drawnScale;
    }
    /** @param {Element} node not a label */
    bind(node) {
        const hold = holdOf(node), {view} = this, {on} = hold;
        const paths = node.tagName === 'path' ? [node] : [...node.querySelectorAll('path')];
        const redraw = (/** @type {() => string} */ pathNow) => view.bindings.push(() => {
            const d = pathNow();
            paths.forEach((path, i) => view.show(path, d !== '' && i === 0));
            if (d !== '') view.set(paths[0], 'd', d);
        });
        switch (hold.form) {
            case 'at':
                this.places.add(on[0]);
                return view.bindToPlace([node], () => this.place(on[0]));
            case 'body':
                return view.bindToBody(node, Number(on[0]));
            case 'with':
                return this.bindWith(node, on);
            case 'arrow':
                return this.bindArrow(node, on);
            case 'couple':
                return this.bindCouple(node, on);
            case 'line':
                return redraw(() => this.linesNow(hold));
            case 'segment':
                this.bindAxis(node, on);
                return redraw(() => this.segmentNow(hold));
            case 'through':
            case 'normal':
                return redraw(() => this.wholeLineNow(hold));
            case 'circle':
                return redraw(() => this.circleNow(on));
            case 'arc':
                return redraw(() => this.arcNow(on));
            default:
                return node.classList.add('still');
        }
    }
    /**
     * @param {Element} node
     * @param {string[]} on
     */
    bindWith(node, on) {
        const {view} = this, drawn = this.axes(on);
        if (!drawn) return node.classList.add('still');
        view.bindings.push(() => {
            const now = this.axes(on);
            view.show(node, now !== null);
            if (!now) return;
            const c = dot(drawn.e, now.e), s = dot(drawn.n, now.e);
            const e = now.at.x - c * drawn.at.x + s * drawn.at.y, f = now.at.y - s * drawn.at.x - c * drawn.at.y;
            view.transform(node, `matrix(${[c, s, -s, c, e, f].map((each) => each.toFixed(6)).join(' ')})`);
        });
    }
    /**
     * An arrow to scale: it keeps its distance from its place, before, behind or beside it.
     * @param {Element} node
     * @param {string[]} on
     */
    bindArrow(node, on) {
        const {view} = this, axis = node.querySelector(':scope > line.axis'), known = this.axes(on);
        if (!known) return node.classList.add('still');
        const length = this.sizeOf(on) / this.drawnScale;
        const [tail, tip] = axis ? endsOf(axis) : [known.at, along(known.at, length, known.e)];
        const [begins, ends] = [tail, tip].map((at) => dot(minus(at, known.at), known.e)),
            pulls = Math.abs(begins) <= Math.abs(ends);
        const aside = dot(minus(tail, known.at), known.n);
        const now = () => {
            const here = this.axes(on), size = this.sizeOf(on) / this.scale;
            if (!here || size < leastVector) return null;
            const from = along(along(here.at, pulls ? begins : ends - size, here.e), aside, here.n);
            return /** @type {[Spot, Spot]} */ ([from, along(from, size, here.e)]);
        };
        const whole = /** @type {[Spot, Spot]} */ ([tail, tip]);
        this.arrows.set(on.join(' '), {drawn: whole, now});
        view.bindArrow(node, whole, now);
    }
    /**
     * Mirrored if its sense changes.
     * @param {Element} node
     * @param {string[]} on
     */
    bindCouple(node, [place, couple]) {
        const {view} = this, drawn = this.place(place), sense = Math.sign(this.couple(couple));
        if (!drawn) return node.classList.add('still');
        view.bindings.push(() => {
            const now = this.place(place), size = this.couple(couple);
            view.show(node, now !== null && size !== 0);
            if (!now) return;
            const by = minus(now, drawn), isTurned = Math.sign(size) === -sense;
            view.transform(node, isTurned ? `matrix(-1 0 0 1 ${(by.x + 2 * drawn.x).toFixed(4)} ${by.y.toFixed(4)})` :
                `translate(${by.x.toFixed(4)} ${by.y.toFixed(4)})`);
        });
    }
    /**
     * @param {Element} node
     * @param {string[]} on
     */
    bindAxis(node, [from, to]) {
        const axis = node.querySelector(':scope > line.axis');
        if (!axis) return;
        this.places.add(from).add(to);
        this.view.bindings.push(() => {
            const [a, b] = [this.place(from), this.place(to)];
            if (a && b) this.view.setEnds(axis, a, b);
        });
    }

    // --- current shapes
    // -----------------------------------------------------------------------------------------------

    /**
     * The visible part of a line.
     * @param {Spot} at
     * @param {Spot} e
     */
    seen(at, e) {
        const [left, top, width, height] = this.view.shownRoom, rim = 1;
        let [from, to] = [-Infinity, Infinity];
        for (const [x, dx, low, high] of [
            [at.x, e.x, left + rim, left + width - rim],
            [at.y, e.y, top + rim, top + height - rim],
        ]) {
            if (dx === 0 && (x < low || x > high)) return {from: 0, to: 0};
            if (dx === 0) continue;
            const [a, b] = [(low - x) / dx, (high - x) / dx];
            from = Math.max(from, Math.min(a, b));
            to = Math.min(to, Math.max(a, b));
        }
        return {from, to};
    }
    /**
     * @param {Spot} at
     * @param {Spot} e
     * @param {number} from
     * @param {number} to
     */
    piece(at, e, from, to) {
        const seen = this.seen(at, e), [a, b] = [Math.max(from, seen.from), Math.min(to, seen.to)];
        return b - a < leastLine ? '' : [a, b].map((t, i) => `${'ML'[i]}${written(along(at, t, e))}`).join('');
    }
    /**
     * Forces with a common line of action as drawn may have several elsewhere.
     * @param {Hold} hold
     */
    linesNow({on, beyond}) {
        const middle = on.indexOf('');
        const lines = on.slice(0, middle).flatMap((force) => this.axes([force, force]) ?? []);
        const places = [...lines.map(({at}) => at), ...on.slice(middle + 1).flatMap((name) => this.place(name) ?? [])];
        const off = (/** @type {Spot} */ at, /** @type {{at: Spot, n: Spot}} */ line) =>
            Math.abs(dot(minus(at, line.at), line.n));
        const several = lines.filter(
            (line, i) =>
                !lines
                    .slice(0, i)
                    .some((known) => off(line.at, known) < sameLine && Math.abs(dot(line.e, known.n)) < 1e-3),
        );
        return several
            .map((line) => {
                const reached = places
                    .filter((at) => off(at, line) < sameLine)
                    .map((at) => dot(minus(at, line.at), line.e));
                return this.piece(line.at, line.e, Math.min(...reached) - beyond, Math.max(...reached) + beyond);
            })
            .join('');
    }
    /** @param {Hold} hold */
    segmentNow({on, beyond}) {
        const [a, b] = on.map((name) => this.place(name)), e = this.direction(on);
        return a && b && e ? this.piece(a, e, -beyond, apart(a, b) + beyond) : '';
    }
    /** @param {Hold} hold */
    wholeLineNow({form, on}) {
        const at = this.place(on[0]), e = this.direction(on);
        return at && e ? this.piece(at, form === 'normal' ? quarterTurn(e) : e, -Infinity, Infinity) : '';
    }
    /** @param {string[]} on */
    circleNow(on) {
        const [a, b] = on.map((name) => this.place(name));
        return a && b ? round({x: (a.x + b.x) / 2, y: (a.y + b.y) / 2}, apart(a, b) / 2) : '';
    }
    /** @param {string[]} on */
    arcNow(on) {
        const [centre, at] = on.map((name) => this.place(name)), radius = centre && at ? apart(centre, at) : 0;
        if (!centre || !at || radius === 0 || radius > largestRound) return '';
        const [left, top, width, height] = this.view.shownRoom;
        const isWhole = centre.x - radius > left && centre.x + radius < left + width && centre.y - radius > top &&
            centre.y + radius < top + height;
        if (isWhole) return round(centre, radius);
        const half = Math.min(Math.PI, Math.max(shortestArc / radius, 0.4)),
            toward = Math.atan2(at.y - centre.y, at.x - centre.x);
        const steps = Array.from({length: 33}, (_, i) => toward + half * (i / 16 - 1));
        const spots = steps.map((angle) => along(centre, radius, {x: Math.cos(angle), y: Math.sin(angle)}));
        return `M${spots.map(written).join('L')}`;
    }

    // --- labels ------------------------------------------------------------------------------------------------------

    /**
     * @param {Element} label
     * @param {Element[]} parts
     * @param {Spot} centre
     * @param {DOMRect} box
     */
    bindLabel(label, parts, centre, box) {
        const hold = holdOf(label), {on, form} = hold, {view} = this;
        if (hold.unit > 0) this.tellNumber(label, hold);
        if (form === 'at') this.places.add(on[0]);
        if (form === 'at' || form === 'couple') return view.bindToPlace(parts, () => this.place(on[0]));
        const ends = this.sidesOf(hold, centre), whole = this.arrows.get(on.join(' '))?.drawn ?? ends();
        if (!whole) return parts.forEach((part) => part.classList.add('still'));
        if (form === 'arrow' && hold.unit === 0) {
            view.vectorLabels.push({label, box, value: () => ends() && this.sizeOf(on) / this.inUnit, unit: this.unit});
        }
        view.bindBeside(parts, whole, ends, centre, box);
    }
    /**
     * The segment beside which a label stands. Arrows must be bound before.
     * @param {Hold} hold
     * @param {Spot} centre
     * @returns {() => [Spot, Spot] | null}
     */
    sidesOf({form, on}, centre) {
        const arrow = this.arrows.get(on.join(' ')), half = 5;
        if (arrow) return arrow.now;
        if (form === 'segment') {
            return () => {
                const [a, b] = on.map((name) => this.place(name));
                return a && b ? [a, b] : null;
            };
        }
        const axesNow = () => {
            if (form !== 'normal' && form !== 'arc') return this.axes(on);
            const at = this.place(on[form === 'arc' ? 1 : 0]), e = this.direction(on);
            return at && e ? {at, e: quarterTurn(e), n: scaledBy(-1, e)} : null;
        };
        const drawn = axesNow(), t = drawn ? dot(minus(centre, drawn.at), drawn.e) : 0;
        return () => {
            const now = axesNow();
            return now && [along(now.at, t - half, now.e), along(now.at, t + half, now.e)];
        };
    }
    /**
     * Replaces the number in a label by the current value.
     * @param {Element} label
     * @param {Hold} hold
     */
    tellNumber(label, {form, on, unit}) {
        const said = label.getAttribute('data-label') ?? '', name = said.split(' = ')[0], {view} = this;
        const glyphs = [...label.querySelectorAll('use')], count = [...name.replace(/[_^ ]/g, '')].length;
        glyphs.slice(count).forEach((glyph) => glyph.classList.add('still'));
        const kept = /** @type {SVGGraphicsElement[]} */ (glyphs.slice(0, count));
        const all = /** @type {SVGGraphicsElement} */ (label).getBBox();
        const right = Math.max(all.x, ...kept.map((glyph) => glyph.getBBox()).map(({x, width}) => x + width));
        const text = drawn(label, 'text', {class: 'number', x: right + 0.8, y: all.y + 0.75 * all.height});
        const symbol = said.slice(name.length + 3).replace(/^[−\d.,]+(?: ?· ?10\S*)? ?/, '');
        view.bindings.push(() => {
            const [a, b] = form === 'segment' || form === 'arc' ? on.map((each) => this.place(each)) : [];
            const value =
                form === 'couple'
                    ? Math.abs(this.couple(on[1])) / unit
                    : a && b
                      ? (apart(a, b) * view.scale) / unit
                      : this.sizeOf(on) / unit;
            text.textContent = `= ${view.written(Number(value.toPrecision(4)))} ${symbol}`;
        });
    }
}

/**
 * @param {Element} axis
 * @returns {[Spot, Spot]}
 */
function endsOf(axis) {
    const of = (/** @type {string} */ name) => Number(axis.getAttribute(name));
    return [{x: of('x1'), y: of('y1')}, {x: of('x2'), y: of('y2')}];
}
/** @param {Spot} at */
function written({x, y}) {
    return `${x.toFixed(4)} ${y.toFixed(4)}`;
}
/**
 * @param {Spot} centre
 * @param {number} radius
 */
function round(centre, radius) {
    if (radius < leastVector || radius > largestRound) return '';
    const [a, b] = [1, -1].map((side) => written({x: centre.x + side * radius, y: centre.y})), r = radius.toFixed(4);
    return `M${a}A${r} ${r} 0 0 1 ${b}A${r} ${r} 0 0 1 ${a}Z`;
}
