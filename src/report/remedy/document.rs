//! What does `remedy --json` hold? The engine, the weights, and the sums of the corrected engine with their evidence.

use super::super::document::{
    coefficient_claim, is_whole, knuckle_weight, rod_statement, shaft_radius, shaft_rod, vectors,
};
use crate::engine::Engine;
use crate::exact::PhasorSum;
use crate::loads::Missing;
use crate::numbers;
use crate::order::{self, Factor};
use crate::proof::{
    Certificate, Coefficient, CorrectedClaim, Format, LeftOutClaim, Masses, Planar, Quantity, RemedyDocument,
    RodCylinder, Sense, TurningClaim, WeightClaim, WeightPart,
};
use crate::remedy::{ComparableEngine, Remedy, Weight};

/// A remedy as data: what `verify` reads. Sums that do not vanish, if there are any, have evidence of that, which
/// `verify` refuses.
pub fn remedy_document(remedy: &Remedy) -> RemedyDocument {
    let subject = &remedy.subject;
    let mut sums = Vec::new();
    for &order in &remedy.orders {
        for quantity in Planar::BOTH {
            for sense in Sense::BOTH {
                let about = (quantity, order, sense);
                let claim = |coefficient, terms, certificate| CorrectedClaim {
                    quantity: quantity.into(),
                    order,
                    sense,
                    coefficient,
                    terms,
                    certificate,
                };
                let judged = remedy.corrected.iter().filter(|one| (one.quantity, one.order, one.sense) == about);
                let judged = judged.map(|one| (one, one.sum.collected())).filter(|(_, terms)| !terms.is_empty());
                let mut claims: Vec<CorrectedClaim> = judged
                    .map(|(one, terms)| claim(coefficient_claim(&one.factor), vectors(&terms), one.certificate.clone()))
                    .collect();
                if claims.is_empty() {
                    // The sum that has no term at this order.
                    let nothing = Certificate::Polygons { polygons: Vec::new() };
                    claims.push(claim(Coefficient::One, Vec::new(), nothing));
                }
                sums.extend(claims);
            }
        }
    }
    RemedyDocument {
        orders: remedy.orders.clone(),
        weights: remedy.weights().iter().map(weight).collect(),
        left_out: remedy.left_out.iter().map(|shaft| LeftOutClaim { order: shaft.order, sense: shaft.sense }).collect(),
        sums,
        ..engine_of(subject)
    }
}

/// The document of an engine without a remedy: what one is compared with.
///
/// # Errors
/// What the layout lacks for its masses to be compared.
pub fn remedy_engine(engine: &Engine) -> Result<RemedyDocument, Missing> {
    Ok(engine_of(&ComparableEngine::new(engine)?))
}

fn engine_of(subject: &ComparableEngine) -> RemedyDocument {
    let engine = subject.engine();
    let cylinders = engine.cylinders().iter().map(|cylinder| RodCylinder {
        speed: engine.speed_of(cylinder),
        throw: cylinder.throw.turns().clone(),
        bank: cylinder.bank.turns().clone(),
        position: cylinder.position.clone(),
        weight: order::mass_radius(engine, cylinder),
        rod: rod_statement(cylinder),
        knuckle_weight: knuckle_weight(cylinder),
    });
    let masses = order::turning_masses(engine).into_iter().filter(is_whole).map(|mass| TurningClaim {
        order: mass.order,
        sense: mass.sense,
        position: mass.position.clone(),
        angle: mass.angle.turns().clone(),
        mass_radius: shaft_radius(engine, &mass),
        coefficient_of: shaft_rod(engine, &mass),
    });
    RemedyDocument {
        format: Format::Remedy,
        title: engine.title().written().to_owned(),
        masses: Masses::All,
        orders: Vec::new(),
        quantities: Quantity::PLANAR.to_vec(),
        reference_plane: engine.reference_plane().clone(),
        cylinders: cylinders.collect(),
        turning_masses: masses.collect(),
        weights: Vec::new(),
        left_out: Vec::new(),
        sums: Vec::new(),
    }
}

fn weight(weight: &Weight) -> WeightClaim {
    let part = |(factor, sum): (&Factor, &PhasorSum)| WeightPart {
        coefficient: coefficient_claim(factor),
        terms: vectors(&sum.collected()),
        modulus: numbers::length_of(sum),
        angle_deg: numbers::degrees(numbers::evaluate(sum)),
    };
    WeightClaim {
        order: weight.order,
        sense: weight.sense,
        position: weight.position.clone(),
        parts: weight.vector.parts().iter().map(part).collect(),
    }
}
