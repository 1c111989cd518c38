//! What does the engine look like? The crank star with the banks from the free end, and the crankshaft from the side.

use std::collections::{BTreeMap, BTreeSet};

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::figure::{Anchor, Dash, Figure, Ink, Point, Stroke};
use super::star::towards;
use super::typeset;
use crate::engine::{Cylinder, Engine};
use crate::exact::Turn;

/// More banks than this are not drawn as rows of the side view.
const MOST_ROWS: usize = 4;
/// More throws or banks than this are drawn without labels.
const MOST_LABELS: usize = 36;

/// The names of the cylinders that share something, by what they share.
fn groups<K: Ord>(engine: &Engine, key: impl Fn(&Cylinder) -> K) -> BTreeMap<K, Vec<&str>> {
    let mut groups: BTreeMap<K, Vec<&str>> = BTreeMap::new();
    for cylinder in engine.cylinders() {
        groups.entry(key(cylinder)).or_default().push(&cylinder.name);
    }
    groups
}

/// The engine from its free end at θ = 0: pins inside, cylinder axes outside, angle 0 upwards.
pub(super) fn end_view(engine: &Engine) -> Figure {
    let mut figure = Figure::new(100.0, 92.0);
    let centre = Point::new(50.0, 46.0);
    let throws = groups(engine, |cylinder| cylinder.throw.clone());
    let banks = groups(engine, |cylinder| cylinder.bank.clone());
    for (bank, names) in &banks {
        let along = towards(bank);
        let across = along * Point::i();
        figure.line(centre, centre + along * 38.0, Stroke { ink: Ink::Grey, width: 0.25, dash: Dash::Dashed });
        let half = if banks.len() > 12 { 2.2 } else { 3.2 };
        let corner = |reach: f64, side: f64| centre + along * reach + across * side;
        let barrel = vec![corner(26.0, half), corner(35.0, half), corner(35.0, -half), corner(26.0, -half)];
        figure.polygon(barrel, Stroke::solid(Ink::Black, 0.3), Some(Ink::Light));
        if banks.len() <= MOST_LABELS {
            figure.text(centre + along * 40.5, typeset::names(names), anchor(along));
        }
    }
    figure.circle(centre, 10.0, Stroke::solid(Ink::Grey, 0.2), None);
    for (throw, names) in &throws {
        let along = towards(throw);
        let pin = centre + along * 10.0;
        figure.line(centre, pin, Stroke::solid(Ink::Blue, 1.4));
        figure.circle(pin, 1.7, Stroke::solid(Ink::Blue, 0.4), Some(Ink::Light));
        if throws.len() <= MOST_LABELS {
            figure.text(centre + along * 16.5, typeset::names(names), Anchor::Middle);
        }
    }
    figure.circle(centre, 2.0, Stroke::solid(Ink::Black, 0.4), Some(Ink::Light));
    figure
}

fn anchor(along: Point) -> Anchor {
    match along.re {
        x if x > 0.3 => Anchor::Start,
        x if x < -0.3 => Anchor::End,
        _ => Anchor::Middle,
    }
}

/// Where things stand in the side view, in millimetres.
const WIDTH: f64 = 148.0;
const AXIS: f64 = 26.0;
const CRANK_RADIUS: f64 = 8.0;
const FIRST_ROW: f64 = 42.0;
const ROW: f64 = 9.0;

/// The crankshaft from the side, free end at the left: pins at the height of their throws, cylinders above.
pub(super) fn side_view(engine: &Engine) -> Figure {
    let banks: BTreeSet<&Turn> = engine.cylinders().iter().map(|cylinder| &cylinder.bank).collect();
    let rows = if banks.len() <= MOST_ROWS { banks.len() } else { 1 };
    let mut figure = Figure::new(WIDTH, FIRST_ROW + ROW * rows as f64 + 3.0);
    let scale = Scale::new(engine);
    let plane = scale.x(engine.reference_plane());
    let top = figure.height - 1.0;
    figure.line(
        Point::new(plane, AXIS - CRANK_RADIUS),
        Point::new(plane, top),
        Stroke { ink: Ink::Red, width: 0.25, dash: Dash::Dashed },
    );
    figure.line(Point::new(6.0, AXIS), Point::new(WIDTH - 6.0, AXIS), Stroke::solid(Ink::Grey, 1.0));
    figure.text(Point::new(1.0, AXIS + 4.0), "free end", Anchor::Start);
    figure.arrow(Point::new(16.0, 2.5), Point::new(4.0, 2.5), Stroke::solid(Ink::Grey, 0.3));
    figure.text(Point::new(17.5, 2.5), "z", Anchor::Start);
    draw_pins(&mut figure, engine, &scale);
    draw_cylinders(&mut figure, engine, &scale, &banks);
    figure
}

