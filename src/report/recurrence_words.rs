//! In which sentences is it told, class by class, which of all orders vanish?

use super::residual::shape_name;
use super::theorem_words::of_both;
use super::typeset;
use crate::engine::Engine;
use crate::page::{Choice, Text, phrase};
use crate::proof::Shape;
use crate::report::texts::recurrence as text;
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
    let force = told(&all.first.force, &all.force);
    let moment = told(&all.first.moment, &all.moment);
    of_both(engine, all.masses, [force, moment])
}

fn order_one(whole: &WholeOrder) -> Text {
    match whole.shape {
        Shape::Balanced | Shape::DoesNotExist => text::first_vanishes(),
        Shape::NotDecided if !whole.is_left() => text::first_not_decided(),
        Shape::NotDecided => text::first_remains(),
        shape => text::first_remains_with_shape(shape_name(shape)),
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
        let stated = |class: &ClassPattern| {
            class.stars.factors().into_iter().map(|of| of.claim.zeros.clone()).collect::<Vec<_>>()
        };
        match stated(of_direct) == stated(of_reverse) {
            true => sentences.push(text::both_vectors(subject, zeros(&of_direct.stars))),
            false => {
                sentences.push(text::direct_vector(subject.clone(), zeros(&of_direct.stars)));
                sentences.push(text::reverse_vector(subject, zeros(&of_reverse.stars)));
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
            Set::These(these) => text::zeros(these),
        },
        Stars::Banks { bank, banks } => match (set(bank), set(banks)) {
            (Set::All, _) | (_, Set::All) => "all vanish".into(),
            (Set::None, Set::None) => "none vanishes".into(),
            (Set::These(these), Set::None) => text::zeros_of_bank(these),
            (Set::None, Set::These(these)) => text::zeros_of_banks(these),
            (Set::These(bank), Set::These(banks)) => text::zeros_of_either(bank, banks),
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
    let zeros = &factor.claim.zeros;
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
    let verdicts: usize = factors().map(|factor| factor.claim.judged.len()).sum();
    if verdicts == 0 {
        return Vec::new();
    }
    let mut paragraphs = vec![text::period_alone(verdicts, Text::code("classify --json --all-orders"))];
    let of_banks = [&all.force, &all.moment].map(|of| {
        let mut classes = of.iter().flat_map(|one| one.even.iter().chain(&one.odd));
        classes.any(|class| matches!(class.stars, Stars::Banks { .. }))
    });
    let banks = match of_banks {
        [false, false] => None,
        [true, true] => Some(0),
        [true, false] => Some(1),
        [false, true] => Some(2),
    };
    paragraphs.extend(banks.map(|of| text::banks_alike(Choice::of(of))));
    if let Some(longest) = factors().filter_map(|factor| factor.sieved).max() {
        paragraphs.push(text::few_decided(longest));
    }
    if all.force.iter().any(|one| one.even.len() > 1 || one.odd.len() > 1) {
        paragraphs.push(text::several_classes());
    }
    paragraphs
}
