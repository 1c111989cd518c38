// Opens the files that come on standard input, and says which have another title than the one beside them.
const assert = require("node:assert");
const fs = require("node:fs");
const { pathToFileURL } = require("node:url");
const { chromium } = require("playwright-core");

const FLAGS = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync"];

async function main() {
  const pages = JSON.parse(fs.readFileSync(0, "utf8"));
  const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: FLAGS });
  const wrong = [];
  for (const [file, title] of pages) {
    const page = await browser.newPage({ viewport: { width: 1100, height: 900 } });
    await page.goto(pathToFileURL(file).href, { waitUntil: "load" });
    const found = await page.title();
    if (found !== title) wrong.push(`${file}: ${found}, not ${title}`);
    await page.close();
  }
  await browser.close();
  assert.deepEqual(wrong, []);
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});
