//! How is it put where on the circle a sum in one unknown vanishes?

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use super::super::typeset;
use super::unknowns::{NEVER, alternatives, open_angle, unknowns, zero_where};
use crate::engine::Linear;
use crate::exact::Turn;
use crate::family::{Circle, Closed, Place, is_in_range};
use crate::numbers;
use crate::page::number::Bearing;
use crate::page::{Piece, Text, phrase};
use crate::proof::CoprimeClaim;
use crate::report::texts::family as text;

/// `0 where φ ≡ 60°, or φ ≈ 75.52°`, and where it is not known; `never 0` where it has no zero.
pub(super) fn condition(circle: &Circle) -> Text {
    zero_where(zeros(circle), open(circle)).unwrap_or_else(|| none_of(Some(circle)))
}

/// Where it is not known.
pub(super) fn open(circle: &Circle) -> impl Iterator<Item = Text> + '_ {
    circle.open().map(|ends| {
        let [from, to] = about(ends);
        text::open_arc(unknown(circle), from, to)
    })
}

/// `φ ≡ 60°, or φ ≈ 75.52°`: closed forms where there are such; none where no zero is known.
pub(super) fn zeros(circle: &Circle) -> Option<Text> {
    let unknown = unknown(circle);
    let times = [circle.polynomial.phi.clone(), circle.polynomial.delta.clone()];
    let is_meant =
        |ends: [&BigRational; 2]| is_in_range(&[Place { times: times.clone(), ends: ends.map(Clone::clone) }]);
    let rational = circle.rational().filter(|turn| is_meant([turn.turns(); 2]));
    let rational: Vec<String> = rational.map(|turn| format!("{unknown} ≡ {}", typeset::angle(&turn))).collect();
    let irrational: Vec<f64> = circle.irrational().filter(|ends| is_meant(*ends)).map(middle).collect();
    let closed = circle.closed().filter(|_| rational.is_empty());
    let told = match (closed, irrational.as_slice()) {
        (Some(Closed::Argument(direction)), [decimal]) => {
            let decimal = if *decimal > 180.0 { decimal - 360.0 } else { *decimal };
            vec![phrase!("{} ≡ {}", unknown, Bearing { exact: Some(direction), decimal })]
        }
        (Some(Closed::Cosine { turn, cosine }), [_, ..]) if circle.irrational().count() == 2 => {
            let (phi, delta) = (&circle.polynomial.phi, &circle.polynomial.delta);
            let turned = Linear::constant(turn.turns().clone());
            let of_unknown = |name: &str, times: &BigRational| Linear::symbol(name, times.clone());
            let argument = of_unknown(crate::engine::PHI, phi).plus(&of_unknown(crate::engine::DELTA, delta));
            let argument = open_angle(&argument.plus(&turned));
            let degrees = signed(&times, &turn, libm::acos(cosine.to_float()).to_degrees());
            let value = Text::from(Piece::Form(cosine));
            vec![phrase!("cos({}) = {}, {} ≈ {}", argument.clone(), value, argument, degrees)]
        }
        (Some(Closed::Argument(_) | Closed::Cosine { .. }) | None, irrational) => {
            let decimals = irrational.iter().map(|at| format!("{unknown} ≈ {}°", typeset::decimal(*at)));
            rational.into_iter().chain(decimals).map(Text::label).collect()
        }
    };
    alternatives(told)
}

/// `±75.52°`, the angle of which a cosine is known that is of multiples of φ and δ and a turn; without the sign that no φ and δ in the range make.
pub(super) fn signed(times: &[BigRational; 2], turn: &Turn, degrees: f64) -> String {
    let ahead = 360.0 * numbers::float(turn.turns());
    let is_there = |degrees: f64| is_in_range(&[Place::near(times, degrees - ahead)]);
    let sign = match (is_there(degrees), is_there(-degrees)) {
        (true, false) => "",
        (false, true) => "−",
        (true, true) | (false, false) => "±",
    };
    format!("{sign}{}°", typeset::decimal(degrees))
}

