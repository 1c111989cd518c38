//! Does the atlas in `reports/atlas` still say what the program writes, and does it hold?
//!
//! `CRANKSTAR_RENEW=1 cargo test --test suite atlas` writes it anew.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use crankstar::engine::Cycle;
use crankstar::file;
use crankstar::page::{Block, Document, Format, Language, Picture};
use crankstar::report;
use crankstar::search::{self, Best, Options, Problem};

use crate::studies::catalogue;
use crate::support::figure_texts::FigureTexts;
use crate::support::german::{has_words, phrases};
use crate::support::program::{program, scratch};
use crate::support::{golden, pages};

fn best(cylinders: u32, cycle: Cycle) -> Best {
    search::best_in_line(cylinders, cycle, &Options::default()).expect("there are stars")
}

/// The files that the program writes, by name.
fn written() -> &'static BTreeMap<String, String> {
    static FILES: OnceLock<BTreeMap<String, String>> = OnceLock::new();
    FILES.get_or_init(|| {
        let folder = scratch("atlas").join("new");
        let output = Command::new(env!("CARGO_BIN_EXE_crankstar"))
            .args(["atlas", "--reports", "..", "--output", folder.to_str().expect("a path")])
            .output()
            .expect("the program starts");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let files = fs::read_dir(&folder).expect("the folder").map(|entry| entry.expect("an entry"));
        let text = |path: PathBuf| fs::read_to_string(path).expect("a text");
        files.map(|file| (file.file_name().to_string_lossy().into_owned(), text(file.path()))).collect()
    })
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/atlas")
}

#[test]
fn the_atlas_is_as_stored() {
    for name in ["README.md", "atlas.tex", "atlas.html", "atlas.csv", "stars-in-line.svg"] {
        assert!(written().contains_key(name), "{name} is not written");
    }
    let (for_browsers, others) = written().clone().into_iter().partition(|(name, _)| name.ends_with(".html"));
    golden::compare(&folder(), &others);
    golden::compare_formats(&folder(), &for_browsers);
}

#[test]
fn every_engine_of_the_catalogue_stands_on_the_poster_and_no_text_lies_on_another() {
    let engines = file::catalogue().expect("it reads");
    let files = report::poster(&engines, Language::En);
    assert_eq!(files.iter().map(|file| file.name.as_str()).collect::<Vec<_>>(), ["poster.svg", "poster.tex"]);
    for (entry, _) in &engines {
        assert!(files[0].text.contains(&format!(">{}</text>", entry.name)), "{}", entry.name);
        assert!(files[1].text.contains(&format!("{{{}}};", entry.name)), "{}", entry.name);
    }
    assert!(files[1].text.contains("[a2paper,margin=0mm]{geometry}"));
    let sheet = report::poster_sheet(&engines);
    assert_eq!((sheet.width, sheet.height), (420.0, 594.0));
    assert!(sheet.overlaps().is_empty() && sheet.leaving().is_empty(), "{:?} {:?}", sheet.overlaps(), sheet.leaving());
}

