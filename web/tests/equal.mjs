// Does the module answer as the program does, byte for byte, for the whole catalogue? node equal.mjs MODULE PROGRAM [NAME…]
// But for the points of a few curves, and names beside them: where two points are equally far from a line, the last digit of a sine decides which
// one is drawn.
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
const CURVES = /coordinates \{([^}]*)\}/g;
/** A text, of its drawings only the names, wherever they stand. */
const bare = (text) => {
  const [kept, names] = [[], []];
  for (const line of text.replace(CURVES, "").split("\n")) {
    if (!/^\s*(\\draw|\\node|<\/?g\b|<path|<text)/.test(line)) kept.push(line);
    else names.push(...(line.match(/\{[^{}]*\};$|>[^<>]+<\/text>/g) ?? []));
  }
  return [...kept, ...names.sort()].join("\n");
};
/** The curves of a drawing in LaTeX, whose points are absolute; an SVG is the same drawing. */
const curves = (text) => [...text.matchAll(CURVES)].map(([, points]) =>
  [...points.matchAll(/\(([-.\d]+),([-.\d]+)\)/g)].map(([, x, y]) => [Number(x), Number(y)]));
const distance = ([x, y], [[a, b], [c, d]]) => {
  const square = (c - a) ** 2 + (d - b) ** 2;
  const along = square === 0 ? 0 : Math.min(1, Math.max(0, ((x - a) * (c - a) + (y - b) * (d - b)) / square));
  return Math.hypot(x - a - along * (c - a), y - b - along * (d - b));
};
/** Whether each point of a curve is drawn on the other: within twice the tolerance by which points are omitted, and their roundings. */
const lies = (one, other) => one.every((point) => other.slice(1).some((to, index) => distance(point, [other[index], to]) < 0.05));
const alike = (found, wanted) => {
  if (!found || bare(found) !== bare(wanted)) return false;
  const [ours, theirs] = [found, wanted].map(curves);
  return ours.every((curve, index) => lies(curve, theirs[index]) && lies(theirs[index], curve));
};
let redrawn = 0;
const compare = (what, found, wanted) => {
  compared += 1;
  if (found === wanted) return;
  if (alike(found, wanted)) {
    redrawn += 1;
    return;
  }
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
// More of them would be another cause.
if (redrawn > 0.02 * compared) differing.push(`${redrawn} of ${compared} have curves of other points`);
if (differing.length) {
  console.error(`${differing.length} of ${compared} differ:\n${differing.join("\n")}`);
  process.exit(1);
}
console.log(`${asked.length} layouts, ${compared} texts: the module and the program say the same, byte for byte, but for points of curves in ${redrawn}`);
