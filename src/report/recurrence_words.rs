//! In which sentences is it told, class by class, which of all orders vanish?

use super::residual::shape_name;
use super::theorem_words::whose;
use super::typeset;
use crate::engine::Engine;
use crate::page::{Text, phrase};
use crate::proof::Shape;
use crate::verdict::{ClassPattern, FactorPattern, Recurrence, Recurrences, Stars, WholeOrder};

/// More classes of orders than this are counted.
const MOST_LISTED: usize = 24;

/// What is true of every order, of the force and of the moment.
pub(super) fn statements(engine: &Engine, all: &Recurrences) -> Vec<Text> {
    let told = |whole: &WholeOrder, both: &[Recurrence; 2]| {
        let even = parity(engine, [&both[0].even, &both[1].even], &"Even orders".into());
        let odd = parity(engine, [&both[0].odd, &both[1].odd], &"Odd orders from 3 on".into());
        Text::joined([order_one(whole)].into_iter().chain(even).chain(odd), " ")
    };
    let force = phrase!("**Force.** {}", told(&all.first.force, &all.force));
    let moment = phrase!("**Moment.** {}", told(&all.first.moment, &all.moment));
    [force, moment].map(|statement| whose(engine, all.masses, statement)).into()
}

fn order_one(whole: &WholeOrder) -> Text {
    match whole.shape {
        Shape::Balanced | Shape::DoesNotExist => "Order 1 vanishes.".into(),
        Shape::NotDecided if !whole.is_left() => "Order 1 is not decided.".into(),
        Shape::NotDecided => "Order 1 remains.".into(),
        shape => phrase!("Order 1 remains, {}.", shape_name(shape)),
    }
}

/// A sentence for each class, one where both vectors have the same zeros.
fn parity(engine: &Engine, [direct, reverse]: [&[ClassPattern]; 2], orders: &Text) -> Vec<Text> {
    let mut sentences = Vec::new();
    for (of_direct, of_reverse) in direct.iter().zip(reverse) {
        let names: Vec<String> = of_direct.sources.iter().map(|source| source.name(engine)).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let subject = match names.as_slice() {
            _ if direct.len() == 1 => orders.clone(),
            [only] => phrase!("{}, cylinder {}", orders.clone(), (*only).to_owned()),
            several => phrase!("{}, cylinders {}", orders.clone(), typeset::names(several)),
        };
        let stated =
            |class: &ClassPattern| class.stars.factors().into_iter().map(|of| of.zeros().clone()).collect::<Vec<_>>();
        match stated(of_direct) == stated(of_reverse) {
            true => sentences.push(phrase!("{}: {}, in both vectors.", subject, zeros(&of_direct.stars))),
            false => {
                sentences.push(phrase!("{}, direct vector: {}.", subject.clone(), zeros(&of_direct.stars)));
                sentences.push(phrase!("{}, reverse vector: {}.", subject, zeros(&of_reverse.stars)));
            }
        }
    }
    sentences
}

/// Where a sum is zero.
fn zeros(stars: &Stars) -> Text {
    match stars {
        Stars::One(star) => match set(star) {
            Set::All => "all vanish".into(),
            Set::None => "none vanishes".into(),
            Set::These(these) => phrase!("exactly these vanish: {}", these),
        },
        Stars::Banks { bank, banks } => match (set(bank), set(banks)) {
            (Set::All, _) | (_, Set::All) => "all vanish".into(),
            (Set::None, Set::None) => "none vanishes".into(),
            (Set::These(these), Set::None) => {
                phrase!("exactly those vanish at which the star of one bank does: {}", these)
            }
            (Set::None, Set::These(these)) => {
                phrase!("exactly those vanish at which the star of the banks does: {}", these)
            }
            (Set::These(bank), Set::These(banks)) => phrase!(
                "exactly those vanish at which the star of one bank ({}) or that of the banks ({}) does",
                bank,
                banks
            ),
        },
    }
}

/// The zeros of a factor among the orders of its parity.
enum Set {
    All,
    None,
    These(Text),
}

fn set(factor: &FactorPattern) -> Set {
    let zeros = factor.zeros();
    if factor.vanishes_always() {
        return Set::All;
    }
    match zeros.residues.as_slice() {
        [] => Set::None,
        few if few.len() <= MOST_LISTED => {
            let list: Vec<String> = few.iter().map(u32::to_string).collect();
            Set::These(phrase!("{} modulo {}", list.join(", "), zeros.modulus))
        }
        many => Set::These(phrase!("of {} classes modulo {}", many.len(), zeros.modulus)),
    }
}

/// Why so few verdicts prove the statements.
pub(super) fn why(all: &Recurrences) -> Vec<Text> {
    let classes = || all.force.iter().chain(&all.moment).flat_map(|one| one.even.iter().chain(&one.odd));
    let factors = || classes().flat_map(|class| class.stars.factors());
    let verdicts: usize = factors().map(|factor| factor.judged.len()).sum();
    let mut paragraphs = vec![phrase!(
        "From order 2 on the cylinders whose rods have one λ and one |δ| have one coefficient in common, which is not zero where the order exists; an offset below 0 turns their vectors round in odd orders. The order $k$ only multiplies angles, so that whether their sum is zero depends on $k$ modulo a period alone, of even and of odd orders apart: {} verdicts prove it, and {} writes them.",
        verdicts,
        Text::code("classify --json --all-orders")
    )];
    if classes().any(|class| matches!(class.stars, Stars::Banks { .. })) {
        paragraphs.push(
            "The banks are alike: at every order the sum is the star of one bank times the star of the banks, and each has a period of its own."
                .into(),
        );
    }
    if let Some(longest) = factors().filter(|factor| factor.others_left).map(|factor| factor.period).max() {
        paragraphs.push(phrase!(
            "Of a period of {} orders only those are decided that may be zero. All others are not zero: in a sum of n vectors that vanishes, each has a partner at a multiple of 1/R of a turn, R the product of the primes up to n.",
            longest
        ));
    }
    if all.force.iter().any(|one| one.even.len() > 1 || one.odd.len() > 1) {
        paragraphs.push(
            "Where all classes vanish, an order is zero; where exactly one remains, it is not zero for any λ and δ. If several remain they could cancel for some λ and δ: such an order is decided by itself."
                .into(),
        );
    }
    paragraphs
}
