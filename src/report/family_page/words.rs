//! How is it put that a sum vanishes for all, some or no angles?

use std::collections::BTreeSet;

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::super::{argument, residual, typeset};
use super::unknowns::{NEVER, alternatives, exactly, together, unknowns, zero_where};
use super::{boxes_words, circle_words, plane_words, quadratic_words};
use crate::engine::{DOES_NOT_EXIST, Linear};
use crate::exact::Turn;
use crate::family::{self, Angles, EvenFiring, Never, OpenSum, OpenVerdict, Part, Product, Remaining, When};
use crate::numbers::{Form, float};
use crate::page::number::Bearing;
use crate::page::{Format, Piece, Setting, Text, Unit, phrase, text_in};
use crate::proof::{ConditionClaim, CosineClaim};
use crate::report::texts::family as text;

/// When a verdict vanishes, in a few words: zero, `never 0`, `0 at φ = 90°, 270°`, `2√10 (2a + b + 2c)`.
pub(in crate::report) fn summary(verdict: &OpenVerdict) -> Text {
    if !verdict.exists {
        return DOES_NOT_EXIST.into();
    }
    if verdict.always() {
        return Text::zero();
    }
    if let Remaining::Factored { factor, lengths, .. } = family::remaining(verdict) {
        return factored(&factor, &lengths);
    }
    zeros(verdict, |angles| phrase!("0 at φ = {}", list(angles)), exactly)
}

/// Where it is 0. With several lengths that is told of all lengths at once: given ones may make it 0 elsewhere.
fn zeros(verdict: &OpenVerdict, at: impl Fn(&BTreeSet<Turn>) -> Text, shown: fn(String, &Turn) -> String) -> Text {
    let found = match (verdict.never(), verdict.bank_angles()) {
        (true, _) => None,
        (false, Some(angles)) => (!angles.is_empty()).then(|| at(&angles)),
        (false, None) => match verdict.meeting() {
            Some(met) => zero_where(one_of(met.iter().map(Vec::as_slice), shown), []),
            None => Some(at_once(verdict)),
        },
    };
    match (found, verdict.hangs_on_lengths()) {
        (Some(found), false) => found,
        (Some(found), true) => phrase!("{} for all lengths", found),
        (None, true) => "0 for some lengths at most".into(),
        (None, false) => if verdict.never() { "never 0" } else { NEVER }.into(),
    }
}

/// The conditions of all lengths, each told once; in brackets where there are several, since one may be a list of alternatives.
fn at_once(verdict: &OpenVerdict) -> Text {
    let mut known = BTreeSet::new();
    let conditions = verdict.sums.iter().filter_map(condition_of);
    let told: Vec<Text> = conditions.filter(|condition| known.insert(text_in(condition, Format::PLAIN))).collect();
    match told.len() {
        0 | 1 => Text::joined(told, ""),
        _ => Text::joined(told.into_iter().map(|condition| phrase!("({})", condition)), " and at once "),
    }
}

/// `0 where 2φ − δ ≡ 180°`, where these are the conditions; none in the range else.
fn zero_on(conditions: Option<Text>) -> Text {
    zero_where(conditions, []).unwrap_or_else(|| NEVER.into())
}

/// The same for a table: angles that are no round number of degrees as decimals, since the proofs have them exactly.
pub(super) fn cell(verdict: &OpenVerdict) -> Text {
    let rounds = match (verdict.bank_angles(), verdict.meeting()) {
        _ if verdict.always() || verdict.never() => false,
        (Some(angles), _) => angles.iter().any(is_fractional),
        (None, met) => met.is_some(),
    };
    if rounds { zeros(verdict, at_rounded, nearly) } else { summary(verdict) }
}

/// `0 at φ = 60° and φ ≈ 25.7°`.
fn at_rounded(angles: &BTreeSet<Turn>) -> Text {
    let (near, exact): (Vec<&Turn>, Vec<&Turn>) = angles.iter().partition(|angle| is_fractional(angle));
    let near = Text::joined(near.into_iter().map(in_decimals), ", ");
    match exact.is_empty() {
        true => phrase!("0 at φ ≈ {}", near),
        false => phrase!("0 at φ = {} and φ ≈ {}", typeset::listed(exact.into_iter().map(typeset::angle)), near),
    }
}

fn is_fractional(turn: &Turn) -> bool {
    !typeset::terminates(&turn.degrees())
}

/// The same to the figures that the reader asks for.
fn in_decimals(turn: &Turn) -> Text {
    let one_place = Setting::Usual(|degrees| format!("{degrees:.1}"));
    Text::from(Piece::Measured(float(&turn.degrees()), Unit::NONE, one_place)).and("°")
}

