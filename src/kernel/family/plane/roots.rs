//! Which x on the circle are zeros of `A + B x + C x²`, three vectors without unknowns?

use num_complex::Complex;
use num_rational::BigRational;

use super::triangle::{near_turn, sign, signs};
use crate::exact::{PhasorSum, Turn};
use crate::numbers::{self, Direction};
use crate::proof::{RootClaim, RootsClaim, TriangleShape};

/// A zero on the circle.
#[derive(Clone, Debug)]
pub struct Root {
    /// The closed form, where it has one.
    pub exact: Option<Direction>,
    /// In degrees.
    pub degrees: f64,
}

impl Root {
    /// At a rational turn.
    pub(super) fn at(turn: Turn) -> Self {
        Root { degrees: numbers::float(&turn.degrees()), exact: Some(Direction::Turn(turn)) }
    }
}

/// What is said of the zeros, and the zeros, where not all x are; `None` where the sign of `4|A|² − |B|²` is not found.
pub(super) fn roots(sums: &[PhasorSum; 3]) -> Option<(RootsClaim, Option<Vec<Root>>)> {
    let [first, second, third] = sums;
    let lengths = first.squared_modulus().minus(&third.squared_modulus()).tidied().certificate();
    if !lengths.claims_zero() {
        let (root, at) = root(sums, near(sums));
        return Some((RootsClaim::One { lengths, at: at.into_iter().collect() }, Some(vec![root])));
    }
    let evidence = first.certificate();
    if evidence.claims_zero() {
        let middle = second.certificate();
        let is_zero = middle.claims_zero();
        let certificates = Box::new([evidence, middle, third.certificate()]);
        return Some(match is_zero {
            true => (RootsClaim::All { certificates }, None),
            false => (RootsClaim::None { certificates }, Some(Vec::new())),
        });
    }
    let four = BigRational::from_integer(4.into());
    let shape = sign(first.squared_modulus().scaled(&four).minus(&second.squared_modulus()))?;
    let found = mirrored(sums, &shape).into_iter().map(|degrees| root(sums, degrees));
    let (roots, at): (Vec<Root>, Vec<Option<RootClaim>>) = found.unzip();
    let at = at.into_iter().flatten().collect();
    Some((RootsClaim::Mirror { lengths, first: evidence, shape, at }, Some(roots)))
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
fn root([first, second, third]: &[PhasorSum; 3], degrees: f64) -> (Root, Option<RootClaim>) {
    // x² is beside x.
    let exact = near_turn([first, second, third], 2, degrees).and_then(|turn| {
        let sum = first.plus(&second.turned(&turn)).plus(&third.turned(&turn.times(2)));
        let certificate = sum.certificate();
        let claim = RootClaim { turn: turn.turns().clone(), certificate };
        claim.certificate.claims_zero().then(|| (Root::at(turn), Some(claim)))
    });
    exact.unwrap_or((Root { exact: None, degrees }, None))
}
