//! `moments`: which external and guide-force moments have engines, as a maker's project guide lists them?

use std::path::{Path, PathBuf};

use crankstar::engine::Engine;
use crankstar::file::{self, FileResolver, Layout};
use crankstar::report::MomentsStudy;
use crankstar::text::Untrusted;

use super::answer::Answer;
use super::failure::Failure;
use super::layouts;

/// More engines than this make no table.
const MOST_ENGINES: usize = 200;

/// Arguments of `moments`.
#[derive(clap::Args)]
pub struct Moments {
    /// Paths of layout files, or names of the catalogue
    #[arg(required = true)]
    layouts: Vec<PathBuf>,
    /// A firing order in place of that of the layout, such as 1-4-3-2-5; may be given several times, also with other numbers of cylinders
    #[arg(long, value_name = "ORDER", value_delimiter = ',', value_parser = firing_order)]
    firing_order: Vec<String>,
    /// Print the moments as JSON
    #[arg(long, conflicts_with_all = ["output", "format"])]
    json: bool,
    #[command(flatten)]
    answer: Answer,
}

/// What a TOML string can hold as it stands.
fn firing_order(text: &str) -> Result<String, String> {
    match text.chars().all(|sign| sign.is_alphanumeric() || sign == '-' || sign == ' ') && !text.trim().is_empty() {
        true => Ok(text.trim().to_owned()),
        false => Err("the names of the cylinders with - between, such as 1-4-3-2-5".to_owned()),
    }
}

impl Moments {
    /// Prints the tables, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        self.answer.give("moments", self.json, || {
            let count = self.layouts.len() * self.firing_orders().len().max(1);
            if count > MOST_ENGINES {
                return Err(Failure::new(format!(
                    "{count} engines are too many for a table; up to {MOST_ENGINES} fit"
                )));
            }
            MomentsStudy::new(&self.engines()?).map_err(Failure::new)
        })
    }

    /// The firing orders; names of cylinders alone, with commas between, are one.
    fn firing_orders(&self) -> Vec<String> {
        let is_one = self.firing_order.iter().all(|order| !order.contains(['-', ' ']));
        match is_one && self.firing_order.len() > 1 {
            true => vec![self.firing_order.join("-")],
            false => self.firing_order.clone(),
        }
    }

    fn engines(&self) -> Result<Vec<(Untrusted, Engine)>, Failure> {
        let (mut engines, orders) = (Vec::new(), self.firing_orders());
        for layout in &self.layouts {
            if orders.is_empty() {
                let engine = known(layout, layouts::read(layout)?)?;
                engines.push((engine.title().clone(), engine));
            }
            for order in &orders {
                let engine = known(layout, fired(layout, order)?)?;
                let several =
                    if self.layouts.len() > 1 { format!("{}, ", engine.title().written()) } else { String::new() };
                engines.push((Untrusted::new(format!("{several}{order}")), engine));
            }
        }
        Ok(engines)
    }
}

/// The layout with another firing order.
fn fired(layout: &Path, order: &str) -> Result<Layout, Failure> {
    let (name, text) = layouts::source(layout)?;
    let text = file::with_value(&name, &text, "firing_order", &format!("\"{order}\""), &["firing_angles"])?;
    let beside = |path: &str| layouts::beside(layout, path);
    Ok(file::parse_layout_beside(&format!("{name} with the firing order {order}"), &text, FileResolver::new(&beside))?)
}

fn known(path: &Path, layout: Layout) -> Result<Engine, Failure> {
    match layout {
        Layout::Known(engine, _) => Ok(*engine),
        Layout::Open(_) => Err(Failure::new(format!(
            "`{}` has unknowns; moments are those of engines without, so give values below [values]",
            layouts::shown(path)
        ))),
    }
}
