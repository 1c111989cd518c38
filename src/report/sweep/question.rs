//! What is a sweep as an answer? Tables of points and zeros, and a page with the data of its curves beside it.

use super::super::question::{one_of_all, question};
use super::data;
use super::{sweep_answer, sweep_csv, sweep_page};
use crate::page::File;
use crate::sweep::Sweep;
use crate::table::Table;
use crate::text;

question!(Sweep, "sweep", |sweep| Some(&sweep.title), one_of_all, sweep_answer, sweep_page, {
    fn tables(&self) -> Vec<Table> {
        data::tables(self)
    }

    /// The points, and all tables as JSON.
    fn beside(&self) -> serde_json::Result<Vec<File>> {
        Ok(vec![sweep_csv(self), File { name: "sweep.json".into(), text: text::json(&self.json()?) + "\n" }])
    }
});
