//! In which multiples is a value claimed: `0.449 m r ω² a`, `4 m r ω² c_2`, `0.449 a`?

use super::error::ClaimError;
use super::statement::Subject;
use crate::proof::Quantity;

const SUBSCRIPTS: &str = "₀₁₂₃₄₅₆₇₈₉";
const FORCES: [&str; 6] = ["m r ω²", "m r ω^2", "m r w²", "m r w^2", "mrω²", "mrω^2"];

/// Which names stand behind a value or its tolerance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Named {
    /// m r ω², or c_k.
    pub multiple: bool,
    /// The spacing a.
    pub spacing: bool,
    /// m r ω² without c_k.
    pub is_bare: bool,
}

/// The value with its tolerance, without the names of the multiples that values are counted in, and which they were.
pub(super) fn without_unit(text: &str, subject: Subject) -> Result<(String, Named), ClaimError> {
    let mut named = Named::default();
    let parts = text.replace("+/-", "±");
    let parts: Result<Vec<&str>, ClaimError> = parts.split('±').map(|part| plain(part, subject, &mut named)).collect();
    Ok((parts?.join(" ± "), named))
}

fn plain<'a>(text: &'a str, subject: Subject, named: &mut Named) -> Result<&'a str, ClaimError> {
    let text = text.trim();
    if subject.quantity == Quantity::TORQUE {
        return Ok(text);
    }
    let arm = behind(text, "a").filter(|_| subject.quantity == Quantity::MOMENT);
    let left = arm.unwrap_or(text);
    let order = subject.order.to_string();
    let digits = order.chars().filter_map(|digit| digit.to_digit(10));
    let small: String = digits.filter_map(|digit| SUBSCRIPTS.chars().nth(digit as usize)).collect();
    let names = [format!("c_{order}"), format!("c{order}"), format!("c{small}"), "c_k".to_owned()];
    let coefficient = names.iter().find_map(|name| behind(left, name));
    let left = coefficient.unwrap_or(left);
    let force = FORCES.iter().find_map(|force| behind(left, force));
    named.spacing |= arm.is_some();
    named.multiple |= force.or(coefficient).is_some();
    named.is_bare |= force.is_some() && coefficient.is_none();
    match force {
        // What is printed in m r ω² alone has its coefficient in the number, which the rod decides.
        Some(_) if coefficient.is_none() && subject.order > 1 => Err(ClaimError::new(
            format!("`{text}` leaves the coefficient of order {order} to the rod"),
            format!("the multiple of m r ω² c_{order}, such as √3 or 4 m r ω² c_{order}"),
        )),
        Some(number) => Ok(number),
        None => Ok(left),
    }
}

/// What is before a word at the end.
fn behind<'a>(text: &'a str, word: &str) -> Option<&'a str> {
    let rest = text.strip_suffix(word)?;
    let number = rest.trim_end_matches([' ', '·']);
    (number.len() < rest.len() && !number.is_empty()).then_some(number)
}
