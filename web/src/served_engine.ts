// The engine in the program `kinegraph edit`, which serves this page.
import type {Engine} from './engine';
import type {Json} from './json_text';

async function post(path: string, body: Json) {
    const response = await fetch(path, {
        method: 'POST',
        headers: {'Content-Type': 'application/json'},
        body: JSON.stringify(body)
    });
    if (!response.ok && response.status !== 409 && response.status !== 500) throw new Error(String(response.status));
    return response.json();
}

export function open(): Engine {
    return {
        answer: async (request) => {
            try {
                return await post('answer', request);
            } catch (error) {
                return {faults: [], remarks: [], unsolved: [], title: '', failure: String(error)};
            }
        },
        file: async () => (await fetch('file.json')).json(),
        save: async (text, base) => {
            try {
                return await post('save', {text, base});
            } catch (error) {
                return {fault: String(error)};
            }
        },
    };
}
