// SPDX-License-Identifier: Apache-2.0
import { mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { createServer, request } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { brotliDecompressSync, gunzipSync } from "node:zlib";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { codingFor, contentPolicy, fileOf, mimeTypeOf, serveFolder } from "./static-files.mjs";

const text = "let studio = 1;\n".repeat(200);
let top;
let folder;
let server;

beforeAll(async () => {
  top = mkdtempSync(join(tmpdir(), "static-files-"));
  folder = join(top, "studio");
  mkdirSync(join(folder, "assets"), { recursive: true });
  mkdirSync(join(top, "studio-not"));
  writeFileSync(join(folder, "index.html"), "<!doctype html>");
  writeFileSync(join(folder, "assets", "app one.js"), text);
  writeFileSync(join(top, "secret.txt"), "secret");
  writeFileSync(join(top, "studio-not", "secret.txt"), "secret");
  symlinkSync(join(top, "secret.txt"), join(folder, "link.txt"));
  server = createServer(serveFolder(folder));
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
});

afterAll(() => {
  server.close();
  rmSync(top, { recursive: true });
});

/** Sends the target as it is: fetch() would tidy it first. */
function ask(path, { method = "GET", headers = {} } = {}) {
  return new Promise((resolve, reject) => {
    const { port } = server.address();
    const sent = request({ port, host: "127.0.0.1", path, method, headers }, (answer) => {
      const parts = [];
      answer.on("data", (part) => parts.push(part));
      answer.on("end", () =>
        resolve({
          status: answer.statusCode,
          headers: answer.headers,
          body: Buffer.concat(parts),
        }),
      );
    });
    sent.on("error", reject);
    sent.end();
  });
}

describe("a request", () => {
  it.each([
    "/../secret.txt",
    "/..%2fsecret.txt",
    "/%2e%2e/secret.txt",
    "/assets/../../secret.txt",
    "/..\\secret.txt",
    "/%5c..%5csecret.txt",
    "/../studio-not/secret.txt",
    "/link.txt",
    "//etc/passwd",
    "/assets",
    "/%",
    "/index.html%00.js",
    "../secret.txt",
  ])("never leaves the folder: %s", async (target) => {
    expect(await fileOf(folder, target)).toBeNull();
    expect((await ask(target)).status).toBe(target.startsWith("/") ? 404 : 400);
  });

  it("names files by their decoded path, whatever stands behind it", async () => {
    expect((await ask("/assets/app%20one.js?v=1")).body.toString()).toBe(text);
    expect((await ask("/")).body.toString()).toBe("<!doctype html>");
  });

  it("is refused when it wants to change something", async () => {
    expect((await ask("/", { method: "POST" })).status).toBe(405);
  });
});

describe("an answer", () => {
  it("carries the policy and the type, and forbids guessing another", async () => {
    const { headers } = await ask("/assets/app%20one.js");
    expect(headers["content-security-policy"]).toBe(contentPolicy);
    expect(headers["content-type"]).toBe("text/javascript; charset=utf-8");
    expect(headers["x-content-type-options"]).toBe("nosniff");
  });

  it("is compressed in the best way that the client takes", async () => {
    const both = await ask("/assets/app%20one.js", { headers: { "Accept-Encoding": "gzip, br" } });
    expect(both.headers["content-encoding"]).toBe("br");
    expect(brotliDecompressSync(both.body).toString()).toBe(text);
    const one = await ask("/assets/app%20one.js", { headers: { "Accept-Encoding": "gzip" } });
    expect(gunzipSync(one.body).toString()).toBe(text);
    expect(one.body.length).toBeLessThan(text.length / 4);
  });

  it("is empty when the client has it already", async () => {
    const first = await ask("/");
    const again = await ask("/", { headers: { "If-None-Match": first.headers.etag } });
    expect([again.status, again.body.length]).toEqual([304, 0]);
  });

  it("to HEAD has the length and no body", async () => {
    const { headers, body } = await ask("/", { method: "HEAD" });
    expect([headers["content-length"], body.length]).toEqual(["15", 0]);
  });
});

describe("mimeTypeOf", () => {
  it.each([
    ["core.wasm", "application/wasm"],
    ["sw.js", "text/javascript; charset=utf-8"],
    ["app.CSS", "text/css; charset=utf-8"],
    ["manifest.webmanifest", "application/manifest+json; charset=utf-8"],
    ["unknown.bin", "application/octet-stream"],
  ])("%s is %s", (name, type) => {
    expect(mimeTypeOf(name)).toBe(type);
  });
});

describe("codingFor", () => {
  it.each([
    ["gzip, deflate, br, zstd", "br"],
    ["br;q=0, gzip;q=0.5", "gzip"],
    ["identity", null],
    [undefined, null],
  ])("%s: %s", (accepted, coding) => {
    expect(codingFor(accepted)).toBe(coding);
  });
});
