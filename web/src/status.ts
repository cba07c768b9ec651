// The line at the foot: whether it is solved, what is missing, what is wrong; on the right the grid.
import type {Bench} from './bench';
import {byId, html} from './dom';
import {rounded} from './edit';
import type {Answer, Fault} from '../../app/workbench/protocol';
import {SelectTool} from './tools';
import {word} from './words';

export class Status {
    constructor(readonly bench: Bench) {
        bench.on(['answer'], () => this.show());
        bench.on(['view', 'file'], () => this.showGrid());
        bench.on(['tool', 'cursor', 'file', 'selection'], () => this.showHint());
    }
    show() {
        const {answer, inquiry} = this.bench, status = byId('status'), advice = byId('advice');
        if (!answer) return;
        const faults = answer.failure ? 1 : answer.faults.length;
        const unsolved = answer.unsolved.length;
        let [look, says] = ['', ''];
        if (answer.failure) [look, says] = ['bad', word('engine_lost')];
        else if (faults > 0) {
            const heading = faults > 1 ? word('faults', faults) : word('one_fault');
            [look, says] = ['bad', `${heading} ${wrong(answer.faults[0])}`];
        }
        else if (answer.values && unsolved > 0) [look, says] = ['open', this.missing(answer)];
        else if (answer.values && answer.values.length > 0)
            [look, says] = ['good', this.solved(Math.round(inquiry.took))];
        if (status.textContent !== says) status.textContent = says;
        status.className = look;
        const remarks = faults > 0 ? [] : this.advice(answer);
        advice.replaceChildren(...remarks.slice(0, 4).map((each) => html('li', {}, each)));
        byId('advice-box').hidden = remarks.length === 0 || this.bench.model.points.length === 0;
    }
    /** What the engine remarks; otherwise what comes next: a driver, then what balances the loads. */
    advice(answer: Answer) {
        const {loads, drivers, movingBodies, file} = this.bench.model, {remarks, names, unsolved} = answer;
        if (remarks.length > 0) return remarks;
        if (movingBodies.length > 0 && freedomsLeft(answer) > 0) return [word('drive_more')];
        const isSettled = file.effort !== undefined || unsolved.length > 0 || !names || names.includes('forces');
        return loads.length === 0 || drivers.length === 0 || isSettled ? [] : [word('forces_wanted')];
    }
    /** What is missing: a driver where something is free to move, otherwise what the engine could not determine. */
    missing(answer: Answer) {
        const {mobility, unsolved: [first]} = answer, free = freedomsLeft(answer);
        return free > 0 ? `${word('freedom')}: ${word('freedom_free', mobility?.effective ?? 0, free)}` :
            `${word('not_determined')} ${first.what}: ${first.why}`;
    }
    solved(milliseconds: number) {
        const {results} = this.bench.answer ?? {},
            worst = results ? greatestDifference(results) : null;
        return worst === null
            ? word('solved', milliseconds)
            : word('solved_and_checked', milliseconds, worst.toExponential(0).replace('e-', 'e−'));
    }
    showGrid() {
        const {view, model, snaps} = this.bench;
        byId('grid').textContent =
            `${word('grid', rounded(view.grid), model.unit)} · ${snaps ? word('snap_on') : word('snap_off')}`;
    }
    showHint() {
        const {tool, selection, model} = this.bench, hint = byId('hint');
        const begun = tool && tool.picked.length > 0;
        const says =
            !tool || tool instanceof SelectTool
                ? model.points.length === 0
                    ? word('hint_begin')
                    : selection
                      ? word('hint_selected')
                      : ''
                : word(begun ? `hint_${tool.name}_2` : `hint_${tool.name}`);
        hint.textContent = says;
        hint.hidden = says === '';
    }
}

/** The largest difference of construction and check, as a share of the value. */
function greatestDifference(results: string) {
    const {checks} = JSON.parse(results);
    if (!Array.isArray(checks) || checks.length === 0) return null;
    return checks.reduce(
        (worst, each) => Math.max(worst, Math.abs(each.difference) / Math.max(1, Math.abs(each.numeric))),
        0
    );
}

/** The freedoms that no driver takes. */
const freedomsLeft = ({mobility, counts}: Answer) => (mobility?.effective ?? 0) - (counts?.drivers ?? 0);
/** What is wrong. A remedy is said in terms of the file, and so where the file is shown. */
const wrong = ({text, fault, remedy}: Fault) =>
    fault && remedy ? `${fault}. ${word('remedy_in_file')}` : text;
