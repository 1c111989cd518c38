//! Why does it vanish, or not? The reason that a person would give first.

use num_traits::Zero;

use super::Verdict;
use crate::engine::{Cylinder, Engine};
use crate::exact::{PhasorSum, Term, Turn};
use crate::order::Source;
use crate::proof::{Certificate, Quantity};

/// The plainest reason for a verdict.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// All weights are zero: every arm, or every mass.
    NoWeight,
    /// Zero: a mirror plane across the crankshaft pairs cylinders with opposite arms.
    Mirror,
    /// Zero: like directions collect to nothing.
    Cancels,
    /// Zero: every vector has a partner, equally long and opposite.
    OpposedPairs,
    /// Zero: the collected star maps to itself when turned by `1/fold` of a turn.
    Rotation {
        /// How many such turns make a whole one.
        fold: u32,
    },
    /// Zero: regular polygons, as the certificate lists them.
    Polygons,
    /// Not zero: one direction is left.
    OneDirection(Term),
    /// Not zero: two directions are left that do not cancel.
    TwoDirections(Term, Term),
    /// Not zero: as the certificate shows.
    Certificate,
}

/// The plainest reason for a verdict on this engine.
pub fn reason(engine: &Engine, verdict: &Verdict) -> Reason {
    let collected = verdict.sum.collected();
    let no_weight = verdict.sum.terms().iter().all(|term| term.weight.is_zero());
    match (&verdict.certificate, collected.as_slice()) {
        (Certificate::Polygons { .. }, _) if no_weight => Reason::NoWeight,
        (Certificate::Polygons { .. }, _) if is_moment_of_pistons(verdict) && has_mirror(engine) => Reason::Mirror,
        (Certificate::Polygons { .. }, []) => Reason::Cancels,
        (Certificate::Polygons { .. }, _) if opposed_partners(&verdict.sum).is_some() => Reason::OpposedPairs,
        (Certificate::Polygons { .. }, terms) => match fold(terms) {
            Some(fold) => Reason::Rotation { fold },
            None => Reason::Polygons,
        },
        (_, [only]) => Reason::OneDirection(only.clone()),
        (_, [first, second]) => Reason::TwoDirections(first.clone(), second.clone()),
        _ => Reason::Certificate,
    }
}

/// For each cylinder its mirror image across the reference plane: equal throw, bank and mass, opposite arm.
///
/// `None` where some cylinder has none. A cylinder in the plane is its own image.
pub fn mirror_partners(engine: &Engine) -> Option<Vec<usize>> {
    let mut partners: Vec<Option<usize>> = vec![None; engine.cylinders().len()];
    let is_image = |a: &Cylinder, b: &Cylinder| {
        engine.arm(a) == -engine.arm(b) && (&a.throw, &a.bank, a.weight()) == (&b.throw, &b.bank, b.weight())
    };
    for (index, cylinder) in engine.cylinders().iter().enumerate() {
        if partners[index].is_some() {
            continue;
        }
        let in_plane = is_image(cylinder, cylinder);
        let image = (index + 1..engine.cylinders().len())
            .find(|&other| !in_plane && partners[other].is_none() && is_image(cylinder, &engine.cylinders()[other]));
        let image = if in_plane { index } else { image? };
        partners[index] = Some(image);
        partners[image] = Some(index);
    }
    partners.into_iter().collect()
}

/// The vectors of a sum in pairs that are equally long and opposite, by index; those of length zero are left out.
///
/// `None` where some vector has no partner.
pub fn opposed_partners(sum: &PhasorSum) -> Option<Vec<(usize, usize)>> {
    let mut alone: Vec<(usize, Term)> = Vec::new();
    let mut pairs = Vec::new();
    for (index, term) in sum.terms().iter().enumerate().filter(|(_, term)| !term.weight.is_zero()) {
        match alone.iter().position(|(_, other)| cancel(term, other)) {
            Some(place) => pairs.push((alone.remove(place).0, index)),
            None => alone.push((index, term.clone())),
        }
    }
    pairs.sort_unstable();
    alone.is_empty().then_some(pairs)
}

fn cancel(a: &Term, b: &Term) -> bool {
    let turn = &a.angle - &b.angle;
    (turn == Turn::zero() && a.weight == -&b.weight) || (turn == Turn::fraction(1, 2) && a.weight == b.weight)
}

/// Whether a mirror plane of the cylinders is one of all that the sum is about.
fn is_moment_of_pistons(verdict: &Verdict) -> bool {
    verdict.quantity == Quantity::Moment && verdict.sources.iter().all(|source| matches!(source, Source::Piston(_)))
}

fn has_mirror(engine: &Engine) -> bool {
    mirror_partners(engine).is_some()
}

/// The largest `n ≥ 2` such that the star maps to itself when turned by `1/n`.
fn fold(collected: &[Term]) -> Option<u32> {
    let count = u32::try_from(collected.len()).ok()?;
    (2..=count).rev().find(|&fold| {
        let turned = PhasorSum::new(collected.to_vec()).turned(&Turn::fraction(1, i64::from(fold)));
        turned.collected() == collected
    })
}
