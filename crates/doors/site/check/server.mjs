// A static host of one folder below a path, as strict as one can be: files of the folder alone.

import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";

const TYPES = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".json": "application/json",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
};

/** Serves `folder` below `path`; answers the address and what was asked for. */
export async function serve(folder, path) {
  const asked = [];
  const server = createServer(async (request, response) => {
    const name = decodeURIComponent(new URL(request.url, "http://host").pathname);
    asked.push(name);
    try {
      if (!name.startsWith(path)) throw new Error("another path");
      const file = normalize(join(folder, name.slice(path.length) || "index.html"));
      if (!file.startsWith(join(folder, "/"))) throw new Error("outside the folder");
      const bytes = await readFile(file);
      response.writeHead(200, { "content-type": TYPES[extname(file)] ?? "application/octet-stream", "content-length": bytes.length });
      response.end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { address: `http://127.0.0.1:${server.address().port}${path}`, asked, close: () => server.close() };
}
