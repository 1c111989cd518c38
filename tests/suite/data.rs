//! Do tables of data say what pages and documents say, do they read back, and is every column of theirs documented?

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;
use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use crankstar::engine::{Cycle, CycleOrder, Engine};
use crankstar::exact::Turn;
use crankstar::file::{self, Layout};
use crankstar::numbers::Form;
use crankstar::proof::Planar;
use crankstar::report::{BearingsStudy, Question};
use crankstar::search::Problem;
use crankstar::table::{Column, Format, Kind, Table, Unit, Values, csv};
use crankstar::text::{self, Untrusted};
use num_complex::Complex;
use serde_json::Value;

use crate::support::dice::Dice;
use crate::support::every_form;
use crate::support::program::{call, scratch};
use crate::support::rfc4180;
use crate::support::tables::{self, Answered, decimals, texts, truths};
use crate::true_sentences::VR6;

const V8_GAS: &str = include_str!("../../reports/examples/v8-gas/layout.toml");
const I6_TORSION: &str = include_str!("../../reports/examples/i6-torsion/layout.toml");
const I4_MOUNTS: &str = include_str!("../../reports/examples/i4-mounts/layout.toml");
const MARINE_TORSION: &str = include_str!("../../reports/examples/marine-six-torsion/layout.toml");
const I6_DAMPER: &str = include_str!("../../reports/examples/i6-damper/layout.toml");
const I3: &str = include_str!("../../reports/examples/thesis-i3/layout.toml");
const TWO_RODS: &str = include_str!("../../reports/examples/i6-two-rods/layout.toml");
const V6: &str =
    "cycle = 'four-stroke'\nfiring_order = '1-4-3-6-2-5'\nvee = { bank_angle = 60, throws = [0, 240, 120] }";
const LINKED: &str = "speed = 3000\neffects = ['gas']\ncycle = 'four-stroke'\nfiring_order = '1-3-2'\nbearings = [0.1, -0.1]\n[radial]\ncylinders = 3\n[articulated]\nmaster = 1\nknuckle_ratio = 0.2\nknuckle_mass = '0.1 kg'\n\
    [mechanism]\nreciprocating_mass = '0.5 kg'\ncrank_radius = '40 mm'\nrod_ratio = 0.25\n\
    [gas]\nbore = '90 mm'\ndead_centre = 'crank'\nprocess = 'spark-ignition'\ncompression_ratio = 9\nheat = '900 J'\n";
const SILENT_V6: &str = "vee = { bank_angle = 60, throws = [0, 240, 120] }";
/// Two singles side by side that turn against each other, with gas.
const U2_GAS: &str = "cycle = 'four-stroke'\nfiring_order = '1-2'\nspeed = 3000\n[u]\nsense = 'against'\ndistance = '200 mm'\nthrows = [0]\nspacing = '100 mm'\n\
    [mechanism]\nstroke = '80 mm'\nrod_length = '140 mm'\nreciprocating_mass = '0.5 kg'\n[gas]\nbore = '80 mm'\nprocess = 'spark-ignition'\ncompression_ratio = 8\nheat = '400 J'\n";
const GEARED: &str = "speed = 3000\nbearings = [0.1, -0.1]\neffects = ['torque']\n[u]\nsense = 'against'\nphase = 0\ndistance = '200 mm'\nthrows = [0, 180]\nspacing = '100 mm'\n\
    [mechanism]\nreciprocating_mass = '0.5 kg'\ncrank_radius = '40 mm'\nrod_ratio = 0.25\n";

#[track_caller]
fn known(text: &str) -> Engine {
    match file::parse_layout("layout.toml", text) {
        Ok(Layout::Known(engine, _)) => *engine,
        Ok(Layout::Open(_)) => panic!("the layout has unknowns"),
        Err(error) => panic!("{error}"),
    }
}

/// Engines of every form, as it happens.
fn random(seed: u64, count: usize) -> Vec<Engine> {
    let mut dice = Dice::new(seed);
    let layouts = std::iter::repeat_with(|| every_form::known(&mut dice));
    let read = layouts.filter_map(|text| match file::parse_layout("layout.toml", &text) {
        Ok(Layout::Known(engine, _)) => Some(*engine),
        Ok(Layout::Open(_)) | Err(_) => None,
    });
    read.take(count).collect()
}

/// Answers that have every table and every column between them.
fn every_answer() -> &'static [Answered] {
    static ALL: LazyLock<Vec<Answered>> = LazyLock::new(answer_all);
    &ALL
}

