//! How is a long table computed in pieces: kept, shared among machines, merged, with the time that is left?

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use indicatif::ProgressBar;

use crankstar::report::data;
use crankstar::shard::{Merged, Question, Shard, Store, cores, in_order};
use crankstar::sweep::Stream;
use crankstar::table::{self, Format, Table};

use super::failure::Failure;
use super::layouts::shown;
use super::tables::Wanted;
use super::{progress, write};

/// Which pieces are computed, and where they are kept.
#[derive(clap::Args)]
pub struct Pieces {
    /// Compute the i-th of N equal parts of the table of points, and keep it in the file of --output; called again, go on
    #[arg(long, value_name = "i/N", conflicts_with_all = ["merge", "resume"])]
    shard: Option<String>,
    /// Compute nothing: put the files of all shards together, into the table that one run would give, or into one file NAME.shard
    #[arg(long, value_name = "FILES", num_args = 1.., conflicts_with = "resume")]
    merge: Vec<PathBuf>,
    /// Keep every finished piece of the table of points in this file, and go on from it; interrupt at will
    #[arg(long, value_name = "FILE")]
    resume: Option<PathBuf>,
    /// Number of threads that compute the table of points [default: one per core]
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
}

/// How files of pieces are named.
const ENDING: &str = "shard";

/// What a piece is on its way to the table.
enum Made {
    Rows(String),
    Table(Table),
}

impl Pieces {
    fn threads(&self) -> usize {
        self.threads.map_or_else(cores, usize::from)
    }

    /// The shard that is asked for.
    pub fn shard(&self) -> Result<Option<Shard>, Failure> {
        self.shard.as_deref().map(|text| Shard::parse(text).map_err(Failure::misuse)).transpose()
    }

    /// See [`are_kept_apart`].
    pub fn are_kept_apart(&self, output: Option<&Path>) -> Result<(), Failure> {
        are_kept_apart(self.resume.as_deref(), output)
    }

    /// The file that several are merged into, where that is one of pieces again.
    pub fn merged_into_one<'a>(&self, output: Option<&'a Path>) -> Option<&'a Path> {
        merged_into_one(&self.merge, output)
    }

    /// Sees to it that nothing is said of pieces, where there are none.
    pub fn are_for_tables(&self) -> Result<(), Failure> {
        match (self.merge.is_empty(), &self.resume, self.threads) {
            (true, None, None) => Ok(()),
            (false, _, _) | (_, Some(_), _) | (_, _, Some(_)) => Err(Failure::misuse(
                "pieces and threads are those of the table of points; add --format csv or parquet, and no --output or that of one file",
            )),
        }
    }

    /// Puts several files into one.
    pub fn merge(&self, question: &Question, output: &Path) -> Result<(), Failure> {
        merge(&self.merge, question, output)
    }

    /// Computes the pieces of a shard that its file lacks.
    pub fn keep(&self, stream: &Stream, question: &Question, shard: Shard, output: &Path) -> Result<(), Failure> {
        keep(stream, question, shard, output, self.threads())?;
        write::to_stdout(&format!("Written: {}\n", shown(output)))
    }

    /// Writes the whole table: from the files that are merged, from the file that is gone on with, or as it is computed.
    pub fn write(&self, stream: &Stream, question: &Question, wanted: &Wanted) -> Result<(), Failure> {
        let kept = match &self.resume {
            Some(path) => {
                keep(stream, question, Shard::WHOLE, path, self.threads())?;
                std::slice::from_ref(path)
            }
            None => self.merge.as_slice(),
        };
        let like = data::sweep_points(&stream.first().map_err(Failure::new)?);
        let all: Vec<usize> = (0..question.pieces).collect();
        if !kept.is_empty() {
            let merged = Merged::open(kept, question).and_then(Merged::whole).map_err(Failure::new)?;
            return wanted.stream(like.clone(), |file| {
                let read = |piece| {
                    let rows = text(merged.read(piece).map_err(Failure::new)?)?;
                    Ok(match wanted.format() {
                        Format::Csv => Made::Rows(rows),
                        Format::Parquet | Format::Xlsx | Format::Json => Made::Table(of_rows(&like, &rows)?),
                    })
                };
                in_order(self.threads(), &all, &read, &mut |_, made| add(file, made))
            });
        }
        let bar = if wanted.shows_itself() { ProgressBar::hidden() } else { bar(&all, 0) };
        let outcome = wanted.stream(like.clone(), |file| {
            let make = |piece| {
                let table = points(stream, &like, piece)?;
                Ok(match wanted.format() {
                    Format::Csv => Made::Rows(table::rows(&table)),
                    Format::Parquet | Format::Xlsx | Format::Json => Made::Table(table),
                })
            };
            in_order(self.threads(), &all, &make, &mut |_, made| {
                add(file, made)?;
                bar.inc(1);
                Ok(())
            })
        });
        bar.finish_and_clear();
        outcome
    }
}

