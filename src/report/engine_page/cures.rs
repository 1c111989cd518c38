//! What cancels what is left, and what does it leave: counterweights for what turns with the crank, balancer shafts for the rest?

use std::cell::RefCell;

use num_rational::BigRational;

use super::super::calculation::percent;
use super::super::typeset::short;
use super::left::{is_as_built, left_vectors};
use super::weighing::{Weighed, Weighing};
use crate::engine::{Draft, Engine, LengthUnit};
use crate::loads::Arm;
use crate::order;
use crate::page::{Piece, Text, Unit, phrase};
use crate::proof::{Planar, Sense};
use crate::remedy::{self, Remedy, Request, Shaft, SmallOrders, Weight};
use crate::report::texts::engine as text;
use crate::verdict::{Judgement, OrderVerdict};

/// Orders of a crankshaft above this are usually left as they are.
const USUALLY_CURED: u32 = 2;

/// Whether an order is usually cured: the first two of a crankshaft, of which one may turn faster than the reference.
pub(in crate::report) fn is_usually_cured(engine: &Engine, order: u32) -> bool {
    let speeds = engine.geared_cranks().iter().map(|crank| crank.speed);
    [1].into_iter().chain(speeds).any(|speed| order.is_multiple_of(speed) && order / speed <= USUALLY_CURED)
}

/// Sizes that differ by less than this part are printed alike.
const ALIKE: f64 = 1e-6;

/// What cancels what is left.
pub(super) struct Cures<'a> {
    engine: &'a Engine,
    cured: Vec<&'a OrderVerdict>,
    accepted: Vec<&'a OrderVerdict>,
    weighed: Option<&'a Weighed<'a>>,
    remedy: Option<Remedy>,
    /// The distances of weights that are reported already.
    told: RefCell<Vec<BigRational>>,
}

