//! Is a sum solved that is not its own mirror image, or has multiple zeros that are irrational, with evidence that holds?

use std::f64::consts::TAU;

use crankstar::engine::PHI;
use crankstar::exact::{PhasorSum, Term, Turn};
use crankstar::family::{self, Circle, When, Zeros};
use crankstar::file::{self, Layout};
use crankstar::numbers;
use crankstar::page::{Format, svg};
use crankstar::proof::check_open_document;
use crankstar::report;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::support::dice::Dice;
use crate::support::pages;

const REVERSE: usize = 1;

/// Coefficients from the constant one on, each with its terms: exponents of `e^{2πi/N}` and whole weights.
type Polynomial = Vec<PhasorSum>;

fn sum(conductor: i64, terms: &[(i64, i64)]) -> PhasorSum {
    let term = |&(exponent, weight): &(i64, i64)| Term {
        angle: Turn::fraction(exponent, conductor),
        weight: BigRational::from_integer(weight.into()),
    };
    PhasorSum::new(terms.iter().map(term).collect())
}

fn product(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let mut product = vec![sum(1, &[]); a.len() + b.len() - 1];
    for (i, one) in a.iter().enumerate() {
        for (j, other) in b.iter().enumerate() {
            product[i + j] = PhasorSum::new(product[i + j].plus(&one.times(other)).collected());
        }
    }
    product
}

/// The coefficients in decimals.
fn decimals(polynomial: &Polynomial) -> Vec<Complex<f64>> {
    polynomial.iter().map(numbers::evaluate).collect()
}

fn value(coefficients: &[Complex<f64>], turns: f64) -> Complex<f64> {
    let x = Complex::cis(TAU * turns);
    coefficients.iter().rev().fold(Complex::ZERO, |sum, coefficient| sum * x + coefficient)
}

/// A layout file with this polynomial in `e^{iφ}` as the reverse force of order 1: a cylinder for each term, banks turned by half.
fn layout(polynomial: &Polynomial) -> String {
    let cylinder = |exponent: usize, term: &Term| {
        let (throw, bank) = (-term.angle.turns(), BigRational::new(exponent.into(), 2.into()));
        // A negative weight is a crankpin on the other side.
        let half = BigRational::new(i64::from(term.weight < BigRational::from_integer(0.into())).into(), 2.into());
        let mass = if term.weight < BigRational::from_integer(0.into()) { -&term.weight } else { term.weight.clone() };
        format!(
            "[[cylinder]]\nthrow = '{} turn'\nbank = '{bank} phi'\nposition = 0\nreciprocating_mass = '{mass}'\n",
            throw + half
        )
    };
    polynomial.iter().enumerate().flat_map(|(n, sum)| sum.terms().iter().map(move |one| cylinder(n, one))).collect()
}

struct Solved {
    circle: Circle,
    /// In turns, rising.
    zeros: Vec<f64>,
}

/// Solves it, and has the evidence checked.
fn solved(polynomial: &Polynomial) -> Solved {
    let text = layout(polynomial);
    let family = match file::parse_layout("test", &text) {
        Ok(Layout::Open(family)) => *family,
        other => panic!("{text}\n{other:?}"),
    };
    let orders = family::classify(&family, &[1]).expect("orders");
    let checked = check_open_document(&report::open_document(&family, &orders));
    let checked = checked.unwrap_or_else(|fault| panic!("{text}: {fault}"));
    let verdict = &orders[0].force[REVERSE];
    let When::Circle(circle) = &verdict.sums[0].when else { panic!("{text}: {:?}", verdict.sums[0].when) };
    assert!(circle.is_complete(), "{text}");
    assert!(checked.not_covered.iter().all(|words| !words.contains("`open`")), "{:?}", checked.not_covered);
    let [none, turn] = [0, 1].map(|turns: i64| BigRational::from_integer(turns.into()));
    let Zeros::At(found) = verdict.zeros(PHI, [&none, &turn]) else { panic!("not solved: {text}") };
    let float = |value: &BigRational| value.to_f64().expect("a number");
    let irrational = found.irrational.iter().map(|[low, high]| (float(low) + float(high)) / 2.0);
    let mut zeros: Vec<f64> = found.exact.iter().map(float).chain(irrational).filter(|at| *at < 1.0).collect();
    zeros.sort_by(f64::total_cmp);
    Solved { circle: *circle.clone(), zeros }
}

/// Least lengths of a grid, ever finer: where they are 0.
fn searched(polynomial: &Polynomial) -> Vec<f64> {
    let polynomial = &decimals(polynomial);
    let count = 4000;
    let at = |place: usize| (place as f64 - 0.37) / f64::from(count);
    let lengths: Vec<f64> = (0..count as usize + 2).map(|place| value(polynomial, at(place)).norm()).collect();
    let least = (1..=count as usize)
        .filter(|&place| lengths[place] <= lengths[place - 1] && lengths[place] < lengths[place + 1]);
    let narrowed = least.map(|place| {
        let (mut low, mut high) = (at(place - 1), at(place + 1));
        for _ in 0..60 {
            let [one, other] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
            let is_first = value(polynomial, one).norm() < value(polynomial, other).norm();
            if is_first { high = other } else { low = one }
        }
        (low + high) / 2.0
    });
    let mut zeros: Vec<f64> =
        narrowed.filter(|at| value(polynomial, *at).norm() < 1e-8).map(|at| at.rem_euclid(1.0)).collect();
    zeros.sort_by(f64::total_cmp);
    zeros
}

