//! In which multiple of its unit is a value read best?

use super::Unit;

/// Newtons, newton metres and kilogram millimetres from which on thousands of them are read more easily, and millions.
const LARGE: f64 = 10_000.0;
const HUGE: f64 = 10_000_000.0;

impl Unit {
    /// A value in this unit as it is read best: from 10000 N on in kN, from ten millions on in MN, and so with N·m.
    pub fn at_sight(self, value: f64) -> (f64, Unit) {
        let (unit, size) = self.for_values_up_to(value);
        (value / size, unit)
    }

    /// The unit in which values in this unit are read best, the largest of which is this; and how much of this unit it is.
    pub fn for_values_up_to(self, largest: f64) -> (Unit, f64) {
        if self == Unit::KILOGRAM_MILLIMETRE && largest.abs() >= LARGE {
            return (Unit::KILOGRAM_METRE, 1e3);
        }
        let larger = match self {
            Unit::NEWTON => [Unit::KILONEWTON, Unit::MEGANEWTON],
            Unit::NEWTON_METRE => [Unit::KILONEWTON_METRE, Unit::MEGANEWTON_METRE],
            _ => return (self, 1.0),
        };
        match largest.abs() {
            size if size >= HUGE => (larger[1], 1e6),
            size if size >= LARGE => (larger[0], 1e3),
            _ => (self, 1.0),
        }
    }
}
