//! Which pressures were measured? Rows of crank angle and pressure, once round the cycle.

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::mistake::{At, GasMistake};
use crate::engine::cycle::Cycle;
use crate::engine::firing::degrees;
use crate::text::counted;

/// More rows than this are refused: every twentieth of a degree of two revolutions has one.
pub const MOST_ROWS: usize = 14_401;
/// Fewer rows than this tell nothing of a cycle.
const FEWEST_ROWS: usize = 2;

/// Angles in turns and absolute pressures in pascals, joined by straight lines, the last row to the first of the next cycle. One row
/// is a pressure that stays.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PressureTable {
    rows: Vec<(BigRational, BigRational)>,
    /// Whether a last row repeated the first, a cycle later.
    is_closed: bool,
}

impl PressureTable {
    /// The table of these rows: angles rise, and the rows go once round the cycle. A last row that stands a whole cycle after the
    /// first repeats it, within a hundredth of the largest pressure, and is omitted.
    ///
    /// # Errors
    /// The first row that cannot be, or what the rows lack together.
    pub fn new(mut rows: Vec<(BigRational, BigRational)>, cycle: Cycle) -> Result<Self, GasMistake> {
        check(&rows, cycle)?;
        let mut is_closed = false;
        if let [(first, start), .., (last, end)] = rows.as_slice()
            && last - first == cycle.turns()
        {
            is_closed = true;
            // Two measurements of one instant are not the same to the last digit.
            let highest = rows.iter().map(|(_, pressure)| pressure).max().unwrap_or(start);
            if (end - start).abs() * BigRational::from_integer(100.into()) > *highest {
                let message =
                    format!("the last row repeats the first, a cycle later, with {end} Pa in place of {start} Pa");
                let right = "a pressure that is periodic: leave the last row out, or correct the measurement";
                return Err(GasMistake::new(message, right, At::Row(rows.len() - 1)));
            }
            rows.pop();
        }
        Ok(PressureTable { rows, is_closed })
    }

    /// The rows, angles rising through less than a cycle.
    pub fn rows(&self) -> &[(BigRational, BigRational)] {
        &self.rows
    }

    /// How many rows were given, a last one that repeats the first counted.
    pub fn given(&self) -> usize {
        self.rows.len() + usize::from(self.is_closed)
    }

    /// Steps from each row to the next, the last back to the first.
    fn steps(&self, cycle: Cycle) -> impl Iterator<Item = BigRational> {
        let after = self.rows.iter().skip(1).map(|row| row.0.clone());
        let again = self.rows.first().map(|row| &row.0 + cycle.turns());
        self.rows.iter().zip(after.chain(again)).map(|(row, next)| next - &row.0)
    }

    /// Whether the pressure is the same all through the cycle.
    pub fn is_constant(&self) -> bool {
        self.rows.windows(2).all(|pair| pair[0].1 == pair[1].1)
    }

    /// The widest step from row to row, in turns.
    pub fn widest_step(&self, cycle: Cycle) -> BigRational {
        self.steps(cycle).max().unwrap_or_else(BigRational::zero)
    }

    pub(super) fn check(&self, cycle: Cycle) -> Result<(), GasMistake> {
        let mut rows = self.rows.clone();
        if let (true, Some((first, pressure))) = (self.is_closed, self.rows.first()) {
            rows.push((first + cycle.turns(), pressure.clone()));
        }
        check(&rows, cycle)
    }
}

fn check(rows: &[(BigRational, BigRational)], cycle: Cycle) -> Result<(), GasMistake> {
    if !(FEWEST_ROWS..=MOST_ROWS).contains(&rows.len()) {
        let message = format!("a table of {}", counted(rows.len(), "row"));
        return Err(GasMistake::new(message, format!("between {FEWEST_ROWS} and {MOST_ROWS} are read"), At::All));
    }
    for (index, (_, pressure)) in rows.iter().enumerate() {
        if !pressure.is_positive() {
            let message = format!("row {}: an absolute pressure of {pressure} Pa", index + 1);
            let right =
                "above 0; if it was measured from ambient, write reading = \"gauge\" and the ambient pressure is added";
            return Err(GasMistake::new(message, right, At::Row(index)));
        }
    }
    for (index, pair) in rows.windows(2).enumerate() {
        if pair[0].0 >= pair[1].0 {
            let message = format!("row {}: the angle does not rise", index + 2);
            return Err(GasMistake::new(message, "each angle is above that of the row before", At::Row(index + 1)));
        }
    }
    let whole = cycle.turns();
    let [(first, _), .., (last, _)] = rows else { return Ok(()) };
    let span = last - first;
    if let Some(index) = rows.iter().position(|row| &row.0 - first > whole) {
        let message = format!("row {}: the rows span more than the cycle of {}°", index + 1, degrees(&whole));
        let right = match cycle {
            Cycle::FourStroke => "one cycle: two revolutions",
            Cycle::TwoStroke => "one cycle: a revolution; or is the engine a four-stroke?",
        };
        return Err(GasMistake::new(message, right, At::Row(index)));
    }
    let widest = rows.windows(2).map(|pair| &pair[1].0 - &pair[0].0).max().unwrap_or_else(BigRational::zero);
    let two = BigRational::from_integer(2.into());
    let is_half = &span * &two <= whole.clone() + &widest;
    if span < whole && (is_half || &whole - &span > widest * &two) {
        let message = format!("the rows span {}° of a cycle of {}°", degrees(&span), degrees(&whole));
        let right = match cycle {
            Cycle::FourStroke => {
                "a four-stroke needs the pressures of two revolutions, 720°, the exchange of gas with them"
            }
            Cycle::TwoStroke => "the pressures of a whole revolution, 360°",
        };
        return Err(GasMistake::new(message, right, At::All));
    }
    Ok(())
}
