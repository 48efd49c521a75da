// Serves a folder on the loopback address, compressed, with the headers that a page wants:
//   node serve.mjs FOLDER [PORT]
// A module, too: tests serve what they look at.
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { join, normalize } from "node:path";
import { pathToFileURL } from "node:url";
import { brotliCompress, constants } from "node:zlib";
import { promisify } from "node:util";

const TYPES = {
  css: "text/css", data: "application/octet-stream", html: "text/html; charset=utf-8", js: "text/javascript",
  json: "application/json", mjs: "text/javascript", png: "image/png", svg: "image/svg+xml", toml: "text/plain; charset=utf-8",
  wasm: "application/wasm",
};
const COMPRESSED = new Set(["css", "data", "html", "js", "json", "svg", "toml", "wasm"]);
const compress = promisify(brotliCompress);

/** @param quality of brotli, 0 to 11 @returns the server and its address, once it listens */
export async function serve(folder, port = 0, quality = 5) {
  const kept = new Map();
  const server = createServer(async (request, response) => {
    let path = decodeURIComponent(new URL(request.url, "http://localhost").pathname);
    if (path.endsWith("/")) { path += "index.html"; }
    // nothing above the folder: `normalize` has taken every ".." away that an absolute path has
    const file = join(folder, normalize(path));
    const ending = file.split(".").pop();
    try {
      let bytes = await readFile(file);
      const headers = { "content-type": TYPES[ending] ?? "application/octet-stream", "cache-control": "no-cache", "x-content-type-options": "nosniff", "referrer-policy": "no-referrer" };
      if (COMPRESSED.has(ending) && /\bbr\b/.test(request.headers["accept-encoding"] ?? "")) {
        headers["content-encoding"] = "br";
        if (!kept.get(file)?.from.equals(bytes)) {
          kept.set(file, { from: bytes, to: await compress(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: quality } }) });
        }
        bytes = kept.get(file).to;
      }
      response.writeHead(200, { ...headers, "content-length": bytes.length });
      response.end(bytes);
    } catch {
      response.writeHead(404, { "content-type": "text/plain" });
      response.end("not found\n");
    }
  });
  await new Promise((listening, failed) => {
    server.once("error", failed);
    server.listen(port, "127.0.0.1", listening);
  });
  return { server, address: `http://127.0.0.1:${server.address().port}/` };
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  try {
    const { address } = await serve(process.argv[2], Number(process.argv[3] ?? 8000));
    console.log(address);
  } catch (error) {
    console.error(`dev: error: cannot serve: ${error.message}`);
    process.exit(2);
  }
}
