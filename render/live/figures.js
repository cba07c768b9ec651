// A figure of the sheet that follows the mechanism. Each mark of the drawing is bound once to what it moves with (a
// body, a place, a vector of the program, a line). Away from the drawn position, marks without a binding are hidden,
// since nothing may be shown that was not constructed. In the drawn position it is the sheet's figure, unchanged.

/**
 * @typedef {{name: string, origin: [number, number], places?: number, labels: string[][]}} FigureInfo
 * @typedef {{letter: string, numbers: number[]}} Segment
 * @typedef {{vectors: Map<string, number[]>, spots: Map<string, number>, lines: Map<string, {line: number, points:
 *   number[]}>}} Drawn
 * @typedef {{bodies: {id: string, label: string}[], joints: {id: string, point: number, turnsWith: number, bodies:
 *   [number, number]}[], points: {label: string}[], centres: Record<string, string>}} Names
 */

/**
 * @param {string} d
 * @returns {Segment[]}
 */
function parsePath(d) {
    return (d.match(/[MLCAZ][^MLCAZ]*/g) ?? []).map((part) => ({
        letter: part[0],
        numbers: part.slice(1).split(/[ ,]+/).filter((each) => each !== '').map(Number),
    }));
}

/**
 * @param {Segment[]} segments
 * @param {(at: Spot) => Spot} map must be rigid if there are arcs
 */
function mappedPath(segments, map) {
    const spot = (/** @type {number} */ x, /** @type {number} */ y) => {
        const at = map({x, y});
        return `${at.x.toFixed(4)} ${at.y.toFixed(4)}`;
    };
    return segments.map(({letter, numbers}) => {
        if (letter === 'A') return `A${numbers.slice(0, 5).join(' ')} ${spot(numbers[5], numbers[6])}`;
        const parts = [];
        for (let i = 0; i < numbers.length; i += 2) parts.push(spot(numbers[i], numbers[i + 1]));
        return letter + parts.join(' ');
    }).join('');
}

/**
 * The points of a path.
 * @param {Segment[]} segments
 * @returns {Spot[]}
 */
function spotsOf(segments) {
    /** @type {Spot[]} */
    const spots = [];
    for (const {letter, numbers} of segments) {
        for (let i = letter === 'A' ? 5 : 0; i + 1 < numbers.length; i += 2)
            spots.push({x: numbers[i], y: numbers[i + 1]});
    }
    return spots;
}

/** @param {Spot[]} spots */
function boxOf(spots) {
    const xs = spots.map((at) => at.x), ys = spots.map((at) => at.y);
    const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    return {left, right, top, bottom, centre: {x: (left + right) / 2, y: (top + bottom) / 2}};
}

/**
 * @param {Spot} a
 * @param {Spot} b
 * @returns {Spot}
 */
function minus(a, b) {
    return {x: a.x - b.x, y: a.y - b.y};
}
/**
 * a + t·b.
 * @param {Spot} a
 * @param {number} t
 * @param {Spot} b
 * @returns {Spot}
 */
function along(a, t, b) {
    return {x: a.x + t * b.x, y: a.y + t * b.y};
}
/**
 * @param {Spot} a
 * @param {Spot} b
 */
function apart(a, b) {
    return Math.hypot(a.x - b.x, a.y - b.y);
}

/** Points nearer than this are the same, mm. */
const samePlace = 0.02;
/** Shorter vectors are not drawn, mm. */
const leastVector = 0.05;
/** Share of an arrow that its head may take, and its least width, mm, as in render/page/shapes.cpp. */
const headShare = 0.6, leastHeadWidth = 0.35;

/** A figure of a drawing; a drawing may contain several. */
class FigureView {
    /** @type {Map<number, Drawn>} */
    plans = new Map();
    /**
     * By the name of a vector of this figure: its key in the plans.
     * @type {Map<string, string>}
     */
    keys = new Map();
    /**
     * The scale bar: valid only at the drawing's scale.
     * @type {Element[]}
     */
    measures = [];
    /** @type {(() => void)[]} */
    bindings = [];
    /** @type {{label: Element, box: DOMRect, value: () => number | null, unit: string}[]} */
    vectorLabels = [];
    /** @type {(value: number) => string} */
    written = String;
    tellsValues = false;
    /**
     * A free body stays in place: its points, and the middle of them as drawn.
     * @type {{points: number[], middle: Spot} | null}
     */
    own = null;
    /**
     * Changed attributes: the value as drawn and the current one.
     * @type {Map<Element, Map<string, {drawn: string | null, now: string | null}>>}
     */
    drawn = new Map();
    /**
     * Arrows of a polygon in drawing order; the offset of each that is drawn beside its place.
     * @type {string[]}
     */
    strokes = [];
    /** @type {Map<string, Spot>} */
    asides = new Map();
    /**
     * Labels placed after all others, so that they avoid them.
     * @type {(() => void)[]}
     */
    placings = [];
    crowd = new Crowd();
    /**
     * By point on a guide of the frame: its range of travel before and behind the drawn place, mm.
     * @type {Map<number, {from: number, to: number, drawn: Spot, e: Spot}>}
     */
    travels = new Map();
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
    isBound = false;
    saysOtherScale = false;
    /** Leaders, which move with their labels. */
    taken = new Set();

    /**
     * @param {SVGSVGElement} svg
     * @param {Element} group
     * @param {FigureInfo} info
     * @param {Motion} motion
     * @param {Names} names
     */
    constructor(svg, group, info, motion, names) {
        this.svg = svg;
        this.group = group;
        this.info = info;
        this.motion = motion;
        this.names = names;
        this.id = group.getAttribute('data-id') ?? '';
        this.unit = group.getAttribute('data-unit') ?? '';
        this.drawnScale = Number(group.getAttribute('data-scale') ?? 1);
        this.scale = this.drawnScale;
        /** A free body, or a free pin. */
        this.isFree = /^(body|pin)-/.test(info.name);
        const isHeld = this.isFree || /^(lines-|curvature-|joukowsky$)/.test(info.name);
        this.isMechanism =
            ['mechanism', 'centres', 'velocities'].includes(info.name) || (isHeld && info.name !== 'joukowsky');
        /** Units of the quantity for a mm of a vector; a drawing of the mechanism may show vectors. */
        this.vectorScale = this.drawnScale;
        if (this.isMechanism) this.drawnScale = this.scale = info.places ?? 1;
        this.origin = this.isMechanism || isHeld ? {x: info.origin[0], y: info.origin[1]} : this.poleOf();
        /** The marks with a data-on attribute. */
        this.held = isHeld ? new HeldMarks(this) : null;
        if (this.held?.isLever) this.drawnScale = this.scale;
        this.drawnOrigin = this.origin;
        /** The visible area of the drawing: left, top, width, height. */
        this.shownRoom = (svg.getAttribute('viewBox') ?? '').split(' ').map(Number);
        this.viewBox = (svg.getAttribute('viewBox') ?? '').split(' ').map(Number);
        /**
         * The area for a polygon that fills its space: if it was drawn flat, or beside a detail, its shape may differ
         * elsewhere.
         */
        this.fitRoom = this.isMechanism || isHeld ? this.viewBox : wellShaped(this.viewBox);
        const figure = svg.closest('figure');
        this.note = /** @type {HTMLElement} */ (figure?.querySelector('.note'));
        this.captionOfScale = /** @type {HTMLElement | null} */ (figure?.querySelector('.scale'));
    }

