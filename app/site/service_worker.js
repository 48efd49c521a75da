// Keeps the pages that were visited, so that they are there without network; with network they are always those of the
// server. The program beside them has a service worker of its own.
// other courses may be on the same host
const CACHE = `jointwise-site ${registration.scope}`;

self.addEventListener("fetch", (event) => {
  const url = new URL(event.request.url);
  if (event.request.method !== "GET" || url.origin !== location.origin) { return; }
  event.respondWith((async () => {
    const cache = await caches.open(CACHE);
    try {
      const answer = await fetch(event.request);
      // storage may be full
      if (answer.ok) { await cache.put(event.request, answer.clone()).catch(() => {}); }
      return answer;
    } catch (error) {
      const kept = await cache.match(event.request, { ignoreSearch: true });
      if (kept) { return kept; }
      throw error;
    }
  })());
});
