//! Are engines taken as books write them: the crank clockwise, cylinders numbered as published, throws from the firing order alone?

use std::collections::BTreeMap;

use crate::support::dice::Dice;
use crate::support::{engines, pages, verdicts};
use crankstar::engine::{Convention, Draft, Engine, Rotation, SeenFrom};
use crankstar::exact::Turn;
use crankstar::file::{catalogue, find, parse};
use crankstar::numbers;
use crankstar::proof::{Quantity, Sense, Shape};
use crankstar::verdict::OrderVerdict;

/// A published engine: its file with the order as printed, and its throws by the number of the cylinder, in the sense of rotation.
struct Published {
    name: &'static str,
    source: &'static str,
    file: &'static str,
    throws: &'static [i64],
}

/// The throws are those of the theory of mechanisms, section 6, where that has the engine.
const PUBLISHED: &[Published] = &[
    Published {
        name: "Chevrolet small block",
        source: "web guides: odd cylinders on the driver's left, which stands to the right of who looks at the front",
        file: "rotation = 'clockwise'\nfiring_order = '1-8-4-3-6-5-7-2'\nvee = { bank_angle = 90, numbering = 'alternating' }",
        throws: &[0, 0, 90, 90, 270, 270, 180, 180],
    },
    Published {
        name: "Chevrolet LS",
        source: "web guides: numbered as the small block",
        file: "rotation = 'clockwise'\nfiring_order = '1-8-7-2-6-5-4-3'\nvee = { bank_angle = 90, numbering = 'alternating' }",
        throws: &[0, 0, 90, 90, 270, 270, 180, 180],
    },
    Published {
        name: "Ford small-block V8",
        source: "fordfe.info, firing orders: 1 to 4 on the right bank of the car",
        file: "rotation = 'clockwise'\nfiring_order = '1-3-7-2-6-5-4-8'\nvee = { bank_angle = -90, numbering = 'per bank' }",
        throws: &[0, 90, 270, 180, 0, 90, 270, 180],
    },
    Published {
        name: "Ferrari V8, flat crankshaft",
        source: "mechanics.stackexchange.com, question 25866: 4, 3, 2, 1 along the right bank, 8, 7, 6, 5 along the left",
        file: "rotation = 'clockwise'\nfiring_order = '1-5-3-7-4-8-2-6'\nvee = { bank_angle = -90, numbering = [4, 3, 2, 1, 8, 7, 6, 5] }",
        throws: &[0, 180, 180, 0, 0, 180, 180, 0],
    },
    Published {
        name: "Buick 3800",
        source: "service manual, Riviera 1997: 1-3-5 on the left bank, pins offset by 30°",
        file: "rotation = 'clockwise'\nfiring_order = '1-6-5-4-3-2'\nvee = { bank_angle = 90, numbering = 'alternating' }",
        throws: &[0, 30, 240, 270, 120, 150],
    },
    Published {
        name: "Buick V6, odd firing",
        source: "encyclopedia: three crankpins 120° apart, intervals of 150° and 90°",
        file: "rotation = 'clockwise'\nfiring_angles = [0, 630, 480, 390, 240, 150]\nvee = { bank_angle = 90, numbering = 'alternating' }",
        throws: &[0, 0, 240, 240, 120, 120],
    },
    Published {
        name: "PRV",
        source: "hobby page: 1 to 3 on one bank, 4 to 6 on the other",
        file: "rotation = 'clockwise'\nfiring_order = '1-6-3-5-2-4'\nvee = { bank_angle = 90, numbering = 'per bank' }",
        throws: &[0, 240, 120, 30, 270, 150],
    },
    Published {
        name: "Volkswagen flat four",
        source: "hillmanimages.com, 912 workshop figure 2: 1 and 3 at the flywheel, 1 and 2 on the right",
        file: "rotation = 'clockwise'\nfiring_order = '1-4-3-2'\nboxer = { stagger = 1, numbering = [2, 1, 4, 3] }",
        throws: &[0, 180, 180, 0],
    },
    Published {
        name: "Subaru flat four",
        source: "builder's published data: EJ25",
        file: "rotation = 'clockwise'\nfiring_order = '1-3-2-4'\nboxer = { stagger = 1, numbering = 'alternating' }",
        throws: &[0, 180, 180, 0],
    },
    Published {
        name: "Porsche 911",
        source: "reference page: 1-6-2-4-3-5",
        file: "firing_order = '1-6-2-4-3-5'\nboxer = { stagger = 1 }",
        throws: &[0, 120, 240, 180, 300, 60],
    },
    Published {
        name: "Audi five",
        source: "web guide: 1-2-4-5-3",
        file: "firing_order = '1-2-4-5-3'\ninline = {}",
        throws: &[0, 216, 144, 72, 288],
    },
    Published {
        name: "Yamaha R1 of 2009",
        source: "magazine: 1-3-2-4 at 270, 180, 90, 180",
        file: "firing_angles = [0, 450, 270, 540]\ninline = {}",
        throws: &[0, 270, 90, 180],
    },
    Published {
        name: "Merlin",
        source: "museum page, firing order",
        file: "firing_order = 'A1 B6 A4 B3 A2 B5 A6 B1 A3 B4 A5 B2'\n\
               vee = { bank_angle = 60, numbering = ['A1', 'A2', 'A3', 'A4', 'A5', 'A6', 'B1', 'B2', 'B3', 'B4', 'B5', 'B6'] }",
        throws: &[0, 120, 240, 240, 120, 0, 0, 120, 240, 240, 120, 0],
    },
];

