// Starts the page in a browser; elsewhere, the modules are only read.
import {Page} from './page.js';

if (typeof document !== 'undefined') {
    const page = new Page();
    page.start();
    Object.assign(window, {kinegraph: page});
}
