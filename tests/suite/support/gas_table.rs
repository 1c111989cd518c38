//! Which pressures do tests try, and what are they between their rows?

use super::dice::Dice;

/// The pressure of `[gas]` that a layout leaves out, in pascals.
pub const AMBIENT: f64 = 101_325.0;

/// Five points of Gauss and Legendre in a unit, with their weights.
pub const POINTS: [(f64, f64); 5] = [
    (0.046910077030668, 0.118463442528095),
    (0.230765344947158, 0.239314335249683),
    (0.5, 0.284444444444444),
    (0.769234655052842, 0.239314335249683),
    (0.953089922969332, 0.118463442528095),
];

/// A pressure in bar, two degrees apart through a cycle of this many degrees: it peaks after the dead centre and is rough.
pub fn random(dice: &mut Dice, cycle: f64, peak: u64) -> Vec<f64> {
    let rows = (cycle / 2.0) as usize;
    let bar = |row: usize| {
        let angle = 2.0 * row as f64 - if 2 * row > rows { cycle } else { 0.0 };
        let smooth = 1.0 + peak as f64 * (-(angle - 10.0).powi(2) / 800.0).exp();
        ((smooth + dice.below(100) as f64 / 100.0) * 1e4).round() / 1e4
    };
    (0..rows).map(bar).collect()
}

/// The pressure in pascals at an angle, on lines between the rows.
pub fn pressure(table: &[f64], degrees: f64) -> f64 {
    let place = degrees.rem_euclid(2.0 * table.len() as f64) / 2.0;
    let (row, part) = (place.floor() as usize % table.len(), place.fract());
    1e5 * (table[row] * (1.0 - part) + table[(row + 1) % table.len()] * part)
}

/// The rows as a layout file has them.
pub fn rows(table: &[f64]) -> String {
    table.iter().enumerate().map(|(row, bar)| format!("[{}, {bar}]", 2 * row)).collect::<Vec<_>>().join(", ")
}