fn answer_all() -> Vec<Answered> {
    let mut all = Vec::new();
    let train = format!("speed = 600\n{}", crate::damped::TREE);
    let torsion = [I6_TORSION, MARINE_TORSION, I6_DAMPER, &train];
    for text in [V8_GAS, I3, TWO_RODS, GEARED, LINKED, U2_GAS, V6, I4_MOUNTS].into_iter().chain(torsion) {
        all.extend(tables::of_engine(&known(text), &[1, 2, 4]));
    }
    all.push(tables::valued(&known(V8_GAS), "torque.cycle.mean"));
    all.push(tables::balanced(include_str!("../../examples/shaft.toml")));
    all.push(tables::fluctuating(include_str!("../../examples/turning-moment.toml")));
    all.push(tables::swept(V6, &["vee.bank_angle=0..180:20"], &[1, 2], &["1", "3/2"]).1);
    all.push(tables::swept(V8_GAS, &["speed=1000..3000:1000"], &[1], &[]).1);
    all.push(tables::swept(VR6, &["vr.pin_splay=15..24:9"], &[1], &[]).1);
    let vee = Problem::vee(6, Cycle::FourStroke, Turn::fraction(1, 6), &[1, 2]);
    all.push(tables::searched(&Problem::inline(6, Cycle::FourStroke, &[1, 2]), true).1);
    all.push(tables::searched(&vee, false).1);
    let minor_orders = [1, 2].into_iter().filter_map(CycleOrder::of_halves).collect();
    let by_minor = Problem { minor_orders, neighbours: true, ..Problem::inline(6, Cycle::FourStroke, &[1, 2]) };
    all.push(tables::searched(&by_minor, false).1);
    all
}

fn is_read(column: &Column, row: usize, field: &str) -> bool {
    match column.values() {
        Values::Words(values) | Values::Exact(values) => values[row].as_deref().unwrap_or_default() == field,
        Values::Person(values) => {
            values[row].as_ref().map(|text| text.escaped(text::Format::Csv)).unwrap_or_default() == field
        }
        Values::Integer(values) => values[row] == field.parse().ok(),
        Values::Decimal(values) => values[row].map(f64::to_bits) == field.parse::<f64>().ok().map(f64::to_bits),
        Values::Truth(values) => values[row] == field.parse().ok(),
    }
}

fn reads_back(table: &Table) {
    let (header, rows) = rfc4180::read(&csv(table));
    assert_eq!(header, table.columns().iter().map(Column::name).collect::<Vec<_>>());
    assert_eq!(rows.len(), table.rows(), "{}", table.name());
    for (row, fields) in rows.iter().enumerate() {
        for (column, field) in table.columns().iter().zip(fields) {
            assert!(is_read(column, row, field), "{} {row}: {field}", column.name());
        }
    }
}

/// A name with the unit in it, each once; and a number that is proved to be 0 is 0, and no other is.
fn is_consistent(table: &Table) {
    let names: BTreeSet<&str> = table.columns().iter().map(Column::name).collect();
    assert_eq!(names.len(), table.columns().len(), "{}", table.name());
    for column in table.columns() {
        let is_plain = |letter: char| letter.is_ascii_alphanumeric() || letter == '_' || letter == '/';
        assert!(column.name().chars().all(is_plain), "{}", column.name());
        let Values::Truth(vanishes) = column.values() else { continue };
        let Some(stem) = column.name().strip_suffix("vanishes") else { continue };
        // `force_2_largest` and `force_2_largest_N`, `direct_zero_to_peak_N`, `moment_2_mrw2_ck_a`.
        let of = |other: &&Column| {
            let rest = other.name().strip_prefix(stem.trim_end_matches('_')).unwrap_or("?");
            let rest = rest.trim_start_matches('_');
            let unit = other.unit().suffix;
            rest.is_empty()
                || rest == unit
                || rest == format!("zero_to_peak_{unit}")
                || rest == format!("modulus_{unit}")
                || rest == format!("length_{unit}")
                || rest == format!("mass_radius_{unit}")
                || rest == format!("couple_{unit}")
        };
        let mut found = 0;
        for size in table.columns().iter().filter(of) {
            let Values::Decimal(sizes) = size.values() else { continue };
            found += 1;
            for (vanishes, value) in vanishes.iter().zip(sizes) {
                let Some(value) = value else { continue };
                match vanishes {
                    Some(true) => assert_eq!(*value, 0.0, "{} {}", table.name(), size.name()),
                    Some(false) => assert!(*value != 0.0, "{} {}", table.name(), size.name()),
                    None => {}
                }
            }
        }
        assert!(found > 0, "{}: {} is of no number", table.name(), column.name());
    }
}

#[test]
fn every_table_reads_back_as_it_is_and_zeros_are_those_that_are_proved() {
    let engines = random(15, 25);
    let random: Vec<Answered> = engines.iter().flat_map(|engine| tables::of_engine(engine, &[1, 2, 3, 4])).collect();
    let mut count = 0;
    for table in random.iter().chain(every_answer()).flat_map(|answer| &answer.tables) {
        reads_back(table);
        is_consistent(table);
        count += 1;
    }
    assert!(count > 100, "only {count} tables");
}

