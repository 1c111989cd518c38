// Which values can be moved? Each stop is an exact value of the program's, and so is what vanishes there.
const sliders = (() => {
  const home = $("sliders");
  const shown = new Map(); // key → the parts of its slider
  let moved = () => {};
  let released = () => {};
  let held = false;
  home.addEventListener("pointerdown", ({ target }) => (held = target.type === "range"));
  for (const kind of ["pointerup", "pointercancel"]) {
    addEventListener(kind, () => {
      if (held) released();
      held = false;
    });
  }

  const said = ({ slider, marks }, stop) => {
    const here = marks.get(stop);
    return slider.stops[stop].shown + (here ? `, where ${here.what.join(", ")} is 0` : "");
  };
  const show = (parts, stop) => {
    const { slider, range, output, here, jumps } = parts;
    range.value = stop;
    range.setAttribute("aria-valuetext", said(parts, stop));
    output.textContent = slider.stops[stop].shown;
    const mark = parts.marks.get(stop);
    here.textContent = mark ? `0 here: ${mark.what.join(", ")}` : "";
    for (const button of jumps.querySelectorAll("button")) button.setAttribute("aria-pressed", `${button.value === `${stop}`}`);
  };
  const move = (parts, stop) => {
    show(parts, stop);
    moved(parts.slider.key, parts.slider.stops[stop].value);
  };

  const tick = (slider, { stop, whole, what }) => {
    const part = stop / Math.max(slider.stops.length - 1, 1);
    const mark = make("i", { className: whole ? "whole" : "", title: `${slider.stops[stop].shown}: ${what.join(", ")}` });
    mark.style.setProperty("--at", part);
    return mark;
  };
  const build = (slider) => {
    const id = `slider-${slider.key.replaceAll(".", "-")}`;
    const range = make("input", { type: "range", id, min: 0, max: slider.stops.length - 1, step: 1, autocomplete: "off" });
    const output = make("output", {});
    output.setAttribute("for", id);
    const here = make("span", { className: "here" });
    const ticks = make("div", { className: "ticks" }, ...slider.marks.map((mark) => tick(slider, mark)));
    ticks.setAttribute("aria-hidden", "true");
    const jumps = make("div", { className: "jumps" });
    jumps.setAttribute("role", "group");
    jumps.setAttribute("aria-label", `${slider.label}: exact zeros`);
    const others = make("div", { className: "others" });
    range.disabled = slider.stops.length === 1;
    const parts = { slider, range, output, here, jumps, marks: new Map(slider.marks.map((mark) => [mark.stop, mark])) };
    for (const { stop, whole, what } of slider.marks) {
      const name = make("small", { textContent: what.join(", ") });
      const button = make("button", { type: "button", value: `${stop}`, className: whole ? "whole" : "" }, slider.stops[stop].shown, " ", name);
      button.addEventListener("click", () => move(parts, stop));
      (whole ? jumps : others).append(button);
    }
    if (others.children.length > 0) {
      const count = others.children.length === 1 ? "1 value at which one vector vanishes" : `${others.children.length} values at which one vector vanishes`;
      jumps.append(make("details", {}, make("summary", { textContent: count }), others));
    }
    range.addEventListener("input", () => move(parts, Number(range.value)));
    const label = make("label", { htmlFor: id, textContent: slider.label });
    const note = make("p", { className: "note", textContent: slider.note });
    parts.whole = make("div", { className: "slider" }, make("div", { className: "line" }, label, output, here), make("div", { className: "track" }, range, ticks), jumps, note);
    show(parts, slider.at);
    return parts;
  };

  return {
    /** What is to be done where one is moved. */
    onmove: (act) => (moved = act),
    /** What is to be done where one is let go. */
    onrelease: (act) => (released = act),
    /** Whether a finger or the mouse holds one: then none is put anew. */
    isHeld: () => held,
    /** The sliders of a layout; one that has the focus stays as it is while its stops do. */
    put: (list) => {
      const focused = document.activeElement;
      const kept = list.map((slider) => {
        const old = shown.get(slider.key);
        const same = old && JSON.stringify([old.slider.stops, old.slider.marks]) === JSON.stringify([slider.stops, slider.marks]);
        if (!same) return build(slider);
        old.slider = slider;
        if (old.range !== focused) show(old, slider.at);
        return old;
      });
      const again = [...shown.values()].find((parts) => parts.range === focused)?.slider.key;
      shown.clear();
      for (const parts of kept) shown.set(parts.slider.key, parts);
      const nodes = kept.map((parts) => parts.whole);
      if (nodes.length !== home.children.length || nodes.some((node, at) => home.children[at] !== node)) {
        home.replaceChildren(...nodes);
        if (again) shown.get(again)?.range.focus();
      }
    },
  };
})();
