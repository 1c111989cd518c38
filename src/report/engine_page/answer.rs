//! What shakes, how much, what cures it, and what no crankshaft can cure? What a reader sees first.

use super::super::calculation::Unit;
use super::super::{residual, table};
use super::{articulated, conventions, cures, geared};
use crate::engine::{DOES_NOT_EXIST, Engine, LengthUnit};
use crate::loads::{self, Loads};
use crate::order::{self, Factor, Masses};
use crate::page::{Block, Document, Piece, Table, Text, phrase};
use crate::proof::{Planar, Sense, Shape};
use crate::verdict::{EveryOrderTheorem, Judgement, NextLeft, OrderVerdict, Outcome, WholeOrder};

/// The lines of the box that a report opens with.
pub(super) fn lines(
    engine: &Engine,
    judged: &Judgement,
    loads: Option<&Loads>,
    theorem: Option<&EveryOrderTheorem>,
) -> Vec<Text> {
    let existing: Vec<&OrderVerdict> = judged.orders.iter().filter(|order| order.exists()).collect();
    let loads = loads.filter(|_| is_as_built(engine, judged));
    let sizes = Sizes { engine, masses: judged.masses, loads };
    let mut lines = Vec::new();
    let shaking: Vec<Text> = existing.iter().flat_map(|order| sizes.left(order)).collect();
    lines.extend((!shaking.is_empty()).then(|| phrase!("**What shakes.** {}", Text::joined(shaking, " "))));
    let cures = cures::cures(engine, judged, &existing);
    if !cures.is_empty() {
        lines.push(phrase!("**What cures it.** {}", Text::joined(cures, " ")));
        lines.push(phrase!("**What no crankshaft cures.** {}", beyond_counterweights(engine, &existing)));
    }
    lines.extend(rest(&judged.orders, &existing, theorem.filter(|theorem| theorem.masses() == judged.masses)));
    if let Some(pistons) = &judged.pistons {
        let sizes = Sizes { engine, masses: Masses::Reciprocating, loads: None };
        let left: Vec<Text> =
            pistons.iter().filter(|order| order.exists()).flat_map(|order| sizes.left(order)).collect();
        lines.push(match left.is_empty() {
            true => "**The pistons alone.** Nothing of them is left at these orders.".into(),
            false => phrase!("**The pistons alone.** {}", Text::joined(left, " ")),
        });
    }
    lines.extend(articulated::hidden(engine));
    lines
}

/// Whether the verdicts are about what the numbers are about.
pub(super) fn is_as_built(engine: &Engine, judged: &Judgement) -> bool {
    judged.not_as_built.is_none() && judged.masses == order::masses_as_built(engine)
}

/// How large what is left is.
struct Sizes<'a> {
    engine: &'a Engine,
    masses: Masses,
    loads: Option<&'a Loads>,
}

impl Sizes<'_> {
    /// A sentence each on the force and on the moment of an order, where they are left or not decided.
    fn left(&self, order: &OrderVerdict) -> Vec<Text> {
        let force = self.sentence(order, &order.force, Planar::Force, FORCE);
        let words = if order.force.is_balanced() { COUPLE } else { MOMENT };
        let moment = self.sentence(order, &order.moment, Planar::Moment, words);
        [force, moment].into_iter().flatten().collect()
    }

    fn sentence(
        &self,
        order: &OrderVerdict,
        whole: &WholeOrder,
        quantity: Planar,
        [sized, bare, open]: [&'static str; 3],
    ) -> Option<Text> {
        match (whole.shape, self.size(order, whole, quantity)) {
            (Shape::Balanced | Shape::DoesNotExist, _) => None,
            (Shape::NotDecided, _) if !whole.is_left() => Some(phrase!(open, order.order)),
            (Shape::NotDecided, _) => Some(phrase!(bare, order.order, "not 0")),
            (shape, Some(size)) => Some(phrase!(sized, order.order, size, residual::shape_name(shape))),
            (shape, None) => Some(phrase!(bare, order.order, residual::shape_name(shape))),
        }
    }

    /// The largest value: in newtons, or exactly in multiples.
    fn size(&self, order: &OrderVerdict, whole: &WholeOrder, quantity: Planar) -> Option<Text> {
        if let Some(loads) = self.loads {
            return in_units(self.engine, loads, order.order, quantity, whole);
        }
        let [only] = order.parts.as_slice() else { return None };
        let unit = match &only.class {
            None => multiple(self.engine, order.order, self.masses, quantity),
            Some(class) => multiple_of(self.engine, &class.factor, order.order, quantity),
        };
        Some(phrase!("{} {}", residual::largest(only.balance(quantity)), unit))
    }
}

const FORCE: [&str; 3] = [
    "Order {}: a force of {}, {}.",
    "Order {}: a force, {}.",
    "Whether the force of order {} vanishes is not decided.",
];
const COUPLE: [&str; 3] = [
    "Order {}: a couple of {}, {}.",
    "Order {}: a couple, {}.",
    "Whether the couple of order {} vanishes is not decided.",
];
const MOMENT: [&str; 3] = [
    "Order {}: a moment of {} about the reference plane, {}.",
    "Order {}: a moment about the reference plane, {}.",
    "Whether the moment of order {} vanishes is not decided.",
];

