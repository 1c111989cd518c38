//! Does the sum vanish nowhere? A Bézout identity modulo one prime shows it.
//!
//! With `|x| = 1` and `P(x) = 0` also `P*(x) = x^d conj(P(x)) = 0`, so that the resultant of P and P* is zero, and modulo every prime.
//! Where `UP + VP* ≡ 1` modulo a prime that keeps the leading coefficient of P it is not.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::polynomial::Polynomial;
use crate::exact::{PhasorSum, Term};

/// Evidence that a polynomial and its mirror image have no common zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coprime {
    /// How many times φ enters u.
    pub phi: BigRational,
    /// How many times δ enters u.
    pub delta: BigRational,
    /// A common denominator of the angles.
    pub conductor: u64,
    /// A prime that is 1 modulo the conductor.
    pub prime: u64,
    /// A number whose order modulo the prime is the conductor.
    pub root: u64,
    /// A common denominator of the weights.
    pub scale: BigInt,
    /// The coefficients of U, from the constant one on.
    pub u: Vec<u64>,
    /// The coefficients of V.
    pub v: Vec<u64>,
}

/// Longer identities are not written.
const HIGHEST_DEGREE: i64 = 64;
/// Primes for larger conductors are not looked for.
const LARGEST_CONDUCTOR: u64 = 1_000_000;
/// A small prime divides the resultant by accident.
const LEAST_PRIME: u64 = 10_000;
const PRIMES_TRIED: usize = 3;

/// The identity, if one of a few primes has it.
pub(super) fn prove(polynomial: &Polynomial) -> Option<Coprime> {
    let conductor = polynomial.conductor().to_u64().filter(|conductor| *conductor < LARGEST_CONDUCTOR)?;
    if polynomial.degree() > HIGHEST_DEGREE {
        return None;
    }
    let weights = polynomial.sums.iter().flat_map(PhasorSum::terms).map(|term| &term.weight);
    let scale = weights.fold(BigInt::one(), |scale, weight| scale.lcm(weight.denom()));
    let candidates = (LEAST_PRIME / conductor + 1..).map(|k| k * conductor + 1);
    let mut primes = candidates.filter(|&candidate| is_prime(candidate)).take(PRIMES_TRIED);
    primes.find_map(|prime| {
        let root = root_of_order(conductor, prime)?;
        let field = Field { conductor, prime, root, scale: &scale };
        let straight = field.image(polynomial, |sum| sum.clone());
        let mirrored = field.image(polynomial, PhasorSum::conjugate).into_iter().rev().collect();
        if straight.last().is_none_or(|leading| *leading == 0) {
            return None;
        }
        let (u, v) = field.bezout(straight, mirrored)?;
        let (phi, delta) = (polynomial.phi.clone(), polynomial.delta.clone());
        Some(Coprime { phi, delta, conductor, prime, root, scale: scale.clone(), u, v })
    })
}

fn is_prime(candidate: u64) -> bool {
    (2..).take_while(|d| d * d <= candidate).all(|d| !candidate.is_multiple_of(d))
}

fn root_of_order(order: u64, prime: u64) -> Option<u64> {
    let divides = |d: &u64| order.is_multiple_of(*d) && is_prime(*d);
    let divisors: Vec<u64> = (2..=order).filter(divides).collect();
    let candidates = (2..prime).map(|base| power(base, (prime - 1) / order, prime));
    candidates.take(1000).find(|root| divisors.iter().all(|q| power(*root, order / q, prime) != 1))
}

fn times(a: u64, b: u64, modulus: u64) -> u64 {
    let product = u128::from(a) * u128::from(b) % u128::from(modulus);
    product.to_u64().unwrap_or_else(|| unreachable!("a remainder is below its modulus"))
}

fn power(base: u64, exponent: u64, modulus: u64) -> u64 {
    let (mut result, mut base, mut exponent) = (1, base % modulus, exponent);
    while exponent > 0 {
        if exponent.is_odd() {
            result = times(result, base, modulus);
        }
        base = times(base, base, modulus);
        exponent /= 2;
    }
    result
}

