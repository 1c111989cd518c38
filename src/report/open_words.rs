//! How is it put that a sum vanishes for all, some or no angles?

use std::collections::BTreeSet;

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::argument;
use super::page::capital;
use super::residual;
use super::typeset::{self, Bearing};
use crate::engine::{DELTA, Linear, PHI};
use crate::exact::Turn;
use crate::family::{self, Alternative, Angles, Condition, Left, Never, OpenSum, OpenVerdict, Part, When};
use crate::numbers::Form;
use crate::page::{Format, Math, text_in};

/// When a verdict vanishes, in a few words of plain text: `0`, `never 0`, `0 at φ = 90°, 270°`, `= 2√10 (2a + b + 2c)`.
pub fn open_summary(verdict: &OpenVerdict) -> String {
    cell(verdict, |form| form.to_string())
}

/// The same as prose with formulas.
pub(super) fn open_summary_prose(verdict: &OpenVerdict) -> String {
    cell(verdict, |form| format!("${}$", form.tex()))
}

fn cell(verdict: &OpenVerdict, set: fn(&Form) -> String) -> String {
    if verdict.always() {
        return "0".to_owned();
    }
    if let Left::Factored { factor, lengths, .. } = family::left(verdict) {
        return format!("= {}", factored(&factor, &lengths, set));
    }
    if verdict.never() {
        return "never 0".to_owned();
    }
    match verdict.bank_angles() {
        Some(angles) if angles.is_empty() => "never 0 in (0°, 360°)".to_owned(),
        Some(angles) => format!("0 at φ = {}", list(&angles)),
        None => {
            let open: Vec<String> = verdict.sums.iter().filter_map(condition_of).collect();
            open.join("; and ")
        }
    }
}

/// At which bank angles it can fire evenly.
pub fn even_firing_words(angles: &BTreeSet<Turn>) -> String {
    match angles.is_empty() {
        true => "No bank angle lets it fire evenly.".to_owned(),
        false => format!("It can fire evenly exactly at φ = {}.", list(angles)),
    }
}

/// Angles in a row.
pub(super) fn list(angles: &BTreeSet<Turn>) -> String {
    angles.iter().map(typeset::angle).collect::<Vec<_>>().join(", ")
}

fn condition_of(sum: &OpenSum) -> Option<String> {
    match &sum.when {
        When::Always => None,
        When::Never(_) => Some("never 0".to_owned()),
        When::Where(angles) => Some(format!("0 where {}", conditions(angles))),
        When::Irrational { phi, delta, degrees, .. } => {
            let decimal = typeset::decimal(degrees.rem_euclid(360.0));
            Some(format!("0 where {} ≈ {decimal}°", unknowns(phi, delta)))
        }
        When::NotSolved(parts) => Some(format!("not solved: {parts} parts")),
    }
}

/// `2φ − δ ≡ 180°`, alternatives joined by "or".
fn conditions(angles: &Angles) -> String {
    let one = |condition: &Condition| {
        // φ, or else δ, is shown entering positively.
        let Condition { phi, delta, turn } = condition;
        match phi.is_negative() || phi.is_zero() && delta.is_negative() {
            true => format!("{} ≡ {}", unknowns(&-phi, &-delta), typeset::angle(&-turn)),
            false => format!("{} ≡ {}", unknowns(phi, delta), typeset::angle(turn)),
        }
    };
    let together = |alternative: &Alternative| alternative.conditions.iter().map(one).collect::<Vec<_>>().join(" and ");
    angles.alternatives.iter().map(together).collect::<Vec<_>>().join(", or ")
}

/// `2φ − δ`.
pub(super) fn unknowns(phi: &BigRational, delta: &BigRational) -> String {
    let parts = [(PHI, phi), (DELTA, delta)].map(|(name, factor)| Linear::symbol(name, factor.clone()));
    match parts.map(|part| (part != Linear::default()).then(|| greek(&part))) {
        [None, None] => "0".to_owned(),
        [Some(only), None] | [None, Some(only)] => only,
        [Some(phi), Some(delta)] => format!("{phi} + {delta}").replace("+ −", "− "),
    }
}