    /** Whether the figure can follow the mechanism. */
    get follows() {
        if (this.isMechanism || this.held) return this.scale > 0;
        return this.keys.size > 0 && ![...this.keys.values()].includes('');
    }
    /** Whether the figure depends on a construction, not on the position only. */
    get isConstructed() {
        return !this.isMechanism || this.held !== null;
    }
    /** Units for a mm, now and as drawn; of Joukowsky's lever for velocities and forces. */
    get scales() {
        const {held, unit, scale, drawnScale} = this, forces = held && held.forces.length > 0 ?
            [{now: held.scale / held.inUnit, drawn: held.drawnScale / held.inUnit, unit: held.unit}] : [];
        if (this.isFree) return forces;
        const own = held?.isLever
            ? Number(this.group.getAttribute('data-scale'))
            : this.isMechanism
              ? this.vectorScale
              : drawnScale;
        return [{now: (own * scale) / drawnScale, drawn: own, unit}, ...forces];
    }
    get caption() {
        return this.group.querySelector('title')?.textContent ?? '';
    }
    /**
     * The pole of a polygon, computed from its vectors.
     * @returns {Spot}
     */
    poleOf() {
        /** @type {{name: string, key: string, x: number, y: number}[]} */
        const told = [];
        for (const node of this.group.querySelectorAll(':scope > g.vector')) {
            const name = node.getAttribute('data-name') ?? '', axis = node.querySelector('line.axis');
            for (const [key, [element]] of this.vectorsOf(0)) {
                const tail = axis && key.split('#')[0] === name ? this.motion.spot(element) : null;
                if (!axis || !tail) continue;
                const x = Number(axis.getAttribute('x1')) - tail.x / this.scale,
                    y = Number(axis.getAttribute('y1')) + tail.y / this.scale;
                told.push({name, key, x, y});
            }
        }
        // Two polygons may be of one body: the pole on which most vectors agree is the right one.
        const agreeing = told.map((one) => told.filter((other) => apart(one, other) < 0.05));
        const most = agreeing.reduce((best, each) => each.length > best.length ? each : best, []);
        // A vector drawn slightly beside its place, so that it does not cover another, is identified by its name.
        told.forEach(({name, key}) => this.keys.set(name, this.keys.has(name) ? '' : key));
        most.forEach(({name, key}) => this.keys.set(name, key));
        return most.length > 0 ? {x: most[0].x, y: most[0].y} : {x: 0, y: 0};
    }

    /**
     * The point at which the mechanism shows a vector: v_B at B; −1: none.
     * @param {string} name
     */
    pointOf(name) {
        return this.names.points.findIndex(({label}) => label === name.slice(2).replace('*', ''));
    }

    // --- positions
    // ----------------------------------------------------------------------------------------------------

    /**
     * Converts SI to mm on paper.
     * @param {Spot} at
     * @returns {Spot}
     */
    paper(at) {
        return {x: this.origin.x + at.x / this.scale, y: this.origin.y - at.y / this.scale};
    }
    /**
     * The same for the figure as drawn.
     * @param {Spot} at
     * @returns {Spot}
     */
    drawnPaper(at) {
        return {x: this.drawnOrigin.x + at.x / this.drawnScale, y: this.drawnOrigin.y - at.y / this.drawnScale};
    }
    /**
     * The elements that a plan draws in this figure, by name.
     * @param {number} plan
     */
    drawnBy(plan) {
        let found = this.plans.get(plan);
        if (found) return found;
        const own = this.isMechanism ? '' : this.id, drawn = this.motion.data.plans[plan];
        const from = this.info.name === 'velocities' ? 'velocity' : this.id;
        const vectors = drawn?.vectors ?? [], spots = drawn?.spots ?? [], lines = drawn?.lines ?? [];
        found = {
            vectors: new Map(),
            spots: new Map(spots.filter(([figure]) => figure === own).map(([, name, point]) => [name, point])),
            lines: new Map(
                lines.filter(([figure]) => figure === own).map(([, name, , line, ...points]) => [name, {line, points}]),
            ),
        };
        for (const [figure, name, tail, tip] of vectors) {
            if (figure !== from) continue;
            let key = name;
            const known = found.vectors.get(name);
            if (known && known[0] === tail && known[1] === tip) continue;  // of two bodies with a common point
            for (let k = 1; found.vectors.has(key); ++k) key = `${name}#${k}`;
            found.vectors.set(key, [tail, tip]);
        }
        this.plans.set(plan, found);
        return found;
    }
    /**
     * Tail and tip of the vectors of a plan, by name.
     * @param {number} plan
     */
    vectorsOf(plan) {
        return this.drawnBy(plan).vectors;
    }
    /**
     * Tail and tip on paper, in the current position.
     * @param {string} name
     * @returns {[Spot, Spot] | null}
     */
    vector(name) {
        const found = this.vectorsOf(this.motion.plan).get(this.keys.get(name) ?? name);
        const tail = found && this.motion.spot(found[0]), tip = found && this.motion.spot(found[1]);
        if (!tail || !tip) return null;
        if (!this.isMechanism) return [this.paper(tail), this.paper(tip)];
        const point = this.pointOf(name), by = minus(tip, tail);
        if (point < 0) return null;
        const from = this.point(point);
        return [from, {x: from.x + by.x / this.vectorScale, y: from.y - by.y / this.vectorScale}];
    }
    /**
     * A vertex or a centre, on paper.
     * @param {string} name
     * @returns {Spot | null}
     */
    spot(name) {
        const element = this.drawnBy(this.motion.plan).spots.get(name);
        const at = element === undefined ? null : this.motion.spot(element);
        return at && this.paper(at);
    }
    /**
     * The points through which a construction line was drawn, and its direction.
     * @param {string} name
     * @returns {{points: Spot[], direction: Spot} | null}
     */
    line(name) {
        const {motion} = this, found = this.drawnBy(motion.plan).lines.get(name);
        if (!found) return null;
        const points = found.points.map((element) => motion.spot(element)).filter((at) => at !== null);
        const replay = motion.replays[motion.plan], element = found.line;
        const direction = {x: -replay.y(element), y: -replay.x(element)};  // y downwards
        if (points.length === 0 || (direction.x === 0 && direction.y === 0)) return null;
        return {points: points.map((at) => this.paper(/** @type {Spot} */ (at))), direction: unitOf(direction)};
    }
    /**
     * @param {number} point
     * @returns {Spot}
     */
    point(point) {
        return this.paper(this.motion.read.points[point]);
    }

    // --- following ---------------------------------------------------------------------------------------------------

