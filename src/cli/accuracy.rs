//! `accuracy`: what does accuracy cost?

use std::path::PathBuf;

use num_rational::BigRational;
use num_traits::{One, Signed};

use crankstar::accuracy::{self, Timing};
use crankstar::file::{self, Layout};
use crankstar::proof::Quantity;
use crankstar::report::{self, AccuracyCase};

use super::failure::Failure;
use super::pages::Pages;
use super::{layouts, print_json, progress};

/// Arguments of `accuracy`.
#[derive(clap::Args)]
pub struct Accuracy {
    /// A name of the catalogue, or the path of a layout file
    layout: PathBuf,
    /// Rod ratios λ, from 0 to below 1, in place of those of the layout
    #[arg(long, value_name = "RATIOS", value_delimiter = ',', value_parser = ratio)]
    rod_ratio: Vec<BigRational>,
    #[command(flatten)]
    pages: Pages,
    /// Print errors and times as JSON
    #[arg(long)]
    json: bool,
}

fn ratio(text: &str) -> Result<BigRational, String> {
    match file::parse_number(text) {
        Ok(ratio) if !ratio.is_negative() && ratio < BigRational::one() => Ok(ratio),
        _ => Err("a number from 0 to below 1, such as 0.3".to_owned()),
    }
}

impl Accuracy {
    /// Measures all methods and prints what they find, or writes the page.
    pub fn run(&self) -> Result<(), Failure> {
        let Layout::Known(engine, _) = layouts::read(&self.layout)? else {
            return Err(Failure::new("peaks need an engine without unknowns; give them values below [values]"));
        };
        if engine.mechanisms().is_empty() && self.rod_ratio.is_empty() {
            return Err(Failure::new("the layout says nothing of its rods; name some with --rod-ratio 0.3"));
        }
        let engines = match self.rod_ratio.as_slice() {
            [] => vec![engine.as_ref().clone()],
            ratios => {
                let engines = ratios.iter().map(|ratio| accuracy::with_rod_ratio(&engine, ratio));
                engines.collect::<Result<_, _>>().map_err(Failure::new)?
            }
        };
        let quantities = [Quantity::FORCE, Quantity::MOMENT, Quantity::TORQUE];
        let bar = progress::bar("loads by all methods");
        bar.set_length((engines.len() * AccuracyCase::steps(&quantities)) as u64);
        let cases =
            engines.iter().map(|engine| AccuracyCase::step_by_step(engine, &quantities, Timing::On, &|| bar.inc(1)));
        let cases = cases.collect::<Result<Vec<_>, _>>();
        bar.finish_and_clear();
        let cases = cases.map_err(Failure::new)?;
        if self.json {
            self.pages.write(|| report::accuracy_page(&engine, &cases), Vec::new)?;
            return print_json(&report::accuracy_document(&engine, &cases));
        }
        self.pages.show(&report::accuracy_answer(&engine, &cases), || report::accuracy_page(&engine, &cases))
    }
}
