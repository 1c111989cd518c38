//! `mounts`: how does an engine shake on its mounts?

use std::path::PathBuf;

use crankstar::engine::CycleOrder;
use crankstar::report::{MountsAsked, MountsStudy};

use super::answer::Answer;
use super::failure::Failure;
use super::layouts;

/// Arguments of `mounts`.
#[derive(clap::Args)]
pub struct Mounts {
    /// The path of a layout file with [block] and [[mount]]
    layout: PathBuf,
    /// The orders, such as 1/2,1,2 [default: up to 6]
    #[arg(long, value_delimiter = ',')]
    orders: Vec<CycleOrder>,
    /// Revolutions a minute, in place of the speed of the layout
    #[arg(long, value_name = "RPM", allow_hyphen_values = true)]
    speed: Option<f64>,
    /// Where the range of speeds begins [default: a tenth of its end]
    #[arg(long, value_name = "RPM", allow_hyphen_values = true)]
    from: Option<f64>,
    /// Where the range of speeds ends [default: the speed]
    #[arg(long, value_name = "RPM", allow_hyphen_values = true)]
    to: Option<f64>,
    /// Print modes, motions and mount forces as JSON
    #[arg(long, conflicts_with_all = ["output", "format"])]
    json: bool,
    #[command(flatten)]
    answer: Answer,
}

impl Mounts {
    /// Prints the answer, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        self.answer.give("mounts", self.json, || {
            let engine = layouts::known(&self.layout, "motions on the mounts need")?;
            let asked = MountsAsked { orders: self.orders.clone(), speed: self.speed, from: self.from, to: self.to };
            MountsStudy::new(&engine, &asked).map_err(Failure::new)
        })
    }
}
