//! Do the errors of the methods come out as told, do the guarantees hold, and is the published page as stored?
//!
//! `CRANKSTAR_RENEW=1 cargo test --test suite accuracy` writes the page anew.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{env, fs, thread};

use crankstar::accuracy::{self, Method, Row, Study, Timing};
use crankstar::engine::Engine;
use crankstar::file::{self, Layout};
use crankstar::loads::{Missing, PeakMethod};
use crankstar::motion::{Coefficient, Enclosure, SliderCrank};
use crankstar::page;
use crankstar::proof::Quantity;
use crankstar::report::{self, AccuracyCase};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use crate::studies::accuracy_errors;
use crate::support::written::fraction;

fn reports() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reports")
}

fn example(name: &str) -> Engine {
    let file = reports().join("examples").join(name).join("layout.toml");
    let text = fs::read_to_string(file).expect("a layout file");
    match file::parse_layout("layout.toml", &text).expect("it reads") {
        Layout::Known(layout, _) => *layout,
        Layout::Open(_) => panic!("{name} has unknowns"),
    }
}

fn catalogue(name: &str, ratio: &BigRational) -> Engine {
    let layout = file::find(name).expect("it is known").engine().expect("it reads");
    accuracy::with_rod_ratio(&layout, ratio).expect("it turns round")
}

fn study(layout: &Engine, quantity: Quantity) -> Study {
    accuracy::study(layout, quantity, Timing::Off).expect("it has numbers")
}

fn row(study: &Study, method: Method) -> &Row {
    study.rows.iter().find(|row| row.method == method).expect("the method")
}

fn middle(peak: &Enclosure) -> f64 {
    ((&peak.low + &peak.high) / fraction(2, 1)).to_f64().expect("a float")
}

/// Lower and upper ends of the square root of a fraction, 200 bits behind the point.
fn root(number: &BigRational) -> [BigRational; 2] {
    let bits = 200_u32;
    let root = ((number.numer() << (2 * bits)) / number.denom()).sqrt();
    let unit = BigInt::from(1) << bits;
    [BigRational::new(root.clone(), unit.clone()), BigRational::new(root + 1_u32, unit)]
}

/// What every study has to keep, whatever the engine.
fn guarantees_hold(layout: &Engine, quantity: Quantity) {
    let study = study(layout, quantity);
    let peak = middle(&study.peak);
    let doubt = (study.peak.width()).to_f64().expect("a float") / peak;
    for row in &study.rows {
        let slack = study.rounding + doubt;
        match row.method {
            Method::Orders(_) => {
                let bound = row.bound.expect("a bound");
                assert!(row.error <= bound + slack, "{}: {quantity:?} {row:?}", layout.title().written());
            }
            Method::Intervals(_) => {
                let half = row.bound.expect("a bound") * peak / 2.0;
                let (low, high) = (row.value - half, row.value + half);
                let roundings = 4.0 * f64::EPSILON * peak;
                assert!(study.peak.low.to_f64().unwrap() <= high + roundings, "{}: {row:?}", layout.title().written());
                assert!(study.peak.high.to_f64().unwrap() >= low - roundings, "{}: {row:?}", layout.title().written());
            }
            // A sample is never above the peak, but for roundings, and one of 3600 comes near it.
            Method::Doubles(steps) => {
                assert!(row.value <= peak * (1.0 + slack), "{}: {row:?}", layout.title().written());
                assert!(steps < 3600 || row.error < 1e-3, "{}: {row:?}", layout.title().written());
            }
            Method::Fractions => {}
        }
    }
}

#[test]
fn guarantees_hold_for_engines_of_all_kinds_at_all_rod_ratios() {
    let names = ["I1", "I3", "I4", "I2-270", "V6-90-split", "boxer-4", "radial-3"];
    for (place, name) in names.into_iter().enumerate() {
        let ratio = fraction(place as i64 + 2, 10);
        for quantity in [Quantity::FORCE, Quantity::MOMENT, Quantity::TORQUE] {
            guarantees_hold(&catalogue(name, &ratio), quantity);
        }
    }
    guarantees_hold(&example("i6-offset"), Quantity::FORCE);
}

#[test]
fn guarantees_hold_with_masses_on_the_crankshaft() {
    guarantees_hold(&example("thesis-v8-crossplane"), Quantity::MOMENT);
    let text = fs::read_to_string(reports().join("thesis/i3-skewed.toml")).expect("a layout file");
    let skewed = file::parse("i3-skewed.toml", &text).expect("it reads");
    assert!(!skewed.crankshaft().counterweights.is_empty());
    guarantees_hold(&skewed, Quantity::MOMENT);
    guarantees_hold(&skewed, Quantity::FORCE);
}

