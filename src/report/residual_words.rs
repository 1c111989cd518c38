//! How is it put in a sentence what is left of an order?

use num_rational::BigRational;
use num_traits::{One, Signed};

use super::residual::{largest, line_bearing, shape_name};
use crate::engine::DOES_NOT_EXIST;
use crate::page::{Choice, Text, phrase};
use crate::proof::{Planar, Sense, Shape, ShapeEvidence};
use crate::verdict::{Balance, Outcome, WholeOrder};

/// A sentence on what the two vectors together trace.
pub(super) fn sentence(balance: &Balance) -> Text {
    match balance.shape {
        Shape::Balanced => "Balanced: both vectors vanish.".into(),
        Shape::Rotating => turning(balance, "+", ROTATING),
        Shape::CounterRotating => turning(balance, "-", COUNTER_ROTATING),
        Shape::Planar => planar(balance),
        Shape::Elliptical => elliptical(balance),
        Shape::NotDecided => "Whether the vectors are equally long is not decided.".into(),
        Shape::DoesNotExist => DOES_NOT_EXIST.into(),
    }
}

/// What the sums are called: `P` of the force, `C` of the moment.
fn letter(balance: &Balance) -> &'static str {
    match balance.quantity {
        Planar::Force => "P",
        Planar::Moment => "C",
    }
}

/// `½|P_2⁺|`.
fn half_length(balance: &Balance, sign: &str) -> Text {
    let (letter, k) = (letter(balance), balance.direct.order);
    Text::formula(format!("\\tfrac12 \\lvert {letter}_{{{k}}}^{{{sign}}} \\rvert"))
}

/// One vector is left: in words for order 1, and in those for higher orders.
fn turning(balance: &Balance, sign: &str, [first, higher]: [&'static str; 2]) -> Text {
    let (length, size) = (half_length(balance, sign), largest(balance));
    match balance.direct.order {
        1 => phrase!(first, length, size),
        k => phrase!(higher, length, size, k),
    }
}

const ROTATING: [&str; 2] = [
    "The residual is **rotating**: a vector of constant length {}, here {}, that turns with the crank. Counterweights on the crankshaft remove it.",
    "The residual is **rotating**: a vector of constant length {}, here {}, that turns the same way as the crank at {} times its speed. A balancer shaft that turns so removes it.",
];
const COUNTER_ROTATING: [&str; 2] = [
    "The residual is **counter-rotating**: a vector of constant length {}, here {}, that turns against the crank at crank speed. One balancer shaft that turns so removes it.",
    "The residual is **counter-rotating**: a vector of constant length {}, here {}, that turns against the crank at {} times its speed. One balancer shaft that turns so removes it.",
];

/// `|P_2⁺|² − |P_2⁻|²` beside zero.
fn difference(balance: &Balance, relation: &str) -> Text {
    let (letter, k) = (letter(balance), balance.direct.order);
    let square = |sign: &str| format!("\\lvert {letter}_{{{k}}}^{{{sign}}} \\rvert^2");
    Text::formula(format!("{} - {} {relation} 0", square("+"), square("-")))
}

fn planar(balance: &Balance) -> Text {
    let (difference, line, size) = (difference(balance, "="), line_bearing(balance), largest(balance));
    phrase!(
        "The residual is **planar**: both vectors are equally long ({}, proved), so the {force|moment} swings along the line at {}; its largest value is {}.",
        difference,
        balance.quantity,
        line,
        size
    )
}

fn elliptical(balance: &Balance) -> Text {
    let (difference, line, size) = (difference(balance, "\\ne"), line_bearing(balance), largest(balance));
    phrase!(
        "The residual is **elliptical**: the vectors differ in length ({}, proved), so the tip of the {force|moment} runs round an ellipse; its largest value is {}, along the line at {}.",
        difference,
        balance.quantity,
        size,
        line
    )
}

/// A sentence on a whole order, how it is known whether it vanishes.
pub(super) fn whole_sentence(name: &'static str, order: u32, whole: &WholeOrder) -> Text {
    let [direct, reverse] = &whole.outcomes;
    let outcomes = match direct == reverse {
        true => vec![vector_sentence(None, direct)],
        false => vec![vector_sentence(Some(Sense::Direct), direct), vector_sentence(Some(Sense::Reverse), reverse)],
    };
    let lead = phrase!("**{} of order {}, all its sums together.**", name, order);
    Text::joined([lead].into_iter().chain(outcomes).chain(what_is_left(whole)), " ")
}

/// How it is known whether a vector vanishes, or both do.
fn vector_sentence(vector: Option<Sense>, outcome: &Outcome) -> Text {
    let vector = vector.map_or_else(|| Choice::of(2).into(), Text::from);
    match outcome {
        Outcome::Zero => phrase!(
            "{1:The direct vector vanishes|The reverse vector vanishes|Both vectors vanish}: each of {1:its|its|their} sums is zero.",
            vector
        ),
        Outcome::NotZero => phrase!(
            "{The direct vector does not vanish|The reverse vector does not vanish|Neither vector vanishes}: only one of its sums remains, and its coefficient is not zero.",
            vector
        ),
        Outcome::NotZeroByEnclosure { .. } => phrase!(
            "{The direct vector does not vanish|The reverse vector does not vanish|Neither vector vanishes}: an enclosure of the whole, each sum times its coefficient, excludes zero.",
            vector
        ),
        Outcome::NotDecided { below } => phrase!(
            "{The direct vector is not|The reverse vector is not|Neither vector is} decided: only the coefficients could make it vanish, and it is no longer than {}.",
            vector,
            rounded_up(below)
        ),
        Outcome::Open => phrase!(
            "{The direct vector is not|The reverse vector is not|Neither vector is} decided: it depends on the rods, of which the layout says nothing.",
            vector
        ),
    }
}

/// Its shape, and how that is known; nothing where it vanishes or is not decided.
fn what_is_left(whole: &WholeOrder) -> Option<Text> {
    let shape = match whole.shape {
        Shape::Balanced | Shape::NotDecided | Shape::DoesNotExist => return None,
        shape => shape_name(shape),
    };
    Some(match &whole.evidence {
        None => phrase!("The residual is **{}**.", shape),
        Some(ShapeEvidence::Certificate(_)) => {
            phrase!("The residual is **{}**: the squares of both lengths are compared exactly.", shape)
        }
        Some(ShapeEvidence::Pairs(_)) => phrase!(
            "The residual is **{}**: both vectors are equally long for any coefficients: in the difference of the squares of their lengths each product of two of them has the exact coefficient zero.",
            shape
        ),
        Some(ShapeEvidence::Bits(_)) => {
            phrase!("The residual is **{}**: an enclosure shows that the lengths differ.", shape)
        }
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
