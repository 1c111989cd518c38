//! What shakes, how much, what cures it and what that leaves? What a reader sees first: five lines at most.

use num_traits::Zero;

use super::super::calculation::{Unit, books_line, percent_at_most};
use super::super::roll_asked::roll_asked;
use super::super::{mechanism_words, residual, stars, table};
use super::left::{Name, numbers};
use super::weighing::{Rest, Weighed, WeighedParts, Weighing, circumstances, sizes};
use super::{articulated, at_speed, cures, geared};
use crate::engine::{DOES_NOT_EXIST, Engine};
use crate::order::Masses;
use crate::page::{Block, Choice, Document, Text, phrase};
use crate::proof::{Planar, Quantity, Shape};
use crate::report::texts::{engine as text, residual as of_residual};
use crate::verdict::{self, EveryOrderTheorem, Judgement, NextLeft, NoTheorem, OrderVerdict, WholeOrder};

/// The lines of the box that a report opens with.
pub(super) fn lines(
    engine: &Engine,
    judged: &Judgement,
    theorem: Option<&EveryOrderTheorem>,
    weighed: &WeighedParts,
) -> Vec<Text> {
    let existing: Vec<&OrderVerdict> = judged.orders.iter().filter(|order| order.exists()).collect();
    let parts = weighed;
    let weighed = parts.as_judged.as_ref();
    let mut lines = vec![shaking(&existing, weighed)];
    lines.extend(cures::Cures::new(engine, judged, &existing, weighed).line());
    lines.extend(balanced(&judged.orders, &existing, weighed));
    lines.extend(others(&existing, weighed, theorem.filter(|theorem| theorem.masses() == judged.masses)));
    // There is room for one of them: balancer shafts and counterweights say more of an engine than rods that it may not have.
    lines.extend(pistons(judged, parts).or_else(|| articulated::hidden(engine, weighed)));
    lines
}

/// What shakes of the pistons alone, where the verdicts are on more.
fn pistons(judged: &Judgement, weighed: &WeighedParts) -> Option<Text> {
    let existing: Vec<&OrderVerdict> = judged.pistons.as_ref()?.iter().filter(|order| order.exists()).collect();
    let as_built: Vec<&OrderVerdict> = judged.orders.iter().filter(|order| order.exists()).collect();
    let what = what_shakes(&existing, weighed.pistons.as_ref());
    Some(match what.plain() == what_shakes(&as_built, weighed.as_judged.as_ref()).plain() {
        true => text::pistons_alone_alike(),
        false => text::pistons_alone(what),
    })
}

/// What is left, order by order, at which speed.
fn shaking(orders: &[&OrderVerdict], weighed: Option<&Weighed>) -> Text {
    let what = what_shakes(orders, weighed);
    match circumstances(weighed) {
        None => text::shakes(what),
        Some(circumstances) => text::shakes_under(circumstances, what),
    }
}

fn what_shakes(orders: &[&OrderVerdict], weighed: Option<&Weighed>) -> Text {
    let left = left(orders, weighed);
    match left.is_empty() {
        false => Text::joined(left, " "),
        true if orders.iter().all(|order| order.force.is_balanced() && order.moment.is_balanced()) => {
            text::nothing_shakes()
        }
        true => match weighed {
            Some(weighed) => text::all_below(percent_at_most(weighed.above())),
            None => text::nothing_known(),
        },
    }
}

/// A sentence each on the forces and moments of one name, those of the lowest order first.
fn left(orders: &[&OrderVerdict], weighed: Option<&Weighed>) -> Vec<Text> {
    let mut named: Vec<(Name, Vec<Text>)> = Vec::new();
    for order in orders {
        for quantity in Planar::BOTH {
            let Some((name, size)) = sized(order, quantity, weighed) else { continue };
            match named.iter_mut().find(|(other, _)| other.label == name.label) {
                Some((_, sizes)) => sizes.push(size),
                None => named.push((name, vec![size])),
            }
        }
    }
    let mut sentences: Vec<Text> =
        named.into_iter().map(|(name, sizes)| (name.sentence)(Text::joined(sizes, ", "))).collect();
    sentences.extend(weighed.into_iter().flat_map(about_the_axis));
    sentences.extend(not_decided(orders));
    sentences
}

