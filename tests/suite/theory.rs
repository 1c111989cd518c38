//! Can every citation of the theory be followed? `docs/theory.md` has the sections that comments name, in order.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Sources and pages below a folder.
fn texts(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let is_text = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "rs" || ending == "md");
    let nested = folders.iter().flat_map(|folder| texts(folder));
    files.into_iter().filter(is_text).chain(nested).collect()
}

/// The numbers behind `theory, section`, however the lines of a comment break: `3`, `3 and 9`, `3, 7`.
fn cited(text: &str) -> Vec<u32> {
    let line = |line: &str| line.trim().trim_start_matches(['/', '!']).trim().to_owned();
    let joined = text.lines().map(line).collect::<Vec<_>>().join(" ").to_lowercase();
    let numbers = |after: &str| {
        let words = after
            .strip_prefix('s')
            .unwrap_or(after)
            .split([' ', ','])
            .filter(|word| !word.is_empty() && *word != "and");
        let number = |word: &str| word.trim_end_matches(|letter: char| !letter.is_ascii_digit()).parse().ok();
        words.map_while(number).collect::<Vec<u32>>()
    };
    joined.split("theory, section").skip(1).flat_map(numbers).collect()
}

/// The numbers of the headings `## 3. …`.
fn sections() -> Vec<u32> {
    let theory = fs::read_to_string(root().join("docs/theory.md")).expect("the theory");
    let number = |line: &str| line.strip_prefix("## ")?.split_once(". ")?.0.parse().ok();
    theory.lines().filter_map(number).collect()
}

#[test]
fn citations_are_read_across_lines() {
    assert_eq!(cited("//! so (theory, section\n//! 8) and\n/// Theory, section 3: x\n"), [8, 3]);
    assert_eq!(
        cited("(theory, sections 3 and 9), (theory, section 4; de Bruijn 1953), theory, sections 2, 7.\n"),
        [3, 9, 4, 2, 7]
    );
}

#[test]
fn every_section_that_is_cited_is_written() {
    let sections = sections();
    assert_eq!(sections, (1..=sections.last().copied().unwrap_or(0)).collect::<Vec<_>>());
    let mut count = 0;
    for file in ["src", "tests", "benches"].iter().flat_map(|folder| texts(&root().join(folder))) {
        for number in cited(&fs::read_to_string(&file).expect("a text")) {
            assert!(
                sections.contains(&number),
                "{} cites section {number}, which docs/theory.md has not",
                file.display()
            );
            count += 1;
        }
    }
    assert!(count > 40, "only {count} citations were found: the reader of citations is broken");
}

#[test]
fn every_formula_is_closed() {
    let theory = fs::read_to_string(root().join("docs/theory.md")).expect("the theory");
    assert_eq!(theory.matches("$`").count(), theory.matches("`$").count());
    let fences: BTreeSet<&str> = theory.lines().filter(|line| line.starts_with("```")).collect();
    assert_eq!(fences, BTreeSet::from(["```", "```math"]));
    assert_eq!(theory.lines().filter(|line| line.starts_with("```")).count() % 2, 0);
    assert!(
        theory.lines().all(|line| line.matches("$`").count() == line.matches("`$").count()),
        "a formula breaks over lines"
    );
}
