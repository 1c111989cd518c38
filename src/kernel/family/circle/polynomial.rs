//! Which polynomial is it in one unknown? Whole exponents without common divisor, phasor sums as coefficients.

use std::collections::BTreeSet;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::super::part::Part;
use crate::exact::{PhasorSum, Term, Turn, fraction};
use crate::proof::Certificate;

/// Sums in which the unknown enters more often than this are not solved.
const HIGHEST_DEGREE: i64 = 4096;

/// `Σ_j S_j x^{n_j}` with `x = e^{iu}`, `u = phi·φ + delta·δ`, up to a factor that is not zero.
#[derive(Clone, Debug)]
pub struct Polynomial {
    /// How many times φ enters u.
    pub phi: BigRational,
    /// How many times δ enters u: where φ does not, this is positive.
    pub delta: BigRational,
    /// `n_j`, rising from 0 on, without common divisor.
    pub exponents: Vec<i64>,
    /// `S_j`, collected; none is zero.
    pub sums: Vec<PhasorSum>,
}

impl Polynomial {
    /// That of parts in rising order, none of them zero; `None` where their multiples of φ and δ do not lie on one line, or
    /// where the degree is too high.
    pub(super) fn of(parts: &[&Part]) -> Option<Self> {
        let (first, others) = parts.split_first()?;
        let apart = |part: &Part| [&part.phi - &first.phi, &part.delta - &first.delta];
        let second = apart(others.first()?);
        // Along a line one coordinate tells the place; the parts rise, so that every place does.
        let axis = usize::from(second[0].is_zero());
        let mut places = vec![BigRational::zero()];
        for part in others {
            let apart = apart(part);
            if &apart[0] * &second[1] != &apart[1] * &second[0] {
                return None;
            }
            places.push(&apart[axis] / &second[axis]);
        }
        let unit = fraction::common_unit(&places);
        let exponents = places.iter().map(|place| (place / &unit).to_integer().to_i64());
        let exponents = exponents.collect::<Option<Vec<i64>>>()?;
        let in_range = exponents.iter().all(|exponent| (0..=HIGHEST_DEGREE).contains(exponent));
        let [phi, delta] = second.map(|times| times * &unit);
        let sums = parts.iter().map(|part| part.sum.tidied()).collect();
        in_range.then_some(Polynomial { phi, delta, exponents, sums })
    }

    /// The highest exponent.
    pub fn degree(&self) -> i64 {
        self.exponents.last().copied().unwrap_or(0)
    }

    /// A number that no value on the circle exceeds in size: the sum of all weights.
    pub(super) fn total(&self) -> BigRational {
        self.sums.iter().flat_map(PhasorSum::terms).map(|term| term.weight.abs()).sum()
    }

    /// The common denominator of all weights.
    pub(super) fn scale(&self) -> BigInt {
        fraction::common_denominator(self.sums.iter().flat_map(PhasorSum::terms).map(|term| &term.weight))
    }

    /// The common denominator of all angles.
    pub(super) fn conductor(&self) -> BigInt {
        fraction::common_denominator(self.sums.iter().flat_map(PhasorSum::terms).map(|term| term.angle.turns()))
    }

    /// Every zero that is a rational turn is a multiple of `1/L` for one of these L (theory, section 16).
    pub(super) fn moduli(&self) -> BTreeSet<BigInt> {
        let conductor = self.conductor();
        let is_prime = |p: &u64| *p > 1 && (2..*p).all(|d| !(*p).is_multiple_of(d));
        let missing = (2..=self.sums.len() as u64).filter(is_prime).map(BigInt::from);
        let missing = missing.filter(|prime| !conductor.is_multiple_of(prime));
        let base = missing.fold(conductor.clone(), |product, prime| product * prime);
        self.exponents.iter().skip(1).map(|exponent| &base * exponent).collect()
    }

    /// `Σ_j n_j^i S_j x^{n_j}` at a turn: up to a factor the i-th derivative along the circle.
    pub(super) fn derivative(&self, i: u32, at: &BigRational) -> PhasorSum {
        let terms = self.exponents.iter().zip(&self.sums).flat_map(|(&exponent, sum)| {
            let turned = Turn::new(at * BigRational::from_integer(exponent.into()));
            let factor = BigRational::from_integer(BigInt::from(exponent).pow(i));
            let term = move |term: &Term| Term { angle: &term.angle + &turned, weight: &term.weight * &factor };
            sum.terms().iter().map(term)
        });
        PhasorSum::new(terms.collect()).tidied()
    }

    /// Evidence that `e^{−idu/2}` times the polynomial stays on one line through 0, d its degree: `conj(S_{k−1−j}) S_{k−1} −
    /// conj(S_0) S_j` is zero for every j whose exponent is at most d/2. `None` where it does not stay on one.
    pub(super) fn mirrored(&self) -> Option<Vec<Certificate>> {
        let (degree, last) = (self.degree(), self.sums.len() - 1);
        let pairs = self.exponents.iter().zip(self.exponents.iter().rev());
        if pairs.into_iter().any(|(low, high)| low + high != degree) {
            return None;
        }
        let half = self.exponents.iter().take_while(|exponent| *exponent * 2 <= degree).count();
        let difference = |j: usize| {
            let outer = self.sums[last - j].conjugate().times(&self.sums[last]);
            outer.minus(&self.sums[0].conjugate().times(&self.sums[j]))
        };
        let certificates: Vec<Certificate> = (0..half).map(|j| difference(j).tidied().certificate()).collect();
        certificates.iter().all(Certificate::claims_zero).then_some(certificates)
    }
}
