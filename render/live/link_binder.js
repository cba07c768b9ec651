// Binds the parts of a mechanism, by their roles: links, joints, centres, guides.

import {dot, quarterTurn, unitOf} from './closure.js';
import {scaledBy} from './given.js';
import {apart, boxOf, mappedPath, minus, parsePath, samePlace, spotsOf} from './path.js';
/** @typedef {import('./figures.js').FigureView} FigureView */
/** @typedef {import('./types.js').Spot} Spot */

export class LinkBinder {
    /** @param {FigureView} view */
    constructor(view) {
        this.view = view;
    }
    /**
     * A group of marks, by its role.
     * @param {Element} group
     */
    bindRole(group) {
        const role = group.getAttribute('class') ?? '';
        if (role === 'dimensions') return group.classList.add('still');
        if (role === 'vector') return this.view.arrows.bindVector(group);
        if (role === 'label' || role === 'text') return;
        for (const node of group.children) {
            if (this.view.taken.has(node)) continue;
            if (node.matches('g.vector')) this.view.arrows.bindVector(node);
            else if (role === 'links') this.bindLink(node);
            else if (role === 'tint') this.bindTint(node);
            else if (role === 'joints') this.bindJoint(node);
            else if (role === 'centres') this.bindCentre(node);
            else if (role === 'construction') this.bindGuide(node);
            else if (role === 'ground' && node.tagName === 'g') node.classList.add('still');
            else if (role === 'ground') this.view.ground.bindToGround(node, 15);
            else if (role === 'arrows' && node.hasAttribute('data-statement')) node.classList.add('still');
            else if (role === 'arrows' && !this.view.ground.bindToGround(node, 16)) node.classList.add('still');
        }
    }
    /**
     * The lines between the joints of each moving body, which labels keep off.
     * @returns {[Spot, Spot][]}
     */
    bars() {
        const {view} = this, {joints, bodies} = view.names;
        return bodies.flatMap((_, body) => {
            const own = body > 0 ? joints.filter((joint) => joint.bodies.includes(body)).map(({point}) =>
                view.point(point)) : [];
            return own.flatMap((a, i) => own.slice(i + 1).map((b) => /** @type {[Spot, Spot]} */ ([a, b])));
        });
    }
    /**
     * Moves a node with a body.
     * @param {Element} node
     * @param {number} body
     */
    bindToBody(node, body) {
        if (body <= 0) return;
        const {places, data, givens} = this.view.motion, [rx, ry] = givens.drawn.bodies[body];
        const all = node.tagName === 'path' ? [node] : [...node.querySelectorAll('path')];
        const paths = all.map((path) => ({path, d: path.getAttribute('d') ?? ''}));
        let wasShaped = false;
        this.view.bindings.push(() => {
            const shape = givens.shapes[body], {x: c, y: s} = places.facing[body];
            if (shape || wasShaped) {
                for (const {path, d} of paths)
                    this.view.marks.set(path, 'd', shape ? mappedPath(parsePath(d), (at) => this.shaped(body, at)) : d);
            }
            wasShaped = shape !== null;
            if (shape) return this.view.marks.set(node, 'transform', '');
            const from = this.view.drawnPaper({x: data.unit * rx, y: data.unit * ry});
            const to = this.view.paper({x: data.unit * places.at[body].x, y: data.unit * places.at[body].y});
            const e = to.x - c * from.x - s * from.y, f = to.y + s * from.x - c * from.y;
            this.view.marks.transform(node, `matrix(${[c, -s, s, c, e, f].map((each) => each.toFixed(6)).join(' ')})`);
        });
    }
    /**
     * The current position on paper of a place that was drawn on a body.
     * @param {number} body
     * @param {Spot} drawn
     */
    shaped(body, drawn) {
        const {places, data, givens} = this.view.motion,
            [rx, ry] = givens.drawn.bodies[body],
            {drawnScale, drawnOrigin} = this.view;
        const at = {x: (drawn.x - drawnOrigin.x) * drawnScale, y: (drawnOrigin.y - drawn.y) * drawnScale};
        const local = {x: at.x / data.unit - rx, y: at.y / data.unit - ry},
            {x, y} = givens.shapes[body]?.(local) ?? local;
        return this.view.paper(scaledBy(data.unit, places.world(body, x, y)));
    }
    /**
     * The current position on paper of a place that a body carries.
     * @param {number} body
     * @param {Spot} at as drawn, m
     */
    carried(body, at) {
        return body === 0 ? this.view.paper(at) : this.shaped(body, this.view.drawnPaper(at));
    }
    /**
     * Index of the owner of a mark, by ids such as "link-3", "velocities-link-3", "body-2-link-2"; −1: none.
     * @param {Element} node
     * @param {string} kind
     * @param {{id: string}[]} list
     */
    named(node, kind, list) {
        const said = node.getAttribute('data-id') ?? '',
            {info} = this.view,
            free = this.view.isFree ? `${info.name}-` : '';
        const prefixes = ['', `${info.name}-`, free, info.prefix ?? ''];
        return list.findIndex(({id}) => prefixes.some((prefix) => said === `${prefix}${kind}-${id}`));
    }
    /** @param {Element} node */
    bindLink(node) {
        const body = this.named(node, 'link', this.view.names.bodies);
        if (body < 0 || node.matches('.crossing')) node.classList.add('still');
        else this.bindToBody(node, body);
    }
    /**
     * The tint of a plate is below the link with the same corners.
     * @param {Element} node
     */
    bindTint(node) {
        const outline = node.getAttribute('d') ?? '';
        const links = [...this.view.group.querySelectorAll('g.link')];
        const link = links.find((each) =>
            [...each.querySelectorAll('path')].some((path) => path.getAttribute('d') === outline),
        );
        const body = link ? this.named(link, 'link', this.view.names.bodies) : -1;
        if (body < 0) node.classList.add('still');
        else this.bindToBody(node, body);
    }
    /**
     * A mark of a joint or a point that does not say which: at the point where it stands.
     * @param {Element} node
     */
    bindJoint(node) {
        const {centre} = boxOf(spotsOf(parsePath(node.getAttribute('d') ?? '')));
        const point = this.view.motion.read.points.findIndex((_, i) => apart(this.view.point(i), centre) < samePlace);
        if (point < 0) node.classList.add('still');
        else this.view.labels.bindToPlace([node], () => this.view.point(point));
    }
    /** @param {Element} node */
    bindCentre(node) {
        const name = this.view.names.centres[node.getAttribute('data-id') ?? ''];
        if (name !== undefined && this.view.spot(name)) return this.view.labels.bindToPlace([node], () =>
            this.view.spot(name));
        const segments = parsePath(node.getAttribute('d') ?? ''), spots = spotsOf(segments);
        if (spots.length === 2) this.view.lines.bindThroughCentres(node, segments, spots);
        else node.classList.add('still');
    }
    /**
     * The axis of a guide moves with its body; compass strokes exist only in the drawn position.
     * @param {Element} node
     */
    bindGuide(node) {
        const segments = parsePath(node.getAttribute('d') ?? ''), spots = spotsOf(segments);
        if (this.view.isHeld && node.hasAttribute('data-statement')) return node.classList.add('still');
        if (node.hasAttribute('data-statement') && spots.length === 2)
            return this.view.lines.bindThroughCentres(node, segments, spots);
        const joint =
            spots.length !== 2
                ? undefined
                : this.view.names.joints.find(({point, turnsWith}) => {
                      const e = unitOf(minus(spots[1], spots[0]));
                      return (
                          turnsWith >= 0
                          && Math.abs(dot(minus(this.view.point(point), spots[0]), quarterTurn(e))) < samePlace
                      );
                  });
        if (joint?.turnsWith === 0) this.view.ground.bindToGuideOfFrame(node, spots, samePlace);
        else if (joint) this.bindToBody(node, joint.turnsWith);
        else node.classList.add('still');
    }
}