/// The largest value of an order with its unit; none where the numbers do not hold it.
fn in_units(engine: &Engine, loads: &Loads, order: u32, quantity: Planar, whole: &WholeOrder) -> Option<Text> {
    let of_order = loads.orders.iter().find(|of| of.order == order)?;
    let unit = Unit::of(engine, loads, quantity);
    let is_known = whole.outcomes.iter().all(|outcome| outcome.vanishes().is_some()) && unit.factor != 0.0;
    is_known.then(|| Piece::Quantity(of_order.swing(quantity).largest() * unit.factor, unit.unit).into())
}

/// What exact values are multiples of: `m r ω² c_4 a`.
fn multiple(engine: &Engine, order: u32, masses: Masses, quantity: Planar) -> Text {
    let pistons = matches!(masses, Masses::Reciprocating | Masses::All);
    let coefficient = pistons && (order > 1 || engine.has_offset());
    in_multiples(engine, coefficient.then_some(order), quantity)
}

/// The same of the only sum of an order, which stands before this number: that of the order of its own crankshaft.
fn multiple_of(engine: &Engine, factor: &Factor, order: u32, quantity: Planar) -> Text {
    let (own, order) = factor.own(order);
    in_multiples(engine, (*own != Factor::One).then_some(order), quantity)
}

/// Before c_k of this order, or before 1.
fn in_multiples(engine: &Engine, coefficient: Option<u32>, quantity: Planar) -> Text {
    let coefficient = coefficient.map_or_else(String::new, |order| format!(" c_{{{order}}}"));
    let mass = if engine.has_unit_masses() { "m\\,r\\,\\omega^2" } else { "\\mathrm{kg}\\;r\\,\\omega^2" };
    let arm = match (quantity, engine.length_unit()) {
        (Planar::Force, _) => "",
        (Planar::Moment, LengthUnit::Metre) => "\\cdot\\mathrm{m}",
        (Planar::Moment, LengthUnit::Spacing) => "\\,a",
    };
    Text::formula(format!("{mass}{coefficient}{arm}"))
}

/// Whether the direct and the reverse vector of force or moment are left.
pub(super) fn left_vectors(order: &OrderVerdict) -> [bool; 2] {
    let is_left = |outcome: &Outcome| outcome.vanishes() == Some(false);
    [0, 1].map(|sense| is_left(&order.force.outcomes[sense]) || is_left(&order.moment.outcomes[sense]))
}

/// What counterweights on the crankshaft cannot reach.
fn beyond_counterweights(engine: &Engine, orders: &[&OrderVerdict]) -> Text {
    if engine.faster_crank().is_some() {
        return beyond_several(engine, orders);
    }
    let against = orders.iter().any(|order| order.order == 1 && left_vectors(order)[1]);
    let higher: Vec<String> = orders
        .iter()
        .filter(|order| order.order > 1 && left_vectors(order) != [false, false])
        .map(|order| order.order.to_string())
        .collect();
    match (against, higher.as_slice()) {
        (false, []) => "Nothing at these orders: counterweights alone cure all that is left.".into(),
        (true, []) => "What turns against the crank at order 1.".into(),
        (false, [only]) => phrase!("Order {}: it does not turn with the crank at crank speed.", only.clone()),
        (false, several) => {
            phrase!("Orders {}: they do not turn with the crank at crank speed.", several.join(", "))
        }
        (true, several) => {
            phrase!("What turns against the crank at order 1, and all of {}.", residual::orders_in_words(several))
        }
    }
}

/// The same where crankshafts turn at different speeds: each has counterweights for its own first order, in its own sense.
fn beyond_several(engine: &Engine, orders: &[&OrderVerdict]) -> Text {
    let turns =
        |order: u32, sense| engine.geared_cranks().iter().any(|crank| (crank.speed, crank.sense) == (order, sense));
    let is_beyond = |order: &&&OrderVerdict| {
        let senses = [Sense::Direct, Sense::Reverse].into_iter().zip(left_vectors(order));
        senses.into_iter().any(|(sense, left)| left && !turns(order.order, sense))
    };
    let names: Vec<String> = orders.iter().filter(is_beyond).map(|order| order.order.to_string()).collect();
    match names.as_slice() {
        [] => "Nothing at these orders: all that is left turns as some crankshaft does.".into(),
        several => {
            phrase!("Not all that is left of {} turns as a crankshaft does.", residual::orders_in_words(several))
        }
    }
}

