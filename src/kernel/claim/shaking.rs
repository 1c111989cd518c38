//! Is each term of a Fourier series that of the shaking force of the engine? Term by term, exactly, in powers of the rod ratio.
//!
//! Along the reference direction the force is `Σ m r ω² c_k (A_k cos kθ + B_k sin kθ)`, with `2A_k = Re(P⁺ + P⁻)` and
//! `2B_k = Im(P⁻ − P⁺)`; across it, to the left, `2A_k = Im(P⁺ + P⁻)` and `2B_k = Re(P⁺ − P⁻)` (theory, section 3). The coefficient
//! `c_k` is a series of its own in λ: of order 2, λ + λ³/4 + 15λ⁵/128 + ….

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::{Pow, Zero};

use super::absolute::Numbers;
use super::answer::{Answer, Status};
use super::error::ClaimError;
use super::every;
use super::finding::{Finding, Term, TermVerdict};
use super::formula::{Factor, Formula, Powers, Series, Wave};
use super::handwritten::is_within_of;
use super::statement::{ShakingForce, Statement};
use crate::engine::{Engine, Rods};
use crate::exact::{PhasorSum, Turn};
use crate::motion;
use crate::numbers::{self, Form};
use crate::order;
use crate::proof::{Quantity, Sense};

/// So many powers of λ of a coefficient are compared.
const POWERS: usize = 8;
/// So many make its decimals.
const ALL_POWERS: usize = 60;
/// Terms up to this order, and up to the highest that is claimed, may not be omitted.
const TOLD: u32 = 2;

/// What the words of such a claim begin with.
const ALONG: [&str; 5] =
    ["shaking force along the reference direction", "shaking force along", "shaking force", "F(θ)", "F"];
const ACROSS: [&str; 2] = ["shaking force across the reference direction", "shaking force across"];

/// Reads a claim about the shaking force as a series; none where the words are about something else.
pub(super) fn parse(words: &str) -> Option<Result<Statement, ClaimError>> {
    let behind = |name: &&str| words.strip_prefix(*name)?.trim_start().strip_prefix('=');
    let across = ACROSS.iter().find_map(behind).map(|text| (text, Some(true)));
    let along = ALONG[..2].iter().find_map(behind).map(|text| (text, Some(false)));
    let (text, across) = across.or(along).or_else(|| ALONG[2..].iter().find_map(behind).map(|text| (text, None)))?;
    let right = "such as \"shaking force = 2 m r ω² (cos θ + λ cos 2θ)\"";
    let series = Formula::read(text).and_then(|formula| Series::of(&formula));
    Some(match series {
        Ok(series) => Ok(Statement::ShakingForce(ShakingForce { across, series })),
        Err(mistake) => Err(ClaimError::new(mistake, right)),
    })
}

