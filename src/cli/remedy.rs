//! `remedy`: which counterweights and balancer shafts cancel what is left?

use std::fmt::Display;
use std::path::{Path, PathBuf};

use crankstar::engine::{Draft, Engine, LengthUnit};
use crankstar::exact::Turn;
use crankstar::file::{self, parse_angle, parse_length, parse_number, parse_radius};
use crankstar::remedy::{self, Request};
use crankstar::report;
use crankstar::text::counted;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::answer::Answer;
use super::failure::Failure;
use super::orders::EngineAndOrders;
use super::weigh::Threshold;
use super::{folder, layouts, write};

/// Arguments of `remedy`.
#[derive(clap::Args)]
pub struct Remedy {
    #[command(flatten)]
    about: EngineAndOrders,
    /// Two planes for counterweights and couples, positions along the crankshaft [default: the outermost throws]
    #[arg(long, value_name = "Z1,Z2", value_delimiter = ',', allow_hyphen_values = true)]
    planes: Vec<String>,
    /// Counterweights on each throw with this balance factor: one for all throws, or one per throw
    #[arg(long, value_name = "FACTORS", value_delimiter = ',')]
    balance_factor: Vec<String>,
    /// Angle of these counterweights from the direction opposite to their throw, in degrees: one for all throws, or one per throw
    #[arg(long, value_name = "ANGLES", value_delimiter = ',', allow_hyphen_values = true, requires = "balance_factor")]
    skew: Vec<String>,
    /// Counterweights on each throw for all that rotates and this part of the reciprocating masses: one for all throws, or one per throw
    #[arg(long, value_name = "PARTS", value_delimiter = ',', conflicts_with = "balance_factor")]
    reciprocating: Vec<String>,
    /// Show the mass of each weight at this radius, such as "3.5 in"
    #[arg(long, value_name = "LENGTH")]
    radius: Option<String>,
    /// Place the shafts of a pair for the least squares of the roll moment over these speeds in rpm, with the gas of the layout
    #[arg(long, value_name = "SPEEDS", value_delimiter = ',')]
    speeds: Vec<String>,
    /// Write the layout file of the corrected engine, exact
    #[arg(long, value_name = "FILE")]
    write: Option<PathBuf>,
    /// Print the remedy as JSON with its certificates, for `verify`
    #[arg(long, conflicts_with_all = ["output", "format"])]
    json: bool,
    #[command(flatten)]
    above: Threshold,
    #[command(flatten)]
    answer: Answer,
}

/// What is said of a file whose weights are not all exact.
const ROUNDED: &str = "The weights against what links on a master rod leave have no exact size: in the file they are decimals, and leave less than 10^-6 of \
                       the load.\n";

/// What is said where masses are asked for of the document.
const NO_MASSES: &str =
    "the document holds what `verify` checks, without masses at a radius; --format json --table weights has them";

/// What is said where places of shafts over several speeds are asked for of data.
const NO_PLACES: &str = "data has no places of shafts over the speeds of --speeds; the answer and the page have them";

/// What is said where a part of the reciprocating masses and two planes are given: the part stays on the throws.
const ON_THE_THROWS: &str = "--reciprocating puts weights on the throws and --planes cancels what they leave; for a part of the reciprocating masses in two \
                             planes, as in the wheels of a locomotive, ask `crankstar rotor`, with `share`";

