//! `classify`: does force or moment vanish, order by order?

use crankstar::report;
use crankstar::verdict;

use super::failure::Failure;
use super::{Subject, terminal, write};

/// Arguments of `classify`.
#[derive(clap::Args)]
pub struct Classify {
    #[command(flatten)]
    subject: Subject,
    /// Print the verdicts with their certificates as JSON
    #[arg(long)]
    json: bool,
    /// Prove what vanishes at every order: adds the statements with one period of verdicts to the JSON
    #[arg(long, requires = "json")]
    all_orders: bool,
    /// Judge the inertia torque too
    #[arg(long)]
    torque: bool,
}

impl Classify {
    /// Prints the verdicts.
    pub fn run(&self) -> Result<(), Failure> {
        let (layout, orders) = self.subject.read()?;
        let balances = verdict::classify(&layout, &orders, self.torque);
        if !self.json {
            return write::to_stdout(&terminal::summary(&layout, &balances));
        }
        let mut document = report::document(&layout, &balances);
        if self.all_orders {
            let theorem = verdict::theorem(&layout).map_err(Failure::new)?;
            document.theorems = report::theorem_claims(&theorem);
        }
        let json = serde_json::to_string_pretty(&document).map_err(Failure::new)?;
        write::to_stdout(&format!("{json}\n"))
    }
}
