//! Do natural frequencies, modes and critical speeds come out as the textbooks have them?

use std::f64::consts::PI;

use crankstar::engine::{CycleOrder, ElasticShaft, Engine, Torsion};
use crankstar::file;
use crankstar::page::{Document, Format, Language};
use crankstar::report::{Question, TorsionStudy};
use crankstar::table;
use crankstar::torsion::{Excitation, Mode, Train, critical_speeds, forced_twist, modes};
use num_complex::Complex;
use num_rational::BigRational;

use super::true_sentences::said;
use crate::support::dice::Dice;
use crate::support::figure_texts::FigureTexts;
use crate::support::german::phrases;
use crate::support::pages;

/// Discs in a row without damping.
fn shaft(inertias: &[f64], stiffnesses: &[f64]) -> Train {
    let exact = |value: &f64| BigRational::from_float(*value).expect("finite");
    let between = |(at, stiffness)| ElasticShaft::between([at, at + 1], exact(stiffness));
    let shafts = stiffnesses.iter().enumerate().map(between).collect();
    Train::new(&Torsion { inertias: inertias.iter().map(exact).collect(), shafts, ..Torsion::default() })
}

fn assert_near(found: f64, right: f64, part: f64) {
    assert!((found - right).abs() <= part * right.abs().max(1e-300), "{found} for {right}");
}

/// W. T. Thomson, Theory of Vibration with Applications, table 12.4-1; the digits by `theory-gas`, section 3.
#[test]
fn the_textbook_shaft_of_three_discs_comes_out() {
    let found = modes(&shaft(&[5.0, 11.0, 22.0], &[0.10e6, 0.20e6]));
    let right =
        [(123.665_800_08, [1.0, 0.235_338_49, -0.344_941_97]), (202.658_348_59, [1.0, -1.053_520_31, 0.299_487_43])];
    assert_eq!(found.len(), 2);
    for (mode, (omega, shape)) in found.iter().zip(right) {
        assert_near(mode.omega, omega, 1e-9);
        for (found, right) in mode.shape.iter().zip(shape) {
            assert!((found - right).abs() < 1e-8, "{found} for {right}");
        }
    }
}

/// `ω_j = 2√(k/J) sin(jπ/2n)` of n equal free discs.
#[test]
fn equal_discs_have_the_frequencies_of_the_formula() {
    for count in 2..=40_u32 {
        let found = modes(&shaft(&vec![0.25; count as usize], &vec![9.0e4; count as usize - 1]));
        assert_eq!(found.len(), count as usize - 1);
        for (j, mode) in (1..count).zip(&found) {
            let right = 2.0 * 600.0 * (f64::from(j) * PI / f64::from(2 * count)).sin();
            assert_near(mode.omega, right, 1e-13);
            assert_eq!(mode.nodes(), j as usize, "{mode:?}");
        }
    }
}

/// The inertia at another speed is a multiple of what it is at that of the file: at rest it is nothing to be multiplied.
#[test]
fn a_speed_of_0_in_the_file_is_read_as_none() {
    let text = include_str!("../../reports/examples/i6-torsion/layout.toml").to_owned()
        + "loss_factor = 0.02\nspeed_range = ['1000 rpm', '6000 rpm']\n";
    let given = "speed = \"6000 rpm\"\n";
    assert!(text.contains(given));
    let told = |speed: &str| {
        let engine = file::parse("six.toml", &text.replace(given, speed)).expect("it reads");
        let study = TorsionStudy::new(&engine, &[]).expect("a shaft");
        let tables = study.tables().iter().map(table::csv).collect::<Vec<_>>();
        (study.speed, pages::text(&study.answer(), Format::PLAIN), tables)
    };
    assert_eq!(told("speed = 0\n"), told(""));
}

fn six_with_flywheel() -> Engine {
    let layout = "title = \"Six\"\ncycle = \"four-stroke\"\nfiring_order = \"1-5-3-6-2-4\"\n\
                  [inline]\nthrows = [0, 240, 120, 120, 240, 0]\n\
                  [torsion]\ninertias = [\"0.03 kg m^2\", 0.03, 0.03, 0.03, 0.03, \"300 kg cm²\", 0.3]\n\
                  stiffnesses = [\"1 MN m/rad\", 1000000, \"1000 kN m/rad\", 1000000, 1000000, 1000000]\n";
    file::parse("six.toml", layout).unwrap_or_else(|error| panic!("{error}"))
}

