//! How fast is it? Speeds of the crank, and frequencies of orders at a speed.

use std::f64::consts::TAU;

use crate::engine::CycleOrder;

/// Revolutions a minute in radians a second.
pub fn angular_speed(rpm: f64) -> f64 {
    rpm / 60.0 * TAU
}

impl CycleOrder {
    /// The order as a decimal, which is exact.
    pub fn value(self) -> f64 {
        f64::from(self.halves()) / 2.0
    }

    /// Oscillations a second at a speed in revolutions a minute.
    pub fn hertz(self, rpm: f64) -> f64 {
        self.value() * rpm / 60.0
    }

    /// The speed in revolutions a minute at which it has a frequency in oscillations a second.
    pub fn rpm(self, hertz: f64) -> f64 {
        60.0 * hertz / self.value()
    }
}
