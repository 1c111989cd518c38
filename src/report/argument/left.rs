//! How is it told without primes that a sum is not zero? By the few vectors that are left, or by what they add up to along a line.

use num_traits::Signed;

use super::sums::{MOST_IN_LIST, components_tex, vectors};
use crate::exact::{PhasorSum, Term, Turn};
use crate::numbers::{Form, Root};
use crate::page::number::angle;
use crate::page::{Number, Text};
use crate::report::texts::argument as text;
use crate::verdict::{Component, Size};

/// One vector is left.
pub(super) fn one(vector: &Term) -> Text {
    text::one_vector(Number::exact(&vector.weight), angle(&vector.angle))
}

/// All vectors are on one side.
pub(super) fn one_side(sum: &PhasorSum, middle: &Turn, within: &Turn) -> Text {
    text::one_side(remaining(&sum.on_lines()), angle(within), angle(middle))
}

/// The components along one direction add up to a positive number.
pub(super) fn component(found: &Component) -> Text {
    let Component { vectors, along, is_mirror_line, size } = found;
    let line = if *is_mirror_line { text::mirror_line(angle(along)) } else { text::direction(angle(along)) };
    Text::joined([remaining(vectors), line, size_sentence(vectors, along, size)], " ")
}

/// Which vectors are left.
fn remaining(left: &[Term]) -> Text {
    if left.len() <= MOST_IN_LIST { text::remaining(vectors(left)) } else { text::many_remaining(left.len()) }
}

/// What the components add up to, and why that is not zero.
fn size_sentence(vectors: &[Term], along: &Turn, size: &Size) -> Text {
    let cosines = components_tex(vectors, along);
    match (size, cosines) {
        (Size::Between(low, high), Some(cosines)) => {
            text::components_between(Text::formula(cosines), Number::exact(low), Number::exact(high))
        }
        (Size::Between(low, high), None) => text::number_between(Number::exact(low), Number::exact(high)),
        (Size::Roots(form), cosines) => {
            let value = form.tex();
            let sum = match cosines {
                Some(cosines) if cosines != value => format!("{cosines} = {value}"),
                _ => value,
            };
            text::components(Text::formula(sum), why_not_zero(form))
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
        [] | [_] => text::one_root(),
        terms if terms.iter().all(|(_, coefficient)| coefficient.is_positive()) => text::positive_sum(),
        [(Root::One, _), (other, _)] | [(other, _), (Root::One, _)] => text::irrational(root(other)),
        [(one, _), (other, _), ..] => text::irrational_ratio(root(one), root(other)),
    }
}
