// The service worker: keeps the whole site, so that it works without a network. `files` and `version` are filled by
// web/site.mjs; another version replaces the files of this one as a whole.
const version = '{version}';
const files = ['{files}'];
/** @type {any} */
const worker = self;

worker.addEventListener('install', (/** @type {any} */ event) => {
    event.waitUntil(caches.open(version).then((cache) => cache.addAll(files)).then(() => worker.skipWaiting()));
});
worker.addEventListener('activate', (/** @type {any} */ event) => {
    const leave = async () => {
        for (const name of await caches.keys()) if (name !== version) await caches.delete(name);
        await worker.clients.claim();
    };
    event.waitUntil(leave());
});
worker.addEventListener('fetch', (/** @type {any} */ event) => {
    if (event.request.method !== 'GET' || new URL(event.request.url).origin !== worker.location.origin) return;
    event.respondWith(
        caches
            .match(event.request, {cacheName: version, ignoreSearch: true})
            .then((kept) => kept ?? fetch(event.request))
    );
});
