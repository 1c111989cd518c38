//! How does a document become files? A composer walks its blocks; a writer per format knows the signs.

mod alone;
mod columns;
mod compose;
mod decimals;
mod filled;
mod html;
mod labels;
mod latex;
mod markdown;
mod notation;
mod options;
mod siunitx;
mod templates;
mod terminal;
mod tex;
mod typst;
mod writer;

use super::block::{Block, Document};
use super::language::Language;
use super::text::Text;
pub use alone::Alone;
use compose::Composer;
pub use markdown::Math;
pub use options::Options;
pub(crate) use templates::say;
pub use terminal::wrapped;
pub use writer::File;
use writer::Writer;

/// What a document is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Format {
    /// Markdown, with pictures beside it.
    Markdown(Math),
    /// LaTeX for pdflatex, pictures inside.
    Latex,
    /// One page for a browser, pictures inside.
    Html,
    /// Typst, with pictures beside it.
    Typst,
    /// Plain text of this many columns, in colours or not, without pictures.
    Terminal {
        /// Columns of the terminal.
        width: usize,
        /// Whether colours are wanted, which the feature `cli` has.
        colour: bool,
    },
}

impl Format {
    /// Markdown for code-hosting pages.
    pub const GITHUB: Format = Format::Markdown(Math::Github);
    /// Plain text of 80 columns.
    pub const PLAIN: Format = Format::Terminal { width: 80, colour: false };
    /// Those that a person asks for by name, and what is told of them.
    pub const NAMED: [(&str, Format, &str); 5] = [
        ("markdown", Format::GITHUB, "Markdown with SVG files beside it"),
        ("latex", Format::Latex, "LaTeX for pdflatex"),
        ("html", Format::Html, "One file for a browser"),
        ("typst", Format::Typst, "Typst with SVG files beside it"),
        ("text", Format::PLAIN, "Plain text without pictures"),
    ];

    /// The format of a name; or what can be written, in a row.
    ///
    /// # Errors
    /// The names that there are.
    pub fn of_name(name: &str) -> Result<Self, String> {
        let known = Format::NAMED.iter().find(|(known, ..)| *known == name);
        known.map(|(_, format, _)| *format).ok_or_else(|| {
            let [names @ .., last] = Format::NAMED.map(|(known, ..)| known);
            format!("format `{name}`; {} or {last} are written", names.join(", "))
        })
    }

    /// What knows the signs of the format.
    fn writer(self) -> Box<dyn Writer> {
        match self {
            Format::Markdown(math) => Box::new(markdown::Markdown { math }),
            Format::Latex => Box::new(latex::Latex),
            Format::Html => Box::new(html::Html),
            Format::Typst => Box::new(typst::Typst),
            Format::Terminal { width, colour } => Box::new(terminal::Terminal { width, colour, unbroken: false }),
        }
    }
}

/// The files of a document: the main one first.
pub fn write(document: &Document, format: Format, options: &Options) -> Vec<File> {
    let writer = format.writer();
    let mut composer = Composer::new(writer.as_ref(), options);
    let text = composer.document(document);
    let main = File { name: format!("{}.{}", document.name, writer.ending()), text };
    [main].into_iter().chain(composer.files).collect()
}

/// Blocks by themselves, with no document around them: a part of a page that has styles and a head of its own.
pub fn blocks_in(blocks: &[Block], format: Format, options: &Options) -> String {
    Composer::new(format.writer().as_ref(), options).blocks(blocks)
}

impl Text {
    /// As plain text, in English.
    pub fn plain(&self) -> String {
        text_in(self, Format::PLAIN)
    }

    /// As plain text in a language.
    pub fn plain_in(&self, language: Language) -> String {
        notation::plain(self, &Options { language, ..Options::default() })
    }
}

/// A text by itself in a format, in English.
pub fn text_in(text: &Text, format: Format) -> String {
    let writer = format.writer();
    Composer::new(writer.as_ref(), &Options::default()).text(text)
}
