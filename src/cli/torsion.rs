//! `torsion`: at which speeds does the crankshaft twist?

use std::path::PathBuf;

use crankstar::engine::CycleOrder;
use crankstar::report::TorsionStudy;

use super::answer::Answer;
use super::failure::Failure;
use super::layouts;

/// Arguments of `torsion`.
#[derive(clap::Args)]
pub struct Torsion {
    /// A name of the catalogue, or the path of a layout file with a table [torsion]
    layout: PathBuf,
    /// The orders whose critical speeds are shown, such as 1/2,1,3/2 [default: up to 12, or the firings in a revolution]
    #[arg(long, value_delimiter = ',')]
    orders: Vec<CycleOrder>,
    /// The speed at which the forced vibration is shown, such as 70 [default: that of the layout]
    #[arg(long, value_parser = speed)]
    speed: Option<f64>,
    /// The name of a cylinder that does not fire
    #[arg(long, value_name = "CYLINDER")]
    misfire: Option<String>,
    /// Print modes and critical speeds as JSON
    #[arg(long, conflicts_with_all = ["output", "format"])]
    json: bool,
    #[command(flatten)]
    answer: Answer,
}

impl Torsion {
    /// Prints the critical speeds, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        self.answer.give("torsion", self.json, || {
            let engine = layouts::firing(&self.layout, "a torsional model needs", self.misfire.as_deref())?;
            let study = TorsionStudy::new(&engine, &self.orders).map_err(Failure::new)?;
            Ok(match self.speed {
                Some(speed) => study.at(speed),
                None => study,
            })
        })
    }
}

/// Revolutions a minute above 0.
fn speed(text: &str) -> Result<f64, String> {
    let speed: f64 = text.parse().map_err(|_| "revolutions a minute, such as 70".to_owned())?;
    if speed.is_finite() && speed > 0.0 {
        Ok(speed)
    } else {
        Err("a speed above 0, in revolutions a minute".to_owned())
    }
}
