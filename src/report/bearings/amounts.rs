//! How is the force on a bearing written? Six digits after ≈, in newtons where the layout allows; 0 is proved.

use crate::loads::{BearingLoads, Outcome, Peak, Swing, Vector};

/// What forces are counted in.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unit {
    /// As plain text.
    pub name: &'static str,
    /// Units in a multiple of m r ω².
    pub factor: f64,
}

impl Unit {
    pub fn of(loads: &BearingLoads) -> Self {
        match &loads.scale {
            Some(scale) => Unit { name: "N", factor: scale.force() },
            None => Unit { name: "m r ω²", factor: 1.0 },
        }
    }
}

/// Digits of a value.
const DIGITS: i32 = 6;

/// A decimal of six digits without zeros that say nothing, `−` for minus.
pub(super) fn digits(value: f64) -> String {
    let written = format!("{value:.*e}", DIGITS as usize - 1);
    let exponent = written.split_once('e').and_then(|(_, power)| power.parse::<i32>().ok()).unwrap_or(0);
    let text = match exponent {
        -4..=8 => format!("{value:.*}", (DIGITS - 1 - exponent).max(0) as usize),
        _ => written,
    };
    let (mantissa, power) = text.split_once('e').map_or((text.as_str(), String::new()), |(m, p)| (m, format!("e{p}")));
    let short = if mantissa.contains('.') { mantissa.trim_end_matches('0').trim_end_matches('.') } else { mantissa };
    let short = if short == "-0" { "0" } else { short };
    format!("{short}{power}").replace('-', "−")
}

/// The size of a peak: `≈ 18733`, or 0.
pub(super) fn size(peak: &Peak, unit: Unit) -> String {
    if peak.value == 0.0 { "0".to_owned() } else { format!("≈ {}", digits(peak.value * unit.factor)) }
}

/// The crank angle of a peak.
pub(super) fn angle(peak: &Peak) -> String {
    match peak.angle {
        _ if peak.value == 0.0 => "–".to_owned(),
        Some(angle) => format!("≈ {}°", digits(angle)),
        None => "every θ".to_owned(),
    }
}

/// The largest length of an order: 0, its decimals, or how little it is known to be below.
pub(super) fn largest(swing: &Swing, unit: Unit) -> String {
    let vectors = [&swing.direct, &swing.reverse];
    if swing.vanishes() {
        return "0".to_owned();
    }
    if vectors.iter().any(|vector| vector.outcome == Outcome::NotZero) {
        return format!("≈ {}", digits(swing.largest() * unit.factor));
    }
    let below: f64 = vectors.iter().map(|vector| bound(vector)).sum();
    format!("not decided, below {}", digits((below / 2.0 * unit.factor).next_up()))
}

/// One of the two vectors of an order: 0, or its length and its angle at θ = 0.
pub(super) fn vector(vector: &Vector, unit: Unit) -> String {
    match vector.outcome {
        Outcome::Zero => "0".to_owned(),
        Outcome::NotZero => {
            let length = digits(vector.value.norm() / 2.0 * unit.factor);
            format!("≈ {length} at {}°", digits(direction(vector.value.arg().to_degrees())))
        }
        Outcome::Undecided { below } => {
            format!("not decided, below {}", digits((below / 2.0 * unit.factor).next_up()))
        }
    }
}

/// An angle in (−180°, 180°] without what the last digit of a float leaves of 0 or of half a turn.
fn direction(degrees: f64) -> f64 {
    let rounded = (degrees * 1e9).round() / 1e9;
    if rounded <= -180.0 { 180.0 } else { rounded }
}

fn bound(vector: &Vector) -> f64 {
    match vector.outcome {
        Outcome::Undecided { below } => below,
        Outcome::Zero | Outcome::NotZero => 0.0,
    }
}
