//! What does `classify --json` hold? Every verdict with its terms and its certificate.

use num_complex::Complex;

use crate::layout::Layout;
use crate::numbers;
use crate::proof::{Cylinder, Document, OrderClaim, ShapeClaim, TheoremClaim, Vector, VerdictClaim};
use crate::verdict::{self, Balance, OrderBalance, Theorem, Verdict};

/// The verdicts on an engine as data: what `verify` reads.
pub fn document(layout: &Layout, orders: &[OrderBalance]) -> Document {
    let cylinder = |cylinder: &crate::layout::Cylinder| Cylinder {
        name: cylinder.name.clone(),
        throw: cylinder.throw.turns().clone(),
        bank: cylinder.bank.turns().clone(),
        position: cylinder.position.clone(),
        reciprocating_mass: cylinder.reciprocating_mass.clone(),
        crank_radius: cylinder.crank_radius.clone(),
    };
    let of = |order: &OrderBalance| order.class.as_ref().map_or_else(Vec::new, |class| class.cylinders.clone());
    let verdicts = orders.iter().flat_map(|order| {
        let verdicts = [&order.force, &order.moment].into_iter().flat_map(Balance::verdicts).chain(&order.torque);
        verdicts.map(move |verdict| verdict_claim(verdict, of(order)))
    });
    let shapes =
        orders.iter().flat_map(|order| [&order.force, &order.moment].map(|balance| shape_claim(balance, of(order))));
    Document {
        title: layout.title.written().to_owned(),
        reference_plane: layout.reference_plane.clone(),
        cylinders: layout.cylinders.iter().map(cylinder).collect(),
        verdicts: verdicts.collect(),
        shapes: shapes.collect(),
        theorems: Vec::new(),
    }
}

fn verdict_claim(verdict: &Verdict, of: Vec<String>) -> VerdictClaim {
    let vanishes = verdict.vanishes();
    let sum = if vanishes { Complex::new(0.0, 0.0) } else { numbers::evaluate(&verdict.sum) };
    let term = |term: &crate::exact::Term| Vector { angle: term.angle.turns().clone(), weight: term.weight.clone() };
    VerdictClaim {
        quantity: verdict.quantity,
        order: verdict.order,
        sense: verdict.sense,
        of,
        vanishes,
        terms: verdict.sum.terms().iter().map(term).collect(),
        modulus: sum.norm(),
        angle_deg: (!vanishes).then(|| sum.arg().to_degrees()),
        certificate: verdict.certificate.clone(),
    }
}

fn shape_claim(balance: &Balance, of: Vec<String>) -> ShapeClaim {
    ShapeClaim {
        quantity: balance.direct.quantity,
        order: balance.direct.order,
        of,
        shape: balance.shape,
        certificate: balance.comparison.clone(),
    }
}

/// The statements as data, with the verdicts that prove them: what `verify` reads.
pub fn theorem_claims(theorem: &Theorem) -> Vec<TheoremClaim> {
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
