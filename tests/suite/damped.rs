//! Does a shaft with damping vibrate as textbooks, class rules and integration in time have it?
//!
//! The digits are those of a complex Holzer table with 30 places, and of an integration of the constraints for gears.

use crankstar::engine::{CycleOrder, Engine};
use crankstar::file;
use crankstar::page::Format;
use crankstar::report::{Question, TorsionStudy};
use crankstar::torsion::{
    DamperSetting, Excitation, StressLimit, Train, barred, forced_twist, formula, half_range, heat, highest, modes,
    search, shaft_torques,
};
use num_complex::Complex;

use crate::support::dice::Dice;
use crate::support::pages;
use crate::torsion::said_in_german;

pub const MARINE: &str = include_str!("../../reports/examples/marine-six-torsion/layout.toml");
pub const AUTOMOTIVE: &str = include_str!("../../reports/examples/i6-damper/layout.toml");

fn engine(layout: &str) -> Engine {
    file::parse("six.toml", layout).unwrap_or_else(|error| panic!("{error}"))
}

fn study(layout: &str) -> TorsionStudy {
    TorsionStudy::new(&engine(layout), &[]).expect("a shaft that fires")
}

/// To as many digits as the right one is printed with.
fn assert_prints(found: f64, right: &str) {
    let places = right.split_once('.').map_or(0, |(_, places)| places.len());
    let value: f64 = right.parse().expect("a number");
    assert!((found - value).abs() <= 1.01 * 10f64.powi(-(places as i32)), "{found} for {right}");
}

fn order(halves: u32) -> CycleOrder {
    CycleOrder::of_halves(halves).expect("an order")
}

#[test]
fn a_marine_shaft_has_the_frequencies_node_and_amplitudes_of_the_complex_table() {
    let study = study(MARINE);
    assert_prints(study.modes[0].mode.hertz(), "7.02163732");
    assert_prints(study.modes[1].mode.hertz(), "24.800973");
    assert_eq!(format!("{:?}", study.modes[0].mode.nodes).split(',').next(), Some("[Shaft(6"));
    let crankstar::torsion::Node::Shaft(6, part) = study.modes[0].mode.nodes[0] else { panic!("in the last shaft") };
    assert_prints(part, "0.23482715");
    for (speed, first, torque, stress) in [
        (40.0, "8.77442287", "160.188892", "12.747427"),
        (70.216_373_2, "20.3627846", "1289.82725", "102.641192"),
        (90.0, "4.63743262", "171.849402", "13.675340"),
    ] {
        let vibration = study.vibration(speed).expect("a vibration");
        assert_eq!(vibration.orders.len(), 1);
        assert_prints(1e3 * vibration.twist(0), first);
        assert_prints(1e-3 * vibration.torque(6), torque);
        assert_prints(1e-6 * study.stress(6, vibration.torque(6)).expect("a section"), stress);
    }
}

#[test]
fn the_energy_method_is_near_the_resonance_and_the_peak_is_beside_it() {
    let study = study(MARINE);
    let [sixth] = study.resonances() else { panic!("one order, one mode in the range") };
    assert_prints(sixth.rpm, "70.2163732");
    assert_prints(1e3 * sixth.energy.amplitude, "19.351506");
    assert_prints(1e3 * sixth.energy.equilibrium, "1.648863");
    assert_prints(sixth.energy.magnifier().expect("it works on the mode"), "11.736");
    let (speed, torque) = sixth.peak.expect("a peak");
    assert_prints(1e-3 * torque, "1291.400681");
    assert!((speed - 70.0686).abs() < 2e-4, "{speed}");
    assert_eq!(sixth.shaft, 6);
    let shape = &study.modes[0].mode.shape;
    let by_energy = sixth.energy.amplitude * study.train.links[6].stiffness * (shape[6] - shape[7]).abs();
    assert_prints(1e-3 * by_energy, "1284.342");
}

#[test]
fn the_class_formula_gives_limits_barred_range_and_the_speeds_above_the_limit() {
    let study = study(MARINE);
    let limit: StressLimit = study.limit(6).expect("a steel");
    assert_prints(limit.size, "0.630589199");
    let lambda = study.resonances()[0].rpm / 127.0;
    assert_prints(1e-6 * limit.continuous(lambda).expect("below 1.05"), "60.249941");
    assert_prints(1e-6 * limit.transient(lambda).expect("below 0.8"), "102.424900");
    assert_eq!((limit.transient(0.8), limit.continuous(1.051)), (None, None));
    let range = study.resonances()[0].barred.as_ref().expect("the stress is larger than permitted");
    assert!(range.suffices);
    let [from, to] = range.speeds;
    assert_prints(from, "64.392420");
    assert_prints(to, "76.567072");
    assert_eq!([from, to], barred(study.resonances()[0].rpm, 127.0));
    let [excess] = study.excesses() else { panic!("one shaft, one range") };
    assert_prints(excess.speeds[0], "66.011105");
    assert_prints(excess.speeds[1], "74.291051");
}

/// The end of the range of speeds cuts the excess off, 0.3 rpm after its begin.
#[test]
fn a_narrow_range_of_speeds_has_two_ends_on_the_page() {
    let study = study(&MARINE.replace("\"127 rpm\"]", "\"66.3 rpm\"]"));
    for document in said_in_german(&study) {
        let text = pages::text(&document, Format::PLAIN).split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains("for continuous running from 66.01 rpm to 66.30 rpm"), "{text}");
    }
}

/// `16 M / π d³` at the peak of order 6 is 102.8 MPa; τ_T there 102.5 MPa of a steel of 560 MPa, and 108.2 of one of 600.
#[test]
fn a_range_is_no_cure_where_the_stress_in_it_is_too_large_to_pass_through() {
    for (strength, is_cure) in [("560 MPa", false), ("600 MPa", true)] {
        let study =
            study(&MARINE.replace("tensile_strength = \"560 MPa\"", &format!("tensile_strength = '{strength}'")));
        let [page, answer] = said_in_german(&study);
        for document in [page, answer] {
            let text = pages::text(&document, Format::PLAIN).split_whitespace().collect::<Vec<_>>().join(" ");
            assert_eq!(text.contains("its formula bars 64.4"), is_cure, "{text}");
            let told = "a barred range is no cure: at 70.1 rpm the stress in shaft 7–8 is ≈ 102.8 MPa, and ≈ 102.5 MPa is permitted";
            assert_eq!(text.contains(told), !is_cure, "{text}");
        }
        let text = pages::text(&study.page(), Format::GITHUB);
        assert_eq!(text.contains("Barred"), is_cure, "{text}");
    }
}

