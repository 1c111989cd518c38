//! In which formats is a table written, into which files?

use super::unwritable::Unwritable;
use super::{Named, Table, csv};

/// What tables are written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Comma-separated values: a file a table.
    Csv,
    /// A workbook for spreadsheets: a sheet a table, and one that tells the columns.
    Xlsx,
    /// Parquet: a file a table.
    Parquet,
    /// JSON: an object with the tables below their names, each an array of its rows.
    Json,
}

/// A file of data.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DataFile {
    /// Its name, without a folder.
    pub name: String,
    /// What it holds.
    pub bytes: Vec<u8>,
}

impl Format {
    /// How the names of its files end: `csv`.
    pub fn ending(self) -> &'static str {
        match self {
            Format::Csv => "csv",
            Format::Xlsx => "xlsx",
            Format::Parquet => "parquet",
            Format::Json => "json",
        }
    }

    /// Whether a file holds several tables.
    pub fn holds_several(self) -> bool {
        match self {
            Format::Xlsx | Format::Json => true,
            Format::Csv | Format::Parquet => false,
        }
    }

    /// Whether this program was built with it.
    ///
    /// # Errors
    /// Which feature it was built without.
    pub fn is_built(self) -> Result<(), Unwritable> {
        match self {
            Format::Xlsx if !cfg!(feature = "xlsx") => Err(Unwritable::NotBuilt("xlsx")),
            Format::Parquet if !cfg!(feature = "parquet") => Err(Unwritable::NotBuilt("parquet")),
            Format::Csv | Format::Xlsx | Format::Parquet | Format::Json => Ok(()),
        }
    }

    /// The tables as one file.
    ///
    /// # Errors
    /// Several tables in a format that holds one; a feature that is missing; more than the format holds.
    pub fn one_file(self, tables: &[Table]) -> Result<Vec<u8>, Unwritable> {
        match (self, tables) {
            (Format::Csv, [only]) => Ok(csv(only).into_bytes()),
            (Format::Parquet, [only]) => parquet(only),
            (Format::Xlsx, several) => xlsx(several),
            (Format::Json, several) => {
                serde_json::to_vec_pretty(&Named(several)).map_err(|error| Unwritable::Failed(error.to_string()))
            }
            (Format::Csv | Format::Parquet, several) => {
                Err(Unwritable::Failed(format!("{} tables are not in one file", several.len())))
            }
        }
    }

    /// The tables of a question as files: `loads.csv` for the main one and `loads-theta.csv`, or `loads.xlsx`.
    ///
    /// # Errors
    /// A feature that is missing; more than the format holds.
    pub fn files(self, question: &str, main: &str, tables: &[Table]) -> Result<Vec<DataFile>, Unwritable> {
        let ending = self.ending();
        if self.holds_several() {
            return Ok(vec![DataFile { name: format!("{question}.{ending}"), bytes: self.one_file(tables)? }]);
        }
        let file = |table: &Table| {
            let name = match table.name() == main {
                true => format!("{question}.{ending}"),
                false => format!("{question}-{}.{ending}", table.name()),
            };
            Ok(DataFile { name, bytes: self.one_file(std::slice::from_ref(table))? })
        };
        tables.iter().map(file).collect()
    }
}

#[cfg(feature = "xlsx")]
use super::xlsx::xlsx;

#[cfg(not(feature = "xlsx"))]
fn xlsx(_: &[Table]) -> Result<Vec<u8>, Unwritable> {
    Err(Unwritable::NotBuilt("xlsx"))
}

#[cfg(feature = "parquet")]
use super::parquet::parquet;

#[cfg(not(feature = "parquet"))]
fn parquet(_: &Table) -> Result<Vec<u8>, Unwritable> {
    Err(Unwritable::NotBuilt("parquet"))
}
