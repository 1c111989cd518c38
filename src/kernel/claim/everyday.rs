//! What do everyday words claim: "no second-order shaking force", "F2 = 0", "secondary forces are balanced"? What may mean two
//! things is asked about, and a word that is not known leaves the sentence to others.

use super::error::{ClaimError, asked};
use super::ordinal::{order_number, ordinal};
use super::statement::{Orders, Predicate, Statement, Subject};
use super::symbols;
use crate::order::Masses;
use crate::proof::{Quantity, Sense};

/// What a sentence says, word by word.
#[derive(Default)]
struct ParsedClaim {
    orders: Vec<u32>,
    /// Whether an ordinal stands without the word order.
    bare: bool,
    has_order_word: bool,
    every: bool,
    higher: bool,
    quantities: Vec<Quantity>,
    senses: Vec<Sense>,
    no: usize,
    not: usize,
    there: bool,
    free: bool,
    inertia: bool,
    /// That it is left, before what it is said of: "no unbalanced force".
    adjective: bool,
    /// That it vanishes, or is left.
    says: Vec<bool>,
}

/// That it vanishes.
const VANISHES: &str = "vanish vanishes vanishing cancel cancels cancelled canceled balanced zero 0 nil null disappear \
    disappears absent nothing";
/// That it is left.
const LEFT: &str = "unbalanced nonzero non-zero remain remains remaining left exist exists present occur occurs survive \
    survives stays acts persists";
/// Words that say nothing.
const FILLERS: &str = "the a an its this that is are be being of in at for to on engine crankshaft shaking resultant \
    resulting total net out both exactly fully completely and or equal equals";

/// Reads everyday words; none where they are no such sentence.
pub(super) fn parse(words: &str) -> Option<Result<Statement, ClaimError>> {
    if let Some(claim) = symbols::parse(words) {
        return Some(claim);
    }
    let said = said(words)?;
    let is_about_something = !said.orders.is_empty() || said.every || said.higher || !said.quantities.is_empty();
    let says_something = !said.says.is_empty() || said.no > 0 || said.adjective || said.there;
    // "The second force" is one of several, and of no order.
    let is_of_orders = said.has_order_word || !said.bare;
    (is_about_something && says_something && is_of_orders).then(|| said.statement(words))
}

fn is_one_of(words: &str, word: &str) -> bool {
    words.split(' ').any(|known| known == word)
}

/// Every word with its meaning; none where one is not known.
fn said(words: &str) -> Option<ParsedClaim> {
    let lower = words.to_lowercase().replace("n't", " not").replace(['’', '\''], " ").replace([',', ';'], " ");
    let lower = lower
        .replace('≠', " ≠ ")
        .replace('=', " = ")
        .replace("first- ", "first-order ")
        .replace("second- ", "second-order ");
    let tokens: Vec<&str> = lower.split_whitespace().collect();
    let mut said = ParsedClaim::default();
    let mut at = 0;
    while let Some(word) = tokens.get(at) {
        at += 1;
        if is_one_of(VANISHES, word) {
            said.says.push(true);
        } else if is_one_of(LEFT, word) {
            match said.quantities.is_empty() && said.says.is_empty() {
                true => said.adjective = true,
                false => said.says.push(false),
            }
        } else if !is_one_of(FILLERS, word) {
            match *word {
                "no" | "without" | "neither" => said.no += 1,
                "nor" => {}
                "not" | "never" => said.not += 1,
                "do" | "does" => {}
                "there" | "has" | "have" | "leaves" | "produces" => said.there = true,
                "free" => said.free = true,
                "inertia" | "inertial" => said.inertia = true,
                "every" | "all" | "any" => said.every = true,
                "higher" => said.higher = true,
                "direct" => said.senses.push(Sense::Direct),
                "reverse" => said.senses.push(Sense::Reverse),
                "force" | "forces" => said.quantities.push(Quantity::FORCE),
                "moment" | "moments" | "couple" | "couples" => said.quantities.push(Quantity::MOMENT),
                "torque" | "torques" => said.quantities.push(Quantity::TORQUE),
                "primary" => said.orders.push(1),
                "secondary" => said.orders.push(2),
                "=" | "≠" => {
                    // Anything but zero is a value, which the other words of claims have.
                    (tokens.get(at) == Some(&"0")).then_some(())?;
                    at += 1;
                    said.says.push(*word == "=");
                }
                "order" | "orders" | "harmonic" | "harmonics" => {
                    said.has_order_word = true;
                    at += numbers(&tokens[at..], &mut said.orders)?;
                }
                other => {
                    let plain = other.strip_suffix("-order").or_else(|| other.strip_suffix("-orders"));
                    said.orders.push(ordinal(plain.unwrap_or(other))?.ok()?);
                    match plain {
                        Some(_) => said.has_order_word = true,
                        None => said.bare = true,
                    }
                }
            }
        }
    }
    said.orders.sort_unstable();
    said.orders.dedup();
    said.quantities.dedup();
    // "Any order" is every order, "any second-order force" is that force.
    said.every &= said.orders.is_empty() && said.has_order_word;
    Some(said)
}

