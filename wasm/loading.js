// Compiling the modules of the package, wherever their bytes are.

/**
 * Compiles a module. source: a compiled module, bytes, a response, or an address that is absolute or relative to this
 * file.
 */
export async function compiled(source) {
  if (source instanceof WebAssembly.Module) {
    return source;
  }
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) {
    return WebAssembly.compile(source);
  }
  if (typeof Response !== "undefined" && source instanceof Response) {
    return WebAssembly.compile(await source.arrayBuffer());
  }
  const address = new URL(source, import.meta.url);
  if (address.protocol === "file:") {
    // Bundlers would look for a module with a literal name, and browsers lack this one.
    const files = "node:fs/promises", { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ files);
    return WebAssembly.compile(await readFile(address));
  }
  const answer = await fetch(address);
  if (!answer.ok) {
    throw new Error(`${address}: ${answer.status} ${answer.statusText}`);
  }
  return WebAssembly.compile(await answer.arrayBuffer());
}
