//! How is a person's text shown? As that text and nothing else, in every format.
//!
//! What comes from a file or the command line is [`Untrusted`]. It has no `Display` and does not serialise, so that it cannot
//! be on a page by mistake: the ways out are [`Untrusted::escaped`], and [`Untrusted::written`] for JSON and comparisons,
//! whose callers `tests/suite/hostile_text.rs` lists.

mod coq;
mod csv;
mod decoded;
mod json;
mod latex;
mod letters;
mod markdown;
mod script;
mod terminal;
mod xml;

pub use coq::coq_comment;
pub use csv::field;
pub use decoded::decoded;
pub use json::json;
pub use latex::{SUPERSCRIPTS, breakable, latex};
pub use letters::TEX_LETTERS;
pub use markdown::markdown;
pub use script::json_in_script;
pub use terminal::{harmless, harmless_but_colours, harmless_lines, of_equal_length};
pub use xml::xml;

/// So many of them: `1 value`, `2 values`.
pub fn counted(count: usize, one: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {one}{plural}")
}

/// A text that a person wrote: a title, a name, a source, a path.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Untrusted {
    text: String,
    /// Whether it stands in a file of the catalogue, whose titles have translations.
    of_catalogue: bool,
}

/// Where a text is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Markdown, and the HTML that is made of it.
    Markdown,
    /// LaTeX for pdflatex.
    Latex,
    /// Plain text: a terminal, a cell or a label that its own writer escapes.
    Plain,
    /// A field of a table for spreadsheets, without the quotes that [`field`] puts round it.
    Csv,
}

impl Untrusted {
    /// A person's text.
    pub fn new(text: impl Into<String>) -> Self {
        Untrusted { text: text.into(), of_catalogue: false }
    }

    /// The same text in a file of the catalogue: what it is read from decides this, never how it sounds.
    #[must_use]
    pub fn of_catalogue(self) -> Self {
        Untrusted { of_catalogue: true, ..self }
    }

    /// Whether it stands in a file of the catalogue.
    pub fn is_of_catalogue(&self) -> bool {
        self.of_catalogue
    }

    /// The text in one line, with nothing in it that the format would obey.
    ///
    /// ```standalone_crate
    /// # use crankstar_kernel as crankstar;
    /// use crankstar::text::{Format, Untrusted};
    /// let title = Untrusted::new("<b>\u{1b}[31m four");
    /// assert_eq!(title.escaped(Format::Plain), "<b>[U+001B][31m four");
    /// assert_eq!(title.escaped(Format::Markdown), "&lt;b&gt;\\[U+001B\\]\\[31m four");
    /// ```
    pub fn escaped(&self, format: Format) -> String {
        let plain = harmless(&self.text);
        match format {
            Format::Markdown => markdown(&plain),
            Format::Latex => latex::quoted(&plain),
            Format::Plain => plain,
            Format::Csv => csv::inert(plain),
        }
    }

    /// The text as it was written, for what compares, reads or serialises it.
    pub fn written(&self) -> &str {
        &self.text
    }
}

impl PartialEq<&str> for Untrusted {
    fn eq(&self, other: &&str) -> bool {
        self.text == *other
    }
}
