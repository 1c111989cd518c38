//! Do no files of a room import each other in a circle, so that each can be read after those that it needs?

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

use crate::rooms::source_files;
use crate::support::imports::{self, For};
use crate::support::rooms;

/// The circles that are left, by their files below `src`. The list must not grow.
const KNOWN: [&[&str]; 1] = [
    // A composer's labels need a title as plain text, which a composer makes.
    &["page/write/compose.rs", "page/write/labels.rs", "page/write/notation.rs"],
];

/// Names from the root of the crate down: of a path, or of the module that a file is.
type Names = Vec<String>;

struct File {
    name: String,
    paths: BTreeSet<(Names, For)>,
}

/// The files of a room, by their modules.
type Room = BTreeMap<Names, File>;

/// `page/write/mod.rs` is the module `page::write`.
fn file((name, text): (String, String)) -> (Names, File) {
    let module: Vec<&str> = name.trim_end_matches(".rs").split('/').filter(|name| *name != "mod").collect();
    let paths = imports::paths(&text, &module);
    (module.into_iter().map(str::to_owned).collect(), File { name, paths })
}

/// The file that defines what this path leads to, through imports that hand a name on; none for a module, and outside of the room.
fn definition<'a>(room: &'a Room, path: &[String], seen: &mut BTreeSet<Names>) -> Option<&'a File> {
    if !seen.insert(path.to_vec()) {
        return None;
    }
    let length = (1..path.len()).rev().find(|length| room.contains_key(&path[..*length]))?;
    let (file, rest) = (&room[&path[..length]], &path[length..]);
    let handed_on = file.paths.iter().find_map(|(from, purpose)| match purpose {
        For::Import(name) | For::HandedOn(name) if *name == rest[0] => Some(from),
        For::Import(_) | For::HandedOn(_) | For::Code => None,
    });
    match handed_on {
        Some(from) => definition(room, &[from, &rest[1..]].concat(), seen),
        None => (!room.contains_key(path)).then_some(file),
    }
}

/// The other files that each file needs, with one of the paths that lead there. A `mod.rs` needs nothing that it only hands on.
fn needed(room: &Room) -> BTreeMap<&str, BTreeMap<&str, String>> {
    let of = |file: &File| {
        let hands_on = file.name.ends_with("mod.rs");
        let paths = file.paths.iter().filter(|(_, purpose)| !(hands_on && matches!(purpose, For::HandedOn(_))));
        let found = paths.filter_map(|(path, _)| Some((definition(room, path, &mut BTreeSet::new())?, path)));
        let others = found.filter(|(other, _)| other.name != file.name);
        others.map(|(other, path)| (other.name.as_str(), path.join("::"))).collect()
    };
    room.values().map(|file| (file.name.as_str(), of(file))).collect()
}

/// The circles of these files of one room, in each of which every file needs every other, with what they need of each other.
fn circles(files: impl IntoIterator<Item = (String, String)>) -> BTreeMap<Vec<String>, String> {
    let room: Room = files.into_iter().map(file).collect();
    let needed = needed(&room);
    let reached = |file| {
        let (mut all, mut waiting) = (BTreeSet::new(), vec![file]);
        while let Some(next) = waiting.pop() {
            waiting.extend(needed[next].keys().filter(|other| all.insert(**other)));
        }
        all
    };
    let reached: BTreeMap<&str, BTreeSet<&str>> = needed.keys().map(|file| (*file, reached(*file))).collect();
    let circle = |(file, all): (&&str, &BTreeSet<&str>)| {
        let circle: Vec<&str> = all.iter().filter(|other| reached[**other].contains(file)).copied().collect();
        let all = circle.iter().flat_map(|file| needed[file].iter().map(move |(other, path)| (file, other, path)));
        let inside = all.filter(|(_, other, _)| circle.contains(other));
        let told = inside.map(|(file, other, path)| format!("{file} needs {path} of {other}\n")).collect();
        (circle.into_iter().map(str::to_owned).collect(), told)
    };
    reached.iter().map(circle).filter(|(circle, _): &(Vec<String>, _)| !circle.is_empty()).collect()
}

#[test]
fn no_files_of_a_room_import_each_other_in_a_circle() {
    let read = |path: PathBuf| {
        let name = rooms::path_in_crate(&path).to_string_lossy().replace('\\', "/");
        (name, fs::read_to_string(path).expect("a source file"))
    };
    let found: BTreeMap<_, _> =
        rooms::folders().into_iter().flat_map(|room| circles(source_files(&room).into_iter().map(read))).collect();
    let told: String = found.values().map(String::as_str).collect();
    let found: Vec<Vec<String>> = found.into_keys().collect();
    assert_eq!(found, KNOWN, "a circle is new, or one that is known is gone:\n{told}");
}

/// What two files of a room hold beside its `mod.rs`, and whether they are a circle.
const PAIRS: &[(&str, &str, bool)] = &[
    ("use super::B;", "use super::a::A;", true),
    ("use super::Renamed as R;", "fn f(a: &crate::room::a::A) {}", true),
    ("fn f() { super::b::b() }", "use super::a; fn f() { a::a() }", true),
    ("fn f() { super::b() }", "mod inner { use super::super::a::A; }", true),
    ("use super::B;", "", false),
    ("use super::B;", "use super::a; mod a_of_b { use super::B; }", false),
    ("use super::B; pub(in crate::room) struct A;", "pub(in crate::room::a) struct B; struct C(other::a::A);", false),
];

#[test]
fn a_circle_is_found_through_names_that_are_handed_on() {
    for (a, b, is_circle) in PAIRS {
        let hands_on = "mod a; mod b; pub use a::A; pub use b::{B, B as Renamed, b};";
        let files = [("room/mod.rs", hands_on), ("room/a.rs", a), ("room/b.rs", b)];
        let found = circles(files.map(|(name, text)| (name.to_owned(), text.to_owned())));
        let wanted = is_circle.then(|| vec!["room/a.rs".to_owned(), "room/b.rs".to_owned()]);
        assert_eq!(found.into_keys().collect::<Vec<_>>(), Vec::from_iter(wanted), "{a} {b}");
    }
}
