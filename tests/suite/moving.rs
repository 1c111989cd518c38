//! Does an engine in motion say what is proved, and is its drawing that of the engine?

use std::collections::BTreeMap;

use crate::support::dice::Dice;
use crate::support::engines;
use crate::support::written::fraction;
use crankstar::engine::{DELTA, Engine, Family, PHI};
use crankstar::exact::Turn;
use crankstar::family;
use crankstar::file::{self, Layout, parse_layout};
use crankstar::order;
use crankstar::page::Language;
use crankstar::proof::{Quantity, Sense};
use crankstar::report::Weighing;
use crankstar::report::moving::{
    MOVING_SCRIPT, MOVING_STYLE, MovingQuantity, MovingSense, Scene, moving_fragment, open_scenes, scene,
};
use crankstar::verdict::{Balance, Judgement, WholeOrder};
use num_complex::Complex;
use num_rational::BigRational;

const ORDERS: [u32; 5] = [1, 2, 3, 4, 6];

fn judged(engine: &Engine) -> Judgement {
    Judgement::new(engine, &ORDERS, &Quantity::PLANAR).expect("orders")
}

fn open(text: &str) -> Family {
    match parse_layout("test", text).expect("it reads") {
        Layout::Open(family) => *family,
        Layout::Known(..) => panic!("nothing is open in {text}"),
    }
}

/// The sum of the vectors as the page draws them, the open angle moved by this many degrees.
fn drawn(sense: &MovingSense, moved: f64) -> Complex<f64> {
    let rays = sense.rays.iter();
    rays.map(|ray| Complex::from_polar(ray.length, (ray.degrees + ray.turns * moved).to_radians())).sum()
}

fn near(one: Complex<f64>, other: Complex<f64>) -> bool {
    (one - other).norm() < 1e-9 * (1.0 + one.norm())
}

fn says_what_is_proved(said: &MovingQuantity, balance: &Balance, exists: bool, text: &str) {
    assert_eq!(said.words == "0, proved", exists && balance.is_balanced(), "{text}: {}", said.words);
    for (sense, verdict) in said.senses.iter().zip(balance.verdicts()) {
        assert_eq!(sense.zero, verdict.vanishes(), "{text}");
        assert_eq!(sense.words == "0, proved", verdict.vanishes(), "{text}: {}", sense.words);
        let sum = Complex::from_polar(sense.length, sense.degrees.to_radians());
        assert!(near(drawn(sense, 0.0), sum), "{text}: {sum} is not what is drawn");
        assert_eq!(sense.length == 0.0, verdict.vanishes(), "{text}");
    }
}

/// The vectors with their coefficients sum to what the loads of the engine are, which are computed class by class.
fn says_of_the_whole(said: &MovingQuantity, whole: &WholeOrder, exists: bool, text: &str) {
    assert_eq!(said.words == "0, proved", exists && whole.is_balanced(), "{text}: {}", said.words);
    for (sense, outcome) in said.senses.iter().zip(&whole.outcomes) {
        assert_eq!(sense.zero, outcome.vanishes() == Some(true), "{text}");
        let sum = Complex::from_polar(sense.length, sense.degrees.to_radians());
        let most = sense.rays.iter().map(|ray| ray.length).sum::<f64>();
        assert!((drawn(sense, 0.0) - sum).norm() < 1e-8 * (1.0 + most), "{text}: {sum} is not what is drawn");
    }
}

fn opens_on_the_first_order_left(made: &Scene, judged: &Judgement, text: &str) {
    let is_left = |whole: &WholeOrder| whole.outcomes.iter().any(|outcome| outcome.vanishes() != Some(true));
    let mut left = judged.orders.iter().filter(|order| made.orders.iter().any(|said| said.order == order.order));
    let first = left.find(|order| order.exists() && (is_left(&order.force) || is_left(&order.moment)));
    let expected = first.map(|order| (order.order, if is_left(&order.force) { "force" } else { "moment" }));
    let (place, quantity) = made.start;
    if let Some(expected) = expected {
        assert_eq!((made.orders[place].order, quantity), expected, "{text}");
    }
}

