//! Build script: lists the layout files of the catalogue, so that adding an engine is adding a file.

use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() {
    let folder = Path::new(&env::var("CARGO_MANIFEST_DIR").expect("cargo sets it")).join("file/catalogue");
    println!("cargo::rerun-if-changed={}", folder.display());
    let entries = engines(&folder)
        .into_iter()
        .map(|(name, path)| format!("Entry {{ name: {name:?}, text: include_str!({path:?}) }},\n"));
    let code = format!("const ENTRIES: &[Entry] = &[\n{}];\n", entries.collect::<String>());
    let target = Path::new(&env::var("OUT_DIR").expect("cargo sets it")).join("catalogue.rs");
    fs::write(target, code).expect("OUT_DIR can be written");
}

/// The TOML files of a folder by their names, sorted.
fn engines(folder: &Path) -> Vec<(String, PathBuf)> {
    let names = fs::read_dir(folder).expect("the folder is part of the package");
    let names =
        names.filter_map(|entry| entry.ok()?.file_name().into_string().ok()?.strip_suffix(".toml").map(str::to_owned));
    let mut files: Vec<_> = names.map(|name| (name.clone(), folder.join(format!("{name}.toml")))).collect();
    files.sort();
    files
}
