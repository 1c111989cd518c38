//! Which numbers over a conductor have these images modulo primes? Put together prime by prime, until they are small fractions.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::field::{Coefficients, Field};
use crate::exact::modulo::{multiply, power};
use crate::exact::{PhasorSum, Term, Turn};

/// Polynomials, by the coefficients of `e^{2πij/N}` in their coefficients, j below φ(N), modulo a product of primes.
pub(super) struct Images {
    /// How many coefficients each polynomial has.
    pub shape: Vec<usize>,
    modulus: BigInt,
    numbers: Vec<BigInt>,
}

impl Images {
    /// From the polynomials under every `e^{2πi/N} ↦ root^a`, a prime to N: for each such a one list, all of one shape.
    pub fn of(field: &Field<'_>, units: &[u64], lists: &[Vec<Coefficients>]) -> Option<Self> {
        let shape: Vec<usize> = lists.first()?.iter().map(Vec::len).collect();
        if lists.iter().any(|list| !list.iter().map(Vec::len).eq(shape.iter().copied())) {
            return None;
        }
        let interpolation = Interpolation::new(field, units);
        let mut numbers = Vec::new();
        for (at, length) in shape.iter().enumerate() {
            for place in 0..*length {
                let values: Vec<u64> = lists.iter().map(|list| list[at][place]).collect();
                numbers.extend(interpolation.through(&values).into_iter().map(BigInt::from));
            }
        }
        Some(Images { shape, modulus: field.prime.into(), numbers })
    }

    /// Which images are nearer to the truth: a prime by accident makes a common factor larger, or factors equal.
    pub fn rank(&self) -> [usize; 2] {
        let first = self.shape.first().copied().unwrap_or(0);
        [first, self.shape.iter().skip(1).map(|length| length - 1).sum()]
    }

    /// With those modulo one more prime (Chinese remainders).
    pub fn and(self, other: &Images) -> Images {
        let inverse = self.modulus.mod_floor(&other.modulus).modpow(&(&other.modulus - 2), &other.modulus);
        let both = |(own, others): (&BigInt, &BigInt)| {
            own + &self.modulus * ((others - own) * &inverse).mod_floor(&other.modulus)
        };
        let numbers = self.numbers.iter().zip(&other.numbers).map(both).collect();
        Images { numbers, modulus: &self.modulus * &other.modulus, shape: self.shape }
    }

    /// The polynomials with the smallest fractions of these images; `None` where there are none.
    pub fn polynomials(&self, conductor: u64) -> Option<Vec<Vec<PhasorSum>>> {
        let all: usize = self.shape.iter().sum();
        let mut sums = self.numbers.chunks(self.numbers.len().checked_div(all)?).map(|numbers| {
            let term = |(j, number): (u64, &BigInt)| {
                let angle = Turn::new(BigRational::new(j.into(), conductor.into()));
                Some(Term { angle, weight: fraction(number, &self.modulus)? })
            };
            let terms = (0..).zip(numbers).map(term).collect::<Option<Vec<Term>>>()?;
            Some(PhasorSum::new(terms).tidied())
        });
        self.shape.iter().map(|length| sums.by_ref().take(*length).collect()).collect()
    }
}

/// The fraction with this image whose parts are both small: where Euclid's algorithm is half done (Wang 1981).
fn fraction(image: &BigInt, modulus: &BigInt) -> Option<BigRational> {
    let most = (modulus / 2_u8).sqrt();
    let (mut upper, mut lower) = ((modulus.clone(), BigInt::zero()), (image.clone(), BigInt::one()));
    while lower.0 > most {
        let quotient = &upper.0 / &lower.0;
        let next = (&upper.0 - &quotient * &lower.0, &upper.1 - &quotient * &lower.1);
        (upper, lower) = (lower, next);
    }
    let fits = !lower.1.is_zero() && lower.1.abs() <= most && lower.0.gcd(&lower.1).is_one();
    fits.then(|| BigRational::new(lower.0, lower.1))
}

/// The one polynomial in `e^{2πi/N}`, of lower degree than φ(N), with given values at the `root^a`.
struct Interpolation<'a> {
    field: &'a Field<'a>,
    units: &'a [u64],
    powers: Vec<u64>,
    /// `Π (x − root^a)`: the cyclotomic polynomial.
    cyclotomic: Coefficients,
}

impl<'a> Interpolation<'a> {
    fn new(field: &'a Field<'a>, units: &'a [u64]) -> Self {
        let powers: Vec<u64> = (0..field.conductor).map(|j| power(field.root, j, field.prime)).collect();
        let at = |a: u64| (a % field.conductor).to_usize().map_or(1, |place| powers[place]);
        let minus_one = [field.prime - 1];
        let cyclotomic = units.iter().fold(minus_one.to_vec(), |product, a| {
            // Subtracting from nothing changes the sign each time; in the end the leading coefficient is made 1.
            field.minus_product(&Vec::new(), &product, &vec![field.prime - at(*a), 1])
        });
        let sign = cyclotomic.last().copied().unwrap_or(1);
        let cyclotomic = cyclotomic.into_iter().map(|c| multiply(c, sign, field.prime)).collect();
        Interpolation { field, units, powers, cyclotomic }
    }

    fn through(&self, values: &[u64]) -> Coefficients {
        let (conductor, prime) = (self.field.conductor, self.field.prime);
        let inverse = power(conductor, prime - 2, prime);
        // The inverse transform, with 0 at all other roots of x^N − 1.
        let coefficient = |j: u64| {
            let term = |(a, value): (&u64, &u64)| {
                let back = ((conductor - a % conductor) * j % conductor).to_usize().unwrap_or(0);
                multiply(*value, self.powers[back], prime)
            };
            let sum = self.units.iter().zip(values).map(term).fold(0, |sum, next| (sum + next) % prime);
            multiply(sum, inverse, prime)
        };
        let whole: Coefficients = (0..conductor).map(coefficient).collect();
        let quotient = self.field.quotient(&whole, &self.cyclotomic);
        let mut rest = self.field.minus_product(&whole, &quotient, &self.cyclotomic);
        rest.resize(self.units.len(), 0);
        rest
    }
}