#[test]
fn engines_with_balancer_shafts_are_refused_with_words() {
    let numbers = "[mechanism]\nrod_ratio = 0.25\ncrank_radius = 1\nreciprocating_mass = 1\n";
    let shaft = "[[balancer]]\norder = 2\nsense = 'with'\nmass_radius = 1\nangle = 0\nposition = 0\n";
    let layout =
        file::parse("x.toml", &format!("inline.throws = [0, 180, 180, 0]\n{numbers}{shaft}")).expect("it reads");
    let refused = accuracy::study(&layout, Quantity::FORCE, Timing::Off).map(|_| ());
    assert_eq!(refused, Err(Missing::BalancerShafts));
}

#[test]
fn engines_whose_cranks_turn_against_each_other_are_told_so() {
    let numbers = "[mechanism]\nrod_ratio = 0.25\ncrank_radius = 1\nreciprocating_mass = 1\nrotating_mass = 1\n";
    let text = format!("[u]\nthrows = [0, 180]\nsense = 'against'\ndistance = 4\n{numbers}");
    let layout = file::parse("x.toml", &text).expect("it reads");
    let refused = accuracy::study(&layout, Quantity::FORCE, Timing::Off).expect_err("no comparison").to_string();
    assert!(refused.contains("all turn the same way") && !refused.contains("balancer"), "{refused}");
}

#[test]
fn the_peak_force_of_an_in_line_four_stands_a_quarter_turn_from_dead_centre() {
    // There all four have −λ/√(1−λ²); at dead centre two have 1 + λ and two −1 + λ, which is 4λ together.
    for ratio in [fraction(1, 10), fraction(1, 4), fraction(3, 10)] {
        let four = study(&catalogue("I4", &ratio), Quantity::FORCE);
        let square = &ratio * &ratio;
        let [low, high] = root(&(&square / (fraction(1, 1) - &square)));
        let four_times = |number: BigRational| number * fraction(4, 1);
        assert!(four.peak.low <= four_times(high) && four_times(low) <= four.peak.high, "λ = {ratio}");
        assert!(four.peak.width() < fraction(1, 10).pow(40), "λ = {ratio}");
    }
}

#[test]
fn the_peak_force_of_a_single_is_one_plus_the_rod_ratio() {
    for ratio in [fraction(1, 10), fraction(3, 10), fraction(1, 2)] {
        let single = study(&catalogue("I1", &ratio), Quantity::FORCE);
        let exact = fraction(1, 1) + &ratio;
        assert!(single.peak.contains(&exact), "λ = {ratio}");
        assert!(single.peak.width() < fraction(1, 10).pow(40), "λ = {ratio}");
    }
}

#[test]
fn orders_of_a_single_are_off_by_the_coefficients_cut_off() {
    // All even orders peak together at ψ = 90°, but the peak is at ψ = 0, where c_2 + c_4 + c_6 + … = λ.
    let ratio = fraction(3, 10);
    let single = study(&catalogue("I1", &ratio), Quantity::FORCE);
    let crank = SliderCrank::new(ratio.clone(), BigRational::zero()).expect("it turns");
    let second = crank.coefficient(2).re;
    let error = ((second.low - &ratio) / (fraction(1, 1) + &ratio)).abs().to_f64().expect("a float");
    let measured = row(&single, Method::Orders(2)).error;
    assert!((measured / error - 1.0).abs() < 1e-9, "{measured} against {error}");
}

#[test]
fn the_bound_of_what_is_cut_off_is_above_all_orders_cut_off() {
    // Far more orders than the bound sums one by one, at a rod ratio at which they fall slowly.
    let ratio = fraction(97, 100);
    let crank = SliderCrank::new(ratio.clone(), BigRational::zero()).expect("it turns");
    let size = |c: Coefficient| c.to_complex().norm();
    let single = catalogue("I1", &ratio);
    for (quantity, amplitude) in [
        (Quantity::FORCE, &(|k| size(crank.coefficient(k))) as &dyn Fn(u32) -> f64),
        (Quantity::TORQUE, &|k| size(crank.torque_coefficient(k))),
    ] {
        let study = study(&single, quantity);
        let all: f64 = (33..=200).map(amplitude).sum();
        let bound = row(&study, Method::Orders(32)).bound.expect("a bound") * middle(&study.peak);
        assert!(all < bound && bound < 1.5 * all, "{quantity:?}: {all} against {bound}");
    }
}

