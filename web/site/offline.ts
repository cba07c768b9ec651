// The service worker: keeps the whole site, so that it works without a network. Another version replaces the files of
// this one as a whole. web/site.mjs defines the two constants.
declare const siteVersion: string, siteFiles: string[];

/** What a service worker has; TypeScript's own names of it exclude those of a page. */
interface Extendable {
    waitUntil(done: Promise<unknown>): void;
}
interface Fetching {
    request: Request;
    respondWith(response: Promise<Response>): void;
}
interface ServiceWorkerScope {
    addEventListener(name: 'install' | 'activate', act: (event: Extendable) => void): void;
    addEventListener(name: 'fetch', act: (event: Fetching) => void): void;
    skipWaiting(): Promise<void>;
    location: Location;
    clients: {claim(): Promise<void>};
}
const worker = self as unknown as ServiceWorkerScope;

worker.addEventListener('install', (event) => {
    event.waitUntil(caches.open(siteVersion).then((cache) => cache.addAll(siteFiles)).then(() => worker.skipWaiting()));
});
worker.addEventListener('activate', (event) => {
    const leave = async () => {
        for (const name of await caches.keys()) if (name !== siteVersion) await caches.delete(name);
        await worker.clients.claim();
    };
    event.waitUntil(leave());
});
worker.addEventListener('fetch', (event) => {
    if (event.request.method !== 'GET' || new URL(event.request.url).origin !== worker.location.origin) return;
    event.respondWith(
        caches
            .match(event.request, {cacheName: siteVersion, ignoreSearch: true})
            .then((kept) => kept ?? fetch(event.request))
    );
});

export {};
