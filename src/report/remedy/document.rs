//! What does `remedy --json` hold? The weights in decimals for reading, and the remedy with its evidence, which `verify`
//! checks.

use num_rational::BigRational;
use num_traits::ToPrimitive;
use serde::Serialize;

use super::words;
use crate::exact::PhasorSum;
use crate::loads::{self, Factor};
use crate::proof::{
    CorrectedClaim, RemedyDocument, RodClaim, RodCylinder, Sense, TurningClaim, Vector, WeightClaim, WeightPart,
};
use crate::remedy::{Ellipse, Partial, Remedy, Weight};

/// A remedy as data.
#[derive(Clone, Debug, Serialize)]
pub struct RemedyPage {
    #[serde(flatten)]
    remedy: RemedyDocument,
    weights_in_decimals: Vec<WeightEntry>,
    pair_heights: Vec<HeightEntry>,
    partial_balance: Option<PartialEntry>,
    /// As the layout file has it; null where it gives no masses.
    balance_factors: Vec<Option<f64>>,
    /// The masses in the balance equations, and with the counterweights of the remedy at the crank radius.
    crankshaft_mass_kg: Option<[f64; 2]>,
}

#[derive(Clone, Debug, Serialize)]
struct WeightEntry {
    part_of: String,
    order: u32,
    sense: &'static str,
    lanchester: bool,
    position: f64,
    /// In closed form, in multiples of m r, or of m r |c_k|.
    mass_radius_exact: Option<String>,
    /// In multiples of m r.
    mass_radius: Option<f64>,
    angle_deg: Option<f64>,
    mass_radius_kg_m: Option<f64>,
    mass_at_crank_radius_kg: Option<f64>,
}

#[derive(Clone, Debug, Serialize)]
struct HeightEntry {
    order: u32,
    crank_radii: f64,
    metres: Option<f64>,
}

/// The first order over the balanced part of the reciprocating masses, in multiples of m r ω².
#[derive(Clone, Debug, Serialize)]
struct PartialEntry {
    least_peak: f64,
    at_part: f64,
    curve: Vec<[f64; 3]>,
}

/// The data of a remedy; sums that do not vanish, if there are any, have evidence of that, which `verify` refuses.
pub fn remedy_document(remedy: &Remedy) -> RemedyPage {
    let layout = remedy.subject.layout();
    let entry_of = |partial: &Partial, (part, least): (BigRational, Ellipse)| PartialEntry {
        least_peak: least.peak_decimal,
        at_part: part.to_f64().unwrap_or(f64::NAN),
        curve: (partial.curve(20).iter())
            .map(|(part, ellipse)| [part.to_f64().unwrap_or(f64::NAN), ellipse.peak_decimal, ellipse.least_decimal])
            .collect(),
    };
    let partial = Partial::new(layout);
    let partial_balance = partial.and_then(|partial| Some(entry_of(&partial, partial.minimum()?)));
    let height = |height: &crate::remedy::PairHeight| HeightEntry {
        order: height.order,
        crank_radii: height.in_crank_radii,
        metres: height.metres,
    };
    RemedyPage {
        weights_in_decimals: words::parts(remedy).into_iter().map(|part| entry(remedy, &part)).collect(),
        pair_heights: remedy.heights.iter().map(height).collect(),
        partial_balance,
        balance_factors: layout.balance_factors().into_iter().map(|factor| factor?.to_f64()).collect(),
        crankshaft_mass_kg: layout.crankshaft_mass().and_then(|mass| Some([mass.to_f64()?, remedy.crankshaft_mass()?])),
        remedy: proof(remedy),
    }
}

fn entry(remedy: &Remedy, part: &words::Part<'_>) -> WeightEntry {
    let (subject, weight) = (&remedy.subject, part.weight);
    let decimals = weight.decimals(subject);
    WeightEntry {
        part_of: part.name.clone(),
        order: weight.order,
        sense: if weight.sense == Sense::Direct { "with" } else { "against" },
        lanchester: part.lanchester,
        position: weight.position.to_f64().unwrap_or(f64::NAN),
        mass_radius_exact: weight.modulus().map(|form| form.to_string()),
        mass_radius: decimals.map(|[size, _]| size),
        angle_deg: decimals.map(|[_, angle]| angle),
        mass_radius_kg_m: weight.mass_radius(subject),
        mass_at_crank_radius_kg: weight.mass_at_crank_radius(subject),
    }
}

fn proof(remedy: &Remedy) -> RemedyDocument {
    let layout = remedy.subject.layout();
    let cylinders = layout.cylinders.iter().zip(&layout.mechanism.rods).map(|(cylinder, rod)| RodCylinder {
        throw: cylinder.throw.turns().clone(),
        bank: cylinder.bank.turns().clone(),
        position: cylinder.position.clone(),
        weight: loads::mass_radius(layout, cylinder),
        rod: RodClaim { ratio: rod.ratio.clone(), offset: rod.offset.clone() },
    });
    let masses = loads::all_turning_masses(layout).into_iter().map(|mass| TurningClaim {
        order: mass.order,
        sense: mass.sense,
        position: mass.position,
        angle: mass.angle.turns().clone(),
        mass_radius: mass.mass_radius,
    });
    let sums = remedy.corrected.iter().map(|judged| CorrectedClaim {
        quantity: judged.quantity,
        order: judged.order,
        sense: judged.sense,
        coefficient: rod(&judged.factor),
        terms: terms(&judged.sum),
        certificate: judged.certificate.clone(),
    });
    RemedyDocument {
        title: layout.title.written().to_owned(),
        remedied_orders: remedy.orders.clone(),
        reference_plane: layout.reference_plane.clone(),
        rods_known: remedy.subject.rods_known(),
        cylinders: cylinders.collect(),
        masses: masses.collect(),
        weights: remedy.weights().iter().map(weight).collect(),
        sums: sums.collect(),
    }
}

fn weight(weight: &Weight) -> WeightClaim {
    let part = |(factor, sum): (&Factor, &PhasorSum)| WeightPart { coefficient: rod(factor), terms: terms(sum) };
    WeightClaim {
        order: weight.order,
        sense: weight.sense,
        position: weight.position.clone(),
        parts: weight.vector.parts().iter().map(part).collect(),
    }
}

fn rod(factor: &Factor) -> Option<RodClaim> {
    factor.as_ref().map(|rod| RodClaim { ratio: rod.ratio.clone(), offset: rod.offset.clone() })
}

fn terms(sum: &PhasorSum) -> Vec<Vector> {
    let term = |term: &crate::exact::Term| Vector { angle: term.angle.turns().clone(), weight: term.weight.clone() };
    sum.terms().iter().map(term).collect()
}
