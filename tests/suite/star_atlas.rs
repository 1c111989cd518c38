//! Does the atlas of minimal vanishing stars in `reports/stars/atlas` still say what the program writes, and is it right?
//!
//! `CRANKSTAR_RENEW=1 cargo test --test suite star_atlas` writes it anew.

use std::collections::BTreeMap;
use std::fs;
use std::sync::LazyLock;

use crankstar::exact::{PhasorSum, Term, Turn};
use crankstar::file;
use crankstar::page::{Format, Language};
use crankstar::report::{self, StarAtlas, StarredEngine};
use num_rational::BigRational;

use crate::support::german::{has_words, phrases};
use crate::support::golden;
use crate::support::pages;

/// The catalogue, and the engines that were built.
static ATLAS: LazyLock<StarAtlas> = LazyLock::new(|| {
    let catalogue = file::catalogue().expect("a catalogue").into_iter();
    let mut engines: Vec<StarredEngine> =
        catalogue.map(|(entry, engine)| StarredEngine { name: entry.name.to_owned(), engine }).collect();
    let built = fs::read_dir(golden::reports().join("engines")).expect("engines");
    let mut folders: Vec<_> = built.map(|entry| entry.expect("an entry").path()).filter(|path| path.is_dir()).collect();
    folders.sort();
    engines.extend(folders.into_iter().map(|folder| {
        let name = folder.file_name().expect("a name").to_string_lossy().into_owned();
        let text = fs::read_to_string(folder.join("engine.toml")).expect("a layout file");
        StarredEngine { engine: file::parse(&name, &text).expect("an engine"), name }
    }));
    StarAtlas::new(&engines)
});

#[test]
fn the_atlas_of_stars_is_as_stored() {
    let page = pages::files(&report::star_atlas_page(&ATLAS), Format::GITHUB).into_iter();
    golden::compare(&golden::reports().join("stars/atlas"), &page.map(|file| (file.name, file.text)).collect());
}

#[test]
fn the_atlas_of_stars_has_german_for_every_phrase() {
    let documents = [report::star_atlas_page(&ATLAS), report::star_atlas_answer(&ATLAS)];
    let phrases = documents.iter().flat_map(phrases);
    let missing: Vec<&str> = phrases.filter(|words| has_words(words) && !Language::De.knows(words)).collect();
    assert!(missing.is_empty(), "no German for {missing:#?}");
}

/// The rows of the tables of the stored page that have this many columns.
fn rows(columns: usize) -> Vec<Vec<String>> {
    let text = fs::read_to_string(golden::reports().join("stars/atlas/README.md")).expect("the page");
    let row = |line: &str| Some(line.strip_prefix("| ")?.strip_suffix(" |")?.split(" | ").map(str::to_owned).collect());
    text.lines()
        .filter_map(row)
        .filter(|row: &Vec<String>| row.len() == columns && !row[0].starts_with("---"))
        .collect()
}

fn fraction(text: &str) -> BigRational {
    text.replace('−', "-").parse().unwrap_or_else(|_| panic!("{text}"))
}

#[test]
fn the_polygons_on_the_page_make_up_the_vectors_beside_them() {
    let mut stars = 0;
    for row in rows(3).iter().filter(|row| row[0] != "Star") {
        let vector = |angle: &str| Term { angle: Turn::new(fraction(angle)), weight: fraction("1") };
        let told = PhasorSum::new(row[1].split(", ").map(vector).collect());
        let corners = row[2].split("), (").flat_map(|polygon| {
            let parts: Vec<&str> = polygon.trim_matches(['(', ')']).split("; ").collect();
            let (sides, first, weight) =
                (parts[0].parse::<i64>().expect("sides"), fraction(parts[1]), fraction(parts[2]));
            (0..sides).map(move |corner| Term {
                angle: &Turn::new(first.clone()) + &Turn::fraction(corner, sides),
                weight: weight.clone(),
            })
        });
        assert_eq!(PhasorSum::new(corners.collect()).collected(), told.collected(), "{row:?}");
        assert!(row[0].starts_with(&format!("{}.", told.terms().len())), "{row:?}");
        stars += 1;
    }
    assert_eq!(stars, 107);
}

#[test]
fn the_table_counts_what_stands_below_it() {
    let mut polygons: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for row in rows(3).iter().filter(|row| row[0] != "Star") {
        polygons.entry(row[1].split(", ").count()).or_default().push(row[2].split("), (").count());
    }
    let classes = rows(5);
    let mut places: BTreeMap<usize, usize> = BTreeMap::new();
    let mut engines = 0;
    for row in classes.iter().filter(|row| row[0] != "Vectors") {
        let (vectors, stars): (usize, usize) = (row[0].parse().expect("vectors"), row[2].parse().expect("stars"));
        let first = places.entry(vectors).or_default();
        let of_class = &polygons[&vectors][*first..*first + stars];
        *first += stars;
        let told: Vec<usize> = row[3].split(", ").map(|number| number.parse().expect("a number")).collect();
        assert_eq!(told.first(), of_class.iter().min(), "{row:?}");
        assert_eq!(told.last(), of_class.iter().max(), "{row:?}");
        engines += row[4].parse::<usize>().expect("engines");
    }
    assert_eq!(classes.len(), 21 + 1);
    assert_eq!(rows(2).iter().filter(|row| row[0] != "Engine").count(), engines);
}

/// An engine that was not looked at when the page was made: the throws of the smallest star that is no regular polygon.
#[test]
fn an_engine_whose_throws_are_a_star_of_six_vectors_has_it_in_its_force() {
    let star = crankstar::exact::minimal_stars(6).pop().expect("a star");
    let angles = star.angles();
    assert!(angles.len() == 6 && !star.class.is_regular());
    let text = format!(
        "title = \"Six throws\"\n{}",
        angles
            .iter()
            .enumerate()
            .map(|(place, angle)| format!(
                "[[cylinder]]\nthrow = \"{} turn\"\nbank = 0\nposition = {place}\n",
                angle.turns()
            ))
            .collect::<String>()
    );
    let engine = file::parse("six", &text).expect("an engine");
    let atlas = StarAtlas::new(&[StarredEngine { name: "six".to_owned(), engine }]);
    let page = pages::files(&report::star_atlas_page(&atlas), Format::GITHUB);
    let readme = &page.iter().find(|file| file.name == "README.md").expect("the page").text;
    assert!(readme.contains("| six | $`P_{1}^{+},\\; P_{1}^{-}"));
}
