//! What cancels what is left, and what does it leave: counterweights for what turns with the crank, balancer shafts for the rest?

use std::cell::RefCell;

use num_rational::BigRational;

use super::super::calculation::percent;
use super::super::typeset::short;
use super::answer::{is_as_built, left_vectors};
use super::weighing::Weighed;
use crate::engine::{Engine, LengthUnit};
use crate::page::{Piece, Text, Unit, phrase};
use crate::proof::{Planar, Sense};
use crate::remedy::{self, Remedy, Request, Shaft, Weight};
use crate::verdict::{Judgement, OrderVerdict};

/// Orders above this are usually left as they are.
const USUALLY_CURED: u32 = 2;

/// Sizes that differ by less than this part are printed alike.
const ALIKE: f64 = 1e-6;

/// What cancels what is left; none where nothing is.
pub(super) fn line(
    engine: &Engine,
    judged: &Judgement,
    orders: &[&OrderVerdict],
    weighed: Option<&Weighed>,
) -> Option<Text> {
    let told: Vec<&OrderVerdict> = orders.iter().copied().filter(|order| is_worth_it(order, weighed)).collect();
    let is_cured = |order: &&OrderVerdict| order.order <= USUALLY_CURED || weighed.is_some_and(Weighed::asks_for_all);
    let (low, high): (Vec<&OrderVerdict>, Vec<&OrderVerdict>) = told.into_iter().partition(is_cured);
    let wish = Request { orders: low.iter().map(|order| order.order).collect(), ..Request::default() };
    let is_sized = is_as_built(engine, judged) || judged.masses == crate::order::Masses::Reciprocating;
    let remedy = weighed.filter(|_| is_sized).and_then(|weighed| remedy::remedy(&weighed.engine, &wish).ok());
    let told = RefCell::default();
    let mut cures: Vec<Text> = low
        .iter()
        .filter_map(|order| Cure { order, told: &told, weighed, remedy: remedy.as_ref() }.sentence())
        .collect();
    cures.extend(usually_left(&high));
    (!cures.is_empty()).then(|| phrase!("**What cures it.** {}", Text::joined(cures, " ")))
}

/// Whether an order is left, and large enough for a shaft.
fn is_worth_it(order: &OrderVerdict, weighed: Option<&Weighed>) -> bool {
    let is_large =
        |weighed: &Weighed, quantity: Planar| weighed.is_worth_it(weighed.size(order.order, quantity), quantity);
    left_vectors(order) != [false, false]
        && weighed.is_none_or(|weighed| Planar::BOTH.into_iter().any(|of| is_large(weighed, of)))
}

/// The orders above 2 that stand out.
fn usually_left(orders: &[&OrderVerdict]) -> Option<Text> {
    match orders {
        [] => None,
        [only] => Some(phrase!("Order {} is usually accepted.", only.order)),
        several => Some(phrase!(
            "Orders {} are usually accepted.",
            Text::joined(several.iter().map(|order| order.order.into()), ", ")
        )),
    }
}

/// What cures an order.
struct Cure<'a> {
    order: &'a OrderVerdict,
    /// The distances of weights that are reported already.
    told: &'a RefCell<Vec<BigRational>>,
    weighed: Option<&'a Weighed<'a>>,
    remedy: Option<&'a Remedy>,
}

