//! Do the pages of the study in `reports/grigoryev` say what the program finds, and what the paper does?
//!
//! `CRANKSTAR_RENEW=1 cargo test --test suite grigoryev` writes them anew.

use std::f64::consts::TAU;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::{env, fs};

use num_rational::BigRational;

use crankstar::claim::{Provenance, Quote};
use crankstar::numbers;
use crankstar::page;

use crate::studies::study::{Found, Study, study};
use crate::studies::study_page::{study_page, study_tables};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/grigoryev")
}

fn read() -> &'static Study {
    static STUDY: OnceLock<Study> = OnceLock::new();
    STUDY.get_or_init(|| {
        let file = |name: &str| fs::read_to_string(folder().join(name)).map_err(|error| format!("{name}: {error}"));
        study("study.toml", &file("study.toml").expect("the study"), &file).expect("it reads")
    })
}

#[test]
fn the_study_is_as_stored() {
    let mut files = page::write(&study_page(read()), page::Format::GITHUB, &page::Options::default());
    files.extend(study_tables(read()));
    let entries = fs::read_dir(folder()).expect("the folder").map(|entry| entry.expect("an entry").file_name());
    let names = entries.map(|name| name.to_string_lossy().into_owned());
    let stale = names.filter(|name| !name.ends_with(".toml") && files.iter().all(|file| file.name != *name));
    let stale: Vec<String> = stale.collect();
    if env::var_os("CRANKSTAR_RENEW").is_some() {
        stale.iter().for_each(|name| fs::remove_file(folder().join(name)).expect("a stale file"));
        for file in &files {
            fs::write(folder().join(&file.name), &file.text).expect("a file");
        }
    } else {
        assert!(stale.is_empty(), "{stale:?}");
    }
    for file in &files {
        let stored = fs::read_to_string(folder().join(&file.name)).expect("a stored file");
        let first = stored.lines().zip(file.text.lines()).position(|(old, new)| old != new);
        assert!(stored == file.text, "{} differs, first in line {:?}", file.name, first.map(|line| line + 1));
    }
}

#[test]
fn exactly_these_checks_fail_and_each_is_corrected_in_its_conclusion() {
    let failing: Vec<(&str, &str)> = read()
        .statements
        .iter()
        .flat_map(|said| &said.checks)
        .filter(|check| !check.holds)
        .map(|check| (check.engine.written(), check.claim.written()))
        .collect();
    let right = [
        ("six", "moment 2 is of constant length nowhere"),
        ("six", "the firing is more even than one step before at 20°"),
        ("six", "the flywheel is lighter than one step before at 20°"),
    ];
    assert_eq!(failing, right);
    let words = ["less evenly", "second resultant"];
    for said in read().statements.iter().filter(|said| said.checks.iter().any(|check| !check.holds)) {
        assert!(words.iter().any(|word| said.conclusion.written().contains(word)), "{}", said.text.written());
    }
}

#[test]
fn every_check_counted_as_the_paper_s_names_its_place_and_all_that_is_reckoned_beside_it_holds() {
    let mut quoted = 0;
    for check in read().statements.iter().flat_map(|said| &said.checks) {
        match &check.provenance {
            Provenance::Quoted(Quote { place, words, .. }) => {
                assert!(
                    place.written().starts_with("section ") && words.written().split_whitespace().count() <= 20,
                    "{}",
                    check.claim.written()
                );
                quoted += 1;
            }
            Provenance::Own => assert!(check.holds, "{}: {}", check.engine.written(), check.claim.written()),
            Provenance::Folklore => panic!("{} is said of the paper", check.claim.written()),
        }
    }
    assert!(quoted > 20);
}

/// The study of this one check of the flat eights, without statements of its own.
fn one_check(check: &str) -> Result<Study, String> {
    let text = format!(
        "title = \"x\"\nsource = \"y\"\norders = [1, 2]\n[[family]]\nname = \"eight\"\nlayout = \"eight-flat.toml\"\n\
         sweep = \"vee.bank_angle=10..180:10\"\n[[statement]]\ntext = \"z\"\nconclusion = \"c\"\n[[statement.check]]\n\
         engine = \"eight\"\n{check}\n"
    );
    let file = |name: &str| fs::read_to_string(folder().join(name)).map_err(|error| format!("{name}: {error}"));
    study("study.toml", &text, &file)
}

