//! How large is it in newtons? Decimals only: the exact factor of the star times m r ω² c_k.

use num_rational::BigRational;
use num_traits::Zero;

use super::answer::{Answer, Evidence, Status};
use super::compare::{half_of_lengths, half_width};
use super::condition::of;
use super::finding::{Absolute, Finding};
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

/// Answers a claim in newtons or newton-metres.
pub(super) fn answer(
    engine: &Engine,
    subject: Subject,
    order: &OrderBalance,
    value: &Value,
    numbers: Option<&Numbers>,
    evidence: Vec<Evidence>,
) -> Answer {
    let balance = if subject.quantity == Quantity::MOMENT { &order.moment } else { &order.force };
    let vanishes = match subject.sense {
        None => balance.is_balanced(),
        Some(sense) => of(balance, sense).vanishes(),
    };
    let claims_nothing = value.form.as_rational().is_some_and(|claimed| claimed.is_zero());
    let Some(numbers) = numbers.cloned().or_else(|| Numbers::of(engine, subject.order)) else {
        return Answer::nothing("a value in N or N·m needs the table numbers");
    };
    let empty = crate::exact::PhasorSum::new(Vec::new());
    let sums = match subject.sense {
        None => [&balance.direct.sum, &balance.reverse.sum],
        Some(sense) => [&of(balance, sense).sum, &empty],
    };
    let star = half_of_lengths(sums).1;
    let arm = match (subject.quantity, engine.length_unit(), &numbers.spacing) {
        (Quantity::MOMENT, LengthUnit::Spacing, None) => return Answer::nothing("a value in N·m needs the spacing"),
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
    let Some((first, whole)) = coefficient(subject.order, &(&numbers.crank_radius / &numbers.rod_length)) else {
        return Answer::nothing("the rod has to be longer than the crank radius");
    };
    let (first_term, whole) = (scale * first.abs(), scale * whole.abs());
    let claimed = value.form.to_float();
    let takes_first = (claimed - first_term).abs() <= (claimed - whole).abs();
    let off = (claimed - if takes_first { first_term } else { whole }).abs();
    let Some(within) = half_width(value) else {
        return Answer::nothing("newtons are known in decimals: give decimals, or give a tolerance");
    };
    // Whether nothing is left is decided by the exact sums; only sizes are compared in decimals.
    let status = match (claims_nothing, vanishes) {
        (true, true) => Status::True,
        (true, false) | (false, true) => Status::False,
        (false, false) if off <= within => Status::True,
        (false, false) => Status::False,
    };
    let absolute = Absolute { first_term, whole, takes_first };
    Answer { status, finding: Finding::Absolute(Box::new(order.clone()), absolute), evidence }
}

/// c_k of a centric crank: the first term of its series, and the sum (theory, section 2); none of a crank that cannot turn.
fn coefficient(order: u32, ratio: &BigRational) -> Option<(f64, f64)> {
    let crank = SliderCrank::new(ratio.clone(), BigRational::zero()).ok()?;
    Some((numbers::float(&motion::series(order, 1).value(ratio)), crank.coefficient(order).re.to_float()))
}
