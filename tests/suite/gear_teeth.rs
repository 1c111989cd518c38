//! Is the torque in the teeth of gears the one that keeps both wheels together?

use std::f64::consts::TAU;

use crankstar::file;
use crankstar::page::Format;
use crankstar::report::{Question, TorsionStudy};
use crankstar::torsion::{Excitation, Train, forced_twist, mesh_torques, shaft_torques};
use num_complex::Complex;

use crate::damped::TREE;
use crate::support::dense;
use crate::support::dice::Dice;
use crate::support::pages;
use crate::torsion::said_in_german;

const I: Complex<f64> = Complex::new(0.0, 1.0);

fn study(layout: &str) -> TorsionStudy {
    let engine = file::parse("geared.toml", layout).unwrap_or_else(|error| panic!("{layout}\n{error}"));
    TorsionStudy::new(&engine, &[]).expect("a shaft that fires")
}

/// A train whose every disc turns by itself until gears keep some together: two discs with a stiffness, a damping, or a ratio.
struct Geared {
    inertias: Vec<f64>,
    dampings: Vec<f64>,
    shafts: Vec<([usize; 2], f64, f64)>,
    gears: Vec<([usize; 2], f64)>,
}

impl Geared {
    fn random(dice: &mut Dice) -> Self {
        let mut random = |low: f64, high: f64| low + (high - low) * dice.below(1000) as f64 / 1000.0;
        let count = 3 + random(0.0, 5.0) as usize;
        let (mut shafts, mut gears) = (Vec::new(), Vec::new());
        for disc in 1..count {
            let other = random(0.0, disc as f64 - 0.001) as usize;
            let ends = if random(0.0, 1.0) < 0.5 { [other, disc] } else { [disc, other] };
            match random(0.0, 1.0) < 0.5 {
                true => shafts.push((ends, random(20.0, 60.0), random(0.1, 1.0))),
                false => gears.push((ends, [-3.0, -0.5, 0.25, 2.0][random(0.0, 3.99) as usize])),
            }
        }
        if gears.is_empty() {
            gears.push((shafts.pop().expect("discs").0, -1.5));
        }
        let inertias = (0..count).map(|_| random(0.5, 3.0)).collect();
        Geared { inertias, dampings: (0..count).map(|_| random(0.2, 1.0)).collect(), shafts, gears }
    }

    fn keys(&self) -> String {
        let mut text = format!("[torsion]\ninertias = {:?}\ndampings = {:?}\n", self.inertias, self.dampings);
        for ([from, to], stiffness, damping) in &self.shafts {
            let ends = format!("between = [{}, {}]", from + 1, to + 1);
            text += &format!("[[torsion.shaft]]\n{ends}\nstiffness = {stiffness:?}\ndamping = {damping:?}\n");
        }
        for ([from, to], ratio) in &self.gears {
            text += &format!("[[torsion.gear]]\nbetween = [{}, {}]\nratio = {ratio:?}\n", from + 1, to + 1);
        }
        text
    }

    /// The torque that each gear takes from its first disc: an unknown beside the twists, with the ratio as an equation.
    fn by_constraints(&self, omega: f64, torques: &[Complex<f64>]) -> Vec<Complex<f64>> {
        let discs = self.inertias.len();
        let count = discs + self.gears.len();
        let mut rows = vec![vec![Complex::default(); count]; count];
        for (disc, (damping, inertia)) in self.dampings.iter().zip(&self.inertias).enumerate() {
            rows[disc][disc] = I * omega * damping - omega * omega * inertia;
        }
        for ([from, to], stiffness, damping) in &self.shafts {
            let stiffness = stiffness + I * omega * damping;
            for (one, other) in [(*from, *to), (*to, *from)] {
                rows[one][one] += stiffness;
                rows[one][other] -= stiffness;
            }
        }
        for (gear, ([from, to], ratio)) in self.gears.iter().enumerate() {
            // The first disc is held back with T, the second is driven with T over the ratio: no power is lost.
            rows[*from][discs + gear] += 1.0;
            rows[*to][discs + gear] -= 1.0 / ratio;
            rows[discs + gear][*from] = Complex::from(*ratio);
            rows[discs + gear][*to] = Complex::from(-1.0);
        }
        let right = torques.iter().copied().chain(self.gears.iter().map(|_| Complex::default())).collect();
        dense::solve(rows, right)[discs..].to_vec()
    }
}

