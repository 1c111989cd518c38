//! Which plots show a sweep? Curves over one parameter with the exact zeros marked, or maps over two.

use super::super::figure::Figure;
use super::super::plot::{Axis, Curve, Map, Plot, PointMark};
use super::amounts::axis_unit;
use super::words::{axis, exact, float, quantity_name};
use crate::page::{Picture, Text, phrase};
use crate::proof::Quantity;
use crate::sweep::{Amplitudes, Sweep, SweptEngine, ZeroSet, Zeros};

/// One of the amplitudes of an order.
pub(super) type Amplitude = fn(&Amplitudes) -> f64;

/// More exact zeros than this are not marked one by one.
const MOST_MARKS: usize = 60;

/// One drawing for each order of force and moment that is not zero at every point.
pub(super) fn drawings(sweep: &Sweep) -> Vec<Picture> {
    let mut drawn = Vec::new();
    for quantity in [Quantity::Force, Quantity::Moment] {
        for (place, &order) in sweep.orders.iter().enumerate() {
            let gone = |point: &SweptEngine| amplitudes(point, place, quantity).is_none_or(|a| a.largest.vanishes);
            if sweep.points.iter().chain(&sweep.curve).all(gone) || sweep.points.len() < 2 {
                continue;
            }
            let name = format!("{}-{order}", quantity_name(quantity));
            let figure = match sweep.parameters.len() {
                1 => curves(sweep, quantity, order, place),
                _ => map(sweep, quantity, order, place),
            };
            drawn.push(Picture { name, caption: caption(sweep, quantity, order), figure });
        }
    }
    drawn
}

/// What a reader sees in a drawing.
fn caption(sweep: &Sweep, quantity: Quantity, order: u32) -> Text {
    match (sweep.parameters.len(), quantity == Quantity::Moment, sweep.zeros.is_some()) {
        (1, false, true) => phrase!(
            "Force of order {}. Rings mark the exact zeros of a part, dots where one of its two vectors is zero and the other draws a circle.",
            order
        ),
        (1, true, true) => phrase!(
            "Moment of order {}. Rings mark the exact zeros of a part, dots where one of its two vectors is zero and the other draws a circle.",
            order
        ),
        (1, false, false) => {
            phrase!("Force of order {}. Rings mark values at which a part is proved to be zero.", order)
        }
        (1, true, false) => {
            phrase!("Moment of order {}. Rings mark values at which a part is proved to be zero.", order)
        }
        (_, false, _) => phrase!(
            "Largest force of order {} over both values. Rings mark points at which it is proved to be zero.",
            order
        ),
        (_, true, _) => phrase!(
            "Largest moment of order {} over both values. Rings mark points at which it is proved to be zero.",
            order
        ),
    }
}

pub(super) fn amplitudes(point: &SweptEngine, place: usize, quantity: Quantity) -> Option<&Amplitudes> {
    let order = point.orders.get(place)?;
    Some(if quantity == Quantity::Moment { &order.moment } else { &order.force })
}

fn value_axis(sweep: &Sweep, quantity: Quantity) -> Axis {
    let name = if quantity == Quantity::Moment { "Moment" } else { "Force" };
    Axis::linear(format!("{name} in {}", axis_unit(sweep, quantity)))
}

fn curves(sweep: &Sweep, quantity: Quantity, order: u32, place: usize) -> Figure {
    let parameter = &sweep.parameters[0];
    let is_angle = sweep.zeros.is_some();
    let title = format!("Order {order} of the {}", quantity_name(quantity));
    let ends = (float(&parameter.range.value(0)), float(&parameter.range.last()));
    let label = axis(parameter, is_angle);
    let x = if is_angle { Axis::angle(label, ends.0.min(ends.1), ends.0.max(ends.1), 30) } else { Axis::linear(label) };
    let x = if is_angle && (ends.1 - ends.0).abs() < 60.0 { Axis { ticks: None, ..x } } else { x };
    let mut plot = Plot::new(title, x, value_axis(sweep, quantity));
    let parts: [(&str, Amplitude); 4] = [
        ("largest", |a| a.largest.value),
        ("smallest", |a| a.smallest.value),
        ("along", |a| a.along.value),
        ("across", |a| a.across.value),
    ];
    for (number, (name, part)) in parts.into_iter().enumerate() {
        let point =
            |point: &SweptEngine| Some((float(point.values.first()?), part(amplitudes(point, place, quantity)?)));
        plot.curves.push(Curve::new(number, name, sweep.curve.iter().filter_map(point).collect()));
    }
    plot.marks = marks(sweep, quantity, order, place);
    plot.figure()
}

