//! What do the texts in `templates/pages` say? Read by the build script's own reader.

use std::fs;
use std::path::Path;

use super::german::quoted;

#[path = "../../../src/embed/pages.rs"]
mod pages;

pub use pages::module;

/// The phrases of a text, with bare or numbered places.
pub fn said(text: &str) -> Vec<String> {
    let code = module("a-page", text).expect("the build has read it");
    code.split("Text::phrase(").skip(1).filter_map(|call| quoted(call).into_iter().next()).collect()
}

/// The texts of pages by their names, with what each says.
pub fn all() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("templates/pages");
    let files = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    files
        .map(|path| {
            let name = path.file_stem().and_then(|name| name.to_str()).expect("a name").to_owned();
            (name, fs::read_to_string(&path).expect("a text"))
        })
        .collect()
}
