// The panel of what is given: speeds of drivers and sizes of loads, which a reader may change. The record is replayed with them.

class Panel {
    /** @param {Page} page */
    constructor(page) {
        this.page = page;
        /** @type {HTMLInputElement[]} */
        this.inputs = [];
    }
    /** @param {Motion} motion */
    wire(motion) {
        const panel = this.page.at('givens');
        panel.hidden = motion.data.settings.length === 0;
        motion.data.settings.forEach(({name, unit, size}, i) => {
            const label = document.createElement('label'), input = document.createElement('input');
            Object.assign(input, {type: 'number', step: 'any'});
            input.oninput = () => this.give(motion, i, input.valueAsNumber * size);
            label.append(`${name} `, input, ` ${unit}`);
            panel.append(label);
            this.inputs.push(input);
        });
    }
    /**
     * @param {Motion} motion
     * @param {number} setting
     * @param {number} value SI
     */
    give(motion, setting, value) {
        this.page.pause();
        if (!Number.isFinite(value)) return;
        motion.settings[setting] = value;
        this.page.rooms.clear();
        this.page.moveTo(motion.at);
        this.page.traces.draw();
    }
    /**
     * What is given now; an input that is being written in is left alone.
     * @param {Motion} motion
     */
    show(motion) {
        this.inputs.forEach((input, i) => {
            const value = motion.settings[i] / motion.data.settings[i].size;
            if (input !== document.activeElement) input.value = String(Number(value.toPrecision(12)));
        });
    }
}
