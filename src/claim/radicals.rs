//! Which sum of rotating vectors is this real number? So that a claimed value is compared exactly, with a certificate.
//!
//! A cosine is half the sum of two opposite turns; √p of an odd prime is Gauss's sum Σ (a/p) e^{2πia/p}, times −i where
//! p ≡ 3 (mod 4); √2 = 2 cos 45°.

use num_rational::BigRational;
use num_traits::{One, ToPrimitive};

use crate::exact::{PhasorSum, Term, Turn};
use crate::numbers::{Form, Root};

/// Square roots of larger whole numbers are not written as sums.
const LARGEST_RADICAND: u64 = 1000;

/// The number as a sum; none where it has nested roots, or roots of large numbers.
pub(super) fn as_sum(form: &Form) -> Option<PhasorSum> {
    let mut sum = PhasorSum::new(Vec::new());
    for (root, coefficient) in form.terms() {
        let part = match root {
            Root::One => number(BigRational::one()),
            Root::Whole(n) => square_root(n.to_u64().filter(|n| *n <= LARGEST_RADICAND)?),
            Root::Cosine(angle) => twice_cosine(angle).scaled(&BigRational::new(1.into(), 2.into())),
            Root::Nested(_) => return None,
        };
        sum = sum.plus(&part.scaled(coefficient));
    }
    Some(sum)
}

/// The square of the number as a sum.
pub(super) fn square_as_sum(form: &Form) -> Option<PhasorSum> {
    match as_sum(form) {
        Some(sum) => Some(sum.times(&sum)),
        None => as_sum(&form.times(form)?),
    }
}

/// A rational number as a sum.
pub(super) fn number(value: BigRational) -> PhasorSum {
    PhasorSum::new(vec![Term { angle: Turn::zero(), weight: value }])
}

fn twice_cosine(angle: &Turn) -> PhasorSum {
    let one = number(BigRational::one());
    one.turned(angle).plus(&one.turned(&-angle))
}

/// √n for a whole number free of squares, prime by prime.
fn square_root(n: u64) -> PhasorSum {
    let primes = (2..=n).filter(|p| n.is_multiple_of(*p) && (2..*p).all(|d| p % d != 0));
    primes.fold(number(BigRational::one()), |product, p| product.times(&root_of_prime(p)))
}

fn root_of_prime(p: u64) -> PhasorSum {
    if p == 2 {
        return twice_cosine(&Turn::fraction(1, 8));
    }
    let is_square = |a: u64| (1..p).any(|b| b * b % p == a);
    let weight = |a: u64| BigRational::from_integer(if is_square(a) { 1.into() } else { (-1).into() });
    let angle = |a: u64| Turn::new(BigRational::new(a.into(), p.into()));
    let gauss = PhasorSum::new((1..p).map(|a| Term { angle: angle(a), weight: weight(a) }).collect());
    if p % 4 == 1 { gauss } else { gauss.turned(&Turn::fraction(3, 4)) }
}