/// Orders of which it is not decided whether they vanish.
fn not_decided(orders: &[&OrderVerdict]) -> Option<Text> {
    let is_open = |whole: &WholeOrder| whole.shape == Shape::NotDecided && !whole.is_left();
    let open = numbers(orders.iter().copied(), |order| is_open(&order.force) || is_open(&order.moment));
    (!open.is_empty()).then(|| text::not_decided(residual::orders_in_words(&open), Choice::one_or_more(open.len())))
}

/// The name of the force or moment of an order, and its size; none where it is not left, or told with others.
fn sized(order: &OrderVerdict, quantity: Planar, weighed: Option<&Weighed>) -> Option<(Name, Text)> {
    let whole = order.whole(quantity);
    if !whole.is_left() {
        return None;
    }
    let weighed = weighed.filter(|_| whole.is_decided());
    let size = match weighed {
        Some(weighed) if !weighed.is_told(order.order, quantity) => return None,
        Some(weighed) => weighed.amount(weighed.size(order.order, quantity), quantity),
        None => of_one_sum(order, quantity),
    };
    let size = match size {
        Some(size) => phrase!("{} (order {})", size, order.order),
        None => phrase!("order {}", order.order),
    };
    Some((Name::of(order, quantity, whole.shape, weighed), size))
}

/// The exact size of an order that is one sum of masses that turn, which has no coefficient.
fn of_one_sum(order: &OrderVerdict, quantity: Planar) -> Option<Text> {
    let [only] = order.parts.as_slice() else { return None };
    let is_of_turning = matches!(order.masses, Masses::Rotating | Masses::Counterweights);
    is_of_turning.then(|| residual::largest(only.balance(quantity)).into())
}

/// The largest orders of the roll moment, where it is given.
fn about_the_axis(weighed: &Weighed) -> Option<Text> {
    let quantity = weighed.loads.rolling()?;
    let mut falling = weighed.about_the_axis(quantity);
    falling.retain(|(_, size)| *size > 0.0);
    falling.sort_by(|(_, one), (_, other)| other.total_cmp(one));
    falling.retain(|(order, _)| weighed.is_told(*order, Quantity::Axial(quantity)));
    let (large, small) = falling.split_at(falling.len().min(MOST_OF_ROLL));
    let large = large
        .iter()
        .map(|(order, size)| Some(phrase!("{} (order {})", weighed.amount(*size, Quantity::Axial(quantity))?, *order)));
    let large: Vec<Text> = large.collect::<Option<_>>()?;
    let small: Vec<String> = small.iter().map(|(order, _)| order.to_string()).collect();
    match (large.is_empty(), small.is_empty()) {
        (true, _) => None,
        (false, true) => Some(text::roll_moment(Text::joined(large, ", "))),
        (false, false) => {
            let small = residual::orders_in_words(&small);
            Some(text::roll_moment_smaller(Text::joined(large, ", "), small))
        }
    }
}

/// Orders of the roll moment whose sizes are in the box; all are in its table.
const MOST_OF_ROLL: usize = 2;

/// Which forces and moments vanish, and which orders are not there.
fn balanced(all: &[OrderVerdict], existing: &[&OrderVerdict], weighed: Option<&Weighed>) -> Option<Text> {
    let [forces, moments] =
        Planar::BOTH.map(|quantity| numbers(existing.iter().copied(), |order| order.whole(quantity).is_balanced()));
    let words = residual::orders_in_words;
    let vanishing = match (forces.as_slice(), moments.as_slice()) {
        ([], []) => None,
        (forces, moments) if forces == moments => Some(text::force_and_moment_at(words(forces))),
        (forces, []) => Some(text::force_at(words(forces))),
        ([], moments) => Some(text::moment_at(words(moments))),
        (forces, moments) => Some(text::force_at_moment_at(words(forces), words(moments))),
    };
    let mut missing = numbers(all, |order| !order.exists());
    missing.dedup();
    let missing = match missing.as_slice() {
        [] => None,
        [only] => Some(text::order_missing(only.clone(), DOES_NOT_EXIST)),
        several => Some(text::orders_missing(several.join(", "))),
    };
    let sentences: Vec<Text> = vanishing.into_iter().chain(weighed.and_then(no_roll)).chain(missing).collect();
    (!sentences.is_empty()).then(|| text::balanced(Text::joined(sentences, " ")))
}

/// That the roll moment vanishes, where it does at every order that is known of it.
fn no_roll(weighed: &Weighed) -> Option<Text> {
    let quantity = weighed.loads.rolling()?;
    let examined = weighed.about_the_axis(quantity).len();
    (examined > 0 && weighed.zeros_about_the_axis(quantity).count() == examined).then(text::no_roll_moment)
}

