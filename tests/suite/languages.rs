//! Does a page in another language say all that the English one says, with decimals as that language writes them?

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crankstar::accuracy::Timing;
use crankstar::claim::parse_claims;
use crankstar::data::TABLES;
use crankstar::engine::{Cycle, Engine};
use crankstar::file;
use crankstar::journal::cycle_loads;
use crankstar::loads::{Method, bearing_loads};
use crankstar::page::figure::Mark;
use crankstar::page::{self, Document, Format, Language, Options};
use crankstar::report::{
    self, AccuracyCase, AccuracyStudy, CompareStudy, Compared, FlywheelStudy, Question, RotorStudy, SearchStudy,
    TorqueStudy, ValuesStudy,
};
use crankstar::search::Problem;
use crankstar::text::Untrusted;

use crate::studies::catalogue;
use crate::support::german::{
    has_words, is_said, literals, names_of_keys, pages_of, pages_of_folders, pages_of_the_catalogue, phrases, places,
};
use crate::support::pages;
use crate::support::tables::{searched, swept};

fn formulas(words: &str) -> BTreeSet<&str> {
    words.split('$').skip(1).step_by(2).collect()
}

pub fn assert_known(documents: &[Document]) {
    let phrases = documents.iter().flat_map(phrases);
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
        assert_eq!(places(english), places(words), "places of {english:?}");
        assert_eq!(formulas(english), formulas(words), "formulas of {english:?}");
        assert_eq!(english.matches("**").count(), words.matches("**").count(), "bold words of {english:?}");
    }
}

#[test]
fn pages_of_the_catalogue_have_german_for_every_phrase() {
    let engines = file::catalogue().expect("the catalogue reads");
    assert_known(&[report::catalogue_answer(&engines)]);
    for (_, pages) in pages_of_the_catalogue() {
        assert_known(pages);
    }
}

#[test]
fn pages_of_examples_families_and_odd_layouts_have_german_for_every_phrase() {
    for (_, pages) in pages_of_folders() {
        assert_known(pages);
    }
}

#[test]
fn pages_of_engines_drawn_otherwise_have_german_for_every_phrase() {
    let four = crate::journal::four();
    for keys in ["rotation = 'clockwise'", "seen_from = 'flywheel'", "rotation = 'clockwise'\nseen_from = 'flywheel'"] {
        let four = four.replace("['gas']", "['gas', 'remedy']");
        let engine = file::parse("layout.toml", &format!("{keys}\n{four}"));
        let engine = engine.unwrap_or_else(|error| panic!("{keys}\n{error}"));
        assert_known(&pages_of(&engine));
        let masses = bearing_loads(&engine, engine.orders(), Method::Continuous).expect("bearings");
        let loads = cycle_loads(&engine).unwrap_or_else(|lack| panic!("{lack}"));
        assert_known(&[report::complete_bearings_page(&engine, &loads, &masses)]);
        let family = format!("{keys}\nvee = {{ bank_angle = 'phi', throws = [0] }}");
        let Ok(file::Layout::Open(family)) = file::parse_layout("layout.toml", &family) else { panic!("{keys}") };
        let orders = crankstar::family::classify(&family, &[1, 2]).expect("orders");
        assert_known(&[report::family_page(&family, &orders, false)]);
    }
}