/// `25.7°` for (180/7)°.
fn rounded(turn: &Turn) -> String {
    if is_fractional(turn) { format!("{:.1}°", float(&turn.degrees())) } else { typeset::angle(turn) }
}

/// The same for a table: `2φ − δ ≈ 25.7°`.
fn nearly(unknowns: String, turn: &Turn) -> String {
    if is_fractional(turn) { format!("{unknowns} ≈ {}", rounded(turn)) } else { exactly(unknowns, turn) }
}

/// At which bank angles it can fire evenly.
pub(super) fn even_firing_words(angles: &BTreeSet<Turn>) -> Text {
    if angles.is_empty() { text::fires_unevenly() } else { text::fires_evenly_at(list(angles)) }
}

/// For which bank angles and pin splits together it can.
pub(super) fn even_firing_lines_words(even: &EvenFiring) -> Text {
    match even.turns.is_empty() {
        true => text::fires_unevenly_always(),
        false => text::fires_evenly_where(unknowns(&even.phi, &even.delta), list(&even.turns)),
    }
}

/// Angles in a row.
pub(super) fn list(angles: &BTreeSet<Turn>) -> String {
    typeset::listed(angles.iter().map(typeset::angle))
}

pub(in crate::report) fn condition_of(sum: &OpenSum) -> Option<Text> {
    told(&sum.when)
}

/// When a sum vanishes, in a few words; none where it always does.
pub(super) fn told(when: &When) -> Option<Text> {
    match when {
        When::Always => None,
        When::Never(_) => Some("never 0".into()),
        When::Where(angles) => Some(zero_on(conditions(angles))),
        When::Irrational { phi, delta, degrees, .. } => {
            let decimal = typeset::decimal(degrees.rem_euclid(360.0));
            Some(phrase!("0 where {} ≈ {}°", unknowns(phi, delta), decimal))
        }
        When::Cosine(found) => Some(phrase!("0 where {}", cosine(found))),
        When::Circle(circle) => Some(circle_words::condition(circle)),
        When::Triangle(triangle) => Some(plane_words::triangle_condition(triangle)),
        When::Classes(classes) => Some(plane_words::condition(classes)),
        When::Quadratic(found) => Some(quadratic_words::condition(found)),
        When::Product(product) => Some(product_condition(product)),
        When::Boxes(found) => Some(boxes_words::condition(found)),
        When::NotSolved(parts) => Some(phrase!("not solved: {} parts", *parts)),
    }
}

/// Where a vector vanishes: `2φ − δ ≡ 180°`; none where no such condition says it.
pub(super) fn conditions_of(verdict: &OpenVerdict) -> Option<Text> {
    one_of(verdict.meeting()?.iter().map(Vec::as_slice), exactly)
}

fn conditions(angles: &Angles) -> Option<Text> {
    one_of(angles.alternatives.iter().map(|one| one.conditions.as_slice()), exactly)
}

/// `2φ − δ ≡ 180°`, alternatives in the range joined by "or"; none where there is none.
fn one_of<'a>(all: impl IntoIterator<Item = &'a [ConditionClaim]>, shown: fn(String, &Turn) -> String) -> Option<Text> {
    alternatives(all.into_iter().filter_map(|conditions| together(conditions, shown)))
}

/// `cos(φ) = 0.25, φ ≈ ±75.52°`.
pub(super) fn cosine(found: &CosineClaim) -> Text {
    let degrees = float(&found.cosine).acos().to_degrees();
    let (argument, value) = (argument_of(found), typeset::number(&found.cosine));
    let (phi, delta, turn) = entering_positively(found);
    let degrees = circle_words::signed(&[phi, delta], &turn, degrees);
    phrase!("cos({}) = {}, {} ≈ {}", argument.clone(), value, argument, degrees)
}

/// `φ`, `2φ + 30°`: what the cosine is of.
fn argument_of(found: &CosineClaim) -> String {
    let (phi, delta, turn) = entering_positively(found);
    match turn == Turn::zero() {
        true => unknowns(&phi, &delta),
        false => format!("{} + {}", unknowns(&phi, &delta), typeset::degrees(&typeset::signed_degrees(&turn)))
            .replace("+ −", "− "),
    }
}

/// A cosine is even: φ, or else δ, is shown entering positively.
fn entering_positively(found: &CosineClaim) -> (BigRational, BigRational, Turn) {
    let turn = Turn::new(found.turn.clone());
    match found.phi.is_negative() || found.phi.is_zero() && found.delta.is_negative() {
        true => (-&found.phi, -&found.delta, -&turn),
        false => (found.phi.clone(), found.delta.clone(), turn),
    }
}

