// Closes the joints in the browser: Newton's method on the closure equations, as in engine/motion/positions.cpp,
// started near a sample of the cycle. Knows no construction and no figure.

/** @typedef {import('./types.js').JointRule} JointRule */
/** @typedef {import('./types.js').MovingData} MovingData */
/** @typedef {import('./types.js').Row} Row */
/** @typedef {import('./types.js').Spot} Spot */

/**
 * The direction turned by `facing`: the product as complex numbers.
 * @param {Spot} facing
 * @param {number} x
 * @param {number} y
 * @returns {Spot}
 */
function faced(facing, x, y) {
    return {x: facing.x * x - facing.y * y, y: facing.x * y + facing.y * x};
}

/**
 * @param {Spot} a
 * @returns {Spot}
 */
export function quarterTurn(a) {
    return {x: -a.y, y: a.x};
}

/**
 * @param {Spot} a
 * @param {Spot} b
 */
export function dot(a, b) {
    return a.x * b.x + a.y * b.y;
}

/**
 * @param {Spot} a
 * @returns {Spot}
 */
export function unitOf(a) {
    const size = Math.hypot(a.x, a.y);
    return {x: a.x / size, y: a.y / size};
}

export const together = 0, onLine = 1, atDistance = 2, turnsAlike = 3, rollsRound = 4;

/** The positions of the bodies, closed at any coordinate of a driver. */
export class Places {
    /** @param {MovingData} data */
    constructor(data) {
        this.data = data;
        this.at = data.bodies.map((body) => ({x: body[0], y: body[1]}));
        this.turn = data.bodies.map(() => 0);
        this.facing = data.bodies.map(() => ({x: 1, y: 0}));
        this.columns = data.frozen.length;
        /** The last closed position, by column. */
        this.q = new Float64Array(this.columns);
    }

    /** @param {ArrayLike<number>} q */
    set(q) {
        this.data.bodies.forEach((body, i) => {
            if (i === 0) return;
            this.at[i] = body[2] >= 0 ? {x: q[body[2]], y: q[body[2] + 1]} : {x: body[0], y: body[1]};
            this.turn[i] = q[body[3]];
            this.facing[i] = {x: Math.cos(this.turn[i]), y: Math.sin(this.turn[i])};
        });
    }

    /**
     * The position of a point of a body, in the closure's unit.
     * @param {number} body
     * @param {number} x
     * @param {number} y
     * @returns {Spot}
     */
    world(body, x, y) {
        const turned = faced(this.facing[body], x, y);
        return {x: this.at[body].x + turned.x, y: this.at[body].y + turned.y};
    }

    /**
     * @param {Float64Array} into
     * @param {number} body
     * @param {Spot} n
     * @param {number} turning
     */
    put(into, body, n, turning) {
        if (body === 0) return;
        const [, , x, turn] = this.data.bodies[body];
        const {frozen} = this.data;
        if (x >= 0 && !frozen[x]) into[x] += n.x;
        if (x >= 0 && !frozen[x + 1]) into[x + 1] += n.y;
        if (!frozen[turn]) into[turn] += turning;
    }

    /**
     * Writes a row's gradient; returns its residual, without the driver's coordinate.
     * @param {Row} row
     * @param {Float64Array} into
     */
    write(row, into) {
        const [kind, i, j, px, py, qx, qy, ax, ay, offset, lever, shareI, shareJ] = row;
        if (kind === turnsAlike) {
            this.put(into, i, {x: 0, y: 0}, 1);
            this.put(into, j, {x: 0, y: 0}, -1);
            return this.turn[i] - this.turn[j];
        }
        const p = faced(this.facing[i], px, py), q = faced(this.facing[j], qx, qy);
        const d = {x: this.at[i].x + p.x - this.at[j].x - q.x, y: this.at[i].y + p.y - this.at[j].y - q.y};
        let n = {x: ax, y: ay}, moreI = 0, moreJ = 0, excess = 0;
        if (kind === together) {
            excess = dot(n, d);
        } else if (kind === onLine) {
            n = faced(this.facing[j], ax, ay);
            moreI = -lever;
            moreJ = lever + dot(quarterTurn(n), d);
            excess = dot(n, d) - offset - lever * (this.turn[i] - this.turn[j]);
        } else if (kind === atDistance) {
            n = {x: d.x / offset, y: d.y / offset};
            excess = (dot(d, d) - offset * offset) / (2 * offset);
        } else if (kind === rollsRound) {
            const angle = shareI * this.turn[i] + shareJ * this.turn[j];
            const e = faced({x: Math.cos(angle), y: Math.sin(angle)}, ax, ay);
            n = quarterTurn(e);
            moreI = -shareI * dot(e, d);
            moreJ = -shareJ * dot(e, d);
            excess = e.x * d.y - e.y * d.x;
        }
        this.put(into, i, n, dot(n, quarterTurn(p)) + moreI);
        this.put(into, j, {x: -n.x, y: -n.y}, -dot(n, quarterTurn(q)) + moreJ);
        return excess;
    }

