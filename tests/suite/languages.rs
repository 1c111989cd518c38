//! Does a page in another language say all that the English one says, with decimals as that language writes them?

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crankstar::engine::Engine;
use crankstar::family;
use crankstar::file::{self, Layout};
use crankstar::loads::{Method, bearing_loads};
use crankstar::page::{self, Document, Format, Language, Options};
use crankstar::remedy::{self, Wish};
use crankstar::report::{self, Compared};
use crankstar::text::Untrusted;

use crate::support::german::{has_words, outside};
use crate::support::pages;

/// The places of a phrase: how many, and which are named.
fn places(words: &str) -> Vec<String> {
    let parts = outside(words).flat_map(|part| part.split('{').skip(1)).filter_map(|part| part.split_once('}'));
    parts.map(|(place, _)| place.to_owned()).collect()
}

fn formulas(words: &str) -> BTreeSet<&str> {
    words.split('$').skip(1).step_by(2).collect()
}

/// The report on an engine, with its remedy and its bearings where it has any.
fn pages_of(engine: &Engine) -> Vec<Document> {
    let remedy = remedy::remedy(engine, &Wish { orders: vec![1, 2], ..Wish::default() });
    let solve = |method| bearing_loads(engine, engine.orders(), method).ok();
    let bearings = solve(Method::Continuous).zip(solve(Method::Determinate));
    let remedy = remedy.ok().map(|remedy| report::remedy_page(&remedy));
    let bearings = bearings.map(|(continuous, determinate)| report::bearings_page(engine, &continuous, &determinate));
    [Some(pages::document(engine)), remedy, bearings].into_iter().flatten().collect()
}

/// The pages on the layout files of a folder below this project.
fn pages_of_files(folder: &str) -> Vec<Document> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let files = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let files = files.map(|path| if path.is_dir() { path.join("layout.toml") } else { path });
    let texts = files.filter(|path| path.extension().is_some_and(|ending| ending == "toml"));
    let page = |path| match file::parse_layout("layout.toml", &fs::read_to_string(path).expect("a text")) {
        Ok(Layout::Known(engine, _)) => pages_of(&engine),
        Ok(Layout::Open(open)) => {
            let orders = family::classify(&open, open.orders()).expect("orders");
            vec![report::family_page(&open, &orders, false), report::family_answer(&open, &orders)]
        }
        Err(_) => Vec::new(),
    };
    texts.flat_map(page).collect()
}

fn assert_known(documents: &[Document]) {
    let phrases = documents.iter().flat_map(Document::phrases);
    let missing: BTreeSet<&str> = phrases.filter(|words| has_words(words) && !Language::De.knows(words)).collect();
    assert!(missing.is_empty(), "no German for {missing:#?}");
}

fn written(document: &Document, format: Format, language: Language) -> String {
    let options = Options { language, ..Options::default() };
    page::write(document, format, &options).remove(0).text
}

fn small_block() -> Engine {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/examples/v8-small-block/layout.toml");
    file::parse("layout.toml", &fs::read_to_string(path).expect("a layout file")).expect("an engine")
}

#[test]
fn every_entry_has_the_places_the_formulas_and_the_bold_words_of_its_key() {
    for (english, words) in Language::De.entries() {
        assert_eq!(places(english).len(), places(words).len(), "places of {english:?}");
        assert_eq!(formulas(english), formulas(words), "formulas of {english:?}");
        assert_eq!(english.matches("**").count(), words.matches("**").count(), "bold words of {english:?}");
    }
}

#[test]
fn pages_of_the_catalogue_have_german_for_every_phrase() {
    let engines = file::catalogue().expect("the catalogue reads");
    assert_known(&[report::catalogue_page(&engines), report::catalogue_answer(&engines)]);
    for (_, engine) in &engines {
        assert_known(&pages_of(engine));
    }
}

#[test]
fn pages_of_examples_families_and_odd_layouts_have_german_for_every_phrase() {
    for folder in ["reports/examples", "reports/families", "tests/pages"] {
        assert_known(&pages_of_files(folder));
    }
}

#[test]
fn a_comparison_has_german_for_every_phrase() {
    let engines = file::catalogue().expect("the catalogue reads");
    let compared =
        engines.iter().take(9).map(|(entry, engine)| Compared::new(Untrusted::new(entry.name), engine, &[1, 2]));
    let compared: Vec<Compared> = compared.collect::<Result<_, _>>().expect("orders");
    assert_known(&[report::compare_page(&compared), report::compare_answer(&compared)]);
}

#[test]
fn german_has_decimal_commas_and_english_points() {
    let engine = small_block();
    let page = pages::document(&engine);
    let (german, english) = (Language::De, Language::En);
    let text = written(&page, Format::GITHUB, german);
    // What a person wrote stays as it is written.
    let ours = text.lines().take_while(|line| !line.starts_with("## Der Motor")).collect::<Vec<_>>().join("\n");
    let digits: Vec<char> = ours.chars().collect();
    let is_point = |three: &[char]| three[0].is_ascii_digit() && three[1] == '.' && three[2].is_ascii_digit();
    assert!(!digits.windows(3).any(is_point), "a decimal point");
    assert!(text.contains("≈\u{a0}5,657") && text.contains("0,7252"));
    assert!(written(&page, Format::GITHUB, english).contains("≈\u{a0}5.657"));
}

#[test]
fn html_names_its_language() {
    let page = pages::document(&small_block());
    assert!(written(&page, Format::Html, Language::De).contains("<html lang=\"de\">"));
    assert!(written(&page, Format::Html, Language::En).contains("<html lang=\"en\">"));
    assert!(written(&page, Format::Html, Language::De).contains("aria-label=\"Inhalt\""));
}

#[test]
fn a_value_may_stand_in_another_order() {
    for (english, words) in Language::De.entries() {
        let named: Vec<usize> = places(words).iter().filter_map(|place| place.parse().ok()).collect();
        assert!(named.iter().all(|place| (1..=places(english).len()).contains(place)), "{english:?}");
    }
}
