//! Do engines that were built balance as is known of them, and do their pages still say so?
//!
//! `CRANKSTAR_RENEW=1 cargo test --test suite engines_of_the_world` writes the pages anew.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crankstar::claim::{Published, parse_claims};
use crankstar::engine::Engine;
use crankstar::family::{self, OpenSum, When};
use crankstar::file::{self, Layout};
use crankstar::page::Format;
use crankstar::proof::{Sense, Vector, check_certificate, check_open_document};
use crankstar::remedy::{Request, remedy};
use crankstar::report;

use crate::studies::world::{BuiltEngine, engines_page};
use crate::support::{golden, pages, time_domain};

/// The engines of which a known fact is not what the layout file leads to, with a reason in the facts.
const DIFFER: [&str; 2] = ["ford-essex-v4", "honda-rc211v"];

/// Shafts that are built: engine, turns in a revolution of the crank, with it (+) or against it (−).
const SHAFTS: [(&str, &[i32]); 21] = [
    ("bmw-f650", &[-1]),
    ("fiat-twinair", &[-1]),
    ("kawasaki-er6", &[-1]),
    ("yamaha-trx850", &[-1]),
    ("ktm-lc8", &[-1]),
    ("aprilia-rsv", &[-1]),
    ("bmw-r1200", &[-1]),
    ("triumph-rocket", &[-1]),
    ("yamaha-r1", &[-1]),
    ("ford-taunus-v4", &[-1]),
    ("ford-sho-v8", &[-1]),
    ("aprilia-rsv4", &[-1]),
    ("buick-3800", &[-1]),
    ("mercedes-m112", &[-1]),
    ("international-vt275", &[-1]),
    ("lexus-lfa", &[-1]),
    ("lamborghini-gallardo", &[-1]),
    ("mitsubishi-4g63", &[2, -2]),
    ("porsche-944", &[2, -2]),
    ("marine-two-stroke-5", &[2, -2]),
    ("marine-two-stroke-6", &[2, -2]),
];

/// Engines that are built without a shaft, since no order 1 and, where it is so, no order 2 is left for one.
const WITHOUT: [(&str, &[u32]); 13] = [
    ("ducati-90", &[1]),
    ("honda-nv400", &[1]),
    ("honda-vfr", &[1]),
    ("bmw-f800", &[1, 2]),
    ("bmw-six", &[1, 2]),
    ("straight-eight", &[1, 2]),
    ("ford-cologne-v6", &[1]),
    ("chevrolet-small-block", &[1, 2]),
    ("gm-ls", &[1, 2]),
    ("ferrari-v12", &[1, 2]),
    ("rolls-royce-merlin", &[1, 2]),
    ("porsche-911", &[1, 2]),
    ("ferrari-flat-twelve", &[1, 2]),
];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/engines")
}

fn names() -> Vec<String> {
    let entries = fs::read_dir(folder()).expect("engines").map(|entry| entry.expect("an entry").path());
    let folders = entries.filter(|path| path.is_dir());
    let names: BTreeSet<String> =
        folders.map(|path| path.file_name().expect("a name").to_string_lossy().into_owned()).collect();
    names.into_iter().collect()
}

fn text(name: &str, file: &str) -> String {
    fs::read_to_string(folder().join(name).join(file)).unwrap_or_else(|error| panic!("{name}/{file}: {error}"))
}

