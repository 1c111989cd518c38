//! In which sentences is a statement on every order put, and why does it hold?

use super::argument::listed;
use super::typeset;
use crate::engine::Engine;
use crate::order::{self, Masses};
use crate::page::{Number, Text, phrase};
use crate::proof::Survivors;
use crate::verdict::{self, EveryOrder, LONGEST_SIEVED, MOST_CANDIDATES, NoTheorem, Theorem};

/// Up to this many classes of orders are named one by one, as `18j − 8`.
const MOST_NAMED: usize = 4;
/// Periods with more digits are not written out.
const MOST_DIGITS: usize = 20;

/// What is true of every order, of the force and of the moment.
pub(super) fn statements(engine: &Engine, theorem: &Theorem) -> Vec<Text> {
    let force = phrase!("**Force.** {}", statement(&theorem.force));
    let moment = phrase!("**Moment.** {}", statement(&theorem.moment));
    [force, moment].map(|statement| whose(engine, theorem.masses, statement)).into()
}

/// Whose masses it is about, where the engine has others than pistons.
pub(super) fn whose(engine: &Engine, masses: Masses, statement: Text) -> Text {
    let has_others = order::groups_of(engine).len() > 1;
    match masses {
        Masses::Reciprocating if has_others => phrase!("{} This is about the pistons alone.", statement),
        Masses::All if has_others => phrase!("{} This is about the engine as it is built.", statement),
        Masses::Reciprocating | Masses::All => statement,
        Masses::Rotating => {
            phrase!("{} This is about the rotating masses alone, without counterweights and shafts.", statement)
        }
        Masses::Counterweights => phrase!("{} This is about the counterweights alone.", statement),
    }
}

/// Why nothing is said of every order at once.
pub(super) fn no_theorem(reason: &NoTheorem) -> Text {
    match reason {
        NoTheorem::PeriodTooLong(period) => match period.to_string() {
            digits if digits.len() <= MOST_DIGITS => phrase!(
                "No statement is made on every order at once: the pattern repeats only after {} orders, and at most {} are examined.",
                digits,
                LONGEST_SIEVED
            ),
            digits => phrase!(
                "No statement is made on every order at once: the pattern repeats only after a number of orders that has {} digits, and at most {} are examined.",
                digits.len(),
                LONGEST_SIEVED
            ),
        },
        NoTheorem::TooManyCandidates(period) => phrase!(
            "No statement is made on every order at once: the pattern repeats only after {} orders, of which more than {} may be zero, too many to decide. The verdicts cover only the orders asked for.",
            *period,
            MOST_CANDIDATES
        ),
        NoTheorem::RodsDiffer => {
            "No statement is made on every order at once: the rods differ, so no order is a single sum.".into()
        }
        NoTheorem::FasterCrank(speed) => phrase!(
            "No statement is made on every order at once: a crankshaft turns {} times while the reference turns once, so that its pistons have \
             other orders than those of the reference.",
            *speed
        ),
        NoTheorem::Shaft(order) => phrase!(
            "No statement is made on every order at once: a balancer shaft turns at order {}, which is not in the pattern of the cylinders; use the reciprocating masses only (`--masses reciprocating`).",
            *order
        ),
    }
}

/// Why one period of orders proves the statements.
pub(super) fn why(engine: &Engine, theorem: &Theorem) -> Text {
    let period = theorem.period;
    let part = Text::formula(format!("\\tfrac{{1}}{{{period}}}"));
    let plane = Number::exact(engine.reference_plane());
    match period {
        2 => phrase!(
            "All throws and banks are multiples of {} of a turn, and in (2) the order $k$ only multiplies angles: so the sums of the \
             force depend on $k$ only modulo {}, and so do those of the moment, about z = {}. The verdicts on order 1 and on order 2 \
             prove the statements for every order of a centric engine.",
            part,
            period,
            plane
        ),
        _ => phrase!(
            "All throws and banks are multiples of {} of a turn, and in (2) the order $k$ only multiplies angles: so the sums of the \
             force depend on $k$ only modulo {}, and so do those of the moment, about z = {}. The verdicts on order 1 and on the even \
             orders 2 to {} prove the statements for every order of a centric engine.",
            part,
            period,
            plane,
            period
        ),
    }
}

/// At which orders it is zero, and each of the two vectors where they differ.
fn statement(every: &EveryOrder) -> Text {
    let both = every.survivors();
    let senses @ [direct, reverse] = &[&every.direct, &every.reverse].map(|verdicts| verdict::survivors(verdicts));
    match named(&both, senses) {
        _ if every.first.is_none() => sentence(&both),
        Some(list) => phrase!("Nothing remains but {}.", list),
        None if direct == reverse => {
            phrase!("{} This holds for both the direct and the reverse vector.", sentence(&both))
        }
        None => phrase!(
            "{} The direct vector: {} The reverse vector: {}",
            sentence(&both),
            sentence(direct),
            sentence(reverse)
        ),
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
        ([], _, false) => "Zero at every order.".into(),
        ([], _, true) => "Zero at every order but order 1.".into(),
        (_, [], true) => "Zero at no order.".into(),
        (_, [], false) => "Zero at order 1 and at no other.".into(),
        ([0], _, one) => phrase!(
            "Zero exactly at the orders $k$ {but 1 |}that {} does not divide ({}).",
            *one,
            *modulus,
            does("\\nmid")
        ),
        (_, [0], one) => phrase!(
            "Zero exactly {|at order 1 and }at the orders $k$ that {} divides ({}).",
            *one,
            *modulus,
            does("\\mid")
        ),
        (left, zeros, one) if left.len() <= zeros.len() => match (orders(left, *modulus), one) {
            (Orders::Named(list), one) => phrase!("Zero at every order but {order 1 and |}{}.", *one, list),
            (Orders::Counted(list), one) => {
                phrase!("Zero at every order but {order 1 and |}those that are {} modulo {}.", *one, list, *modulus)
            }
        },
        (_, zeros, one) => match (orders(zeros, *modulus), one) {
            (Orders::Named(list), one) => phrase!("Zero at {1:|order 1 and }{2}{1:|,} and at no other.", *one, list),
            (Orders::Counted(list), one) => phrase!(
                "Zero at {|order 1, at }the orders that are {} modulo {}, and at no other.",
                *one,
                list,
                *modulus
            ),
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
