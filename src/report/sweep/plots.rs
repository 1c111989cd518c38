//! Which plots show a sweep? Curves over one parameter with the exact zeros marked, or maps over two.

use num_rational::BigRational;

use super::super::data::exact_number as exact;
use super::super::figure::{Figure, Ink};
use super::super::plot::stack::stacked;
use super::super::plot::{Axis, Curve, Map, Plot, PointMark};
use super::super::typeset;
use super::amounts::{self, ALIKE, axis_name};
use crate::numbers::float;
use crate::page::{Picture, Text};
use crate::proof::Planar;
use crate::report::texts::sweep as text;
use crate::sweep::{Amplitudes, Parameter, Sweep, SweptEngine, ZeroSet, Zeros};

/// One of the amplitudes of an order.
pub(super) type Amplitude = fn(&Amplitudes) -> f64;

/// More exact zeros than this are not marked one by one.
const MOST_MARKS: usize = 60;

/// One drawing for each order of force and moment that is not zero at every point.
pub(super) fn drawings(sweep: &Sweep) -> Vec<Picture> {
    let mut drawn = Vec::new();
    for quantity in Planar::BOTH {
        for (place, &order) in sweep.orders.iter().enumerate() {
            let gone = |point: &SweptEngine| amplitudes(point, place, quantity).is_none_or(|a| a.largest.vanishes);
            if sweep.points.iter().chain(&sweep.curve).all(gone) || sweep.points.len() < 2 {
                continue;
            }
            let name = format!("{}-{order}", quantity.name());
            let figure = match sweep.parameters.len() {
                1 => curves(sweep, quantity, order, place),
                _ => map(sweep, quantity, order, place),
            };
            drawn.push(Picture::new(name, caption(sweep, quantity, order), figure));
        }
    }
    drawn
}

/// What a reader sees in a drawing.
fn caption(sweep: &Sweep, quantity: Planar, order: u32) -> Text {
    let shown = if sweep.parameters.len() == 1 { text::curves() } else { text::map() };
    text::drawing(quantity, order, shown)
}

pub(super) fn amplitudes(point: &SweptEngine, place: usize, quantity: Planar) -> Option<&Amplitudes> {
    Some(point.orders.get(place)?.amplitudes(quantity))
}

/// The semi-axes of the ellipse above, its parts along and across the reference direction below.
fn curves(sweep: &Sweep, quantity: Planar, order: u32, place: usize) -> Figure {
    let x = over(sweep, &sweep.parameters[0]);
    let title = format!("Order {order} of the {}", quantity.name());
    let marks = marks(sweep, quantity, order, place);
    let panel = |title: String, parts: [(&str, Amplitude); 2], shown: &[Zeros]| {
        let mut plot = Plot::new(title, x.clone(), amounts::axis(sweep, quantity));
        for (number, (name, part)) in parts.into_iter().enumerate() {
            let point =
                |point: &SweptEngine| Some((float(point.values.first()?), part(amplitudes(point, place, quantity)?)));
            let curve = Curve::new(number, name, sweep.curve.iter().filter_map(point).collect());
            plot.curves.push(Curve { width: if number == 0 { 0.7 } else { 0.45 }, ..curve });
        }
        plot.marks = marks.iter().filter(|(of, _)| shown.contains(of)).map(|(_, mark)| mark.clone()).collect();
        plot.figure()
    };
    let axes: [(&str, Amplitude); 2] = [("largest", |a| a.largest.value), ("smallest", |a| a.smallest.value)];
    let parts: [(&str, Amplitude); 2] = [("along", |a| a.along.value), ("across", |a| a.across.value)];
    stacked(vec![
        panel(format!("{title}: largest and smallest"), axes, &[Zeros::Largest, Zeros::Direct, Zeros::Reverse]),
        panel(format!("{title}: along and across"), parts, &[Zeros::Largest, Zeros::Along, Zeros::Across]),
    ])
}

/// The axis of a parameter; over all its range where it is an angle.
pub(super) fn over(sweep: &Sweep, parameter: &Parameter) -> Axis {
    let is_angle = is_angle(sweep, parameter);
    let label = axis_name(sweep, parameter, is_angle);
    let [from, to] = [parameter.range.value(0), parameter.range.last()].map(|end| float(&end));
    if is_angle { Axis::degrees(label, from, to) } else { Axis::linear(label) }
}

/// Whether the parameter is an angle in degrees.
fn is_angle(sweep: &Sweep, parameter: &Parameter) -> bool {
    let known = sweep.axes().any(|(own, is_angle)| own == parameter && is_angle);
    known && ["", "°", "deg"].contains(&parameter.range.unit())
}

/// A mark with what vanishes at it.
type ZeroMark = (Zeros, PointMark);