fn published(engine: &Published) -> Engine {
    let text = format!("cycle = 'four-stroke'\n{}", engine.file);
    parse(engine.name, &text).unwrap_or_else(|error| panic!("{} ({}): {error}", engine.name, engine.source))
}

#[test]
fn published_firing_orders_are_taken_as_printed_and_give_the_published_throws() {
    for known in PUBLISHED {
        let engine = published(known);
        let mut found: Vec<(String, Turn)> =
            engine.cylinders().iter().map(|cylinder| (cylinder.name.clone(), cylinder.throw.clone())).collect();
        found.sort_by_key(|(name, _)| name.clone());
        let throws: Vec<Turn> = found.into_iter().map(|(_, throw)| throw).collect();
        let right: Vec<Turn> = known.throws.iter().map(|&degrees| Turn::fraction(degrees, 360)).collect();
        assert_eq!(throws, right, "{}", known.name);
        let fires = engine.firing().expect("it fires");
        assert!(fires.is_even() || known.file.contains("firing_angles"), "{}", known.name);
    }
}

#[test]
fn throws_that_follow_are_those_that_can_be_written() {
    for known in PUBLISHED.iter().filter(|known| known.file.contains("vee") && known.throws.len() == 8) {
        let followed = published(known);
        let pins: BTreeMap<usize, String> = followed
            .cylinders()
            .iter()
            .map(|cylinder| (cylinder.pin, followed.convention().as_written(&cylinder.throw).degrees().to_string()))
            .collect();
        let list = pins.into_values().collect::<Vec<_>>().join(", ");
        let text = format!("cycle = 'four-stroke'\n{}", known.file)
            .replace("vee = {", &format!("vee = {{ throws = [{list}],"));
        let written = parse(known.name, &text).unwrap_or_else(|error| panic!("{}: {error}", known.name));
        assert_eq!(followed.cylinders(), written.cylinders(), "{}", known.name);
        assert_eq!(followed.firing(), written.firing(), "{}", known.name);
    }
}

#[test]
fn throws_follow_from_the_firing_of_every_engine_of_the_catalogue() {
    let mut followed = 0;
    for (entry, engine) in catalogue().expect("it reads") {
        let (Some(firing), Some(cycle)) = (engine.firing(), engine.cycle()) else { continue };
        let turns = |value: &num_rational::BigRational| format!("'{value} turn'");
        let mut angles = vec![String::new(); firing.shots.len()];
        firing.shots.iter().for_each(|shot| angles[shot.cylinder] = turns(&shot.angle));
        let cycle = match cycle {
            crankstar::engine::Cycle::TwoStroke => "two-stroke",
            crankstar::engine::Cycle::FourStroke => "four-stroke",
        };
        let mut text = format!("cycle = '{cycle}'\nfiring_angles = [{}]\n", angles.join(", "));
        for cylinder in engine.cylinders() {
            let (bank, at, pin) = (turns(cylinder.bank.turns()), &cylinder.position, cylinder.pin + 1);
            text +=
                &format!("[[cylinder]]\nname = '{}'\nbank = {bank}\nposition = '{at}'\npin = {pin}\n", cylinder.name);
        }
        let own = parse("throws", &text).unwrap_or_else(|error| panic!("{}: {error}", entry.name));
        let first = &engine.cylinders()[0].throw;
        for (one, other) in own.cylinders().iter().zip(engine.cylinders()) {
            assert_eq!(one.throw, &other.throw - first, "{}, cylinder {}", entry.name, other.name);
        }
        followed += 1;
    }
    assert!(followed > 20, "{followed}");
}