/// Refuses to write an answer over the pieces that are kept.
pub fn are_kept_apart(resume: Option<&Path>, output: Option<&Path>) -> Result<(), Failure> {
    let (Some(kept), Some(written)) = (resume, output) else { return Ok(()) };
    // `./pieces` is `pieces`; what cannot be resolved is compared as it stands.
    let place = |path: &Path| std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    match place(kept) == place(written) {
        false => Ok(()),
        true => {
            let path = shown(kept);
            Err(Failure::misuse(format!(
                "--resume and --output both name `{path}`; the answer needs a file of its own"
            )))
        }
    }
}

/// The file that several are merged into, where that is one of pieces again.
pub fn merged_into_one<'a>(files: &[PathBuf], output: Option<&'a Path>) -> Option<&'a Path> {
    let is_one = |path: &&Path| path.extension().is_some_and(|ending| ending == ENDING);
    output.filter(|_| !files.is_empty()).filter(is_one)
}

/// Puts several files into one.
pub fn merge(files: &[PathBuf], question: &Question, output: &Path) -> Result<(), Failure> {
    let merged = Merged::open(files, question).map_err(Failure::new)?;
    merged.keep(output, question).map_err(Failure::new)?;
    let count = merged.pieces().count();
    write::to_stdout(&format!("Written: {}, {count} of {} pieces\n", shown(output), question.pieces))
}

fn add<W: std::io::Write + Send>(file: &mut table::Stream<W>, made: Made) -> Result<(), Failure> {
    match made {
        Made::Rows(rows) => file.add_rows(&rows).map_err(Failure::new),
        Made::Table(table) => file.add(&table).map_err(Failure::new),
    }
}

fn text(bytes: Vec<u8>) -> Result<String, Failure> {
    String::from_utf8(bytes).map_err(|_| Failure::new("a piece is not a text"))
}

fn of_rows(like: &Table, rows: &str) -> Result<Table, Failure> {
    table::from_rows(like, rows).ok_or_else(|| Failure::new("a piece holds no rows of this table"))
}

/// The rows of one piece.
fn points(stream: &Stream, like: &Table, piece: usize) -> Result<Table, Failure> {
    let table = data::sweep_points(&stream.piece(piece).map_err(Failure::new)?);
    match like.has_the_columns_of(&table) {
        true => Ok(table),
        false => Err(Failure::new("not all points of this sweep have the same columns; sweep less at once")),
    }
}

/// Computes the pieces of a shard that its file lacks, and keeps each.
fn keep(stream: &Stream, question: &Question, shard: Shard, path: &Path, threads: usize) -> Result<(), Failure> {
    let mut store = Store::open(path, question, shard).map_err(Failure::new)?;
    let there: BTreeSet<usize> = store.pieces();
    let list: Vec<usize> = (0..question.pieces).filter(|piece| shard.takes(*piece) && !there.contains(piece)).collect();
    let like = data::sweep_points(&stream.first().map_err(Failure::new)?);
    let bar = bar(&list, there.len());
    let make = |piece| points(stream, &like, piece).map(|table| table::rows(&table));
    let kept = in_order(threads, &list, &make, &mut |piece, rows| {
        store.put(piece, rows.as_bytes()).map_err(Failure::new)?;
        bar.inc(1);
        Ok(())
    });
    bar.finish_and_clear();
    kept?;
    store.finish().map_err(Failure::new)
}

/// A bar for these pieces, of which this many others were done before.
fn bar(list: &[usize], before: usize) -> ProgressBar {
    let bar = progress::bar("pieces");
    bar.set_length((list.len() + before) as u64);
    bar.set_position(before as u64);
    bar.reset_eta();
    bar
}
