//! How is a sum of vectors written down? As a formula where it is short, else as a list.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::exact::{Term, Turn};
use crate::page::number::{self, angle, signed_degrees};
use crate::page::{Number, Text, phrase};

/// Sums of more vectors are not written as a formula.
pub(super) const MOST_IN_FORMULA: usize = 9;
/// Longer lists of vectors tell a reader nothing.
pub(super) const MOST_IN_LIST: usize = 40;

/// `a`, `a and b`, `a, b and c`.
pub(in crate::report) fn listed(items: Vec<Text>) -> Text {
    let mut items = items;
    match (items.pop(), items.is_empty()) {
        (Some(last), false) => phrase!("{} and {}", Text::joined(items, ", "), last),
        (Some(only), true) => only,
        (None, _) => Text::default(),
    }
}

/// `1 at 0°, 2 at 120° and 1 at 240°`.
pub(super) fn vectors(terms: &[Term]) -> Text {
    let one = |term: &Term| phrase!("{} at {}", Number::exact(&term.weight), angle(&term.angle));
    listed(terms.iter().map(one).collect())
}

/// An exact number in TeX: an integer, a short decimal, or a fraction; none where it is too long to be read.
fn number_tex(value: &BigRational) -> Option<String> {
    let text = number::number(&value.abs());
    if text.chars().any(|letter| !letter.is_ascii_digit() && letter != '.' && letter != '/') {
        return None;
    }
    Some(match text.split_once('/') {
        Some((above, below)) => format!("\\tfrac{{{above}}}{{{below}}}"),
        None => text,
    })
}

/// Terms joined by their signs.
fn signed(terms: impl IntoIterator<Item = (bool, String)>) -> String {
    let mut out = String::new();
    for (is_negative, term) in terms {
        out.push_str(match (is_negative, out.is_empty()) {
            (true, true) => "-",
            (true, false) => " - ",
            (false, true) => "",
            (false, false) => " + ",
        });
        out.push_str(&term);
    }
    if out.is_empty() { "0".to_owned() } else { out }
}

/// A factor in TeX before something: nothing for 1.
fn factor(weight: &BigRational) -> Option<String> {
    if weight.abs().is_one() { Some(String::new()) } else { Some(format!("{}\\,", number_tex(weight)?)) }
}

/// An angle in TeX.
fn angle_tex(turn: &BigRational) -> Option<String> {
    let text = number_tex(turn)?;
    Some(if turn.is_integer() || !text.contains('\\') {
        format!("{text}^{{\\circ}}")
    } else {
        format!("({text})^{{\\circ}}")
    })
}

/// `2\,e^{i\,0°} - e^{i\,120°}`; none where it is long.
pub(super) fn sum_tex(terms: &[Term]) -> Option<String> {
    let one = |term: &Term| {
        let angle = angle_tex(&term.angle.degrees())?;
        Some((term.weight.is_negative(), format!("{}e^{{i\\,{angle}}}", factor(&term.weight)?)))
    };
    let terms: Option<Vec<_>> = (terms.len() <= MOST_IN_FORMULA).then(|| terms.iter().map(one).collect())?;
    Some(signed(terms?))
}

/// The components along a direction: `1 + 2\cos 40°`; none where it is long.
pub(super) fn components_tex(vectors: &[Term], along: &Turn) -> Option<String> {
    // The cosine of an angle is that of its opposite: like ones are collected.
    let mut cosines: Vec<(BigRational, BigRational)> = Vec::new();
    for term in vectors {
        let from = signed_degrees(&(&term.angle - along)).abs();
        match cosines.iter_mut().find(|(angle, _)| *angle == from) {
            Some((_, weight)) => *weight += &term.weight,
            None => cosines.push((from, term.weight.clone())),
        }
    }
    cosines.sort();
    let [right, straight] = [90, 180].map(|degrees| BigRational::from_integer(degrees.into()));
    let one = |(angle, weight): &(BigRational, BigRational)| {
        if angle.is_zero() || *angle == straight {
            return Some((!angle.is_zero(), number_tex(weight)?));
        }
        Some((false, format!("{}\\cos {}", factor(weight)?, angle_tex(angle)?)))
    };
    let told: Vec<_> = cosines.iter().filter(|(angle, _)| *angle != right).collect();
    let terms: Option<Vec<_>> = (told.len() <= MOST_IN_FORMULA).then(|| told.into_iter().map(one).collect())?;
    Some(signed(terms?))
}

/// A longer image than this, in letters of TeX, does not fit on a line with what it is said to be.
const LONGEST_IMAGE: usize = 130;

/// The image of a sum modulo a prime: `2\cdot 3^{0} - 3^{4}`; none where it is long.
pub(super) fn image_tex(terms: &[Term], scale: &BigInt, conductor: &BigInt, root: &BigInt) -> Option<String> {
    let whole = |value: &BigRational, by: &BigInt| (value * BigRational::from_integer(by.clone())).to_integer();
    let one = |term: &Term| {
        let (weight, exponent) = (whole(&term.weight, scale), whole(term.angle.turns(), conductor));
        let factor = if weight.abs().is_one() { String::new() } else { format!("{}\\cdot ", weight.abs()) };
        (weight.is_negative(), format!("{factor}{root}^{{{exponent}}}"))
    };
    let image = (terms.len() <= MOST_IN_FORMULA).then(|| signed(terms.iter().map(one)));
    image.filter(|tex| tex.len() <= LONGEST_IMAGE)
}
