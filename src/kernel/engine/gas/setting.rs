//! Which values can be said of the gas, and what are they called?

/// A value of the gas, by its key in a layout file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Setting {
    /// Bore of the cylinder.
    Bore,
    /// Pressure in the crankcase, or under the piston.
    Crankcase,
    /// Diameter of the piston rod of a double-acting cylinder.
    PistonRod,
    /// Compression ratio ε.
    CompressionRatio,
    /// Pressure at which the fresh gas is taken in.
    IntakePressure,
    /// Pressure at which the burnt gas is put out.
    ExhaustPressure,
    /// Exponent of the polytropic compression.
    CompressionExponent,
    /// Exponent of burning and expansion.
    ExpansionExponent,
    /// Heat released in a cycle, or the pressure that it is found from.
    Heat,
    /// Exponent m of the Wiebe function.
    WiebeExponent,
    /// Where the intake, or the last port, closes.
    IntakeCloses,
    /// Where burning starts.
    CombustionStarts,
    /// Over which angle it burns.
    CombustionLasts,
    /// Where the exhaust opens.
    ExhaustOpens,
    /// Over which angle the pressure falls to that of the exhaust.
    Blowdown,
    /// Pressure at which a compressor delivers.
    DeliveryPressure,
    /// Clearance of a compressor, as a part of its stroke volume.
    Clearance,
}

impl Setting {
    /// Its key in a layout file.
    pub fn key(self) -> &'static str {
        match self {
            Setting::Bore => "bore",
            Setting::Crankcase => "crankcase",
            Setting::PistonRod => "piston_rod",
            Setting::CompressionRatio => "compression_ratio",
            Setting::IntakePressure => "intake_pressure",
            Setting::ExhaustPressure => "exhaust_pressure",
            Setting::CompressionExponent => "compression_exponent",
            Setting::ExpansionExponent => "expansion_exponent",
            Setting::Heat => "heat",
            Setting::WiebeExponent => "wiebe_exponent",
            Setting::IntakeCloses => "intake_closes",
            Setting::CombustionStarts => "combustion_starts",
            Setting::CombustionLasts => "combustion_lasts",
            Setting::ExhaustOpens => "exhaust_opens",
            Setting::Blowdown => "blowdown",
            Setting::DeliveryPressure => "delivery_pressure",
            Setting::Clearance => "clearance",
        }
    }
}
