// Types of the page's data, which render/live/live_data.cpp writes. No code.

/**
 * @typedef {{x: number, y: number}} Spot
 * @typedef {[number, number, number, number, number, number, number, number, number, number, number, number, number,
 *   number]} Row
 *   kind, bodies i and j, p, q, along (x and y each), offset, lever, share of i, share of j, driver (or −1)
 * @typedef {{turnsWith: number, bodies: [number, number], guide: [number, number], tangent: [number, number],
 *   locals: [[number, number], [number, number]], reaches: [number, number], straight: [boolean, boolean],
 *   circle: number,
 *   point: number, arc: boolean, touches: boolean, meshes: boolean, pressure: [number, number]}} JointRule
 * @typedef {{rule: string, given: number, index: number, ends: [number, number], bodies: [number, number],
 *   factor: number,
 *   offset: number}} MovingGiven
 * @typedef {{givens: (number[])[], strokes: number[], guards: number[], doubtfulBits: number, moving: MovingGiven[],
 *   sources: number[], vectors: [string, string, number, number, number][], spots: [string, string, number][],
 *   lines: [string, string, number, number, ...number[]][], held: [string, number, number, number, number?,
 *   string?, string?][]}} Plan
 *   held: place, vector, couple; the index of what the file gives; figure and symbol of a force that the drawn position
 *   does not have
 *   strokes: verb, plane, two inputs, given of each; guards: question, how, two inputs, verdict,
 *   stroke before which it is evaluated;
 *   sources: an element by column, −1: it vanishes, −2: unknown
 * @typedef {{name: string, symbol: string, kind: string, unit: string, size: number, body: number, point: number,
 *   joint: number,
 *   component: string}} Column
 *   symbol: as on the sheet, with _ before what is set low: ω_4
 * @typedef {{at: number, coordinate: number, plan: number, rate: number, acceleration: number, q: number[],
 *   values?: (number | null)[]}} Sample
 *   coordinate, rate and acceleration are written only for a driver with a law; otherwise Motion sets them
 * @typedef {{driver: number, name: string, turns: boolean, rate: number, from: number, to: number,
 *   startsAtLimit: boolean,
 *   endsAtLimit: boolean, changePoints: number[], byLaw: boolean, shares: number[], samples: Sample[]}} Course
 * @typedef {{name: string, unit: string, size: number, value: number,
 *   ends?: [number, number], bar?: number, parameter?: boolean, radians?: number, direction?: number,
 *   given?: number}} Changeable
 *   direction: as drawn, rad, of a vector that can be turned; given: its index in the file
 *   radians: of a parameter that is an angle; ends: points, of a length; bar: the body of the length,
 *   otherwise the frame
 * @typedef {{size: number, unit: number, rows: Row[], bodies: [number, number, number, number][], frozen: boolean[],
 *   points: [number, number, number, number][], joints: JointRule[], directions: number[],
 *   settings: Changeable[], effects: [(string | number)[], ...number[]][], fixed: [string, string][],
 *   columns: Column[], plans: Plan[],
 *   courses: Course[], pens?: [string, number][]}} MovingData
 *   pens: stroke and width of bars in compression, without force, in tension
 *   effects: the path to a number in this data;
 *   then for each term one or two of Givens.deltas (the second −1) and its factor
 *   fixed: parameters that can be changed only in the file, and the reason
 *   bodies: reference x and y, columns of place (−1: a hinge on the frame) and turn; points: carrier, local x and y,
 *   contact
 */

export {};
