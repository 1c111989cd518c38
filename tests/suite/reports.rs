//! Do the reports in `reports/` still say, byte for byte, what the program writes?
//!
//! `CRANKSTAR_RENEW=1 cargo test --test suite reports` writes them anew.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{env, fs};

use crankstar::engine::Engine;
use crankstar::family;
use crankstar::file::{self, Layout};
use crankstar::page::{Document, Format};
use crankstar::report;

use crate::support::pages;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reports")
}

/// The files of an engine's folder, by name.
fn written(layout: &Engine) -> BTreeMap<String, String> {
    in_all_formats(&pages::document(layout))
}

/// What is stored of a page: Markdown with its pictures, LaTeX.
fn in_all_formats(document: &Document) -> BTreeMap<String, String> {
    let files = [Format::GITHUB, Format::Latex].into_iter().flat_map(|format| pages::files(document, format));
    files.map(|file| (file.name, file.text)).collect()
}

fn stored(folder: &Path) -> BTreeMap<String, String> {
    let Ok(entries) = fs::read_dir(folder) else { return BTreeMap::new() };
    let files = entries.map(|entry| entry.expect("an entry").path()).filter(|path| path.is_file());
    files
        .map(|path| {
            (
                path.file_name().expect("a name").to_string_lossy().into_owned(),
                fs::read_to_string(&path).expect("a text"),
            )
        })
        .collect()
}

/// Compares a folder with what the program writes, or renews it.
pub fn compare(folder: &Path, written: &BTreeMap<String, String>) {
    if env::var_os("CRANKSTAR_RENEW").is_some() {
        for name in stored(folder).keys().filter(|name| !written.contains_key(*name)) {
            fs::remove_file(folder.join(name)).expect("a stale file");
        }
        fs::create_dir_all(folder).expect("the folder");
        // What is read by other tests at this moment is not touched.
        let there = stored(folder);
        for (name, text) in written.iter().filter(|(name, text)| there.get(*name) != Some(text)) {
            fs::write(folder.join(name), text).expect("a file");
        }
    }
    let stored = stored(folder);
    let names = |files: &BTreeMap<String, String>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&stored), names(written), "files of {}", folder.display());
    for (name, text) in written {
        let first = stored[name].lines().zip(text.lines()).position(|(old, new)| old != new);
        assert!(&stored[name] == text, "{}/{name} differs, first in line {:?}", folder.display(), first.map(|n| n + 1));
    }
}

fn compare_family(prefix: &str) {
    let engines: Vec<_> = file::catalogue().expect("the catalogue reads").into_iter().collect();
    let family: Vec<_> = engines.into_iter().filter(|(entry, _)| entry.name.starts_with(prefix)).collect();
    assert!(!family.is_empty(), "no engine is called {prefix}…");
    for (entry, layout) in family {
        compare(&folder().join(entry.name), &written(&layout));
    }
}

macro_rules! families {
    ($($test:ident: $prefix:literal;)*) => {
        $(#[test]
        fn $test() {
            compare_family($prefix);
        })*

        #[test]
        fn every_engine_of_the_catalogue_belongs_to_a_family() {
            for (entry, _) in file::catalogue().expect("the catalogue reads") {
                assert!([$($prefix),*].iter().any(|prefix| entry.name.starts_with(prefix)), "{}", entry.name);
            }
        }
    };
}

families! {
    reports_on_singles_are_as_stored: "I1";
    reports_on_in_line_twins_are_as_stored: "I2";
    reports_on_in_line_threes_are_as_stored: "I3";
    reports_on_in_line_fours_are_as_stored: "I4";
    reports_on_in_line_fives_are_as_stored: "I5";
    reports_on_in_line_sixes_are_as_stored: "I6";
    reports_on_in_line_eights_are_as_stored: "I8";
    reports_on_v_twins_are_as_stored: "V2";
    reports_on_v_fours_are_as_stored: "V4";
    reports_on_v_sixes_are_as_stored: "V6";
    reports_on_v_eights_are_as_stored: "V8";
    reports_on_v_tens_and_v_twelves_are_as_stored: "V1";
    reports_on_boxers_are_as_stored: "boxer";
    reports_on_radials_are_as_stored: "radial";
}

/// Compares the folders below this one, each of which holds the layout file that its report is about.
fn compare_layouts(below: &str) {
    let folders = fs::read_dir(folder().join(below)).expect("folders").map(|entry| entry.expect("an entry").path());
    for folder in folders {
        let layout = fs::read_to_string(folder.join("layout.toml")).expect("a layout file");
        let mut files = BTreeMap::from([("layout.toml".to_owned(), layout.clone())]);
        let page = match file::parse_layout("layout.toml", &layout).expect("it reads") {
            Layout::Known(engine, open) => pages::document_of(&engine, open.as_deref()),
            Layout::Open(open) => {
                report::family_page(&open, &family::classify(&open, open.orders()).expect("orders"), false)
            }
        };
        files.extend(in_all_formats(&page));
        compare(&folder, &files);
    }
}

#[test]
fn reports_on_families_are_as_stored() {
    compare_layouts("families");
}

#[test]
fn reports_on_examples_with_numbers_are_as_stored() {
    compare_layouts("examples");
}

#[test]
fn the_index_is_as_stored_and_every_folder_is_an_engine() {
    let index = report::catalogue_page(&file::catalogue().expect("reads"));
    let files = pages::files(&index, Format::GITHUB);
    compare(&folder(), &files.into_iter().map(|file| (file.name, file.text)).collect());
    let folders = fs::read_dir(folder()).expect("reports").map(|entry| entry.expect("an entry").path());
    for path in folders.filter(|path| path.is_dir()) {
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        let linked = stored(&folder())["README.md"].contains(&format!("]({name}/"))
            || stored(&folder())["README.md"].contains(&format!("]({name})"));
        assert!(linked, "reports/README.md does not lead to reports/{name}");
        assert!(
            [
                "accuracy",
                "atlas",
                "claims",
                "engines",
                "examples",
                "families",
                "firing",
                "forms",
                "grigoryev",
                "optimise",
                "speed",
                "stability",
                "thesis",
                "trust",
                "v-angles"
            ]
            .contains(&name.as_str())
                || file::find(&name).is_some(),
            "reports/{name} belongs to no engine"
        );
    }
}

#[test]
fn no_report_holds_a_path_a_date_or_a_version() {
    for (entry, layout) in file::catalogue().expect("the catalogue reads") {
        for (name, text) in written(&layout) {
            let unwanted =
                [env!("CARGO_MANIFEST_DIR"), concat!("crankstar ", env!("CARGO_PKG_VERSION")), "/home/", "/root/"];
            assert!(unwanted.iter().all(|word| !text.contains(word)), "{}/{name}", entry.name);
        }
    }
}
