//! What is an answer written in: a page in one of its formats, or data?

use std::path::{Path, PathBuf};

use crankstar::page::{self, Document, File};
use crankstar::report::Question;
use crankstar::table;

use super::choice::Choices;
use super::failure::Failure;
use super::layouts::shown;
use super::measures::Measures;
use super::pages::{PageArgs, formats};
use super::tables::{Tables, Wanted};
use super::{tables, verify};

/// What a person may say of an answer that is a page or data.
#[derive(clap::Args)]
#[command(mut_arg("output", |output| output.help("Folder for the page and its pictures; for data a file, or a folder for all tables")))]
pub struct Answer {
    /// What is printed, or written into the folder [default: a short answer; into the folder markdown]
    #[arg(long, value_parser = data_formats().each(Format::Data).and(formats().each(Format::Page)))]
    format: Option<Format>,
    #[command(flatten)]
    tables: Tables,
    #[command(flatten)]
    page: PageArgs,
}

/// Data, or a page in any of its formats.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Format {
    Data(DataFormat),
    Page(page::Format),
}

/// Data for other programs.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum DataFormat {
    /// Tables of columns.
    Table(table::Format),
    /// The answer as JSON.
    Json,
}

impl DataFormat {
    /// What a file of this name holds, by its ending.
    fn of_file(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?;
        data_formats().named(ending, true).copied()
    }
}

/// The formats of data.
fn data_formats() -> Choices<DataFormat> {
    Choices::new([
        ("csv", "Tables of comma-separated values", DataFormat::Table(table::Format::Csv)),
        ("xlsx", "A workbook for spreadsheets, a sheet a table", DataFormat::Table(table::Format::Xlsx)),
        ("parquet", "Tables for notebooks and databases", DataFormat::Table(table::Format::Parquet)),
        ("json", "The output of --json, or for a sweep the points and the exact zeros", DataFormat::Json),
    ])
}

impl Answer {
    /// Asks a question and gives its answer: as tables or as JSON where that is asked for, else in short, with the page in the folder.
    ///
    /// # Errors
    /// What cannot be had, before anything is computed; what the question refuses.
    pub fn give<Q: Question>(
        &self,
        question: &'static str,
        is_json: bool,
        ask: impl FnOnce() -> Result<Q, Failure>,
    ) -> Result<(), Failure> {
        let wanted = self.wanted(question)?;
        if is_json {
            self.page.is_said_of_data()?;
        }
        let asked = ask()?;
        match wanted {
            Some(wanted) => wanted.give(asked.tables()),
            None if is_json || self.is_json() => self.show_json(question, verify::checked(&asked)?),
            None => self.show_with(&asked.answer(), || asked.page(), || asked.beside().map_err(Failure::new)),
        }
    }

