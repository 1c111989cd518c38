//! Does `reports/thesis` say of chapter 6 of the thesis what an independent computation says, and is it as stored?
//!
//! `CRANKSTAR_RENEW=1 cargo test --test suite thesis` writes its pages anew.

use std::path::{Path, PathBuf};
use std::{env, fs};

use crankstar::claim::{Claims, Condition, Provenance, Statement, Status, answer, parse_claims, parse_statement};
use crankstar::engine::{Draft, Engine};
use crankstar::file;
use crankstar::loads::{Method, bearing_loads, usual_bearing_orders};
use crankstar::page::{self, Format, Options};
use crankstar::proof::{Vector, check_certificate};
use crankstar::report;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/thesis")
}

fn engine(name: &str) -> Engine {
    let text = fs::read_to_string(folder().join(name)).expect("a layout file");
    file::parse(name, &text).unwrap_or_else(|error| panic!("{error}"))
}

fn claims() -> Claims {
    claims_in("")
}

/// The claims of a folder below that of the thesis.
fn claims_in(within: &str) -> Claims {
    let text = fs::read_to_string(folder().join(within).join("claims.toml")).expect("the claims");
    let find = |name: &str| match file::find(name) {
        Some(entry) => entry.engine().map_err(|error| error.to_string()),
        None => Ok(engine(&Path::new(within).join(name).to_string_lossy())),
    };
    parse_claims("claims.toml", &text, &find).unwrap_or_else(|error| panic!("{error}"))
}

/// The layout files of the folder, by name without ending.
fn engines() -> Vec<String> {
    let entries = fs::read_dir(folder()).expect("the folder").map(|entry| entry.expect("an entry").path());
    let names = entries.filter(|path| path.extension().is_some_and(|ending| ending == "toml"));
    let mut names: Vec<String> =
        names.map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned()).collect();
    names.retain(|name| name != "claims");
    names.sort();
    names
}

#[test]
fn what_the_thesis_says_holds_but_for_three_claims_and_all_that_is_reckoned_beside_it_holds() {
    let claims = claims();
    let all = claims.statements.iter().flat_map(|statement| &statement.claims);
    let mut wrong = Vec::new();
    for claim in all {
        let answer = claim.answer();
        assert_ne!(answer.status, Status::NotDecided, "{}: {}", claim.engine.written(), claim.says.written());
        if !answer.status.holds() {
            wrong.push(format!("{} {}", claim.engine.written(), claim.says.written()));
            assert_ne!(claim.provenance, Provenance::Own, "{}: {}", claim.engine.written(), claim.says.written());
        }
        for evidence in &answer.evidence {
            let vector = |term: &crankstar::exact::Term| Vector {
                angle: term.angle.turns().clone(),
                weight: term.weight.clone(),
            };
            let terms: Vec<Vector> = evidence.sum().terms().iter().map(vector).collect();
            check_certificate(&terms, evidence.vanishes(), evidence.certificate()).expect("the certificate holds");
        }
    }
    assert_eq!(
        wrong,
        [
            "v8-cross.toml first-order direct moment of the rotating masses vanishes",
            "v8-cross.toml second-order direct moment does not vanish",
            "v8-cross.toml second-order reverse moment does not vanish",
        ]
    );
}

#[test]
fn which_bearings_feel_the_most_is_the_same_at_the_orders_that_the_thesis_keeps() {
    for claim in claims().statements.iter().flat_map(|statement| &statement.claims) {
        let Statement::WorstBearings(_) = claim.statement else { continue };
        let layout = Draft { orders: vec![1, 2], ..claim.layout.clone().into_draft() }.build().expect("it holds");
        let at_two_orders = answer(&layout, &claim.statement, None).status;
        assert_eq!(at_two_orders, claim.answer().status, "{}: {}", claim.engine.written(), claim.says.written());
    }
}

/// Amplitudes of an independent computation in floats from the thesis's tables.
#[rustfmt::skip]
const AMPLITUDES: [(&str, &str); 22] = [
    ("i3.toml", "first-order direct moment of the rotating masses ≈ 1538.5 N·m"),
    ("i3.toml", "first-order direct moment of the pistons ≈ 1000.0 N·m"),
    ("i3.toml", "first-order direct moment of all masses ≈ 2538.56 N·m"),
    ("i3.toml", "first-order reverse moment of all masses ≈ 1000.0 N·m"),
    ("i3.toml", "second-order direct moment = 250.0 N·m ± 0.05"),
    ("i3-065.toml", "first-order direct moment of all masses ≈ 888.49 N·m"),
    ("i3-065.toml", "first-order direct moment of the counterweights ≈ 1650.06 N·m"),
    ("i3-065.toml", "crankshaft mass = 4.08375 kg"),
    ("i3-100.toml", "first-order direct moment of the counterweights ≈ 2538.56 N·m"),
    ("i3-skewed.toml", "first-order direct force of all masses ≈ 7328.18 N"),
    ("i3-skewed.toml", "first-order direct moment of all masses ≈ 235.63 N·m"),
    ("v8-flat.toml", "second-order direct force = 8165.3 N ± 0.05"),
    ("v8-flat.toml", "second-order force = 16330.5 N ± 0.05"),
    ("v8-flat.toml", "second-order moment = 130.64 N·m ± 0.005"),
    ("v8-cross.toml", "first-order direct moment of the rotating masses ≈ 5393.2 N·m"),
    ("v8-cross.toml", "first-order direct moment of the pistons ≈ 4381.9 N·m"),
    ("v8-cross.toml", "first-order direct moment of all masses ≈ 9775.11 N·m"),
    ("v8-cross-065.toml", "first-order direct moment of all masses ≈ 3421.29 N·m"),
    ("v8-cross-065.toml", "first-order direct moment of the counterweights ≈ 6353.82 N·m"),
    ("v8-cross-100.toml", "first-order direct moment of the counterweights ≈ 9775.11 N·m"),
    ("v8-cross-100.toml", "crankshaft mass = 11.6 kg"),
    ("v8-cross-skewed.toml", "first-order direct moment of all masses ≈ 1733.02 N·m"),
];

