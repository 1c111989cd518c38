//! In which sentences is it said which orders of the gas torque vanish?

use num_rational::BigRational;

use super::super::residual;
use super::super::typeset::{self, Amount};
use crate::engine::{CycleOrder, Engine};
use crate::firing::{FiringPattern, FiringStar, NoPattern, StarOrder};
use crate::page::{Text, phrase};
use crate::report::texts::firing as text;

/// Up to this many classes of orders are named one by one, as `4j − 1`.
const MOST_NAMED: usize = 4;
/// Longer lists of intervals are not written out.
const MOST_INTERVALS: usize = 16;

/// How evenly the cylinders fire.
pub(super) fn evenness(engine: &Engine) -> Option<Text> {
    let firing = engine.firing()?;
    let degrees = |turns: &BigRational| Text::from(typeset::turns(turns));
    let (intervals, in_line) = (firing.intervals(), engine.has_dead_centres_apart());
    Some(match (intervals.as_slice(), firing.is_even()) {
        ([only], _) => text::one_cylinder(degrees(only)),
        ([first, ..], true) => text::even(in_line, degrees(first)),
        (_, _) if intervals.len() <= MOST_INTERVALS => {
            text::uneven_intervals(in_line, Text::joined(intervals.iter().map(degrees), ", "))
        }
        _ => text::uneven(in_line),
    })
}

/// What is said of every order at once.
pub(super) fn statement(pattern: &FiringPattern) -> Text {
    let (length, left) = shortest(pattern);
    let zeros = zeros(pattern, length);
    let repeats = pattern.orders[length - 1].order;
    match (left.as_slice(), zeros.as_slice()) {
        (_, []) => text::none_vanishes(),
        ([], _) => text::all_vanish(),
        (left, _) if left.len() <= MOST_NAMED => text::vanish_except(classes(left, repeats)),
        (_, zeros) if zeros.len() <= MOST_NAMED => text::exactly_vanish(classes(zeros, repeats)),
        (left, zeros) if left.len() <= zeros.len() => {
            text::vanish_except_repeating(typeset::listed(left), repeats.to_string())
        }
        (_, zeros) => text::vanish_repeating(typeset::listed(zeros), repeats.to_string()),
    }
}

/// `2, 4, … = 2j`, or `all but 2, 6, … = 4j − 2`.
pub(super) fn left_in_short(pattern: &FiringPattern) -> Text {
    let (length, left) = shortest(pattern);
    let repeats = pattern.orders[length - 1].order;
    let zeros: Vec<CycleOrder> = zeros(pattern, length);
    match (left.is_empty(), zeros.is_empty()) {
        (true, _) => "none".into(),
        (false, true) => "all".into(),
        (false, false) if left.len() <= zeros.len() => classes(&left, repeats),
        (false, false) => phrase!("all but {}", classes(&zeros, repeats)),
    }
}

/// The orders that vanish among the first this many.
fn zeros(pattern: &FiringPattern, length: usize) -> Vec<CycleOrder> {
    pattern.orders[..length].iter().filter(|order| order.vanishes()).map(|order| order.order).collect()
}

/// After how many orders the verdicts repeat, and the orders that are left among the first this many.
fn shortest(pattern: &FiringPattern) -> (usize, Vec<CycleOrder>) {
    let left: Vec<bool> = pattern.orders.iter().map(|order| !order.vanishes()).collect();
    let repeats = |length: &usize| left.len().is_multiple_of(*length) && left[*length..] == left[..left.len() - length];
    let length = (1..=left.len()).find(repeats).unwrap_or(left.len());
    let orders = pattern.orders[..length].iter().filter(|order| !order.vanishes());
    (length, orders.map(|order| order.order).collect())
}

/// `½, 2½, … = 2j − 3/2; 1, 3, … = 2j − 1`.
fn classes(lowest: &[CycleOrder], repeats: CycleOrder) -> Text {
    Text::joined(lowest.iter().map(|order| class(*order, repeats)), "; ")
}

fn class(lowest: CycleOrder, repeats: CycleOrder) -> Text {
    let step = match repeats.halves() {
        2 => "j".to_owned(),
        whole if whole.is_multiple_of(2) => format!("{}j", tex(whole)),
        halves => format!("{}\\,j", tex(halves)),
    };
    let formula = match repeats.halves() - lowest.halves() {
        0 => step,
        less => format!("{step} - {}", tex(less)),
    };
    let second = CycleOrder::of_halves(lowest.halves() + repeats.halves());
    let second = second.map(|order| order.to_string()).unwrap_or_default();
    phrase!("{}, {}, … = {}", lowest.to_string(), second, Text::formula(formula))
}

/// This many halves in TeX.
fn tex(halves: u32) -> String {
    if halves.is_multiple_of(2) { (halves / 2).to_string() } else { format!("\\tfrac{{{halves}}}{{2}}") }
}

/// The minor orders with the longest stars, and how long these are.
fn strongest_minor(pattern: &FiringPattern) -> Option<(Vec<CycleOrder>, Amount)> {
    let strongest = pattern.strongest_minor();
    let length = residual::modulus(strongest.first()?.only()?);
    Some((strongest.iter().map(|order| order.order).collect(), length))
}

/// `1½: 3√2`.
pub(super) fn strongest_in_short(pattern: &FiringPattern) -> Option<Text> {
    let (orders, length) = strongest_minor(pattern)?;
    Some(phrase!("{}: {}", typeset::listed(&orders), length))
}

/// The minor orders that leave most, with the length of their stars.
pub(super) fn strongest(pattern: &FiringPattern) -> Option<Text> {
    strongest_minor(pattern).map(|(orders, length)| strongest_in_words(&orders, length))
}

/// Which minor orders are the strongest.
pub(in crate::report) fn strongest_in_words(orders: &[CycleOrder], length: Amount) -> Text {
    match orders {
        [only] => text::strongest_order(only.to_string(), length),
        _ => text::strongest_orders(typeset::listed(orders), length),
    }
}

/// The orders at which the firing phases of all cylinders agree.
pub(super) fn major(pattern: &FiringPattern) -> Option<Text> {
    let majors: Vec<&StarOrder> = pattern.orders.iter().filter(|order| order.is_major()).collect();
    let first = majors.first()?;
    let repeats = pattern.repeats_after();
    let list: Vec<CycleOrder> = majors.iter().map(|order| order.order).collect();
    let is_regular = list.windows(2).all(|pair| pair[1].halves() - pair[0].halves() == first.order.halves())
        && repeats.halves() == first.order.halves() * u32::try_from(list.len()).unwrap_or(u32::MAX);
    let orders = if is_regular { class(first.order, first.order) } else { classes(&list, repeats) };
    Some(text::major_orders(orders))
}

/// Why nothing is said of every order at once.
pub(super) fn no_pattern(why: &NoPattern) -> Text {
    match why {
        NoPattern::NoStar(why) => text::no_pattern(why.to_string()),
        NoPattern::PeriodTooLong(_) => text::long_period(),
    }
}

/// Why one period tells of all orders.
pub(super) fn why(pattern: &FiringPattern) -> Text {
    let repeats = pattern.repeats_after().to_string();
    match pattern.orders.len() {
        1 => text::all_stars_alike(repeats),
        count => text::period(repeats, count),
    }
}

/// `1, 3, 5`.
pub(super) fn names_of(engine: &Engine, star: &FiringStar) -> String {
    typeset::listed(star.sources.iter().map(|source| source.name(engine)))
}