/// Why it vanishes there, and nowhere else.
pub(super) fn why(circle: &Circle) -> Text {
    let (unknown, count) = (unknown(circle), circle.claim.arcs.len());
    let sum = match &circle.claim.divided {
        None => text::polynomial(circle.polynomial.degree().to_string(), unknown),
        Some(divided) => text::common_polynomial(
            divided.equalities.len().saturating_sub(1).to_string(),
            unknown,
            circle.polynomial.degree().to_string(),
            divided.coprime.prime.to_string(),
        ),
    };
    let arcs = match (zeros(circle), circle.is_complete()) {
        (Some(zeros), true) => text::zeros_on_arcs(count, zeros),
        (None, true) => text::no_zero_on_arcs(count),
        (Some(zeros), false) => text::zeros_but_for_open(count, zeros),
        (None, false) => text::no_zero_but_for_open(count),
    };
    let only = circle.irrational().map(|near| {
        let [from, to] = between(circle, near);
        text::vanishes_once(from, to)
    });
    let open = circle.open().map(|ends| {
        let [from, to] = about(ends);
        text::left_open(from, to)
    });
    Text::joined([sum, arcs].into_iter().chain(only).chain(open), " ")
}

/// Why a sum vanishes nowhere, by a prime.
pub(super) fn coprime(found: &CoprimeClaim) -> Text {
    text::coprime(found.prime.to_string(), unknowns(&found.phi, &found.delta))
}

fn unknown(circle: &Circle) -> String {
    unknowns(&circle.polynomial.phi, &circle.polynomial.delta)
}

/// In degrees from 0 on.
pub(super) fn middle([low, high]: [&BigRational; 2]) -> f64 {
    let middle = (low + high) / BigRational::from_integer(2.into());
    numbers::float(&degrees(&(&middle - middle.floor())))
}

fn degrees(turns: &BigRational) -> BigRational {
    turns * BigRational::from_integer(360.into())
}

/// Turns in degrees with this many places, up or down.
fn rounded(turns: &BigRational, places: u32, up: bool) -> BigRational {
    let units = BigRational::from_integer(BigInt::from(10).pow(places));
    let scaled = degrees(turns) * &units;
    (if up { scaled.ceil() } else { scaled.floor() }) / units
}

/// Degrees about a range that is open.
pub(super) fn about(ends: [&BigRational; 2]) -> [String; 2] {
    [(ends[0], false), (ends[1], true)].map(|(end, up)| typeset::degrees(&rounded(end, 4, up)))
}

/// Degrees about an irrational zero, with as few places as keep every other zero out.
pub(super) fn between(circle: &Circle, near: [&BigRational; 2]) -> [String; 2] {
    let rational: Vec<BigRational> = circle.rational().map(|turn| turn.turns().clone()).collect();
    let others = circle.irrational().chain(circle.open()).filter(|ends| *ends != near);
    let others: Vec<[BigRational; 2]> = others
        .map(|ends| ends.map(Clone::clone))
        .chain(rational.into_iter().map(|at| [at.clone(), at]))
        .flat_map(|[low, high]| {
            [-1, 0, 1].map(|turns| BigRational::from_integer(turns.into())).map(|by| [&low + &by, &high + &by])
        })
        .map(|ends| ends.map(|end| degrees(&end)))
        .collect();
    let ends = |places: u32| [rounded(near[0], places, false), rounded(near[1], places, true)];
    let is_alone = |[from, to]: &[BigRational; 2]| {
        to - from < BigRational::one() && others.iter().all(|[low, high]| high < from || to < low)
    };
    let found = (1..12).map(ends).find(is_alone).unwrap_or_else(|| near.map(degrees));
    found.map(|end| typeset::degrees(&end))
}

/// What is said where no zero is reported.
pub(super) fn none_of(circle: Option<&Circle>) -> Text {
    if circle.is_some_and(|circle| !circle.is_free()) { NEVER.into() } else { "never 0".into() }
}
