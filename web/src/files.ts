// Open, save, new, drop a file, a link: what the file is, and that nothing is lost unasked.
import {fileAsked} from './address';
import {type Bench, emptyFile} from './bench';
import {byId, download, html} from './dom';
import {fragmentOf, isLink, textOf} from './link';
import {word} from './words';

const mostBytes = 8 << 20;
/** Whether a text is meant as a mechanism file. */
const isJson = (text: string) => /^\uFEFF?\s*\{/.test(text);

export class Files {
    picker: HTMLInputElement = byId('picker');
    /** Why the last text was no link of PMKS+. */
    fault = '';
    isServed: boolean | undefined;
    timer: number | undefined;

    constructor(readonly bench: Bench) {
        this.picker.addEventListener('change', () => {
            const [file] = this.picker.files ?? [];
            this.picker.value = '';
            if (file) void this.read(file);
        });
        document.addEventListener('dragover', (event) => event.preventDefault());
        document.addEventListener('drop', (event) => {
            event.preventDefault();
            const {dataTransfer} = event, [file] = dataTransfer?.files ?? [];
            if (file) void this.read(file);
            else if (dataTransfer) void this.take(dataTransfer.getData('text/plain'));
        });
        document.addEventListener('paste', ({target, clipboardData}) => {
            const isTyping = target instanceof Element && target.matches('input, textarea');
            if (!isTyping && clipboardData) void this.take(clipboardData.getData('text/plain'));
        });
        window.addEventListener('beforeunload', (event) => bench.document.isChanged && event.preventDefault());
        window.addEventListener('hashchange', () => void this.openLink());
        bench.on(['file'], () => this.showName());
    }
    /** What the page begins with: the address's mechanism, the served file, or a new one. */
    async begin() {
        if (await this.openLink() || await this.openAsked()) return;
        const file = await this.bench.engine.file();
        if (file?.fault) this.say(file.fault);
        this.isServed = Boolean(file);
        const name = file?.name ?? `${word('mechanism').toLowerCase()}.json`;
        this.bench.open(file?.text ?? emptyFile(word('untitled')), name, file?.text ?? null);
    }
    /** The address names a mechanism: opens it. A damaged one is said and leaves what is there. */
    async openLink() {
        if (!isLink(location.hash)) return false;
        const text = await textOf(location.hash);
        if (text === null) {
            this.say(word('bad_link'));
            return false;
        }
        if (!await this.mayLose()) return true;
        this.isServed = false;
        this.bench.open(text, 'mechanism.json', text);
        return true;
    }
    /** The address names a file of this server: opens it. */
    async openAsked() {
        const file = fileAsked();
        if (!file) return false;
        const response = await fetch(file.address).catch(() => null), text = response?.ok ? await response.text() : '';
        if (text === '' || text.length > mostBytes) {
            this.say(word('bad_link'));
            return false;
        }
        this.isServed = false;
        this.bench.open(text, file.name, text);
        return true;
    }
    /** Whether changes may be given up. */
    async mayLose() {
        return (
            !this.bench.document.isChanged ||
            this.bench.document.past.length === 0 ||
            this.ask(word('lose_changes'), word('go_on'))
        );
    }
    /** A question with two answers. */
    ask(text: string, yes: string) {
        const dialog: HTMLDialogElement = byId('question');
        byId('question-text').textContent = text;
        byId('question-yes').textContent = yes;
        dialog.returnValue = '';
        dialog.showModal();
        return new Promise((resolve) =>
            dialog.addEventListener('close', () => resolve(dialog.returnValue === 'yes'), {once: true})
        );
    }
    pick() {
        this.picker.click();
    }
    async read(file: File) {
        if (file.size > mostBytes) return this.say(word('too_large'));
        const text = await file.text();
        if (!isJson(text) && await this.takePmks(text, file.name)) return;
        if (!await this.mayLose()) return;
        this.isServed = false;
        this.bench.open(text, file.name, text);
    }
    /** Opens a text that was pasted or dropped: a mechanism file, or a link of PMKS+. */
    async take(text: string) {
        if (text.trim() === '' || text.length > mostBytes) return;
        if (isJson(text)) return this.openExample(text, 'mechanism.json');
        if (!await this.takePmks(text, 'mechanism.json')) this.say(this.fault);
    }
    /**
     * Makes a mechanism of a link of PMKS+ and opens it, after what changed was said. False: it is none; then `fault`
     * says why.
     */
    async takePmks(text: string, name: string) {
        const options = this.bench.inquiry.options();
        const {imported, remarks, faults, failure} = await this.bench.engine.answer({text: text.trim(), name,
            want: ['import'], options});
        this.fault = failure ?? faults[0]?.text ?? '';
        if (imported === undefined) return false;
        if (remarks.length > 0 && !await this.ask(remarks.join('\n'), word('go_on'))) return true;
        await this.openNew(imported, `${name.replace(/\.[^.]*$/, '')}.json`);
        return true;
    }
    /** Asks for a link of PMKS+. */
    async askForPmks() {
        const dialog: HTMLDialogElement = byId('import');
        const field: HTMLTextAreaElement = byId('import-text');
        field.value = dialog.returnValue = '';
        dialog.showModal();
        await new Promise((resolve) => dialog.addEventListener('close', resolve, {once: true}));
        if (dialog.returnValue === 'yes') await this.take(field.value);
    }
    async openExample(text: string, name: string) {
        if (!await this.mayLose()) return;
        this.isServed = false;
        this.bench.open(text, name, text);
    }
    startNew() {
        return this.openNew(emptyFile(word('untitled')), 'mechanism.json');
    }
    /** Opens what no disk has yet. */
    async openNew(text: string, name: string) {
        if (!await this.mayLose()) return;
        this.isServed = false;
        this.bench.open(text, name, null);
    }
    /** Saves where the page can, otherwise offers the file. */
    async save() {
        const {bench} = this, {text, base, name} = bench.document, {save} = bench.engine;
        if (!save || !this.isServed) {
            download(new Blob([text], {type: 'application/json'}), name.endsWith('.json') ? name : `${name}.json`);
            bench.document.saved(text);
            return this.showName();
        }
        const answer = await save(text, base);
        if (answer.saved) {
            bench.document.saved(text);
            this.say(word('saved', name));
        } else if ('text' in answer) {
            const keepMine = await this.ask(word('changed_elsewhere', name), word('overwrite'));
            if (!keepMine) return;
            bench.document.base = answer.text ?? null;
            await this.save();
        } else {
            this.say(answer.fault ?? word('engine_lost'));
        }
        this.showName();
    }
    async copyLink() {
        const fragment = await fragmentOf(this.bench.document.text),
            address = location.href.replace(/#.*/, '') + fragment;
        history.replaceState(null, '', fragment);
        try {
            await navigator.clipboard.writeText(address);
            this.say(word('link_copied'));
        } catch {
            this.say(word('link_in_address'));
        }
    }
    showName() {
        const {bench} = this,
            {title} = bench.model.file,
            {language} = bench.inquiry;
        const text = typeof title === 'string' ? title : (title?.[language] ?? title?.en ?? ''),
            {name, isChanged} = bench.document;
        const shown = text || name || word('untitled');
        byId('name').textContent = shown;
        byId('name').title = name;
        byId('changed').hidden = !isChanged;
        document.title = `${isChanged ? '• ' : ''}${shown} – Kinegraph`;
        byId<HTMLButtonElement>('undo').disabled = bench.document.past.length === 0;
        byId<HTMLButtonElement>('redo').disabled = bench.document.future.length === 0;
    }
    say(text: string) {
        const notice = byId('notice');
        notice.replaceChildren(html('span', {}, text));
        notice.hidden = false;
        clearTimeout(this.timer);
        this.timer = setTimeout(() => (notice.hidden = true), 6000);
    }
}
