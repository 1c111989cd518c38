//! `verify`: does every certificate of a file hold?

use std::io::Read;
use std::path::Path;

use crankstar::proof::{Document, check_document};

use super::failure::Failure;
use super::write;

/// Checks a `classify --json` output.
pub fn run(file: &Path) -> Result<(), Failure> {
    let name = if file == Path::new("-") { "standard input".to_owned() } else { format!("`{}`", file.display()) };
    let mut json = Vec::new();
    let read = if file == Path::new("-") {
        std::io::stdin().read_to_end(&mut json)
    } else {
        std::fs::File::open(file).and_then(|mut file| file.read_to_end(&mut json))
    };
    read.map_err(|error| Failure::new(format!("cannot read {name}: {error}")))?;
    let document: Document = serde_json::from_slice(&json)
        .map_err(|error| Failure::new(format!("{name} is no `classify --json` output: {error}")))?;
    let count = check_document(&document).map_err(|fault| Failure::new(format!("{name}: {fault}")))?;
    write::to_stdout(&format!("{}: all {count} certificates hold\n", document.title))
}
