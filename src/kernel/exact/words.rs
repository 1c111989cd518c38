//! What does a sum look like in machine words? Over one denominator, with whole weights, where all of it fits.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::Signed;
use smallvec::SmallVec;

use super::term::Term;
use super::terms::Terms;

/// The sum `Σ weight · e^{2πi·exponent/conductor}`, scaled by `scale` to whole weights; like directions not collected.
pub(super) struct Words {
    /// The common denominator of the angles, below 2⁶³.
    pub conductor: u64,
    /// What the rational weights were multiplied by to make them whole.
    pub scale: i64,
    /// `(exponent, weight)`, each exponent below the conductor, the sum of the moduli of all weights below 2⁶³.
    pub terms: Terms<u64, i64>,
}

/// Terms whose polygons are found in words.
const MOST_TERMS: usize = 24;

impl Words {
    /// The sum in words; none where a number is too long.
    pub fn of(terms: &[Term]) -> Option<Self> {
        let (mut conductor, mut scale) = (1, 1);
        // Each number is read once: exponent and its denominator, weight and its.
        let mut read: SmallVec<[(u64, u64, i64, u64); 16]> = SmallVec::with_capacity(terms.len());
        for Term { angle, weight } in terms {
            let (part, whole) = (word(angle.turns().numer())?, word(angle.denominator())?);
            let (over, under) = (signed(weight.numer())?, word(weight.denom())?);
            conductor = common(conductor, whole)?;
            scale = common(scale, under)?;
            read.push((part, whole, over, under));
        }
        let mut total = 0_i64;
        let mut words = Terms::with_capacity(terms.len());
        for (part, whole, over, under) in read {
            let weight = over.checked_mul(i64::try_from(quotient(scale, under)).ok()?)?;
            total = total.checked_add(weight.checked_abs()?)?;
            words.push((part * quotient(conductor, whole), weight));
        }
        Some(Words { conductor, scale: i64::try_from(scale).ok()?, terms: words })
    }

    /// Whether the search for polygons stays within words, too.
    ///
    /// A comparison of classes modulo `p` makes the sum of all moduli at most `1 + p` times as large, once for each prime up to the
    /// number of terms: up to 24 less than 2³⁰ times. Exponents stay below four times the conductor.
    pub fn leave_room(&self) -> bool {
        let total: i64 = self.terms.iter().map(|(_, weight)| weight.abs()).sum();
        self.terms.len() <= MOST_TERMS && self.conductor < 1 << 60 && total < 1 << 31
    }
}

/// The least common multiple of two numbers, below 2⁶³.
fn common(one: u64, other: u64) -> Option<u64> {
    // A division takes longer than all else here, and most denominators are alike or 1.
    if one == other || other == 1 || one.is_multiple_of(other) {
        return Some(one);
    }
    (one / one.gcd(&other)).checked_mul(other).filter(|multiple| *multiple <= i64::MAX as u64)
}

/// The quotient of a multiple.
fn quotient(multiple: u64, part: u64) -> u64 {
    if multiple == part { 1 } else { multiple / part }
}

/// The modulus of a number of one word.
fn word(number: &BigInt) -> Option<u64> {
    let mut digits = number.iter_u64_digits();
    let word = digits.next().unwrap_or(0);
    (digits.len() == 0).then_some(word)
}

/// A number of one word with its sign.
fn signed(number: &BigInt) -> Option<i64> {
    let modulus = i64::try_from(word(number)?).ok()?;
    Some(if number.is_negative() { -modulus } else { modulus })
}
