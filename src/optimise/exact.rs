//! Which counterweights does a workshop make? Whole units of mass-radius, but for those that make force and couple vanish.

use num_bigint::BigInt;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};

use super::direction::Directions;
use super::place::Place;
use super::problem::Problem;
use crate::engine::Counterweight;
use crate::exact::{PhasorSum, Turn};
use crate::numbers;

/// The steps that mass-radii and masses are rounded to.
pub(super) struct Steps {
    /// In kilogram-metres: 10⁻⁴ of the power of ten below m r.
    pub mass_radius: BigRational,
    /// In kilograms, likewise from m.
    pub mass: BigRational,
}

impl Steps {
    pub fn new(unit: &BigRational, radius: &BigRational) -> Self {
        let below = |value: &BigRational, digits: i32| {
            let power = value.to_f64().filter(|value| *value > 0.0).map_or(0.0, |value| value.log10().floor());
            BigRational::from_integer(10.into()).pow(power as i32 - digits)
        };
        Steps { mass_radius: below(unit, 4), mass: below(&(unit / radius), 5) }
    }
}

/// Weights of fewer steps than this are what the solver leaves of none.
const NOTHING: f64 = 5.0;

/// The exact mass-radii in kilogram-metres, from those of a solution in multiples of m r.
///
/// All are rounded but those that have to hold the balance: two where the couple has to vanish, one where it may stay. Those
/// are chosen where they are heaviest and farthest apart, so that what they take over is little.
pub(super) fn mass_radii(
    problem: &Problem,
    places: &[Place],
    directions: &Directions,
    steps: &Steps,
    weights: &[Complex<f64>],
) -> Vec<PhasorSum> {
    let unit = problem.unit.to_f64().unwrap_or(1.0);
    // Where the couple is bounded, what is dropped would count against the bound.
    let nothing = if problem.most_couple.is_some() { 0.0 } else { NOTHING };
    let least = nothing * steps.mass_radius.to_f64().unwrap_or(0.0);
    let rounded = |weight: &Complex<f64>| match weight.norm() * unit < least {
        true => PhasorSum::new(Vec::new()),
        false => directions.rounded(weight * unit, &steps.mass_radius),
    };
    let mut exact: Vec<PhasorSum> = weights.iter().map(rounded).collect();
    let size = |index: usize| weights[index].norm();
    let apart = |a: usize, b: usize| (problem.arms[a] - problem.arms[b]).abs();
    let pairs = (0..places.len()).flat_map(|a| (a + 1..places.len()).map(move |b| (a, b)));
    let worth = |&(a, b): &(usize, usize)| size(a).min(size(b)) * apart(a, b) + 1e-12 * apart(a, b);
    let Some((one, other)) = pairs.max_by(|p, q| worth(p).total_cmp(&worth(q))) else { return exact };
    let heavier = if size(one) >= size(other) { one } else { other };
    let closing: &[usize] = if problem.most_couple.is_some() { &[heavier] } else { &[one, other] };
    // What the closing weights have to add: U_1 + U_2 = F, z_1 U_1 + z_2 U_2 = C.
    let [mut force, mut couple] = problem.exact.clone().map(|sum| sum.scaled(&-BigRational::one()));
    let reference = &places[one].position;
    let shifted = |place: usize| &places[place].position - reference;
    // The couple about the first of the two: C = C_0 − (z_1 − z_0) F.
    couple = couple.minus(&problem.exact[0].scaled(&-(reference - &problem.reference)));
    for index in (0..places.len()).filter(|index| !closing.contains(index)) {
        force = force.minus(&exact[index]);
        couple = couple.minus(&exact[index].scaled(&shifted(index)));
    }
    match closing {
        [one, other] => {
            exact[*other] = couple.scaled(&shifted(*other).recip());
            exact[*one] = force.minus(&exact[*other]);
        }
        _ => exact[heavier] = force,
    }
    exact.iter().map(|sum| directions.positive(sum)).collect()
}

/// Counterweights that have this mass-radius together.
///
/// One along a direction of its own is one weight; any other is written as parts along two directions (more where those of the
/// throws are no square or hexagon): their masses add up to that of the weight, and their common centre of gravity stands
/// at its place, within the radius. The mass is rounded up, so that it is never below `|U|/r`.
pub(super) fn counterweights(place: &Place, mass_radius: &PhasorSum, step: &BigRational) -> Vec<Counterweight> {
    let terms = mass_radius.terms();
    if terms.is_empty() {
        return Vec::new();
    }
    let steps_of = |mass: BigRational| mass / step;
    let whole = steps_of(length_above(mass_radius) / &place.radius).ceil().to_integer();
    let count = terms.len().into();
    let whole = whole.max(count);
    let all: BigRational = terms.iter().map(|term| term.weight.clone()).sum();
    let mut left = whole.clone();
    let mut weights = Vec::new();
    for (index, term) in terms.iter().enumerate() {
        let last = index + 1 == terms.len();
        let behind: BigInt = (terms.len() - index - 1).into();
        let share = (BigRational::from_integer(whole.clone()) * &term.weight / &all).floor().to_integer();
        let share = if last { left.clone() } else { share.max(One::one()).min(&left - behind) };
        left -= &share;
        let mass = BigRational::from_integer(share) * step;
        let radius = &term.weight / &mass;
        let angle: Turn = term.angle.clone();
        weights.push(Counterweight { throw: None, angle, mass, radius, position: place.position.clone(), crank: 0 });
    }
    weights
}

/// The length of a vector, or a little more.
fn length_above(sum: &PhasorSum) -> BigRational {
    if let [only] = sum.terms() {
        return only.weight.abs();
    }
    let [re, im] = numbers::enclose(sum, 128);
    let square = |(low, high): &(BigRational, BigRational)| {
        let largest = if low.abs() > high.abs() { low.abs() } else { high.abs() };
        &largest * &largest
    };
    let square = square(&re) + square(&im);
    // A square root from above in steps of 2⁻⁹⁶.
    let bits = 96_u32;
    let scaled = (square * BigRational::from_integer(BigInt::one() << (2 * bits))).ceil().to_integer();
    BigRational::new(scaled.sqrt() + 1, BigInt::one() << bits)
}
