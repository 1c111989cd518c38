//! Do answers on open angles name every solution from 0° to 360°, none outside, and no condition twice?

use std::fs;

use crankstar::family::{Place, is_in_range};
use num_rational::BigRational;
use num_traits::Zero;

use crate::support::dice::Dice;
use crate::support::program::{call, scratch};
use crate::support::written::fraction;

/// What `classify` prints of cylinders in one plane with these throws and masses: their moment vanishes.
fn told(name: &str, cylinders: &[(&str, &str)], order: u32) -> String {
    let mut text = format!("orders = [{order}]\n");
    for (throw, mass) in cylinders {
        text +=
            &format!("[[cylinder]]\nthrow = \"{throw}\"\nbank = 0\nposition = 0\nreciprocating_mass = \"{mass}\"\n");
    }
    let path = scratch("open-ranges").join(format!("{name}.toml"));
    fs::write(&path, text).expect("written");
    String::from_utf8(call(&["classify".as_ref(), path.as_os_str()]).stdout).expect("text")
}

#[test]
fn a_condition_that_follows_from_another_is_not_told() {
    for (order, implied) in [(1, "2δ"), (2, "4δ")] {
        let page = told("alike", &[("0", "1"), ("delta", "1"), ("2delta", "1")], order);
        assert!(page.contains("120°") && page.contains("240°") && !page.contains(implied), "{page}");
    }
}

#[test]
fn a_triangle_that_only_a_bank_angle_above_360_makes_is_not_told() {
    let page = told("half", &[("0", "1"), ("phi/2", "1/2"), ("delta", "3/4")], 1);
    assert!(page.contains("133.4°") && !page.contains("226.6°"), "{page}");
}

#[test]
fn every_solution_in_the_range_is_found_and_none_outside() {
    let mut dice = Dice::new(26);
    let mut tried = [0, 0];
    for _ in 0..3000 {
        let mut times = || {
            let mut one = || fraction(dice.below(9) as i64 - 4, dice.below(3) as i64 + 1);
            [one(), one()]
        };
        let [first, second] = [times(), times()];
        let determinant = &first[0] * &second[1] - &first[1] * &second[0];
        if determinant.is_zero() {
            continue;
        }
        let [phi, delta] = [(); 2].map(|()| fraction(dice.below(25) as i64, 24));
        let value = |times: &[BigRational; 2]| &times[0] * &phi + &times[1] * &delta;
        let part = |value: BigRational| &value - value.floor();
        let place = |times: &[BigRational; 2]| Place::exact(times, &part(value(times)));
        // A solution, so that it is in the range.
        assert!(is_in_range(&[place(&first), place(&second)]), "{first:?} {second:?} {phi} {delta}");
        assert!(is_in_range(&[place(&first)]));
        // Two angles at will: all φ and δ that make them.
        let [u, v] = [(); 2].map(|()| fraction(dice.below(24) as i64, 24));
        let whole = -9..=9_i64;
        let found = whole.clone().flat_map(|n| whole.clone().map(move |m| (n, m))).any(|(n, m)| {
            let (u, v) = (&u + fraction(n, 1), &v + fraction(m, 1));
            let phi = (&second[1] * &u - &first[1] * &v) / &determinant;
            let delta = (&first[0] * &v - &second[0] * &u) / &determinant;
            [phi, delta].iter().all(|turns| *turns >= fraction(0, 1) && *turns <= fraction(1, 1))
        });
        let places = [Place::exact(&first, &u), Place::exact(&second, &v)];
        assert_eq!(is_in_range(&places), found, "{first:?} {second:?} {u} {v}");
        tried[usize::from(found)] += 1;
        if tried.iter().sum::<i32>() >= 60 {
            break;
        }
    }
    assert!(tried.iter().all(|&count| count > 5), "{tried:?}");
}
