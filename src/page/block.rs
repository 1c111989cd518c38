//! Of which blocks is a document made?

use std::fmt;
use std::sync::Arc;

use super::figure::Figure;
use super::text::Text;
use super::{Language, Units};
use crate::text::Untrusted;

/// What a question answers with, in no format yet.
#[derive(Clone, Debug)]
pub struct Document {
    /// The name of its main file, without the ending.
    pub name: &'static str,
    /// The title.
    pub title: Text,
    /// Whether a list of its headings stands before the first of them.
    pub has_contents: bool,
    /// What is on it, in order.
    pub blocks: Vec<Block>,
}

impl Document {
    /// An empty document.
    pub fn new(name: &'static str, title: impl Into<Text>) -> Self {
        Document { name, title: title.into(), has_contents: false, blocks: Vec::new() }
    }

    /// With one more block.
    pub fn push(&mut self, block: impl Into<Block>) {
        self.blocks.push(block.into());
    }

    /// With one more section: its heading, and what stands first below it.
    pub fn section(&mut self, heading: impl Into<Text>, block: impl Into<Block>) {
        self.push(Block::Heading(1, heading.into()));
        self.push(block);
    }

    /// All its pictures, those on folds too, in order.
    pub fn pictures(&self) -> Vec<&Picture> {
        let pictures = unfolded(&self.blocks).into_iter().filter_map(|block| match block {
            Block::Pictures(drawn) => Some(drawn),
            _ => None,
        });
        pictures.flatten().collect()
    }
}

/// The blocks with those on folds, in order.
fn unfolded(blocks: &[Block]) -> Vec<&Block> {
    let mut all = Vec::new();
    for block in blocks {
        match block {
            Block::Folded(fold) => all.extend(unfolded(&fold.blocks)),
            other => all.push(other),
        }
    }
    all
}

/// A part of a document.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Block {
    /// A heading: 1 of a section, 2 below it.
    Heading(u8, Text),
    /// A paragraph.
    Paragraph(Text),
    /// The answer, before all else: a few paragraphs in a box.
    Answer(Vec<Text>),
    /// A table.
    Table(Table),
    /// Pictures beside each other.
    Pictures(Vec<Picture>),
    /// A formula on a line of its own, in TeX, with its number where it has one.
    Formula(String, Option<u32>),
    /// A list.
    List(Vec<Text>),
    /// What only some readers want: closed on a screen, at the end in print.
    Folded(Fold),
    /// A small remark.
    Note(Text),
    /// What only a browser shows.
    Live(Live),
    /// A person's file as it stands, in a language.
    Verbatim(&'static str, Untrusted),
}

impl Block {
    /// Blocks that only some readers want, below what is on the fold.
    pub fn folded(summary: impl Into<Text>, blocks: Vec<Block>) -> Self {
        Block::Folded(Fold { summary: summary.into(), blocks })
    }
}

/// What a page shows that moves, in HTML.
pub trait Moving: fmt::Debug {
    /// The part itself, finished.
    fn body(&self, language: Language) -> String;
}

/// A part in HTML that moves by a script; formats without scripts leave it out.
#[derive(Clone, Debug)]
pub struct Live {
    /// The part itself.
    pub part: Arc<dyn Moving + Send + Sync>,
    /// What it looks like: once on a page.
    pub style: &'static str,
    /// What moves it: once on a page.
    pub script: &'static str,
}

/// What is folded, and what is on the fold.
#[derive(Clone, Debug)]
pub struct Fold {
    /// On the fold.
    pub summary: Text,
    /// Inside.
    pub blocks: Vec<Block>,
}

/// A table: every row has as many cells as the header.
#[derive(Clone, Debug, Default)]
pub struct Table {
    /// Headings of the columns.
    pub header: Vec<Text>,
    /// The cells.
    pub rows: Vec<Vec<Text>>,
}

