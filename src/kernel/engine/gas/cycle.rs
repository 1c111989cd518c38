//! What is an ideal cycle? Polytropic compression, burning by Wiebe, expansion, and an exchange of gas at even pressures.

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::mistake::{At, GasMistake, above_zero, is_exponent};
use super::setting::Setting;
use crate::engine::cycle::Cycle;
use crate::engine::firing::degrees;

/// How the charge is lit: what is assumed of its burning depends on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ignition {
    /// By a spark.
    Spark,
    /// By compression: a diesel.
    Compression,
}

/// The heat that a cycle releases.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Heat {
    /// This much, in joules.
    Released(BigRational),
    /// As much as gives this highest pressure, absolute, in pascals.
    PeakPressure(BigRational),
    /// As much as gives this mean indicated pressure of the whole cycle, in pascals.
    MeanPressure(BigRational),
}

/// An ideal cycle of a combustion engine: angles in turns from the firing dead centre, pressures absolute in pascals.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IdealCycle {
    /// How it is lit.
    pub ignition: Ignition,
    /// Compression ratio ε: largest over smallest volume.
    pub compression_ratio: BigRational,
    /// Pressure while fresh gas is taken in.
    pub intake_pressure: BigRational,
    /// Pressure while burnt gas is put out; that of the intake in a two-stroke.
    pub exhaust_pressure: BigRational,
    /// Exponent n of the compression.
    pub compression_exponent: BigRational,
    /// Exponent n of burning and expansion.
    pub expansion_exponent: BigRational,
    /// What is burnt.
    pub heat: Heat,
    /// Exponent m of the Wiebe function `1 − exp(−a τ^{m+1})`, `a = ln 1000`.
    pub wiebe_exponent: BigRational,
    /// Where the intake closes and compression begins; below 0.
    pub intake_closes: BigRational,
    /// Where burning starts.
    pub combustion_starts: BigRational,
    /// Over which angle it burns.
    pub combustion_lasts: BigRational,
    /// Where the exhaust opens.
    pub exhaust_opens: BigRational,
    /// Over which angle the pressure falls then.
    pub blowdown: BigRational,
    /// Which of these were not given, but assumed.
    pub assumed: Vec<Setting>,
}

/// Between exhaust and intake of a four-stroke the pressure changes over this many degrees after 360°.
const CHANGE: i64 = 20;

impl IdealCycle {
    /// Over which angle the pressure of the exhaust becomes that of the intake, in turns.
    pub fn change() -> BigRational {
        BigRational::new(CHANGE.into(), 360.into())
    }

    /// The number behind a setting; none where the cycle has no such number.
    pub fn value(&self, setting: Setting) -> Option<&BigRational> {
        Some(match setting {
            Setting::CompressionRatio => &self.compression_ratio,
            Setting::IntakePressure => &self.intake_pressure,
            Setting::ExhaustPressure => &self.exhaust_pressure,
            Setting::CompressionExponent => &self.compression_exponent,
            Setting::ExpansionExponent => &self.expansion_exponent,
            Setting::WiebeExponent => &self.wiebe_exponent,
            Setting::IntakeCloses => &self.intake_closes,
            Setting::CombustionStarts => &self.combustion_starts,
            Setting::CombustionLasts => &self.combustion_lasts,
            Setting::ExhaustOpens => &self.exhaust_opens,
            Setting::Blowdown => &self.blowdown,
            Setting::Heat => match &self.heat {
                Heat::Released(value) | Heat::PeakPressure(value) | Heat::MeanPressure(value) => value,
            },
            Setting::Bore
            | Setting::Crankcase
            | Setting::PistonRod
            | Setting::DeliveryPressure
            | Setting::Clearance => return None,
        })
    }

