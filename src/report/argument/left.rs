//! How is it told without primes that a sum is not zero? By the few vectors that are left, or by what they add up to along a line.

use num_traits::Signed;

use super::sums::{MOST_IN_LIST, components_tex, vectors};
use crate::exact::{PhasorSum, Term, Turn};
use crate::numbers::{Form, Root};
use crate::page::number::angle;
use crate::page::{Number, Text, phrase};
use crate::verdict::{Component, Size};

/// One vector is left.
pub(super) fn one(vector: &Term) -> Text {
    phrase!(
        "After vectors on one line are combined, one vector remains, {} at {}: it is not zero.",
        Number::exact(&vector.weight),
        angle(&vector.angle)
    )
}

/// Two vectors are left that do not lie on one line.
pub(super) const TWO: &str = "With like and opposite directions collected two vectors remain: {}. They do not lie on one line, so they cannot cancel.";

/// Three vectors are left, the first too long.
pub(super) const ONE_TOO_LONG: &str = "With like and opposite directions collected three vectors remain: {}. The first is no shorter than the other two together, which do not both point against it: they cannot cancel it.";

/// Three vectors are left that are equally long.
pub(super) const THREE_ALIKE: &str = "With like and opposite directions collected three vectors remain: {}. Three equally long vectors cancel only where they are 120° apart, and these are not.";

/// These few vectors are left, in such words.
pub(super) fn few(words: &'static str, left: &[Term]) -> Text {
    phrase!(words, vectors(left))
}

/// All vectors are on one side.
pub(super) fn one_side(sum: &PhasorSum, middle: &Turn, within: &Turn) -> Text {
    phrase!(
        "{} All of them point to within {} of {}, so each has a positive component in that direction, and nothing can cancel it.",
        remaining(&sum.on_lines()),
        angle(within),
        angle(middle)
    )
}

/// The components along one direction add up to a positive number.
pub(super) fn component(found: &Component) -> Text {
    let Component { vectors, along, is_mirror_line, size } = found;
    let line = match is_mirror_line {
        true => {
            phrase!(
                "Together they are their own mirror image in the line at {}, so their sum lies on that line.",
                angle(along)
            )
        }
        false => phrase!("Take the components of the vectors in the direction {}.", angle(along)),
    };
    Text::joined([remaining(vectors), line, size_sentence(vectors, along, size)], " ")
}

/// Which vectors are left.
fn remaining(left: &[Term]) -> Text {
    match left.len() <= MOST_IN_LIST {
        true => phrase!("With like and opposite directions collected these vectors remain: {}.", vectors(left)),
        false => phrase!("With like and opposite directions collected {} vectors remain.", left.len()),
    }
}

/// What the components add up to, and why that is not zero.
fn size_sentence(vectors: &[Term], along: &Turn, size: &Size) -> Text {
    let cosines = components_tex(vectors, along);
    match (size, cosines) {
        (Size::Between(low, high), Some(cosines)) => phrase!(
            "The components in that direction add up to {}, which lies between {} and {}: it is not zero.",
            Text::formula(cosines),
            Number::exact(low),
            Number::exact(high)
        ),
        (Size::Between(low, high), None) => phrase!(
            "The components in that direction add up to a number between {} and {}: it is not zero.",
            Number::exact(low),
            Number::exact(high)
        ),
        (Size::Roots(form), Some(cosines)) => phrase!(
            "The components in that direction add up to {}. {}",
            Text::formula(match form.tex() {
                value if value == cosines => value,
                value => format!("{cosines} = {value}"),
            }),
            why_not_zero(form)
        ),
        (Size::Roots(form), None) => {
            phrase!("The components in that direction add up to {}. {}", Text::formula(form.tex()), why_not_zero(form))
        }
    }
}

/// Why a sum of roots is not zero.
fn why_not_zero(form: &Form) -> Text {
    let root = |root: &Root| {
        let number = match root {
            Root::Whole(number) => number.to_string(),
            Root::One | Root::Nested(_) | Root::Cosine(_) | Root::Product(..) => "1".to_owned(),
        };
        Text::formula(format!("\\sqrt{{{number}}}"))
    };
    match form.terms() {
        [] | [_] => "That is not zero.".into(),
        terms if terms.iter().all(|(_, coefficient)| coefficient.is_positive()) => {
            "That is a sum of positive numbers, and not zero.".into()
        }
        [(Root::One, _), (other, _)] | [(other, _), (Root::One, _)] => {
            phrase!("That is not zero, for {} is irrational.", root(other))
        }
        [(one, _), (other, _), ..] => {
            phrase!("That is not zero, for the ratio of {} and {} is irrational.", root(one), root(other))
        }
    }
}