/// The files of a call of `atlas` with these arguments, by name.
fn written_with(name: &str, arguments: &[&str]) -> BTreeMap<String, String> {
    let folder = scratch(name);
    let output = program().arg("atlas").args(arguments).arg("--output").arg(&folder).output();
    let output = output.expect("the program starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let files = fs::read_dir(&folder).expect("the folder").map(|entry| entry.expect("an entry"));
    let text = |path: PathBuf| fs::read_to_string(path).expect("a text");
    files.map(|file| (file.file_name().to_string_lossy().into_owned(), text(file.path()))).collect()
}

#[test]
fn the_atlas_stands_in_one_format_where_one_is_named_with_the_same_numbers() {
    for (format, file) in [("latex", "atlas.tex"), ("typst", "atlas.typ"), ("text", "atlas.txt")] {
        let files = written_with(&format!("atlas-{format}"), &["--format", format]);
        let pages = files.keys().filter(|name| !name.ends_with(".svg")).collect::<Vec<_>>();
        assert_eq!(pages, ["atlas.csv", file]);
        assert_eq!(files["atlas.csv"], written()["atlas.csv"]);
        assert!(
            files[file].contains("Atlas of engine balance") && files[file].contains("Its numbers for a spreadsheet")
        );
    }
    let german = written_with("atlas-german", &["--format", "html", "--lang", "de"]);
    assert_eq!(german.keys().collect::<Vec<_>>(), ["atlas.csv", "atlas.html"]);
    assert_eq!(german["atlas.csv"], written()["atlas.csv"], "a spreadsheet is in no language");
    assert!(german["atlas.html"].contains("<html lang=\"de\">"));
    let both = program().args(["atlas", "--poster", "--format", "html", "--output", "somewhere"]).output();
    assert_eq!(both.expect("the program starts").status.code(), Some(2));
    let nowhere = program().args(["atlas", "--format", "html"]).output();
    assert_eq!(nowhere.expect("the program starts").status.code(), Some(2));
}

#[test]
fn the_atlas_has_german_for_every_phrase() {
    let engines = file::catalogue().expect("it reads");
    let stars = [best(5, Cycle::TwoStroke), best(8, Cycle::FourStroke), best(12, Cycle::TwoStroke)];
    let atlas = report::Atlas::new(&engines, &stars).expect("an atlas");
    let pages: Vec<Document> = atlas.pages().into_iter().chain([atlas.page()]).collect();
    // Names lead to reports where the reader says that there are some.
    let has_links =
        |pages: &[Document]| pages.iter().any(|page| pages::text(page, Format::GITHUB).contains("/report.md"));
    let led = report::Atlas::new(&engines, &stars).expect("an atlas").leading_to("..").pages();
    assert!(has_links(&led) && !has_links(&pages));
    let phrases = pages.iter().flat_map(phrases);
    let missing: Vec<&str> = phrases.filter(|words| has_words(words) && !Language::De.knows(words)).collect();
    assert!(missing.is_empty(), "no German for {missing:#?}");
}

#[test]
fn the_poster_speaks_german_and_no_text_lies_on_another_or_leaves_the_sheet() {
    let engines = file::catalogue().expect("it reads");
    let files = report::poster(&engines, Language::De);
    assert!(files[0].text.contains("Massenausgleich von") && files[1].text.contains("Reihenmotoren"));
    let sheet = Picture { name: String::new(), caption: "".into(), figure: report::poster_sheet(&engines) };
    let sheet = Language::De.picture(&sheet).figure;
    assert_eq!((sheet.width, sheet.height), (420.0, 594.0));
    assert!(sheet.overlaps().is_empty() && sheet.leaving().is_empty(), "{:?} {:?}", sheet.overlaps(), sheet.leaving());
}

#[test]
fn the_pictures_of_the_catalogue_show_every_engine_and_no_text_lies_on_another() {
    let engines = file::catalogue().expect("it reads");
    let page = catalogue::page(&engines);
    let pictures = page.blocks.iter().filter_map(|block| match block {
        Block::Pictures(pictures) => Some(pictures),
        _ => None,
    });
    let figures: Vec<_> = pictures.flatten().map(|picture| &picture.figure).collect();
    let texts: Vec<&str> = figures.iter().flat_map(|figure| figure.text_boxes()).map(|(text, _)| text).collect();
    assert!(engines.iter().all(|(entry, _)| texts.contains(&entry.name)), "{texts:?}");
    for figure in figures {
        assert!(figure.overlaps().is_empty() && figure.leaving().is_empty(), "{:?}", figure.overlaps());
    }
}

/// The fields of each line of the CSV file, by the names in its header.
fn lines() -> Vec<BTreeMap<String, String>> {
    let mut all = written()["atlas.csv"].lines().map(fields);
    let header = all.next().expect("a header");
    all.map(|line| {
        assert_eq!(line.len(), header.len(), "{line:?}");
        header.iter().cloned().zip(line).collect()
    })
    .collect()
}

/// The fields of a line; no field of the atlas holds the end of a line.
fn fields(line: &str) -> Vec<String> {
    let (mut fields, mut quoted) = (vec![String::new()], false);
    for letter in line.chars() {
        match letter {
            '"' => quoted = !quoted,
            ',' if !quoted => fields.push(String::new()),
            _ => fields.last_mut().expect("a field").push(letter),
        }
    }
    fields
}

/// The throws of a star in turns, from `throws 0, 3, 4 times (360/7)°` or `throws 0, 90°`.
fn throws(title: &str) -> Vec<f64> {
    let list = title.strip_prefix("throws ").expect("throws");
    let (list, step) = match list.split_once(" times ") {
        Some((list, step)) => {
            let (above, below) = step.trim_matches(['(', ')', '°']).split_once('/').expect("a fraction");
            (list, above.parse::<f64>().expect("a number") / below.parse::<f64>().expect("a number"))
        }
        None => (list.trim_end_matches('°'), 1.0),
    };
    list.split(", ").map(|number| number.parse::<f64>().expect("a number") * step / 360.0).collect()
}

/// Lengths of `Σ e^{ikβ}` and `Σ z e^{ikβ}`, the throws one apart about their middle.
fn lengths(throws: &[f64], order: f64) -> [f64; 2] {
    let middle = (throws.len() as f64 - 1.0) / 2.0;
    let (mut force, mut moment) = ([0.0; 2], [0.0; 2]);
    for (place, throw) in throws.iter().enumerate() {
        let (sin, cos) = (TAU * order * throw).sin_cos();
        let arm = middle - place as f64;
        for (part, value) in [cos, sin].into_iter().enumerate() {
            force[part] += value;
            moment[part] += arm * value;
        }
    }
    [force, moment].map(|[re, im]| f64::hypot(re, im))
}

#[test]
fn every_number_of_a_star_is_the_length_of_its_plain_sum() {
    let mut counted = 0;
    for line in lines().iter().filter(|line| line["origin"] != "catalogue") {
        let throws = throws(&line["title"]);
        assert_eq!(throws.len().to_string(), line["engine"]);
        let [force, moment] = lengths(&throws, line["order"].parse().expect("an order"));
        for (column, expected) in [("force", force), ("moment", moment)] {
            let written: f64 = line[column].parse().expect("a number");
            assert!((written - expected).abs() < 2e-9, "{line:?}: {expected}");
            assert_eq!(line[column] == "0", expected < 1e-9, "{line:?}");
            assert_eq!(line[column] == "0", line[&format!("{column}_exact")] == "0");
        }
        counted += 1;
    }
    assert!(counted > 500, "{counted} lines");
}

#[test]
fn the_throws_of_a_star_fire_evenly_in_its_firing_order() {
    for line in lines().iter().filter(|line| line["origin"] != "catalogue" && line["order"] == "1") {
        let throws = throws(&line["title"]);
        let revolutions = if line["origin"].contains("four-stroke") { 2.0 } else { 1.0 };
        let step = revolutions / throws.len() as f64;
        for (place, cylinder) in line["firing_order"].split('-').enumerate() {
            let throw = throws[cylinder.parse::<usize>().expect("a number") - 1];
            let off = place as f64 * step + throw;
            assert!((off - off.round()).abs() < 1e-9, "{line:?}");
        }
    }
}

#[test]
fn known_stars_and_counts_stand_in_the_atlas() {
    let lines = lines();
    let of = |origin: &str, engine: &str, order: &str| -> Vec<&BTreeMap<String, String>> {
        let is = |line: &&BTreeMap<String, String>| {
            line["origin"] == origin && line["engine"] == engine && line["order"] == order
        };
        lines.iter().filter(is).collect()
    };
    let two = "best two-stroke star";
    // Five cylinders: eight classes among 24 stars.
    let fives = of(two, "5", "1");
    assert_eq!(fives.len(), 8);
    assert_eq!(fives.iter().map(|line| line["stars"].parse::<u32>().expect("a number")).sum::<u32>(), 24);
    // Six cylinders two-stroke with M_1 = 0 keep M_2 = 2√3.
    assert_eq!(of(two, "6", "1")[0]["moment"], "0");
    assert_eq!(of(two, "6", "2")[0]["moment_exact"], "2√3");
    // The usual in-line six leaves nothing before order 6, and needs nothing.
    let six = of("catalogue", "I6", "1")[0];
    assert_eq!([&six["first_force_residual"], &six["remedy_of_orders_1_and_2"]], ["6, planar", "none needed"]);
    assert_eq!(of("catalogue", "I4", "1")[0]["remedy_of_orders_1_and_2"], "Lanchester pair ±2");
    let v8 = of("catalogue", "V8-crossplane", "1")[0];
    assert_eq!([&v8["moment_exact"], &v8["moment_shape"]], ["√10", "rotating"]);
    assert_eq!(v8["remedy_of_orders_1_and_2"], "2 counterweights (couple)");
    let engines = file::catalogue().expect("it reads");
    assert!(engines.iter().all(|(entry, _)| of("catalogue", entry.name, "8").len() == 1));
}

#[test]
fn tied_stars_are_told_apart_by_the_least_moment_of_order_4() {
    // All stars one by one: of those without moments of orders 1 and 2, the least of order 4 is the one given.
    let (cylinders, cycle) = (8, Cycle::FourStroke);
    let all = search::every_value(&Problem::inline(cylinders, cycle, &[1, 2, 4])).expect("stars");
    let is_tied = |star: &&search::FoundStar| star.moments[..2].iter().all(|moment| moment.sum.vanishes());
    let tied: Vec<_> = all.stars.iter().filter(is_tied).collect();
    let eight = best(cylinders, cycle);
    assert_eq!(eight.tied, Some(tied.iter().filter_map(|star| star.classes).sum()));
    let least = tied.iter().map(|star| star.moments[2].decimal).fold(f64::INFINITY, f64::min);
    assert_eq!(eight.stars.len(), 1);
    assert!(eight.stars[0].moments[2].decimal <= least);
    // Twelve cylinders two-stroke: 15 classes leave neither, and none of them is without order 4.
    let twelve = best(12, Cycle::TwoStroke);
    assert_eq!((twelve.tied, twelve.stars[0].classes), (Some(15), Some(5)));
    assert_eq!(twelve.stars[0].moments[2].modulus().expect("a form").to_string(), "4√3");
}
