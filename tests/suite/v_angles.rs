//! For which bank angles and pin splits does a V engine balance, whatever its pin star? The page `reports/v-angles`.
//!
//! `CRANKSTAR_RENEW=1 cargo test --test suite v_angles` writes it anew.

use std::env;
use std::f64::consts::TAU;
use std::fs;
use std::path::{Path, PathBuf};

use crankstar::exact::{PhasorSum, Term, Turn};
use num_rational::BigRational;

use crate::support::dice::Dice;
use crate::support::pin_stars::{ORDERS, stars};
use crate::support::plane_star::float;
use crate::support::program::{call, scratch};
use crate::support::torus::{Places, balanced};
use crate::support::v_angles::{CYCLES, Found, MOST, found, verdicts};
use crate::support::{v_pictures, v_words};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/v-angles")
}

/// The page.
fn page(found: &Found) -> String {
    let all: usize = found.classes.values().flat_map(|class| class.counts).sum();
    let shafts: usize = found.shafts.values().map(Vec::len).sum();
    format!(
        include_str!("support/v_angles.md"),
        points = v_words::points(found),
        classes = v_words::classes(found),
        even = v_words::even(found),
        one_left = v_words::one_left(found),
        shafts = v_words::shafts(found),
        all = all,
        shafts_count = shafts,
    )
}

#[test]
fn the_page_is_as_stored_and_the_program_writes_and_verifies_its_proofs() {
    let found = found();
    let mut files = vec![("README.md".to_owned(), page(&found))];
    files.extend(v_pictures::pictures(&found).map(|(name, text)| (name.to_owned(), text)));
    for (vanishing, class) in &found.classes {
        let stem = v_words::stem(vanishing);
        let layout = format!(
            "title = \"V with pins at {}\"\norders = [1, 2, 4]\n{}",
            class.first.list(),
            class.first.layout(None)
        );
        let path = scratch("v-angles").join(format!("{stem}.toml"));
        fs::write(&path, &layout).expect("the layout");
        let told = call(&["classify", path.to_str().expect("UTF-8"), "--format", "json"]);
        assert!(told.status.success(), "{}", String::from_utf8_lossy(&told.stderr));
        files.push((format!("{stem}.toml"), layout));
        files.push((format!("{stem}.json"), String::from_utf8(told.stdout).expect("UTF-8")));
    }
    if env::var_os("CRANKSTAR_RENEW").is_some() {
        fs::create_dir_all(folder()).expect("the folder");
        for (name, text) in &files {
            fs::write(folder().join(name), text).expect("a file");
        }
    }
    for (name, text) in &files {
        let stored = fs::read_to_string(folder().join(name)).unwrap_or_default();
        assert!(stored == *text, "reports/v-angles/{name} differs:\n{text}");
        if name.ends_with(".json") {
            let told = call(&["verify", folder().join(name).to_str().expect("UTF-8")]);
            assert!(told.status.success(), "{name}: {}", String::from_utf8_lossy(&told.stdout));
        }
    }
    let listed = fs::read_dir(folder()).expect("the folder").count();
    assert_eq!(listed, files.len(), "a file that the page does not have");
}

#[test]
fn every_star_of_a_class_vanishes_where_its_first_star_does_and_its_moments_at_the_same_points() {
    let found = found();
    let points = &found.classes[&[false; 3]].places;
    let (mut judged, mut vanishing) = (0, [0; 2]);
    for star in (1..=MOST).flat_map(stars) {
        let class = &found.classes[&star.forces()];
        let moments = star.moments();
        for (at, order) in verdicts(&star).iter().enumerate() {
            assert_eq!(order.order, ORDERS[at]);
            assert_eq!(balanced(&order.force), class.places[at], "{}", star.list());
            let expected = if moments[at] { &Places::Everywhere } else { &points[at] };
            assert_eq!(balanced(&order.moment), *expected, "{}", star.list());
            vanishing[0] += usize::from(star.forces()[at]);
            vanishing[1] += usize::from(moments[at]);
        }
        judged += 1;
    }
    assert!(judged > 700 && vanishing.iter().all(|count| *count > 20), "{judged} {vanishing:?}");
}

/// The two forces of order k, in time: each piston along its bank, at a few angles of the crank; their greatest length.
fn shaking(order: u32, throws: &[i64], [phi, delta]: [f64; 2]) -> f64 {
    let k = f64::from(order);
    let at = |theta: f64| {
        let banks = [(-phi / 2.0, 0.0), (phi / 2.0, delta)];
        let pistons =
            throws.iter().flat_map(|throw| banks.map(|(bank, split)| ((*throw as f64).to_radians() + split, bank)));
        let force = pistons.fold([0.0; 2], |[x, y], (throw, bank)| {
            let push = (k * (theta + throw - bank)).cos();
            [x + push * bank.cos(), y + push * bank.sin()]
        });
        force[0].hypot(force[1])
    };
    (0..8).map(|step| at(TAU * f64::from(step) / 8.0 / k)).fold(0.0, f64::max)
}

