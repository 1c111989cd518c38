// How does the page ask? One question at a time, to a worker that is started anew where it hangs.
const $ = (id) => document.getElementById(id);
const make = (name, properties = {}, ...inside) => {
  const element = Object.assign(document.createElement(name), properties);
  element.append(...inside);
  return element;
};

const PATIENCE = 700; // ms for which a new layout waits for a question about the last one
const TOO_LONG = 2000; // ms for which it waits for the verdict on the last one

/** Answers questions one after the other: `ask`, what is being answered (`current`), and `giveUp` of that. */
const asker = async () => {
  const address = URL.createObjectURL(new Blob([$("worker").textContent], { type: "text/javascript" }));
  const waiting = new Map(); // number → the question, and whom to tell; the first is being answered
  let worker;
  let number = 0;

  // A worker starts while the module is compiled.
  const begin = () =>
    new Promise((resolve, reject) => {
      worker = new Worker(address);
      worker.onerror = (event) => reject(new Error(event.message));
      worker.onmessage = ({ data }) => {
        if (data.ready) return resolve();
        const told = waiting.get(data.id)?.told;
        waiting.delete(data.id);
        told?.(data);
      };
      compiled.then((program) => worker.postMessage({ program }), reject);
    });
  let ready = begin();
  await ready;

  const current = () => waiting.keys().next().value;
  /** Ends the worker over a question that it is still at, and asks the others of a new one. */
  const giveUp = async (id) => {
    if (id === undefined || current() !== id) return;
    worker.terminate();
    const { told } = waiting.get(id);
    waiting.delete(id);
    ready = begin();
    await ready;
    for (const [other, { question }] of waiting) worker.postMessage({ id: other, question });
    told({});
  };

  /** The answer: `{ ok }`, `{ mistake }`, `{ fault }`, or nothing where the question was given up. */
  const ask = async (question, isUrgent = false) => {
    for (let known; known !== ready; ) await (known = ready);
    const id = ++number;
    const ahead = current();
    if (isUrgent && ahead !== undefined) setTimeout(() => giveUp(ahead), PATIENCE);
    const data = await new Promise((told) => {
      const written = JSON.stringify(question);
      waiting.set(id, { question: written, told });
      worker.postMessage({ id, question: written });
    });
    if (data.fault !== undefined) return { fault: data.fault };
    return data.answer === undefined ? undefined : { ...JSON.parse(data.answer), took: data.took };
  };
  return { ask, current, giveUp };
};
