//! `firing`: which orders of the gas torque vanish, whatever the pressure is?

use std::path::PathBuf;

use crankstar::engine::{Cycle, CycleOrder, Engine, Family};
use crankstar::file::{self, Layout, parse_number};
use crankstar::firing::Weights;
use crankstar::report::{self, FiringStudy, OpenFiringStudy};
use num_rational::BigRational;

use super::answer::Answer;
use super::cycle::cycles;
use super::failure::Failure;
use super::layouts;

/// Arguments of `firing`.
#[derive(clap::Args)]
pub struct Firing {
    /// A name of the catalogue, or the path of a layout file; all of the catalogue where none is named
    layout: Option<PathBuf>,
    /// The cycle that the catalogue is run in
    #[arg(long, value_parser = cycles(), default_value = "four-stroke", conflicts_with = "layout")]
    cycle: Cycle,
    /// The orders to decide, such as 1/2,1,3/2 [default: up to the first that is major in even firing, at least 4]
    #[arg(long, value_delimiter = ',', requires = "layout")]
    orders: Vec<CycleOrder>,
    #[command(flatten)]
    mode: ModeShape,
    #[command(flatten)]
    answer: Answer,
}

/// A mode of torsional vibration that the stars are weighed by.
#[derive(clap::Args)]
pub struct ModeShape {
    /// Weigh the firing stars by the deflections of the throws in a mode of torsional vibration, one per cylinder: 6,5,4,3,2,1
    #[arg(long, value_delimiter = ',', value_name = "DELTA", allow_hyphen_values = true)]
    mode_shape: Vec<String>,
}

impl Firing {
    /// Prints the verdicts, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        let Some(layout) = &self.layout else {
            self.has_no_tables("the catalogue")?;
            if self.mode.is_given() {
                return Err(Failure::misuse(
                    "--mode-shape has a deflection for each throw of one engine: name its layout",
                ));
            }
            let engines = file::catalogue()?;
            let answer = report::firing_catalogue_answer(&engines, self.cycle);
            return self.answer.show(&answer, || report::firing_catalogue_page(&engines, self.cycle));
        };
        match layouts::read(layout)? {
            Layout::Known(engine, _) => self.answer.give("firing", false, || study(&engine, &self.orders, &self.mode)),
            Layout::Open(family) => {
                self.has_no_tables("a layout with unknowns")?;
                let study = open_study(&family, &self.orders, &self.mode)?;
                self.answer.show(&report::open_firing_answer(&study), || report::open_firing_page(&study))
            }
        }
    }

    /// Data are of one engine.
    fn has_no_tables(&self, of: &str) -> Result<(), Failure> {
        match self.answer.wanted("firing")?.is_none() && !self.answer.is_json() {
            true => Ok(()),
            false => {
                Err(Failure::misuse(format!("{of} has no tables of firing stars; name an engine without unknowns")))
            }
        }
    }
}

/// Judges the stars that are asked for.
pub fn study(engine: &Engine, orders: &[CycleOrder], mode: &ModeShape) -> Result<FiringStudy, Failure> {
    FiringStudy::new(engine, orders, mode.read()?).map_err(Failure::new)
}

/// Judges the stars that are asked for of a layout with unknowns.
pub fn open_study<'a>(
    family: &'a Family,
    orders: &[CycleOrder],
    mode: &ModeShape,
) -> Result<OpenFiringStudy<'a>, Failure> {
    OpenFiringStudy::new(family, orders, mode.read()?).map_err(Failure::new)
}

impl ModeShape {
    /// Whether one is given.
    pub fn is_given(&self) -> bool {
        !self.mode_shape.is_empty()
    }

    /// The deflections, where they are given.
    pub fn deflections(&self) -> Result<Option<Vec<BigRational>>, Failure> {
        let value = |text: &String| {
            parse_number(text.trim()).map_err(|error| Failure::misuse(format!("--mode-shape: {error}")))
        };
        match self.mode_shape.as_slice() {
            [] => Ok(None),
            values => values.iter().map(value).collect::<Result<_, _>>().map(Some),
        }
    }

    fn read(&self) -> Result<Weights, Failure> {
        Ok(self.deflections()?.map_or(Weights::Rigid, Weights::ModeShape))
    }
}