/// Rings where a part vanishes, dots where one of the two vectors does and the other one draws a circle.
fn marks(sweep: &Sweep, quantity: Quantity, order: u32, place: usize) -> Vec<PointMark> {
    let Some(sets) = &sweep.zeros else { return grid_marks(sweep, quantity, place) };
    let of = |which: Zeros| sets.iter().find(|set| set.quantity == quantity && set.order == order && set.of == which);
    let at = |which: Zeros| of(which).map_or(&[][..], |set: &ZeroSet| &set.at);
    let all = at(Zeros::Largest);
    let mut marks = Vec::new();
    for (which, name) in [(Zeros::Largest, "all"), (Zeros::Along, "along"), (Zeros::Across, "across")] {
        let own = at(which).iter().filter(|value| which == Zeros::Largest || !all.contains(value));
        marks.extend(
            own.map(|value| PointMark::ring((float(value), 0.0), format!("{}° {name}", exact(value))).of("exact zero")),
        );
    }
    for which in [Zeros::Direct, Zeros::Reverse] {
        for value in at(which).iter().filter(|value| !all.contains(value)) {
            let point = sweep.curve.iter().find(|point| point.values.first() == Some(value));
            let height = point.and_then(|point| amplitudes(point, place, quantity)).map(|a| a.largest.value);
            marks.extend(height.map(|height| {
                PointMark::dot((float(value), height), format!("{}°", exact(value)))
                    .of("circle: exactly one vector is zero")
            }));
        }
    }
    marks.truncate(MOST_MARKS);
    marks
}

/// The points of the grid at which a part is proved to vanish.
fn grid_marks(sweep: &Sweep, quantity: Quantity, place: usize) -> Vec<PointMark> {
    let mark = |point: &SweptEngine| {
        let amplitudes = amplitudes(point, place, quantity)?;
        let name = match amplitudes {
            a if a.largest.vanishes => "all",
            a if a.along.vanishes => "along",
            a if a.across.vanishes => "across",
            _ => return None,
        };
        Some((name, float(point.values.first()?)))
    };
    let found: Vec<(&str, f64)> = sweep.points.iter().filter_map(mark).collect();
    // Where a part vanishes at every point there is nothing to mark.
    if found.len() == sweep.points.len() || found.len() > MOST_MARKS {
        return Vec::new();
    }
    found.into_iter().map(|(name, x)| PointMark::ring((x, 0.0), name).of("exact zero on the grid")).collect()
}

fn map(sweep: &Sweep, quantity: Quantity, order: u32, place: usize) -> Figure {
    let [slow, fast] = [&sweep.parameters[0], &sweep.parameters[1]];
    let is_angle = [0, 1].map(|index| sweep.angles.get(index).copied().unwrap_or(false));
    let columns = fast.range.count();
    let around = |parameter: &crate::sweep::Parameter, is_angle: bool| {
        // Cells reach half a step beyond the outer values.
        let (first, last) = (float(&parameter.range.value(0)), float(&parameter.range.last()));
        let half =
            if parameter.range.count() > 1 { (last - first) / (parameter.range.count() - 1) as f64 / 2.0 } else { 0.5 };
        Axis::linear(axis(parameter, is_angle)).within(first - half, last + half)
    };
    let largest = |point: &SweptEngine| amplitudes(point, place, quantity).map_or(f64::NAN, |a| a.largest.value);
    let mut rows: Vec<Vec<f64>> = sweep.points.chunks(columns).map(|row| row.iter().map(largest).collect()).collect();
    // The axes rise from the left and from below, whichever way the ranges run.
    if slow.range.value(0) > slow.range.last() {
        rows.reverse();
    }
    if fast.range.value(0) > fast.range.last() {
        rows.iter_mut().for_each(|row| row.reverse());
    }
    let gone =
        sweep.points.iter().filter(|point| amplitudes(point, place, quantity).is_some_and(|a| a.largest.vanishes));
    let mut marks: Vec<PointMark> = gone
        .filter_map(|point| Some(PointMark::ring((float(point.values.get(1)?), float(point.values.first()?)), "")))
        .map(|mark| mark.of("exact zero on the grid"))
        .collect();
    if marks.len() > MOST_MARKS {
        marks.clear();
    }
    let map = Map {
        title: format!("Order {order}: largest {}", quantity_name(quantity)),
        x: around(fast, is_angle[1]),
        y: around(slow, is_angle[0]),
        value: value_axis(sweep, quantity),
        rows,
        curves: Vec::new(),
        marks,
    };
    map.figure()
}
