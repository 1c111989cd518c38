//! How would a person write an irrational zero? As an argument where two parts are left, as an arc cosine where three are.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;

use super::arcs::Circle;
use crate::exact::{PhasorSum, Turn};
use crate::numbers::{self, Direction, Form};

/// The zeros of a sum in closed form.
#[derive(Clone, Debug, PartialEq)]
pub enum Closed {
    /// The one zero `u = arg(−S_0/S_1)` of two parts.
    Argument(Direction),
    /// The zeros of `S_1 (1 − cos(u + turn)/cosine)`.
    Cosine {
        /// What is added to u.
        turn: Turn,
        /// The cosine, which is not rational.
        cosine: Form,
    },
}

impl Circle {
    /// The closed form of its zeros, where it has one.
    pub fn closed(&self) -> Option<Closed> {
        match (self.polynomial.exponents.as_slice(), self.polynomial.sums.as_slice()) {
            ([0, 1], [first, second]) => {
                let quotient = first.times(&second.conjugate()).turned(&Turn::fraction(1, 2));
                numbers::direction_of(&quotient).map(Closed::Argument)
            }
            ([0, 1, 2], [_, middle, last]) if !self.claim.mirrored.is_empty() => cosine(middle, last),
            _ => None,
        }
    }
}

/// `1 + 2ρ cos(u + t)` with `ρe^{it} = S_2/S_1` is zero where the cosine is `−1/(2ρ) = −|S_1||S_2| / (2|S_2|²)`.
fn cosine(middle: &PhasorSum, last: &PhasorSum) -> Option<Closed> {
    let product = last.times(&middle.conjugate());
    let Direction::Turn(turn) = numbers::direction_of(&product)? else { return None };
    let square = last.squared_modulus();
    let length = numbers::mean_of_conjugates(&square).filter(|length| !length.is_zero())?;
    if !square.minus(&numbers::number(length.clone())).vanishes() {
        return None;
    }
    let upright = product.turned(&-&turn);
    let halved = (length * BigRational::from_integer(BigInt::from(-2))).recip();
    // Half a turn is the sign of the cosine.
    let (turn, sign) = match turn == Turn::fraction(1, 2) {
        true => (Turn::zero(), BigRational::from_integer((-1).into())),
        false => (turn, BigRational::from_integer(1.into())),
    };
    Some(Closed::Cosine { turn, cosine: numbers::real(&upright.scaled(&(halved * sign)))? })
}
