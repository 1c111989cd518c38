//! Are several crankshafts the same engine in either drawing, and does the page of a remedy know which of them bears a weight?

use crankstar::engine::{Convention, Draft, Engine, Rotation};
use crankstar::file::parse;
use crankstar::numbers;
use crankstar::order::Masses;
use crankstar::proof::Sense;
use crankstar::remedy::{Request, remedy};
use crankstar::report::{remedy_answer, remedy_cures};
use crankstar::verdict;

use crate::geared::any_engine;
use crate::support::dice::Dice;
use crate::support::pages;
use crate::support::written::engine as layout;

const CLOCKWISE: &str = "rotation = 'clockwise'\n";

/// The same engine drawn from its other end: each angle, and each length to the left, with the other sign.
fn other_drawing(text: &str) -> String {
    let mut of_throw = false;
    let lines = text.lines().map(|line| {
        if line.starts_with('[') {
            // There it is the number of a throw.
            of_throw = line == "[[counterweight]]";
        }
        match line.split_once(" = ") {
            Some((key @ ("throw" | "bank" | "angle" | "offset" | "phase"), value)) if !(of_throw && key == "throw") => {
                let value = value.trim_matches('\'');
                match value.strip_prefix('-') {
                    Some(positive) => format!("{key} = '{positive}'\n"),
                    None => format!("{key} = '-{value}'\n"),
                }
            }
            _ => format!("{line}\n"),
        }
    });
    lines.collect()
}

/// What the file of the other drawing describes, without the note of how it is drawn.
fn as_if_drawn_so(text: &str, engine: &Engine) -> Engine {
    let other = layout(text);
    assert_eq!(other.convention().rotation, Rotation::Clockwise);
    let file = engine.file().clone();
    Draft { convention: Convention::default(), file, ..other.into_draft() }.build().expect("an engine")
}

#[test]
fn a_geared_engine_drawn_the_other_way_round_is_the_same_engine() {
    let mut dice = Dice::new(41);
    for _ in 0..80 {
        let text = any_engine(&mut dice);
        let engine = layout(&text);
        for end in ["free end", "flywheel"] {
            let drawn = format!("{CLOCKWISE}seen_from = '{end}'\n{}", other_drawing(&text));
            assert_eq!(as_if_drawn_so(&drawn, &engine), engine, "{text}\n{drawn}");
        }
    }
}

/// Whether each sum vanishes, how long it is, the shapes of force and moment, and the roll moments.
fn sizes(engine: &Engine) -> Vec<String> {
    let quantities = verdict::quantities(engine, true);
    let orders = verdict::classify(engine, &[1, 2, 4], Masses::All, &quantities).expect("orders");
    let length = |vanishes: bool, sum: &crankstar::exact::PhasorSum| match vanishes {
        true => "0".to_owned(),
        false => numbers::modulus(sum)
            .map_or_else(|| format!("{:.9}", numbers::evaluate(sum).norm()), |form| form.to_string()),
    };
    let mut lines = Vec::new();
    for order in &orders {
        for part in &order.parts {
            for balance in [&part.force, &part.moment] {
                lines.extend(balance.verdicts().map(|one| length(one.vanishes(), &one.sum)));
                lines.push(format!("{:?}", balance.shape));
            }
        }
        for torque in [&order.torque, &order.roll].into_iter().flatten() {
            lines.extend(torque.parts.iter().map(|part| length(part.verdict.vanishes(), &part.verdict.sum)));
        }
    }
    lines
}

/// Engines as the file draws them, and as it draws their mirror images, which turn the other way.
#[test]
fn a_mirror_image_of_several_crankshafts_leaves_the_same() {
    let mut dice = Dice::new(42);
    for _ in 0..12 {
        let text = any_engine(&mut dice);
        let (one, other) = (layout(&text), layout(&format!("{CLOCKWISE}{}", other_drawing(&text))));
        assert_eq!(sizes(&one), sizes(&other), "{text}");
    }
    for (one, mirrored) in [
        ("[u]\nthrows = [0, 90]\nsense = 'against'\ndistance = 4\nphase = 30", "[0, -90]"),
        ("[u]\nthrows = [0, 90]\nsense = 'with'\ndistance = 4\nphase = 30", "[0, -90]"),
        ("[h]\nthrows = [0, 90]\nsense = 'against'\ndistance = 4\nphase = 30", "[0, -90]"),
        ("[opposed_piston]\nthrows = [0, 90]\nlead = 11", "[0, -90]"),
        ("[opposed_piston]\nthrows = [0, 90]\nlead = 11\nleading = 'lower'\nsense = 'against'", "[0, -90]"),
        ("[square_four]\nin_phase = 'diagonals'\nsense = 'against'\ndistance = 4", ""),
    ] {
        let drawn = format!("{CLOCKWISE}{}", one.replace("[0, 90]", mirrored));
        let (one, other) = (layout(one), layout(&drawn));
        assert_eq!(sizes(&one), sizes(&other), "{drawn}");
        // A lead counts with the crank, and not in the drawing.
        let ahead = |engine: &Engine| {
            let cylinders = engine.cylinders();
            let half = cylinders.len() / 2;
            let pairs = cylinders.iter().zip(&cylinders[half..]);
            pairs.map(|(one, other)| &other.top_dead_centre() - &one.top_dead_centre()).collect::<Vec<_>>()
        };
        assert_eq!(ahead(&one), ahead(&other), "{drawn}");
    }
}

