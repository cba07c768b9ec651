// The worker of the static site: answers requests, texts of JSON, in their order.
import {Decompress} from 'fzstd';
import {openModule} from './module';

/** The module unpacks as it arrives, and is compiled as it unpacks. */
async function compile() {
    const {body, ok, status} = await fetch('kinegraph.wasm.zst');
    if (!ok || !body) throw new Error(`kinegraph.wasm.zst: ${status}`);
    let unpack: Decompress;
    const unpacked = body.pipeThrough(new TransformStream<Uint8Array, Uint8Array>({
        start: (out) => void (unpack = new Decompress((bytes) => out.enqueue(bytes))),
        transform: (bytes) => unpack.push(bytes),
        flush: () => unpack.push(new Uint8Array(), true),
    }));
    return WebAssembly.compileStreaming(new Response(unpacked, {headers: {'Content-Type': 'application/wasm'}}));
}
const compiled = compile();
let engine = compiled.then(openModule);

async function answer(request: string) {
    try {
        self.postMessage(JSON.parse((await engine)(request)));
    } catch (error) {
        // Memory or stack ran out, say. What is left of the module is not used again.
        engine = compiled.then(openModule);
        self.postMessage({faults: [], remarks: [], unsolved: [], title: '', failure: String(error)});
    }
}
self.addEventListener('message', ({data}) => void answer(data));
