//! Are sweeps exact in their values and zeros, right in their amplitudes, and told in words where they cannot be done?

use std::process::Command;

use crankstar::engine::{self, Cycle};
use crankstar::file::{self, Key, Layout, Template};
use crankstar::loads;
use crankstar::numbers::Form;
use crankstar::order;
use crankstar::proof::{Planar, Quantity, Sense};
use crankstar::remedy::{ComparableEngine, two_planes};
use crankstar::sweep::{self, Geometry, MOST_POINTS, Parameter, Range, Sweep, SweptEngine};
use crankstar::{page, report};
use num_traits::ToPrimitive;

use crate::studies::section::section;
use crate::support::program::{call, scratch};
use crate::support::tables;
use crate::support::written::fraction;
use crate::support::{dice, every_form};

pub const V6: &str = "cycle = \"four-stroke\"\n[vee]\nbank_angle = 60\nthrows = [0, 240, 120]\n";
const V8: &str = "cycle = \"four-stroke\"\n[vee]\nbank_angle = 90\nthrows = [0, 270, 90, 180]\n";
const MASSES: &str = "[mechanism]\ncrank_radius = \"45 mm\"\nrod_ratio = 0.25\nreciprocating_mass = \"0.6 kg\"\nrotating_mass = \"0.2 kg\"\n";

pub fn run(text: &str, parameters: &[&str], orders: &[u32]) -> Result<Sweep, String> {
    let template = Template::new("test.toml", text).expect("it is TOML");
    let parameters: Result<Vec<Parameter>, _> = parameters.iter().map(|text| Parameter::parse(text)).collect();
    let parameters = parameters.map_err(|error| error.to_string())?;
    sweep::sweep(&template, &parameters, orders, &Geometry::default()).map_err(|error| error.to_string())
}

pub fn good(text: &str, parameters: &[&str], orders: &[u32]) -> Sweep {
    run(text, parameters, orders).expect("a sweep")
}

fn close(value: f64, right: f64) -> bool {
    (value - right).abs() <= 1e-12 * right.abs().max(1.0)
}

#[test]
fn values_are_exact_and_the_end_is_one_where_it_lies_on_the_grid() {
    let values =
        |text: &str| Range::parse(text).expect(text).values().map(|value| value.to_string()).collect::<Vec<_>>();
    assert_eq!(values("0..1:1/3"), ["0", "1/3", "2/3", "1"]);
    assert_eq!(values("0..1:0.3"), ["0", "3/10", "3/5", "9/10"]);
    assert_eq!(values("10..-10:-10"), ["10", "0", "-10"]);
    assert_eq!(values("5..5:7"), ["5"]);
    let metric = Range::parse("80..120:20 mm").expect("millimetres");
    assert_eq!(metric, Range::parse("80 mm..120mm:20 mm").expect("a unit behind each number"));
    assert_eq!((metric.unit(), metric.count()), ("mm", 3));
    assert_eq!(Range::parse("0..1:1e-1").expect("an exponent").count(), 11);
}

#[test]
fn ranges_that_are_none_are_refused_in_words() {
    for (text, word) in [
        ("0..180", "no step"),
        ("0:10", "no `..`"),
        ("0..180:0", "step of 0"),
        ("0..180:-10", "is empty"),
        ("180..0:10", "0..180"),
        ("0..1000000000:1", "1000000001 points"),
        ("0..1:1e-90", "points"),
        ("a..2:1", "start"),
        ("1..:1", "end"),
        ("1..2:x", "step"),
        ("", "`..`"),
        ("0..1/0:1", "fraction over 0"),
    ] {
        let error = match Range::parse(text) {
            Ok(range) => format!("{} points were read", range.count()),
            Err(error) => error.to_string(),
        };
        if text == "180..0:10" {
            assert!(error.contains("180..0:-10"), "{text}: {error}");
        } else {
            assert!(error.contains(word), "{text}: {error}");
        }
    }
    assert_eq!(Range::parse("1..1000000000:1").expect("just enough").count(), 1_000_000_000);
    let told = run(V6, &[&format!("speed=0..{MOST_POINTS}:1")], &[1]).expect_err("too many for a page");
    assert!(told.contains("100001 points") && told.contains("--format csv"), "{told}");
}