#[test]
fn no_range_is_barred_from_four_fifths_of_the_rated_speed_on() {
    for (rated, may_be_barred) in [("88 rpm", true), ("87 rpm", false)] {
        let study = study(&MARINE.replace("rated_speed = \"127 rpm\"", &format!("rated_speed = \"{rated}\"")));
        let [sixth] = study.resonances() else { panic!("one order, one mode in the range") };
        assert_eq!((sixth.barred.is_some(), sixth.is_unbarred), (may_be_barred, !may_be_barred), "{rated}");
        let text = pages::text(&study.page(), Format::GITHUB);
        assert_eq!(text.contains("no range may be barred.\n"), !may_be_barred, "{text}");
    }
}

/// A marine five whose order 5 exceeds the limit far beyond the range that the formula bars around order 6.
const FIVE: &str = "speed = 110\ncycle = 'two-stroke'\nfiring_order = '1-4-3-2-5'\n[inline]\nspacing = '0.9 m'\n[torsion]\n\
    inertias = [4200, 4200, 4200, 4200, 4200, 5200, 11000]\n\
    stiffnesses = ['520 MN m/rad', '520 MN m/rad', '520 MN m/rad', '520 MN m/rad', '700 MN m/rad']\n\
    dampings = [0, 0, 0, 0, 0, 0, '45 kN m s/rad']\nloss_factor = 0.015\nrated_speed = 110\nspeed_range = [35, 110]\n\
    [[torsion.shaft]]\nbetween = [6, 7]\nlength = '11 m'\nshear_modulus = '81 GPa'\nouter_diameter = '420 mm'\n\
    tensile_strength = '600 MPa'\nsteel = 'carbon'\nshape_factor = 0.55\n\
    [[torsion.harmonic]]\norder = 5\ntorque = '100 kN m'\nphase = 0\n[[torsion.harmonic]]\norder = 6\ntorque = '40 kN m'\nphase = 0\n";

#[test]
fn a_range_is_barred_only_where_the_limit_holds_again_at_its_ends() {
    let study = study(FIVE);
    let sixth = study.resonances().iter().find(|one| one.order == order(12)).expect("order 6 in the range");
    let range = sixth.barred.as_ref().expect("the stress is larger than permitted");
    let exceeds = |speed: f64| {
        let torque = study.vibration(speed).expect("a vibration").torque(5);
        study.stress(5, torque) > study.permissible(5, speed)
    };
    assert_eq!(range.speeds.map(exceeds), [false, true]);
    assert!(!range.suffices);
    assert_eq!(range.largest_part, order(10));
    let [_, answer] = said_in_german(&study);
    let text = pages::text(&answer, Format::PLAIN);
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains("does not suffice: the stress exceeds the limit from"), "{text}");
    assert!(text.contains("The order with the largest part at that critical speed is 5."), "{text}");
    assert!(!text.contains("its formula bars"), "{text}");
}

#[test]
fn the_strongest_resonance_is_told_at_its_peak_where_that_is_in_the_range() {
    let layout = AUTOMOTIVE.replace("loss_factor", "speed_range = [1000, 8000]\nloss_factor");
    let study = study(&layout);
    let [one] = study.resonances() else { panic!("one order, one mode in the range") };
    let (speed, torque) = one.peak.expect("a peak");
    assert_eq!((one.largest.rpm, one.largest.torque), (speed, torque));
    assert!(torque > 1.001 * one.torque, "{torque} {}", one.torque);
    let [_, answer] = said_in_german(&study);
    let text = pages::text(&answer, Format::PLAIN);
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        text.contains(&format!("order 4½ has the highest peak inside the range, at {speed:.0} rpm: {torque:.0} N·m")),
        "{text}"
    );
}

#[test]
fn stars_are_compared_up_to_the_end_of_the_range_where_one_is_given() {
    let layout = AUTOMOTIVE.replace("loss_factor", "speed_range = [1000, 8000]\nloss_factor");
    let text = pages::text(&study(&layout).answer(), Format::PLAIN);
    assert!(text.contains("Up to 8000 rpm no order shown has a longer star"), "{text}");
    let text = pages::text(&study(AUTOMOTIVE).answer(), Format::PLAIN);
    assert!(text.contains("Up to 6000 rpm no order shown has a longer star"), "{text}");
}

#[test]
fn a_length_makes_a_stiffness() {
    let layout = |bore: &str| {
        format!(
            "cycle = \"four-stroke\"\nfiring_order = \"1-2\"\n[inline]\nthrows = [0, 0]\n[torsion]\ninertias = [1, 1]\n\
             [[torsion.shaft]]\nbetween = [1, 2]\nlength = \"1 m\"\nouter_diameter = \"100 mm\"\n{bore}shear_modulus = \"80 GPa\"\n"
        )
    };
    let stiffness = |bore| study(&layout(bore)).train.links[0].stiffness;
    assert_prints(stiffness(""), "785398.1634");
    assert_prints(stiffness("inner_diameter = \"50 mm\"\n"), "736310.7782");
}

#[test]
fn a_six_with_a_viscous_ring_has_the_optimum_amplitudes_and_heat_of_the_table() {
    let study = study(AUTOMOTIVE);
    assert_prints(study.modes[0].mode.hertz(), "269.337708");
    let [damper] = study.dampers() else { panic!("one damper") };
    assert_prints(0.02 / damper.in_mode.mass_ratio, "0.116316797");
    assert_prints(damper.in_mode.best.damping, "30.0015864");
    assert_eq!(damper.setting.damping, damper.in_mode.best.damping);
    let found = damper.found.as_ref().expect("a torque");
    assert_eq!(found.order, order(9));
    assert_prints(found.without.expect("the shafts damp too"), "17201.17");
    assert_prints(found.peaks[1], "1927.2970");
    assert_prints(found.peaks[0], "1927.2938");
    assert!((found.best.damping - 29.9464).abs() < 2e-3, "{:?}", found.best);
    let resonances = study.resonances();
    let (speed, torque) = resonances[0].peak.expect("a peak");
    assert_prints(torque, "1927.2970");
    assert!((speed * 4.5 / 60.0 - 258.8525).abs() < 2e-3, "{speed}");
    let vibration = study.vibration(3200.0).expect("240 Hz");
    let right = [
        "2.746024353",
        "3.893684961",
        "3.453411150",
        "2.689513826",
        "1.654122091",
        "0.594108635",
        "0.420079694",
        "1.321195060",
    ];
    // The ring is the last disc.
    for (disc, right) in [7, 0, 1, 2, 3, 4, 5, 6].into_iter().zip(right) {
        assert_prints(1e3 * vibration.twist(disc), right);
    }
    let heat = vibration.heat();
    assert_prints(heat.total(), "296.26131");
    assert_prints(heat.links[6], "259.93154");
    assert_prints(heat.links[..6].iter().sum(), "36.32977");
}

