// Turns the engines of a page: words, verdicts and zeros come from the scene, only drawings are reckoned.
(() => {
  "use strict";
  const RADIANS = Math.PI / 180;
  const RADIUS = 78; // of a star, in its units
  const SPEED = 0.06; // degrees per ms

  const short = (number) => String(Math.round(number * 1000) / 1000);
  const set = (element, attributes) => {
    for (const [name, value] of Object.entries(attributes)) {
      element.setAttribute(name, typeof value === "number" ? short(value) : value);
    }
    return element;
  };
  const on = (target, kind, act) => target.addEventListener(kind, act);
  const put = (parent, element, text = "") => {
    element.textContent = text;
    parent.append(element);
    return element;
  };
  const draw = (parent, name, attributes, text) =>
    set(put(parent, document.createElementNS("http://www.w3.org/2000/svg", name), text), attributes);
  const path = (parent, kind, d) => draw(parent, "path", { class: kind, d });

  // Points [x, y]; angle 0 is up, angles grow anticlockwise.
  const polar = (length, degrees) => [-length * Math.sin(degrees * RADIANS), -length * Math.cos(degrees * RADIANS)];
  const plus = ([a, b], [c, d]) => [a + c, b + d];
  const times = ([a, b], by) => [a * by, b * by];
  const CENTRE = [0, 0];
  const POINT = (0.5).toLocaleString(document.documentElement.lang || "en")[1];
  const size = (point) => Math.hypot(...point);
  const dot = ([a, b], [c, d]) => a * c + b * d;
  const line = (...points) => `M${points.map((point) => point.map(short).join(" ")).join("L")}`;
  /** An arrow, longer than its head. */
  const arrow = (from, to, head) => {
    const along = plus(to, times(from, -1));
    const [x, y] = times(along, Math.min(0.4, head / size(along)));
    const barb = (turn) => plus(to, [-x - (turn * y) / 2, -y + (turn * x) / 2]);
    return size(along) < 1e-6 ? "" : line(from, to) + line(barb(1), to, barb(-1));
  };
  const decimal = (value) => `≈ ${value.toFixed(3).replace(".", POINT)}`;

  const start = (figure) => {
    const parts = (name) => figure.querySelectorAll(`[data-part="${name}"]`);
    const part = (name) => parts(name)[0];
    const { bodies, orders, angle, words } = JSON.parse(part("scene").textContent);
    let order = orders[0];
    let quantity = "force";
    let theta = 0;
    const home = angle ? angle.start.at : 0; // what finished words are about
    let value = home;

    // What the exact list says of a sum, in whole numbers.
    const atHome = () => value === home;
    const outcome = ({ zero, zeros }) => {
      if (atHome()) return zero ? "zero" : "not_zero";
      if (zeros && (zeros.everywhere || zeros.at.includes(value))) return "zero";
      if (zeros && zeros.near.includes(value)) return "near";
      return zeros && zeros.complete ? "not_zero" : "undecided";
    };
    const moved = () => (angle ? (value - home) / angle.unit : 0); // in degrees

    // The engine from its free end, pistons side by side. A rod stands on the crankpin, a link on a pin of the master rod.
    const place = ({ bank, bank_turns, throw: at, throw_turns, radius, aside, rod, knuckle }) => {
      const axis = bank + bank_turns * moved();
      const crank = at + throw_turns * moved() + theta;
      const pin = polar(radius, crank);
      let foot = pin;
      if (knuckle) {
        const master = axis - knuckle.angle;
        const lean = Math.asin((radius * Math.sin((crank - master) * RADIANS)) / knuckle.master) / RADIANS;
        foot = plus(pin, polar(knuckle.radius, master - lean + knuckle.ahead));
      }
      const across = dot(foot, polar(1, axis + 90)) - aside;
      const height = dot(foot, polar(1, axis)) + Math.sqrt(Math.max(0, rod ** 2 - across ** 2));
      const shift = polar(aside, axis + 90);
      return { axis, height, shift, pin, foot, wrist: plus(polar(height, axis), shift) };
    };
    const middle = ({ rod, knuckle }) => rod + (knuckle ? knuckle.radius : 0);
    const engine = part("engine");
    const layers = ["barrel", "crank", "rod", "piston", "pin"].map(() => draw(engine, "g", {}));
    const unit = Math.max(...bodies.map(({ radius }) => radius));
    const half = (bodies.length > 12 ? 0.36 : 0.46) * unit;
    const drawn = bodies.filter((body) => body.label !== null).map((body) => {
      const colour = `c${body.crank % 4}`;
      const piston = draw(layers[3], "g", {});
      const shape = { class: `piston ${colour}`, x: -half, y: -0.75 * half, width: 2 * half, height: 1.5 * half };
      const crown = draw(piston, "rect", shape);
      draw(piston, "text", { "font-size": half * Math.min(0.8, 3 / body.label.length) }, body.label);
      const [barrel, crank, rod] = ["barrel", "crank", "rod"].map((name, layer) =>
        path(layers[layer], `${name} ${layer ? colour : ""}`, ""));
      const pin = draw(layers[4], "circle", { class: `pin ${colour}`, r: 0.13 * unit });
      return { body, piston, crown, barrel, crank, rod, pin };
    });
    draw(layers[4], "circle", { class: "hub", r: 0.16 * unit });
    const heights = part("strip").querySelectorAll("rect");
    const drawEngine = () => {
      for (const { body, piston, crank, rod, pin } of drawn) {
        const at = place(body);
        set(piston, { transform: `translate(${at.wrist.map(short)})` });
        set(crank, { d: line(CENTRE, at.pin) });
        set(rod, { d: line(at.pin, at.foot, at.wrist) });
        set(pin, { cx: at.pin[0], cy: at.pin[1] });
      }
      bodies.forEach((body, at) => set(heights[at], { y: 9.5 - (7.5 * (place(body).height - middle(body))) / unit }));
    };
    /** Barrels, and a window on all of them: only the open angle moves them. */
    const drawBarrels = () => {
      const corners = [[-1.3 * unit, -1.3 * unit], [1.3 * unit, 1.3 * unit]];
      for (const { body, crown, barrel } of drawn) {
        const { axis, shift } = place(body);
        set(crown, { transform: `rotate(${short(-axis)})` });
        const ends = [-1, 1].map((end) => plus(shift, polar(middle(body) + end * (body.radius + half), axis)));
        const walls = [90, -90].map((side) => ends.map((end) => plus(end, polar(1.08 * half, axis + side))));
        set(barrel, { d: walls.map((wall) => line(...wall)).join("") });
        corners.push(...walls.flat());
      }
      const [xs, ys] = [0, 1].map((axis) => corners.map((corner) => corner[axis]));
      const [x, y] = [Math.min(...xs), Math.min(...ys)];
      set(engine, { viewBox: [x, y, Math.max(...xs) - x, Math.max(...ys) - y].map(short).join(" ") });
    };

    // The stars, and the path of their sums, to one scale.
    const panels = parts("star");
    const captions = parts("caption");
    /** The sum of a star turned by so many degrees; nothing where it is proved to be 0. */
    const sumOf = (sense, by = 0) => {
      if (outcome(sense) === "zero") return CENTRE;
      if (atHome()) return polar(sense.length, sense.degrees + by);
      const vector = (ray) => polar(ray.length, ray.degrees + ray.turns * moved() + by);
      return sense.rays.map(vector).reduce(plus, CENTRE);
    };
    const axes = (panel) => {
      panel.replaceChildren();
      draw(panel, "circle", { class: "axis", r: RADIUS });
      path(panel, "axis", `M0 ${-RADIUS}V${RADIUS}M${-RADIUS} 0H${RADIUS}`);
    };
    const drawStars = () => {
      const { senses, reach } = order[quantity];
      const scale = reach > 0 ? RADIUS / reach : 1;
      const phases = [order.order * theta, -order.order * theta];
      senses.forEach((sense, index) => {
        const panel = panels[index];
        axes(panel);
        path(panel, "sum", arrow(CENTRE, times(sumOf(sense, phases[index]), scale), 12));
        for (const ray of sense.rays) {
          const towards = ray.degrees + ray.turns * moved() + phases[index];
          let from = 0;
          for (const length of ray.lengths) {
            const to = from + length * scale;
            path(panel, "vector", arrow(polar(from, towards), polar(to, towards), 7));
            from = to;
          }
          const [x, y] = polar(Math.max(from, 3 * sense.rays.length) + 10, towards);
          draw(panel, "text", { x: x * (1 + (2 * ray.label.length) / size([x, y])), y }, ray.label);
        }
      });
      const ends = (by) => {
        const direct = times(sumOf(senses[0], by), scale / 2);
        return [direct, plus(direct, times(sumOf(senses[1], -by), scale / 2))];
      };
      const [direct, whole] = ends(phases[0]);
      axes(panels[2]);
      const isLeft = order.exists && senses.some((sense) => outcome(sense) !== "zero");
      if (isLeft) {
        const round = Array.from({ length: 97 }, (_, step) => ends(step * 3.75)[1]);
        path(panels[2], "path", line(...round));
        path(panels[2], "half", arrow(CENTRE, direct, 7) + arrow(direct, whole, 7));
        path(panels[2], "sum", arrow(CENTRE, whole, 12));
      } else draw(panels[2], "text", { "font-size": 40 }, "0");
      captions[2].textContent = isLeft ? `${decimal(size(whole) / scale)} at θ = ${theta}°` : words.zero;
    };

    // What is said: finished words, or those of the list.
    const angleText = () => {
      const mark = [angle.start, ...order[quantity].marks].find((one) => one.at === value);
      return mark ? mark.text : `${value / angle.unit}°`.replace("-", "−").replace(".", POINT);
    };
    const say = () => {
      const { senses, whole, words: known } = order[quantity];
      const told = senses.map((sense, index) => `${words.senses[index]} ${words[outcome(sense)]}`).join("; ");
      const at = angle ? `, ${angle.symbol} = ${angleText()}` : "";
      const said = atHome() || !order.exists ? known : told;
      const together = whole ? ` ${words.together} ${whole}.` : "";
      part("verdict").textContent = `${words.order} ${order.name}, ${words[quantity]}${at}: ${said}.${together}`;
      senses.forEach((sense, index) => {
        const result = outcome(sense);
        const now = atHome() ? sense.words : `${decimal(size(sumOf(sense)))}, ${words[result]}`;
        captions[index].textContent = result === "zero" ? words.zero : now;
      });
    };

    // What is chosen.
    const [crank, slider, jumps, ticks, play] = ["theta", "angle", "jumps", "ticks", "play"].map(part);
    const turn = (to) => {
      theta = to;
      crank.value = to;
      set(crank, { "aria-valuetext": `${to}°` });
      part("theta-text").textContent = `= ${to}°`;
      drawEngine();
      drawStars();
    };
    /** Shows the engine at a value of the open angle. */
    const move = (to) => {
      value = to;
      if (angle) {
        slider.value = to;
        set(slider, { "aria-valuetext": angleText() });
        part("angle-text").textContent = `= ${angleText()}`;
        for (const button of jumps.children) set(button, { "aria-pressed": `${button.value === `${to}`}` });
      }
      drawBarrels();
      say();
      turn(theta);
    };
    /** Ticks and buttons for the exact zeros of what is shown. */
    const mark = () => {
      const marks = order[quantity].marks;
      ticks.replaceChildren();
      jumps.replaceChildren();
      for (const { at, both } of marks) {
        const x = `${(100 * (at - angle.low)) / (angle.high - angle.low)}%`;
        draw(ticks, "line", { class: both ? "tick both" : "tick", x1: x, x2: x, y2: "12" });
      }
      const others = marks.some((one) => one.at === home) ? [] : [angle.start];
      for (const { at, text, of } of [...others, ...marks]) {
        const name = of.length ? `${text} (0: ${of.join(", ")})` : text;
        const button = put(jumps, document.createElement("button"), name);
        set(button, { type: "button", value: `${at}` });
        on(button, "click", () => move(at));
      }
    };
    const choose = () => {
      if (angle) mark();
      move(value);
    };
    on(part("order"), "change", ({ target }) => {
      order = orders[target.value];
      choose();
    });
    on(part("quantity"), "change", ({ target }) => {
      quantity = target.value;
      choose();
    });
    on(crank, "input", () => {
      stop();
      turn(Number(crank.value));
    });
    if (angle) on(slider, "input", () => move(Number(slider.value)));

    // Motion.
    let frame = 0;
    const stop = () => {
      frame = cancelAnimationFrame(frame);
      play.textContent = words.play;
    };
    const go = () => {
      const from = theta - performance.now() * SPEED;
      const step = (now) => {
        turn((Math.floor(from + now * SPEED) + 360) % 360);
        frame = requestAnimationFrame(step);
      };
      frame = requestAnimationFrame(step);
      play.textContent = words.pause;
    };
    on(play, "click", () => (frame ? stop() : go()));
    on(matchMedia("(prefers-reduced-motion: reduce)"), "change", stop);

    figure.hidden = false;
    stop();
    choose();
  };

  document.querySelectorAll("[data-moving]").forEach(start);
})();
