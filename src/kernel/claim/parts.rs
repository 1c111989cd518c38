//! Does a sentence say one thing, word by word, or several? What says several is not guessed at.

use std::collections::BTreeSet;

use crate::proof::Quantity;

/// What a word is to a sentence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mark {
    /// An order.
    Order(u32),
    /// The word order, or higher.
    Orders,
    /// Force, moment or torque.
    Quantity(Quantity),
    /// "No", "without"; and "or" behind one of them, which denies another part.
    No,
    /// "Or" where nothing is denied.
    Or,
    /// "Not".
    Not,
    /// That it vanishes.
    Vanishes,
    /// That it is left.
    Left,
    /// The same, before what it is said of: "no unbalanced force".
    Unbalanced,
    /// A word with which another part begins, such as the article of "no force and a moment".
    Another,
}

/// The words of a sentence that count, in their order.
#[derive(Default)]
pub(super) struct Marks(pub Vec<Mark>);

impl Marks {
    /// How often this stands.
    pub fn count(&self, mark: Mark) -> usize {
        self.0.iter().filter(|one| **one == mark).count()
    }

    /// The orders, rising.
    pub fn orders(&self) -> Vec<u32> {
        let orders = self.0.iter().filter_map(|mark| match mark {
            Mark::Order(order) => Some(*order),
            _ => None,
        });
        orders.collect::<BTreeSet<_>>().into_iter().collect()
    }

    /// The quantities, each as often as it is named.
    pub fn named(&self) -> impl Iterator<Item = Quantity> {
        self.0.iter().filter_map(|mark| match mark {
            Mark::Quantity(quantity) => Some(*quantity),
            _ => None,
        })
    }

    /// Each that is named, once.
    pub fn quantities(&self) -> Vec<Quantity> {
        let mut once = Vec::new();
        for quantity in self.named() {
            if !once.contains(&quantity) {
                once.push(quantity);
            }
        }
        once
    }

    /// That it vanishes or is left, each time.
    pub fn says(&self) -> impl Iterator<Item = bool> {
        self.0.iter().filter_map(|mark| match mark {
            Mark::Vanishes => Some(true),
            Mark::Left => Some(false),
            _ => None,
        })
    }

    /// Whether the same is said of every order with every quantity, whatever the sentence is divided into. `o` stands for orders, `q` for
    /// quantities, which are one group where nothing but fillers is between them.
    ///
    /// `is_listed` tells that all of its orders are named.
    pub fn say_one_thing(&self, is_listed: bool) -> bool {
        let letters = self.letters();
        let is_product = || is_listed && self.is_product();
        match letters.strip_prefix('n') {
            // No force; no force or moment of order 2; no first-order force and no second-order force.
            Some(denied) => {
                let denied = denied.strip_suffix('l').unwrap_or(denied);
                let parts: Vec<&str> = denied.split('n').collect();
                match parts.as_slice() {
                    [only] => ["o", "q", "oq", "qo", "qlo", "olq"].contains(only),
                    several => several.iter().all(|part| ["oq", "qo"].contains(part)) && is_product(),
                }
            }
            // At order 2 no force or moment is left.
            None if letters.contains('n') => ["onq", "onql", "onqnq", "onqnql"].contains(&letters.as_str()),
            None => {
                let is_once = |group: char| letters.matches(group).count() <= 1;
                let vanish = letters.strip_suffix('v').is_some_and(|rest| !rest.contains(['a', 'l', 'r', 't']));
                (is_once('o') && is_once('q')) || (vanish && is_product())
            }
        }
    }

    /// A letter for each mark, or group of orders or quantities.
    fn letters(&self) -> String {
        let has_no = self.count(Mark::No) > 0;
        let mut letters = String::new();
        for mark in &self.0 {
            let letter = match mark {
                Mark::Order(_) | Mark::Orders => 'o',
                Mark::Quantity(_) => 'q',
                Mark::No => 'n',
                Mark::Or => 'r',
                Mark::Not => 't',
                Mark::Vanishes => 'v',
                Mark::Left => 'l',
                Mark::Unbalanced => 'a',
                Mark::Another => 'x',
            };
            // Without a "no" all of it is said of every part.
            if !(letter == 'x' && !has_no || "oq".contains(letter) && letters.ends_with(letter)) {
                letters.push(letter);
            }
        }
        // "Has no", "no unbalanced", "no first-order unbalanced force".
        for [words, one] in [["xn", "n"], ["nx", "n"], ["na", "n"], ["oaq", "oq"]] {
            letters = letters.replace(words, one);
        }
        // "No first- or second-order force or moment": one group.
        while letters.starts_with('n') && (letters.contains("ono") || letters.contains("qnq")) {
            letters = letters.replace("ono", "o").replace("qnq", "q");
        }
        letters.trim_end_matches('x').to_owned()
    }

    /// Whether the pairs of a group of orders and one of quantities, one after the other, are all orders with all quantities.
    fn is_product(&self) -> bool {
        let mut groups: Vec<(bool, Vec<Mark>)> = Vec::new();
        for mark in &self.0 {
            let is_order = match mark {
                Mark::Order(_) => true,
                Mark::Quantity(_) => false,
                _ => continue,
            };
            match groups.last_mut() {
                Some((kind, group)) if *kind == is_order => group.push(*mark),
                _ => groups.push((is_order, vec![*mark])),
            }
        }
        let mut pairs: Vec<(Mark, Mark)> = Vec::new();
        for two in groups.chunks(2) {
            let [(first_is_order, first), (_, second)] = two else { return false };
            let [orders, quantities] = if *first_is_order { [first, second] } else { [second, first] };
            let all = orders.iter().flat_map(|order| quantities.iter().map(|quantity| (*order, *quantity)));
            all.for_each(|pair| {
                if !pairs.contains(&pair) {
                    pairs.push(pair)
                }
            });
        }
        pairs.len() == self.orders().len() * self.quantities().len()
    }
}
