//! What is a comparison as an answer? The engines, judged at the same orders.

use super::super::question::{json_with_evidence, one_of_all, question};
use super::super::values::ValuesStudy;
use super::data;
use super::{CompareDocument, Compared, compare_answer, compare_document, compare_page};
use crate::page::Document;
use crate::table::Table;

/// Engines side by side.
pub struct CompareStudy {
    /// The engines.
    pub engines: Vec<Compared>,
    /// Values of other questions, a row each engine, where they are asked for.
    pub values: Option<ValuesStudy>,
}

impl CompareStudy {
    fn document(&self) -> CompareDocument {
        compare_document(&self.engines)
    }

    /// With the values below what stands first.
    fn with_values(&self, mut document: Document) -> Document {
        let values = self.values.iter().flat_map(ValuesStudy::blocks);
        document.blocks.splice(1..1, values);
        document
    }
}

question!(
    CompareStudy,
    "compare",
    |_| None,
    one_of_all,
    |study| study.with_values(compare_answer(&study.engines)),
    |study| study.with_values(compare_page(&study.engines)),
    {
        fn tables(&self) -> Vec<Table> {
            let mut tables = data::tables(&self.engines);
            let engines = tables.iter_mut().filter(|table| table.name() == "engines");
            engines.zip(&self.values).for_each(|(table, values)| values.columns_into(table));
            tables
        }

        json_with_evidence!();
    }
);
