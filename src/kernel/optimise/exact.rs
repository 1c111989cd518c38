//! Which counterweights does a workshop make? Whole units of mass-radius, but for those that make force and couple vanish.

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};

use super::direction::Directions;
use super::place::Place;
use super::problem::Problem;
use crate::exact::PhasorSum;
use crate::remedy::{mass_step, power_of_ten_below};

/// The steps that mass-radii and masses are rounded to.
pub(super) struct Steps {
    /// In kilogram-metres: 10⁻⁴ of the power of ten below m r.
    pub mass_radius: BigRational,
    /// In kilograms, likewise from m.
    pub mass: BigRational,
}

impl Steps {
    pub fn new(unit: &BigRational, radius: &BigRational) -> Self {
        Steps { mass_radius: power_of_ten_below(unit, 4), mass: mass_step(&(unit / radius)) }
    }
}

/// Weights of fewer steps than this are what the solver leaves of none.
const NOTHING: f64 = 5.0;

/// The exact mass-radii in kilogram-metres, from those of a solution in multiples of m r.
///
/// All are rounded but those that have to hold the balance: two on each crankshaft where the couple has to vanish, one where it may stay. Those
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
    for shaft in 0..problem.shafts.len() {
        close(problem, places, shaft, weights, &mut exact);
    }
    exact.iter().map(|sum| directions.positive(sum)).collect()
}

/// Gives the closing weights of a crankshaft what the others leave to them.
fn close(problem: &Problem, places: &[Place], shaft: usize, weights: &[Complex<f64>], exact: &mut [PhasorSum]) {
    let size = |index: usize| weights[index].norm();
    let apart = |a: usize, b: usize| (problem.arms[a] - problem.arms[b]).abs();
    let own = problem.places_on(shaft);
    let pairs = own.clone().flat_map(|a| own.clone().filter(move |b| *b > a).map(move |b| (a, b)));
    let worth = |&(a, b): &(usize, usize)| size(a).min(size(b)) * apart(a, b) + 1e-12 * apart(a, b);
    let Some((one, other)) = pairs.max_by(|p, q| worth(p).total_cmp(&worth(q))) else { return };
    let heavier = if size(one) >= size(other) { one } else { other };
    let closing: &[usize] = if problem.most_couple.is_some() { &[heavier] } else { &[one, other] };
    // What the closing weights have to add: U_1 + U_2 = F, z_1 U_1 + z_2 U_2 = C.
    let left = &problem.shafts[shaft].exact;
    let [mut force, mut couple] = left.clone().map(|sum| sum.scaled(&-BigRational::one()));
    let reference = &places[one].position;
    let shifted = |place: usize| &places[place].position - reference;
    // The couple about the first of the two: C = C_0 − (z_1 − z_0) F.
    couple = couple.minus(&left[0].scaled(&-(reference - &problem.reference)));
    for index in own.filter(|index| !closing.contains(index)) {
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
}
