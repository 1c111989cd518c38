//! Does any text of a drawing lie on another or leave the page? Looked for in the catalogue, in random engines and in hard ones.

use crankstar::engine::Engine;
use crankstar::file::{self, Layout};
use crankstar::page::figure::{Anchor, Extent, Figure, Ink, Mark, Point, Stroke, text_width};
use crankstar::page::{self, Block, Picture};
use crankstar::report::{self, Column};
use crankstar::verdict::{Judgement, torque};

use crate::support::dice::Dice;
use crate::support::figure_texts::FigureTexts;
use crate::support::pages::{self, judgement};
use crate::support::written::engine;
use crate::support::{engines, every_form};

/// A fan of four banks with offsets and splits.
const W12: &str = "fan = { banks = [-43.5, -28.5, 28.5, 43.5], throws = [0, 120, 240], pin_splits = [0, 3, -3, 7], bank_offsets = \
                   [0, '1/5', '2/5', '3/5'] }";
/// Twenty directions, in no symmetry of the banks.
const V20: &str = "vee = { bank_angle = 37.3, throws = [0, 36, 72, 108, 144, 180, 216, 252, 288, 324], pin_split = 11.7, bank_offset = '1/5' }";
/// Masses and arms that no panel shows in one scale.
const UNEQUAL: &str =
    "inline.throws = [0, 90, 180, 270]\nmechanism.reciprocating_mass = ['1/1000000007', 1, 1, 1000000007]";

/// The stars of an engine, with words that say which.
fn stars(name: &str, engine: &Engine) -> Vec<(String, Figure)> {
    let judged = judgement(engine);
    let orders = judged.orders.iter().chain(judged.pistons.iter().flatten());
    let of_order = orders.flat_map(|order| &order.parts).flat_map(|part| {
        let small = report::small_star(part);
        [("stars", report::star_figure(engine, part)), ("small star", small)]
            .map(|(what, figure)| (format!("{what} of order {} of {name}", part.order), figure))
    });
    let torques = torque(engine, &[1, 2, 3]).expect("orders");
    let parts: Vec<_> = torques.iter().flat_map(|torque| &torque.parts).map(|part| &part.verdict).collect();
    of_order.chain([(format!("torque of {name}"), report::torque_figure(engine, &parts))]).collect()
}

#[track_caller]
fn assert_clear(what: &str, figure: &Figure) {
    assert!(figure.overlaps().is_empty(), "{what}: texts on each other: {:?}", figure.overlaps());
    assert!(figure.leaving().is_empty(), "{what}: texts off the page: {:?}", figure.leaving());
    let page = page::svg(figure, what);
    assert!(!page.contains("NaN") && !page.contains("inf"), "{what}");
}

#[test]
fn no_text_of_a_star_of_the_catalogue_lies_on_another_or_leaves_the_page() {
    for (entry, engine) in file::catalogue().expect("the catalogue reads") {
        for (what, figure) in stars(entry.name, &engine) {
            assert_clear(&what, &figure);
        }
    }
}

#[test]
fn no_text_of_a_star_of_a_random_engine_lies_on_another_or_leaves_the_page() {
    let mut drawn = 0;
    for seed in 0..120 {
        // Some are not layouts, some have unknowns.
        let Ok(Layout::Known(engine, _)) = file::parse_layout("engine.toml", &random(seed)) else { continue };
        for (what, figure) in stars(&format!("engine {seed}"), &engine) {
            assert_clear(&what, &figure);
            drawn += 1;
        }
    }
    assert!(drawn > 600, "{drawn} drawings");
}

fn random(seed: u64) -> String {
    match seed % 2 {
        0 => every_form::known(&mut Dice::new(seed)),
        _ => engines::file(&mut Dice::new(seed), engines::FORMS[seed as usize / 2 % engines::FORMS.len()]),
    }
}

#[test]
fn no_text_of_a_star_of_an_engine_at_odd_angles_lies_on_another_or_leaves_the_page() {
    for text in [W12, V20, UNEQUAL] {
        for (what, figure) in stars(text, &engine(text)) {
            assert_clear(&what, &figure);
        }
    }
}

