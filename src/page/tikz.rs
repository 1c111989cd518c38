//! How is a drawing written as TikZ?

use std::fmt::Write;

use super::figure::{Anchor, Dash, Figure, Ink, Mark, Point, Stroke, arrow_head, coordinate};
use super::markup::{Mark as Sign, marks};
use crate::text::latex;

/// Longer paths are split, so that TeX holds only this many points at a time.
const LONGEST_PATH: usize = 500;
/// Points on a line of the file.
const POINTS_A_LINE: usize = 12;

/// The drawing as a `tikzpicture`; the colours are defined in a template.
pub fn tikz(figure: &Figure) -> String {
    let (letters, line) = (coordinate(figure.letters), coordinate(1.2 * figure.letters));
    let mut out =
        format!("\\begin{{tikzpicture}}[x=1mm,y=1mm,font=\\fontsize{{{letters}mm}}{{{line}mm}}\\selectfont]\n");
    let corner = point(&Point::new(figure.width, figure.height));
    let _ = writeln!(out, "\\useasboundingbox (0,0) rectangle {corner};");
    for mark in &figure.marks {
        let _ = writeln!(out, "{}", command(mark));
    }
    out.push_str("\\end{tikzpicture}\n");
    out
}

fn command(mark: &Mark) -> String {
    match mark {
        Mark::Line { from, to, stroke, arrow } => {
            let head = arrow.then(|| arrow_head(*from, *to, stroke)).flatten();
            let head = head.map_or(String::new(), |(length, half)| {
                format!(",-{{Stealth[length={}mm,width={}mm,inset=0mm]}}", coordinate(length), coordinate(2.0 * half))
            });
            format!("\\draw[{}{head}] {} -- {};", outline(stroke), point(from), point(to))
        }
        Mark::Circle { centre, radius, stroke, fill } => {
            format!("\\draw[{}{}] {} circle ({});", outline(stroke), inside(fill), point(centre), coordinate(*radius))
        }
        Mark::Polygon { corners, stroke, fill } => {
            let corners: Vec<String> = corners.iter().map(point).collect();
            format!("\\draw[{}{},line join=round] {} -- cycle;", outline(stroke), inside(fill), corners.join(" -- "))
        }
        Mark::Path { points, stroke } => path(points, stroke),
        Mark::Rectangles { corners, fill } => {
            let one = |(low, high): &(Point, Point)| format!("{}rectangle{}", point(low), point(high));
            let fills = corners.chunks(LONGEST_PATH).map(|chunk| {
                let lines = chunk.chunks(POINTS_A_LINE / 2);
                let lines: Vec<String> = lines.map(|line| line.iter().map(one).collect()).collect();
                format!("\\fill[{}] {};", colour(*fill), lines.join("\n"))
            });
            fills.collect::<Vec<_>>().join("\n")
        }
        Mark::Text { at, text, prose, anchor, bold } => {
            let anchor = hanging(*anchor);
            let text = prose.as_ref().map_or_else(|| latex(text), |prose| prose_in_tex(prose));
            let text = if *bold { format!("\\textbf{{{text}}}") } else { text };
            format!("\\node[anchor={anchor},inner sep=0pt] at {} {{{text}}};", point(at))
        }
        Mark::Title { at, text, letters, anchor } => {
            let (anchor, size) = (hanging(*anchor), coordinate(*letters));
            let font = format!("\\fontsize{{{size}mm}}{{{size}mm}}\\selectfont\\bfseries");
            format!("\\node[anchor={anchor},inner sep=0pt,font={font}] at {} {{{}}};", point(at), latex(text))
        }
    }
}

fn hanging(anchor: Anchor) -> &'static str {
    match anchor {
        Anchor::Start => "west",
        Anchor::Middle => "center",
        Anchor::End => "east",
    }
}

/// Words with `$formulas$`.
fn prose_in_tex(prose: &str) -> String {
    let set = |mark: Sign| match mark {
        Sign::Words(words) => latex(words),
        Sign::Formula(tex) => format!("${tex}$"),
        Sign::Bold | Sign::Place(_) => String::new(),
    };
    marks(prose).into_iter().map(set).collect()
}

fn path(points: &[Point], stroke: &Stroke) -> String {
    let mut pieces = Vec::new();
    let mut start = 0;
    // Neighbouring pieces share a point.
    while start + 1 < points.len() {
        let end = points.len().min(start + LONGEST_PATH);
        let lines = points[start..end].chunks(POINTS_A_LINE);
        let lines: Vec<String> = lines.map(|line| line.iter().map(point).collect()).collect();
        let options = format!("{},line join=round", outline(stroke));
        pieces.push(format!("\\draw[{options}] plot coordinates {{{}}};", lines.join("\n")));
        start = end - 1;
    }
    pieces.join("\n")
}

fn point(point: &Point) -> String {
    format!("({},{})", coordinate(point.re), coordinate(point.im))
}

fn outline(stroke: &Stroke) -> String {
    let dash = match stroke.dash {
        Dash::Solid => "",
        Dash::Dashed => ",dashed",
        Dash::Dotted => ",dash pattern=on 0.4mm off 0.8mm",
        Dash::DashDotted => ",dash pattern=on 2mm off 0.7mm on 0.4mm off 0.7mm",
    };
    format!("{},line width={}mm{dash}", colour(stroke.ink), coordinate(stroke.width))
}

fn inside(fill: &Option<Ink>) -> String {
    fill.map_or(String::new(), |ink| format!(",fill={}", colour(ink)))
}

fn colour(ink: Ink) -> String {
    match ink {
        Ink::Shade(percent) => format!("black!{}", percent.min(100)),
        named => format!("cs{}", named.name()),
    }
}
