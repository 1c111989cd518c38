//! `loads`: how large are the forces, moments and torques?

use std::ffi::{OsStr, OsString};

use crankstar::engine::Engine;
use crankstar::loads::{self, Needed};
use crankstar::report::LoadsStudy;

use super::answer::Answer;
use super::failure::Failure;
use super::layouts::without_unknowns;
use super::orders::EngineAndOrders;
use super::weigh::{DATA_HAS_ALL, PAGE_HAS_ALL, Threshold};

/// The percentage of a bare `--auto`.
const USUAL_PERCENT: &str = "0.1";

/// Arguments of `loads`.
#[derive(clap::Args)]
pub struct Loads {
    #[command(flatten)]
    about: EngineAndOrders,
    /// Print the loads as JSON
    #[arg(long, conflicts_with_all = ["output", "format"])]
    json: bool,
    #[command(flatten)]
    auto: Auto,
    #[command(flatten)]
    above: Threshold,
    #[command(flatten)]
    answer: Answer,
}

/// The choice of the orders by a wanted accuracy.
#[derive(clap::Args)]
pub struct Auto {
    /// Keep just the orders that this accuracy of the peaks needs, in percent, by a rigorous bound [default value: 0.1]
    #[arg(long, value_name = "PERCENT", num_args = 0..=1, default_missing_value = USUAL_PERCENT, conflicts_with = "orders", value_parser = percent)]
    auto: Option<f64>,
}

/// Whether what follows `--auto` is its percentage; else it is the layout, and `--auto` stands for itself.
fn is_percentage(argument: &OsStr) -> bool {
    argument.to_str().is_some_and(|text| text.trim_end_matches('%').parse::<f64>().is_ok())
}

/// The arguments, with `--auto` spelled out where its percentage is omitted.
pub fn spelled_out(arguments: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let mut spelled: Vec<OsString> = Vec::new();
    let mut arguments = arguments.peekable();
    while let Some(argument) = arguments.next() {
        let alone = argument == "--auto" && !arguments.peek().is_some_and(|next| is_percentage(next));
        spelled.push(if alone { format!("--auto={USUAL_PERCENT}").into() } else { argument });
    }
    spelled
}

fn percent(text: &str) -> Result<f64, String> {
    match text.trim_end_matches('%').parse::<f64>() {
        Ok(value) if (1e-9..=50.0).contains(&value) => Ok(value),
        _ => Err("a number of percent from 0.000000001 to 50, such as 0.1".to_owned()),
    }
}

impl Auto {
    /// The orders that the accuracy needs; none where it was not asked for.
    pub fn needed(&self, engine: &Engine) -> Result<Option<Needed>, Failure> {
        let needed = self.auto.map(|percent| loads::needed_orders(engine, percent / 100.0));
        needed.transpose().map_err(Failure::new)
    }
}

impl Loads {
    /// Prints the loads, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        if self.json || self.answer.is_data() {
            self.above.are_omitted(DATA_HAS_ALL)?;
        }
        if self.answer.is_page_alone() {
            self.above.are_omitted(PAGE_HAS_ALL)?;
        }
        self.answer.give("loads", self.json, || {
            let (layout, orders) = self.about.read()?;
            let engine = without_unknowns(layout, "loads need")?;
            let needed = self.auto.needed(&engine)?;
            let is_asked = self.about.are_asked() || needed.is_some();
            let study = LoadsStudy::new(&engine, &orders, needed).map_err(Failure::new)?;
            Ok(LoadsStudy { weighing: Some(self.above.read(is_asked)), ..study })
        })
    }
}