impl Remedy {
    /// Prints the remedy, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        let mut written = String::new();
        self.answer.give("remedy", self.json, || {
            let (layout, orders) = self.about.read()?;
            let engine = layouts::without_unknowns(layout, "a remedy needs")?;
            // A length with its unit makes the layout metric, as in the file.
            let is_metric = self.has_metric_planes() && engine.positions_given();
            let unit = if is_metric { LengthUnit::Metre } else { engine.length_unit() };
            let draft = Draft { length_unit: unit, ..engine.into_draft() };
            let engine = draft.build().map_err(Failure::new)?;
            let remedy = remedy::remedy(&engine, &self.request(&engine, orders)?).map_err(Failure::new)?;
            if !self.planes.is_empty() && !self.reciprocating.is_empty() {
                write::warn(ON_THE_THROWS);
            }
            if let Some(file) = &self.write {
                written = self.write_corrected(&remedy, file)?;
            }
            if self.radius.is_some() && (self.json || self.answer.is_document()) {
                write::warn(NO_MASSES);
            }
            if !self.speeds.is_empty() && (self.json || self.answer.is_data()) {
                write::warn(NO_PLACES);
            }
            Ok(remedy)
        })?;
        if self.json || self.answer.is_data() { Ok(()) } else { write::to_stdout(&written) }
    }

    /// Writes the layout file of the corrected engine, which names what lies beside the file that was read.
    fn write_corrected(&self, remedy: &remedy::Remedy, file: &Path) -> Result<String, Failure> {
        let layout = &self.about.layout;
        let beside = |path: &str| layouts::beside(layout, path);
        let corrected = remedy::corrected_file(remedy, &layouts::shown(file), layouts::resolver(layout, &beside))
            .map_err(Failure::new)?;
        if file.exists() && layout.canonicalize().ok() == file.canonicalize().ok() {
            return Err(Failure::new("--write names the layout file itself, which stays as it is; name another file"));
        }
        folder::write_file(file, corrected.text.as_bytes(), "corrected.toml")?;
        let rounded = if corrected.is_rounded { ROUNDED } else { "" };
        Ok(format!("Written: {}\n{rounded}", layouts::shown(file)))
    }

    fn has_metric_planes(&self) -> bool {
        self.planes.iter().any(|text| parse_length(text).is_ok_and(|(_, unit)| unit == LengthUnit::Metre))
    }

    /// The balance factor of each throw that is asked for.
    fn factors(&self, engine: &Engine) -> Result<Vec<BigRational>, Failure> {
        if self.reciprocating.is_empty() {
            return self.balance_factor.iter().map(|text| factor("--balance-factor", text)).collect();
        }
        let shares = self.reciprocating.iter().map(|text| factor("--reciprocating", text));
        let shares = shares.collect::<Result<Vec<_>, _>>()?;
        let Some(parts) = engine.throw_parts() else {
            let right = "--reciprocating needs masses and a crank radius; below [mechanism], give them";
            return Err(Failure::new(right));
        };
        if shares.len() > 1 && shares.len() != parts.len() {
            return Ok(shares);
        }
        let two = BigRational::from_integer(2.into());
        let of_throw = |(index, [rotating, reciprocating]): (usize, &[BigRational; 2])| {
            let share = shares.get(index).or(shares.last()).cloned().unwrap_or_default();
            let whole = rotating + reciprocating / &two;
            if whole.is_zero() { BigRational::zero() } else { (rotating + reciprocating * share) / whole }
        };
        Ok(parts.iter().enumerate().map(of_throw).collect())
    }

    fn request(&self, engine: &Engine, orders: Vec<u32>) -> Result<Request, Failure> {
        let plane = |text: &String| {
            warn_of("position", text, Some(engine));
            remedy::plane_of(engine, text).map_err(|right| misread("--planes", text, right))
        };
        let planes = match self.planes.as_slice() {
            [] => None,
            [first, second] => Some([plane(first)?, plane(second)?]),
            more => {
                let message = format!("--planes: {}; give two, such as 0.12,-0.12", counted(more.len(), "position"));
                return Err(Failure::misuse(message));
            }
        };
        let factors = self.factors(engine)?;
        let skew = |text| parse_angle(text).map(Turn::new).map_err(|right| misread("--skew", text, right));
        let skews = self.skew.iter().map(String::as_str).map(skew);
        let radius = |text| parse_radius(text).map_err(|right| misread("--radius", text, right));
        let radius = self.radius.as_deref().map(radius).transpose()?;
        let speeds = self.speeds.iter().map(|text| match parse_number(text) {
            Ok(speed) if speed.is_positive() => Ok(speed),
            _ => Err(misread("--speeds", text, "a speed above 0 in rpm, such as 3000")),
        });
        let (orders, small) = report::worth_curing(engine, orders, &self.above.read(self.about.are_asked()));
        Ok(Request {
            orders,
            small,
            planes,
            factors,
            skews: skews.collect::<Result<_, _>>()?,
            radius,
            speeds: speeds.collect::<Result<_, _>>()?,
        })
    }
}

fn misread(flag: &str, text: &str, right: impl Display) -> Failure {
    Failure::misuse(format!("{flag}: cannot read `{text}`: {right}"))
}

/// Says what is odd about a value of an option.
fn warn_of(key: &str, text: &str, engine: Option<&Engine>) {
    if let Some(odd) = file::odd_value(key, text, engine) {
        write::warn(&format!("warning: {odd}"));
    }
}

fn factor(flag: &str, text: &str) -> Result<BigRational, Failure> {
    let key = flag.trim_start_matches('-').replace('-', "_");
    warn_of(&key, text, None);
    remedy::factor_of(text).map_err(|right| misread(flag, text, right))
}