#[test]
fn a_text_is_quoted_and_never_a_formula() {
    let words = ["a,b", "say \"so\"", "=cmd|' /C calc'!A0", "+1", "-1+2", "@sum", "two\nlines", "\u{1b}[31m"];
    let person = Values::Person(words.iter().map(|words| Some(Untrusted::new(*words))).collect());
    let table = Table::new("t", "a row", words.len()).with(Column::new("text", Unit::NONE, "a text", person));
    let (_, rows) = rfc4180::read(&csv(&table));
    let read: Vec<&str> = rows.iter().map(|row| row[0].as_str()).collect();
    let right = ["a,b", "say \"so\"", "'=cmd|' /C calc'!A0", "'+1", "'-1+2", "'@sum", "two lines", "[U+001B][31m"];
    assert_eq!(read, right);
}

#[test]
fn a_decimal_has_all_its_digits_and_what_is_none_is_empty() {
    let values = [0.1 + 0.2, 1e300, 5e-324, -2.5e-7, 123456789.0, 1e15, f64::NAN, f64::INFINITY, -0.0];
    let column = Column::new("x", Unit::NONE, "a number", Values::Decimal(values.iter().copied().map(Some).collect()));
    let text = csv(&Table::new("t", "a row", values.len()).with(column));
    let lines: Vec<&str> = text.lines().skip(1).collect();
    assert_eq!(lines[..6], ["0.30000000000000004", "1e300", "5e-324", "-2.5e-7", "123456789", "1e15"]);
    assert_eq!(lines[6..], ["", "", "0"]);
}

fn same(found: Option<f64>, told: &Value, what: &str) {
    // −0 is 0 in a table.
    assert!(found == told.as_f64(), "{what}: {found:?} and {told}");
}

#[test]
fn the_tables_of_loads_are_the_document() {
    for text in [V8_GAS, I3, TWO_RODS, GEARED] {
        let engine = known(text);
        let answer = tables::asked("loads", &engine, &[1, 2, 4]).expect("numbers");
        let orders = answer.table("orders");
        let entries = answer.document["orders"].as_array().expect("entries");
        let mut compared = 0;
        for (quantity, suffixes) in [("force", ["N", "N"]), ("moment", ["N_m", "N_a"])] {
            let entries: Vec<&Value> = entries.iter().filter(|entry| entry["quantity"] == quantity).collect();
            let unit = suffixes.iter().find(|unit| orders.column(&format!("{quantity}_zero_to_peak_{unit}")).is_some());
            let unit = unit.expect("newtons");
            let column = |part: &str| decimals(orders, &format!("{quantity}_{part}_{unit}"));
            let (largest, y) = (column("zero_to_peak"), column("y_zero_to_peak"));
            let reverse = column("reverse_zero_to_peak");
            let angles = decimals(orders, &format!("{quantity}_direct_angle_deg"));
            let vanishes = truths(orders, &format!("{quantity}_vanishes"));
            for (row, entry) in entries.into_iter().enumerate() {
                same(largest[row], &entry["largest"], "largest");
                same(y[row], &entry["along"], "along");
                same(reverse[row], &entry["reverse"]["amplitude"], "reverse");
                same(angles[row], &entry["direct"]["angle_deg"], "angle");
                assert!(vanishes[row] != Some(true) || entry["largest"] == 0.0, "a proved zero is 0");
                compared += 1;
            }
        }
        assert_eq!(compared, 2 * orders.rows());
        let largest = decimals(answer.table("largest"), "force_zero_to_peak_N");
        same(largest[0], &answer.document["largest"]["force"]["value"], "the largest force");
        // Only what the scene calls for.
        assert_eq!(answer.tables.iter().any(|table| table.name() == "torque"), engine.effects().torque);
        let theta = answer.table("theta");
        assert_eq!(theta.column("torque_N_m").is_some(), engine.effects().torque);
        let peak = answer.document["peaks"]["force"]["value"].as_f64().expect("a peak");
        let sampled = decimals(theta, "force_y_N").into_iter().zip(decimals(theta, "force_x_N"));
        let sampled = sampled.map(|(y, x)| y.expect("y").hypot(x.expect("x"))).fold(0.0, f64::max);
        assert!(sampled <= peak * (1.0 + 1e-12) && sampled >= peak * 0.99, "{sampled} of {peak}");
    }
}

/// The acceleration of a piston over the crank angle, in crank radii, from its place alone.
fn acceleration(psi: f64, ratio: f64) -> f64 {
    let place = |psi: f64| psi.cos() + (1.0 / (ratio * ratio) - psi.sin() * psi.sin()).sqrt();
    let step = 1e-3;
    // Of fourth order in the step.
    let far = place(psi + 2.0 * step) + place(psi - 2.0 * step);
    let near = place(psi + step) + place(psi - step);
    (-far + 16.0 * near - 30.0 * place(psi)) / (12.0 * step * step)
}

