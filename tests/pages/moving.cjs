// Opens the pages of this folder whose names come on standard input, moves their sliders, reads and photographs them.
const assert = require("node:assert");
const fs = require("node:fs");
const path = require("node:path");
const { chromium } = require("playwright-core");

const FLAGS = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync"];

/** What is drawn: every attribute of every mark. */
const drawing = (figure) => figure.locator("svg").evaluateAll((all) => all.map((svg) => svg.innerHTML).join());
const read = async (figure, part) => (await figure.locator(`[data-part="${part}"]`).first().textContent()).trim();
const sceneOf = async (figure) => JSON.parse(await read(figure, "scene"));

/** What has to be said of one sum at a value of the slider, from the exact list. */
const expected = (sense, value, words) => {
  if (sense.zeros.everywhere || sense.zeros.at.includes(value)) return words.zero;
  return sense.zeros.complete ? words.not_zero : words.undecided;
};

async function crankTurns(page, figure, name) {
  const slider = figure.locator('[data-part="theta"]');
  const before = await drawing(figure);
  await slider.focus();
  for (let press = 0; press < 30; press++) await page.keyboard.press("ArrowRight");
  assert.equal(await read(figure, "theta-text"), "= 30°", name);
  assert.equal(await slider.getAttribute("aria-valuetext"), "30°", name);
  const turned = await drawing(figure);
  assert.ok(turned !== before, `${name}: nothing moves`);
  const box = await slider.boundingBox();
  const thumb = (share) => [box.x + 8 + (box.width - 16) * share, box.y + box.height / 2];
  await page.mouse.move(...thumb(30 / 360));
  await page.mouse.down();
  await page.mouse.move(...thumb(0.5), { steps: 5 });
  await page.mouse.up();
  const angle = Number((await read(figure, "theta-text")).match(/\d+/)[0]);
  assert.ok(Math.abs(angle - 180) <= 3, `${name}: dragged to ${angle}°`);
  assert.ok((await drawing(figure)) !== turned, `${name}: nothing is dragged`);
}

/** Every rod stands on its crankpin or knuckle pin, keeps its length and leads its piston along the axis of the cylinder. */
async function rodsFit(figure, scene, name) {
  const seen = scene.bodies.filter((body) => body.label !== null);
  const paths = await figure.locator("svg .rod").evaluateAll((all) => all.map((rod) => rod.getAttribute("d")));
  const about = ([x, y]) => (point) => { const [a, b] = point.split(" ").map(Number); return [a - x, b + y]; };
  const joints = paths.map((d, index) => d.slice(1).split("L").map(about(seen[index].axis)));
  const from = ([a, b], [c, d]) => [c - a, b - d]; // y upwards
  const near = (one, other, what) => assert.ok(Math.abs(one - other) < 4e-3, `${name}: ${what} ${one}, not ${other}`);
  const ahead = (one, other) => ((Math.atan2(other[1], other[0]) - Math.atan2(one[1], one[0])) * 180) / Math.PI;
  let links = 0;
  seen.forEach((body, index) => {
    const [pin, foot, wrist] = joints[index];
    near(Math.hypot(...pin), body.radius, "crank");
    near(Math.hypot(...from(foot, wrist)), body.rod, "rod");
    const turned = (ahead([0, 1], from([0, 0], wrist)) - body.bank) * (Math.PI / 180);
    if (!scene.angle) near(Math.sin(turned) * Math.hypot(...wrist), body.aside, "side of the axis");
    if (!body.knuckle) return;
    const its = (other) => other.crank === body.crank && !other.knuckle && Math.abs(other.rod - body.knuckle.master) < 1e-9;
    const master = joints[seen.findIndex(its)];
    near(Math.hypot(...from(pin, foot)), body.knuckle.radius, "knuckle radius");
    const off = (ahead(from(master[0], master[2]), from(pin, foot)) - body.knuckle.ahead) * (Math.PI / 180);
    near(Math.abs(Math.sin(off)) + Math.abs(Math.cos(off) - 1), 0, "knuckle angle");
    links += 1;
  });
  return links;
}

