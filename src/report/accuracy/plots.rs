//! How are the methods drawn? Error against time, and what is left of the peak over the highest order kept.

use std::time::Duration;

use super::super::figure::Ink;
use super::super::plot::{Axis, Curve, Plot, PointMark};
use super::{AccuracyCase, methods, words};
use crate::accuracy::{Method, Row, Study};
use crate::page::Picture;
use crate::report::texts::accuracy as text;

/// Errors smaller than this are drawn as this.
const LEAST: f64 = 1e-18;

/// Digits against time, the Pareto front as stairs, the program's own choice marked.
pub(super) fn cost(number: usize, case: &AccuracyCase, study: &Study) -> Picture {
    let title = words::heading(case, study);
    let x = Axis::log("Time of one evaluation in µs");
    let mut plot = Plot::new(title.plain(), x, Axis::linear("Digits of the peak"));
    let at = |row: &Row| {
        let time = row.time.map_or(f64::NAN, microseconds);
        (time, digits(methods::shown_error(study, row)))
    };
    let front: Vec<(f64, f64)> = methods::front(study).into_iter().map(|place| at(&study.rows[place])).collect();
    plot.curves
        .push(Curve { ink: Ink::Grey, ..Curve::new(0, "no other is both faster and more accurate", front).stepped() });
    for row in &study.rows {
        let (label, series, ink) = match row.method {
            Method::Orders(order) => (order.to_string(), "orders up to", Ink::Blue),
            Method::Doubles(steps) => (steps.to_string(), "angles, 64 bits", Ink::Orange),
            Method::Intervals(digits) => (methods::power_of_ten(-i64::from(digits)), "intervals to", Ink::Green),
            Method::Fractions => (methods::guaranteed(row).plain(), "fractions", Ink::Red),
        };
        plot.marks.push(PointMark { ink, ..PointMark::dot(at(row), label).of(series) });
    }
    if let Some(own) = study.own {
        let at = (microseconds(own.time), digits(own.bound));
        plot.marks.push(PointMark::ring(at, "").of("the program's own choice, from the engine itself"));
    }
    let caption = text::marks(title);
    let name = format!("{}-{number}", words::name(study.quantity).replace('_', "-"));
    Picture::new(name, caption, plot.figure())
}

/// Decimal digits that an error, a part of the peak, leaves.
fn digits(error: f64) -> f64 {
    -error.max(LEAST).log10()
}

fn microseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e6
}
