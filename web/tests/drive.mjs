// Does the page work in a real browser? node drive.mjs PAGE FOLDER: opened from its file, typed, dragged, read, photographed.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, statSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const { chromium } = createRequire(join(process.env.NODE_PATH, "x.js"))("playwright-core");
const [file, folder] = process.argv.slice(2);
const address = `file://${resolve(file)}`;
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync"],
});
const faults = [];
const times = {};

/** A page that is ready; whatever it complains of, or asks a network for, fails the test. */
const open = async (look = {}, fragment = "") => {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, reducedMotion: "reduce", ...look });
  const page = await context.newPage();
  page.on("pageerror", (error) => faults.push(`page error: ${error.message}`));
  page.on("console", (message) => message.type() === "error" && faults.push(`console: ${message.text()}`));
  page.on("request", (request) => /^(file|blob|data|about):/.test(request.url()) || faults.push(`asked for ${request.url()}`));
  await page.goto(address + fragment);
  await page.waitForSelector("body[data-ready]", { timeout: 120000 });
  await settled(page);
  return page;
};
/** When proof and report are about what is written. */
const settled = (page) => page.waitForFunction(() => document.body.dataset.settled !== undefined, null, { timeout: 60000 });
/** What is done, until all follows it. */
const after = async (page, act) => {
  await page.evaluate(() => delete document.body.dataset.settled);
  await act();
  await settled(page);
};
const text = (page, id) => page.$eval(`#${id}`, (node) => node.textContent.trim());
const layout = (page) => page.$eval("#layout", (node) => node.value);

