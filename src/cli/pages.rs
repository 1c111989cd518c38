//! How is a page written: in which format, into which folder, with what at its foot?

use std::path::{Path, PathBuf};

use crankstar::page::{self, Document, File, Format, Language, Math, Options};

use super::choice::Choices;
use super::failure::Failure;
use super::language::LanguageArgs;
use super::measures::Measures;
use super::notation::Notation;
use super::{folder, layouts, tables, write};

/// What a person may say of a page.
#[derive(clap::Args)]
pub struct Pages {
    /// What the page is written in [default: markdown]
    #[arg(long, value_parser = formats())]
    format: Option<Format>,
    #[command(flatten)]
    page: PageArgs,
}

/// What a person may say of a page whatever it is written in.
#[derive(clap::Args)]
pub struct PageArgs {
    /// How formulas are marked in Markdown [default: github]
    #[arg(long, value_enum)]
    math: Option<Math>,
    /// Folder for the page and its pictures
    #[arg(long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Write LaTeX, Typst or HTML without preamble, to be included in a document; LaTeX with captions and labels
    #[arg(long)]
    fragment: bool,
    /// What the labels of the fragment begin with [default: the title]
    #[arg(long, value_name = "PREFIX", requires = "fragment", value_parser = prefix)]
    label: Option<String>,
    /// Write quantities as \qty of the LaTeX package siunitx
    #[arg(long)]
    siunitx: bool,
    #[command(flatten)]
    reader: Reader,
}

/// What a person may say of whatever is written.
#[derive(clap::Args)]
pub struct Reader {
    /// Name program and version at the foot of a page, or in a comment of a drawing
    #[arg(long)]
    stamp: bool,
    #[command(flatten)]
    measures: Measures,
    #[command(flatten)]
    notation: Notation,
    #[command(flatten)]
    language: LanguageArgs,
}

impl Reader {
    /// In which units and to how many figures a page is to be.
    pub fn measures(&self) -> &Measures {
        &self.measures
    }

    /// The notation and the language, and the stamp where it is asked for.
    pub fn options(&self) -> Result<Options, Failure> {
        let stamp = self.stamp.then(|| format!("crankstar {}", env!("CARGO_PKG_VERSION")));
        let (symbols, language) = (self.notation.read()?, self.language.language());
        Ok(Options { stamp, symbols, ..self.measures.options(language) })
    }
}

/// The formats of pages.
pub fn formats() -> Choices<Format> {
    Choices::new(Format::NAMED.map(|(name, format, about)| (name, about, format)))
}

/// Whether a path has the ending of a page.
fn is_named_as_a_page(path: &Path) -> bool {
    const ENDINGS: [&str; 7] = ["html", "htm", "md", "tex", "pdf", "txt", "typ"];
    let ending = path.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
    ending.is_some_and(|ending| ENDINGS.contains(&ending.as_str()))
}

/// What LaTeX takes in a label.
fn prefix(text: &str) -> Result<String, String> {
    let is_meant = |letter: char| letter.is_ascii_alphanumeric() || "-.:".contains(letter);
    match !text.is_empty() && text.chars().all(is_meant) {
        true => Ok(text.to_owned()),
        false => Err("letters, digits, -, . and : such as v8".to_owned()),
    }
}

impl PageArgs {
    fn format(&self, format: Format) -> Format {
        match (format, self.math) {
            (Format::Markdown(_), Some(math)) => Format::Markdown(math),
            (format, _) => format,
        }
    }

    /// The format of the page that is written, of which this one is named; none where a short answer alone is given.
    pub fn written(&self, named: Option<Format>) -> Option<Format> {
        named.or(self.output.as_ref().map(|_| Format::GITHUB))
    }

    /// Refuses what is said of another format than that of the page; of all of them where no page is written.
    ///
    /// # Errors
    /// The option, and the formats that it is for.
    pub fn is_said_of(&self, page: Option<Format>) -> Result<(), Failure> {
        let is_markdown = matches!(page, Some(Format::Markdown(_)));
        let has_preamble = matches!(page, Some(Format::Latex | Format::Typst | Format::Html));
        let told = [
            ("--math", "Markdown", self.math.is_some() && !is_markdown),
            ("--siunitx", "LaTeX", self.siunitx && page != Some(Format::Latex)),
            ("--fragment", "LaTeX, Typst and HTML", self.fragment && !has_preamble),
        ];
        let strange = told.into_iter().find(|(_, _, is_strange)| *is_strange);
        strange.map_or(Ok(()), |(option, formats, _)| {
            let written = match page {
                Some(_) => "this page is in another format",
                None => "no page is written",
            };
            Err(Failure::misuse(format!(
                "{option} is for pages in {formats}, and {written}; omit it, or change --format"
            )))
        })
    }

    /// Refuses what is said of pages and answers where data is written.
    ///
    /// # Errors
    /// The option.
    pub fn is_said_of_data(&self) -> Result<(), Failure> {
        let told = [("--symbols", self.reader.notation.is_given()), ("--stamp", self.reader.stamp)];
        let strange = told.into_iter().find(|(_, is_given)| *is_given);
        strange.map_or(Ok(()), |(option, _)| {
            Err(Failure::misuse(format!("{option} is for pages and answers, and data is written; omit it")))
        })
    }

