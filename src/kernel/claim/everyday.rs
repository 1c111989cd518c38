//! What do everyday words claim: "no second-order shaking force", "F2 = 0", "secondary forces are balanced"? What may mean two
//! things is asked about, and a word that is not known leaves the sentence to others.

use super::error::{ClaimError, asked};
use super::ordinal::{order_number, ordinal};
use super::parts::{Mark, Marks};
use super::statement::{Orders, Predicate, Statement, Subject};
use super::symbols;
use crate::order::Masses;
use crate::proof::{Quantity, Sense};

/// What a sentence says, word by word.
#[derive(Default)]
struct ParsedClaim {
    marks: Marks,
    /// Whether an ordinal stands without the word order.
    bare: bool,
    has_order_word: bool,
    every: bool,
    higher: bool,
    senses: Vec<Sense>,
    there: bool,
    free: bool,
    inertia: bool,
}

/// That it vanishes.
const VANISHES: &str = "vanish vanishes vanishing cancel cancels cancelled canceled balanced zero 0 nil null disappear \
    disappears absent nothing";
/// That it is left.
const LEFT: &str = "unbalanced nonzero non-zero remain remains remaining left exist exists present occur occurs survive \
    survives stays acts persists";
/// Words that say nothing.
const FILLERS: &str = "the a an its this that is are be being of in at for to on engine crankshaft shaking resultant \
    resulting total net out both exactly fully completely and equal equals";
/// Words with which another part of a sentence may begin.
const BEGINNINGS: &str = "a an there has have leaves produces";

/// Reads everyday words; none where they are no such sentence.
pub(super) fn parse(words: &str) -> Option<Result<Statement, ClaimError>> {
    if let Some(claim) = symbols::parse(words) {
        return Some(claim);
    }
    let said = said(words)?;
    let is = |wanted: &[Mark]| said.marks.0.iter().any(|mark| wanted.contains(mark));
    let is_about_something =
        said.every || said.higher || !said.marks.orders().is_empty() || said.marks.named().next().is_some();
    let says_something = said.there || is(&[Mark::No, Mark::Unbalanced, Mark::Vanishes, Mark::Left]);
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
        let marks = &mut said.marks.0;
        if is_one_of(BEGINNINGS, word) && !marks.is_empty() {
            marks.push(Mark::Another);
        }
        if is_one_of(VANISHES, word) {
            marks.push(Mark::Vanishes);
        } else if is_one_of(LEFT, word) {
            let is_before = |mark: &Mark| !matches!(mark, Mark::Quantity(_) | Mark::Vanishes | Mark::Left);
            let left = if marks.iter().all(is_before) { Mark::Unbalanced } else { Mark::Left };
            marks.push(left);
        } else if !is_one_of(FILLERS, word) {
            match *word {
                "no" | "without" | "neither" => marks.push(Mark::No),
                // "Order 2 or higher" is both, "no force or moment" neither.
                "or" if tokens.get(at) == Some(&"higher") => {}
                "or" | "nor" => marks.push(or(marks)),
                "not" | "never" => marks.push(Mark::Not),
                "do" | "does" => {}
                "there" | "has" | "have" | "leaves" | "produces" => said.there = true,
                "free" => said.free = true,
                "inertia" | "inertial" => said.inertia = true,
                "every" | "all" | "any" => said.every = true,
                "higher" => {
                    said.higher = true;
                    marks.push(Mark::Orders);
                }
                "direct" => said.senses.push(Sense::Direct),
                "reverse" => said.senses.push(Sense::Reverse),
                "force" | "forces" => marks.push(Mark::Quantity(Quantity::FORCE)),
                "moment" | "moments" | "couple" | "couples" => marks.push(Mark::Quantity(Quantity::MOMENT)),
                "torque" | "torques" => marks.push(Mark::Quantity(Quantity::TORQUE)),
                "primary" => marks.push(Mark::Order(1)),
                "secondary" => marks.push(Mark::Order(2)),
                "=" | "≠" => {
                    // Anything but zero is a value, which the other words of claims have.
                    (tokens.get(at) == Some(&"0")).then_some(())?;
                    at += 1;
                    marks.push(if *word == "=" { Mark::Vanishes } else { Mark::Left });
                }
                "order" | "orders" | "harmonic" | "harmonics" => {
                    said.has_order_word = true;
                    marks.push(Mark::Orders);
                    at += numbers(&tokens[at..], marks)?;
                }
                other => {
                    let plain = other.strip_suffix("-order").or_else(|| other.strip_suffix("-orders"));
                    marks.push(Mark::Order(ordinal(plain.unwrap_or(other))?.ok()?));
                    match plain {
                        Some(_) => said.has_order_word = true,
                        None => said.bare = true,
                    }
                }
            }
        }
    }
    // "Any order" is every order, "any second-order force" is that force.
    said.every &= said.marks.orders().is_empty() && said.has_order_word;
    Some(said)
}