    /** Shows the figure as drawn. */
    restore() {
        for (const [node, attributes] of this.drawn) {
            for (const [name, known] of attributes) {
                if (known.now === known.drawn) continue;
                known.now = known.drawn;
                if (known.drawn === null) node.removeAttribute(name);
                else node.setAttribute(name, known.drawn);
            }
        }
        this.scale = this.drawnScale;
        this.origin = this.drawnOrigin;
        this.svg.setAttribute('viewBox', this.viewBox.join(' '));
        this.shownRoom = this.viewBox;
        this.svg.classList.remove('moved');
    }
    /**
     * Follows the mechanism; `room`: the area that it may cover.
     * @param {number[]} room
     * @param {{scale: number, origin: Spot}} to
     */
    follow(room, to = {scale: this.drawnScale, origin: this.drawnOrigin}) {
        this.scale = to.scale;
        this.origin = to.origin;
        const isAsDrawn = to.scale === this.drawnScale && this.held?.scale === this.held?.drawnScale;
        for (const node of this.measures) this.show(node, isAsDrawn);
        if (room !== this.shownRoom || !this.svg.matches('.moved')) {
            this.svg.setAttribute('viewBox', room.map((each) => each.toFixed(3)).join(' '));
            this.svg.classList.add('moved');
            this.shownRoom = room;
        }
        if (this.isMechanism) this.measuresToRim(room);
        this.stayInPlace();
        setSideBySide(this);
        this.crowd.clear(this.held ? [...this.held.arrows.values()].flatMap(({now}) => [now() ?? []]) :
            [...this.keys.keys()].map((name) => this.drawnVector(name) ?? []));
        for (const update of [...this.bindings, ...this.placings]) update();
    }
    /**
     * Where a vector is drawn: in its place, or beside it.
     * @param {string} name
     * @returns {[Spot, Spot] | null}
     */
    drawnVector(name) {
        const at = this.vector(name), by = this.asides.get(name);
        return at && by ? [along(at[0], 1, by), along(at[1], 1, by)] : at;
    }
    /**
     * Moves the scale bar to the corner of the visible area, away from the mechanism.
     * @param {number[]} room
     */
    measuresToRim([x, y, , height]) {
        const [bar] = this.measures;
        if (!bar || this.svg.querySelectorAll('g.figure').length > 1) return;
        const {left, bottom} = boxOf(spotsOf(parsePath(this.known(bar, 'd').drawn ?? '')));
        const isWidened = x !== this.viewBox[0] || y !== this.viewBox[1] || height !== this.viewBox[3];
        for (const node of this.measures)
            this.translate(node, isWidened ? {x: x + 3 - left, y: y + height - 2 - bottom} : {x: 0, y: 0});
    }
    /** A free body turns, but stays in place. */
    stayInPlace() {
        if (this.own) this.origin = along(this.origin, 1, minus(this.own.middle, this.middleOf(this.own.points)));
    }
    /**
     * On paper.
     * @param {number[]} points
     */
    middleOf(points) {
        const sum = points.map((point) => this.point(point)).reduce((all, each) => along(all, 1, each), {x: 0, y: 0});
        return scaledBy(1 / points.length, sum);
    }
    /**
     * @param {Element} node
     * @param {string} name
     * @param {string} value
     */
    set(node, name, value) {
        const known = this.known(node, name);
        if (known.now === value) return;
        known.now = value;
        node.setAttribute(name, value);
    }
    /**
     * @param {Element} node
     * @param {string} name
     */
    known(node, name) {
        let all = this.drawn.get(node);
        if (!all) this.drawn.set(node, all = new Map());
        let known = all.get(name);
        if (!known) {
            const drawn = node.getAttribute(name);
            all.set(name, known = {drawn, now: drawn});
        }
        return known;
    }
    /**
     * @param {Element} node
     * @param {boolean} visible
     */
    show(node, visible) {
        this.set(node, 'visibility', visible ? 'inherit' : 'hidden');
    }
    /**
     * Set before the node's own transform.
     * @param {Element} node
     * @param {string} transform
     */
    transform(node, transform) {
        const known = this.drawn.get(node)?.get('transform'),
            own = known ? known.drawn : node.getAttribute('transform');
        this.set(node, 'transform', own ? `${transform} ${own}` : transform);
    }
    /**
     * @param {Element} node
     * @param {Spot} by
     */
    translate(node, by) {
        this.transform(node, `translate(${by.x.toFixed(4)} ${by.y.toFixed(4)})`);
    }

    // --- binding, in the drawn position ------------------------------------------------------------------------------

    /** Call once, in the drawn position, while the figure is visible. */
    bind() {
        if (this.isBound) return;
        this.isBound = true;
        this.bindHeld();
        this.bindLabels();
        for (const node of [...this.svg.children, ...this.group.children]) this.bindScaleBar(node);
        for (const node of this.group.children) {
            if (this.taken.has(node)) continue;
            if (node.tagName === 'g' && this.isMechanism) this.bindRole(node);
            else if (node.matches('g.vector')) this.bindVector(node);
            else if (node.matches('g.figure')) node.classList.add('still');
            else if (node.tagName === 'path') this.bindPath(node);
            else if (node.matches('g.text:not(.label ~ .text)')) this.measures.push(node);
        }
    }

    /** Binds the marks with a data-on attribute; of a free body also its own marks. */
    bindHeld() {
        const {held, names, motion} = this;
        if (!held) return;
        if (this.isFree) {
            const labels = [...this.group.querySelectorAll('g.label')].map(
                (each) => each.getAttribute('data-label') ?? '',
            );
            const said = new Set(labels.flatMap((each) => each.split(' ≡ ')));
            const body = names.bodies.findIndex(({id}) => this.info.name === `body-${id}`);
            const points = names.points.flatMap(({label}, i) =>
                motion.data.points[i][0] === body || said.has(label) ? [i] : []);
            this.own = points.length > 0 ? {points, middle: this.middleOf(points)} : null;
        }
        for (const node of this.group.querySelectorAll('[data-on]:not(.label, .text)')) {
            if (node.parentElement?.closest('[data-on]')) continue;
            this.taken.add(node);
            held.bind(node);
        }
    }

