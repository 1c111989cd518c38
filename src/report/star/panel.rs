//! How is one star drawn? About its centre: ring, polygons, vectors, and the resultant above them.

use super::labels::Labels;
use super::scale::{LETTERS, SAME, Scale, WIDTH};
use super::{Ray, Star, corners, part_felt, upright};
use crate::engine::Engine;
use crate::page::Number;
use crate::page::figure::{Anchor, Dash, Extent, Figure, Ink, Point, Stroke, text_width};
use crate::proof::{Polygon, Quantity, Sense};
use crate::report::{residual, typeset};
use crate::verdict::{JudgedStar, Verdict};

/// More rays than this are drawn without labels.
pub(super) const MOST_LABELS: usize = 36;
/// Three and more equal vectors shorter than this, in millimetres, are drawn as one arrow with their number; two, where they
/// are much shorter.
const SHORTEST: f64 = 2.2;
const SHORTEST_PAIR: f64 = 0.8;
/// Rings smaller than this say nothing.
const SMALLEST_RING: f64 = 2.0;
/// Smaller stars than this are drawn in finer lines.
const FINE: f64 = 12.0;
/// The greatest radius of a circle of labels in millimetres.
const MOST_ROOM: f64 = 14.0;
/// Width of the outline of a resultant in millimetres.
const OUTLINE: f64 = 0.5;
/// A shorter resultant than this, in millimetres, is filled: its outline would close.
const SHORT_RESULTANT: f64 = 2.5;

/// One star, its centre at the origin, with the texts above and below it.
pub(in crate::report) struct Panel {
    /// What it shows: `Force, direct, order 2`.
    pub heading: String,
    /// The length of the sum, in plain text and as prose.
    pub sum: (String, String),
    /// The star with its labels.
    pub drawing: Figure,
    /// What its lengths mean.
    pub scale: Scale,
}

impl Panel {
    /// The star of a verdict.
    pub fn new(engine: &Engine, verdict: &Verdict, star: &Star, scale: Scale) -> Self {
        let heading = heading(verdict.quantity, verdict.order, verdict.sense);
        Panel::headed(heading, engine, sum(verdict.into()), star, scale)
    }

    /// Any star, under this heading, above what its vectors sum to.
    pub fn headed(heading: String, engine: &Engine, sum: (String, String), star: &Star, scale: Scale) -> Self {
        let mut drawing = Figure::new(0.0, 0.0).lettered(LETTERS);
        match star.rays.is_empty() {
            true => drawing.text(Point::default(), star.nothing(), Anchor::Middle),
            false => draw(&mut drawing, engine, star, scale.millimetres),
        }
        Panel { heading, sum, drawing, scale }
    }

    /// What the star covers, its centre included.
    pub fn extent(&self) -> Extent {
        let nothing = Extent { low: Point::default(), high: Point::default() };
        self.drawing.extent().map_or(nothing, |extent| extent.joined(&nothing))
    }
}

pub(super) fn heading(quantity: Quantity, order: u32, sense: Option<Sense>) -> String {
    match (quantity, sense) {
        (Quantity::FORCE, Some(Sense::Direct)) => format!("Force, direct, order {order}"),
        (Quantity::FORCE, Some(Sense::Reverse)) => format!("Force, reverse, order {order}"),
        (Quantity::FORCE, None) => format!("Force, order {order}"),
        (Quantity::MOMENT, Some(Sense::Direct)) => format!("Moment, direct, order {order}"),
        (Quantity::MOMENT, Some(Sense::Reverse)) => format!("Moment, reverse, order {order}"),
        (Quantity::MOMENT, None) => format!("Moment, order {order}"),
        (Quantity::Axial(_), _) => format!("Torque, order {order}"),
    }
}

/// `sum = 0`, `resultant = √10 ≈ 3.162`; in decimals alone where the exact form has no room.
pub(super) fn sum(judged: JudgedStar<'_>) -> (String, String) {
    if judged.vanishes() {
        return ("sum = 0".to_owned(), "sum = 0".to_owned());
    }
    let resultant = residual::modulus_of(&judged.sum.scaled(&part_felt(judged.quantity)));
    let (plain, in_decimals) = (format!("resultant = {}", resultant.plain()), rounded_sum(resultant.decimal));
    match resultant.number() {
        Number::Zero | Number::Exact(_) | Number::Closed(..) if text_width(&plain, LETTERS) <= WIDTH - 2.0 => {
            (plain, format!("resultant = {}", resultant.prose()))
        }
        Number::Zero | Number::Exact(_) | Number::Closed(..) | Number::Decimal(_) => in_decimals,
    }
}

/// The same in decimals.
pub(super) fn rounded_sum(length: f64) -> (String, String) {
    let words = format!("resultant {}", typeset::approximate(length));
    (words.clone(), words)
}