#[test]
fn forces_and_moments_over_the_crank_angle_are_those_of_pistons_on_their_paths() {
    let text = "speed = 3000\n[vee]\nbank_angle = 70\nthrows = [0, 110, 200]\nspacing = '100 mm'\n\
                [mechanism]\nreciprocating_mass = '0.5 kg'\ncrank_radius = '40 mm'\nrod_ratio = 0.25\n";
    let engine = known(text);
    let orders: Vec<u32> = (1..=24).collect();
    let answer = tables::asked("loads", &engine, &orders).expect("numbers");
    let theta = answer.table("theta");
    let columns = ["force_y_N", "force_x_N", "moment_y_N_m", "moment_x_N_m"].map(|name| decimals(theta, name));
    let omega = 3000.0 / 60.0 * TAU;
    let scale = 0.5 * 0.04 * omega * omega;
    // Throws and banks grow anticlockwise from y; the first pin, at the free end, has the largest z.
    let pistons = [(0.0, 0.1), (110.0, 0.0), (200.0, -0.1)];
    for (row, degrees) in decimals(theta, "theta_deg").into_iter().enumerate() {
        let degrees = degrees.expect("an angle");
        let (mut force, mut moment) = (Complex::new(0.0, 0.0), Complex::new(0.0, 0.0));
        for bank in [-35.0_f64, 35.0] {
            for (throw, z) in pistons {
                let psi = (degrees + throw - bank).to_radians();
                let one = -scale * acceleration(psi, 0.25) * Complex::cis(bank.to_radians());
                force += one;
                moment += one * z;
            }
        }
        for (column, right) in columns.iter().zip([force.re, -force.im, moment.re, -moment.im]) {
            let found = column[row].expect("a load");
            assert!((found - right).abs() < 1e-3, "θ = {degrees}: {found} and {right}");
        }
    }
}

#[test]
fn the_tables_of_a_sweep_hold_its_points_and_zeros() {
    let (swept, answer) = tables::swept(V6, &["vee.bank_angle=0..180:20/3"], &[1, 2], &["1", "3/2"]);
    let points = answer.table("points");
    let exact = texts(points, "bank_angle_exact");
    assert_eq!(exact[1].as_deref(), Some("20/3"));
    let value = decimals(points, "bank_angle");
    let stars = swept.firing.as_ref().expect("stars");
    for (row, point) in swept.points.iter().enumerate() {
        assert_eq!(exact[row], Some(point.values[0].to_string()));
        for order in &point.orders {
            for quantity in Planar::BOTH {
                for (part, amplitude) in order.amplitudes(quantity).named() {
                    let name = format!("{}_{}_{part}", quantity.name(), order.order);
                    assert_eq!(
                        decimals(points, &name)[row],
                        Some(if amplitude.vanishes { 0.0 } else { amplitude.value }),
                        "{name}"
                    );
                    assert_eq!(truths(points, &format!("{name}_vanishes"))[row], Some(amplitude.vanishes), "{name}");
                }
            }
        }
        assert_eq!(decimals(points, "firing_star_3/2_r")[row], stars.points[row][1].amplitude().map(|star| star.value));
    }
    assert!((value[1].expect("a value") - 20.0 / 3.0).abs() < 1e-15);
    let zeros = answer.table("zeros");
    let sets = swept.zeros.iter().flatten();
    assert_eq!(zeros.rows(), sets.map(|set| (set.at.len() + set.irrational.len()).max(1)).sum::<usize>());
    assert_eq!(answer.document["zeros"].as_array().map(Vec::len), Some(zeros.rows()));
    assert!(truths(zeros, "complete").iter().all(|complete| *complete == Some(true)));
    let at = |quantity: &str, of: &str, order: i64| -> Vec<String> {
        let orders = match zeros.column("order").expect("orders").values() {
            Values::Integer(orders) => orders.clone(),
            other => panic!("{:?}", other.kind()),
        };
        let rows = (0..zeros.rows()).filter(|row| {
            orders[*row] == Some(order)
                && texts(zeros, "quantity")[*row].as_deref() == Some(quantity)
                && texts(zeros, "of")[*row].as_deref() == Some(of)
        });
        rows.filter_map(|row| texts(zeros, "bank_angle_exact")[row].clone()).collect()
    };
    assert_eq!(at("moment", "along", 2), ["90", "180"]);
    assert!(decimals(answer.table("firing_zeros"), "bank_angle").contains(&Some(120.0)));
    assert_eq!(swept.points.len(), points.rows());
}

#[test]
fn a_map_has_both_parameters_even_of_one_list() {
    let (_, answer) = tables::swept(SILENT_V6, &["vee.throws.2=0..120:60", "vee.throws.3=0..240:120"], &[1], &[]);
    let points = answer.table("points");
    assert_eq!(points.rows(), 9);
    let two = decimals(points, "vee_throws_2");
    let three = decimals(points, "vee_throws_3");
    assert_eq!((two[5], three[5]), (Some(60.0), Some(240.0)));
}

