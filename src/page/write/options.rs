//! What may a person choose of a page beside its format?

use super::super::symbols::Symbols;
use super::super::{Figures, Language, Units};

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
    pub(super) fn in_language(&self) -> Options {
        Options { language: self.language, ..Options::default() }
    }
}