#[test]
fn a_check_says_one_thing_and_what_it_says_is_read_as_nothing_else() {
    let holds =
        |check: &str| one_check(check).unwrap_or_else(|error| panic!("{check}: {error}")).statements[0].checks[0].holds;
    assert!(holds("firing = \"least\"\nonly_at = [90]") && holds("firing = \"most\"\nmet_at = [180]"));
    assert!(!holds("firing = \"most\"\nonly_at = [10]") && !holds("firing = \"even\"\nmet_at = [100]"));
    assert!(holds("vanishes = \"force 2\"\nonly_at = [180]") && !holds("vanishes = \"force 2\"\nonly_at = []"));
    assert!(holds("vanishes = \"force 1\"") && !holds("vanishes = \"force 2\""));
    for (wrong, keyword) in [
        ("firing = \"mots\"\nonly_at = [90]", "mots"),
        ("firing = \"most\"", "only_at"),
        ("firing = \"most\"\nonly_at = [90]\nmet_at = [90]", "both"),
        ("vanishes = \"force 2 sideways\"", "sideways"),
        ("vanishes = \"force two\"", "two"),
        ("constant = \"force 2 along\"\nonly_at = []", "part"),
        ("says = \"fires evenly\"\nvanishes = \"force 2\"", "two things"),
        ("says = \"fires evenly\"\nonly_at = [90]", "only_at"),
        ("flywheel = \"light\"\nonly_at = [90]", "light"),
        ("flywheel = \"lightest\"", "only_at"),
        ("flywheel = \"lightest\"\nonly_at = [90]", "[family.flywheel]"),
        ("torque_vanishes = \"1.25\"\nonly_at = [90]", "1.25"),
        ("", "nothing"),
    ] {
        let message = one_check(wrong).map(|_| ()).expect_err(wrong);
        assert!(message.contains(keyword), "{wrong}\n{message}");
    }
}

#[test]
fn every_list_of_angles_is_proved_to_be_complete() {
    for check in read().statements.iter().flat_map(|said| &said.checks) {
        if let Found::Values { everywhere, complete, .. } = &check.found {
            assert!(*everywhere || *complete, "{}", check.claim.written());
        }
    }
}

/// The angle by which the second bank of the six fires after the first, modulo 240°.
fn second_bank(angle: i64) -> i64 {
    if angle < 60 { angle + 120 } else { angle }
}

#[test]
fn the_torque_of_the_sixes_is_as_uneven_as_the_theory_of_the_gas_says() {
    let flywheels = read().families[0].flywheels.as_ref().expect("flywheels");
    let at = |angle: u32| {
        flywheels.points.iter().find(|point| point.at == BigRational::from_integer(angle.into())).expect("a point")
    };
    for (angle, ratio) in [(10, 1.32), (20, 1.68), (60, 3.17), (90, 2.06), (110, 1.32), (120, 1.0), (180, 3.17)] {
        let found = flywheels.ratio(at(angle));
        assert!((found - ratio).abs() < 5e-3, "{found} at {angle}°");
    }
    // J = ΔW/(δ ω²) in a ring of 120 mm, and for 180° the mass of the counterweights of 10°.
    for point in flywheels.all() {
        let omega = 2000.0 / 60.0 * TAU;
        let flywheel = point.energy * 50.0 / (omega * omega) / (0.12 * 0.12);
        assert!((point.flywheel - flywheel).abs() < 1e-9 * flywheel, "{}", point.at);
    }
    let in_line = flywheels.in_line.as_ref().expect("the engine in line");
    assert!(in_line.counterweights.expect("two planes").vanishes);
    // √3 m r a in planes 2a apart, m the 0.5 kg of a piston and the 0.4 kg of a pin.
    let counterweights = 2.0 * 3.0_f64.sqrt() / 2.0 * (0.5 + 0.4) * 0.043 / 0.05;
    for point in &flywheels.points {
        assert!((point.counterweights.expect("two planes").value - counterweights).abs() < 1e-9, "{}", point.at);
    }
}

#[test]
fn the_firing_stars_of_the_sixes_are_those_of_two_banks() {
    let flywheels = read().families[0].flywheels.as_ref().expect("flywheels");
    for point in &flywheels.points {
        let behind = second_bank(point.at.to_integer().try_into().expect("small"));
        for order in &point.orders {
            let halves = i64::from(order.order.halves());
            // S = 3 (1 + e^{−iκγ'}) where κ is a multiple of 1½, else 0; κγ' in half degrees.
            let (length, vanishes) = match halves % 3 {
                0 => {
                    (6.0 * (halves as f64 * behind as f64 / 4.0).to_radians().cos().abs(), halves * behind % 720 == 360)
                }
                _ => (0.0, true),
            };
            assert_eq!(order.vanishes(), vanishes, "order {} at {}°", order.order, point.at);
            let star = numbers::evaluate(point.star(order.order).expect("one class")).norm();
            assert!((star - length).abs() < 1e-12, "order {} at {}°", order.order, point.at);
        }
    }
}