/// Every crankshaft turns, each its own way about its own axis: its pins stand at θ = 0 where the engine says.
#[test]
fn several_crankshafts_move_each_about_its_own_axis() {
    let text = "[delta]\nrows = [0, 120, 240]\ncircumradius = 6";
    let engine = file::parse("delta", text).expect("it reads");
    let made = scene(&engine, &judged(&engine), None, Weighing::usual());
    let mut axes: Vec<[i64; 2]> = Vec::new();
    for body in &made.bodies {
        let cylinder = engine.cylinders().iter().find(|cylinder| cylinder.name == body.name).expect("the cylinder");
        let sign = if engine.sense_of(cylinder) == Sense::Direct { 1.0 } else { -1.0 };
        assert_eq!(body.speed, sign);
        let pin = crankstar::numbers::direction(&engine.pin_angle(cylinder));
        assert!(near(Complex::from_polar(1.0, body.throw.to_radians()), pin), "{}", body.name);
        axes.push(body.axis.map(|place| (place * 1e6).round() as i64));
    }
    axes.sort_unstable();
    axes.dedup();
    assert_eq!(axes.len(), 3);
    assert!(made.bodies.iter().any(|body| body.speed < 0.0) && made.bodies.iter().any(|body| body.speed > 0.0));
}

#[test]
fn words_say_0_exactly_where_it_is_proved_for_random_engines() {
    let mut dice = Dice::new(12);
    let (mut zeros, mut wholes) = (0, 0);
    for form in engines::FORMS.iter().cycle().take(160) {
        let text = engines::file(&mut dice, form);
        let Ok(Layout::Known(engine, _)) = parse_layout("random", &text) else { continue };
        let judged = judged(&engine);
        let made = scene(&engine, &judged, None, Weighing::usual());
        for said in &made.orders {
            let order = judged.orders.iter().find(|order| order.order == said.order).expect("a judged order");
            match order.parts.as_slice() {
                [part] if part.class.is_none() => {
                    says_what_is_proved(&said.force, &part.force, part.exists, &text);
                    says_what_is_proved(&said.moment, &part.moment, part.exists, &text);
                }
                _ => {
                    says_of_the_whole(&said.force, &order.force, order.exists(), &text);
                    says_of_the_whole(&said.moment, &order.moment, order.exists(), &text);
                    wholes += 1;
                }
            }
            zeros += usize::from(said.force.words == "0, proved");
        }
        opens_on_the_first_order_left(&made, &judged, &text);
        assert_eq!(made.bodies.len(), engine.cylinders().len());
    }
    assert!(zeros > 100 && wholes > 50, "only {zeros} zeros, {wholes} orders of several coefficients");
}

/// The engine at a value of the unknown that moves, the others as they are held.
fn member(family: &Family, held: &BTreeMap<String, BigRational>, unknown: &str, turns: BigRational) -> Engine {
    let mut values = held.clone();
    values.insert(unknown.to_owned(), turns);
    family.with(&values).expect("it holds together").only().expect("all is known").expect("it holds together")
}

/// Every step of the slider and every mark: what the list says, and what is drawn, are those of the engine at that value.
fn the_slider_is_right(text: &str, held: &[(&str, BigRational)], unknown: &str, which: usize) -> usize {
    let family = open(text);
    let held: BTreeMap<String, BigRational> = held.iter().map(|(name, v)| ((*name).to_owned(), v.clone())).collect();
    let made = &open_scenes(&family, &ORDERS)[which];
    let angle = made.angle.as_ref().expect("an angle is open");
    let mut at: Vec<i64> =
        (0..48).map(|step| angle.low + step * ((angle.high - angle.low) / 48 / angle.step * angle.step)).collect();
    let quantities = made.orders.iter().flat_map(|order| [&order.force, &order.moment]);
    at.extend(quantities.flat_map(|quantity| quantity.marks.iter().map(|mark| mark.at)));
    let mut zeros = 0;
    for value in at {
        let engine = member(&family, &held, unknown, BigRational::new(value.into(), (360 * angle.unit).into()));
        let moved = (value - angle.start.at) as f64 / angle.unit as f64;
        for body in &made.bodies {
            let own = engine.cylinders().iter().find(|cylinder| cylinder.name == body.name).expect("the cylinder");
            let is = |degrees: f64, turn: &Turn| {
                near(Complex::from_polar(1.0, degrees.to_radians()), crankstar::numbers::direction(turn))
            };
            assert!(is(body.throw + body.throw_turns * moved, &own.throw), "{text}: throw of {}", own.name);
            assert!(is(body.bank + body.bank_turns * moved, &own.bank), "{text}: bank of {}", own.name);
        }
        for order in made.orders.iter().filter(|order| order.exists) {
            for (quantity, of) in [(&order.force, Quantity::FORCE), (&order.moment, Quantity::MOMENT)] {
                for (sense, which) in quantity.senses.iter().zip([Sense::Direct, Sense::Reverse]) {
                    let star = order::star(&engine, of, order.order, Some(which));
                    let list = sense.zeros.as_ref().expect("a list");
                    assert!(near(drawn(sense, moved), crankstar::numbers::evaluate(&star)), "{text} at {value}");
                    let listed = list.everywhere || list.at.contains(&value);
                    assert!(!listed || star.vanishes(), "{text}, order {}: not 0 at {value}", order.order);
                    assert!(!list.complete || listed == star.vanishes(), "{text}, order {}: 0 at {value}", order.order);
                    zeros += usize::from(listed && !list.everywhere);
                }
            }
        }
    }
    zeros
}