fn engine(name: &str) -> Engine {
    file::parse("engine.toml", &text(name, "engine.toml")).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn built(name: &str) -> BuiltEngine {
    let find = |_: &str| Ok(engine(name));
    let facts = parse_claims("facts.toml", &text(name, "facts.toml"), &find);
    let facts = facts.unwrap_or_else(|error| panic!("{name}: {error}"));
    let family = match file::parse_layout("engine.toml", &text(name, "engine.toml")) {
        Ok(Layout::Known(engine, Some(open))) => family::classify(&open, engine.orders()).expect("orders"),
        _ => Vec::new(),
    };
    BuiltEngine { name: name.to_owned(), engine: engine(name), family, facts }
}

/// The turns of the shafts that an order needs, with their sense.
fn shafts(engine: &Engine, order: u32) -> BTreeSet<i32> {
    let remedy = remedy(engine, &Request { orders: vec![order], ..Request::default() }).expect("a remedy");
    assert!(remedy.holds());
    let signed = |sense: Sense| if sense == Sense::Direct { order as i32 } else { -(order as i32) };
    remedy.shafts.iter().map(|shaft| signed(shaft.sense)).collect()
}

#[test]
fn shafts_that_are_built_are_those_that_are_needed() {
    for (name, turns) in SHAFTS {
        let order = turns[0].unsigned_abs();
        assert_eq!(shafts(&engine(name), order), turns.iter().copied().collect(), "{name}");
    }
}

#[test]
fn the_double_wasp_has_its_shafts_at_twice_crank_speed_for_its_master_rods() {
    let text = text("pratt-whitney-r2800", "engine.toml");
    assert!(shafts(&engine("pratt-whitney-r2800"), 2).contains(&2));
    let (before, _) = text.split_once("[articulated]").expect("master rods");
    let concentric = file::parse("engine.toml", before).expect("it reads");
    assert_eq!(shafts(&concentric, 2), BTreeSet::new());
}

#[test]
fn engines_without_a_shaft_need_none_at_the_orders_they_are_known_for() {
    for (name, orders) in WITHOUT {
        for order in orders {
            assert_eq!(shafts(&engine(name), *order), BTreeSet::new(), "{name}, order {order}");
        }
    }
}

#[test]
fn what_is_known_and_what_is_found_agree_but_where_a_reason_is_given() {
    let all = names();
    assert!(all.len() >= 40, "{}", all.len());
    for name in all {
        let built = built(&name);
        let differs = DIFFER.contains(&name.as_str());
        let [statements, hold] = built.agreement();
        assert!(statements > 0 && built.agrees() != differs, "{name}: {hold} of {statements}");
        let reasons = built.facts.statements.iter().filter(|fact| fact.conclusion.is_some()).count();
        assert_eq!(reasons > 0, differs, "{name}");
    }
}

#[test]
fn every_fact_names_its_source_and_every_layout_is_short() {
    for name in names() {
        let told =
            |fact: &Published| fact.text.is_some() && fact.source.as_ref().is_some_and(|at| !at.written().is_empty());
        assert!(built(&name).facts.statements.iter().all(told), "{name}");
        let layout = text(&name, "engine.toml");
        assert!(layout.lines().count() <= 20, "{name}: {}", layout.lines().count());
        let says_whence = ["#", "from memory", "estimated"].iter().any(|word| layout.contains(word));
        assert!(!layout.contains("[mechanism]") || says_whence, "{name}: numbers without their source");
    }
}

#[test]
fn every_answer_to_a_fact_is_decided_and_its_certificates_hold() {
    for name in names() {
        for claim in built(&name).facts.statements.iter().flat_map(|fact| &fact.claims) {
            let answer = claim.answer();
            assert_ne!(answer.status, crankstar::claim::Status::NotDecided, "{name}: {}", claim.says.written());
            for evidence in &answer.evidence {
                let terms = evidence.sum().terms().iter();
                let vectors: Vec<Vector> = terms
                    .map(|term| Vector { angle: term.angle.turns().clone(), weight: term.weight.clone() })
                    .collect();
                check_certificate(&vectors, evidence.vanishes(), evidence.certificate())
                    .expect("the certificate holds");
            }
        }
    }
}

/// Without phasors: pistons on their exact paths through a revolution, their forces added up at each moment.
#[test]
fn sums_of_every_engine_are_those_of_the_time_domain() {
    for name in names() {
        let engine = engine(&name);
        for order in [1, 2, 3, 4, 6] {
            let worst = time_domain::difference(&engine, order);
            assert!(worst < 1e-9, "{name}, order {order}: {worst}");
        }
    }
}

#[test]
fn the_angle_of_the_v5_is_the_arc_cosine_of_a_quarter_exactly() {
    let layout = text("honda-rc211v", "engine.toml").replace("values = { phi = 75.5 }", "");
    let Ok(Layout::Open(open)) = file::parse_layout("engine.toml", &layout) else { panic!("an angle is open") };
    let orders = family::classify(&open, &[1]).expect("orders");
    let [direct, reverse] = &orders[0].force;
    assert!(direct.never());
    let [OpenSum { when: When::Cosine(found), .. }] = reverse.sums.as_slice() else { panic!("{reverse:?}") };
    assert_eq!((found.phi.abs(), found.cosine.to_string().as_str()), (BigRational::one(), "1/4"));
    assert!(found.delta.is_zero() && found.turn.is_zero());
    // The angle as built is that one, rounded; 104.5° is what is left to half a turn.
    assert!((0.25_f64.acos().to_degrees() - 75.5).abs() < 0.05);
    let checked = check_open_document(&report::open_document(&open, &orders)).expect("it holds");
    assert!(checked.counts.certificates() > 0);
}

fn report(layout: &str) -> BTreeMap<String, String> {
    let page = match file::parse_layout("engine.toml", layout).expect("it reads") {
        Layout::Known(engine, open) => pages::document_of(&engine, open.as_deref()),
        Layout::Open(_) => panic!("an engine that was built has no open angle"),
    };
    pages::files(&page, Format::GITHUB).into_iter().map(|file| (file.name, file.text)).collect()
}

#[test]
fn reports_on_engines_of_the_world_are_as_stored() {
    for name in names() {
        let layout = text(&name, "engine.toml");
        let mut files = report(&layout);
        files.insert("engine.toml".to_owned(), layout);
        files.insert("facts.toml".to_owned(), text(&name, "facts.toml"));
        golden::compare(&folder().join(&name), &files);
    }
}

#[test]
fn the_index_of_engines_of_the_world_is_as_stored() {
    let engines: Vec<BuiltEngine> = names().iter().map(|name| built(name)).collect();
    let files = pages::files(&engines_page(&engines), Format::GITHUB);
    golden::compare(&folder(), &files.into_iter().map(|file| (file.name, file.text)).collect());
}