#[test]
fn the_tables_of_a_search_are_the_document() {
    let (_, answer) = tables::searched(&Problem::inline(5, Cycle::TwoStroke, &[1, 2]), false);
    let stars = answer.table("stars");
    let mut closed = 0;
    for (row, star) in answer.document["stars"].as_array().expect("stars").iter().enumerate() {
        assert_eq!(texts(stars, "firing_order")[row].as_deref(), star["firing_order"].as_str());
        for (moment, order) in star["moments"].as_array().expect("moments").iter().zip([1, 2]) {
            let (value, exact) = (format!("moment_{order}_mrw2_ck_a"), format!("moment_{order}_exact"));
            same(decimals(stars, &value)[row], &moment["decimal"], &value);
            let exact = texts(stars, &exact)[row].clone();
            assert_eq!(exact.as_deref(), moment["exact"].as_str());
            let Some(exact) = exact else { continue };
            let form = Form::parse(&exact).expect("a form").to_float();
            assert!((form - moment["decimal"].as_f64().expect("a number")).abs() < 1e-9, "{exact}");
            closed += 1;
        }
    }
    assert!(stars.rows() > 1 && closed > 1, "{closed} of {}", stars.rows());
    let question = answer.table("question");
    assert_eq!(texts(question, "all_stars")[0].as_deref(), answer.document["all_stars"].as_str());
    let (_, answer) = tables::searched(&Problem::inline(6, Cycle::FourStroke, &[1, 2]), true);
    let orders = answer.table("firing_orders");
    let told = &answer.document["stars"][0]["torsion"];
    same(decimals(orders, "phase_sum")[1], &told[0]["sums"][1]["decimal"], "the second sum");
    assert_eq!(texts(orders, "firing_order")[0].as_deref(), told[0]["firing_order"].as_str());
}

#[test]
fn the_tables_of_verdicts_are_the_documents() {
    for engine in random(51, 30).iter().chain(&[known(TWO_RODS), known(GEARED)]) {
        let answer = tables::classify(engine, &[1, 2, 4]);
        let sums = answer.table("sums");
        let verdicts = answer.document["verdicts"].as_array().expect("verdicts");
        for quantity in ["force", "moment"] {
            let verdicts: Vec<&Value> = verdicts.iter().filter(|one| one["quantity"] == quantity).collect();
            assert_eq!(verdicts.len(), sums.rows());
            let stem = format!("{quantity}_modulus_m_r");
            let is_modulus =
                |column: &&Column| column.name().starts_with(&stem) && column.values().kind() == Kind::Decimal;
            let modulus = sums.columns().iter().find(is_modulus).expect("lengths").name().to_owned();
            let exact = texts(sums, &format!("{quantity}_modulus_exact"));
            let evidence = texts(sums, &format!("{quantity}_evidence"));
            for (row, verdict) in verdicts.into_iter().enumerate() {
                same(decimals(sums, &modulus)[row], &verdict["modulus"], "modulus");
                same(decimals(sums, &format!("{quantity}_angle_deg"))[row], &verdict["angle_deg"], "angle");
                let vanishes = truths(sums, &format!("{quantity}_vanishes"))[row];
                assert_eq!(vanishes, verdict["vanishes"].as_bool());
                assert_eq!(exact[row].as_deref() == Some("0"), vanishes == Some(true));
                assert_eq!(evidence[row].as_deref(), verdict["certificate"]["kind"].as_str());
            }
        }
        let answer = tables::compare(engine, &[1, 2, 4]);
        let orders = answer.table("orders");
        let entries = answer.document["engines"].as_array().expect("engines").iter();
        let entries: Vec<&Value> = entries.flat_map(|entry| entry["orders"].as_array().expect("orders")).collect();
        assert_eq!(entries.len(), orders.rows());
        for (row, entry) in entries.into_iter().enumerate() {
            same(decimals(orders, "force_zero_to_peak_mrw2_ck")[row], &entry["force"]["largest"], "force");
        }
    }
}