/// Positions along the crankshaft on the page: +z to the left.
struct Scale {
    highest: f64,
    millimetres: f64,
    /// Smallest distance between two positions on the page.
    gap: f64,
}

impl Scale {
    fn new(engine: &Engine) -> Self {
        let mut positions: Vec<f64> =
            engine.cylinders().iter().filter_map(|cylinder| cylinder.position.to_f64()).collect();
        positions.sort_by(f64::total_cmp);
        let (low, high) = (positions.first().copied().unwrap_or(0.0), positions.last().copied().unwrap_or(0.0));
        let span = high - low;
        let millimetres = if span > 0.0 { 112.0 / span } else { 1.0 };
        let gaps = positions.windows(2).map(|pair| (pair[1] - pair[0]) * millimetres).filter(|gap| *gap > 1e-9);
        let highest = if span > 0.0 { high } else { high + WIDTH / 2.0 - 18.0 };
        Scale { highest, millimetres, gap: gaps.fold(f64::INFINITY, f64::min) }
    }

    /// Kept on the page for a reference plane far from the engine.
    fn x(&self, position: &BigRational) -> f64 {
        let x = 18.0 + (self.highest - position.to_f64().unwrap_or(0.0)) * self.millimetres;
        x.clamp(2.0, WIDTH - 2.0)
    }
}

fn draw_pins(figure: &mut Figure, engine: &Engine, scale: &Scale) {
    let mut at_position: BTreeMap<&BigRational, BTreeSet<&Turn>> = BTreeMap::new();
    for cylinder in engine.cylinders() {
        at_position.entry(&cylinder.position).or_default().insert(&cylinder.throw);
    }
    let lines_apart = if scale.gap < 11.0 { 2 } else { 1 };
    for (index, (position, throws)) in at_position.iter().rev().enumerate() {
        let x = scale.x(position);
        for (line, throw) in throws.iter().enumerate() {
            let pin = Point::new(x, AXIS + CRANK_RADIUS * towards(throw).im);
            figure.line(Point::new(x, AXIS), pin, Stroke::solid(Ink::Blue, 1.0));
            figure.circle(pin, 1.5, Stroke::solid(Ink::Blue, 0.4), Some(Ink::Light));
            let level = (line + index % lines_apart * throws.len()) as f64;
            if at_position.len() <= MOST_LABELS {
                figure.text(Point::new(x, 13.5 - 3.8 * level), typeset::angle(throw), Anchor::Middle);
            }
        }
    }
}

fn draw_cylinders(figure: &mut Figure, engine: &Engine, scale: &Scale, banks: &BTreeSet<&Turn>) {
    let as_rows = banks.len() <= MOST_ROWS;
    let row_of = |cylinder: &Cylinder| {
        if as_rows { banks.iter().position(|bank| **bank == cylinder.bank).unwrap_or(0) } else { 0 }
    };
    let by_place = groups(engine, |cylinder| (row_of(cylinder), cylinder.position.clone()));
    let half = if scale.gap.is_finite() { (scale.gap * 0.42).clamp(0.6, 3.4) } else { 3.4 };
    for ((row, position), names) in &by_place {
        let (x, y) = (scale.x(position), FIRST_ROW + ROW * *row as f64);
        let label = typeset::names(names);
        // A box is as wide as its label, where its neighbours leave room.
        let half = half.max((label.chars().count() as f64 + 0.5).min(scale.gap * 0.42));
        let corners = [(-half, -3.4), (half, -3.4), (half, 3.4), (-half, 3.4)];
        let corners = corners.map(|(dx, dy)| Point::new(x + dx, y + dy)).to_vec();
        figure.polygon(corners, Stroke::solid(Ink::Black, 0.3), Some(Ink::Light));
        if by_place.len() <= MOST_LABELS {
            figure.text(Point::new(x, y), label, Anchor::Middle);
        }
    }
    if as_rows && banks.len() > 1 {
        for (row, bank) in banks.iter().enumerate() {
            let degrees = typeset::signed_degrees(bank);
            let sign = if degrees.is_positive() { "+" } else { "" };
            let label = format!("{sign}{}", typeset::degrees(&degrees));
            figure.text(Point::new(1.0, FIRST_ROW + ROW * row as f64), label, Anchor::Start);
        }
    }
}
