// How does something leave the page? As files, several of them in an archive, and as a link that carries the layout.
const save = (() => {
  const TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
    let rest = byte;
    for (let bit = 0; bit < 8; bit += 1) rest = rest & 1 ? 0xedb88320 ^ (rest >>> 1) : rest >>> 1;
    return rest >>> 0;
  });
  const crc = (bytes) => {
    let rest = 0xffffffff;
    for (const byte of bytes) rest = TABLE[(rest ^ byte) & 255] ^ (rest >>> 8);
    return (rest ^ 0xffffffff) >>> 0;
  };
  const numbers = (...pairs) => {
    const out = new Uint8Array(pairs.reduce((sum, [, size]) => sum + size, 0));
    let at = 0;
    for (const [value, size] of pairs) {
      for (let byte = 0; byte < size; byte += 1) out[at + byte] = Math.floor(value / 256 ** byte) % 256;
      at += size;
    }
    return out;
  };
  const JANUARY = 0x21; // 1980-01-01, the first day that an archive knows: the same files make the same archive
  /** A ZIP archive of files that are stored as they are. */
  const zip = (files) => {
    const [parts, directory] = [[], []];
    let at = 0;
    for (const { name, text } of files) {
      const [title, bytes] = [name, text].map((one) => new TextEncoder().encode(one));
      const common = [[0x800, 2], [0, 2], [0, 2], [JANUARY, 2], [crc(bytes), 4], [bytes.length, 4], [bytes.length, 4], [title.length, 2], [0, 2]];
      const head = numbers([0x04034b50, 4], [20, 2], ...common);
      directory.push(numbers([0x02014b50, 4], [20, 2], [20, 2], ...common, [0, 2], [0, 2], [0, 2], [0, 4], [at, 4]), title);
      parts.push(head, title, bytes);
      at += head.length + title.length + bytes.length;
    }
    const size = directory.reduce((sum, { length }) => sum + length, 0);
    const end = numbers([0x06054b50, 4], [0, 2], [0, 2], [files.length, 2], [files.length, 2], [size, 4], [at, 4], [0, 2]);
    return new Blob([...parts, ...directory, end], { type: "application/zip" });
  };

  const blob = (name, content) => {
    const link = make("a", { download: name, href: URL.createObjectURL(content) });
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  };
  const through = (bytes, stream) => new Response(new Blob([bytes]).stream().pipeThrough(stream));

  return {
    blob,
    text: (name, text) => blob(name, new Blob([text], { type: "text/plain;charset=utf-8" })),
    zip: (name, files) => blob(name, zip(files)),
    /** A text as letters that may stand in a link. */
    packed: async (text) => {
      const bytes = new Uint8Array(await through(text, new CompressionStream("deflate-raw")).arrayBuffer());
      const letters = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
      return letters.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
    },
    unpacked: async (letters) => {
      const bytes = Uint8Array.from(atob(letters.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
      return through(bytes, new DecompressionStream("deflate-raw")).text();
    },
  };
})();
