// A page that is served while its file is watched: polls for changes, shows the faults of the file, and is replaced by
// its next version, which starts from the same state. Uses only the public state of the page.

/**
 * A fault, by language its text.
 * @typedef {{line?: number, column?: number, where: string, [language: string]: string | number | undefined}} FileFault
 */

class Watching {
    constructor() {
        /** @type {any} */
        this.page = /** @type {any} */ (window).kinegraph ?? null;
        this.data = JSON.parse(/** @type {HTMLElement} */ (document.getElementById('data')).textContent ?? '');
        /** @type {FileFault[]} */
        this.faults = [];
        this.isLost = false;
        this.place = document.createElement('section');
        this.place.id = 'faults';
        this.place.setAttribute('role', 'alert');
        this.place.hidden = true;
        document.body.append(this.place);
    }
    start() {
        const key = location.pathname, kept = sessionStorage.getItem(key);
        sessionStorage.removeItem(key);
        if (kept !== null && this.page) {
            const {page, scroll} = JSON.parse(kept);
            this.page.takeUp(page);
            window.scrollTo(0, scroll);
        }
        document.addEventListener('languagechosen', () => this.show());
        this.ask();
    }
    async ask() {
        const before = JSON.stringify([this.faults, this.isLost]);
        try {
            const answer = await fetch('news');
            if (!answer.ok) throw new Error(answer.statusText);
            const news = await answer.json();
            if (news.page !== this.data.served) return this.giveWay();
            this.faults = news.faults;
            this.isLost = false;
        } catch {
            this.isLost = true;
        }
        if (JSON.stringify([this.faults, this.isLost]) !== before) this.show();
        setTimeout(() => this.ask(), this.isLost ? 2000 : 400);
    }
    giveWay() {
        if (this.page) {
            sessionStorage.setItem(
                location.pathname,
                JSON.stringify({page: this.page.whereItIs(), scroll: window.scrollY}),
            );
        }
        location.reload();
    }
    /** @param {string} key */
    word(key) {
        return this.data.words[this.language][key];
    }
    get language() {
        return document.documentElement.lang;
    }
    show() {
        const {place, faults} = this;
        place.hidden = faults.length === 0 && !this.isLost;
        place.textContent = '';
        const line = (/** @type {string} */ tag, /** @type {string} */ text) => {
            const node = document.createElement(tag);
            node.textContent = text;
            place.append(node);
        };
        if (this.isLost) line('p', this.word('lost'));
        else if (faults.length > 0) line('p', this.word(this.page ? 'faults' : 'faults_at_first'));
        for (const fault of faults) {
            const at = fault.line === undefined ? '' :
                `${this.word('line').replace('{0}', String(fault.line)).replace('{1}', String(fault.column))}: `;
            line('p', `${at}${fault.where === '' ? '' : `${fault.where}: `}${fault[this.language]}`);
        }
    }
}

if (typeof document !== 'undefined') new Watching().start();
