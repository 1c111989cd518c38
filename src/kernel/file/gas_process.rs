//! How is a process of the gas written? `process` and its values; what is omitted is assumed, and marked so.

use num_rational::BigRational;

use super::error::LayoutError;
use super::gas_layers::{Keys, Layers, absolute};
use super::number::parse_number;
use super::quantities::misread;
use super::units;
use super::written::{Text, place};
use crate::engine::{CompressorStage, Cycle, Heat, IdealCycle, Ignition, PressureLaw, Setting};

/// Where a key of the tables is.
type Key = fn(&Keys) -> &Option<Text>;

/// The keys of processes; that of the heat is found from it, or from a pressure.
pub(super) const KEYS: [(&str, Key); 16] = [
    ("compression_ratio", |keys| &keys.compression_ratio),
    ("intake_pressure", |keys| &keys.intake_pressure),
    ("exhaust_pressure", |keys| &keys.exhaust_pressure),
    ("delivery_pressure", |keys| &keys.delivery_pressure),
    ("clearance", |keys| &keys.clearance),
    ("compression_exponent", |keys| &keys.compression_exponent),
    ("expansion_exponent", |keys| &keys.expansion_exponent),
    ("heat", |keys| &keys.heat),
    ("peak_pressure", |keys| &keys.peak_pressure),
    ("mean_pressure", |keys| &keys.mean_pressure),
    ("wiebe_exponent", |keys| &keys.wiebe_exponent),
    ("intake_closes", |keys| &keys.intake_closes),
    ("combustion_starts", |keys| &keys.combustion_starts),
    ("combustion_lasts", |keys| &keys.combustion_lasts),
    ("exhaust_opens", |keys| &keys.exhaust_opens),
    ("blowdown", |keys| &keys.blowdown),
];

/// Keys of combustion that a compressor does not have.
const OF_COMBUSTION: [&str; 11] = [
    "compression_ratio",
    "exhaust_pressure",
    "heat",
    "peak_pressure",
    "mean_pressure",
    "wiebe_exponent",
    "intake_closes",
    "combustion_starts",
    "combustion_lasts",
    "exhaust_opens",
    "blowdown",
];

/// The values of a process.
pub(super) struct Settings<'a>(pub &'a Layers<'a>);

/// What is assumed where a cycle does not say it: pressures in hundredths of a bar, exponents in hundredths, angles in degrees.
struct Usual {
    intake_pressure: Option<i64>,
    exhaust_pressure: Option<i64>,
    compression_exponent: i64,
    expansion_exponent: i64,
    wiebe_exponent: i64,
    intake_closes: i64,
    combustion_starts: i64,
    combustion_lasts: i64,
    exhaust_opens: i64,
    blowdown: i64,
}

impl Usual {
    fn of(ignition: Ignition, cycle: Cycle) -> Self {
        let four_stroke = match ignition {
            Ignition::Spark => Usual {
                intake_pressure: Some(90),
                exhaust_pressure: Some(110),
                compression_exponent: 132,
                expansion_exponent: 128,
                wiebe_exponent: 2,
                intake_closes: -180,
                combustion_starts: -20,
                combustion_lasts: 60,
                exhaust_opens: 130,
                blowdown: 50,
            },
            Ignition::Compression => Usual {
                intake_pressure: Some(200),
                exhaust_pressure: Some(180),
                compression_exponent: 136,
                expansion_exponent: 128,
                wiebe_exponent: 1,
                intake_closes: -180,
                combustion_starts: -6,
                combustion_lasts: 70,
                exhaust_opens: 130,
                blowdown: 50,
            },
        };
        match cycle {
            Cycle::FourStroke => four_stroke,
            // How a two-stroke is charged decides its pressure: nothing is usual.
            Cycle::TwoStroke => Usual {
                intake_pressure: None,
                exhaust_pressure: None,
                intake_closes: -110,
                exhaust_opens: 110,
                blowdown: 40,
                ..four_stroke
            },
        }
    }
}

fn hundredths(value: i64, of: i64) -> BigRational {
    BigRational::new((value * of).into(), 100.into())
}

