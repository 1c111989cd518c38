//! `list`: which engines are known by name?

use crankstar::engine;
use crankstar::file;
use crankstar::text::Format;

use super::failure::Failure;
use super::write;

/// Prints the catalogue, one line per engine: name, number of cylinders, title.
pub fn run() -> Result<(), Failure> {
    let engines = file::catalogue()?;
    let widest = engines.iter().map(|(entry, _)| entry.name.len()).max().unwrap_or(0);
    let line = |(entry, engine): &(file::Entry, engine::Engine)| {
        format!("{:widest$}  {:2}  {}\n", entry.name, engine.cylinders().len(), engine.title().escaped(Format::Plain))
    };
    write::to_stdout(&engines.iter().map(line).collect::<String>())
}
