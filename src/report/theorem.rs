//! How is a statement on every order put into words?

use super::{residual, table};
use crate::engine::Engine;
use crate::order::{self, Masses};
use crate::page::{Block, Fold, Text, phrase};
use crate::proof::Survivors;
use crate::verdict::{self, EveryOrder, LONGEST_PERIOD, NoTheorem, Theorem};

/// Longer tables of one period are left out.
const MOST_ROWS: usize = 24;
/// Up to so many classes of orders are named one by one, as `18j − 8`.
const MOST_NAMED: usize = 4;
/// Periods with more digits are not written out.
const MOST_DIGITS: usize = 20;

/// The section on every order: the statements, why one period proves them, and the period.
pub(super) fn section(engine: &Engine, theorem: &Result<Theorem, NoTheorem>) -> Vec<Block> {
    let mut blocks = vec![Block::Heading(1, "Every order".into())];
    match theorem {
        Err(reason) => blocks.push(Block::Paragraph(no_theorem(reason))),
        Ok(theorem) => {
            blocks.push(Block::List(statements(engine, theorem)));
            blocks.push(Block::Paragraph(why(engine, theorem)));
            if theorem.force.direct.len() <= MOST_ROWS {
                let summary = "One period of orders".into();
                blocks.push(Block::Folded(Fold { summary, blocks: vec![table::period(theorem).into()] }));
            }
        }
    }
    blocks
}

/// What is true of every order, of the force and of the moment.
pub(super) fn statements(engine: &Engine, theorem: &Theorem) -> Vec<Text> {
    let statement =
        |name, every| Text::phrase(format!("{}{}", statement(name, every), whose(engine, theorem)), Vec::new());
    vec![statement("force", &theorem.force), statement("moment", &theorem.moment)]
}

/// Whose masses it is about, where the engine has others than pistons.
fn whose(engine: &Engine, theorem: &Theorem) -> String {
    let has_others = order::groups_of(engine).len() > 1;
    match theorem.masses {
        Masses::Reciprocating if has_others => " This is about the pistons alone.".to_owned(),
        Masses::All if has_others => " This is about the engine as it is built.".to_owned(),
        Masses::Reciprocating | Masses::All => String::new(),
        masses => format!(" This is about {} alone.", residual::masses_words(masses)),
    }
}

fn no_theorem(reason: &NoTheorem) -> Text {
    let why = match reason {
        NoTheorem::PeriodTooLong(period) => {
            let period = match period.to_string() {
                digits if digits.len() <= MOST_DIGITS => format!("{digits} orders"),
                digits => format!("a number of orders that has {} digits", digits.len()),
            };
            format!("the pattern repeats only after {period}, and at most {LONGEST_PERIOD} are judged one by one")
        }
        other => other.to_string(),
    };
    phrase!("No statement is made on every order at once: {}.", why)
}

fn why(engine: &Engine, theorem: &Theorem) -> Text {
    let period = theorem.period;
    let even = if period == 2 { "order 2".to_owned() } else { format!("the even orders 2 to {period}") };
    let plane = super::typeset::number(engine.reference_plane());
    let words = format!(
        "All throws and banks are multiples of $\\tfrac{{1}}{{{period}}}$ of a turn, and in (2) the order k only multiplies \
         angles: $P_k^{{\\pm}}$ depends on $k$ only modulo {period}, and so do the sums of the moment, about z = {plane}. The verdicts \
         on order 1 and on {even} prove the statements for every order of a centric engine."
    );
    Text::phrase(words, Vec::new())
}

/// `**Force.** The force of order k vanishes iff 6 ∤ k. …`, and the two vectors apart where they differ.
fn statement(name: &str, every: &EveryOrder) -> String {
    let both = every.survivors();
    let senses @ [direct, reverse] = &[&every.direct, &every.reverse].map(|verdicts| verdict::survivors(verdicts));
    let text = match named(&both, senses) {
        _ if every.first.is_none() => sentence(&format!("The {name}"), &both),
        Some(list) => format!("Nothing is left of the {name} but {list}."),
        None if direct == reverse => {
            format!("{} Direct and reverse vector alike.", sentence(&format!("The {name}"), &both))
        }
        None => [(&format!("The {name}")[..], &both), ("The direct vector", direct), ("The reverse vector", reverse)]
            .map(|(subject, survivors)| sentence(subject, survivors))
            .join(" "),
    };
    let lead = if name == "force" { "Force" } else { "Moment" };
    format!("**{lead}.** {text}")
}

