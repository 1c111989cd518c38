//! Are the firing stars of a sweep as long as sums in doubles, and zero exactly where these are?

use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

use crankstar::engine::{CycleOrder, Engine};
use crankstar::file::{self, Template};
use crankstar::firing;
use crankstar::page::{self, Format, Language, Options};
use crankstar::report;
use crankstar::sweep::{self, Geometry, Parameter, Stream, Sweep};
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::ToPrimitive;
use serde_json::json;

use crate::support::german::phrases;
use crate::support::tables;

const V6: &str =
    "cycle = 'four-stroke'\nfiring_order = '1-4-3-6-2-5'\nvee = { bank_angle = 60, throws = [0, 240, 120] }";
const V2: &str = "cycle = 'four-stroke'\nfiring_angles = [0, '360 + phi']\nvee = { bank_angle = 'phi', throws = [0] }\n\
                  values.phi = 90";

fn swept(text: &str, parameters: &[&str], orders: &[&str]) -> Result<Sweep, String> {
    let template = Template::new("layout.toml", text).expect("TOML");
    let parameters: Vec<Parameter> = parameters.iter().map(|text| Parameter::parse(text).expect("a range")).collect();
    let orders: Vec<CycleOrder> = orders.iter().map(|order| order.parse().expect("an order")).collect();
    let stream = Stream::new(&template, &parameters, &[1], &orders, &Geometry::default());
    stream.map(|stream| stream.whole(&AtomicBool::new(false)).expect("a sweep")).map_err(|error| error.to_string())
}

fn zeros(sweep: &Sweep) -> Vec<Vec<String>> {
    let zeros = sweep.firing.iter().flat_map(|firing| firing.zeros.as_ref().expect("an angle"));
    zeros.map(|zeros| zeros.at.iter().map(ToString::to_string).collect()).collect()
}

/// `|Σ e^{−iκφ_j}|` in doubles.
fn length(engine: &Engine, order: CycleOrder) -> Option<f64> {
    let angles: Vec<f64> = match (engine.firing(), order.is_whole()) {
        (_, true) => engine.cylinders().iter().filter_map(|one| (&one.bank - &one.throw).turns().to_f64()).collect(),
        (Some(firing), false) => firing.shots.iter().filter_map(|shot| shot.angle.to_f64()).collect(),
        (None, false) => return None,
    };
    let kappa = f64::from(order.halves()) / 2.0;
    Some(angles.iter().map(|angle| Complex::from_polar(1.0, -kappa * TAU * angle)).sum::<Complex<f64>>().norm())
}

#[test]
fn lengths_and_zeros_are_those_of_sums_in_doubles() {
    let orders = ["1/2", "1", "3/2", "3", "9/2"];
    for (key, from, to, text) in [
        ("vee.bank_angle", 0, 359, V6.to_owned()),
        ("vee.pin_split", -180, 180, V6.replace("throws", "pin_split = 0, throws")),
        ("values.phi", 0, 359, V2.to_owned()),
    ] {
        let sweep = swept(&text, &[&format!("{key}={from}..{to}:5")], &orders).expect("stars");
        let firing = sweep.firing.as_ref().expect("asked for");
        let all = firing.zeros.as_ref().expect("an angle");
        for (value, stars) in &firing.curve {
            let written = match key {
                "vee.bank_angle" => text.replace("bank_angle = 60", &format!("bank_angle = '{value}'")),
                "vee.pin_split" => text.replace("pin_split = 0", &format!("pin_split = '{value}'")),
                _ => text.replace("values.phi = 90", &format!("values.phi = '{value}'")),
            };
            let unfired = written.replace("firing_order = '1-4-3-6-2-5'", "");
            let read = file::parse("layout.toml", &written).or_else(|_| file::parse("layout.toml", &unfired));
            let engine = read.expect("an engine");
            for ((order, star), zeros) in firing.orders.iter().zip(stars).zip(all) {
                let right = length(&engine, *order);
                let star = star.amplitude();
                assert_eq!(star.is_some(), right.is_some(), "{key} = {value}, order {order}");
                assert!(zeros.complete && zeros.fires, "{key}, order {order}");
                let Some((star, right)) = star.zip(right) else { continue };
                assert!(
                    (star.value - right).abs() < 1e-9,
                    "{key} = {value}, order {order}: {} for {right}",
                    star.value
                );
                let is_listed = zeros.everywhere || zeros.at.contains(value);
                assert_eq!(star.vanishes, is_listed, "{key} = {value}, order {order}");
                assert_eq!(star.vanishes, right < 1e-9, "{key} = {value}, order {order}");
            }
        }
    }
}

