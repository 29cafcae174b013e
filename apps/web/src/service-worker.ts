// SPDX-License-Identifier: Apache-2.0
// Keeps all files of one build, so that the studio starts and works without a network. Another build is taken over
// only when the person says so.

declare const self: ServiceWorkerGlobalScope;

/** Written by the build: tools/studio-plugins.ts. */
declare const __INKFLATE_FILES__: {
  readonly version: string;
  /** Address from the scope on, and hash for "integrity". */
  readonly files: readonly (readonly [path: string, integrity: string])[];
};
const build = __INKFLATE_FILES__;
const home = self.registration.scope;

/** One site may hold several studios. */
const prefix = `inkflate ${home} `;
const cacheName = prefix + build.version;

/** All or nothing: a file that is not of this build, as in the midst of an upload, ends the installation. */
async function install(): Promise<void> {
  const cache = await caches.open(cacheName);
  await Promise.all(
    build.files.map(async ([path, integrity]) => {
      const url = new URL(path, home).href;
      const response = await fetch(new Request(url, { integrity, cache: "no-cache" }));
      if (!response.ok) throw new Error(`${path}: ${response.status}`);
      await cache.put(url, response);
    }),
  );
}

/** The version before stays: another tab may still show it, and fetch more of its files. */
async function removeOlder(): Promise<void> {
  const names = await caches.keys();
  const older = names.filter((name) => name.startsWith(prefix) && name !== cacheName).slice(0, -1);
  await Promise.all(older.map((name) => caches.delete(name)));
}

async function answer(request: Request): Promise<Response> {
  const cache = await caches.open(cacheName);
  // Whatever stands behind the address of the page, it is the one page; other files that are opened by themselves are those files.
  const { pathname } = new URL(request.url);
  const isPage = pathname.replace(/index\.html$/, "") === new URL(home).pathname;
  const wanted = isPage ? home : request;
  const kept = (await cache.match(wanted, { ignoreSearch: true })) ?? (await caches.match(request));
  return kept ?? fetch(request);
}

self.addEventListener("install", (event) => {
  event.waitUntil(install());
});

self.addEventListener("activate", (event) => {
  event.waitUntil(removeOlder().then(() => self.clients.claim()));
});

self.addEventListener("message", (event) => {
  if (event.data === "take over") event.waitUntil(self.skipWaiting());
});

self.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(home)) return;
  event.respondWith(answer(request));
});

// Without it the types of the page and those of this file would be the same.
export {};
