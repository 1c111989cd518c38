//! How is a process of the gas written? `process` and its values; what is omitted is assumed, and marked so.

use num_rational::BigRational;

use super::error::LayoutError;
use super::gas_layers::{Keys, Layers, absolute};
use super::number::parse_number;
use super::quantities::{known_angle, misread, value};
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

/// From here on they are of the events of a cycle, one after the other.
pub(super) const FIRST_EVENT: usize = 11;

/// The keys that a compressor has; the others are of combustion.
const OF_A_STAGE: [&str; 5] =
    ["intake_pressure", "delivery_pressure", "clearance", "compression_exponent", "expansion_exponent"];

/// How the value behind a key is read.
type Reader = fn(&Text) -> Result<BigRational, LayoutError>;

/// The values of a process.
pub(super) struct Settings<'a>(pub &'a Layers<'a>);

/// What is assumed of a two-stroke.
enum TwoStroke {
    /// The same as of a four-stroke.
    Alike,
    Otherwise(i64),
    /// Nothing is usual: how it is charged decides its pressures.
    Nothing,
}

/// What is assumed where a cycle does not say it: in which parts of a pascal, of one, of a turn; of a spark and of a diesel; of two strokes.
const USUAL: [(Setting, i64, [i64; 2], TwoStroke); 10] = [
    (Setting::IntakePressure, 1, [90_000, 200_000], TwoStroke::Nothing),
    (Setting::ExhaustPressure, 1, [110_000, 180_000], TwoStroke::Nothing),
    (Setting::CompressionExponent, 100, [132, 136], TwoStroke::Alike),
    (Setting::ExpansionExponent, 100, [128, 128], TwoStroke::Alike),
    (Setting::WiebeExponent, 1, [2, 1], TwoStroke::Alike),
    (Setting::IntakeCloses, 360, [-180, -180], TwoStroke::Otherwise(-110)),
    (Setting::CombustionStarts, 360, [-20, -6], TwoStroke::Alike),
    (Setting::CombustionLasts, 360, [60, 70], TwoStroke::Alike),
    (Setting::ExhaustOpens, 360, [130, 130], TwoStroke::Otherwise(110)),
    (Setting::Blowdown, 360, [50, 50], TwoStroke::Otherwise(40)),
];

/// The exponents of a compressor, in hundredths.
const OF_A_COMPRESSOR: i64 = 130;

fn usual(setting: Setting, ignition: Ignition, cycle: Cycle) -> Option<BigRational> {
    let (_, parts, [spark, diesel], of_two) = USUAL.iter().find(|(known, ..)| *known == setting)?;
    let of_four = match ignition {
        Ignition::Spark => spark,
        Ignition::Compression => diesel,
    };
    let value = match (cycle, of_two) {
        (Cycle::FourStroke, _) | (Cycle::TwoStroke, TwoStroke::Alike) => of_four,
        (Cycle::TwoStroke, TwoStroke::Otherwise(value)) => value,
        (Cycle::TwoStroke, TwoStroke::Nothing) => return None,
    };
    Some(BigRational::new((*value).into(), (*parts).into()))
}

/// Reads the law of a process.
pub(super) fn read(process: &Text, settings: &Settings<'_>, cycle: Cycle) -> Result<PressureLaw, LayoutError> {
    match process.get_ref().0.as_str() {
        "spark-ignition" => settings.cycle(Ignition::Spark, cycle),
        "diesel" => settings.cycle(Ignition::Compression, cycle),
        "compressor" => settings.stage(process),
        _ => Err(misread(process, "process", "\"spark-ignition\", \"diesel\" or \"compressor\"")),
    }
}

