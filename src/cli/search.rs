//! `search`: which crank stars balance best?

use std::ops::ControlFlow;
use std::path::PathBuf;

use crankstar::engine::{Cycle, CycleOrder};
use crankstar::exact::Turn;
use crankstar::file::{parse_angle, parse_number};
use crankstar::report::{SearchStudy, rising, search_theorems};
use crankstar::search::{self, Front, Limit, Options, Pieces, Problem, Progress, SearchError, Sizes, Way};
use crankstar::shard::Shard;

use super::answer::Answer;
use super::cycle::cycles;
use super::failure::Failure;
use super::firing::ModeShape;
use super::layouts::{self, shown};
use super::orders::whole_order;
use super::{pieces, progress, write};

/// Arguments of `search`.
#[derive(clap::Args)]
pub struct Search {
    /// Number of cylinders
    #[arg(long)]
    cylinders: u32,
    /// The working cycle
    #[arg(long, value_parser = cycles())]
    cycle: Cycle,
    /// The orders whose moments are compared
    #[arg(long, value_delimiter = ',', default_value = "1,2", value_parser = whole_order)]
    orders: Vec<u32>,
    /// A V of this many degrees, instead of an in-line engine: on shared pins, unless --pin-split parts them
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true)]
    bank_angle: Option<String>,
    /// For a V: the pin of bank 2 is this many degrees ahead of that of bank 1
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true, requires = "bank_angle")]
    pin_split: Option<String>,
    /// For a V: bank 1 is this many spacings towards the free end of bank 2
    #[arg(long, value_name = "SPACINGS", allow_hyphen_values = true, requires = "bank_angle")]
    bank_offset: Option<String>,
    /// For a V: the number of different directions of its pins [default: one per pin]
    #[arg(long, value_name = "COUNT")]
    directions: Option<u32>,
    /// Throws at any multiples of 1/N turn, as often as they like, with balanced first-order force
    #[arg(long, value_name = "N")]
    grid: Option<u32>,
    /// Compare by neighbours of a bank that fire in succession too
    #[arg(long)]
    neighbours: bool,
    /// Compare firing orders too, by these minor orders in a mode of torsional vibration: one that falls evenly along the shaft, or the
    /// mode shape
    #[arg(long, value_delimiter = ',')]
    minor_orders: Vec<CycleOrder>,
    /// Keep the stars whose moment of this order is no larger, in m r ω² c a or in newton-metres: 2=1.5, "2=30 kN m"
    #[arg(long, value_name = "ORDER=MOMENT", value_delimiter = ',')]
    limit: Vec<String>,
    /// Show moments in newton-metres too, with the masses, the rod, the spacing and the speed of this in-line layout
    #[arg(long, value_name = "LAYOUT")]
    sizes: Option<PathBuf>,
    /// List the firing orders of each star, by their minor orders in that mode
    #[arg(long)]
    torsion: bool,
    #[command(flatten)]
    mode: ModeShape,
    /// Keep every finished piece in this file, and go on from it; interrupt at will
    #[arg(long, value_name = "FILE")]
    resume: Option<PathBuf>,
    /// Search the i-th of N equal parts of the stars, and keep its pieces in the file of --output; called again, go on
    #[arg(long, value_name = "i/N", conflicts_with_all = ["merge", "resume", "json", "torsion"])]
    shard: Option<String>,
    /// Search nothing: merge the files of all shards, into the answer that one search would give, or into one file NAME.shard
    #[arg(long, value_name = "FILES", num_args = 1.., conflicts_with = "resume")]
    merge: Vec<PathBuf>,
    /// Number of threads [default: one per core]
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Print the front as JSON
    #[arg(long, conflicts_with_all = ["output", "format"])]
    json: bool,
    #[command(flatten)]
    answer: Answer,
}

/// What is said where sizes are asked for of the document.
const NO_SIZES: &str = "the document has moments in m r ω² c a alone; --format json --table stars has those in newton-metres, as --sizes asks";

