// What a live page holds, read without a browser: its data, and its interpreter as a module of node's.
import {readFileSync} from 'node:fs';
import vm from 'node:vm';

/** The data of a page and the classes of its script. */
export function readPage(path) {
    const html = readFileSync(path, 'utf8');
    const data = JSON.parse(html.match(/<script type="application\/json" id="data">([^]*?)<\/script>/)[1]);
    const script = html.match(/<script>([^]*?)<\/script>/)[1];
    const context = vm.createContext({});
    vm.runInContext(`${script}\nthis.Motion = Motion; this.Replay = Replay;`, context);
    return {html, data, script, ...context};
}

/** Of a column, what its values may be measured by: "omega", "v", "place_x". */
export function kindOf({kind, name}) {
    return kind === 'result' || kind === 'along' ? name.split(' ')[0].replace(/[xy]$/, '') : kind;
}

/** The largest difference of a page's columns from the rows of a sweep, as a share of the largest value of its kind. */
export function differences(page, sweep, course = 0) {
    const motion = new page.Motion(page.data.moving), {columns} = page.data.moving, way = page.data.moving.courses[course];
    const indices = columns.map((column) => sweep.columns.indexOf(column.name));
    const largest = new Map();
    columns.forEach((column, i) => {
        if (indices[i] < 0) return;
        const most = Math.max(...sweep.rows.map((row) => Math.abs(row[indices[i]])));
        largest.set(kindOf(column), Math.max(largest.get(kindOf(column)) ?? 0, most));
    });
    const worst = {share: 0, column: '', at: 0}, missing = [];
    let compared = 0;
    for (const row of sweep.rows) {
        const at = row[sweep.columns.indexOf(way.byLaw ? 'time' : 'turn')];
        if (!motion.moveTo(way, at)) {
            missing.push(`${at}: not closed`);
            continue;
        }
        columns.forEach((column, i) => {
            if (indices[i] < 0) return;
            const value = motion.value(i);
            if (value === null) return void missing.push(`${at}: ${column.name}`);
            ++compared;
            // Less than a thousandth is nothing beside an example's values.
            const share = Math.abs(value - row[indices[i]]) / Math.max(largest.get(kindOf(column)), 1e-3);
            if (!(share <= worst.share)) Object.assign(worst, {share, column: column.name, at});
        });
    }
    return {compared, worst, missing};
}
