//! Does every room import only rooms to its left on the arrow line?

use std::fs;
use std::path::{Path, PathBuf};

const ROOMS: [&str; 19] = [
    "proof", "exact", "text", "layout", "phasor", "verdict", "numbers", "motion", "beam", "loads", "accuracy",
    "remedy", "optimise", "search", "family", "sweep", "claim", "report", "cli",
];

fn source_files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("the folder of a room").map(|entry| entry.expect("an entry").path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let nested = folders.iter().flat_map(|folder| source_files(folder));
    files.into_iter().filter(|path| path.extension().is_some_and(|ending| ending == "rs")).chain(nested).collect()
}

/// Names that follow `crate::` or `crankstar::` in a file, without its comments.
fn imported_rooms(text: &str) -> Vec<String> {
    let code = text.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n");
    let after = |prefix: &str| {
        let pieces: Vec<String> = code.split(prefix).skip(1).map(str::to_owned).collect();
        pieces
            .into_iter()
            .map(|piece| piece.chars().take_while(|letter| letter.is_ascii_lowercase()).collect::<String>())
    };
    after("crate::").chain(after("crankstar::")).filter(|name| ROOMS.contains(&name.as_str())).collect()
}

#[test]
fn every_import_points_to_the_left() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut imports = 0;
    for (place, room) in ROOMS.iter().enumerate() {
        for file in source_files(&source.join(room)) {
            for imported in imported_rooms(&fs::read_to_string(&file).expect("a source file")) {
                let is_left = ROOMS[..=place].contains(&imported.as_str());
                assert!(is_left, "{} imports {imported}, which is not left of {room}", file.display());
                imports += 1;
            }
        }
    }
    assert!(imports > 40, "only {imports} imports were found: the reader of imports is broken");
}

#[test]
fn the_checker_imports_nothing_of_the_solver() {
    let room = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/proof");
    for file in source_files(&room) {
        let imported = imported_rooms(&fs::read_to_string(&file).expect("a source file"));
        assert!(imported.iter().all(|name| name == "proof"), "{} imports {imported:?}", file.display());
    }
}

#[test]
fn library_and_readme_state_the_arrow_line() {
    let line = format!("`{}`", ROOMS.join(" ← "));
    for file in ["src/lib.rs", "README.md"] {
        let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).expect("a text");
        assert!(text.contains(&line), "{file} does not state {line}");
    }
}

#[test]
fn there_is_no_other_room() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let folders = fs::read_dir(source).expect("src").map(|entry| entry.expect("an entry").path());
    for folder in folders.filter(|path| path.is_dir()) {
        let name = folder.file_name().expect("a name").to_string_lossy().into_owned();
        assert!(ROOMS.contains(&name.as_str()), "{name} has no place on the arrow line");
    }
}
