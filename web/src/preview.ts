// What a tool is about to draw, and what the pointer has caught: a point, a bar, the grid, a whole angle.
import type {Bench} from './bench';
import {svg} from './dom';
import {rounded} from './edit';
import {angle, distance} from './placing';
import {LoadTool, SelectTool, SliderTool} from './tools';
import * as symbols from './symbols';

export function preview(bench: Bench): Element[] {
    const {tool, cursor, view} = bench;
    const byKeys = document.documentElement.dataset.input === 'keys';
    if (!tool || !cursor || (tool instanceof SelectTool && !byKeys)) return [];
    const at = view.toScreen(cursor.at), marks = [];
    const isCross = tool instanceof SelectTool;
    const from = isCross ? null : tool.from(), start = from && view.toScreen(from);
    if (from && start && distance(from, cursor.at) > 0) {
        const turned = Math.atan2(at[1] - start[1], at[0] - start[0]);
        if (tool instanceof SliderTool) marks.push(symbols.slider(start, turned, true));
        else if (tool instanceof LoadTool) marks.push(symbols.arrow(start, at, 'force'));
        else marks.push(svg('path', {class: 'rubber', d: `M${start}L${at}`}));
        const length = rounded(Number(distance(from, cursor.at).toPrecision(5)));
        const says = `${length} ${bench.model.unit}  ∠ ${rounded(Number(angle(from, cursor.at).toFixed(1)))}°`;
        marks.push(...tag(says, at));
    } else if (!isCross) {
        marks.push(...tag(cursor.says || `${rounded(cursor.at[0])}, ${rounded(cursor.at[1])}`, at));
    }
    const look = cursor.wheel || /^(point|bar)$/.test(cursor.snapped) ? 'catch' : 'cross';
    marks.unshift(look === 'catch' ? svg('circle', {class: 'catch', cx: at[0], cy: at[1], r: 11}) :
        svg('path', {class: 'cross', d: `M${at[0] - 9} ${at[1]}h18M${at[0]} ${at[1] - 9}v18`}));
    return marks;
}
function tag(says: string, [x, y]: [number, number]) {
    const width = says.length * 7.6 + 16;
    return [svg('rect', {class: 'tag-ground', x: x + 14, y: y - 38, width, height: 24, rx: 5}),
        svg('text', {class: 'tag-text', x: x + 14 + width / 2, y: y - 21}, says)];
}
