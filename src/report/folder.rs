//! Of which files is a page made?

pub use crate::page::File;
