//! Does every room import only rooms of the storeys below it?

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::support::{imports, rooms};

/// The rooms from the ground up: each imports from the storeys below, and from its own nothing but itself.
const STOREYS: [&[&str]; 16] = [
    &["proof", "motion", "beam", "text"],
    &["exact", "shard", "table"],
    &["engine"],
    &["file"],
    &["order", "numbers", "gas", "stars"],
    &["verdict"],
    &["firing"],
    &["loads", "family", "rotor"],
    &["accuracy", "remedy", "sweep", "search", "torque", "torsion"],
    &["flywheel", "journal", "mounts"],
    &["claim", "optimise"],
    &["classroom"],
    &["page"],
    &["report"],
    &["cli", "web"],
    &["python"],
];

/// So many of them, from the ground up, are the kernel: a crate of its own, of which the compiler keeps pages and commands out.
const KERNEL: usize = 12;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The files of Rust in a folder, and in those in it.
pub fn source_files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("the folder of a room").map(|entry| entry.expect("an entry").path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let nested = folders.iter().flat_map(|folder| source_files(folder));
    files.into_iter().filter(|path| path.extension().is_some_and(|ending| ending == "rs")).chain(nested).collect()
}

/// `src/kernel/exact/decide.rs` is the module `exact::decide`, `src/kernel/exact/mod.rs` is `exact`.
fn module(file: &Path) -> Vec<String> {
    let below = rooms::path_in_crate(file).with_extension("");
    let names = below.iter().map(|name| name.to_string_lossy().into_owned());
    names.filter(|name| name != "mod").collect()
}

/// What a file of a room takes from the root of the crate.
fn imports_of(file: &Path) -> BTreeSet<String> {
    let module = module(file);
    let module: Vec<&str> = module.iter().map(String::as_str).collect();
    imports::names(&fs::read_to_string(file).expect("a source file"), &module)
}

#[test]
fn a_room_imports_only_from_the_storeys_below() {
    let mut imports = 0;
    for folder in rooms::folders() {
        let room = rooms::name(&folder);
        let below =
            STOREYS.iter().take_while(|rooms| !rooms.contains(&room.as_str())).copied().collect::<Vec<_>>().concat();
        for file in source_files(&folder) {
            for imported in imports_of(&file) {
                let is_below = imported == room || below.contains(&imported.as_str());
                assert!(is_below, "{} imports {imported}, which is not below {room}", file.display());
                imports += usize::from(imported != room);
            }
        }
    }
    assert!(imports > 300, "only {imports} imports were found: the reader of imports is broken");
}

#[test]
fn the_checker_imports_nothing_of_the_solver() {
    for file in source_files(&root().join("src/kernel/proof")) {
        let imported = imports_of(&file);
        assert!(imported.iter().all(|name| name == "proof"), "{} imports {imported:?}", file.display());
    }
}

#[test]
fn library_and_map_draw_the_storeys() {
    for (file, mark, storeys) in [
        ("src/kernel/lib.rs", "//! ", &STOREYS[..KERNEL]),
        ("src/lib.rs", "//! ", &STOREYS[..]),
        ("CONTRIBUTING.md", "", &STOREYS[..]),
    ] {
        let text = fs::read_to_string(root().join(file)).expect("a text");
        let storeys: Vec<String> = storeys.iter().rev().map(|rooms| format!("{mark}{}\n", rooms.join("  "))).collect();
        let drawn = format!("{mark}```text\n{}{mark}```\n", storeys.concat());
        assert!(text.contains(&drawn), "{file} does not draw\n{drawn}");
    }
}

#[test]
fn there_is_no_other_room() {
    let found: BTreeSet<String> = rooms::folders().iter().map(|folder| rooms::name(folder)).collect();
    let drawn: BTreeSet<String> = STOREYS.concat().into_iter().map(str::to_owned).collect();
    assert_eq!(found, drawn);
    for folder in rooms::folders() {
        let is_of_kernel = STOREYS[..KERNEL].concat().contains(&rooms::name(&folder).as_str());
        assert_eq!(
            folder.parent().is_some_and(|parent| parent.ends_with("kernel")),
            is_of_kernel,
            "{}",
            folder.display()
        );
    }
}

/// Each spelling, read in the module `exact::decide`, and what it takes from the root.
const SPELLINGS: &[(&str, &str)] = &[
    ("use crate::loads;", "loads"),
    ("pub(crate) use crate::loads::Loads as Heavy;", "loads"),
    ("use crate::{loads, proof::{Shape, Sense}};", "loads proof"),
    ("use {crate::loads, std::fmt, super::super::beam::{self}};", "beam loads"),
    ("use\n    crate\n    :: // where\n    loads;", "loads"),
    ("use crate::{self as top};", "crate"),
    ("use crate as top;", "crate"),
    ("use crate::*;", "crate"),
    ("extern crate self as top;", "crate"),
    ("use crate::{loads::*, exact::*};", "exact loads"),
    ("use r#crate_of::x; use crate::r#loads;", "loads"),
    ("use super::super::loads;", "loads"),
    ("use super::super::{loads, beam};", "beam loads"),
    ("use super::{super::loads, sum::Term};", "exact loads"),
    ("use super::super as top;", "crate"),
    ("use self::super::super::loads::Loads;", "loads"),
    ("use super::sum::Term; use self::inner::X;", "exact"),
    ("mod tests { use super::super::super::loads; use super::Y; }", "exact loads"),
    ("fn f() { crate::loads::loads(); }", "loads"),
    (
        "fn f(x: &crate::loads::Loads) -> Vec<crate::beam::Load> { x.map::<crate::sweep::Range>(self.y) }",
        "beam loads sweep",
    ),
    ("impl crate::proof::A for <crate::loads::L as super::super::beam::B>::C {}", "beam loads proof"),
    ("fn f() { format!(\"{}\", crate::loads::total()); vec![super::super::beam::X] }", "beam loads"),
    ("macro_rules! m { ($x:ty) => { $crate::loads::go::<$x>() } }", "loads"),
    ("use crankstar::{report, loads::{self}};", "loads report"),
    ("fn f() { ::crankstar::loads::loads() }", "loads"),
    ("#[derive(A)] pub(in crate::exact) struct S { pub(super) x: u8, pub(crate) y: T }", ""),
    ("// use crate::loads;\n/// [`crate::beam`]\nconst S: &str = \"crate::loads\"; /* crate::loads */", ""),
    ("use std::{fmt, io::{self, Write}}; use num::loads::crates;", ""),
];

#[test]
fn imports_are_read_in_every_spelling() {
    for (code, wanted) in SPELLINGS {
        let found: Vec<String> = imports::names(code, &["exact", "decide"]).into_iter().collect();
        assert_eq!(found.join(" "), *wanted, "{code}");
    }
}