#[test]
fn gears_and_branches_have_the_frequencies_of_the_constraints() {
    let layout = "cycle = \"four-stroke\"\nfiring_order = \"1\"\n[inline]\nthrows = [0]\n\
                  [torsion]\ninertias = [20, 1, 30, 400, 0.5, 6]\nstiffnesses = [\"0.5 MN m/rad\"]\n\
                  [[torsion.gear]]\nbetween = [2, 3]\nratio = \"-1/3\"\n[[torsion.gear]]\nbetween = [2, 5]\nratio = 2\n\
                  [[torsion.shaft]]\nbetween = [3, 4]\nstiffness = \"4 MN m/rad\"\n\
                  [[torsion.shaft]]\nbetween = [5, 6]\nstiffness = \"0.1 MN m/rad\"\n";
    let study = study(layout);
    let found: Vec<f64> = study.modes.iter().map(|speeds| speeds.mode.hertz()).collect();
    assert_eq!(found.len(), 3);
    for (found, right) in found.into_iter().zip(["18.0716056", "23.0771856", "76.3329911"]) {
        assert_prints(found, right);
    }
    // Discs in mesh move in the ratio of the gear.
    for speeds in &study.modes {
        let shape = &speeds.mode.shape;
        assert!((shape[2] + shape[1] / 3.0).abs() < 1e-12 && (shape[4] - 2.0 * shape[1]).abs() < 1e-12);
    }
}

/// A mass on a spring: the other disc is so heavy that it stands still. The peak of the torque over the torque at rest.
fn peak_over_static(train: &Train) -> f64 {
    let torque = |omega: f64| {
        let excitation = Excitation { omega, torques: vec![Complex::default(), Complex::from(1.0)] };
        shaft_torques(train, omega, &forced_twist(train, &excitation))[0].norm()
    };
    highest(0.5, 1.5, 200, &torque).1
}

/// `J = k = 1`, so that ω₁ = 1, and a ring of inertia μ.
fn on_a_wall(mu: f64) -> (Train, f64) {
    let layout = format!(
        "cycle = \"four-stroke\"\nfiring_order = \"1-2\"\n[inline]\nthrows = [0, 0]\n[torsion]\ninertias = [1e14, 1]\n\
         stiffnesses = [1]\n[[torsion.damper]]\ndisc = 2\ninertia = {mu}\nstiffness = 1\ndamping = 1\n"
    );
    (study(&layout).train, mu)
}

/// J. P. Den Hartog, Mechanical Vibrations, chapter 3.
#[test]
fn the_best_dampers_are_those_of_the_formulas_or_a_little_better() {
    for (mu, fixed, at_formula, least) in
        [(0.1, "4.582576", "4.590220", "4.589165"), (0.2, "3.316625", "3.327539", "3.325439")]
    {
        let (zeta, f, peak) = formula(mu, true);
        assert_prints(peak, fixed);
        let (mut train, ring) = on_a_wall(mu);
        (train.links[1].stiffness, train.links[1].damping) = (ring * f * f, 2.0 * ring * zeta);
        assert_prints(peak_over_static(&train), at_formula);
        let start = crankstar::torsion::DamperSetting { stiffness: ring * f * f, damping: 2.0 * ring * zeta };
        assert_prints(search(&train, 1, start, &peak_over_static).1, least);
        let (zeta, _, peak) = formula(mu, false);
        let (mut train, ring) = on_a_wall(mu);
        (train.links[1].stiffness, train.links[1].damping) = (0.0, 2.0 * ring * zeta);
        let found = peak_over_static(&train);
        assert!((found - peak).abs() < 1e-6 * peak, "{found} for {peak}");
        let start = crankstar::torsion::DamperSetting { stiffness: 0.0, damping: 2.0 * ring * zeta };
        let (best, least) = search(&train, 1, start, &peak_over_static);
        assert!((least - peak).abs() < 2e-6 * peak && (best.damping / start.damping - 1.0).abs() < 1e-2);
        let at = highest(0.5, 1.5, 200, &|g: f64| {
            let excitation = Excitation { omega: g, torques: vec![Complex::default(), Complex::from(1.0)] };
            forced_twist(&train, &excitation)[1].norm()
        });
        assert!((at.0 * at.0 - 2.0 / (2.0 + mu)).abs() < 1e-4, "{at:?}");
    }
}

/// From which disc to which, with which stiffness and damping.
type Links = Vec<(usize, usize, f64, f64)>;

/// A random tree with viscous damping, in the words of a layout file, and its matrices.
fn random_train(dice: &mut Dice) -> (String, Vec<f64>, Vec<f64>, Links) {
    let mut random = |low: f64, high: f64| (low + (high - low) * dice.below(1000) as f64 / 1000.0).max(low);
    let count = 3 + (random(0.0, 4.0) as usize);
    let inertias: Vec<f64> = (0..count).map(|_| random(0.5, 3.0)).collect();
    let dampings: Vec<f64> = (0..count).map(|_| random(0.2, 1.0)).collect();
    let mut text = format!("[torsion]\ninertias = {inertias:?}\ndampings = {dampings:?}\n");
    let mut links = Vec::new();
    for disc in 1..count {
        let (from, stiffness, damping) =
            (random(0.0, disc as f64 - 0.01) as usize, random(20.0, 60.0), random(0.1, 1.0));
        text += &format!(
            "[[torsion.shaft]]\nbetween = [{}, {}]\nstiffness = {stiffness:?}\ndamping = {damping:?}\n",
            from + 1,
            disc + 1
        );
        links.push((from, disc, stiffness, damping));
    }
    (text, inertias, dampings, links)
}