#[test]
fn the_tables_of_bearings_are_the_loads() {
    let engine = known(V8_GAS);
    let study = BearingsStudy::new(&engine, &[1, 2, 3]).expect("bearings");
    let table = |name: &str| study.table(name).expect("a table");
    let newtons = study.continuous.scale.as_ref().expect("newtons").force();
    let all: Vec<_> = study.continuous.bearings.iter().chain(&study.determinate.bearings).collect();
    let peaks = decimals(&table("bearings"), "force_zero_to_peak_N");
    assert_eq!(peaks, all.iter().map(|bearing| Some(bearing.peak.value * newtons)).collect::<Vec<_>>());
    let (orders, told) = (table("orders"), all.iter().flat_map(|bearing| &bearing.orders));
    for (row, order) in told.enumerate() {
        let direct = order.swing.direct.value.norm() / 2.0 * newtons;
        assert_eq!(decimals(&orders, "direct_zero_to_peak_N")[row], Some(direct));
        assert_eq!(truths(&orders, "reverse_vanishes")[row], order.swing.reverse.outcome.vanishes());
    }
    let [gas, _] = study.with_gas().and_then(|loads| loads.bearings.as_ref()).expect("gas");
    let peak = &gas.bearings[0].peak;
    assert_eq!(decimals(&table("gas_bearings"), "force_zero_to_peak_N")[0], Some(peak.value));
    // The largest load over the crank angle is that of the table, as near as a degree comes.
    let theta = table("gas_theta");
    assert_eq!(theta.rows(), 720);
    let tips = decimals(&theta, "bearing_1_y_N").into_iter().zip(decimals(&theta, "bearing_1_x_N"));
    let sampled = tips.map(|(y, x)| y.expect("y").hypot(x.expect("x"))).fold(0.0, f64::max);
    assert!(sampled <= peak.value * (1.0 + 1e-9) && sampled > 0.98 * peak.value, "{sampled} of {}", peak.value);
    let at = peak.angle.round() as usize % 720;
    let y = decimals(&theta, "bearing_1_y_N")[at].expect("y");
    assert!((y - peak.vector.re).abs() < 0.02 * peak.value, "{y}");
}

/// What stands before the tables that a test writes.
const MARK: &str = "\n<!-- What follows is written by `CRANKSTAR_RENEW=1 cargo test --test suite data`. -->\n";

/// Where the unit of a column is told.
fn unit_told(column: &Column) -> &'static str {
    match column.unit() {
        Unit::NONE => "",
        _ if column.pattern().contains("{unit}") => "in the name",
        Unit::MASS_RADIUS => "m r",
        unit if unit.suffix.starts_with("mrw2") => "multiples",
        unit => unit.name,
    }
}

/// What a row of a table is, and its columns: name, unit, type, meaning.
type Listed<'a> = (&'a str, Vec<[&'a str; 4]>);

/// Every table with every column that some answer has, in the order in which they stand.
fn reference() -> String {
    let mut all: BTreeMap<(&str, &str), Listed> = BTreeMap::new();
    for answer in every_answer() {
        for table in &answer.tables {
            let (_, rows) = all.entry((answer.question, table.name())).or_insert((table.about(), Vec::new()));
            for column in table.columns() {
                let row = [column.pattern(), unit_told(column), column.values().kind().name(), column.about()];
                if !rows.contains(&row) {
                    rows.push(row);
                }
            }
        }
    }
    let mut text = String::new();
    for (question, tables) in crankstar::data::TABLES.iter() {
        for table in tables {
            let (about, rows) = all.remove(&(*question, *table)).unwrap_or_else(|| panic!("no {table} of {question}"));
            text += &format!(
                "\n### {question}: {table}\n\nA row: {about}.\n\n| Column | Unit | Type | Meaning |\n| --- | --- | --- | --- |\n"
            );
            for [pattern, unit, kind, about] in rows {
                let about = about.replace('|', "\\|");
                text += &format!("| `{pattern}` | {unit} | {kind} | {about} |\n");
            }
        }
    }
    assert!(all.is_empty(), "tables that `data::TABLES` does not name: {:?}", all.keys());
    text
}

#[test]
fn the_documentation_lists_every_column_of_every_table_and_no_other() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/data.md");
    let page = fs::read_to_string(&path).expect("the page");
    let (told, listed) = page.split_once(MARK).expect("the mark");
    let reference = reference();
    if std::env::var_os("CRANKSTAR_RENEW").is_some() {
        fs::write(&path, format!("{told}{MARK}{reference}")).expect("the page is written");
    } else {
        assert!(listed == reference, "docs/data.md is not what the tables are; CRANKSTAR_RENEW=1 writes it anew");
    }
}

/// `columns.txt` says something of every column, and nothing of one that no table has.
#[test]
fn every_column_has_its_sentence_and_every_sentence_its_column() {
    let mut columns: BTreeSet<(String, &str, &str)> = BTreeSet::new();
    for answer in every_answer() {
        for table in &answer.tables {
            let path = format!("{}.{}", answer.question, table.name());
            assert!(!table.about().is_empty(), "{path}");
            for column in table.columns() {
                assert!(!column.about().is_empty(), "{path}: {}", column.name());
                let names = [column.pattern(), column.name()];
                columns.extend(names.map(|name| (path.clone(), name, column.about())));
            }
        }
    }
    let sections = include_str!("../../src/report/data/columns.txt").trim_end().split("\n\n");
    for (head, lines) in sections.map(|section| section.split_once('\n').unwrap_or((section, ""))) {
        let path = head[1..].split(']').next().expect("a name");
        for line in lines.lines().filter(|line| !line.starts_with("as ")) {
            let (name, about) = line.split_once(": ").expect("a name and what it tells");
            assert!(columns.contains(&(path.to_owned(), name, about)), "[{path}] {line}");
        }
    }
}