/// Every angle with the other sign: the generator writes them all in turns.
fn other_drawing(text: &str) -> String {
    let Some((angles, last)) = text.rsplit_once("turn\"") else { return text.to_owned() };
    let negated = angles.split("turn\"").map(|part| match part.rsplit_once('"') {
        Some((before, angle)) => format!("{before}\"-{angle}turn\""),
        None => part.to_owned(),
    });
    negated.collect::<String>() + last
}

#[test]
fn an_engine_drawn_the_other_way_round_is_the_same_engine() {
    let mut dice = Dice::new(14);
    // Narrow banks stand where their form draws them, the first at −φ/2 whichever way the crank turns.
    for form in engines::FORMS.into_iter().filter(|form| !["open", "vr", "w"].contains(form)) {
        for _ in 0..40 {
            let text = engines::file(&mut dice, form);
            let Ok(engine) = parse("drawn", &text) else { continue };
            let drawn = other_drawing(&text);
            for end in ["free end", "flywheel"] {
                let keys = format!("rotation = 'clockwise'\nseen_from = '{end}'\n");
                let other = parse("drawn", &format!("{keys}{drawn}")).unwrap_or_else(|error| panic!("{error}"));
                assert_eq!(other.convention().rotation, Rotation::Clockwise);
                let same =
                    Draft { convention: Convention::default(), file: engine.file().clone(), ..other.into_draft() };
                let same = same.build().expect("an engine");
                // The banks of a flat engine are not written: in both drawings bank 1 is to the right.
                match form {
                    "flat" | "boxer" => {
                        let [one, other] = [&engine, &same].map(|engine| verdicts::judged(engine, &[1, 2, 4], false));
                        assert_eq!(sizes(&one), sizes(&other), "{text}");
                    }
                    _ => assert_eq!(same, engine, "{text}\n{drawn}"),
                }
            }
        }
    }
}

type Sizes = Vec<(u32, Quantity, Option<Sense>, bool, Option<String>)>;

fn sizes(orders: &[OrderVerdict]) -> (Sizes, Vec<Shape>) {
    let (mut sizes, mut shapes) = (Sizes::new(), Vec::new());
    for part in orders.iter().flat_map(|order| &order.parts) {
        for balance in [&part.force, &part.moment] {
            for verdict in balance.verdicts() {
                let modulus = numbers::modulus(&verdict.sum).map(|form| form.to_string());
                sizes.push((part.order, verdict.quantity, verdict.sense, verdict.vanishes(), modulus));
            }
            shapes.push(balance.shape);
        }
    }
    (sizes, shapes)
}

/// The claim behind it: the mirror image, with its mechanism drawn along, has the same verdicts, lengths and shapes.
#[test]
fn a_mirror_image_has_equal_verdicts_lengths_and_shapes() {
    let mut dice = Dice::new(141);
    let mut compared = 0;
    for form in engines::FORMS.into_iter().filter(|form| !["open", "radial", "vr", "w"].contains(form)) {
        for _ in 0..8 {
            let text = engines::file(&mut dice, form);
            let (Ok(engine), Ok(mirrored)) = (parse("one", &text), parse("other", &other_drawing(&text))) else {
                continue;
            };
            let [one, other] = [&engine, &mirrored].map(|engine| verdicts::judged(engine, &[1, 2, 3, 4, 6], false));
            assert_eq!(sizes(&one), sizes(&other), "{text}");
            compared += 1;
        }
    }
    assert!(compared > 30, "{compared}");
}

