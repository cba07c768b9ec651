// The menu of what can be taken away, and the tabs of the panel.
import type {Bench} from './bench';
import {byId} from './dom';

export class Menus {
    readonly tabs: HTMLButtonElement[];

    constructor(bench: Bench) {
        const more = byId('more'), menu = byId('menu');
        const show = (isOpen: boolean) => {
            menu.hidden = !isOpen;
            more.setAttribute('aria-expanded', String(isOpen));
        };
        more.addEventListener('click', () => show(menu.hidden));
        menu.addEventListener('click', () => show(false));
        // On a phone the buttons of the bar stand in the menu.
        for (const each of menu.querySelectorAll<HTMLElement>('[data-press]'))
            each.addEventListener('click', () => byId(each.dataset.press ?? '').click());
        document.addEventListener('pointerdown', (event) => {
            if (event.target instanceof Node && !menu.contains(event.target) && !more.contains(event.target))
                show(false);
        });
        document.addEventListener('keydown', (event) => {
            if (event.key !== 'Escape' || menu.hidden) return;
            show(false);
            more.focus();
        });
        this.tabs = [...byId('tabs').querySelectorAll('button')];
        for (const each of this.tabs) {
            each.addEventListener('click', () => this.choose(each));
            each.addEventListener('keydown', (event) => {
                const by = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
                if (by === 0) return;
                const seen = this.tabs.filter((tab) => tab.offsetParent !== null),
                    next = seen[(seen.indexOf(each) + by + seen.length) % seen.length];
                next.focus();
                this.choose(next);
            });
        }
        bench.on(['selection'], () => {
            if (bench.selection !== null && byId('tab-polygons').getAttribute('aria-selected') === 'true')
                this.choose(byId('tab-properties'));
        });
    }
    choose(chosen: HTMLButtonElement) {
        for (const each of this.tabs) {
            const isChosen = each === chosen;
            each.setAttribute('aria-selected', String(isChosen));
            each.tabIndex = isChosen ? 0 : -1;
            byId(each.getAttribute('aria-controls') ?? '').classList.toggle('chosen', isChosen);
        }
    }
}