    /// The tables that are wanted of this question; none where no table is.
    ///
    /// # Errors
    /// What cannot be had, before anything is computed.
    pub fn wanted(&self, question: &'static str) -> Result<Option<Wanted<'_>>, Failure> {
        match self.is_data() {
            true => self.page.is_said_of(None).and_then(|()| self.page.is_said_of_data())?,
            false => self.page.is_said_of(self.page.written(self.page_format()))?,
        }
        let format = match self.format() {
            Some(Format::Data(DataFormat::Table(format))) => Some(format),
            Some(Format::Data(DataFormat::Json)) => self.tables.json(),
            Some(Format::Page(_)) => {
                self.page.is_for_a_folder()?;
                None
            }
            None => None,
        };
        self.tables.wanted(question, format, self.page.measures(), self.page.folder())
    }

    /// The format that is named, or that of the file to write.
    fn format(&self) -> Option<Format> {
        self.format.or_else(|| DataFormat::of_file(self.output()?).map(Format::Data))
    }

    /// Where the answer goes, if not to standard output.
    pub fn output(&self) -> Option<&Path> {
        self.page.folder()
    }

    /// The file that `--output` names, where nothing else is said of the answer.
    ///
    /// # Errors
    /// No file, or a format.
    pub fn nothing_but_output(&self, flag: &str) -> Result<&Path, Failure> {
        match (self.format, self.output()) {
            (None, Some(output)) if tables::is_named_as_data(output) => Err(Failure::misuse(format!(
                "`{}` is named as a file of data, and {flag} keeps pieces; write --output NAME.shard",
                shown(output)
            ))),
            (None, Some(output)) => Ok(output),
            (Some(_), _) => Err(Failure::misuse(format!(
                "{flag} keeps pieces, in no format yet; name one with --merge, when all are there"
            ))),
            (None, None) => Err(Failure::misuse(format!("{flag} needs a file for its pieces: --output NAME.shard"))),
        }
    }

    /// Whether `--format json` asks for the document, not for a table of data.
    pub fn is_document(&self) -> bool {
        self.is_json() && self.tables.json().is_none()
    }

    /// Whether JSON is asked for.
    pub fn is_json(&self) -> bool {
        self.format() == Some(Format::Data(DataFormat::Json))
    }

    /// Whether a page is printed in place of the short answer.
    pub fn is_page_alone(&self) -> bool {
        self.page_format().is_some() && self.output().is_none()
    }

    /// Whether data are asked for, and no page.
    pub fn is_data(&self) -> bool {
        matches!(self.format(), Some(Format::Data(_)))
    }

    /// Prints a document, or writes it where that is asked for.
    pub fn show_json(&self, question: &str, text: String) -> Result<(), Failure> {
        tables::show_json(question, text, self.page.folder())
    }

    /// Prints the short answer, or the page where its format is named; writes the page into the folder where one is.
    pub fn show(&self, answer: &Document, page: impl FnOnce() -> Document) -> Result<(), Failure> {
        self.show_with(answer, page, || Ok(Vec::new()))
    }

    /// The same, with other files beside the page.
    pub fn show_with(
        &self,
        answer: &Document,
        page: impl FnOnce() -> Document,
        beside: impl FnOnce() -> Result<Vec<File>, Failure>,
    ) -> Result<(), Failure> {
        self.page.give(self.page_format(), answer, page, beside)
    }

    /// A document for the terminal.
    pub fn shown(&self, document: &Document) -> Result<String, Failure> {
        self.page.shown(document)
    }

    /// The format of the page that is named.
    fn page_format(&self) -> Option<page::Format> {
        match self.format {
            Some(Format::Page(format)) => Some(format),
            Some(Format::Data(_)) | None => None,
        }
    }
}

/// What the verdicts are written in, where they are not an answer.
#[derive(Clone, Copy, PartialEq, Eq)]
enum VerdictFormat {
    Data(DataFormat),
    /// Theorems.
    Coq,
}

fn verdict_formats() -> Choices<VerdictFormat> {
    let coq = Choices::new([("coq", "Theorems for the proof assistant Coq", VerdictFormat::Coq)]);
    data_formats().each(VerdictFormat::Data).and(coq)
}

/// What a person may say of an answer that is data or a few lines.
#[derive(clap::Args)]
pub struct DataAnswer {
    /// Write data in place of the answer
    #[arg(long, value_parser = verdict_formats())]
    format: Option<VerdictFormat>,
    #[command(flatten)]
    tables: Tables,
    /// File for the data, or folder for all tables
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl DataAnswer {
    /// The tables that are wanted of this question; none where no table is.
    ///
    /// # Errors
    /// What cannot be had, before anything is computed.
    pub fn wanted(&self, question: &'static str, measures: &Measures) -> Result<Option<Wanted<'_>>, Failure> {
        let format = match self.format() {
            Some(VerdictFormat::Data(DataFormat::Table(format))) => Some(format),
            Some(VerdictFormat::Data(DataFormat::Json)) => self.tables.json(),
            Some(VerdictFormat::Coq) | None => None,
        };
        if self.format().is_none() && self.output.is_some() {
            return Err(Failure::misuse("--output is for data; add --format csv, xlsx, parquet, json or coq"));
        }
        self.tables.wanted(question, format, measures, self.output.as_deref())
    }

    /// The format that is named, or that of the file to write.
    fn format(&self) -> Option<VerdictFormat> {
        self.format.or_else(|| DataFormat::of_file(self.output.as_deref()?).map(VerdictFormat::Data))
    }

    /// Whether JSON is asked for.
    pub fn is_json(&self) -> bool {
        self.format() == Some(VerdictFormat::Data(DataFormat::Json))
    }

    /// Whether theorems of Coq are asked for.
    pub fn is_coq(&self) -> bool {
        self.format == Some(VerdictFormat::Coq)
    }

    /// Prints a document, or writes it where that is asked for.
    pub fn show_json(&self, question: &str, text: String) -> Result<(), Failure> {
        tables::show_json(question, text, self.output.as_deref())
    }

    /// Prints a file of Coq, or writes it where that is asked for.
    pub fn show_coq(&self, question: &str, text: &str) -> Result<(), Failure> {
        tables::show_text(question, text, "v", self.output.as_deref())
    }
}
