//! Which languages are there? One for each list of words.

use std::fs;
use std::path::PathBuf;

/// `enum Language`, English first, with the code, the name and the list of each.
pub fn code(lists: &[(String, PathBuf)]) -> String {
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
