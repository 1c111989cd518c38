//! In which sentences is a statement on every order put, and why does it hold?

use super::argument::listed;
use super::typeset;
use crate::engine::Engine;
use crate::order::{self, Masses};
use crate::page::{Number, Text, phrase};
use crate::proof::Survivors;
use crate::report::texts::theorem as text;
use crate::verdict::{self, EveryOrder, LONGEST_SIEVED, MOST_CANDIDATES, NoTheorem, Theorem};

/// Up to this many classes of orders are named one by one, as `18j − 8`.
const MOST_NAMED: usize = 4;
/// Periods with more digits are not written out.
const MOST_DIGITS: usize = 20;

/// What is true of every order, of the force and of the moment.
pub(super) fn statements(engine: &Engine, theorem: &Theorem) -> Vec<Text> {
    of_both(engine, theorem.masses, [statement(&theorem.force), statement(&theorem.moment)])
}

/// The statements on force and moment.
pub(super) fn of_both(engine: &Engine, masses: Masses, [force, moment]: [Text; 2]) -> Vec<Text> {
    [text::force(force), text::moment(moment)].map(|statement| whose(engine, masses, statement)).into()
}

/// Whose masses it is about, where the engine has others than pistons.
fn whose(engine: &Engine, masses: Masses, statement: Text) -> Text {
    let has_others = order::masses_as_built(engine) != Masses::Reciprocating;
    match masses {
        Masses::Reciprocating if has_others => text::pistons_alone(statement),
        Masses::All if has_others => text::as_built(statement),
        Masses::Reciprocating | Masses::All => statement,
        Masses::Rotating => text::rotating_alone(statement),
        Masses::Counterweights => text::counterweights_alone(statement),
    }
}

/// Why nothing is said of every order at once.
pub(super) fn no_theorem(reason: &NoTheorem) -> Text {
    match reason {
        NoTheorem::PeriodTooLong(period) => match period.to_string() {
            digits if digits.len() <= MOST_DIGITS => text::period_too_long(digits, LONGEST_SIEVED),
            digits => text::period_of_digits(digits.len(), LONGEST_SIEVED),
        },
        NoTheorem::TooManyCandidates(period) => text::too_many_candidates(*period, MOST_CANDIDATES),
        NoTheorem::RodsDiffer => text::rods_differ(),
        NoTheorem::FasterCrank(speed) => text::faster_crank(*speed),
        NoTheorem::Shaft(order) => text::shaft_apart(*order),
    }
}

/// Why one period of orders proves the statements.
pub(super) fn why(engine: &Engine, theorem: &Theorem) -> Text {
    let period = theorem.period;
    let part = Text::formula(format!("\\tfrac{{1}}{{{period}}}"));
    let plane = Number::exact(engine.reference_plane());
    match period {
        2 => text::why_two_orders(part, period, plane),
        _ => text::why_one_period(part, period, plane),
    }
}

/// At which orders it is zero, and each of the two vectors where they differ.
fn statement(every: &EveryOrder) -> Text {
    let both = every.survivors();
    let senses @ [direct, reverse] = &[&every.direct, &every.reverse].map(|verdicts| verdict::survivors(verdicts));
    match named(&both, senses) {
        _ if every.first.is_none() => sentence(&both),
        Some(list) => text::nothing_but(list),
        None if direct == reverse => text::both_vectors(sentence(&both)),
        None => text::each_vector(sentence(&both), sentence(direct), sentence(reverse)),
    }
}

/// `order 1 (direct), orders 8, 26, … = 18j − 10 (reverse) and orders 10, 28, … = 18j − 8 (direct)`, where few classes are
/// left and each is reported by its vectors.
fn named(both: &Survivors, senses: &[Survivors; 2]) -> Option<Text> {
    let Survivors { order_one, modulus, residues } = both;
    let classes = (*modulus / 2) as usize;
    let all_but_multiples = residues.len() + 1 == classes && !residues.contains(&0);
    let is_rule = residues == &[0] || (*order_one && !residues.is_empty() && all_but_multiples);
    let is_uniform = senses.iter().all(|one| modulus.is_multiple_of(one.modulus));
    if is_rule || 2 * residues.len() > classes || residues.len() > MOST_NAMED || !is_uniform {
        return None;
    }
    let left = |order: u32| senses.each_ref().map(|one| one.contains(order));
    let one = order_one.then(|| match left(1) {
        [true, false] => "order 1 (direct)".into(),
        [false, true] => "order 1 (reverse)".into(),
        [true, true] | [false, false] => "order 1".into(),
    });
    let classes = lowest(residues, *modulus).into_iter().map(|order| {
        let class = class(order, *modulus);
        match left(order) {
            [true, false] => phrase!("orders {} (direct)", class),
            [false, true] => phrase!("orders {} (reverse)", class),
            [true, true] | [false, false] => phrase!("orders {}", class),
        }
    });
    Some(listed(one.into_iter().chain(classes).collect()))
}

/// One sentence that says of every order that exists, 1 and the even ones, whether it vanishes.
fn sentence(survivors: &Survivors) -> Text {
    let Survivors { order_one, modulus, residues } = survivors;
    let zeros: Vec<u32> = (0..*modulus).step_by(2).filter(|residue| !residues.contains(residue)).collect();
    let does = |sign: &str| Text::formula(format!("{modulus} {sign} k"));
    match (residues.as_slice(), zeros.as_slice(), order_one) {
        ([], _, false) => text::zero_at_all(),
        ([], _, true) => text::zero_but_first(),
        (_, [], true) => text::zero_at_none(),
        (_, [], false) => text::zero_at_first(),
        ([0], _, one) => text::zero_unless_divided(*one, *modulus, does("\\nmid")),
        (_, [0], one) => text::zero_if_divided(*one, *modulus, does("\\mid")),
        (left, zeros, one) if left.len() <= zeros.len() => match orders(left, *modulus) {
            Orders::Named(list) => text::zero_but(*one, list),
            Orders::Counted(list) => text::zero_but_modulo(*one, list, *modulus),
        },
        (_, zeros, one) => match orders(zeros, *modulus) {
            Orders::Named(list) => text::zero_at(*one, list),
            Orders::Counted(list) => text::zero_at_modulo(*one, list, *modulus),
        },
    }
}

/// Classes of orders.
enum Orders {
    /// Each by itself: `orders 8, 26, … = 18j − 10 and orders 10, 28, … = 18j − 8`.
    Named(Text),
    /// Their lowest orders in a row, for they are many.
    Counted(String),
}

fn orders(residues: &[u32], modulus: u32) -> Orders {
    let lowest = lowest(residues, modulus);
    if lowest.len() > MOST_NAMED {
        return Orders::Counted(typeset::listed(lowest));
    }
    Orders::Named(listed(lowest.into_iter().map(|order| phrase!("orders {}", class(order, modulus))).collect()))
}

/// The first order of each class: order 0 does not exist.
fn lowest(residues: &[u32], modulus: u32) -> Vec<u32> {
    let mut lowest: Vec<u32> = residues.iter().map(|&residue| if residue == 0 { modulus } else { residue }).collect();
    lowest.sort_unstable();
    lowest
}

/// `8, 26, … = 18j − 10`.
fn class(lowest: u32, modulus: u32) -> Text {
    let formula = match modulus - lowest {
        0 => format!("{modulus}j"),
        less => format!("{modulus}j - {less}"),
    };
    phrase!("{}, {}, … = {}", lowest, lowest + modulus, Text::formula(formula))
}