#[test]
fn no_text_of_a_comparison_lies_on_another_or_leaves_the_page() {
    let names = ["I3", "V6-60-even", "radial-18", "V8-crossplane", "V12-60"];
    let engines = names.map(|name| file::find(name).expect("in the catalogue").engine().expect("it reads"));
    let w12 = engine(W12);
    let engines = engines.iter().chain([&w12]);
    let judged: Vec<_> = engines.map(|engine| (engine, judgement(engine))).collect();
    for place in 0..4 {
        let column = |(engine, judged)| {
            let (engine, judged): (&Engine, &Judgement) = (engine, judged);
            let name = format!("{}, as long a name as any", engine.file().written());
            Column { name, engine, order: &judged.orders[place].parts[0] }
        };
        let columns: Vec<Column> = judged.iter().map(|(engine, judged)| column((engine, judged))).collect();
        for count in 1..=columns.len() {
            for figure in report::multiples(&columns[..count]) {
                assert_clear(&format!("{count} engines"), &figure);
            }
        }
    }
}

/// Endings of the names of drawings that are not yet clear everywhere.
const EXEMPT: [&str; 3] = ["end-view", "side-view", "-polar"];

#[test]
fn no_text_of_any_drawing_of_a_report_lies_on_another_or_leaves_the_page() {
    let folders = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/reports/examples")).expect("examples");
    let layouts = folders.map(|folder| std::fs::read_to_string(folder.expect("a folder").path().join("layout.toml")));
    let examples = layouts.filter_map(|text| file::parse("layout.toml", &text.expect("a layout file")).ok());
    let catalogue = file::catalogue().expect("the catalogue reads").into_iter().map(|(_, engine)| engine);
    for engine in catalogue.chain(examples) {
        for picture in pictures(&pages::document(&engine).blocks) {
            if !EXEMPT.iter().any(|ending| picture.name.ends_with(ending)) {
                assert_clear(&format!("{} of {:?}", picture.name, engine.title()), &picture.figure);
            }
        }
    }
}

/// The pictures of blocks, folded ones too.
fn pictures<'a>(blocks: &'a [Block]) -> Vec<&'a Picture> {
    let of_block = |block: &'a Block| match block {
        Block::Pictures(pictures) => pictures.iter().collect(),
        Block::Folded(fold) => pictures(&fold.blocks),
        _ => Vec::new(),
    };
    blocks.iter().flat_map(of_block).collect()
}

#[test]
fn every_ray_of_a_star_has_its_name_where_there_are_not_too_many() {
    let v20 = engine(V20);
    for part in judgement(&v20).orders.iter().flat_map(|order| &order.parts) {
        let figure = report::star_figure(&v20, part);
        let written: Vec<String> = figure.text_boxes().into_iter().map(|(text, _)| text.to_owned()).collect();
        let names = written.join(" ").replace(',', "");
        for cylinder in 1..=20 {
            let times = names.split(' ').filter(|name| *name == cylinder.to_string()).count();
            assert!(times >= 4, "order {}: cylinder {cylinder} is {times} times in {names}", part.order);
        }
    }
}

/// What the red outlines of a figure measure, longest side first.
fn resultants(figure: &Figure) -> Vec<f64> {
    let tip = |mark: &Mark| match mark {
        Mark::Polygon { corners, stroke, .. } if stroke.ink == Ink::Red => {
            Some((corners[3] - (corners[0] + corners[6]) / 2.0).norm())
        }
        _ => None,
    };
    figure.marks.iter().filter_map(tip).collect()
}