try {
  // Opened.
  const page = await open();
  times["start to first verdict, ms"] = Number(await page.evaluate(() => document.body.dataset.verdict));
  times["start to stars, ms"] = Number(await page.evaluate(() => document.body.dataset.ready));
  times["page, bytes"] = statSync(file).size;
  await page.getByRole("heading", { level: 1, name: "V8, 90°, cross-plane crankshaft" }).waitFor();
  assert.match(await text(page, "verdicts"), /couple/);
  assert.match(await text(page, "checked"), /^All \d+ certificates hold/);
  const paper = page.frameLocator("#paper");
  await paper.getByRole("heading", { level: 1, name: /cross-plane/ }).waitFor();
  const order = await page.$$eval("main > section", (nodes) => nodes.map((node) => node.id));
  assert.deepEqual(order, ["verdict", "engine", "words", "stars", "claims", "proof", "report"]);

  // Read: every control has a role and a name, in the tree that screen readers get.
  const session = await page.context().newCDPSession(page);
  const { nodes } = await session.send("Accessibility.getFullAXTree");
  const focusable = nodes.filter((node) => !node.ignored && node.properties?.some(({ name, value }) => name === "focusable" && value.value));
  const nameless = focusable.filter((node) => !["RootWebArea", "generic"].includes(node.role.value) && !node.name?.value);
  assert.deepEqual(nameless.map((node) => node.role.value), [], "controls without a name");
  assert.ok(focusable.length > 20);
  for (const [role, name] of [["combobox", "Engine"], ["textbox", /^Layout file/], ["slider", "Bank angle φ"], ["slider", "Pin split"],
    ["slider", /^Crank angle θ/], ["combobox", "A claim about this engine"], ["group", "Save the report"]]) {
    assert.equal(await page.getByRole(role, { name, exact: typeof name === "string" }).count(), 1, `${role} ${name}`);
  }
  const spoken = await page.waitForFunction(() => document.querySelector("#spoken").textContent, null, { timeout: 10000 });
  assert.match(await spoken.jsonValue(), /cross-plane.*Order 1, Force in m r ω² 0,/);
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "To the verdict");
  const reached = [];
  for (let step = 0; step < 12; step += 1) {
    await page.keyboard.press("Tab");
    reached.push(await page.evaluate(() => document.activeElement.id || document.activeElement.className));
  }
  assert.equal(reached[0], "pick");
  const places = ["slider-vee-bank_angle", "slider-vee-pin_split", "layout"].map((id) => reached.indexOf(id));
  assert.ok(places.every((place, at) => place > (at ? places[at - 1] : 0)), `the focus goes ${reached.join(", ")}`);

  // Typed.
  await after(page, async () => {
    await page.locator("#layout").fill("");
    await page.locator("#layout").pressSequentially("title = \"Typed\"\n[inline]\nthrows = [0, 120, 240]\n");
  });
  await page.getByRole("heading", { level: 1, name: "Typed" }).waitFor();
  assert.match(await text(page, "verdicts"), /couple 3\s≈\s1\.732, planar/);
  assert.equal(await page.$eval("#mistake", (node) => node.textContent), "");

  // A mistake is shown at its place, and what was known stays.
  await page.locator("#layout").fill("title = \"π wrong\"\n[vee]\nbank_angle = \"60x\"\nthrows = [0]\n");
  await page.locator("#mistake strong").waitFor();
  assert.match(await text(page, "mistake"), /^Line 3, letter 14: .*60x/);
  assert.equal(await page.$eval("#marked mark", (node) => node.textContent), "\"60x\"");
  assert.equal(await page.$eval("#gutter b", (node) => node.textContent.trim()), "✕ 3");
  assert.equal(await page.$eval("#layout", (node) => node.getAttribute("aria-invalid")), "true");
  assert.equal(await text(page, "title"), "Typed");
  await page.screenshot({ path: join(folder, "mistake.png") });
  await page.getByRole("button", { name: "Go there" }).click();
  assert.equal(await page.evaluate(() => String(getSelection())), "\"60x\"");

  // Picked, then dragged.
  await after(page, () => page.getByRole("combobox", { name: "Engine", exact: true }).selectOption("V6-60-shared"));
  assert.equal(await text(page, "mistake"), "");
  const slider = page.getByRole("slider", { name: "Bank angle φ" });
  const { x, y, width, height } = await slider.boundingBox();
  const looks = [];
  await after(page, async () => {
    await page.mouse.move(x + width / 3, y + height / 2);
    await page.mouse.down();
    for (let step = 0; step <= 20; step += 1) {
      await page.mouse.move(x + width * (1 / 3 + step / 40), y + height / 2);
      await page.waitForTimeout(40);
      looks.push(parseFloat((await text(page, "state")).match(/[\d.]+/)));
    }
    await page.mouse.up();
  });
  looks.sort((a, b) => a - b);
  times["verdict and scene while dragging, median ms"] = looks[Math.floor(looks.length / 2)];
  times["verdict and scene while dragging, largest ms"] = looks.at(-1);
  times["report while dragging, ms"] = Number(await page.evaluate(() => document.body.dataset.report));
  const dragged = await layout(page);
  assert.match(dragged, /^bank_angle = 1[45]\d$/m);
  assert.match(await text(page, "changed"), /^Changed here: vee\.bank_angle = 1[45]\d\.$/);

  // To the exact zeros, by button and by key.
  const zero = page.locator("#sliders .jumps button.whole").first();
  const degrees = (await zero.textContent()).match(/^[\d/]+/)[0];
  await after(page, () => zero.click());
  assert.match(await layout(page), new RegExp(`^bank_angle = "?${degrees}"?$`, "m"));
  assert.match(await page.locator(".slider .here").first().textContent(), /^0 here: order/);
  assert.match(await slider.getAttribute("aria-valuetext"), /, where order .* is 0$/);
  await after(page, async () => {
    await slider.focus();
    await page.keyboard.press("Home");
  });
  assert.match(await layout(page), /^bank_angle = [01]$/m);
  assert.equal(await page.evaluate(() => document.activeElement.id), "slider-vee-bank_angle");
  const split = page.getByRole("slider", { name: "Pin split" });
  await after(page, () => split.press("ArrowRight"));
  assert.match(await layout(page), /^\[vee\]\npin_split = 1$/m);

  // The crank is turned, and stays where it is when the layout changes.
  const crank = page.getByRole("slider", { name: /^Crank angle θ/ });
  await crank.focus();
  for (let step = 0; step < 30; step += 1) await page.keyboard.press("ArrowRight");
  await after(page, () => split.press("ArrowRight"));
  assert.equal(await page.getByRole("slider", { name: /^Crank angle θ/ }).inputValue(), "30");

  // Claimed.
  const claim = page.getByRole("combobox", { name: "A claim about this engine" });
  const says = async (words) => {
    await claim.fill(words);
    await page.waitForTimeout(600);
    return text(page, "claim-answer");
  };
  await after(page, () => page.getByRole("combobox", { name: "Engine", exact: true }).selectOption("I4"));
  assert.match(await says("the second-order force vanishes"), /^✕ false/);
  assert.match(await says("first-order force vanishes"), /^✓ true/);
  assert.match(await says("it runs smoothly"), /[^✓✕]/);
  assert.equal(await page.locator("#claim-answer .unread").count(), 1);

  // Saved.
  const saved = async (name) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name, exact: true }).click()]);
    const path = join(folder, download.suggestedFilename());
    await download.saveAs(path);
    return path;
  };
  assert.match(readFileSync(await saved("HTML"), "utf8"), /^<!DOCTYPE html>[^]*data-moving/);
  assert.match(readFileSync(await saved("LaTeX"), "utf8"), /^\\documentclass/);
  assert.match(readFileSync(await saved("Plain text"), "utf8"), /In-line/);
  assert.equal(JSON.parse(readFileSync(await saved("Certificates (JSON)"), "utf8")).title, await text(page, "title"));
  for (const name of ["Markdown", "Typst", "Pictures (SVG)"]) {
    const path = await saved(name);
    const inside = execFileSync("python3", ["-c", "import sys, zipfile\nz = zipfile.ZipFile(sys.argv[1])\nassert z.testzip() is None\nprint(*z.namelist())", path], { encoding: "utf8" });
    assert.match(inside, /order-2\.svg/, name);
  }
  assert.equal(readFileSync(await saved("Save the layout"), "utf8"), await layout(page));
  await page.getByRole("combobox", { name: "In", exact: true }).selectOption("de");
  await paper.getByText("Ordnung").first().waitFor();

  // A link carries the layout; a broken one says so.
  await after(page, () => page.locator("#layout").fill("title = \"Carried: äöü 😀\"\n[inline]\nthrows = [0, 180]\n"));
  const fragment = await page.evaluate(() => location.hash);
  assert.match(fragment, /^#l=[\w-]+$/);
  const carried = await open({}, fragment);
  assert.equal(await layout(carried), await layout(page));
  assert.equal(await text(carried, "title"), "Carried: äöü 😀");
  await carried.context().close();
  const broken = await open({}, fragment.slice(0, 20));
  assert.match(await text(broken, "banner"), /^The link carries no layout/);
  await broken.context().close();
  const nowhere = await open({}, "#no-such-engine");
  assert.match(await text(nowhere, "banner"), /^The link names no engine/);
  await nowhere.context().close();

  // A link may name an engine; Back goes to the engine before; on a phone the report waits until it is asked for.
  const phone = await open({ viewport: { width: 390, height: 844 }, isMobile: true }, "#boxer-4");
  assert.equal(await text(phone, "title"), "Boxer four");
  assert.equal(await phone.locator("#scenes input[value=moment]").isChecked(), true, "it opens on what is left first");
  await after(phone, () => phone.getByRole("combobox", { name: "Engine", exact: true }).selectOption("I4"));
  assert.equal(await text(phone, "title"), "In-line four, flat crankshaft");
  await after(phone, () => phone.goBack());
  assert.equal(await text(phone, "title"), "Boxer four");
  assert.equal(await phone.locator("#paper").isVisible(), false);
  await phone.getByText("The report on this engine").click();
  assert.equal(await phone.locator("#paper").isVisible(), true);
  await phone.context().close();

  // A trap of the module is told, and the next question is answered by a new one.
  const worker = page.workers()[0];
  await worker.evaluate(() => {
    exports = { ...exports, crankstar_ask: () => { throw new WebAssembly.RuntimeError("unreachable"); } };
  });
  await page.locator("#layout").pressSequentially("#");
  await page.locator("#banner").filter({ hasText: "fault of its own" }).waitFor();
  await after(page, () => page.locator("#layout").fill("[inline]\nthrows = [0, 90]\n"));
  assert.equal(await page.locator("#banner").isHidden(), true);
  assert.match(await text(page, "verdicts"), /1\.414/);

  // One that does not come back is given up for a newer question.
  await worker.evaluate(() => {
    exports = { ...exports, crankstar_ask: () => { for (;;); } };
  });
  await page.locator("#layout").pressSequentially("#");
  await page.waitForTimeout(300);
  await after(page, () => page.locator("#layout").fill("title = \"Again\"\n[inline]\nthrows = [0, 180]\n"));
  assert.equal(await text(page, "title"), "Again");

  // Hostile words stay words.
  await after(page, () => page.locator("#layout").fill("title = \"<img src=x onerror=alert(1)><b>x\"\n[inline]\nthrows = [0, 180]\n"));
  assert.equal(await text(page, "title"), "<img src=x onerror=alert(1)><b>x");
  assert.equal(await page.$$eval("main img", (images) => images.length), 0);
  await page.context().close();

  // Photographed; nothing is wider than the screen.
  const engines = { light: ["V8-crossplane", "open-v8", "open-v6", "i4-numbers", "radial-9"], dark: ["V8-crossplane", "open-v8"] };
  for (const [name, viewport] of [["narrow", { width: 320, height: 700 }], ["phone", { width: 390, height: 844 }], ["wide", { width: 1440, height: 900 }]]) {
    for (const colorScheme of ["light", "dark"]) {
      const one = await open({ viewport, colorScheme, isMobile: name === "phone", hasTouch: name === "phone" });
      for (const engine of engines[colorScheme]) {
        await after(one, () => one.getByRole("combobox", { name: "Engine", exact: true }).selectOption(engine));
        const [inside, outside] = await one.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
        assert.ok(inside <= outside, `${engine}: ${inside} px wide on ${outside}`);
        // The report below is long; what is above it fits.
        const clip = { x: 0, y: 0, width: viewport.width, height: 4000 };
        await one.screenshot({ path: join(folder, `${engine}-${name}-${colorScheme}.png`), fullPage: true, clip, timeout: 120000 });
      }
      await one.context().close();
    }
  }
  assert.deepEqual(faults, []);
} finally {
  if (faults.length) console.error(faults.join("\n"));
  await browser.close();
}
writeFileSync(join(folder, "times.json"), `${JSON.stringify(times, null, 2)}\n`);
console.log("the page works:", times);
