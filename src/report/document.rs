//! What does `classify --json` hold? Every verdict with its terms and its certificate.

use std::borrow::Cow;

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{One, Signed};

use crate::exact::Term;
use crate::layout::{self, Layout, Rod};
use crate::numbers;
use crate::proof::{
    Cylinder, Document, Format, Masses, OrderClaim, Quantity, RodClaim, RodStatement, ShapeClaim, ShapeEvidence,
    TheoremClaim, Vector, VerdictClaim,
};
use crate::verdict::{self, Balance, OrderBalance, Theorem, Verdict};

/// The verdicts on an engine as data: what `verify` reads. Statements on every order stand in it where they are given.
pub fn document(
    layout: &Layout,
    orders: &[OrderBalance],
    quantities: &[Quantity],
    every_order: Option<&Theorem>,
) -> Document {
    let of = |order: &OrderBalance| order.class.as_ref().map_or_else(Vec::new, |class| class.cylinders.clone());
    let verdicts = orders.iter().flat_map(|order| {
        let verdicts = [&order.force, &order.moment].into_iter().flat_map(Balance::verdicts).chain(&order.torque);
        verdicts.map(move |verdict| verdict_claim(&against_the_offset(layout, verdict), of(order)))
    });
    let shapes = orders.iter().flat_map(|order| [&order.force, &order.moment].map(shape_claim));
    let mut numbers: Vec<u32> = orders.iter().map(|order| order.order).collect();
    numbers.dedup();
    Document {
        format: Format::Classify,
        title: layout.title.written().to_owned(),
        masses: Masses::Reciprocating,
        orders: numbers,
        quantities: quantities.to_vec(),
        all_orders: every_order.is_some(),
        reference_plane: layout.reference_plane.clone(),
        cylinders: layout
            .cylinders
            .iter()
            .enumerate()
            .map(|(at, one)| cylinder(one, layout.mechanism.rods.get(at)))
            .collect(),
        turning_masses: Vec::new(),
        verdicts: verdicts.collect(),
        wholes: Vec::new(),
        shapes: shapes.collect(),
        theorems: every_order.map(theorem_claims).unwrap_or_default(),
    }
}

/// The quantities that `classify` judges.
pub fn quantities(with_torque: bool) -> Vec<Quantity> {
    [Quantity::Force, Quantity::Moment].into_iter().chain(with_torque.then_some(Quantity::Torque)).collect()
}

fn cylinder(cylinder: &layout::Cylinder, rod: Option<&Rod>) -> Cylinder {
    Cylinder {
        name: cylinder.name.clone(),
        throw: cylinder.throw.turns().clone(),
        bank: cylinder.bank.turns().clone(),
        position: cylinder.position.clone(),
        reciprocating_mass: cylinder.reciprocating_mass.clone(),
        crank_radius: cylinder.crank_radius.clone(),
        rod: rod.map_or(RodStatement::Unknown, |rod| RodStatement::Known(rod_claim(rod))),
    }
}

/// A rod as data.
pub(super) fn rod_claim(rod: &Rod) -> RodClaim {
    RodClaim { ratio: rod.ratio.clone(), offset: rod.offset.clone() }
}

/// The terms of a sum as data.
pub(super) fn vectors(terms: &[Term]) -> Vec<Vector> {
    terms.iter().map(|term| Vector { angle: term.angle.turns().clone(), weight: term.weight.clone() }).collect()
}

/// Terms stand before the coefficient of an offset to the positive side; that of odd orders above 1 changes its sign with it.
fn against_the_offset<'a>(layout: &Layout, verdict: &'a Verdict) -> Cow<'a, Verdict> {
    let is_behind = layout.mechanism.rods.first().is_some_and(|rod| rod.offset.is_negative());
    if !is_behind || verdict.quantity == Quantity::Torque || verdict.order == 1 || verdict.order.is_multiple_of(2) {
        return Cow::Borrowed(verdict);
    }
    let sum = verdict.sum.scaled(&-BigRational::one());
    Cow::Owned(Verdict { certificate: sum.certificate(), sum, ..verdict.clone() })
}

fn verdict_claim(verdict: &Verdict, of: Vec<String>) -> VerdictClaim {
    let vanishes = verdict.vanishes();
    let sum = if vanishes { Complex::new(0.0, 0.0) } else { numbers::evaluate(&verdict.sum) };
    VerdictClaim {
        quantity: verdict.quantity,
        order: verdict.order,
        sense: verdict.sense,
        of,
        vanishes,
        terms: vectors(verdict.sum.terms()),
        modulus: sum.norm(),
        angle_deg: (!vanishes).then(|| numbers::degrees(sum)),
        certificate: verdict.certificate.clone(),
    }
}

fn shape_claim(balance: &Balance) -> ShapeClaim {
    ShapeClaim {
        quantity: balance.direct.quantity,
        order: balance.direct.order,
        shape: balance.shape,
        evidence: balance.comparison.clone().map(ShapeEvidence::Certificate),
    }
}

/// The statements as data, with the verdicts that prove them.
fn theorem_claims(theorem: &Theorem) -> Vec<TheoremClaim> {
    let claim = |verdicts: &Vec<Verdict>| {
        let first = verdicts.first()?;
        let order = |verdict: &Verdict| OrderClaim {
            order: verdict.order,
            vanishes: verdict.vanishes(),
            certificate: verdict.certificate.clone(),
        };
        Some(TheoremClaim {
            quantity: first.quantity,
            sense: first.sense?,
            period: theorem.period.into(),
            survivors: verdict::survivors(verdicts),
            verdicts: verdicts.iter().map(order).collect(),
        })
    };
    let quantities = [&theorem.force, &theorem.moment];
    quantities.into_iter().flat_map(|every| [&every.direct, &every.reverse]).filter_map(claim).collect()
}