/// Answers a claim that a series is the shaking force of the pistons, with the rod ratio of the claim's own numbers where it has some.
pub(super) fn answer(engine: &Engine, says: &ShakingForce, numbers: Option<&Numbers>) -> Answer {
    if engine.faster_crank().is_some() {
        return Answer::nothing("a series is compared where all crankshafts turn equally fast");
    }
    let ratio = match engine.all_rods() {
        Rods::Unknown => None,
        Rods::Alike(rod) if rod.is_centric() => Some(&rod.ratio),
        Rods::Alike(_) | Rods::Differ | Rods::Without(_) => {
            return Answer::nothing(
                "a series is compared where all rods are alike, on the crankpin, and no axis is offset",
            );
        }
    };
    let ratio = numbers.map(|numbers| &numbers.rod.ratio).or(ratio);
    let waves = says.series.waves();
    let written = waves.keys().map(|wave| wave.order).max().unwrap_or(0);
    // A force that is 0, without any order, is one of every order: a period of them tells.
    let is_zero = written == 0 && waves.values().flatten().all(|(_, factor)| factor.is_zero());
    let through = if is_zero { None } else { Some(written.max(TOLD)) };
    let Some(highest) = through.or_else(|| every::period(engine).map(|period| period + 1)) else {
        return Answer::nothing("the phases repeat only after more than 2000 orders: claim the orders one by one");
    };
    let exact = |across: bool| -> BTreeMap<Wave, PhasorSum> {
        let orders = (1..=highest).filter(|order| engine.pistons_have_order(Quantity::FORCE, *order));
        let of_order = |order: u32| {
            let found = [false, true].map(|is_sine| Wave { order, is_sine });
            let sums = found.map(|wave| (wave, amplitude(engine, wave, across)));
            sums.into_iter().filter(|(_, sum)| !sum.vanishes()).collect::<Vec<_>>()
        };
        let mut orders = orders.map(of_order).filter(|found| !found.is_empty());
        // Where all are claimed to be 0, the first that is not will do.
        if is_zero { orders.next().into_iter().flatten().collect() } else { orders.flatten().collect() }
    };
    let exact = match says.across {
        Some(across) => exact(across),
        None if is_zero => [false, true].into_iter().map(exact).find(|found| !found.is_empty()).unwrap_or_default(),
        // Which part is meant is asked where there is another.
        None if !exact(true).is_empty() => {
            return Answer::nothing(
                "the force of this engine has a part across the reference direction: claim \"shaking force along = …\" or \
                 \"shaking force across = …\"",
            );
        }
        None => exact(false),
    };
    let all: std::collections::BTreeSet<Wave> = waves.keys().chain(exact.keys()).copied().collect();
    let zero = PhasorSum::new(Vec::new());
    let terms: Vec<Term> = all
        .into_iter()
        .filter_map(|wave| {
            let (zeros, said): (Vec<_>, Vec<_>) =
                waves.get(&wave).cloned().unwrap_or_default().into_iter().partition(|(_, factor)| factor.is_zero());
            let right = exact.get(&wave).unwrap_or(&zero);
            let verdict = judged([&said, &zeros], right, wave.order, ratio)?;
            let coefficient = coefficient(wave.order, 2);
            let said = said.into_iter().map(|(powers, factor)| (powers, factor.form)).collect();
            Some(Term { wave, said, right: (numbers::real(right), numbers::evaluate(right).re), coefficient, verdict })
        })
        .collect();
    let is = |wanted: &[TermVerdict]| terms.iter().any(|term| wanted.contains(&term.verdict));
    let status = match () {
        () if is(&[TermVerdict::Wrong, TermVerdict::WrongUnit, TermVerdict::Missing]) => Status::False,
        () if is(&[TermVerdict::NoRatio]) => Status::NotDecided,
        () if is(&[TermVerdict::Rounded]) => Status::TrueAsRounded,
        () => Status::True,
    };
    Answer { status, finding: Finding::Terms { terms, through }, evidence: Vec::new() }
}

/// What stands before a wave and m r ω² c_k, a real sum.
fn amplitude(engine: &Engine, wave: Wave, across: bool) -> PhasorSum {
    let [direct, reverse] = Sense::BOTH.map(|sense| order::star(engine, Quantity::FORCE, wave.order, Some(sense)));
    let real = |sum: PhasorSum| sum.plus(&sum.conjugate()).scaled(&BigRational::new(1.into(), 4.into()));
    // The imaginary part is the real one of what is turned back by a quarter.
    let imaginary = |sum: PhasorSum| real(sum.turned(&Turn::fraction(3, 4)));
    match (across, wave.is_sine) {
        (false, false) => real(direct.plus(&reverse)),
        (false, true) => imaginary(reverse.minus(&direct)),
        (true, false) => imaginary(direct.plus(&reverse)),
        (true, true) => real(direct.minus(&reverse)),
    }
}

