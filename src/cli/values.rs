//! `values`: which values have these engines, shafts and diagrams, each by its name?

use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::thread;

use crankstar::file::Layout;
use crankstar::report::{ValueName, Valued, ValuesStudy, values_of};
use crankstar::table::Single;
use crankstar::text::Untrusted;

use super::answer::Answer;
use super::failure::Failure;
use super::layouts;

/// Arguments of `values`.
#[derive(clap::Args)]
pub struct Values {
    /// Names of the catalogue, or paths of layout files; of shafts and diagrams for values of rotor and flywheel
    #[arg(required = true)]
    layouts: Vec<PathBuf>,
    /// A value by its name: question, table, the keys of a row, column; docs/data.md lists them: torsion.modes.1.frequency
    #[arg(long, value_name = "NAME", required = true)]
    value: Vec<ValueName>,
    #[command(flatten)]
    answer: Answer,
}

impl Values {
    /// Prints the values, or writes them as data.
    pub fn run(&self) -> Result<(), Failure> {
        self.answer.give("values", false, || {
            let rows = self.layouts.iter().map(|layout| layouts::shown(layout)).map(Untrusted::new);
            Ok(ValuesStudy { names: self.value.clone(), rows: rows.zip(self.computed()?).collect() })
        })
    }

    /// The values of each layout, on all cores.
    fn computed(&self) -> Result<Vec<Vec<Result<Single, String>>>, Failure> {
        let threads = thread::available_parallelism().map_or(1, NonZero::get);
        let size = self.layouts.len().div_ceil(threads).max(1);
        let part = |layouts: &[PathBuf]| layouts.iter().map(|layout| self.of(layout)).collect::<Vec<_>>();
        let all: Vec<Result<_, Failure>> = thread::scope(|scope| {
            let part = &part;
            let parts: Vec<_> = self.layouts.chunks(size).map(|some| scope.spawn(move || part(some))).collect();
            let joined =
                parts.into_iter().map(|one| one.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
            joined.flatten().collect()
        });
        all.into_iter().collect()
    }

    fn of(&self, layout: &Path) -> Result<Vec<Result<Single, String>>, Failure> {
        let (name, text) = layouts::source(layout)?;
        if let Some(valued) = Valued::of_file(&name, &text).map_err(Failure::new)? {
            return Ok(valued.values(&self.value));
        }
        match layouts::read(layout)? {
            Layout::Known(engine, _) => Ok(values_of(&engine, &self.value)),
            Layout::Open(_) => {
                let why = "the layout has unknowns; give them values below [values]";
                Ok(self.value.iter().map(|_| Err(why.to_owned())).collect())
            }
        }
    }
}
