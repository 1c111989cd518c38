//! Where does a sum point exactly? A rational turn, or an arctangent.

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::banks::{self, Split};
use super::budget::Budget;
use super::closed::real;
use super::evaluate::evaluate;
use super::form::Form;
use super::quadratic;
use super::radicals::{as_sum, number};
use super::rational_direction::rational_direction;
use super::star::Star;
use super::trace::mean_of_conjugates;
use crate::exact::{PhasorSum, Turn};

/// A tangent of more roots is shorter as a decimal.
const MOST_ROOTS: usize = 2;

/// Direction of a sum that is not zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Direction {
    /// A rational turn.
    Turn(Turn),
    /// `arctan(tangent)`, and half a turn more where `opposite`.
    Arctangent {
        /// The tangent of the angle.
        tangent: Form,
        /// Whether the direction has a negative real part.
        opposite: bool,
    },
    /// That of the star of one bank, and a rational turn more.
    Turned {
        /// The turn more, with half a turn where the star of one bank has a negative real part.
        by: Turn,
        /// The tangent of the direction of the star of one bank.
        tangent: Form,
    },
}

/// The direction of a sum that is not zero, in closed form where it is a rational turn, or has a tangent of
/// one or two roots or a real part of degree up to 2, or is a rational turn off such a direction as the banks of a V are.
pub fn direction_of(sum: &PhasorSum) -> Option<Direction> {
    if let Some(turn) = rational_direction(sum) {
        return Some(Direction::Turn(turn));
    }
    match tangent_of(sum) {
        Some(tangent) => Some(Direction::Arctangent { tangent, opposite: evaluate(sum).re < 0.0 }),
        None => of_banks(sum),
    }
}

fn tangent_of(sum: &PhasorSum) -> Option<Form> {
    let mirrored = sum.conjugate();
    let (twice_re, twice_im) = (sum.plus(&mirrored), sum.minus(&mirrored).turned(&Turn::fraction(3, 4)));
    of_few_roots(sum, &twice_re, &twice_im).or_else(|| by_conjugate(&twice_re, &twice_im))
}

/// The direction of the star of one bank and that of the bank factor, a rational turn.
fn of_banks(sum: &PhasorSum) -> Option<Direction> {
    let (mut star, mut by, mut budget) = (Star::of(sum)?, Turn::zero(), Budget::new());
    while let Some(Split { bank, turn, .. }) = banks::split(&star, &mut budget) {
        // Turned to its first vector the star of a bank lies in the smallest field.
        let first = bank.terms.first().map_or(0, |(exponent, _)| *exponent);
        by = &(&by + &turn) + &Turn::new(BigRational::new(first.into(), bank.conductor.into()));
        star = bank.turned_to_first();
        let sum = star.to_sum();
        if let Some(tangent) = tangent_of(&sum) {
            let by = if evaluate(&sum).re < 0.0 { by.opposite() } else { by };
            return Some(Direction::Turned { by, tangent });
        }
    }
    None
}

/// A tangent of one or two roots, proposed from its conjugates.
fn of_few_roots(sum: &PhasorSum, twice_re: &PhasorSum, twice_im: &PhasorSum) -> Option<Form> {
    let star = Star::of(sum)?.over_fourths();
    // i ↦ i^a: the imaginary part changes its sign with a ≡ 3 (mod 4).
    let tangent = |(value, unit): (Complex<f64>, u64)| {
        let tangent = value.im / value.re;
        if unit % 4 == 3 { -tangent } else { tangent }
    };
    let units = star.units();
    let tangents: Vec<f64> = star.conjugates().into_iter().zip(units.iter().copied()).map(tangent).collect();
    let tangent = quadratic::propose(&tangents, &units, star.conductor, quadratic::fraction)?;
    if tangent.terms().len() > MOST_ROOTS {
        return None;
    }
    twice_im.minus(&twice_re.times(&as_sum(&tangent)?)).vanishes().then_some(tangent)
}

/// `tan = Im/Re = Im·R'/(Re·R')`, with R' the conjugate that makes the denominator rational, where Re has one or two.
fn by_conjugate(twice_re: &PhasorSum, twice_im: &PhasorSum) -> Option<Form> {
    let star = Star::of(twice_re)?;
    let values: Vec<f64> = star.conjugates().into_iter().map(|value| value.re).collect();
    let differs = |value: f64| (value / values[0] - 1.0).abs() > 1e-9;
    let place = values.iter().position(|&value| differs(value)).unwrap_or(0);
    let is_third = |value: f64| differs(value) && (value / values[place] - 1.0).abs() > 1e-9;
    if values.iter().any(|&value| is_third(value)) {
        return None;
    }
    let whole = star.to_sum();
    let partner = match place {
        0 => number(BigRational::one()),
        _ => whole.galois(star.units()[place].to_i64()?),
    };
    let product = whole.times(&partner);
    let denominator = mean_of_conjugates(&product).filter(|mean| !mean.is_zero())?;
    if !product.minus(&number(denominator.clone())).vanishes() {
        return None;
    }
    real(&twice_im.times(&partner).scaled(&(denominator * star.unit).recip()))
}
