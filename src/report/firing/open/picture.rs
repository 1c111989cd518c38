//! How long is the firing star of each order over the open angle, and where is it exactly zero?

use std::f64::consts::TAU;

use num_complex::Complex;
use num_rational::BigRational;

use super::super::super::family_page::{axis_name, only_open_angle, which_angle};
use super::super::super::typeset;
use super::{OpenFiringStudy, words};
use crate::engine::{FiringSpan, PHI};
use crate::family::{OpenStar, SpanStar};
use crate::numbers;
use crate::page::Picture;
use crate::page::figure::Figure;
use crate::page::plot::{Axis, Curve, Plot, stacked};
use crate::report::texts::open_firing as text;

/// Steps of a turn of the open angle.
const STEPS: i64 = 720;
/// More orders than this are not drawn; and more than this stand not in one plot.
const MOST_ORDERS: usize = 9;
const MOST_CURVES: usize = 3;

/// Curves of the orders that do not always vanish, in 0° to 360°; none where no angle or two are open.
pub(super) fn lengths(study: &OpenFiringStudy<'_>) -> Option<Picture> {
    let unknown = only_open_angle(study.family)?;
    let is_drawn = |star: &&OpenStar| !star.always() && star.spans.as_ref().is_ok_and(|spans| !spans.is_empty());
    let drawn: Vec<&OpenStar> = study.orders.iter().filter(is_drawn).take(MOST_ORDERS).collect();
    let plots: Vec<Figure> = drawn.chunks(MOST_CURVES).map(|chunk| plot(study, unknown, chunk)).collect();
    (!plots.is_empty())
        .then(|| Picture::new("firing-lengths", text::lengths(which_angle(study.family, unknown)), stacked(plots)))
}

fn plot(study: &OpenFiringStudy<'_>, unknown: &str, stars: &[&OpenStar]) -> Figure {
    let names: Vec<String> = stars.iter().map(|star| star.order.to_string()).collect();
    let mut plot = plot_of_stars(&names, Axis::angle(axis_name(study.family, unknown), 0.0, 360.0, 30));
    for (number, (star, name)) in stars.iter().zip(names).enumerate() {
        let zeros: Vec<BigRational> = words::values(study, star).into_iter().flatten().collect();
        let spans = star.spans.as_deref().unwrap_or_default();
        let curve = Curve::new(number, format!("order {name}"), points(unknown, spans, &zeros));
        for zero in &zeros {
            plot.ring_zero(degrees(zero), typeset::turns(zero), curve.ink, "exact zero");
        }
        plot.curves.push(curve);
    }
    plot.figure()
}

/// A plot for the lengths of the stars of these orders.
pub(in crate::report) fn plot_of_stars(orders: &[String], x: Axis) -> Plot {
    let title = match orders {
        [only] => format!("Firing star, order {only}"),
        several => format!("Firing stars, orders {}", several.join(", ")),
    };
    Plot::new(title, x, Axis::amplitude("Length in r"))
}

/// Points of a curve, those of its zeros among them; a point without a height parts two spans.
fn points(unknown: &str, spans: &[SpanStar], zeros: &[BigRational]) -> Vec<(f64, f64)> {
    let mut points = Vec::new();
    for star in spans {
        let at = |angle: f64| (angle, length(unknown, star, angle / 360.0));
        let [low, high] = ends(&star.span);
        let grid = (0..=STEPS).map(|step| step as f64 * 360.0 / STEPS as f64);
        let inside = grid.filter(|angle| (low..=high).contains(angle)).chain([low, high]).map(at);
        let own = zeros.iter().filter(|zero| star.span.holds(zero)).map(|zero| (degrees(zero), 0.0));
        let mut run: Vec<(f64, f64)> = inside.chain(own).collect();
        run.sort_by(|a, b| a.0.total_cmp(&b.0));
        points.extend(run);
        points.push((high, f64::NAN));
    }
    points
}

/// From where to where a span reaches, in degrees.
fn ends(span: &FiringSpan) -> [f64; 2] {
    span.within.as_ref().map_or([0.0, 360.0], |ends| ends.each_ref().map(|end| degrees(&end.at)))
}

fn degrees(turns: &BigRational) -> f64 {
    360.0 * numbers::float(turns)
}

/// The length of a star at an angle in turns.
fn length(unknown: &str, star: &SpanStar, angle: f64) -> f64 {
    let parts = star.sum.left().map(|part| {
        let times = if unknown == PHI { &part.phi } else { &part.delta };
        numbers::evaluate(&part.sum) * Complex::from_polar(1.0, TAU * numbers::float(times) * angle)
    });
    parts.sum::<Complex<f64>>().norm()
}
