// SPDX-License-Identifier: Apache-2.0
// node serve.mjs [FOLDER] [--port N] [--host NAME]: shows the studio in FOLDER (build/studio) until Ctrl+C.
import { createServer } from "node:http";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { serveFolder } from "./static-files.mjs";

const usage = "usage: serve.mjs [FOLDER] [--port N] [--host NAME]";
/** So many ports after the wanted one are tried. */
const portsToTry = 20;

function readArguments() {
  try {
    const { values, positionals } = parseArgs({
      allowPositionals: true,
      options: {
        port: { type: "string", default: "8484" },
        host: { type: "string", default: "127.0.0.1" },
      },
    });
    const port = Number(values.port);
    if (!Number.isInteger(port) || port < 0 || port > 65535) throw new Error("no such port");
    if (positionals.length > 1) throw new Error("one folder");
    const folder =
      positionals[0] ?? fileURLToPath(new URL("../../../build/studio", import.meta.url));
    return { port, host: values.host, folder };
  } catch (error) {
    console.error(`${error.message}\n${usage}`);
    process.exit(2);
  }
}

/** Listens at the wanted port, or the next free one. */
function listen(server, port, host) {
  return new Promise((resolve, reject) => {
    let tried = 0;
    server.on("error", (error) => {
      if (error.code !== "EADDRINUSE" || ++tried >= portsToTry) return reject(error);
      server.listen(port + tried, host);
    });
    server.on("listening", () => resolve(server.address().port));
    server.listen(port, host);
  });
}

function stopOnSignal(server) {
  for (const signal of ["SIGINT", "SIGTERM"]) {
    process.on(signal, () => {
      server.close();
      process.exit(0);
    });
  }
}

const { port, host, folder } = readArguments();
const server = createServer(serveFolder(folder));
stopOnSignal(server);
try {
  const found = await listen(server, port, host);
  // Service workers and pickers of files need a secure place: browsers take localhost for one.
  const name = host === "127.0.0.1" ? "localhost" : host;
  console.log(`Inkflate studio: http://${name}:${found}/ (Ctrl+C ends it)`);
} catch (error) {
  console.error(`cannot listen at ${host}:${port}: ${error.message}`);
  process.exit(4);
}
