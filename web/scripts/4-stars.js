// How does the engine turn on the page? By the moving part of the reports, put in again where the layout changes.
const stars = (() => {
  const home = $("scenes");
  let script = "";

  const part = (figure, name) => figure.querySelector(`[data-part="${name}"]`);
  /** What a person has chosen in a scene. */
  const chosen = (figure) => {
    const order = part(figure, "order");
    const play = part(figure, "play");
    const state = {
      order: order.options[order.selectedIndex]?.textContent,
      quantity: figure.querySelector("input[type=radio]:checked")?.value,
      theta: part(figure, "theta").value,
      plays: play.dataset.plays === "true",
      focus: document.activeElement?.dataset?.part,
      has: figure.contains(document.activeElement),
    };
    if (state.plays) play.click(); // so that it stops before it goes
    return state;
  };
  const change = (control, kind) => control.dispatchEvent(new Event(kind, { bubbles: true }));
  const choose = (figure, state, isOther) => {
    const order = part(figure, "order");
    // Another engine opens on what it leaves first.
    const found = isOther ? -1 : [...order.options].findIndex((option) => option.textContent === state.order);
    if (found >= 0) {
      order.selectedIndex = found;
      change(order, "change");
    }
    const radio = [...figure.querySelectorAll("input[type=radio]")].find((one) => one.value === state.quantity);
    if (radio && !radio.checked && !isOther) {
      radio.checked = true;
      change(radio, "change");
    }
    const theta = part(figure, "theta");
    theta.value = state.theta;
    change(theta, "input");
    if (state.plays) part(figure, "play").click();
    if (state.has && state.focus) part(figure, state.focus)?.focus();
  };

  const stamp = (figure, { svg, name }, at) => {
    const button = make("button", { type: "button", innerHTML: svg });
    button.append(make("span", { textContent: name }));
    button.addEventListener("click", () => {
      const order = part(figure, "order");
      order.selectedIndex = at;
      change(order, "change");
    });
    return button;
  };

  home.addEventListener("click", ({ target }) => {
    if (target.dataset?.part === "play") target.dataset.plays = target.dataset.plays === "true" ? "false" : "true";
  });
  home.addEventListener("input", ({ target }) => {
    // Who turns the crank by hand stops it.
    if (target.dataset?.part === "theta") part(target.closest("[data-moving]"), "play").dataset.plays = "false";
  });

  return {
    style: (moving) => {
      $("moving-style").textContent = moving.style;
      script = moving.script;
    },
    /** Scenes, and the star of each of their orders in the size of a stamp. */
    put: (scenes, small, isOther) => {
      const before = [...home.querySelectorAll("[data-moving]")].map(chosen);
      home.innerHTML = scenes.join("");
      const run = make("script", { textContent: script });
      document.body.append(run);
      run.remove();
      [...home.querySelectorAll("[data-moving]")].forEach((figure, at) => before[at] && choose(figure, before[at], isOther));
      const first = home.querySelector("[data-moving]");
      const stamps = first ? small.map((star, at) => stamp(first, star, at)) : [];
      $("glance").replaceChildren(...stamps);
      if (first) {
        const order = part(first, "order");
        const show = () => stamps.forEach((one, at) => one.setAttribute("aria-pressed", `${order.selectedIndex === at}`));
        order.addEventListener("change", show);
        show();
      }
    },
  };
})();