#[test]
fn random_trees_vibrate_as_their_integration_in_time() {
    let mut dice = Dice::new(30);
    for _ in 0..8 {
        let (text, inertias, dampings, links) = random_train(&mut dice);
        let layout = format!("cycle = \"four-stroke\"\nfiring_order = \"1\"\n[inline]\nthrows = [0]\n{text}");
        let train = study(&layout).train;
        let omega = 1.0 + dice.below(80) as f64 / 10.0;
        let count = inertias.len();
        let torques: Vec<Complex<f64>> =
            (0..count).map(|_| Complex::from_polar(1.0, dice.below(628) as f64 / 100.0)).collect();
        let twist = forced_twist(&train, &Excitation { omega, torques: torques.clone() });
        // Newton's law of each disc, by Runge and Kutta, until the start is forgotten.
        let acceleration = |time: f64, at: &[f64], speed: &[f64]| -> Vec<f64> {
            let mut sum: Vec<f64> = (0..count)
                .map(|disc| (torques[disc] * Complex::cis(omega * time)).re - dampings[disc] * speed[disc])
                .collect();
            for &(from, to, stiffness, damping) in &links {
                let torque = stiffness * (at[from] - at[to]) + damping * (speed[from] - speed[to]);
                sum[from] -= torque;
                sum[to] += torque;
            }
            sum.iter().zip(&inertias).map(|(torque, inertia)| torque / inertia).collect()
        };
        let (mut at, mut speed, mut time) = (vec![0.0; count], vec![0.0; count], 0.0);
        let steps_in_period = 600;
        let step = std::f64::consts::TAU / omega / f64::from(steps_in_period);
        let plus = |one: &[f64], other: &[f64], part: f64| -> Vec<f64> {
            one.iter().zip(other).map(|(one, other)| one + part * other).collect()
        };
        let mut advance = |at: &mut Vec<f64>, speed: &mut Vec<f64>| {
            let a1 = acceleration(time, at, speed);
            let (x2, v2) = (plus(at, speed, step / 2.0), plus(speed, &a1, step / 2.0));
            let a2 = acceleration(time + step / 2.0, &x2, &v2);
            let (x3, v3) = (plus(at, &v2, step / 2.0), plus(speed, &a2, step / 2.0));
            let a3 = acceleration(time + step / 2.0, &x3, &v3);
            let (x4, v4) = (plus(at, &v3, step), plus(speed, &a3, step));
            let a4 = acceleration(time + step, &x4, &v4);
            for disc in 0..count {
                at[disc] += step / 6.0 * (speed[disc] + 2.0 * v2[disc] + 2.0 * v3[disc] + v4[disc]);
                speed[disc] += step / 6.0 * (a1[disc] + 2.0 * a2[disc] + 2.0 * a3[disc] + a4[disc]);
            }
            time += step;
        };
        let periods = (300.0 * omega / std::f64::consts::TAU).ceil() as usize;
        for _ in 0..periods * steps_in_period as usize {
            advance(&mut at, &mut speed);
        }
        // The train may have turned as a whole by then: twists between its ends, and speeds.
        let scale = twist.iter().map(|twist| twist.norm()).fold(0.0, f64::max);
        for &(from, to, ..) in &links {
            let right = (twist[from] - twist[to]).re;
            assert!((at[from] - at[to] - right).abs() < 1e-6 * scale, "{} for {right}", at[from] - at[to]);
        }
        for disc in 0..count {
            let right = (twist[disc] * Complex::new(0.0, omega)).re;
            assert!((speed[disc] - right).abs() < 1e-6 * scale * omega, "{} for {right}", speed[disc]);
        }
        let put_in: f64 = torques
            .iter()
            .zip(&twist)
            .map(|(torque, twist)| 0.5 * (torque * (twist * Complex::new(0.0, omega)).conj()).re)
            .sum();
        let heat = heat(&train, omega, &twist).total();
        assert!((heat - put_in).abs() < 1e-9 * heat.abs(), "{heat} of {put_in}");
    }
}

/// Half of the largest less the smallest of many values through a cycle.
fn half_range_of(sum: impl Fn(f64) -> f64) -> f64 {
    let values = (0..200_000).map(|index| sum(f64::from(index) * std::f64::consts::TAU / 200_000.0));
    let (low, high) = values.fold((f64::MAX, f64::MIN), |(low, high), value| (low.min(value), high.max(value)));
    0.5 * (high - low)
}

#[test]
fn half_the_range_of_orders_is_that_of_their_sum() {
    let both = [(order(2), Complex::from(3.0)), (order(4), Complex::new(0.0, 2.0))];
    let sum = |theta: f64| 3.0 * theta.cos() - 2.0 * (2.0 * theta).sin();
    assert!((half_range(&both) - half_range_of(sum)).abs() < 1e-8);
    assert_eq!(half_range(&[(order(3), Complex::new(3.0, 4.0))]), 5.0);
}

#[test]
fn half_the_range_is_found_where_many_tops_are_nearly_alike() {
    for [first, second] in [[-117.0_f64, 124.0], [30.0, 75.0], [0.0, 10.0], [200.0, 303.0], [77.0, -12.0]] {
        // Orders 12 and 23/2 beat once in two turns: their tops near each other are nearly alike.
        let [v, w] = [first, second].map(|degrees| 100.0 * Complex::cis(degrees.to_radians()));
        let both = [(order(24), v), (order(23), w)];
        let sum = |half: f64| (v * Complex::cis(24.0 * half) + w * Complex::cis(23.0 * half)).re;
        let (range, right) = (half_range(&both), half_range_of(sum));
        assert!((range - right).abs() < 1e-4, "{first} {second}: {range} {right}");
    }
}

#[test]
fn modes_of_random_trees_satisfy_their_equations() {
    let mut dice = Dice::new(31);
    for _ in 0..40 {
        let (text, inertias, _, links) = random_train(&mut dice);
        let layout = format!("cycle = \"four-stroke\"\nfiring_order = \"1\"\n[inline]\nthrows = [0]\n{text}");
        let found = modes(&study(&layout).train);
        assert_eq!(found.len(), inertias.len() - 1);
        for mode in found {
            let mut residual: Vec<f64> =
                mode.shape.iter().zip(&inertias).map(|(one, inertia)| mode.omega.powi(2) * inertia * one).collect();
            let size = residual.iter().fold(0.0_f64, |most, one| most.max(one.abs()));
            for &(from, to, stiffness, _) in &links {
                let torque = stiffness * (mode.shape[from] - mode.shape[to]);
                residual[from] -= torque;
                residual[to] += torque;
            }
            assert!(residual.iter().all(|one| one.abs() < 1e-9 * size), "{residual:?}");
        }
    }
}

