//! Which sum of rotating vectors is this real number? So that a claimed value is compared exactly, with a certificate.
//!
//! A cosine is half the sum of two opposite turns; a square root is Gauss's sum of its discriminant.

use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};

use super::form::{Form, Root};
use super::quadratic;
use crate::exact::{PhasorSum, Term, Turn};

/// Square roots of larger whole numbers are not written as sums.
const LARGEST_RADICAND: u64 = 1000;

/// The number as a sum of rotating vectors; none where it has nested roots, or roots of large numbers.
pub fn as_sum(form: &Form) -> Option<PhasorSum> {
    let parts = form.terms().iter().map(|(root, coefficient)| Some(root_as_sum(root)?.scaled(coefficient)));
    parts.into_iter().try_fold(PhasorSum::new(Vec::new()), |sum, part| Some(sum.plus(&part?)))
}

fn root_as_sum(root: &Root) -> Option<PhasorSum> {
    Some(match root {
        Root::One => number(BigRational::one()),
        Root::Whole(n) => square_root(n.to_u64().filter(|n| *n <= LARGEST_RADICAND)?),
        Root::Cosine(angle) => cosine(angle),
        Root::Product(root, cosines) => {
            cosines.iter().fold(root_as_sum(root)?, |product, angle| product.times(&cosine(angle)))
        }
        Root::Nested(_) => return None,
    })
}

/// The square of the number as a sum; none where that has nested roots.
pub fn square_as_sum(form: &Form) -> Option<PhasorSum> {
    match as_sum(form) {
        Some(sum) => Some(sum.times(&sum)),
        None => as_sum(&form.times(form)?),
    }
}

/// A rational number as a sum.
pub fn number(value: BigRational) -> PhasorSum {
    PhasorSum::new(vec![Term { angle: Turn::zero(), weight: value }])
}

fn cosine(angle: &Turn) -> PhasorSum {
    twice_cosine(angle).scaled(&BigRational::new(1.into(), 2.into()))
}

fn twice_cosine(angle: &Turn) -> PhasorSum {
    let one = number(BigRational::one());
    one.turned(angle).plus(&one.turned(&-angle))
}

/// √n for a whole number free of squares: with its discriminant Δ, `√Δ = Σ χ(j) e^{2πij/Δ}` over j prime to Δ.
fn square_root(n: u64) -> PhasorSum {
    let discriminant = quadratic::discriminant(n);
    let half = BigRational::new(1.into(), if discriminant == n { 1.into() } else { 2.into() });
    let term = |j: u64| Term {
        angle: Turn::new(BigRational::new(j.into(), discriminant.into())),
        weight: &half * BigRational::from_integer(quadratic::character(n, j).into()),
    };
    PhasorSum::new((1..=discriminant).filter(|j| j.gcd(&discriminant) == 1).map(term).collect())
}