impl Cure<'_> {
    fn sentence(&self) -> Option<Text> {
        let order = self.order.order;
        // What is too small for a shaft is left.
        let [direct, reverse] = self.needed();
        let leaves = |kept: [bool; 2]| self.part_left(kept);
        Some(match (order, direct, reverse) {
            (_, false, false) => return None,
            (1, true, false) => phrase!("Order 1: {} leave {}.", self.counterweights(), leaves([false, true])),
            (1, true, true) => phrase!(
                "Order 1: {} leave {}; with {}, nothing.",
                self.counterweights(),
                leaves([false, true]),
                self.shaft(Sense::Reverse)
            ),
            (_, true, false) => {
                phrase!("Order {}: {} leaves {}.", order, self.shaft(Sense::Direct), leaves([false, true]))
            }
            (_, false, true) => {
                phrase!("Order {}: {} leaves {}.", order, self.shaft(Sense::Reverse), leaves([true, false]))
            }
            (_, true, true) => self.pair(),
        })
    }

    /// What takes both vectors of an order above 1 away.
    fn pair(&self) -> Text {
        let (order, speed) = (self.order.order, || times(self.order.order));
        let [with, against] = [[false, true], [true, false]].map(|rest| self.decimal_left(rest));
        let [one, other] = Sense::BOTH.map(|sense| self.size(sense));
        let is_alike = (with - against).abs() < ALIKE;
        match (one, other) {
            (Some(one), Some(_)) if is_alike => {
                phrase!(
                    "Order {}: two shafts at {} crank speed, one each way (each {}), leave nothing.",
                    order,
                    speed(),
                    one
                )
            }
            // The one that cancels more stands first.
            (Some(one), Some(other)) => {
                let (sense, left, other) = match with < against {
                    true => (WITH, with, [one, other]),
                    false => (AGAINST, against, [other, one]),
                };
                let [first, second] = other;
                phrase!(sense, order, speed(), first, percent(left), second)
            }
            (None, _) | (_, None) => {
                phrase!("Order {}: two shafts at {} crank speed, one each way, leave nothing.", order, speed())
            }
        }
    }

    /// Which of both vectors are left, and large enough for a weight.
    fn needed(&self) -> [bool; 2] {
        let left = left_vectors(self.order);
        let Some(weighed) = self.weighed else { return left };
        [0, 1].map(|sense| {
            left[sense]
                && Planar::BOTH
                    .into_iter()
                    .any(|quantity| weighed.is_worth_it(weighed.lengths(self.order.order, quantity)[sense], quantity))
        })
    }

    /// Which part of the largest value these vectors make; 0 where they are not left.
    fn decimal_left(&self, vectors: [bool; 2]) -> f64 {
        let Some(weighed) = self.weighed else { return 1.0 };
        // Of the force, where it is left.
        let quantity = if self.order.force.is_left() { Planar::Force } else { Planar::Moment };
        let lengths = weighed.lengths(self.order.order, quantity);
        let kept: f64 = lengths.iter().zip(vectors).map(|(length, is_kept)| if is_kept { *length } else { 0.0 }).sum();
        kept / lengths.iter().sum::<f64>()
    }

    /// The same in percent.
    fn part_left(&self, vectors: [bool; 2]) -> Text {
        let is_left = vectors.into_iter().zip(left_vectors(self.order)).any(|(kept, left)| kept && left);
        match (is_left, self.weighed.is_some()) {
            (false, _) => "nothing".into(),
            (true, true) => phrase!("{} %", percent(self.decimal_left(vectors))),
            (true, false) => "the part that turns the other way".into(),
        }
    }

    fn counterweights(&self) -> Text {
        match self.size(Sense::Direct) {
            Some(size) => phrase!("counterweights ({})", size),
            None => "counterweights".into(),
        }
    }

    /// A shaft with its size.
    fn shaft(&self, sense: Sense) -> Text {
        let shaft = match (self.order.order, sense) {
            (1, _) => "a shaft against the crank".into(),
            (order, Sense::Direct) => phrase!("a shaft at {} crank speed with the crank", times(order)),
            (order, Sense::Reverse) => phrase!("a shaft at {} crank speed against the crank", times(order)),
        };
        match self.size(sense) {
            Some(size) => phrase!("{} ({})", shaft, size),
            None => shaft,
        }
    }

    /// The mass-radius of what takes a vector away.
    fn size(&self, sense: Sense) -> Option<Text> {
        let remedy = self.remedy?;
        let is_meant = |shaft: &&Shaft| (shaft.order, shaft.sense) == (self.order.order, sense);
        let shaft = remedy.crankshaft.iter().chain(&remedy.shafts).find(is_meant)?;
        let weights: Vec<Weight> = shaft.weights.iter().filter_map(|weight| remedy.as_built(weight)).collect();
        let sizes: Vec<f64> = weights.iter().filter_map(|weight| decimal(remedy, weight)).collect();
        let alike = |first: f64| sizes.iter().all(|other| (other - first).abs() <= ALIKE * first);
        match sizes.as_slice() {
            _ if sizes.len() != weights.len() => None,
            [] => None,
            [only] => Some(mass_radius(remedy, *only)),
            [first, _] if alike(*first) => {
                Some(self.with_distance(phrase!("2 × {}", mass_radius(remedy, *first)), remedy, &weights))
            }
            [first, others @ ..] if alike(*first) => {
                Some(phrase!("{} × {}", others.len() + 1, mass_radius(remedy, *first)))
            }
            several => {
                let sizes = Text::joined(several.iter().map(|size| mass_radius(remedy, *size)), " + ");
                Some(self.with_distance(sizes, remedy, &weights))
            }
        }
    }

    /// Weights with how far they stand apart, where that was not told before.
    fn with_distance(&self, sizes: Text, remedy: &Remedy, weights: &[Weight]) -> Text {
        let positions = || weights.iter().map(|weight| &weight.position);
        let apart = positions().max().zip(positions().min()).map(|(last, first)| last - first).unwrap_or_default();
        let mut told = self.told.borrow_mut();
        match (told.contains(&apart), remedy.subject.engine().length_unit()) {
            (true, _) => sizes,
            (false, unit) => {
                told.push(apart.clone());
                match unit {
                    LengthUnit::Metre => {
                        let in_millimetres =
                            Piece::Shortly(apart * BigRational::from_integer(1000.into()), Unit::MILLIMETRE);
                        phrase!("{}, {} {} apart", sizes, in_millimetres, Unit::MILLIMETRE)
                    }
                    LengthUnit::Spacing => phrase!("{}, {} a apart", sizes, short(&apart)),
                }
            }
        }
    }
}

const WITH: &str =
    "Order {}: a shaft at {} crank speed with the crank ({}) leaves {} %; with one the other way ({}), nothing.";
const AGAINST: &str =
    "Order {}: a shaft at {} crank speed against the crank ({}) leaves {} %; with one the other way ({}), nothing.";

/// In kilogram-metres, else in multiples of m r.
fn decimal(remedy: &Remedy, weight: &Weight) -> Option<f64> {
    match remedy.subject.scale() {
        Some(_) => weight.mass_radius(&remedy.subject),
        None => Some(weight.decimals(&remedy.subject)?[0]),
    }
}

fn mass_radius(remedy: &Remedy, value: f64) -> Text {
    let piece = match remedy.subject.scale() {
        Some(_) => Piece::Quantity(value * 1000.0, Unit::KILOGRAM_MILLIMETRE),
        None => Piece::Quantity(value, Unit::MASS_RADIUS),
    };
    piece.into()
}

fn times(order: u32) -> Text {
    match order {
        2 => "twice".into(),
        3 => "three times".into(),
        4 => "four times".into(),
        6 => "six times".into(),
        other => phrase!("{} times", other),
    }
}