impl<'a> Cures<'a> {
    pub fn new(
        engine: &'a Engine,
        judged: &Judgement,
        orders: &[&'a OrderVerdict],
        weighed: Option<&'a Weighed>,
    ) -> Self {
        let worth_it: Vec<&OrderVerdict> = orders.iter().copied().filter(|order| is_worth_it(order, weighed)).collect();
        let asks_for_all = weighed.is_some_and(Weighed::asks_for_all);
        let is_cured = |order: &&OrderVerdict| asks_for_all || is_usually_cured(engine, order.order);
        let (cured, accepted): (Vec<&OrderVerdict>, Vec<&OrderVerdict>) = worth_it.into_iter().partition(is_cured);
        let request = Request { orders: cured.iter().map(|order| order.order).collect(), ..Request::default() };
        let is_sized = is_as_built(engine, judged) || judged.masses == crate::order::Masses::Reciprocating;
        let remedy = weighed.filter(|_| is_sized).and_then(|weighed| {
            // The outermost bearings are the ends of the shaft, between which weights are.
            let draft = Draft { bearings: engine.bearings().to_vec(), ..weighed.engine.clone().into_draft() };
            remedy::remedy(&draft.build().ok()?, &request).ok()
        });
        Cures { engine, cured, accepted, weighed, remedy, told: RefCell::default() }
    }

    /// A sentence each; none where nothing is left.
    pub fn line(&self) -> Option<Text> {
        let mut cures: Vec<Text> = self.cured.iter().filter_map(|order| self.of(order).sentence()).collect();
        cures.extend(self.usually_left());
        (!cures.is_empty()).then(|| text::cures(Text::joined(cures, " ")))
    }

    /// The orders above 2 that stand out, each beside the largest of its kind.
    fn usually_left(&self) -> Option<Text> {
        let named = |order: &&OrderVerdict| match self.weighed.and_then(|weighed| weighed.part(order.order)) {
            Some(part) => phrase!("{} ({} %)", order.order, percent(part)),
            None => order.order.into(),
        };
        match self.accepted.as_slice() {
            [] => None,
            [only] => Some(text::uncorrected_order(named(only))),
            several => Some(text::uncorrected_orders(Text::joined(several.iter().map(named), ", "))),
        }
    }

    /// What cures an order, a step after the other, and which of its vectors each step leaves.
    pub fn steps(&self, order: &OrderVerdict) -> Vec<(Text, [bool; 2])> {
        match self.cured.iter().any(|cured| cured.order == order.order) {
            true => {
                self.of(order).steps().into_iter().map(|(means, kept)| (self.of(order).named(means), kept)).collect()
            }
            false => Vec::new(),
        }
    }

    /// Whether an order stands out, and is usually left as it is.
    pub fn is_accepted(&self, order: &OrderVerdict) -> bool {
        self.accepted.iter().any(|accepted| accepted.order == order.order)
    }

    fn of<'b>(&'b self, order: &'b OrderVerdict) -> Cure<'b> {
        Cure { engine: self.engine, order, told: &self.told, weighed: self.weighed, remedy: self.remedy.as_ref() }
    }
}

/// Of these orders those that weights are proposed for, and those that are too small: above the second one an order counts from the threshold
/// on, unless it was asked for. One that vanishes is never too small: that is proved of the corrected engine too.
pub fn worth_curing(engine: &Engine, orders: Vec<u32>, weighing: &Weighing) -> (Vec<u32>, SmallOrders) {
    let weighed = Weighed::new(engine, order::masses_as_built(engine), &orders, weighing);
    let is_small = |weighed: &Weighed, order: u32| {
        let sizes = Planar::BOTH.map(|quantity| (weighed.size(order, quantity), quantity));
        sizes.iter().any(|(size, _)| *size > 0.0) && !sizes.iter().any(|(size, of)| weighed.is_worth_it(*size, *of))
    };
    let weighed = weighed.filter(|_| !weighing.tells_all(engine));
    let (small, worth): (Vec<u32>, Vec<u32>) = orders.into_iter().partition(|&order| {
        !is_usually_cured(engine, order) && weighed.as_ref().is_some_and(|weighed| is_small(weighed, order))
    });
    (worth, SmallOrders { below: weighing.above(engine), orders: small })
}

/// Whether an order is left, and large enough for a shaft.
fn is_worth_it(order: &OrderVerdict, weighed: Option<&Weighed>) -> bool {
    let is_large =
        |weighed: &Weighed, quantity: Planar| weighed.is_worth_it(weighed.size(order.order, quantity), quantity);
    left_vectors(order) != [false, false]
        && weighed.is_none_or(|weighed| Planar::BOTH.into_iter().any(|of| is_large(weighed, of)))
}

/// What cures an order.
struct Cure<'a> {
    engine: &'a Engine,
    order: &'a OrderVerdict,
    /// The distances of weights that are reported already.
    told: &'a RefCell<Vec<BigRational>>,
    weighed: Option<&'a Weighed<'a>>,
    remedy: Option<&'a Remedy>,
}

/// One step of a cure.
#[derive(Clone, Copy)]
enum Means {
    Counterweights,
    /// One that turns with the crank, or against it, at the speed of the order.
    Shaft(Sense),
    /// Two alike, or of sizes that are not known, one each way.
    Pair,
}