#[test]
fn sweeps_that_cannot_be_done_are_refused_in_words() {
    for (parameters, word) in [
        (&[][..], "nothing is swept"),
        (&["speed=1..2:1", "vee.spacing=1..2:1", "vee.pin_split=1..2:1"][..], "3 parameters"),
        (&["speed=1..2:1", "speed=1..2:1"][..], "swept twice"),
        (&["vee.pin_split=0..2000:1", "vee.bank_angle=0..100:0.1"][..], "2001 × 1001 points"),
        (&["vee.bankangle=0..1:1"][..], "unknown key `bankangle`"),
        (&["vee.throws.4=0..1:1"][..], "no `4` in a list of 3"),
        (&["vee.throws.1.2=0..1:1"][..], "single value"),
        (&["vee=0..1:1"][..], "is a table"),
        (&["vee.bank_angle=0..360:90"][..], "vee.bank_angle = 360"),
        (&["mechanism.rod_ratio=0..1:0.5"][..], "cannot turn round"),
        (&["title=0..1:1"][..], "no quantity"),
        (&["=0..1:1"][..], "cannot read the key"),
        (&["2=0..1:1"], "cannot read the key `2`"),
        (&["1.throw=0..1:1"], "cannot read the key"),
        (&["vee.bank_angle"][..], "sets nothing"),
        (&["crankshaft.balance_factor=0..1:1"][..], "counterweight_radius"),
    ] {
        let error = run(V6, parameters, &[]).expect_err("it is refused");
        assert!(error.contains(word), "{parameters:?}: {error}");
    }
    let template = Template::new("i4.toml", "[inline]\nthrows = [0, 180]").expect("TOML");
    let error = Parameter::short_cut("bank-angle", "0..90:10", &template).expect_err("no V").to_string();
    assert!(error.contains("[vee]") && error.contains("[inline]"), "{error}");
    assert!(run("[vee]\nbank_angle = \"phi\"\nthrows = [0]", &["speed=1..2:1"], &[]).is_err_and(|e| e.contains("phi")));
}

/// The amplitudes of a sweep against those of the room of loads, which sums exactly and encloses its coefficients.
fn same_as_loads(point: &SweptEngine, layout: &engine::Engine, orders: &[u32]) {
    let loads = loads::loads(layout, orders).expect("loads");
    for (own, other) in point.orders.iter().zip(&loads.orders) {
        for (own, swing) in [(&own.force, &other.force), (&own.moment, &other.moment)] {
            let size = 1.0 + swing.largest();
            let near = |a: f64, b: f64| (a - b).abs() < 1e-11 * size;
            assert!(near(own.largest.value, swing.largest()), "{} {}", own.largest.value, swing.largest());
            assert!(near(own.smallest.value, swing.smallest()));
            assert!(near(own.along.value, swing.along()) && near(own.across.value, swing.across()));
            assert_eq!(own.largest.vanishes, swing.vanishes());
            assert_eq!(own.direct.vanishes, swing.direct.outcome == loads::Outcome::Zero);
            assert_eq!(own.reverse.vanishes, swing.reverse.outcome == loads::Outcome::Zero);
        }
    }
}

#[test]
fn amplitudes_are_those_of_the_loads_with_and_without_masses_that_turn() {
    let counterweights = "[crankshaft]\nbalance_factor = 0.5\ncounterweight_radius = \"45 mm\"\n";
    let pistons = "[mechanism]\ncrank_radius = \"45 mm\"\nrod_ratio = 0.3\nreciprocating_mass = \"0.6 kg\"\n";
    let offset =
        "[mechanism]\ncrank_radius = \"45 mm\"\nrod_ratio = 0.3\noffset_ratio = 0.05\nreciprocating_mass = 1\n";
    let orders = [1, 2, 3, 4, 6];
    for rest in [pistons.to_owned(), offset.to_owned(), MASSES.to_owned(), format!("{MASSES}{counterweights}")] {
        for base in [V6, V8] {
            let text = format!("{base}{rest}");
            let sweep = good(&text, &["vee.bank_angle=0..180:36"], &orders);
            let template = Template::new("t.toml", &text).expect("TOML");
            let key = Key::parse("vee.bank_angle").expect("a key");
            for point in &sweep.points {
                let value = point.values[0].to_string();
                let Ok(Layout::Known(layout, _)) = template.layout(&[(&key, &value)]) else { panic!("it reads") };
                same_as_loads(point, &layout, &orders);
            }
        }
    }
}

#[test]
fn words_decide_as_the_exact_sums_do_on_random_engines() {
    let mut dice = dice::Dice::new(20_061);
    for _ in 0..60 {
        let count = 2 + dice.below(5);
        let list = |dice: &mut dice::Dice, of: u64| {
            let values: Vec<String> = (0..count).map(|_| format!("{}", 15 * dice.below(of))).collect();
            format!("[{}]", values.join(", "))
        };
        let throws = list(&mut dice, 24);
        let text = format!(
            "[vee]\nbank_angle = {}\nthrows = {throws}\npin_split = {}\n",
            15 * dice.below(12),
            15 * dice.below(6)
        );
        let layout = file::parse("r.toml", &text).expect("it reads");
        let point = sweep::judge(&layout, None, &[1, 2, 4, 6, 8, 12], &Geometry::default()).expect("judged");
        for order in &point.orders {
            for (quantity, own) in [(Quantity::FORCE, order.force), (Quantity::MOMENT, order.moment)] {
                let sum = |sense| crankstar::order::star(&layout, quantity, order.order, Some(sense));
                let (direct, reverse) = (sum(Sense::Direct), sum(Sense::Reverse));
                let right = [
                    (own.direct, direct.vanishes()),
                    (own.reverse, reverse.vanishes()),
                    (own.along, direct.plus(&reverse.conjugate()).vanishes()),
                    (own.across, direct.minus(&reverse.conjugate()).vanishes()),
                ];
                let flat = direct.squared_modulus().minus(&reverse.squared_modulus()).vanishes();
                assert_eq!((own.smallest.vanishes, own.smallest.value == 0.0), (flat, flat), "{text}");
                for (part, vanishes) in right {
                    assert_eq!(part.vanishes, vanishes, "{text} {quantity:?} {}", order.order);
                    assert_eq!(part.value == 0.0, vanishes, "{text}");
                }
            }
        }
    }
}

