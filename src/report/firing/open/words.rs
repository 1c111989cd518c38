//! In which words is it said for which angles an order of the gas torque vanishes?

use std::collections::BTreeSet;

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::super::super::family_page::{condition_of, only_open_angle, unknowns, written};
use super::super::super::residual;
use super::super::super::typeset::{self, Amount};
use super::OpenFiringStudy;
use crate::engine::{FiringSpan, Linear, NoSpans, PHI};
use crate::exact::Turn;
use crate::family::{OpenStar, SpanStar, When};
use crate::page::{Piece, Text, phrase};
use crate::report::texts::open_firing as text;

/// When a star vanishes, in a few words: zero, `never 0`, `0 at φ = 90°, 270°`.
pub(super) fn summary(study: &OpenFiringStudy<'_>, star: &OpenStar) -> Text {
    let spans = match &star.spans {
        Ok(spans) => spans,
        Err(NoSpans::NotSaid) => return "needs a firing order".into(),
        Err(NoSpans::TwoAngles) => return "not solved: two angles are open".into(),
        Err(NoSpans::TooWide) => return "not solved".into(),
    };
    match (spans.as_slice(), values(study, star)) {
        ([], _) => "cannot be fired".into(),
        _ if star.always() => Text::zero(),
        _ if star.never() => "never 0".into(),
        (_, Some(values)) => at(study, &values),
        ([only], None) => of_span(study, only),
        (several, None) => by_span(study, several.iter().map(|star| (star, of_span(study, star)))),
    }
}

/// The values in (0°, 360°) of the one open angle at which a star vanishes; none where it does for a whole range, or is not solved.
pub(super) fn values(study: &OpenFiringStudy<'_>, star: &OpenStar) -> Option<BTreeSet<BigRational>> {
    let [none, turn] = ends();
    star.values(only_open_angle(study.family)?, [&none, &turn]).map(inside)
}

/// From where to where the open angle runs.
fn ends() -> [BigRational; 2] {
    [BigRational::zero(), BigRational::one()]
}

/// The values without the ends.
fn inside(mut values: BTreeSet<BigRational>) -> BTreeSet<BigRational> {
    values.retain(|value| !ends().contains(value));
    values
}

/// When a star vanishes in one span.
pub(super) fn of_span(study: &OpenFiringStudy<'_>, star: &SpanStar) -> Text {
    let [none, turn] = ends();
    let values = only_open_angle(study.family).and_then(|unknown| star.values(unknown, [&none, &turn]));
    match (&star.sum.when, values) {
        (When::Always, _) => Text::zero(),
        (When::Never(_), _) => "never 0".into(),
        (_, Some(values)) => at(study, &inside(values)),
        (_, None) => condition_of(&star.sum).unwrap_or_else(Text::zero),
    }
}

fn at(study: &OpenFiringStudy<'_>, values: &BTreeSet<BigRational>) -> Text {
    let symbol = symbol(only_open_angle(study.family).unwrap_or(PHI));
    match values.is_empty() {
        true => "never 0 in (0°, 360°)".into(),
        false if symbol == "φ" => phrase!("0 at φ = {}", list(values)),
        false => phrase!("0 at δ = {}", list(values)),
    }
}

/// How long a star is, where that is reported in short: 0, a number, `6 |cos(3φ/4)|`.
pub(super) fn length(study: &OpenFiringStudy<'_>, star: &OpenStar) -> Text {
    let spans = star.spans.as_deref().unwrap_or_default();
    if star.always() {
        return Text::zero();
    }
    let lengths: Option<Vec<Text>> = spans.iter().map(length_of_span).collect();
    match (spans, lengths.as_deref()) {
        ([], _) | (_, None) => "–".into(),
        (_, Some([only])) => only.clone(),
        (spans, Some(several)) => by_span(study, spans.iter().zip(several.iter().cloned())),
    }
}

/// What is said of the star in each span.
fn by_span<'s>(study: &OpenFiringStudy<'_>, said: impl Iterator<Item = (&'s SpanStar, Text)>) -> Text {
    let each = said.map(|(star, words)| match label(study, &star.span) {
        Some(span) => phrase!("{} for {}", words, span),
        None => words,
    });
    Text::joined(each, "; ")
}

