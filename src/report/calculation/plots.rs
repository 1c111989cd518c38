//! How do forces, moments and torque run through a revolution? Curves of each order and of their sum, and the path of the vector.

use std::f64::consts::TAU;

use num_complex::Complex;

use super::super::typeset;
use super::amounts::{Unit, is_left, waveform};
use crate::engine::Engine;
use crate::loads::{Circle, Loads, Outcome, Torque, Waveform};
use crate::page::plot::{Axis, Curve, Plot, Polar, stacked};
use crate::page::{Choice, Picture, Text};
use crate::proof::{Planar, Quantity};
use crate::report::texts::loads as text;

/// Steps of a revolution in a plot.
const STEPS: usize = 360;
/// A component below this part of the largest is the rounding of one that is zero.
const NOTHING: f64 = 1e-12;

/// What is drawn of the force, the moment or the torque.
struct Drawing<'a> {
    /// What the names of its files begin with.
    name: &'static str,
    /// The waveform, and what it is counted in.
    waveform: &'a Waveform,
    unit: Unit,
    /// The label of its axis, with a place for the unit.
    axis: &'static str,
}

/// What is above a plot, and what its caption begins with.
type Heading = (&'static str, Text);

/// All plots of the numbers of an engine; none of what is zero.
pub(in crate::report) fn figures(engine: &Engine, loads: &Loads) -> Vec<Picture> {
    let mut figures = Vec::new();
    let drawing = |name, waveform, axis, quantity| {
        let unit = Unit::as_read(engine, loads, quantity);
        Drawing { name, waveform, unit, axis }
    };
    let end = engine.convention().turns_anticlockwise_from();
    let same = |heading: &'static str| (heading, Text::from(heading));
    let force = [same("Force along the reference direction"), same("Force across the reference direction")];
    let moment = [("Pitching moment", text::pitching()), ("Yawing moment", text::yawing())];
    let both = [
        (Planar::Force, "Force in {}", force, "Path of the force in a revolution"),
        (Planar::Moment, "Moment in {}", moment, "Path of the moment in a revolution"),
    ];
    for (of, axis, headings, path) in both {
        if loads.orders.iter().any(|order| is_left(order.swing(of))) {
            let drawing = drawing(of.name(), waveform(loads, of), axis, of.into());
            figures.extend(vectors(&drawing, headings, (path, text::path(of, end))));
        }
    }
    let is_left = |torque: &&Torque| torque.orders.iter().any(|order| order.vector.outcome == Outcome::NotZero);
    if let Some(torque) = loads.torque.as_ref().filter(is_left) {
        let drawing = drawing("torque", &torque.waveform, "Inertia torque in {}", Quantity::TORQUE);
        figures.extend(curves(&drawing, same("Inertia torque on the crankshaft"), "", |vector| vector.re));
    }
    figures
}

/// Both components of a vector, and its path where it has both.
fn vectors(drawing: &Drawing, [first, second]: [Heading; 2], path_words: (&'static str, Text)) -> Vec<Picture> {
    let along = curves(drawing, first, "-along", |vector| vector.re);
    let across = curves(drawing, second, "-across", |vector| vector.im);
    let path = (along.is_some() && across.is_some()).then(|| path(drawing, path_words));
    [along, across, path].into_iter().flatten().collect()
}

/// More curves than this are not drawn in one plot.
const MOST_CURVES: usize = 3;

/// One order of a component: its number, and its points.
type Order = (u32, Vec<(f64, f64)>);

/// One component over the crank angle; none where it is zero. The sum and the two largest orders come first, the rest below.
fn curves(
    drawing: &Drawing,
    (heading, subject): Heading,
    mark: &str,
    part: fn(Complex<f64>) -> f64,
) -> Option<Picture> {
    let waveform = drawing.waveform.scaled(drawing.unit.factor);
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
    let plot = |heading: &str| {
        let angle = Axis::angle("Crank angle θ in °", 0.0, 360.0, 90);
        Plot::new(heading, angle, Axis::linear(drawing.axis).counted_in(drawing.unit.unit))
    };
    let mut first = plot(heading);
    if left.len() > 1 {
        first.curves.push(Curve { width: 0.8, ..Curve::new(0, "sum", sum) });
    }
    let rest = left.split_off(left.len().min(MOST_CURVES - first.curves.len()));
    let caption = caption(subject, &left, &rest);
    add(&mut first, left);
    let mut plots = vec![first];
    if !rest.is_empty() {
        let mut second = plot("The smaller orders");
        add(&mut second, with_others(rest));
        plots.push(second);
    }
    let figure = stacked(plots.iter().map(Plot::figure).collect());
    Some(Picture::new(format!("{}{mark}", drawing.name), caption, figure))
}

/// What the plots of a component show: the orders in the first, and those below.
fn caption(component: Text, first: &[Order], rest: &[Order]) -> Text {
    let words = match first {
        [(only, _)] => text::only_order(component, *only),
        several => text::sum_and_orders(component, numbers(several)),
    };
    let below = match rest {
        [] => return words,
        few if few.len() <= MOST_CURVES => text::smaller(Choice::one_or_more(few.len()), numbers(few)),
        many => {
            let (shown, others) = many.split_at(MOST_CURVES - 1);
            text::smaller_and_others(numbers(shown), numbers(others))
        }
    };
    words.and(" ").and(below)
}

fn numbers(orders: &[Order]) -> String {
    typeset::listed(orders.iter().map(|(order, _)| order))
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

/// The path of the tip of the vector, as seen from the free end.
fn path(drawing: &Drawing, (heading, caption): (&'static str, Text)) -> Picture {
    let waveform = drawing.waveform.scaled(drawing.unit.factor);
    let tip = |step: usize| {
        let vector = waveform.at(step as f64 * TAU / STEPS as f64);
        // Direction 0 points up, angles grow anticlockwise.
        (-vector.im, vector.re)
    };
    let tips: Vec<(f64, f64)> = (0..=STEPS).map(tip).collect();
    let curve = Curve::new(0, "", tips.clone());
    let mut polar = Polar::new(heading, drawing.axis, vec![curve]).counted_in(drawing.unit.unit);
    polar.mark_quarters(&tips, STEPS);
    Picture::new(format!("{}-path", drawing.name), caption, polar.figure())
}
