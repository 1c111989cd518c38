//! Does CITATION.cff name the program that this is, and is its version one?

use std::fs;

#[test]
fn the_citation_has_name_version_and_licences_of_the_package() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/CITATION.cff");
    let citation = fs::read_to_string(path).expect("a file");
    let value = |key: &str| citation.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(": "));
    assert_eq!(value("title"), Some(env!("CARGO_PKG_NAME")));
    assert_eq!(value("version"), Some(env!("CARGO_PKG_VERSION")));
    assert_eq!(value("type"), Some("software"));
    assert_eq!(value("abstract").map(|words| words.trim_end_matches('.')), Some(env!("CARGO_PKG_DESCRIPTION")));
    let licences: Vec<&str> = env!("CARGO_PKG_LICENSE").split(" OR ").collect();
    let listed = citation.split("license:\n").nth(1).expect("licences").lines();
    let listed: Vec<&str> = listed.map_while(|line| line.strip_prefix("  - ")).collect();
    assert_eq!(listed, licences);
    assert!(!citation.contains("date"), "a date goes out of date");
}

/// The changelog, both lock files, the citation and the package of Python.
#[test]
fn the_version_is_one() {
    let text = |file: &str| {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
        fs::read_to_string(path).unwrap_or_else(|error| panic!("{file}: {error}"))
    };
    let version = env!("CARGO_PKG_VERSION");
    let changes = text("CHANGELOG.md");
    let newest = changes.lines().find_map(|line| line.strip_prefix("## "));
    assert_eq!(newest, Some(version), "the changelog");
    for lock in ["Cargo.lock", "fuzz/Cargo.lock"] {
        assert!(text(lock).contains(&format!("name = \"crankstar\"\nversion = \"{version}\"\n")), "{lock}");
    }
    for crate_of_it in ["Cargo.toml", "src/kernel/Cargo.toml"] {
        assert!(text(crate_of_it).contains(&format!("\nversion = \"{version}\"\n")), "{crate_of_it}");
    }
    assert!(text("Cargo.toml").contains(&format!("crankstar-kernel = {{ version = \"={version}\", path")));
    assert!(text("CITATION.cff").contains(&format!("\nversion: {version}\n")));
    let package = text("pyproject.toml");
    assert!(package.contains("dynamic = [\"version\"]") && !package.lines().any(|line| line.starts_with("version")));
}