#[test]
fn counterweights_of_the_six_at_90_degrees_are_root_3_in_closed_form() {
    // m_cw = √3 r a (m_r + m_n)/(ρ b), Grigoryev, Vasilyev and Dolgov, section 2; m_r is the rotating mass of a pin.
    for (reciprocating, rotating) in [(3, 0), (3, 1), (6, 2), (5, 7)] {
        let text = format!(
            "[vee]\nbank_angle = 90\nthrows = [0, 240, 120]\n[mechanism]\nreciprocating_mass = {reciprocating}\nrotating_mass = {rotating}\n"
        );
        let layout = file::parse("v6.toml", &text).expect("it reads");
        let subject = ComparableEngine::new(&layout).expect("masses");
        let planes = [fraction(1, 1), fraction(-1, 1)];
        let (force, moment) = (subject.force(1, Sense::Direct), subject.moment(1, Sense::Direct));
        let weights = two_planes(1, Sense::Direct, &force, &moment, &planes);
        let root = Form::parse("√3").expect("a form");
        // b = 2a, and masses in multiples of m_n.
        let right = root.scaled(&(fraction(reciprocating + 2 * rotating, reciprocating) / fraction(2, 1)));
        assert_eq!(weights.len(), 2);
        for weight in &weights {
            assert_eq!(weight.modulus(), Some(right.clone()), "{text}");
        }
        let point = sweep::judge(&layout, None, &[1], &Geometry::default()).expect("judged");
        assert!(close(point.counterweight.expect("a couple").value, right.to_float()));
    }
}

#[test]
fn a_balanced_shaft_needs_no_counterweight_and_that_is_proved() {
    let i4 = file::find("I4").expect("I4").engine().expect("it reads");
    let none = sweep::judge(&i4, None, &[1], &Geometry::default()).expect("judged").counterweight.expect("planes");
    assert!(none.vanishes && none.value == 0.0);
    let i2 = file::parse("i2.toml", "[inline]\nthrows = [0, 0]").expect("it reads");
    // P = 2, one in each plane: U = 1/2.
    assert!(close(
        sweep::judge(&i2, None, &[1], &Geometry::default()).expect("judged").counterweight.expect("planes").value,
        0.5
    ));
}

#[test]
fn the_most_even_firing_of_the_six_is_that_of_its_bank_angle() {
    let sweep = good(V6, &["vee.bank_angle=10..180:10"], &[1]);
    for point in &sweep.points {
        let angle = point.values[0].to_integer().to_i64().expect("degrees");
        // Bank 2 fires γ after bank 1, or a revolution later: intervals γ and 240° − γ, or 120° ± γ.
        let right = (2 * angle).min((240 - 2 * angle).abs());
        let evenness = point.evenness.as_ref().expect("the cycle is given");
        assert_eq!(evenness.unevenness() * fraction(360, 1), fraction(right, 1), "{angle}");
        assert!(!evenness.of_the_file);
    }
    let of_the_file = file::find("I6").expect("I6").engine().expect("it reads");
    let even =
        sweep::judge(&of_the_file, None, &[1], &Geometry::default()).expect("judged").evenness.expect("a firing order");
    assert!(even.of_the_file && even.unevenness() == fraction(0, 1));
    let two_stroke = file::parse("i3.toml", "[inline]\nthrows = [0, 120, 200]").expect("it reads");
    let uneven = sweep::judge(&two_stroke, Some(Cycle::TwoStroke), &[1], &Geometry::default())
        .expect("judged")
        .evenness
        .expect("a cycle");
    assert_eq!(
        (uneven.longest * fraction(360, 1), uneven.shortest * fraction(360, 1)),
        (fraction(160, 1), fraction(80, 1))
    );
}

