//! How do forces, moments and torque run through a revolution? Curves of each order and of their sum, and the path of the vector.

use std::f64::consts::TAU;

use num_complex::Complex;

use super::amounts::{Unit, is_left};
use crate::engine::Engine;
use crate::loads::{Circle, Loads, OrderLoads, Outcome, Torque, Waveform};
use crate::page::plot::{Axis, Curve, Plot, Polar, stacked};
use crate::page::{Picture, Text, phrase};
use crate::proof::Quantity;

/// Steps of a revolution in a plot.
const STEPS: usize = 360;
/// A component below this part of the largest is the rounding of one that is zero.
const NOTHING: f64 = 1e-12;

/// All plots of the numbers of an engine; none of what is zero.
pub(in crate::report) fn figures(engine: &Engine, loads: &Loads) -> Vec<Picture> {
    let mut figures = Vec::new();
    let forces = ("force", "Force", &loads.force, Unit::of(engine, loads, Quantity::Force));
    let moments = ("moment", "Moment", &loads.moment, Unit::of(engine, loads, Quantity::Moment));
    let is_left = |name: &str| {
        let swing = |order: &OrderLoads| if name == "force" { is_left(&order.force) } else { is_left(&order.moment) };
        loads.orders.iter().any(swing)
    };
    for (name, title, waveform, unit) in [forces, moments].into_iter().filter(|(name, ..)| is_left(name)) {
        let sides = match name {
            "force" => ["along the reference direction", "across it, in the plane of the cylinders"],
            _ => ["of the forces along the reference direction (pitching)", "of the forces across it (yawing)"],
        };
        let parts: [fn(Complex<f64>) -> f64; 2] = [|vector| vector.re, |vector| vector.im];
        let drawn = [0, 1].map(|side| curves(waveform, unit, title, sides[side], parts[side]));
        let both = drawn.iter().all(Option::is_some);
        for (mark, drawn) in ["along", "across"].into_iter().zip(drawn) {
            figures.extend(drawn.map(|drawn| drawn.named(format!("{name}-{mark}"))));
        }
        figures.extend(both.then(|| path(name, title, waveform, unit)));
    }
    let is_left = |torque: &&Torque| torque.orders.iter().any(|order| order.vector.outcome == Outcome::NotZero);
    if let Some(torque) = loads.torque.as_ref().filter(is_left) {
        let unit = Unit::of(engine, loads, Quantity::Torque);
        let drawn = curves(&torque.waveform, unit, "Inertia torque", "on the crankshaft", |vector| vector.re);
        figures.extend(drawn.map(|drawn| drawn.named("torque".into())));
    }
    figures
}

/// More curves than this are not drawn in one plot.
const MOST_CURVES: usize = 3;

/// A component over the crank angle: its plots below each other, and what they show.
struct Drawn {
    plots: Vec<Plot>,
    caption: String,
}

impl Drawn {
    fn named(self, name: String) -> Picture {
        let figure = stacked(self.plots.iter().map(Plot::figure).collect());
        Picture { name, caption: Text::phrase(self.caption, Vec::new()), figure }
    }
}

/// One order of a component: its number, and its points.
type Order = (u32, Vec<(f64, f64)>);

