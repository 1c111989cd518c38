//! Which order of which quantity is F2, and what is said of it: `F2 = 0`, `M₁ = √3`, `F1 = F2 = 0`?

use super::error::{ClaimError, asked};
use super::grammar::strict;
use super::ordinal::order_number;
use super::statement::{Orders, Statement};
use crate::proof::{Quantity, Sense};

/// `F2 = 0`, `F_2 ≠ 0`, `M₁ = √3`, `F1 = F2 = 0`: F is the force, M or C the moment.
pub(super) fn parse(words: &str) -> Option<Result<Statement, ClaimError>> {
    let (name, rest) = symbol(words)?;
    let rest = rest.trim_start();
    let Some(value) = rest.strip_prefix('=') else {
        let rest = rest.replace('≠', "!=").replace("<>", "!=");
        let said = match rest.strip_prefix("!=").map(str::trim) {
            Some("0") => "does not vanish".to_owned(),
            Some(_) => {
                return Some(Err(ClaimError::new(format!("`{words}` denies a value"), "such as F2 ≠ 0, or F2 = 4")));
            }
            None => rest,
        };
        let said =
            said.replace("is zero", "vanishes").replace("is 0", "vanishes").replace("is not zero", "does not vanish");
        return Some(strict(&format!("{} {said}", name.words())));
    };
    let value = value.trim();
    if value == "0" {
        return Some(strict(&format!("{} vanishes", name.words())));
    }
    // Several of them, one after the other.
    let mut names = vec![name];
    let mut left = value;
    while let Some((name, rest)) = symbol(left) {
        names.push(name);
        left = rest.trim_start().strip_prefix('=')?.trim_start();
    }
    match (names.as_slice(), left) {
        ([only], value) => Some(strict(&format!("{} = {value}", only.words()))),
        (_, "0") => Some(all_of(words, &names)),
        (_, _) => None,
    }
}

fn all_of(words: &str, names: &[Symbol]) -> Result<Statement, ClaimError> {
    let mut orders: Vec<u32> = names.iter().map(|name| name.order).collect();
    orders.sort_unstable();
    orders.dedup();
    let quantities = [Quantity::FORCE, Quantity::MOMENT];
    let quantities: Vec<Quantity> =
        quantities.into_iter().filter(|quantity| names.iter().any(|name| name.quantity == *quantity)).collect();
    let is_whole = names.len() == orders.len() * quantities.len() && names.iter().all(|name| name.sense.is_none());
    match is_whole {
        true => Ok(Statement::Vanish { orders: Orders::Listed(orders), quantities }),
        false => Err(asked(words, "write a claim for each of them, such as F2 = 0")),
    }
}

/// An order of a quantity by its letter.
struct Symbol {
    quantity: Quantity,
    order: u32,
    sense: Option<Sense>,
}

impl Symbol {
    fn words(&self) -> String {
        let sense = self.sense.map(|sense| format!("{} ", sense.name())).unwrap_or_default();
        format!("order {} {sense}{}", self.order, self.quantity.name())
    }
}

/// `F2`, `F_2`, `F_{2}`, `F₂⁺`, and what is behind it.
fn symbol(words: &str) -> Option<(Symbol, &str)> {
    let (quantity, rest) = match (words.strip_prefix('F'), words.strip_prefix(['M', 'C'])) {
        (Some(rest), _) => (Quantity::FORCE, rest),
        (None, Some(rest)) => (Quantity::MOMENT, rest),
        (None, None) => return None,
    };
    let rest = rest.strip_prefix('_').unwrap_or(rest);
    let rest = rest.strip_prefix('{').unwrap_or(rest);
    let below = |letter: char| {
        ('₀'..='₉').contains(&letter).then(|| char::from(b'0' + (u32::from(letter) - u32::from('₀')) as u8))
    };
    let digit = |letter: char| if letter.is_ascii_digit() { Some(letter) } else { below(letter) };
    let digits: String = rest.chars().map_while(digit).collect();
    let order = digits.parse().ok().filter(|order| order_number(&digits).is_ok() && *order > 0)?;
    let length: usize = rest.chars().take_while(|letter| digit(*letter).is_some()).map(char::len_utf8).sum();
    let rest = &rest[length..];
    let rest = rest.strip_prefix('}').unwrap_or(rest);
    let signs = [
        ("^{+}", Sense::Direct),
        ("^{-}", Sense::Reverse),
        ("^+", Sense::Direct),
        ("^-", Sense::Reverse),
        ("⁺", Sense::Direct),
        ("⁻", Sense::Reverse),
    ];
    let sign = signs.iter().find_map(|(sign, sense)| Some((rest.strip_prefix(sign)?, *sense)));
    let (rest, sense) = sign.map_or((rest, None), |(rest, sense)| (rest, Some(sense)));
    rest.starts_with([' ', '=', '≠', '!', '<', '≈']).then_some((Symbol { quantity, order, sense }, rest))
}
