// SPDX-License-Identifier: Apache-2.0
// Answers requests for the files of one folder.
import { readFileSync } from "node:fs";
import { readFile, realpath, stat } from "node:fs/promises";
import { extname, join, sep } from "node:path";
import { promisify } from "node:util";
import { brotliCompress, constants, gzip } from "node:zlib";

const mimeTypes = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".css": "text/css; charset=utf-8",
  ".json": "application/json; charset=utf-8",
  ".webmanifest": "application/manifest+json; charset=utf-8",
  ".svg": "image/svg+xml; charset=utf-8",
  ".txt": "text/plain; charset=utf-8",
  ".wasm": "application/wasm",
  ".png": "image/png",
  ".webp": "image/webp",
  ".ico": "image/x-icon",
  ".inkflate": "application/vnd.inkflate+zip",
};
const compressible = /^(text\/|image\/svg|application\/(json|manifest|wasm))/;

/** What a browser is told about a file of this name. */
export function mimeTypeOf(name) {
  return mimeTypes[extname(name).toLowerCase()] ?? "application/octet-stream";
}

const policy = JSON.parse(readFileSync(new URL("content-policy.json", import.meta.url), "utf8"));

/** frame-ancestors only counts in a header; all else stands in the page as well. */
export const contentPolicy = Object.entries({ ...policy, "frame-ancestors": "'none'" })
  .map(([name, value]) => `${name} ${value}`)
  .join("; ");

const commonHeaders = {
  "Content-Security-Policy": contentPolicy,
  "Cross-Origin-Opener-Policy": "same-origin",
  "Cross-Origin-Resource-Policy": "same-origin",
  "Referrer-Policy": "no-referrer",
  "X-Content-Type-Options": "nosniff",
};

/** The file that a request's target names; null: none within the folder. */
export async function fileOf(folder, target) {
  let path;
  try {
    path = decodeURIComponent(target.split(/[?#]/, 1)[0]);
  } catch {
    return null;
  }
  if (!path.startsWith("/") || /[\0\\]/.test(path) || path.split("/").includes("..")) return null;
  const inside = await realpath(folder);
  const wanted = join(inside, path.endsWith("/") ? `${path}index.html` : path);
  try {
    // A link inside the folder may lead out of it.
    const found = await realpath(wanted);
    return found.startsWith(inside + sep) && (await stat(found)).isFile() ? found : null;
  } catch {
    return null;
  }
}

const compress = {
  br: (bytes) =>
    promisify(brotliCompress)(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: 9 } }),
  gzip: promisify(gzip),
};

/** The best coding that a client takes: "br", "gzip", or null. */
export function codingFor(accepted) {
  const names = String(accepted ?? "")
    .split(",")
    .map((each) => each.trim())
    .filter((each) => !/;\s*q=0(\.0*)?$/.test(each))
    .map((each) => each.split(";")[0]);
  return ["br", "gzip"].find((each) => names.includes(each)) ?? null;
}

/** A listener for node's http server. Keeps what it has compressed for as long as the file stays as it was. */
export function serveFolder(folder) {
  const cache = new Map();

  async function bodyOf(path, coding) {
    const { mtimeMs, size } = await stat(path);
    const tag = `"${size.toString(36)}-${Math.trunc(mtimeMs).toString(36)}${coding ?? ""}"`;
    const key = `${coding} ${path}`;
    const known = cache.get(key);
    if (known?.tag === tag) return known;
    const bytes = await readFile(path);
    const made = { tag, bytes: coding === null ? bytes : await compress[coding](bytes) };
    cache.set(key, made);
    return made;
  }

  async function answer(request, response) {
    const refuse = (status, text, more = {}) => {
      response.writeHead(status, {
        ...commonHeaders,
        ...more,
        "Content-Type": "text/plain; charset=utf-8",
      });
      response.end(`${text}\n`);
    };
    if (request.method !== "GET" && request.method !== "HEAD") {
      return refuse(405, "only GET and HEAD", { Allow: "GET, HEAD" });
    }
    const path = await fileOf(folder, request.url ?? "/");
    if (path === null) return refuse(404, "not found");
    const type = mimeTypeOf(path);
    const coding = compressible.test(type) ? codingFor(request.headers["accept-encoding"]) : null;
    const { tag, bytes } = await bodyOf(path, coding);
    const headers = {
      ...commonHeaders,
      "Content-Type": type,
      // Asked for again each time, so that a new build is seen at once; the answer is short when nothing has changed.
      "Cache-Control": "no-cache",
      ETag: tag,
      Vary: "Accept-Encoding",
    };
    if (request.headers["if-none-match"] === tag) {
      response.writeHead(304, headers);
      return response.end();
    }
    if (coding !== null) headers["Content-Encoding"] = coding;
    response.writeHead(200, { ...headers, "Content-Length": bytes.length });
    response.end(request.method === "HEAD" ? undefined : bytes);
  }

  return (request, response) => {
    answer(request, response).catch(() => {
      if (!response.headersSent) response.writeHead(500, commonHeaders);
      response.end();
    });
  };
}