/// `order 1 (direct), orders 8, 26, … = 18j − 10 (reverse) and 10, 28, … = 18j − 8 (direct)`, where few classes are
/// left and each is told by its vectors.
fn named(both: &Survivors, senses: &[Survivors; 2]) -> Option<String> {
    let Survivors { order_one, modulus, residues } = both;
    let classes = (*modulus / 2) as usize;
    let all_but_multiples = residues.len() + 1 == classes && !residues.contains(&0);
    let is_rule = residues == &[0] || (*order_one && !residues.is_empty() && all_but_multiples);
    let is_uniform = senses.iter().all(|one| modulus.is_multiple_of(one.modulus));
    if is_rule || 2 * residues.len() > classes || residues.len() > MOST_NAMED || !is_uniform {
        return None;
    }
    let vectors = |order: u32| match senses.each_ref().map(|one| one.contains(order)) {
        [true, false] => " (direct)",
        [false, true] => " (reverse)",
        _ => "",
    };
    let one = order_one.then(|| format!("order 1{}", vectors(1)));
    let classes = lowest(residues, *modulus).into_iter().enumerate().map(|(index, order)| {
        format!("{}{}{}", if index == 0 { "orders " } else { "" }, class(order, *modulus), vectors(order))
    });
    Some(listed(&one.into_iter().chain(classes).collect::<Vec<_>>()))
}

/// One sentence that says of every order that exists whether it vanishes.
pub(super) fn sentence(subject: &str, survivors: &Survivors) -> String {
    let Survivors { order_one, modulus, residues } = survivors;
    let zeros: Vec<u32> = (0..*modulus).step_by(2).filter(|residue| !residues.contains(residue)).collect();
    let with_one = |orders: String| format!("order 1 and {orders}");
    match (residues.as_slice(), zeros.as_slice(), order_one) {
        ([], _, false) => format!("{subject} vanishes at every order."),
        ([], _, true) => format!("{subject} vanishes at every order but order 1."),
        (_, [], true) => format!("{subject} vanishes at no order."),
        (_, [], false) => format!("{subject} vanishes at order 1 and at no other."),
        ([0], _, false) => format!("{subject} of order $k$ vanishes iff ${modulus} \\nmid k$."),
        ([0], _, true) => format!("{subject} of order $k$ vanishes iff $k \\ne 1$ and ${modulus} \\nmid k$."),
        (_, [0], true) => format!("{subject} of order $k$ vanishes iff ${modulus} \\mid k$."),
        (_, [0], false) => format!("{subject} of order $k$ vanishes iff $k = 1$ or ${modulus} \\mid k$."),
        (left, zeros, one) if left.len() <= zeros.len() => {
            let left = orders(left, *modulus);
            format!("{subject} vanishes at every order but {}.", if *one { with_one(left) } else { left })
        }
        (_, zeros, one) => {
            let zeros = orders(zeros, *modulus);
            format!("{subject} vanishes at {} and at no other.", if *one { zeros } else { with_one(zeros) })
        }
    }
}

/// `orders 8, 26, … = 18j − 10 and 10, 28, … = 18j − 8`; many classes as `the orders that are … modulo 48`.
fn orders(residues: &[u32], modulus: u32) -> String {
    let lowest = lowest(residues, modulus);
    if lowest.len() > MOST_NAMED {
        let list: Vec<String> = lowest.iter().map(u32::to_string).collect();
        return format!("the orders that are {} modulo {modulus}", list.join(", "));
    }
    let classes: Vec<String> = lowest.into_iter().map(|order| class(order, modulus)).collect();
    format!("orders {}", listed(&classes))
}

/// The first order of each class: order 0 does not exist.
fn lowest(residues: &[u32], modulus: u32) -> Vec<u32> {
    let mut lowest: Vec<u32> = residues.iter().map(|&residue| if residue == 0 { modulus } else { residue }).collect();
    lowest.sort_unstable();
    lowest
}

/// `8, 26, … = 18j − 10`.
fn class(lowest: u32, modulus: u32) -> String {
    let formula = match modulus - lowest {
        0 => format!("{modulus}j"),
        less => format!("{modulus}j - {less}"),
    };
    format!("{lowest}, {}, … = ${formula}$", lowest + modulus)
}

/// `a`, `a and b`, `a, b and c`.
fn listed(items: &[String]) -> String {
    match items.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, before)) => format!("{} and {last}", before.join(", ")),
        None => String::new(),
    }
}

/// `The first order that survives: force 6, planar; no moment at any order.`
pub(super) fn first_survivors(theorem: &Theorem) -> String {
    let one = |name: &str, every: &EveryOrder| match &every.first {
        Some(first) => format!("{name} {}, {}", first.direct.order, residual::shape_name(first.shape)),
        None => format!("no {name} at any order"),
    };
    match (&theorem.force.first, &theorem.moment.first) {
        (None, None) => "No order survives: neither force nor moment, at any order.".to_owned(),
        _ => format!(
            "The first order that survives: {}; {}.",
            one("force", &theorem.force),
            one("moment", &theorem.moment)
        ),
    }
}