    /**
     * Beside the figures of a drawing: a half-filled bar, its outline and its label.
     * @param {Element} node
     */
    bindScaleBar(node) {
        const d = node.tagName === 'path' && node.getAttribute('fill') !== 'none' ? node.getAttribute('d') ?? '' : '';
        const spots = /^M[^A]*Z$/.test(d) ? spotsOf(parsePath(d)) : [], box = boxOf(spots);
        if (spots.length !== 4 || box.bottom - box.top > 2) return;
        for (let next = node, k = 0; next && k < 4; next = /** @type {Element} */ (next.nextElementSibling), ++k)
            this.measures.push(next);
    }
    /** @param {Element} node */
    bindVector(node) {
        const name = node.getAttribute('data-name') ?? '',
            axis = node.querySelector('line.axis'),
            place = this.vector(name);
        if (!place || apart(place[0], place[1]) < leastVector) return node.classList.add('still');
        if (this.isMechanism || !axis) return this.bindArrow(node, place, () => this.vector(name));
        const drawn = endsOf(axis);
        if (node.querySelector('path:not([fill=none])')) this.strokes.push(name);
        this.bindLeads(name, place, drawn);
        this.bindArrow(node, drawn, () => this.drawnVector(name));
    }
    /**
     * Thin lines lead from the ends of a vector's place to where it is drawn.
     * @param {string} name
     * @param {[Spot, Spot]} place
     * @param {[Spot, Spot]} drawn
     */
    bindLeads(name, place, drawn) {
        if (apart(place[0], drawn[0]) < samePlace) return;
        for (const node of this.group.querySelectorAll(':scope > path')) {
            const [from, to, more] = spotsOf(parsePath(node.getAttribute('d') ?? ''));
            const end = [0, 1].find(
                (i) => to && !more && apart(from, place[i]) < samePlace && apart(to, drawn[i]) < samePlace,
            );
            if (end === undefined || this.taken.has(node)) continue;
            this.taken.add(node);
            this.bindings.push(() => {
                const at = this.vector(name), by = this.asides.get(name);
                this.show(node, by !== undefined && at !== null);
                if (at && by) this.set(node, 'd', `M${written(at[end])}L${written(along(at[end], 1, by))}`);
            });
        }
    }
    /**
     * The head of an arrow, and the width of its shaft.
     * @param {Element} node
     */
    headOf(node) {
        const isHead = (/** @type {Element} */ path) => path.getAttribute('fill') !== 'none';
        /** @type {Element[]} */
        const all = node.tagName === 'path' ? [node] : [...node.querySelectorAll('path')];
        const [tip, left, , right] = all
            .filter(isHead)
            .flatMap((path) => spotsOf(parsePath(path.getAttribute('d') ?? '')));
        const shaft = Number(all.find((path) => !isHead(path))?.getAttribute('stroke-width') ?? 0);
        return right
            ? {length: apart(tip, along(left, 0.5, minus(right, left))), width: apart(left, right), shaft}
            : null;
    }
    /**
     * The full head of an arrow that was too short for it, taken from another arrow of the drawing.
     * @param {Element} node
     * @param {number} length
     */
    wholeHeadOf(node, length) {
        const own = this.headOf(node), others = [...this.svg.querySelectorAll(`g.${node.classList[0]}`)];
        if (!own || own.length < 0.99 * headShare * length) return own;
        return others
            .flatMap((each) => this.headOf(each) ?? [])
            .reduce((most, each) => (each.length > most.length ? each : most), own);
    }
    /**
     * The arrow's head and shaft keep their shape at any length.
     * @param {Element} node an arrow, or a stroke of one
     * @param {[Spot, Spot]} drawn
     * @param {() => [Spot, Spot] | null} place
     */
    bindArrow(node, drawn, place) {
        const [tail, tip] = drawn, length = apart(tail, tip), local = localOf(tail, tip);
        const all = node.tagName === 'path' ? [node] : [...node.querySelectorAll('path')];
        const paths = all.map((path) => ({path, segments: parsePath(path.getAttribute('d') ?? '')}));
        const own = this.headOf(node), full = this.wholeHeadOf(node, length), head = own?.length ?? 0;
        const axis = node.querySelector('line.axis');
        this.bindings.push(() => {
            const now = place(), size = now ? apart(now[0], now[1]) : 0;
            this.show(node, size >= leastVector);
            if (!now || size < leastVector) return;
            const toward = unitOf(minus(now[1], now[0])), across = quarterTurn(toward);
            const share = full ? Math.min(1, headShare * size / full.length) : 1;
            const wide = full ? full.width * Math.max(share, leastHeadWidth) : 1;
            const [long, broad] = own && full ? [share * full.length / head, wide / own.width] : [1, 1];
            const map = (/** @type {Spot} */ at) => {
                const {t, n: side} = local(at), atTail = t < 0.01 || length - t > head + 1;
                const from = atTail ? now[0] : now[1];
                return along(
                    along(from, atTail ? t : long * (t - length), toward),
                    (atTail ? 1 : broad) * side,
                    across,
                );
            };
            for (const {path, segments} of paths) {
                this.set(path, 'd', mappedPath(segments, map));
                if (full && path.getAttribute('fill') === 'none')
                    this.set(path, 'stroke-width', String(Math.min(full.shaft, 0.5 * wide)));
            }
            if (axis) this.setEnds(axis, ...now);
        });
    }
    /**
     * @param {Element} axis
     * @param {Spot} from
     * @param {Spot} to
     */
    setEnds(axis, from, to) {
        this.set(axis, 'x1', from.x.toFixed(6));
        this.set(axis, 'y1', from.y.toFixed(6));
        this.set(axis, 'x2', to.x.toFixed(6));
        this.set(axis, 'y2', to.y.toFixed(6));
    }

    /**
     * A single stroke: a construction line, a disc at a vertex, the scale bar.
     * @param {Element} node
     */
    bindPath(node) {
        const segments = parsePath(node.getAttribute('d') ?? '');
        const spots = spotsOf(segments), box = boxOf(spots);
        const name = this.vertexAt(box.centre);
        if (segments.some(({letter}) => letter === 'A') && name !== null) {
            const drawn = box.centre;
            this.bindings.push(() => {
                const now = this.spot(name);
                this.show(node, now !== null);
                if (now) this.translate(node, minus(now, drawn));
            });
        } else if (spots.length === 2 && node.hasAttribute('data-statement')) {
            this.bindLine(node, segments, spots);
        } else if (node.hasAttribute('data-statement')) {
            node.classList.add('still');
        } else {
            this.measures.push(node);
        }
    }
    /** @param {Spot} at */
    vertexAt(at) {
        const own = this.isMechanism ? '' : this.id;
        for (const [figure, name] of this.motion.data.plans[0].spots) {
            const spot = figure === own ? this.spot(name) : null;
            if (spot && apart(spot, at) < samePlace) return name;
        }
        return null;
    }
    /**
     * The construction line through all of the points.
     * @param {Spot[]} spots
     * @param {string | null} statement
     */
    lineThrough(spots, statement) {
        const own = this.isMechanism ? '' : this.id;
        for (const [figure, name, said] of this.motion.data.plans[0].lines) {
            if (figure !== own || (statement !== null && String(said) !== statement)) continue;
            const line = this.line(name);
            if (!line) continue;
            const off = (/** @type {Spot} */ at) =>
                Math.abs(dot(minus(at, line.points[0]), quarterTurn(line.direction)));
            if (spots.every((at) => off(at) < samePlace)) return {name, line};
        }
        return null;
    }
    /**
     * @param {Element} node
     * @param {Segment[]} segments
     * @param {Spot[]} spots
     */
    bindLine(node, segments, spots) {
        const found = this.lineThrough(spots, node.closest('[data-statement]')?.getAttribute('data-statement') ?? null);
        if (!found) return this.bindBetweenVertices(node, segments, spots);
        const {name, line} = found;
        const ends = spots.map((at) => {
            const distances = line.points.map((point) => apart(point, at));
            const nearest = distances.indexOf(Math.min(...distances));
            return {nearest, beyond: dot(minus(at, line.points[nearest]), line.direction)};
        });
        const sense = Math.sign(dot(minus(line.points[line.points.length - 1], line.points[0]), line.direction));
        this.bindings.push(() => {
            const now = this.line(name);
            const fits = now !== null && ends.every(({nearest}) => nearest < now.points.length);
            this.show(node, fits);
            if (!fits) return;
            // If the points change their order along the line, so do its ends.
            const turned =
                Math.sign(dot(minus(now.points[now.points.length - 1], now.points[0]), now.direction)) * sense < 0
                    ? -1
                    : 1;
            const places = ends.map(({nearest, beyond}) => along(now.points[nearest], turned * beyond, now.direction));
            let next = 0;
            this.set(node, 'd', mappedPath(segments, () => places[next++]));
        });
    }

    /**
     * The image of a link whose points are collinear: it goes from vertex to vertex.
     * @param {Element} node
     * @param {Segment[]} segments
     * @param {Spot[]} spots
     */
    bindBetweenVertices(node, segments, spots) {
        const names = spots.flatMap((at) => this.vertexAt(at) ?? []);
        if (names.length < spots.length) return node.classList.add('still');
        this.bindings.push(() => {
            const places = names.flatMap((name) => this.spot(name) ?? []);
            this.show(node, places.length === names.length);
            let next = 0;
            if (places.length === names.length) this.set(node, 'd', mappedPath(segments, () => places[next++]));
        });
    }

    // --- labels ------------------------------------------------------------------------------------------------------

