//! Is every reason that a proof gives true, and is it about the polygons that are drawn and certified?

use std::f64::consts::TAU;

use crankstar::engine::Engine;
use crankstar::exact::{PhasorSum, Term, Turn};
use crankstar::file;
use crankstar::page::{Block, Format, text_in};
use crankstar::proof::{Certificate, Polygon, Quantity};
use crankstar::report::{verdict_argument, worked_example};
use crankstar::verdict::{
    Component, Reason, Size, Verdict, corners, drawn_polygons, mirror_partners, opposed_partners, reason,
};
use num_traits::{Signed, ToPrimitive, Zero};

use crate::support::every_verdict::{all_engines, all_verdicts};
use crate::support::verdicts;

fn written(form: &str) -> Engine {
    file::parse("layout.toml", &format!("title = 'engine'\n{form}")).expect("it reads")
}

fn named(name: &str) -> Engine {
    file::find(name).expect("a name of the catalogue").engine().expect("it reads")
}

fn degrees(angle: &Turn) -> f64 {
    angle.turns().to_f64().expect("a number") * 360.0
}

fn total(polygons: &[Polygon]) -> PhasorSum {
    polygons.iter().fold(PhasorSum::new(Vec::new()), |sum, polygon| sum.plus(&corners(polygon)))
}

/// The part of a vector along a direction, in decimals.
fn along(term: &Term, direction: &Turn) -> f64 {
    let angle = (&term.angle - direction).turns().to_f64().expect("a number") * TAU;
    term.weight.to_f64().expect("a number") * angle.cos()
}

/// Whether the polygons drawn are the star drawn, and those of the certificate, which may be turned with pairs beside them.
fn check_polygons(verdict: &Verdict) {
    let drawn = verdict.sum.positive();
    let shown = drawn_polygons(verdict);
    assert_eq!(total(&shown).collected(), drawn.collected(), "{verdict:?}");
    let Certificate::Polygons { polygons } = &verdict.certificate else { panic!("it is zero") };
    let odd = |list: &[Polygon]| list.iter().filter(|one| one.sides != 2).cloned().collect::<Vec<_>>();
    if shown.iter().any(|polygon| polygon.weight.is_negative()) {
        return;
    }
    let lines = |list: &[Polygon]| total(list).on_lines();
    if verdict.sum.terms().iter().all(|term| !term.weight.is_negative()) {
        let mut certified = polygons.clone();
        let mut drawn = shown.clone();
        certified.sort_by(|a, b| (a.sides, &a.rotation).cmp(&(b.sides, &b.rotation)));
        drawn.sort_by(|a, b| (a.sides, &a.rotation).cmp(&(b.sides, &b.rotation)));
        if polygons.iter().all(|one| one.weight.is_positive()) {
            assert_eq!(drawn, certified, "what is certified is drawn");
        }
    } else if odd(&shown).len() == odd(polygons).len() {
        assert_eq!(lines(&odd(&shown)), lines(&odd(polygons)), "the same polygons, turned");
    }
}

fn check_component(verdict: &Verdict, found: &Component) {
    assert_eq!(found.vectors, verdict.sum.on_lines());
    let decimal: f64 = found.vectors.iter().map(|term| along(term, &found.along)).sum();
    assert!(decimal > 0.0);
    match &found.size {
        Size::Roots(form) => {
            assert!((form.to_float() - decimal).abs() < 1e-9, "{form} is {decimal}");
            assert!(!form.terms().is_empty());
        }
        Size::Between(low, high) => {
            let [low, high] = [low, high].map(|end| end.to_f64().expect("a number"));
            assert!(0.0 < low && low <= decimal + 1e-9 && decimal - 1e-9 <= high, "{low} {decimal} {high}");
        }
    }
    if found.is_mirror_line {
        let image = |term: &Term| Term { angle: &found.along.times(2) - &term.angle, weight: term.weight.clone() };
        assert_eq!(PhasorSum::new(found.vectors.iter().map(image).collect()).collected(), found.vectors);
    }
}

fn check(engine: &Engine, verdict: &Verdict) -> &'static str {
    let vectors = verdict.sum.on_lines();
    assert_eq!(PhasorSum::new(vectors.clone()), verdict.sum, "collecting opposite directions changes no sum");
    let lines: Vec<Turn> = vectors.iter().map(|term| term.angle.times(2)).collect();
    assert!(vectors.iter().all(|term| term.weight.is_positive()));
    assert!(lines.iter().enumerate().all(|(index, line)| !lines[..index].contains(line)), "one vector a line");
    if verdict.vanishes() {
        check_polygons(verdict);
    } else {
        assert!(drawn_polygons(verdict).is_empty());
    }
    match reason(engine, verdict) {
        Reason::NoWeight => {
            assert!(verdict.sum.terms().iter().all(|term| term.weight.is_zero()));
            "no weight"
        }
        Reason::Mirror => {
            assert!(verdict.quantity == Quantity::MOMENT && mirror_partners(engine).is_some());
            "mirror"
        }
        Reason::Cancels => {
            assert!(verdict.sum.collected().is_empty());
            "cancels"
        }
        Reason::OpposedPairs => {
            assert!(drawn_polygons(verdict).iter().all(|polygon| polygon.sides == 2), "pairs are drawn");
            let Certificate::Polygons { polygons } = &verdict.certificate else { panic!("it is zero") };
            assert!(polygons.iter().all(|polygon| polygon.sides == 2), "pairs are certified");
            assert!(opposed_partners(&verdict.sum).is_some());
            "pairs"
        }
        Reason::Rotation { fold } => {
            let star = verdict.sum.positive();
            assert_eq!(star.turned(&Turn::fraction(1, i64::from(fold))).collected(), star.collected());
            "rotation"
        }
        Reason::Polygons => "polygons",
        Reason::OneVector(only) => {
            assert_eq!(vectors, [only]);
            "one"
        }
        Reason::TwoVectors(two) => {
            assert_eq!(vectors, two);
            "two"
        }
        Reason::OneTooLong([longest, second, third]) => {
            assert_eq!(vectors.len(), 3);
            assert!(longest.weight >= second.weight + third.weight);
            "too long"
        }
        Reason::ThreeAlike(three) => {
            assert!(vectors == three && three.iter().all(|term| term.weight == three[0].weight));
            let thirds = [&three[1].angle - &three[0].angle, &three[2].angle - &three[1].angle];
            assert!(thirds.iter().any(|turn| *turn != Turn::fraction(1, 3)));
            "alike"
        }
        Reason::OneSide { middle, within } => {
            assert!(degrees(&within) < 90.0);
            let from = |term: &Term| {
                let turn = &term.angle - &middle;
                std::cmp::min(turn.clone(), -&turn)
            };
            assert_eq!(vectors.iter().map(from).max(), Some(within), "the outermost is as far as is said");
            "one side"
        }
        Reason::Component(component) => {
            check_component(verdict, &component);
            if component.is_mirror_line { "mirror line" } else { "component" }
        }
        Reason::Certificate => {
            assert!(!verdict.vanishes());
            "certificate"
        }
    }
}