/// Each unit that a name may hold, as the documentation explains it.
#[test]
fn the_documentation_explains_every_unit_in_a_name() {
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/data.md")).expect("the page");
    let mut found = BTreeSet::new();
    for answer in every_answer() {
        for column in answer.tables.iter().flat_map(Table::columns) {
            let Unit { suffix, name, .. } = column.unit();
            if !suffix.is_empty() && found.insert(suffix) {
                assert!(page.contains(&format!("| `{suffix}` | {name} |")), "| `{suffix}` | {name} | is not told");
            }
        }
    }
    assert!(found.len() > 10, "{found:?}");
}

/// A call that is refused, and what it says.
#[track_caller]
fn refused(arguments: &[&str], status: i32, words: &str) {
    let output = call(arguments);
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(status), "{arguments:?}: {error}");
    assert!(error.contains(words) && output.stdout.is_empty(), "{arguments:?}: {error}");
}

#[test]
fn what_cannot_be_had_is_refused_before_anything_is_written() {
    let folder = scratch("data-refused");
    let file = |name: &str| folder.join(name).to_str().expect("UTF-8").to_owned();
    let inch = ["loads", "I4", "--format", "csv", "--units", "inch"];
    refused(&inch, 2, "in SI units");
    refused(&["classify", "I4", "--format", "csv", "--units", "inch"], 2, "in SI units");
    refused(&["compare", "I4", "I6", "--format", "csv", "--table", "theta"], 2, "it has orders, engines");
    refused(&["compare", "I4", "I6", "--table", "orders"], 2, "--table is for data");
    refused(&["classify", "I4", "--output", &file("x")], 2, "--output is for data");
    refused(&["classify", "I4", "--format", "csv", "--output", &file("x.xlsx")], 2, "--format xlsx, or a name");
    refused(&["compare", "I4", "I6", "--format", "json", "--output", &file("x.csv")], 2, "--format csv, or a name");
    refused(&["classify", "I4", "--firing", "--format", "csv"], 2, "no tables of firing stars");
    refused(&["classify", "I4", "--format", "csv", "--table", "roll"], 1, "it has orders, sums");
    refused(&["classify", "I4", "--all-orders"], 2, "add --json");
    refused(&["classify", "I4", "--json", "--format", "csv"], 2, "cannot be used with");
    refused(&["loads", "I4", "--format", "csv"], 1, "rods");
    for format in ["xlsx", "parquet"] {
        let is_built =
            [("xlsx", cfg!(feature = "xlsx")), ("parquet", cfg!(feature = "parquet"))].contains(&(format, true));
        let search = ["search", "--cylinders", "12", "--cycle", "four-stroke", "--format", format];
        match is_built {
            true => refused(&search, 2, &format!("name a file: --output search.{format}")),
            false => refused(&search, 1, &format!("--features {format}")),
        }
    }
    assert_eq!(fs::read_dir(&folder).expect("the folder").count(), 0);
}

