//! How is a drawing written as SVG? Marks that are painted alike share their attributes: a page has many drawings, and they are most of its bytes.

mod colour;
mod outline;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use self::colour::{class, colours};
use self::outline::{number, outline, rectangle};
use super::figure::{Anchor, Dash, Figure, Ink, Mark, Point, Stroke, arrow_head};
use crate::text::xml;

/// Pixels a millimetre on the page.
const SCALE: f64 = 4.8;
/// From the middle of a line of text to its baseline, over the size of its letters.
const BASELINE: f64 = 0.35;

/// The drawing as an SVG file, or as part of an HTML page: it has no ground and its colours follow those of the page. Rules
/// of style begin with `cs-` and are the same in every drawing, so that several on one page do not clash.
pub fn svg(figure: &Figure, title: &str) -> String {
    let (width, height) = (number(figure.width), number(figure.height));
    let (pixels_wide, pixels_high) = (figure.width * SCALE, figure.height * SCALE);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"cs-drawing\" role=\"img\" width=\"{pixels_wide:.0}\" \
         height=\"{pixels_high:.0}\" viewBox=\"0 0 {width} {height}\" font-family=\"Helvetica, Arial, sans-serif\" \
         font-size=\"{}\" fill=\"none\" stroke-linejoin=\"round\">\n<title>{}</title>\n{}",
        number(figure.letters),
        xml(title),
        style(figure)
    );
    for run in runs(figure) {
        // Writing to a string cannot fail.
        let _ = writeln!(out, "{}", run.written());
    }
    out.push_str("</svg>\n");
    out
}

/// The colours of the drawing on a light page and on a dark one.
fn style(figure: &Figure) -> String {
    let used: BTreeSet<(&str, Ink)> = figure.marks.iter().flat_map(paints).collect();
    let rules = |page: usize| -> String {
        let one = |(paint, ink): &(&str, Ink)| format!(".{}{{{paint}:{}}}", class(paint, *ink), colours(*ink)[page]);
        used.iter().map(one).collect()
    };
    let (light, dark) = (rules(0), rules(1));
    format!(
        "<style>.cs-drawing{{max-width:100%;height:auto}}{light}@media screen and (prefers-color-scheme:dark){{{dark}}}</style>\n"
    )
}

/// What a mark is painted with.
fn paints(mark: &Mark) -> Vec<(&'static str, Ink)> {
    match mark {
        Mark::Line { stroke, arrow, .. } => {
            [(STROKE, stroke.ink)].into_iter().chain(arrow.then_some((FILL, stroke.ink))).collect()
        }
        Mark::Path { stroke, .. } => vec![(STROKE, stroke.ink)],
        Mark::Circle { stroke, fill, .. } | Mark::Polygon { stroke, fill, .. } => {
            [(STROKE, stroke.ink)].into_iter().chain(fill.map(|ink| (FILL, ink))).collect()
        }
        Mark::Rectangles { fill, .. } => vec![(FILL, *fill)],
        Mark::Text { .. } | Mark::Title { .. } => vec![(FILL, Ink::Black)],
    }
}

const STROKE: &str = "stroke";
const FILL: &str = "fill";

/// What a mark is drawn with, but for how it is painted.
enum Shape {
    /// Data of a path: what is painted alike may share one.
    Outline(String),
    /// The start of an element that stands alone, and what it holds.
    Element(String, Option<String>),
}

/// Shapes that are painted alike.
struct Run {
    attributes: String,
    shapes: Vec<Shape>,
}

/// The only ink of a mark.
fn only_ink(mark: &Mark) -> Option<Ink> {
    let inks: BTreeSet<Ink> = paints(mark).into_iter().map(|(_, ink)| ink).collect();
    if inks.len() == 1 { inks.first().copied() } else { None }
}

/// The marks in their order, but for two freedoms that nobody sees: neighbours of one and the same ink are sorted by how they are painted, and
/// texts lie upon all else.
fn runs(figure: &Figure) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    let mut texts: BTreeMap<String, Vec<Shape>> = BTreeMap::new();
    // Where the neighbours of the last ink begin.
    let (mut ink, mut from) = (None, 0);
    for mark in &figure.marks {
        if matches!(mark, Mark::Text { .. } | Mark::Title { .. }) {
            for (attributes, shape) in pieces(mark, figure) {
                texts.entry(attributes).or_default().push(shape);
            }
            continue;
        }
        let own = only_ink(mark);
        if own != ink {
            (ink, from) = (own, runs.len());
        } else if own.is_none() {
            from = runs.len().saturating_sub(1).max(from);
        }
        for (attributes, shape) in pieces(mark, figure) {
            match runs[from..].iter_mut().find(|run| run.attributes == attributes) {
                Some(run) => run.shapes.push(shape),
                None => runs.push(Run { attributes, shapes: vec![shape] }),
            }
        }
    }
    runs.extend(texts.into_iter().map(|(attributes, shapes)| Run { attributes, shapes }));
    runs
}

