//! What is said of the terms of a series: which is wrong, and what would be right?

use num_rational::BigRational;
use num_traits::{One, Signed};

use super::super::typeset::{self, Amount};
use crate::claim::{Powers, Term, TermVerdict, Wave};
use crate::numbers::Form;
use crate::page::number::raised;
use crate::page::{Text, phrase};
use crate::report::texts::claims as text;

/// Each term with what is said of it.
pub(super) fn found(terms: &[Term], through: Option<u32>) -> Text {
    match (terms, through) {
        ([], Some(order)) => text::no_such_force_through(order),
        ([], None) => text::no_such_force(),
        (terms, _) => Text::joined(terms.iter().map(sentence), " "),
    }
}

fn sentence(term: &Term) -> Text {
    let wave = wave(term.wave);
    match term.verdict {
        TermVerdict::Right => text::term_right(wave),
        TermVerdict::UpTo(power) => text::term_right_up_to(wave, lambda(power)),
        TermVerdict::Rounded => text::term_rounded(wave, right(term)),
        TermVerdict::Wrong => text::term_wrong(wave, said(&term.said), right(term)),
        TermVerdict::WrongUnit => text::term_in_wrong_unit(wave, said(&term.said), right(term)),
        TermVerdict::Missing => text::term_missing(wave, right(term)),
        TermVerdict::NoRatio => text::term_without_ratio(wave, right(term)),
    }
}

/// `cos 2θ`.
fn wave(Wave { order, is_sine }: Wave) -> Text {
    let name = if is_sine { "sin" } else { "cos" };
    Text::label(match order {
        0 => "1".to_owned(),
        1 => format!("{name} θ"),
        order => format!("{name} {order}θ"),
    })
}

fn lambda(power: u32) -> String {
    match power {
        0 => "1".to_owned(),
        1 => "λ".to_owned(),
        power => format!("λ{}", raised(power.into())),
    }
}

/// What was claimed: numbers and letters, `2 m r ω² λ + …`.
fn said(parts: &[(Powers, Form)]) -> Text {
    let part = |(powers, form): &(Powers, Form)| {
        let letters = ["m", "r", "ω", "λ"].iter().zip(powers).filter(|(_, power)| **power != 0);
        let letters = letters.map(|(letter, power)| match power {
            1 => (*letter).to_owned(),
            power => format!("{letter}{}", raised((*power).into())),
        });
        let amount = Amount { exact: Some(form.clone()), decimal: form.to_float() };
        phrase!("{} {}", amount, letters.collect::<Vec<_>>().join(" "))
    };
    Text::joined(parts.iter().map(part), " + ")
}

/// `4 m r ω² (λ + 1/4 λ³ + …)`; 0 where nothing belongs there.
fn right(term: &Term) -> Text {
    let (exact, decimal) = &term.right;
    if term.coefficient.is_empty() || *decimal == 0.0 {
        return Text::zero();
    }
    let amount = Amount { exact: exact.clone(), decimal: *decimal };
    match term.coefficient.first() {
        Some((0, _)) => phrase!("{} m r ω²", amount),
        _ => phrase!("{} m r ω² ({} + …)", amount, powers(&term.coefficient)),
    }
}

/// `λ + 1/4 λ³`.
fn powers(coefficient: &[(u32, BigRational)]) -> String {
    let mut text = String::new();
    for (power, number) in coefficient {
        text.push_str(match (text.is_empty(), number.is_negative()) {
            (true, false) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (false, true) => " − ",
        });
        if !number.abs().is_one() {
            text.push_str(&format!("{} ", typeset::number(&number.abs())));
        }
        text.push_str(&lambda(*power));
    }
    text
}
