// The worker of the static site: answers requests, texts of JSON, in their order.
import {openModule} from './module.js';

const compiled = WebAssembly.compileStreaming(fetch('kinegraph.wasm'));
let engine = compiled.then(openModule);

self.addEventListener('message', async ({data}) => {
    let answer;
    try {
        answer = JSON.parse((await engine)(data));
    } catch (error) {
        // Memory or stack ran out, say. What is left of the module is not used again.
        engine = compiled.then(openModule);
        answer = {faults: [], remarks: [], unsolved: [], title: '', failure: String(error)};
    }
    self.postMessage(answer);
});
