//! How is a drawing written as SVG?

use std::collections::BTreeSet;
use std::fmt::Write;

use super::figure::{Anchor, Dash, Figure, Ink, Mark, Point, Stroke, arrow_head, coordinate};
use crate::text::xml;

/// Pixels a millimetre on the page.
const SCALE: f64 = 4.8;
/// From the middle of a line of text to its baseline, over the size of its letters.
const BASELINE: f64 = 0.35;

/// The drawing as an SVG file, or as part of an HTML page: it has no ground and its colours follow those of the page. Rules
/// of style begin with `cs-` and are the same in every drawing, so that several on one page do not clash.
pub fn svg(figure: &Figure, title: &str) -> String {
    let (width, height) = (coordinate(figure.width), coordinate(figure.height));
    let (pixels_wide, pixels_high) = (figure.width * SCALE, figure.height * SCALE);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"cs-drawing\" role=\"img\" width=\"{pixels_wide:.0}\" \
         height=\"{pixels_high:.0}\" viewBox=\"0 0 {width} {height}\" font-family=\"Helvetica, Arial, sans-serif\" \
         font-size=\"{}\">\n<title>{}</title>\n{}",
        coordinate(figure.letters),
        xml(title),
        style(figure)
    );
    for mark in &figure.marks {
        // Writing to a string cannot fail.
        let _ = writeln!(out, "{}", element(mark, figure));
    }
    out.push_str("</svg>\n");
    out
}

/// The colours of the drawing on a light page and on a dark one.
fn style(figure: &Figure) -> String {
    let used: BTreeSet<(&str, Ink)> = figure.marks.iter().flat_map(paints).collect();
    let rules = |colour: fn(Ink) -> String| -> String {
        let one = |(paint, ink): &(&str, Ink)| format!(".{}{{{paint}:{}}}", class(paint, *ink), colour(*ink));
        used.iter().map(one).collect::<Vec<_>>().join("")
    };
    format!(
        "<style>.cs-drawing{{max-width:100%;height:auto}}{}@media screen and (prefers-color-scheme:dark){{{}}}</style>\n",
        rules(on_light),
        rules(on_dark)
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

/// `cs-stroke-red`, `cs-fill-40` for a shade.
fn class(paint: &str, ink: Ink) -> String {
    let name = match ink {
        Ink::Black => "black",
        Ink::Grey => "grey",
        Ink::Light => "light",
        Ink::Blue => "blue",
        Ink::Orange => "orange",
        Ink::Green => "green",
        Ink::Red => "red",
        Ink::Shade(percent) => return format!("cs-{paint}-{}", percent.min(100)),
    };
    format!("cs-{paint}-{name}")
}

fn element(mark: &Mark, figure: &Figure) -> String {
    let height = figure.height;
    let x = |point: &Point| coordinate(point.re);
    let y = |point: &Point| coordinate(height - point.im);
    match mark {
        Mark::Line { from, to, stroke, arrow } => {
            let head = arrow.then(|| arrow_head(*from, *to, stroke)).flatten();
            // The line ends inside of its head, which would else be blunt.
            let along = head.map_or(Point::default(), |(length, _)| (to - from) / (to - from).norm() * length);
            let end = to - along * 0.9;
            let line = format!(
                "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>",
                x(from),
                y(from),
                x(&end),
                y(&end),
                outline(stroke, "")
            );
            let corners = head.map(|(length, half)| {
                let across = along / length * Point::i() * half;
                [*to, to - along + across, to - along - across]
            });
            match corners {
                Some(corners) => {
                    format!("{line}\n{}", polygon(&corners, height, &format!("class=\"{}\"", class(FILL, stroke.ink))))
                }
                None => line,
            }
        }
        Mark::Circle { centre, radius, stroke, fill } => format!(
            "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>",
            x(centre),
            y(centre),
            coordinate(*radius),
            painted(stroke, fill)
        ),
        Mark::Polygon { corners, stroke, fill } => {
            polygon(corners, height, &format!("{} stroke-linejoin=\"round\"", painted(stroke, fill)))
        }
        Mark::Path { points, stroke } => {
            let attributes = format!("{} stroke-linejoin=\"round\"", painted(stroke, &None));
            format!("<polyline points=\"{}\" {attributes}/>", coordinates(points, height))
        }
        // Without crisp edges the cells of a map would show seams.
        Mark::Rectangles { corners, fill } => {
            let one = |(low, high): &(Point, Point)| {
                let (wide, tall) = (coordinate(high.re - low.re), coordinate(high.im - low.im));
                format!("M{},{}h{wide}v{tall}h-{wide}z", x(low), y(high))
            };
            let outlines: String = corners.iter().map(one).collect();
            format!("<path d=\"{outlines}\" class=\"{}\" shape-rendering=\"crispEdges\"/>", class(FILL, *fill))
        }
        Mark::Text { at, text, anchor, bold, .. } => {
            let anchor = hanging(*anchor);
            let weight = if *bold { " font-weight=\"bold\"" } else { "" };
            let baseline = Point::new(at.re, at.im - BASELINE * figure.letters);
            let (x, y) = (x(&baseline), y(&baseline));
            let class = class(FILL, Ink::Black);
            format!("<text class=\"{class}\" x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\"{weight}>{}</text>", xml(text))
        }
        Mark::Title { at, text, letters, anchor } => {
            let (x, y) = (coordinate(at.re), coordinate(height - at.im + 0.35 * letters));
            let (anchor, size) = (hanging(*anchor), coordinate(*letters));
            format!(
                "<text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\" font-weight=\"bold\" font-size=\"{size}\">{}</text>",
                xml(text)
            )
        }
    }
}

fn hanging(anchor: Anchor) -> &'static str {
    match anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    }
}