fn draw(figure: &mut Figure, engine: &Engine, star: &Star, scale: f64) {
    let centre = Point::default();
    let mut labels = Labels::new(WIDTH / 2.0 - 0.5, LETTERS);
    let ring = star.reach() * scale;
    let guide = Point::new(0.0, ring + 1.0);
    if ring > SMALLEST_RING && has_both_halves(star) {
        figure.circle(centre, ring, Stroke::solid(Ink::Light, 0.25), None);
        let corner = |part: i32| Point::from_polar(ring, f64::from(part) * std::f64::consts::PI / 24.0);
        labels.avoid_guide(&(0..=48).map(corner).collect::<Vec<_>>());
    }
    figure.line(centre, guide, Stroke { ink: Ink::Grey, width: 0.2, dash: Dash::Dashed });
    labels.avoid_guide(&[centre, guide]);
    let fine = (ring / FINE).clamp(0.3, 1.0);
    for (index, polygon) in star.polygons.iter().enumerate() {
        let corners = draw_polygon(figure, (scale, fine), polygon, index);
        labels.avoid_guide(&corners);
    }
    for ray in &star.rays {
        let along = ray.along();
        let mut start = centre;
        for (length, _) in ray.arrows(scale) {
            let end = start + along * length;
            figure.arrow(start, end, Stroke::solid(Ink::Black, 0.35 * fine));
            start = end;
        }
        labels.avoid(centre, start);
    }
    if let Some(resultant) = star.resultant {
        labels.avoid_resultant(&draw_resultant(figure, upright(resultant) * scale, OUTLINE));
    }
    if star.rays.len() <= MOST_LABELS {
        let named = |ray: &Ray| {
            let counts: Vec<usize> = ray.arrows(scale).into_iter().map(|(_, count)| count).collect();
            ray.labels(engine, &counts, LETTERS)
        };
        let named: Vec<(&Ray, Vec<Vec<String>>)> = star.rays.iter().map(|ray| (ray, named(ray))).collect();
        // The names of short vectors are on a circle that has room for all.
        let room = named
            .iter()
            .filter_map(|(_, ways)| ways.first())
            .map(|lines| (Labels::width(lines, LETTERS) + LETTERS) / 2.0);
        let least = (room.sum::<f64>() / std::f64::consts::TAU).min(MOST_ROOM);
        for (ray, ways) in &named {
            let (along, long) = (ray.along(), ray.length() * scale);
            labels.write(figure, (along * long, along * long.max(least)), along, ways);
        }
    }
}

/// Whether some of the star points up and some down; the ring of another would be half empty.
fn has_both_halves(star: &Star) -> bool {
    let tips = star.rays.iter().map(|ray| ray.along() * ray.length()).chain(star.resultant.map(upright));
    let heights: Vec<f64> = tips.map(|tip| tip.im / star.reach()).collect();
    heights.iter().any(|height| *height > 0.2) && heights.iter().any(|height| *height < -0.2)
}

/// Whether a drawing tells two lengths apart.
fn alike(one: f64, other: f64) -> bool {
    (one - other).abs() <= SAME * one.max(other)
}

impl Ray {
    /// The arrows it is drawn in, in millimetres, each with the number of vectors that it stands for.
    pub(super) fn arrows(&self, scale: f64) -> Vec<(f64, usize)> {
        let mut groups: Vec<(f64, usize)> = Vec::new();
        for (_, length) in &self.members {
            match groups.iter_mut().find(|(of_group, _)| alike(*of_group, *length)) {
                Some((_, count)) => *count += 1,
                None => groups.push((*length, 1)),
            }
        }
        let arrows = |(length, count): (f64, usize)| {
            let one = length * scale;
            if one < SHORTEST_PAIR || count > 2 && one < SHORTEST {
                vec![(one * count as f64, count)]
            } else {
                vec![(one, 1); count]
            }
        };
        groups.into_iter().flat_map(arrows).collect()
    }
}

/// Draws a polygon in the colour and dash of its number; its corners in order, the first again at the end.
fn draw_polygon(figure: &mut Figure, (scale, fine): (f64, f64), polygon: &Polygon, index: usize) -> Vec<Point> {
    const INKS: [Ink; 3] = [Ink::Blue, Ink::Orange, Ink::Green];
    const DASHES: [Dash; 4] = [Dash::Solid, Dash::Dashed, Dash::DashDotted, Dash::Dotted];
    let (ink, dash) = (INKS[index % 3], DASHES[index % 4]);
    let mut corners = corners(polygon, scale);
    let width = fine * if polygon.sides == 2 { 1.6 } else { 0.8 };
    figure.polygon(corners.clone(), Stroke { ink, width, dash }, None);
    for corner in &corners {
        figure.circle(*corner, 0.9 * fine, Stroke::solid(ink, 0.3 * fine), Some(ink));
    }
    corners.extend(corners.first().copied());
    corners
}

/// An arrow in outline from the origin, through which the vectors below it are seen; its corners. The outline is so wide, in
/// millimetres, where the arrow is not short.
pub(super) fn draw_resultant(figure: &mut Figure, tip: Point, outline: f64) -> Vec<Point> {
    let length = tip.norm();
    if length < 1e-6 {
        return Vec::new();
    }
    let (along, across) = (tip / length, tip / length * Point::i());
    let head = (0.4 * length).min(3.5 + 1.4 * outline);
    let (half, shaft) = (0.45 * head, 0.27 * head);
    let neck = tip - along * head;
    let corners = vec![
        across * shaft,
        neck + across * shaft,
        neck + across * half,
        tip,
        neck - across * half,
        neck - across * shaft,
        -across * shaft,
    ];
    let fill = (length < SHORT_RESULTANT).then_some(Ink::Red);
    figure.polygon(corners.clone(), Stroke::solid(Ink::Red, (0.07 * length).clamp(0.2, outline)), fill);
    corners
}