    /// The files of a page, the main one first.
    pub fn files(&self, document: &Document, format: Format) -> Result<Vec<File>, Failure> {
        let (fragment, label, siunitx) = (self.fragment, self.label.clone(), self.siunitx);
        let options = Options { fragment, label, siunitx, ..self.reader.options()? };
        Ok(page::write(document, self.format(format), &options))
    }

    /// Refuses a name of a file: a page goes into a folder.
    ///
    /// # Errors
    /// How the data would be had, where the command has any.
    pub fn is_for_a_folder(&self) -> Result<(), Failure> {
        let named = self.output.as_deref().filter(|path| !path.is_dir());
        if let Some(path) = named.filter(|path| is_named_as_a_page(path)) {
            let shown = layouts::shown(path);
            let (folder, _) = shown.rsplit_once('.').unwrap_or((&shown, ""));
            return Err(Failure::misuse(format!(
                "`{shown}` is named as a file, and a page goes into a folder with its pictures; write --output {folder}"
            )));
        }
        match named.filter(|path| tables::is_named_as_data(path)) {
            None => Ok(()),
            Some(path) => Err(Failure::misuse(format!(
                "`{}` is named as a file of data, and a page goes into a folder; name a folder",
                layouts::shown(path)
            ))),
        }
    }

    /// Writes the files into the folder where one is named; says what was written.
    pub fn write(&self, files: impl FnOnce() -> Result<Vec<File>, Failure>) -> Result<String, Failure> {
        let Some(folder) = &self.output else { return Ok(String::new()) };
        self.is_for_a_folder()?;
        let files = files()?;
        folder::write(folder, &files)?;
        Ok(format!("\n{}", folder::written(folder, &files)))
    }

    /// Prints the short answer and writes the page with other files beside it into the folder where one is named; without a folder the page alone
    /// where its format is named.
    pub fn give(
        &self,
        format: Option<Format>,
        answer: &Document,
        page: impl FnOnce() -> Document,
        beside: impl FnOnce() -> Result<Vec<File>, Failure>,
    ) -> Result<(), Failure> {
        let files = || self.files(&page(), format.unwrap_or(Format::GITHUB));
        if format.is_some() && self.output.is_none() {
            return write::to_stdout(&files()?[0].text);
        }
        let written = self.write(|| Ok(files()?.into_iter().chain(beside()?).collect()))?;
        write::to_stdout(&(self.shown(answer)? + &written))
    }

    /// A short answer for the terminal, in the notation of the reader.
    pub fn shown(&self, answer: &Document) -> Result<String, Failure> {
        Ok(shown(answer, &Options { stamp: None, ..self.reader.options()? }))
    }

    /// In which units a page is to be.
    pub fn measures(&self) -> &Measures {
        &self.reader.measures
    }

    /// The folder that is named.
    pub fn folder(&self) -> Option<&Path> {
        self.output.as_deref()
    }

    /// The language.
    pub fn language(&self) -> Language {
        self.reader.language.language()
    }
}

impl Pages {
    /// In which units a page is to be.
    pub fn measures(&self) -> &Measures {
        self.page.measures()
    }

    /// The folder that is named.
    pub fn folder(&self) -> Option<&Path> {
        self.page.folder()
    }

    /// Writes these files into the folder; says what was written.
    pub fn write_files(&self, files: &[File]) -> Result<String, Failure> {
        self.page.write(|| Ok(files.to_vec()))
    }

    /// Whether the page runs scripts.
    pub fn runs_scripts(&self) -> bool {
        self.format == Some(Format::Html)
    }

    /// The files of a page, the main one first.
    pub fn files(&self, document: &Document) -> Result<Vec<File>, Failure> {
        let format = self.format.unwrap_or(Format::GITHUB);
        self.page.is_said_of(Some(format))?;
        self.page.files(document, format)
    }

    /// Prints the short answer, and writes the page with other files beside it into the folder where one is named; without a folder the page alone
    /// where its format is named.
    pub fn show(
        &self,
        answer: &Document,
        page: impl FnOnce() -> Document,
        beside: impl FnOnce() -> Vec<File>,
    ) -> Result<(), Failure> {
        self.page.is_said_of(self.page.written(self.format))?;
        self.page.give(self.format, answer, page, || Ok(beside()))
    }

    /// Writes the page into the folder and the short answer to the terminal; without a folder the page alone to standard output.
    pub fn show_page(&self, answer: impl FnOnce() -> Document, page: &Document) -> Result<(), Failure> {
        let files = self.files(page)?;
        let Some(folder) = &self.page.output else { return write::to_stdout(&files[0].text) };
        self.page.is_for_a_folder()?;
        folder::write(folder, &files)?;
        write::to_stdout(&format!("{}\n{}", self.page.shown(&answer())?, folder::written(folder, &files)))
    }
}

/// Columns of a text that is not printed on a terminal.
const USUAL_WIDTH: usize = 80;
/// Columns beyond which lines are hard to read.
const WIDEST: usize = 140;

/// A document for the terminal that this runs in; colours are taken away where nobody sees them.
pub fn shown(document: &Document, options: &Options) -> String {
    let width = comfy_table::Table::new().width().map_or(USUAL_WIDTH, usize::from);
    let format = Format::Terminal { width: width.clamp(20, WIDEST), colour: true };
    let files = page::write(document, format, options);
    format!("{}\n", files[0].text.trim_end())
}