#[test]
fn what_cannot_damp_is_refused_at_its_place() {
    let head = "cycle = \"four-stroke\"\nfiring_order = \"1-2\"\n[inline]\nthrows = [0, 0]\n[torsion]\n";
    let two = "inertias = [1, 1]\nstiffnesses = [1]\n";
    for (keys, words, line) in [
        (format!("{two}dampings = [0, -1]\n"), "cannot read the damping `-1`", 8),
        (format!("{two}dampings = [0]\n"), "1 damping for 2", 8),
        (format!("{two}loss_factor = -0.1\n"), "loss factor is 0 or more", 8),
        (format!("{two}[[torsion.shaft]]\nbetween = [1, 2]\nloss_factor = -3\n"), "loss factor is 0 or more", 10),
        (format!("{two}loss_factor = 0.1\nmagnifier = 10\n"), "a loss factor and a magnifier", 9),
        (format!("{two}[[torsion.shaft]]\nbetween = [1, 2]\ndamping = -3\n"), "damping is 0 or more", 10),
        (format!("{two}[[torsion.shaft]]\nbetween = [2, 1]\nstiffness = 3\n"), "written before", 9),
        (format!("{two}[[torsion.shaft]]\nbetween = [1, 3]\nstiffness = 3\n"), "shaft 2 is at disc 3; there are 2", 8),
        ("inertias = [1, 1, 1]\nstiffnesses = [1]\n".to_owned(), "3 discs in a row need 2", 7),
        ("inertias = [1, 1, 1]\nstiffnesses = [1, 1]\n[[torsion.shaft]]\nbetween = [1, 3]\nstiffness = 3\n".to_owned(), "may close no ring", 8),
        ("inertias = [1, 1, 1, 1]\n[[torsion.gear]]\nbetween = [1, 2]\nratio = 2\n[[torsion.shaft]]\nbetween = [3, 4]\nstiffness = 3\n".to_owned(), "joins disc 3 to the first", 6),
        ("inertias = [1, 1]\n[[torsion.gear]]\nbetween = [1, 2]\nratio = 0\n".to_owned(), "ratio of 0", 9),
        ("inertias = [1, 1]\n[[torsion.gear]]\nbetween = [1, 2]\nratio = 2\n".to_owned(), "crankpin 2 is on disc 2, which gears turn", 6),
        ("inertias = [1, 1]\n[[torsion.shaft]]\nbetween = [1, 2]\nlength = 1\nouter_diameter = 0.1\n".to_owned(), "shear modulus", 9),
        ("inertias = [1, 1]\n[[torsion.shaft]]\nbetween = [1, 2]\nlength = 1\nshear_modulus = \"80 GPa\"\n".to_owned(), "without a diameter", 9),
        ("inertias = [1, 1]\n[[torsion.shaft]]\nbetween = [1, 2]\nstiffness = 1\nouter_diameter = 0.1\ninner_diameter = 0.1\n".to_owned(), "bore of shaft 1", 7),
        ("inertias = [1, 1]\n[[torsion.shaft]]\nbetween = [1, 2]\n".to_owned(), "without a stiffness", 8),
        (format!("{two}[[torsion.shaft]]\nbetween = [1, 2]\ntensile_strength = \"560 MPa\"\n"), "needs three keys", 10),
        (format!("{two}[[torsion.damper]]\ndisc = 3\ninertia = 1\ndamping = 1\n"), "damper 1 is at disc 3", 9),
        (format!("{two}[[torsion.damper]]\ndisc = 1\ninertia = 0\ndamping = 1\n"), "above 0", 10),
        (format!("{two}[[torsion.damper]]\ndisc = 1\ninertia = 1\ndamping = 1\nstiffness = 0\n"), "above 0", 12),
        (format!("{two}[[torsion.damper]]\ndisc = 1\ninertia = 1\ndamping = -1\n"), "damping is 0 or more", 11),
        (format!("{two}[[torsion.damper]]\ndisc = 1\ninertia = 1\ndamping = \"good\"\n"), "damping `good`", 11),
        (format!("{two}[[torsion.damper]]\ndisc = 1\ninertia = 1\ndamping = \"bst\"\n"), "or \"best\"", 11),
        (format!("{two}[[torsion.damper]]\ndisc = 1\ninertia = 1\ndamping = 1\nstiffness = \"bst\"\n"), "or \"best\"", 12),
        (format!("{two}[[torsion.harmonic]]\norder = 1\ntorque = 1\n[[torsion.harmonic]]\norder = 2\ntorque = 1\n"), "has no phase", 8),
        (format!("{two}[[torsion.harmonic]]\norder = 1\ntorque = 0\n"), "above 0", 10),
        (format!("{two}speed_range = [3, 2]\n"), "does not rise", 8),
    ] {
        let error = file::parse("two.toml", &format!("{head}{keys}")).expect_err(&keys).to_string();
        assert!(error.contains(words), "{keys}: {error}");
        assert!(error.contains(&format!(":{line}:")), "line {line}: {error}");
    }
}

pub const TREE: &str = "cycle = \"four-stroke\"\nfiring_order = \"1\"\n[inline]\nthrows = [0]\n\
                    [torsion]\ninertias = [20, 1, 30, 400]\nstiffnesses = [\"0.5 MN m/rad\"]\nspeed_range = [100, 2000]\n\
                    [[torsion.gear]]\nbetween = [2, 3]\nratio = \"-1/3\"\n\
                    [[torsion.shaft]]\nbetween = [3, 4]\nstiffness = \"4 MN m/rad\"\ndamping = 100\n\
                    [[torsion.harmonic]]\norder = \"1/2\"\ntorque = 100\nphase = 0\n\
                    [[torsion.harmonic]]\norder = 1\ntorque = 50\nphase = 30\n";

#[test]
fn pages_and_tables_of_damped_trains_say_what_was_computed_in_both_languages() {
    let marine = study(MARINE);
    let six = study(AUTOMOTIVE);
    let tree = study(TREE).at(600.0);
    let [page, answer] = said_in_german(&marine);
    let text = pages::text(&page, Format::GITHUB);
    for words in ["102.8", "102.5", "66.0", "1291401", "0.2348"] {
        assert!(text.contains(words), "{words}: {text}");
    }
    assert!(!text.contains("complies") && pages::text(&answer, Format::PLAIN).contains("1291 kN·m in shaft 7–8"));
    let [page, _] = said_in_german(&six);
    let text = pages::text(&page, Format::GITHUB);
    assert!(text.contains("ring of damper 1") && text.contains("The firing star is zero at order 4½"), "{text}");
    let [page, _] = said_in_german(&tree);
    assert!(pages::text(&page, Format::GITHUB).contains("tree of rigid discs"));
    for study in [marine, six, tree] {
        let json: serde_json::Value = serde_json::from_str(&study.json().expect("JSON")).expect("JSON");
        assert!(json["shafts"][0]["torque_half_range_N_m"].as_f64().is_some_and(|torque| torque > 0.0), "{json}");
        assert!(json["heat"].as_array().is_some_and(|places| !places.is_empty()));
    }
}

