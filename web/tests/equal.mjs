// Does the module answer as the program does, byte for byte, for the whole catalogue? node equal.mjs MODULE PROGRAM [NAME…]
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { load } from "./module.mjs";

const [module, program, ...only] = process.argv.slice(2);
const ask = await load(module);
const work = mkdtempSync(join(tmpdir(), "crankstar-equal-"));
const native = (...words) => execFileSync(program, words, { maxBuffer: 1 << 28, encoding: "utf8" });
const differing = [];
let compared = 0;
const compare = (what, found, wanted) => {
  compared += 1;
  if (found === wanted) return;
  const lines = [found, wanted].map((text) => (text ?? "(nothing)").split("\n"));
  const at = lines[0].findIndex((line, index) => line !== lines[1][index]);
  differing.push(`${what}, line ${at + 1}\n  module:  ${lines[0][at]?.slice(0, 300)}\n  program: ${lines[1][at]?.slice(0, 300)}`);
};

const { ok: known } = ask({ ask: "catalogue" });
const listed = native("list");
for (const { name } of known.engines) if (!listed.includes(name)) differing.push(`the program does not list ${name}`);

// The catalogue by name, and the layouts that the page has besides as files.
const layouts = known.engines.map(({ name, text }) => ({ name, text, path: name }));
for (const { name, text } of known.starters) {
  const path = join(work, `${name}.toml`);
  writeFileSync(path, text);
  layouts.push({ name: path, text, path });
}
const asked = layouts.filter(({ name, path }) => only.length === 0 || only.some((one) => [name, path].some((known) => known.includes(one))));
for (const { name, text, path } of asked) {
  const proof = ask({ ask: "proof", name, text });
  compare(`classify ${path} --json`, proof.ok?.json, native("classify", path, "--json"));
  for (const [format, moving] of [["markdown", false], ["html", true], ["latex", false], ["typst", false], ["text", false]]) {
    const folder = join(work, "out");
    rmSync(folder, { recursive: true, force: true });
    native("report", path, "--format", format, "--output", folder);
    const files = ask({ ask: "report", name, text, format, moving }).ok.files;
    const what = `report ${path} --format ${format}`;
    compare(`${what}: the names of its files`, files.map((file) => file.name).sort().join(" "), readdirSync(folder).sort().join(" "));
    for (const file of files) {
      const wanted = readFileSync(join(folder, file.name), "utf8");
      compare(`${what}: ${file.name}`, file.text, wanted);
    }
  }
}
rmSync(work, { recursive: true });
if (known.engines.length < 40) differing.push(`only ${known.engines.length} engines are in the catalogue of the module`);
if (differing.length) {
  console.error(`${differing.length} of ${compared} differ:\n${differing.join("\n")}`);
  process.exit(1);
}
console.log(`${asked.length} layouts, ${compared} texts: the module and the program say the same, byte for byte`);