impl Settings<'_> {
    fn cycle(&self, ignition: Ignition, cycle: Cycle) -> Result<PressureLaw, LayoutError> {
        self.without(|key| ["delivery_pressure", "clearance"].contains(&key), "a combustion engine")?;
        let Some(ratio) = self.text(Setting::CompressionRatio) else {
            return Err(self.lacks("a cycle without a compression ratio", "add compression_ratio = 10"));
        };
        let mut assumed = Vec::new();
        // What is said, or else what is usual, where anything is.
        let mut or_usual = |setting: Setting, read: Reader| -> Result<Option<BigRational>, LayoutError> {
            let said = self.read(setting, read)?;
            if said.is_some() {
                return Ok(said);
            }
            let usual = usual(setting, ignition, cycle);
            assumed.extend(usual.is_some().then_some(setting));
            Ok(usual)
        };
        let Some(intake_pressure) = or_usual(Setting::IntakePressure, absolute)? else {
            let right = "add intake_pressure, absolute: that of the scavenging air";
            return Err(self.lacks("a two-stroke without its intake pressure", right));
        };
        if let (Some(text), Cycle::TwoStroke) = (self.text(Setting::ExhaustPressure), cycle) {
            let right = "after its blowdown a two-stroke has the intake_pressure; leave this out";
            return Err(LayoutError::new("an exhaust pressure in a two-stroke", right, place(text)));
        }
        let exhaust_pressure = or_usual(Setting::ExhaustPressure, absolute)?;
        let mut number = |setting, read| -> Result<BigRational, LayoutError> {
            Ok(or_usual(setting, read)?.unwrap_or_else(|| unreachable!("all but the pressures has a usual value")))
        };
        Ok(PressureLaw::Cycle(Box::new(IdealCycle {
            ignition,
            exhaust_pressure: exhaust_pressure.unwrap_or_else(|| intake_pressure.clone()),
            intake_pressure,
            compression_exponent: number(Setting::CompressionExponent, pure)?,
            expansion_exponent: number(Setting::ExpansionExponent, pure)?,
            compression_ratio: pure(ratio)?,
            wiebe_exponent: number(Setting::WiebeExponent, pure)?,
            intake_closes: number(Setting::IntakeCloses, known_angle)?,
            combustion_starts: number(Setting::CombustionStarts, known_angle)?,
            combustion_lasts: number(Setting::CombustionLasts, known_angle)?,
            exhaust_opens: number(Setting::ExhaustOpens, known_angle)?,
            blowdown: number(Setting::Blowdown, known_angle)?,
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
            (Some(text), None, None) => value(text, "heat", units::energy).map(Heat::Released),
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
        self.without(|key| !OF_A_STAGE.contains(&key), "a compressor")?;
        let needed = |setting: Setting, read: Reader| {
            self.read(setting, read)?.ok_or_else(|| {
                let message = format!("a compressor without {}", setting.key());
                let right = "it needs intake_pressure, delivery_pressure and clearance = 0.05";
                LayoutError::new(message, right, place(process))
            })
        };
        let mut assumed = Vec::new();
        let mut exponent = |setting: Setting| {
            let usual = || {
                assumed.push(setting);
                BigRational::new(OF_A_COMPRESSOR.into(), 100.into())
            };
            Ok::<_, LayoutError>(self.read(setting, pure)?.unwrap_or_else(usual))
        };
        Ok(PressureLaw::Stage(Box::new(CompressorStage {
            intake_pressure: needed(Setting::IntakePressure, absolute)?,
            delivery_pressure: needed(Setting::DeliveryPressure, absolute)?,
            clearance: needed(Setting::Clearance, pure)?,
            compression_exponent: exponent(Setting::CompressionExponent)?,
            expansion_exponent: exponent(Setting::ExpansionExponent)?,
            assumed,
        })))
    }

    /// Keys that say nothing of this kind of process.
    fn without(&self, is_other: impl Fn(&str) -> bool, of: &str) -> Result<(), LayoutError> {
        let mut named = KEYS.iter().filter(|(name, _)| is_other(name));
        match named.find_map(|(name, key)| Some((name, self.0.pick(*key)?))) {
            None => Ok(()),
            Some((name, text)) => Err(LayoutError::new(format!("{name} in {of}"), "leave it out", place(text))),
        }
    }

    fn lacks(&self, message: &str, right: &str) -> LayoutError {
        LayoutError::new(message, right, self.0.span.clone())
    }

    /// What is written of a setting.
    fn text(&self, setting: Setting) -> Option<&Text> {
        let (_, key) = KEYS.iter().find(|(name, _)| *name == setting.key())?;
        self.0.pick(*key)
    }

    fn read(&self, setting: Setting, read: Reader) -> Result<Option<BigRational>, LayoutError> {
        self.text(setting).map(read).transpose()
    }
}

fn pure(text: &Text) -> Result<BigRational, LayoutError> {
    let value = parse_number(&text.get_ref().0).map_err(|error| misread(text, "number", error.to_string()))?;
    if units::has_a_size(&value) { Ok(value) } else { Err(misread(text, "number", "out of range")) }
}