#[test]
fn more_cylinders_than_a_word_has_bits_fire_too() {
    let throws: Vec<String> = (0..72).map(|place| (place * 5).to_string()).collect();
    let engine = file::parse("i72.toml", &format!("inline.throws = [{}]", throws.join(", "))).expect("it reads");
    let even = sweep::judge(&engine, Some(Cycle::TwoStroke), &[1], &Geometry::default())
        .expect("judged")
        .evenness
        .expect("a cycle");
    assert_eq!((even.longest, even.shortest), (fraction(1, 72), fraction(1, 72)));
    assert!(
        sweep::judge(&engine, Some(Cycle::FourStroke), &[1], &Geometry::default()).expect("judged").evenness.is_none(),
        "too many orders to try"
    );
}

#[test]
fn a_firing_order_that_some_throws_cannot_fire_leaves_the_most_even_one() {
    let text = "cycle = \"four-stroke\"\nfiring_order = \"1-5-4-3-7-2-6-8\"\n[vee]\nbank_angle = 90\nthrows = [0, 270, 90, 180]\n";
    let sweep = good(text, &["vee.bank_angle=30..180:30"], &[1]);
    let of_the_file: Vec<bool> =
        sweep.points.iter().map(|point| point.evenness.as_ref().expect("a cycle").of_the_file).collect();
    assert!(of_the_file[2], "90° is what the order is for");
    assert!(sweep.points.iter().all(|point| point.evenness.is_some()));
}

#[test]
fn the_envelope_is_that_of_its_geometry() {
    let geometry = Geometry::default();
    let one = file::parse("i1.toml", "[inline]\nthrows = [0]").expect("it reads");
    let box_of = sweep::envelope(&one, &geometry).expect("a box");
    // D = 2r, λ = 1/4: 1 + 4 + 1.5·2 above the shaft and 1.6 below it; 1.6 to both sides; 1.2·2 along.
    assert!(close(box_of.height, 9.6) && close(box_of.breadth, 3.2) && close(box_of.length.expect("a length"), 2.4));
    let flat = file::parse("f.toml", "[flat]\nthrows = [0]").expect("it reads");
    let box_of = sweep::envelope(&flat, &geometry).expect("a box");
    assert!(close(box_of.breadth, 16.0) && close(box_of.height, 3.2));
    let sizes = |text: &str| {
        let mechanism = "[mechanism]\ncrank_radius = '40 mm'\nrod_length = '140 mm'\nreciprocating_mass = 0.5\n";
        let engine = file::parse("e.toml", &format!("{text}\n{mechanism}")).expect(text);
        sweep::envelope(&engine, &geometry).map(|size| [size.breadth, size.height])
    };
    let are = |text: &str, right: [f64; 2]| {
        let sizes = sizes(text).expect(text);
        assert!(sizes.iter().zip(right).all(|(size, right)| close(*size, right)), "{text}: {sizes:?}");
    };
    // Crankcases of radius 64 mm about two shafts; and above 180 mm of crank and rod 3 r.
    are("[u]\nthrows = [0, 180]\nsense = 'with'\ndistance = '400 mm'", [(400.0 + 128.0) / 40.0, 1.6 + 4.5 + 3.0]);
    are("[opposed_piston]\nlead = 9\nthrows = [0]\ndistance = '500 mm'", [3.2, (500.0 + 128.0) / 40.0]);
    assert_eq!(sizes("[opposed_piston]\nlead = 9\nthrows = [0]"), None, "nobody knows where its crankshafts are");
    // A bank 24 mm beside the shaft reaches 72 mm from it.
    let top = (4.5_f64 * 4.5 - 0.6 * 0.6).sqrt() + 3.0;
    for offset in ["24 mm", "-24 mm"] {
        let mechanism = format!("pin_offset = '{offset}'");
        let text =
            format!("[inline]\nthrows = [0]\n[mechanism]\ncrank_radius = '40 mm'\nrod_length = '140 mm'\n{mechanism}");
        let engine = file::parse("e.toml", &text).expect("it reads");
        let size = sweep::envelope(&engine, &geometry).expect("a box");
        assert!(close(size.breadth, 1.6 + 1.8) && close(size.height, 1.6 + top), "{size:?}");
    }
    // Half a circle of radius 1.6, and the rectangle 2.4 wide above it with what the circle shows beside it.
    let half = 1.2_f64;
    let (reach, top) = (1.6_f64, 8.0);
    let beside =
        2.0 * (reach * reach * (half / reach).acos() / 2.0 - half * (reach * reach - half * half).sqrt() / 2.0);
    let right = std::f64::consts::PI * reach * reach / 2.0 + 2.0 * half * top + beside;
    let area = section(&one, &geometry).expect("an area");
    assert!((area - right).abs() < 1e-2 * right, "{area} {right}");
    let metric = file::parse("m.toml", "[inline]\nthrows = [0, 180]\nspacing = \"100 mm\"").expect("it reads");
    assert_eq!(sweep::envelope(&metric, &geometry).expect("a box").length, None);
}

