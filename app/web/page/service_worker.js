// Keeps the files of the page, so that it opens without network after the first visit. All of one version are fetched
// together; the page of before goes on with those of before until it is closed.
const VERSION = "@VERSION@";
const FILES = ["@FILES@"];
// other courses may be on the same host
const OURS = `jointwise-program ${registration.scope} `;
const CACHE = OURS + VERSION;

self.addEventListener("install", (event) => {
  event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(["./", ...FILES.filter((f) => f !== "service_worker.js")])));
});

self.addEventListener("activate", (event) => {
  event.waitUntil(caches.keys().then((names) =>
    Promise.all(names.filter((n) => n.startsWith(OURS) && n !== CACHE).map((n) => caches.delete(n)))));
});

self.addEventListener("fetch", (event) => {
  if (event.request.method !== "GET" || new URL(event.request.url).origin !== location.origin) { return; }
  event.respondWith((async () => {
    const cache = await caches.open(CACHE);
    const kept = await cache.match(event.request, { ignoreSearch: true });
    if (kept) { return kept; }
    const answer = await fetch(event.request);
    // letters that only some languages need
    if (answer.ok) { await cache.put(event.request, answer.clone()).catch(() => {}); }
    return answer;
  })());
});
