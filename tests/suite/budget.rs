//! Does no room grow unnoticed? Each has this many lines of Rust and no more.
//!
//! Who needs more lines in a room makes fewer of others first; a higher budget needs a reason, which its commit tells.

use std::fs;
use std::path::Path;

use crate::support::rooms;

/// The rooms with their lines: what they have, and a little.
const BUDGET: [(&str, usize); 35] = [
    ("accuracy", 1690),
    ("beam", 340),
    ("claim", 5140),
    ("classroom", 1790),
    ("cli", 4985),
    ("engine", 4215),
    ("exact", 1710),
    ("family", 4160),
    ("file", 8540),
    ("firing", 440),
    ("flywheel", 520),
    ("gas", 1140),
    ("journal", 1470),
    ("loads", 2370),
    ("motion", 2310),
    ("mounts", 520),
    ("numbers", 2160),
    ("optimise", 1590),
    ("order", 1930),
    ("page", 6990),
    ("proof", 8950),
    ("python", 2680),
    ("remedy", 1905),
    ("report", 34995),
    ("rotor", 680),
    ("search", 3800),
    ("shard", 680),
    ("stars", 670),
    ("sweep", 2120),
    ("table", 1420),
    ("text", 490),
    ("torque", 1255),
    ("torsion", 890),
    ("verdict", 1930),
    ("web", 890),
];

/// Lines of Rust in a folder.
fn lines(folder: &Path) -> usize {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let of = |path: &Path| match path.extension().is_some_and(|ending| ending == "rs") {
        true => fs::read_to_string(path).expect("a source file").lines().count(),
        false => 0,
    };
    entries.map(|path| if path.is_dir() { lines(&path) } else { of(&path) }).sum()
}

#[test]
fn no_room_has_more_lines_than_its_budget() {
    for room in rooms::folders() {
        let name = rooms::name(&room);
        let budget = BUDGET.iter().find(|(known, _)| *known == name);
        let (_, budget) = budget.unwrap_or_else(|| panic!("`{name}` has no budget"));
        let lines = lines(&room);
        assert!(lines <= *budget, "`{name}` has {lines} lines, {budget} are its budget: a raise needs a reason");
        assert!(10 * lines > 9 * budget, "`{name}` has {lines} lines: lower its budget of {budget}");
    }
}
