//! How is the response of an engine on its mounts drawn? Over speed and order, in the manner of Campbell's diagram.

use super::super::figure::Ink;
use super::super::plot::{Axis, Curve, Plot, PointMark};
use super::{AtSpeed, MountsStudy, Place};
use crate::page::{Picture, Unit};
use crate::report::texts::mounts as text;

/// So many orders have curves of their own.
const MOST_CURVES: usize = 5;
/// Responses down to this part of the largest are drawn: three decades.
const DECADES: f64 = 3.0;
/// A response of the largest size rises so far towards the next order, in their steps.
const RISE: f64 = 0.85;

pub(super) fn pictures(study: &MountsStudy) -> Vec<Picture> {
    [map(study), speeds(study)].into_iter().flatten().collect()
}

fn of_order(study: &MountsStudy, order: usize) -> impl Iterator<Item = &AtSpeed> {
    study.range().iter().filter(move |at| at.order == order)
}

fn greatest(study: &MountsStudy, order: usize) -> f64 {
    of_order(study, order).filter_map(|at| at.velocity).fold(0.0, f64::max)
}

/// The response above the line of each order, over the speed, with a dot where the order meets a mode.
fn map(study: &MountsStudy) -> Option<Picture> {
    let [from, to] = study.ends;
    let kappa = |order: usize| study.orders[order].excitation.order.value();
    let count = study.orders.len();
    let steps = (1..count).map(|order| kappa(order) - kappa(order - 1));
    let step = steps.fold(f64::INFINITY, f64::min).min(1.0);
    let most = (0..count).map(|order| greatest(study, order)).fold(0.0, f64::max);
    if most <= 0.0 {
        return None;
    }
    let x = Axis { range: Some((from, to)), ..Axis::linear("Speed in rpm") };
    let ticks: Vec<f64> = (0..count).map(kappa).collect();
    let y = Axis {
        range: Some((ticks.first()? - 0.3 * step, ticks.last()? + step)),
        ticks: Some(ticks),
        ..Axis::linear("Order κ")
    };
    let mut plot = Plot::new("Response over speed and order", x, y);
    for order in 0..count {
        let base = kappa(order);
        let line = Curve::new(0, "", vec![(from, base), (to, base)]);
        plot.curves.push(Curve { ink: Ink::Grey, width: 0.2, ..line });
        let height = |velocity: f64| ((velocity / most).log10() / DECADES + 1.0).max(0.0) * RISE * step;
        let points = of_order(study, order).map(|at| (at.rpm, base + height(at.velocity.unwrap_or(most))));
        if !study.orders[order].excitation.still.is_whole() {
            let curve = Curve::new(0, "", points.collect());
            plot.curves.push(Curve { ink: Ink::Blue, width: 0.35, ..curve });
            for mode in &study.modes {
                let at = study.orders[order].excitation.order.rpm(mode.hertz());
                if (from..=to).contains(&at) {
                    plot.marks.push(PointMark::dot((at, base), ""));
                }
            }
        }
    }
    Some(Picture::new("map", text::map(), plot.figure()))
}

/// The velocity of the watched place in the strongest orders.
fn speeds(study: &MountsStudy) -> Option<Picture> {
    let [from, to] = study.ends;
    let mut strongest: Vec<usize> = (0..study.orders.len()).filter(|order| greatest(study, *order) > 0.0).collect();
    strongest.sort_by(|one, other| greatest(study, *other).total_cmp(&greatest(study, *one)));
    strongest.truncate(MOST_CURVES);
    if strongest.is_empty() {
        return None;
    }
    strongest.sort_unstable();
    let x = Axis { range: Some((from, to)), ..Axis::linear("Speed in rpm") };
    let y = Axis::amplitude("Velocity in {}").counted_in(Unit::MILLIMETRE_PER_SECOND);
    let mut plot = Plot::new("Velocity over the speed", x, y);
    for (number, &order) in strongest.iter().enumerate() {
        let points = of_order(study, order).map(|at| (at.rpm, at.velocity.map_or(f64::NAN, |velocity| velocity * 1e3)));
        plot.curves.push(Curve::new(
            number,
            format!("order {}", study.orders[order].excitation.order),
            points.collect(),
        ));
    }
    let caption = text::velocity_curves(study.watched() == Place::Point);
    Some(Picture::new("velocity", caption, plot.figure()))
}
