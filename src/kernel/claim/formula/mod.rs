//! What may a formula about one cylinder say? Letters of crank, rod, masses and forces, and what is computed with them.

mod letter;
mod read;
mod series;

pub use letter::{Letter, Measured};
pub(super) use read::half_of_place;
pub use series::{Factor, Powers, Series, Wave};

use num_rational::BigRational;

use crate::numbers;

/// A formula in the letters of one cylinder, SI units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Formula {
    /// A number, exactly as written, and half a unit of its last decimal; 0 of a whole number.
    Number(BigRational, BigRational),
    /// π.
    Pi,
    /// A letter.
    Letter(Letter),
    /// A formula with its sign changed.
    Negative(Box<Formula>),
    /// Two formulas, and what is done with them.
    Both(Operation, Box<(Formula, Formula)>),
    /// A power with a small whole exponent.
    Power(Box<Formula>, u8),
    /// A function of a formula; angles are in radians.
    Of(Function, Box<Formula>),
}

/// What is done with two formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// `+`.
    Plus,
    /// `−`.
    Minus,
    /// `·`, or nothing between two factors.
    Times,
    /// `/`.
    Over,
}

/// A function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// `sin`.
    Sine,
    /// `cos`.
    Cosine,
    /// `tan`.
    Tangent,
    /// `√`.
    Root,
}

impl Formula {
    /// Its value where the letters are these.
    pub fn value(&self, letter: &impl Fn(Letter) -> f64) -> f64 {
        match self {
            Formula::Number(number, _) => numbers::float(number),
            Formula::Pi => std::f64::consts::PI,
            Formula::Letter(one) => letter(*one),
            Formula::Negative(one) => -one.value(letter),
            Formula::Both(operation, pair) => {
                let [one, other] = [&pair.0, &pair.1].map(|formula| formula.value(letter));
                match operation {
                    Operation::Plus => one + other,
                    Operation::Minus => one - other,
                    Operation::Times => one * other,
                    Operation::Over => one / other,
                }
            }
            Formula::Power(one, exponent) => one.value(letter).powi(i32::from(*exponent)),
            Formula::Of(function, one) => {
                let value = one.value(letter);
                match function {
                    Function::Sine => value.sin(),
                    Function::Cosine => value.cos(),
                    Function::Tangent => value.tan(),
                    Function::Root => value.sqrt(),
                }
            }
        }
    }
}