/// The plots of one component; none where it is zero. The sum and the two largest orders come first, the rest below.
fn curves(waveform: &Waveform, unit: Unit, title: &str, side: &str, part: fn(Complex<f64>) -> f64) -> Option<Drawn> {
    let waveform = waveform.scaled(unit.factor);
    let points = |waveform: &Waveform| -> Vec<(f64, f64)> {
        let degrees = |step: usize| step as f64 * 360.0 / STEPS as f64;
        (0..=STEPS).map(|step| (degrees(step), part(waveform.at(step as f64 * TAU / STEPS as f64)))).collect()
    };
    let size = |points: &[(f64, f64)]| points.iter().map(|point| point.1.abs()).fold(0.0, f64::max);
    let largest = waveform.sample(&Circle::new(STEPS)).iter().map(|vector| vector.norm()).fold(0.0, f64::max);
    let sum = points(&waveform);
    let by_order = waveform.harmonics().iter().map(|harmonic| (harmonic.order, points(&Waveform::new([*harmonic]))));
    let mut left: Vec<Order> = by_order.filter(|(_, points)| size(points) > NOTHING * largest).collect();
    if left.is_empty() {
        return None;
    }
    left.sort_by(|a, b| size(&b.1).total_cmp(&size(&a.1)).then(a.0.cmp(&b.0)));
    let whole = format!("{title} {side}");
    let plot = |heading: String| {
        let angle = Axis::angle("Crank angle θ in °", 0.0, 360.0, 90);
        Plot::new(heading, angle, Axis::linear(format!("{title} in {}", unit.name)))
    };
    let mut first = plot(whole.clone());
    if left.len() > 1 {
        first.curves.push(Curve { width: 0.8, ..Curve::new(0, "sum", sum) });
    }
    let rest = left.split_off(left.len().min(MOST_CURVES - first.curves.len()));
    let mut caption = match first.curves.is_empty() {
        true => format!("{whole} against the crank angle: order {}, the only one that is not zero.", left[0].0),
        false => format!("{whole} against the crank angle: the sum (wide) and its {}.", numbered(&left, "largest ")),
    };
    add(&mut first, left);
    let mut plots = vec![first];
    if !rest.is_empty() {
        caption.push_str(&format!(" Below, to a larger scale, {}.", rest_words(&rest)));
        let mut second = plot("The smaller orders".to_owned());
        add(&mut second, with_others(rest));
        plots.push(second);
    }
    Some(Drawn { plots, caption })
}

/// The orders as curves that differ from those before them.
fn add(plot: &mut Plot, orders: Vec<Order>) {
    for (order, points) in orders {
        let name = if order == 0 { "others".to_owned() } else { format!("order {order}") };
        plot.curves.push(Curve::new(plot.curves.len(), name, points));
    }
}

/// As many orders as a plot can show, the others summed under the number 0.
fn with_others(mut orders: Vec<Order>) -> Vec<Order> {
    if orders.len() <= MOST_CURVES {
        return orders;
    }
    let others = orders.split_off(MOST_CURVES - 1);
    let sum = others
        .into_iter()
        .map(|(_, points)| points)
        .reduce(|a, b| a.iter().zip(&b).map(|(a, b)| (a.0, a.1 + b.1)).collect());
    orders.extend(sum.map(|sum| (0, sum)));
    orders
}

/// `order 6`, `orders 6, 8`, `orders 6, 8 and the sum of orders 10, 12`.
fn rest_words(orders: &[Order]) -> String {
    match orders.len() > MOST_CURVES {
        false => numbered(orders, ""),
        true => {
            let (shown, others) = orders.split_at(MOST_CURVES - 1);
            format!("{} and the sum of {}", numbered(shown, ""), numbered(others, "the others, "))
        }
    }
}

/// `order 2`, `largest orders 2, 4`.
fn numbered(orders: &[Order], which: &str) -> String {
    let numbers: Vec<String> = orders.iter().map(|(order, _)| order.to_string()).collect();
    format!("{which}order{} {}", if numbers.len() == 1 { "" } else { "s" }, numbers.join(", "))
}

/// The path of the tip of the vector, as seen from the free end.
fn path(name: &str, title: &str, waveform: &Waveform, unit: Unit) -> Picture {
    let waveform = waveform.scaled(unit.factor);
    let tip = |step: usize| {
        let vector = waveform.at(step as f64 * TAU / STEPS as f64);
        // Direction 0 points up, angles grow anticlockwise.
        (-vector.im, vector.re)
    };
    let tips: Vec<(f64, f64)> = (0..=STEPS).map(tip).collect();
    let curve = Curve::new(0, "", tips.clone());
    let what = if name == "force" { "the force" } else { "the moment, arm times force," };
    let mut polar =
        Polar::new(format!("Path of {what} in a revolution"), format!("{title} in {}", unit.name), vec![curve]);
    polar.mark_quarters(&tips, STEPS);
    Picture {
        name: format!("{name}-path"),
        caption: phrase!(
            "Path of the tip of {} in a revolution, seen from the free end, direction 0 upwards; rings mark crank angles.",
            what
        ),
        figure: polar.figure(),
    }
}