/// What is known of the orders that are not told: that there are none, or what they add up to at most, forces and moments together where
/// they are the same orders.
fn others(judged: &[&OrderVerdict], weighed: Option<&Weighed>, theorem: Option<&EveryOrderTheorem>) -> Option<Text> {
    let told: Vec<u32> = judged.iter().map(|order| order.order).collect();
    let next = |of: &[Planar]| theorem.map_or(NextLeft::NotKnown, |theorem| theorem.next_left(of, &told));
    let bound = |(quantity, [of_largest, alone]): (Planar, [&'static str; 2])| {
        let (small, rest) = weighed?.rest(quantity, judged.iter().copied());
        let next = next(&[quantity]);
        // A bound of nothing says that there may be something.
        let is_all = small.is_empty() && next == NextLeft::None;
        let small: Vec<String> = small.iter().map(u32::to_string).collect();
        let bound = match rest.filter(|_| !is_all)? {
            Rest::Part(part) => phrase!(of_largest, percent_at_most(part)),
            Rest::Amount(amount) => phrase!(alone, amount),
        };
        Some((small, bound, next))
    };
    let of_force = bound((Planar::Force, ["{} % of the largest force", "{} of force"]));
    let of_moment = bound((Planar::Moment, ["{} % of the largest moment", "{} of moment"]));
    match (of_force, of_moment) {
        (None, None) => match next(&Planar::BOTH) {
            NextLeft::None if is_all_told(weighed) => Some(text::others_zero()),
            NextLeft::Order(next) => Some(text::next_order_left(next)),
            NextLeft::None | NextLeft::NotKnown => None,
        },
        (Some((small, force, _)), Some((same, moment, _))) if small == same => {
            Some(at_most(&small, next(&Planar::BOTH), Text::joined([force, moment], ", ")))
        }
        (Some((small, bound, next)), None) | (None, Some((small, bound, next))) => Some(at_most(&small, next, bound)),
        (Some(force), Some(moment)) => {
            let named = |(mut orders, bound, next): (Vec<String>, Text, NextLeft)| {
                if orders.is_empty() {
                    return bound;
                }
                orders.extend((next != NextLeft::None).then(|| "…".to_owned()));
                phrase!("{} ({})", bound, orders.join(", "))
            };
            Some(text::others_at_most(Text::joined([force, moment].map(named), ", ")))
        }
    }
}

/// Whether no order that exists is left untold.
fn is_all_told(weighed: Option<&Weighed>) -> bool {
    Planar::BOTH
        .into_iter()
        .all(|quantity| weighed.is_none_or(|weighed| weighed.rest_in_multiples(quantity).0.is_empty()))
}

/// What orders that are not told, and those that were not looked at, add up to at most.
fn at_most(small: &[String], next: NextLeft, bound: Text) -> Text {
    let listed = || Text::label(small.join(", "));
    match (small, next) {
        ([], NextLeft::Order(next)) => text::others_from(next, bound),
        ([], NextLeft::None | NextLeft::NotKnown) => text::others_at_most(bound),
        ([only], NextLeft::None) => text::order_at_most(only.clone(), bound),
        (_, NextLeft::None) => text::orders_at_most(listed(), bound),
        (_, NextLeft::Order(_) | NextLeft::NotKnown) => {
            text::these_and_others_at_most(Choice::one_or_more(small.len()), listed(), bound)
        }
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

/// The short answer: what is left of each order, in newtons where the file gives numbers, and exactly.
pub fn engine_answer(engine: &Engine, judged: &Judgement) -> Document {
    answer(engine, judged, Weighing::usual(), |_| None)
}

/// The short answer of a terminal, with what is reported one by one and what together: one table where masses and speed are given; what is
/// exact follows it where all is asked for.
pub fn engine_answer_weighed(engine: &Engine, judged: &Judgement, weighing: &Weighing) -> Document {
    answer(engine, judged, weighing, |weighed| weighed.speed())
}

fn answer(
    engine: &Engine,
    judged: &Judgement,
    weighing: &Weighing,
    speed_of_table: impl Fn(&Weighed) -> Option<Text>,
) -> Document {
    let mut page = Document::new("verdicts", engine.title());
    let theorem = theorem_of(engine, judged).ok();
    let weighed = WeighedParts::new(engine, judged, weighing);
    let as_judged = weighed.as_judged.as_ref();
    let at_speed = as_judged.and_then(|weighed| Some((weighed, speed_of_table(weighed)?)));
    let is_exact = at_speed.is_none() || weighing.all;
    match at_speed {
        None => page.push(Block::Answer(lines(engine, judged, theorem.as_ref(), &weighed))),
        Some((sized, speed)) => {
            page.push(at_speed::table(engine, judged, theorem.as_ref(), sized, speed));
            page.push(Block::Note(text::sizes_rounded(Text::code("--all"))));
            page.blocks.extend(pistons(judged, &weighed).map(Block::Paragraph));
        }
    }
    page.blocks.extend(is_exact.then(|| tables(judged, weighing, &weighed)).into_iter().flatten());
    page.blocks.extend(notes(engine, judged, as_judged, weighing, is_exact));
    page
}

/// The tables of exact verdicts.
fn tables(judged: &Judgement, weighing: &Weighing, weighed: &WeighedParts) -> Vec<Block> {
    let WeighedParts { as_judged, pistons: of_pistons } = weighed;
    let mut page = Document::new("verdicts", Text::default());
    page.blocks.extend(judged.pistons.as_ref().map(|_| Block::Paragraph(text::as_built())));
    page.push(table::verdicts(&judged.orders, as_judged.as_ref()));
    if let Some(pistons) = &judged.pistons {
        page.push(text::of_pistons());
        page.push(table::verdicts(pistons, of_pistons.as_ref()));
    }
    let sums = table::sums(&judged.orders).filter(|_| shows_classes(weighing, as_judged.as_ref()));
    page.blocks.extend(sums.map(Block::Table));
    page.blocks
}

/// Whether the sums of classes have rows of their own.
fn shows_classes(weighing: &Weighing, as_judged: Option<&Weighed>) -> bool {
    weighing.all || as_judged.is_none()
}

/// What is to be known of an answer; of its exact numbers, where it has any.
fn notes(
    engine: &Engine,
    judged: &Judgement,
    as_judged: Option<&Weighed>,
    weighing: &Weighing,
    is_exact: bool,
) -> Vec<Block> {
    let mut notes: Vec<Text> = stars::cited(engine).into_iter().collect();
    notes.extend(sizes(as_judged).filter(|_| is_exact));
    // What books say of rods that are assumed nobody asks.
    let given = as_judged.filter(|weighed| weighed.assumed.is_none());
    notes.extend(given.and_then(|weighed| books_line(engine, &weighed.loads, Unit::as_read)));
    notes.extend(is_exact.then(of_residual::exact_sizes));
    let is_without_mass = engine.dimensions().mass.as_ref().is_some_and(Zero::is_zero);
    notes.extend((is_exact && is_without_mass).then(text::mass_of_one));
    if is_exact && shows_classes(weighing, as_judged) {
        notes.extend(mechanism_words::rows(engine));
    }
    notes.extend(articulated::hidden(engine, as_judged));
    notes.extend((is_exact && !engine.geared_cranks().is_empty()).then(of_residual::torque_and_roll));
    let lacks = as_judged.and_then(|weighed| weighed.loads.roll_lacks);
    notes.extend(geared::roll_asked_of(engine).or_else(|| lacks.map(|missing| roll_asked(engine, missing))));
    notes.extend(geared::has_flywheels(engine, judged).then(text::own_flywheels));
    notes.extend(engine.faster_crank().filter(|_| is_exact).map(|_| of_residual::orders_by_speed()));
    notes.extend(residual::turning_unit(judged).filter(|_| is_exact));
    let missing =
        |order: &OrderVerdict| !order.exists() || order.torque.as_ref().is_some_and(|torque| !torque.exists());
    if judged.orders.iter().any(missing) {
        notes.push(residual::why_not(judged.masses));
    }
    notes.extend(residual::whose_masses(engine, judged));
    notes.into_iter().map(Block::Note).collect()
}

/// What is true of every order, of the masses judged or else of the pistons.
pub(super) fn theorem_of(engine: &Engine, judged: &Judgement) -> Result<EveryOrderTheorem, NoTheorem> {
    match verdict::every_order(engine, judged.masses) {
        // The pistons have a pattern even where a shaft has none.
        Err(NoTheorem::Shaft(_)) => verdict::every_order(engine, Masses::Reciprocating),
        other => other,
    }
}
