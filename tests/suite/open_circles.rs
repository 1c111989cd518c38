//! Is every sum with one open angle solved, completely, as a dense search without the solver finds it?

use std::f64::consts::TAU;

use crankstar::engine::{Cylinder, DELTA, Family, Linear, PHI};
use crankstar::family::{self, Circle, Closed, OpenVerdict, Solutions, When, Zeros};
use crankstar::file::{self, Layout};
use crankstar::numbers::Direction;
use crankstar::proof::{Planar, Sense, check_open_document};
use crankstar::report;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use crate::support::dice::Dice;

fn family(text: &str) -> Family {
    match file::parse_layout("test", text) {
        Ok(Layout::Open(family)) => *family,
        Ok(Layout::Known(..)) => panic!("nothing is open in {text}"),
        Err(error) => panic!("{text}: {error}"),
    }
}

fn pick<'a>(dice: &mut Dice, list: &[&'a str]) -> &'a str {
    list[dice.below(list.len() as u64) as usize]
}

fn angle(dice: &mut Dice) -> String {
    match dice.below(6) {
        0 => format!("'{}/7 turn'", dice.below(7)),
        1 => format!("{}", dice.below(360)),
        2 => format!("'{}.5'", dice.below(360)),
        _ => ((45 * dice.below(8) + 30 * dice.below(12)) % 360).to_string(),
    }
}

fn angles(dice: &mut Dice, count: u64) -> String {
    (0..count).map(|_| angle(dice)).collect::<Vec<_>>().join(", ")
}

/// A layout file with one open angle and known lengths: V engines with pins of every kind, W and four-bank fans, and cylinders of any
/// masses whose angles hold any multiples of the unknown.
fn one_unknown(dice: &mut Dice) -> String {
    let count = 1 + dice.below(4);
    let throws = angles(dice, count);
    match dice.below(6) {
        0 => format!("[vee]\nbank_angle = 'phi'\nthrows = [{throws}]\npin_split = {}", angle(dice)),
        1 => format!(
            "[vee]\nbank_angle = {}\nthrows = [{throws}]\npin_split = 'delta'\nbank_offset = '1/3'",
            angle(dice)
        ),
        2 => format!("[vee]\nbank_angle = 'phi'\nthrows = [{throws}]\npin_split = 'phi/3'\nbank_offset = '1/7'"),
        3 => format!(
            "[fan]\nbanks = ['-phi', {}, 'phi']\nthrows = [{throws}]\nbank_offsets = ['1/4', 0, '-1/4']",
            dice.below(2) * 60
        ),
        4 => format!(
            "[fan]\nbanks = ['-phi', '-phi/2', 'phi/2', 'phi']\nthrows = [{throws}]\nbank_offsets = [0, 1, 2, 3]"
        ),
        _ => {
            let unknown = pick(dice, &["phi", "delta"]);
            let cylinder = |dice: &mut Dice, at: u64| {
                let (throw, mass, place) = (angle(dice).replace('\'', ""), 1 + dice.below(4), dice.below(7));
                let [times, of_throw] = [0, 1].map(|_| pick(dice, &["", "-", "2", "1/2 ", "-3/2 ", "-1/3 "]));
                let throw = match dice.below(2) {
                    0 if !throw.contains("turn") => format!("'{throw} + {of_throw}{unknown}'"),
                    _ => format!("'{throw}'"),
                };
                let bank = if at == 0 || dice.below(3) > 0 { format!("'{times}{unknown}'") } else { angle(dice) };
                format!(
                    "[[cylinder]]\nthrow = {throw}\nbank = {bank}\nposition = '{place}/2'\nreciprocating_mass = '{mass}/2'\n"
                )
            };
            (0..=count).map(|at| cylinder(dice, at)).collect()
        }
    }
}

/// The sum at an angle in turns, straight from the cylinders, in decimals.
struct Star {
    terms: Vec<(f64, f64, f64)>,
    total: f64,
}

impl Star {
    fn of(family: &Family, verdict: &OpenVerdict, unknown: &str) -> Star {
        let float = |value: &BigRational| value.to_f64().expect("a number");
        let k = f64::from(verdict.order);
        let [of_throw, of_bank] = match verdict.sense {
            Sense::Direct => [k, 1.0 - k],
            Sense::Reverse => [-k, 1.0 + k],
        };
        let terms = family.cylinders().iter().map(|cylinder: &Cylinder<Linear, Linear>| {
            let known = of_throw * float(cylinder.throw.known()) + of_bank * float(cylinder.bank.known());
            let times = of_throw * float(&cylinder.throw.coefficient(unknown))
                + of_bank * float(&cylinder.bank.coefficient(unknown));
            let arm = match verdict.quantity {
                Planar::Moment => float(cylinder.position.known()) - float(family.reference_plane().known()),
                _ => 1.0,
            };
            let weight = float(&cylinder.reciprocating_mass) * float(&cylinder.crank_radius) * arm;
            (known, times, weight)
        });
        let terms: Vec<(f64, f64, f64)> = terms.collect();
        let total = terms.iter().map(|(_, _, weight)| weight.abs()).sum();
        Star { terms, total }
    }