fn turns(degrees: i64) -> BigRational {
    BigRational::new(degrees.into(), 360.into())
}

/// Reads the law of a process.
pub(super) fn read(process: &Text, settings: &Settings<'_>, cycle: Cycle) -> Result<PressureLaw, LayoutError> {
    match process.get_ref().0.as_str() {
        "spark-ignition" => settings.cycle(Ignition::Spark, cycle),
        "diesel" => settings.cycle(Ignition::Compression, cycle),
        "compressor" => settings.stage(process),
        other => Err(misread("process", other, "\"spark-ignition\", \"diesel\" or \"compressor\"".to_owned(), process)),
    }
}

impl Settings<'_> {
    fn cycle(&self, ignition: Ignition, cycle: Cycle) -> Result<PressureLaw, LayoutError> {
        self.without(&["delivery_pressure", "clearance"], "a combustion engine")?;
        let usual = Usual::of(ignition, cycle);
        let mut assumed = Vec::new();
        let mut or = |given: Option<BigRational>, setting: Setting, usual: BigRational| {
            given.unwrap_or_else(|| {
                assumed.push(setting);
                usual
            })
        };
        let Some(ratio) = self.0.pick(|keys| &keys.compression_ratio) else {
            return Err(self.lacks("a cycle without a compression ratio", "add compression_ratio = 10"));
        };
        let bar = 100_000;
        let intake = match (self.0.pressure(|keys| &keys.intake_pressure)?, usual.intake_pressure) {
            (Some(given), _) => given,
            (None, Some(usual)) => or(None, Setting::IntakePressure, hundredths(usual, bar)),
            (None, None) => {
                let right = "add intake_pressure, absolute: that of the scavenging air";
                return Err(self.lacks("a two-stroke without its intake pressure", right));
            }
        };
        let exhaust = match (self.0.pressure(|keys| &keys.exhaust_pressure)?, usual.exhaust_pressure) {
            (Some(given), Some(_)) => given,
            (None, Some(usual)) => or(None, Setting::ExhaustPressure, hundredths(usual, bar)),
            (None, None) => intake.clone(),
            (Some(_), None) => {
                let right = "after its blowdown a two-stroke has the intake_pressure; leave this out";
                return Err(self.at(|keys| &keys.exhaust_pressure, "an exhaust pressure in a two-stroke", right));
            }
        };
        let exponents = [
            or(
                self.number(|keys| &keys.compression_exponent)?,
                Setting::CompressionExponent,
                hundredths(usual.compression_exponent, 1),
            ),
            or(
                self.number(|keys| &keys.expansion_exponent)?,
                Setting::ExpansionExponent,
                hundredths(usual.expansion_exponent, 1),
            ),
        ];
        let [compression_exponent, expansion_exponent] = exponents;
        Ok(PressureLaw::Cycle(Box::new(IdealCycle {
            ignition,
            compression_ratio: pure(ratio)?,
            intake_pressure: intake,
            exhaust_pressure: exhaust,
            compression_exponent,
            expansion_exponent,
            wiebe_exponent: or(
                self.number(|keys| &keys.wiebe_exponent)?,
                Setting::WiebeExponent,
                hundredths(usual.wiebe_exponent, 100),
            ),
            intake_closes: or(
                self.angle(|keys| &keys.intake_closes)?,
                Setting::IntakeCloses,
                turns(usual.intake_closes),
            ),
            combustion_starts: or(
                self.angle(|keys| &keys.combustion_starts)?,
                Setting::CombustionStarts,
                turns(usual.combustion_starts),
            ),
            combustion_lasts: or(
                self.angle(|keys| &keys.combustion_lasts)?,
                Setting::CombustionLasts,
                turns(usual.combustion_lasts),
            ),
            exhaust_opens: or(
                self.angle(|keys| &keys.exhaust_opens)?,
                Setting::ExhaustOpens,
                turns(usual.exhaust_opens),
            ),
            blowdown: or(self.angle(|keys| &keys.blowdown)?, Setting::Blowdown, turns(usual.blowdown)),
            heat: self.heat()?,
            assumed,
        })))
    }

    fn heat(&self) -> Result<Heat, LayoutError> {
        let says = |keys: &Keys| keys.heat.is_some() || keys.peak_pressure.is_some() || keys.mean_pressure.is_some();
        let Some(keys) = self.0.says(says) else {
            let right =
                "add heat = \"1100 J\" a cycle, or peak_pressure or mean_pressure = \"10 bar\", from which it is found";
            return Err(self.lacks("a cycle that does not say what it burns", right));
        };
        match (&keys.heat, &keys.peak_pressure, &keys.mean_pressure) {
            (Some(text), None, None) => {
                let written = &text.get_ref().0;
                units::energy(written).map(Heat::Released).map_err(|right| misread("heat", written, right, text))
            }
            (None, Some(text), None) => absolute(text).map(Heat::PeakPressure),
            (None, None, Some(text)) => absolute(text).map(Heat::MeanPressure),
            (_, Some(text), _) | (_, None, Some(text)) => {
                let right = "one of heat, peak_pressure and mean_pressure is enough";
                Err(LayoutError::new("what is burnt is given twice", right, place(text)))
            }
            (None, None, None) => unreachable!("one of the three is there"),
        }
    }

    fn stage(&self, process: &Text) -> Result<PressureLaw, LayoutError> {
        self.without(&OF_COMBUSTION, "a compressor")?;
        let needed = |value: Option<BigRational>, name: &str| {
            value.ok_or_else(|| {
                let message = format!("a compressor without {name}");
                LayoutError::new(
                    message,
                    "it needs intake_pressure, delivery_pressure and clearance = 0.05",
                    place(process),
                )
            })
        };
        let mut assumed = Vec::new();
        let mut exponent = |given: Option<BigRational>, setting: Setting| {
            given.unwrap_or_else(|| {
                assumed.push(setting);
                hundredths(130, 1)
            })
        };
        Ok(PressureLaw::Stage(Box::new(CompressorStage {
            intake_pressure: needed(self.0.pressure(|keys| &keys.intake_pressure)?, "intake_pressure")?,
            delivery_pressure: needed(self.0.pressure(|keys| &keys.delivery_pressure)?, "delivery_pressure")?,
            clearance: needed(self.number(|keys| &keys.clearance)?, "clearance")?,
            compression_exponent: exponent(
                self.number(|keys| &keys.compression_exponent)?,
                Setting::CompressionExponent,
            ),
            expansion_exponent: exponent(self.number(|keys| &keys.expansion_exponent)?, Setting::ExpansionExponent),
            assumed,
        })))
    }

    /// Keys that say nothing of this kind of process.
    fn without(&self, names: &[&str], of: &str) -> Result<(), LayoutError> {
        let found = KEYS
            .iter()
            .filter(|(name, _)| names.contains(name))
            .find_map(|(name, key)| Some((name, self.0.pick(*key)?)));
        match found {
            None => Ok(()),
            Some((name, text)) => Err(LayoutError::new(format!("{name} in {of}"), "leave it out", place(text))),
        }
    }

    fn lacks(&self, message: &str, right: &str) -> LayoutError {
        LayoutError::new(message, right, self.0.span.clone())
    }

    fn at(&self, key: Key, message: &str, right: &str) -> LayoutError {
        LayoutError::new(message, right, self.0.pick(key).and_then(place))
    }

    fn number(&self, key: Key) -> Result<Option<BigRational>, LayoutError> {
        self.0.pick(key).map(pure).transpose()
    }

    fn angle(&self, key: Key) -> Result<Option<BigRational>, LayoutError> {
        self.0.pick(key).map(super::quantities::known_angle).transpose()
    }
}

fn pure(text: &Text) -> Result<BigRational, LayoutError> {
    let written = &text.get_ref().0;
    let value = parse_number(written).map_err(|error| misread("number", written, error.to_string(), text))?;
    match units::has_a_size(&value) {
        true => Ok(value),
        false => Err(misread("number", written, "out of range".to_owned(), text)),
    }
}
