//! For which angles and spacings does it vanish? Sums with an open bank angle φ, pin split δ, and open lengths.
//!
//! An angle `q + jφ + lδ` puts the factor `e^{i(jφ + lδ)}` before its term, and an arm `Σ c_s s` splits the sum by its
//! symbols. So every sum is `Σ_s s Σ_{j,l} e^{i(jφ + lδ)} S_{s,j,l}` with phasor sums S without unknowns: it vanishes for
//! all values of the symbols iff each `Σ_{j,l}` does, and for all angles iff every S does (theory, section 5).

mod circle;
mod comparable;
mod component;
mod firing;
mod plane;
mod range;
mod remaining;
mod solve;
mod torque;
mod zeros;

pub use circle::{Arc, Circle, Closed, Coprime, Factor, Kind, Polynomial};
pub use comparable::{NotComparable, comparable};
pub use component::{Component, component_zeros};
pub use firing::{EvenFiring, even_firing, even_firing_lines};
pub use plane::{BoxZero, Boxes, Classes, Corner, Meeting, Product, Quadratic, Root, Roots, Shape, Triangle, Twist};
pub use range::{Place, is_in_range};
pub use remaining::{Remaining, remaining};
pub use solve::{Alternative, Angles, Condition, Cosine, Never, When};
pub use torque::{NoOpenStar, OpenStar, SpanStar, firing_stars};
pub use zeros::{Solutions, Zeros};

use std::collections::{BTreeMap, BTreeSet};

use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::engine::{Cylinder, DELTA, Family, Linear, NotAnOrder, PHI, are_orders};
use crate::exact::{PhasorSum, Term, Turn};
use crate::order;
use crate::proof::{Certificate, Planar, Sense};

/// The factor `e^{i(phi·φ + delta·δ)}` with the sum behind it.
#[derive(Clone, Debug)]
pub struct Part {
    /// How many times φ enters.
    pub phi: BigRational,
    /// How many times δ enters.
    pub delta: BigRational,
    /// The sum without unknowns.
    pub sum: PhasorSum,
    /// Evidence that it is zero, or that it is not.
    pub certificate: Certificate,
}

/// The part of a sum that one length multiplies.
#[derive(Clone, Debug)]
pub struct OpenSum {
    /// The open length, or none for the known lengths (and for the force).
    pub symbol: Option<String>,
    /// The sums by the multiples of φ and δ that they are turned by.
    pub parts: Vec<Part>,
    /// When it vanishes.
    pub when: When,
}

impl OpenSum {
    /// The parts that do not vanish.
    pub fn left(&self) -> impl Iterator<Item = &Part> {
        self.parts.iter().filter(|part| !part.certificate.claims_zero())
    }
}

/// When one quantity, order and sense vanishes, whatever the open lengths are.
#[derive(Clone, Debug)]
pub struct OpenVerdict {
    /// Force or moment.
    pub quantity: Planar,
    /// The order k.
    pub order: u32,
    /// Direct or reverse.
    pub sense: Sense,
    /// One sum per length; none where no term has a weight.
    pub sums: Vec<OpenSum>,
}

impl OpenVerdict {
    /// Whether it vanishes for all angles and lengths.
    pub fn always(&self) -> bool {
        self.sums.iter().all(|sum| matches!(sum.when, When::Always))
    }

    /// Whether it vanishes for no angle, whatever the lengths are.
    pub fn never(&self) -> bool {
        self.sums.iter().any(|sum| matches!(sum.when, When::Never(_)))
    }

    /// The angles φ in (0°, 360°) at which it vanishes for all lengths; `None` where it always does, where δ enters,
    /// or where not all of them are rational.
    pub fn bank_angles(&self) -> Option<BTreeSet<Turn>> {
        self.angles_of(PHI)
    }

    /// The same of an unknown, φ or δ: `None` where the other one enters.
    pub fn angles_of(&self, unknown: &str) -> Option<BTreeSet<Turn>> {
        let (none, one) = (BigRational::zero(), BigRational::one());
        let values = self.values(unknown, [&none, &one])?;
        Some(values.into_iter().filter(|value| *value != none && *value != one).map(Turn::new).collect())
    }

    /// The values of one unknown, φ or δ, in a range at which it vanishes for all lengths, in turns and with the ends of the
    /// range; `None` where it always does, where the other one enters, or where not all of them are rational.
    pub fn values(&self, unknown: &str, range: [&BigRational; 2]) -> Option<BTreeSet<BigRational>> {
        match self.zeros(unknown, range) {
            Zeros::At(solutions) => solutions.all_exact().cloned(),
            Zeros::Everywhere | Zeros::NotSolved => None,
        }
    }
}

/// The verdicts on one order.
#[derive(Clone, Debug)]
pub struct OpenOrder {
    /// The order k.
    pub order: u32,
    /// Force, direct and reverse.
    pub force: [OpenVerdict; 2],
    /// Moment, direct and reverse.
    pub moment: [OpenVerdict; 2],
}

/// Judges the given orders of a family that is [`comparable`].
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
    OpenVerdict { quantity, order, sense, sums: sums_of(&terms) }
}

/// What a cylinder's vector weighs.
fn weight(family: &Family, cylinder: &Cylinder<Linear, Linear>, quantity: Planar) -> Linear {
    match quantity {
        Planar::Moment => family.arm(cylinder).scaled(&cylinder.weight()),
        Planar::Force => Linear::constant(cylinder.weight()),
    }
}

/// The sums of terms with open angles and weights, one for each length.
fn sums_of(terms: &[(Linear, Linear)]) -> Vec<OpenSum> {
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
fn sum_of(terms: &[(Linear, Linear)], symbol: Option<&String>) -> OpenSum {
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