/// What is said of a wave, zeros apart; nothing where that is 0, and is.
fn judged(
    [said, zeros]: [&[(Powers, Factor)]; 2],
    right: &PhasorSum,
    order: u32,
    ratio: Option<&BigRational>,
) -> Option<TermVerdict> {
    let is_force = |powers: &Powers| powers[..3] == [1, 1, 2];
    if said.is_empty() {
        return (!right.vanishes()).then_some(TermVerdict::Missing);
    }
    if !said.iter().all(|(powers, _)| is_force(powers)) {
        return Some(TermVerdict::WrongUnit);
    }
    let series = coefficient(order, POWERS);
    let is_power = |lambda: i32| series.iter().any(|(power, _)| i64::from(*power) == i64::from(lambda));
    if right.vanishes() || zeros.iter().any(|(powers, _)| is_force(powers) && is_power(powers[3])) {
        return Some(TermVerdict::Wrong);
    }
    Some(compared(said, &series, right, order, ratio))
}

fn compared(
    said: &[(Powers, Factor)],
    series: &[(u32, BigRational)],
    right: &PhasorSum,
    order: u32,
    ratio: Option<&BigRational>,
) -> TermVerdict {
    let powers: BTreeMap<i32, &Factor> = said.iter().map(|([.., lambda], factor)| (*lambda, factor)).collect();
    let is_multiple = |form: &Form, by: &BigRational| is_number(form, &right.scaled(by));
    let is_rounded = |factor: &Factor, by: &BigRational| {
        let known = factor.form.as_rational().zip(factor.rounding.as_ref().filter(|rounding| !rounding.is_zero()));
        known.is_some_and(|(value, half)| is_within_of(&right.scaled(by), &value, half))
    };
    // In powers of λ: as many of the first ones as there are.
    let is_exact = |((power, number), (said, factor)): (&(u32, BigRational), (&i32, &&Factor))| match *said {
        said if i64::from(*power) != i64::from(said) => None,
        _ if is_multiple(&factor.form, number) => Some(true),
        _ => is_rounded(factor, number).then_some(false),
    };
    let are_exact: Option<Vec<bool>> = series.iter().zip(&powers).map(is_exact).collect();
    if let Some(are_exact) = are_exact.filter(|_| powers.len() <= series.len()) {
        return match are_exact.contains(&false) {
            true => TermVerdict::Rounded,
            false if order == 1 => TermVerdict::Right,
            false => TermVerdict::UpTo(series[powers.len() - 1].0),
        };
    }
    let only_numbers = order > 1 && powers.keys().all(|power| *power == 0);
    // That of order 1 is 1 whatever the ratio is.
    let none = BigRational::zero();
    let ratio = ratio.or((order == 1).then_some(&none));
    let Some(ratio) = ratio else { return if only_numbers { TermVerdict::NoRatio } else { TermVerdict::Wrong } };
    // With the ratio of the layout put in.
    let at = |power: i32| if power < 0 { ratio.recip().pow(-power) } else { ratio.clone().pow(power) };
    if ratio.is_zero() && powers.keys().any(|power| *power < 0) {
        return TermVerdict::Wrong;
    }
    let parts = powers.iter().map(|(power, factor)| factor.scaled(&at(*power)));
    let none = Factor::exact(Form::rational(BigRational::zero()));
    let value = parts.fold(none, |sum, part| sum.plus(&part));
    let mut sum = BigRational::zero();
    for (power, number) in series {
        sum += number * at(*power as i32);
        if is_multiple(&value.form, &sum) {
            return TermVerdict::UpTo(*power);
        }
    }
    let whole = coefficient(order, ALL_POWERS).iter().map(|(power, number)| number * at(*power as i32)).sum();
    if is_rounded(&value, &whole) { TermVerdict::Rounded } else { TermVerdict::Wrong }
}

/// Whether a number is this real sum.
fn is_number(form: &Form, real: &PhasorSum) -> bool {
    match numbers::as_sum(form) {
        Some(sum) => sum.minus(real).vanishes(),
        None => numbers::real(real).is_some_and(|right| right == *form),
    }
}

/// The first powers of λ in `c_k` with their numbers.
fn coefficient(order: u32, count: usize) -> Vec<(u32, BigRational)> {
    motion::series(order, count).terms().to_vec()
}
