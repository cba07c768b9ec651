// TypeScript for Node.js, which does not read it: esbuild makes one script of it, for tests and for web/site.mjs.
import {execFileSync} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

/** What the modules of this folder export: await compiled('src/model.ts', 'src/edit.ts'). */
export async function compiled(...paths) {
    const folder = mkdtempSync(join(tmpdir(), 'kinegraph-script-')), script = join(folder, 'script.mjs');
    try {
        const to = ['--bundle', '--format=esm', '--target=node18', '--log-level=warning', `--outfile=${script}`];
        execFileSync('esbuild', to, {
            cwd: fileURLToPath(new URL('.', import.meta.url)),
            input: paths.map((path) => `export * from './${path}';`).join('\n'),
            stdio: ['pipe', 'inherit', 'inherit'],
        });
        return await import(pathToFileURL(script).href);
    } finally {
        rmSync(folder, {recursive: true});
    }
}