#[test]
fn pages_of_the_torque_have_german_for_every_phrase() {
    let single = crate::gas::SPARK;
    let table: Vec<String> = (0..60).map(|row| format!("[{}, {}]", 12 * row, 1 + row % 7)).collect();
    let odd = format!("reading = 'gauge'\nunit = 'bar'\npressure = [{}]", table.join(", "));
    let (before, _) = single.split_once("process").expect("a process");
    let two =
        single.replace("throws = [0]", "throws = [0, 180]").replace("firing_order = '1'", "firing_angles = [0, 180]");
    let texts = [
        format!("effects = ['gas']\nspeed = 3000\n{single}[flywheel]\nirregularity = '1/50'"),
        format!("speed = 3000\n{single}[flywheel]\ninertia = 1"),
        format!("speed = 3000\n{single}[flywheel]\ninertia = 0.00001\nirregularity = '1/50'"),
        format!("speed = 3000\n{}", single.replace("[inline]", "pin_offset = '1 mm'\n[inline]") + "dead_centre = 'piston'"),
        format!("speed = 3000\n{}", single.replace("reciprocating_mass = '0.5 kg'\n", "")),
        single.replace("heat = '1100 J'", "mean_pressure = '8 bar'"),
        single.replace("heat = '1100 J'", "peak_pressure = '60 bar'"),
        format!("{before}{odd}"),
        format!("{}[[gas.cylinder]]\ncylinders = [2]\nheat = 0", two.replace("throws", "spacing = '0.1 m'\nthrows")),
        "cycle = 'two-stroke'\neffects = ['gas']\n[mechanism]\nstroke = 0.07\nrod_length = 0.14\n[inline]\nthrows = [0]\n[gas]\nbore = 0.09\n\
         process = 'compressor'\nintake_pressure = '1 bar'\ndelivery_pressure = '7 bar'\nclearance = 0.05"
            .to_owned(),
        "effects = ['gas']\n[inline]\nthrows = [0]".to_owned(),
    ];
    for text in texts {
        let engine = file::parse("layout.toml", &text).unwrap_or_else(|error| panic!("{text}\n{error}"));
        assert_known(&pages_of(&engine));
        if let Ok(study) = TorqueStudy::new(&engine) {
            assert_known(&[study.answer(), study.page()]);
        }
    }
}

const V8_GAS: &str = include_str!("../../reports/examples/v8-gas/layout.toml");
const I4_MOUNTS: &str = include_str!("../../reports/examples/i4-mounts/layout.toml");
const I6_TORSION: &str = include_str!("../../reports/examples/i6-torsion/layout.toml");