    bindLabels() {
        this.bindLabelsOfDetails();
        const isDetailed = this.svg.querySelector('[data-figure=detail]') !== null;
        [...this.svg.querySelectorAll('g.label')].forEach((label, i) => {
            if (label.closest('.dimension') || label.closest('g.figure') !== this.group) return;
            const told = this.info.labels[i] ?? [],
                names = told.length > 0 ? told : [label.getAttribute('data-label') ?? ''];
            const box = /** @type {SVGGElement} */ (label).getBBox();
            const centre = {x: box.x + box.width / 2, y: box.y + box.height / 2};
            const parts = this.partsOf(label, centre);
            if (isDetailed && /^[IVX]+$/.test(names[0])) return parts.forEach((part) => part.classList.add('still'));
            if (this.held && label.hasAttribute('data-on')) return this.held.bindLabel(label, parts, centre, box);
            this.cutNumber(label);
            const vector = names.find((name) => this.vector(name));
            const spot = names.find((name) => this.spot(name));
            if (vector !== undefined)
                this.vectorLabels.push({label, box, value: () => this.sizeOf(vector), unit: this.unit});
            if (vector !== undefined) this.bindVectorLabel(parts, vector, centre, box);
            else if (spot !== undefined && !this.isMechanism)
                this.bindAround(parts, () => this.spot(spot), centre, box);
            else if (spot !== undefined) this.bindToPlace(parts, () => this.spot(spot));
            else if (this.isMechanism) this.bindMechanismLabel(label, parts, centre);
            else this.bindLineLabel(label, centre);
        });
    }
    /**
     * The label of a mark repeated in a detail stands in the detail. Away from the drawn position there is no detail,
     * so a copy of the label stands here.
     */
    bindLabelsOfDetails() {
        if (this.isMechanism || this.held) return;
        const all = [...this.svg.querySelectorAll('g.label')], own = new Set(all.flatMap((label, i) =>
            label.closest('g.figure') === this.group ? this.info.labels[i] ?? [] : []));
        all.forEach((label, i) => {
            const detail = label.closest('g.figure[data-figure=detail]')?.getAttribute('data-id') ?? '';
            const vector = (this.info.labels[i] ?? []).find(
                (name) => this.keys.has(name) && !own.has(name) && this.vector(name),
            );
            if (vector === undefined || !detail.startsWith(`${this.id}-detail`)) return;
            own.add(vector);
            const copy = /** @type {SVGGElement} */ (label.cloneNode(true)),
                box = /** @type {SVGGElement} */ (label).getBBox();
            copy.classList.add('number');  // shown only away from the drawn position
            copy.classList.remove('label');
            this.group.append(copy);
            this.bindVectorLabel([copy], vector, {x: box.x + box.width / 2, y: box.y + box.height / 2}, box);
        });
    }
    /**
     * The label, its parts in other colours, and its circle.
     * @param {Element} label
     * @param {Spot} centre
     */
    partsOf(label, centre) {
        const parts = [label];
        for (let next = label.nextElementSibling; next?.matches('g.text'); next = next.nextElementSibling)
            parts.push(next);
        const before = label.previousElementSibling;
        if (before?.tagName === 'path') {
            const box = boxOf(spotsOf(parsePath(before.getAttribute('d') ?? '')));
            if (apart(box.centre, centre) < 1.5 && box.right - box.left < 8) parts.push(before);
        }
        for (const part of this.leaderBefore(parts[parts.length - 1], centre)) {
            parts.push(part);
            this.taken.add(part);
        }
        return parts;
    }
    /**
     * The line from a label to what it names, and the dot at its end.
     * @param {Element} first of the label
     * @param {Spot} centre
     * @returns {Element[]}
     */
    leaderBefore(first, centre) {
        const dot = first.matches('g.text') ? null : first.previousElementSibling, line = dot?.previousElementSibling;
        if (dot?.tagName !== 'path' || line?.tagName !== 'path') return [];
        const ends = spotsOf(parsePath(line.getAttribute('d') ?? '')),
            end = boxOf(spotsOf(parsePath(dot.getAttribute('d') ?? '')));
        const isLeader = end.right - end.left < 1.2 && ends.length === 2 && apart(end.centre, ends[0]) < samePlace;
        return isLeader && apart(ends[1], centre) < apart(ends[0], centre) ? [dot, line] : [];
    }
    /**
     * @param {Element[]} parts
     * @param {() => Spot | null} place
     */
    bindToPlace(parts, place) {
        const drawn = place();
        if (!drawn) return parts.forEach((part) => part.classList.add('still'));
        this.bindings.push(() => {
            const now = place();
            for (const part of parts) {
                this.show(part, now !== null);
                if (now) this.translate(part, minus(now, drawn));
            }
        });
    }
    /**
     * A vertex's label: it keeps its distance, and goes to a side where it can be read.
     * @param {Element[]} parts
     * @param {() => Spot | null} place
     * @param {Spot} centre
     * @param {{width: number, height: number}} box
     */
    bindAround(parts, place, centre, box) {
        const drawn = place();
        if (!drawn) return parts.forEach((part) => part.classList.add('still'));
        const off = minus(centre, drawn), x = box.width / 2 + 1.2, y = box.height / 2 + 1.2;
        const sides = [off, {x: -off.x, y: off.y}, {x: off.x, y: -off.y}, {x: -off.x, y: -off.y},
            {x, y: 0}, {x: -x, y: 0}, {x: 0, y}, {x: 0, y: -y}];
        this.placeLabel(parts, centre, box, () => {
            const now = place();
            return now ? sides.map((by) => along(now, 1, by)) : [];
        });
    }
    /**
     * Puts the label where it hides least; if there is no place, hides it.
     * @param {Element[]} parts
     * @param {Spot} centre
     * @param {{width: number, height: number}} box
     * @param {() => Spot[]} placesNow
     */
    placeLabel(parts, centre, box, placesNow) {
        this.placings.push(() => {
            const places = placesNow();
            parts.forEach((part) => this.show(part, places.length > 0));
            if (places.length === 0) return;
            const by = minus(this.crowd.best(places, box), centre);
            parts.forEach((part) => this.translate(part, by));
        });
    }
    /**
     * The label keeps its side of the vector and its distance from it.
     * @param {Element[]} parts
     * @param {string} name
     * @param {Spot} centre
     * @param {{width: number, height: number}} box
     */
    bindVectorLabel(parts, name, centre, box) {
        const place = /** @type {[Spot, Spot]} */ (this.vector(name));
        if (apart(...place) < leastVector) return this.bindToPlace(parts, () => this.vector(name)?.[0] ?? null);
        const axis = this.isMechanism
            ? null
            : this.group.querySelector(`:scope > g.vector[data-name="${name}"] > line.axis`);
        this.bindBeside(parts, axis ? endsOf(axis) : place, () => this.drawnVector(name), centre, box);
    }
    /**
     * The label keeps its side and its distance while it can be read there.
     * @param {Element[]} parts
     * @param {[Spot, Spot]} drawn
     * @param {() => [Spot, Spot] | null} place
     * @param {Spot} centre
     * @param {{width: number, height: number}} box
     */
    bindBeside(parts, drawn, place, centre, box) {
        // A leader started where the label was.
        for (const part of parts) if (this.taken.has(part)) part.classList.add('still');
        const middle = (/** @type {[Spot, Spot]} */ [tail, tip]) => ({
            x: (tail.x + tip.x) / 2,
            y: (tail.y + tip.y) / 2,
        });
        const reach = (/** @type {Spot} */ n) => (Math.abs(n.x) * box.width) / 2 + (Math.abs(n.y) * box.height) / 2;
        const length = apart(drawn[0], drawn[1]);
        const e = unitOf(minus(drawn[1], drawn[0])),
            n = quarterTurn(e),
            off = minus(centre, middle(drawn));
        const side = Math.sign(dot(off, n)) || 1,
            share = dot(off, e) / length,
            clearance = Math.abs(dot(off, n)) - reach(n);
        // Beyond an end of a short vector, or at a leader, it would be far from a long one or on it.
        const near = Math.min(Math.max(share, -0.4), 0.4), close = Math.min(Math.max(clearance, 0.8), 2.5);
        const isNear = Math.hypot(off.x, off.y) < length / 2 + 25;  // otherwise it was in a detail
        const sides = [near, 0, 0.3, -0.3].flatMap((part) => [{part, across: side}, {part, across: -side}]);
        this.placeLabel(parts, centre, box, () => {
            const now = place(), size = now ? apart(now[0], now[1]) : 0;
            if (!now || size < leastVector) return [];
            const toward = unitOf(minus(now[1], now[0])),
                across = quarterTurn(toward);
            const beside = (/** @type {number} */ t, /** @type {number} */ by) =>
                along(along(middle(now), t * size, toward), by, across);
            const isAsDrawn = isNear && apart(minus(now[1], now[0]), minus(drawn[1], drawn[0])) < samePlace;
            return isAsDrawn ? [beside(share, side * (clearance + reach(across)))] :
                sides.map((each) => beside(each.part, each.across * (close + reach(across))));
        });
    }
    /**
     * Shows or hides the value of each vector beside its name.
     * @param {boolean} isOn
     * @param {(value: number) => string} written
     */
    showValues(isOn, written) {
        if (!isOn && !this.tellsValues) return;
        this.tellsValues = isOn;
        for (const {label, box, value, unit} of this.vectorLabels) {
            let text = label.querySelector('text');
            if (!isOn) {
                text?.remove();
                continue;
            }
            text ??= /** @type {SVGTextElement} */ (
                drawn(label, 'text', {x: box.x + box.width + 0.6, y: box.y + 0.75 * box.height})
            );
            const size = value();
            text.textContent = size === null ? '' : `= ${written(Number(size.toPrecision(4)))} ${unit}`;
        }
    }
    /**
     * The magnitude of a vector in this position, in the figure's unit.
     * @param {string} name
     */
    sizeOf(name) {
        const ends = this.vector(name);
        return ends && apart(...ends) * (this.isMechanism ? this.vectorScale : this.scale);
    }
    /**
     * Text along a construction line.
     * @param {Element} label
     * @param {Spot} drawnCentre
     */
    bindLineLabel(label, drawnCentre) {
        const pivot = (label.getAttribute('transform') ?? '').match(/rotate\((\S+) (\S+) (\S+)\)/);
        const centre = pivot ? {x: Number(pivot[2]), y: Number(pivot[3])} : drawnCentre;
        const statement = label.closest('[data-statement]')?.getAttribute('data-statement') ?? null;
        if (statement === null) return;
        let best = null, least = 6;
        for (const [figure, name, said] of this.motion.data.plans[0].lines) {
            const line = figure === this.id && String(said) === statement ? this.line(name) : null;
            const off = line ? Math.abs(dot(minus(centre, line.points[0]), quarterTurn(line.direction))) : least;
            if (line && off < least) [best, least] = [{name, line}, off];
        }
        if (!best) return label.classList.add('still');
        const {name, line} = best;
        const last = line.points.length - 1,
            from = line.points[last];
        const t = dot(minus(centre, from), line.direction),
            n = dot(minus(centre, from), quarterTurn(line.direction));
        const size = /** @type {SVGGElement} */ (label).getBBox(),
            steps = [0, 1, 2, -1, -2].map((k) => k * (size.width / 2 + 1));
        this.placings.push(() => {
            const now = this.line(name);
            const fits = now !== null && last < now.points.length;
            this.show(label, fits);
            if (!fits) return;
            const across = quarterTurn(now.direction), places = steps.flatMap((step) => [n, -n].map((side) =>
                along(along(now.points[last], t + step, now.direction), side, across)));
            const {x: c, y: s} = pivot ? now.direction : {x: 1, y: 0};
            const at = this.crowd.best(places, {width: Math.abs(c) * size.width + Math.abs(s) * size.height,
                height: Math.abs(s) * size.width + Math.abs(c) * size.height});
            const degrees = (/** @type {Spot} */ a) => Math.atan2(a.y, a.x) * 180 / Math.PI;
            const own = pivot ? Number(pivot[1]) : 0;
            let turn = degrees(now.direction) - degrees(line.direction);
            const upright = ((own + turn) % 360 + 540) % 360 - 180;  // −180 … 180
            if (Math.abs(upright) > 90) turn += 180;
            this.transform(label, `translate(${(at.x - centre.x).toFixed(4)} ${(at.y - centre.y).toFixed(4)}) ` +
                                      `rotate(${turn.toFixed(3)} ${centre.x} ${centre.y})`);
        });
    }