/// The numbers behind the word order, `1`, `1 and 2`; how many words they are.
fn numbers(tokens: &[&str], orders: &mut Vec<u32>) -> Option<usize> {
    let mut read = 0;
    loop {
        let skipped = usize::from(read > 0 && tokens.get(read).is_some_and(|word| ["and", "or"].contains(word)));
        match tokens.get(read + skipped).filter(|word| word.bytes().all(|digit| digit.is_ascii_digit())) {
            Some(number) => orders.push(order_number(number).ok()?),
            None => return Some(read),
        }
        read += skipped + 1;
    }
}

impl ParsedClaim {
    fn statement(mut self, words: &str) -> Result<Statement, ClaimError> {
        let vanishes = self.vanishes(words)?;
        if self.free {
            let question = "\"no free moment\" says it of all orders, about whichever plane; \"second-order moment vanishes\" of one order, about the reference plane";
            return Err(asked(words, question));
        }
        if self.quantities.is_empty() {
            let question = "is it the force, the moment, or both? such as \"second-order force vanishes\", \"second-order moment vanishes\" or \"orders 2 vanish\"";
            return Err(asked(words, question));
        }
        if self.quantities.contains(&Quantity::TORQUE) && !self.inertia {
            return Err(asked(
                words,
                "\"order 2 of the gas torque vanishes\" or \"second-order torque vanishes\", the inertia torque",
            ));
        }
        let orders = match (self.every, self.higher) {
            (_, true) => Orders::Higher,
            (true, false) => Orders::Every,
            (false, false) if self.orders.is_empty() => {
                let question = "which order is meant? such as \"second-order force vanishes\" or \"every order of the force vanishes\"";
                return Err(asked(words, question));
            }
            (false, false) => Orders::Listed(std::mem::take(&mut self.orders)),
        };
        match (&orders, self.quantities.as_slice(), self.senses.as_slice()) {
            (Orders::Listed(list), [quantity], [] | [_]) if list.len() == 1 => {
                let subject = Subject {
                    order: list[0],
                    sense: self.senses.first().copied(),
                    quantity: *quantity,
                    masses: Masses::Reciprocating,
                };
                match (*quantity, subject.sense) {
                    (Quantity::TORQUE, Some(_)) => {
                        Err(ClaimError::new("a torque has no direct and reverse vector", "leave the word out"))
                    }
                    _ => Ok(Statement::Order { subject, predicate: Predicate::Vanishes(vanishes) }),
                }
            }
            (_, quantities, []) if vanishes && !quantities.contains(&Quantity::TORQUE) => {
                Ok(Statement::Vanish { orders, quantities: self.quantities })
            }
            (_, _, []) => {
                Err(asked(words, "does none of them vanish, or not all? claim it of one order and one quantity"))
            }
            (_, _, _) => {
                Err(asked(words, "claim it of the direct or the reverse vector of one order and one quantity"))
            }
        }
    }

    /// Whether it is said to vanish.
    fn vanishes(&self, words: &str) -> Result<bool, ClaimError> {
        let first = self.says.first().copied();
        let alike = self.says.iter().all(|says| Some(*says) == first);
        let unclear = || {
            asked(
                words,
                "write it without a second negation, such as \"second-order force vanishes\" or \"… does not vanish\"",
            )
        };
        match (self.no, self.not, first) {
            _ if !alike => Err(unclear()),
            // No force; no force remains; no unbalanced force.
            (1.., 0, None | Some(false)) => Ok(true),
            (1.., _, _) => Err(unclear()),
            // The unbalanced force vanishes.
            (0, 0, Some(says)) => Ok(says),
            (0, 1, Some(says)) => Ok(!says),
            // There is an unbalanced force; the engine is not without one is left to a clearer sentence.
            (0, 0, None) => Ok(false),
            (0, _, _) => Err(unclear()),
        }
    }
}