/// `theory-gas`, section 3: six discs J, flywheel 10 J, all stiffnesses alike.
#[test]
fn a_six_with_a_flywheel_has_the_modes_stars_and_critical_speeds_of_the_theory() {
    let engine = six_with_flywheel();
    let torsion = engine.torsion().expect("a shaft");
    let orders: Vec<CycleOrder> = [1, 2, 3, 6].map(|halves| CycleOrder::of_halves(halves).expect("an order")).to_vec();
    let found = critical_speeds(&engine, torsion, &orders).expect("it fires");
    let unit = (1e6_f64 / 0.03).sqrt();
    for (speeds, right) in found.iter().zip([0.293_114_74, 0.728_416_03, 1.145_628_29]) {
        assert!((speeds.mode.omega / unit - right).abs() < 6e-9);
    }
    let shape = [1.0, 0.914_083_75, 0.749_632_85, 0.520_776_31, 0.247_176_62, -0.047_659_55, -0.338_401];
    for (found, right) in found[0].mode.shape.iter().zip(shape) {
        assert!((found - right).abs() < 6e-7, "{found} for {right}");
    }
    for (critical, right) in found[0].orders.iter().zip([0.709_683, 0.279_936, 1.943_423, 3.384_010]) {
        assert!((critical.star.norm() - right).abs() < 6e-7, "order {}: {}", critical.order, critical.star);
    }
    assert!((found[0].mode.hertz() - 269.3377).abs() < 5e-5);
    assert!((found[0].orders[3].rpm - 5386.75).abs() < 5e-3);
}

/// `K Θ = ω² J Θ`, and modes of different frequencies do not work on each other.
fn assert_is_a_mode(shaft: &Train, mode: &Mode) {
    let count = shaft.discs.len();
    let spring = |index: usize| shaft.links[index].stiffness * (mode.shape[index + 1] - mode.shape[index]);
    let largest = (0..count - 1).map(|index| spring(index).abs()).fold(0.0, f64::max);
    for disc in 0..count {
        let after = if disc + 1 < count { spring(disc) } else { 0.0 };
        let before = if disc > 0 { spring(disc - 1) } else { 0.0 };
        let residual = after - before + mode.omega.powi(2) * shaft.discs[disc].inertia * mode.shape[disc];
        assert!(residual.abs() < 1e-9 * largest, "{residual} of {largest} at disc {disc} of {shaft:?}");
    }
}

#[test]
fn random_shafts_satisfy_their_equations_and_forced_twists_theirs() {
    let mut dice = Dice::new(7);
    let mut random = || (dice.below(1_000_000) as f64 + 1.0) / 1e6;
    for count in 2..=30_usize {
        for _ in 0..10 {
            let inertias: Vec<f64> = (0..count).map(|_| 10.0_f64.powf(3.0 * random() - 2.0)).collect();
            let stiffnesses: Vec<f64> = (1..count).map(|_| 10.0_f64.powf(3.0 * random() + 4.0)).collect();
            let shaft = shaft(&inertias, &stiffnesses);
            let found = modes(&shaft);
            assert!(found.windows(2).all(|pair| pair[0].omega < pair[1].omega));
            for (number, mode) in found.iter().enumerate() {
                assert_is_a_mode(&shaft, mode);
                assert_eq!(mode.nodes(), number + 1, "{mode:?}");
            }
            let work: f64 = (0..count).map(|disc| inertias[disc] * found[0].shape[disc]).sum();
            let size: f64 = (0..count).map(|disc| (inertias[disc] * found[0].shape[disc]).abs()).sum();
            assert!(work.abs() < 1e-9 * size, "it does not turn as a whole");
            let torques: Vec<Complex<f64>> = (0..count).map(|_| Complex::new(random(), random())).collect();
            // Between two natural frequencies, and below the first.
            let omega = found.get(1).map_or(0.7 * found[0].omega, |second| 0.5 * (found[0].omega + second.omega));
            let twist = forced_twist(&shaft, &Excitation { omega, torques: torques.clone() });
            for disc in 0..count {
                let spring = |index: usize| (twist[index + 1] - twist[index]) * stiffnesses[index];
                let after = if disc + 1 < count { spring(disc) } else { Complex::default() };
                let before = if disc > 0 { spring(disc - 1) } else { Complex::default() };
                let inertia = twist[disc] * omega * omega * inertias[disc];
                let residual = (after - before + inertia + torques[disc]).norm();
                let size = after.norm() + before.norm() + inertia.norm() + torques[disc].norm();
                assert!(residual < 1e-7 * size, "{residual} of {size}");
            }
        }
    }
}