#[test]
fn each_star_fills_its_panel_and_a_bar_tells_its_scale() {
    // At order 1 the direct vectors of a V are alike, the reverse ones 2φ apart: half as long together.
    let v = engine("vee = { bank_angle = 60, throws = [0] }");
    let judged = judgement(&v);
    let drawn = resultants(&report::star_figure(&v, &judged.orders[0].parts[0]));
    assert!(drawn.len() == 2 && (drawn[0] - drawn[1]).abs() < 1e-6, "{drawn:?}");
    let bars = |name: &str| {
        let layout = file::find(name).expect("in the catalogue").engine().expect("it reads");
        let orders = judgement(&layout).orders;
        let figure = report::star_figure(&layout, &orders[0].parts[0]);
        let texts: Vec<String> = figure.text_boxes().into_iter().map(|(text, _)| text.to_owned()).collect();
        texts.into_iter().filter(|text| text.contains(" m r")).collect::<Vec<_>>()
    };
    assert_eq!(bars("V8-crossplane"), ["0.5 m r", "2 m r a", "1 m r a"]);
}

/// The decimals that follow these words in the texts of a figure.
fn decimals(figure: &Figure, words: &str) -> Vec<f64> {
    let number = |text: &str| {
        let rest = text.strip_prefix(words)?.trim_start_matches([' ', '=', '≈', '\u{a0}']);
        let rest = rest.split(" (").next()?;
        let rest = rest.rsplit_once('≈').map_or(rest, |(_, decimal)| decimal).trim_start_matches('\u{a0}');
        let digit = |sign: char| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|digit| digit == sign).map(|digit| digit.to_string());
        let plain = |sign: char| digit(sign).unwrap_or(sign.to_string());
        let rest = rest.split([' ', '\u{202f}', '\u{a0}', '(']).next()?.replace("·10", "e").replace(['⁻', '−'], "-");
        rest.chars().map(plain).collect::<String>().parse().ok()
    };
    figure.text_boxes().into_iter().filter_map(|(text, _)| number(text)).collect()
}

/// What an engine of one rod, of several, with offsets, with links does at each order, against the loads by classes.
#[test]
fn a_star_says_the_number_of_the_box_and_its_resultants_add_up_to_it() {
    const ENGINES: [&str; 5] = [
        "inline.throws = [0, 90, 270, 180]\nmechanism.rod_ratio = '2/7'",
        "inline.throws = [0, 144, 216, 288, 72]\nmechanism.rod_ratio = ['1/4', '1/4', '1/3', '1/3', '1/4']",
        "vr = { bank_angle = 15, throws = [0, 240, 120, 120, 240, 0], pin_splay = 22, pin_offset = '12.5 mm' }\n\
         mechanism = { stroke = '90.3 mm', rod_length = '164 mm' }",
        "radial.cylinders = 9\nmechanism.rod_ratio = '5/19'\n[articulated]\nmaster = 1\nknuckle_ratio = '1/4'",
        "orders = [1, 2, 4]\nvee = { bank_angle = 75, throws = [0, 120, 240] }\nmechanism.rod_ratio = '1/4'",
    ];
    let (mut compared, mut several) = (0, 0);
    for text in ENGINES {
        let Ok(engine) = file::parse("engine.toml", text) else { panic!("{text}") };
        let judged = judgement(&engine);
        let orders: Vec<u32> = judged.orders.iter().map(|order| order.order).collect();
        let loads = crankstar::loads::loads(&engine, &orders).expect("loads");
        let document = pages::document(&engine);
        for (order, of_order) in judged.orders.iter().zip(&loads.orders) {
            let name = format!("order-{}", order.order);
            let picture = document.pictures().into_iter().find(|picture| picture.name == name).expect("a star");
            let said = decimals(&picture.figure, "together at most");
            let left: Vec<f64> = [&of_order.force, &of_order.moment]
                .into_iter()
                .filter(|swing| !swing.vanishes())
                .map(|swing| swing.largest())
                .collect();
            assert_eq!(said.len(), left.len(), "{text}, order {}", order.order);
            for (said, largest) in said.iter().zip(&left) {
                assert!((said / largest - 1.0).abs() < 0.006, "{text}, order {}: {said}, not {largest}", order.order);
                compared += 1;
            }
            if order.parts.len() > 1 {
                let drawn: f64 = decimals(&picture.figure, "resultant").iter().sum();
                let whole: f64 = left.iter().sum();
                assert!((drawn - whole).abs() < 0.006 * whole, "{text}, order {}: {drawn}, not {whole}", order.order);
                several += 1;
            }
        }
    }
    assert!(compared > 12 && several > 6, "{compared} compared, {several} of several coefficients");
}

