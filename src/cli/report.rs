//! `report`: where are the proofs written?

use crankstar::accuracy::Timing;
use crankstar::engine::Engine;
use crankstar::file::Layout;
use crankstar::proof::Quantity;
use crankstar::report::{self, AccuracyCase};
use crankstar::{family, verdict};

use super::failure::Failure;
use super::loads::Auto;
use super::masses::{Masses, masses_of_a_family};
use super::orders::{EngineAndOrders, classified};
use super::pages::Pages;
use super::progress;
use super::weigh::{OF_KNOWN, Weigh};

/// Arguments of `report`.
#[derive(clap::Args)]
pub struct Report {
    #[command(flatten)]
    about: EngineAndOrders,
    #[command(flatten)]
    masses: Masses,
    #[command(flatten)]
    pages: Pages,
    #[command(flatten)]
    weigh: Weigh,
    #[command(flatten)]
    auto: Auto,
    /// Add what the peak loads are by other methods, and how far off those are
    #[arg(long)]
    accuracy: bool,
}

fn accuracy_of(engine: &Engine) -> Result<AccuracyCase, Failure> {
    let torque = engine.effects().torque.then_some(Quantity::TORQUE);
    let quantities: Vec<Quantity> = [Quantity::FORCE, Quantity::MOMENT].into_iter().chain(torque).collect();
    progress::doing("finding each peak by all methods");
    AccuracyCase::of(engine, &quantities, Timing::Off).map_err(Failure::new)
}

impl Report {
    /// Writes the report into the folder and the summary to the terminal, or the text alone to the terminal.
    pub fn run(&self) -> Result<(), Failure> {
        let (layout, orders) = self.about.read()?;
        match &layout {
            Layout::Known(engine, family) => {
                let needed = self.auto.needed(engine)?;
                let orders = needed.as_ref().map_or(&orders, |needed| &needed.kept);
                let judged = self.masses.judge(engine, orders, &verdict::quantities(engine, false))?;
                let open = classified(family.as_deref(), orders)?;
                let family = open.as_ref().map(|(family, orders)| (*family, orders.as_slice()));
                let accuracy = self.accuracy.then(|| accuracy_of(engine)).transpose()?;
                let weighing = self.weigh.read(engine, self.about.are_asked())?;
                let subject = report::Contents {
                    engine,
                    judged: &judged,
                    family,
                    needed: needed.as_ref(),
                    in_motion: self.pages.runs_scripts(),
                    accuracy: accuracy.as_ref(),
                    weighing: &weighing,
                };
                let answer = || report::engine_answer_weighed(engine, &judged, &weighing);
                self.pages.show_page(answer, &report::engine_page(subject))
            }
            Layout::Open(_) if self.masses.are_given() => Err(masses_of_a_family()),
            Layout::Open(family) => {
                self.weigh.are_omitted(OF_KNOWN)?;
                family::comparable(family).map_err(Failure::new)?;
                let verdicts = family::classify(family, &orders).map_err(Failure::new)?;
                let page = report::family_page(family, &verdicts, self.pages.runs_scripts());
                self.pages.show_page(|| report::family_answer(family, &verdicts), &page)
            }
        }
    }
}
