// Turns the engines of a page: words, verdicts and zeros come from the scene, only drawings are computed.
(() => {
  "use strict";
  const RADIANS = Math.PI / 180;
  const RADIUS = 66; // of a star, in its units
  const LETTERS = 11.5; // of names, in pixels of the screen
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
  /** To four figures; what is less than a millionth is a rounded zero. */
  const decimal = (value) => `≈ ${String(Number(value < 1e-6 ? 0 : value.toPrecision(4))).replace(".", POINT)}`;

  const start = (figure) => {
    const parts = (name) => figure.querySelectorAll(`[data-part="${name}"]`);
    const part = (name) => parts(name)[0];
    const { bodies, orders, start: [first, left], units, angle, words } = JSON.parse(part("scene").textContent);
    if (!orders.length) return;
    let order = orders[first];
    let quantity = left;
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

    // The engine from its free end, pistons side by side. A rod is on the crankpin, a link on a pin of the master rod.
    const place = (body, turned = theta) => {
      const { bank, bank_turns, throw: at, throw_turns, radius, aside, rod, knuckle, speed } = body;
      const axis = bank + bank_turns * moved();
      const crank = at + throw_turns * moved() + speed * turned;
      const pin = polar(radius, crank);
      let foot = pin;
      if (knuckle) {
        const master = axis - knuckle.angle;
        const lean = Math.asin((radius * Math.sin((crank - master) * RADIANS)) / knuckle.master) / RADIANS;
        foot = plus(pin, polar(knuckle.radius, master - lean + knuckle.ahead));
      }
      const across = dot(foot, polar(1, axis + 90)) - aside;
      const height = dot(foot, polar(1, axis)) + Math.sqrt(Math.max(0, rod ** 2 - across ** 2));
      const centre = [body.axis[0], -body.axis[1]];
      const shift = plus(centre, polar(aside, axis + 90));
      const [at_pin, at_foot] = [pin, foot].map((point) => plus(centre, point));
      return { axis, height, centre, shift, crank, pin: at_pin, foot: at_foot, wrist: plus(polar(height, axis), shift) };
    };
    const middle = ({ rod, knuckle }) => rod + (knuckle ? knuckle.radius : 0);
    const engine = part("engine");
    const layers = ["barrel", "crank", "rod", "piston", "pin", "names"].map(() => draw(engine, "g", {}));
    const unit = Math.max(...bodies.map(({ radius }) => radius));
    const half = (bodies.length > 12 ? 0.36 : 0.46) * unit;
    const drawn = bodies.filter((body) => body.label !== null).map((body) => {
      const colour = `c${body.colour % 4}`;
      const piston = draw(layers[3], "g", {});
      const shape = { class: `piston ${colour}`, x: -half, y: -0.75 * half, width: 2 * half, height: 1.5 * half };
      const crown = draw(piston, "rect", shape);
      const [barrel, crank, rod] = ["barrel", "crank", "rod"].map((name, layer) =>
        path(layers[layer], `${name} ${layer ? colour : ""}`, ""));
      const pin = draw(layers[4], "circle", { class: `pin ${colour}`, r: 0.13 * unit });
      return { body, piston, crown, barrel, crank, rod, pin };
    });
    for (const [x, y] of new Set(bodies.map(({ axis }) => axis))) {
      draw(layers[4], "circle", { class: "hub", r: 0.16 * unit, cx: x, cy: -y });
    }

    // Names: of a piston that has its cylinder for itself beyond that, of the others beside their pin; at no angle on another, or on a line.
    const shares = (one, other) => one !== other && size(plus(barrelEnd(one), times(barrelEnd(other), -1))) < half;
    const barrelEnd = (body) => {
      const { axis, shift } = place(body, 0);
      return plus(shift, polar(middle(body) + body.radius + 1.9 * half, axis));
    };
    const extent = (text, letters) => [0.62 * letters * (text.length + 1), 1.15 * letters];
    /** Whether a line passes through the rectangle of a name. */
    const crosses = ([x, y], [w, h], [from, to]) => {
      const [a, along] = [plus(from, [-x, -y]), plus(to, times(from, -1))];
      let [enters, leaves] = [0, 1];
      for (const [start, way, half] of [[a[0], along[0], w / 2], [a[1], along[1], h / 2]]) {
        if (Math.abs(way) < 1e-9) {
          if (Math.abs(start) > half) return false;
          continue;
        }
        const [one, other] = [(-half - start) / way, (half - start) / way];
        enters = Math.max(enters, Math.min(one, other));
        leaves = Math.min(leaves, Math.max(one, other));
      }
      return enters < leaves;
    };
    /** Those of these names that have room at most angles, free of each other and of the lines: at each angle the choice of a place, -1 where none is free. */
    const apart = (names, letters, { widest = Infinity, lines = [], mostHidden = 0 } = {}) => {
      const kept = [];
      for (const name of names) {
        const box = extent(name.text, letters);
        const meets = ([x, y], at) => kept.some(({ box: [w, h], stands }) => stands[at] &&
          Math.abs(x - stands[at][0]) < (box[0] + w) / 2 && Math.abs(y - stands[at][1]) < (box[1] + h) / 2);
        const free = (point, at) => !meets(point, at) && !(lines[at] || []).some((ends) => crosses(point, box, ends));
        let last = 0; // where it is it stays, as long as that is free
        const chosen = name.places.map((places, at) => {
          const choice = [last, ...places.keys()].find((one) => free(places[one], at)) ?? -1;
          last = Math.max(choice, 0);
          return choice;
        });
        const hidden = chosen.filter((choice) => choice < 0).length;
        if (name.text && box[0] < widest && hidden <= mostHidden * chosen.length) {
          kept.push({ ...name, box, chosen, stands: chosen.map((choice, at) => name.places[at][choice]) });
        }
      }
      return kept;
    };
    let names = [];
    const nameEngine = () => {
      const box = engine.getBoundingClientRect();
      const [, , width, height] = engine.getAttribute("viewBox").split(" ").map(Number);
      const letters = LETTERS / (Math.min(box.width / width, box.height / height) || LETTERS);
      const bare = (body) => !drawn.some((other) => shares(body, other.body));
      const ends = drawn.filter(({ body }) => bare(body)).map(({ body }) => ({ text: body.label, at: () => [barrelEnd(body)] }));
      const shared = new Set(drawn.filter(({ body }) => !bare(body)).map(({ body }) => body.crank));
      const pins = bodies.filter(({ pin, crank }) => pin !== null && shared.has(crank));
      const around = (body) => {
        const [w, h] = extent(body.pin, letters);
        const beside = ({ pin, crank }, far, by) => {
          const [x, y] = polar(1, crank + by);
          return plus(pin, [x * (far * unit + w / 2), y * (far * unit + h / 2)]);
        };
        const ways = [0, 30, -30, 60, -60, 90, -90, 120, -120, 150, -150];
        return (turned) => {
          const at = place(body, turned);
          return [0.18, 0.4].flatMap((far) => ways.map((by) => beside(at, far, by)));
        };
      };
      const all = [...ends, ...pins.map((body) => ({ text: body.pin, at: around(body) }))];
      const turns = Array.from({ length: 36 }, (_, step) => 10 * step);
      const lines = turns.map((turned) => drawn.flatMap(({ body }) => {
        const { centre, pin, foot, wrist } = place(body, turned);
        return [[centre, pin], [pin, foot], [foot, wrist]];
      }).concat(walls));
      layers[5].replaceChildren();
      names = apart(all.map((name) => ({ ...name, places: turns.map(name.at) })), letters, { lines, mostHidden: 0.3 });
      for (const name of names) name.mark = draw(layers[5], "text", { class: "name", "font-size": letters }, name.text);
    };
    const heights = part("strip").querySelectorAll("rect");
    const drawEngine = () => {
      for (const { body, piston, crank, rod, pin } of drawn) {
        const at = place(body);
        set(piston, { transform: `translate(${at.wrist.map(short)})` });
        set(crank, { d: line(at.centre, at.pin) });
        set(rod, { d: line(at.pin, at.foot, at.wrist) });
        set(pin, { cx: at.pin[0], cy: at.pin[1] });
      }
      for (const { at, chosen, mark } of names) {
        const choice = chosen[Math.round(theta / 10) % chosen.length];
        const [x, y] = at(theta)[Math.max(choice, 0)];
        set(mark, { x, y, visibility: choice < 0 ? "hidden" : "visible" });
      }
      bodies.forEach((body, at) => set(heights[at], { y: 9.5 - (7.5 * (place(body).height - middle(body))) / unit }));
    };
    /** Barrels, and a window on all of them: only the open angle moves them. */
    let walls = [];
    const drawBarrels = () => {
      const corners = [];
      walls = [];
      for (const { body, crown, barrel } of drawn) {
        const { axis, shift, centre } = place(body);
        corners.push(plus(centre, [-1.5 * unit, -1.5 * unit]), plus(centre, [1.5 * unit, 1.5 * unit]), barrelEnd(body));
        set(crown, { transform: `rotate(${short(-axis)})` });
        const ends = [-1, 1].map((end) => plus(shift, polar(middle(body) + end * (body.radius + half), axis)));
        const both = [90, -90].map((side) => ends.map((end) => plus(end, polar(1.08 * half, axis + side))));
        set(barrel, { d: both.map((wall) => line(...wall)).join("") });
        walls.push(...both);
        corners.push(...both.flat());
      }
      const [xs, ys] = [0, 1].map((axis) => corners.map((corner) => corner[axis]));
      const [x, y] = [Math.min(...xs), Math.min(...ys)];
      set(engine, { viewBox: [x, y, Math.max(...xs) - x, Math.max(...ys) - y].map(short).join(" ") });
      nameEngine();
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
    /** The resultants of an order, halved, end to end, each multiplied by the order's coefficient where that is asked for. */
    const ends = (of, turned, [length, degrees] = [1, 0]) => {
      const by = of.order * turned + degrees;
      const [direct, reverse] = of[quantity].senses.map((sense, index) => times(sumOf(sense, index ? -by : by), length / 2));
      return [direct, plus(direct, reverse)];
    };
    const felt = orders.filter(({ exists, coefficient }) => exists && coefficient);
    const total = (turned) => felt.map((of) => ends(of, turned, of.coefficient)[1]).reduce(plus, CENTRE);
    const ROUND = Array.from({ length: 181 }, (_, step) => step * 2);
    const counted = (value, [length] = [1]) => {
      const unit = units && units[quantity === "force" ? 0 : 1];
      return unit ? `${decimal(value * length * unit.factor)} ${unit.name}` : decimal(value);
    };
    let traced = { largest: 0, points: [] };
    const trace = () => {
      const points = ROUND.map(total);
      traced = { points, largest: Math.max(...points.map(size)) };
    };
    /** The names of the vectors of a star that stay free of each other. */
    const labels = (sense, scale, letters) => {
      const beyond = (ray) => Math.max((ray.length * scale) / 2, 2 * sense.rays.length) + 0.9 * letters;
      const at = (ray, by) => {
        const [x, y] = polar(beyond(ray), ray.degrees + ray.turns * moved() + by);
        const most = 110 - 0.31 * letters * (ray.label.length + 1); // inside of the panel
        return [Math.max(-most, Math.min(most, x * (1 + (0.27 * letters * ray.label.length) / (size([x, y]) || 1)))), y];
      };
      const turns = Array.from({ length: 24 }, (_, step) => 15 * step);
      const all = sense.rays.map((ray) => ({ text: ray.label, at: (by) => at(ray, by), places: turns.map((by) => [at(ray, by)]) }));
      return apart(all, letters, { widest: 1.4 * RADIUS });
    };
    const starScale = ({ reach }) => (reach > 0 ? (2 * RADIUS) / reach : 1); // vectors count half
    let starNames = [[], []];
    let starLetters = LETTERS;
    const nameStars = () => {
      starLetters = (LETTERS * 220) / (panels[0].getBoundingClientRect().width || 220);
      starNames = order[quantity].senses.map((sense) => labels(sense, starScale(sense), starLetters));
    };
    const drawStars = () => {
      const { senses } = order[quantity];
      const phases = [order.order * theta, -order.order * theta];
      senses.forEach((sense, index) => {
        const [panel, scale] = [panels[index], starScale(sense)];
        axes(panel);
        path(panel, "sum", arrow(CENTRE, times(sumOf(sense, phases[index]), scale / 2), 12));
        for (const ray of sense.rays) {
          const towards = ray.degrees + ray.turns * moved() + phases[index];
          let from = 0;
          for (const length of ray.lengths) {
            const to = from + (length * scale) / 2;
            path(panel, "vector", arrow(polar(from, towards), polar(to, towards), 7));
            from = to;
          }
        }
        for (const { text, at } of starNames[index]) {
          const [x, y] = at(phases[index]);
          draw(panel, "text", { class: "name", x, y, "font-size": starLetters }, text);
        }
      });
      axes(panels[2]);
      const itself = (turned) => ends(order, turned, [1, order.coefficient?.[1] ?? 0]); // in its own direction, the length that of the stars
      const [direct, whole] = itself(theta);
      const wide = RADIUS / (order[quantity].senses.map((sense) => size(sumOf(sense)) / 2).reduce((a, b) => a + b) || 1);
      const isLeft = order.exists && senses.some((sense) => outcome(sense) !== "zero");
      if (isLeft) {
        path(panels[2], "path", line(...ROUND.map((turned) => times(itself(turned)[1], wide))));
        const [middle, end] = [direct, whole].map((point) => times(point, wide));
        path(panels[2], "half", arrow(CENTRE, middle, 7) + arrow(middle, end, 7));
        path(panels[2], "sum", arrow(CENTRE, end, 12));
      } else draw(panels[2], "text", { "font-size": 40 }, "0");
      captions[2].textContent = isLeft ? `${counted(size(whole), order.coefficient || [1])} ${words.at} θ = ${theta}°` : words.zero;
      if (!panels[3]) return;
      axes(panels[3]);
      const isZero = felt.every((of) => of[quantity].senses.every((sense) => outcome(sense) === "zero"));
      if (!isZero) {
        const by = RADIUS / (traced.largest || 1);
        path(panels[3], "path", line(...traced.points.map((point) => times(point, by))));
        path(panels[3], "sum", arrow(CENTRE, times(total(theta), by), 12));
      } else draw(panels[3], "text", { "font-size": 40 }, "0");
      captions[3].textContent = isZero ? words.zero : `${counted(size(total(theta)))}, ${words.largest} ${counted(traced.largest)}`;
    };

    // What is said: finished words, or those of the list.
    const angleText = () => {
      const mark = [angle.start, ...order[quantity].marks].find((one) => one.at === value);
      return mark ? mark.text : `${value / angle.unit}°`.replace("-", "−").replace(".", POINT);
    };
    const say = () => {
      const { senses, most, words: known } = order[quantity];
      const told = senses.map((sense, index) => `${words.senses[index]} ${words[outcome(sense)]}`).join("; ");
      const at = angle ? `, ${angle.symbol} = ${angleText()}` : "";
      const said = atHome() || !order.exists ? known : told;
      const amount = most && atHome() ? `${most}; ` : "";
      part("verdict").textContent = `${words.order} ${order.order}, ${words[quantity]}${at}: ${amount}${said}.`;
      senses.forEach((sense, index) => {
        const result = outcome(sense);
        const now = atHome() ? sense.words : `${decimal(size(sumOf(sense)) / 2)}, ${words[result]}`;
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
      nameStars();
      if (panels[3]) trace();
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
    // On paper a picture says nothing where nothing is left.
    const balanced = ({ exists, force, moment }) => !exists || [force, moment].every(({ senses }) => senses.every(({ zero }) => zero));
    figure.classList.toggle("moving-balanced", orders.every(balanced));
    stop();
    choose();
    new ResizeObserver(() => move(value)).observe(figure);
  };

  document.querySelectorAll("[data-moving]").forEach(start);
})();
