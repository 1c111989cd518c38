//! How does a section made of blocks stand in a report whose template takes strings? It goes when reports are documents.

use super::dialect::Dialect;
use crate::page::{Block, Document, Format, Math, Options, Text, write};

/// The blocks in a dialect; what is folded is unfolded.
pub(super) fn in_dialect(blocks: Vec<Block>, dialect: Dialect) -> String {
    let mut section = Document::new("section", Text::default());
    section.blocks = blocks.into_iter().flat_map(unfolded).collect();
    let format = match dialect {
        Dialect::GithubMarkdown => Format::GITHUB,
        Dialect::DollarMarkdown => Format::Markdown(Math::Dollars),
        Dialect::Latex => Format::Latex,
    };
    let files = write(&section, format, &Options { fragment: true, stamp: None });
    let text = files.into_iter().next().map_or_else(String::new, |file| file.text);
    match dialect {
        Dialect::Latex => text,
        // Without the title.
        Dialect::GithubMarkdown | Dialect::DollarMarkdown => text.trim_start_matches('#').trim_start().to_owned(),
    }
}

fn unfolded(block: Block) -> Vec<Block> {
    match block {
        Block::Folded(fold) => {
            let inside = fold.blocks.into_iter().flat_map(unfolded);
            [Block::Heading(2, fold.summary)].into_iter().chain(inside).collect()
        }
        Block::Heading(..)
        | Block::Paragraph(_)
        | Block::Answer(_)
        | Block::Table(_)
        | Block::Pictures(_)
        | Block::Formula(..)
        | Block::List(_)
        | Block::Note(_)
        | Block::Verbatim(..) => vec![block],
    }
}
