//! At which rational turn does a sum point, if at any?

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::evaluate::evaluate;
use crate::exact::{PhasorSum, Turn, fraction};

/// Among more directions than this the decimals cannot name the one candidate.
const MOST_DIRECTIONS: i64 = 1 << 40;

/// S points to a rational turn t iff `e^{2πi·2t} = S/S̄` is a root of unity of its field. The decimals only name the
/// one candidate; whether it is right is decided exactly.
pub(super) fn rational_direction(sum: &PhasorSum) -> Option<Turn> {
    let collected = sum.collected();
    if let [only] = collected.as_slice() {
        let angle = if only.weight < BigRational::zero() { only.angle.opposite() } else { only.angle.clone() };
        return Some(angle);
    }
    let conductor = fraction::common_denominator(collected.iter().map(|term| term.angle.turns()));
    let parts: BigInt = conductor.lcm(&BigInt::from(2)) * 2;
    let parts = parts.to_i64().filter(|&parts| parts <= MOST_DIRECTIONS)?;
    let turns = evaluate(sum).arg() / std::f64::consts::TAU * parts as f64;
    let nearest = turns.round();
    if (turns - nearest).abs() > 1e-3 {
        return None;
    }
    let candidate = Turn::fraction(nearest.to_i64()?, parts);
    let upright = sum.turned(&-&candidate);
    upright.minus(&upright.conjugate()).vanishes().then_some(candidate)
}
