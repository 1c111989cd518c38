//! Does gas on both sides of a piston act as the difference of two forces, in every question of the gas?

use crankstar::claim::{self, Status, parse_statement};
use crankstar::engine::Engine;
use crankstar::file;
use crankstar::firing::Weights;
use crankstar::gas::{CylinderGas, Warning};
use crankstar::page::Format;
use crankstar::report::{self, AngleStudy, AnglesAsked, FiringStudy, Question, TorqueStudy};
use crankstar::torque::{TorqueOrder, torque};

use crate::angle::steam_engine;
use crate::languages::assert_known;
use crate::support::dice::Dice;
use crate::support::figure_texts::FigureTexts;
use crate::support::gas_table::{self, pressure};
use crate::support::pages;
use crate::support::written::assert_near;

fn engine(text: &str) -> Engine {
    file::parse("layout.toml", text).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

/// Bore and piston rod in metres.
const BORE: f64 = 0.3;
const ROD: f64 = 0.05;

fn two_stroke(throws: &str, above: &[f64], below: &str) -> String {
    let firing = if throws == "0" { "" } else { "firing_order = '1-2'\n" };
    format!(
        "cycle = 'two-stroke'\nspeed = 200\n{firing}[inline]\nthrows = [{throws}]\n[mechanism]\ncrank_radius = '225 mm'\n\
         rod_length = '1200 mm'\n[gas]\nbore = '300 mm'\ncrankcase = '1 bar'\nunit = 'bar'\npressure = [{}]\n{below}",
        gas_table::rows(above)
    )
}

fn disc(diameter: f64) -> f64 {
    std::f64::consts::PI / 4.0 * diameter * diameter
}

#[test]
fn force_torque_orders_and_work_are_the_difference_of_both_sides_for_random_cards() {
    let mut dice = Dice::new(50);
    for _ in 0..10 {
        let [above, below] = [30, 20].map(|peak| gas_table::random(&mut dice, 360.0, peak));
        let keys = format!("below_pressure = [{}]\npiston_rod = '50 mm'\n", gas_table::rows(&below));
        let both = engine(&two_stroke("0", &above, &keys));
        let gas = CylinderGas::new(&both, 0).expect("gas");
        let force = |degrees: f64| {
            let inner = disc(BORE) - disc(ROD);
            pressure(&above, degrees) * disc(BORE) - pressure(&below, degrees) * inner - 1e5 * disc(ROD)
        };
        for _ in 0..20 {
            let degrees = dice.below(36_000) as f64 / 100.0;
            assert_near(gas.force(degrees.to_radians()), force(degrees), 1e-8 * 2e5);
        }
        // Each side by itself, the inner one as a piston of its own area.
        let alone = |table: &[f64]| CylinderGas::new(&engine(&two_stroke("0", table, "")), 0).expect("gas");
        let [outer, inner] = [alone(&above), alone(&below)];
        let part = 1.0 - disc(ROD) / disc(BORE);
        assert_near(gas.work(), outer.work() - part * inner.work(), 1e-9 * outer.work().abs());
        let harmonics = [&gas, &outer, &inner].map(|gas| gas.harmonics(12));
        for order in 0..=12 {
            let [found, one, other] =
                harmonics.each_ref().map(|all| [all.force[order], all.side[order], all.torque[order]]);
            for place in 0..3 {
                let right = one[place] - other[place] * part;
                assert!((found[place] - right).norm() < 1e-8 * harmonics[1].force[0].norm(), "order {order}");
            }
        }
        assert!(harmonics[0].variation <= harmonics[1].variation + part * harmonics[2].variation + 1.0);
        let torque = torque(&both).expect("a torque");
        assert!(torque.balance < 1e-9, "{}", torque.balance);
        let largest =
            (0..72_000).map(|at| gas.torque(f64::from(at) * std::f64::consts::TAU / 72_000.0)).fold(f64::MIN, f64::max);
        assert_near(torque.highest.value, largest, 1e-6 * largest.abs());
    }
}

/// The same verdicts as of a single-acting engine: one law of the cylinder's own angle.
#[test]
fn verdicts_are_those_of_one_law_a_cylinder() {
    let mut dice = Dice::new(51);
    let [above, below] = [30, 20].map(|peak| gas_table::random(&mut dice, 360.0, peak));
    let keys = format!("below_pressure = [{}]\npiston_rod = '50 mm'\n", gas_table::rows(&below));
    let twin = |keys: &str| torque(&engine(&two_stroke("0, 180", &above, keys))).expect("a torque");
    let [one, two] = [twin(""), twin(&keys)];
    assert_eq!((one.classes.len(), two.classes.len()), (1, 1));
    let verdicts = |orders: &[TorqueOrder]| orders.iter().map(|order| order.gas_vanishes).collect::<Vec<_>>();
    assert_eq!(verdicts(&one.orders), verdicts(&two.orders));
    assert!(two.orders[0].gas_vanishes && !two.orders[1].gas_vanishes);
    // A cylinder that is double-acting alone is in a class of its own.
    let unlike = format!("[[gas.cylinder]]\ncylinders = [2]\n{keys}");
    assert_eq!(twin(&unlike).classes.len(), 2);
    // A star that vanishes is about gas that all cylinders share.
    let unlike = engine(&two_stroke("0, 180", &above, &unlike));
    let answer = claim::answer(&unlike, &parse_statement("order 1 of the gas torque vanishes").expect("a claim"), None);
    assert_eq!(answer.status, Status::NotDecided);
    let study = FiringStudy::new(&unlike, &[], Weights::Rigid).expect("stars");
    let told = pages::text(&report::firing_answer(&study), Format::PLAIN);
    assert!(told.contains("differs between its cylinders"), "{told}");
}

/// Like cards half a turn apart on pistons that move as `cos ψ`: odd orders of the torque cancel. A long rod is nearly that, a short one is not.
#[test]
fn like_cards_cancel_odd_orders_only_where_the_rod_is_endless() {
    let mut dice = Dice::new(52);
    let above = gas_table::random(&mut dice, 360.0, 30);
    let below: Vec<f64> = (0..180).map(|row| above[(row + 90) % 180]).collect();
    let keys = format!("below_pressure = [{}]\npiston_rod = '0.01 mm'\n", gas_table::rows(&below));
    let odd = |rod: &str| {
        let text = two_stroke("0", &above, &keys).replace("1200 mm", rod);
        let torque = torque(&engine(&text)).expect("a torque");
        torque.orders[0].gas.norm() / torque.orders[1].gas.norm()
    };
    assert!(odd("1000 m") < 1e-3 && odd("900 mm") > 1e-2, "{} {}", odd("1000 m"), odd("900 mm"));
}

#[test]
fn pages_name_both_sides_in_both_languages() {
    let steam = engine(&steam_engine());
    let page = TorqueStudy::new(&steam).expect("a torque").page();
    let text = pages::text(&page, Format::GITHUB);
    assert!(text.contains("diameter of the piston rod") && text.contains("p_2 (A - a)"), "{text}");
    let angle = AngleStudy::new(&steam, &AnglesAsked { at: vec![125.0], ..AnglesAsked::default() }).expect("values");
    assert!(pages::text(&angle.page(), Format::GITHUB).contains("p_2 (A - a)"));
    for picture in page.pictures() {
        assert!(picture.figure.overlaps().is_empty(), "{}", picture.name);
    }
    assert_known(&[page, angle.page()]);
}

#[test]
fn a_largest_pressure_far_from_the_dead_centre_is_usual_where_both_sides_press() {
    // Steam is admitted up to a quarter of a turn.
    let admitted: Vec<f64> = (0..180).map(|row| if row < 45 { 8.0 + f64::from(row) / 100.0 } else { 1.0 }).collect();
    let odd = |below: &str| torque(&engine(&two_stroke("0", &admitted, below))).expect("a torque").warnings;
    let of_the_angle = |odd: Vec<(usize, Warning)>| odd.iter().any(|(_, odd)| matches!(odd, Warning::PeakAngle(_)));
    assert!(of_the_angle(odd("")));
    assert!(!of_the_angle(odd("below_pressure = [[0, 1], [360, 1]]\npiston_rod = '50 mm'\n")));
}

#[test]
fn a_cylinder_that_misfires_loses_both_cards() {
    let misfire = engine(&steam_engine()).misfiring("1").expect("it fires");
    let gas = CylinderGas::new(&misfire, 0).expect("gas");
    assert!((0..360).all(|degrees| gas.force(f64::from(degrees).to_radians()).abs() < 1e-9));
}

#[test]
fn what_is_said_of_one_side_alone_is_refused_at_its_place() {
    let base = steam_engine();
    let without = |line: &str| base.lines().filter(|one| !one.starts_with(line)).collect::<Vec<_>>().join("\n") + "\n";
    for (text, words, line) in [
        (without("below_pressure"), "a piston rod without a pressure below the piston", 14),
        (without("piston_rod"), "without the diameter of the piston rod", 9),
        (base.replace("'50 mm'", "'300 mm'"), "below that of the bore", 15),
        (base.replace("'50 mm'", "'-1 mm'"), "above 0", 15),
        (base.clone() + "below_table = 'card.csv'\n", "given twice", 14),
        (base.replace("[360, 1.5]", "[270, 1.5, 2]"), "a row of 3 values", 14),
    ] {
        let error = file::parse("steam.toml", &text).expect_err(words).to_string();
        assert!(error.contains(words) && error.contains(&format!(":{line}:")), "line {line}: {error}");
    }
}

#[test]
fn a_process_above_goes_with_a_card_below_in_a_unit_of_its_own() {
    let base = steam_engine();
    let process = base.replace(
        "pressure = [[0, 30], [360, 30]]",
        "process = 'compressor'\nintake_pressure = '1 bar'\ndelivery_pressure = '7 bar'\nclearance = 0.05",
    );
    let gas = CylinderGas::new(&engine(&process), 0).expect("gas");
    assert_near(gas.pressure_below(1.0).expect("a card"), 101_325.0 + 1_500.0, 1e-6);
    assert!(gas.peak_pressure().0 > 6.9e5);
}