/// `S + (a + b ζ^j + …) x + conj(S) x²` with a real middle, up to a turn: its own mirror image.
fn mirrored(dice: &mut Dice, conductor: i64) -> Polynomial {
    let below = |dice: &mut Dice, n: i64| dice.below(n as u64) as i64;
    let outer = [(0, 2 + below(dice, 2)), (below(dice, conductor), below(dice, 2))];
    let turn = below(dice, conductor);
    let conjugate = outer.map(|(exponent, weight)| (-exponent, weight));
    let turned = |terms: &[(i64, i64)], by: i64| {
        let terms: Vec<(i64, i64)> = terms.iter().map(|(exponent, weight)| (exponent + by, *weight)).collect();
        sum(conductor, &terms)
    };
    let (j, weight) = (below(dice, conductor), below(dice, 2));
    let middle = [(0, 1 - below(dice, 3)), (j, weight), (-j, weight)];
    vec![turned(&outer, turn), turned(&middle, turn), turned(&conjugate, turn)]
}

/// `a + S x` or `S + a x`, with S too short or too long for a zero on the circle.
fn without(dice: &mut Dice, conductor: i64) -> Polynomial {
    let small = sum(conductor, &[(dice.below(conductor as u64) as i64, 1), (dice.below(conductor as u64) as i64, 1)]);
    let large = sum(conductor, &[(dice.below(conductor as u64) as i64, 3)]);
    if dice.below(2) == 0 { vec![small, large] } else { vec![large, small] }
}

#[test]
fn products_with_factors_off_the_circle_and_squares_are_solved_as_a_dense_search_finds_them() {
    let mut dice = Dice::new(29);
    let (mut divided, mut irrational) = (0, 0);
    for round in 0..48 {
        let conductor = 1 + round % 24;
        let factor = mirrored(&mut dice, conductor);
        let distinct = match round % 3 {
            2 => product(&factor, &mirrored(&mut dice, conductor)),
            _ => factor.clone(),
        };
        let mut whole = match dice.below(3) {
            0 => product(&distinct, &factor),
            _ => distinct.clone(),
        };
        whole = product(&whole, &without(&mut dice, conductor));
        if whole.iter().any(PhasorSum::vanishes) {
            continue;
        }
        let searched = searched(&distinct);
        if searched.is_empty() {
            continue;
        }
        let found = solved(&whole);
        let place = format!("{}\n{:?}\n{searched:?}", layout(&whole), found.zeros);
        assert_eq!(found.zeros.len(), searched.len(), "{place}");
        for (one, other) in found.zeros.iter().zip(&searched) {
            assert!((one - other).abs() < 1e-6 && value(&decimals(&whole), *one).norm() < 1e-9, "{place}");
        }
        divided += usize::from(found.circle.claim.divided.is_some());
        irrational += found.circle.irrational().count();
    }
    assert!(divided > 20 && irrational > 40, "{divided} divided, {irrational} irrational zeros");
}

/// (x² − x/2 + 1)(x + 2) and (x² − x/2 + 1)², x = e^{iφ}: zero where cos φ = 1/4.
const LAYOUTS: [(&str, &str); 2] = [
    (
        "cylinder = [{ throw = 0, bank = 0, position = 0, reciprocating_mass = 2 },
                     { throw = 0, bank = 'phi', position = 0, reciprocating_mass = '3/2' }, { throw = 0, bank = '3/2 phi', position = 0 }]",
        "a polynomial of degree 3 in the turn by φ. What it has in common with its mirror image, a polynomial of degree 2",
    ),
    (
        "cylinder = [{ throw = 0, bank = 0, position = 0 }, { throw = 180, bank = 'phi/2', position = 0 },
                     { throw = 0, bank = 'phi', position = 0, reciprocating_mass = '9/4' },
                     { throw = 180, bank = '3/2 phi', position = 0 }, { throw = 0, bank = '2 phi', position = 0 }]",
        "a polynomial of degree 4 in the turn by φ. What it has in common with its mirror image, a polynomial of degree 2",
    ),
];

#[test]
fn pages_tell_the_zeros_in_closed_form_and_why_there_are_no_others() {
    for (text, degrees) in LAYOUTS {
        let Ok(Layout::Open(family)) = file::parse_layout("test", text) else { panic!("not a family: {text}") };
        let orders = family::classify(&family, &[1]).expect("orders");
        let page = report::family_page(&family, &orders, false);
        let markdown = pages::text(&page, Format::GITHUB);
        assert!(markdown.contains(degrees), "{markdown}");
        assert!(markdown.contains("vanishes once, at no rational turn."), "{markdown}");
        assert!(!markdown.contains("left open") && !markdown.contains("not solved"), "{markdown}");
        let answer = pages::text(&report::family_answer(&family, &orders), Format::PLAIN);
        assert!(answer.contains("0 where cos(φ) =") && answer.contains("1/4, φ ≈ ±75.52°"), "{answer}");
    }
}

#[test]
fn irrational_zeros_are_rings_or_dots_of_a_plot_named_as_such() {
    let Ok(Layout::Open(family)) = file::parse_layout("test", LAYOUTS[0].0) else { panic!("not a family") };
    let orders = family::classify(&family, &[1, 2]).expect("orders");
    let markdown = pages::text(&report::family_page(&family, &orders, false), Format::GITHUB);
    assert!(markdown.contains("Marks that the legend calls irrational"), "{markdown}");
    let drawn = svg(&report::amplitudes(&family, &orders).expect("a drawing"), "");
    assert!(drawn.contains("one vector zero, irrational"), "{drawn}");
    // Zeros at rational angles alone: nothing of it.
    let twin = "vee = { bank_angle = 'phi', throws = [0] }";
    let Ok(Layout::Open(family)) = file::parse_layout("test", twin) else { panic!("not a family") };
    let orders = family::classify(&family, &[1, 2]).expect("orders");
    let markdown = pages::text(&report::family_page(&family, &orders, false), Format::GITHUB);
    assert!(!markdown.contains("irrational"), "{markdown}");
}