#[test]
fn exact_angles_are_found_between_the_points() {
    let sweep = swept(V6, &["vee.bank_angle=1..358:7"], &["3/2", "3", "9/2"]).expect("stars");
    let right = [vec!["120"], vec!["60", "180", "300"], vec!["40", "120", "200"]];
    assert_eq!(zeros(&sweep), right.map(|row| row.into_iter().map(str::to_owned).collect::<Vec<String>>()));
    let split = V6.replace("throws", "pin_split = 0, throws");
    let sweep = swept(&split, &["vee.pin_split=-90..90:45"], &["3/2", "3"]).expect("stars");
    assert_eq!(zeros(&sweep), [vec!["-60".to_owned()], vec!["0".to_owned()]]);
    let turns = swept(V6, &["vee.bank_angle=0..0.9:0.1 turn"], &["3/2"]).expect("stars");
    assert_eq!(zeros(&turns), [vec!["1/3".to_owned()]]);
}

#[test]
fn half_orders_without_a_firing_order_are_refused_and_whole_ones_are_not() {
    let silent = "cycle = 'four-stroke'\nvee = { bank_angle = 60, throws = [0, 240, 120] }";
    let refused = swept(silent, &["vee.bank_angle=0..90:30"], &["1/2"]).expect_err("half orders");
    assert!(refused.contains("firing_order"), "{refused}");
    let sweep = swept(silent, &["vee.bank_angle=0..90:30"], &["1", "3"]).expect("whole orders");
    assert_eq!(zeros(&sweep), [Vec::new(), vec!["60".to_owned()]]);
    let two_stroke = "cycle = 'two-stroke'\nvee = { bank_angle = 60, throws = [0] }";
    let refused = swept(two_stroke, &["vee.bank_angle=0..90:30"], &["1/2"]).expect_err("a half order");
    assert!(refused.contains("does not exist in a two-stroke engine"), "{refused}");
    let map = swept(V6, &["vee.bank_angle=60..90:30", "vee.throws.2=240..250:10"], &["3"]).expect("a map");
    assert!(map.firing.expect("asked for").zeros.is_none());
}

