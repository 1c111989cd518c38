//! `--above`, `--all`, `--rod-ratio`: which orders are reported one by one, and how large are they where no rod is given?

use crankstar::engine::Engine;
use crankstar::report::Weighing;
use num_rational::BigRational;

use super::accuracy::ratio;
use super::failure::Failure;

/// What is reported one by one, and what together.
#[derive(clap::Args)]
pub struct Threshold {
    /// List an order separately if it reaches this percentage of the largest, or of one piston's force; combine smaller ones [default: 1]
    #[arg(long, value_name = "PERCENT", conflicts_with = "all", value_parser = percent)]
    above: Option<f64>,
    /// List every order separately, however small
    #[arg(long)]
    all: bool,
}

/// The same, and how large the orders are where the layout gives no rods.
#[derive(clap::Args)]
pub struct Weigh {
    #[command(flatten)]
    above: Threshold,
    /// Rod ratio λ for the sizes where the layout gives no rods [default: 2/7]
    #[arg(long, value_name = "RATIO", value_parser = ratio)]
    rod_ratio: Option<BigRational>,
}

/// Why they say nothing of data.
pub const DATA_HAS_ALL: &str = "choose what an answer lists order by order, and data has every order; omit them";
/// Why they say nothing of the page of the loads.
pub const PAGE_HAS_ALL: &str =
    "choose what the short answer lists order by order, and the page has every order; omit them, or --format";
/// Why they say nothing of a layout with unknowns.
pub const OF_KNOWN: &str = "need an engine without unknowns; give them values below [values]";

fn percent(text: &str) -> Result<f64, String> {
    match text.trim_end_matches('%').parse::<f64>() {
        Ok(value) if (0.0..=100.0).contains(&value) => Ok(value / 100.0),
        _ => Err("a number of percent from 0 to 100, such as 1".to_owned()),
    }
}

impl Threshold {
    /// Refuses them where they say nothing, for this reason.
    ///
    /// # Errors
    /// One of them.
    pub fn are_omitted(&self, why: &str) -> Result<(), Failure> {
        match self.is_given() {
            true => Err(Failure::misuse(format!("--above and --all {why}"))),
            false => Ok(()),
        }
    }

    fn is_given(&self) -> bool {
        self.above.is_some() || self.all
    }

    /// What is reported of an engine whose orders were asked for, or were not.
    pub fn read(&self, asked: bool) -> Weighing {
        Weighing { above: self.above, all: self.all, asked, rod_ratio: None }
    }
}

impl Weigh {
    /// Refuses them where they say nothing, for this reason.
    ///
    /// # Errors
    /// One of them.
    pub fn are_omitted(&self, why: &str) -> Result<(), Failure> {
        match self.above.is_given() || self.rod_ratio.is_some() {
            true => Err(Failure::misuse(format!("--above, --all and --rod-ratio {why}"))),
            false => Ok(()),
        }
    }

    /// What is reported of an engine whose orders were asked for, or were not.
    ///
    /// # Errors
    /// A ratio for rods that the layout gives.
    pub fn read(&self, engine: &Engine, asked: bool) -> Result<Weighing, Failure> {
        if self.rod_ratio.is_some() && engine.cylinders().iter().all(|cylinder| cylinder.mechanism.is_some()) {
            return Err(Failure::misuse(
                "--rod-ratio is for layouts without rods, and this layout gives its own; omit it",
            ));
        }
        Ok(Weighing { rod_ratio: self.rod_ratio.clone(), ..self.above.read(asked) })
    }
}
