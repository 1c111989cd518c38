//! How is the front drawn? Load over mass, with uniform balance factors beside it.

use super::super::plot::{Axis, Curve, Plot, PointMark};
use super::super::typeset;
use super::amounts::{Units, four};
use crate::engine::Engine;
use crate::numbers::float;
use crate::optimise::{Design, Front, Uniform};
use crate::page::{Picture, Unit};
use crate::report::texts::optimise as text;
use crate::text::Format;

/// The front.
pub(super) fn picture(layout: &Engine, front: &Front) -> Picture {
    let units = Units::of(layout, front);
    // Four digits, so that the drawing is the same wherever the figures are.
    let at = |design: &Design| (four(float(&design.mass)), four(design.peak() * units.newtons));
    let load = Axis::linear("Largest bearing load in {}").counted_in(units.force);
    let mass = Axis::linear("Crankshaft mass in {}").counted_in(Unit::KILOGRAM);
    let mut plot = Plot::new(layout.title().escaped(Format::Plain), mass, load);
    let best: Vec<(f64, f64)> = front.points.iter().map(|point| at(&point.design)).collect();
    plot.marks.extend(best.iter().map(|&at| PointMark::dot(at, "")));
    plot.curves.push(Curve::new(0, "the best counterweights", best));
    let uniform = |uniform: &Uniform| {
        let name = format!("balance factor {}", typeset::number(&uniform.factor));
        PointMark::ring(at(&uniform.design), name).of("one balance factor for all throws")
    };
    plot.marks.extend(front.uniform.iter().map(uniform));
    Picture::new("front", text::front(), plot.figure())
}
