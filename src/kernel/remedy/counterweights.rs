//! Which counterweights cancel what turns with the crank: one set a bay, or two planes?

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::comparable_engine::ComparableEngine;
use super::weight::{Weight, doubled_square};
use crate::engine::{Throw, throws};
use crate::exact::{PhasorSum, Term, Turn};
use crate::numbers;
use crate::order::{self, Factor, OrderSum};
use crate::proof::Sense;

/// Counterweights of each throw opposite to it, or turned on from there by a skew, sized by a balance factor: `BF·D` with
/// `D = m_rot r + ½ Σ m_rec r` (theory, section 7). One weight a throw, in its plane.
///
/// A list that is shorter than the number of throws goes on with its last value.
pub fn bay_by_bay(subject: &ComparableEngine, factors: &[BigRational], skews: &[Turn]) -> Vec<Weight> {
    let throws = throws(subject.engine());
    let wholes = throw_weights(subject, &throws);
    let weight = |(index, throw): (usize, &Throw)| {
        let factor = value_of(factors, index).cloned().unwrap_or_else(BigRational::zero);
        let skew = value_of(skews, index).cloned().unwrap_or_else(Turn::zero);
        let angle = &throw.angle.opposite() + &skew;
        let weight = &wholes[index] * factor;
        Weight {
            order: 1,
            sense: Sense::Direct,
            position: throw.position.clone(),
            vector: OrderSum::single(Factor::One, PhasorSum::new(vec![Term { angle, weight }])),
        }
    };
    throws.iter().enumerate().map(weight).filter(|weight| !weight.vector.vanishes()).collect()
}

fn value_of<T>(list: &[T], index: usize) -> Option<&T> {
    list.get(index).or(list.last())
}

/// D of each throw in multiples of m r; engines without numbers have their reciprocating masses only.
fn throw_weights(subject: &ComparableEngine, throws: &[Throw]) -> Vec<BigRational> {
    let engine = subject.engine();
    if let (Some([unit, _]), Some(wholes)) = (subject.scale(), engine.throw_mass_radii()) {
        return wholes.into_iter().map(|whole| whole / &unit).collect();
    }
    // Without a crank radius all masses are at the crankpins, and it cancels.
    let two = BigRational::from_integer(2.into());
    let unit = engine.unit_mass();
    let cylinder = |&at: &usize| {
        let cylinder = &engine.cylinders()[at];
        order::big_end(engine, cylinder) + order::mass_radius(engine, cylinder) / &two
    };
    let whole = |(index, throw): (usize, &Throw)| {
        let pin = engine.crankshaft().pins.get(index).map_or_else(BigRational::zero, |mass| mass / &unit);
        throw.cylinders.iter().map(cylinder).sum::<BigRational>() + pin * &throw.crank_radius
    };
    throws.iter().enumerate().map(whole).collect()
}

/// Weights in two planes that take a force P and its moment C about position 0 away:
/// `U_1 + U_2 = −P/2n²`, `z_1 U_1 + z_2 U_2 = −C/2n²` (theory, section 7, there for n = 1).
///
/// Weights of length zero are omitted. The planes must differ.
pub fn two_planes(
    order: u32,
    sense: Sense,
    force: &OrderSum,
    moment: &OrderSum,
    planes: &[BigRational; 2],
) -> Vec<Weight> {
    let [first, second] = planes;
    let size = (second - first) * doubled_square(order);
    let share = BigRational::one() / size;
    let at_first = moment.minus(&force.scaled(second)).scaled(&share);
    let at_second = force.scaled(first).minus(moment).scaled(&share);
    let weight = |position: &BigRational, vector: OrderSum| Weight { order, sense, position: position.clone(), vector };
    let weights = [weight(first, at_first), weight(second, at_second)];
    weights.into_iter().filter(|weight| !weight.vector.vanishes()).collect()
}

/// The one weight that takes both away, where the force acts in one plane: `C = z_0 P` with a rational position z_0.
pub fn one_plane(order: u32, sense: Sense, force: &OrderSum, moment: &OrderSum) -> Option<Weight> {
    let (factor, sum) = force.parts().iter().next()?;
    let fits = |position: &BigRational| moment.minus(&force.scaled(position)).vanishes();
    let position = match moment.parts().get(factor) {
        None => Some(BigRational::zero()).filter(fits),
        Some(arm) => ratio_of_terms(arm, sum).filter(fits).or_else(|| ratio_of_means(arm, sum).filter(fits)),
    }?;
    let vector = force.scaled(&-(BigRational::one() / doubled_square(order)));
    Some(Weight { order, sense, position, vector })
}

/// `z_0` where the sums are alike term by term: all that acts is in one plane.
fn ratio_of_terms(moment: &PhasorSum, force: &PhasorSum) -> Option<BigRational> {
    let first = force.collected().into_iter().next()?;
    let arm = moment.collected().into_iter().find(|term| term.angle == first.angle)?;
    Some(arm.weight / first.weight)
}

/// `C P̄ = z_0 |P|²`: the means of their conjugates are as z_0 to 1, or z_0 is not rational; up to conductor 1000.
fn ratio_of_means(moment: &PhasorSum, force: &PhasorSum) -> Option<BigRational> {
    let below = numbers::mean_of_conjugates(&force.squared_modulus()).filter(|mean| !mean.is_zero())?;
    Some(numbers::mean_of_conjugates(&moment.times(&force.conjugate()))? / below)
}
