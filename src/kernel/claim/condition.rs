//! What does a moment depend on, that a claim may leave unsaid? The reference plane, and the offset of the banks.

use num_rational::BigRational;

use super::answer::Condition;
use crate::engine::{Cylinder, Engine, Form};
use crate::exact::{PhasorSum, Term, Turn};
use crate::numbers;
use crate::order::{Masses, Source, Sources};
use crate::proof::{Planar, Sense};
use crate::verdict::OrderBalance;

/// Conditions of a vanishing moment: only about this plane where the force is left, only without a bank offset where
/// one would not cancel.
pub(super) fn of_vanishing(engine: &Engine, order: &OrderBalance, senses: &[Sense]) -> Vec<Condition> {
    let force_is_left = senses.iter().any(|sense| !of(&order.force, *sense).vanishes());
    let plane = force_is_left.then(|| Condition::AboutPlane(engine.reference_plane().clone()));
    let offset = (takes_offset(engine)
        && senses.iter().any(|sense| !offset_sum(engine, order.order, *sense).vanishes()))
    .then_some(Condition::NoBankOffset);
    plane.into_iter().chain(offset).collect()
}

/// The plane about which a moment vanishes that does not about the layout's: `C = z P` for each vector.
pub(super) fn plane_of_vanishing(engine: &Engine, order: &OrderBalance, senses: &[Sense]) -> Option<BigRational> {
    let vectors = |sense: &Sense| (of(&order.force, *sense).sum.clone(), of(&order.moment, *sense).sum.clone());
    let (force, moment) = senses.iter().map(vectors).find(|(force, _)| !force.vanishes())?;
    // C P̄ = z |P|²: for a rational z both closed forms are multiples of each other.
    let (product, square) =
        (numbers::real(&moment.times(&force.conjugate()))?, numbers::real(&force.squared_modulus())?);
    let arm = product.terms().first()?.1.clone() / square.terms().first()?.1.clone();
    let fits = |(force, moment): (PhasorSum, PhasorSum)| moment.minus(&force.scaled(&arm)).vanishes();
    senses.iter().map(vectors).all(fits).then(|| engine.reference_plane() + &arm)
}

/// One of the two vectors.
pub(super) fn of(balance: &crate::verdict::Balance, sense: Sense) -> &crate::verdict::Verdict {
    sense.choose(&balance.direct, &balance.reverse)
}

/// Whether the layout is a vee whose cylinders stand pin by pin in one plane, so that an offset is a change. Links are in the plane
/// of their master and cannot be elsewhere.
fn takes_offset(engine: &Engine) -> bool {
    let partner = |a: &Cylinder| engine.cylinders().iter().any(|b| b.bank != a.bank && b.position == a.position);
    matches!(engine.form(), Form::Vee | Form::Flat)
        && engine.only_rods().is_ok()
        && engine.cylinders().iter().all(partner)
}

/// What an offset of the banks adds to the moment: the force of one bank less that of the other.
fn offset_sum(engine: &Engine, order: u32, sense: Sense) -> PhasorSum {
    let first: Option<&Turn> = engine.cylinders().first().map(|cylinder| &cylinder.bank);
    let bank = |source: Source| source.piston().map(|index| &engine.cylinders()[index].bank);
    let terms = Sources::new(engine, Masses::Reciprocating).terms(Planar::Force.into(), order, Some(sense));
    let signed = terms.into_iter().map(|(source, _, Term { angle, weight })| Term {
        angle,
        weight: if bank(source) == first { weight } else { -weight },
    });
    PhasorSum::new(signed.collect())
}

/// The senses that a claim is about.
pub(super) fn senses(sense: Option<Sense>) -> Vec<Sense> {
    sense.map_or(Sense::BOTH.to_vec(), |sense| vec![sense])
}
