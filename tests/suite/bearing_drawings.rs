//! Do the drawings of bearings and pins on one page mean the same by the same line, and have bearings one scale?

use std::collections::{BTreeMap, BTreeSet};

use crankstar::engine::Engine;
use crankstar::page::figure::{Dash, Mark, Stroke};
use crankstar::page::{Block, Document, Format, Picture, text_in};
use crankstar::report;

use crate::support::pages;
use crate::support::written::engine;

const V8: &str = include_str!("../../reports/examples/v8-gas/layout.toml");
const I4: &str = include_str!("../../reports/examples/i4-spark/layout.toml");
/// A row of five with links on a master rod, and its bearings on both sides.
const LINKS: &str = "speed = 3000\neffects = ['gas']\ncycle = 'four-stroke'\nfiring_order = '1-3-5-2-4'\nbearings = ['100 mm', '-120 mm']\n\
    [radial]\ncylinders = 5\n[articulated]\nmaster = 1\nknuckle_ratio = 0.2\nknuckle_mass = '0.1 kg'\n\
    [mechanism]\nreciprocating_mass = '0.5 kg'\ncrank_radius = '40 mm'\nrod_ratio = 0.25\n\
    [gas]\nbore = '90 mm'\ndead_centre = 'crank'\nprocess = 'spark-ignition'\ncompression_ratio = 9\nheat = '900 J'\n";

fn page(text: &str) -> Document {
    let engine: Engine = engine(text);
    let study =
        report::ask("bearings", &engine, &[]).expect("a question").unwrap_or_else(|why| panic!("{text}: {why}"));
    study.page()
}

fn pictures(page: &Document) -> Vec<&Picture> {
    page.blocks.iter().flat_map(|block| if let Block::Pictures(all) = block { &all[..] } else { &[] }).collect()
}

/// The width of curves.
const WIDTH: f64 = 0.45;

fn style(stroke: &Stroke) -> String {
    format!("{:?} {:?}", stroke.ink, stroke.dash)
}

/// The styles of the curves of a drawing with their names, numbers left out: from its legend, or, where the names stand at the curves or
/// there is one alone, by the kind of drawing.
fn named(picture: &Picture) -> Vec<(String, String)> {
    let pair = |pair: &[Mark]| match pair {
        [Mark::Line { stroke, .. }, Mark::Text { text, .. }] if stroke.width == WIDTH => {
            Some((style(stroke), text.chars().filter(|sign| !sign.is_ascii_digit()).collect()))
        }
        _ => None,
    };
    let legend: Vec<_> = picture.figure.marks.windows(2).filter_map(pair).collect();
    if !legend.is_empty() {
        return legend;
    }
    let mut styles: Vec<String> = Vec::new();
    for mark in &picture.figure.marks {
        if let Mark::Path { stroke, .. } = mark
            && stroke.width == WIDTH
            && !styles.contains(&style(stroke))
        {
            styles.push(style(stroke));
        }
    }
    let names: &[&str] = match picture.name.starts_with("bearing-") && !picture.name.ends_with("polar") {
        true => &["y", "x"],
        false => &["with gas"],
    };
    assert_eq!(styles.len(), names.len(), "{}: {styles:?}", picture.name);
    styles.into_iter().zip(names.iter().map(ToString::to_string)).collect()
}

#[test]
fn a_style_of_line_means_one_thing_on_a_page_of_bearings() {
    for (text, least) in [(V8, 5), (I4, 3), (LINKS, 7)] {
        let page = page(text);
        let mut meanings: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for picture in pictures(&page) {
            let named = named(picture);
            let styles: BTreeSet<&String> = named.iter().map(|(style, _)| style).collect();
            assert_eq!(styles.len(), named.len(), "{}: {named:?}", picture.name);
            for (style, name) in named {
                meanings.entry(style).or_default().insert(name);
            }
        }
        // The whole load is drawn with gas, and for all rods of a pin: the same thing.
        let whole = BTreeSet::from(["with gas".to_owned(), "all rods".to_owned()]);
        for (style, names) in &meanings {
            assert!(names.len() == 1 || names.is_subset(&whole), "{style} means {names:?}");
        }
        assert!(meanings.len() >= least, "{meanings:?}");
    }
}

#[test]
fn the_polar_drawings_of_all_bearings_have_one_scale() {
    for text in [V8, I4, LINKS, &V8.replace("effects = [\"gas\", \"firing\"]", "")] {
        let page = page(text);
        let rings = |picture: &&Picture| -> Vec<String> {
            let texts = picture.figure.text_boxes().into_iter().map(|(text, _)| text.to_owned());
            texts.filter(|text| text.starts_with(|sign: char| sign.is_ascii_digit()) && !text.contains('°')).collect()
        };
        let of_bearings = |picture: &&Picture| picture.name.starts_with("bearing-") && picture.name.ends_with("polar");
        let drawn: Vec<Vec<String>> = pictures(&page).into_iter().filter(of_bearings).map(|one| rings(&one)).collect();
        assert!(drawn.len() > 1 && drawn[0].len() > 1, "{drawn:?}");
        assert!(drawn.iter().all(|one| *one == drawn[0]), "{drawn:?}");
    }
}

/// An in-line four is its own mirror image: bearings 2 and 4 carry the same, one revolution later.
#[test]
fn all_bearings_with_the_largest_load_are_named_with_gas_too() {
    let page = page(I4);
    let table = &pages::tables(&page)[0];
    let worst: Vec<&str> = table.iter().filter(|row| row[2].contains("worst")).map(|row| row[0].as_str()).collect();
    assert_eq!(worst, ["2", "4"]);
    let Some(Block::Answer(lines)) = page.blocks.first() else { panic!("{:?}", page.blocks.first()) };
    let first = text_in(&lines[0], Format::PLAIN);
    assert!(first.contains("on bearings 2, 4, at crank angle ≈"), "{first}");
}

#[test]
fn broken_lines_are_told_apart_from_whole_ones_without_colour() {
    let page = page(V8);
    let shared = pictures(&page).into_iter().find(|picture| picture.name.starts_with("shared-pin")).expect("a pin");
    let dashes: Vec<bool> = shared.figure.marks.iter().filter_map(dash).collect();
    assert!(dashes.contains(&true) && dashes.contains(&false), "{dashes:?}");
}

fn dash(mark: &Mark) -> Option<bool> {
    match mark {
        Mark::Path { stroke, .. } if stroke.width == WIDTH => Some(stroke.dash == Dash::Solid),
        _ => None,
    }
}