impl Cure<'_> {
    /// The steps, each with which vectors are kept after it: what is too small for a shaft is left.
    fn steps(&self) -> Vec<(Means, [bool; 2])> {
        const NOTHING: [bool; 2] = [false, false];
        const DIRECT: [bool; 2] = [true, false];
        const REVERSE: [bool; 2] = [false, true];
        let shaft = |sense| match sense {
            Sense::Direct => (Means::Shaft(Sense::Direct), REVERSE),
            Sense::Reverse => (Means::Shaft(Sense::Reverse), DIRECT),
        };
        let last = |sense| (Means::Shaft(sense), NOTHING);
        match (self.order.order, self.needed()) {
            (_, [false, false]) => Vec::new(),
            (1, [true, false]) => vec![(Means::Counterweights, REVERSE)],
            (1, [true, true]) => vec![(Means::Counterweights, REVERSE), last(Sense::Reverse)],
            (_, [true, false]) => vec![shaft(Sense::Direct)],
            (_, [false, true]) => vec![shaft(Sense::Reverse)],
            (_, [true, true]) => {
                let [with, against] = [REVERSE, DIRECT].map(|rest| self.decimal_left(rest));
                let equally_long = (with - against).abs() < ALIKE;
                match self.are_alike() {
                    // What a crankshaft can carry needs no shaft, and is told first.
                    _ if self.is_on_a_crankshaft(Sense::Direct) => vec![shaft(Sense::Direct), last(Sense::Reverse)],
                    _ if self.is_on_a_crankshaft(Sense::Reverse) => vec![shaft(Sense::Reverse), last(Sense::Direct)],
                    None => vec![(Means::Pair, NOTHING)],
                    Some(true) if equally_long => vec![(Means::Pair, NOTHING)],
                    // The one that cancels more stands first. Vectors of the force may be equally long where those of the moment differ.
                    Some(_) if equally_long || with < against => vec![shaft(Sense::Direct), last(Sense::Reverse)],
                    Some(_) => vec![shaft(Sense::Reverse), last(Sense::Direct)],
                }
            }
        }
    }

    /// A step in a few words.
    fn named(&self, means: Means) -> Text {
        match means {
            Means::Counterweights => self.counterweights(),
            Means::Shaft(sense) => self.shaft(sense),
            Means::Pair => match self.size(Sense::Direct).filter(|_| self.are_alike().is_some()) {
                Some(size) => text::pair_of_size(times(self.order.order), size),
                None => text::pair(times(self.order.order)),
            },
        }
    }

    fn sentence(&self) -> Option<Text> {
        let order = self.order.order;
        let leaves = |kept: [bool; 2]| self.part_left(kept);
        Some(match *self.steps().as_slice() {
            [(Means::Counterweights, kept)] => text::first_order(self.counterweights(), leaves(kept)),
            [(Means::Counterweights, kept), (Means::Shaft(sense), _)] => {
                text::first_order_with_shaft(self.counterweights(), leaves(kept), self.shaft(sense))
            }
            [(Means::Shaft(sense), kept)] => {
                text::one_shaft(order, self.shaft(sense), !self.is_on_a_crankshaft(sense), leaves(kept))
            }
            [(first @ Means::Shaft(sense), kept), (last, _), ..] if self.is_on_a_crankshaft(sense) => {
                text::two_steps(order, self.named(first), leaves(kept), self.named(last))
            }
            [(Means::Shaft(sense), kept), ..] => {
                let other = if sense == Sense::Direct { Sense::Reverse } else { Sense::Direct };
                let [first, second] = [sense, other].map(|sense| self.size(sense).unwrap_or_default());
                text::two_shafts(order, times(order), sense, first, leaves(kept), second)
            }
            [(Means::Pair, _), ..] => text::pair_leaves(order, self.named(Means::Pair)),
            [(Means::Counterweights, _), ..] | [] => return None,
        })
    }

    /// Whether what takes both vectors away has the same sizes; none where one is not known, or too slight to be proposed.
    fn are_alike(&self) -> Option<bool> {
        // What is told of distances is told by the sentence itself.
        let told = || RefCell::default();
        let size = |sense| Some(Cure { told: &told(), ..*self }.size(sense)?.plain());
        Some(size(Sense::Direct)? == size(Sense::Reverse)?)
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
        // Of the force, where it is left.
        self.part_of(if self.order.force.is_left() { Planar::Force } else { Planar::Moment }, vectors)
    }

    fn part_of(&self, quantity: Planar, vectors: [bool; 2]) -> f64 {
        let Some(weighed) = self.weighed else { return 1.0 };
        let lengths = weighed.lengths(self.order.order, quantity);
        let kept: f64 = lengths.iter().zip(vectors).map(|(length, is_kept)| if is_kept { *length } else { 0.0 }).sum();
        kept / lengths.iter().sum::<f64>()
    }

    /// The same in percent.
    fn part_left(&self, vectors: [bool; 2]) -> Text {
        let is_left = vectors.into_iter().zip(left_vectors(self.order)).any(|(kept, left)| kept && left);
        match (is_left, self.weighed.is_some()) {
            (false, _) => "nothing".into(),
            (true, true) => {
                let [force, moment] = Planar::BOTH.map(|quantity| percent(self.part_of(quantity, vectors)));
                let both = Planar::BOTH.into_iter().all(|quantity| self.order.whole(quantity).is_left());
                match both && force != moment {
                    true => text::part_of_both(force, moment),
                    false => phrase!("{} %", percent(self.decimal_left(vectors))),
                }
            }
            (true, false) => text::other_part(),
        }
    }

    /// Counterweights with their sizes; where only a balancer shaft that turns with the crank is removed, that.
    fn counterweights(&self) -> Text {
        let goes = |remedy: &&Remedy| remedy.crankshaft.as_ref().is_some_and(|shaft| !remedy.stays(&shaft.weights));
        if self.remedy.filter(goes).is_some_and(|remedy| !remedy.changes_counterweights()) {
            return "balancer shafts with the crank (removed)".into();
        }
        match self.size(Sense::Direct) {
            Some(size) => phrase!("counterweights ({})", size),
            None => "counterweights".into(),
        }
    }

    /// Whether a crankshaft other than the reference turns like a shaft of the order.
    fn is_on_a_crankshaft(&self, sense: Sense) -> bool {
        self.engine.crank_turning(self.order.order, sense).is_some()
    }

    /// A shaft with its size.
    fn shaft(&self, sense: Sense) -> Text {
        // Counterweights on another crankshaft that turns so need no shaft.
        let crank = self.engine.crank_turning(self.order.order, sense);
        let shaft = match (crank, self.order.order, sense) {
            (Some(crank), ..) => phrase!("counterweights added on crankshaft {}", crank.name.clone()),
            (None, 1, _) => "a shaft against the crank".into(),
            (None, order, sense) => text::shaft(times(order), sense),
        };
        match self.size(sense) {
            Some(_) if self.is_removed(sense) => phrase!("the removal of {}", shaft),
            Some(size) => phrase!("{} ({})", shaft, size),
            None => shaft,
        }
    }

    /// What takes a vector away, in the remedy.
    fn shaft_of(&self, sense: Sense) -> Option<(&Remedy, &Shaft)> {
        let remedy = self.remedy?;
        let is_meant = |shaft: &&Shaft| (shaft.order, shaft.sense) == (self.order.order, sense);
        Some((remedy, remedy.crankshaft.iter().chain(&remedy.shafts).find(is_meant)?))
    }

    /// Whether weights of the layout are taken away for it, and none are left.
    fn is_removed(&self, sense: Sense) -> bool {
        let of = self.shaft_of(sense);
        of.is_some_and(|(remedy, shaft)| !shaft.weights.is_empty() && !remedy.stays(&shaft.weights))
    }

    /// The mass-radius of what takes a vector away.
    fn size(&self, sense: Sense) -> Option<Text> {
        let (remedy, shaft) = self.shaft_of(sense)?;
        if self.is_removed(sense) {
            return Some("removed".into());
        }
        let sizes = self.sizes(remedy, shaft)?;
        // What is there already takes the place of nothing that is added.
        let is_resized = shaft.weights.iter().any(|weight| remedy.resizes(weight));
        Some(if is_resized { phrase!("resized to {}", sizes) } else { sizes })
    }

    /// The mass-radius of each weight of a shaft, as it is built.
    fn sizes(&self, remedy: &Remedy, shaft: &Shaft) -> Option<Text> {
        let weights: Vec<Weight> = shaft.weights.iter().filter_map(|weight| remedy.as_built(weight)).collect();
        let sizes: Vec<f64> = weights.iter().filter_map(|weight| decimal(remedy, weight)).collect();
        let alike = |first: f64| sizes.iter().all(|other| (other - first).abs() <= ALIKE * first);
        match sizes.as_slice() {
            _ if sizes.len() != weights.len() => None,
            [] => None,
            [only] => Some(mass_radius(remedy, *only)),
            [first, _] if alike(*first) => {
                Some(self.with_distance(phrase!("2\u{a0}×\u{a0}{}", mass_radius(remedy, *first)), remedy, &weights))
            }
            [first, others @ ..] if alike(*first) => {
                Some(phrase!("{}\u{a0}×\u{a0}{}", others.len() + 1, mass_radius(remedy, *first)))
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
        if told.contains(&apart) {
            return sizes;
        }
        told.push(apart.clone());
        // Where masses are in kilograms, positions without a unit are in metres, as moments are.
        match Arm::of(remedy.subject.engine()) {
            Arm::Metre if remedy.subject.scale().is_some() || self.engine.length_unit() == LengthUnit::Metre => {
                let in_millimetres = Piece::Shortly(apart * BigRational::from_integer(1000.into()), Unit::MILLIMETRE);
                phrase!("{}, {} {} apart", sizes, in_millimetres, Unit::MILLIMETRE)
            }
            Arm::Metre | Arm::Spacing => phrase!("{}, {} a apart", sizes, short(&apart)),
        }
    }
}

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