async function wordsAreThoseOfTheVerdicts(figure, scene, name) {
  for (const [index, order] of scene.orders.entries()) {
    await figure.locator('[data-part="order"]').selectOption({ index });
    for (const quantity of ["force", "moment"]) {
      await figure.locator(`input[value="${quantity}"]`).check();
      const said = await read(figure, "verdict");
      assert.ok(said.startsWith(`Order ${order.order}, ${quantity}`), `${name}: ${said}`);
      assert.ok(said.includes(` ${order[quantity].words}.`), `${name}: ${said}`);
      const sums = await figure.locator(".moving-stars .sum").evaluateAll((all) => all.map((sum) => sum.getAttribute("d")));
      order[quantity].senses.forEach((sense, at) => {
        assert.equal(sums[at] === "", sense.zero, `${name}: order ${order.order}, ${quantity}: a sum is drawn where it is 0`);
      });
    }
  }
  await figure.locator('input[value="force"]').check();
}

async function zerosAreExact(page, figure, scene, name) {
  const slider = figure.locator('[data-part="angle"]');
  let jumps = 0;
  for (const [index, order] of scene.orders.entries()) {
    await figure.locator('[data-part="order"]').selectOption({ index });
    if (!order.exists) continue;
    const { senses, marks } = order.force;
    assert.equal(await figure.locator('[data-part="ticks"] line').count(), marks.length, `${name}: ticks`);
    const check = async (value, where) => {
      const said = await read(figure, "verdict");
      const told = senses.map((sense, at) => `${scene.words.senses[at]} ${expected(sense, value, scene.words)}`);
      if (value !== scene.angle.start.at) assert.ok(said.includes(`: ${told.join("; ")}.`), `${name}, ${where}: ${said}`);
    };
    for (const mark of marks) {
      const button = figure.locator(`[data-part="jumps"] button[value="${mark.at}"]`);
      assert.ok((await button.textContent()).startsWith(mark.text), name);
      await slider.press("Home");
      const before = await drawing(figure);
      await button.click();
      assert.equal(await read(figure, "angle-text"), `= ${mark.text}`, name);
      assert.equal(await button.getAttribute("aria-pressed"), "true", name);
      await check(mark.at, mark.text);
      assert.ok((await drawing(figure)) !== before, `${name}: the engine stays at ${mark.text}`);
      jumps += 1;
    }
    const { low, step } = scene.angle;
    await slider.focus();
    await page.keyboard.press("Home");
    for (let press = 1; press <= 3; press++) {
      await page.keyboard.press("ArrowRight");
      await check(low + press * step, `${press} steps`);
    }
  }
  await figure.locator('[data-part="order"]').selectOption({ index: 0 });
  return jumps;
}

/** No name lies on another, none is smaller than 11 pixels, at any crank angle that is looked at. */
async function namesAreApart(page, figure, name) {
  for (const width of [1200, 390]) {
    await page.setViewportSize({ width, height: 900 });
    await page.waitForTimeout(100);
    for (const theta of ["0", "20", "50", "130"]) {
      await figure.locator('[data-part="theta"]').fill(theta);
      const seen = await figure.locator("svg .name").evaluateAll((all) => all.map((text) => {
        const { left, right, top, bottom } = text.getBoundingClientRect();
        return { text: text.textContent, of: text.ownerSVGElement.getAttribute("aria-label"), left, right, top, bottom,
          size: parseFloat(getComputedStyle(text).fontSize) * text.getScreenCTM().a };
      }));
      for (const one of seen) assert.ok(one.size > 10.99, `${name}: ${one.text} has ${one.size} pixels at ${width}`);
      const meet = (a, b) => a.of === b.of && a.left < b.right && b.left < a.right && a.top + 2 < b.bottom - 2 && b.top + 2 < a.bottom - 2;
      seen.forEach((one, at) => seen.slice(at + 1).forEach((other) =>
        assert.ok(!meet(one, other), `${name}: ${one.text} lies on ${other.text} at ${width}, θ = ${theta}`)));
    }
  }
  await page.setViewportSize({ width: 1200, height: 900 });
}

