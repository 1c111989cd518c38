//! How does a page of `templates/pages` become a document? Line by line; what is empty is left out.

use super::{Block, Document, Picture, Text};

/// What stands in a place for blocks.
#[derive(Debug, Default)]
pub struct Blocks(Vec<Block>);

/// What stands in a place for items of a list, or for remarks.
#[derive(Debug, Default)]
pub struct Items(Vec<Text>);

impl<B: Into<Block>> From<B> for Blocks {
    fn from(block: B) -> Self {
        Blocks(vec![block.into()])
    }
}

impl<B: Into<Block>> From<Option<B>> for Blocks {
    fn from(block: Option<B>) -> Self {
        block.into_iter().collect()
    }
}

impl From<Vec<Block>> for Blocks {
    fn from(blocks: Vec<Block>) -> Self {
        Blocks(blocks)
    }
}

/// No picture is no block.
impl From<Vec<Picture>> for Blocks {
    fn from(pictures: Vec<Picture>) -> Self {
        Blocks(if pictures.is_empty() { Vec::new() } else { vec![Block::Pictures(pictures)] })
    }
}

impl<B: Into<Block>> FromIterator<B> for Blocks {
    fn from_iter<I: IntoIterator<Item = B>>(blocks: I) -> Self {
        Blocks(blocks.into_iter().map(Into::into).collect())
    }
}

impl<T: Into<Text>, I: IntoIterator<Item = T>> From<I> for Items {
    fn from(items: I) -> Self {
        Items(items.into_iter().map(Into::into).collect())
    }
}

/// A page that is being filled.
pub struct Skeleton {
    document: Document,
    /// The sections that a heading begins and none has ended, the outer one first.
    open: Vec<Section>,
}

/// Where a section begins, and what its places for blocks hold.
struct Section {
    level: u8,
    begin: usize,
    has_places: bool,
    is_filled: bool,
}

impl Skeleton {
    pub fn new(name: &'static str, title: Text) -> Self {
        Skeleton { document: Document::new(name, title), open: Vec::new() }
    }

    pub fn section(&mut self, heading: Text) {
        self.heading(1, heading);
    }

    pub fn subsection(&mut self, heading: Text) {
        self.heading(2, heading);
    }

    fn heading(&mut self, level: u8, heading: Text) {
        self.close(level);
        self.open.push(Section { level, begin: self.document.blocks.len(), has_places: false, is_filled: false });
        self.document.push(Block::Heading(level, heading));
    }

    /// Ends the sections down to this level: one whose places are all empty is left out.
    fn close(&mut self, level: u8) {
        while let Some(section) = self.open.pop_if(|section| section.level >= level) {
            if section.has_places && !section.is_filled {
                self.document.blocks.truncate(section.begin);
            }
        }
    }

    pub fn paragraph(&mut self, text: Text) {
        if !text.lacks_a_value() {
            self.document.push(text);
        }
    }

    pub fn notes(&mut self, notes: Items) {
        let said = notes.0.into_iter().filter(|text| !text.lacks_a_value());
        self.document.blocks.extend(said.map(Block::Note));
    }

    /// Items go to the list before them.
    pub fn items(&mut self, items: Items) {
        let said: Vec<Text> = items.0.into_iter().filter(|text| !text.lacks_a_value()).collect();
        match self.document.blocks.last_mut() {
            Some(Block::List(list)) => list.extend(said),
            _ if said.is_empty() => {}
            _ => self.document.push(Block::List(said)),
        }
    }

    pub fn blocks(&mut self, blocks: Blocks) {
        let is_filled = !blocks.0.is_empty();
        self.open.iter_mut().for_each(|section| {
            section.has_places = true;
            section.is_filled |= is_filled;
        });
        self.document.blocks.extend(blocks.0);
    }

    pub fn done(mut self) -> Document {
        self.close(0);
        self.document
    }
}