/// The numbers behind the word order, `1`, `1 and 2`; how many words they are.
fn numbers(tokens: &[&str], marks: &mut Vec<Mark>) -> Option<usize> {
    let mut read = 0;
    loop {
        let joint = tokens.get(read).filter(|word| read > 0 && ["and", "or"].contains(word));
        let skipped = usize::from(joint.is_some());
        match tokens.get(read + skipped).filter(|word| word.bytes().all(|digit| digit.is_ascii_digit())) {
            Some(number) => {
                marks.extend(joint.filter(|word| **word == "or").map(|_| or(marks)));
                marks.push(Mark::Order(order_number(number).ok()?));
            }
            None => return Some(read),
        }
        read += skipped + 1;
    }
}

/// "No force or moment" denies both; else one of two is meant, nobody knows which.
fn or(marks: &[Mark]) -> Mark {
    if marks.contains(&Mark::No) { Mark::No } else { Mark::Or }
}

impl ParsedClaim {
    fn statement(self, words: &str) -> Result<Statement, ClaimError> {
        let vanishes = self.vanishes(words)?;
        let quantities = self.marks.quantities();
        if self.free {
            let question = "\"no free moment\" says it of all orders, about whichever plane; \"second-order moment vanishes\" of one order, about the reference plane";
            return Err(asked(words, question));
        }
        if quantities.is_empty() {
            let question = "is it the force, the moment, or both? such as \"second-order force vanishes\", \"second-order moment vanishes\" or \"orders 2 vanish\"";
            return Err(asked(words, question));
        }
        if quantities.contains(&Quantity::TORQUE) && !self.inertia {
            return Err(asked(
                words,
                "\"order 2 of the gas torque vanishes\" or \"second-order torque vanishes\", the inertia torque",
            ));
        }
        let orders = self.orders(words)?;
        let is_listed = matches!(orders, Orders::Listed(_)) && self.senses.is_empty();
        let is_one = self.senses.is_empty() || self.marks.named().count() == 1;
        if !(is_one && self.marks.say_one_thing(is_listed)) {
            let question = "write a claim for each thing that it says, such as \"second-order force vanishes\"";
            return Err(asked(words, question));
        }
        match (&orders, quantities.as_slice(), self.senses.as_slice()) {
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
            (_, several, []) if vanishes && !several.contains(&Quantity::TORQUE) => {
                Ok(Statement::Vanish { orders, quantities })
            }
            (_, _, []) => {
                Err(asked(words, "does none of them vanish, or not all? claim it of one order and one quantity"))
            }
            (_, _, _) => {
                Err(asked(words, "claim it of the direct or the reverse vector of one order and one quantity"))
            }
        }
    }

    /// The orders that are named, and with "higher" all above them.
    fn orders(&self, words: &str) -> Result<Orders, ClaimError> {
        let named = self.marks.orders();
        if !self.higher {
            return match (self.every, named.is_empty()) {
                (true, _) => Ok(Orders::From(1)),
                (false, false) => Ok(Orders::Listed(named)),
                (false, true) => Err(asked(
                    words,
                    "which order is meant? such as \"second-order force vanishes\" or \"every order of the force vanishes\"",
                )),
            };
        }
        let below = 1..=named.last().copied().unwrap_or(1);
        let left_out: Vec<u32> = below.filter(|order| !named.contains(order)).collect();
        match left_out.as_slice() {
            [] => Ok(Orders::From(1)),
            [1] => Ok(Orders::From(2)),
            _ => Err(asked(
                words,
                "which orders are left out? such as \"every order of the force vanishes\", \"every higher order of the force vanishes\", \
                 which leaves out the first alone, or \"orders 1, 4 and 6 of the force vanish\"",
            )),
        }
    }

    /// Whether it is said to vanish.
    fn vanishes(&self, words: &str) -> Result<bool, ClaimError> {
        let [no, not] = [Mark::No, Mark::Not].map(|mark| self.marks.count(mark));
        let first = self.marks.says().next();
        let alike = self.marks.says().all(|says| Some(says) == first);
        let unclear = || {
            asked(
                words,
                "write it without a second negation, such as \"second-order force vanishes\" or \"… does not vanish\"",
            )
        };
        match (no, not, first) {
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