    fn at(&self, turns: f64) -> Complex<f64> {
        self.terms
            .iter()
            .map(|(known, times, weight)| Complex::from_polar(*weight, TAU * (known + times * turns)))
            .sum()
    }

    fn length(&self, turns: f64) -> f64 {
        self.at(turns).norm() / self.total
    }

    /// Where a grid and golden sections end at 0, in [0, 1].
    fn zeros(&self) -> Vec<f64> {
        let most = self.terms.iter().map(|(_, times, _)| times.abs()).fold(1.0, f64::max);
        let count = (200.0 * most) as usize;
        // The ends of the range are inside, and no point of the grid.
        let at = |place: usize| (place as f64 - 2.3) / count as f64;
        let lengths: Vec<f64> = (0..count + 6).map(|place| self.length(at(place))).collect();
        let least = (1..count + 5)
            .filter(|&place| lengths[place] <= lengths[place - 1] && lengths[place] <= lengths[place + 1]);
        let found = least.map(|place| self.least_between(at(place - 1), at(place + 1)));
        let inside = |at: &f64| (-1e-6..=1.0 + 1e-6).contains(at);
        let mut zeros: Vec<f64> = found.filter(|&at| self.length(at) < 1e-7).filter(inside).collect();
        zeros.dedup_by(|b, a| (*b - *a).abs() < 1e-5);
        zeros
    }

    fn least_between(&self, mut low: f64, mut high: f64) -> f64 {
        for _ in 0..60 {
            let [one, other] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
            if self.length(one) < self.length(other) { high = other } else { low = one }
        }
        (low + high) / 2.0
    }
}

fn decimals(found: &Solutions) -> Vec<f64> {
    let float = |value: &BigRational| value.to_f64().expect("a number");
    let irrational = found.irrational.iter().map(|[low, high]| (float(low) + float(high)) / 2.0);
    let mut all: Vec<f64> = found.exact.iter().map(float).chain(irrational).collect();
    all.sort_by(f64::total_cmp);
    all
}

#[test]
fn three_hundred_families_with_one_open_angle_are_solved_as_a_dense_search_finds_them() {
    let mut dice = Dice::new(16);
    let [none, turn] = [BigRational::zero(), BigRational::from_integer(1.into())];
    let (mut zeros, mut circles) = (0, 0);
    for _ in 0..300 {
        let text = one_unknown(&mut dice);
        let family = family(&text);
        let unknown = if family.open_angles().contains(PHI) { PHI } else { DELTA };
        let orders = family::classify(&family, &[1, 2, 4]).expect("orders");
        for verdict in orders.iter().flat_map(|order| order.force.iter().chain(&order.moment)) {
            let place = format!("{text}\norder {} {:?} {:?}", verdict.order, verdict.quantity, verdict.sense);
            let star = Star::of(&family, verdict, unknown);
            let found = match verdict.zeros(unknown, [&none, &turn]) {
                Zeros::Everywhere => {
                    assert!((0..50).all(|at| star.length(f64::from(at) / 7.0) < 1e-9 || star.total == 0.0), "{place}");
                    continue;
                }
                Zeros::NotSolved => panic!("not solved: {place}"),
                Zeros::At(found) => found,
            };
            assert!(found.open.is_empty(), "{place}: {:?}", found.open);
            circles += verdict.sums.iter().filter(|sum| matches!(sum.when, When::Circle(_))).count();
            let (listed, searched) = (decimals(&found), star.zeros());
            zeros += listed.len();
            assert_eq!(listed.len(), searched.len(), "{place}\n{listed:?}\n{searched:?}");
            for (one, other) in listed.iter().zip(&searched) {
                assert!((one - other).abs() < 1e-4 && star.length(*one) < 1e-11, "{place}\n{listed:?}\n{searched:?}");
            }
        }
        let checked = check_open_document(&report::open_document(&family, &orders));
        let checked = checked.unwrap_or_else(|fault| panic!("{text}: {fault:?}"));
        assert!(checked.not_covered.iter().all(|words| !words.contains("not-solved")), "{text}");
    }
    assert!(zeros > 1000 && circles > 100, "{zeros} zeros, {circles} circles");
}

fn reverse_force(family: &Family) -> OpenVerdict {
    family::classify(family, &[1]).expect("orders").remove(0).force[1].clone()
}

fn circle_of(verdict: &OpenVerdict) -> &Circle {
    let [sum] = verdict.sums.as_slice() else { panic!("{verdict:?}") };
    let When::Circle(circle) = &sum.when else { panic!("{:?}", sum.when) };
    circle
}

