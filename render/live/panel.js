// The panel of givens that a reader may change: speeds of drivers, sizes of loads, lengths, parameters of the file. A
// change closes the joints and replays the program again.

import {unscored} from './exercise.js';
/** @typedef {import('./motion.js').Motion} Motion */
/** @typedef {import('./page.js').Page} Page */

export class Panel {
    /** @param {Page} page */
    constructor(page) {
        this.page = page;
        /** @type {Map<number, HTMLInputElement>} */
        this.inputs = new Map();
        /**
         * Of directions, in degrees.
         * @type {Map<number, HTMLInputElement>}
         */
        this.directions = new Map();
    }
    /** @param {Motion} motion */
    wire(motion) {
        const panel = this.page.at('givens'), {settings} = motion.data;
        panel.hidden = settings.length + motion.data.fixed.length === 0;
        settings.forEach(({name, unit, size, value, ends, parameter}, i) => {
            if (motion.givens.follows(i)) return;
            const label = document.createElement('label'), input = document.createElement('input');
            Object.assign(input, {type: 'number', step: 'any'});
            input.oninput = () => {
                const isFirst = input.value === shortText(value / size);
                this.give(motion, i, input, isFirst ? value : input.valueAsNumber * size);
            };
            input.onblur = () => this.show(motion);
            const said = ends ? ends.map((end) => unscored(this.page.data.names.points[end].label)).join('') : name;
            label.append(symbolOf(said, parameter), ' ', input, ' ', unitText(unit));
            panel.append(label);
            this.inputs.set(i, input);
            if (settings[i].direction !== undefined) this.addDirection(motion, i, label, said);
        });
        /** @type {Map<string, string[]>} */
        const fixed = new Map();
        for (const [why, name] of motion.data.fixed) fixed.set(why, [...fixed.get(why) ?? [], name]);
        for (const [why, names] of fixed) {
            const told = panel.appendChild(document.createElement('p'));
            const say = () => (told.textContent = this.page.word(`fixed_${why}`).replace('{0}', names.join(', ')));
            document.addEventListener('languagechosen', say);
            say();
        }
    }
    /**
     * The direction of a load, beside its size.
     * @param {Motion} motion
     * @param {number} setting
     * @param {HTMLElement} label
     * @param {string} said
     */
    addDirection(motion, setting, label, said) {
        const input = document.createElement('input'), {direction = 0} = motion.data.settings[setting];
        Object.assign(input, {type: 'number', step: 'any'});
        const name = () => input.setAttribute('aria-label', `${said}: ${this.page.word('direction')}`);
        document.addEventListener('languagechosen', name);
        name();
        input.oninput = () => {
            const isFirst = input.value === shortText(degrees(direction)), to = input.valueAsNumber * Math.PI / 180;
            const isGood = Number.isFinite(to);
            input.setAttribute('aria-invalid', String(!isGood));
            if (isGood) this.page.drive.turnLoad(setting, motion.settings[setting], isFirst ? 0 : to - direction);
        };
        input.onblur = () => this.show(motion);
        label.append(' ∠ ', input, ' ', unitText('°'));
        this.directions.set(setting, input);
    }
    /**
     * @param {Motion} motion
     * @param {number} setting
     * @param {HTMLInputElement} input
     * @param {number} value SI; of a parameter in its unit
     */
    give(motion, setting, input, value) {
        const {page} = this, isLength = motion.data.settings[setting].ends !== undefined;
        page.pause();
        const isGood = Number.isFinite(value) && !(isLength && value <= 0) &&
            motion.give(motion.settings.map((each, i) => i === setting ? value : each));
        input.setAttribute('aria-invalid', String(!isGood));
        if (!isGood) return page.drive.say(page.word('does_not_close'));
        page.drive.rooms.clear();
        page.show();
        page.traces.draw();
    }
    /**
     * Shows the current values; does not change an input that has the focus.
     * @param {Motion} motion
     */
    show(motion) {
        for (const [i, input] of this.inputs) {
            const value = motion.settings[i] / motion.data.settings[i].size;
            if (input === document.activeElement) continue;
            input.value = shortText(value);
            input.removeAttribute('aria-invalid');
        }
        for (const [i, input] of this.directions) {
            const angle = degrees((motion.data.settings[i].direction ?? 0) + motion.turns[i]);
            if (input !== document.activeElement) input.value = shortText(angle);
        }
    }
}

/**
 * A name as it is written: what stands behind the letter is set low.
 * @param {string} name "ω 2", "F_P"
 * @param {boolean} [asItIs] a word of the file
 */
function symbolOf(name, asItIs) {
    const symbol = document.createElement('span'),
        [, letter, index] = (asItIs ? null : /^(\S+?)[ _](.+)$/.exec(name)) ?? ['', name, ''];
    symbol.append(letter);
    if (index) symbol.append(document.createElement('sub'));
    if (symbol.lastElementChild) symbol.lastElementChild.textContent = index;
    return symbol;
}
/** @param {string} unit */
function unitText(unit) {
    const node = document.createElement('span');
    node.className = 'unit';
    node.textContent = unit;
    return node;
}
/** @param {number} angle rad; the result between −180° and 180° */
function degrees(angle) {
    const whole = Number((angle * 180 / Math.PI).toFixed(5));
    return Number((((whole + 180) % 360 + 360) % 360 - 180).toFixed(5)) || 0;
}
/** @param {number} value */
function shortText(value) {
    return String(Number(value.toPrecision(10)));
}