async function playsOrStandsStill(page, figure, name) {
  const play = figure.locator('[data-part="play"]');
  await play.click();
  await page.waitForTimeout(200);
  const one = await drawing(figure);
  await page.waitForTimeout(200);
  assert.ok((await drawing(figure)) !== one, `${name}: it does not play`);
  await play.click();
  const two = await drawing(figure);
  await page.waitForTimeout(100);
  assert.ok((await drawing(figure)) === two, `${name}: it does not stop`);
  await page.emulateMedia({ reducedMotion: "reduce" });
  assert.equal(await play.isVisible(), false, `${name}: motion is offered to those who asked for none`);
  await page.emulateMedia({ reducedMotion: "no-preference" });
}

(async () => {
  const names = JSON.parse(fs.readFileSync(0, "utf8"));
  const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: FLAGS });
  let jumps = 0;
  let links = 0;
  for (const name of names) {
    const url = `file://${path.resolve(`${name}.html`)}`;
    const page = await browser.newPage({ viewport: { width: 1200, height: 900 } });
    const wrong = [];
    page.on("pageerror", (error) => wrong.push(String(error)));
    page.on("console", (message) => wrong.push(message.text()));
    page.on("dialog", (dialog) => { wrong.push(`dialog ${dialog.message()}`); dialog.dismiss(); });
    page.on("request", (request) => { if (request.url() !== url) wrong.push(`request ${request.url()}`); });
    await page.goto(url);
    for (const figure of await page.locator("[data-moving]").all()) {
      const scene = await sceneOf(figure);
      assert.ok((await figure.locator(".moving-title").textContent()).startsWith(scene.title), name);
      const [place, quantity] = scene.start;
      const opening = await read(figure, "verdict");
      assert.ok(opening.startsWith(`Order ${scene.orders[place].order}, ${quantity}`), `${name} opens on ${opening}`);
      await namesAreApart(page, figure, name);
      await figure.locator('[data-part="theta"]').fill("0");
      await crankTurns(page, figure, name);
      links += await rodsFit(figure, scene, name);
      await wordsAreThoseOfTheVerdicts(figure, scene, name);
      if (scene.angle) jumps += await zerosAreExact(page, figure, scene, name);
      await playsOrStandsStill(page, figure, name);
      assert.equal(await figure.locator("svg").evaluateAll((all) => all.some((svg) => svg.outerHTML.includes("NaN"))), false, name);
    }
    await page.reload();
    for (const slider of await page.locator('[data-part="theta"]').all()) await slider.fill("40");
    for (const [width, scheme] of [[1200, "light"], [1200, "dark"], [390, "light"], [390, "dark"]]) {
      await page.setViewportSize({ width, height: 900 });
      await page.emulateMedia({ colorScheme: scheme });
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
      assert.ok(overflow <= 0, `${name}: ${overflow} pixels too wide at ${width}`);
      await page.screenshot({ path: `${name}-${width}-${scheme}.png`, fullPage: true });
    }
    await page.emulateMedia({ media: "print", colorScheme: "light" });
    assert.equal(await page.locator('[data-part="theta"]').first().isVisible(), false, `${name}: a slider is printed`);
    await page.screenshot({ path: `${name}-print.png`, fullPage: true });
    assert.deepEqual(wrong, [], name);
    await page.close();
  }
  await browser.close();
  assert.ok(jumps > 20, `only ${jumps} zeros were visited`);
  assert.ok(links > 10, `only ${links} links were measured`);
  console.log(`${names.length} pages, ${jumps} zeros`);
})().catch((error) => {
  console.error(error);
  process.exit(1);
});
