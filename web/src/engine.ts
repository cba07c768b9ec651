// The engine: the program that serves this page, or WebAssembly in a worker. Both answer the same
// (app/workbench/protocol.d.ts).
import type {Answer, Request} from '../../app/workbench/protocol';

export interface ServedFile {
    name: string;
    text: string | null;
    fault?: string;
}
export interface Saved {
    saved?: boolean;
    fault?: string;
    /** What the file has become meanwhile; null: it is gone. */
    text?: string | null;
}
export interface Engine {
    answer(request: Request): Promise<Answer>;
    /** The file that the page was opened for, if there is one. */
    file(): Promise<ServedFile | null>;
    /** Writes that file, where it can be done. */
    save: ((text: string, base: string | null) => Promise<Saved>) | null;
}
