//! What do the first stars look like? Each from the free end, with the vectors of an order that it leaves.

use super::super::star::{star_figure, star_legend};
use super::super::views::{end_view, end_view_caption};
use crate::order::Masses;
use crate::page::Picture;
use crate::proof::Quantity;
use crate::report::texts::search as text;
use crate::search::{FoundStar, Problem};
use crate::verdict::classify;

/// The crankshaft, and the vectors of the first order of which a moment is left, or of the first one.
pub(super) fn pictures(problem: &Problem, star: &FoundStar, number: usize) -> Vec<Picture> {
    let left = star.moments.iter().find(|moment| !moment.sum.vanishes()).or(star.moments.first());
    pictures_at(problem, star, number, left.map(|moment| moment.order))
}

/// The crankshaft, and the vectors of an order.
pub(in crate::report) fn pictures_at(
    problem: &Problem,
    star: &FoundStar,
    number: usize,
    order: Option<u32>,
) -> Vec<Picture> {
    let Ok(engine) = star.engine(problem) else { return Vec::new() };
    let from_the_end =
        Picture::new(format!("star-{number}"), text::crankshaft(number, end_view_caption(&engine)), end_view(&engine));
    let judged = order.and_then(|order| classify(&engine, &[order], Masses::Reciprocating, &Quantity::PLANAR).ok());
    let parts = judged.iter().flatten().flat_map(|order| order.parts.first());
    let vectors = parts.map(|order| {
        Picture::new(
            format!("star-{number}-order-{}", order.order),
            text::star_vectors(number, order.order, star_legend(&engine, order)),
            star_figure(&engine, order),
        )
    });
    [from_the_end].into_iter().chain(vectors).collect()
}
