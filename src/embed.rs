//! Build script: lists the words of each language, so that adding a language is adding a file.

use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() {
    write("languages.rs", &languages(&listed("templates/words")));
}

/// The TOML files of a folder by their names, sorted.
fn listed(folder: &str) -> Vec<(String, PathBuf)> {
    let folder = Path::new(&env::var("CARGO_MANIFEST_DIR").expect("cargo sets it")).join(folder);
    println!("cargo::rerun-if-changed={}", folder.display());
    let names = fs::read_dir(&folder).expect("the folder is part of the package");
    let names =
        names.filter_map(|entry| entry.ok()?.file_name().into_string().ok()?.strip_suffix(".toml").map(str::to_owned));
    let mut files: Vec<_> = names.map(|name| (name.clone(), folder.join(format!("{name}.toml")))).collect();
    files.sort();
    files
}

/// `enum Language`, English first, with the code, the name and the list of each.
fn languages(lists: &[(String, PathBuf)]) -> String {
    let mut lists: Vec<_> = lists.iter().collect();
    lists.sort_by_key(|(code, _)| code != "en");
    let (mut variants, mut all, mut files) = (String::new(), String::new(), String::new());
    for (code, path) in &lists {
        let text = fs::read_to_string(path).expect("the list is part of the package");
        let name = text.lines().find_map(|line| line.strip_prefix("name = \"")?.strip_suffix('"'));
        let name = name.unwrap_or_else(|| panic!("{}: it has no line `name = \"…\"`", path.display()));
        let variant = code[..1].to_uppercase() + &code[1..].replace('-', "");
        let default = if all.is_empty() { "#[default]\n" } else { "" };
        variants += &format!("/// {name}.\n{default}{variant},\n");
        all += &format!("Language::{variant}, ");
        files += &format!("({code:?}, {name:?}, include_str!({path:?})),\n");
    }
    let count = lists.len();
    format!(
        "/// A language of pages.\n#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]\n#[non_exhaustive]\npub enum Language {{\n{variants}}}\n\
         impl Language {{\n/// Every language, English first.\npub const ALL: [Language; {count}] = [{all}];\n}}\n\
         /// Code, name and list of each.\nconst FILES: [(&str, &str, &str); {count}] = [\n{files}];\n"
    )
}

fn write(name: &str, code: &str) {
    let target = Path::new(&env::var("OUT_DIR").expect("cargo sets it")).join(name);
    fs::write(target, code).expect("OUT_DIR can be written");
}
