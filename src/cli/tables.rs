//! Which tables are asked for, and where do they go: to standard output, into a file, into a folder?

use std::io::{IsTerminal, Write};
use std::path::Path;

use crankstar::page::Units;
use crankstar::report::data::tables_of;
use crankstar::table::{Format, Stream, Table};
use crankstar::text::harmless;

use super::failure::Failure;
use super::layouts::shown;
use super::measures::Measures;
use super::{folder, write};

/// Which of the tables is meant.
#[derive(clap::Args)]
pub struct Tables {
    /// Of the tables this one alone; docs/data.md lists them [default: the first; into a folder or a workbook all]
    #[arg(long, value_name = "TABLE")]
    table: Option<String>,
}

/// Tables that are asked for.
pub struct Wanted<'a> {
    question: &'static str,
    format: Format,
    table: Option<&'a str>,
    output: Option<&'a Path>,
}

/// Names that end so are files of data.
const ENDINGS: [&str; 4] = ["csv", "xlsx", "parquet", "json"];

impl Tables {
    /// JSON as a format of tables, where one of them is named; else it is the document of the answer.
    pub fn json(&self) -> Option<Format> {
        self.table.as_ref().map(|_| Format::Json)
    }

    /// The tables of a question in a format, where one is named.
    ///
    /// # Errors
    /// What cannot be had.
    pub fn wanted<'a>(
        &'a self,
        question: &'static str,
        format: Option<Format>,
        measures: &Measures,
        output: Option<&'a Path>,
    ) -> Result<Option<Wanted<'a>>, Failure> {
        let table = self.table.as_deref();
        let Some(format) = format else {
            return match table {
                None => Ok(None),
                Some(_) => Err(Failure::misuse("--table is for data; add --format csv, xlsx, parquet or json")),
            };
        };
        format.is_built().map_err(Failure::new)?;
        match measures.units() {
            Units::Si => {}
            Units::Inch => {
                return Err(Failure::misuse(
                    "tables of data are in SI units, which are given in the names of their columns; omit --units inch",
                ));
            }
        }
        let known = tables_of(question);
        if let Some(table) = table.filter(|table| !known.contains(table)) {
            let message = format!("`{question}` has no table `{}`; it has {}", harmless(table), known.join(", "));
            return Err(Failure::misuse(message));
        }
        let ending = format.ending();
        match (format, output) {
            (Format::Xlsx | Format::Parquet, None) => Err(Failure::misuse(format!(
                "--format {ending} is not for a terminal; name a file: --output {question}.{ending}"
            ))),
            (_, Some(path)) => {
                is_of(path, ending)?;
                Ok(Some(Wanted { question, format, table, output }))
            }
            (Format::Csv | Format::Json, None) => Ok(Some(Wanted { question, format, table, output })),
        }
    }
}