#[test]
fn every_reason_on_the_catalogue_and_on_engines_at_random_is_true() {
    let mut kinds = std::collections::BTreeMap::<&str, usize>::new();
    for engine in all_engines() {
        for verdict in all_verdicts(&engine) {
            *kinds.entry(check(&engine, &verdict)).or_default() += 1;
        }
    }
    for kind in
        ["no weight", "mirror", "cancels", "pairs", "rotation", "one", "two", "one side", "mirror line", "component"]
    {
        assert!(kinds.contains_key(kind), "{kind} is not among {kinds:?}");
    }
    assert!(kinds.get("certificate").copied().unwrap_or(0) == 0, "primes are left to the certificate: {kinds:?}");
}

fn argued(engine: &Engine, quantity: Quantity, order: u32, sense: usize) -> String {
    let balances = verdicts::pistons(engine, &[order]);
    let balance = if quantity == Quantity::FORCE { &balances[0].force } else { &balances[0].moment };
    text_in(&verdict_argument(engine, balance.verdicts()[sense]), Format::PLAIN)
}

#[test]
fn opposite_directions_are_collected_before_it_is_argued() {
    assert_eq!(
        argued(&named("radial-18"), Quantity::MOMENT, 1, 0),
        "After vectors on one line are combined, one vector remains, 9 at 0°: it is not zero."
    );
}

#[test]
fn a_star_of_triangles_is_not_said_to_be_one_of_pairs() {
    let text = argued(&named("radial-18"), Quantity::FORCE, 1, 1);
    assert!(text.starts_with("By symmetry: turned by 20° the star is the same star"), "{text}");
    assert!(text.contains("is the corners of a regular triangle and sums to zero: 1, 4 and 7; "), "{text}");
}

#[test]
fn each_way_without_primes_has_its_sentences() {
    let says = |form: &str, order: u32, lines: &[&str]| {
        let engine = written(form);
        let texts: Vec<String> = (0..2).map(|sense| argued(&engine, Quantity::FORCE, order, sense)).collect();
        for line in lines {
            assert!(texts.iter().any(|text| text.contains(line)), "{form}: no {line:?} in {texts:?}");
        }
    };
    says("[inline]\nthrows = [0, 90]", 1, &["two vectors remain: 1 at 0° and 1 at 90°. They do not lie on one line"]);
    says(
        "[inline]\nthrows = [0, 0, 0, 120, 240]",
        1,
        &["three vectors remain: 3 at 0°, 1 at 120° and 1 at 240°. The first"],
    );
    says("[inline]\nthrows = [0, 100, 200]", 1, &["cancel only where they are 120° apart, and these are not."]);
    says("[inline]\nthrows = [0, 10, 20, 30]", 1, &["All of them point to within 15° of 15°"]);
    says(
        "[inline]\nthrows = [0, 72, 72, 144, 216, 288]",
        1,
        &["their own mirror image in the line at 72°", " = 1. That is not zero."],
    );
    says(
        "[inline]\nthrows = [0, 0, 90, 90, 90, 225, 225]",
        1,
        &[
            "Take the components of the vectors in the direction 135°. The components in that direction add up to 3 cos 45° + 2 cos 135°",
        ],
    );
    says(
        "[inline]\nthrows = [0, 0, 0, 135, 135, 225, 225]",
        1,
        &["so their sum lies on that line", "for √2 is irrational."],
    );
    let ratio = argued(&named("V6-90-split"), Quantity::MOMENT, 1, 1);
    assert!(ratio.ends_with("for the ratio of √2 and √6 is irrational."), "{ratio}");
}

#[test]
fn the_worked_example_puts_a_cylinder_of_the_engine_into_the_phases() {
    let engine = named("V6-60-even");
    for order in [1, 2] {
        let balance = &verdicts::pistons(&engine, &[order])[0];
        let blocks = worked_example(&engine, balance);
        let words: Vec<String> = blocks
            .iter()
            .filter_map(|block| match block {
                Block::Paragraph(text) => Some(text_in(text, Format::PLAIN)),
                _ => None,
            })
            .collect();
        assert!(words[1].contains("its direct vector is at") && words[1].contains('≡') || order == 1, "{words:?}");
        assert_eq!(blocks.iter().filter(|block| matches!(block, Block::Pictures(_))).count(), 1);
    }
}