    // --- the mechanism -----------------------------------------------------------------------------------------------

    /**
     * A group of marks, by its role.
     * @param {Element} group
     */
    bindRole(group) {
        const role = group.getAttribute('class') ?? '';
        if (role === 'dimensions') return group.classList.add('still');
        if (role === 'vector') return this.bindVector(group);
        if (role === 'label' || role === 'text') return;
        for (const node of group.children) {
            if (this.taken.has(node)) continue;
            if (node.matches('g.vector')) this.bindVector(node);
            else if (role === 'links') this.bindLink(node);
            else if (role === 'tint') this.bindTint(node);
            else if (role === 'joints') this.bindJoint(node);
            else if (role === 'centres') this.bindCentre(node);
            else if (role === 'construction') this.bindGuide(node);
            else if (role === 'ground' && node.tagName === 'g') node.classList.add('still');
            else if (role === 'ground') this.bindToGround(node, 15);
            else if (role === 'arrows' && node.hasAttribute('data-statement')) node.classList.add('still');
            else if (role === 'arrows' && !this.bindToGround(node, 16)) node.classList.add('still');
        }
    }
    /**
     * Moves a node with a body.
     * @param {Element} node
     * @param {number} body
     */
    bindToBody(node, body) {
        if (body <= 0) return;
        const {places, data, givens} = this.motion, [rx, ry] = givens.drawn.bodies[body];
        const all = node.tagName === 'path' ? [node] : [...node.querySelectorAll('path')];
        const paths = all.map((path) => ({path, d: path.getAttribute('d') ?? ''}));
        let wasShaped = false;
        this.bindings.push(() => {
            const shape = givens.shapes[body], {x: c, y: s} = places.facing[body];
            if (shape || wasShaped) {
                for (const {path, d} of paths)
                    this.set(path, 'd', shape ? mappedPath(parsePath(d), (at) => this.shaped(body, at)) : d);
            }
            wasShaped = shape !== null;
            if (shape) return this.set(node, 'transform', '');
            const from = this.drawnPaper({x: data.unit * rx, y: data.unit * ry});
            const to = this.paper({x: data.unit * places.at[body].x, y: data.unit * places.at[body].y});
            const e = to.x - c * from.x - s * from.y, f = to.y + s * from.x - c * from.y;
            this.transform(node, `matrix(${[c, -s, s, c, e, f].map((each) => each.toFixed(6)).join(' ')})`);
        });
    }
    /**
     * The current position on paper of a place that was drawn on a body.
     * @param {number} body
     * @param {Spot} drawn
     */
    shaped(body, drawn) {
        const {places, data, givens} = this.motion,
            [rx, ry] = givens.drawn.bodies[body],
            {drawnScale, drawnOrigin} = this;
        const at = {x: (drawn.x - drawnOrigin.x) * drawnScale, y: (drawnOrigin.y - drawn.y) * drawnScale};
        const local = {x: at.x / data.unit - rx, y: at.y / data.unit - ry},
            {x, y} = givens.shapes[body]?.(local) ?? local;
        return this.paper(scaledBy(data.unit, places.world(body, x, y)));
    }
    /**
     * Index of the owner of a mark, by ids such as "link-3", "velocities-link-3", "body-2-link-2"; −1: none.
     * @param {Element} node
     * @param {string} kind
     * @param {{id: string}[]} list
     */
    named(node, kind, list) {
        const said = node.getAttribute('data-id') ?? '',
            {info} = this,
            free = this.isFree ? `${info.name}-` : '';
        const load = info.name.match(/^lines-(load-.*)/)?.[1],
            prefixes = ['', 'velocities-', `${info.name}-`, free, `${load}-`];
        return list.findIndex(({id}) => prefixes.some((prefix) => said === `${prefix}${kind}-${id}`));
    }
    /** @param {Element} node */
    bindLink(node) {
        const body = this.named(node, 'link', this.names.bodies);
        if (body < 0 || node.matches('.crossing')) node.classList.add('still');
        else this.bindToBody(node, body);
    }
    /**
     * The tint of a plate is below the link with the same corners.
     * @param {Element} node
     */
    bindTint(node) {
        const outline = node.getAttribute('d') ?? '';
        const links = [...this.group.querySelectorAll('g.link')];
        const link = links.find((each) =>
            [...each.querySelectorAll('path')].some((path) => path.getAttribute('d') === outline),
        );
        const body = link ? this.named(link, 'link', this.names.bodies) : -1;
        if (body < 0) node.classList.add('still');
        else this.bindToBody(node, body);
    }
    /** @param {Element} node */
    bindJoint(node) {
        const joint = this.names.joints[this.named(node, 'joint', this.names.joints)];
        if (joint) {
            const drawn = this.point(joint.point), {places} = this.motion;
            this.bindings.push(() => {
                const by = minus(this.point(joint.point), drawn);
                const turn = joint.turnsWith > 0 ? (-places.turn[joint.turnsWith] * 180) / Math.PI : 0;
                this.transform(
                    node,
                    `translate(${by.x.toFixed(4)} ${by.y.toFixed(4)}) rotate(${turn.toFixed(4)} ${drawn.x} ${drawn.y})`,
                );
            });
            return;
        }
        const {centre} = boxOf(spotsOf(parsePath(node.getAttribute('d') ?? '')));
        const point = this.motion.read.points.findIndex((_, i) => apart(this.point(i), centre) < samePlace);
        if (point < 0) node.classList.add('still');
        else this.bindToPlace([node], () => this.point(point));
    }
    /** @param {Element} node */
    bindCentre(node) {
        const name = this.names.centres[node.getAttribute('data-id') ?? ''];
        if (name !== undefined && this.spot(name)) return this.bindToPlace([node], () => this.spot(name));
        const segments = parsePath(node.getAttribute('d') ?? ''), spots = spotsOf(segments);
        if (spots.length === 2) this.bindThroughCentres(node, segments, spots);
        else node.classList.add('still');
    }
    /**
     * A line of Aronhold and Kennedy, which contains centres.
     * @param {Element} node
     * @param {Segment[]} segments
     * @param {Spot[]} spots
     */
    bindThroughCentres(node, segments, spots) {
        const toward = unitOf(minus(spots[1], spots[0]));
        const on = Object.values(this.names.centres).flatMap((name) => {
            const at = this.spot(name);
            return at && Math.abs(dot(minus(at, spots[0]), quarterTurn(toward))) < samePlace ? [{name, at}] : [];
        });
        on.sort((a, b) => dot(minus(a.at, b.at), toward));
        const first = on[0], last = on[on.length - 1];
        if (on.length < 2 || apart(first.at, last.at) < 1) return node.classList.add('still');
        const ends = spots.map((at) => {
            const nearest = apart(at, first.at) < apart(at, last.at) ? first : last;
            return {name: nearest.name, beyond: dot(minus(at, nearest.at), toward)};
        });
        this.bindings.push(() => {
            const [from, to] = [this.spot(first.name), this.spot(last.name)];
            const fits = from !== null && to !== null && apart(from, to) > leastVector;
            this.show(node, fits);
            if (!fits) return;
            const now = unitOf(minus(to, from));
            const places = ends.map(({name, beyond}) => along(name === first.name ? from : to, beyond, now));
            let next = 0;
            this.set(node, 'd', mappedPath(segments, () => places[next++]));
        });
    }
    /**
     * The axis of a guide moves with its body; compass strokes exist only in the drawn position.
     * @param {Element} node
     */
    bindGuide(node) {
        const segments = parsePath(node.getAttribute('d') ?? ''), spots = spotsOf(segments);
        if (this.held && node.hasAttribute('data-statement')) return node.classList.add('still');
        if (node.hasAttribute('data-statement') && spots.length === 2)
            return this.bindThroughCentres(node, segments, spots);
        const joint =
            spots.length !== 2
                ? undefined
                : this.names.joints.find(({point, turnsWith}) => {
                      const e = unitOf(minus(spots[1], spots[0]));
                      return (
                          turnsWith >= 0
                          && Math.abs(dot(minus(this.point(point), spots[0]), quarterTurn(e))) < samePlace
                      );
                  });
        if (joint?.turnsWith === 0) this.bindToGuideOfFrame(node, spots, samePlace);
        else if (joint) this.bindToBody(node, joint.turnsWith);
        else node.classList.add('still');
    }
    /**
     * A mark at a place of the frame stays there, unless a changed length moves the place. False: there is no place so
     * near.
     * @param {Element} node
     * @param {number} reach mm
     */
    bindToGround(node, reach) {
        const spots = spotsOf(parsePath(node.getAttribute('d') ?? ''));
        if (spots.length === 0) return false;
        const point = this.groundAt(boxOf(spots).centre, reach);
        if (point < 0) return this.bindToGuideOfFrame(node, spots, reach);
        const drawn = this.point(point);
        this.carry(node, () => minus(this.point(point), drawn));
        return true;
    }
    /**
     * A mark that moves only with a changed length.
     * @param {Element} node
     * @param {() => Spot} offset
     */
    carry(node, offset) {
        let wasMoved = false;
        this.bindings.push(() => {
            const by = offset(), isMoved = Math.hypot(by.x, by.y) > 1e-9;
            if (isMoved || wasMoved) this.translate(node, by);
            wasMoved = isMoved;
        });
    }
    /**
     * The axis of a guide on the frame, and the hatching beside it.
     * @param {Element} node
     * @param {Spot[]} spots
     * @param {number} reach
     */
    bindToGuideOfFrame(node, spots, reach) {
        const {data, read} = this.motion,
            {centre} = boxOf(spots);
        const across = (/** @type {number} */ joint) =>
            quarterTurn(unitOf({x: read.guides[joint].x, y: -read.guides[joint].y}));
        const joint = this.names.joints.findIndex(
            ({bodies, point}, k) =>
                data.joints[k].point >= 0
                && bodies.includes(0)
                && (read.guides[k].x !== 0 || read.guides[k].y !== 0)
                && Math.abs(dot(minus(centre, this.point(point)), across(k))) < reach,
        );
        if (joint < 0) return false;
        const {point} = this.names.joints[joint], drawn = this.point(point), n = across(joint);
        this.carry(node, () => scaledBy(dot(minus(this.point(point), drawn), n), n));
        if (this.names.joints[joint].turnsWith === 0) this.stretch(node, point, drawn, scaledBy(-1, quarterTurn(n)));
        return true;
    }
    /**
     * Extends a guide over the travel of its slide: a line by its ends, hatching by more strokes.
     * @param {Element} node
     * @param {number} point
     * @param {Spot} drawn
     * @param {Spot} e
     */
    stretch(node, point, drawn, e) {
        const segments = parsePath(node.getAttribute('d') ?? ''), spots = spotsOf(segments);
        if (node.tagName !== 'path' || !segments.every(({letter}, i) => letter === 'ML'[i % 2])) return;
        const at = spots.map((spot) => dot(minus(spot, drawn), e)), count = spots.length;
        if (Math.min(...at) > 0 || Math.max(...at) < 0) return;  // of another place of the frame
        const travel = this.travels.get(point) ?? {from: 0, to: 0, drawn, e};
        this.travels.set(point, travel);
        this.bindings.push(() => {
            const {from, to} = travel;
            if (count === 2) {
                const ends = spots.map((spot, i) => along(spot, at[i] < at[1 - i] ? from : to, e));
                return this.set(node, 'd', mappedPath(segments, () => /** @type {Spot} */ (ends.shift())));
            }
            // The outermost stroke may be cut, so its neighbour is copied.
            const pitch = count > 7 ? at[4] - at[2] : 0, step = Math.abs(pitch), isUp = pitch > 0;
            if (step < samePlace) return;
            const copies = [
                {pair: isUp ? segments.slice(2, 4) : segments.slice(-4, -2), by: -step, reach: -from},
                {pair: isUp ? segments.slice(-4, -2) : segments.slice(2, 4), by: step, reach: to},
            ].flatMap(({pair, by, reach}) =>
                Array.from({length: Math.floor(reach / step)}, (_, k) =>
                    mappedPath(pair, (spot) => along(spot, (k + 2) * by, e)),
                ),
            );
            this.set(node, 'd', mappedPath(segments, (spot) => spot) + copies.join(''));
        });
    }
    /** The travel of points on guides, in one position of the driver. */
    measureTravels() {
        const [, , width, height] = this.viewBox;
        for (const [point, travel] of this.travels) {
            const by = dot(minus(this.point(point), travel.drawn), travel.e);
            if (Math.abs(by) > width + height) continue;
            travel.from = Math.min(travel.from, by);
            travel.to = Math.max(travel.to, by);
        }
    }
    /**
     * The nearest place of the frame; −1: none.
     * @param {Spot} at
     * @param {number} reach
     */
    groundAt(at, reach) {
        let best = -1, least = reach;
        this.motion.data.points.forEach(([body], i) => {
            const off = body === 0 ? apart(this.point(i), at) : least;
            if (off < least) [best, least] = [i, off];
        });
        return best;
    }
    /**
     * @param {Element} label
     * @param {Element[]} parts
     * @param {Spot} centre
     */
    bindMechanismLabel(label, parts, centre) {
        const text = label.getAttribute('data-label') ?? '';
        const first = text.split(' ≡ ')[0];
        const point = this.names.points.findIndex(
            (each, i) => each.label === first && apart(this.point(i), centre) < 40,
        );
        const body = this.names.bodies.findIndex((each) => each.label === text);
        if (/ = [−\d]/.test(text)) return this.bindNumber(parts, text, centre);
        const isBalloon = parts.some((part) => part.tagName === 'path');
        if (isBalloon && body > 0) {
            this.bindToPlace(parts, () => this.shaped(body, centre));
        } else if (point >= 0) {
            this.bindToPlace(parts, () => this.point(point));
        } else {
            const ground = this.isFree ? -1 : this.groundAt(centre, 25);
            if (ground < 0) parts.forEach((part) => part.classList.add('still'));
            else this.bindToPlace(parts, () => this.point(ground));
        }
    }
    /**
     * Hides a label with a number that is no longer true: "ω_2 = 5 rad/s" of a driver stays until it is changed.
     * @param {Element[]} parts
     * @param {string} text
     * @param {Spot} centre
     */
    bindNumber(parts, text, centre) {
        const {motion} = this, {settings} = motion.data, ground = this.groundAt(centre, Infinity);
        const setting = settings.findIndex(({name}) => text.startsWith(`${name.replace(/^([ωv]) /, '$1_')} = `));
        if (ground < 0 || setting < 0) return parts.forEach((part) => part.classList.add('still'));
        this.bindToPlace(parts, () => motion.settings[setting] === settings[setting].value ? this.point(ground) : null);
    }
    /**
     * "P_13  (O_2P_13 = 424 mm)": only the name remains away from the drawn position.
     * @param {Element} label
     */
    cutNumber(label) {
        const [name, number] = (label.getAttribute('data-label') ?? '').split('  (');
        if (number === undefined) return;
        const glyphs = [...name.replace(/[_^ ]/g, '')].length;
        [...label.querySelectorAll('use')].slice(glyphs).forEach((glyph) => glyph.classList.add('still'));
    }
    /**
     * @param {Spot} at mm
     * @returns {Spot}
     */
    unpaper(at) {
        return {x: (at.x - this.origin.x) * this.scale, y: (this.origin.y - at.y) * this.scale};
    }