#[test]
fn a_shaft_without_damping_or_without_torque_is_told_so() {
    let undamped = MARINE.replace("loss_factor = 0.02\n", "").replace("\"60 kN m s/rad\"", "0");
    let answer = study(&undamped).answer();
    assert!(pages::text(&answer, Format::PLAIN).contains("at a critical speed the amplitude is infinite"));
    let silent = MARINE.split("[[torsion.harmonic]]").next().expect("a text").to_owned();
    let answer = study(&silent).answer();
    assert!(pages::text(&answer, Format::PLAIN).contains("No amplitudes: they need the torque"));
}

/// `Σ J Θ = −Σ t / Ω²` on a free shaft: zero where the star is, though the discs move.
#[test]
fn an_order_whose_star_is_zero_twists_the_shaft_and_does_not_roll_it() {
    let study = study(AUTOMOTIVE);
    let vibration = study.vibration(3200.0).expect("240 Hz");
    let twists = &vibration.orders[0].twists;
    let sum: Complex<f64> = study.train.discs.iter().zip(twists).map(|(disc, twist)| twist * disc.inertia).sum();
    let size: f64 = study.train.discs.iter().zip(twists).map(|(disc, twist)| twist.norm() * disc.inertia).sum();
    assert!(sum.norm() < 1e-12 * size && vibration.torque(5) > 1.0);
}

/// Mirror images 360° apart in a mirror-symmetric chain: whole orders leave antisymmetric modes still, half orders symmetric ones.
#[test]
fn a_mirror_symmetric_crank_is_twisted_by_whole_orders_symmetrically() {
    let layout = "cycle = \"four-stroke\"\nfiring_order = \"1-5-3-6-2-4\"\nspeed = 3000\n[inline]\n\
                  throws = [0, 240, 120, 120, 240, 0]\n[torsion]\ninertias = [1, 2, 3, 3, 2, 1]\nstiffnesses = [7e5, 8e5, 9e5, 8e5, 7e5]\n\
                  loss_factor = 0.05\n[[torsion.harmonic]]\norder = \"3/2\"\ntorque = 3\nphase = 0\n\
                  [[torsion.harmonic]]\norder = 4\ntorque = 2\nphase = 0\n";
    let damped = study(layout);
    let vibration = damped.at_speed().expect("a vibration");
    for (order, sign) in vibration.orders.iter().zip([-1.0, 1.0]) {
        let size = order.twists[0].norm();
        for disc in 0..3 {
            let mirror = order.twists[5 - disc] * sign;
            assert!((order.twists[disc] - mirror).norm() < 1e-12 * size.max(1e-30), "{}", order.order);
        }
    }
}

const STILL_RADIAL: &str = "cycle = 'four-stroke'\nfiring_order = '1-3-5-7-9-2-4-6-8'\nspeed = 2200\n[radial]\ncylinders = 9\n[mechanism]\n\
    stroke = '140 mm'\nrod_length = '270 mm'\nreciprocating_mass = '2.5 kg'\n[gas]\nbore = '140 mm'\nprocess = 'spark-ignition'\n\
    compression_ratio = 6.5\nmean_pressure = '9 bar'\n[torsion]\ninertias = [0.6, 12]\nstiffnesses = ['130 kN m/rad']\nloss_factor = 0.02\n";

/// A radial excites only orders 4½, 9, 13½ and 18 of those up to 24: all others are 0 and no roundings.
#[test]
fn an_order_that_cancels_on_each_disc_twists_nothing_and_is_no_resonance() {
    let study = study(STILL_RADIAL);
    let orders: Vec<String> = study.resonances().iter().map(|one| one.order.to_string()).collect();
    assert_eq!(orders, ["4½", "9", "13½", "18"]);
    let lives = |order: CycleOrder| order.halves().is_multiple_of(9);
    for one in &study.at_speed().expect("a vibration").orders {
        let values = one.twists.iter().chain(&one.torques);
        assert!(values.clone().all(|value| lives(one.order) != (value.norm() == 0.0)), "{}", one.order);
    }
    for one in &study.modes[0].orders {
        assert_eq!((one.vanishes, one.star.norm() == 0.0), (!lives(one.order), !lives(one.order)));
    }
    let page = pages::text(&study.page(), pages::DOLLARS);
    assert!(page.contains("| 4 | ≈\u{a0}146.7 | **0** | **0** |"), "{page}");
    // Up to 180 rpm no order that is left meets the mode.
    let low = format!("{STILL_RADIAL}speed_range = [100, 180]\n");
    let answer = pages::text(&self::study(&low).answer(), Format::PLAIN);
    assert!(
        answer.contains("No order shown excites the first of them up to 180") && !answer.contains("0 orders of"),
        "{answer}"
    );
    assert!(!answer.contains("highest peak"), "{answer}");
}

/// Two cylinders on discs in mesh: order 1 cancels between them, so that the teeth are loaded and no shaft is.
#[test]
fn what_discs_in_mesh_cancel_loads_the_teeth_alone() {
    let layout = "cycle = 'two-stroke'\nfiring_angles = [0, 180]\nspeed = 3000\n[u]\nsense = 'against'\ndistance = 3\nthrows = [0]\n\
        phase = 180\n[torsion]\ninertias = [0.02, 0.02, 0.3]\ncrankpins_at = [1, 2]\nloss_factor = 0.02\nstiffnesses = []\n\
        [[torsion.gear]]\nbetween = [1, 2]\nratio = -1\n[[torsion.shaft]]\nbetween = [2, 3]\nstiffness = 100000\n\
        [[torsion.harmonic]]\norder = 1\ntorque = 100\n";
    let geared = study(layout);
    let one = &geared.at_speed().expect("a vibration").orders[0];
    assert!(one.twists.iter().chain(&one.torques).all(|value| value.norm() == 0.0));
    assert!((one.meshes[0].norm() - 100.0).abs() < 1e-9 && geared.resonances().is_empty());
    assert!(
        geared.modes.iter().all(|mode| mode.orders.iter().all(|one| one.vanishes == (one.order.halves() % 4 != 0)))
    );
    let answer = pages::text(&geared.answer(), Format::PLAIN);
    assert!(answer.contains("The torque twists nothing") && answer.contains("gear teeth is 100 N"), "{answer}");
    // Two discs that are no gears twist the shaft between them.
    let apart = study(&layout.replace("order = 1\n", "order = 2\n"));
    assert!(!pages::text(&apart.answer(), Format::PLAIN).contains("twists nothing"));
}

