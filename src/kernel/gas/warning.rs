//! What is odd about a pressure, though it can be?

use std::ops::RangeInclusive;

use num_rational::BigRational;

use super::cylinder::CylinderGas;
use crate::engine::{Cycle, PressureLaw, PressureTable};
use crate::file::{USUAL_PEAK_BAR, USUAL_PEAK_DEGREES};

/// Something that a person should look at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Warning {
    /// The largest pressure, in pascals, is below 5 bar or above 400 bar: a unit, perhaps.
    Peak(f64),
    /// The largest pressure is at this angle in degrees, not shortly after the firing dead centre; of single-acting cylinders alone.
    PeakAngle(f64),
    /// The gas takes work instead of giving it, this mean torque in newton-metres: a wrong dead centre, or the other way round.
    TakesWork(f64),
    /// The rows of the table are this many degrees apart: more than 5.
    Coarse(f64),
}

/// Rows farther apart than this, in degrees, leave much to the lines between them.
const WIDEST_STEP: i64 = 5;

/// Whether a value is within a range in these units.
fn is_within(value: f64, usual: &RangeInclusive<i64>, unit: f64) -> bool {
    (*usual.start() as f64 * unit..=*usual.end() as f64 * unit).contains(&value)
}

impl CylinderGas {
    /// What is odd about the pressure of this law.
    pub fn warnings(&self, law: &PressureLaw, cycle: Cycle) -> Vec<Warning> {
        let mut warnings = Vec::new();
        let table = match law {
            // What a compressor and a motored cylinder do is as it should be.
            PressureLaw::Stage(_) => return warnings,
            PressureLaw::Cycle(ideal) if ideal.is_motored() => return warnings,
            PressureLaw::Cycle(_) => None,
            PressureLaw::Table(table) => Some(table),
        };
        let (peak, at) = self.peak_pressure();
        if !is_within(peak, &USUAL_PEAK_BAR, 1e5) {
            warnings.push(Warning::Peak(peak));
        }
        if table.is_some_and(PressureTable::is_constant) {
            return warnings;
        }
        let half = self.period() / 2.0;
        let degrees = ((at - self.zero() + half).rem_euclid(self.period()) - half).to_degrees();
        // A double-acting cylinder is of steam or of a pump as a rule, whose admission makes the largest pressure.
        let is_double_acting = self.sides().len() > 1;
        if !is_double_acting && !is_within(degrees, &USUAL_PEAK_DEGREES, 1.0) {
            warnings.push(Warning::PeakAngle(degrees));
        }
        let mean = self.work() / self.period();
        if mean < 0.0 {
            warnings.push(Warning::TakesWork(mean));
        }
        let widest = table.map(|table| table.widest_step(cycle) * BigRational::from_integer(360.into()));
        if let Some(step) = widest.filter(|step| *step > BigRational::from_integer(WIDEST_STEP.into())) {
            warnings.push(Warning::Coarse(crate::motion::float(&step)));
        }
        warnings
    }
}
