//! Does the torque say what a person means: the largest in size, the gas without the masses, and nothing of what is only rounding?

use crankstar::engine::{CycleOrder, Engine};
use crankstar::journal::cycle_loads;
use crankstar::torque::{EngineTorque, Peak, PeakMethod, guide_moments, torque};
use num_complex::Complex;

use crate::gas::{SPARK, engine};
use crate::moments::torque_of_one;
use crate::support::dice::Dice;
use crate::support::gas_table;
use crate::support::program::{call, scratch};

fn torque_of(text: &str) -> EngineTorque {
    torque(&engine(text)).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

fn printed(arguments: &[&str]) -> String {
    let output = call(arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("a text")
}

/// A stage of a compressor, whose gas takes its torque from the crank.
const COMPRESSOR: &str = "title = 'stage'\ncycle = 'two-stroke'\nfiring_order = '1-2'\nspeed = 600\n[mechanism]\nstroke = '86 mm'\n\
    rod_length = '143 mm'\nreciprocating_mass = '0.1 kg'\n[inline]\nthrows = [0, 180]\n[gas]\nbore = '86 mm'\nprocess = 'compressor'\n\
    intake_pressure = '1 bar'\ndelivery_pressure = '5 bar'\nclearance = 0.05\n";

#[test]
fn the_largest_torque_of_a_compressor_is_its_largest_in_size() {
    let torque = torque_of(COMPRESSOR);
    assert!(torque.lowest.value < -20.0 && torque.highest.value > torque.lowest.value / 2.0, "{torque:?}");
    let peak = Peak::new(&torque);
    assert_eq!(peak.largest, torque.lowest);
    for method in peak.methods() {
        let value = peak.value(method);
        assert!(value < 0.0 && value > 1.5 * torque.lowest.value, "{method:?}: {value}");
        assert!((peak.error(value) - ((value - torque.lowest.value) / torque.lowest.value).abs()).abs() < 1e-12);
    }
    assert!((peak.value(PeakMethod::Refined) - torque.lowest.value).abs() < 1e-9);
    let layout = scratch("compressor-peak").join("stage.toml");
    std::fs::write(&layout, COMPRESSOR).expect("a file");
    let page = printed(&["accuracy", layout.to_str().expect("a path")]);
    let said = page.lines().find(|line| line.contains("Largest torque in magnitude, gas and inertia")).expect("a line");
    let digits: String = said.chars().skip_while(|letter| !matches!(letter, '−' | '-')).skip(1).collect();
    let size: String = digits.chars().take_while(|letter| letter.is_ascii_digit() || *letter == '.').collect();
    let size: f64 = size.parse().unwrap_or_else(|_| panic!("no negative torque in {said}"));
    assert!((size + torque.lowest.value).abs() < 1e-2 * size, "{said}");
}

#[test]
fn the_error_of_any_method_is_within_what_is_anywhere_and_that_within_what_is_guaranteed_at_either_end() {
    for text in [COMPRESSOR.to_owned(), format!("speed = 3000\n{SPARK}")] {
        let torque = torque_of(&text);
        let peak = Peak::new(&torque);
        for order in [2, 6, 12].map(|halves| CycleOrder::of_halves(2 * halves).expect("an order")) {
            let method = PeakMethod::Orders(order);
            let error = (peak.value(method) - peak.largest.value).abs();
            let (farthest, bound) = (peak.farthest(method).expect("orders"), peak.bound(method).expect("orders"));
            assert!(error <= farthest && farthest <= bound, "{method:?}: {error}, {farthest}, {bound}");
        }
    }
}

/// An in-line four with these masses of its pistons, and a spacing.
fn four(masses: &str) -> String {
    let four =
        SPARK.replace("throws = [0]", "throws = [0, 180, 180, 0]\nspacing = '90 mm'").replace("'1'", "'1-3-4-2'");
    format!(
        "speed = 3000\n{}",
        four.replace("reciprocating_mass = '0.5 kg'", &format!("reciprocating_mass = {masses}"))
    )
}

#[test]
fn the_gas_does_not_feel_the_masses_of_the_pistons() {
    let unequal = torque_of(&four("['0.5 kg', '0.51 kg', '0.5 kg', '0.49 kg']"));
    let equal = torque_of(&four("'0.5 kg'"));
    assert_eq!(unequal.classes.len(), 1);
    for (one, other) in unequal.orders.iter().zip(&equal.orders) {
        assert_eq!((one.gas, one.gas_vanishes), (other.gas, other.gas_vanishes), "order {}", one.order);
        let is_zero = one.gas == num_complex::Complex::default();
        assert_eq!(one.gas_vanishes, is_zero, "order {}", one.order);
        // Half orders and the fourth multiples of a half are left by four even firings alone.
        assert_eq!(one.gas_vanishes, one.order.halves() % 4 != 0, "order {}", one.order);
    }
    // Order 1: 0.5 − 0.51 − 0.5 + 0.49 kg are not balanced.
    let first = unequal.orders.iter().find(|order| order.order.halves() == 2).expect("order 1");
    assert!(first.gas_vanishes && !first.inertia_vanishes && !first.vanishes());
    // The masses 2, 1, 0, 1 balance order 1, though no two neighbours are alike.
    let shared = torque_of(&four("['1 kg', '0.7 kg', '0.3 kg', '0 kg']"));
    let first = shared.orders.iter().find(|order| order.order.halves() == 2).expect("order 1");
    assert!(first.inertia_vanishes && first.vanishes() && first.inertia == Some(num_complex::Complex::default()));
}

#[test]
fn proved_zeros_of_the_gas_are_printed_and_written_as_zeros_beside_unequal_pistons() {
    let layout = scratch("unequal-gas").join("four.toml");
    std::fs::write(&layout, four("['0.5 kg', '0.51 kg', '0.5 kg', '0.49 kg']")).expect("a file");
    let layout = layout.to_str().expect("a path");
    let page = printed(&["torque", layout]);
    assert!(!page.contains("≈ 0 "), "{page}");
    let row = page.lines().find(|line| line.trim_start().starts_with("½ ")).expect("order ½");
    assert_eq!(row.matches(" 0").count(), 4, "{row}");
    let document: serde_json::Value = serde_json::from_str(&printed(&["torque", layout, "--json"])).expect("JSON");
    for order in document["orders"].as_array().expect("orders") {
        let halves = order["gas_vanishes"].as_bool().expect("a truth");
        let is_zero = order["gas_cos_N_m"] == 0.0 && order["gas_sin_N_m"] == 0.0;
        assert_eq!(halves, is_zero, "{order}");
    }
    assert_eq!(document["orders"][0]["gas_vanishes"], true);
    assert_eq!(document["orders"][1]["total_vanishes"], false);
    assert_eq!(document["classes"].as_array().map(Vec::len), Some(1));
}

/// An engine of cylinders that differ in nothing but their masses, and the same with equal ones.
fn unequal(dice: &mut Dice) -> (Engine, Engine) {
    let count = 2 + dice.below(5) as usize;
    let table = gas_table::rows(&gas_table::random(dice, 720.0, 40));
    let throws: Vec<u64> = (0..count).map(|_| 30 * dice.below(12)).collect();
    let fires: Vec<String> =
        throws.iter().map(|throw| ((720 - throw) % 360 + 360 * dice.below(2)).to_string()).collect();
    let masses: Vec<String> = (0..count).map(|_| format!("'{} g'", 100 * dice.below(6))).collect();
    let text = |masses: &str| {
        format!(
            "cycle = 'four-stroke'\nspeed = 2000\nfiring_angles = [{}]\n[mechanism]\nstroke = '90 mm'\nrod_length = '150 mm'\n\
             reciprocating_mass = {masses}\n[inline]\nthrows = {throws:?}\nspacing = '100 mm'\n[gas]\nbore = '80 mm'\nunit = 'bar'\n\
             pressure = [{table}]\n",
            fires.join(", ")
        )
    };
    (engine(&text(&format!("[{}]", masses.join(", ")))), engine(&text("'0.5 kg'")))
}

#[test]
fn no_mass_changes_what_the_gas_does_in_random_engines() {
    let mut dice = Dice::new(2606);
    for _ in 0..40 {
        let (one, other) = unequal(&mut dice);
        let torques = [&one, &other].map(|engine| torque(engine).expect("a torque"));
        for (a, b) in torques[0].orders.iter().zip(&torques[1].orders) {
            assert_eq!((a.gas, a.gas_vanishes, &a.stars), (b.gas, b.gas_vanishes, &b.stars));
            assert_eq!(a.gas_vanishes, a.gas == num_complex::Complex::default());
            assert_eq!(a.inertia_vanishes, a.inertia == Some(num_complex::Complex::default()), "{a:?}");
        }
        let loads = [&one, &other].map(|engine| cycle_loads(engine).expect("loads"));
        for (a, b) in loads[0].cylinders.iter().zip(&loads[1].cylinders) {
            for (a, b) in a.pin.orders.iter().zip(&b.pin.orders) {
                assert_eq!((a.gas, a.gas_vanishes), (b.gas, b.gas_vanishes));
            }
        }
        // The moments of the guides are sums over the cylinders, of the gas and of the masses.
        for (engine, torque) in [&one, &other].into_iter().zip(&torques) {
            let moments = guide_moments(engine, torque).expect("distances");
            for (moment, order) in moments.iter().zip(&torque.orders) {
                let sum = |cylinder: usize, place: usize| {
                    let class = &torque.classes[0];
                    let psi = std::f64::consts::TAU * crankstar::numbers::float(&class.fires[place]);
                    let kappa = f64::from(order.order.halves()) / 2.0;
                    let arm = crankstar::numbers::float(&engine.arm(&engine.cylinders()[cylinder])) / 0.15;
                    torque_of_one(class, place, order.order) * num_complex::Complex::cis(-kappa * psi) * arm
                };
                let places = torque.classes[0].cylinders.iter().enumerate();
                let twisting: num_complex::Complex<f64> = places.map(|(place, &cylinder)| sum(cylinder, place)).sum();
                let found = moment.twisting.unwrap_or(0.0);
                assert!((twisting.norm() - found).abs() < 1e-6, "{twisting} is not {found}");
            }
        }
    }
}

/// One cylinder with these rows of pressures in bar.
fn measured(rows: &str) -> String {
    let (before, _) = SPARK.split_once("[gas]").expect("gas");
    format!("speed = 3000\n{before}[gas]\nbore = '86 mm'\nunit = 'bar'\npressure = [{rows}]\n")
}

#[test]
fn a_pressure_that_stays_gives_no_mean_torque_and_is_no_multiple_of_it() {
    let every_ten: Vec<String> = (-36..=36).map(|ten| format!("[{}, 7.3]", 10 * ten)).collect();
    for rows in
        [every_ten.join(", "), "[-360, 7.3], [360, 7.3]".to_owned(), "[0, 7.3], [123, 7.3], [720, 7.3]".to_owned()]
    {
        let torque = torque_of(&measured(&rows));
        assert_eq!((torque.mean, torque.unevenness(), torque.power), (0.0, None, Some(0.0)), "{rows}");
        assert_eq!(torque.classes[0].gas.work(), 0.0);
        assert_eq!(torque.warnings, []);
        // The pressure still swings the torque: twice a revolution, and more.
        assert!(torque.orders[1].gas.norm() > 10.0);
    }
    let folder = scratch("constant-pressure");
    let layout = folder.join("constant.toml");
    std::fs::write(&layout, measured("[0, 7.3], [720, 7.3]")).expect("a file");
    let page = printed(&["torque", layout.to_str().expect("a path")]);
    assert!(!page.contains("times the mean") && !page.contains("dead centre"), "{page}");
}

#[test]
fn cylinders_of_opposite_work_have_no_mean_torque() {
    // A triangle of pressures, and the same backwards: what one gives the other takes.
    let gas = "[-360, 1], [0, 1], [90, 31], [200, 1], [360, 1]";
    let back = "[-360, 1], [-200, 1], [-90, 31], [0, 1], [360, 1]";
    let (before, _) = SPARK.split_once("[gas]").expect("gas");
    let before = before.replace("throws = [0]", "throws = [0, 0]").replace("'1'", "'1-2'");
    let text = format!(
        "speed = 3000\n{before}[gas]\nbore = '86 mm'\nunit = 'bar'\npressure = [{gas}]\n[[gas.cylinder]]\ncylinders = [2]\npressure = [{back}]\n"
    );
    let torque = torque_of(&text);
    assert!(torque.classes.iter().all(|class| class.harmonics.torque[0].re.abs() > 1.0));
    assert_eq!((torque.mean, torque.unevenness()), (0.0, None));
}

#[test]
fn harmonics_that_are_below_their_error_are_zero_and_no_others_are() {
    let mut dice = Dice::new(77);
    for _ in 0..20 {
        let table = gas_table::random(&mut dice, 720.0, 40);
        let torque = torque_of(&measured(&gas_table::rows(&table)));
        let harmonics = &torque.classes[0].harmonics;
        let largest = harmonics.torque.iter().map(|one| one.norm()).fold(0.0, f64::max);
        assert!(harmonics.errors[2] > 0.0 && harmonics.errors[2] < 1e-11 * largest, "{:?}", harmonics.errors);
        assert!(harmonics.torque.iter().all(|one| one.norm() > harmonics.errors[2]));
    }
}

#[test]
fn few_rows_suffice_where_they_go_round_the_cycle() {
    // A triangle between rows that close the cycle; and what two rows of half a cycle leave open.
    let torque = torque_of(&measured("[-360, 1], [0, 1], [90, 31], [200, 1], [360, 1]"));
    assert!(torque.mean > 1.0, "{}", torque.mean);
    let refused = |rows: &str| {
        let file = measured(rows);
        crankstar::parse("table.toml", &file).expect_err("rows that do not tell the cycle").to_string()
    };
    assert!(refused("[0, 7.3]").contains("a table of 1 row"));
    assert!(refused("[0, 7.3], [360, 7.3]").contains("the rows span 360° of a cycle of 720°"));
    assert!(refused("[0, 7.3], [720, 7.4]").contains("the last row repeats the first"));
}

/// A pressure that rises and falls within half a degree, and is largest at its kink.
const NEEDLE: &str = "cycle = 'two-stroke'\nspeed = 1000\nbearings = ['60 mm', '-60 mm']\ninline = { throws = [0] }\n\
    mechanism = { stroke = '80 mm', rod_length = '140 mm', reciprocating_mass = '0.5 kg' }\n\
    [gas]\nbore = '80 mm'\nunit = 'bar'\npressure = [[0, 1], [30.05, 1], [30.25, 60], [30.45, 1], [360, 1]]\n";

#[test]
fn what_the_orders_miss_is_looked_for_at_the_kinks_of_the_pressure_too() {
    let torque = torque_of(NEEDLE);
    let series = |theta: f64| -> f64 {
        torque.orders.iter().map(|one| (one.total() * Complex::cis(one.order.value() * theta)).re).sum()
    };
    let loads = cycle_loads(&engine(NEEDLE)).expect("loads");
    let [bearings, _] = loads.bearings.as_ref().expect("bearings");
    let [mut off, mut off_bearing] = [0.0_f64; 2];
    for step in 0..36_000 {
        let theta = (f64::from(step) / 100.0).to_radians();
        off = off.max((torque.course.total(theta) - torque.mean - series(theta)).abs());
        for one in &bearings.bearings {
            off_bearing = off_bearing.max((loads.course.carried(&one.carried, theta) - one.series.at(theta)).norm());
        }
    }
    assert!(off > 700.0 && off_bearing > 10_000.0, "{off}, {off_bearing}");
    for (told, scanned) in [(torque.missed, off), (loads.missed(bearings), off_bearing)] {
        assert!(told >= scanned * (1.0 - 1e-9) && told < scanned * 1.001, "{told} for {scanned}");
    }
}

#[test]
fn the_angle_of_the_largest_pressure_counts_as_the_gas_of_the_file_does() {
    let layout = "cycle = 'four-stroke'\nspeed = 3000\ninline = { throws = [0] }\n\
        mechanism = { stroke = '80 mm', rod_length = '140 mm', pin_offset = '20 mm', reciprocating_mass = '0.5 kg' }\n\
        [gas]\nbore = '80 mm'\ndead_centre = 'piston'\nunit = 'bar'\n\
        pressure = [[-180, 1], [0, 10], [12, 60], [180, 2], [200, 1], [540, 1]]\n";
    let path = scratch("peak-angle").join("layout.toml");
    std::fs::write(&path, layout).expect("a file");
    let page = printed(&["torque", path.to_str().expect("a path"), "--format", "markdown"]);
    assert!(page.contains(" 12.00° |") && !page.contains("18.38°"), "{page}");
    // A last row that repeats the first was given too.
    assert!(page.contains("| rows of the table of pressures | 6 |"), "{page}");
}

/// The angles of a file tell in which revolution the first cylinder fires, where they fit the throws as drawn.
#[test]
fn firing_angles_are_crank_angles_of_the_cycle() {
    let twin = |angles: &str, throws: &str| {
        let (before, gas) = SPARK.split_once("[gas]").expect("gas");
        let before = before.replace("throws = [0]", &format!("throws = [{throws}]\nspacing = '90 mm'"));
        let before = before.replace("firing_order = '1'", &format!("firing_angles = [{angles}]"));
        format!("speed = 3000\n{before}[gas]{gas}")
    };
    let fires = |layout: &str| {
        let path = scratch("firing-angles").join("layout.toml");
        std::fs::write(&path, layout).expect("a file");
        let document = printed(&["torque", path.to_str().expect("a path"), "--json"]);
        let document: serde_json::Value = serde_json::from_str(&document).expect("a document");
        document["classes"][0]["fires_deg"].as_str().expect("angles").to_owned()
    };
    let shifted = twin("540, 0", "180, 0");
    assert_eq!(fires(&shifted), "540 0");
    assert_eq!(fires(&twin("180, 360", "180, 0")), "180 360");
    // Angles that count from another angle than the drawing: the first revolution.
    assert_eq!(fires(&twin("360, 540", "180, 0")), "180 360");
    let [late, early] = [&shifted, &twin("180, 360", "180, 0")].map(|text| torque_of(text).highest);
    assert!(((late.angle - early.angle).rem_euclid(720.0) - 360.0).abs() < 1e-6, "{late:?} {early:?}");
}
