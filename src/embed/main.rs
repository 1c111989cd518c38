//! Build script: makes Rust of the words in `templates`, so that adding a language is adding a file, and mending a sentence asks for no Rust.

mod languages;
mod pages;

use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() {
    write("languages.rs", &languages::code(&listed("templates/words", ".toml")));
    let modules = listed("templates/pages", ".md").into_iter().map(|(name, path)| {
        let text = fs::read_to_string(&path).expect("the page is part of the package");
        pages::module(&name, &text).unwrap_or_else(|mistake| panic!("{}:{mistake}", path.display()))
    });
    write("pages.rs", &modules.collect::<String>());
}

/// The files of a folder that end so, by their names without the ending, sorted.
fn listed(folder: &str, ending: &str) -> Vec<(String, PathBuf)> {
    let folder = Path::new(&env::var("CARGO_MANIFEST_DIR").expect("cargo sets it")).join(folder);
    println!("cargo::rerun-if-changed={}", folder.display());
    let names = fs::read_dir(&folder).expect("the folder is part of the package");
    let names =
        names.filter_map(|entry| entry.ok()?.file_name().into_string().ok()?.strip_suffix(ending).map(str::to_owned));
    let mut files: Vec<_> = names.map(|name| (name.clone(), folder.join(format!("{name}{ending}")))).collect();
    files.sort();
    files
}

fn write(name: &str, code: &str) {
    let target = Path::new(&env::var("OUT_DIR").expect("cargo sets it")).join(name);
    fs::write(target, code).expect("OUT_DIR can be written");
}