#[test]
fn the_list_of_zeros_is_right_at_every_step_of_the_slider_and_at_every_mark() {
    const V6_SPLIT: &str = "vee = { bank_angle = 'phi', throws = [0, 120, 240], pin_split = 'delta' }";
    const SPACED: &str = "vee = { bank_angle = 'phi', throws = [0, 120, 240], spacing = 'a', bank_offset = 'b' }";
    let lengths = [("a", fraction(1, 1)), ("b", fraction(1, 2))];
    let zeros = [
        the_slider_is_right("vee = { bank_angle = 'phi', throws = [0] }", &[], PHI, 0),
        the_slider_is_right("vee = { bank_angle = 'phi', throws = [0, 270, 90, 180] }", &[], PHI, 0),
        the_slider_is_right("fan = { banks = ['-phi', 0, 'phi'], throws = [0, 180], positions = [0, 1] }", &[], PHI, 0),
        the_slider_is_right("vee = { bank_angle = 72, throws = [0, 180], pin_split = 'delta' }", &[], DELTA, 0),
        the_slider_is_right(V6_SPLIT, &[(DELTA, fraction(0, 1))], PHI, 0),
        the_slider_is_right(V6_SPLIT, &[(PHI, fraction(1, 4))], DELTA, 1),
        the_slider_is_right(SPACED, &lengths, PHI, 0),
    ];
    assert!(zeros.iter().sum::<usize>() > 100, "{zeros:?}");
}

/// Its reverse force of order 1 is (x² − x/2 + 1)(x + 2) with x = e^{iφ}: 0 where cos φ = 1/4.
const IRRATIONAL: &str = "
    cylinder = [{ throw = 0, bank = 0, position = 0, reciprocating_mass = 2 },
                { throw = 0, bank = 'phi', position = 0, reciprocating_mass = '3/2' }, { throw = 0, bank = '3/2 phi', position = 1 }]";

#[test]
fn the_slider_stops_beside_an_irrational_zero_and_says_that_it_is_rounded() {
    the_slider_is_right(IRRATIONAL, &[], PHI, 0);
    let made = open_scenes(&open(IRRATIONAL), &[1]).remove(0);
    let angle = made.angle.expect("φ is open");
    let force = &made.orders[0].force;
    let list = force.senses[1].zeros.as_ref().expect("a list");
    assert!(list.complete && list.at.is_empty());
    let degrees: Vec<f64> = list.near.iter().map(|at| *at as f64 / angle.unit as f64).collect();
    let [first, second] = degrees[..] else { panic!("{degrees:?}") };
    let zero = 0.25_f64.acos().to_degrees();
    assert!((first - zero).abs() < 1e-3 && (second - 360.0 + zero).abs() < 1e-3, "{degrees:?}");
    let marks: Vec<(&str, bool)> = force.marks.iter().map(|mark| (mark.text.as_str(), mark.both)).collect();
    assert_eq!(marks, [("≈ 75.52°", false), ("≈ 284.5°", false)]);
    assert!(force.marks.iter().all(|mark| mark.of == ["reverse"] && list.near.contains(&mark.at)));
    assert!(MOVING_SCRIPT.contains("zeros.near.includes(value)"));
}

#[test]
fn where_lengths_are_open_the_moment_is_not_said_to_vanish_nowhere_else() {
    let family = open("vee = { bank_angle = 'phi', throws = [0, 120, 240], spacing = 'a', bank_offset = 'b' }");
    let made = &open_scenes(&family, &ORDERS)[0];
    let lists = |of: fn(&crankstar::report::moving::MovingOrder) -> &MovingQuantity| {
        let senses = made.orders.iter().flat_map(move |order| &of(order).senses);
        senses.filter_map(|sense| sense.zeros.clone()).filter(|zeros| !zeros.everywhere).collect::<Vec<_>>()
    };
    assert!(lists(|order| &order.force).iter().all(|zeros| zeros.complete));
    let moments = lists(|order| &order.moment);
    assert!(!moments.is_empty() && moments.iter().all(|zeros| !zeros.complete));
}

