// Who answers? The module, in a thread of its own, so that the page never waits for it.
"use strict";
let program; // compiled once, instantiated again where it stopped
let exports;

const taken = (packed) => {
  const whole = BigInt.asUintN(64, packed);
  const at = Number(whole & 0xffffffffn);
  const length = Number(whole >> 32n);
  const text = new TextDecoder().decode(new Uint8Array(exports.memory.buffer, at, length));
  exports.crankstar_give_back(at, length);
  return text;
};

const begin = async () => {
  ({ exports } = await WebAssembly.instantiate(program, {}));
  exports.crankstar_start();
};

const ask = (question) => {
  const bytes = new TextEncoder().encode(question);
  const at = exports.crankstar_room(bytes.length);
  new Uint8Array(exports.memory.buffer, at, bytes.length).set(bytes);
  return taken(exports.crankstar_ask(at, bytes.length));
};

/** What the program said before it stopped; its memory may be in any state. */
const fault = (error) => {
  try {
    return taken(exports.crankstar_fault()) || String(error);
  } catch {
    return String(error);
  }
};

const answer = async (data) => {
  if (data.program) {
    program = data.program;
    await begin();
    self.postMessage({ ready: true });
    return;
  }
  const { id, question } = data;
  const from = performance.now();
  try {
    const said = ask(question);
    self.postMessage({ id, answer: said, took: performance.now() - from });
  } catch (error) {
    const told = fault(error);
    await begin();
    self.postMessage({ id, fault: told });
  }
};

// One after the other, also while the module is started again.
let last = Promise.resolve();
self.onmessage = ({ data }) => (last = last.then(() => answer(data)));
