// The keyboard: tools by their letters, a cross that the arrow keys move, Enter picks; the selection moves by the grid.
import type {Bench} from './bench';
import {rounded, type Spot} from './edit';
import {canDrag, moveTo} from './placing';
import {removeBody, removeJoint, removePoint} from './references';
import {pointNear, snap} from './snap';
import {SelectTool, pointerTo, tools} from './tools';

const ways: Record<string, Spot> = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};

/** Deletes what is selected. */
export function deleteSelected(bench: Bench) {
    const selected = bench.selected();
    if (!selected) return;
    const {list, key, path} = selected;
    bench.edit((edit) => {
        if (list === 'points') removePoint(edit, String(key));
        else if (list === 'bodies') removeBody(edit, String(key));
        else if (list === 'joints') removeJoint(edit, edit.model.joints.findIndex((each) => each.path[1] === key));
        else edit.remove(path);
        return null;
    });
}

export class Keys {
    /** @param commands by key, with Ctrl */
    constructor(readonly bench: Bench, readonly canvas: SVGSVGElement, readonly commands: Record<string, () => void>) {
        document.addEventListener('keydown', (event) => {
            document.documentElement.dataset.input = 'keys';
            this.onKey(event);
        });
        document.addEventListener('pointerdown', () => (document.documentElement.dataset.input = 'pointer'), true);
        canvas.addEventListener('keydown', (event) => this.onCanvasKey(event));
    }
    onKey(event: KeyboardEvent) {
        const isTyping = event.target instanceof Element && event.target.matches('input, textarea, select');
        if (event.ctrlKey || event.metaKey) {
            const name = (event.shiftKey ? 'shift+' : '') + event.key.toLowerCase();
            // While a text is written its own undo counts; a field that is taken is as the file has it.
            const {target} = event,
                isTaken = target instanceof HTMLInputElement && target.value === target.defaultValue;
            if (isTyping && !isTaken && /z$|y$/.test(name)) return;
            if (!(name in this.commands)) return;
            event.preventDefault();
            this.commands[name]();
            return;
        }
        if (isTyping || event.altKey || this.bench.mode !== 'build') return;
        const tool = tools.find((each) => each.key === event.key.toLowerCase());
        if (tool) {
            this.bench.take(new tool(this.bench));
            this.canvas.focus();
            event.preventDefault();
        }
    }
    onCanvasKey(event: KeyboardEvent) {
        const {bench} = this, way = ways[event.key];
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        if (way) this.go(way, event.shiftKey ? 5 : 1);
        else if (event.key === 'Enter' || event.key === ' ') this.pick();
        else if (event.key === 'Escape') this.escape();
        else if (event.key === 'Delete' || event.key === 'Backspace') deleteSelected(bench);
        else if (event.key === '+' || event.key === '=') this.zoom(1.25);
        else if (event.key === '-' && (bench.tool instanceof SelectTool || !bench.tool)) this.zoom(0.8);
        else if (event.key === '0' && bench.tool instanceof SelectTool) bench.fit();
        else return;
        event.preventDefault();
    }
    zoom(factor: number) {
        const {view} = this.bench;
        view.zoom(factor, [view.width / 2, view.height / 2]);
        this.bench.tell('view');
    }
    escape() {
        const {bench} = this;
        if (bench.tool && bench.tool.picked.length > 0) bench.tool.cancel();
        else if (bench.tool instanceof SelectTool) bench.select(null);
        else bench.take(new SelectTool(bench));
        bench.tell('cursor');
    }
    /** Where the cross is: the middle of the canvas before it is moved. */
    cross(): Spot {
        const {view, cursor} = this.bench;
        return cursor?.at ?? view.toPlane([view.width / 2, view.height / 2]);
    }
    /** Moves the selected point, or the cross. */
    go(way: Spot, steps: number) {
        const {bench} = this, {grid} = bench.view, selected = bench.selected();
        const isSelecting = bench.tool instanceof SelectTool;
        if (isSelecting && selected?.list === 'points' && canDrag(selected.form)) {
            const point = String(selected.key), at = bench.spots[point];
            if (!at) return;
            const turns = !Array.isArray(selected.form);
            const unit = turns ? 3 / bench.view.scale : grid;
            bench.edit(
                (edit) =>
                    moveTo(edit, point, [
                        rounded(at[0] + way[0] * steps * unit),
                        rounded(at[1] + way[1] * steps * unit)
                    ]),
                `keys ${point}`
            );
            return;
        }
        const at = this.cross(),
            to = at.map((each, i) => rounded((Math.round(each / grid) + way[i] * steps) * grid)) as Spot;
        this.show(to);
        bench.cursor = {...snap(bench.model, bench.spots, bench.view, to, {from: null, onBars: true}), at: to};
        const point = pointNear(bench.model, bench.spots, bench.view, to);
        if (point) bench.cursor.at = bench.spots[point];
        bench.tell('cursor');
    }
    /** Keeps the cross on the screen. */
    show(at: Spot) {
        const {view} = this.bench,
            [x, y] = view.toScreen(at),
            edge = 30;
        const by = (place: number, size: number) =>
            place < edge ? edge - place : place > size - edge ? size - edge - place : 0;
        view.pan(by(x, view.width), by(y, view.height));
        this.bench.tell('view');
    }
    pick() {
        const {bench} = this, at = this.cross();
        const target = snap(bench.model, bench.spots, bench.view, at, {isFree: false});
        if (bench.tool && !(bench.tool instanceof SelectTool)) {
            // The cross stands where it stands, on the grid or a point.
            bench.tool.pick(target.point || target.bar ? target : {...target, at, snapped: 'grid'});
            bench.tell('cursor');
            return;
        }
        if (target.point) bench.select(pointerTo('points', target.point));
        else if (target.bar) bench.select(pointerTo('bodies', target.bar.body));
    }
}
