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
mod templates;
mod terminal;
mod tex;
mod typst;

use super::block::{Block, Document, Picture};
use super::symbols::Symbols;
use super::text::Text;
use super::{Figures, Language, Unit, Units};
pub use alone::Alone;
use compose::Composer;
pub(crate) use templates::say;

/// A file to be written: its name inside the folder, and its text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Name inside the folder.
    pub name: String,
    /// What it holds.
    pub text: String,
}

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

/// How formulas are marked in Markdown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Math {
    /// As `` $`…`$ ``, which code-hosting pages render.
    Github,
    /// As `$…$`, which pandoc, Quarto and Jupyter read.
    Dollars,
}

impl Format {
    /// Markdown for code-hosting pages.
    pub const GITHUB: Format = Format::Markdown(Math::Github);
    /// Plain text of 80 columns.
    pub const PLAIN: Format = Format::Terminal { width: 80, colour: false };

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

/// What a person may choose of a page beside its format.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Whether LaTeX, Typst or HTML is a piece for an existing document, without what stands around it.
    pub fragment: bool,
    /// What is said of the program at the foot of the page.
    pub stamp: Option<String>,
    /// What the reader calls the symbols.
    pub symbols: Symbols,
    /// What the labels of a fragment begin with; else its title.
    pub label: Option<String>,
    /// Whether quantities in LaTeX are left to siunitx.
    pub siunitx: bool,
    /// The language.
    pub language: Language,
    /// The units that quantities are shown in.
    pub units: Units,
    /// The figures of decimals.
    pub figures: Figures,
}

impl Options {
    /// Those of the language alone.
    fn in_language(&self) -> Options {
        Options { language: self.language, ..Options::default() }
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

/// A text by itself in a format, in English.
pub fn text_in(text: &Text, format: Format) -> String {
    let writer = format.writer();
    Composer::new(writer.as_ref(), &Options::default()).text(text)
}

/// What a format has to know: its signs, and where its templates are.
trait Writer {
    /// The ending of its files.
    fn ending(&self) -> &'static str;
    /// Its templates.
    fn templates(&self) -> &'static templates::Set;
    /// Plain words of the program.
    fn words(&self, words: &str) -> String;
    /// A symbol by a name of the reader, in TeX and as plain text, among words.
    fn symbol(&self, _tex: &str, plain: &str) -> String {
        self.words(plain)
    }
    /// Whether formulas are set by what reads any TeX.
    fn reads_tex(&self) -> bool {
        true
    }
    /// A person's words: nothing in them is markup.
    fn person(&self, words: &crate::text::Untrusted) -> String;
    /// A formula in the line, in TeX.
    fn formula(&self, tex: &str) -> String;
    /// What is exact, in TeX and as plain text.
    fn exact(&self, tex: &str, _plain: &str) -> String {
        self.formula(tex)
    }
    /// A formula on a line of its own.
    fn display(&self, tex: &str, number: Option<u32>) -> String;
    /// Bold.
    fn strong(&self, inside: &str) -> String;
    /// Exactly zero, proved.
    fn zero(&self) -> String {
        self.strong("0")
    }
    /// What is typed.
    fn code(&self, text: &str) -> String;
    /// Words that lead to a file, or to `#` and the name of a heading.
    fn link(&self, inside: &str, target: &str) -> String;
    /// A line of a file as it stands: nothing in it is markup.
    fn line(&self, line: &str) -> String;
    /// A picture: what is in the text, and the file beside it if there is one.
    fn picture(&self, picture: &Picture, caption: &str) -> (String, Option<File>);
    /// A table whole, where templates cannot set it.
    fn table(&self, _table: &columns::Cells) -> Option<String> {
        None
    }
    /// What is as wide as a digit, where decimals of a table can be pushed by it.
    fn digit_space(&self) -> Option<&'static str> {
        None
    }
    /// Words that tell what they mean to who points at them, where the format can.
    fn explained(&self, words: String, _meaning: &str) -> String {
        words
    }
    /// A quantity as a package of the format sets it, where there is one.
    fn quantity(&self, _number: &str, _unit: Unit) -> Option<String> {
        None
    }
    /// Whether a fragment has labels and captions.
    fn has_labels(&self) -> bool {
        false
    }
    /// A paragraph, broken into lines where the format does not do so itself.
    fn paragraph(&self, text: String) -> String {
        text
    }
    /// One of a list, which a mark stands before.
    fn item(&self, text: String) -> String {
        self.paragraph(text)
    }
    /// Whether a reader's page runs scripts.
    fn has_scripts(&self) -> bool {
        false
    }
    /// Whether what is folded is at the end.
    fn folds_at_end(&self) -> bool {
        false
    }
}
