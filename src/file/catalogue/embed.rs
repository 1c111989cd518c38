//! Build script: lists the layout files beside it, so that adding an engine is adding a file.

use std::path::Path;
use std::{env, fs};

fn main() {
    let folder = Path::new(&env::var("CARGO_MANIFEST_DIR").expect("cargo sets it")).join("src/file/catalogue");
    println!("cargo::rerun-if-changed={}", folder.display());
    let mut names: Vec<String> = fs::read_dir(&folder)
        .expect("the catalogue folder is part of the package")
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok()?.strip_suffix(".toml").map(str::to_owned))
        .collect();
    names.sort();
    let entries = names.iter().map(|name| {
        let path = folder.join(format!("{name}.toml"));
        format!("Entry {{ name: {name:?}, text: include_str!({path:?}) }},\n")
    });
    let list = format!("const ENTRIES: &[Entry] = &[\n{}];\n", entries.collect::<String>());
    let target = Path::new(&env::var("OUT_DIR").expect("cargo sets it")).join("catalogue.rs");
    fs::write(target, list).expect("OUT_DIR can be written");
}
