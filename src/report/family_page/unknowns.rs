//! How is an angle or a length with unknowns written?

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::super::typeset;
use crate::engine::{DELTA, Family, Linear, PHI};
use crate::exact::Turn;
use crate::family::in_range;
use crate::page::{Text, phrase};
use crate::proof::ConditionClaim;

/// `2φ − δ ≡ 180°`.
pub(super) fn exactly(unknowns: String, turn: &Turn) -> String {
    format!("{unknowns} ≡ {}", typeset::angle(turn))
}

/// Where there is no angle in the range.
pub(super) const NEVER: &str = "never 0 in (0°, 360°)";

/// `φ ≡ 60° and δ ≡ 90°`; none where no φ and δ in the range make it.
pub(super) fn together(conditions: &[ConditionClaim], shown: fn(String, &Turn) -> String) -> Option<Text> {
    let one = |ConditionClaim { phi, delta, turn }: &ConditionClaim| {
        let turn = Turn::new(turn.clone());
        // φ, or else δ, is shown entering positively.
        Text::label(match phi.is_negative() || phi.is_zero() && delta.is_negative() {
            true => shown(unknowns(&-phi, &-delta), &-&turn),
            false => shown(unknowns(phi, delta), &turn),
        })
    };
    in_range(conditions).map(|conditions| Text::joined(conditions.iter().map(one), " and "))
}

/// `2φ − δ`.
pub(in crate::report) fn unknowns(phi: &BigRational, delta: &BigRational) -> String {
    let parts = [(PHI, phi), (DELTA, delta)].map(|(name, factor)| Linear::symbol(name, factor.clone()));
    match parts.map(|part| (part != Linear::default()).then(|| greek(&part))) {
        [None, None] => "0".to_owned(),
        [Some(only), None] | [None, Some(only)] => only,
        [Some(phi), Some(delta)] => format!("{phi} + {delta}").replace("+ −", "− "),
    }
}

/// The one open angle of a family, φ or δ; none where two are open, or lengths alone.
pub(in crate::report) fn only_open_angle(family: &Family) -> Option<&'static str> {
    let open = family.open_angles();
    match [PHI, DELTA].map(|angle| open.contains(angle)) {
        [true, false] => Some(PHI),
        [false, true] => Some(DELTA),
        [true, true] | [false, false] => None,
    }
}

/// An angle with unknowns, given in turns: `45° + φ/2`; the known part in `(−180°, 180°]`.
pub(super) fn open_angle(angle: &Linear) -> String {
    written(angle, typeset::degrees(&typeset::signed_degrees(&Turn::new(angle.known().clone()))))
}

/// The same with its known part as it is written there.
pub(in crate::report) fn written(angle: &Linear, known: String) -> String {
    let symbols = angle.minus(&Linear::constant(angle.known().clone()));
    // Whole turns are written as none.
    match (symbols == Linear::default(), angle.known().is_zero() || known == "0°") {
        (true, _) => known,
        (false, true) => greek(&symbols),
        (false, false) => format!("{known} + {}", greek(&symbols)).replace("+ −", "− "),
    }
}

pub(in crate::report) fn greek(linear: &Linear) -> String {
    linear.to_string().replace(PHI, "φ").replace(DELTA, "δ")
}

/// A length with symbols.
pub(super) fn open_length(length: &Linear) -> String {
    match length.as_known() {
        Some(known) => typeset::number(known),
        None => length.to_string(),
    }
}

/// Alternatives in a row; none where there is none.
pub(super) fn alternatives(told: impl IntoIterator<Item = Text>) -> Option<Text> {
    let told = Text::joined(told, ", or ");
    (!told.is_empty()).then_some(told)
}

/// `0 where φ ≡ 60°`, and where it is not known; none where neither is told.
pub(super) fn zero_where(zeros: Option<Text>, open: impl IntoIterator<Item = Text>) -> Option<Text> {
    let zeros = zeros.map(|zeros| phrase!("0 where {}", zeros));
    let told = Text::joined(zeros.into_iter().chain(open), "; ");
    (!told.is_empty()).then_some(told)
}

/// The names of two unknowns.
pub(super) fn names(both: [&[BigRational; 2]; 2]) -> [String; 2] {
    both.map(name)
}

pub(super) fn name([phi, delta]: &[BigRational; 2]) -> String {
    unknowns(phi, delta)
}

pub(super) fn near(name: &str, degrees: f64) -> Text {
    Text::label(format!("{name} ≈ {}°", typeset::decimal(degrees)))
}
