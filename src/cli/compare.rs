//! `compare`: what do engines leave, side by side?

use std::path::{Path, PathBuf};

use crankstar::engine::Engine;
use crankstar::file::Layout;
use crankstar::loads::usual_orders;
use crankstar::report::{CompareStudy, Compared, ValueName, ValuesStudy, rising};
use crankstar::text::Untrusted;

use super::answer::Answer;
use super::failure::Failure;
use super::orders::whole_order;
use super::{layouts, write};

/// Arguments of `compare`.
#[derive(clap::Args)]
pub struct Compare {
    /// Names of the catalogue, or paths of layout files
    #[arg(required = true)]
    layouts: Vec<PathBuf>,
    /// The orders to compare [default: all that the layout files ask for, else 1,2,4,6 and other large ones]
    #[arg(long, value_delimiter = ',', value_parser = whole_order)]
    orders: Vec<u32>,
    /// A value of any question by its name, beside the comparison: torsion.modes.1.frequency
    #[arg(long, value_name = "NAME")]
    value: Vec<ValueName>,
    /// Print the comparison as JSON
    #[arg(long, conflicts_with_all = ["output", "format"])]
    json: bool,
    #[command(flatten)]
    answer: Answer,
}

/// What is said where values are asked for of the document.
const NO_VALUES: &str =
    "the document holds what `verify` checks, without the values of --value; --format json --table engines has them";

impl Compare {
    /// Prints the table, and writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        self.answer.give("compare", self.json, || {
            let engines = self.read()?;
            let orders = rising(match self.orders.as_slice() {
                [] => engines.iter().flat_map(|(_, engine)| usual_orders(engine)).collect(),
                asked => asked.to_vec(),
            });
            let compared = engines.iter().map(|(name, engine)| Compared::new(name.clone(), engine, &orders));
            let compared = compared.collect::<Result<_, _>>().map_err(Failure::new)?;
            let named = engines.iter().map(|(name, engine)| (name.clone(), engine));
            if !self.value.is_empty() && (self.json || self.answer.is_document()) {
                write::warn(NO_VALUES);
            }
            if let Some(wanted) = self.answer.wanted("compare")?.filter(|_| !self.value.is_empty()) {
                wanted.tell_what_is_in("engines", "--value");
            }
            let values = ValuesStudy::beside(named, &self.value);
            Ok(CompareStudy { engines: compared, values })
        })
    }

    /// The engines with short names; with their arguments where two would have the same.
    fn read(&self) -> Result<Vec<(Untrusted, Engine)>, Failure> {
        layouts::read_once(&self.layouts)?;
        if let [only] = self.layouts.as_slice() {
            let only = layouts::shown(only);
            return Err(Failure::misuse(format!(
                "a comparison needs two or more engines; for one ask `crankstar classify {only}`"
            )));
        }
        let short: Vec<String> = self.layouts.iter().map(|argument| short_name(argument)).collect();
        let is_unique = |name: &String| short.iter().filter(|other| *other == name).count() == 1;
        let named = |(argument, name): (&PathBuf, &String)| {
            let name = if is_unique(name) { name.clone() } else { layouts::shown(argument) };
            match layouts::read(argument)? {
                Layout::Known(engine, _) => Ok((Untrusted::new(name), *engine)),
                Layout::Open(family) => Err(Failure::new(format!(
                    "`{}` has unknowns: {}; engines are compared without, so give values below [values]",
                    layouts::shown(argument),
                    family.unknowns().into_iter().collect::<Vec<_>>().join(", ")
                ))),
            }
        };
        self.layouts.iter().zip(&short).map(named).collect()
    }
}

/// A name of the catalogue as it is written there; else the name of the file, or of its folder for `layout.toml`.
fn short_name(path: &Path) -> String {
    if layouts::is_standard_input(path) {
        return layouts::shown(path);
    }
    if let Some(entry) = layouts::named(path) {
        return entry.name.to_owned();
    }
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let folder = path.parent().and_then(Path::file_name).map(|name| name.to_string_lossy().into_owned());
    match folder {
        Some(folder) if stem == "layout" => folder,
        _ if stem.is_empty() => layouts::shown(path),
        _ => stem,
    }
}
