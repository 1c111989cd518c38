//! Do the reports still say, byte for byte, what the program writes? `support/golden.rs` tells which of them stand in `reports/`.
//!
//! `CRANKSTAR_RENEW=1 cargo test --test suite reports` writes them anew.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crankstar::engine::Engine;
use crankstar::family;
use crankstar::file::{self, Layout};
use crankstar::page::{Document, Format};
use crankstar::report::{self, Question};

use crate::studies::catalogue;
use crate::support::{golden, pages};

/// The files of an engine's folder, by name.
fn written(layout: &Engine) -> BTreeMap<String, String> {
    in_all_formats(&pages::document(layout))
}

/// What is stored of a page: Markdown with its pictures, LaTeX.
fn in_all_formats(document: &Document) -> BTreeMap<String, String> {
    let files = [Format::GITHUB, Format::Latex].into_iter().flat_map(|format| pages::files(document, format));
    files.map(|file| (file.name, file.text)).collect()
}

fn compare_family(prefix: &str) {
    let engines: Vec<_> = file::catalogue().expect("the catalogue reads").into_iter().collect();
    let family: Vec<_> = engines.into_iter().filter(|(entry, _)| entry.name.starts_with(prefix)).collect();
    assert!(!family.is_empty(), "no engine is called {prefix}…");
    for (entry, layout) in family {
        golden::compare(&golden::reports().join(entry.name), &written(&layout));
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

/// The folders below this one, each of which holds the layout file that its report is about: name, text and page.
fn layouts(below: &str) -> Vec<(PathBuf, String, Document)> {
    let folders =
        fs::read_dir(golden::reports().join(below)).expect("folders").map(|entry| entry.expect("an entry").path());
    let read = |folder: PathBuf| {
        let layout = fs::read_to_string(folder.join("layout.toml")).expect("a layout file");
        let page = match file::parse_layout("layout.toml", &layout).expect("it reads") {
            Layout::Known(engine, open) => pages::document_of(&engine, open.as_deref()),
            Layout::Open(open) => {
                report::family_page(&open, &family::classify(&open, open.orders()).expect("orders"), false)
            }
        };
        (folder, layout, page)
    };
    folders.map(read).collect()
}

fn compare_layouts(below: &str) {
    for (folder, layout, page) in layouts(below) {
        let mut files = in_all_formats(&page);
        files.insert("layout.toml".to_owned(), layout);
        golden::compare(&folder, &files);
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

/// A page of each question that the report of an engine leaves out, by its folder.
#[test]
fn pages_of_other_questions_are_as_stored() {
    let read = |place: &str| fs::read_to_string(golden::reports().join("../examples").join(place)).expect("an example");
    let engine = |name: &str| {
        let text = fs::read_to_string(golden::reports().join("examples").join(name).join("layout.toml"));
        file::parse("layout.toml", &text.expect("a layout file")).unwrap_or_else(|error| panic!("{error}"))
    };
    let moments = ["marine-six", "marine-i4"].map(|name| {
        let engine = engine(name);
        (engine.title().clone(), engine)
    });
    let at = report::AnglesAsked { at: vec![30.0, 125.0], ..Default::default() };
    let asked: [Box<dyn Question>; 5] = [
        Box::new(report::AngleStudy::new(&engine("v8-gas"), &at).expect("angles")),
        Box::new(
            report::FlywheelStudy::new(
                file::parse_diagram("diagram.toml", &read("turning-moment.toml")).expect("a diagram"),
            )
            .expect("it fits"),
        ),
        Box::new(report::MomentsStudy::new(&moments).expect("moments")),
        Box::new(report::MountsStudy::new(&engine("i4-mounts"), &Default::default()).expect("mounts")),
        Box::new(
            report::RotorStudy::new(file::parse_rotor("shaft.toml", &read("shaft.toml")).expect("masses"))
                .expect("solved"),
        ),
    ];
    for question in asked {
        let files = pages::files(&question.page(), Format::GITHUB);
        let files = files.into_iter().map(|file| (file.name, file.text)).collect();
        golden::compare(&golden::reports().join("questions").join(question.command()), &files);
    }
}

#[test]
#[ignore = "`.ci/run` writes every page in every format"]
fn reports_in_formats_without_pictures_of_their_own_are_what_the_digests_say() {
    let engines = file::catalogue().expect("the catalogue reads");
    let catalogue = engines.iter().map(|(entry, engine)| (golden::reports().join(entry.name), pages::document(engine)));
    let beside = ["examples", "families"].into_iter().flat_map(layouts).map(|(folder, _, page)| (folder, page));
    for (folder, page) in catalogue.chain(beside) {
        let main = |format| pages::files(&page, format).swap_remove(0);
        let files = [Format::Html, Format::Typst, Format::PLAIN].map(main);
        golden::compare_formats(&folder, &files.into_iter().map(|file| (file.name, file.text)).collect());
    }
}

/// All pages in Markdown below a folder.
fn in_markdown(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let below = |path: PathBuf| match path.is_dir() {
        true => in_markdown(&path),
        false => vec![path],
    };
    entries.flat_map(below).filter(|path| path.extension().is_some_and(|ending| ending == "md")).collect()
}

#[test]
fn links_and_pictures_of_every_stored_page_lead_somewhere() {
    let mut found = 0;
    for path in in_markdown(&golden::reports()) {
        let text = fs::read_to_string(&path).expect("a page");
        for target in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let file = target.split('#').next().unwrap_or_default();
            if !file.is_empty() && !file.contains("://") && !file.contains(' ') {
                assert!(path.parent().expect("a folder").join(file).exists(), "{} leads to {target}", path.display());
                found += 1;
            }
        }
    }
    assert!(found > 1000, "only {found} links were found");
}

#[test]
fn the_index_is_as_stored_and_every_folder_is_an_engine() {
    let index = catalogue::page(&file::catalogue().expect("reads"));
    let files = pages::files(&index, Format::GITHUB);
    golden::compare(&golden::reports(), &files.into_iter().map(|file| (file.name, file.text)).collect());
    let text = fs::read_to_string(golden::reports().join("README.md")).expect("the index");
    let folders = fs::read_dir(golden::reports()).expect("reports").map(|entry| entry.expect("an entry").path());
    for path in folders.filter(|path| path.is_dir()) {
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        let linked = text.contains(&format!("]({name}/")) || text.contains(&format!("]({name})"));
        assert!(linked, "reports/README.md does not lead to reports/{name}");
        assert!(
            [
                "accuracy",
                "atlas",
                "claims",
                "engines",
                "examples",
                "questions",
                "families",
                "firing",
                "forms",
                "grigoryev",
                "optimise",
                "speed",
                "stability",
                "stars",
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