fn engine(text: &str) -> Engine {
    file::parse("layout.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn every_question_of_an_engine_has_german_for_every_phrase() {
    let four = file::catalogue().expect("the catalogue reads").into_iter().find(|(entry, _)| entry.name == "I4");
    let engines = [V8_GAS, I4_MOUNTS, I6_TORSION].map(engine).into_iter().chain(four.map(|(_, engine)| engine));
    let mut answered = BTreeSet::new();
    for engine in engines {
        for question in report::questions() {
            // None where the layout lacks what the question needs.
            let Some(Ok(study)) = report::ask(question, &engine, &[]) else { continue };
            assert_known(&[study.answer(), study.page()]);
            answered.insert(question);
        }
    }
    assert_eq!(answered, report::questions().collect(), "a question that no engine here has an answer for");
}

#[test]
fn every_other_question_has_german_for_every_phrase() {
    let shaft = file::parse_rotor("shaft.toml", include_str!("../../examples/shaft.toml")).expect("masses");
    let diagram = include_str!("../../examples/turning-moment.toml");
    let diagram = file::parse_diagram("diagram.toml", diagram).expect("a diagram");
    let (title, eight) = (Untrusted::new("V8"), engine(V8_GAS));
    let names = ["torque.cycle.mean", "torsion.modes.1.frequency"].map(|name| name.parse().expect("a name"));
    let values = || ValuesStudy::beside([(title.clone(), &eight)], &names);
    let engines = vec![Compared::new(title.clone(), &eight, &[1, 2]).expect("orders")];
    let (front, _) = searched(&Problem::inline(6, Cycle::FourStroke, &[1, 2]), false);
    let others: [Box<dyn Question>; 6] = [
        Box::new(RotorStudy::new(shaft).expect("it is solved")),
        Box::new(FlywheelStudy::new(diagram).expect("it fits")),
        Box::new(values().expect("values")),
        Box::new(CompareStudy { engines, values: values() }),
        Box::new(swept(V8_GAS, &["vee.bank_angle=0..180:60"], &[1, 2], &["1", "3/2"]).0),
        Box::new(SearchStudy { front, torsion: None }),
    ];
    // The verdicts of `classify` are on the pages of the catalogue.
    let mut looked_at: BTreeSet<&str> = report::questions().chain(["classify"]).collect();
    for study in others {
        assert_known(&[study.answer(), study.page()]);
        looked_at.insert(study.command());
    }
    let all = TABLES.iter().map(|(question, _)| *question).collect();
    assert_eq!(looked_at, all, "a question whose German no test looks at");
}

#[test]
fn values_at_crank_angles_have_german_for_every_phrase() {
    for text in [V8_GAS, "[inline]\nthrows = [0, 180]\n[mechanism]\nstroke = 1\nrod_length = 2\n"] {
        let engine = file::parse("layout.toml", text).expect("an engine");
        let gravity = engine.dimensions().mass.as_ref().map(|_| 9.81);
        let asked = report::AnglesAsked { every: Some(0.5), gravity, ..report::AnglesAsked::default() };
        for asked in [&asked, &report::AnglesAsked::default()] {
            let study = report::AngleStudy::new(&engine, asked).expect("values");
            assert_known(&[study.answer(), study.page()]);
        }
    }
}

#[test]
fn moments_of_project_guides_have_german_for_every_phrase() {
    let five = "cycle = 'two-stroke'\nspeed = 127\nfiring_order = '1-4-3-2-5'\n[inline]\nspacing = '1 m'\n[mechanism]\nstroke = '2 m'\n\
        rod_length = '2 m'\nreciprocating_mass = '1000 kg'\n";
    let weight = "[[counterweight]]\nangle = 90\nposition = '1 m'\nmass = '100 kg'\nradius = '1 m'\n";
    for text in [V8_GAS, five, &format!("{five}{weight}")] {
        let engine = file::parse("layout.toml", text).expect("an engine");
        let study = report::MomentsStudy::new(&[(engine.title().clone(), engine)]).expect("moments");
        assert_known(&[study.answer(), study.page()]);
    }
}

#[test]
fn engines_on_their_mounts_have_german_for_every_phrase() {
    let mirrored = "speed = 900\n[inline]\nthrows = [0, 180, 180, 0]\nspacing = '90 mm'\n[mechanism]\nstroke = '86 mm'\nrod_length = '143 mm'\n\
        reciprocating_mass = 1\n[block]\nmass = 100\ninertia = [9, 8, 5]\ncentre = [0, 0, 0]\n"
        .to_owned();
    let corners: String = [[1, 1], [1, -1], [-1, 1], [-1, -1]]
        .map(|[y, z]| format!("[[mount]]\nplace = [0, '{} mm', '{} mm']\nstiffness = 100\n", 300 * y, 200 * z))
        .concat();
    let halves = I4_MOUNTS.replace("[0, 180, 180, 0]", "[0, 180, 0, 180]").replace("1-3-4-2", "1-2-3-4");
    for text in [I4_MOUNTS, &(mirrored + &corners), &halves] {
        let engine = file::parse("layout.toml", text).unwrap_or_else(|error| panic!("{error}"));
        for orders in [vec![], vec!["1".parse().expect("an order")]] {
            let study = report::MountsStudy::new(&engine, &report::MountsAsked { orders, ..Default::default() });
            let study = study.unwrap_or_else(|error| panic!("{error}"));
            assert_known(&[study.answer(), study.page()]);
        }
    }
}

#[test]
fn masses_on_a_shaft_have_german_for_every_phrase() {
    let mass = |rest: &str| format!("[[mass]]\n{rest}");
    let known = "mass = 1\nradius = 1\nangle = 0\nposition = 0\n";
    let other = "mass = 1\nradius = 1\nangle = 60\nposition = 2\n";
    let wheel = |at: u32| mass(&format!("radius = 1\nposition = {at}\n"));
    let crank = mass("mass = 1\nreciprocating_mass = 1\nradius = 1\nangle = 0\nposition = 0\n");
    let twice = |wanted: &str| mass(known) + &mass(other) + &mass(wanted);
    let angles: String =
        [1, 2, 2].iter().zip(1..).map(|(m, z)| mass(&format!("mass = {m}\nradius = 1\nposition = {z}\n"))).collect();
    let texts = [
        mass(known),
        mass(known) + &mass("mass = 1\nradius = 1\nangle = 180\nposition = 0\n"),
        mass(known) + &wheel(1) + &wheel(2),
        mass(known) + &wheel(1) + &wheel(1),
        mass(known) + &wheel(0) + &wheel(0),
        mass(known) + &wheel(1),
        mass(known) + &mass("radius = 1\nangle = 90\nposition = 0\n"),
        twice("radius = 1\n"),
        twice("radius = 1\nangle = 90\n") + &mass("radius = 1\nangle = 200\n"),
        twice("radius = 1\nangle = 90\n") + &mass("radius = 1\nangle = 90\n"),
        mass(known) + &mass("mass = 1\nradius = 1\nangle = 180\nposition = 1\n") + &mass("radius = 1\n"),
        mass("mass = 0\nradius = 1\nangle = 0\nposition = 0\n") + &mass("radius = 1\n"),
        wheel(0) + &angles,
        wheel(0) + &angles.replace("mass = 1", "mass = 100"),
        format!("speed = 300\nshare = 0.5\n{crank}{}{}", wheel(1), wheel(2)),
        "secondary = true\n".to_owned() + &mass(known) + &wheel(1) + &wheel(2),
    ];
    for text in texts {
        let study =
            report::RotorStudy::new(file::parse_rotor("shaft.toml", &text).expect("masses")).expect("it is solved");
        assert_known(&[study.answer(), study.page()]);
    }
}

#[test]
fn turning_moment_diagrams_have_german_for_every_phrase() {
    let example = include_str!("../../examples/turning-moment.toml");
    let texts = [
        example.to_owned(),
        example.replace("speed = \"300 rpm\"\n", ""),
        "speed = 1800\ninertia = 1\ntorque_scale = '5 N m/mm'\nangle_scale = '1°/mm'\nareas = ['12 mm²', '-12 mm²']\n"
            .to_owned(),
        "speed = 1800\ninertia = 1\nirregularity = 0.01\nareas = ['12 J', '-12 J']\n".to_owned(),
        "mean = 0\nharmonics = [{ order = 2, cos = 1, sin = 1 }]\n".to_owned(),
        "speed = 300\ninertia = 1\npoints = [[0, 1], [360, 1]]\n".to_owned(),
    ];
    for text in texts {
        let diagram = file::parse_diagram("diagram.toml", &text).expect("a diagram");
        let study = report::FlywheelStudy::new(diagram).expect("it fits");
        assert_known(&[study.answer(), study.page()]);
    }
}

#[test]
fn pages_of_the_complete_loads_have_german_for_every_phrase() {
    let four = crate::journal::four();
    let texts = [
        four.clone(),
        four.replace("speed = 3000", "speed = 0"),
        four.replace("speed = 3000", "speed = 12000"),
        // Pistons heavier than their gas, and a misfire.
        four.replace("'0.5 kg'", "'9 kg'") + "[[gas.cylinder]]\ncylinders = [2]\nheat = 0",
        four.replace("speed = 3000\n", ""),
    ];
    for text in texts {
        let engine = file::parse("layout.toml", &text).unwrap_or_else(|error| panic!("{text}\n{error}"));
        let solve = |method| bearing_loads(&engine, engine.orders(), method).expect("bearings");
        let (masses, other) = (solve(Method::Continuous), solve(Method::Determinate));
        let pages = match cycle_loads(&engine) {
            Ok(loads) => vec![
                report::complete_bearings_answer(&engine, &loads),
                report::complete_bearings_page(&engine, &loads, &masses),
            ],
            Err(lack) => vec![report::without_gas(report::bearings_page(&engine, &masses, &other), &lack)],
        };
        assert_known(&pages);
        for picture in pages.iter().flat_map(Document::pictures) {
            let translated = Language::De.picture(picture);
            for (english, german) in picture.figure.marks.iter().zip(&translated.figure.marks) {
                let (Mark::Text { text: english, .. }, Mark::Text { text: german, .. }) = (english, german) else {
                    continue;
                };
                assert!(english != german || !english.contains(" in "), "{english}");
            }
        }
    }
}

#[test]
fn the_accuracy_of_torque_and_bearings_has_german_for_every_phrase() {
    let single = format!("speed = 3000\nbearings = ['0.05 m', '-0.05 m']\neffects = ['gas']\n{}", crate::gas::SPARK);
    let engine = file::parse("layout.toml", &single.replace("[gas]", "spacing = '1 m'\n[gas]")).expect("it reads");
    for timing in [Timing::Off, Timing::On] {
        let cases = vec![AccuracyCase::of(&engine, &[], timing).expect("a torque")];
        let study = AccuracyStudy { engine: engine.clone(), cases };
        assert_known(&[study.page(), study.answer()]);
    }
}

#[test]
fn pages_of_forces_with_gas_have_german_for_every_phrase() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/thesis/forces");
    let engine = |name: &str| {
        let text = fs::read_to_string(folder.join(name)).expect("a layout file");
        file::parse(name, &text).map_err(|error| error.to_string())
    };
    let text = fs::read_to_string(folder.join("claims.toml")).expect("the claims");
    let more = "[[claim]]\nlayout = 'i3.toml'\nsays = 'rod length = r'\n";
    let claims = parse_claims("claims.toml", &(text + more), &engine).expect("claims");
    assert_known(&[report::claims_page(&claims)]);
    let v8 = engine("v8-cross.toml").expect("an engine");
    let loads = cycle_loads(&v8).expect("loads");
    let masses = bearing_loads(&v8, &[1, 2], Method::Continuous).expect("loads");
    assert_known(&[
        report::complete_bearings_page(&v8, &loads, &masses),
        report::complete_bearings_answer(&v8, &loads),
    ]);
    let slow = file::parse("slow.toml", &v8.file().written().replace("speed = \"6000 rpm\"", "")).expect("an engine");
    let compared = [&v8, &slow].map(|engine| Compared::new(Untrusted::new("V8"), engine, &[1]).expect("orders"));
    assert_known(&[report::compare_page(&compared), report::compare_answer(&compared)]);
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
fn a_fragment_loads_no_package() {
    let options = Options { language: Language::De, fragment: true, ..Options::default() };
    let text = page::write(&pages::document(&small_block()), Format::Latex, &options).remove(0).text;
    assert!(text.lines().all(|line| line.starts_with('%') || !line.contains("\\usepackage")), "{text}");
    assert!(text.contains("% \\usepackage[ngerman]{babel}"), "{text}");
}

#[test]
fn every_entry_translates_what_the_program_says() {
    // Names in the drawings of the tests' own pages find their places by how wide they are in every language.
    let said = literals(&["src", "templates", "tests/suite/studies"]);
    assert!(said.len() > 2000, "{}", said.len());
    let entries = Language::De.entries().map(|(english, _)| english);
    let dead: Vec<&str> = entries.filter(|english| !is_said(&said, english)).collect();
    assert!(dead.is_empty(), "nothing says {dead:#?}");
    assert!(!is_said(&said, "A sentence that the program does not say."));
}

#[test]
fn every_name_in_a_drawing_has_german() {
    let engines = file::catalogue().expect("the catalogue reads");
    let index = catalogue::page(&engines);
    let pages = pages_of_the_catalogue().iter().chain(pages_of_folders()).flat_map(|(_, pages)| pages);
    let text = |mark: &Mark| if let Mark::Text { text, .. } = mark { Some(text.clone()) } else { None };
    let pictures = pages.chain([&index]).flat_map(Document::pictures);
    // Most names stand in many drawings.
    let names: BTreeSet<String> = pictures.flat_map(|picture| picture.figure.marks.iter().filter_map(text)).collect();
    let mut missing = BTreeSet::new();
    for english in &names {
        let german = Language::De.label(english);
        // Names of cylinders, symbols and units stay; a word of more than two letters, small but for the first, is English.
        let words = english.split(|letter: char| !letter.is_alphabetic());
        let small = |word: &&str| word.chars().count() > 2 && word.chars().skip(1).all(char::is_lowercase);
        let is_word = |word: &str| words_of(&german).any(|other| other == word) && !IN_BOTH.contains(&word);
        missing.extend(words.filter(small).filter(|word| is_word(word)).map(|word| format!("{word} in {english:?}")));
    }
    assert!(missing.is_empty(), "no German for {missing:#?}");
}

#[test]
fn every_number_of_a_layout_file_has_a_german_name() {
    let keys = include_str!("../../src/kernel/file/schema/keys.txt");
    let kind = |line: &str| Some(line.split_once(": ")?.1.split_once(" = ")?.0.to_owned());
    let is_number = |line: &&str| {
        kind(line).is_some_and(|kind| NUMBERS.iter().any(|number| kind.trim_matches('[').starts_with(number)))
    };
    let numbers = keys.lines().filter(is_number);
    let names: BTreeSet<String> = numbers.flat_map(names_of_keys).collect();
    assert!(names.len() > 60, "{}", names.len());
    let own = |name: &String| Language::De.entries().any(|(english, german)| english == name && !german.contains("{}"));
    let missing: Vec<&String> = names.iter().filter(|name| !own(name)).collect();
    assert!(missing.is_empty(), "no German for {missing:?}");
}

/// Kinds of keys that can be swept.
const NUMBERS: [&str; 13] = [
    "angle",
    "length",
    "mass",
    "speed",
    "pressure",
    "inertia",
    "stress",
    "torque",
    "spring",
    "number",
    "heat",
    "damping",
    "stiffness",
];

fn words_of(text: &str) -> impl Iterator<Item = &str> {
    text.split(|letter: char| !letter.is_alphabetic())
}

/// Words that are German too.
const IN_BOTH: [&str; 7] = ["cos", "sin", "min", "irrational", "Amplitude", "Campbell", "Moment"];

#[test]
fn every_engine_of_the_catalogue_has_a_german_title_and_no_other_title_is_changed() {
    let engines = file::catalogue().expect("the catalogue reads");
    for (known, engine) in &engines {
        assert!(Language::De.title(engine.title()).is_some(), "{}", known.name);
        assert!(Language::En.title(engine.title()).is_none(), "{}", known.name);
    }
    // What a person wrote stays as it is, though it sounds the same.
    for (known, engine) in &engines {
        let own = file::parse("own.toml", known.text).expect("it reads");
        assert!(Language::De.title(own.title()).is_none() && own.title().written() == engine.title().written());
    }
    for written in ["In-line four", "In-line four, flat crankshaft ", "My V12, 60°", "{}"] {
        assert!(Language::De.title(&Untrusted::new(written)).is_none(), "{written}");
    }
}

#[test]
fn german_sentences_say_what_the_english_ones_do() {
    let said = |english: &'static str| Language::De.fixed(english);
    let family = Language::De
        .entries()
        .find(|(english, _)| english.starts_with("**0**: vanishes for all values of the unknowns, proved"));
    assert!(family.is_some_and(|(_, german)| german.starts_with("**0**: verschwindet")), "{family:?}");
    let free = "No order has a free moment: its moment vanishes or is that of its force in one plane; one period of {} orders proves it.";
    assert!(said(free).starts_with("Keine Ordnung hat ein freies Moment: "), "{}", said(free));
    let exact = said(
        "Decimals are right where they equal the true value, rounded: for √10 both 3.2 and 3.162 are right, 3.15 is not. A number without a point is taken as exact.",
    );
    assert!(exact.ends_with("Eine Zahl ohne Dezimalpunkt gilt als exakt."), "{exact}");
    assert!(said("The peaks of the bearings in {} are, in order, {}: {}.").contains("der Reihe nach {}"));
}
