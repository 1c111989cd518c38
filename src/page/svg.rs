//! How is a drawing written as SVG?

use std::borrow::Cow;
use std::fmt::Write;

use super::figure::{Anchor, Dash, Figure, Ink, Mark, Point, Stroke, coordinate};
use crate::text::xml;

/// Pixels a millimetre on the page.
const SCALE: f64 = 4.8;

/// The drawing as an SVG file with a white ground, so that it reads on dark pages too.
pub fn svg(figure: &Figure, title: &str) -> String {
    let (width, height) = (coordinate(figure.width), coordinate(figure.height));
    let (pixels_wide, pixels_high) = (figure.width * SCALE, figure.height * SCALE);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{pixels_wide:.0}\" height=\"{pixels_high:.0}\" \
         viewBox=\"0 0 {width} {height}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"3\">\n\
         <title>{}</title>\n<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n",
        xml(title)
    );
    for mark in &figure.marks {
        // Writing to a string cannot fail.
        let _ = writeln!(out, "{}", element(mark, figure.height));
    }
    out.push_str("</svg>\n");
    out
}

fn element(mark: &Mark, height: f64) -> String {
    let x = |point: &Point| coordinate(point.re);
    let y = |point: &Point| coordinate(height - point.im);
    match mark {
        Mark::Line { from, to, stroke, arrow } => {
            let line = format!(
                "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>",
                x(from),
                y(from),
                x(to),
                y(to),
                outline(stroke)
            );
            let head = arrow.then(|| arrow_head(*from, *to, stroke)).flatten();
            match head {
                Some(corners) => {
                    format!("{line}\n{}", polygon(&corners, height, &format!("fill=\"{}\"", colour(stroke.ink))))
                }
                None => line,
            }
        }
        Mark::Circle { centre, radius, stroke, fill } => format!(
            "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {} {}/>",
            x(centre),
            y(centre),
            coordinate(*radius),
            inside(fill),
            outline(stroke)
        ),
        Mark::Polygon { corners, stroke, fill } => {
            polygon(corners, height, &format!("{} {} stroke-linejoin=\"round\"", inside(fill), outline(stroke)))
        }
        Mark::Path { points, stroke } => {
            let attributes = format!("fill=\"none\" {} stroke-linejoin=\"round\"", outline(stroke));
            format!("<polyline points=\"{}\" {attributes}/>", coordinates(points, height))
        }
        // Without crisp edges the cells of a map would show seams.
        Mark::Rectangles { corners, fill } => {
            let one = |(low, high): &(Point, Point)| {
                let (wide, tall) = (coordinate(high.re - low.re), coordinate(high.im - low.im));
                format!("M{},{}h{wide}v{tall}h-{wide}z", x(low), y(high))
            };
            let outlines: String = corners.iter().map(one).collect();
            format!("<path d=\"{outlines}\" fill=\"{}\" shape-rendering=\"crispEdges\"/>", colour(*fill))
        }
        Mark::Text { at, text, anchor, bold, .. } => {
            let anchor = hanging(*anchor);
            let weight = if *bold { " font-weight=\"bold\"" } else { "" };
            let baseline = Point::new(at.re, at.im - 1.05);
            let (x, y) = (x(&baseline), y(&baseline));
            format!("<text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\"{weight}>{}</text>", xml(text))
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

/// A slim triangle at the end of a line; none on a line of no length.
fn arrow_head(from: Point, to: Point, stroke: &Stroke) -> Option<[Point; 3]> {
    let length = (to - from).norm();
    let along = (length > 1e-6).then(|| (to - from) / length)?;
    let across = along * Point::i();
    let size = 1.2 + 1.6 * stroke.width;
    Some([to, to - along * size * 1.6 + across * size * 0.5, to - along * size * 1.6 - across * size * 0.5])
}

fn outline(stroke: &Stroke) -> String {
    let dash = match stroke.dash {
        Dash::Solid => "",
        Dash::Dashed => " stroke-dasharray=\"1.6 1\"",
        Dash::Dotted => " stroke-dasharray=\"0.4 0.8\"",
        Dash::DashDotted => " stroke-dasharray=\"2 0.7 0.4 0.7\"",
    };
    format!("stroke=\"{}\" stroke-width=\"{}\"{dash}", colour(stroke.ink), coordinate(stroke.width))
}

fn inside(fill: &Option<Ink>) -> String {
    format!("fill=\"{}\"", fill.map_or_else(|| "none".into(), colour))
}

fn colour(ink: Ink) -> Cow<'static, str> {
    let known = match ink {
        Ink::Black => "#111111",
        Ink::Grey => "#999999",
        Ink::Light => "#e8e8e8",
        Ink::Blue => "#1f4e9c",
        Ink::Orange => "#e08214",
        Ink::Green => "#3a9a5b",
        Ink::Red => "#b2182b",
        Ink::Shade(percent) => {
            let level = 255 - (u16::from(percent.min(100)) * 255 + 50) / 100;
            return format!("#{level:02x}{level:02x}{level:02x}").into();
        }
    };
    known.into()
}
