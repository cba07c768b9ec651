// The tools as buttons, each with its sign and its key.
import type {Bench} from './bench';
import {byId, html, svg} from './dom';
import {tools} from './tools';
import {word} from './words';

/** Strokes in a square of 24. */
const signs: Record<string, string> = {
    select: 'M6 3l12 9-6 1-3 6z',
    point: 'M12 8a4 4 0 1 0 .01 0zM12 2v3M12 19v3M2 12h3M19 12h3',
    link: 'M6 15a3 3 0 1 0 .01 0zM18 3a3 3 0 1 0 .01 0zM8.1 15.9L15.9 8.1',
    plate: 'M5 19L12 5l8 11zM12 4.5h.01M20 16.5h.01M5 19.5h.01',
    ground: 'M12 4l-6 11h12zM4 15h16M7 15l-3 5M12 15l-3 5M17 15l-3 5',
    roller: 'M12 4l-6 10h12zM9 15a2 2 0 1 0 .01 0zM15 15a2 2 0 1 0 .01 0zM4 20.5h16',
    weld: 'M4 18L12 6l8 12M12 6l-4 6h8z',
    slider: 'M7 7h10v7H7zM3 18h18M6 18l-2 3M12 18l-2 3M18 18l-2 3',
    slot: 'M7 8h10a4 4 0 0 1 0 8H7a4 4 0 0 1 0-8zM9 10.5a1.5 1.5 0 1 0 .01 0z',
    gear: 'M9 6a6 6 0 1 0 .01 0zM18.5 9a3.5 3.5 0 1 0 .01 0zM9 4v2M9 18v2M1 12h2M4 7l1 1M4 17l1-1',
    rolling: 'M8 6a6 6 0 1 0 .01 0zM18 8a4 4 0 1 0 .01 0z',
    contact: 'M9 4a6 6 0 1 0 .01 0zM17.5 11a4 4 0 1 0 .01 0zM11 18l9-10',
    driver: 'M19 12a7 7 0 1 1-3-5.7M16.5 2v4.6h-4.6',
    weight: 'M9 6a3 3 0 1 1 6 0M6 9h12l2 11H4z',
    load: 'M12 3v15M7 13l5 6 5-6',
    couple: 'M6 7a8 8 0 1 1-1 9M6 3v4.5h4.5M12 12h.01',
    spring: 'M2 12h3l2-5 3 10 3-10 3 10 2-5h4',
};

export class Toolbar {
    readonly root = byId('tools');

    constructor(bench: Bench, canvas: SVGSVGElement) {
        for (const tool of tools) {
            const label = `${word(`tool_${tool.tool}`)} (${tool.key.toUpperCase()})`;
            this.root.append(
                html(
                    'button',
                    {
                        type: 'button',
                        'data-tool': tool.tool,
                        'aria-label': label,
                        title: label,
                        'aria-pressed': 'false',
                        'aria-keyshortcuts': tool.key.toUpperCase(),
                        onclick: () => {
                            bench.take(new tool(bench));
                            canvas.focus();
                        }
                    },
                    svg(
                        'svg',
                        {class: 'icon', viewBox: '0 0 24 24', 'aria-hidden': 'true'},
                        svg('path', {d: signs[tool.tool]})
                    )
                )
            );
        }
        bench.on(['tool'], () => {
            for (const each of this.root.querySelectorAll('button'))
                each.setAttribute('aria-pressed', String(each.dataset.tool === bench.tool?.name));
        });
    }
}
