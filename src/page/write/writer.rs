//! What has a format to know?

use super::super::Unit;
use super::super::block::Picture;
use super::columns::Cells;
use super::templates::Set;

/// A file to be written: its name inside the folder, and its text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Name inside the folder.
    pub name: String,
    /// What it holds.
    pub text: String,
}

/// What a format has to know: its signs, and where its templates are.
pub(super) trait Writer {
    /// The ending of its files.
    fn ending(&self) -> &'static str;
    /// Its templates.
    fn templates(&self) -> &'static Set;
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
    /// Words that lead to a file, or to `#` and the name of a heading; in print and on a terminal a file leads nowhere.
    fn link(&self, inside: &str, _target: &str) -> String {
        inside.to_owned()
    }
    /// A line of a file as it stands: nothing in it is markup.
    fn line(&self, line: &str) -> String;
    /// A picture: what is in the text, and the file beside it if there is one.
    fn picture(&self, picture: &Picture, caption: &str) -> (String, Option<File>);
    /// A table whole, where one template cannot set it: in print it has to fit the page.
    fn table(&self, table: &Cells) -> Option<String> {
        self.is_print().then(|| table.printed(self.templates()))
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
    /// Whether it is for print: tables fit the page, and what is folded is at the end.
    fn is_print(&self) -> bool {
        false
    }
}
