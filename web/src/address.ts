// What the page's address asks besides the link behind its # (link.js): `file=PATH`, a file of the same server;
// `mode=NAME`, the mode to begin in; `compact`, the view for a frame in a page of others, where nothing is drawn.
import {byId} from './dom';

const asked = new URLSearchParams(location.search);

/** The file, absolute, and its name; null: none is asked, or one of another server. */
export function fileAsked() {
    const path = asked.get('file');
    if (!path) return null;
    const address = new URL(path, location.href);
    return address.origin === location.origin
        ? {address, name: address.pathname.slice(address.pathname.lastIndexOf('/') + 1)}
        : null;
}
/** @param modes those that there are */
export function modeAsked(modes: string[]) {
    const mode = asked.get('mode') ?? '';
    return modes.includes(mode) ? mode : asked.has('compact') ? 'move' : 'build';
}
/** Shows the compact view if it is asked; from there a link leads to the whole page. */
export function showCompact() {
    if (!asked.has('compact')) return;
    document.documentElement.dataset.view = 'compact';
    const link: HTMLAnchorElement = byId('edit-here');
    link.hidden = false;
    const follow = () => {
        const whole = new URL(location.href);
        for (const each of ['compact', 'mode']) whole.searchParams.delete(each);
        link.href = whole.href;
    };
    window.addEventListener('hashchange', follow);
    follow();
}