/// Corners follow each other in the sense of rotation: else the exhaust would not lead.
#[test]
fn a_delta_is_the_same_engine_in_either_drawing() {
    let mut dice = Dice::new(43);
    for against in ["", "against = ['B']\n", "against = ['B', 'C']\n", "against = []\n"] {
        let rows = (0..3).map(|_| (15 * dice.below(24)).to_string()).collect::<Vec<_>>().join(", ");
        let text = format!("[delta]\nrows = [{rows}]\ncircumradius = 6\n{against}");
        let engine = layout(&text);
        assert_eq!(as_if_drawn_so(&format!("{CLOCKWISE}{text}"), &engine), engine, "{text}");
    }
}

#[test]
fn left_is_the_left_of_the_drawing() {
    let text = "[u]\nthrows = [0]\nsense = 'against'\ndistance = 4\n";
    let offset = |engine: &Engine| engine.geared_cranks()[0].axis[0].weight.to_string();
    assert_eq!(offset(&layout(text)), "2");
    // Its page looks from the flywheel.
    let other = layout(&format!("{CLOCKWISE}{text}"));
    assert_eq!(offset(&other), "-2");
    let page = pages::text(&pages::document(&other), pages::DOLLARS);
    assert!(page.contains("The layout file draws the engine from the free end"), "{page}");
}

/// What a remedy for these orders says in sentences, and what it answers in short.
fn said(text: &str, orders: &[u32]) -> [String; 2] {
    let request = Request { orders: orders.to_vec(), ..Request::default() };
    let found = remedy(&layout(text), &request).expect("a remedy");
    let cures = remedy_cures(&found).iter().map(crankstar::page::Text::plain).collect::<Vec<_>>().join("\n");
    [cures, pages::text(&remedy_answer(&found), pages::DOLLARS)]
}

#[test]
fn a_crankshaft_that_turns_against_the_reference_bears_the_weight_at_minus_1() {
    const BEARS: &str = "may sit on crankshaft right";
    let twin = |sense: &str| format!("[u]\nthrows = [0]\nsense = '{sense}'\ndistance = 4\n");
    let [cures, answer] = said(&twin("against"), &[1]);
    assert!(cures.contains(BEARS) && answer.contains(BEARS), "{cures}");
    assert!(!cures.contains("Counterweights cannot replace") && !answer.contains("fewest"), "{answer}");
    let [cures, answer] = said(&twin("against"), &[1, 2]);
    assert!(cures.contains(BEARS) && cures.contains("cannot replace the other shafts"), "{cures}");
    assert!(answer.contains("still needed is 2"), "{answer}");
    let [cures, _] = said(&twin("against"), &[2]);
    assert!(!cures.contains(BEARS) && cures.contains("cannot replace these shafts"), "{cures}");
    let [cures, answer] = said(&twin("with"), &[1, 2]);
    assert!(!cures.contains("may sit on crankshaft") && cures.contains("cannot replace these shafts"), "{cures}");
    assert!(answer.contains("3 balancer shafts are the fewest possible"), "{answer}");
}

#[test]
fn it_is_said_on_which_of_several_crankshafts_the_counterweights_are() {
    let twin = "u = { throws = [0], sense = 'against', distance = 4 }\n\
                [mechanism]\nreciprocating_mass = 1\nrotating_mass = 1\ncrank_radius = 1\nrod_ratio = '1/4'\n";
    let [cures, _] = said(twin, &[1]);
    assert!(cures.contains("These counterweights are on crankshaft left, the reference."), "{cures}");
    let [cures, _] = said(&format!("{twin}[[counterweight]]\nthrow = 2\nmass_radius = '1/4'\n"), &[1]);
    let stay = "the reference; those of the other crankshafts stay as they are.";
    assert!(cures.contains(stay), "{cures}");
    let [cures, _] = said("inline.throws = [0]", &[1]);
    assert!(!cures.contains("These counterweights are"), "{cures}");
}

