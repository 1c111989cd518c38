//! Is a moment left that no choice of the reference plane cancels?
//!
//! Where an order leaves no force its moment is the same about every plane, so it has to vanish. Where a force is left the
//! two are one force in one plane, at z, if C = z P with the same real z for both vectors: C P̄ is real, and
//! C⁺P̄⁺ |P⁻|² = C⁻P̄⁻ |P⁺|². Then nothing of the moment is free.

use super::answer::{Answer, Condition, Evidence, Status};
use super::every;
use super::finding::Finding;
use super::masses;
use super::statement::Orders;
use crate::engine::Engine;
use crate::proof::Quantity;
use crate::verdict::OrderBalance;

/// Answers the claim that no order leaves a free moment.
pub(super) fn answer(engine: &Engine) -> Answer {
    let about_the_plane = every::answer(engine, &Orders::From(1), &[Quantity::MOMENT]);
    let Answer { status, finding, mut evidence } = about_the_plane;
    match (status, finding) {
        (Status::TrueOnlyIf { conditions, met }, finding) => {
            // Whose force is left and whose moment vanishes about one plane has no free moment about any.
            let is_plane = |one: &Condition| matches!(one, Condition::AboutPlane(_) | Condition::NotAboutPlane(_));
            let conditions: Vec<Condition> = conditions.into_iter().filter(|one| !is_plane(one)).collect();
            let status = if conditions.is_empty() { Status::True } else { Status::TrueOnlyIf { conditions, met } };
            Answer { status, finding, evidence }
        }
        (Status::False, Finding::Orders { surviving, judged, period, .. }) => {
            let orders = surviving.iter().filter_map(|order| masses::pistons(engine, *order));
            let mut free = Vec::new();
            for order in orders {
                match of_one_force(&order) {
                    Ok(proofs) => evidence.extend(proofs),
                    Err(proofs) => free.push((order, proofs)),
                }
            }
            let surviving = free.iter().map(|(order, _)| order.order).collect();
            // A couple that is free of the reference plane is the plainest counterexample.
            let shown = free.iter().position(|(order, _)| order.moment_is_couple()).unwrap_or(0);
            let first = (shown < free.len()).then(|| free.swap_remove(shown));
            let status = if first.is_some() { Status::False } else { Status::True };
            let first = first.map(|(order, proofs)| {
                let verdicts = order.force.verdicts().into_iter().chain(order.moment.verdicts());
                evidence = verdicts.map(|verdict| Evidence::Verdict(verdict.clone())).chain(proofs).collect();
                Box::new(order)
            });
            Answer { status, finding: Finding::Orders { surviving, judged, period, first }, evidence }
        }
        (status, finding) => Answer { status, finding, evidence },
    }
}

/// Whether force and moment of an order are those of one force in one plane, with the sums that show it or refute it.
fn of_one_force(order: &OrderBalance) -> Result<Vec<Evidence>, Vec<Evidence>> {
    let vectors = [(&order.force.direct, &order.moment.direct), (&order.force.reverse, &order.moment.reverse)];
    let mut proofs = Vec::new();
    for (force, moment) in vectors {
        if force.vanishes() && !moment.vanishes() {
            return Err(Vec::new());
        }
        let product = moment.sum.times(&force.sum.conjugate());
        let across = product.minus(&product.conjugate());
        proofs.push(Evidence::comparison("The part of the moment across its force", across));
    }
    let [direct, reverse] =
        vectors.map(|(force, moment)| (moment.sum.times(&force.sum.conjugate()), force.sum.squared_modulus()));
    if !direct.1.vanishes() && !reverse.1.vanishes() {
        let difference = direct.0.times(&reverse.1).minus(&reverse.0.times(&direct.1));
        proofs.push(Evidence::comparison("The difference of the planes of both forces", difference));
    }
    if proofs.iter().all(Evidence::vanishes) { Ok(proofs) } else { Err(proofs) }
}
