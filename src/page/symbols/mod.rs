//! What does the reader call the symbols? A file renames them, in formulas, in words and in drawings.

mod drawing;
mod file;
pub(super) mod letters;
mod scan;
mod spelling;
mod symbol;

use std::borrow::Cow;

use scan::Part;
use symbol::Symbol;

/// The reader's names of some symbols.
#[derive(Clone, Debug, Default)]
pub struct Symbols {
    renamed: Vec<(Symbol, Name)>,
}

/// What a symbol is called.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Name {
    tex: String,
    plain: String,
}

impl Symbols {
    /// Whether each symbol has its usual name.
    pub fn is_empty(&self) -> bool {
        self.renamed.is_empty()
    }

    fn name(&self, is_meant: impl Fn(&Symbol) -> bool) -> Option<&Name> {
        self.renamed.iter().find(|(symbol, _)| is_meant(symbol)).map(|(_, name)| name)
    }

    /// A formula in TeX with the names of the reader.
    pub(super) fn in_tex<'a>(&self, tex: &'a str) -> Cow<'a, str> {
        self.in_formula(tex, |name| &name.tex)
    }

    /// The same where a formula will be read as plain text.
    pub(super) fn in_plain_formula<'a>(&self, tex: &'a str) -> Cow<'a, str> {
        self.in_formula(tex, |name| &name.plain)
    }

    fn in_formula<'a>(&self, tex: &'a str, of: fn(&Name) -> &String) -> Cow<'a, str> {
        if self.is_empty() {
            return tex.into();
        }
        let set = |part: Part| match part {
            Part::Symbol(symbol, written) => match self.name(|other| *other == symbol) {
                Some(name) => grouped(symbol, of(name)),
                None => written.to_owned(),
            },
            Part::Other(written) => written.to_owned(),
        };
        scan::formula(tex).into_iter().map(set).collect::<String>().into()
    }

    /// Words in parts: those as they stand, and the new names in TeX and as plain text.
    pub(super) fn in_parts<'a>(&'a self, words: &'a str) -> Vec<Word<'a>> {
        if self.is_empty() {
            return vec![Word::Plain(words)];
        }
        let set = |part: Part<'a>| match part {
            Part::Symbol(symbol, written) => match self.name(|other| *other == symbol) {
                Some(name) => Word::Renamed { tex: &name.tex, plain: &name.plain },
                None => Word::Plain(written),
            },
            Part::Other(written) => Word::Plain(written),
        };
        scan::words(words).into_iter().map(set).collect()
    }

    /// Words as plain text.
    pub(super) fn in_plain_words(&self, words: &str) -> String {
        let set = |word: Word| match word {
            Word::Plain(words) => words.to_owned(),
            Word::Renamed { plain, .. } => plain.to_owned(),
        };
        self.in_parts(words).into_iter().map(set).collect()
    }

    /// The letters of a script, in which words are few and code is not touched.
    pub(super) fn in_letters(&self, text: &str) -> String {
        let set = |letter: char| match self.name(|symbol| !symbol.has_index && symbol.letter == letter) {
            Some(name) => name.plain.clone(),
            None => letter.to_string(),
        };
        text.chars().map(set).collect()
    }
}

/// A part of words.
pub(super) enum Word<'a> {
    /// As it stands.
    Plain(&'a str),
    /// A symbol by its new name.
    Renamed {
        /// In TeX.
        tex: &'a str,
        /// As plain text.
        plain: &'a str,
    },
}

/// A name as one sign: before an index, behind a command.
fn grouped(symbol: Symbol, name: &str) -> String {
    let is_command = name.strip_prefix('\\').is_some_and(|rest| rest.bytes().all(|byte| byte.is_ascii_alphabetic()));
    // A letter with an index takes the place of another.
    let is_letter = symbol.has_index && name.chars().count() == 1;
    if is_command || is_letter { name.to_owned() } else { format!("{{{name}}}") }
}