#[test]
fn errors_are_the_same_each_time() {
    let layout = catalogue("V6-60-even", &fraction(3, 10));
    let [first, second] = [0, 1].map(|_| study(&layout, Quantity::TORQUE));
    for (one, other) in first.rows.iter().zip(&second.rows) {
        assert_eq!((one.value, one.error, one.bound), (other.value, other.error, other.bound));
    }
}

#[test]
fn fewer_orders_are_enough_for_a_shorter_crank_and_as_many_as_the_bound_says() {
    let needed = |tenths: i64, of: fn(&Row) -> f64| {
        let study = study(&catalogue("I4", &fraction(tenths, 10)), Quantity::FORCE);
        let enough = study.rows.iter().find_map(|row| match row.method {
            Method::Orders(order) if of(row) < 1e-3 => Some(order),
            _ => None,
        });
        enough.expect("32 orders are enough")
    };
    let by_bound: Vec<u32> = (1..=9).map(|tenths| needed(tenths, |row| row.bound.unwrap_or(1.0))).collect();
    let by_error: Vec<u32> = (1..=9).map(|tenths| needed(tenths, |row| row.error)).collect();
    assert!(by_bound.is_sorted(), "{by_bound:?}");
    assert!(by_bound[0] < by_bound[8], "{by_bound:?}");
    // All orders of an in-line four peak together, so that the bound is the error.
    assert_eq!(by_bound, by_error);
}

#[test]
fn loads_that_vanish_have_a_bound_and_no_methods() {
    let layout = catalogue("I6", &fraction(3, 10));
    let moment = study(&layout, Quantity::MOMENT);
    assert!(moment.rows.is_empty());
    assert!(moment.peak.high < fraction(1, 10).pow(15));
}

#[test]
fn a_load_of_one_length_is_known_without_a_search() {
    // The couple of a cross-plane V8 with equal spacing: √10 at order 1, nothing else (theory, section 6).
    let moment = study(&catalogue("V8-crossplane", &fraction(3, 10)), Quantity::MOMENT);
    let [low, high] = root(&fraction(10, 1));
    assert!(moment.peak.low <= high && low <= moment.peak.high);
    assert!(moment.peak.width() < fraction(1, 10).pow(15));
}

#[test]
fn what_a_layout_lacks_is_told() {
    let layout = file::find("I4").expect("it is known").engine().expect("it reads");
    assert_eq!(accuracy::study(&layout, Quantity::FORCE, Timing::Off).map(|_| ()), Err(Missing::Rods));
    assert!(accuracy::with_rod_ratio(&example("i6-offset"), &fraction(999, 1000)).is_err());
}

#[test]
fn times_are_measured_only_where_they_are_asked_for() {
    let layout = catalogue("I1", &fraction(3, 10));
    assert!(study(&layout, Quantity::FORCE).rows.iter().all(|row| row.time.is_none()));
    let timed = accuracy::study(&layout, Quantity::FORCE, Timing::On).expect("it has numbers");
    assert!(timed.rows.iter().all(|row| row.time.is_some()));
}

#[test]
fn a_method_that_adds_nothing_to_the_one_before_it_is_left_out() {
    // The force of the V6 on shared pins has orders 6, 12, 18, 24 …: a figure that turns, which intervals in doubles do not tell from a still one.
    let study = study(&catalogue("V6-60-shared", &fraction(3, 10)), Quantity::FORCE);
    let methods: Vec<Method> = study.rows.iter().map(|row| row.method).collect();
    assert_eq!(methods[..5], [2, 6, 12, 24, 32].map(Method::Orders));
    assert_eq!(methods[8..], [Method::Intervals(3), Method::Fractions]);
    assert_eq!(study.rows[8].looked_at, Some(4000));
    for name in ["I4", "I5-12453", "V8-crossplane", "radial-9"] {
        let rows = self::study(&catalogue(name, &fraction(3, 10)), Quantity::FORCE).rows;
        for pair in rows.windows(2).filter(|pair| matches!(pair[1].method, Method::Orders(_))) {
            assert!(pair[0].bound > pair[1].bound, "{name}: {pair:?}");
        }
    }
}

