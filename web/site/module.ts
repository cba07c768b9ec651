// The module as a function: text of a request in, text of its answer out. For the worker, and for tests in Node.js.

/** What the module's standard library asks of a system. It has no files and no arguments; what it writes is dropped. */
const badDescriptor = 8, done = 0;

/** What web/module/entry.cpp exports. Places are bytes of the memory. */
interface Exports {
    memory: WebAssembly.Memory;
    _initialize?(): void;
    /** Where the text of a request of so many bytes goes. */
    kinegraph_request(length: number): number;
    /** Answers it, and gives the length of the answer. */
    kinegraph_answer(): number;
    /** Where the answer begins. */
    kinegraph_text(): number;
}
export interface Answering {
    (request: string): string;
    /** Bytes of memory. */
    size(): number;
}

export async function openModule(compiled: WebAssembly.Module): Promise<Answering> {
    const view = () => new DataView(of.memory.buffer);
    const wasi = {
        fd_close: () => badDescriptor,
        fd_read: () => badDescriptor,
        fd_seek: () => badDescriptor,
        fd_write: (_file: number, pieces: number, count: number, written: number) => {
            let size = 0;
            for (let i = 0; i < count; ++i) size += view().getUint32(pieces + 8 * i + 4, true);
            view().setUint32(written, size, true);
            return done;
        },
        environ_sizes_get: (count: number, size: number) => {
            view().setUint32(count, 0, true);
            view().setUint32(size, 0, true);
            return done;
        },
        environ_get: () => done,
        clock_time_get: (_clock: number, _precision: bigint, time: number) => {
            view().setBigUint64(time, 0n, true);
            return done;
        },
        proc_exit: (code: number) => {
            throw new Error(`exit ${code}`);
        },
    };
    const instance = await WebAssembly.instantiate(compiled, {
        wasi_snapshot_preview1: wasi,
        env: {emscripten_notify_memory_growth: () => {}, __call_sighandler: () => {}},
    });
    const of = instance.exports as unknown as Exports;
    of._initialize?.();
    const encoder = new TextEncoder(), decoder = new TextDecoder();
    const answer = (request: string) => {
        const bytes = encoder.encode(request);
        const at = of.kinegraph_request(bytes.length);
        new Uint8Array(of.memory.buffer, at, bytes.length).set(bytes);
        const length = of.kinegraph_answer();
        return decoder.decode(new Uint8Array(of.memory.buffer, of.kinegraph_text(), length));
    };
    return Object.assign(answer, {size: () => of.memory.buffer.byteLength});
}
