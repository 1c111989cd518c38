//! How large is it in newtons? Decimals only: the exact factor of the star times m r ω² c_k.

use num_rational::BigRational;
use num_traits::Zero;

use super::answer::{Condition, Status};
use super::compare::{half_of_lengths, half_width, is_exact_zero};
use super::condition::of;
use super::finding::Absolute;
use super::statement::{Subject, Value};
use crate::engine::{Engine, Rod};
use crate::motion::{self, SliderCrank};
use crate::numbers;
use crate::order::Factor;
use crate::proof::Quantity;
use crate::verdict::OrderBalance;

const NO_NUMBERS: &str = "a value in N or N·m needs the mass, the crank radius, the rods and the speed: in the layout, the rods alike, or as \
    `numbers` of the claim";
const OF_CENTRIC_RODS: &str =
    "`numbers` are those of rods without an offset: give the sizes of this engine in its layout";

/// What an engine weighs and measures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Numbers {
    /// Reciprocating mass that the layout's masses are multiples of, in kilograms.
    pub reciprocating_mass: BigRational,
    /// Crank radius r in metres.
    pub crank_radius: BigRational,
    /// The rod of all pistons.
    pub rod: Rod,
    /// Speed in revolutions a minute.
    pub speed: BigRational,
    /// Spacing in metres that the layout's positions are multiples of; none where they are in metres.
    pub spacing: Option<BigRational>,
}

impl Numbers {
    /// What a layout file says itself, where all rods are alike; in order 1 it is enough that none has an offset, and no link a corrected
    /// knuckle angle, for `c_1 = 1` then.
    fn of(engine: &Engine, order: u32) -> Option<Self> {
        let mechanism = engine.dimensions();
        mechanism.mass.as_ref()?;
        let are_alike = engine.mechanisms().len() == 1;
        (are_alike || (order == 1 && engine.is_centric())).then_some(())?;
        Some(Numbers {
            reciprocating_mass: engine.unit_mass(),
            rod: engine.rods().next()?.clone(),
            crank_radius: mechanism.crank_radius.clone()?,
            speed: mechanism.speed.clone()?,
            spacing: engine.positions_given().then(|| BigRational::from_integer(1.into())),
        })
    }
}

/// Whether the largest value is the claimed one in newtons or newton-metres, and what it is.
///
/// # Errors
/// What is missing.
pub(super) fn answer(
    engine: &Engine,
    subject: Subject,
    order: &OrderBalance,
    value: &Value,
    numbers: Option<&Numbers>,
) -> Result<(Status, Absolute), &'static str> {
    let balance = if subject.quantity == Quantity::MOMENT { &order.moment } else { &order.force };
    let empty = crate::exact::PhasorSum::new(Vec::new());
    let (vanishes, sums) = match subject.sense {
        None => (balance.is_balanced(), [&balance.direct.sum, &balance.reverse.sum]),
        Some(sense) => (of(balance, sense).vanishes(), [&of(balance, sense).sum, &empty]),
    };
    let numbers = match numbers {
        Some(_) if !engine.is_centric() => return Err(OF_CENTRIC_RODS),
        Some(numbers) => numbers.clone(),
        None => Numbers::of(engine, subject.order).ok_or(NO_NUMBERS)?,
    };
    // Whether nothing is left is decided by the exact sums; only sizes are compared in decimals.
    let star = if vanishes { 0.0 } else { half_of_lengths(sums).1 };
    let arm = match (subject.quantity, &numbers.spacing) {
        (Quantity::MOMENT, _) if engine.is_in_metres() => 1.0,
        (Quantity::MOMENT, None) => return Err("a value in N·m needs the spacing"),
        (Quantity::MOMENT, Some(spacing)) => numbers::float(spacing),
        _ => 1.0,
    };
    let omega = numbers::angular_speed(numbers::float(&numbers.speed));
    let scale = star
        * numbers::float(&numbers.reciprocating_mass)
        * numbers::float(&numbers.crank_radius)
        * omega
        * omega
        * arm;
    let (first, whole) = match order.factor.own(subject.order) {
        // Of masses that turn, or in order 1 of centric rods.
        (Factor::One, _) => (None, 1.0),
        (_, own_order) => coefficient(own_order, &numbers.rod)?,
    };
    let absolute = Absolute { first_term: first.map(|first| scale * first), whole: scale * whole };
    if is_exact_zero(value) {
        // At rest nothing shakes.
        let parts = [&numbers.speed, &numbers.reciprocating_mass, &numbers.crank_radius];
        let is_none = parts.into_iter().any(|part| part.is_zero());
        return Ok((Status::of(vanishes || is_none), absolute));
    }
    let within = half_width(value).ok_or("newtons are known in decimals: give decimals, or give a tolerance")?;
    let is_within = |known: f64| (value.form.to_float() - known).abs() <= within;
    let status = match (is_within(absolute.whole), absolute.first_term.is_some_and(is_within)) {
        (true, _) => Status::True,
        // As books take c_k, c_2 = r/l: the answer says that it is the first term alone.
        (false, true) => Status::TrueOnlyIf { conditions: vec![Condition::FirstTermAlone], met: true },
        (false, false) => Status::False,
    };
    Ok((status, absolute))
}

/// The size of c_k: by the first term of its series, above order 1 of a centric crank, and in all (theory, section 2).
fn coefficient(order: u32, rod: &Rod) -> Result<(Option<f64>, f64), &'static str> {
    let crank = SliderCrank::new(rod.ratio.clone(), rod.offset.clone());
    let number = crank.map_err(|_| "the rod has to be longer than the crank radius")?.coefficient(order);
    let first = || numbers::float(&motion::series(order, 1).value(&rod.ratio)).abs();
    Ok(((order > 1 && rod.is_centric()).then(first), number.re.to_float().hypot(number.im.to_float())))
}
