//! What does the engine look like from the side? The crankshaft with its free end at the left, the cylinders above.

use std::collections::BTreeMap;

use num_rational::BigRational;

use super::super::figure::{Anchor, Dash, Figure, Ink, LETTERS, Point, Stroke};
use super::super::plot::labels::LINE;
use super::super::plot::number::text_width;
use super::super::typeset;
use super::MOST_LABELS;
use super::crankshaft::{Drawn, RADIUS, Side, draw_bearing, draw_crankshaft, drawn_throws, ends, sign};
use super::crop::cropped;
use super::rows::{draw_rows, in_levels};
use super::scale::Scale;
use crate::engine::Engine;

/// Heights over the axis of the crankshaft: the first row of cylinders, the angles of the throws.
const FIRST_ROW: f64 = RADIUS + 4.5;
const ANGLES: f64 = -RADIUS - 4.6;
/// Lines of the legend are not longer than this, or than the crankshaft.
const LEGEND: f64 = 82.0;

/// Between the views of two crankshafts, and beside them for words that are longer in another language.
const APART: f64 = 6.0;
const BESIDE: f64 = 2.0;

/// The engine from the side, positions to scale: pins at their heights, filled where they stand towards the reader; of several
/// crankshafts one below the other.
pub fn side_view(engine: &Engine) -> Figure {
    if engine.geared_cranks().is_empty() {
        return of_crankshaft(engine);
    }
    let cranks = engine.geared_cranks().iter().enumerate();
    let views: Vec<(&str, Figure)> = cranks
        .filter_map(|(index, crank)| Some((crank.name.as_str(), of_crankshaft(&engine.crankshaft_alone(index)?))))
        .collect();
    let width = views.iter().map(|(_, view)| view.width).fold(0.0, f64::max);
    let height = views.iter().map(|(_, view)| view.height + LINE + APART).sum();
    let (mut whole, mut top) = (Figure::new(width + 2.0 * BESIDE, height), height);
    for (name, view) in views {
        top -= LINE;
        whole.title(Point::new(BESIDE, top), name, LETTERS, Anchor::Start);
        top -= view.height;
        whole.place(view, Point::new(BESIDE, top));
        top -= APART;
    }
    whole
}

fn of_crankshaft(engine: &Engine) -> Figure {
    let scale = Scale::new(engine);
    let throws = drawn_throws(engine, &scale);
    let (left, right) = ends(&scale, &throws);
    let mut figure = Figure::new(0.0, 0.0);
    let (plane, moved) = scale.near(engine.reference_plane());
    let lowest = if throws.len() <= MOST_LABELS { ANGLES + LINE / 2.0 } else { -RADIUS - 2.0 };
    let guide = figure.marks.len();
    draw_crankshaft(&mut figure, engine, &scale, &throws);
    let top = draw_rows(&mut figure, engine, &scale, FIRST_ROW, left - 1.0) + 1.5;
    let mut behind = Figure::new(0.0, 0.0);
    behind.line(
        Point::new(plane, lowest),
        Point::new(plane, top),
        Stroke { ink: Ink::Red, width: 0.3, dash: Dash::Dashed },
    );
    figure.marks.splice(guide..guide, behind.marks);
    let words = if moved { "reference plane, farther off" } else { "reference plane" };
    figure.text(Point::new(plane, top + LINE / 2.0), words, Anchor::Middle);
    figure.arrow(Point::new(left - 0.5, 0.0), Point::new(left - 6.0, 0.0), Stroke::solid(Ink::Grey, 0.3));
    figure.text(Point::new(left - 1.0, 3.0), "free end", Anchor::End);
    figure.text(Point::new(left - 7.0, 0.0), "z", Anchor::End);
    let bottom = write_angles(&mut figure, &throws);
    draw_legend(&mut figure, engine, &throws, (left, right), bottom - LINE * 1.3);
    cropped(figure)
}

/// The angles of the throws below them; gives the lowest line.
fn write_angles(figure: &mut Figure, throws: &[Drawn]) -> f64 {
    if throws.len() > MOST_LABELS {
        return ANGLES;
    }
    // Throws at one position share a text.
    let mut places: BTreeMap<_, (f64, Vec<String>)> = BTreeMap::new();
    for throw in throws {
        let entry = places.entry(&throw.throw.position).or_insert((0.0, Vec::new()));
        entry.0 += throw.x;
        let angle = typeset::angle(&throw.throw.angle);
        if !entry.1.contains(&angle) {
            entry.1.push(angle);
        }
    }
    let count = |position: &BigRational| throws.iter().filter(|throw| throw.throw.position == *position).count();
    let texts: Vec<(f64, String)> = places
        .iter()
        .rev()
        .map(|(position, (sum, angles))| (sum / count(position) as f64, angles.join(", ")))
        .collect();
    in_levels(figure, &texts, ANGLES, -1.0)
}

/// What can be in the legend.
enum Entry {
    Pin(Side),
    /// Counterweights have the code of the pins; one of them stands for all.
    Counterweight(Side),
    Bearing,
}

impl Entry {
    fn words(&self) -> &'static str {
        match self {
            Entry::Pin(Side::Near) => "pin towards the reader",
            Entry::Pin(Side::InPlane) => "pin in the plane of the page",
            Entry::Pin(Side::Away) => "pin away from the reader",
            Entry::Counterweight(_) => "counterweight, likewise",
            Entry::Bearing => "main bearing",
        }
    }

    fn draw(&self, figure: &mut Figure, at: Point) {
        match self {
            Entry::Pin(side) => sign(figure, at, *side, Ink::Blue),
            Entry::Counterweight(side) => sign(figure, at, *side, Ink::Black),
            Entry::Bearing => draw_bearing(figure, at),
        }
    }
}

/// What the signs mean that are on this drawing, in lines below it.
fn draw_legend(figure: &mut Figure, engine: &Engine, throws: &[Drawn], (left, right): (f64, f64), top: f64) {
    let sides = [Side::Near, Side::InPlane, Side::Away];
    let pins = sides.into_iter().filter(|side| throws.iter().any(|throw| throw.side == *side)).map(Entry::Pin);
    let weight = engine.crankshaft().counterweights.first();
    let weight = weight.map(|weight| Entry::Counterweight(Side::of(&weight.angle, engine.convention())));
    let bearings = (!engine.bearings().is_empty()).then_some(Entry::Bearing);
    let start = left - 12.0;
    let (mut x, mut y) = (start, top);
    for entry in pins.chain(weight).chain(bearings) {
        let words = entry.words();
        let width = 3.2 + text_width(words);
        if x > start && x + width > start + LEGEND.max(right - start) {
            (x, y) = (start, y - LINE - 1.4);
        }
        entry.draw(figure, Point::new(x + 1.7, y));
        figure.text(Point::new(x + 4.4, y), words, Anchor::Start);
        x += width + 4.0;
    }
}
