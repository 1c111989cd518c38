//! What is asked of crank stars? The best of them, and where that is wanted the firing orders that twist the shaft least.

use super::super::question::{one_of_all, question};
use super::data;
use super::{search_answer, search_layouts, search_page, search_torsion};
use crate::page::{Document, File};
use crate::search::{self, Front, Torsion};
use crate::table::Table;

/// What a search found.
pub struct SearchStudy {
    /// The best stars.
    pub front: Front,
    /// Their firing orders, where these are asked for.
    pub torsion: Option<Torsion>,
}

impl SearchStudy {
    fn with_torsion(&self, mut page: Document) -> Document {
        page.blocks.extend(self.torsion.iter().flat_map(|torsion| search_torsion(&self.front, torsion)));
        page
    }
}

question!(
    SearchStudy,
    "search",
    |_| None,
    one_of_all,
    |study| study.with_torsion(search_answer(&study.front)),
    |study| study.with_torsion(search_page(&study.front)),
    {
        fn tables(&self) -> Vec<Table> {
            data::tables(&self.front, self.torsion.as_ref())
        }

        /// The stars as layout files.
        fn beside(&self) -> serde_json::Result<Vec<File>> {
            Ok(search_layouts(&self.front))
        }

        fn json(&self) -> serde_json::Result<String> {
            let document = search::document(&self.front);
            serde_json::to_string_pretty(&match &self.torsion {
                Some(torsion) => document.with_torsion(torsion),
                None => document,
            })
        }
    }
);
