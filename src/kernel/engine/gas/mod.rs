//! What presses on the pistons? A pressure over each cylinder's own cycle: a table, an ideal cycle, or a compressor's stage.
//!
//! Angles are turns of the crank from the firing dead centre, pressures are absolute and in pascals, both exactly as they were
//! written.

mod cycle;
mod mistake;
mod setting;
mod stage;
mod table;

use num_rational::BigRational;

use super::cycle::Cycle;
pub use cycle::{Heat, IdealCycle, Ignition};
pub use mistake::{At, GasMistake};
pub use setting::Setting;
pub use stage::CompressorStage;
pub use table::{MOST_ROWS, PressureTable};

/// The gas of an engine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Gas {
    /// The different pressure laws.
    pub laws: Vec<PressureLaw>,
    /// One a cylinder, in their order.
    pub chambers: Vec<Chamber>,
}

/// What the gas of one cylinder works on, and by which law.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Chamber {
    /// Bore in metres.
    pub bore: BigRational,
    /// Absolute pressure on the other side of the piston, in pascals; of a double-acting one on the section of its rod.
    pub crankcase: BigRational,
    /// Whether that pressure was not given, but assumed.
    pub crankcase_assumed: bool,
    /// Which of the engine's laws holds.
    pub law: usize,
    /// Which dead centre its angles count from.
    pub zero: DeadCentre,
    /// What presses on the inner side of a double-acting piston.
    pub below: Option<Below>,
}

/// The inner side of a double-acting piston.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Below {
    /// Which of the engine's laws holds there: a table, by the angles of the outer side.
    pub law: usize,
    /// Diameter of the piston rod in metres.
    pub rod: BigRational,
}

/// The absolute pressure of a cylinder through its cycle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PressureLaw {
    /// Measured or computed elsewhere: rows of angle and pressure, joined by straight lines.
    Table(PressureTable),
    /// Compression, burning by Wiebe, expansion, and the exchange of gas.
    Cycle(Box<IdealCycle>),
    /// One stage of a piston compressor.
    Stage(Box<CompressorStage>),
}

/// Where the angle 0 of a pressure is. Without an offset of the cylinder axis both are one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum DeadCentre {
    /// Where the crank points along the cylinder axis, ψ = 0.
    #[default]
    Crank,
    /// Where the piston is farthest out: `sin ψ = δ/(1 + λ)`.
    Piston,
}

impl PressureLaw {
    /// Whether it holds together over such a cycle.
    ///
    /// # Errors
    /// What does not, and where.
    pub fn check(&self, cycle: Cycle) -> Result<(), GasMistake> {
        match self {
            PressureLaw::Table(table) => table.check(cycle),
            PressureLaw::Cycle(ideal) => ideal.check(cycle),
            PressureLaw::Stage(stage) => stage.check(cycle),
        }
    }
}

impl Below {
    fn check(&self, chamber: &Chamber, laws: &[PressureLaw]) -> Result<(), GasMistake> {
        mistake::above_zero(&self.rod, Setting::PistonRod)?;
        if self.rod >= chamber.bore {
            let at = At::Setting(Setting::PistonRod);
            return Err(GasMistake::new("a piston rod as wide as the bore", "a diameter below that of the bore", at));
        }
        match laws.get(self.law) {
            Some(PressureLaw::Table(_)) => Ok(()),
            _ => Err(GasMistake::new("no table of the pressure below the piston", "one for each side", At::All)),
        }
    }
}

impl Gas {
    /// Whether the gas of all cylinders is one, on pistons of one size.
    pub fn is_shared(&self) -> bool {
        self.chambers.windows(2).all(|pair| pair[0] == pair[1])
    }

    /// Whether it fits an engine of this many cylinders.
    ///
    /// # Errors
    /// What does not fit.
    pub fn check(&self, cylinders: usize, cycle: Option<Cycle>) -> Result<(), GasMistake> {
        if self.chambers.len() != cylinders {
            let message = format!("gas in {} cylinders of {cylinders}", self.chambers.len());
            return Err(GasMistake::new(message, "one chamber a cylinder", At::All));
        }
        let Some(cycle) = cycle else {
            let right = "add cycle = \"four-stroke\" or \"two-stroke\"";
            return Err(GasMistake::new("pressures repeat with the cycle, which is missing", right, At::All));
        };
        for chamber in &self.chambers {
            mistake::above_zero(&chamber.bore, Setting::Bore)?;
            mistake::above_zero(&chamber.crankcase, Setting::Crankcase)?;
            if self.laws.get(chamber.law).is_none() {
                return Err(GasMistake::new("a cylinder without a pressure", "one law for each", At::All));
            }
            if let Some(below) = &chamber.below {
                below.check(chamber, &self.laws)?;
            }
        }
        self.laws.iter().try_for_each(|law| law.check(cycle))
    }
}
