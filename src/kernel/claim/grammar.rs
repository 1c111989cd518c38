//! Which claim do these words make? A small grammar, described in the room's README.

use super::error::ClaimError;
use super::ordinal::{order_number, ordinal};
use super::statement::{Orders, Predicate, Statement, Subject, Unit, Value};
use super::written_value::{angle, kilograms, value};
use super::{forces, gas_torque, multiples, possible, shafts, shaking};
use crate::order::Masses;
use crate::proof::{Quantity, Sense, Shape};

const MASSES: [(&str, Masses); 4] = [
    ("of the pistons", Masses::Reciprocating),
    ("of the rotating masses", Masses::Rotating),
    ("of the counterweights", Masses::Counterweights),
    ("of all masses", Masses::All),
];
const SHAPES: [(&str, Shape); 5] = [
    ("balanced", Shape::Balanced),
    ("rotating", Shape::Rotating),
    ("counter-rotating", Shape::CounterRotating),
    ("planar", Shape::Planar),
    ("elliptical", Shape::Elliptical),
];

/// The words of the README.
pub(super) fn strict(words: &str) -> Result<Statement, ClaimError> {
    let lower = words.to_lowercase();
    if let Some(claim) = shaking::parse(words) {
        return claim;
    }
    if let Some(claim) = gas_torque::parse(&lower).or_else(|| forces::parse(words)).or_else(|| shafts::parse(&lower)) {
        return claim;
    }
    match lower.as_str() {
        "fires evenly" => return Ok(Statement::FiresEvenly { evenly: true }),
        "does not fire evenly" => return Ok(Statement::FiresEvenly { evenly: false }),
        "no free moment" | "no free moments" => return Ok(Statement::NoFreeMoment),
        lower if lower.starts_with(possible::BEGINNING) => return possible::parse(lower),
        lower if lower.starts_with("crankshaft mass ") => return mass(lower),
        lower if lower.starts_with("largest main-bearing load ") => {
            let (sign, written) = next(&words["largest main-bearing load ".len()..]);
            let about = is_about(sign, words, "largest main-bearing load = 18733 N ± 1 %")?;
            return Ok(Statement::BearingLoad(value(written, about, Quantity::FORCE)?));
        }
        lower if lower.starts_with("worst main bearing") => return worst_bearings(lower),
        lower if lower.starts_with("every ") || lower.starts_with("orders ") => return many(lower),
        _ => {}
    }
    let (subject, predicate) = subject(words)?;
    Ok(Statement::Order { subject, predicate: self::predicate(predicate, subject)? })
}

/// `every order of the force vanishes`, `orders 1 and 2 vanish`.
fn many(text: &str) -> Result<Statement, ClaimError> {
    let right = "such as \"every order of the force vanishes\", \"every higher order vanishes\" or \"orders 1 and 2 of the \
                 moment vanish\"";
    let no_claim = || ClaimError::new(format!("`{text}` is not a claim about many orders"), right);
    let rest = text.strip_suffix(" vanishes").or_else(|| text.strip_suffix(" vanish")).ok_or_else(no_claim)?;
    let (rest, quantities) = match rest.split_once(" of the ") {
        None => (rest, vec![Quantity::FORCE, Quantity::MOMENT]),
        Some((rest, word)) => (rest, vec![quantity(word).ok_or_else(no_claim)?]),
    };
    let orders = match rest {
        "every order" => Orders::From(1),
        "every higher order" => Orders::From(2),
        _ => {
            let list = rest.strip_prefix("orders ").ok_or_else(no_claim)?.replace(" and ", ",");
            Orders::Listed(list.split(',').map(|word| order_number(word.trim())).collect::<Result<_, _>>()?)
        }
    };
    Ok(Statement::Vanish { orders, quantities })
}

/// `crankshaft mass = 4.08375 kg`.
fn mass(text: &str) -> Result<Statement, ClaimError> {
    let (sign, written) = next(text.trim_start_matches("crankshaft mass "));
    let about = is_about(sign, text, "crankshaft mass = 4.08375 kg")?;
    Ok(Statement::CrankshaftMass(kilograms(written, about)?))
}

/// Whether a sign is that of about, not that of equality.
fn is_about(sign: &str, words: &str, right: &str) -> Result<bool, ClaimError> {
    match sign {
        "=" => Ok(false),
        "≈" => Ok(true),
        _ => Err(ClaimError::new(format!("`{words}` is not understood"), right)),
    }
}

/// `worst main bearing 3`, `worst main bearings 2 and 3`.
fn worst_bearings(text: &str) -> Result<Statement, ClaimError> {
    let list = text.trim_start_matches("worst main bearing").trim_start_matches('s').replace(" and ", ",");
    let number = |word: &str| word.trim().parse::<usize>().ok().filter(|number| *number > 0);
    let numbers: Option<Vec<usize>> = list.split(',').map(number).collect();
    let right = "their numbers in the list of the layout file, such as \"worst main bearings 2 and 3\"";
    let mut numbers =
        numbers.ok_or_else(|| ClaimError::new(format!("cannot read the bearings `{}`", list.trim()), right))?;
    numbers.sort_unstable();
    numbers.dedup();
    Ok(Statement::WorstBearings(numbers))
}

