//! How are the best crankshafts shown? Tables, a plot, a page with layout files beside it.

mod amounts;
mod data;
mod layouts;
mod page;
mod plot;
mod study;
mod tables;

pub use layouts::optimise_layouts;
pub use page::{optimise_answer, optimise_page};
pub use study::OptimiseStudy;

use super::question::question;
use crate::page::File;

question!(
    OptimiseStudy,
    "optimise",
    |study| Some(study.engine.title()),
    data::table,
    |study| optimise_answer(&study.engine, &study.front, &study.couple),
    |study| optimise_page(&study.engine, &study.front, &study.couple),
    {
        /// The layout files of the points, and what they name.
        fn beside(&self) -> serde_json::Result<Vec<File>> {
            Ok(optimise_layouts(&self.front).into_iter().chain(self.files.iter().cloned()).collect())
        }
    }
);
