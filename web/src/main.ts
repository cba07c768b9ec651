// Starts the workbench: puts its parts together.
import {modeAsked, showCompact} from './address.js';
import {Bench} from './bench.js';
import {Canvas} from './canvas.js';
import {byId} from './dom.js';
import {take} from './downloads.js';
import {openEngine} from './engine.js';
import {Entry} from './entry.js';
import {Figures} from './figures.js';
import {Files} from './files.js';
import {Gallery} from './gallery.js';
import {Inspector} from './inspector.js';
import {Keys} from './keys.js';
import {Lesson} from './lesson.js';
import {Menus} from './menus.js';
import {Modes} from './modes.js';
import {Pointer} from './pointer.js';
import {preview} from './preview.js';
import {Status} from './status.js';
import {TextView} from './text_view.js';
import {Toolbar} from './toolbar.js';
import {SelectTool} from './tools.js';
import {dress, setWords} from './words.js';

/**
 * The canvas is drawn once a frame, however much has changed.
 * @param {Bench} bench
 * @param {SVGSVGElement} root
 */
function drawWhenChanged(bench, root) {
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
    const ask = (/** @type {boolean} */ whole) => {
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

async function start() {
    const engine = await openEngine(), bench = new Bench(engine), root = byId('canvas');
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
    /** @type {Record<string, () => void>} */
    const acts = {
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
            const {take: kind = ''} = /** @type {HTMLElement} */ (each).dataset;
            void take(bench, kind, (text) => files.say(text));
        });
    drawWhenChanged(bench, root);
    await files.begin();
    bench.take(new SelectTool(bench));
    bench.setMode(modeAsked(modes.names()));
    document.documentElement.dataset.ready = 'true';
    Object.assign(window, {workbench: bench});
}
/**
 * @param {Bench} bench
 * @param {number} factor
 */
function zoom(bench, factor) {
    bench.view.zoom(factor, [bench.view.width / 2, bench.view.height / 2]);
    bench.tell('view');
}

void start();
