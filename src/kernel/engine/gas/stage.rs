//! What is a stage of a compressor? Compression, delivery, expansion out of the clearance, suction, with ideal valves.

use num_rational::BigRational;

use super::mistake::{At, GasMistake, above_zero, is_exponent};
use super::setting::Setting;
use crate::engine::cycle::Cycle;

/// One stage of a piston compressor; pressures absolute in pascals. Its dead centre of delivery is the angle 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CompressorStage {
    /// Pressure of suction.
    pub intake_pressure: BigRational,
    /// Pressure of delivery.
    pub delivery_pressure: BigRational,
    /// Volume that is left at the dead centre, as a part of the stroke volume.
    pub clearance: BigRational,
    /// Exponent n of the compression.
    pub compression_exponent: BigRational,
    /// Exponent n of the expansion out of the clearance.
    pub expansion_exponent: BigRational,
    /// Which of these were not given, but assumed.
    pub assumed: Vec<Setting>,
}

impl CompressorStage {
    /// The number behind a setting; none where a stage has no such number.
    pub fn value(&self, setting: Setting) -> Option<&BigRational> {
        Some(match setting {
            Setting::IntakePressure => &self.intake_pressure,
            Setting::DeliveryPressure => &self.delivery_pressure,
            Setting::Clearance => &self.clearance,
            Setting::CompressionExponent => &self.compression_exponent,
            Setting::ExpansionExponent => &self.expansion_exponent,
            _ => return None,
        })
    }

    pub(super) fn check(&self, cycle: Cycle) -> Result<(), GasMistake> {
        if cycle == Cycle::FourStroke {
            let right = "a compressor works in every revolution: cycle = \"two-stroke\"";
            return Err(GasMistake::new("a compressor in a four-stroke cycle", right, At::All));
        }
        above_zero(&self.intake_pressure, Setting::IntakePressure)?;
        if self.delivery_pressure <= self.intake_pressure {
            let message = format!("a delivery at {} Pa, not above the suction", self.delivery_pressure);
            return Err(GasMistake::new(message, "both are absolute", At::Setting(Setting::DeliveryPressure)));
        }
        let most = BigRational::from_integer(10.into());
        above_zero(&self.clearance, Setting::Clearance)?;
        if self.clearance > most {
            let message = format!("a clearance of {}", self.clearance);
            return Err(GasMistake::new(
                message,
                "a part of the stroke volume, such as 0.05",
                At::Setting(Setting::Clearance),
            ));
        }
        is_exponent(&self.compression_exponent, Setting::CompressionExponent)?;
        is_exponent(&self.expansion_exponent, Setting::ExpansionExponent)
    }
}
