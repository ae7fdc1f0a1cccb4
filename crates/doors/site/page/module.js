// Loading of the module: once for a page, whatever number of workers share it.

const loaded = new Map();

/** The compiled module at `address`. `hear` is told how many of its bytes have come. */
export function loadModule(address, hear) {
  const key = String(address);
  if (!loaded.has(key)) {
    const loading = load(address, hear);
    // The next try may have more luck.
    loading.catch(() => loaded.delete(key));
    loaded.set(key, loading);
  }
  return loaded.get(key);
}

async function load(address, hear) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address}: the server says ${response.status}; is lunoid.wasm beside lunoid.js?`);
  const total = Number(response.headers.get("content-length")) || null;
  const counted = new TransformStream({
    bytes: 0,
    transform(piece, controller) {
      this.bytes += piece.length;
      hear({ phase: "loading", bytes: this.bytes, total });
      controller.enqueue(piece);
    },
  });
  // Compiled while it comes; the type is ours, since not every server knows it.
  const body = response.body.pipeThrough(counted);
  const module = await WebAssembly.compileStreaming(new Response(body, { headers: { "content-type": "application/wasm" } }));
  hear({ phase: "compiled" });
  return module;
}
