// What happens on the page? A layout changes, and what is said of it follows: verdict, stars, claim, proof, report.
const SETTLES = 250; // ms without a change before proof and report follow
const SPEAKS = 900; // ms before a changed verdict is read out
const OWN = "layout.toml"; // what messages call a layout that no name has

const page = async () => {
  const { ask, current, giveUp } = await asker();
  const state = { name: OWN, turn: 0, looking: false, next: null, settling: 0, speaking: 0, said: "", link: "", isOther: false, isStep: false, isFaulty: false, values: new Map() };
  const banner = (words) => {
    $("banner").hidden = !words;
    $("banner").textContent = words;
  };
  const about = (more = {}) => ({ name: state.name, text: editor.area.value, ...more });
  /** The answer's content; a mistake or a fault is shown. Nothing where there is none. */
  const answered = async (question, isUrgent) => {
    const answer = await ask(question, isUrgent);
    if (!answer) return undefined;
    if (answer.fault !== undefined) {
      state.isFaulty = true;
      banner(`The program met a fault of its own and was started again; the layout is kept. It said: ${answer.fault}`);
      return undefined;
    }
    return answer;
  };

  const speak = (words) => {
    clearTimeout(state.speaking);
    state.speaking = setTimeout(() => {
      if (state.said !== words) $("spoken").textContent = words;
      state.said = words;
    }, SPEAKS);
  };

  /** When what was written is on the screen; a page that nobody sees does not wait. */
  const painted = () => document.hidden || new Promise((done) => requestAnimationFrame(() => setTimeout(done)));

  const words = ({ title, verdicts, summary }) => {
    $("title").innerHTML = title;
    document.title = `${$("title").textContent} · crankstar`;
    $("verdicts").innerHTML = verdicts;
    $("summary").innerHTML = summary;
  };

  const show = (answer, took) => {
    words(answer);
    $("state").textContent = `Computed in ${took < 10 ? took.toFixed(1) : Math.round(took)} ms.`;
    stars.put(answer.scenes, answer.stars, state.isOther);
    state.isOther = false;
    speak(`${$("title").textContent}. ${answer.spoken}`);
  };

  /** The first verdict, which does not wait for its stars. */
  const first = async () => {
    const answer = await answered({ ask: "verdicts", ...about() });
    if (!answer?.ok) return;
    words(answer.ok);
    await painted();
    document.body.dataset.verdict = `${Math.round(performance.now())}`;
  };

  /** The layout after a value was set: it is no longer the one that was picked. */
  const changed = ({ key, value }, text) => {
    editor.put(text);
    state.name = OWN;
    $("pick").value = "";
    state.values.set(key, value);
    const values = [...state.values].map((pair) => pair.join(" = "));
    $("changed").textContent = `Changed here: ${values.join(", ")}.`;
  };

  /** The verdicts of what is written, after a value was set in it. One question at a time; of those that come meanwhile the last. */
  const look = async (set) => {
    state.next = { set };
    if (state.looking) {
      const before = current();
      setTimeout(() => state.next && giveUp(before), TOO_LONG);
      return;
    }
    state.looking = true;
    while (state.next) {
      const { set: value } = state.next;
      state.next = null;
      state.turn += 1;
      const answer = await answered({ ask: "look", ...about(value && { set: value }) }, true);
      if (answer?.ok) {
        if (state.isFaulty) banner("");
        state.isFaulty = false;
        if (answer.ok.text !== null) changed(value, answer.ok.text);
        editor.show(null);
        show(answer.ok, answer.took);
      } else if (answer?.mistake) {
        editor.show(answer.mistake);
        $("state").textContent = "The layout cannot be read as it stands.";
      }
      document.body.classList.toggle("stale", !answer?.ok);
    }
    state.looking = false;
    clearTimeout(state.settling);
    state.settling = setTimeout(settle, SETTLES);
  };

  /** What follows when nothing has changed for a moment. */
  const settle = async () => {
    const turn = state.turn;
    const isOld = () => turn !== state.turn || state.looking;
    if (document.body.classList.contains("stale")) return;
    const steps = [moveable, claim, proof, report, link];
    for (const step of steps) {
      await step(isOld);
      if (isOld()) return;
    }
    document.body.dataset.settled = `${turn}`;
  };
  const moveable = async (isOld) => {
    if (sliders.isHeld()) return;
    const answer = await answered({ ask: "sliders", ...about() });
    if (answer?.ok && !isOld()) sliders.put(answer.ok);
  };
  const proof = async (isOld) => {
    const answer = await answered({ ask: "proof", ...about() });
    if (!answer || isOld()) return;
    const words = answer.ok?.checked ?? `${answer.mistake.message}: ${answer.mistake.right}`;
    $("checked").textContent = words;
    $("proof-checked").textContent = `${words} ${answer.ok?.by ?? ""} The checker knows nothing of how the verdicts were found.`;
    $("proofs").innerHTML = answer.ok?.html ?? "";
    $("json").textContent = answer.ok?.json ?? "";
  };

  const files = async (format, moving) => {
    const answer = await answered({ ask: "report", format, language: $("language").value, moving, ...about() });
    if (answer?.mistake) banner(`${answer.mistake.message}: ${answer.mistake.right}`);
    return answer?.ok?.files;
  };
  const report = async (isOld) => {
    const from = performance.now();
    const made = await files("html", false);
    if (!made || isOld()) return;
    document.body.dataset.report = `${Math.round(performance.now() - from)}`;
    $("paper").srcdoc = made[0].text;
  };
  // On a phone the report waits until it is asked for.
  $("folded").open = !matchMedia("(max-width: 46em)").matches;
  $("folded").addEventListener("toggle", () => fit());
  const fit = () => {
    const inside = $("paper").contentDocument?.documentElement;
    if (inside) $("paper").style.height = `${inside.scrollHeight + 4}px`;
  };
  $("paper").addEventListener("load", fit);
  $("paper").addEventListener("load", () => new ResizeObserver(fit).observe($("paper").contentDocument.body));

  const claim = async (isOld = () => false) => {
    const says = $("claim").value.trim();
    const home = $("claim-answer");
    if (!says) return home.replaceChildren();
    const answer = await answered({ ask: "claim", says, ...about() });
    if (!answer || isOld() || says !== $("claim").value.trim()) return undefined;
    if (answer.mistake) {
      const { message, right } = answer.mistake;
      home.replaceChildren(make("p", { className: "verdict-of-claim unread" }, make("strong", { textContent: message })), make("p", { textContent: right }));
      return undefined;
    }
    const { status, kind, finding, evidence } = answer.ok;
    const sign = { holds: "✓", fails: "✕", open: "?" }[kind];
    const lead = make("p", { className: `verdict-of-claim ${kind}` }, make("span", { ariaHidden: "true", textContent: `${sign} ` }), make("strong", { textContent: status }));
    const found = make("div", { innerHTML: finding });
    const certificates = make("details", { innerHTML: evidence });
    certificates.prepend(make("summary", { textContent: "What the answer rests on" }));
    home.replaceChildren(lead, found, ...(evidence ? [certificates] : []));
    return undefined;
  };

  const link = async (isOld) => {
    const fragment = `#l=${await save.packed(editor.area.value)}`;
    if (isOld()) return;
    // Each engine that is picked is a step of its own for the browser's Back; what is typed changes the step it is at.
    if (location.hash !== fragment) history[state.isStep && state.link ? "pushState" : "replaceState"](null, "", fragment);
    state.isStep = false;
    state.link = fragment;
  };
  /** Shows the layout that the address carries or names, if it does; says so where a link is broken. */
  const carried = async () => {
    const hash = location.hash.slice(1);
    if (!hash || location.hash === state.link || $(hash)) return false;
    const letters = hash.match(/^l=(.*)$/)?.[1];
    try {
      const text = letters === undefined ? (await named(decodeURIComponent(hash))).text : await save.unpacked(letters);
      state.name = [...texts.keys()].find((name) => texts.get(name) === text) ?? OWN;
      $("pick").value = texts.has(state.name) ? state.name : "";
      [state.isOther, state.link] = [true, location.hash];
      banner("");
      afresh();
      editor.put(text);
      return true;
    } catch {
      banner(letters === undefined
        ? "The link names no engine of the catalogue."
        : "The link carries no layout that can be read: a part of it may be missing.");
      return false;
    }
  };
  /** The text of an engine of the catalogue and its name as it is written there; throws where there is none of that name. */
  const named = async (name) => {
    const { ok } = await ask({ ask: "engine", name });
    if (!ok) throw new Error(name);
    texts.set(ok.name, ok.text);
    return ok;
  };

  const { ok: known } = await ask({ ask: "begin" });
  stars.style(known.moving);
  $("claim-examples").append(...known.claims.map((value) => make("option", { value })));
  $("claim").value = known.claims[0];
  $("about").textContent = `crankstar ${known.version}. Everything on this page is computed in it: it asks no server and sends nothing. To keep it, save it (Ctrl+S): it is one file, and works offline.`;

  // What can be picked: every engine of the catalogue is built for its title, so that the list comes after the first verdict.
  const texts = new Map();
  const list = async () => {
    const { ok: all } = await ask({ ask: "catalogue" });
    const groups = Object.groupBy ? Object.groupBy(all.engines, ({ group }) => group) : { Engines: all.engines };
    const option = ({ name, title, text }) => {
      texts.set(name, text);
      return make("option", { value: name, textContent: title });
    };
    $("pick").append(make("optgroup", { label: "To begin with" }, ...all.starters.map(option)));
    for (const [label, engines] of Object.entries(groups)) $("pick").append(make("optgroup", { label }, ...engines.map(option)));
    $("pick").value = texts.has(state.name) ? state.name : "";
  };

  const afresh = () => {
    state.values.clear();
    $("changed").textContent = "";
  };
  const put = (name) => {
    state.name = name;
    $("pick").value = name;
    [state.isOther, state.isStep] = [true, true];
    afresh();
    editor.put(texts.get(name));
  };
  $("pick").addEventListener("change", () => {
    banner("");
    if (!texts.has($("pick").value)) return;
    put($("pick").value);
    look();
  });
  editor.area.addEventListener("input", () => {
    editor.draw();
    if (editor.area.value !== texts.get(state.name)) {
      state.name = OWN;
      $("pick").value = "";
      afresh();
    }
    look();
  });
  sliders.onrelease(() => {
    clearTimeout(state.settling);
    state.settling = setTimeout(settle, SETTLES);
  });
  sliders.onmove((key, value) => look({ key, value }));
  let claiming = 0;
  $("claim").addEventListener("input", () => {
    clearTimeout(claiming);
    claiming = setTimeout(claim, SETTLES);
  });
  $("language").addEventListener("change", () => report(() => false));
  addEventListener("hashchange", async () => (await carried()) && look());

  // What leaves the page.
  const stem = () => $("title").textContent.normalize("NFKD").replace(/[^\w]+/g, "-").replace(/^-|-$/g, "") || "engine";
  const pictures = (all) => all.filter(({ name }) => name.endsWith(".svg"));
  const ways = {
    HTML: async () => save.text(`${stem()}.html`, (await files("html", true))[0].text),
    LaTeX: async () => save.text(`${stem()}.tex`, (await files("latex", false))[0].text),
    Markdown: async () => save.zip(`${stem()}-markdown.zip`, await files("markdown", false)),
    Typst: async () => save.zip(`${stem()}-typst.zip`, await files("typst", false)),
    "Plain text": async () => save.text(`${stem()}.txt`, (await files("text", false))[0].text),
    "Pictures (SVG)": async () => save.zip(`${stem()}-pictures.zip`, pictures(await files("markdown", false))),
    "Certificates (JSON)": async () => save.text(`${stem()}.json`, $("json").textContent),
  };
  for (const [name, way] of Object.entries(ways)) {
    const button = make("button", { type: "button", textContent: name });
    button.addEventListener("click", way);
    $("downloads").append(button);
  }
  $("save-layout").addEventListener("click", () => save.text(`${stem()}.toml`, editor.area.value));
  $("copy-link").addEventListener("click", async () => {
    const address = `${location.href.split("#")[0]}#l=${await save.packed(editor.area.value)}`;
    const copied = await navigator.clipboard?.writeText(address).then(() => true, () => false);
    $("copy-link").textContent = copied ? "Copied" : "The address of the page is the link";
    setTimeout(() => ($("copy-link").textContent = "Copy a link to this engine"), 3000);
  });

  // A link may carry an engine of the list, which then keeps its name.
  const isLink = location.hash.startsWith("#l=");
  if (isLink) await list();
  if (!(await carried())) put((await named("V8-crossplane")).name);
  await first();
  await look();
  document.body.dataset.ready = `${Math.round(performance.now())}`;
  if (!isLink) await list();
};

page().catch((error) => {
  $("title").textContent = "crankstar did not start";
  $("state").textContent = `${error.message} An up-to-date browser is needed, with WebAssembly and DecompressionStream.`;
});
