// The engine: the program that serves this page, or WebAssembly in a worker. Both answer the same
// (app/workbench/protocol.d.ts).

/**
 * @typedef {import('../../app/workbench/protocol.js').Request} Request
 * @typedef {import('../../app/workbench/protocol.js').Answer} Answer
 * @typedef {{name: string, text: string | null, fault?: string}} ServedFile
 * @typedef {{answer(request: Request): Promise<Answer>, file(): Promise<ServedFile | null>,
 *     save: ((text: string, base: string | null) =>
 *         Promise<{saved?: boolean, fault?: string, text?: string | null}>) | null}} Engine
 *     file: the file that the page was opened for, if there is one; save: writes it, where that can be done
 */

/**
 * The engine that index.html names.
 * @returns {Promise<Engine>}
 */
export async function openEngine() {
    const name = document.documentElement.dataset.engine === 'worker' ? './worker_engine.js' : './served_engine.js';
    const {open} = await import(name);
    return open();
}