#[test]
fn two_parts_in_an_irrational_direction_cancel_at_an_arctangent() {
    // (1 − 2i) e^{−iφ} + (2 − i) e^{iφ}: 2φ = arg(−4 + 3i).
    let family = family(
        "cylinder = [{ throw = 0, bank = '-phi/2', position = 0 }, { throw = 90, bank = '-phi/2', position = 0, reciprocating_mass = 2 },
                     { throw = 0, bank = 'phi/2', position = 1, reciprocating_mass = 2 }, { throw = 90, bank = 'phi/2', position = 1 }]",
    );
    let verdict = reverse_force(&family);
    let circle = circle_of(&verdict);
    let Some(Closed::Argument(Direction::Arctangent { tangent, opposite: true })) = circle.closed() else {
        panic!("{:?}", circle.closed())
    };
    assert!((tangent.to_float() + 0.75).abs() < 1e-12);
    assert!(circle.is_complete() && circle.irrational().count() == 1 && circle.rational().next().is_none());
}

#[test]
fn a_cosine_that_is_not_rational_is_written_with_its_root() {
    let family = family(
        "cylinder = [{ throw = 0, bank = '-phi', position = 0 }, { throw = 0, bank = 0, position = 0, reciprocating_mass = '1/2' },
                     { throw = 90, bank = 0, position = 1, reciprocating_mass = '1/2' }, { throw = 90, bank = 'phi', position = 1 }]",
    );
    let verdict = reverse_force(&family);
    let Some(Closed::Cosine { turn, cosine }) = circle_of(&verdict).closed() else { panic!("{verdict:?}") };
    let found = decimals(&match verdict.zeros(PHI, [&BigRational::zero(), &BigRational::from_integer(1.into())]) {
        Zeros::At(found) => found,
        other => panic!("{other:?}"),
    });
    let turn = turn.turns().to_f64().expect("a number");
    assert_eq!(found.len(), 4);
    for at in found {
        assert!(((TAU * (2.0 * at + turn)).cos() - cosine.to_float()).abs() < 1e-11, "{at}");
    }
    assert!((cosine.to_float().abs() - 2_f64.sqrt() / 4.0).abs() < 1e-12);
}

/// (x² − x/2 + 1)(x + 2), x = e^{iφ}: 0 where cos φ = 1/4. All throws stand at this turn.
fn not_its_own_mirror_image(turn: &str) -> (Solutions, OpenVerdict, Vec<&'static str>) {
    let family = family(&format!(
        "cylinder = [{{ throw = '{turn} turn', bank = 0, position = 0, reciprocating_mass = 2 }},
                     {{ throw = '{turn} turn', bank = 'phi', position = 0, reciprocating_mass = '3/2' }},
                     {{ throw = '{turn} turn', bank = '3/2 phi', position = 1 }}]"
    ));
    let orders = family::classify(&family, &[1]).expect("orders");
    let verdict = orders[0].force[1].clone();
    let Zeros::At(found) = verdict.zeros(PHI, [&BigRational::zero(), &BigRational::from_integer(1.into())]) else {
        panic!("not solved")
    };
    let checked = check_open_document(&report::open_document(&family, &orders)).expect("it holds");
    (found, verdict, checked.not_covered)
}

#[test]
fn a_sum_with_an_irrational_zero_that_is_not_its_own_mirror_image_is_solved_in_closed_form() {
    for turn in ["0", "1/7", "5/24"] {
        let (found, verdict, not_covered) = not_its_own_mirror_image(turn);
        let zero = 0.25_f64.acos() / TAU;
        assert!(found.exact.is_empty() && found.open.is_empty());
        let [first, second] = decimals(&found)[..] else { panic!("{found:?}") };
        assert!((first - zero).abs() < 1e-12 && (second - 1.0 + zero).abs() < 1e-12);
        let Some(Closed::Cosine { turn, cosine }) = circle_of(&verdict).closed() else { panic!("{verdict:?}") };
        assert!(turn.turns().is_zero() && (cosine.to_float() - 0.25).abs() < 1e-15);
        assert!(not_covered.iter().all(|words| !words.contains("`open`")));
    }
}

#[test]
fn where_the_count_of_products_ends_two_open_arcs_are_named() {
    let (found, _, not_covered) = not_its_own_mirror_image("1/1009");
    assert!(found.exact.is_empty() && found.irrational.is_empty());
    let float = |value: &BigRational| value.to_f64().expect("a number");
    let zero = 0.25_f64.acos() / TAU;
    let [first, second] = found.open.as_slice() else { panic!("{:?}", found.open) };
    for ([low, high], zero) in [(first, zero), (second, 1.0 - zero)] {
        assert!(float(low) - 1e-12 < zero && zero < float(high) + 1e-12 && float(high) - float(low) < 1e-9);
    }
    assert!(not_covered.iter().any(|words| words.contains("`open`")));
}
