//! What is a page made of, and how is it written? A document of blocks, and one writer per format.
//!
//! `document (blocks of words, values, tables, pictures) → writer (templates, escapes) → files`
//!
//! A question makes a [`Document`] and knows nothing of formats; a writer knows nothing of engines. Whether a number is zero, exact or
//! a decimal, and whether words are the program's or a person's, is said by types ([`Piece`], [`Number`]), never read back from text.
//! A format is a folder of templates and one file of escapes: [`Format`] names it, and the compiler lists the rest. A language is one
//! list of words: [`Language`] names it.

mod block;
pub mod figure;
mod language;
mod markup;
pub mod number;
pub mod plot;
mod skeleton;
mod svg;
mod symbols;
mod text;
mod tikz;
mod unit;
mod write;

pub use crate::table::Unit;
pub use block::{Block, Columns, Document, Fold, Live, Moving, Picture, Table};
pub use language::Language;
pub use number::{Figures, Number};
pub(crate) use skeleton::{Blocks, Items, Skeleton};
pub use svg::svg;
pub use symbols::Symbols;
pub(crate) use text::phrase;
pub use text::{Choice, Piece, Setting, Text};
pub use tikz::tikz;
pub use unit::Units;
pub(crate) use write::say;
pub use write::{Alone, File, Format, Math, Options, blocks_in, text_in, wrapped, write};
