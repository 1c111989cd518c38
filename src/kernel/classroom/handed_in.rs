//! What was handed in, and which tables are in it? Read by what the name of the file ends in.

use super::answers::in_toml;
use super::submission::{Owner, Submission};
use super::{csv, lines};
use crate::table;
use crate::text::decoded;

/// A file that was handed in.
#[derive(Clone, Debug)]
pub struct HandedIn {
    /// Its name, which tells what it is: a table in TOML, CSV or XLSX, or none.
    pub name: String,
    /// What it holds.
    pub content: Content,
}

/// What a file holds, or why nobody knows.
#[derive(Clone, Debug)]
pub enum Content {
    /// These bytes.
    Bytes(Vec<u8>),
    /// It cannot be read, for this reason.
    Unreadable(String),
    /// It is not looked at, for this reason.
    LeftOut(&'static str),
}

/// What a table is written as.
enum Kind {
    Toml,
    Csv,
    Workbook,
}

/// The endings of files that are read.
const KINDS: [(&str, Kind); 3] = [("toml", Kind::Toml), ("csv", Kind::Csv), ("xlsx", Kind::Workbook)];

impl HandedIn {
    /// Why it is no table of a student; none where it is looked at.
    pub(super) fn left_out(&self) -> Option<&'static str> {
        match &self.content {
            Content::LeftOut(why) => Some(why),
            Content::Bytes(_) | Content::Unreadable(_) => self.kind().is_none().then_some(NO_TABLE),
        }
    }

    /// Whether it is a table that is to be read.
    pub fn is_table(&self) -> bool {
        self.left_out().is_none()
    }

    fn kind(&self) -> Option<&'static Kind> {
        let (_, ending) = self.name.rsplit_once('.')?;
        KINDS.iter().find(|(known, _)| ending.eq_ignore_ascii_case(known)).map(|(_, kind)| kind)
    }

    /// Its tables, with whose they are; why there are none, where it cannot be read.
    pub(super) fn tables(self) -> Result<Vec<(Owner, Submission)>, String> {
        let kind = self.kind();
        let content = match self.content {
            Content::Bytes(bytes) => bytes,
            Content::Unreadable(why) => return Err(why),
            Content::LeftOut(why) => return Err(why.to_owned()),
        };
        match kind {
            None => Err(NO_TABLE.to_owned()),
            Some(Kind::Toml) => in_toml(decoded(&content)).map(|table| vec![table]),
            Some(Kind::Csv) => lines::in_rows(csv::rows(&decoded(&content))),
            Some(Kind::Workbook) => lines::in_rows(csv::filled(table::workbook_rows(&content)?.into_iter())),
        }
    }
}

/// What is said of all other files.
const NO_TABLE: &str = "tables end in .toml, .csv or .xlsx";