    /**
     * Closes all joints at a coordinate of the driver, from a start; false if it does not converge.
     * @param {ArrayLike<number>} start
     * @param {number} coordinate
     * @param {number[]} shares by driver
     */
    close(start, coordinate, shares) {
        const q = Float64Array.from(start);
        const {rows} = this.data;
        for (let pass = 0; pass < 40; ++pass) {
            this.set(q);
            const matrix = rows.map(() => new Float64Array(this.columns + 1));
            rows.forEach((row, r) => {
                const excess = this.write(row, matrix[r]);
                matrix[r][this.columns] = excess - (row[13] >= 0 ? coordinate * shares[row[13]] : 0);
            });
            const delta = solved(matrix, this.columns);
            let size = 0;
            for (let k = 0; k < q.length; ++k) {
                q[k] -= delta[k];
                size = Math.max(size, Math.abs(delta[k]));
            }
            if (!(size < 0.5)) return false;
            if (size < 1e-15 || (pass > 3 && size < 1e-13)) {
                this.set(q);
                this.q = q;
                return true;
            }
        }
        return false;
    }

    /**
     * The virtual displacements of the unknowns, by column, for a displacement one of a driver's coordinate; the other
     * drivers rest.
     * @param {number} driver
     */
    displaced(driver) {
        const {rows} = this.data;
        const matrix = rows.map(() => new Float64Array(this.columns + 1));
        rows.forEach((row, r) => {
            this.write(row, matrix[r]);
            matrix[r][this.columns] = row[13] === driver ? 1 : 0;
        });
        return solved(matrix, this.columns);
    }
    /**
     * The displacement of a point, in the closure's unit.
     * @param {number} point
     * @param {Float64Array} by of the unknowns
     * @returns {Spot}
     */
    displacement(point, by) {
        const [body, x, y] = this.data.points[point];
        if (body <= 0) return {x: 0, y: 0};
        const [, , column, turn] = this.data.bodies[body], arm = quarterTurn(faced(this.facing[body], x, y));
        const [dx, dy] = column >= 0 ? [by[column], by[column + 1]] : [0, 0];
        return {x: dx + by[turn] * arm.x, y: dy + by[turn] * arm.y};
    }

    /** Points, guides, normals and tangents, m, as in engine/motion/positions.cpp. */
    read() {
        const {points, joints, unit} = this.data;
        const scaled = (/** @type {Spot} */ a) => ({x: unit * a.x, y: unit * a.y});
        const read = {
            points: points.map(([body, x, y, contact]) =>
                scaled(body >= 0 ? this.world(body, x, y) : this.contact(joints[contact])),
            ),
            guides: joints.map(() => ({x: 0, y: 0})),
            normals: joints.map(() => ({x: 0, y: 0})),
            tangents: joints.map(() => ({x: 0, y: 0})),
        };
        joints.forEach((joint, k) => {
            if (joint.point < 0) return;
            const local = (/** @type {number} */ side) =>
                this.world(joint.bodies[side], joint.locals[side][0], joint.locals[side][1]);
            if (!joint.touches) {
                if (!joint.arc) read.guides[k] = faced(this.facing[joint.turnsWith], joint.guide[0], joint.guide[1]);
                const apart = joint.arc ? {x: local(0).x - local(1).x, y: local(0).y - local(1).y} : {x: 0, y: 0};
                read.normals[k] = joint.arc ? scaled(apart) : quarterTurn(read.guides[k]);
                return;
            }
            if (joint.turnsWith >= 0) {
                read.tangents[k] = faced(this.facing[joint.turnsWith], joint.tangent[0], joint.tangent[1]);
                read.normals[k] = quarterTurn(read.tangents[k]);
            } else {
                const centre = scaled(local(Math.max(joint.circle, 0))), at = read.points[joint.point];
                read.normals[k] = {x: centre.x - at.x, y: centre.y - at.y};
                read.tangents[k] = {x: read.normals[k].y, y: -read.normals[k].x};
            }
            if (joint.meshes) {
                const {x, y} = read.tangents[k];
                read.normals[k] = faced({x: joint.pressure[0], y: joint.pressure[1]}, x, y);
            }
        });
        return read;
    }

