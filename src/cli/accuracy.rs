//! `accuracy`: what does accuracy cost?

use std::path::PathBuf;

use num_rational::BigRational;
use num_traits::{One, Signed};

use crankstar::accuracy::Timing;
use crankstar::file;
use crankstar::report::AccuracyStudy;

use super::answer::Answer;
use super::failure::Failure;
use super::{layouts, progress};

/// Arguments of `accuracy`.
#[derive(clap::Args)]
pub struct Accuracy {
    /// A name of the catalogue, or the path of a layout file
    layout: PathBuf,
    /// Rod ratios λ, from 0 to below 1, in place of those of the layout
    #[arg(long, value_name = "RATIOS", value_delimiter = ',', value_parser = ratio)]
    rod_ratio: Vec<BigRational>,
    /// Print errors and times as JSON
    #[arg(long, conflicts_with_all = ["output", "format"])]
    json: bool,
    #[command(flatten)]
    answer: Answer,
}

pub(super) fn ratio(text: &str) -> Result<BigRational, String> {
    match file::parse_number(text) {
        Ok(ratio) if !ratio.is_negative() && ratio < BigRational::one() => Ok(ratio),
        _ => Err("a number from 0 to below 1, such as 0.3".to_owned()),
    }
}

impl Accuracy {
    /// Measures all methods and prints what they find, or writes the page.
    pub fn run(&self) -> Result<(), Failure> {
        self.answer.give("accuracy", self.json, || {
            let engine = layouts::known(&self.layout, "peaks need")?;
            let bar = progress::bar("loads by all methods");
            let step = |steps| {
                bar.set_length(steps);
                bar.inc(1);
            };
            let study = AccuracyStudy::new(&engine, &self.rod_ratio, Timing::On, &step);
            bar.finish_and_clear();
            study.map_err(Failure::new)
        })
    }
}