impl Table {
    /// An empty table with these headings.
    pub fn new<T: Into<Text>>(header: impl IntoIterator<Item = T>) -> Self {
        Table { header: header.into_iter().map(Into::into).collect(), rows: Vec::new() }
    }

    /// A table with a row for each of these, to be filled a column at a time.
    pub fn of<R>(rows: impl IntoIterator<Item = R>) -> Columns<R> {
        let of: Vec<R> = rows.into_iter().collect();
        Columns { table: Table { header: Vec::new(), rows: vec![Vec::new(); of.len()] }, of }
    }

    /// With one more row.
    pub fn push(&mut self, row: Vec<Text>) {
        assert_eq!(row.len(), self.header.len(), "a row of another width");
        self.rows.push(row);
    }
}

/// A table that is filled a column at a time, and what its rows are about.
pub struct Columns<R> {
    of: Vec<R>,
    table: Table,
}

impl<R> Columns<R> {
    /// With one more column: its heading, and its cell in each row.
    pub fn column<T: Into<Text>>(mut self, heading: impl Into<Text>, cell: impl Fn(&R) -> T) -> Self {
        self.table.header.push(heading.into());
        self.table.rows.iter_mut().zip(&self.of).for_each(|(row, of)| row.push(cell(of).into()));
        self
    }

    /// The same where the table has this column.
    pub fn column_if<T: Into<Text>>(self, has: bool, heading: impl Into<Text>, cell: impl Fn(&R) -> T) -> Self {
        if has { self.column(heading, cell) } else { self }
    }

    /// The table.
    pub fn done(self) -> Table {
        self.table
    }

    /// The table; none where it has no rows.
    pub fn done_if_any(self) -> Option<Table> {
        (!self.of.is_empty()).then_some(self.table)
    }
}

/// A drawing with the words below it.
#[derive(Clone, Debug)]
pub struct Picture {
    /// The name of its file, without the ending.
    pub name: String,
    /// What a reader sees below it: what colours and signs mean.
    pub caption: Text,
    /// The drawing.
    pub figure: Figure,
}

impl Picture {
    /// A drawing with the name of its file and the words below it.
    pub fn new(name: impl Into<String>, caption: impl Into<Text>, figure: Figure) -> Self {
        Picture { name: name.into(), caption: caption.into(), figure }
    }

    /// The same counted in these units.
    pub(super) fn counted_in(&self, units: Units) -> Picture {
        match (&self.figure.in_inches, units) {
            (Some(figure), Units::Inch) => Picture { figure: figure.as_ref().clone(), ..self.clone() },
            (_, Units::Inch | Units::Si) => self.clone(),
        }
    }
}

/// Whether some of these have formulas on lines of their own.
pub(super) fn in_si_units(blocks: &[Block]) -> bool {
    unfolded(blocks).into_iter().any(|block| matches!(block, Block::Formula(..)))
}

/// A text by itself is a paragraph.
impl From<Text> for Block {
    fn from(text: Text) -> Self {
        Block::Paragraph(text)
    }
}

impl From<&'static str> for Block {
    fn from(words: &'static str) -> Self {
        Block::Paragraph(words.into())
    }
}

impl From<Table> for Block {
    fn from(table: Table) -> Self {
        Block::Table(table)
    }
}

impl From<Picture> for Block {
    fn from(picture: Picture) -> Self {
        Block::Pictures(vec![picture])
    }
}

impl Language {
    /// A picture whose drawing has its words in the language; its caption is a text as others.
    pub fn picture(self, picture: &Picture) -> Picture {
        let mut out = picture.clone();
        if self == Language::En {
            return out;
        }
        for (text, prose) in out.figure.texts_mut() {
            *text = self.signs(text);
            if let Some(prose) = prose.and_then(Option::as_mut) {
                *prose = self.prose(prose);
            }
        }
        out.figure = out.figure.with_room_for_texts();
        out
    }
}