#[test]
fn the_resultant_lies_above_the_vectors_and_hides_none() {
    for name in ["I4", "V8-crossplane", "V2-90", "I5-12453"] {
        let layout = file::find(name).expect("in the catalogue").engine().expect("it reads");
        for part in judgement(&layout).orders.iter().flat_map(|order| &order.parts) {
            let figure = report::small_star(part);
            let resultant = |mark: &Mark| matches!(mark, Mark::Polygon { stroke, .. } if stroke.ink == Ink::Red);
            let vector = |mark: &Mark| matches!(mark, Mark::Line { arrow: true, .. });
            let (above, below) = (figure.marks.iter().position(resultant), figure.marks.iter().rposition(vector));
            assert_eq!(above.is_some(), !report::told(part).vanishes());
            assert!(above.is_none_or(|above| Some(above) > below), "{name}, order {}", part.order);
        }
    }
}

#[test]
fn a_drawing_is_cropped_to_its_marks_and_keeps_them() {
    let mut figure = Figure::new(200.0, 100.0);
    figure.line(Point::new(50.0, 40.0), Point::new(80.0, 60.0), Stroke::solid(Ink::Black, 1.0));
    figure.text(Point::new(80.0, 60.0), "name", Anchor::Start);
    let cropped = figure.cropped(2.0);
    let width = 30.0 + 0.5 + 2.0 + 2.0 + text_width("name", 3.0);
    assert!((cropped.width - width).abs() < 0.01 && (cropped.height - 26.0).abs() < 0.01 + 1.0, "{cropped:?}");
    assert!(matches!(&cropped.marks[0], Mark::Line { from, .. } if (from - Point::new(2.5, 2.5)).norm() < 1e-9));
    assert!(Figure::new(3.0, 4.0).cropped(1.0).marks.is_empty());
}

#[test]
fn texts_that_overlap_or_leave_are_found() {
    let mut figure = Figure::new(20.0, 10.0);
    figure.text(Point::new(1.0, 5.0), "one", Anchor::Start);
    figure.text(Point::new(3.0, 6.0), "two", Anchor::Start);
    figure.text(Point::new(19.0, 2.0), "out", Anchor::Start);
    assert_eq!(figure.overlaps(), [("one", "two")]);
    assert_eq!(figure.leaving(), ["out"]);
    let boxes: Vec<Extent> = figure.text_boxes().into_iter().map(|(_, text)| text).collect();
    assert!(boxes[0].meets(&boxes[1]) && !boxes[0].meets(&boxes[2]));
}

#[test]
fn a_drawing_follows_a_dark_page_and_shares_its_rules_with_others() {
    let layout = engine(W12);
    let drawings: Vec<String> = stars("W12", &layout).iter().map(|(what, figure)| page::svg(figure, what)).collect();
    let mut rules: std::collections::BTreeMap<String, String> = Default::default();
    for page in &drawings {
        assert!(
            page.contains("role=\"img\"") && page.contains("<title>") && page.contains("prefers-color-scheme:dark")
        );
        assert!(!page.contains("fill=\"#") && !page.contains("stroke=\"#"), "a colour that does not follow the page");
        let style = page.split("<style>").nth(1).and_then(|rest| rest.split("</style>").next()).expect("a style");
        let (light, dark) = style.split_once("@media").expect("a dark page");
        for (page, part) in [("light", light), ("dark", dark)] {
            for rule in part.split('}').filter_map(|rule| rule.rsplit_once('.')) {
                let (name, value) = rule.1.split_once('{').expect("a rule");
                assert!(name.starts_with("cs-"), "{name}");
                let known = rules.entry(format!("{page} {name}")).or_insert_with(|| value.to_owned());
                assert_eq!(known, value, "two drawings on one page would clash");
            }
        }
    }
}
