//! Does no room grow unnoticed? Each has this many lines of Rust and no more.
//!
//! Who needs more lines in a room makes fewer of others first; a higher budget needs a reason, which its commit tells.

use std::fs;
use std::path::Path;

use crate::support::rooms;

/// The rooms with their lines: what they have, and a little.
const BUDGET: [(&str, usize); 35] = [
    ("accuracy", 1660),
    ("beam", 330),
    ("claim", 5500),
    ("classroom", 1770),
    ("cli", 5260),
    ("engine", 4305),
    ("exact", 1765),
    ("family", 3890),
    ("file", 8610),
    ("firing", 405),
    ("flywheel", 520),
    ("gas", 1090),
    ("journal", 1470),
    ("loads", 2330),
    ("motion", 2375),
    ("mounts", 495),
    ("numbers", 2055),
    ("optimise", 1540),
    ("order", 1815),
    ("page", 7060),
    ("proof", 8955),
    ("python", 2615),
    ("remedy", 1915),
    ("report", 32725),
    ("rotor", 670),
    ("search", 3830),
    ("shard", 660),
    ("stars", 650),
    ("sweep", 2445),
    ("table", 1500),
    ("text", 520),
    ("torque", 1225),
    ("torsion", 1260),
    ("verdict", 1860),
    ("web", 880),
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
