//! Which polynomial in one unknown are the parts of a sum? Found anew from what the parts say.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::audit::{Audit, Reason, demand, steps_of};
use super::collected::{Collected, collect, common_multiple};
use super::part::Part;
use super::whole::is_prime;

/// Higher exponents are not read.
pub(super) const HIGHEST_EXPONENT: i64 = 4096;

/// `Σ_j S_j x^{n_j}`, with `n_0 = 0`.
pub(super) struct Unknown<'a> {
    /// `n_j`, rising.
    pub exponents: Vec<i64>,
    /// `S_j`; none is zero.
    pub sums: Vec<&'a Collected>,
}

impl<'a> Unknown<'a> {
    /// With `x = e^{i(phi·φ + delta·δ)}`.
    pub fn of(left: &'a [Part<'a>], phi: &BigRational, delta: &BigRational, audit: &Audit) -> Result<Self, Reason> {
        let [first, _, ..] = left else {
            return Err(format!("{} parts do not vanish, which contradicts `when`", left.len()).into());
        };
        if !is_positive([phi, delta]) {
            return Err("the unknown enters with φ taken a positive number of times, or not at all and δ so".into());
        }
        let mut exponents = Vec::new();
        for part in left {
            let apart = part.turned_against(first);
            audit.spend(steps_of(&apart[0]) + steps_of(&apart[1]))?;
            let times = whole_times(&apart, [phi, delta]);
            let times = times.ok_or("a part is not turned by a whole multiple of the unknown")?;
            let times = times.to_i64().filter(|times| *times <= HIGHEST_EXPONENT);
            exponents.push(times.ok_or_else(|| format!("the unknown enters more than {HIGHEST_EXPONENT} times"))?);
        }
        if !exponents.is_sorted_by(|a, b| a < b) || exponents.iter().fold(0, |all, n| n.gcd(&all)) != 1 {
            return Err("the parts do not turn by rising multiples of the unknown without a common divisor".into());
        }
        Ok(Unknown { exponents, sums: left.iter().map(Part::sum).collect() })
    }

    pub fn degree(&self) -> i64 {
        self.exponents.last().copied().unwrap_or(0)
    }

    /// `Σ_j n_j^i S_j x^{n_j}` at a turn.
    pub fn derivative(&self, i: u32, at: &BigRational, audit: &Audit) -> Result<Collected, Reason> {
        let mut terms = Vec::new();
        for (&exponent, sum) in self.exponents.iter().zip(&self.sums) {
            let turned = at * BigRational::from_integer(exponent.into());
            let factor = BigRational::from_integer(BigInt::from(exponent).pow(i));
            audit.spend((sum.len() as u64).saturating_mul(steps_of(&turned) + steps_of(&factor)))?;
            terms.extend(sum.iter().map(|(angle, weight)| (angle + &turned, weight * &factor)));
        }
        Ok(collect(terms, audit)?)
    }

    /// `conj(S_{k−1−j}) S_{k−1} − conj(S_0) S_j` for every j whose exponent is at most half the degree; all of them are zero iff the
    /// sum, turned back by half of the degree, stays on one line.
    pub fn against_mirror(&self, audit: &Audit) -> Result<Vec<Collected>, Reason> {
        let degree = self.degree();
        if self.exponents.iter().zip(self.exponents.iter().rev()).any(|(low, high)| low + high != degree) {
            return Err("the multiples of the unknown are not their own mirror image".into());
        }
        let last = self.sums.len() - 1;
        let half = self.exponents.iter().take_while(|exponent| **exponent * 2 <= degree).count();
        let difference = |j: usize| {
            let mut terms = product(self.sums[last - j], self.sums[last], audit)?;
            let inner = product(self.sums[0], self.sums[j], audit)?;
            terms.extend(inner.into_iter().map(|(angle, weight)| (angle, -weight)));
            Ok(collect(terms, audit)?)
        };
        (0..half).map(difference).collect()
    }

    /// Each zero that is a rational turn is a multiple of `1/L` for one of these L: N times the primes up to the number of parts that
    /// do not divide it, times an exponent (theory, section 16).
    pub fn moduli(&self, audit: &Audit) -> Result<Vec<BigInt>, Reason> {
        let mut modulus = BigInt::one();
        for angle in self.sums.iter().flat_map(|sum| sum.keys()) {
            audit.spend(steps_of(angle) + steps_of(&BigRational::from_integer(modulus.clone())))?;
            modulus = common_multiple(&modulus, angle.denom());
        }
        let conductor = modulus.clone();
        for prime in (2..=self.sums.len() as u64).filter(|candidate| is_prime(*candidate)) {
            if !(&conductor % prime).is_zero() {
                modulus *= prime;
            }
        }
        Ok(self.exponents.iter().skip(1).map(|exponent| &modulus * exponent).collect())
    }
}

/// What is said of a part that is turned otherwise within its class.
pub(super) const NOT_WHOLE: &str = "a part is not turned against its class by a whole multiple of u";

/// Checks that `u = phi·φ + delta·δ` is said in one way.
pub(super) fn check_positive(u: [&BigRational; 2]) -> Result<(), &'static str> {
    demand(is_positive(u), "u takes φ a positive number of times, or not at all and δ so")
}

fn is_positive([phi, delta]: [&BigRational; 2]) -> bool {
    phi.is_positive() || phi.is_zero() && delta.is_positive()
}

/// How many times an angle is u, where that is a whole number of times.
pub(super) fn whole_times(angle: &[BigRational; 2], [phi, delta]: [&BigRational; 2]) -> Option<BigInt> {
    let times = if phi.is_zero() { &angle[1] / delta } else { &angle[0] / phi };
    (*angle == [phi * &times, delta * &times] && times.is_integer()).then(|| times.to_integer())
}

/// `conj(A)·B`, not collected.
pub(super) fn product(a: &Collected, b: &Collected, audit: &Audit) -> Result<Vec<(BigRational, BigRational)>, Reason> {
    times(a, b, |s, t| t - s, audit)
}

/// Each term of a sum times each of another, their angles taken together so.
pub(super) fn times(
    a: &Collected,
    b: &Collected,
    together: impl Fn(&BigRational, &BigRational) -> BigRational,
    audit: &Audit,
) -> Result<Vec<(BigRational, BigRational)>, Reason> {
    let mut terms = Vec::new();
    for (s, v) in a {
        for (t, w) in b {
            audit.spend(steps_of(s).max(steps_of(v)).max(steps_of(t)).max(steps_of(w)))?;
            terms.push((together(s, t), v * w));
        }
    }
    Ok(terms)
}

/// The terms of a class at a turn of its unknown, not collected.
pub(super) fn turned<'a>(
    class: impl Iterator<Item = (i64, &'a Collected)>,
    turn: &BigRational,
    audit: &Audit,
) -> Result<Vec<(BigRational, BigRational)>, Reason> {
    let mut terms = Vec::new();
    for (times, sum) in class {
        let turned = turn * BigRational::from_integer(times.into());
        audit.spend((sum.len() as u64).saturating_mul(steps_of(&turned)))?;
        terms.extend(sum.iter().map(|(angle, weight)| (angle + &turned, weight.clone())));
    }
    Ok(terms)
}