#[test]
fn what_turns_is_drawn_with_the_engine() {
    let text = |keys: &str, [throw, weight, shaft, offset]: [&str; 4]| {
        let engine = format!("{keys}inline = {{ throws = [0, {throw}], spacing = '0.1 m' }}\n");
        let rods = "[mechanism]\nreciprocating_mass = 1\ncrank_radius = 0.05\nrod_ratio = 0.25\noffset_ratio = 0.05\n";
        let weights = format!(
            "[[counterweight]]\nangle = {weight}\nposition = 0\nmass = 1\nradius = 1\n\
             [[counterweight]]\nthrow = 2\nangle = {weight}\nmass = 1\nradius = 1\n"
        );
        let shaft = format!(
            "[[balancer]]\norder = 1\nsense = 'against'\nmass_radius = 1\nangle = {shaft}\nposition = 0\noffset = {offset}\n"
        );
        parse("engine", &(engine + rods + &weights + &shaft)).unwrap_or_else(|error| panic!("{error}"))
    };
    let one = text("", ["120", "30", "70", "'3 mm'"]);
    let other = text("rotation = 'clockwise'\n", ["-120", "-30", "-70", "'-3 mm'"]);
    assert_eq!(one.crankshaft(), other.crankshaft());
    assert_eq!(one.cylinders(), other.cylinders());
}

#[test]
fn pages_look_from_the_end_from_which_the_crank_turns_anticlockwise() {
    let cases = [
        ("", SeenFrom::FreeEnd, "Seen from the free end at", 0),
        ("seen_from = 'flywheel'\n", SeenFrom::Flywheel, "Seen from the flywheel at", 1),
        ("rotation = 'clockwise'\n", SeenFrom::Flywheel, "Seen from the flywheel at", 1),
        ("rotation = 'clockwise'\nseen_from = 'flywheel'\n", SeenFrom::FreeEnd, "Seen from the free end at", 1),
    ];
    for (keys, end, words, notes) in cases {
        let engine = parse("v2", &format!("{keys}vee = {{ bank_angle = 60, throws = [0] }}")).expect("a V-twin");
        assert_eq!(engine.convention().turns_anticlockwise_from(), end, "{keys}");
        let page = pages::text(&pages::document(&engine), pages::DOLLARS);
        assert!(page.contains(words), "{keys}\n{page}");
        assert_eq!(
            page.matches("The layout file draws").count() + page.matches("The layout file and this").count(),
            2 * notes,
            "{page}"
        );
    }
}

/// The file is refused; the message has all of these words, and points at this line.
#[track_caller]
fn assert_refused(text: &str, line: usize, words: &[&str]) {
    let error = match parse("layout.toml", text) {
        Ok(_) => panic!("accepted:\n{text}"),
        Err(error) => error.to_string(),
    };
    words.iter().for_each(|words| assert!(error.contains(words), "no {words:?} for\n{text}\n{error}"));
    assert!(error.contains(&format!("layout.toml:{line}:")), "not at line {line} of\n{text}\n{error}");
}

