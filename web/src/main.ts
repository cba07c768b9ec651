// Puts the parts of the workbench together.
import {modeAsked, showCompact} from './address';
import {Bench} from './bench';
import {Canvas} from './canvas';
import {byId} from './dom';
import {take} from './downloads';
import type {Engine} from './engine';
import {Entry} from './entry';
import {Figures} from './figures';
import {Files} from './files';
import {Gallery} from './gallery';
import {Inspector} from './inspector';
import {Keys} from './keys';
import {Lesson} from './lesson';
import {Menus} from './menus';
import {Modes} from './modes';
import {Pointer} from './pointer';
import {preview} from './preview';
import {Status} from './status';
import {TextView} from './text_view';
import {Toolbar} from './toolbar';
import {SelectTool} from './tools';
import {dress, setWords} from './words';

/** The canvas is drawn once a frame, however much has changed. */
function drawWhenChanged(bench: Bench, root: SVGSVGElement) {
    const canvas = new Canvas(root, bench.view);
    let asked = false, drawn = false;
    const draw = () => {
        asked = false;
        if (bench.isToFit && Object.keys(bench.spots).length >= Math.min(1, bench.model.points.length)) {
            bench.isToFit = false;
            bench.fit();
        }
        if (!drawn)
            canvas.draw({
                ...bench,
                faulty: new Set(bench.answer?.faults.map(({where}) => where.split('/').slice(0, 3).join('/')))
            });
        drawn = true;
        canvas.over(...preview(bench));
    };
    const ask = (whole: boolean) => {
        drawn = drawn && !whole;
        if (!asked) requestAnimationFrame(draw);
        asked = true;
    };
    bench.on(['file', 'answer', 'selection', 'view'], () => ask(true));
    bench.on(['cursor', 'tool'], () => ask(false));
    new ResizeObserver(([{contentRect}]) => {
        const {view} = bench, isFirst = view.width <= 1, sawAll = bench.seesAll();
        // While another mode is shown the canvas has no size.
        if (contentRect.width === 0) return;
        Object.assign(view, {width: contentRect.width, height: contentRect.height});
        // Turned or made smaller, the window shows what it showed.
        if (isFirst || (sawAll && !bench.seesAll())) bench.isToFit = true;
        ask(true);
    }).observe(root);
}

/** Puts the workbench over its engine, into index.html. */
export async function start(engine: Engine) {
    const bench = new Bench(engine), root = byId<SVGSVGElement>('canvas');
    const dark = matchMedia('(prefers-color-scheme: dark)'), {inquiry} = bench;
    inquiry.language = document.documentElement.lang;
    inquiry.theme = dark.matches ? 'dark' : 'colour';
    dark.addEventListener('change', () => {
        inquiry.theme = dark.matches ? 'dark' : 'colour';
        inquiry.ask();
    });
    const {words} = await engine.answer({text: '', name: '', want: ['words'], options: {lang: inquiry.language}});
    setWords(words ?? {}, inquiry.language);
    dress(document);
    showCompact();
    const files = new Files(bench), gallery = new Gallery(bench, files), modes = new Modes(bench);
    const lesson = new Lesson(bench);
    new Toolbar(bench, root);
    new Inspector(bench);
    new TextView(bench);
    new Figures(bench);
    new Status(bench);
    new Entry(bench, root);
    new Pointer(bench, root);
    new Menus(bench);
    new Keys(bench, root, {
        z: () => bench.document.undo(), y: () => bench.document.redo(), 'shift+z': () => bench.document.redo(),
        s: () => void files.save(), o: () => files.pick(),
    });
    const acts: Record<string, () => void> = {
        undo: () => bench.document.undo(),
        redo: () => bench.document.redo(),
        open: () => files.pick(),
        link: () => void files.copyLink(),
        save: () => void files.save(),
        'new-file': () => void files.startNew(),
        'begin-lesson': () => void files.startNew().then(() => lesson.begin()),
        'from-pmks': () => void files.askForPmks(),
        examples: () => void gallery.open(),
        fit: () => bench.fit(),
        'zoom-in': () => zoom(bench, 1.25),
        'zoom-out': () => zoom(bench, 0.8),
        snap: () => {
            bench.snaps = !bench.snaps;
            bench.tell('view');
        },
    };
    for (const [id, act] of Object.entries(acts)) byId(id).addEventListener('click', act);
    for (const each of document.querySelectorAll('[data-take]'))
        each.addEventListener('click', () => {
            const {take: kind = ''} = (each as HTMLElement).dataset;
            void take(bench, kind, (text) => files.say(text));
        });
    drawWhenChanged(bench, root);
    await files.begin();
    bench.take(new SelectTool(bench));
    bench.setMode(modeAsked(modes.names()));
    document.documentElement.dataset.ready = 'true';
    Object.assign(window, {workbench: bench});
}
function zoom(bench: Bench, factor: number) {
    bench.view.zoom(factor, [bench.view.width / 2, bench.view.height / 2]);
    bench.tell('view');
}
