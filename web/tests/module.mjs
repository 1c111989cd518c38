// How is the module asked without a page? As the worker of the page asks it.
import { readFileSync } from "node:fs";

/** A function from questions to answers, from the file of the module. */
export const load = async (file) => {
  const { instance } = await WebAssembly.instantiate(readFileSync(file), {});
  const { memory, crankstar_start, crankstar_room, crankstar_ask, crankstar_give_back } = instance.exports;
  crankstar_start();
  return (question) => {
    const bytes = Buffer.from(typeof question === "string" ? question : JSON.stringify(question));
    const at = crankstar_room(bytes.length);
    new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
    const whole = BigInt.asUintN(64, crankstar_ask(at, bytes.length));
    const [place, length] = [Number(whole & 0xffffffffn), Number(whole >> 32n)];
    const answer = Buffer.from(memory.buffer, place, length).toString();
    crankstar_give_back(place, length);
    return JSON.parse(answer);
  };
};