/// A weight at −1 on such a crankshaft is a counterweight there: the engine with it has nothing left at order 1.
#[test]
fn the_weight_at_minus_1_stands_on_that_crankshaft_as_it_is_proposed() {
    let twin = "[u]\nthrows = [0]\nsense = 'against'\ndistance = 4\n";
    let found = remedy(&layout(twin), &Request { orders: vec![1], ..Request::default() }).expect("a remedy");
    let [shaft] = &found.shafts[..] else { panic!("one shaft") };
    assert_eq!((shaft.order, shaft.sense, shaft.weights.len()), (1, Sense::Reverse, 1));
    let size = shaft.weights[0].modulus().expect("a length").to_string();
    let own = format!(
        "{twin}[[counterweight]]\nthrow = 1\nmass_radius = '1 m r'\n[[counterweight]]\nthrow = 2\nmass_radius = '{size} m r'\n"
    );
    let engine = layout(&own);
    let quantities = verdict::quantities(&engine, false);
    let orders = verdict::classify(&engine, &[1], Masses::All, &quantities).expect("orders");
    let balances = orders[0].parts.iter().flat_map(|part| [&part.force, &part.moment]);
    assert!(balances.flat_map(|balance| balance.verdicts()).all(|one| one.vanishes()), "{own}");
}

/// Vs on two crankshafts with no throws, one against the other: `β = α − τ` on the first, `α + τ` on the other.
#[test]
fn throws_follow_from_the_firing_on_crankshafts_of_either_sense() {
    let text = |[rotation, sense, minus, plus]: [&str; 4]| {
        let cranks = format!(
            "[[crankshaft]]\nname = 'a'\nsense = 'with'\n[[crankshaft]]\nname = 'b'\nsense = '{sense}'\nheight = 4\n"
        );
        let pin = |crank: &str, position: u32| {
            let one =
                |bank: &str| format!("[[cylinder]]\ncrankshaft = '{crank}'\nbank = {bank}\nposition = {position}\n");
            one(minus) + &one(plus)
        };
        let head = format!("{rotation}cycle = 'four-stroke'\nfiring_angles = [0, 90, 450, 360, 270, 180]\n");
        head + &cranks + &pin("a", 0) + &pin("b", 1) + &pin("b", 2)
    };
    for [rotation, minus, plus] in [["", "-45", "45"], [CLOCKWISE, "45", "-45"]] {
        let engine = layout(&text([rotation, "against", minus, plus]));
        let pins: Vec<_> = engine.cylinders().iter().map(|cylinder| engine.pin_angle(cylinder)).collect();
        assert!(pins.chunks(2).all(|pins| pins[0] == pins[1]), "{pins:?}");
        // Where both turn alike, shared pins would take the banks of the second exchanged.
        let wrong = text([rotation, "with", minus, plus]);
        let error = parse("v.toml", &wrong).expect_err("two pins of three").to_string();
        assert!(error.contains("with the banks exchanged"), "{error}");
    }
}

/// What is said of banks and throws is of crankshafts that turn one way.
#[test]
fn an_order_that_fits_the_other_rotation_is_told_so() {
    let text = |rotation: &str| {
        format!(
            "{rotation}cycle = 'two-stroke'\nfiring_order = '1-2-3'\n\
             [[crankshaft]]\nname = 'a'\nsense = 'with'\n[[crankshaft]]\nname = 'b'\nsense = 'against'\noffset = 4\n\
             [[cylinder]]\ncrankshaft = 'a'\nthrow = 0\nbank = 0\nposition = 0\n\
             [[cylinder]]\ncrankshaft = 'a'\nthrow = 120\nbank = 0\nposition = 1\n\
             [[cylinder]]\ncrankshaft = 'b'\nthrow = 120\nbank = 0\nposition = 1\n"
        )
    };
    let error = parse("i3.toml", &text("")).expect_err("it fires 1-3-2").to_string();
    assert!(error.contains("as drawn it fits a crank that turns with rotation = \"clockwise\""), "{error}");
    assert!(!error.contains("banks exchanged") && !error.contains("other sign"), "{error}");
    layout(&text(CLOCKWISE));
}