impl Run {
    /// One element, or a group of them, each on its line.
    fn written(&self) -> String {
        let (mut outlines, mut elements) = (String::new(), Vec::new());
        for shape in &self.shapes {
            match shape {
                Shape::Outline(data) => outlines.push_str(data),
                Shape::Element(start, content) => elements.push((start.clone(), content.clone())),
            }
        }
        if !outlines.is_empty() {
            elements.insert(0, (format!("<path d=\"{outlines}\""), None));
        }
        let whole = |(start, content): &(String, Option<String>), attributes: &str| match content {
            Some(content) => format!("{start}{attributes}>{content}</text>"),
            None => format!("{start}{attributes}/>"),
        };
        match elements.as_slice() {
            [one] => whole(one, &format!(" {}", self.attributes)),
            several => {
                let lines: Vec<String> = several.iter().map(|element| whole(element, "")).collect();
                format!("<g {}>\n{}\n</g>", self.attributes, lines.join("\n"))
            }
        }
    }
}

/// The shapes of a mark, each with how it is painted.
fn pieces(mark: &Mark, figure: &Figure) -> Vec<(String, Shape)> {
    let height = figure.height;
    match mark {
        Mark::Line { from, to, stroke, arrow } => {
            let head = arrow.then(|| arrow_head(*from, *to, stroke)).flatten();
            // The line ends inside of its head, which would else be blunt.
            let along = head.map_or(Point::default(), |(length, _)| (to - from) / (to - from).norm() * length);
            let line = (painted(stroke, &None), Shape::Outline(outline(&[*from, to - along * 0.9], height, false)));
            let head = head.map(|(length, half)| {
                let across = along / length * Point::i() * half;
                let corners = [*to, to - along + across, to - along - across];
                (format!("class=\"{}\"", class(FILL, stroke.ink)), Shape::Outline(outline(&corners, height, true)))
            });
            [line].into_iter().chain(head).collect()
        }
        Mark::Circle { centre, radius, stroke, fill } => {
            let (x, y) = (number(centre.re), number(height - centre.im));
            let start = format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\"", number(*radius));
            vec![(painted(stroke, fill), Shape::Element(start, None))]
        }
        Mark::Polygon { corners, stroke, fill } => {
            let data = outline(corners, height, true);
            let shape = match fill {
                None => Shape::Outline(data),
                // The colour inside lies upon what was drawn before.
                Some(_) => Shape::Element(format!("<path d=\"{data}\""), None),
            };
            vec![(painted(stroke, fill), shape)]
        }
        Mark::Path { points, stroke } => {
            vec![(painted(stroke, &None), Shape::Outline(outline(points, height, false)))]
        }
        // Without crisp edges the cells of a map would show seams.
        Mark::Rectangles { corners, fill } => {
            let outlines: String = corners.iter().map(|(low, high)| rectangle(*low, *high, height)).collect();
            let attributes = format!("class=\"{}\" shape-rendering=\"crispEdges\"", class(FILL, *fill));
            vec![(attributes, Shape::Outline(outlines))]
        }
        Mark::Text { at, text, anchor, bold, .. } => {
            let weight = if *bold { " font-weight=\"bold\"" } else { "" };
            vec![written_text(*at, text, figure.letters, height, *anchor, weight)]
        }
        Mark::Title { at, text, letters, anchor } => {
            let weight = format!(" font-weight=\"bold\" font-size=\"{}\"", number(*letters));
            vec![written_text(*at, text, *letters, height, *anchor, &weight)]
        }
    }
}

/// A line of text in letters of this many millimetres.
fn written_text(at: Point, text: &str, letters: f64, height: f64, anchor: Anchor, more: &str) -> (String, Shape) {
    let (x, y) = (number(at.re), number(height - at.im + BASELINE * letters));
    let attributes = format!("class=\"{}\" text-anchor=\"{}\"{more}", class(FILL, Ink::Black), hanging(anchor));
    (attributes, Shape::Element(format!("<text x=\"{x}\" y=\"{y}\""), Some(indexed(text, letters))))
}

/// The text with the index of `c_k` below its line.
fn indexed(text: &str, letters: f64) -> String {
    let [small, down, up] = [0.7, 0.2, -0.2].map(|part| number(part * letters));
    let mut parts = text.split("c_k");
    let mut out = parts.next().map_or_else(String::new, xml);
    for after in parts {
        let _ = write!(out, "c<tspan dy=\"{down}\" font-size=\"{small}\">k</tspan>");
        if !after.is_empty() {
            let _ = write!(out, "<tspan dy=\"{up}\">{}</tspan>", xml(after));
        }
    }
    out
}

fn hanging(anchor: Anchor) -> &'static str {
    match anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    }
}

/// How an outline is painted, and what is inside.
fn painted(stroke: &Stroke, fill: &Option<Ink>) -> String {
    let inside = fill.map(|ink| format!(" {}", class(FILL, ink))).unwrap_or_default();
    let dash = match stroke.dash {
        Dash::Solid => "",
        Dash::Dashed => " stroke-dasharray=\"1.6 1\"",
        Dash::Dotted => " stroke-dasharray=\".4 .8\"",
        Dash::DashDotted => " stroke-dasharray=\"2 .7 .4 .7\"",
    };
    format!("class=\"{}{inside}\" stroke-width=\"{}\"{dash}", class(STROKE, stroke.ink), number(stroke.width))
}
