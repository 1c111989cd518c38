//! Is a turning-moment diagram read as textbooks give it, and are energy, speed and flywheel those of the theory, exactly?

use std::f64::consts::{PI, TAU};

use crankstar::file::{Diagram, Torque, parse_diagram};
use crankstar::flywheel::{Fluctuation, NoFluctuation, TorqueCurve, WithPi, fluctuation};
use crankstar::page::{Format, Options, Units};
use crankstar::report::{FlywheelStudy, Question};
use num_rational::BigRational;

use super::true_sentences::said;
use crate::support::dice::Dice;
use crate::support::program::call;
use crate::support::written::{assert_near, fraction};

const TRIANGLES: &str = include_str!("../../examples/turning-moment.toml");

fn diagram(text: &str) -> Diagram {
    parse_diagram("diagram.toml", text).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

fn found(text: &str) -> Fluctuation {
    fluctuation(&diagram(text)).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

/// The rational number before this power of π.
fn before_pi(value: &WithPi, power: i32) -> BigRational {
    assert_eq!(value.power, power, "{value:?}");
    value.form.as_ref().and_then(crankstar::numbers::Form::as_rational).unwrap_or_else(|| panic!("{value:?}"))
}

/// The range of the integral of torque less load, sampled.
fn sampled(diagram: &Diagram, turns: f64) -> f64 {
    let steps = 20_000;
    let course = TorqueCurve::new(diagram).expect("no areas");
    let (mut sum, mut highest, mut lowest) = (0.0_f64, 0.0_f64, 0.0_f64);
    for step in 0..steps {
        let middle = fraction(2 * step + 1, 2 * steps) * fraction(turns as i64, 1);
        let [torque, load] = course.at(&middle);
        sum += (torque - load) * turns * TAU / steps as f64;
        (highest, lowest) = (highest.max(sum), lowest.min(sum));
    }
    highest - lowest
}

#[test]
fn areas_of_a_drawing_give_the_textbooks_energy_and_speed_exactly() {
    let found = found(
        "speed = 1800\nmass = '36 kg'\nradius_of_gyration = '150 mm'\ntorque_scale = '1 mm = 5 N m'\nangle_scale = '1°/mm'\n\
         areas = ['295 mm²', '-685 mm²', '40 mm²', '-340 mm²', '960 mm²', '-270 mm²']\n",
    );
    assert_eq!(before_pi(&found.energy, 1), fraction(985, 36));
    assert_near(found.energy.decimal, 85.957466, 1e-6);
    let part = found.irregularity.expect("an inertia");
    assert_eq!(before_pi(&part, -1), fraction(985, 104_976));
    assert_near(part.decimal, 0.002_986_732_6, 1e-10);
    assert!(found.mean.is_none() && found.fastest_and_slowest.is_none());
}

/// The same curve, begun a quarter turn earlier.
#[test]
fn a_diagram_may_begin_at_any_angle() {
    let curve = "[[-90, 200], [0, 0], [90, 200], [180, 400], [270, 200]]";
    let whole = "[[0, 0], [180, 400], [360, 0]]";
    let load = |points: &str, load: &str| found(&format!("points = {points}\nload_points = {load}\n"));
    assert_eq!(before_pi(&load(whole, curve).energy, 1), fraction(0, 1));
    assert_eq!(before_pi(&load(curve, whole).energy, 1), fraction(0, 1));
    let text = "points = [[-90, 0], [0, 400], [90, 0], [180, -200], [270, 0]]\nangles = [0, 180, -90, 225]\n";
    let drawn = diagram(text);
    let course = TorqueCurve::new(&drawn).expect("no areas");
    for (turn, torque) in
        [(fraction(0, 1), 400.0), (fraction(1, 2), -200.0), (fraction(3, 4), 0.0), (fraction(5, 8), -100.0)]
    {
        assert_near(course.at(&turn)[0], torque, 1e-9);
    }
    let [fastest, slowest] = found(text).fastest_and_slowest.expect("angles");
    assert_near(fastest, 78.75, 1e-9);
    assert_near(slowest, 281.25, 1e-9);
}

#[test]
fn an_exact_energy_in_joules_is_no_number_of_foot_pounds() {
    let text = "title = 'x'\npoints = [[0, 0], [90, 400], [180, 0], [270, -200], [360, 0]]\n";
    let study = FlywheelStudy::new(diagram(text)).expect("an answer");
    let told = |units| {
        let options = Options { units, ..Options::default() };
        crankstar::page::write(&study.answer(), Format::PLAIN, &options).remove(0).text
    };
    assert!(told(Units::Si).contains("π · 1225/8 ≈ 481"), "{}", told(Units::Si));
    assert!(!told(Units::Inch).contains("1225/8") && told(Units::Inch).contains("355"), "{}", told(Units::Inch));
}

#[test]
fn triangles_give_mean_energy_and_inertia_exactly() {
    let found = found(TRIANGLES);
    assert_eq!(before_pi(found.mean.as_ref().expect("a mean"), 0), fraction(475, 2));
    assert_eq!(before_pi(&found.energy, 1), fraction(244_205, 192));
    assert_near(found.energy.decimal, 3_995.794_969, 1e-6);
    let inertia = found.inertia.expect("an irregularity");
    assert_near(inertia.decimal, 202.429_338, 1e-6);
    assert_near(found.mass.expect("a radius").decimal, 202.429_338 / 0.81, 1e-5);
    assert_near(found.angles[0].torque, -200.0, 1e-12);
    assert_near(found.angles[1].acceleration.expect("an inertia"), (3000.0 - 237.5) / inertia.decimal, 1e-9);
}

#[test]
fn three_cylinders_240_degrees_apart_add_up_exactly() {
    let text = TRIANGLES.to_owned() + "cylinders = 3\ninterval = 240\n";
    let found = found(&text.replace("angles = [90, 450]\n", ""));
    assert_eq!(before_pi(found.mean.as_ref().expect("a mean"), 0), fraction(1425, 2));
    // Degrees are π/180.
    assert_eq!(before_pi(&found.energy, 1), fraction(484_260_825, 4256 * 180));
    assert_near(found.energy.decimal, 1_985.889_529, 1e-6);
    assert_near(sampled(&diagram(&text), 2.0), 1_985.889_529, 0.1);
}

#[test]
fn harmonics_have_their_energy_as_a_root_and_the_acceleration_at_an_angle() {
    let text = "speed = 180\nirregularity = 0.01\nmean = 20000\nangles = [45]\nharmonics = [{ order = 2, sin = 9500, cos = -5700 }]\n";
    let one = found(text);
    assert_eq!(one.energy.form.as_ref().expect("a root").to_string(), "1900√34");
    assert_near(one.energy.decimal, 11078.8086, 1e-4);
    assert_near(one.power.expect("a speed").decimal, 376_991.118, 1e-3);
    let inertia = one.inertia.expect("wanted").decimal;
    assert_near(inertia, 3_118.105_558, 1e-6);
    assert_near(one.angles[0].acceleration.expect("an inertia"), 3.046_721_743, 1e-9);
    let two =
        found("mean = 5000\nharmonics = [{ order = 3, sin = 1500 }]\nload_harmonics = [{ order = 1, sin = 600 }]\n");
    assert_near(two.energy.decimal, 1_656.502_339, 1e-6);
    assert_near(two.energy.decimal, 280.0 * 35f64.sqrt(), 1e-8);
    let half = found("mean = 10\nharmonics = [{ order = '1/2', cos = 3, sin = 4 }]\n");
    assert_eq!(before_pi(&half.energy, 0), fraction(20, 1));
    assert_eq!(half.cycle, Some(fraction(2, 1)));
    let none = found("mean = 10\nharmonics = [{ order = 1, cos = 3 }]\nload_harmonics = [{ order = 1, cos = 3 }]\n");
    assert_eq!(before_pi(&none.energy, 0), fraction(0, 1));
}

#[test]
fn strokes_by_areas_of_a_known_work_have_a_mean_with_one_over_pi() {
    let found = found(
        "speed = 200\nirregularity = '1/100'\narea_scale = '1400 J/cm²'\n\
         triangles = [{ width = 180, area = '-0.45 cm^2' }, { width = 180, area = '-1.7 cm²' }, { width = 180, area = '6.8 cm²' }, { width = 180, area = '-0.65 cm²' }]\n",
    );
    // 4 cm² of 1400 J in two turns.
    assert_eq!(before_pi(found.work.as_ref().expect("a work"), 0), fraction(5600, 1));
    assert_eq!(before_pi(found.mean.as_ref().expect("a mean"), -1), fraction(1400, 1));
    // Above the mean is of the third triangle the part similar to it: its peak is 2·6.8·1400/π.
    let (peak, mean) = (2.0 * 6.8 * 1400.0 / PI, 1400.0 / PI);
    assert_near(found.energy.decimal, 6.8 * 1400.0 * ((peak - mean) / peak).powi(2), 1e-9);
}

#[test]
fn points_with_steps_and_a_load_of_points_are_exact() {
    // 300 N m for half a turn, none for the other: 150 on the mean, 150·π above it.
    let step = found("points = [[0, 300], [180, 300], [180, 0], [360, 0]]\n");
    assert_eq!(before_pi(&step.energy, 1), fraction(150, 1));
    assert_eq!(step.fastest_and_slowest, Some([180.0, 0.0]));
    // The same load removes all of it; one that is half a turn behind doubles it.
    let with =
        |load: &str| found(&format!("points = [[0, 300], [180, 300], [180, 0], [360, 0]]\nload_points = {load}\n"));
    let same = with("[[0, 300], [180, 300], [180, 0], [360, 0]]");
    assert_eq!(before_pi(&same.energy, 1), fraction(0, 1));
    let behind = with("[[0, 0], [180, 0], [180, 300], [360, 300]]");
    assert_eq!(before_pi(&behind.energy, 1), fraction(300, 1));
}

#[test]
fn the_energy_of_random_diagrams_is_that_of_their_sampled_integral() {
    let mut dice = Dice::new(30);
    for _ in 0..12 {
        let count = 3 + dice.below(6);
        let mut number = |most: u64| i64::try_from(dice.below(most)).expect("small");
        let points: Vec<String> =
            (0..=count).map(|place| format!("[{}, {}]", 720 * place / count, number(4000) - 1500)).collect();
        let cylinders = 1 + number(4);
        let text =
            format!("points = [{}]\ncylinders = {cylinders}\ninterval = {}\n", points.join(", "), 15 * number(48));
        let (energy, drawn) = (found(&text).energy, diagram(&text));
        assert!(energy.form.is_some() && energy.power == 1);
        assert!((energy.decimal - sampled(&drawn, 2.0)).abs() < 1e-2 * (1.0 + energy.decimal), "{text}");
    }
}

#[test]
fn what_does_not_fit_is_refused_with_its_place() {
    let told = |text: &str| parse_diagram("diagram.toml", text).expect_err("a mistake").to_string();
    for (text, words) in [
        ("title = 'x'\n", "no turning-moment diagram"),
        ("points = [[0, 1], [360, 1]]\nmean = 3\n", "without harmonics"),
        ("points = [[0, 1], [360, 1]]\nareas = ['1 J', '-1 J']\n", "two diagrams"),
        ("points = []\n", "an empty list"),
        ("points = [[0, 1]]\n", "without a width"),
        ("points = [[0, 1], [90]]\n", "[angle, torque]"),
        ("points = [[90, 1], [0, 1]]\n", "angles that rise"),
        ("points = [[0, 1], [3600000, 1]]\n", "up to 100 turns"),
        ("points = [[0, '1 kg'], [90, 1]]\n", "none of"),
        ("areas = ['12 mm²', '-12 mm²']\n", "without a scale"),
        ("areas = [12, -12]\n", "with its unit"),
        ("areas = ['12 J', '-8 J']\n", "do not close over the cycle"),
        ("areas = ['12.5 J', '-8 J']\n", "; 4.5 J remains, 22 % of all of them"),
        (
            "torque_scale = '5 N m/mm'\nangle_scale = '1°/mm'\nareas = ['12 mm²', '-0.1225 cm²']\n",
            "; -0.25 mm² remains, -1 % of all of them",
        ),
        ("areas = ['1296 J', '-1295 J']\n", "; 1 J remains, 0.04 % of all of them"),
        ("torque_scale = '5 N m/mm'\nangle_scale = '1°/mm'\nareas = ['12 mm²', '-12 J']\n", "all in one way"),
        ("torque_scale = '5 N m'\n", "600 N m/mm"),
        ("torque_scale = '0 mm = 5 N m'\n", "600 N m/mm"),
        ("angle_scale = '-3°/mm'\n", "above 0"),
        ("irregularity = '±60 %'\npoints = [[0, 1], [360, 1]]\n", "±1 %"),
        ("harmonics = [{ order = 2, sin = 1 }]\n", "without a mean"),
        ("mean = 1\nharmonics = [{ sin = 1 }]\n", "without an order"),
        ("mean = 1\nharmonics = [{ order = 0.3, sin = 1 }]\n", "order"),
        ("triangles = [{ width = 180 }]\n", "its peak or its area"),
        ("triangles = [{ peak = 1 }]\n", "without a width"),
        ("triangles = [{ width = -1, peak = 1 }]\n", "above 0"),
        ("cylinders = 3\npoints = [[0, 1], [360, 1]]\n", "belong together"),
        ("cylinders = 3\ninterval = 120\nareas = ['1 J', '-1 J']\n", "points or triangles"),
        ("mass = 3\npoints = [[0, 1], [360, 1]]\n", "radius of gyration"),
        ("mean = 1\nharmonics = [{ order = 1 }]\nload_points = [[0, 1], [360, 1]]\n", "another kind"),
        ("angles = [45]\nareas = ['1 J', '-1 J']\n", "toml:1:"),
        ("angles = [45]\nareas = ['1 J', '-1 J']\n", "angles beside areas"),
        ("weight = 1\n", "weight"),
    ] {
        assert!(told(text).contains(words), "{text}{}", told(text));
    }
    let refused = |text: &str| fluctuation(&diagram(text)).expect_err("it does not fit");
    let points = "points = [[0, 300], [180, 0], [360, 0]]\n";
    let unequal = refused(&format!("{points}load_points = [[0, 1], [360, 1]]\n")).to_string();
    assert!(unequal.contains("their means, 1 and 75 N m, must be equal"), "{unequal}");
    assert_eq!(refused(&format!("{points}load_points = [[0, 75], [720, 75]]\n")), NoFluctuation::OtherCycle);
}

#[test]
fn scales_of_a_drawing_are_given_once_and_beside_areas_that_they_measure() {
    let told = |text: &str| parse_diagram("diagram.toml", text).expect_err("a mistake").to_string();
    let (sides, area) = ("torque_scale = '5 N m/mm'\nangle_scale = '1°/mm'\n", "area_scale = '1400 J/cm²'\n");
    let drawn = "areas = ['12 mm²', '-12 mm²']\n";
    for scales in [sides, area] {
        diagram(&format!("{scales}{drawn}"));
        diagram(&format!("{scales}triangles = [{{ width = 360, area = '1 cm²' }}]\n"));
    }
    let both = told(&format!("{sides}{area}{drawn}"));
    assert!(both.contains("both torque_scale and area_scale are given") && both.contains("toml:3:"), "{both}");
    let both = told(&format!("angle_scale = '1°/mm'\n{area}{drawn}"));
    assert!(both.contains("both angle_scale and area_scale are given"), "{both}");
    for torque in [
        "points = [[0, 60], [180, 240], [360, 60]]\n",
        "mean = 1\nharmonics = [{ order = 2, sin = 1 }]\n",
        "triangles = [{ width = 180, peak = 3 }]\n",
        "triangles = [{ width = 180, area = '3 J' }]\n",
        "areas = ['12 J', '-12 J']\n",
    ] {
        for (scales, key) in [(sides, "torque_scale"), (area, "area_scale"), ("angle_scale = '1°/mm'\n", "angle_scale")]
        {
            let told = told(&format!("{scales}{torque}"));
            let words = format!("{key} without an area that it measures");
            assert!(told.contains(&words) && told.contains("toml:1:"), "{told}");
        }
    }
}

#[test]
fn the_command_shows_the_exact_values_and_its_tables() {
    let out = call(&["flywheel", concat!(env!("CARGO_MANIFEST_DIR"), "/examples/turning-moment.toml"), "--json"]);
    let json: serde_json::Value = serde_json::from_slice(&out.stdout).expect("JSON");
    assert_eq!(json["values"]["energy_exact"], "π·(244205/192)");
    assert!(matches!(diagram(TRIANGLES).torque, Torque::Lines(lines) if lines.len() == 8));
    let study = FlywheelStudy::new(diagram(TRIANGLES)).expect("it fits");
    let page = crankstar::page::write(&study.page(), Format::PLAIN, &Options::default()).remove(0).text;
    assert!(page.contains("237.5 N·m") && page.contains("3996 J"), "{page}");
}

#[test]
fn a_value_at_a_step_says_on_which_side_it_is() {
    let page = |angle: u32| {
        let points = "[[0, 300], [45, 2400], [45, -1000], [180, 0], [360, 0]]";
        said("flywheel", &format!("title = 'x'\npoints = {points}\nangles = [{angle}]\n"), &["--format", "markdown"])
    };
    let words = "At a step, torque and load are the values just after it.";
    for (angle, is_said) in [(45, true), (405, true), (0, true), (90, false), (180, false)] {
        assert_eq!(page(angle).contains(words), is_said, "at {angle}: {}", page(angle));
    }
}
