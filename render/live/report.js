// The report of an exercise: what was drawn, with how many attempts and hints, in what time, for how many points. It
// can be printed or saved; nothing is sent.

import {total} from './room.js';
/** @typedef {import('./page.js').Page} Page */

/** @typedef {{name: string, attempts: number, hints: number, seconds: number, points: number}} Done */

export class Report {
    /** @param {Page} page */
    constructor(page) {
        this.page = page;
        /** @type {string[][]} */
        this.rows = [];
    }
    wire() {
        const {page} = this;
        page.at('report-print').onclick = () => {
            document.documentElement.classList.add('reporting');
            window.print();
            document.documentElement.classList.remove('reporting');
        };
        page.at('report-save').onclick = () => this.save();
    }
    hide() {
        this.page.at('report').hidden = true;
    }
    /**
     * @param {string} title of the polygon
     * @param {Done[]} all
     */
    show(title, all) {
        const {page} = this, number = (/** @type {number} */ value) => page.numberText(value);
        const sum = (/** @type {(each: Done) => number} */ of) => number(total(all.map(of)));
        this.rows = [
            ['report_step', 'attempts', 'hints', 'seconds', 'points'].map((key) => page.word(key)),
            ...all.map(({name, attempts, hints, seconds, points}) => [name, ...[attempts, hints, seconds,
                points].map(number)]),
            ['Σ', sum(({attempts}) => attempts), sum(({hints}) => hints), sum(({seconds}) => seconds),
                sum(({points}) => points)],
        ];
        page.at('report-title').textContent = `${document.title}: ${title}`;
        const table = page.at('report-table');
        table.textContent = '';
        this.rows.forEach((row, i) => {
            const line = table.appendChild(document.createElement('tr'));
            row.forEach((text, k) => {
                const cell = line.appendChild(document.createElement(i === 0 || k === 0 ? 'th' : 'td'));
                cell.textContent = text;
                if (i === 0) cell.setAttribute('scope', 'col');
                else if (k === 0) cell.setAttribute('scope', 'row');
            });
        });
        page.at('report').hidden = false;
    }
    /** As a text with tabs, which spreadsheets read. */
    save() {
        const lines = [[this.page.at('report-title').textContent], ...this.rows].map((row) => row.join('\t'));
        const link = document.createElement('a');
        link.href = URL.createObjectURL(new Blob([`${lines.join('\n')}\n`], {type: 'text/plain'}));
        link.download = 'kinegraph-report.txt';
        link.click();
        URL.revokeObjectURL(link.href);
    }
}