    /**
     * The contact point of two profiles, in the closure's unit.
     * @param {JointRule} joint
     * @returns {Spot}
     */
    contact(joint) {
        const centres = [0, 1].map((side) =>
            this.world(joint.bodies[side], joint.locals[side][0], joint.locals[side][1]),
        );
        for (const side of [0, 1]) {
            if (!joint.straight[side]) continue;
            const tangent = faced(this.facing[joint.turnsWith], joint.tangent[0], joint.tangent[1]);
            const share = joint.reaches[1 - side] / Math.hypot(tangent.x, tangent.y);
            const across = quarterTurn(tangent), centre = centres[1 - side];
            return {x: centre.x - share * across.x, y: centre.y - share * across.y};
        }
        const [one, other] = joint.reaches, apart = one - other;
        return {
            x: (one * centres[1].x - other * centres[0].x) / apart,
            y: (one * centres[1].y - other * centres[0].y) / apart,
        };
    }

    /**
     * The displacement along a straight slide from the drawn position, m.
     * @param {JointRule} joint
     */
    slid(joint) {
        const guide = faced(this.facing[joint.turnsWith], joint.guide[0], joint.guide[1]);
        const [one, other] = [0, 1].map((side) =>
            this.world(joint.bodies[side], joint.locals[side][0], joint.locals[side][1]),
        );
        return (this.data.unit * dot(guide, {x: one.x - other.x, y: one.y - other.y})) / Math.hypot(guide.x, guide.y);
    }
}

/**
 * Solves rows (each with its right side last) by elimination with complete pivoting: repeated equations are harmless,
 * and unknowns that no equation determines stay zero.
 * @param {Float64Array[]} matrix
 * @param {number} columns
 */
function solved(matrix, columns) {
    const order = Array.from({length: columns}, (_, k) => k);
    let rank = 0, first = 0;
    for (; rank < Math.min(matrix.length, columns); ++rank) {
        let best = 0, row = rank, column = rank;
        for (let r = rank; r < matrix.length; ++r) {
            for (let k = rank; k < columns; ++k) {
                const size = Math.abs(matrix[r][order[k]]);
                if (size > best) [best, row, column] = [size, r, k];
            }
        }
        if (rank === 0) first = best;
        if (!(best > 1e-12 * first)) break;
        [matrix[rank], matrix[row]] = [matrix[row], matrix[rank]];
        [order[rank], order[column]] = [order[column], order[rank]];
        for (let r = rank + 1; r < matrix.length; ++r) {
            const factor = matrix[r][order[rank]] / matrix[rank][order[rank]];
            if (factor === 0) continue;
            for (let k = rank; k < columns; ++k) matrix[r][order[k]] -= factor * matrix[rank][order[k]];
            matrix[r][columns] -= factor * matrix[rank][columns];
        }
    }
    const found = new Float64Array(columns);
    for (let k = rank - 1; k >= 0; --k) {
        let value = matrix[k][columns];
        for (let later = k + 1; later < rank; ++later) value -= matrix[k][order[later]] * found[order[later]];
        found[order[k]] = value / matrix[k][order[k]];
    }
    return found;
}
