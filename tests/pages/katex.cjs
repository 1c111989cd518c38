// Does KaTeX read every formula of a list in strict mode? The list comes as JSON on standard input.
const katex = require("katex");
const formulas = JSON.parse(require("fs").readFileSync(0, "utf8"));
for (const formula of formulas) {
  katex.renderToString(formula, { strict: "error", throwOnError: true, displayMode: formula.includes("\\tag") });
}
console.log(`${formulas.length} formulas`);