    // --- the area
    // -----------------------------------------------------------------------------------------------------

    /**
     * All points that it must show here, at the drawing's scale, mm.
     * @returns {Spot[]}
     */
    extent() {
        if (this.held) return this.extentHeld(this.held);
        if (this.isMechanism) {
            // A vector that grows without limit near a dead point may leave the area.
            const [x, y, width, height] = this.viewBox, rim = width / 4;
            const tips = [...this.vectorsOf(this.motion.plan).keys()].flatMap((name) => this.vector(name) ?? []).filter(
                (at) => at.x > x - rim && at.x < x + width + rim && at.y > y - rim && at.y < y + height + rim);
            return [...this.motion.read.points.map((at) => this.paper(at)), ...tips];
        }
        return [...this.keys.keys()].flatMap((name) => this.vector(name) ?? []);
    }
    /**
     * Points of concurrency and poles of curvature may be far away; then they leave the area, as on the sheet.
     * @param {HeldMarks} held
     */
    extentHeld(held) {
        this.stayInPlace();
        const [x, y, width, height] = this.viewBox,
            rim = width / 4;
        const isNear = (/** @type {Spot} */ at) =>
            at.x > x - rim && at.x < x + width + rim && at.y > y - rim && at.y < y + height + rim;
        const places = [...held.places].flatMap((name) => held.place(name) ?? []);
        if (held.isLever) return places;
        const points = this.own ? this.own.points : this.motion.read.points.map((_, i) => i);
        const arrows = [...held.arrows.values()].flatMap(({now}) => now() ?? []);
        return [...points.map((point) => this.point(point)), ...[...places, ...arrows].filter(isNear)];
    }
    /** The box of what it shows, at the drawing's scale, mm. */
    box() {
        const {scale, origin} = this;
        this.scale = this.drawnScale;
        this.origin = this.drawnOrigin;
        const spots = this.extent();
        [this.scale, this.origin] = [scale, origin];
        return spots.length > 0 ? boxOf(spots) : null;
    }
    /**
     * The figure's part of the drawing: all of it, or a place in a row. In the drawn position.
     * @param {FigureView[]} views of the drawing, itself among them
     * @param {FigureView[][]} rows
     */
    takeRoom(views, rows) {
        const rim = 12, below = 8, own = this.fitRoom;
        if (views.length > 1 && !this.isMechanism && !this.held) {
            this.rows = rows;
            [this.title, this.foot] = companionsOf(this, views);
            const feet = total(rows.map((row) => Math.max(...row.map(({foot}) => foot?.height ?? 0))));
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
                this.translate(node, fits ? {x: left - of.left, y: top - of.top} : {x: 0, y: 0}),
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
        if (!box) return {scale: this.drawnScale, origin: this.drawnOrigin};
        const middle = {x: (left + right) / 2, y: (top + bottom) / 2};
        return {scale: this.drawnScale * k, origin: along(middle, -1 / k, minus(box.centre, this.drawnOrigin))};
    }
}