#[test]
fn the_section_of_a_report_has_no_times_in_any_format() {
    let layout = catalogue("I2-180", &fraction(3, 10));
    let case = AccuracyCase::of(&layout, &[Quantity::FORCE, Quantity::TORQUE], Timing::Off).expect("it has numbers");
    let mut section = page::Document::new("section", "section");
    section.blocks = report::accuracy_section(std::slice::from_ref(&case));
    let tables = |blocks: &[page::Block]| blocks.iter().filter(|block| matches!(block, page::Block::Table(_))).count();
    let folded =
        section.blocks.iter().map(|block| if let page::Block::Folded(fold) = block { tables(&fold.blocks) } else { 0 });
    assert_eq!(tables(&section.blocks) + folded.sum::<usize>(), 4);
    let dollars = page::Format::Markdown(page::Math::Dollars);
    for format in [page::Format::GITHUB, dollars, page::Format::Latex, page::Format::Html, page::Format::PLAIN] {
        let text = page::write(&section, format, &page::Options::default()).remove(0).text;
        assert!([" µs", " ms", " ns", "[U+"].iter().all(|word| !text.contains(word)), "{text}");
    }
}

/// The published page: two engines at five rod ratios.
fn published() -> BTreeMap<String, String> {
    let ratios: Vec<BigRational> = [1, 3, 5, 7, 9].map(|tenths| fraction(tenths, 10)).to_vec();
    let engines = [
        (example("marine-i4"), vec![Quantity::FORCE, Quantity::TORQUE]),
        (example("thesis-v8-crossplane"), vec![Quantity::FORCE, Quantity::MOMENT, Quantity::TORQUE]),
    ];
    let cases = |(layout, quantities): (Engine, Vec<Quantity>)| {
        let case = |ratio: &BigRational| {
            let changed = accuracy::with_rod_ratio(&layout, ratio).expect("it turns round");
            AccuracyCase::of(&changed, &quantities, Timing::Off).expect("it has numbers")
        };
        let cases = thread::scope(|scope| {
            let running: Vec<_> = ratios.iter().map(|ratio| scope.spawn(|| case(ratio))).collect();
            running.into_iter().map(|case| case.join().expect("a case")).collect()
        });
        (layout, cases)
    };
    let written = accuracy_errors::page(&engines.map(cases));
    let files = page::write(&written, page::Format::GITHUB, &page::Options::default());
    files.into_iter().map(|file| (file.name, file.text)).collect()
}

#[test]
fn the_published_page_is_as_stored() {
    let folder = reports().join("accuracy");
    let written = published();
    if env::var_os("CRANKSTAR_RENEW").is_some() {
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("the folder");
        for (name, text) in &written {
            fs::write(folder.join(name), text).expect("a file");
        }
    }
    let entries = fs::read_dir(&folder).expect("the folder").map(|entry| entry.expect("an entry").path());
    let stored: BTreeMap<String, String> = entries
        .map(|path| {
            let name = path.file_name().expect("a name").to_string_lossy().into_owned();
            (name, fs::read_to_string(&path).expect("a text"))
        })
        .collect();
    assert_eq!(stored.keys().collect::<Vec<_>>(), written.keys().collect::<Vec<_>>());
    for (name, text) in &written {
        let first = stored[name].lines().zip(text.lines()).position(|(old, new)| old != new);
        assert!(&stored[name] == text, "{name} differs, first in line {:?}", first.map(|line| line + 1));
    }
}

#[test]
fn bearing_loads_by_orders_come_to_the_closed_form_and_keep_their_guarantee() {
    for name in ["boxer-4-ej25", "v8-small-block", "i6-offset", "thesis-i3"] {
        let layout = example(name);
        let rows = accuracy::bearings(&layout, Timing::Off).expect("numbers").expect("bearings");
        let mut guaranteed = f64::INFINITY;
        for row in &rows {
            if let Some(bound) = row.bound {
                assert!(row.error <= bound + 1e-11 && bound <= guaranteed, "{name}: {row:?}");
                guaranteed = bound;
            }
        }
        let error = |method: PeakMethod| rows.iter().find(|row| row.method == method).expect("the method").error;
        assert!(error(PeakMethod::Orders("24".parse().expect("an order"))) < 1e-9, "{name}: {rows:?}");
        assert!(error(PeakMethod::Samples(3600)) < 1e-5 && error(PeakMethod::Refined) == 0.0, "{name}: {rows:?}");
    }
    let without = catalogue("I4", &fraction(3, 10));
    assert!(accuracy::bearings(&without, Timing::Off).expect("numbers").is_none());
}