/// Of two equal parts, which cancel where `x ≡ t`: `|S_1| |e^{ix} − e^{it}| = 2 |S_1| |sin((x − t)/2)|`.
fn length_of_span(star: &SpanStar) -> Option<Text> {
    let parts: Vec<_> = star.sum.left().collect();
    let turning = match (parts.as_slice(), &star.sum.when) {
        ([], _) => return Some(Text::zero()),
        ([only], _) => return Some(residual::modulus_of(&only.sum).into()),
        ([_, _], When::Where(angles)) => angles.alternatives.first()?.conditions.first()?,
        _ => return None,
    };
    let half = BigRational::new(1.into(), 2.into());
    let sign =
        if turning.phi.is_negative() || turning.phi.is_zero() && turning.delta.is_negative() { -&half } else { half };
    let x = unknowns(&(&turning.phi * &sign), &(&turning.delta * &sign));
    let offset = typeset::signed_degrees(&Turn::new(turning.turn.clone())) * &sign;
    let quarter = BigRational::from_integer(90.into());
    let factor = match (offset.is_zero(), offset.abs() == quarter, offset.is_negative()) {
        (true, ..) => format!("|sin({x})|"),
        (_, true, _) => format!("|cos({x})|"),
        (.., true) => format!("|sin({x} + {})|", typeset::degrees(&-offset)),
        (.., false) => format!("|sin({x} − {})|", typeset::degrees(&offset)),
    };
    let length = residual::modulus_of(&parts[0].sum);
    let twice = Amount {
        exact: length.exact.map(|form| form.scaled(&BigRational::from_integer(2.into()))),
        decimal: 2.0 * length.decimal,
    };
    Some(match twice.exact.as_ref().filter(|form| form.as_rational().is_none()) {
        Some(form) => phrase!("{} {}", Piece::Form(form.clone()), factor),
        None => phrase!("{} {}", twice, factor),
    })
}

/// Angles in turns, in a row.
pub(super) fn list(values: &BTreeSet<BigRational>) -> String {
    typeset::listed(values.iter().map(typeset::turns))
}

pub(super) fn symbol(unknown: &str) -> &'static str {
    if unknown == PHI { "φ" } else { "δ" }
}

/// `0° < φ ≤ 120°`; none where a span holds all values.
pub(super) fn label(study: &OpenFiringStudy<'_>, span: &FiringSpan) -> Option<String> {
    let ([low, high], symbol) = (span.within.as_ref()?, symbol(only_open_angle(study.family)?));
    if low.at == high.at {
        return Some(format!("{symbol} = {}", typeset::turns(&low.at)));
    }
    let sign = |included: bool| if included { "≤" } else { "<" };
    let [from, to] = [low, high].map(|end| typeset::turns(&end.at));
    Some(format!("{from} {} {symbol} {} {to}", sign(low.included), sign(high.included)))
}

/// A crank angle with unknowns, given in turns, whole revolutions too: `360° + φ`.
pub(super) fn crank_angle(angle: &Linear) -> String {
    written(angle, typeset::turns(angle.known()))
}

/// Where the cylinders can fire in the order of the layout; none where it gives none, or where that is not solved.
pub(super) fn can_fire(study: &OpenFiringStudy<'_>) -> Option<Text> {
    let order = study.order()?;
    let [none, turn] = ends();
    let spans = match study.family.firing_spans([&none, &turn], false) {
        Ok(spans) => spans,
        Err(NoSpans::TwoAngles) => return Some(text::two_angles(order)),
        Err(NoSpans::TooWide) => return Some(text::too_wide(order)),
        Err(NoSpans::NotSaid) => return None,
    };
    let labels: Vec<String> = spans.iter().filter_map(|span| label(study, span)).collect();
    let is_everywhere =
        |span: &FiringSpan| span.within.as_ref().is_none_or(|[low, high]| low.at == none && high.at == turn);
    Some(match spans.as_slice() {
        [] => text::cannot_fire(order),
        [_] if only_open_angle(study.family).is_none() => text::fires(order),
        [only] if is_everywhere(only) => text::fires_everywhere(order),
        _ => text::fires_where(order, Text::joined(labels.into_iter().map(Text::label), " or ")),
    })
}