/// An angle with unknowns, given in turns: `45° + φ/2`; the known part in `(−180°, 180°]`.
pub(super) fn open_angle(angle: &Linear) -> String {
    let symbols = angle.minus(&Linear::constant(angle.known().clone()));
    let known = typeset::degrees(&typeset::signed_degrees(&Turn::new(angle.known().clone())));
    match (symbols == Linear::default(), angle.known().is_zero()) {
        (true, _) => known,
        (false, true) => greek(&symbols),
        (false, false) => format!("{known} + {}", greek(&symbols)).replace("+ −", "− "),
    }
}

fn greek(linear: &Linear) -> String {
    linear.to_string().replace(PHI, "φ").replace(DELTA, "δ")
}

/// A length with symbols.
pub(super) fn open_length(length: &Linear) -> String {
    match length.as_known() {
        Some(known) => typeset::number(known),
        None => length.to_string(),
    }
}

/// Sentences on one sum: its parts, and why it vanishes where it does.
pub(super) fn argument(sum: &OpenSum) -> String {
    let before = match &sum.symbol {
        Some(symbol) => format!("What {symbol} multiplies: "),
        None => String::new(),
    };
    let has_open_angles = sum.parts.iter().any(|part| !part.phi.is_zero() || !part.delta.is_zero());
    let one = |part: &Part| {
        let turned = format!("turned by {}: {}. ", unknowns(&part.phi, &part.delta), value(part));
        let value = match (&sum.symbol, has_open_angles) {
            (_, true) => capital(&turned),
            (Some(_), false) => format!("{}. ", value(part)),
            // The lead of the verdict says it already.
            (None, false) => String::new(),
        };
        let certificate = argument::certificate_of(&part.sum, &part.certificate);
        format!("{value}{}", text_in(&certificate, Format::Markdown(Math::Dollars)))
    };
    let mut sentences: Vec<String> = sum.parts.iter().map(one).collect();
    sentences.extend(has_open_angles.then(|| why(&sum.when)));
    format!("{before}{}", sentences.join(" "))
}

fn why(when: &When) -> String {
    match when {
        When::Always => "Every part vanishes, so the sum does for all angles.".to_owned(),
        When::Never(Never::OnePart) => "One part is left, so the sum vanishes for no angle.".to_owned(),
        When::Never(Never::UnequalLengths(_)) => {
            "Two parts are left and their lengths differ (proved), so they cancel for no angle.".to_owned()
        }
        When::Where(angles) => format!(
            "The parts that are left are equally long (proved), so they cancel exactly where they are {}: {} (modulo 360°).",
            if angles.alternatives.len() == 1 { "opposite" } else { "120° apart" },
            conditions(angles)
        ),
        When::Irrational { .. } => {
            "The two parts are equally long (proved) and cancel where they are opposite; no rational turn was found for that."
                .to_owned()
        }
        When::NotSolved(count) => format!("{count} parts are left; for which angles they cancel is not solved here."),
    }
}

fn value(part: &Part) -> String {
    if part.certificate.claims_zero() {
        return "0".to_owned();
    }
    let (length, bearing) = (residual::modulus_of(&part.sum).prose(), residual::bearing(&part.sum).prose());
    format!("length {length}, angle {bearing}")
}

/// `2√10 (2a + b + 2c)`, `√2 b`, `3`.
fn factored(factor: &Form, lengths: &Linear, set: fn(&Form) -> String) -> String {
    if lengths.as_known().is_some_and(|known| known.abs().is_one()) {
        return set(factor);
    }
    let is_single = lengths.symbols().len() == 1 && lengths.known().is_zero();
    let lengths = if is_single { lengths.to_string() } else { format!("({lengths})") };
    let is_one = factor.as_rational().is_some_and(|one| one.is_one());
    if is_one { lengths } else { format!("{} {lengths}", set(factor)) }
}

/// Where the lengths factor out, in which direction what is left points.
pub(super) fn left_sentence(verdict: &OpenVerdict) -> Option<String> {
    let Left::Factored { factor, lengths, direction, degrees } = family::left(verdict) else { return None };
    let bearing = Bearing { exact: direction, decimal: degrees };
    let factored = factored(&factor, &lengths, |form| format!("${}$", form.tex()));
    Some(format!("What is left: length = {factored}, angle {}.", bearing.prose()))
}
