//! What do the first stars look like? Each from the free end, with the vectors of an order that it leaves.

use super::super::star::star_figure;
use super::super::views::end_view;
use crate::order::Masses;
use crate::page::{Picture, phrase};
use crate::proof::Quantity;
use crate::search::{FoundStar, Problem};
use crate::verdict::classify;

/// The crankshaft, and the vectors of the first order of which a moment is left, or of the first one.
pub(super) fn pictures(problem: &Problem, star: &FoundStar, number: usize) -> Vec<Picture> {
    let Ok(engine) = star.engine(problem) else { return Vec::new() };
    let from_the_end = Picture {
        name: format!("star-{number}"),
        caption: phrase!(
            "Star {} from the free end, angle 0 upwards, angles anticlockwise: crankpins inside, cylinders outside.",
            number
        ),
        figure: end_view(&engine),
    };
    let left = star.moments.iter().find(|moment| !moment.sum.vanishes()).or(star.moments.first());
    let judged = left.and_then(|moment| {
        let quantities = [Quantity::Force, Quantity::Moment];
        classify(&engine, &[moment.order], Masses::Reciprocating, &quantities).ok()
    });
    let parts = judged.iter().flatten().flat_map(|order| order.parts.first());
    let vectors = parts.map(|order| Picture {
        name: format!("star-{number}-order-{}", order.order),
        caption: phrase!(
            "Star {}, order {}: the two vectors of each cylinder, above for the force and below for the moment. Coloured polygons sum to zero; a \
             red arrow is what is left.",
            number,
            order.order
        ),
        figure: star_figure(&engine, order),
    });
    [from_the_end].into_iter().chain(vectors).collect()
}
