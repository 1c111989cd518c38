//! `verify`: does every certificate of a file hold?

use std::io::Read;
use std::path::Path;

use crankstar::proof::{
    Document, OpenDocument, RemedyDocument, check_document, check_open_document, check_remedy_document,
};
use serde::Deserialize;
use serde::de::IgnoredAny;

use super::failure::Failure;
use super::write;

/// Checks a `classify --json` or `remedy --json` output.
pub fn run(file: &Path) -> Result<(), Failure> {
    let name = if file == Path::new("-") { "standard input".to_owned() } else { format!("`{}`", file.display()) };
    let mut json = Vec::new();
    let read = if file == Path::new("-") {
        std::io::stdin().read_to_end(&mut json)
    } else {
        std::fs::File::open(file).and_then(|mut file| file.read_to_end(&mut json))
    };
    read.map_err(|error| Failure::new(format!("cannot read {name}: {error}")))?;
    let no_output = |error| Failure::new(format!("{name} is no `classify --json` output: {error}"));
    let fault = |fault| Failure::new(format!("{name}: {fault}"));
    let (title, count) = if is_family(&json) {
        let document: OpenDocument = serde_json::from_slice(&json).map_err(no_output)?;
        let count = check_open_document(&document).map_err(fault)?;
        (document.title, count)
    } else if is_remedy(&json) {
        let document: RemedyDocument = serde_json::from_slice(&json).map_err(no_output)?;
        let count = check_remedy_document(&document).map_err(fault)?;
        (document.title, count)
    } else {
        let document: Document = serde_json::from_slice(&json).map_err(no_output)?;
        let count = check_document(&document).map_err(fault)?;
        (document.title, count)
    };
    write::to_stdout(&format!("{title}: all {count} certificates hold\n"))
}

/// The documents of families have a list of another name.
fn is_family(json: &[u8]) -> bool {
    #[derive(Deserialize)]
    struct Names {
        #[serde(rename = "open_verdicts")]
        _open_verdicts: IgnoredAny,
    }
    serde_json::from_slice::<Names>(json).is_ok()
}

/// Remedies have weights and sums instead of verdicts.
fn is_remedy(json: &[u8]) -> bool {
    #[derive(Deserialize)]
    struct Names {
        #[serde(rename = "remedied_orders")]
        _remedied_orders: IgnoredAny,
    }
    serde_json::from_slice::<Names>(json).is_ok()
}