    pub(super) fn check(&self, cycle: Cycle) -> Result<(), GasMistake> {
        let refuse = |message: String, right: &str, setting| Err(GasMistake::new(message, right, At::Setting(setting)));
        let largest = BigRational::from_integer(1000.into());
        if self.compression_ratio <= BigRational::from_integer(1.into()) || self.compression_ratio > largest {
            let message = format!("a compression ratio of {}", self.compression_ratio);
            return refuse(message, "largest over smallest volume: above 1, such as 10", Setting::CompressionRatio);
        }
        above_zero(&self.intake_pressure, Setting::IntakePressure)?;
        above_zero(&self.exhaust_pressure, Setting::ExhaustPressure)?;
        is_exponent(&self.compression_exponent, Setting::CompressionExponent)?;
        is_exponent(&self.expansion_exponent, Setting::ExpansionExponent)?;
        match &self.heat {
            Heat::Released(heat) if heat.is_negative() => {
                return refuse(format!("a heat of {heat} J"), "0, where it does not fire, or more", Setting::Heat);
            }
            Heat::Released(_) => {}
            Heat::PeakPressure(pressure) => above_zero(pressure, Setting::Heat)?,
            Heat::MeanPressure(pressure) => above_zero(pressure, Setting::Heat)?,
        }
        if self.wiebe_exponent.is_negative() || self.wiebe_exponent > BigRational::from_integer(20.into()) {
            let message = format!("a Wiebe exponent of {}", self.wiebe_exponent);
            return refuse(message, "from 0 to 20; 2 is usual for a spark, 1 for a diesel", Setting::WiebeExponent);
        }
        let shortest = BigRational::new(1.into(), 3600.into());
        for (angle, setting) in
            [(&self.combustion_lasts, Setting::CombustionLasts), (&self.blowdown, Setting::Blowdown)]
        {
            if *angle < shortest {
                return refuse(format!("{} is {}°", setting.key(), degrees(angle)), "0.1° or more", setting);
            }
        }
        self.check_order(cycle)
    }

    /// Each event comes after the one before.
    fn check_order(&self, cycle: Cycle) -> Result<(), GasMistake> {
        let burnt = &self.combustion_starts + &self.combustion_lasts;
        let open = &self.exhaust_opens + &self.blowdown;
        let again = &self.intake_closes + cycle.turns();
        let even = match cycle {
            Cycle::FourStroke => BigRational::from_integer(1.into()),
            Cycle::TwoStroke => again.clone(),
        };
        let refuse = |setting: Setting, words: &str, after: &BigRational| {
            Err(GasMistake::new(
                format!("{words} {}°", degrees(after)),
                "in order of the cycle, in degrees from the firing dead \
                 centre: intake_closes, combustion_starts, its end, exhaust_opens, the end of its blowdown, intake_closes",
                At::Setting(setting),
            ))
        };
        if !self.intake_closes.is_negative() {
            return refuse(
                Setting::IntakeCloses,
                "the intake closes before the firing dead centre, not after it, at",
                &self.intake_closes,
            );
        }
        if !again.is_positive() {
            let whole = -cycle.turns();
            return refuse(
                Setting::IntakeCloses,
                "the intake closes more than a cycle before it fires, before",
                &whole,
            );
        }
        if self.combustion_starts < self.intake_closes {
            return refuse(Setting::CombustionStarts, "it burns before the intake closes at", &self.intake_closes);
        }
        if self.exhaust_opens < burnt {
            let words =
                format!("the exhaust opens at {}°, before the charge is burnt, at", degrees(&self.exhaust_opens));
            return refuse(Setting::ExhaustOpens, &words, &burnt);
        }
        if open > even {
            return refuse(Setting::Blowdown, "the blowdown ends after the burnt gas has to be out, at", &even);
        }
        if cycle == Cycle::FourStroke && even + IdealCycle::change() > again {
            return refuse(
                Setting::IntakeCloses,
                "the intake closes before it opens: in the cycle it would be at",
                &again,
            );
        }
        Ok(())
    }

    /// Whether nothing burns: a cylinder that misfires, or is motored.
    pub fn is_motored(&self) -> bool {
        match &self.heat {
            Heat::Released(heat) => heat.is_zero(),
            Heat::PeakPressure(_) | Heat::MeanPressure(_) => false,
        }
    }
}