/// The phase counts from where the first cylinder fires, of gas as of harmonics, wherever that is in the layout.
#[test]
fn phases_count_from_the_first_firing_however_the_throws_are_drawn() {
    let layout = |throws: &str| {
        format!(
            "speed = 3000\ncycle = 'four-stroke'\nfiring_order = '1-3-4-2'\n[inline]\nthrows = {throws}\n[mechanism]\nstroke = '80 mm'\n\
             rod_length = '130 mm'\nreciprocating_mass = '0.5 kg'\n[gas]\nbore = '80 mm'\nprocess = 'spark-ignition'\ncompression_ratio = 9\n\
             mean_pressure = '8 bar'\n[torsion]\ninertias = [0.01, 0.01, 0.01, 0.01, 0.2]\nstiffnesses = [4e5, 4e5, 4e5, 4e5]\nloss_factor = 0.02\n"
        )
    };
    let phases = |throws: &str| -> Vec<f64> {
        let table = study(&layout(throws)).table("response").expect("a table");
        let text = crankstar::table::csv(&table);
        text.lines().skip(1).map(|line| line.rsplit(',').next().expect("a phase").parse().expect("a number")).collect()
    };
    let (drawn, turned) = (phases("[0, 180, 180, 0]"), phases("[50, 230, 230, 50]"));
    for (one, other) in drawn.iter().zip(&turned) {
        let apart = (one - other + 180.0).rem_euclid(360.0) - 180.0;
        assert!(apart.abs() < 1e-6, "{one} and {other}");
    }
}

/// A four whose sixth order peaks in the range, while the critical speed of the undamped mode is above it; and one with so much damping that a
/// peak lies between two modes. Both are found by a fine scan of each order.
const VISCOUS: &str = "cycle = 'four-stroke'\nspeed = 2750\nfiring_order = '1-3-4-2'\ninline = { throws = [0, 180, 180, 0] }\n\
    [mechanism]\nstroke = '4.25 in'\nrod_length = '7.3 in'\nreciprocating_mass = '2.4 lb'\n\
    [gas]\nbore = '4.05 in'\nprocess = 'diesel'\ncompression_ratio = 16.5\nintake_pressure = '14 psi'\nmean_pressure = '110 psi'\n\
    [torsion]\ninertias = [0.0337, 0.031, 0.03, 0.03, 0.031, 1.0535]\nstiffnesses = [7e5, 11e5, 11e5, 11e5, 15e5]\n\
    crankpins_at = [2, 3, 4, 5]\ndampings = [0, 1.5, 1.5, 1.5, 1.5, 3]\nloss_factor = 0.02\nrated_speed = 2750\n\
    [[torsion.damper]]\ndisc = 1\ninertia = 0.02107\ndamping = DAMPING\n";

#[test]
fn the_strongest_resonance_and_the_largest_torque_in_the_range_are_those_of_a_fine_scan() {
    for damping in ["'best'", "120"] {
        let study = study(&VISCOUS.replace("DAMPING", damping));
        let [from, to] = study.range().expect("a range");
        let steps = 6000;
        let speeds = (0..=steps).map(|step| from + (to - from) * f64::from(step) / f64::from(steps));
        let all: Vec<_> = speeds.map(|speed| study.vibration(speed).expect("a vibration")).collect();
        let torque = |at: usize, place: usize| {
            let torques = &all[at].orders[place].torques[..study.train.shafts];
            torques.iter().map(|torque| torque.norm()).fold(0.0, f64::max)
        };
        let mut strongest = (0.0, 0, 0.0);
        for place in 0..all[0].orders.len() {
            let torques: Vec<f64> = (0..all.len()).map(|at| torque(at, place)).collect();
            for (three, vibration) in torques.windows(3).zip(&all[1..]) {
                if three[1] > strongest.0 && three[1] >= three[0] && three[1] >= three[2] {
                    strongest = (three[1], place, vibration.speed);
                }
            }
        }
        let found = study.strongest_peak().expect("a resonance");
        assert_eq!(found.order, all[0].orders[strongest.1].order, "{found:?} for {strongest:?}");
        assert!((found.torque / strongest.0 - 1.0).abs() < 1e-4, "{found:?} for {strongest:?}");
        assert!((found.rpm / strongest.2 - 1.0).abs() < 2e-3, "{found:?} for {strongest:?}");
        for shaft in 0..study.train.shafts {
            let told = study.over_range().iter().map(|at| at.torques[shaft]).fold(0.0, f64::max);
            let scanned = all.iter().step_by(20).map(|at| at.torque(shaft)).fold(0.0, f64::max);
            assert!(told >= scanned * (1.0 - 1e-6), "{told} for {scanned} in shaft {shaft}");
        }
    }
}

/// A train with a ring whose formula is far from the best: c ≈ 9 damps the two modes that are close to each other.
const CLOSE: &str = "cycle = 'two-stroke'\nspeed = 9000\ninline = { throws = [0] }\n[torsion]\ninertias = [0.03, 0.3, 0.03]\n\
    stiffnesses = [200000, 200000]\ncrankpins_at = [1]\nloss_factor = 0.02\nspeed_range = ['10 rpm', '90000 rpm']\n\
    [[torsion.damper]]\ndisc = 3\ninertia = 0.1\ndamping = 'best'\n[[torsion.harmonic]]\norder = 1\ntorque = 100\n";

#[test]
fn the_search_finds_dampers_that_are_far_from_the_formula() {
    let viscous = study(CLOSE);
    let found = viscous.dampers()[0].found.as_ref().expect("a search");
    let without = found.without.expect("the shafts damp too");
    assert!((found.best.damping - 9.08).abs() < 0.05 && (found.peaks[0] - 1041.0).abs() < 2.0, "{found:?}");
    assert!((without - 2553.0).abs() < 1.0 && found.peaks[0] < found.peaks[1].min(without), "{found:?}");
    // No setting of a coarse grid is better.
    let tuned = CLOSE
        .replace("[0.03, 0.3, 0.03]", "[0.03, 0.1]")
        .replace("[200000, 200000]", "[200000]")
        .replace("disc = 3\ninertia = 0.1", "disc = 2\ninertia = 0.5\nstiffness = 'best'");
    for layout in [tuned.clone(), tuned.replace("crankpins_at = [1]", "crankpins_at = [2]")] {
        let study = study(&layout);
        let [damper] = study.dampers() else { panic!("one damper") };
        let found = damper.found.as_ref().expect("a search");
        let peak = |stiffness: f64, damping: f64| {
            let mut train = study.train.clone();
            (train.links[1].stiffness, train.links[1].damping) = (stiffness, damping);
            let torque = |omega: f64| {
                let torques = study.train.discs.iter().enumerate();
                let pinned = study.torsion().pins[0];
                let torques = torques.map(|(disc, _)| Complex::from(if disc == pinned { 100.0 } else { 0.0 }));
                let twists = forced_twist(&train, &Excitation { omega, torques: torques.collect() });
                shaft_torques(&train, omega, &twists)[0].norm()
            };
            let omegas = (10..=1200).map(|step| damper.in_mode.omega * f64::from(step) / 200.0);
            omegas.map(torque).fold(0.0, f64::max)
        };
        for (k, c) in (-4..=4).flat_map(|k| (-8..=8).map(move |c| (k, c))) {
            let [k, c] = [k, c].map(|steps| 10f64.powf(f64::from(steps) / 4.0));
            let there = peak(damper.in_mode.best.stiffness * k, damper.in_mode.best.damping * c);
            assert!(found.peaks[0] < 1.01 * there, "{there} with {k} and {c} times the formula: {found:?}");
        }
    }
}

