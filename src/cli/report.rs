//! `report`: where are the proofs written?

use std::path::PathBuf;

use crankstar::accuracy::Timing;
use crankstar::engine::Engine;
use crankstar::family;
use crankstar::file::Layout;
use crankstar::proof::Quantity;
use crankstar::report::{self, AccuracyCase, Dialect};

use super::failure::Failure;
use super::loads::Auto;
use super::masses::Masses;
use super::{EngineAndOrders, Format, Math, folder, progress, terminal, write};

/// Arguments of `report`.
#[derive(clap::Args)]
pub struct Report {
    #[command(flatten)]
    about: EngineAndOrders,
    #[command(flatten)]
    masses: Masses,
    /// Language of the report
    #[arg(long, value_enum, default_value = "markdown")]
    format: Format,
    /// How formulas are marked in Markdown
    #[arg(long, value_enum, default_value = "github")]
    math: Math,
    /// Folder for the report and its diagrams; without it the text alone goes to standard output
    #[arg(long, value_name = "DIR")]
    output: Option<PathBuf>,
    #[command(flatten)]
    auto: Auto,
    /// Add what the peak loads are by other methods, and how far off those are
    #[arg(long)]
    accuracy: bool,
}

fn accuracy_of(engine: &Engine) -> Result<AccuracyCase, Failure> {
    let torque = engine.effects().torque.then_some(Quantity::Torque);
    let quantities: Vec<Quantity> = [Quantity::Force, Quantity::Moment].into_iter().chain(torque).collect();
    let spinner = progress::spinner("finding each peak by all methods");
    let case = AccuracyCase::of(engine, &quantities, Timing::Off);
    spinner.finish_and_clear();
    case.map_err(Failure::new)
}

impl Report {
    /// Writes the report into the folder and the summary to the terminal, or the text alone to the terminal.
    pub fn run(&self) -> Result<(), Failure> {
        let (layout, orders) = self.about.read()?;
        let dialect = match (self.format, self.math) {
            (Format::Latex, _) => Dialect::Latex,
            (Format::Markdown, Math::Github) => Dialect::GithubMarkdown,
            (Format::Markdown, Math::Dollars) => Dialect::DollarMarkdown,
        };
        let (files, summary) = match &layout {
            Layout::Known(engine, family) => {
                let needed = self.auto.needed(engine)?;
                let orders = needed.as_ref().map_or(&orders, |needed| &needed.kept);
                let judged = self.masses.judge(engine, orders, &[Quantity::Force, Quantity::Moment])?;
                // Where the rods differ nothing is said of other values than those given.
                let family = family.as_ref().filter(|family| family::comparable(family).is_ok());
                let open = match family {
                    None => None,
                    Some(family) => Some((family.as_ref(), family::classify(family, orders).map_err(Failure::new)?)),
                };
                let family = open.as_ref().map(|(family, orders)| (*family, orders.as_slice()));
                let accuracy = self.accuracy.then(|| accuracy_of(engine)).transpose()?;
                let subject = report::Contents {
                    engine,
                    judged: &judged,
                    family,
                    needed: needed.as_ref(),
                    accuracy: accuracy.as_ref(),
                };
                (report::report(subject, dialect), terminal::summary(engine, &judged))
            }
            Layout::Open(_) if self.masses.are_given() => {
                return Err(Failure::new("--masses needs an engine without unknowns; give them values below [values]"));
            }
            Layout::Open(family) => {
                family::comparable(family).map_err(Failure::new)?;
                let verdicts = family::classify(family, &orders).map_err(Failure::new)?;
                (report::open_report(family, &verdicts, dialect), terminal::open_summary(family, &verdicts))
            }
        };
        let Some(folder) = &self.output else {
            return write::to_stdout(&files[0].text);
        };
        folder::write(folder, &files)?;
        write::to_stdout(&format!("{summary}\n{}", folder::written(folder, &files)))
    }
}