/// Sentences on one sum: its parts, and why it vanishes where it does.
pub(in crate::report) fn argument(sum: &OpenSum) -> Text {
    let has_open_angles = sum.parts.iter().any(|part| !part.phi.is_zero() || !part.delta.is_zero());
    let one = |part: &Part| {
        let certificate = argument::certificate_of(&part.sum, &part.certificate);
        match (&sum.symbol, has_open_angles) {
            (_, true) => text::turned(unknowns(&part.phi, &part.delta), value(part), certificate),
            (Some(_), false) => phrase!("{}. {}", value(part), certificate),
            // The lead of the verdict says it already.
            (None, false) => certificate,
        }
    };
    let sentences = sum.parts.iter().map(one).chain(has_open_angles.then(|| why(&sum.when)));
    let sentences = Text::joined(sentences, " ");
    match &sum.symbol {
        Some(symbol) => text::factor_of(symbol.clone(), sentences),
        None => sentences,
    }
}

pub(super) fn why(when: &When) -> Text {
    match when {
        When::Always => text::all_parts_vanish(),
        When::Never(Never::OnePart) => text::one_part(),
        When::Never(Never::UnequalLengths(_)) => text::unequal_parts(),
        When::Never(Never::Coprime(found)) => circle_words::coprime(found),
        When::Never(Never::Circle(circle)) | When::Circle(circle) => circle_words::why(circle),
        When::Never(Never::Triangle(triangle)) | When::Triangle(triangle) => plane_words::triangle_why(triangle),
        When::Never(Never::Classes(classes)) | When::Classes(classes) => plane_words::why(classes),
        When::Never(Never::Quadratic(found)) | When::Quadratic(found) => quadratic_words::why(found),
        When::Never(Never::Product(product)) | When::Product(product) => product_why(product),
        When::Never(Never::Boxes(found)) | When::Boxes(found) => boxes_words::why(found),
        When::Where(angles) => match conditions(angles) {
            Some(conditions) => text::cancel_where(angles.alternatives.len() == 1, conditions),
            None => text::cannot_cancel(),
        },
        When::Irrational { .. } => text::no_rational_turn(),
        When::Cosine(found) => text::mirror_images(argument_of(found), typeset::number(&found.cosine)),
        When::NotSolved(count) => text::not_solved(*count),
    }
}

/// `0 where δ ≡ 90°; 0 where φ ≡ 60°`, without what never vanishes.
pub(super) fn product_condition(product: &Product) -> Text {
    let factors = [&product.group, &product.firsts].map(|when| match when {
        When::Never(_) => None,
        other => told(other),
    });
    Text::joined(factors.into_iter().flatten(), "; ")
}

/// Why it vanishes there, and nowhere else.
pub(super) fn product_why(product: &Product) -> Text {
    text::product(product.groups.len(), why(&product.group), why(&product.firsts))
}

fn value(part: &Part) -> Text {
    if part.certificate.claims_zero() {
        return Text::zero();
    }
    phrase!("length {}, angle {}", residual::modulus_of(&part.sum), residual::bearing(&part.sum))
}

/// `2√10 (2a + b + 2c)`, `√2 b`, `3`.
fn factored(factor: &Form, lengths: &Linear) -> Text {
    let size = || Text::from(Piece::Form(factor.clone()));
    if lengths.as_known().is_some_and(|known| known.abs().is_one()) {
        return size();
    }
    let is_single = lengths.symbols().len() == 1 && lengths.known().is_zero();
    let lengths = match (is_single, may_be_negative(lengths)) {
        (true, _) => lengths.to_string(),
        (false, true) => format!("|{lengths}|"),
        (false, false) => format!("({lengths})"),
    };
    let is_one = factor.as_rational().is_some_and(|one| one.is_one());
    if is_one { lengths.into() } else { phrase!("{} {}", size(), lengths) }
}

/// Whether lengths are taken away from others.
fn may_be_negative(lengths: &Linear) -> bool {
    lengths.known().is_negative() || lengths.symbols().values().any(Signed::is_negative)
}

/// Where the lengths factor out, in which direction what is left points.
pub(super) fn left_sentence(verdict: &OpenVerdict) -> Option<Text> {
    let Remaining::Factored { factor, lengths, direction, degrees } = family::remaining(verdict) else { return None };
    let bearing = Bearing { exact: direction, decimal: degrees };
    let length = factored(&factor, &lengths);
    Some(match may_be_negative(&lengths) {
        true => text::residual_of_difference(length, bearing, lengths.to_string()),
        false => text::residual(length, bearing),
    })
}
