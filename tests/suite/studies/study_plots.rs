//! Which plots show a family of a study? What is unbalanced, how large it is, and what its mass follows.

use std::collections::BTreeSet;

use crankstar::loads::Arm;
use crankstar::numbers::float;
use crankstar::page::plot::{Axis, Curve, Plot, PointMark};
use crankstar::page::{Picture, Text, number};
use crankstar::proof::Planar;
use crankstar::sweep::{Amplitudes, Envelope, Parameter, Sweep, SweptEngine, ZeroSet, Zeros};
use crankstar::text::Format;
use num_rational::BigRational;

use super::study::Studied;
use super::study_flywheels as flywheel;

const FORCES: &str = "Vertical and horizontal amplitudes of the forces of orders 1 and 2; what is 0 everywhere is omitted. Rings mark the exact zeros of a part.";
const MOMENTS: &str = "Vertical and horizontal amplitudes of the moments of orders 1 and 2; what is 0 everywhere is omitted. Rings mark the exact zeros of a part.";
const SIZE: &str =
    "Length, breadth and height as parts of the length of the engine in line; dots are the engine in line itself.";
const MASS: &str = "The volume as a part of that of the engine in line, the counterweight as its mass-radius in multiples of $m r$, and the difference of the longest and \
    the shortest firing interval in turns of the crank; dots are the engine in line itself.";

/// The drawings of a family; `whole` has the engine in line for its first point.
pub(super) fn pictures(family: &Studied, whole: &Sweep) -> Vec<Picture> {
    let picture = |kind: &str, plot: Plot, caption: &'static str| Picture {
        name: format!("{}-{kind}", family.name),
        caption: Text::from(caption),
        figure: plot.figure(),
    };
    let kinds = [("forces", Planar::Force, FORCES), ("moments", Planar::Moment, MOMENTS)];
    let unbalanced = kinds.map(|(name, quantity, caption)| (name, unbalanced(family, quantity), caption));
    let unbalanced = unbalanced.into_iter().filter(|(_, plot, _)| !plot.curves.is_empty());
    let mut drawn: Vec<Picture> = unbalanced.map(|(name, plot, caption)| picture(name, plot, caption)).collect();
    if family.in_line.is_some() {
        drawn.push(picture("size", size(family, whole), SIZE));
        drawn.push(picture("mass", mass(family, whole), MASS));
    }
    drawn.extend(flywheel::picture(family));
    drawn
}

/// `bank angle in °`.
pub(super) fn axis(parameter: &Parameter) -> String {
    format!("{} in °", parameter.label)
}

/// The amplitudes of an order at a point.
fn amplitudes(point: &SweptEngine, place: usize, quantity: Planar) -> Option<&Amplitudes> {
    let order = point.orders.get(place)?;
    Some(if quantity == Planar::Force { &order.force } else { &order.moment })
}

/// Vertical and horizontal amplitudes of orders 1 and 2, and that of the rotating masses; what is zero is left out.
fn unbalanced(family: &Studied, quantity: Planar) -> Plot {
    let sweep = &family.sweep;
    let mut plot = plot(sweep, if quantity == Planar::Force { "unbalanced forces" } else { "unbalanced moments" });
    let arm = match (quantity, sweep.arm) {
        (Planar::Moment, Arm::Spacing) => " a",
        (Planar::Moment, Arm::Metre) => " · m",
        _ => "",
    };
    plot.y = Axis::linear(format!("Amplitude in m r ω²{arm}, of order 2 times c₂"));
    let mut add = |name: String, of: &Sweep, place: usize, part: fn(&Amplitudes) -> f64| {
        let point =
            |point: &SweptEngine| Some((float(point.values.first()?), part(amplitudes(point, place, quantity)?)));
        let points: Vec<(f64, f64)> = of.curve.iter().filter_map(point).collect();
        if points.iter().any(|(_, value)| *value != 0.0) {
            plot.curves.push(Curve::new(plot.curves.len(), name, points));
        }
    };
    let turning = family.rotating.as_ref();
    if let Some((rotating, place)) = turning.and_then(|of| Some((of, of.orders.iter().position(|&order| order == 1)?)))
    {
        add("rotating masses".into(), rotating, place, |a| a.largest.value);
    }
    for (place, &order) in sweep.orders.iter().enumerate().filter(|(_, order)| **order < 3) {
        add(format!("order {order} vertical"), sweep, place, |a| a.along.value);
        add(format!("order {order} horizontal"), sweep, place, |a| a.across.value);
    }
    let shown =
        |set: &&ZeroSet| set.quantity == quantity && set.order < 3 && matches!(set.of, Zeros::Along | Zeros::Across);
    let at: BTreeSet<&BigRational> = sweep.zeros.iter().flatten().filter(shown).flat_map(|set| &set.at).collect();
    plot.marks = at
        .into_iter()
        .map(|at| PointMark::ring((float(at), 0.0), number::degrees(at)).of("exact zero of a part"))
        .collect();
    plot
}

fn plot(sweep: &Sweep, what: &str) -> Plot {
    let parameter = &sweep.parameters[0];
    let last = float(&parameter.range.last());
    let x = Axis::angle(axis(parameter), 0.0, last, 30);
    Plot::new(format!("{}: {what}", sweep.title.escaped(Format::Plain)), x, Axis::linear(""))
}

/// Values over the grid: those of the family as a curve, that of the engine in line as a dot.
fn add(plot: &mut Plot, name: &str, dot: &str, values: impl Iterator<Item = Option<(f64, f64)>>) {
    let mut points = values.flatten();
    let in_line = points.next();
    plot.curves.push(Curve::new(plot.curves.len(), name, points.collect()));
    plot.marks.extend(in_line.map(|at| PointMark::dot(at, dot).of("in line")));
}

/// One side of an envelope.
type Side = fn(&Envelope) -> Option<f64>;

/// Length, breadth and height against the length of the engine in line.
fn size(family: &Studied, whole: &Sweep) -> Plot {
    let mut plot = plot(&family.sweep, "size of the envelope");
    plot.y = Axis::linear("against the length of the engine in line");
    let Some(unit) = family.in_line.as_ref().and_then(|(_, point)| point.envelope?.length) else { return plot };
    let sides: [(&str, Side); 3] =
        [("length", |e| e.length), ("breadth", |e| Some(e.breadth)), ("height", |e| Some(e.height))];
    for (name, side) in sides {
        let value = |point: &SweptEngine| Some((float(point.values.first()?), side(point.envelope.as_ref()?)? / unit));
        add(&mut plot, name, name, whole.points.iter().map(value));
    }
    plot
}

/// What the paper's mass rests on: the volume, the counterweights, the firing.
fn mass(family: &Studied, whole: &Sweep) -> Plot {
    let mut plot = plot(&family.sweep, "what the mass follows");
    plot.y = Axis::linear("see the legend");
    let Some(unit) = family.volumes.first().copied().flatten() else { return plot };
    let at = |point: &SweptEngine| point.values.first().map(float);
    let volumes = whole.points.iter().zip(&family.volumes);
    add(&mut plot, "volume, in line 1", "volume", volumes.map(|(point, volume)| Some((at(point)?, (*volume)? / unit))));
    let weights = whole.points.iter().map(|point| Some((at(point)?, point.counterweight?.value)));
    add(&mut plot, "counterweight in m r", "", weights);
    let firing = whole.points.iter().map(|point| Some((at(point)?, float(&point.evenness.as_ref()?.unevenness()))));
    add(&mut plot, "longest less shortest firing interval, in turns", "", firing);
    plot
}