#[test]
fn a_table_goes_to_standard_output_a_file_or_a_folder() {
    let folder = scratch("data-written");
    let layout = folder.join("i3.toml");
    fs::write(&layout, I3).expect("a layout");
    let layout = layout.to_str().expect("UTF-8");
    let printed = |arguments: &[&str]| {
        let output = call(arguments);
        assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).expect("UTF-8")
    };
    let main = printed(&["loads", layout, "--format", "csv"]);
    assert!(main.starts_with("order,exists,force_vanishes,force_zero_to_peak_N,"), "{main}");
    let theta = printed(&["loads", layout, "--format", "csv", "--table", "theta"]);
    assert!(theta.starts_with("theta_deg,force_y_N,force_x_N,moment_y_N_m,") && theta.lines().count() == 361);
    let file = folder.join("of-theta.csv");
    let file = file.to_str().expect("UTF-8");
    let told = printed(&["loads", layout, "--format", "csv", "--table", "theta", "--output", file]);
    assert_eq!(told, format!("Written: {file}\n"));
    assert_eq!(fs::read_to_string(file).expect("the file"), theta);
    let all = folder.join("all");
    printed(&["loads", layout, "--format", "csv", "--output", all.to_str().expect("UTF-8")]);
    assert_eq!(fs::read_to_string(all.join("loads.csv")).expect("the file"), main);
    assert_eq!(fs::read_to_string(all.join("loads-theta.csv")).expect("the file"), theta);
    let json = printed(&["loads", layout, "--format", "json"]);
    assert_eq!(json, printed(&["loads", layout, "--json"]));
    // One table as JSON is that of the document of tables, or one that a certified document does not have.
    let table = |arguments: &[&str], name: &str| -> serde_json::Value {
        let text = printed(&[arguments, &["--format", "json", "--table", name]].concat());
        let all: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!(all.as_object().expect("an object").len(), 1, "{text}");
        all[name].clone()
    };
    assert_eq!(table(&["loads", layout], "theta").as_array().expect("rows").len(), 360);
    let shown = printed(&["angle", layout, "--at", "30", "--json"]);
    let document: serde_json::Value = serde_json::from_str(&shown).expect("JSON");
    assert_eq!(table(&["angle", layout, "--at", "30"], "pistons"), document["pistons"]);
    let weights = table(&["remedy", layout, "--radius", "80 mm"], "weights");
    for weight in weights.as_array().expect("rows") {
        let [mass, radius, both] =
            ["mass_kg", "radius_m", "mass_radius_kg_m"].map(|name| weight[name].as_f64().expect("a number"));
        assert!(radius == 0.08 && (mass * radius / both - 1.0).abs() < 1e-14, "{weight}");
    }
    // The document of the remedy has no masses, and says where they are.
    let document = call(&["remedy", layout, "--radius", "80 mm", "--json"]);
    assert!(String::from_utf8_lossy(&document.stderr).contains("--format json --table weights"));
    assert_eq!(document.stdout, call(&["remedy", layout, "--json"]).stdout);
    let search = ["search", "--cylinders", "4", "--cycle", "four-stroke"];
    for (asked, more, told) in [
        (&search[..], &["--sizes", "examples/four.toml"][..], "--format json --table stars"),
        (&["compare", "I4", "I5-12453"], &["--value", "classify.orders.1.order"], "--format json --table engines"),
        (&["remedy", layout], &["--speeds", "3000"], "the answer and the page have them"),
    ] {
        let document = call(&[asked, more, &["--json"]].concat());
        assert!(String::from_utf8_lossy(&document.stderr).contains(told), "{document:?}");
        assert_eq!(document.stdout, call(&[asked, &["--json"]].concat()).stdout, "{more:?}");
        assert!(!String::from_utf8_lossy(&call(&[asked, more].concat()).stderr).contains(told), "{more:?}");
    }
    // An answer in German has the same tables.
    assert_eq!(printed(&["loads", layout, "--format", "csv", "--lang", "de"]), main);
}

#[test]
fn a_format_that_was_not_built_is_refused_in_words() {
    let table = Table::new("t", "a row", 0);
    for (format, is_built) in
        [(Format::Xlsx, cfg!(feature = "xlsx")), (Format::Parquet, cfg!(feature = "parquet")), (Format::Csv, true)]
    {
        let written = format.one_file(std::slice::from_ref(&table));
        match is_built {
            true => assert!(format.is_built().is_ok() && written.is_ok(), "{written:?}"),
            false => {
                let why = written.expect_err("it is not built").to_string();
                assert!(why.contains("was built without") && why.contains("--features"), "{why}");
                assert_eq!(format.is_built().expect_err("it is not built").to_string(), why);
            }
        }
    }
}

#[test]
fn a_file_to_write_says_by_its_ending_what_it_holds() {
    let folder = scratch("data-endings");
    let layout = concat!(env!("CARGO_MANIFEST_DIR"), "/reports/examples/v8-gas/layout.toml");
    let path = |name: &str| folder.join(name).to_str().expect("a path").to_owned();
    for (question, name) in
        [("loads", "l.csv"), ("bearings", "b.CSV"), ("moments", "m.json"), ("classify", "c.csv"), ("values", "v.json")]
    {
        let value: &[&str] = if question == "values" { &["--value", "loads.orders.2.force"] } else { &[] };
        let (path, format) = (path(name), name[2..].to_lowercase());
        let run = |more: &[&str]| {
            let output = call(&[&[question, layout], value, more].concat());
            assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
            String::from_utf8(output.stdout).expect("a text")
        };
        let printed = run(&["--format", &format]);
        run(&["--output", &path]);
        assert_eq!(std::fs::read_to_string(&path).expect("a file"), printed, "{name}");
    }
    // Without the feature it is refused as --format is.
    let xlsx = path("x.xlsx");
    let output = call(&["loads", layout, "--output", &xlsx]);
    assert_eq!(output.status.success(), cfg!(feature = "xlsx"));
    assert_eq!(std::path::Path::new(&xlsx).is_file(), cfg!(feature = "xlsx"));
    for asked in [vec!["loads", layout, "--format", "html"], vec!["report", layout]] {
        let output = call(&[&asked[..], &["--output", &path("p.csv")]].concat());
        assert_eq!(output.status.code(), Some(2), "{asked:?}");
        assert!(String::from_utf8_lossy(&output.stderr).contains("a page goes into a folder"));
        assert!(!folder.join("p.csv").exists());
    }
}