#[test]
fn amplitudes_are_those_of_an_independent_computation() {
    for (name, says) in AMPLITUDES {
        let statement = parse_statement(says).unwrap_or_else(|mistake| panic!("{says}: {mistake:?}"));
        // The thesis takes the first term of c_2.
        let status = answer(&engine(name), &statement, None).status;
        let by_the_first_term = Status::TrueOnlyIf { conditions: vec![Condition::FirstTermAlone], met: true };
        assert!(status == Status::True || status == by_the_first_term, "{name}: {says}: {status:?}");
    }
}

#[test]
fn a_claim_that_is_off_by_a_little_is_false() {
    for (name, says) in [
        ("i3.toml", "first-order direct moment of all masses ≈ 2538.46 N·m"),
        ("i3.toml", "first-order direct moment of all masses plane 31°"),
        ("i3-065.toml", "crankshaft mass = 4.0836 kg"),
        ("i3-065.toml", "first-order direct moment of the counterweights vanishes"),
        ("v8-cross.toml", "worst main bearing 2"),
        ("v8-cross.toml", "worst main bearings 2, 3 and 4"),
        ("i3.toml", "worst main bearings 1, 2 and 3"),
        ("i3.toml", "largest main-bearing load = 18800 N ± 50"),
    ] {
        let statement = parse_statement(says).unwrap_or_else(|mistake| panic!("{says}: {mistake:?}"));
        assert_eq!(answer(&engine(name), &statement, None).status, Status::False, "{name}: {says}");
    }
    for says in [
        "first-order torque of all masses vanishes",
        "worst main bearing zero",
        "crankshaft mass = 4 stone",
        "largest main-bearing load is 3 N",
    ] {
        assert!(parse_statement(says).is_err(), "{says}");
    }
    let i4 = file::find("I4").expect("an engine").engine().expect("reads");
    for says in ["worst main bearing 1", "crankshaft mass = 1 kg"] {
        let statement = parse_statement(says).unwrap_or_else(|mistake| panic!("{says}: {mistake:?}"));
        assert_eq!(answer(&i4, &statement, None).status, Status::NotDecided, "I4 has no numbers: {says}");
    }
}

fn compare(path: &Path, text: &str) {
    if env::var_os("CRANKSTAR_RENEW").is_some() {
        fs::create_dir_all(path.parent().expect("a folder")).expect("the folder");
        fs::write(path, text).expect("a file");
    }
    let stored = fs::read_to_string(path).unwrap_or_default();
    assert!(stored == text, "{} differs", path.display());
}

#[test]
fn the_formulas_of_section_2_hold_but_for_two_that_are_printed_amiss() {
    let claims = claims_in("forces");
    let mut wrong = Vec::new();
    for claim in claims.statements.iter().flat_map(|statement| &statement.claims) {
        let answer = claim.answer();
        assert_ne!(answer.status, Status::NotDecided, "{}", claim.says.written());
        if !answer.status.holds() {
            assert_ne!(claim.provenance, Provenance::Own, "{}: {}", claim.engine.written(), claim.says.written());
            wrong.push(claim.says.written().to_owned());
        }
    }
    assert_eq!(
        wrong,
        [
            "piston velocity = ω r (sin θ + 1/λ · 2 λ sin θ cos θ / (2√(1 − λ² sin² θ)))",
            "force on the frame along the axis = F_ALT + F_ROT cos θ",
        ]
    );
    // Every equation of section 2.3 is answered.
    let text = fs::read_to_string(folder().join("forces/claims.toml")).expect("the claims");
    for equation in 15..=31 {
        assert!(text.contains(&format!("(2.{equation})")), "equation (2.{equation})");
    }
    let page = page::write(&report::claims_page(&claims), Format::GITHUB, &Options::default()).remove(0);
    compare(&folder().join("forces/claims.md"), &page.text);
}

#[test]
fn the_pages_are_as_stored() {
    let page = page::write(&report::claims_page(&claims()), Format::GITHUB, &Options::default()).remove(0);
    compare(&folder().join("claims.md"), &page.text);
    let readme = fs::read_to_string(folder().join("README.md")).expect("the page that leads to the others");
    for name in engines() {
        let layout = engine(&format!("{name}.toml"));
        let orders = usual_bearing_orders(&layout);
        let solve = |method| bearing_loads(&layout, &orders, method).expect("the loads of the bearings");
        let page = report::bearings_page(&layout, &solve(Method::Continuous), &solve(Method::Determinate));
        let files = page::write(&page, Format::GITHUB, &Options::default());
        for file in &files {
            compare(&folder().join(&name).join(&file.name), &file.text);
        }
        let stored = fs::read_dir(folder().join(&name)).expect("a folder").count();
        assert_eq!(stored, files.len(), "{name}: a file that the program does not write");
        assert!(
            readme.contains(&format!("({name}/bearings.md)")) && readme.contains(&format!("({name}.toml)")),
            "{name}"
        );
    }
}