/// The order, sense and quantity at the beginning, and the words behind them.
fn subject(words: &str) -> Result<(Subject, &str), ClaimError> {
    let (first, rest) = next(words);
    let lower = first.to_lowercase();
    let (order, rest) = match lower.strip_suffix("-order").or(Some(lower.as_str())) {
        Some("order") => {
            let (number, rest) = next(rest);
            (order_number(number)?, rest)
        }
        Some("primary") => (1, rest),
        Some("secondary") => (2, rest),
        Some(word) => {
            let order = ordinal(word).ok_or_else(|| no_order(first))??;
            let rest = if lower.ends_with("-order") { Some(rest) } else { rest.strip_prefix("order ") };
            (order, rest.ok_or_else(|| no_order(first))?)
        }
        None => return Err(no_order(first)),
    };
    let (word, after) = next(rest);
    let (sense, rest) = match word.to_lowercase().as_str() {
        "direct" => (Some(Sense::Direct), after),
        "reverse" => (Some(Sense::Reverse), after),
        _ => (None, rest),
    };
    let (word, rest) = next(rest);
    let quantity = quantity(&word.to_lowercase()).ok_or_else(|| {
        ClaimError::new(format!("`{word}` is not a subject of claims"), "force, moment, couple or torque")
    })?;
    let named = MASSES.iter().find_map(|(words, masses)| Some((rest.strip_prefix(words)?.trim_start(), *masses)));
    let (rest, masses) = named.unwrap_or((rest, Masses::Reciprocating));
    if quantity == Quantity::TORQUE && named.is_some() {
        return Err(ClaimError::new("the torque is that of the pistons", "leave the words of the masses out"));
    }
    if quantity == Quantity::TORQUE && sense.is_some() {
        return Err(ClaimError::new("a torque has no direct and reverse vector", "leave the word out"));
    }
    Ok((Subject { order, sense, quantity, masses }, rest))
}

fn predicate(text: &str, subject: Subject) -> Result<Predicate, ClaimError> {
    let right = "vanishes, does not vanish, is planar, = VALUE, ≈ VALUE ± TOLERANCE, = VALUE at ANGLE, or plane ANGLE";
    let is_plain = subject.sense.is_some() || subject.quantity == Quantity::TORQUE;
    let (word, rest) = next(text);
    match (word, rest) {
        ("vanishes" | "vanish", "") => Ok(Predicate::Vanishes(true)),
        ("does" | "do", "not vanish") => Ok(Predicate::Vanishes(false)),
        ("is" | "are", shape) => match SHAPES.iter().find(|(name, _)| *name == shape) {
            Some((_, Shape::Balanced)) => Ok(Predicate::Vanishes(true)),
            Some((_, shape)) if !is_plain => Ok(Predicate::Is(*shape)),
            Some((name, _)) => Err(ClaimError::new(
                format!("`{name}` applies to both vectors together"),
                "omit the word direct or reverse, or claim it of a force or a moment",
            )),
            // "Is 0" has everyday words.
            None if shape != "0"
                && shape.starts_with(|letter: char| letter.is_ascii_digit() || "√=≈".contains(letter)) =>
            {
                let sign = if shape.starts_with(['=', '≈']) { "" } else { "= " };
                self::predicate(&format!("{sign}{shape}"), subject)
            }
            None => Err(ClaimError::new(
                format!("`{shape}` is not a shape"),
                "balanced, rotating, counter-rotating, planar or elliptical",
            )),
        },
        ("plane", written) => Ok(Predicate::Plane(angle(written)?)),
        ("=" | "≈", written) => {
            let (number, direction) = match written.split_once(" at ") {
                Some((number, direction)) => (number, Some(angle(direction)?)),
                None => (written, None),
            };
            let (number, named) = multiples::without_unit(number, subject)?;
            let value = value(&number, word == "≈", subject.quantity)?;
            let unit = match value.unit {
                Some(_) if named.multiple || named.spacing => {
                    return Err(ClaimError::new(
                        format!("`{written}` counts in newtons and in multiples at once"),
                        "one of both, such as 65.18 N·m or 0.449 m r ω² a",
                    ));
                }
                None if named.spacing => Some(Unit::Spacing),
                unit => unit,
            };
            Ok(Predicate::Equals(Value { unit, is_bare: named.is_bare, ..value }, direction))
        }
        _ => Err(ClaimError::new(format!("`{text}` is not understood"), right)),
    }
}

fn next(text: &str) -> (&str, &str) {
    text.split_once(' ').unwrap_or((text, ""))
}

fn quantity(word: &str) -> Option<Quantity> {
    match word {
        "force" | "forces" => Some(Quantity::FORCE),
        "moment" | "moments" | "couple" | "couples" => Some(Quantity::MOMENT),
        "torque" => Some(Quantity::TORQUE),
        _ => None,
    }
}

fn no_order(word: &str) -> ClaimError {
    let right = "a claim begins with an order, such as first-order, 4th-order or order 4; or it is \"fires evenly\", \"no \
                 free moment\", \"every order of the force vanishes\"";
    ClaimError::new(format!("`{word}` is not an order"), right)
}
