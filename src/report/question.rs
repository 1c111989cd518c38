//! What has every question that is asked of an engine? Tables of typed columns, and two documents: a short answer and a page.
//!
//! The command line, Python, sweeps and comparisons ask it in one way each. A question is a study that owns its engine, and each part of
//! its answer is made when it is wanted.

use std::error::Error;

use serde::Serialize;

use crate::page::{Document, File};
use crate::table::{Named, Table};
use crate::text::Untrusted;

/// A question that was asked, and what answers it.
pub trait Question: Send + Sync {
    /// The command that asks it.
    fn command(&self) -> &'static str;

    /// The engine whose answer it is, by its title; none where there is no single one.
    fn title(&self) -> Option<&Untrusted>;

    /// The table of this name, one of [`super::data::TABLES`]; none where this answer has none.
    fn table(&self, name: &str) -> Option<Table>;

    /// What the terminal shows.
    fn answer(&self) -> Document;

    /// The page.
    fn page(&self) -> Document;

    /// What is beside the page: layout files, data.
    ///
    /// # Errors
    /// What cannot be written as JSON.
    fn beside(&self) -> serde_json::Result<Vec<File>> {
        Ok(Vec::new())
    }

    /// All tables, the main one first.
    fn tables(&self) -> Vec<Table> {
        super::data::tables_of(self.command()).iter().filter_map(|name| self.table(name)).collect()
    }

    /// The document of `--json`: the title and all tables, but for a question whose document has certificates.
    ///
    /// # Errors
    /// What cannot be written as JSON.
    fn json(&self) -> serde_json::Result<String> {
        let (format, tables) = (format!("crankstar {} 2", self.command()), self.tables());
        serde_json::to_string_pretty(&Answer {
            format,
            title: self.title().map(Untrusted::written),
            tables: Named(&tables),
        })
    }

    /// Whether its document has certificates, which are checked before it is given away.
    fn is_certified(&self) -> bool {
        false
    }

    /// The document without its evidence, where it says more than that proves: for evidence that is too large to be checked.
    fn json_without_evidence(&self) -> Option<serde_json::Result<String>> {
        None
    }
}

/// The table of this name of a question that makes all of them together.
pub(super) fn one_of_all(question: &impl Question, name: &str) -> Option<Table> {
    question.tables().into_iter().find(|table| table.name() == name)
}

/// The question of a study: its command, its title, what makes a table, the short answer and the page, and what it has besides, in braces.
/// Where nothing else is named, `data::table`, `page::answer` and `page::page` of its room make them.
macro_rules! question {
    ($study:ty, $command:literal, $title:expr) => {
        $crate::report::question::question!($study, $command, $title, data::table, page::answer, page::page, {});
    };
    ($study:ty, $command:literal, $title:expr, $table:expr, $answer:expr, $page:expr, { $($more:tt)* }) => {
        impl $crate::report::Question for $study {
            fn command(&self) -> &'static str {
                $command
            }

            fn title(&self) -> Option<&$crate::text::Untrusted> {
                let title: fn(&Self) -> Option<&$crate::text::Untrusted> = $title;
                title(self)
            }

            fn table(&self, name: &str) -> Option<$crate::table::Table> {
                let table: fn(&Self, &str) -> Option<$crate::table::Table> = $table;
                table(self, name)
            }

            fn answer(&self) -> $crate::page::Document {
                let answer: fn(&Self) -> $crate::page::Document = $answer;
                answer(self)
            }

            fn page(&self) -> $crate::page::Document {
                let page: fn(&Self) -> $crate::page::Document = $page;
                page(self)
            }

            $($more)*
        }
    };
}
pub(super) use question;

/// The JSON of a study whose `document` has numbers beside evidence, for the braces of [`question!`].
macro_rules! json_with_evidence {
    () => {
        fn json(&self) -> serde_json::Result<String> {
            serde_json::to_string_pretty(&self.document())
        }

        fn is_certified(&self) -> bool {
            true
        }

        fn json_without_evidence(&self) -> Option<serde_json::Result<String>> {
            Some(serde_json::to_string_pretty(&self.document().without_evidence()))
        }
    };
}
pub(super) use json_with_evidence;

#[derive(Serialize)]
struct Answer<'a> {
    format: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    title: Option<&'a str>,
    #[serde(flatten)]
    tables: Named<'a>,
}

/// Why a question has no answer, in its own words.
pub type Unanswered = Box<dyn Error + Send + Sync>;
