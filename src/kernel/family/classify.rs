//! Into which sums does an order of a family split, one for each length and angle?

use std::collections::{BTreeMap, BTreeSet};

use num_rational::BigRational;
use num_traits::Zero;

use super::part::Part;
use super::solve;
use super::verdict::{OpenOrder, OpenSum, OpenVerdict};
use crate::engine::{Cylinder, DELTA, Family, Linear, NotAnOrder, PHI, are_orders};
use crate::exact::{PhasorSum, Term, Turn};
use crate::order;
use crate::proof::{Planar, Sense};

/// Judges the given orders of a family that is [`comparable`](super::comparable()).
///
/// # Errors
/// A number that is no order.
pub fn classify(family: &Family, orders: &[u32]) -> Result<Vec<OpenOrder>, NotAnOrder> {
    are_orders(orders)?;
    let judge = |quantity, order| Sense::BOTH.map(|sense| verdict(family, quantity, order, sense));
    let order =
        |&order: &u32| OpenOrder { order, force: judge(Planar::Force, order), moment: judge(Planar::Moment, order) };
    Ok(orders.iter().map(order).collect())
}

fn verdict(family: &Family, quantity: Planar, order: u32, sense: Sense) -> OpenVerdict {
    let terms: Vec<(Linear, Linear)> = family
        .cylinders()
        .iter()
        .map(|cylinder| (phase(cylinder, order, sense), weight(family, cylinder, quantity)))
        .collect();
    let exists = family.pistons_have_order(quantity.into(), order);
    OpenVerdict { quantity, order, sense, sums: sums_of(&terms), exists }
}

/// What a cylinder's vector weighs.
pub(super) fn weight(family: &Family, cylinder: &Cylinder<Linear, Linear>, quantity: Planar) -> Linear {
    match quantity {
        Planar::Moment => family.arm(cylinder).scaled(&cylinder.weight()),
        Planar::Force => Linear::constant(cylinder.weight()),
    }
}

/// The sums of terms with open angles and weights, one for each length.
pub(super) fn sums_of(terms: &[(Linear, Linear)]) -> Vec<OpenSum> {
    let symbols: BTreeSet<Option<&String>> = terms
        .iter()
        .flat_map(|(_, weight)| {
            let known = (!weight.known().is_zero()).then_some(None);
            weight.symbols().keys().map(Some).chain(known)
        })
        .collect();
    symbols.into_iter().map(|symbol| sum_of(terms, symbol)).collect()
}

/// The phase of a cylinder in the star of order k, with the unknowns in it.
pub fn phase(cylinder: &Cylinder<Linear, Linear>, order: u32, sense: Sense) -> Linear {
    let [of_throw, of_bank] = order::multiples(order, Some(sense)).map(|times| BigRational::from_integer(times.into()));
    cylinder.throw.scaled(&of_throw).plus(&cylinder.bank.scaled(&of_bank))
}

/// The part of a sum that a length multiplies, or of the known lengths.
pub(super) fn sum_of(terms: &[(Linear, Linear)], symbol: Option<&String>) -> OpenSum {
    let mut by_angle: BTreeMap<(BigRational, BigRational), Vec<Term>> = BTreeMap::new();
    for (angle, weight) in terms {
        let weight = symbol.map_or_else(|| weight.known().clone(), |symbol| weight.coefficient(symbol));
        let term = Term { angle: Turn::new(angle.known().clone()), weight };
        by_angle.entry((angle.coefficient(PHI), angle.coefficient(DELTA))).or_default().push(term);
    }
    let part = |((phi, delta), terms)| {
        let sum = PhasorSum::new(terms);
        Part { phi, delta, certificate: sum.certificate(), sum }
    };
    let parts: Vec<Part> = by_angle.into_iter().map(part).collect();
    let left: Vec<&Part> = parts.iter().filter(|part| !part.certificate.claims_zero()).collect();
    OpenSum { symbol: symbol.cloned(), when: solve::when(&left), parts }
}
