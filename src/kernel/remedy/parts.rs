//! How is a weight written whose mass-radius is a sum? As parts along directions, which weigh together what the weight weighs.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};

use crate::engine::Counterweight;
use crate::exact::{PhasorSum, Term, Turn};
use crate::numbers::{self, Direction};

/// So many digits below the power of ten of a value.
pub fn power_of_ten_below(value: &BigRational, digits: i32) -> BigRational {
    let power = value.to_f64().filter(|value| *value > 0.0).map_or(0.0, |value| value.log10().floor());
    BigRational::from_integer(10.into()).pow(power as i32 - digits)
}

/// The step that the masses of parts are rounded up to, in kilograms: 10⁻⁵ of the power of ten below the mass m.
pub fn mass_step(mass: &BigRational) -> BigRational {
    power_of_ten_below(mass, 5)
}

/// A sum in as few terms as are found: one where its length and its direction are rational, which is decided exactly.
pub(super) fn in_few_terms(sum: &PhasorSum) -> Vec<Term> {
    let single = || {
        let weight = numbers::modulus(sum)?.as_rational()?;
        let Some(Direction::Turn(angle)) = numbers::direction_of(sum) else { return None };
        let single = PhasorSum::new(vec![Term { angle, weight }]);
        sum.minus(&single).vanishes().then(|| single.terms().to_vec())
    };
    single().unwrap_or_else(|| sum.on_lines())
}

/// Counterweights that have this mass-radius together, in kilogram-metres, at the place and the radius of the first.
///
/// One along a direction of its own is one weight; any other is written as parts along two directions (more where those of the
/// throws are no square or hexagon): their masses add up to that of the weight, and their common centre of gravity stands
/// at its place, within the radius. The mass is rounded up, so that it is never below `|U|/r`.
pub fn counterweight_parts(at: &Counterweight, mass_radius: &PhasorSum, step: &BigRational) -> Vec<Counterweight> {
    let terms = mass_radius.terms();
    if terms.is_empty() {
        return Vec::new();
    }
    let steps_of = |mass: BigRational| mass / step;
    let whole = steps_of(length_above(mass_radius) / &at.radius).ceil().to_integer();
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
        weights.push(Counterweight { angle, mass, radius, ..at.clone() });
    }
    weights
}

/// The length of a vector, or a little more.
fn length_above(sum: &PhasorSum) -> BigRational {
    if let [only] = sum.terms() {
        return only.weight.abs();
    }
    let [re, im] = numbers::enclose(sum, 128);
    let [re, im] = [re.largest(), im.largest()];
    let square = &re * &re + &im * &im;
    // A square root from above in steps of 2⁻⁹⁶.
    let bits = 96_u32;
    let scaled = (square * BigRational::from_integer(BigInt::one() << (2 * bits))).ceil().to_integer();
    BigRational::new(scaled.sqrt() + 1, BigInt::one() << bits)
}