#[test]
fn a_search_in_time_finds_the_points_and_no_others() {
    let found = found();
    let mut points = 0;
    for class in found.classes.values() {
        let (throws, count) = (class.first.degrees(), 2.0 * class.first.count() as f64);
        for (order, places) in ORDERS.into_iter().zip(&class.places) {
            // Between two neighbours of the grid no force changes by more than this.
            let step = TAU / 120.0;
            let change = count * f64::from(order + 1) * step;
            let grid = (0..120).flat_map(|i| (0..120).map(move |j| [f64::from(i) * step, f64::from(j) * step]));
            match places {
                Places::Everywhere => {
                    assert!(grid.into_iter().all(|at| shaking(order, &throws, at) < 1e-9));
                }
                Places::At(told) => {
                    let told: Vec<[f64; 2]> =
                        told.iter().map(|place| place.each_ref().map(|turns| TAU * float(turns))).collect();
                    points += told.len();
                    assert!(told.iter().all(|at| shaking(order, &throws, *at) < 1e-9), "{}", class.first.list());
                    let mut reached = vec![false; told.len()];
                    for at in grid.filter(|at| shaking(order, &throws, *at) < change) {
                        let zero = descended(order, &throws, at);
                        if shaking(order, &throws, zero) < 1e-7 {
                            let near = told.iter().position(|one| near(*one, zero));
                            reached[near.unwrap_or_else(|| panic!("order {order} at {zero:?}"))] = true;
                        }
                    }
                    assert!(reached.iter().all(|reached| *reached), "order {order}: {reached:?}");
                }
            }
        }
    }
    assert!(points > 30, "{points}");
}

/// Downhill from a point, in ever smaller steps.
fn descended(order: u32, throws: &[i64], mut at: [f64; 2]) -> [f64; 2] {
    let mut step = TAU / 240.0;
    let mut least = shaking(order, throws, at);
    while step > 1e-10 {
        let sides =
            [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]];
        let next = sides.map(|[x, y]| [at[0] + step * x, at[1] + step * y]);
        let lengths = next.map(|at| shaking(order, throws, at));
        match (0..8).find(|&side| lengths[side] < least) {
            Some(side) => (at, least) = (next[side], lengths[side]),
            None => step /= 2.0,
        }
    }
    at
}

fn near(one: [f64; 2], other: [f64; 2]) -> bool {
    let apart = |at: usize| {
        let difference = (one[at] - other[at]).rem_euclid(TAU);
        difference.min(TAU - difference)
    };
    apart(0) < 1e-4 && apart(1) < 1e-4
}

#[test]
fn even_firing_lines_are_those_that_top_dead_centres_on_a_grid_have() {
    let mut found = 0;
    for count in 1..=MOST {
        for star in stars(count) {
            for (cycle, turns) in CYCLES.into_iter().zip([2, 1]) {
                let listed = star.even(cycle);
                let cylinders = 2 * count as i64;
                // In units of this part of a turn; it is four times as fine as the grid of the stars.
                let unit = 4 * cylinders;
                let throws: Vec<i64> = star.degrees().iter().map(|degrees| degrees * unit / 360).collect();
                let mut even: Vec<i64> = (0..cylinders).map(|at| (at * 4 * turns).rem_euclid(unit)).collect();
                even.sort_unstable();
                for apart in 0..unit {
                    let centres = throws.iter().flat_map(|throw| [-throw, apart - throw]);
                    let mut centres: Vec<i64> = centres.map(|centre| (centre + throws[0]).rem_euclid(unit)).collect();
                    centres.sort_unstable();
                    let place = format!("{} {cycle} {apart}/{unit}", star.list());
                    assert_eq!(listed.contains(&Turn::fraction(apart, unit)), centres == even, "{place}");
                    found += usize::from(centres == even);
                }
                assert!(listed.iter().all(|turn| (turn.turns() * BigRational::from_integer(unit.into())).is_integer()));
            }
        }
    }
    assert!(found > 40, "{found}");
}

#[test]
fn the_bank_angle_cancels_both_vectors_only_at_0_and_180_degrees_or_where_each_bank_balances_alone() {
    let (mut dice, mut balanced) = (Dice::new(11), [0; 3]);
    for _ in 0..3000 {
        let throws: Vec<i64> = (0..2 + dice.below(3)).map(|_| 60 * dice.below(6) as i64).collect();
        let split: Vec<i64> = throws.iter().map(|throw| throw + 60 * dice.below(6) as i64).collect();
        let (k, phi) = (1 + dice.below(4) as i64, 30 * dice.below(12) as i64);
        let term =
            |degrees: i64| Term { angle: Turn::fraction(degrees, 360), weight: BigRational::from_integer(1.into()) };
        let star = |throws: &[i64]| PhasorSum::new(throws.iter().map(|throw| term(k * throw)).collect());
        let vector = |of_throw: i64, of_bank: i64| {
            let phase = |throw: &i64, bank: i64| of_throw * throw + of_bank * bank;
            let both = throws
                .iter()
                .map(|throw| phase(throw, -phi / 2))
                .chain(split.iter().map(|throw| phase(throw, phi / 2)));
            PhasorSum::new(both.map(term).collect())
        };
        let both = vector(k, 1 - k).vanishes() && vector(-k, k + 1).vanishes();
        let [one, two] = [star(&throws), star(&split)];
        let alone = one.vanishes() && two.vanishes();
        let signed = if k % 2 == 0 { one.minus(&two) } else { one.plus(&two) };
        let expected = [alone, phi == 0 && one.plus(&two).vanishes(), phi == 180 && signed.vanishes()];
        assert_eq!(both, expected.contains(&true), "{throws:?} {split:?} order {k} at {phi}");
        balanced.iter_mut().zip(expected).for_each(|(count, holds)| *count += usize::from(holds));
    }
    assert!(balanced.iter().all(|count| *count > 20), "{balanced:?}");
}
