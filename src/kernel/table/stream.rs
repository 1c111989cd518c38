//! How is a table written that is too long for memory? Some rows at a time.

use std::io::Write;

use super::csv::{self, header};
use super::{Format, Table, Unwritable};
use crate::text::harmless;

/// A file of one table that grows by some rows at a time.
pub struct Stream<W: Write + Send> {
    like: Table,
    file: File<W>,
}

enum File<W: Write + Send> {
    Csv(W),
    #[cfg(feature = "parquet")]
    Parquet(super::parquet::Groups<W>),
}

fn refused(why: impl ToString) -> Unwritable {
    Unwritable::Refused(harmless(&why.to_string()))
}

fn failed(why: impl ToString) -> Unwritable {
    Unwritable::Failed(harmless(&why.to_string()))
}

impl<W: Write + Send> Stream<W> {
    /// Begins a file with the columns of a table, whose rows do not matter.
    ///
    /// # Errors
    /// A format that is not built in, or one that is written whole; what `sink` does not take.
    pub fn new(format: Format, like: Table, sink: W) -> Result<Self, Unwritable> {
        format.is_built()?;
        let file = match format {
            Format::Csv => {
                let mut sink = sink;
                sink.write_all(header(&like).as_bytes()).map_err(failed)?;
                File::Csv(sink)
            }
            #[cfg(feature = "parquet")]
            Format::Parquet => File::Parquet(super::parquet::Groups::new(&like, sink).map_err(refused)?),
            #[cfg(not(feature = "parquet"))]
            Format::Parquet => return Err(Unwritable::NotBuilt("parquet")),
            Format::Xlsx | Format::Json => return Err(refused("a workbook is written whole, and so is JSON")),
        };
        Ok(Stream { like, file })
    }

    /// Adds the rows of a table with the same columns.
    ///
    /// # Errors
    /// Other columns, or what the file does not take.
    pub fn add(&mut self, table: &Table) -> Result<(), Unwritable> {
        if !self.like.has_the_columns_of(table) {
            return Err(failed("its columns are not the same in all rows"));
        }
        match &mut self.file {
            File::Csv(sink) => sink.write_all(csv::rows(table).as_bytes()).map_err(failed),
            #[cfg(feature = "parquet")]
            File::Parquet(groups) => groups.add(table).map_err(refused),
        }
    }

    /// Adds rows that are written as comma-separated values already ([`super::rows`]).
    ///
    /// # Errors
    /// What are no such rows, or what the file does not take.
    pub fn add_rows(&mut self, rows: &str) -> Result<(), Unwritable> {
        match &mut self.file {
            File::Csv(sink) => sink.write_all(rows.as_bytes()).map_err(failed),
            #[cfg(feature = "parquet")]
            File::Parquet(groups) => {
                let table =
                    csv::from_rows(&self.like, rows).ok_or_else(|| failed("the rows are none of this table"))?;
                groups.add(&table).map_err(refused)
            }
        }
    }

    /// Ends the file.
    ///
    /// # Errors
    /// What the file does not take.
    pub fn finish(self) -> Result<W, Unwritable> {
        match self.file {
            File::Csv(mut sink) => sink.flush().map(|()| sink).map_err(failed),
            #[cfg(feature = "parquet")]
            File::Parquet(groups) => groups.finish().map_err(refused),
        }
    }
}