impl Wanted<'_> {
    /// Whether it is this table alone, in a format that is written some rows at a time.
    pub fn is_streamed(&self, main: &str) -> bool {
        let is_one_file = self.output.is_none_or(|path| ends_in(path, self.format.ending()));
        let grows = match self.format {
            Format::Csv | Format::Parquet => true,
            Format::Xlsx | Format::Json => false,
        };
        grows && is_one_file && self.table.is_none_or(|table| table == main)
    }

    /// Says where the data are that an option asks for, if another table is written alone.
    pub fn tell_what_is_in(&self, table: &str, option: &str) {
        let is_one_file = self.output.is_none_or(|path| ends_in(path, self.format.ending()));
        let first = tables_of(self.question).first().filter(|_| is_one_file && !self.format.holds_several());
        if self.table.or(first.copied()).is_some_and(|alone| alone != table) {
            write::warn(&format!(
                "what {option} asks for is in the table `{table}`, which is not written: add --table {table}"
            ));
        }
    }

    /// Writes a table that `fill` fills, some rows at a time; `like` has its columns.
    pub fn stream(
        &self,
        like: Table,
        fill: impl FnOnce(&mut Stream<Box<dyn Write + Send>>) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let example = format!("{}.{}", self.question, self.format.ending());
        let fill = |sink: Box<dyn Write + Send>| {
            let mut stream = Stream::new(self.format, like, sink).map_err(Failure::new)?;
            fill(&mut stream)?;
            stream.finish().map(drop).map_err(Failure::new)
        };
        match self.output {
            None => fill(Box::new(write::table_to_stdout()?)),
            Some(path) => {
                folder::grow_file(path, &example, |file| fill(Box::new(file)))?;
                write::to_stdout(&format!("Written: {}\n", shown(path)))
            }
        }
    }

    /// Whether its rows are printed on a terminal as they come: they tell how far it is themselves.
    pub fn shows_itself(&self) -> bool {
        self.output.is_none() && std::io::stdout().is_terminal()
    }

    /// What it is written in.
    pub fn format(&self) -> Format {
        self.format
    }

    /// Prints the table, or writes the file or the folder.
    pub fn give(&self, mut tables: Vec<Table>) -> Result<(), Failure> {
        let main = tables.first().map_or("", Table::name);
        if let Some(wanted) = self.table {
            let there: Vec<&str> = tables.iter().map(Table::name).collect();
            if !there.contains(&wanted) {
                let message = format!("this answer has no table `{wanted}`; it has {}", there.join(", "));
                return Err(Failure::new(message));
            }
            tables.retain(|table| table.name() == wanted);
        }
        let ending = self.format.ending();
        let whole_or_first = if self.format.holds_several() { &tables[..] } else { &tables[..1.min(tables.len())] };
        match self.output {
            None => {
                let bytes = self.format.one_file(whole_or_first).map_err(Failure::new)?;
                write::to_stdout(&String::from_utf8_lossy(&bytes))
            }
            Some(path) if ends_in(path, ending) => {
                let bytes = self.format.one_file(whole_or_first).map_err(Failure::new)?;
                folder::write_file(path, &bytes, &format!("{}.{ending}", self.question))?;
                write::to_stdout(&format!("Written: {}\n", shown(path)))
            }
            Some(path) => {
                let files = self.format.files(self.question, main, &tables).map_err(Failure::new)?;
                let contents: Vec<(&str, &[u8])> =
                    files.iter().map(|file| (file.name.as_str(), file.bytes.as_slice())).collect();
                folder::write_contents(path, &contents)?;
                let names: Vec<String> = files.iter().map(|file| shown(&path.join(&file.name))).collect();
                write::to_stdout(&format!("Written: {}\n", names.join(", ")))
            }
        }
    }
}

/// Prints a document, or writes it into a file that ends in `.json`, or into a folder.
pub fn show_json(question: &str, text: String, output: Option<&Path>) -> Result<(), Failure> {
    show_text(question, &text, "json", output)
}

/// Prints a text, or writes it into a file with this ending, or into a folder.
pub fn show_text(question: &str, text: &str, ending: &str, output: Option<&Path>) -> Result<(), Failure> {
    let Some(path) = output else { return write::to_stdout(text) };
    is_of(path, ending)?;
    let name = format!("{question}.{ending}");
    let place = match ends_in(path, ending) {
        true => {
            folder::write_file(path, text.as_bytes(), &name)?;
            path.to_owned()
        }
        false => {
            folder::write_contents(path, &[(&name, text.as_bytes())])?;
            path.join(&name)
        }
    };
    write::to_stdout(&format!("Written: {}\n", shown(&place)))
}

fn ends_in(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|it| it.eq_ignore_ascii_case(ending))
}

/// Whether a name ends as one of a file of data.
pub fn is_named_as_data(path: &Path) -> bool {
    ENDINGS.iter().any(|ending| ends_in(path, ending))
}

/// A name that ends as another format does is a slip.
fn is_of(path: &Path, ending: &str) -> Result<(), Failure> {
    match ENDINGS.iter().find(|other| **other != ending && ends_in(path, other)) {
        None => Ok(()),
        Some(other) => Err(Failure::misuse(format!(
            "`{}` is named as a file of {other}; take --format {other}, or a name that ends in .{ending}",
            shown(path)
        ))),
    }
}