/// The peaks that a light ring makes are narrower than any even steps: here of two discs, in steps of a hundredth of them.
#[test]
fn the_peaks_of_a_light_ring_are_found() {
    let layout = "cycle = 'two-stroke'\nspeed = 3000\nfiring_angles = [0]\ninline = { throws = [0] }\n[torsion]\n\
        inertias = [0.1, 0.15]\nstiffnesses = [20000]\nloss_factor = 0.01\nspeed_range = ['3000 rpm', '7000 rpm']\n\
        [[torsion.damper]]\ndisc = 1\ninertia = 0.00005\ndamping = 'best'\nstiffness = 'best'\n\
        [[torsion.harmonic]]\norder = 1\ntorque = 100\n";
    let study = study(layout);
    let [damper] = study.dampers() else { panic!("one damper") };
    let found = damper.found.as_ref().expect("a search");
    let peak = |setting: DamperSetting| {
        let mut train = study.train.clone();
        (train.links[1].stiffness, train.links[1].damping) = (setting.stiffness, setting.damping);
        let torque = |step: i32| {
            let omega = damper.in_mode.omega * f64::from(step) / 1e4;
            let torques = vec![Complex::from(100.0), Complex::default(), Complex::default()];
            let twists = forced_twist(&train, &Excitation { omega, torques });
            shaft_torques(&train, omega, &twists)[0].norm()
        };
        (9_000..=11_000).map(torque).fold(0.0, f64::max)
    };
    for (setting, largest) in [(found.best, found.peaks[0]), (damper.setting, found.peaks[1])] {
        assert!((largest / peak(setting) - 1.0).abs() < 1e-4, "{} for {largest}", peak(setting));
    }
    for (k, c) in (-10..=10).flat_map(|k| (-4..=4).map(move |c| (k, c))) {
        let setting = DamperSetting {
            stiffness: damper.setting.stiffness * (1.0 + f64::from(k) / 400.0),
            damping: damper.setting.damping * 10f64.powf(f64::from(c) / 4.0),
        };
        assert!(found.peaks[0] < 1.0001 * peak(setting), "{setting:?} is better than {found:?}");
    }
}

/// Order 1 has ten times the torque, and meets the mode beyond the range.
#[test]
fn a_damper_is_looked_for_by_the_strongest_order_in_the_range() {
    let study = study(
        "cycle = 'two-stroke'\nspeed = 3000\nfiring_angles = [0]\ninline = { throws = [0] }\n[torsion]\n\
         inertias = [0.1, 0.15]\nstiffnesses = [20000]\nloss_factor = 0.01\nspeed_range = ['2000 rpm', '4000 rpm']\n\
         [[torsion.damper]]\ndisc = 1\ninertia = 0.01\ndamping = 'best'\n\
         [[torsion.harmonic]]\norder = 1\ntorque = 100\nphase = 0\n[[torsion.harmonic]]\norder = 2\ntorque = 10\nphase = 0\n",
    );
    assert_eq!(study.dampers()[0].found.as_ref().expect("a search").order, order(4));
    let page = pages::text(&study.page(), Format::PLAIN).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(page.contains("the most work in it of those that meet it in the range of speeds"), "{page}");
}

#[test]
fn without_a_damper_an_undamped_train_has_no_largest_torque() {
    let study = study(&AUTOMOTIVE.replace("loss_factor = 0.01\n", ""));
    let found = study.dampers()[0].found.as_ref().expect("a search");
    assert_eq!(found.without, None);
    let answer = pages::text(&study.answer(), Format::PLAIN).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(answer.contains("nothing damps that mode, and the torque has no bound"), "{answer}");
}

/// Three equal cranks that are turned alike by equal torques, and a star whose first disc stays at rest.
#[test]
fn what_only_rounding_twists_is_zero() {
    let rigid = study(
        "cycle = 'two-stroke'\nspeed = 1500\nfiring_angles = [0, 120, 240]\ninline = { throws = [0, 240, 120] }\n[torsion]\n\
         inertias = [0.05, 0.05, 0.05]\nstiffnesses = [1000000, 1000000]\nloss_factor = 0.03\n\
         [[torsion.harmonic]]\norder = 3\ntorque = 100\n",
    );
    let vibration = rigid.at_speed().expect("a vibration");
    assert!(vibration.twist(0) > 1e-3 && (0..2).all(|shaft| vibration.torque(shaft) == 0.0));
    assert!(rigid.strongest_peak().is_none());
    let answer = pages::text(&rigid.answer(), Format::PLAIN);
    assert!(answer.contains("beyond rounding") && !answer.contains("N·m"), "{answer}");
    let star = study(
        "cycle = 'two-stroke'\nspeed = 9000\nfiring_angles = [0, 180]\ninline = { throws = [0, 180] }\n[torsion]\n\
         inertias = [0.2, 0.05, 0.05]\nstiffnesses = [1000000]\ncrankpins_at = [2, 3]\nloss_factor = 0.02\n[[torsion.shaft]]\n\
         between = [1, 3]\nstiffness = 1000000\nloss_factor = 0.02\n[[torsion.harmonic]]\norder = 5\ntorque = 100\n",
    );
    assert_eq!(star.modes[0].mode.nodes, [crankstar::torsion::Node::Disc(0)]);
    assert_eq!((star.modes[0].mode.shape[0], star.modes[1].orders[0].star.norm()), (0.0, 0.0));
    let [one] = star.resonances() else { panic!("one resonance") };
    assert!(one.first == 0.0 && one.torque > 4000.0, "{one:?}");
    let page = pages::text(&star.page(), pages::DOLLARS);
    let row = page.lines().find(|line| line.starts_with("| 1 | 5 | ≈\u{a0}8541 |")).expect("the resonance");
    assert!(!row.contains("0.2865") && !page.contains("10⁻"), "{row} of {page}");
}