impl Search {
    /// Searches, prints the front, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        if let Some(wanted) = self.answer.wanted("search")?.filter(|_| self.torsion) {
            wanted.tell_what_is_in("firing_orders", "--torsion");
        }
        pieces::are_kept_apart(self.resume.as_deref(), self.answer.output())?;
        let problem = self.problem()?;
        if self.mode.is_given() && !self.torsion && self.minor_orders.is_empty() {
            return Err(Failure::misuse(
                "--mode-shape weighs the firing stars of firing orders; add --torsion or --minor-orders",
            ));
        }
        let shape = problem.mode_shape.clone();
        if self.torsion {
            search::mode_shape(&problem, shape.clone()).map_err(Failure::new)?;
        }
        if let Some(shard) = self.shard.as_deref() {
            return self.keep(&problem, Shard::parse(shard).map_err(Failure::misuse)?);
        }
        if let Some(one) = pieces::merged_into_one(&self.merge, self.answer.output()) {
            let question = Pieces::new(&problem, Way::default()).map_err(Failure::new)?.question();
            return pieces::merge(&self.merge, &question, one);
        }
        self.answer.give("search", self.json, || {
            let limits = self
                .limit
                .iter()
                .map(|text| Limit::parse(text).map_err(|right| Failure::misuse(format!("--limit `{text}`: {right}"))));
            let limits = limits.collect::<Result<Vec<_>, _>>()?;
            let sizes = |layout: &PathBuf| Sizes::new(&layouts::known(layout, "--sizes needs")?).map_err(Failure::new);
            let sizes = self.sizes.as_ref().map(sizes).transpose()?;
            if sizes.is_some() && (self.json || self.answer.is_document()) {
                write::warn(NO_SIZES);
            }
            let front = self.front(&problem)?.limited(limits, sizes).map_err(Failure::new)?;
            let torsion = self.torsion.then(|| search::torsion(&front, shape)).transpose().map_err(Failure::new)?;
            Ok(SearchStudy { front, torsion })
        })
    }

    /// From the files that are merged, or by searching.
    fn front(&self, problem: &Problem) -> Result<Front, Failure> {
        if !self.merge.is_empty() {
            let pieces = Pieces::new(problem, Way::default()).map_err(Failure::new)?;
            return pieces.merged(&self.merge).map_err(Failure::new);
        }
        // Said before a search that may take long; the answer has it too.
        if search::described(problem).is_none() && progress::is_shown() {
            progress::end();
            let known = search_theorems(problem);
            write::to_stderr(self.answer.shown(&known)?.trim());
        }
        self.with_a_bar(|options| search::answer(problem, options))
    }

    /// Judges the pieces of a shard that its file lacks.
    fn keep(&self, problem: &Problem, shard: Shard) -> Result<(), Failure> {
        let output = self.answer.nothing_but_output("--shard")?;
        let pieces = Pieces::new(problem, Way::default()).map_err(Failure::new)?;
        self.with_a_bar(|options| pieces.keep(shard, output, options))?;
        write::to_stdout(&format!("Written: {}\n", shown(output)))
    }

    /// Does the work of pieces beside a bar.
    fn with_a_bar<T>(&self, work: impl FnOnce(&Options) -> Result<T, SearchError>) -> Result<T, Failure> {
        let bar = progress::bar("pieces");
        let progress = |progress: Progress| {
            bar.set_length(progress.pieces as u64);
            bar.set_position(progress.done as u64);
            ControlFlow::Continue(())
        };
        let usual = Options::default();
        let threads = self.threads.map_or(usual.threads, usize::from);
        let done = work(&Options { threads, resume: self.resume.clone(), progress: &progress, ..usual });
        bar.finish_and_clear();
        done.map_err(Failure::new)
    }

    fn problem(&self) -> Result<Problem, Failure> {
        let orders = rising(self.orders.clone());
        let degrees = |option: &str, text: &String| {
            parse_angle(text).map_err(|right| Failure::misuse(format!("{option} `{text}`: {right}")))
        };
        let banks = |text: &String| {
            let turns = degrees("--bank-angle", text)?;
            search::bank_angle(&turns).map_err(|right| Failure::misuse(format!("--bank-angle `{text}`: {right}")))
        };
        let bank_angle = self.bank_angle.as_ref().map(banks).transpose()?;
        let split = |text: &String| degrees("--pin-split", text).map(Turn::new);
        let pin_split = self.pin_split.as_ref().map(split).transpose()?;
        let spacings = |text: &String| {
            parse_number(text).map_err(|error| Failure::misuse(format!("--bank-offset `{text}`: {error}")))
        };
        let bank_offset = self.bank_offset.as_ref().map(spacings).transpose()?;
        let minor_orders = rising(self.minor_orders.clone());
        let mode_shape = self.mode.deflections()?;
        let asked = Problem::inline(self.cylinders, self.cycle, &orders);
        let asked = Problem { bank_angle, pin_split, bank_offset, directions: self.directions, ..asked };
        Ok(Problem { grid: self.grid, neighbours: self.neighbours, minor_orders, mode_shape, ..asked })
    }
}