#[test]
fn any_key_is_swept_in_its_unit_and_two_make_a_map() {
    let text = format!("speed = 3000\n{V6}{MASSES}");
    let spaced = good(&text, &["vee.spacing=80..120:20 mm"], &[1]);
    let couple = |point: &SweptEngine| point.orders[0].moment.largest.value;
    assert!(close(couple(&spaced.points[2]) / couple(&spaced.points[0]), 1.5));
    let speed = good(&text, &["speed=1000..3000:1000"], &[1]);
    let newtons = |point: &SweptEngine| point.newtons.expect("masses and speed");
    assert!(close(newtons(&speed.points[2]) / newtons(&speed.points[0]), 9.0));
    let masses = good(&text, &["mechanism.reciprocating_mass=0.5..1:0.5"], &[1]);
    let of_pistons = |point: &SweptEngine| newtons(point) * point.orders[0].moment.reverse.value;
    assert!(close(of_pistons(&masses.points[1]) / of_pistons(&masses.points[0]), 2.0));
    let throw = good(V6, &["vee.throws.2=200..280:40"], &[1]);
    assert!(throw.points[1].orders[0].force.largest.vanishes && !throw.points[0].orders[0].force.largest.vanishes);
    let map = good(V6, &["vee.bank_angle=60..120:30", "vee.pin_split=-30..0:10"], &[1]);
    assert_eq!(map.points.len(), 12);
    assert_eq!(map.points[5].values, [fraction(90, 1), fraction(-20, 1)]);
    let files = page::write(&report::sweep_page(&map), page::Format::GITHUB, &page::Options::default());
    assert!(
        files.iter().any(|file| file.name == "moment-1.svg") && files[0].text.contains("pin\\_split")
            || files[0].text.contains("pin split")
    );
}

#[test]
fn a_balance_factor_is_swept_over_its_counterweights() {
    let crankshaft = "[crankshaft]\ncounterweight_radius = \"45 mm\"\nbalance_factor = 0\n";
    let text = format!("{V8}{MASSES}{crankshaft}");
    let sweep = good(&text, &["crankshaft.balance_factor=0..1:1/2"], &[1]);
    let left = |index: usize| sweep.points[index].orders[0].moment.direct;
    assert!(close(left(1).value, left(0).value / 2.0));
    // BF = 1 removes all that turns with the crank, exactly.
    assert!(left(2).vanishes && !left(1).vanishes);
}

#[test]
fn the_table_has_a_row_a_point_and_zero_only_where_it_is_proved() {
    let sweep = good(V6, &["vee.bank_angle=0..180:10"], &[1, 2]);
    let csv = report::sweep_csv(&sweep).text;
    let lines: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(lines.len(), 20);
    assert!(lines.iter().all(|line| line.len() == lines[0].len()), "every row has every column");
    let column = lines[0].iter().position(|name| *name == "moment_2_along").expect("the column");
    for line in &lines[1..] {
        assert_eq!(line[column] == "0", ["90", "180"].contains(&line[0]), "{}", line[0]);
    }
    let document = tables::json_of(&sweep);
    assert_eq!(document["points"].as_array().map(Vec::len), Some(19));
    assert_eq!(document["zeros"][7]["quantity"], "moment");
}

