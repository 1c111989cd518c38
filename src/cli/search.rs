//! `search`: which crank stars balance best?

use std::ops::ControlFlow;
use std::path::PathBuf;

use clap::ValueEnum;

use crankstar::engine;
use crankstar::exact::Turn;
use crankstar::file::parse_angle;
use crankstar::page::Document;
use crankstar::report::{self, data};
use crankstar::search::{self, Options, Problem, Progress};

use super::answer::Answer;
use super::failure::Failure;
use super::firing::ModeShape;
use super::{json, progress};

/// Arguments of `search`.
#[derive(clap::Args)]
pub struct Search {
    /// Number of cylinders
    #[arg(long)]
    cylinders: u32,
    /// The working cycle
    #[arg(long, value_enum)]
    cycle: Cycle,
    /// The orders whose moments are compared
    #[arg(long, value_delimiter = ',', default_value = "1,2")]
    orders: Vec<u32>,
    /// A V of this many degrees on shared pins, instead of an in-line engine
    #[arg(long, value_name = "DEGREES")]
    bank_angle: Option<String>,
    /// For a V: the number of different directions of its pins [default: one per pin]
    #[arg(long, value_name = "COUNT")]
    directions: Option<u32>,
    /// Throws at any multiples of 1/N turn, as often as they like, with balanced first-order force
    #[arg(long, value_name = "N")]
    grid: Option<u32>,
    /// Compare by neighbours that fire in succession too
    #[arg(long)]
    neighbours: bool,
    /// Judge the firing orders of each star of an engine in line by their minor orders in a mode of torsional vibration: one that falls
    /// evenly along the shaft, or the mode shape
    #[arg(long, conflicts_with = "bank_angle")]
    torsion: bool,
    #[command(flatten)]
    mode: ModeShape,
    /// Keep every finished piece in this file, and go on from it; interrupt at will
    #[arg(long, value_name = "FILE")]
    resume: Option<PathBuf>,
    /// Number of threads [default: one per core]
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Print the front as JSON
    #[arg(long, conflicts_with_all = ["output", "format"])]
    json: bool,
    #[command(flatten)]
    answer: Answer,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Cycle {
    /// Every cylinder fires once a revolution
    TwoStroke,
    /// Every cylinder fires once in two revolutions
    FourStroke,
}

impl From<Cycle> for engine::Cycle {
    fn from(cycle: Cycle) -> Self {
        match cycle {
            Cycle::TwoStroke => engine::Cycle::TwoStroke,
            Cycle::FourStroke => engine::Cycle::FourStroke,
        }
    }
}

impl Search {
    /// Searches, prints the front, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        let wanted = self.answer.wanted("search")?;
        let problem = self.problem()?;
        if self.mode.is_given() && !self.torsion {
            return Err(Failure::new("--mode-shape weighs the firing stars of firing orders; add --torsion"));
        }
        let shape = self.mode.deflections()?;
        if self.torsion {
            search::mode_shape(&problem, shape.clone()).map_err(Failure::new)?;
        }
        let bar = progress::bar("pieces");
        let progress = |progress: Progress| {
            bar.set_length(progress.pieces as u64);
            bar.set_position(progress.done as u64);
            ControlFlow::Continue(())
        };
        let usual = Options::default();
        let threads = self.threads.map_or(usual.threads, usize::from);
        let options = Options { threads, resume: self.resume.clone(), progress: &progress, ..usual };
        let front = search::search(&problem, &options);
        bar.finish_and_clear();
        let front = front.map_err(Failure::new)?;
        let torsion = self.torsion.then(|| search::torsion(&front, shape)).transpose().map_err(Failure::new)?;
        let with_torsion = |mut page: Document| {
            page.blocks.extend(torsion.iter().flat_map(|torsion| report::search_torsion(&front, torsion)));
            page
        };
        if let Some(wanted) = wanted {
            return wanted.give(data::search(&front, torsion.as_ref()));
        }
        if self.json || self.answer.is_json() {
            let document = search::document(&front);
            let document = match &torsion {
                Some(torsion) => document.with_torsion(torsion),
                None => document,
            };
            return self.answer.show_json("search", json(&document)?);
        }
        // Beside a page stand the stars as layout files.
        let beside = || Ok(report::search_layouts(&front));
        let answer = with_torsion(report::search_answer(&front));
        self.answer.show_with(&answer, || with_torsion(report::search_page(&front)), beside)
    }

    fn problem(&self) -> Result<Problem, Failure> {
        let cycle = self.cycle.into();
        let mut orders = self.orders.clone();
        orders.sort_unstable();
        orders.dedup();
        let degrees = |text: &String| {
            let turns = parse_angle(text).map_err(|right| Failure::new(format!("--bank-angle `{text}`: {right}")))?;
            Ok::<_, Failure>(Turn::new(turns))
        };
        let bank_angle = self.bank_angle.as_ref().map(degrees).transpose()?;
        let (directions, grid, neighbours) = (self.directions, self.grid, self.neighbours);
        Ok(Problem { cylinders: self.cylinders, cycle, bank_angle, directions, grid, orders, neighbours })
    }
}
