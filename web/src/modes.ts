// The modes: Build, and the views of the solution; Move, Steps and Try it are the live page in a frame, Sheet its
// pages.
import type {Bench} from './bench';
import {byId, html} from './dom';
import {picture} from './figures';
import {word} from './words';

/** The tab of the live page that a mode shows. */
const tabs: Record<string, string> = {move: 'mode-move', steps: 'mode-steps', try: 'try'};

export class Modes {
    text = '';
    kind = '';
    liveFrame: HTMLIFrameElement | null = null;
    readonly buttons: HTMLButtonElement[];

    constructor(readonly bench: Bench) {
        this.buttons = [...byId('modes').querySelectorAll('button')];
        this.buttons.forEach((each) =>
            each.addEventListener('click', () => bench.setMode(each.dataset.mode ?? 'build'))
        );
        byId('modes').addEventListener('keydown', (event: KeyboardEvent) => this.onKey(event));
        bench.on(['mode'], () => void this.show());
    }
    names() {
        return this.buttons.map((each) => each.dataset.mode ?? '');
    }
    onKey(event: KeyboardEvent) {
        const by = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0, {length} = this.buttons;
        if (by === 0) return;
        const next =
            this.buttons[
                (this.buttons.findIndex((each) => each.dataset.mode === this.bench.mode) + by + length) % length
            ];
        next.focus();
        next.click();
    }
    async show() {
        const {mode} = this.bench, isBuild = mode === 'build';
        for (const each of this.buttons) {
            each.setAttribute('aria-selected', String(each.dataset.mode === mode));
            each.tabIndex = each.dataset.mode === mode ? 0 : -1;
        }
        document.documentElement.dataset.mode = mode;
        byId('build').hidden = !isBuild;
        byId('shown').hidden = isBuild;
        if (isBuild) return;
        byId('shown').setAttribute('aria-labelledby', `go-${mode}`);
        const kind = mode === 'sheet' ? 'sheet' : 'live',
            {text} = this.bench.document,
            {theme, language} = this.bench.inquiry;
        const key = `${kind} ${theme} ${language}`;
        if (key !== this.kind || text !== this.text) await this.load(kind, key, text);
        if (kind === 'live') this.showTab(mode);
    }
    async load(kind: 'sheet' | 'live', key: string, text: string) {
        const room = byId('shown');
        room.replaceChildren(html('p', {class: 'empty', role: 'status'}, word('working')));
        const answer = await this.bench.inquiry.other([kind], [], kind === 'live' ? {theme: 'colour'} : {});
        if (text !== this.bench.document.text || this.bench.mode === 'build') return;
        [this.kind, this.text] = [key, text];
        const faults = answer.failure ? [answer.failure] : answer.faults.map((each) => each.text);
        if (answer.live) {
            await this.frame(answer.live);
        } else if (answer.sheet) {
            room.replaceChildren(...answer.sheet.map((page, i) => picture(page, word('sheet_page', i + 1))));
        } else {
            this.kind = '';
            room.replaceChildren(
                html(
                    'div',
                    {class: 'empty', role: 'status'},
                    html('p', {}, word('not_shown')),
                    ...faults.map((each) => html('p', {}, each))
                )
            );
        }
    }
    /** The live page in a frame, without its own bar of modes. */
    async frame(page: string) {
        const frame = html('iframe', {srcdoc: page, title: word('live_page')});
        byId('shown').replaceChildren(frame);
        await new Promise((resolve) => frame.addEventListener('load', resolve, {once: true}));
        this.liveFrame = frame;
        const inside = frame.contentDocument;
        inside?.getElementById('modes')?.setAttribute('hidden', '');
        inside?.querySelectorAll('h1').forEach((each) => each.setAttribute('hidden', ''));
        // What is left of its bar, the hall and the menu, stands on the right.
        const hall = inside?.getElementById('hall');
        if (hall) hall.style.marginLeft = 'auto';
    }
    showTab(mode: string) {
        const inside = this.liveFrame?.contentDocument, tab = inside?.getElementById(tabs[mode]);
        tab?.click();
    }
}
