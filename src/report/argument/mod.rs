//! How does a person argue that a sum is zero, or that it is not? Sentences that can be checked by hand.

mod certificate;
mod left;
mod sums;
mod zero;

use num_traits::Zero;

use crate::engine::Engine;
use crate::order::Source;
use crate::page::Text;
use crate::proof::{Polygon, Quantity};
use crate::verdict::{Reason, Verdict, drawn_polygons, reason};
pub use certificate::certificate;
pub(super) use certificate::certificate_of;
pub(super) use sums::listed;

/// The sentences that prove a verdict: about the polygons that are drawn, or without primes where there is such a way.
pub fn argument(engine: &Engine, verdict: &Verdict) -> Text {
    match reason(engine, verdict) {
        Reason::NoWeight if verdict.sources.is_empty() => "No mass has a part in it.".into(),
        Reason::NoWeight if verdict.quantity == Quantity::Moment && stand_in_the_plane(engine, verdict) => {
            "Every cylinder stands in the reference plane: all arms are zero.".into()
        }
        Reason::NoWeight => "All masses are zero.".into(),
        Reason::Mirror => zero::mirror(engine),
        Reason::Cancels => zero::cancelling(engine, verdict),
        Reason::OpposedPairs => zero::opposed(engine, verdict),
        Reason::Rotation { fold } => zero::rotation(engine, verdict, fold),
        Reason::Polygons => zero::polygons(engine, verdict),
        Reason::OneVector(vector) => left::one(&vector),
        Reason::TwoVectors(vectors) => left::two(&vectors),
        Reason::OneTooLong(vectors) => left::one_too_long(&vectors),
        Reason::ThreeAlike(vectors) => left::three_alike(&vectors),
        Reason::OneSide { middle, within } => left::one_side(&verdict.sum, &middle, &within),
        Reason::Component(component) => left::component(&component),
        Reason::Certificate => "No set of regular polygons makes up this star; the certificate shows it.".into(),
    }
}

/// The polygons that a drawing of the star shows: those that the argument is about.
pub(super) fn polygons_shown(verdict: &Verdict) -> Vec<Polygon> {
    drawn_polygons(verdict)
}

/// Whether it is the arms that leave nothing of a moment of pistons.
fn stand_in_the_plane(engine: &Engine, verdict: &Verdict) -> bool {
    let arm = |source: &Source| match source {
        Source::Piston(index) => Some(engine.arm(&engine.cylinders()[*index])),
        Source::BigEnd(_) | Source::Pin(_) | Source::Webs(_) | Source::Counterweight(_) | Source::Balancer(_) => None,
    };
    verdict.sources.iter().all(|source| arm(source).is_some_and(|arm| arm.is_zero()))
}
