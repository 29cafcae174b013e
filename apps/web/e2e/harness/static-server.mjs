// SPDX-License-Identifier: Apache-2.0
import { spawn } from "node:child_process";
import { createServer } from "node:http";
import { serveFolder } from "../../tools/static-files.mjs";

/** Serves a folder on a free port. close() also ends the connections that are open. */
export async function serve(folder) {
  const server = createServer(serveFolder(folder));
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return {
    origin: `http://127.0.0.1:${server.address().port}`,
    close: () =>
      new Promise((resolve) => {
        server.close(resolve);
        server.closeAllConnections();
      }),
  };
}

/** The same by a server that knows nothing of the studio and sends no header of ours: Python's, as in any classroom. */
export async function servePlainly(folder) {
  const words = ["-u", "-m", "http.server", "0", "--bind", "127.0.0.1", "--directory", folder];
  const server = spawn("python3", words, { stdio: ["ignore", "pipe", "ignore"] });
  const port = await new Promise((resolve, reject) => {
    server.on("error", reject);
    server.stdout.on("data", (text) => resolve(/port (\d+)/.exec(String(text))?.[1]));
  });
  return {
    origin: `http://127.0.0.1:${port}`,
    close: () =>
      new Promise((resolve) => {
        server.on("exit", resolve);
        server.kill();
      }),
  };
}
