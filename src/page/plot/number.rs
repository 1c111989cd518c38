//! How are the numbers of an axis written? Grouped in thousands, or with a power of ten.

use super::super::figure;
use super::super::number::{grouped, power_of_ten};

/// A linear axis that reaches a power outside these is written in powers of ten.
const PLAIN: std::ops::RangeInclusive<i32> = -3..=5;
/// A logarithmic axis likewise.
const PLAIN_LOG: std::ops::RangeInclusive<i32> = -2..=4;

/// The labels of ticks; those of a linear axis share their power of ten.
pub(super) fn labels(values: &[f64], log: bool) -> Vec<String> {
    let powers = || values.iter().filter(|value| **value != 0.0).map(|value| power_of(*value));
    let greatest = powers().max().unwrap_or(0);
    let plain = if log { powers().all(|power| PLAIN_LOG.contains(&power)) } else { PLAIN.contains(&greatest) };
    let label = |value: &f64| match plain {
        true => plain_number(*value),
        false => in_powers(*value, if log { power_of(*value) } else { greatest }),
    };
    values.iter().map(label).collect()
}

/// A power of ten, the nearest float there is.
pub(super) fn ten_to(power: i32) -> f64 {
    format!("1e{power}").parse().unwrap_or(f64::NAN)
}

/// The power of ten of the first digit.
fn power_of(value: f64) -> i32 {
    let text = format!("{value:.9e}");
    text.split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0)
}

/// Nine digits at most, `−` for minus, `10 000`.
fn plain_number(value: f64) -> String {
    let rounded: f64 = format!("{value:.9e}").parse().unwrap_or(value);
    let text = rounded.abs().to_string();
    let (whole, fraction) = text.split_at(text.find('.').unwrap_or(text.len()));
    let whole = if whole.len() > 4 { grouped(whole) } else { whole.to_owned() };
    format!("{}{whole}{fraction}", if rounded < 0.0 { "−" } else { "" })
}

/// `1.5·10⁶`, `10⁻⁵`, `0`.
fn in_powers(value: f64, power: i32) -> String {
    let factor = value / ten_to(power);
    let factor = plain_number(format!("{factor:.9}").parse().unwrap_or(factor));
    let raised = || power_of_ten(power.into());
    match (factor.as_str(), power) {
        ("0", _) => factor,
        (_, 0) => factor,
        ("1", 1) => "10".to_owned(),
        ("1", _) => raised(),
        ("−1", _) => format!("−{}", raised()),
        _ => format!("{factor}·{}", raised()),
    }
}

/// No text is taken to be narrower than this for each of its letters.
const NARROWEST: f64 = 1.65;

/// About the width of a text on the page in millimetres.
pub(crate) fn text_width(text: &str) -> f64 {
    figure::text_width(text, figure::LETTERS).max(NARROWEST * text.chars().count() as f64)
}