/// What vanishes, what is not there, and what is known of other orders.
fn rest(all: &[OrderVerdict], existing: &[&OrderVerdict], theorem: Option<&EveryOrderTheorem>) -> Vec<Text> {
    let mut sentences = Vec::new();
    let zero: Vec<String> = existing
        .iter()
        .filter(|order| order.force.is_balanced() && order.moment.is_balanced())
        .map(|order| order.order.to_string())
        .collect();
    if !zero.is_empty() {
        sentences.push(phrase!("Force and moment of {} vanish, proved.", residual::orders_in_words(&zero)));
    }
    let mut missing: Vec<String> =
        all.iter().filter(|order| !order.exists()).map(|order| order.order.to_string()).collect();
    missing.dedup();
    match missing.as_slice() {
        [] => {}
        [only] => sentences.push(phrase!("Order {} {}.", only.clone(), DOES_NOT_EXIST)),
        several => sentences.push(phrase!("Orders {} do not exist.", several.join(", "))),
    }
    sentences.extend(theorem.and_then(|theorem| others(existing, theorem)));
    let is_all_balanced = existing.iter().all(|order| left_vectors(order) == [false, false]);
    let words = match (is_all_balanced, zero.is_empty()) {
        (true, _) => "**What shakes.** Nothing that is proved to be left at the orders judged. {}",
        (false, false) => "**What is balanced.** {}",
        (false, true) => "**At other orders.** {}",
    };
    (!sentences.is_empty()).then(|| phrase!(words, Text::joined(sentences, " "))).into_iter().collect()
}

/// The first order that is left beside those told; nothing where that is not known.
fn others(judged: &[&OrderVerdict], theorem: &EveryOrderTheorem) -> Option<Text> {
    let told = |order: u32| judged.iter().any(|judged| judged.order == order);
    let last = judged.iter().map(|order| order.order).max().unwrap_or(1);
    match theorem.next_left(last, told) {
        NextLeft::None => Some("No other order is left, of all there are.".into()),
        NextLeft::Order(next) => Some(phrase!("The next order that is left is {}.", next)),
        NextLeft::NotKnown => None,
    }
}

/// Whose masses the verdicts are about, and in what they are counted.
pub(super) fn whose(engine: &Engine, judged: &Judgement) -> Option<Text> {
    let whose = residual::whose_masses(engine, judged)?;
    Some(match residual::turning_unit(judged) {
        Some(unit) => phrase!("{} {}", whose, unit),
        None => whose,
    })
}

/// What is left in newtons, where the file gives numbers of what is judged; in multiples of m r ω² where rods are articulated, whose sums
/// alone say little.
pub(super) fn in_newtons(engine: &Engine, judged: &Judgement, loads: Option<&Loads>) -> Option<Table> {
    let has_numbers = |loads: &&Loads| loads.scale.is_some() || engine.has_links();
    let loads = loads.filter(|loads| is_as_built(engine, judged) && has_numbers(loads))?;
    let mut table = Table::new(["Order", "Force", "Moment"]);
    let cell = |order: &OrderVerdict, quantity: Planar, whole: &WholeOrder| match (
        whole.shape,
        in_units(engine, loads, order.order, quantity, whole),
    ) {
        (Shape::Balanced, _) => Text::zero(),
        (shape, Some(size)) if quantity == Planar::Moment && order.moment_is_couple() => {
            phrase!("couple {}, {}", size, residual::shape_name(shape))
        }
        (shape, Some(size)) => phrase!("{}, {}", size, residual::shape_name(shape)),
        (_, None) => residual::whole_text(whole),
    };
    for order in judged.orders.iter().filter(|order| order.exists()) {
        let force = cell(order, Planar::Force, &order.force);
        table.push(vec![order.order.into(), force, cell(order, Planar::Moment, &order.moment)]);
    }
    Some(table)
}

/// The short answer: what is left of each order, in newtons where the file gives numbers, and exactly.
pub fn engine_answer(engine: &Engine, judged: &Judgement) -> Document {
    let orders: Vec<u32> = judged.orders.iter().map(|order| order.order).collect();
    let loads = loads::loads(engine, &orders).ok();
    let mut page = Document::new("verdicts", engine.title());
    if let Some(table) = in_newtons(engine, judged, loads.as_ref()) {
        page.push(table);
    }
    match &judged.pistons {
        None => page.push(table::verdicts(&judged.orders)),
        Some(pistons) => {
            page.push(Block::Paragraph("As built:".into()));
            page.push(table::verdicts(&judged.orders));
            page.push(Block::Paragraph("The pistons alone:".into()));
            page.push(table::verdicts(pistons));
        }
    }
    page.push(Block::Note(residual::LEGEND.into()));
    page.blocks.extend(conventions::rows(engine).into_iter().map(|words| Block::Note(words.into())));
    page.blocks.extend(articulated::hidden(engine).map(Block::Note));
    page.blocks.extend((!engine.geared_cranks().is_empty()).then(|| Block::Note(residual::ROLL_LEGEND.into())));
    page.blocks.extend(geared::roll_asked_of(engine).map(Block::Note));
    page.blocks.extend(engine.faster_crank().map(|_| Block::Note(residual::SPEED_LEGEND.into())));
    page.blocks.extend(residual::turning_unit(judged).map(|words| Block::Note(words.into())));
    let missing =
        |order: &OrderVerdict| !order.exists() || order.torque.as_ref().is_some_and(|torque| !torque.exists());
    if judged.orders.iter().any(missing) {
        page.push(Block::Note(residual::why_not(judged.masses).into()));
    }
    page.blocks.extend(residual::whose_masses(engine, judged).map(Block::Note));
    page
}