#[test]
fn a_member_of_a_family_starts_at_the_value_of_its_file() {
    let text = "values = { phi = '180/7' }\nvee = { bank_angle = 'phi', throws = [0] }";
    let Ok(Layout::Known(engine, Some(family))) = parse_layout("member", text) else { panic!("a member of a family") };
    let judged = judged(&engine);
    let orders = family::classify(&family, &ORDERS).expect("orders");
    let made = scene(&engine, &judged, Some((&family, &orders)), Weighing::usual());
    let angle = made.angle.expect("φ is open");
    assert_eq!((angle.start.text.as_str(), angle.start.at * 7), ("(180/7)°", 180 * angle.unit));
    for quantity in made.orders.iter().flat_map(|order| [&order.force, &order.moment]) {
        for sense in &quantity.senses {
            let Some(zeros) = &sense.zeros else { continue };
            assert_eq!(sense.zero, zeros.everywhere || zeros.at.contains(&angle.start.at));
        }
    }
}

#[test]
fn no_text_of_a_person_ends_the_script_or_begins_markup() {
    let harm = "</script><script>alert(1)</script><!-- \u{2028}\u{2029} ]]> & \\\"q\\\" ' \\u001b[31m";
    let text = format!("title = \"{harm}\"\n[[cylinder]]\nname = \"1\"\nthrow = 0\nbank = 0\nposition = 0\n");
    let engine = file::parse("hostile", &text).expect("it reads");
    let mut made: Scene = scene(&engine, &judged(&engine), None, Weighing::usual());
    made.bodies[0].name = harm.to_owned();
    let page = moving_fragment(&made, "m\" onclick=\"alert(1)", Language::En);
    assert_eq!(page.matches("<script").count(), 1, "{page}");
    assert_eq!(page.matches("</script").count(), 1, "{page}");
    assert!(!page.contains("<!--") && !page.contains(['\u{2028}', '\u{2029}', '\u{1b}']), "{page}");
    assert!(!page.contains("onclick=\"alert"), "{page}");
    let json = page.split_once("data-part=\"scene\">").and_then(|(_, rest)| rest.split_once("</script>"));
    let read: serde_json::Value = serde_json::from_str(json.expect("a scene").0).expect("JSON");
    assert_eq!(read["bodies"][0]["name"], harm);
}

#[test]
fn the_script_is_small_asks_nothing_of_a_network_and_makes_no_markup_of_data() {
    assert!(MOVING_SCRIPT.len() < 21 * 1024, "{} bytes", MOVING_SCRIPT.len());
    for word in [
        "innerHTML",
        "eval(",
        "new Function",
        "fetch(",
        "XMLHttpRequest",
        "import",
        "insertAdjacent",
        "document.write",
        "</",
    ] {
        assert!(!MOVING_SCRIPT.contains(word), "{word}");
    }
    assert_eq!(MOVING_SCRIPT.matches("http").count(), 1, "the name of SVG is the only address");
    assert!(!MOVING_STYLE.contains("url(") && !MOVING_STYLE.contains("@import"));
}

/// The notes beside a moving engine are in the language of its page, and those of an offset tell the orders whose vectors do not have it.
#[test]
fn notes_of_a_moving_engine_are_true_and_in_the_language_of_the_page() {
    let layout = |more: &str| {
        format!(
            "title = 'Clockwise'\nspeed = 3000\nrotation = 'clockwise'\n[inline]\nthrows = [0, 180]\nspacing = '90 mm'\n\
             [mechanism]\npin_offset = '4 mm'\nstroke = '80 mm'\nrod_length = '140 mm'\nreciprocating_mass = '1 kg'\n{more}"
        )
    };
    let notes = |text: &str, language: Language| {
        let engine = file::parse("moving.toml", text).unwrap_or_else(|error| panic!("{error}"));
        let made = scene(&engine, &judged(&engine), None, Weighing::usual());
        moving_fragment(&made, "scene-1", language).split("<script").next().unwrap_or_default().to_owned()
    };
    let uniform = notes(&layout(""), Language::En);
    assert!(uniform.contains("c_k of orders 1, 3 turns the vectors by an additional angle"), "{uniform}");
    let whole = notes(&layout("rotating_mass = '1 kg'\n"), Language::En);
    assert!(whole.contains("c_k of order 3 turns the vectors by an additional angle"), "{whole}");
    let apart = notes(&layout("").replace("'4 mm'", "['4 mm', '5 mm']"), Language::En);
    assert!(!apart.contains("additional angle"), "{apart}");
    let german = notes(&layout("rotating_mass = '1 kg'\n"), Language::De);
    for words in ["Wie gebaut: ", "Die Eingabedatei zeichnet", "0 ist bewiesen;", "Koeffizient c_k von Ordnung 3"] {
        assert!(german.contains(words), "`{words}` is not in: {german}");
    }
    for words in ["As built", "The layout file", "0 is proved", "turns the vectors"] {
        assert!(!german.contains(words), "`{words}` is in: {german}");
    }
}