#[test]
fn a_contradiction_says_which_mirror_image_or_numbering_would_fit() {
    let head = "cycle = 'four-stroke'\n";
    let small_block = format!("{head}firing_order = '1-8-4-3-6-5-7-2'\n");
    let pins = "throws = [0, 90, 270, 180]";
    let exchanged = "with the banks exchanged";
    assert_refused(
        &format!("{small_block}vee = {{ bank_angle = 90, {pins}, numbering = 'alternating' }}"),
        2,
        &["need 1800°", "needs pins 180° apart", exchanged, "it turns the other way, or bank 1 is the other bank"],
    );
    assert!(
        parse("fits", &format!("{small_block}vee = {{ bank_angle = -90, {pins}, numbering = 'alternating' }}")).is_ok()
    );
    assert_refused(
        &format!("{small_block}vee = {{ bank_angle = -90, {pins} }}"),
        2,
        &["with numbering = \"alternating\" it fits"],
    );
    assert_refused(
        &format!("{small_block}vee = {{ bank_angle = 90, numbering = 'alternating' }}"),
        2,
        &["needs pins 180° apart", exchanged, "rotation = \"clockwise\"", "pin_split = 180"],
    );
    assert!(
        parse("said", &format!("{small_block}vee = {{ bank_angle = 90, numbering = 'alternating', pin_split = 180 }}"))
            .is_ok()
    );
    assert_refused(
        &format!("{head}firing_angles = [0, 261]\nvee = {{ bank_angle = 13.7 }}"),
        2,
        &["needs pins 112.7° apart", "they are 85.3° apart", "pin_split = 112.7 in a vee"],
    );
    assert_refused(
        &format!("{small_block}vee = {{ bank_angle = 90, numbering = 'alternating', pin_split = 0 }}"),
        2,
        &["pins of cylinders 1 and 2 180° apart, and they are 0°", exchanged],
    );
    let drawn = "rotation = 'clockwise'\ninline = { throws = [0, 216, 144, 72, 288] }";
    assert_refused(&format!("{head}firing_order = '1-2-4-5-3'\n{drawn}"), 2, &["rotation = \"anticlockwise\""]);
    assert_refused(
        &format!("{head}firing_order = '1-2-3-4'\ninline = {{ throws = [0, 180, 180, 0] }}"),
        2,
        &["1080°", "from each to the next it takes 180°, 360°, 180°, 360°"],
    );
    assert_refused(
        &format!("{head}firing_order = '1-3-2-4'\nflat = {{ numbering = 'alternating' }}"),
        2,
        &["180° apart, and they are 0°"],
    );
}

#[test]
fn mistakes_in_the_words_of_books_are_told_with_their_place() {
    let head = "cycle = 'four-stroke'\n";
    assert_refused("rotation = 'left'\ninline.throws = [0]", 1, &["\"clockwise\" or \"anticlockwise\""]);
    assert_refused("seen_from = 'front'\ninline.throws = [0]", 1, &["\"free end\" or \"flywheel\""]);
    assert_refused(
        "[vee]\nbank_angle = 60\nthrows = [0, 120]\nnumbering = [1, 2, 3]",
        4,
        &["3 for 4 cylinders", "bank after bank"],
    );
    assert_refused("[vee]\nbank_angle = 60\nthrows = [0]\nnumbering = [1, 1]", 4, &["`1` at places 1 and 2"]);
    assert_refused("[vee]\nbank_angle = 60\nthrows = [0]\nnumbering = ['left bank', 2]", 4, &["one to six letters"]);
    assert_refused(&format!("{head}firing_order = '1-2-3'\n[vee]\nbank_angle = 60"), 2, &["3 cylinders for 2 banks"]);
    assert_refused("firing_order = '1-2'\n[vee]\nbank_angle = 60", 2, &["crank throws are missing", "with its cycle"]);
    let table = "[[cylinder]]\nbank = 0\nposition = 0\n";
    assert_refused(
        &format!("{head}firing_order = '1-2'\n{table}throw = 0\n{table}"),
        7,
        &["`throw` is missing", "omit all of them"],
    );
    assert_refused(
        &format!("{head}firing_angles = [0]\nfiring_order = '1-2'\n[inline]"),
        2,
        &["one of them is enough"],
    );
    assert_refused(&format!("{head}firing_order = '1-2-3'\n{table}{table}"), 2, &["`3`, which is not a cylinder"]);
}

#[test]
fn rows_of_a_radial_take_their_throws_from_the_order() {
    for name in ["radial-14", "radial-18"] {
        let entry = find(name).expect("in the catalogue");
        let listed = entry.engine().expect("it reads");
        let text: String =
            entry.text.lines().filter(|line| !line.starts_with("row_throw")).map(|line| format!("{line}\n")).collect();
        let followed = parse(name, &text).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(listed.cylinders(), followed.cylinders(), "{name}");
    }
}

#[test]
fn the_examples_of_the_documentation_are_layout_files() {
    let text = include_str!("../../src/kernel/file/README.md");
    let section = text.split("\n## ").find(|section| section.starts_with("As books write it")).expect("the section");
    let examples: Vec<&str> = section.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    assert_eq!(examples.len(), 5);
    for example in examples {
        parse("example", example).unwrap_or_else(|error| panic!("{error}\n{example}"));
    }
}