pub fn in_plain_text(document: &page::Document) -> String {
    let mut files = page::write(document, page::Format::PLAIN, &page::Options::default());
    files.swap_remove(0).text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn the_answer_names_the_exact_zeros_and_what_vanishes_everywhere() {
    let sweep = good(V6, &["vee.bank_angle=10..170:40"], &[1, 2]);
    let answer = in_plain_text(&report::sweep_answer(&sweep));
    for words in ["Moment of order 1: nowhere 0; from", "Exactly zero at every value: the force of orders 1, 2."] {
        assert!(answer.contains(words), "{words}: {answer}");
    }
    // 180° lies between the points.
    let to_the_end = good(V6, &["vee.bank_angle=50..190:70"], &[2]);
    let answer = in_plain_text(&report::sweep_answer(&to_the_end));
    assert!(answer.contains("Moment of order 2: exactly 0 at 180° and nowhere else in the range"), "{answer}");
}

#[test]
fn a_page_counts_in_newtons_where_the_file_gives_all_that_they_need() {
    let text = format!("speed = 3000\n{V6}{MASSES}");
    let sweep = good(&text, &["speed=1000..3000:1000"], &[1]);
    let newtons = |point: &SweptEngine| point.newtons.expect("masses and speed") * point.orders[0].moment.largest.value;
    let greatest = page::text_in(&page::Number::Decimal(newtons(&sweep.points[2])).into(), page::Format::PLAIN);
    for document in [report::sweep_page(&sweep), report::sweep_answer(&sweep)] {
        let text = in_plain_text(&document);
        assert!(text.contains(&greatest) && !text.contains("m r ω²"), "{greatest}: {text}");
    }
    let without = in_plain_text(&report::sweep_page(&good(V6, &["vee.bank_angle=60..90:30"], &[1])));
    assert!(without.contains("m r ω² c_k a"), "{without}");
}

#[test]
fn the_command_writes_its_folder_and_ends_with_2_where_the_sweep_is_refused() {
    let program = || Command::new(env!("CARGO_BIN_EXE_crankstar"));
    let folder = scratch("sweep-v6").join("new");
    let status = program()
        .args(["sweep", "V6-60-shared", "--bank-angle", "0..180:30", "--orders", "1,2", "--output"])
        .arg(&folder)
        .status()
        .expect("it starts");
    assert_eq!(status.code(), Some(0));
    for name in ["sweep.md", "sweep.csv", "sweep.json", "moment-1.svg", "moment-2.svg"] {
        assert!(folder.join(name).is_file(), "{name}");
    }
    let page = std::fs::read_to_string(folder.join("sweep.md")).expect("the page");
    assert!(page.contains("| 2 | moment | 180° | 60°, 180° | 180° | 90°, 180° | 0°, 180° |"), "{page}");
    let table = folder.with_file_name("sweep-v6-table");
    let _ = std::fs::remove_dir_all(&table);
    let of_table = ["sweep", "V6-60-shared", "--bank-angle", "0..180:30", "--format", "csv", "--output"];
    let status = program().args(of_table).arg(&table).status().expect("it starts");
    assert_eq!(status.code(), Some(0));
    assert!(table.join("sweep.csv").is_file() && !table.join("sweep.md").exists());
    for (format, begin) in [("html", "<!DOCTYPE html>"), ("latex", "\\documentclass"), ("text", "V6"), ("json", "{")] {
        let of_format = ["sweep", "V6-60-shared", "--bank-angle", "0..180:30", "--format", format];
        let printed = program().args(of_format).output().expect("it starts").stdout;
        assert!(String::from_utf8_lossy(&printed).starts_with(begin), "{format}");
    }
    for arguments in [
        &["sweep", "V6-60-shared", "--bank-angle", "0..1000000000:1"][..],
        &["sweep", "V6-60-shared", "--bank-angle", "0..180:0"],
        &["sweep", "I4", "--bank-angle", "0..180:10"],
        &["sweep", "I4"],
    ] {
        let output = program().args(arguments).output().expect("it starts");
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(String::from_utf8_lossy(&output.stderr).starts_with("error: "));
    }
}

#[test]
fn masses_that_turn_are_decided_in_words_as_by_the_exact_sums_in_engines_of_every_form() {
    let mut dice = dice::Dice::new(4711);
    let (mut judged, mut zeros) = (0, 0);
    for _ in 0..150 {
        let text = every_form::known(&mut dice);
        let Ok(layout) = file::parse("r.toml", &text) else { continue };
        let Ok(point) = sweep::judge(&layout, None, &[1, 2], &Geometry::default()) else { continue };
        if order::turning_masses(&layout).is_empty() {
            continue;
        }
        for swept in &point.orders {
            for (quantity, own) in [(Planar::Force, swept.force), (Planar::Moment, swept.moment)] {
                let [direct, reverse] = [Sense::Direct, Sense::Reverse]
                    .map(|sense| order::all_masses(&layout, quantity, swept.order, sense));
                let path = order::Path::of(&direct, &reverse, swept.order);
                let right = [
                    (own.direct, direct.vanishes()),
                    (own.reverse, reverse.vanishes()),
                    (own.along, path.nothing_along),
                    (own.across, path.nothing_across),
                    (own.smallest, path.is_line),
                ];
                for (part, vanishes) in right {
                    assert_eq!(part.vanishes, vanishes, "{text}\n{quantity:?} {}", swept.order);
                    zeros += usize::from(vanishes);
                }
                judged += 1;
            }
        }
    }
    assert!(judged > 100 && zeros > 50, "only {judged} orders with {zeros} zeros were tried");
}

#[test]
fn whole_numbers_are_swept() {
    let sweep = good("[radial]\ncylinders = 5\n", &["radial.cylinders=3..9:2"], &[1, 2]);
    assert_eq!(sweep.points.len(), 4);
    // Order 2 of a radial with more than three cylinders has no reverse vector, and of three no direct one.
    let reverse: Vec<bool> = sweep.points.iter().map(|point| point.orders[1].force.reverse.vanishes).collect();
    let direct: Vec<bool> = sweep.points.iter().map(|point| point.orders[1].force.direct.vanishes).collect();
    let independent = |count: u32, times: i64| {
        let turn = |at: u32| std::f64::consts::TAU * f64::from(at) / f64::from(count);
        let sum = |wave: fn(f64) -> f64| (0..count).map(|at| wave(times as f64 * turn(at))).sum::<f64>();
        sum(f64::cos).hypot(sum(f64::sin)) < 1e-9
    };
    // One crankpin: β = 0, and the star of order k is that of e^{i(k∓1)α}.
    assert_eq!(direct, [3, 5, 7, 9].map(|count| independent(count, 1)));
    assert_eq!(reverse, [3, 5, 7, 9].map(|count| independent(count, 3)));
    assert!(!reverse[0], "a radial three shakes in order 2");
    assert_eq!(sweep.curve.len(), 4, "there is no engine between");
}

#[test]
fn the_most_even_firing_is_that_of_the_files_order_where_it_can_be_fired_and_else_said_to_be_another() {
    let six = |order: &str| format!("cycle = \"four-stroke\"\n{order}[vee]\nbank_angle = 60\nthrows = [0, 240, 120]\n");
    let told = |order: &str| {
        let sweep = good(&six(order), &["vee.bank_angle=0..180:10"], &[1]);
        in_plain_text(&report::sweep_answer(&sweep)).replace('\n', " ")
    };
    let other = "in the most even order";
    assert!(
        told("firing_order = \"1-4-3-2-5-6\"\n").contains("Firing: most even, at intervals from 60° to 240°, at 60°.")
    );
    for order in ["", "firing_order = \"1-4-2-5-3-6\"\n"] {
        let told = told(order);
        assert!(told.contains("Firing: even, every 120°") && told.contains(other), "{told}");
    }
}

/// The first point has no offset and later ones have: their tables have the same columns all the same.
#[test]
fn a_sweep_that_begins_without_an_offset_is_written_row_by_row() {
    let file = scratch("offset-from-0").join("layout.toml");
    let text = "[vee]\nbank_angle = 90\nthrows = [0, 90, 180, 270]\npin_offset = ['0 mm', '2 mm']\nspacing = '96 mm'\n[mechanism]\n\
        stroke = '86 mm'\nrod_length = '146 mm'\nreciprocating_mass = '0.55 kg'\n";
    std::fs::write(&file, text).expect("written");
    let csv = |range: &str| {
        let set = format!("vee.pin_offset.2={range}:1 mm");
        let output = call(&["sweep", file.to_str().expect("UTF-8"), "--set", &set, "--format", "csv"]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).expect("UTF-8")
    };
    let (from_0, from_1) = (csv("0..4"), csv("1..4"));
    assert_eq!((from_0.lines().count(), from_0.lines().next()), (6, from_1.lines().next()));
    assert_eq!(from_0.lines().last(), from_1.lines().last());
}

const TWO: &str = "[inline]\nthrows = [0, 180]\nspacing = '90 mm'\n[mechanism]\ncrank_radius = '40 mm'\nrod_length = '140 mm'\nreciprocating_mass = [0.5, 0.6]\n";

/// What is largest is so in newtons too, where each point has an m or r of its own; the amplitudes of other sweeps are their own.
#[test]
fn points_with_masses_and_crank_radii_of_their_own_are_counted_in_one_unit() {
    let one = TWO.replace("[0.5, 0.6]", "0.5\nrotating_mass = 0.3").replace("[0, 180]", "[0]");
    for (text, set) in [
        (TWO, "mechanism.reciprocating_mass.1=0..0.7:0.1 kg"),
        (TWO, "mechanism.crank_radius=40..60:10 mm"),
        (&one, "mechanism.reciprocating_mass=0..1.5:0.5"),
    ] {
        let at_speed = good(&format!("speed = 3000\n{text}"), &[set], &[1, 2]);
        let multiples = good(text, &[set], &[1, 2]);
        let factor = at_speed.points[0].newtons.expect("a speed");
        for (own, newtons) in multiples.points.iter().zip(&at_speed.points) {
            assert!(close(newtons.newtons.expect("a speed") / factor, 1.0), "{set}");
            for (own, newtons) in own.orders.iter().zip(&newtons.orders) {
                assert!(close(own.force.largest.value, newtons.force.largest.value), "{set}");
            }
            let key = Key::parse(set.split('=').next().expect("a key")).expect("a key");
            let value = format!("{}{}", own.values[0], if set.ends_with("mm") { " mm" } else { "" });
            let text = format!("speed = 3000\n{text}");
            let layout = Template::new("test.toml", &text).expect("it is TOML").layout(&[(&key, &value)]);
            let Ok(Layout::Known(alone, _)) = layout else { panic!("{set}: it is known") };
            let alone = sweep::judge(&alone, None, &[1, 2], &Geometry::default()).expect("judged");
            for (own, alone_order) in own.orders.iter().zip(&alone.orders) {
                let right = alone_order.force.largest.value * alone.newtons.expect("a speed");
                assert!((own.force.largest.value * factor - right).abs() < 1e-9 * right.max(1.0), "{set}");
            }
        }
        let answer = in_plain_text(&report::sweep_answer(&multiples));
        assert!(answer.contains("Multiples are of the same unit at every value: m = "), "{answer}");
    }
    let answer =
        in_plain_text(&report::sweep_answer(&good(TWO, &["mechanism.reciprocating_mass.1=0..0.7:0.1 kg"], &[1])));
    assert!(answer.contains("m = 0.6 kg, r = 40 mm") && answer.contains("largest ≈ 1.000 m r ω², at 0 kg"), "{answer}");
    let other = good(TWO, &["mechanism.reciprocating_mass.2=0.6..0.8:0.1 kg"], &[1]);
    assert_eq!(other.multiples, None, "m is that of cylinder 1");
    let page = in_plain_text(&report::sweep_page(&other));
    assert!(!page.contains("same unit") && page.contains("m is the reciprocating mass of a cylinder"), "{page}");
    let radii = good(TWO, &["mechanism.crank_radius=40..60:20 mm"], &[1]);
    let heights = [0, 1].map(|at| radii.points[at].envelope.expect("a box").height);
    // D = 2r: r + l + 3r above the shaft, and 1.6r below it, in radii of 40 mm.
    assert!(close(heights[0], 5.6 + 3.5) && close(heights[1], 5.6 * 1.5 + 3.5), "{heights:?}");
}

#[test]
fn two_values_of_one_list_or_of_one_name_are_told_apart_on_a_page() {
    let sweep = good(V6, &["vee.throws.2=0..360:180", "vee.throws.1=0..180:60"], &[1]);
    for document in [report::sweep_page(&sweep), report::sweep_answer(&sweep)] {
        let text = in_plain_text(&document);
        assert!(
            text.contains("throws 2 and throws 1 swept") && text.contains("throws 2 = 0° with throws 1 = "),
            "{text}"
        );
    }
    assert!(in_plain_text(&report::sweep_page(&sweep)).contains("throws 2 in ° throws 1 in °"));
    let german = page::Options { language: page::Language::De, ..page::Options::default() };
    let text = page::write(&report::sweep_page(&sweep), page::Format::GITHUB, &german).swap_remove(0).text;
    assert!(text.contains("Kröpfungswinkel 2 in °") && !text.contains("throws 2"), "{text}");
    let masses = format!(
        "{V6}{MASSES}[crankshaft]\npin_mass = 0.3\n[[counterweight]]\nposition = 0\nangle = 0\nmass = 1\nradius = 0.1\n"
    );
    let radii = ["mechanism.reciprocating_mass=0.5..0.6:0.1", "mechanism.rotating_mass=0.1..0.2:0.1"];
    let text = in_plain_text(&report::sweep_page(&good(&masses, &radii, &[1])));
    assert!(text.contains("reciprocating mass and rotating mass swept"), "{text}");
    let alike = ["counterweight.1.mass=1..2:1", "vee.throws.1=0..60:60"];
    let text = in_plain_text(&report::sweep_page(&good(&masses, &alike, &[1])));
    assert!(text.contains("mass and throws swept"), "a name that is alone stays as it is: {text}");
}

/// A point at rest, and a value that no point has.
#[test]
fn what_is_nothing_is_printed_as_that() {
    let text = format!("speed = 3000\n{TWO}");
    let sweep = good(&text, &["speed=0..3000:1000"], &[1, 2]);
    let answer = in_plain_text(&report::sweep_answer(&sweep));
    assert!(answer.contains("Force of order 1: exactly 0 at 0 rpm; largest"), "{answer}");
    let page = page::write(&report::sweep_page(&sweep), page::Format::GITHUB, &page::Options::default());
    let page = &page[0].text;
    assert!(page.contains("| 0 | **0** | **0** | **0** | **0** |") && !page.contains("≈ 0 "), "{page}");
    let at_rest = good(&format!("speed = 0\n{TWO}"), &["inline.throws.2=90..180:30"], &[1]);
    let answer = in_plain_text(&report::sweep_answer(&at_rest));
    assert!(answer.contains("Forces are in m r ω²") && answer.contains("Force of order 1: nowhere 0"), "{answer}");

    let names = ["classify.orders.1.force_exact".parse().expect("a name")];
    let odd = Template::new("test.toml", "[inline]\nthrows = [0, 17, 101.3]\n").expect("it is TOML");
    let throw = [Parameter::parse("inline.throws.2=17..19:1").expect("a range")];
    let stream = sweep::Stream::new(&odd, &throw, &[1], &[], &Geometry::default()).expect("a sweep");
    let stream = stream.observing(report::observer(&names)).expect("a value");
    let swept = stream.whole(&std::sync::atomic::AtomicBool::new(false)).expect("swept");
    let answer = in_plain_text(&report::sweep_answer(&swept));
    assert!(answer.contains("classify.orders.1.force_exact is not given at any value."), "{answer}");
}
