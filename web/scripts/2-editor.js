// How is a mistake shown where it is? Its line in the margin, its letters underlined, its words below.
const editor = (() => {
  const [area, marked, gutter, told] = [$("layout"), $("marked"), $("gutter"), $("mistake")];
  let place = null;

  const draw = () => {
    const text = area.value;
    const lines = text.split("\n").length;
    area.rows = Math.min(Math.max(lines + 1, 8), 30);
    gutter.replaceChildren(
      ...Array.from({ length: lines }, (_, at) =>
        place?.line === at + 1 ? make("b", { textContent: `✕ ${at + 1}\n` }) : `${at + 1}\n`),
    );
    if (place) {
      const mark = make("mark", { textContent: text.slice(place.from, place.to) || " " });
      marked.replaceChildren(text.slice(0, place.from), mark, `${text.slice(place.to)}\n`);
    } else marked.replaceChildren(`${text}\n`);
    follow();
  };
  const follow = () => {
    marked.scrollTo(area.scrollLeft, area.scrollTop);
    gutter.scrollTo(0, area.scrollTop);
  };
  area.addEventListener("scroll", follow);

  /** Shows a mistake, or none. */
  const show = (mistake) => {
    place = mistake?.place ?? null;
    area.setAttribute("aria-invalid", `${Boolean(mistake)}`);
    told.replaceChildren();
    if (mistake) {
      const where = place ? `Line ${place.line}, letter ${place.column}: ` : "";
      told.append(make("p", {}, make("strong", { textContent: `${where}${mistake.message}` })));
      if (mistake.right) told.append(make("p", { textContent: mistake.right }));
      if (place) {
        const go = make("button", { type: "button", textContent: "Go there" });
        go.addEventListener("click", () => {
          area.focus();
          area.setSelectionRange(place.from, place.to);
        });
        told.append(go);
      }
      told.append(make("p", { className: "old", textContent: "What else stands here is about the last layout that could be read." }));
    }
    draw();
  };

  return {
    area,
    show,
    /** Puts a text there, the caret where it was. */
    put: (text) => {
      if (area.value === text) return;
      const caret = Math.min(area.selectionStart, text.length);
      area.value = text;
      area.setSelectionRange(caret, caret);
      draw();
    },
    draw,
  };
})();
