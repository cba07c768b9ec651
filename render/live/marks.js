// The attributes of a figure's marks: the values as drawn and now, so that the drawing comes back as it was.

/** @typedef {import('./types.js').Spot} Spot */

export class Marks {
    /** @type {Map<Element, Map<string, {drawn: string | null, now: string | null}>>} */
    drawn = new Map();

    /** Every mark as drawn. */
    restore() {
        for (const [node, attributes] of this.drawn) {
            for (const [name, known] of attributes) {
                if (known.now === known.drawn) continue;
                known.now = known.drawn;
                if (known.drawn === null) node.removeAttribute(name);
                else node.setAttribute(name, known.drawn);
            }
        }
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
    /** @param {Element} node */
    isShown(node) {
        return this.drawn.get(node)?.get('visibility')?.now !== 'hidden';
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
}
