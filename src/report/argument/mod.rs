//! How does a person argue that a sum is zero, or that it is not? Sentences that can be checked by hand.

mod certificate;
mod left;
mod star;
mod sums;
mod zero;

use num_traits::Zero;

use crate::engine::Engine;
use crate::order::Source;
use crate::page::Text;
use crate::proof::Quantity;
use crate::report::texts::argument as text;
use crate::verdict::{JudgedStar, Reason, reason};
pub use certificate::certificate;
pub(super) use certificate::{certificate_of, listed_polygons};
pub(super) use star::{ExactRay, ExactStar};
pub(super) use sums::listed;

/// The sentences that prove a verdict: about the polygons that are drawn, or without primes where there is such a way.
pub fn argument<'a>(engine: &Engine, star: impl Into<JudgedStar<'a>>) -> Text {
    let star = star.into();
    match reason(engine, star) {
        Reason::NoWeight if star.sources.is_empty() => text::no_mass(),
        Reason::NoWeight if star.quantity == Quantity::MOMENT && stand_in_the_plane(engine, star) => text::no_arm(),
        Reason::NoWeight if star.quantity == Quantity::MOMENT => text::no_mass_or_arm(),
        Reason::NoWeight => text::masses_zero(),
        Reason::Mirror => zero::mirror(engine),
        Reason::Cancels => zero::cancelling(engine, star),
        Reason::OpposedPairs => zero::opposed(engine, star),
        Reason::Rotation { fold } => zero::rotation(engine, star, fold),
        Reason::Polygons => zero::polygons(engine, star),
        Reason::OneVector(vector) => left::one(&vector),
        Reason::TwoVectors(vectors) => text::two_vectors(sums::vectors(&vectors)),
        Reason::OneTooLong(vectors) => text::one_too_long(sums::vectors(&vectors)),
        Reason::ThreeAlike(vectors) => text::three_alike(sums::vectors(&vectors)),
        Reason::OneSide { middle, within } => left::one_side(star.sum, &middle, &within),
        Reason::Component(component) => left::component(&component),
        Reason::Certificate => text::by_certificate(),
    }
}

/// Whether it is the arms that leave nothing of a moment of pistons.
fn stand_in_the_plane(engine: &Engine, star: JudgedStar<'_>) -> bool {
    let arm = |source: &Source| Some(engine.arm(&engine.cylinders()[source.piston()?]));
    star.sources.iter().all(|source| arm(source).is_some_and(|arm| arm.is_zero()))
}