#[test]
fn it_is_the_multiplier_of_the_constraint_in_random_trees() {
    let mut dice = Dice::new(60);
    for _ in 0..60 {
        let geared = Geared::random(&mut dice);
        let layout =
            format!("cycle = \"four-stroke\"\nfiring_order = \"1\"\n[inline]\nthrows = [0]\n{}", geared.keys());
        let train: Train = study(&layout).train;
        let omega = 0.5 + dice.below(100) as f64 / 10.0;
        let torques: Vec<Complex<f64>> = (0..geared.inertias.len())
            .map(|_| Complex::from_polar(dice.below(10) as f64, dice.below(628) as f64 / 100.0))
            .collect();
        let excitation = Excitation { omega, torques };
        let twists = forced_twist(&train, &excitation);
        let found = mesh_torques(&train, &excitation, &twists, &shaft_torques(&train, omega, &twists));
        let right = geared.by_constraints(omega, &excitation.torques);
        let size = right.iter().map(|torque| torque.norm()).fold(1.0, f64::max);
        assert_eq!(found.len(), right.len());
        for (found, right) in found.iter().zip(&right) {
            assert!((found - right).norm() < 1e-9 * size, "{found} for {right}\n{layout}");
        }
    }
}

/// By orders at a speed, over the range, and at both discs.
#[test]
fn the_study_has_it_by_orders_over_the_range_and_at_both_discs() {
    let mut dice = Dice::new(61);
    for _ in 0..6 {
        let geared = Geared::random(&mut dice);
        let layout = format!(
            "cycle = \"four-stroke\"\nspeed = 60\nfiring_order = \"1\"\n[inline]\nthrows = [0]\n{}\
             [[torsion.harmonic]]\norder = 1\ntorque = 7\nphase = 20\n",
            geared.keys().replace("[torsion]\n", "[torsion]\nspeed_range = [20, 90]\n")
        );
        let study = study(&layout);
        let on_first = |omega: f64| {
            let mut torques = vec![Complex::default(); geared.inertias.len()];
            torques[0] = Complex::from_polar(7.0, 20.0_f64.to_radians());
            geared.by_constraints(omega, &torques)
        };
        let right = on_first(TAU);
        let vibration = study.at_speed().expect("a vibration");
        let json: serde_json::Value = serde_json::from_str(&study.json().expect("JSON")).expect("JSON");
        for (gear, right) in right.iter().enumerate() {
            assert!((vibration.orders[0].meshes[gear] - right).norm() < 1e-9 * right.norm().max(1.0));
            assert!((vibration.mesh(gear) - right.norm()).abs() < 1e-9 * right.norm().max(1.0));
            let row = &json["gears"][gear];
            let number = |name: &str| row[name].as_f64().unwrap_or_else(|| panic!("{name} in {row}"));
            let second = right.norm() / geared.gears[gear].1.abs();
            assert!((number("to_torque_half_range_N_m") - second).abs() < 1e-9 * second.max(1.0));
            let range = study.over_range().iter().map(|at| at.meshes[gear]).fold(0.0, f64::max);
            assert_eq!(number("largest_half_range_N_m"), range);
            assert!(range >= right.norm() * (1.0 - 1e-3), "{range} below that at the speed, {}", right.norm());
            let at_largest = on_first(TAU * number("largest_speed_rpm") / 60.0)[gear].norm();
            assert!((at_largest - range).abs() < 1e-9 * range.max(1.0));
        }
    }
}

/// Two wheels alone: what the second needs is its inertia, behind a shaft that is as good as rigid.
#[test]
fn a_wheel_alone_needs_its_inertia() {
    let layout = "cycle = \"four-stroke\"\nspeed = 300\nfiring_order = \"1\"\n[inline]\nthrows = [0]\n[torsion]\ninertias = [3, 2, 5]\n\
                  stiffnesses = [1e9]\nloss_factor = 0.01\n[[torsion.gear]]\nbetween = [2, 3]\nratio = -2\n[[torsion.harmonic]]\norder = 1\n\
                  torque = 100\n";
    let study = study(layout);
    // Of the reduced inertia 3 + 2 + 4 · 5 the second wheel is 20 parts of 25.
    let torque = study.at_speed().expect("a vibration").mesh(0);
    assert!((torque - 80.0).abs() < 1e-3, "{torque}");
}

#[test]
fn the_pages_tell_it_in_both_languages() {
    let [page, answer] = said_in_german(&study(TREE).at(600.0));
    let text = pages::text(&page, Format::GITHUB);
    for words in ["Gear teeth at", "Gear 2–3", "the teeth separate"] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let answer = pages::text(&answer, Format::PLAIN);
    assert!(answer.contains("largest vibration torque in the gear teeth is"), "{answer}");
    let row = study(crate::damped::MARINE).page();
    assert!(!pages::text(&row, Format::GITHUB).contains("teeth"));
}
