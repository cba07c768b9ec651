// Hall mode: the page for a projector. Full screen, one statement in large letters, a pointer that a hall sees; the
// strokes of the next step stand there in grey before it is taken. The style sheet does the rest.

/** @typedef {import('./page.js').Page} Page */

export class Hall {
    /** @param {Page} page */
    constructor(page) {
        this.page = page;
        this.isOn = false;
        /** @type {HTMLElement | null} */
        this.pointer = null;
    }
    wire() {
        const button = this.page.at('hall');
        if (!button) return;
        button.onclick = () => this.turn(!this.isOn);
        document.addEventListener('fullscreenchange', () => {
            if (this.isOn && !document.fullscreenElement) this.turn(false);
        });
        document.addEventListener('pointermove', ({clientX, clientY}) => {
            if (!this.pointer) return;
            this.pointer.style.left = `${clientX}px`;
            this.pointer.style.top = `${clientY}px`;
        });
    }
    /** @param {boolean} isOn */
    turn(isOn) {
        const {page} = this, root = document.documentElement;
        this.isOn = isOn;
        root.classList.toggle('hall', isOn);
        page.at('hall').setAttribute('aria-pressed', String(isOn));
        this.pointer?.remove();
        this.pointer = null;
        if (isOn) {
            this.pointer = document.body.appendChild(document.createElement('div'));
            this.pointer.id = 'pointer';
            if (page.step < 0) page.steps.at = 0;
            page.showStep(page.step, false);
            // Where full screen is refused the window is used as it is.
            root.requestFullscreen?.().catch(() => {});
        } else if (document.fullscreenElement) {
            document.exitFullscreen();
        }
        page.stage.layOut();
        page.steps.fitSentence();
    }
}