#[test]
fn stars_of_one_length_have_it_at_every_value_or_wherever_the_cylinders_fire() {
    let text = "cycle = 'four-stroke'\nfiring_order = '1-4-2-5-3-6'\nvee = { bank_angle = 60 }";
    let answer = |text: &str, set: &str, orders: &[&str]| {
        let words = words_of(&report::sweep_answer(&swept(text, &[set], orders).expect("stars")));
        words.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let told = answer(text, "vee.bank_angle=30..150:15", &["1/2", "3/2", "3"]);
    assert!(told.contains("the firing star is ≈ 6.000 at every value.") && !told.contains("from ≈ 6.000"), "{told}");
    // A single cylinder's star is 1 whatever its throw is.
    let one = "cycle = 'four-stroke'\nfiring_order = '1'\ninline = { throws = [0] }";
    let told = answer(one, "inline.throws.1=0..90:30", &["1/2", "1"]);
    assert_eq!(told.matches("the firing star is ≈ 1.000 at every value.").count(), 2, "{told}");
}

#[test]
fn page_table_and_document_tell_the_stars() {
    let sweep = swept(V6, &["vee.bank_angle=0..350:10"], &["1", "3/2", "3"]).expect("stars");
    let page = report::sweep_page(&sweep);
    let text = page::write(&page, Format::GITHUB, &Options::default()).remove(0).text;
    assert!(text.contains("**Gas torque of order 1½:** exactly **0** at 120° and nowhere else in the range"), "{text}");
    assert!(text.contains("| 3 | 60°, 180°, 300° |"), "{text}");
    let pages = [page, report::sweep_answer(&sweep)];
    let phrases = pages.iter().flat_map(phrases);
    let unknown: Vec<&str> = phrases.filter(|words| words.contains("iring") && !Language::De.knows(words)).collect();
    assert!(unknown.is_empty(), "no German for {unknown:#?}");
    let csv = report::sweep_csv(&sweep).text;
    let rows: Vec<&str> = csv.lines().collect();
    let fields = |row: &str| row.split(',').map(str::to_owned).collect::<Vec<String>>();
    let first = fields(rows[0]).iter().position(|name| name == "firing_star_1_r").expect("the column");
    let stars = |row: &str| fields(row)[first..first + 3].join(",");
    assert_eq!(stars(rows[0]), "firing_star_1_r,firing_star_3/2_r,firing_star_3_r");
    assert!(rows[13].starts_with("120,"), "{}", rows[13]);
    assert_eq!(stars(rows[13]), "0,0,6");
    assert!(rows[31].starts_with("300,") && rows[31].ends_with(",true,,true"), "{}", rows[31]);
    assert_eq!(stars(rows[31]), "0,,0");
    let document = tables::json_of(&sweep);
    let zeros = document["firing_zeros"].as_array().expect("rows");
    assert!(
        zeros.iter().any(|row| (&row["order"], &row["bank_angle_exact"]) == (&json!("1.5"), &json!("120"))),
        "{zeros:?}"
    );
    assert!(document["points"][30]["firing_star_3/2_r"].is_null());
}

fn words_of(document: &page::Document) -> String {
    page::write(document, Format::GITHUB, &Options::default()).remove(0).text
}

/// Where rods become unlike their stars have no common length: that is no zero, and no layout that cannot fire.
#[test]
fn stars_of_several_rods_are_neither_zero_nor_unfired() {
    let text = "cycle = 'two-stroke'\nfiring_order = '1-2-3'\n[mechanism]\nrod_ratio = [0.25, 0.25, 0.25]\n[inline]\nthrows = [0, 240, 120]\n";
    let some = swept(text, &["mechanism.rod_ratio.2=0.25..0.35:0.05"], &["1", "3"]).expect("stars");
    let of_order = |place: usize| {
        let points = &some.firing.as_ref().expect("asked for").points;
        points.iter().map(|stars| stars[place].vanishes()).collect::<Vec<_>>()
    };
    assert_eq!(of_order(0), [Some(true), Some(false), Some(false)]);
    assert_eq!(of_order(1), [Some(false); 3]);
    let told = words_of(&report::sweep_answer(&some));
    assert!(told.contains("not **0** at 2 of 3 values") || told.contains("not 0 at 2 of 3 values"), "{told}");
    assert!(!told.contains("exactly 0 at every value"), "{told}");
    let unlike = text.replace("[0.25, 0.25, 0.25]", "[0.25, 0.3, 0.25]");
    let all = swept(&unlike, &["mechanism.rod_ratio.1=0.3..0.4:0.05"], &["1"]).expect("stars");
    let told = words_of(&report::sweep_answer(&all));
    assert!(!told.contains("at no value of the sweep"), "{told}");
    let endless = text.replace("rod_ratio = [0.25, 0.25, 0.25]", "rod_ratio = 0\noffset_ratio = [0.1, 0.1, 0.1]");
    let some = swept(&endless, &["mechanism.offset_ratio.2=0.1..0.2:0.1"], &["1"]).expect("stars");
    let told = words_of(&report::sweep_answer(&some));
    assert!(told.contains("not decided at 1 of 2 values"), "{told}");
}

#[test]
fn pistons_that_share_a_cylinder_fire_together() {
    let opposed = "cycle = 'two-stroke'\nopposed_piston = { throws = [0, 120, 240], lead = 11 }";
    for text in [opposed, "cycle = 'two-stroke'\ndelta = { rows = [0], circumradius = 6 }"] {
        let engine = file::parse("layout.toml", text).expect("an engine");
        let even = sweep::judge(&engine, engine.cycle(), &[1], &Geometry::default())
            .expect("judged")
            .evenness
            .expect("it fires");
        // Those of a row of a delta fire 40° apart, and six rows fill the turn.
        let [longest, shortest] = if text == opposed { [120, 120] } else { [280, 40] };
        let turns = |degrees: i32| BigRational::new(degrees.into(), 360.into());
        assert_eq!([even.longest, even.shortest], [turns(longest), turns(shortest)], "{text}");
        assert_eq!(sweep::most_even_firings(&engine, engine.cycle()).len(), 1);
        let stars = firing::star_sums(&engine, "1".parse().expect("an order")).expect("stars");
        assert!(stars.len() == 1 && stars[0].terms().len() == 3, "{text}");
        // Without a cycle nothing says how often they fire.
        let silent = file::parse("layout.toml", text.split_once('\n').expect("two lines").1).expect("an engine");
        assert_eq!(
            sweep::judge(&silent, silent.cycle().or(engine.cycle()), &[1], &Geometry::default())
                .expect("judged")
                .evenness,
            None
        );
    }
    let swept = swept(opposed, &["opposed_piston.lead=5..15:5"], &["1"]).expect("a sweep");
    assert!(swept.points.iter().all(|point| point.evenness.is_some()));
    assert!(swept.firing.expect("asked for").points.iter().flatten().all(|star| star.vanishes() == Some(true)));
}
