//! How are polynomials computed modulo a prime? Whole numbers below it, and an image of `e^{2πi/N}` among them.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::polynomial::Polynomial;
use crate::exact::modulo::{has_order, multiply, power, prime_divisors};
use crate::exact::{PhasorSum, Term};

/// A number whose powers up to this one are not 1 before it.
pub(super) fn root_of_order(order: u64, prime: u64) -> Option<u64> {
    let divisors = prime_divisors(order);
    let candidates = (2..prime).map(|base| power(base, (prime - 1) / order, prime));
    candidates.take(1000).find(|root| has_order(*root, order, &divisors, prime))
}

/// The whole numbers modulo a prime, with an image of `e^{2πi/N}`.
pub(super) struct Field<'a> {
    pub conductor: u64,
    pub prime: u64,
    /// The image of `e^{2πi/N}`.
    pub root: u64,
    /// What makes all weights whole.
    pub scale: &'a BigInt,
}

/// Coefficients from the constant one on.
pub(super) type Coefficients = Vec<u64>;

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

    /// The images of both a polynomial and its mirror image.
    pub fn images(&self, polynomial: &Polynomial) -> [Coefficients; 2] {
        let mirrored = self.image(polynomial, PhasorSum::conjugate).into_iter().rev().collect();
        [self.image(polynomial, PhasorSum::clone), mirrored]
    }

    fn term(&self, term: &Term) -> u64 {
        let angle = term.angle.turns() * BigRational::from_integer(self.conductor.into());
        let weight = &term.weight * BigRational::from_integer(self.scale.clone());
        let weight = weight.to_integer().mod_floor(&BigInt::from(self.prime)).to_u64().unwrap_or(0);
        multiply(weight, power(self.root, angle.to_integer().to_u64().unwrap_or(0), self.prime), self.prime)
    }

    /// U and V with `Ua + Vb = 1`, by Euclid's algorithm; `None` where the two have a common factor.
    pub fn bezout(&self, a: Coefficients, b: Coefficients) -> Option<(Coefficients, Coefficients)> {
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
        let scaled = |row: Coefficients| row.into_iter().map(|c| multiply(c, inverse, self.prime)).collect();
        Some((scaled(upper.1), scaled(upper.2)))
    }

    /// The greatest common divisor, its leading coefficient 1.
    pub fn common(&self, a: &Coefficients, b: &Coefficients) -> Coefficients {
        let (mut upper, mut lower) = (trimmed(a.clone()), trimmed(b.clone()));
        while !lower.is_empty() {
            let rest = self.minus_product(&upper, &self.quotient(&upper, &lower), &lower);
            (upper, lower) = (lower, rest);
        }
        let inverse = power(upper.last().copied().unwrap_or(1), self.prime - 2, self.prime);
        upper.into_iter().map(|coefficient| multiply(coefficient, inverse, self.prime)).collect()
    }

    /// The derivative by x.
    pub fn derivative(&self, a: &Coefficients) -> Coefficients {
        trimmed((1..).zip(a.iter().skip(1)).map(|(n, coefficient)| multiply(n, *coefficient, self.prime)).collect())
    }

    /// Without its rest.
    pub fn quotient(&self, dividend: &Coefficients, divisor: &Coefficients) -> Coefficients {
        let mut rest = dividend.clone();
        let leading = divisor.last().copied().unwrap_or_else(|| unreachable!("no division by zero"));
        let inverse = power(leading, self.prime - 2, self.prime);
        let mut quotient = vec![0; (dividend.len() + 1).saturating_sub(divisor.len())];
        for place in (0..quotient.len()).rev() {
            let factor = multiply(rest[place + divisor.len() - 1], inverse, self.prime);
            quotient[place] = factor;
            for (at, coefficient) in divisor.iter().enumerate() {
                let product = multiply(factor, *coefficient, self.prime);
                rest[place + at] = (rest[place + at] + self.prime - product) % self.prime;
            }
        }
        trimmed(quotient)
    }

    /// `x − q·y`.
    pub fn minus_product(&self, x: &Coefficients, q: &Coefficients, y: &Coefficients) -> Coefficients {
        let mut result = x.clone();
        result.resize(x.len().max(q.len() + y.len()), 0);
        for (i, a) in q.iter().enumerate() {
            for (j, b) in y.iter().enumerate() {
                result[i + j] = (result[i + j] + self.prime - multiply(*a, *b, self.prime)) % self.prime;
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
