// The page of a cam: the cam turns about its centre, the follower is moved by its rise, the plots and the values show
// the row of that turn. Every position is one of the rows that the program computed.

/**
 * @typedef {{
 *     sense: number, pivot?: [number, number], comma: boolean, words: {play: string, pause: string},
 *     turns: number[], rises: number[], contacts: [number, number][], normals: [number, number][], columns: number[][]
 * }} CamData
 */

class CamPage {
    constructor() {
        /** @type {CamData} */
        this.data = JSON.parse(this.part('data').textContent ?? '');
        this.slider = /** @type {HTMLInputElement} */ (this.part('position'));
        this.play = this.part('play');
        this.row = 0;
        /** Of the animation, in milliseconds; 0: it stands. */
        this.since = 0;
        this.slider.addEventListener('input', () => this.show(Number(this.slider.value)));
        this.play.addEventListener('click', () => this.run(this.since === 0));
        this.show(0);
    }
    /**
     * @param {string} id
     * @returns {HTMLElement}
     */
    part(id) {
        const found = document.getElementById(id);
        if (!found) throw new Error(`no #${id}`);
        return found;
    }
    /** @param {number} value */
    said(value) {
        const text = String(Number(value.toPrecision(4))).replace('-', '−');
        return this.data.comma ? text.replace('.', ',') : text;
    }
    /** @param {number} row */
    show(row) {
        const {data} = this, turn = data.turns[row], rise = data.rises[row], [x, y] = data.contacts[row];
        this.row = row;
        this.slider.value = String(row);
        this.slider.setAttribute('aria-valuetext', `${this.said(turn)}°`);
        this.part('where').textContent = `${this.said(turn)}°`;
        this.part('cam').setAttribute('transform', `rotate(${data.sense * turn})`);
        this.part('follower').setAttribute(
            'transform',
            data.pivot ? `rotate(${rise} ${data.pivot[0]} ${data.pivot[1]})` : `translate(0 ${rise})`
        );
        this.part('contact').setAttribute('transform', `translate(${x} ${y})`);
        const [along, down] = data.normals[row];
        this.part('contact').firstElementChild?.setAttribute(
            'd',
            `M${-200 * along} ${-200 * down}L${250 * along} ${250 * down}`
        );
        for (const line of document.querySelectorAll('.here'))
            line.setAttribute('transform', `translate(${turn} 0)`);
        for (const cell of document.querySelectorAll('[data-column]'))
            cell.textContent = this.said(data.columns[Number(cell.getAttribute('data-column'))][row]);
    }
    /** @param {boolean} isGoing */
    run(isGoing) {
        const {words} = this.data;
        this.play.setAttribute('aria-pressed', String(isGoing));
        this.play.setAttribute('aria-label', isGoing ? words.pause : words.play);
        if (!isGoing) {
            this.since = 0;
            return;
        }
        const seconds = 6, rows = this.data.turns.length - 1, first = this.row;
        const step = (/** @type {number} */ now) => {
            if (this.since === 0) return;
            this.show(Math.floor(first + ((now - this.since) / 1000 / seconds) * rows) % rows);
            requestAnimationFrame(step);
        };
        this.since = performance.now();
        requestAnimationFrame(step);
    }
}

Object.assign(window, {camPage: new CamPage()});

export {};