/// Discs on shafts without damping, each disc but the first on one of those before it.
fn tree(inertias: &[f64], shafts: &[(usize, f64)]) -> Train {
    let exact = |value: &f64| BigRational::from_float(*value).expect("finite");
    let behind = |(at, (on, stiffness)): (usize, &(usize, f64))| ElasticShaft::between([*on, at + 1], exact(stiffness));
    let shafts = shafts.iter().enumerate().map(behind).collect();
    Train::new(&Torsion { inertias: inertias.iter().map(exact).collect(), shafts, ..Torsion::default() })
}

/// Of a train with K and J: as many modes as discs less the rigid one, `K Θ = ω² J Θ`, orthogonal in the inertias, and to the rigid
/// motion. That is all of the eigenvectors, whatever their frequencies.
fn assert_are_all_modes(train: &Train) {
    let found = modes(train);
    let count = train.discs.len();
    assert_eq!(found.len(), count - 1, "{train:?}");
    assert!(found.windows(2).all(|pair| pair[0].omega <= pair[1].omega));
    let product = |one: &[f64], other: &[f64]| -> f64 {
        train.discs.iter().zip(one.iter().zip(other)).map(|(disc, (one, other))| disc.inertia * one * other).sum()
    };
    let size = |shape: &[f64]| product(shape, shape).sqrt();
    let mut shapes = vec![(0.0, vec![1.0; count])];
    for mode in &found {
        let square = mode.omega.powi(2);
        let mut residuals: Vec<f64> =
            train.discs.iter().zip(&mode.shape).map(|(disc, own)| -square * disc.inertia * own).collect();
        let mut largest: f64 = 0.0;
        for link in &train.links {
            let [one, other] = link.ends;
            let torque = link.stiffness * (mode.shape[one] - mode.shape[other]);
            largest = largest.max(link.stiffness * mode.shape[one].abs().max(mode.shape[other].abs()));
            residuals[one] += torque;
            residuals[other] -= torque;
        }
        assert!(
            residuals.iter().all(|one| one.abs() < 1e-10 * largest),
            "{residuals:?} of {largest}: {mode:?} of {train:?}"
        );
        for (other, before) in &shapes {
            let part = (product(before, &mode.shape) / size(before) / size(&mode.shape)).abs();
            // Of modes whose frequencies nearly agree each is as far from its own as rounding is of what is between them.
            let gap = (square - other) / square;
            assert!(part < 1e-9 || part * gap < 1e-13, "{part}: {mode:?} beside {before:?} of {train:?}");
        }
        assert!(mode.shape.contains(&1.0), "{mode:?}");
        shapes.push((square, mode.shape.clone()));
    }
}

/// Equal branches have equal frequencies, and leave what is between them at rest.
#[test]
fn small_symmetric_trains_have_all_their_modes() {
    let mut dice = Dice::new(11);
    let mut multiple = 0;
    for case in 0..1000 {
        let count = 2 + dice.below(if case % 10 == 0 { 24 } else { 8 }) as usize;
        let values = if case % 2 == 0 { 1 } else { 2 };
        let inertias: Vec<f64> = (0..count).map(|_| [0.3, 1.1][dice.below(values) as usize]).collect();
        let shafts: Vec<(usize, f64)> =
            (1..count).map(|at| (dice.below(at as u64) as usize, [1e5, 7e5][dice.below(values) as usize])).collect();
        let train = tree(&inertias, &shafts);
        multiple += usize::from(modes(&train).iter().any(|mode| mode.alike.len() > 1));
        assert_are_all_modes(&train);
    }
    assert!(multiple > 100, "{multiple}");
}