/// The whole numbers modulo a prime, with an image of `e^{2πi/N}`.
struct Field<'a> {
    conductor: u64,
    prime: u64,
    root: u64,
    scale: &'a BigInt,
}

/// Coefficients from the constant one on, the last not 0.
type Coefficients = Vec<u64>;

impl Field<'_> {
    /// The coefficients, their zeros among them.
    fn image(&self, polynomial: &Polynomial, of: impl Fn(&PhasorSum) -> PhasorSum) -> Coefficients {
        let mut image = vec![0; polynomial.degree().to_usize().unwrap_or(0) + 1];
        for (exponent, sum) in polynomial.exponents.iter().zip(&polynomial.sums) {
            if let Some(place) = exponent.to_usize().and_then(|at| image.get_mut(at)) {
                *place = of(sum).terms().iter().fold(0, |total, term| (total + self.term(term)) % self.prime);
            }
        }
        image
    }

    fn term(&self, term: &Term) -> u64 {
        let angle = term.angle.turns() * BigRational::from_integer(self.conductor.into());
        let weight = &term.weight * BigRational::from_integer(self.scale.clone());
        let weight = weight.to_integer().mod_floor(&BigInt::from(self.prime)).to_u64().unwrap_or(0);
        times(weight, power(self.root, angle.to_integer().to_u64().unwrap_or(0), self.prime), self.prime)
    }

    /// U and V with `Ua + Vb = 1`, by Euclid's algorithm; `None` where the two have a common factor.
    fn bezout(&self, a: Coefficients, b: Coefficients) -> Option<(Coefficients, Coefficients)> {
        // Each row holds r, s, t with r = s·a + t·b.
        let mut upper = (trimmed(a), vec![1], Vec::new());
        let mut lower = (trimmed(b), Vec::new(), vec![1]);
        while !lower.0.is_empty() {
            let quotient = self.quotient(&upper.0, &lower.0);
            let next = |x: &Coefficients, y: &Coefficients| self.minus_product(x, &quotient, y);
            let rest = (next(&upper.0, &lower.0), next(&upper.1, &lower.1), next(&upper.2, &lower.2));
            (upper, lower) = (lower, rest);
        }
        let [constant] = upper.0.as_slice() else { return None };
        let inverse = power(*constant, self.prime - 2, self.prime);
        let scaled = |row: Coefficients| row.into_iter().map(|c| times(c, inverse, self.prime)).collect();
        Some((scaled(upper.1), scaled(upper.2)))
    }

    fn quotient(&self, dividend: &Coefficients, divisor: &Coefficients) -> Coefficients {
        let mut rest = dividend.clone();
        let leading = divisor.last().copied().unwrap_or_else(|| unreachable!("no division by zero"));
        let inverse = power(leading, self.prime - 2, self.prime);
        let mut quotient = vec![0; (dividend.len() + 1).saturating_sub(divisor.len())];
        for place in (0..quotient.len()).rev() {
            let factor = times(rest[place + divisor.len() - 1], inverse, self.prime);
            quotient[place] = factor;
            for (at, coefficient) in divisor.iter().enumerate() {
                let product = times(factor, *coefficient, self.prime);
                rest[place + at] = (rest[place + at] + self.prime - product) % self.prime;
            }
        }
        trimmed(quotient)
    }

    /// `x − q·y`.
    fn minus_product(&self, x: &Coefficients, q: &Coefficients, y: &Coefficients) -> Coefficients {
        let mut result = x.clone();
        result.resize(x.len().max(q.len() + y.len()), 0);
        for (i, a) in q.iter().enumerate() {
            for (j, b) in y.iter().enumerate() {
                result[i + j] = (result[i + j] + self.prime - times(*a, *b, self.prime)) % self.prime;
            }
        }
        trimmed(result)
    }
}

fn trimmed(mut coefficients: Coefficients) -> Coefficients {
    while coefficients.last().is_some_and(Zero::is_zero) {
        coefficients.pop();
    }
    coefficients
}
