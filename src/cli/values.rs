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
use super::{layouts, write};

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
    /// Prints the values, or writes them as data; a file that cannot be read has a row too, and ends the program with its message.
    pub fn run(&self) -> Result<(), Failure> {
        let computed = self.computed();
        let mut unread: Vec<&Failure> = computed.iter().filter_map(|one| one.as_ref().err()).collect();
        self.answer.give("values", false, || {
            let rows = self.layouts.iter().map(|layout| layouts::shown(layout)).map(Untrusted::new);
            let values = computed.iter().map(|one| match one {
                Ok(values) => values.clone(),
                Err(failure) => self.none(&format!("the file cannot be read: {}", failure.in_one_line())),
            });
            Ok(ValuesStudy { names: self.value.clone(), rows: rows.zip(values).collect() })
        })?;
        match unread.pop() {
            None => Ok(()),
            Some(last) => {
                unread.iter().for_each(|failure| write::to_stderr(&failure.to_string()));
                Err(last.clone())
            }
        }
    }

    /// The values of each layout, on all cores.
    fn computed(&self) -> Vec<Result<Vec<Result<Single, String>>, Failure>> {
        let threads = thread::available_parallelism().map_or(1, NonZero::get);
        let size = self.layouts.len().div_ceil(threads).max(1);
        let part = |layouts: &[PathBuf]| layouts.iter().map(|layout| self.of(layout)).collect::<Vec<_>>();
        thread::scope(|scope| {
            let part = &part;
            let parts: Vec<_> = self.layouts.chunks(size).map(|some| scope.spawn(move || part(some))).collect();
            let joined =
                parts.into_iter().map(|one| one.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
            joined.flatten().collect()
        })
    }

    /// No value, for this reason.
    fn none(&self, why: &str) -> Vec<Result<Single, String>> {
        self.value.iter().map(|_| Err(why.to_owned())).collect()
    }

    fn of(&self, layout: &Path) -> Result<Vec<Result<Single, String>>, Failure> {
        let (name, text) = layouts::source(layout)?;
        if let Some(valued) = Valued::of_file(&name, &text).map_err(Failure::new)? {
            return Ok(valued.values(&self.value));
        }
        match layouts::parsed(layout, &name, &text)? {
            Layout::Known(engine, _) => Ok(values_of(&engine, &self.value)),
            Layout::Open(_) => Ok(self.none("the layout has unknowns; give them values below [values]")),
        }
    }
}