/// Rings where a part vanishes, in the colour of its curve; dots where one of the two vectors does and the other one draws a
/// circle.
fn marks(sweep: &Sweep, quantity: Planar, order: u32, place: usize) -> Vec<ZeroMark> {
    let Some(sets) = &sweep.zeros else { return grid_marks(sweep, quantity, place) };
    let of = |which: Zeros| sets.iter().find(|set| set.quantity == quantity && set.order == order && set.of == which);
    let at = |which: Zeros| of(which).map_or(&[][..], |set: &ZeroSet| &set.at);
    let all = at(Zeros::Largest);
    // Irrational ones lie between the points of the curve.
    let both = of(Zeros::Largest).map_or(&[][..], |set| &set.irrational);
    let irrational = |which: Zeros| -> Vec<f64> {
        let own = of(which).map_or(&[][..], |set| &set.irrational).iter();
        let is_both = |ends: &[BigRational; 2]| both.iter().any(|other| other[0] <= ends[1] && ends[0] <= other[1]);
        let own = own.filter(|ends| which == Zeros::Largest || !is_both(ends));
        own.map(|[low, high]| (float(low) + float(high)) / 2.0).collect()
    };
    let rounded = |at: f64| format!("≈ {}°", typeset::decimal(at));
    let mut marks = Vec::new();
    for which in [Zeros::Largest, Zeros::Along, Zeros::Across] {
        let own = at(which).iter().filter(|value| which == Zeros::Largest || !all.contains(value));
        marks.extend(own.map(|value| (which, ring(which, float(value), typeset::degrees(value)).of("exact zero"))));
        let own = irrational(which).into_iter();
        marks.extend(own.map(|at| (which, ring(which, at, rounded(at)).of("zero, irrational"))));
    }
    let height = |point: &SweptEngine| amplitudes(point, place, quantity).map(|a| a.largest.value);
    for which in [Zeros::Direct, Zeros::Reverse] {
        for value in at(which).iter().filter(|value| !all.contains(value)) {
            let point = sweep.curve.iter().find(|point| point.values.first() == Some(value));
            marks.extend(point.and_then(height).map(|height| {
                let dot = PointMark::dot((float(value), height), typeset::degrees(value));
                (which, dot.of("circle: exactly one vector is zero"))
            }));
        }
        for at in irrational(which) {
            let points: Vec<(f64, f64)> =
                sweep.curve.iter().filter_map(|point| Some((float(point.values.first()?), height(point)?))).collect();
            marks
                .extend(between(&points, at).map(|height| {
                    (which, PointMark::dot((at, height), rounded(at)).of("one vector zero, irrational"))
                }));
        }
    }
    marks.truncate(MOST_MARKS);
    marks
}

/// The height at a place of the line through these points.
fn between(points: &[(f64, f64)], at: f64) -> Option<f64> {
    points.windows(2).find_map(|pair| {
        let [(from, low), (to, high)] = [pair[0], pair[1]];
        let part = (at - from) / (to - from);
        (0.0..=1.0).contains(&part).then_some(low + (high - low) * part)
    })
}

fn ring(which: Zeros, at: f64, label: String) -> PointMark {
    let ink = match which {
        Zeros::Along => Curve::new(0, "", Vec::new()).ink,
        Zeros::Across => Curve::new(1, "", Vec::new()).ink,
        Zeros::Largest | Zeros::Direct | Zeros::Reverse => Ink::Black,
    };
    PointMark { ink, ..PointMark::ring((at, 0.0), label) }
}

/// The points of the grid at which a part is proved to vanish.
fn grid_marks(sweep: &Sweep, quantity: Planar, place: usize) -> Vec<ZeroMark> {
    let mark = |point: &SweptEngine| {
        let amplitudes = amplitudes(point, place, quantity)?;
        let which = match amplitudes {
            a if a.largest.vanishes => Zeros::Largest,
            a if a.along.vanishes => Zeros::Along,
            a if a.across.vanishes => Zeros::Across,
            _ => return None,
        };
        let value = point.values.first()?;
        Some((which, ring(which, float(value), exact(value)).of("exact zero on the grid")))
    };
    let found: Vec<ZeroMark> = sweep.points.iter().filter_map(mark).collect();
    // Where a part vanishes at every point there is nothing to mark.
    if found.len() == sweep.points.len() || found.len() > MOST_MARKS {
        return Vec::new();
    }
    found
}

fn map(sweep: &Sweep, quantity: Planar, order: u32, place: usize) -> Figure {
    let [slow, fast] = [&sweep.parameters[0], &sweep.parameters[1]];
    let columns = fast.range.count();
    let around = |parameter: &Parameter| {
        // Cells reach half a step beyond the outer values.
        let (first, last) = (float(&parameter.range.value(0)), float(&parameter.range.last()));
        let half =
            if parameter.range.count() > 1 { (last - first) / (parameter.range.count() - 1) as f64 / 2.0 } else { 0.5 };
        let is_angle = is_angle(sweep, parameter);
        let label = axis_name(sweep, parameter, is_angle);
        let (low, high) = (first - half, last + half);
        if is_angle { Axis::degrees(label, low, high) } else { Axis::linear(label).within(low, high) }
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
    match marks.len() {
        0 => marks.extend(least(sweep, &largest)),
        count if count > MOST_MARKS => marks.clear(),
        _ => {}
    }
    let map = Map {
        title: format!("Order {order}: largest {}", quantity.name()),
        x: around(fast),
        y: around(slow),
        value: amounts::axis(sweep, quantity),
        rows,
        curves: Vec::new(),
        marks,
    };
    map.figure()
}

/// The points of the grid with the least amplitude, the first named by its value.
fn least(sweep: &Sweep, largest: &dyn Fn(&SweptEngine) -> f64) -> Vec<PointMark> {
    let points = || sweep.points.iter().filter(|point| largest(point).is_finite());
    let lowest = points().map(largest).fold(f64::INFINITY, f64::min);
    let most = points().map(largest).fold(0.0, f64::max);
    let alike = points().filter(|point| largest(point) - lowest <= ALIKE * most);
    let places = alike.filter_map(|point| Some((float(point.values.get(1)?), float(point.values.first()?))));
    let mut dots: Vec<PointMark> = places.map(|at| PointMark::dot(at, "").of("least on the grid")).collect();
    // A value that is the least everywhere, or nearly, has no place.
    if dots.len() > MOST_MARKS {
        dots.clear();
    }
    if let Some(first) = dots.first_mut() {
        *first = first.clone().valued(lowest);
    }
    dots
}