/// A mode in which branches alone swing has deflections of exactly 0 at the hub, and there is one less than there are branches for each
/// frequency of the branch.
#[test]
fn equal_branches_leave_their_hub_at_rest() {
    let mut dice = Dice::new(12);
    for _ in 0..300 {
        let mut random = || 10.0_f64.powf(dice.below(1_000_000) as f64 / 1e6 - 0.5);
        let hub: Vec<f64> = (0..3).map(|_| random()).collect();
        let branch: Vec<(f64, f64)> = (0..3).map(|_| (random(), 1e5 * random())).collect();
        let mut inertias = hub;
        let mut shafts = vec![(0, 1e5 * random()), (1, 1e5 * random())];
        let [times, on] = [2 + dice.below(3) as usize, dice.below(3) as usize];
        let second = dice.below(2) as usize;
        for _ in 0..times {
            let first = inertias.len();
            for (at, (inertia, stiffness)) in branch.iter().enumerate() {
                let behind = if at == 0 { on } else { first + (at - 1) * second };
                inertias.push(*inertia);
                shafts.push((behind, *stiffness));
            }
        }
        let train = tree(&inertias, &shafts);
        let found = modes(&train);
        let alone = found.iter().filter(|mode| mode.shape[..3].iter().all(|value| *value == 0.0)).count();
        assert_eq!(alone, 3 * (times - 1), "{found:?}");
        assert_are_all_modes(&train);
    }
}

/// They hardly feel each other, and have one frequency for all that decimals tell.
#[test]
fn light_ends_of_a_row_are_two_modes() {
    for count in 6..40_usize {
        let inertias: Vec<f64> = (0..count).map(|at| if at == 0 || at == count - 1 { 0.01 } else { 1.0 }).collect();
        assert_are_all_modes(&shaft(&inertias, &vec![1e5; count - 1]));
    }
}

#[test]
fn a_node_in_a_mesh_is_told_once() {
    let geared = study(
        "cycle = 'two-stroke'\nspeed = 3000\nfiring_angles = [0]\n[inline]\nthrows = [0]\n[torsion]\ninertias = [1, 2, 2, 1]\nstiffnesses = []\n\
         gear = [{ between = [2, 3], ratio = -1 }]\n\
         shaft = [{ between = [1, 2], stiffness = 1e5 }, { between = [3, 4], stiffness = 1e5 }]\n",
    );
    let nodes: Vec<_> = geared.modes.iter().map(|one| one.mode.nodes.clone()).collect();
    assert_eq!(nodes[0], [crankstar::torsion::Node::Disc(1)]);
    assert_eq!(nodes.iter().map(Vec::len).collect::<Vec<_>>(), [1, 2]);
}

#[test]
fn a_ring_without_effect_is_not_searched_and_said_so() {
    let light = "cycle = 'two-stroke'\nspeed = 3000\nfiring_angles = [0]\n[inline]\nthrows = [0]\n[torsion]\ninertias = [0.1, 0.15]\n\
        stiffnesses = [20000]\nloss_factor = 0.01\nspeed_range = [3000, 7000]\n\
        [[torsion.damper]]\ndisc = 1\ninertia = '1/10000000000'\ndamping = 'best'\nstiffness = 'best'\n[[torsion.harmonic]]\norder = 1\ntorque = 100\n";
    let told = unbroken(&study(light).answer());
    assert!(told.contains("its ring has less than a millionth of the inertia of the first mode"), "{told}");
    assert!(!told.contains("by a search"), "{told}");
}

