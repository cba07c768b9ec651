// The keys of the page, and its menu.

/** @typedef {import('./page.js').Page} Page */

export class Keys {
    /** @param {Page} page */
    constructor(page) {
        this.page = page;
    }
    wire() {
        const {page} = this;
        page.at('menu-button').onclick = () => this.openMenu(page.at('menu').hidden);
        document.addEventListener('pointerdown', (event) => {
            if (!page.at('bar').contains(event.target)) this.openMenu(false);
        });
        document.addEventListener('keydown', (event) => this.onKey(event));
    }
    /** @param {boolean} isOpen */
    openMenu(isOpen) {
        this.page.at('menu').hidden = !isOpen;
        this.page.at('menu-button').setAttribute('aria-expanded', String(isOpen));
        document.documentElement.classList.toggle('menu-open', isOpen);
    }
    /** @param {KeyboardEvent} event */
    onKey(event) {
        const target = /** @type {HTMLElement} */ (event.target);
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        if (event.key === 'Escape') return this.escape();
        if (this.page.mode === 'try' || target.matches('input:not([type=range]), select')) return;
        if (target.matches('[type=range]') && !event.key.startsWith('Page')) return;
        const actions = /** @type {Record<string, () => void>} */ ({
            'ArrowRight': () => this.page.at('next')?.click(),
            'PageDown': () => this.page.at('next')?.click(),
            'n': () => this.page.at('next')?.click(),
            'ArrowLeft': () => this.page.at('previous')?.click(),
            'PageUp': () => this.page.at('previous')?.click(),
            'p': () => this.page.at('previous')?.click(),
            'Home': () => this.page.showStep(0),
            'End': () => this.page.showStep(this.page.says.length - 1),
            ' ': () => this.page.at('play')?.click(),
            '0': () => this.page.at('drawn')?.click(),
            'm': () => this.page.at('ruler').click(),
            'v': () => this.page.at('values')?.click(),
            'h': () => this.page.at('hall')?.click(),
        });
        const action = actions[event.key];
        if (!action || (event.key === ' ' && target.matches('button, [tabindex]'))) return;
        event.preventDefault();
        action();
    }
    /** Closes what is open, the last first. */
    escape() {
        if (!this.page.at('menu').hidden) return this.openMenu(false);
        if (this.page.mode === 'try') return this.page.setMode('steps');
        if (this.page.ruler.isOn) return this.page.ruler.turn(false);
        if (this.page.hall.isOn) return this.page.hall.turn(false);
        if (this.page.says.length > 0) this.page.showStep(-1);
    }
}
