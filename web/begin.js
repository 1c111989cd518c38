// How does the module come in? In pieces, as the page is read: each is unpacked and compiled while the next is read.
"use strict";
const { piece, compiled } = (() => {
  const unpacking = new DecompressionStream("gzip");
  const packed = unpacking.writable.getWriter();
  const compiled = WebAssembly.compileStreaming(
    new Response(unpacking.readable, { headers: { "content-type": "application/wasm" } }),
  );
  compiled.catch(() => {}); // told where it is waited for

  const decoded = (text) => {
    if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
    const letters = atob(text);
    const bytes = new Uint8Array(letters.length);
    for (let at = 0; at < letters.length; at += 1) bytes[at] = letters.charCodeAt(at);
    return bytes;
  };

  /** Takes the piece that stands before the script that calls it; the last one ends the module. */
  const piece = (isLast) => {
    packed.write(decoded(document.currentScript.previousElementSibling.textContent)).catch(() => {});
    if (isLast) packed.close().catch(() => {});
  };
  return { piece, compiled };
})();
