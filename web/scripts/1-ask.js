// How does the page ask? One question at a time, to a worker that is started anew where it hangs.
const $ = (id) => document.getElementById(id);
const make = (name, properties = {}, ...inside) => {
  const element = Object.assign(document.createElement(name), properties);
  element.append(...inside);
  return element;
};

const TOO_LONG = 2000; // ms after which a newer question does not wait for an older one

const unpacked = async () => {
  const packed = Uint8Array.from(atob($("module").textContent.trim()), (letter) => letter.charCodeAt(0));
  const bytes = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(bytes).arrayBuffer());
};

const asker = async () => {
  const program = await unpacked();
  const address = URL.createObjectURL(new Blob([$("worker").textContent], { type: "text/javascript" }));
  const waiting = new Map();
  let worker;
  let number = 0;
  let oldest = 0;

  const begin = () =>
    new Promise((resolve, reject) => {
      worker = new Worker(address);
      worker.onerror = (event) => reject(new Error(event.message));
      worker.onmessage = ({ data }) => {
        if (data.ready) return resolve();
        const told = waiting.get(data.id);
        waiting.delete(data.id);
        oldest = performance.now();
        told?.(data);
      };
      worker.postMessage({ program });
    });
  await begin();

  /** The answer: `{ ok }`, `{ mistake }`, `{ fault }`, or nothing where a newer question took its place. */
  return async (question) => {
    if (waiting.size > 0 && performance.now() - oldest > TOO_LONG) {
      worker.terminate();
      for (const told of waiting.values()) told({});
      waiting.clear();
      await begin();
    }
    if (waiting.size === 0) oldest = performance.now();
    const id = ++number;
    const data = await new Promise((resolve) => {
      waiting.set(id, resolve);
      worker.postMessage({ id, question: JSON.stringify(question) });
    });
    if (data.fault !== undefined) return { fault: data.fault };
    return data.answer === undefined ? undefined : { ...JSON.parse(data.answer), took: data.took };
  };
};
