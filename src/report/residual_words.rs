//! How is it put in a sentence what is left of an order?

use num_rational::BigRational;
use num_traits::{One, Signed};

use super::residual::{largest, line_bearing, shape_name};
use crate::engine::DOES_NOT_EXIST;
use crate::page::{Choice, Text};
use crate::proof::{Sense, Shape, ShapeEvidence};
use crate::report::texts::residual as text;
use crate::verdict::{Balance, Outcome, WholeOrder};

/// A sentence on what the two vectors together trace.
pub(super) fn sentence(balance: &Balance) -> Text {
    match balance.shape {
        Shape::Balanced => text::balanced(),
        Shape::Rotating => {
            let (length, size) = (half_length(balance, "+"), largest(balance));
            match balance.direct.order {
                1 => text::rotating(length, size),
                order => text::rotating_faster(length, size, order),
            }
        }
        Shape::CounterRotating => {
            let (length, size) = (half_length(balance, "-"), largest(balance));
            match balance.direct.order {
                1 => text::counter_rotating(length, size),
                order => text::counter_rotating_faster(length, size, order),
            }
        }
        Shape::Planar => {
            let (difference, line) = (difference(balance, "="), line_bearing(balance));
            text::planar(difference, balance.quantity, line, largest(balance))
        }
        Shape::Elliptical => {
            let (difference, line) = (difference(balance, "\\ne"), line_bearing(balance));
            text::elliptical(difference, balance.quantity, largest(balance), line)
        }
        Shape::NotDecided => text::lengths_not_decided(),
        Shape::DoesNotExist => DOES_NOT_EXIST.into(),
    }
}

/// What the sums are called: `P` of the force, `C` of the moment.
fn letter(balance: &Balance) -> &'static str {
    balance.quantity.choose("P", "C")
}

/// `½|P_2⁺|`.
fn half_length(balance: &Balance, sign: &str) -> Text {
    let (letter, k) = (letter(balance), balance.direct.order);
    Text::formula(format!("\\tfrac12 \\lvert {letter}_{{{k}}}^{{{sign}}} \\rvert"))
}

/// `|P_2⁺|² − |P_2⁻|²` beside zero.
fn difference(balance: &Balance, relation: &str) -> Text {
    let (letter, k) = (letter(balance), balance.direct.order);
    let square = |sign: &str| format!("\\lvert {letter}_{{{k}}}^{{{sign}}} \\rvert^2");
    Text::formula(format!("{} - {} {relation} 0", square("+"), square("-")))
}

/// A sentence on a whole order, how it is known whether it vanishes.
pub(super) fn whole_sentence(name: &'static str, order: u32, whole: &WholeOrder) -> Text {
    let [direct, reverse] = &whole.outcomes;
    let outcomes = match direct == reverse {
        true => vec![vector_sentence(None, direct)],
        false => vec![vector_sentence(Some(Sense::Direct), direct), vector_sentence(Some(Sense::Reverse), reverse)],
    };
    let lead = text::whole_order(name, order);
    Text::joined([lead].into_iter().chain(outcomes).chain(what_is_left(whole)), " ")
}

/// How it is known whether a vector vanishes, or both do.
fn vector_sentence(vector: Option<Sense>, outcome: &Outcome) -> Text {
    let vectors = vector.map_or_else(|| Choice::of(2), Choice::from);
    match outcome {
        Outcome::Zero => text::vectors_zero(vectors),
        Outcome::NotZero => text::vectors_not_zero(vectors),
        Outcome::NotZeroByEnclosure { .. } => text::vectors_exclude_zero(vectors),
        Outcome::NotDecided { below } => text::vectors_not_decided(vectors, rounded_up(below)),
        Outcome::Open => text::rods_unknown(vectors),
    }
}

/// Its shape, and how that is known; nothing where it vanishes or is not decided.
fn what_is_left(whole: &WholeOrder) -> Option<Text> {
    let shape = match whole.shape {
        Shape::Balanced | Shape::NotDecided | Shape::DoesNotExist => return None,
        shape => shape_name(shape),
    };
    Some(match &whole.evidence {
        None => text::shape(shape),
        Some(ShapeEvidence::Certificate(_)) => text::shape_by_squares(shape),
        Some(ShapeEvidence::Pairs(_)) => text::shape_by_products(shape),
        Some(ShapeEvidence::Bits(_)) => text::shape_by_enclosure(shape),
    })
}

/// A positive number with two digits that is not smaller: `1.5·10⁻⁵`.
fn rounded_up(value: &BigRational) -> Text {
    if !value.is_positive() {
        return Text::zero();
    }
    let ten = BigRational::from_integer(10.into());
    let (mut exponent, mut digits) = (0_i64, value.clone());
    while digits >= ten {
        digits /= &ten;
        exponent += 1;
    }
    while digits < BigRational::one() {
        digits *= &ten;
        exponent -= 1;
    }
    let tenths = (digits * &ten).ceil() / &ten;
    let mantissa = super::typeset::number(&tenths);
    match exponent {
        0 => Text::formula(mantissa),
        exponent => Text::formula(format!("{mantissa} \\cdot 10^{{{exponent}}}")),
    }
}