fn polygon(corners: &[Point], height: f64, attributes: &str) -> String {
    format!("<polygon points=\"{}\" {attributes}/>", coordinates(corners, height))
}

fn coordinates(points: &[Point], height: f64) -> String {
    let point = |p: &Point| format!("{},{}", coordinate(p.re), coordinate(height - p.im));
    points.iter().map(point).collect::<Vec<_>>().join(" ")
}

/// The outline and the colour inside.
fn painted(stroke: &Stroke, fill: &Option<Ink>) -> String {
    match fill {
        Some(ink) => outline(stroke, &format!(" {}", class(FILL, *ink))),
        None => format!("fill=\"none\" {}", outline(stroke, "")),
    }
}

/// The line, with further classes.
fn outline(stroke: &Stroke, classes: &str) -> String {
    let dash = match stroke.dash {
        Dash::Solid => "",
        Dash::Dashed => " stroke-dasharray=\"1.6 1\"",
        Dash::Dotted => " stroke-dasharray=\"0.4 0.8\"",
        Dash::DashDotted => " stroke-dasharray=\"2 0.7 0.4 0.7\"",
    };
    format!("class=\"{}{classes}\" stroke-width=\"{}\"{dash}", class(STROKE, stroke.ink), coordinate(stroke.width))
}

/// Blue, green and orange rise in lightness by equal steps, so that they differ in grey and for the colour-blind.
fn on_light(ink: Ink) -> String {
    let known = match ink {
        Ink::Black => "#111111",
        Ink::Grey => "#8a8a8a",
        Ink::Light => "#e8e8e8",
        Ink::Blue => "#1f4e9c",
        Ink::Orange => "#e69f00",
        Ink::Green => "#2e8b57",
        Ink::Red => "#b2182b",
        Ink::Shade(percent) => return grey(255, 0, percent),
    };
    known.to_owned()
}

/// The same on a dark page, in the same order of lightness, and darker than the vectors upon them.
fn on_dark(ink: Ink) -> String {
    let known = match ink {
        Ink::Black => "#f0f0f0",
        Ink::Grey => "#8f959c",
        Ink::Light => "#3a3f46",
        Ink::Blue => "#3a7ae0",
        Ink::Orange => "#e3ab32",
        Ink::Green => "#35a066",
        Ink::Red => "#ff6b6b",
        Ink::Shade(percent) => return grey(17, 255, percent),
    };
    known.to_owned()
}

/// A grey so many per cent of the way from the ground.
fn grey(ground: u8, ink: u8, percent: u8) -> String {
    let percent = f64::from(percent.min(100)) / 100.0;
    let level = f64::from(ground) + (f64::from(ink) - f64::from(ground)) * percent;
    let level = level.round() as u8;
    format!("#{level:02x}{level:02x}{level:02x}")
}
