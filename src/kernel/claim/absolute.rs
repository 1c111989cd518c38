//! How large is it in newtons? Decimals only: the exact factor of the star times m r ω² c_k.

use num_rational::BigRational;
use num_traits::Zero;

use super::answer::{Condition, Status};
use super::compare::{half_of_lengths, half_width, is_exact_zero};
use super::condition::of;
use super::finding::Absolute;
use super::statement::{Subject, Value};
use crate::engine::{Engine, LengthUnit};
use crate::motion::{self, SliderCrank};
use crate::numbers;
use crate::proof::Quantity;
use crate::verdict::OrderBalance;

/// What an engine weighs and measures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Numbers {
    /// Reciprocating mass that the layout's masses are multiples of, in kilograms.
    pub reciprocating_mass: BigRational,
    /// Crank radius r in metres.
    pub crank_radius: BigRational,
    /// Rod length l in metres.
    pub rod_length: BigRational,
    /// Speed in revolutions a minute.
    pub speed: BigRational,
    /// Spacing in metres that the layout's positions are multiples of; none where they are in metres.
    pub spacing: Option<BigRational>,
}

impl Numbers {
    /// What a layout file says itself, where all rods are alike and without offset; in order 1 it is enough that none has an
    /// offset, and no link a corrected knuckle angle, for `c_1 = 1` then.
    fn of(engine: &Engine, order: u32) -> Option<Self> {
        let mechanism = engine.dimensions();
        mechanism.mass.as_ref()?;
        let rod = engine.rods().next().filter(|rod| rod.offset.is_zero() && !rod.ratio.is_zero())?;
        let crank_radius = mechanism.crank_radius.clone()?;
        let are_alike = engine.mechanisms().len() == 1;
        (are_alike || (order == 1 && engine.is_centric())).then_some(())?;
        Some(Numbers {
            reciprocating_mass: engine.unit_mass(),
            rod_length: &crank_radius / &rod.ratio,
            crank_radius,
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
    let numbers = numbers.cloned().or_else(|| Numbers::of(engine, subject.order));
    let numbers = numbers.ok_or("a value in N or N·m needs the table numbers")?;
    // Whether nothing is left is decided by the exact sums; only sizes are compared in decimals.
    let star = if vanishes { 0.0 } else { half_of_lengths(sums).1 };
    let arm = match (subject.quantity, engine.length_unit(), &numbers.spacing) {
        (Quantity::MOMENT, LengthUnit::Spacing, None) => return Err("a value in N·m needs the spacing"),
        (Quantity::MOMENT, LengthUnit::Spacing, Some(spacing)) => numbers::float(spacing),
        _ => 1.0,
    };
    let omega = numbers::angular_speed(numbers::float(&numbers.speed));
    let scale = star
        * numbers::float(&numbers.reciprocating_mass)
        * numbers::float(&numbers.crank_radius)
        * omega
        * omega
        * arm;
    let (first, whole) = coefficient(subject.order, &(&numbers.crank_radius / &numbers.rod_length))
        .ok_or("the rod has to be longer than the crank radius")?;
    let absolute = Absolute { first_term: scale * first.abs(), whole: scale * whole.abs() };
    if is_exact_zero(value) {
        return Ok((Status::of(vanishes), absolute));
    }
    let within = half_width(value).ok_or("newtons are known in decimals: give decimals, or give a tolerance")?;
    let is_within = |known: f64| (value.form.to_float() - known).abs() <= within;
    let status = match (is_within(absolute.whole), is_within(absolute.first_term)) {
        (true, _) => Status::True,
        // As books take c_k, c_2 = r/l: the answer says that it is the first term alone.
        (false, true) => Status::TrueOnlyIf { conditions: vec![Condition::FirstTermAlone], met: true },
        (false, false) => Status::False,
    };
    Ok((status, absolute))
}

/// c_k of a centric crank: the first term of its series, and the sum (theory, section 2); none of a crank that cannot turn.
fn coefficient(order: u32, ratio: &BigRational) -> Option<(f64, f64)> {
    let crank = SliderCrank::new(ratio.clone(), BigRational::zero()).ok()?;
    Some((numbers::float(&motion::series(order, 1).value(ratio)), crank.coefficient(order).re.to_float()))
}
