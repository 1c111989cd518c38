//! What is the star of one order, and is it zero?

use num_rational::BigRational;

use super::Weights;
use crate::engine::{CycleOrder, Engine, Firing, Mechanism};
use crate::exact::{PhasorSum, Term};
use crate::order::Source;
use crate::proof::{Certificate, Quantity};
use crate::verdict::JudgedStar;

/// One order of the gas torque: a star for each class of cylinders that make the same torque from the same pressure.
#[derive(Clone, Debug)]
pub struct StarOrder {
    /// The order κ.
    pub order: CycleOrder,
    /// The stars, in the order of the first cylinder of each; one where all cylinders have the same rod ratio and offset.
    pub stars: Vec<FiringStar>,
}

/// The star of cylinders that make the same torque from the same pressure, in multiples of their crank radius.
#[derive(Clone, Debug)]
pub struct FiringStar {
    /// Whose vectors they are, in the order of the cylinders.
    pub sources: Vec<Source>,
    /// The sum, one term per cylinder.
    pub sum: PhasorSum,
    /// The evidence.
    pub certificate: Certificate,
}

impl StarOrder {
    pub(super) fn new(engine: &Engine, firing: &Firing, order: CycleOrder, weights: &Weights) -> Self {
        let star = |(cylinders, sum): (Vec<usize>, PhasorSum)| FiringStar {
            sources: cylinders.into_iter().map(Source::Piston).collect(),
            certificate: sum.certificate(),
            sum,
        };
        StarOrder { order, stars: sums(engine, firing, order, weights).into_iter().map(star).collect() }
    }

    /// Whether the order vanishes for every pressure law that all cylinders share.
    ///
    /// Stars of different classes do not cancel for every law: their torques from one pressure are not proportional, since rods
    /// of another ratio or offset have their dead points of `cos β` elsewhere.
    pub fn vanishes(&self) -> bool {
        self.stars.iter().all(FiringStar::vanishes)
    }

    /// The one star of an engine whose cylinders are all alike.
    pub fn only(&self) -> Option<&FiringStar> {
        match self.stars.as_slice() {
            [only] => Some(only),
            _ => None,
        }
    }

    /// Whether the vectors of all cylinders point the same way, so that each adds its full length.
    pub fn is_major(&self) -> bool {
        let mut terms = self.stars.iter().flat_map(|star| star.sum.positive().collected());
        match terms.next() {
            None => false,
            Some(first) => terms.all(|term| term.angle == first.angle),
        }
    }
}

impl FiringStar {
    /// Whether the sum is zero.
    pub fn vanishes(&self) -> bool {
        self.certificate.claims_zero()
    }
}

impl<'a> From<&'a FiringStar> for JudgedStar<'a> {
    fn from(star: &'a FiringStar) -> Self {
        let FiringStar { sources, sum, certificate } = star;
        JudgedStar { quantity: Quantity::TORQUE, sources, sum, certificate }
    }
}

/// The sum of each class of cylinders, with the cylinders in it.
pub(super) fn sums(
    engine: &Engine,
    firing: &Firing,
    order: CycleOrder,
    weights: &Weights,
) -> Vec<(Vec<usize>, PhasorSum)> {
    let term = |&cylinder: &usize| Term {
        angle: order.phase(angle_of(firing, cylinder)),
        weight: &engine.cylinders()[cylinder].crank_radius * weights.of(cylinder),
    };
    let sum = |cylinders: Vec<usize>| {
        let terms = cylinders.iter().map(term).collect();
        (cylinders, PhasorSum::new(terms))
    };
    classes(engine).into_iter().map(sum).collect()
}

/// When a cylinder fires, in turns of the crank after the first of the firing order.
fn angle_of(firing: &Firing, cylinder: usize) -> &BigRational {
    let shot = firing.shots.iter().find(|shot| shot.cylinder == cylinder);
    &shot.unwrap_or_else(|| unreachable!("each cylinder fires once in a cycle")).angle
}

/// The cylinders by rod ratio and offset, in the order of the first of each; one class where no rod is known. Of two pistons in one cylinder the
/// first stands for both: where they move alike in all, what they turn the crank with is in proportion to its star.
fn classes(engine: &Engine) -> Vec<Vec<usize>> {
    let mut classes: Vec<(Option<Mechanism>, Vec<usize>)> = Vec::new();
    for index in engine.firing_pistons() {
        let mechanism = engine.cylinders()[index].mechanism.as_ref().map(Mechanism::motion);
        match classes.iter_mut().find(|(own, _)| *own == mechanism) {
            Some((_, members)) => members.push(index),
            None => classes.push((mechanism, vec![index])),
        }
    }
    classes.into_iter().map(|(_, members)| members).collect()
}
