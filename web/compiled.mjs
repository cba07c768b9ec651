// TypeScript for Node.js, which does not read it: esbuild makes one script of it, for tests and for web/site.mjs.
import {execFileSync} from 'node:child_process';
import {fileURLToPath} from 'node:url';

/** What the modules of this folder export: await compiled('src/model.ts', 'src/edit.ts'). */
export async function compiled(...paths) {
    const script = execFileSync('esbuild', ['--bundle', '--format=esm', '--target=node18', '--log-level=warning'], {
        cwd: fileURLToPath(new URL('.', import.meta.url)),
        input: paths.map((path) => `export * from './${path}';`).join('\n'),
    });
    return import(`data:text/javascript;base64,${script.toString('base64')}`);
}
