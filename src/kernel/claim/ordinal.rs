//! Which order does a word name: `second`, `2nd`, `2`?

use super::error::ClaimError;
use crate::engine::HIGHEST_ORDER;

const ORDINALS: [&str; 12] = [
    "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth", "eleventh",
    "twelfth",
];

/// `second`, `2nd`; none for another word.
pub(super) fn ordinal(word: &str) -> Option<Result<u32, ClaimError>> {
    if let Some(index) = ORDINALS.iter().position(|name| *name == word) {
        return Some(Ok(index as u32 + 1));
    }
    let number = ["st", "nd", "rd", "th"].iter().find_map(|ending| word.strip_suffix(ending))?;
    number.ends_with(|end: char| end.is_ascii_digit()).then(|| order_number(number))
}

/// A whole number that is an order.
pub(super) fn order_number(word: &str) -> Result<u32, ClaimError> {
    match word.parse() {
        Ok(order) if (1..=HIGHEST_ORDER).contains(&order) => Ok(order),
        _ => Err(ClaimError::new(
            format!("`{word}` is not an order"),
            format!(
                "an order of forces and moments is a whole number, 1 to {HIGHEST_ORDER}; half orders are of the gas torque, as in \"order 1/2 of the gas torque vanishes\""
            ),
        )),
    }
}
