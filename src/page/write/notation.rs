//! How are words and formulas written in the reader's notation?

use super::super::symbols::Word;
use super::super::text::Text;
use super::compose::Composer;
use super::options::Options;
use super::terminal::Terminal;

impl Composer<'_> {
    /// Words of the program.
    pub(super) fn words(&self, words: &str) -> String {
        let set = |word: Word| match word {
            Word::Plain(words) => self.writer.words(words),
            Word::Renamed { tex, plain } => self.writer.symbol(tex, plain),
        };
        // A line does not end between a number and its sign.
        self.options.symbols.in_parts(&words.replace(" %", "\u{a0}%")).into_iter().map(set).collect()
    }

    /// A number of the program, with decimals as the language writes them.
    pub(super) fn numbers(&self, text: &str) -> String {
        self.words(&self.options.language.numbers(text))
    }

    /// A formula in the line.
    pub(super) fn formula(&self, tex: &str) -> String {
        self.writer.formula(&self.in_notation(tex))
    }

    /// A formula on a line of its own.
    pub(super) fn display(&mut self, tex: &str, number: Option<u32>) -> String {
        let label = number.and_then(|number| self.labels.label("eq", &number.to_string()));
        let tex = self.in_notation(tex);
        match label {
            Some(label) => self.writer.display(&format!("{tex} \\label{{{label}}}"), number),
            None => self.writer.display(&tex, number),
        }
    }

    /// What is exact, in TeX and as plain text.
    pub(super) fn exact(&self, tex: &str, plain: &str) -> String {
        let plain = self.options.language.numbers(plain);
        self.writer.exact(&self.in_notation(tex), &self.options.symbols.in_plain_words(&plain))
    }

    fn in_notation(&self, tex: &str) -> String {
        let renamed = match self.writer.reads_tex() {
            true => self.options.symbols.in_tex(tex),
            false => self.options.symbols.in_plain_formula(tex),
        };
        self.options.language.formula(&renamed)
    }

    /// A text without colours, as it is measured and searched.
    pub(super) fn plain(&self, text: &Text) -> String {
        plain(text, self.options)
    }

    /// The same with what a line is not broken at as one word: the formulas.
    pub(super) fn unbroken(&self, text: &Text) -> String {
        Composer::new(&Terminal { width: usize::MAX, colour: false, unbroken: true }, self.options).text(text)
    }
}

/// A text without colours, in the notation of some options.
pub(super) fn plain(text: &Text, options: &Options) -> String {
    Composer::new(&Terminal { width: usize::MAX, colour: false, unbroken: false }, options).text(text)
}
