// Debian's chromium by playwright-core, started once for all who ask: one tab that can be touched, and what it said.
import {chromium} from 'playwright-core';

const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
const browser = await chromium.launch({executablePath, args: ['--disable-gpu', '--disable-dev-shm-usage']});
const context = await browser.newContext({hasTouch: true});
export const page = await context.newPage();
/** Chromium's own protocol, for what playwright has no word for. */
export const protocol = await context.newCDPSession(page);
/** What the page said to the console, and what was refused. */
export const messages = [];
page.on('console', (message) => messages.push(message.text()));
page.on('pageerror', (error) => messages.push(String(error)));

/** The page at an address, from where it begins; what was said before is forgotten. */
export async function open(url, {width = 1280, height = 900, dark = false} = {}) {
    messages.length = 0;
    await page.setViewportSize({width, height});
    await page.emulateMedia({colorScheme: dark ? 'dark' : 'light'});
    await page.goto(url);
}
/** The value of an expression in the page. */
export const run = (expression) => page.evaluate(expression);
export const close = () => browser.close();
