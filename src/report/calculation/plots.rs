//! How do forces, moments and torque run through a revolution? Curves of each order and of their sum, and the path of the vector.

use std::f64::consts::TAU;

use num_complex::Complex;

use super::amounts::Unit;
use crate::engine::Engine;
use crate::loads::{Circle, Loads, Waveform};
use crate::page::plot::{Axis, Curve, Plot, Polar};
use crate::page::{Picture, phrase};
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
    for (name, title, waveform, unit) in [forces, moments] {
        let sides = match name {
            "force" => ["along the reference direction", "across it, in the plane of the cylinders"],
            _ => ["of the forces along the reference direction (pitching)", "of the forces across it (yawing)"],
        };
        let parts: [fn(Complex<f64>) -> f64; 2] = [|vector| vector.re, |vector| vector.im];
        let drawn = [0, 1].map(|side| curves(waveform, unit, title, sides[side], parts[side]));
        let both = drawn.iter().all(Option::is_some);
        for (mark, plot) in ["along", "across"].into_iter().zip(drawn) {
            figures.extend(plot.map(|plot| Picture {
                name: format!("{name}-{mark}"),
                caption: phrase!("{} against the crank angle, by order and summed, zero to peak.", plot.title.clone()),
                figure: plot.figure(),
            }));
        }
        figures.extend(both.then(|| path(name, title, waveform, unit)));
    }
    if let Some(torque) = &loads.torque {
        let unit = Unit::of(engine, loads, Quantity::Torque);
        let plot = curves(&torque.waveform, unit, "Inertia torque", "on the crankshaft", |vector| vector.re);
        figures.extend(plot.map(|plot| Picture {
            name: "torque".into(),
            caption:
                "Inertia torque on the crankshaft against the crank angle, by order and summed, zero to peak.".into(),
            figure: plot.figure(),
        }));
    }
    figures
}

/// A plot of one component; none where it is zero.
fn curves(waveform: &Waveform, unit: Unit, title: &str, side: &str, part: fn(Complex<f64>) -> f64) -> Option<Plot> {
    let waveform = waveform.scaled(unit.factor);
    let points = |waveform: &Waveform| -> Vec<(f64, f64)> {
        let degrees = |step: usize| step as f64 * 360.0 / STEPS as f64;
        (0..=STEPS).map(|step| (degrees(step), part(waveform.at(step as f64 * TAU / STEPS as f64)))).collect()
    };
    let size = |points: &[(f64, f64)]| points.iter().map(|point| point.1.abs()).fold(0.0, f64::max);
    let largest = waveform.sample(&Circle::new(STEPS)).iter().map(|vector| vector.norm()).fold(0.0, f64::max);
    let sum = points(&waveform);
    let by_order = waveform.harmonics().iter().map(|harmonic| (harmonic.order, points(&Waveform::new([*harmonic]))));
    let left: Vec<_> = by_order.filter(|(_, points)| size(points) > NOTHING * largest).collect();
    if left.is_empty() {
        return None;
    }
    let angle = Axis::angle("Crank angle θ in °", 0.0, 360.0, 90);
    let mut plot = Plot::new(format!("{title} {side}"), angle, Axis::linear(format!("{title} in {}", unit.name)));
    let several = left.len() > 1;
    for (number, (order, points)) in left.into_iter().enumerate() {
        plot.curves.push(Curve::new(number + usize::from(several), format!("order {order}"), points));
    }
    if several {
        plot.curves.insert(0, Curve { width: 0.7, ..Curve::new(0, "sum", sum) });
    }
    Some(plot)
}

/// The path of the tip of the vector, as seen from the free end.
fn path(name: &str, title: &str, waveform: &Waveform, unit: Unit) -> Picture {
    let waveform = waveform.scaled(unit.factor);
    let tip = |step: usize| {
        let vector = waveform.at(step as f64 * TAU / STEPS as f64);
        // Direction 0 points up, angles grow anticlockwise.
        (-vector.im, vector.re)
    };
    let curve = Curve::new(0, "", (0..=STEPS).map(tip).collect());
    let what = if name == "force" { "the force" } else { "the moment, arm times force," };
    let polar = Polar::new(format!("Path of {what} in a revolution"), format!("{title} in {}", unit.name), vec![curve]);
    Picture {
        name: format!("{name}-path"),
        caption: phrase!("Path of the tip of {} in a revolution, seen from the free end, direction 0 upwards.", what),
        figure: polar.figure(),
    }
}
