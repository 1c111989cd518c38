//! `angle`: what do pistons, rods, crankpins and main bearings do at a crank angle?

use std::path::PathBuf;

use crankstar::file::parse_angle;
use crankstar::report::{AngleStudy, AnglesAsked};
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::answer::Answer;
use super::failure::Failure;
use super::layouts;

/// Arguments of `angle`.
#[derive(clap::Args)]
pub struct Angle {
    /// The path of a layout file with a crank radius and rods
    layout: PathBuf,
    /// Crank angles in degrees, such as 30,125
    #[arg(long, value_name = "DEGREES", value_delimiter = ',', allow_hyphen_values = true, value_parser = degrees)]
    at: Vec<f64>,
    /// A table over the cycle, one row every DEGREES [default: 10 where --at is omitted]
    #[arg(long, value_name = "DEGREES", value_parser = degrees)]
    every: Option<f64>,
    /// Add the weight of the pistons along their axes, direction 0 being up; in m/s², such as 9.81
    #[arg(long, value_name = "M_PER_S2")]
    gravity: Option<f64>,
    /// Print the values as JSON
    #[arg(long, conflicts_with_all = ["output", "format"])]
    json: bool,
    #[command(flatten)]
    answer: Answer,
}

/// An angle as a layout file has it, in degrees.
fn degrees(text: &str) -> Result<f64, String> {
    let turns = parse_angle(text)?;
    (turns * BigRational::from_integer(360.into())).to_f64().ok_or_else(|| "an angle in degrees".to_owned())
}

impl Angle {
    /// Prints the answer, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        self.answer.give("angle", self.json, || {
            let engine = layouts::known(&self.layout, "values at an angle need")?;
            let asked = AnglesAsked { at: self.at.clone(), every: self.every, gravity: self.gravity };
            AngleStudy::new(&engine, &asked).map_err(Failure::new)
        })
    }
}
