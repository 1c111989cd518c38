//! Which x on the circle are zeros of `A + B x + C x²`, three vectors without unknowns?

use num_complex::Complex;
use num_rational::BigRational;

use super::triangle::{near_turn, sign, signs};
use crate::exact::{PhasorSum, Turn};
use crate::numbers;
use crate::proof::{Certificate, TriangleShape};

/// The zeros on the circle, where `(|A|² − |C|²)² = |conj(A) B − C conj(B)|²`.
#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant, reason = "there are few of them")]
pub enum Roots {
    /// All: A = B = C = 0, with evidence.
    All(Box<[Certificate; 3]>),
    /// None: A = C = 0, and B is not, with evidence.
    None(Box<[Certificate; 3]>),
    /// One: A and C are not equally long.
    One {
        /// Evidence that they are not.
        lengths: Certificate,
        /// The zero.
        at: Root,
    },
    /// As many as `4|A|² − |B|²` says: A and C are equally long.
    Mirror {
        /// Evidence that they are.
        lengths: Certificate,
        /// Evidence that A is not zero.
        first: Certificate,
        /// None, one or two.
        shape: TriangleShape,
        /// The zeros.
        at: Vec<Root>,
    },
}

/// A zero on the circle.
#[derive(Clone, Debug)]
pub enum Root {
    /// A rational turn, with evidence that the sum vanishes there.
    Exact(Turn, Box<Certificate>),
    /// In degrees from 0 to 360; no rational turn was found.
    Near(f64),
}

impl Roots {
    /// Whether there is no zero.
    pub(super) fn is_none(&self) -> bool {
        match self {
            Roots::None(_) => true,
            Roots::Mirror { at, .. } => at.is_empty(),
            Roots::All(_) | Roots::One { .. } => false,
        }
    }
}

/// The zeros; `None` where the sign of `4|A|² − |B|²` is not found.
pub(super) fn roots(sums: &[PhasorSum; 3]) -> Option<Roots> {
    let [first, second, third] = sums;
    let lengths = first.squared_modulus().minus(&third.squared_modulus()).tidied().certificate();
    if !lengths.claims_zero() {
        return Some(Roots::One { lengths, at: root(sums, near(sums)) });
    }
    let evidence = first.certificate();
    if evidence.claims_zero() {
        let middle = second.certificate();
        let is_zero = middle.claims_zero();
        let all = Box::new([evidence, middle, third.certificate()]);
        return Some(if is_zero { Roots::All(all) } else { Roots::None(all) });
    }
    let four = BigRational::from_integer(4.into());
    let shape = sign(first.squared_modulus().scaled(&four).minus(&second.squared_modulus()))?;
    let at = mirrored(sums, &shape).into_iter().map(|degrees| root(sums, degrees)).collect();
    Some(Roots::Mirror { lengths, first: evidence, shape, at })
}

/// `x = −D/E`, in degrees.
pub(super) fn near(sums: &[PhasorSum; 3]) -> f64 {
    let [a, b, c] = sums.each_ref().map(numbers::evaluate);
    let difference = a.norm_sqr() - c.norm_sqr();
    let twist = a.conj() * b - c * b.conj();
    numbers::degrees(-twist.conj() * difference).rem_euclid(360.0)
}

/// The x in degrees, where A and C are equally long.
///
/// With `C = A e^{iγ}` the sum is `A e^{iγ/2} x (2 cos(ξ + γ/2) + r)`, ξ the angle of x, and r real.
pub(super) fn mirrored(sums: &[PhasorSum; 3], shape: &TriangleShape) -> Vec<f64> {
    let [a, b, c] = sums.each_ref().map(numbers::evaluate);
    let half = numbers::degrees(c * a.conj()) / 2.0;
    let (sin, cos) = libm::sincos(half.to_radians());
    let ratio = (b / (a * Complex::new(cos, sin))).re;
    let apart = libm::acos((-ratio / 2.0).clamp(-1.0, 1.0)).to_degrees();
    signs(shape).iter().map(|sign| (sign * apart - half).rem_euclid(360.0)).collect()
}

/// A rational turn near the degrees at which the sum vanishes exactly, or the degrees.
fn root([first, second, third]: &[PhasorSum; 3], degrees: f64) -> Root {
    // x² is beside x.
    let exact = near_turn([first, second, third], 2, degrees).and_then(|turn| {
        let sum = first.plus(&second.turned(&turn)).plus(&third.turned(&turn.times(2)));
        let certificate = sum.certificate();
        certificate.claims_zero().then(|| Root::Exact(turn, Box::new(certificate)))
    });
    exact.unwrap_or(Root::Near(degrees))
}
