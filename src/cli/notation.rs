//! `--symbols`: what does the reader call the symbols?

use std::path::PathBuf;

use crankstar::page::Symbols;

use super::failure::Failure;
use super::layouts;

/// The argument.
#[derive(clap::Args)]
pub struct Notation {
    /// A TOML file with your names of symbols: [symbols] beta = "\\chi", c_k = "a_k", …
    #[arg(long, value_name = "FILE")]
    symbols: Option<PathBuf>,
}

impl Notation {
    /// Whether a file is named.
    pub fn is_given(&self) -> bool {
        self.symbols.is_some()
    }

    /// The names that the reader gives; none without a file.
    pub fn read(&self) -> Result<Symbols, Failure> {
        let Some(path) = &self.symbols else { return Ok(Symbols::default()) };
        Ok(Symbols::read(&layouts::shown(path), &layouts::read_text(path)?)?)
    }
}