/// A page without its line breaks.
fn unbroken(page: &Document) -> String {
    pages::text(page, Format::PLAIN).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A layout of discs and shafts, its cranks and its torque.
fn study(text: &str) -> TorsionStudy {
    let engine = file::parse("train.toml", text).unwrap_or_else(|error| panic!("{error}"));
    TorsionStudy::new(&engine, &[]).expect("a study")
}

/// Four cranks at one end, and two equal screws at the other: in the first mode the screws swing against each other.
const TWIN_SCREWS: &str = "cycle = 'four-stroke'\nspeed = '1000 rpm'\nfiring_order = '1-3-4-2'\n\
    [inline]\nthrows = [0, 180, 180, 0]\n\
    [torsion]\ninertias = [2, 2, 2, 2, 10, 40, 40]\nstiffnesses = [8e6, 8e6, 8e6, 8e6]\nloss_factor = 0.01\n\
    [[torsion.shaft]]\nbetween = [5, 6]\nstiffness = 0.2e6\n[[torsion.shaft]]\nbetween = [5, 7]\nstiffness = 0.2e6\n\
    [[torsion.harmonic]]\norder = 2\ntorque = 1000\n";

#[test]
fn what_is_at_rest_in_a_mode_has_no_star_there() {
    let study = study(TWIN_SCREWS);
    let first = &study.modes[0];
    assert_eq!(first.mode.shape[..5], [0.0; 5]);
    assert!((first.mode.shape[5] + first.mode.shape[6]).abs() < 1e-12);
    assert_eq!(first.longest, 0.0);
    assert!(first.orders.iter().all(|order| order.star.norm() == 0.0));
    let answer = pages::text(&study.answer(), Format::PLAIN);
    assert!(answer.contains("No order shown excites the first of them up to 1000 rpm."), "{answer}");
    let page = pages::text(&study.page(), Format::PLAIN);
    assert!(!page.contains("NaN"), "{page}");
    // A damper there has no part in that mode, on a spring or without one.
    for spring in ["", "stiffness = 'best'\n"] {
        let damped =
            self::study(&format!("{TWIN_SCREWS}[[torsion.damper]]\ndisc = 1\ninertia = 1\ndamping = 'best'\n{spring}"));
        let [damper] = damped.dampers() else { panic!("one damper") };
        assert_eq!(damper.in_mode.mass_ratio, 0.0);
        assert!(damper.found.is_none());
        let [page, answer] = said_in_german(&damped).map(|page| unbroken(&page));
        assert!(answer.contains("Damper at disc 1: that disc is at rest in the first mode"), "{answer}");
        assert!(!page.contains("NaN"), "{page}");
    }
    // All cranks are at rest: no part of nothing.
    let critical = table::csv(&study.table("critical").expect("a table"));
    assert!(critical.lines().filter(|row| row.starts_with("1,")).all(|row| row.ends_with(",0,0")), "{critical}");
}

/// Three equal discs on a hub have two modes of one frequency: an order works on their space, whichever of them are shown.
#[test]
fn modes_of_equal_frequency_are_told_and_each_has_its_star() {
    let three = |pins: &str| {
        study(&format!(
            "cycle = 'two-stroke'\nspeed = '3000 rpm'\nfiring_angles = [0, 180]\n[inline]\nthrows = [0, 180]\n\
             [torsion]\ninertias = [0.1, 0.05, 0.05, 0.05]\nstiffnesses = []\ncrankpins_at = {pins}\nloss_factor = 0.01\n\
             speed_range = ['3000 rpm', '20000 rpm']\n\
             [[torsion.shaft]]\nbetween = [1, 2]\nstiffness = 50000\n[[torsion.shaft]]\nbetween = [1, 3]\nstiffness = 50000\n\
             [[torsion.shaft]]\nbetween = [1, 4]\nstiffness = 50000\n[[torsion.harmonic]]\norder = 1\ntorque = 100\n"
        ))
    };
    for pins in ["[2, 3]", "[3, 4]", "[2, 4]"] {
        let study = three(pins);
        // Order 1 turns the two cranks against each other: the parts of that in both modes add up to all of it.
        let stars = study.modes[..2].iter().map(|speeds| {
            let star = speeds.orders.iter().find(|one| one.order.halves() == 2).expect("order 1").star.norm();
            star * star / study.train.inertia_of(&speeds.mode.shape)
        });
        assert_near(stars.sum(), 4.0 / (2.0 * 0.05), 1e-12);
        let [page, answer] = said_in_german(&study).map(|page| unbroken(&page));
        assert!(answer.contains("Modes whose frequencies are equal to twelve digits: 1–2."), "{answer}");
        assert!(answer.contains("than order 1: its critical speed is 9549 rpm"), "{answer}");
        assert!(page.contains("Modes whose frequencies are equal to twelve digits: 1–2."), "{page}");
        let peaks: Vec<f64> = study.resonances()[..2].iter().map(|one| one.peak.expect("a peak").1).collect();
        assert!(peaks.iter().all(|peak| (peak - 10_000.0).abs() < 5.0), "{peaks:?}");
    }
    // One crank on the hub twists all three alike: everywhere the first of them is named.
    let hub = study(
        "cycle = 'two-stroke'\nspeed = '3000 rpm'\nfiring_angles = [0]\n[inline]\nthrows = [0]\n\
         [torsion]\ninertias = [0.1, 0.05, 0.05, 0.05]\nstiffnesses = []\nloss_factor = 0.01\n\
         [[torsion.shaft]]\nbetween = [1, 2]\nstiffness = 50000\n[[torsion.shaft]]\nbetween = [1, 3]\nstiffness = 50000\n\
         [[torsion.shaft]]\nbetween = [1, 4]\nstiffness = 50000\n[[torsion.harmonic]]\norder = 1\ntorque = 100\n\
         [[torsion.damper]]\ndisc = 1\ninertia = 0.005\ndamping = 'best'\n",
    );
    assert_eq!(hub.forced()[0].shaft_number, 0);
    let answer = unbroken(&hub.answer());
    assert!(answer.contains("the largest vibration torque is 20.5 N·m, in shaft 1–2."), "{answer}");
    // One crank alone is at rest in one of the two, which is told second.
    let one = study(
        "cycle = 'two-stroke'\nspeed = '20000 rpm'\nfiring_angles = [0]\n[inline]\nthrows = [0]\n\
         [torsion]\ninertias = [0.1, 0.05, 0.05, 0.05]\nstiffnesses = []\ncrankpins_at = [4]\n\
         [[torsion.shaft]]\nbetween = [1, 2]\nstiffness = 50000\n[[torsion.shaft]]\nbetween = [1, 3]\nstiffness = 50000\n\
         [[torsion.shaft]]\nbetween = [1, 4]\nstiffness = 50000\n",
    );
    assert!(one.modes[0].longest > 0.0 && one.modes[1].longest == 0.0, "{:?}", one.modes);
}

/// A shaft that is its own mirror image has a node in its middle.
#[test]
fn a_node_on_the_first_disc_does_not_divide_by_zero() {
    // A pendulum of three discs: the middle one stands still in the first mode.
    let found = modes(&shaft(&[1.0, 5.0, 1.0], &[1e5, 1e5]));
    assert!(found.iter().flat_map(|mode| &mode.shape).all(|value| value.is_finite()));
    assert_eq!(found[0].shape[1], 0.0);
}

#[test]
fn what_is_no_shaft_is_refused_at_its_place() {
    let head = "title = \"Two\"\n[inline]\nthrows = [0, 180]\n[torsion]\n";
    for (keys, words) in [
        ("inertias = [1]\nstiffnesses = []\n", "2 to 200"),
        ("inertias = [1, 1]\nstiffnesses = [1, 1]\n", "2 discs in a row need 1"),
        ("inertias = [1, 0]\nstiffnesses = [1]\n", "cannot read the moment of inertia `0`"),
        ("inertias = [1, 1, 1]\nstiffnesses = [1, -1]\n", "cannot read the stiffness `-1`"),
        ("inertias = [1, 1]\nstiffnesses = [1]\nspeed_range = [1000]\n", "1 value for a range of speeds"),
        ("inertias = [1, 1]\n[[torsion.shaft]]\nbetween = [2]\n", "1 value for the discs at two ends"),
        ("inertias = [1, 1]\nstiffnesses = [1]\ncrankpins_at = [1]\n", "1 disc named for 2 crankpins"),
        ("inertias = [1, 1]\nstiffnesses = [1]\ncrankpins_at = [1, 3]\n", "crankpin 2 is on disc 3"),
        ("inertias = [1, 1]\nstiffnesses = [1]\ncrankpins_at = [0, 1]\n", "number of the disc"),
        ("inertias = [\"1 kg\", 1]\nstiffnesses = [1]\n", "none of kg m²"),
        ("inertias = [1, 1]\nstiffnesses = [\"1 N m\"]\n", "none of MN m/rad"),
        ("inertias = [1, 1]\n", "stiffnesses"),
        ("inertias = [1, 1]\nstiffnesses = [1]\ndamping = 3\n", "damping"),
    ] {
        let error = file::parse("two.toml", &format!("{head}{keys}")).expect_err(keys).to_string();
        assert!(error.contains(words), "{keys}: {error}");
    }
    let boxer = "[boxer]\nthrows = [0, 180]\nspacing = 1\nstagger = 0.3\n[torsion]\ninertias = [1, 1, 1, 1, 1]\nstiffnesses = [1, 1, 1, 1]\n";
    let error =
        file::parse("boxer.toml", &format!("{boxer}crankpins_at = [1, 2, 3, 4]")).expect_err("two pins").to_string();
    assert!(
        error.contains("4 discs named for 2 crankpins") && error.contains("both pins of a pair of [boxer]"),
        "{error}"
    );
    assert!(file::parse("boxer.toml", &format!("{boxer}crankpins_at = [2, 4]")).is_ok());
    let open =
        "title = \"V\"\n[vee]\nbank_angle = \"phi\"\nthrows = [0]\n[torsion]\ninertias = [1, 1]\nstiffnesses = [1]\n";
    assert!(file::parse_layout("v.toml", open).expect_err("open").to_string().contains("[values]"));
}

#[test]
fn a_draft_with_a_shaft_for_other_pins_is_no_engine() {
    let one = BigRational::from_integer(1.into());
    let shafts = vec![ElasticShaft::between([0, 1], one.clone())];
    let torsion = Torsion { inertias: vec![one.clone(), one], shafts, pins: vec![0], ..Torsion::default() };
    let mut draft = six_with_flywheel().into_draft();
    draft.torsion = Some(torsion);
    assert!(draft.build().is_err());
}

/// Page and answer, every phrase of which has its German, and whose pictures have no texts on each other.
pub fn said_in_german(study: &TorsionStudy) -> [Document; 2] {
    let pages = [study.page(), study.answer()];
    let phrases = pages.iter().flat_map(phrases);
    let has_words = |words: &str| words.chars().filter(|letter| letter.is_alphabetic()).count() > 2;
    let missing: Vec<&str> = phrases.filter(|words| has_words(words) && !Language::De.knows(words)).collect();
    assert!(missing.is_empty(), "no German for {missing:#?}");
    assert!(pages[0].pictures().iter().all(|picture| picture.figure.overlaps().is_empty()));
    pages
}

#[test]
fn the_page_says_what_its_document_says_in_both_languages() {
    let engine = six_with_flywheel();
    let study = TorsionStudy::new(&engine, &[]).expect("a shaft that fires");
    let pages = said_in_german(&study);
    let json: serde_json::Value = serde_json::from_str(&study.json().expect("JSON")).expect("JSON");
    let hertz = json["modes"][0]["frequency_Hz"].as_f64().expect("a number");
    assert!((hertz - 269.3377).abs() < 5e-5);
    let text = pages::text(&pages[0], Format::GITHUB);
    assert!(text.contains("269.3") && text.contains("5387"), "{text}");
}

#[test]
fn a_layout_without_a_shaft_or_without_firing_is_told_what_to_add() {
    let i4 = file::find("I4").expect("known").engine().expect("reads");
    let why = TorsionStudy::new(&i4, &[]).expect_err("no shaft").to_string();
    assert!(why.contains("[torsion]") && why.contains("inertias"), "{why}");
    let silent = "title = \"Two\"\n[inline]\nthrows = [0, 180]\n[torsion]\ninertias = [1, 1]\nstiffnesses = [1]\n";
    let engine = file::parse("two.toml", silent).expect("it reads");
    assert!(TorsionStudy::new(&engine, &[]).expect_err("no firing").to_string().contains("firing_order"));
}

/// A disc takes both pins of a boxer pair; written as cylinders each pin has its own.
#[test]
fn a_boxer_pair_counts_as_one_crankpin_and_cylinders_of_their_own_as_two() {
    let shaft = "[torsion]\ninertias = [1, 1, 3]\nstiffnesses = [1e5, 1e5]\n";
    let boxer = |at: &str| format!("[boxer]\nthrows = [0]\nstagger = '20 mm'\n{shaft}crankpins_at = {at}\n");
    assert!(file::parse("boxer.toml", &boxer("[1]")).is_ok());
    let told = file::parse("boxer.toml", &boxer("[1, 2]")).expect_err("one pin").to_string();
    assert!(told.contains("2 discs named for 1 crankpin; name one for each (a boxer pair is one)"), "{told}");
    let cylinders = "[[cylinder]]\nbank = -90\nthrow = -90\nposition = '10 mm'\n[[cylinder]]\nbank = 90\nthrow = 90\nposition = '-10 mm'\n";
    assert!(file::parse("two.toml", &format!("{cylinders}{shaft}crankpins_at = [1, 2]\n")).is_ok());
}

/// A two-stroke in line with a stiff shaft.
fn many_in_line(cylinders: usize) -> Engine {
    let discs = vec!["0.02"; cylinders].join(", ");
    let names: Vec<String> = (1..=cylinders).map(|name| name.to_string()).collect();
    let text = format!(
        "cycle = 'two-stroke'\nspeed = 1000\nfiring_order = '{}'\n[inline]\nspacing = 0.1\n\
         [mechanism]\nstroke = '90 mm'\nrod_length = '150 mm'\nreciprocating_mass = '600 g'\n\
         [gas]\nbore = '80 mm'\nunit = 'bar'\ncrankcase = '1 bar'\n\
         pressure = [[-180, 1.1], [-90, 3], [-20, 20], [0, 45], [12.5, 70], [30, 40], [90, 6], [140, 3], [180, 1.1]]\n\
         [torsion]\ninertias = [{discs}, 0.4]\nstiffnesses = [{}]\nmagnifier = 40\n",
        names.join("-"),
        vec!["1e6"; cylinders].join(", "),
    );
    file::parse("many.toml", &text).unwrap_or_else(|error| panic!("{error}"))
}

/// Seven of the first twelve orders were the strongest that a two-stroke of fourteen cylinders could have.
#[test]
fn the_first_major_order_of_many_cylinders_is_shown_and_has_the_highest_peak() {
    let study = TorsionStudy::new(&many_in_line(14), &[]).expect("a study");
    let answer = pages::text(&study.answer(), Format::PLAIN);
    assert!(answer.contains("order 14 has the highest peak") && answer.contains("707"), "{answer}");
    assert!(answer.contains("of 14 are shown"), "{answer}");
}

/// Orders were added up to 24 alone.
#[test]
fn of_more_cylinders_than_24_the_first_major_order_is_added_too() {
    let study = TorsionStudy::new(&many_in_line(26), &[]).expect("a study");
    let resonances = table::csv(&study.table("resonances").expect("a table"));
    assert!(resonances.lines().any(|row| row.starts_with("1,26,")), "{resonances}");
}

/// A mode is a line for each shaft: none for gears, nor between discs whose numbers follow each other by chance.
#[test]
fn a_mode_of_a_train_is_drawn_along_its_shafts() {
    let train = "speed = 1800\ncycle = 'two-stroke'\n[inline]\nthrows = [0, 120]\n[mechanism]\nstroke = '140 mm'\nrod_length = '260 mm'\nreciprocating_mass = '5 kg'\n\
        [torsion]\ninertias = [0.2, 0.2, 2.5, 0.05, 0.8, 0.3]\nstiffnesses = ['1.5 MN m/rad', '2 MN m/rad']\n\
        gear = [{ between = [3, 4], ratio = -2 }]\n\
        shaft = [{ between = [4, 5], stiffness = '1 MN m/rad' }, { between = [3, 6], stiffness = '0.3 MN m/rad' }]\n";
    let page = said("torsion", train, &["--format", "html"]);
    let drawn =
        page.split("a line joins the discs of a shaft.</title>").nth(1).expect("a drawing").split("</svg>").next();
    let curve =
        drawn.expect("a drawing").split("<path").find(|path| path.contains("stroke-width=\".45\"")).expect("a curve");
    assert_eq!(curve.matches('M').count(), 4, "{curve}");
}
