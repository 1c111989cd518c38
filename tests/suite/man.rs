//! Do the pages of the manual name every command and option, and keep the lines of the examples?

use std::fs;
use std::path::Path;

use crate::support::program::{call, scratch};

/// The options that the help of a command lists.
fn options(command: &str) -> Vec<String> {
    let help = call(&[command, "-h"]).stdout;
    let help = String::from_utf8(help).expect("a text");
    let lines = help.lines().map(str::trim_start).filter(|line| line.starts_with("--"));
    lines.filter_map(|line| line.split_whitespace().next()).map(str::to_owned).collect()
}

fn page(folder: &Path, name: &str) -> String {
    let page = fs::read_to_string(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    // A hyphen is escaped for readers of manuals.
    page.replace("\\-", "-")
}

fn manual(name: &str) -> std::path::PathBuf {
    let folder = scratch(name).join("man");
    let told = call(&["man", folder.to_str().expect("a path")]);
    assert!(told.status.success(), "{}", String::from_utf8_lossy(&told.stderr));
    folder
}

#[test]
fn the_manual_has_a_page_for_each_command_that_names_every_option() {
    let folder = manual("man-options");
    let program = page(&folder, "crankstar.1");
    let pages = fs::read_dir(&folder).expect("a folder").count();
    let commands: Vec<String> = fs::read_dir(&folder)
        .expect("a folder")
        .filter_map(|entry| entry.expect("an entry").file_name().into_string().ok())
        .filter_map(|name| Some(name.strip_prefix("crankstar-")?.strip_suffix(".1")?.to_owned()))
        .collect();
    assert!(pages == commands.len() + 1 && pages > 20, "{pages} pages, {commands:?}");
    let help = String::from_utf8(call(&["--help"]).stdout).expect("a text");
    let mut found = 0;
    for command in &commands {
        assert!(help.contains(&format!("  {command} ")), "{command} is not a command");
        assert!(program.contains(&format!("crankstar-{command}(1)")), "{command} is not on the page of the program");
        let text = page(&folder, &format!("crankstar-{command}.1"));
        assert!(text.contains(".TH ") && text.contains(".SH SYNOPSIS"), "{text}");
        for option in options(command) {
            assert!(text.contains(&option), "{option} of {command}");
            found += 1;
        }
    }
    assert!(found > 80, "only {found} options were found");
}

#[test]
fn the_manual_keeps_the_lines_of_the_examples() {
    let program = page(&manual("man-examples"), "crankstar.1");
    let (_, examples) = program.split_once(".SH EXAMPLES\n.nf\n").expect("examples");
    let (examples, after) = examples.split_once("\n.fi\n").expect("their end");
    assert!(examples.lines().any(|line| line.trim_start().starts_with("crankstar classify I4 --json")), "{examples}");
    assert!(!examples.contains(".SH") && after.contains(".SH VERSION"), "{after}");
}

#[test]
fn the_manual_tells_that_its_folder_is_a_file() {
    let file = scratch("man-file").join("man");
    fs::create_dir_all(file.parent().expect("a folder")).expect("a folder");
    fs::write(&file, "mine").expect("a file");
    let told = call(&["man", file.to_str().expect("a path")]);
    assert_eq!(told.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&told.stderr).contains("is a file"), "{told:?}");
    assert_eq!(fs::read_to_string(&file).expect("a file"), "mine");
}
