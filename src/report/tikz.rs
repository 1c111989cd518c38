//! How is a drawing written as TikZ?

use std::fmt::Write;

use super::dialect::{Dialect, latex_text};
use super::figure::{Anchor, Dash, Figure, Ink, Mark, Point, Stroke, coordinate};

/// The drawing as a `tikzpicture`; the colours are defined in the template.
pub fn tikz(figure: &Figure) -> String {
    let mut out = String::from("\\begin{tikzpicture}[x=1mm,y=1mm,font=\\footnotesize]\n");
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
            let head = if *arrow { ",-Stealth" } else { "" };
            format!("\\draw[{}{head}] {} -- {};", outline(stroke), point(from), point(to))
        }
        Mark::Circle { centre, radius, stroke, fill } => {
            format!("\\draw[{}{}] {} circle ({});", outline(stroke), inside(fill), point(centre), coordinate(*radius))
        }
        Mark::Polygon { corners, stroke, fill } => {
            let corners: Vec<String> = corners.iter().map(point).collect();
            format!("\\draw[{}{},line join=round] {} -- cycle;", outline(stroke), inside(fill), corners.join(" -- "))
        }
        Mark::Text { at, text, prose, anchor, bold } => {
            let anchor = match anchor {
                Anchor::Start => "west",
                Anchor::Middle => "center",
                Anchor::End => "east",
            };
            let text = prose.as_ref().map_or_else(|| latex_text(text), |prose| Dialect::Latex.prose(prose));
            let text = if *bold { format!("\\textbf{{{text}}}") } else { text };
            format!("\\node[anchor={anchor},inner sep=0pt] at {} {{{text}}};", point(at))
        }
    }
}

fn point(point: &Point) -> String {
    format!("({},{})", coordinate(point.re), coordinate(point.im))
}

fn outline(stroke: &Stroke) -> String {
    let dash = match stroke.dash {
        Dash::Solid => "",
        Dash::Dashed => ",dashed",
        Dash::Dotted => ",densely dotted",
    };
    format!("{},line width={}mm{dash}", colour(stroke.ink), coordinate(stroke.width))
}

fn inside(fill: &Option<Ink>) -> String {
    fill.map_or(String::new(), |ink| format!(",fill={}", colour(ink)))
}

fn colour(ink: Ink) -> &'static str {
    match ink {
        Ink::Black => "csblack",
        Ink::Grey => "csgrey",
        Ink::Light => "cslight",
        Ink::Blue => "csblue",
        Ink::Orange => "csorange",
        Ink::Green => "csgreen",
        Ink::Red => "csred",
    }
}
