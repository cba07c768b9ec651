// Mouse, pen and touch on the canvas: picks for the tool in hand, dragging, panning, zooming.
import type {Bench} from './bench';
import type {Spot} from './edit';
import {canDrag, moveTo} from './placing';
import {pointNear, snap, type Target} from './snap';
import {LinkTool, LoadTool, SelectTool, SliderTool, pointerTo} from './tools';

/** Pixels: what moves less was a click. */
const still = 10;

export class Pointer {
    /** Fingers that are down. */
    down: Map<number, Spot> = new Map();
    pressed: {at: Spot, drags: string, pans: boolean, picks: boolean} | null = null;
    hasMoved = false;

    constructor(readonly bench: Bench, readonly root: SVGSVGElement) {
        root.addEventListener('pointerdown', (event) => this.press(event));
        root.addEventListener('pointermove', (event) => this.move(event));
        root.addEventListener('pointerup', (event) => this.release(event));
        root.addEventListener('pointercancel', (event) => this.stop(event));
        root.addEventListener('pointerleave', () => this.setCursor(null));
        root.addEventListener('wheel', (event) => this.wheel(event), {passive: false});
        root.addEventListener('contextmenu', (event) => {
            event.preventDefault();
            bench.tool?.cancel();
            bench.tell('cursor');
        });
    }
    at(event: MouseEvent): Spot {
        const box = this.root.getBoundingClientRect();
        return [event.clientX - box.left, event.clientY - box.top];
    }
    target(at: Spot, isFree: boolean) {
        const {bench} = this;
        return snap(bench.model, bench.spots, bench.view, bench.view.toPlane(at), {
            from: bench.tool?.from() ?? null,
            isFree: isFree || !bench.snaps,
            onBars: !(bench.tool instanceof SliderTool)
        });
    }
    setCursor(target: Target | null) {
        this.bench.cursor = target;
        this.bench.tell('cursor');
    }
    press(event: PointerEvent) {
        const at = this.at(event), {bench} = this;
        // What is being typed elsewhere is taken first.
        this.root.focus({preventScroll: true});
        this.root.setPointerCapture(event.pointerId);
        this.down.set(event.pointerId, at);
        this.hasMoved = false;
        if (this.down.size > 1) {
            if (this.pressed?.drags) bench.document.rest();
            this.pressed = null;
            return;
        }
        if (event.button === 2) return;
        this.pressed = {at, drags: '', pans: event.button === 1, picks: false};
        if (event.button !== 0) return;
        if (bench.tool instanceof SelectTool || !bench.tool) return this.select(event, at);
        const target = this.target(at, event.altKey);
        this.setCursor(target);
        // A finger that may begin a pinch picks when it is lifted.
        this.pressed.picks = event.pointerType === 'touch';
        if (!this.pressed.picks) bench.tool.pick(target);
    }
    select(event: PointerEvent, at: Spot) {
        const {bench} = this,
            point = pointNear(bench.model, bench.spots, bench.view, bench.view.toPlane(at));
        const hit = document
            .elementsFromPoint(event.clientX, event.clientY)
            .map((each) => each.closest('[data-of]'))
            .find(Boolean);
        const pointer = hit instanceof SVGElement ? (hit.dataset.of ?? null) : null;
        const isOfPoint = point && (pointer === null || !/^\/(loads|drivers|masses)\//.test(pointer));
        bench.select(isOfPoint ? pointerTo('points', point) : pointer);
        if (!this.pressed) return;
        if (isOfPoint && canDrag(bench.model.point(point)?.form)) this.pressed.drags = point;
        else this.pressed.pans = bench.selection === null;
    }
    move(event: PointerEvent) {
        const at = this.at(event), {bench} = this, before = this.down.get(event.pointerId);
        if (this.down.size > 1 && before) {
            const [other] = [...this.down].filter(([id]) => id !== event.pointerId).map(([, each]) => each);
            const gap = (each: Spot) => Math.hypot(each[0] - other[0], each[1] - other[1]) || 1;
            bench.view.pan((at[0] - before[0]) / 2, (at[1] - before[1]) / 2);
            bench.view.zoom(gap(at) / gap(before), other);
            this.down.set(event.pointerId, at);
            return bench.tell('view');
        }
        if (before) this.down.set(event.pointerId, at);
        const {pressed} = this;
        if (
            pressed &&
            Math.hypot(at[0] - pressed.at[0], at[1] - pressed.at[1]) > (event.pointerType === 'touch' ? still : 3)
        )
            this.hasMoved = true;
        if (pressed && before && this.hasMoved && pressed.pans) {
            bench.view.pan(at[0] - before[0], at[1] - before[1]);
            return bench.tell('view');
        }
        if (pressed?.drags && this.hasMoved) {
            const point = pressed.drags, target = snap(bench.model, bench.spots, bench.view, bench.view.toPlane(at),
                {except: point, isFree: event.altKey || !bench.snaps, onBars: false});
            return bench.edit((edit) => moveTo(edit, point, target.at), `drag ${point}`);
        }
        if (bench.tool && !(bench.tool instanceof SelectTool)) this.setCursor(this.target(at, event.altKey));
    }
    release(event: PointerEvent) {
        const at = this.at(event), {pressed, bench} = this;
        this.stop(event);
        if (!pressed) return;
        if (pressed.drags) bench.document.rest();
        const {tool} = bench;
        if (!tool || tool instanceof SelectTool || event.button !== 0 || pressed.pans) return;
        const draws = tool instanceof LinkTool || tool instanceof SliderTool || tool instanceof LoadTool;
        const away = Math.hypot(at[0] - pressed.at[0], at[1] - pressed.at[1]);
        if (pressed.picks) tool.pick(this.target(pressed.at, event.altKey));
        if (away > still && draws && tool.picked.length > 0) {
            tool.pick(this.target(at, event.altKey));
            // What was drawn by dragging ends where it ends.
            tool.cancel();
        }
        this.setCursor(this.target(at, event.altKey));
    }
    stop(event: PointerEvent) {
        this.down.delete(event.pointerId);
        this.pressed = null;
    }
    wheel(event: WheelEvent) {
        event.preventDefault();
        const {view} = this.bench;
        if (event.shiftKey) view.pan(-event.deltaY - event.deltaX, 0);
        else
            view.zoom(
                Math.exp(-Math.sign(event.deltaY) * Math.min(Math.abs(event.deltaY), 120) * 0.0015),
                this.at(event)
            );
        this.bench.tell('view');
    }
}
