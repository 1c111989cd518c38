//! Do firing stars tell which orders of the gas torque vanish? Against the tables of the theory, and sums computed by hand.

use std::f64::consts::TAU;

use crankstar::engine::{Cycle, CycleOrder, Cylinder, Draft, Engine, Firing};
use crankstar::exact::Turn;
use crankstar::file;
use crankstar::firing::{FiringPattern, NoStar, Weights, firing_stars, pattern};
use crankstar::motion::SliderCrank;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use crate::support::dice::Dice;
use crate::support::written::ratio;

/// A four-stroke engine in line whose cylinders fire in their order after these intervals in degrees.
fn firing_after(intervals: &[i64]) -> Engine {
    let mut angles = vec![0];
    for interval in &intervals[..intervals.len() - 1] {
        angles.push(angles.last().expect("one") + interval);
    }
    of_angles(
        &angles.iter().map(|&angle| BigRational::new(angle.into(), 360.into())).collect::<Vec<_>>(),
        Cycle::FourStroke,
    )
}

/// An engine in line whose cylinders fire at these angles, in turns.
fn of_angles(angles: &[BigRational], cycle: Cycle) -> Engine {
    let mut draft = Draft::new("of intervals");
    for (place, angle) in angles.iter().enumerate() {
        let position = BigRational::from_integer(place.into());
        draft.cylinders.push(Cylinder::new(Turn::new(-angle), Turn::zero(), position, place));
    }
    let cylinders = draft.cylinders.clone();
    draft.cycle = Some(cycle);
    draft.firing = Some(Firing::from_angles(angles, cycle, &cylinders).expect("they fire at their dead centres"));
    draft.build().expect("an engine")
}

fn order(text: &str) -> CycleOrder {
    text.parse().expect("an order")
}

/// `|S_κ|` in decimals, and whether it is proved to be zero.
fn length(engine: &Engine, at: &str, weights: &Weights) -> (f64, bool) {
    let stars = firing_stars(engine, &[order(at)], weights).expect("stars");
    let star = stars[0].only().expect("one class");
    (crankstar::numbers::evaluate(&star.sum).norm(), star.vanishes())
}

fn assert_lengths(name: &str, engine: &Engine, weights: &Weights, right: &[(&str, f64)]) {
    for (at, right) in right {
        let (length, is_zero) = length(engine, at, weights);
        assert_eq!(is_zero, *right == 0.0, "{name}, order {at}");
        assert!((length - right).abs() < 1e-8, "{name}, order {at}: {length} for {right}");
    }
}

fn root(value: f64) -> f64 {
    value.sqrt()
}

/// Firing intervals in degrees, and the length of the star at some orders.
type Row = (&'static [i64], Vec<(&'static str, f64)>);

/// The table of `theory-gas`, section 8; its values by 40-digit arithmetic.
#[test]
fn stars_have_the_lengths_of_the_table_of_intervals() {
    let (two, three) = (root(2.0), root(3.0));
    let degrees = f64::to_radians;
    let table: Vec<Row> = vec![
        (&[180, 540], vec![("1/2", two), ("1", 0.0), ("2", 2.0)]),
        (&[270, 450], vec![("1/2", root(2.0 - two)), ("1", two), ("3/2", root(2.0 + two)), ("2", 0.0)]),
        (
            &[315, 405],
            vec![
                ("1/2", root(2.0 - root(2.0 + two))),
                ("1", root(2.0 + two)),
                ("3/2", root(2.0 - root(2.0 - two))),
                ("2", two),
                ("4", 0.0),
                ("8", 2.0),
            ],
        ),
        (
            &[300, 420],
            vec![
                ("1/2", (root(6.0) - two) / 2.0),
                ("1", three),
                ("2", 1.0),
                ("5/2", (root(6.0) + two) / 2.0),
                ("3", 0.0),
                ("6", 2.0),
            ],
        ),
        (&[308, 412], vec![("1/2", 2.0 * degrees(77.0).cos()), ("1", 2.0 * degrees(26.0).cos())]),
        (&[240, 240, 240], vec![("1/2", 0.0), ("3/2", 3.0)]),
        (&[144, 144, 144, 144, 144], vec![("1", 0.0), ("5/2", 5.0)]),
        (&[180, 180, 180, 180], vec![("1/2", 0.0), ("2", 4.0)]),
        (&[120, 120, 120, 120, 120, 120], vec![("3/2", 0.0), ("3", 6.0)]),
        (
            &[270, 180, 90, 180],
            vec![("1/2", root(4.0 - 2.0 * two)), ("1", 0.0), ("3/2", root(4.0 + 2.0 * two)), ("2", 0.0), ("4", 4.0)],
        ),
        (&[90, 200, 90, 340], vec![("1/2", 1.111_263_734), ("1", 2.316_911_861), ("2", 0.0), ("9/2", two)]),
        (&[120, 300, 300], vec![("1/2", three - 1.0), ("1", 2.0), ("2", 0.0), ("5/2", three + 1.0), ("6", 3.0)]),
        (&[60, 180, 60, 180, 60, 180], vec![("3/2", 3.0 * two), ("3", 0.0), ("6", 6.0)]),
        (
            &[90, 150, 90, 150, 90, 150],
            vec![
                ("1", 0.0),
                ("3/2", 3.0 * root(2.0 - two)),
                ("3", 3.0 * two),
                ("9/2", 3.0 * root(2.0 + two)),
                ("6", 0.0),
                ("9", 3.0 * two),
                ("12", 6.0),
            ],
        ),
        (
            &[90, 54, 90, 54, 90, 54, 90, 54, 90, 54],
            vec![("5/2", 5.0 * root(2.0 - two)), ("5", 5.0 * two), ("15/2", 5.0 * root(2.0 + two))],
        ),
    ];
    for (intervals, right) in table {
        assert_lengths(&format!("{intervals:?}"), &firing_after(intervals), &Weights::Rigid, &right);
    }
}

fn shape(values: &[&str]) -> Weights {
    Weights::ModeShape(values.iter().map(|value| file::parse_number(value).expect("a number")).collect())
}

/// The table of `theory-gas`, section 3.
#[test]
fn phase_vector_sums_of_a_six_tell_its_four_firing_orders_apart() {
    let delta = shape(&["6", "5", "4", "3", "2", "1"]);
    let orders = [
        ("1-5-3-6-2-4", 2.0 * root(3.0), 9.0),
        ("1-5-4-6-2-3", 2.0 * root(7.0), 7.0),
        ("1-2-3-6-5-4", 4.0 * root(3.0), 3.0),
        ("1-2-4-6-5-3", 2.0 * root(13.0), 1.0),
    ];
    for (firing_order, half, three_halves) in orders {
        let layout = format!(
            "title = \"Six\"\ncycle = \"four-stroke\"\nfiring_order = \"{firing_order}\"\n[inline]\nthrows = [0, 240, 120, 120, 240, 0]\n"
        );
        let engine = file::parse("six.toml", &layout).expect("a six");
        let right = [
            ("1/2", half),
            ("5/2", half),
            ("7/2", half),
            ("1", 0.0),
            ("2", 0.0),
            ("3/2", three_halves),
            ("9/2", three_halves),
            ("3", 21.0),
            ("6", 21.0),
        ];
        assert_lengths(firing_order, &engine, &delta, &right);
    }
}

#[test]
fn a_node_in_the_middle_of_a_six_doubles_the_minor_orders_and_takes_away_the_major_one() {
    let engine = file::find("I6").expect("known").engine().expect("reads");
    let delta = shape(&["5", "3", "1", "-1", "-3", "-5"]);
    let right = [("1/2", 4.0 * root(3.0)), ("3/2", 18.0), ("3", 0.0), ("6", 0.0)];
    assert_lengths("I6", &engine, &delta, &right);
}

#[test]
fn a_mode_shape_without_deflection_is_none() {
    let engine = file::find("I4").expect("known").engine().expect("reads");
    let of = |values: &[&str]| firing_stars(&engine, &[CycleOrder::of_halves(2).expect("order 1")], &shape(values));
    assert_eq!(of(&["0", "0", "0", "0"]).expect_err("no shape"), NoStar::NoDeflection);
    assert!(of(&["0", "0", "0", "1"]).is_ok());
}

/// At the last order of a period all firing phases agree: it is major for a shape of any signs, as for the rigid shaft.
#[test]
fn major_orders_are_those_of_the_rigid_shaft_in_every_mode_shape() {
    for (name, values) in [
        ("I4", &["5", "2", "-1", "2"][..]),
        ("I4", &["1", "0", "0", "-1"]),
        ("I6", &["5", "3", "1", "-1", "1", "6"]),
        ("I6", &["5", "3", "1", "-1", "-3", "-5"]),
        ("V6-60-even", &["3", "2", "-1", "3", "2", "-1"]),
        ("V8-crossplane", &["1", "0", "-1", "-2", "1", "0", "-1", "-2"]),
    ] {
        let engine = file::find(name).expect("known").engine().expect("reads");
        let major = |weights: &Weights| {
            let pattern = pattern(&engine, weights).expect("a pattern");
            let major = pattern.orders.iter().filter(|order| order.is_major());
            (major.map(|order| order.order).collect::<Vec<_>>(), pattern)
        };
        let (rigid, _) = major(&Weights::Rigid);
        let (found, pattern) = major(&shape(values));
        assert_eq!(found, rigid, "{name} {values:?}");
        let last = CycleOrder::of_halves(engine.cylinders().len() as u32).expect("an order");
        assert_eq!(found.last(), Some(&last), "{name} fires evenly");
        assert!(pattern.strongest_minor().iter().all(|order| order.order != last && !order.vanishes()), "{name}");
    }
}

/// `theory-gas`, section 3: a linear shape cannot tell the two orders apart, the real first mode can.
#[test]
fn two_firing_orders_of_a_cross_plane_eight_differ_in_its_real_mode_alone() {
    // Numbered by pin: 1 and 2 on the first.
    let eight = |firing_order: &str| {
        let names: Vec<usize> = firing_order.split('-').map(|name| name.parse().expect("a number")).collect();
        let angle = |name: usize| names.iter().position(|fired| *fired == name).expect("each fires");
        let angles: Vec<BigRational> = (1..=8).map(|name| BigRational::new(angle(name).into(), 4.into())).collect();
        of_angles(&angles, Cycle::FourStroke)
    };
    let usual = ["1-8-4-3-6-5-7-2", "1-8-7-2-6-5-4-3"];
    let linear = shape(&["4", "4", "3", "3", "2", "2", "1", "1"]);
    let real = shape(&["1", "1", "0.8383", "0.8383", "0.5411", "0.5411", "0.1564", "0.1564"]);
    for (firing_order, half, three_halves) in [(usual[0], 0.4220, 1.2334), (usual[1], 0.8427, 0.9946)] {
        let two = root(2.0);
        let right = [
            ("1/2", root(10.0 - 4.0 * two)),
            ("3/2", root(10.0 + 4.0 * two)),
            ("1", 2.0 * root(5.0)),
            ("2", 0.0),
            ("4", 20.0),
        ];
        let engine = eight(firing_order);
        assert_lengths(firing_order, &engine, &linear, &right);
        for (at, right) in [("1/2", half), ("3/2", three_halves), ("1", 1.2649)] {
            let (length, _) = length(&engine, at, &real);
            assert!((length - right).abs() < 6e-5, "{firing_order}, order {at}: {length} for {right}");
        }
    }
}

/// `theory-gas`, section 2: even firing of n cylinders leaves the multiples of n/2 (n in a two-stroke) and nothing else.
#[test]
fn even_firing_leaves_the_major_orders_alone() {
    for cylinders in 1..=24_i64 {
        for (cycle, turns) in [(Cycle::FourStroke, 2), (Cycle::TwoStroke, 1)] {
            let angles: Vec<BigRational> =
                (0..cylinders).map(|j| BigRational::new((turns * j).into(), cylinders.into())).collect();
            let pattern = pattern(&of_angles(&angles, cycle), &Weights::Rigid).expect("a pattern");
            let left: Vec<CycleOrder> = pattern.left().map(|order| order.order).collect();
            assert_eq!(
                left,
                [CycleOrder::of_halves(u32::try_from(2 * cylinders / turns).expect("small")).expect("an order")]
            );
            assert!(pattern.left().all(|order| order.is_major()));
        }
    }
}

/// `theory-gas`, section 2: misfire of one of n leaves 1 at every minor order and n − 1 at the major ones.
#[test]
fn a_cylinder_that_misfires_shows_at_the_half_order() {
    let engine = file::find("I4").expect("known").engine().expect("reads");
    let misfire = shape(&["1", "1", "0", "1"]);
    let right = [("1/2", 1.0), ("1", 1.0), ("3/2", 1.0), ("2", 3.0), ("5/2", 1.0), ("4", 3.0)];
    assert_lengths("I4", &engine, &misfire, &right);
}

/// Random firing angles and deflections against sums in doubles.
#[test]
fn random_stars_are_the_sums_in_decimals_and_repeat_with_their_period() {
    let mut dice = Dice::new(13);
    for _ in 0..200 {
        let cylinders = dice.below(9) + 1;
        let denominator = [2_i64, 3, 8, 12, 36, 40, 360][dice.below(7) as usize];
        let mut angles = vec![BigRational::from_integer(0.into())];
        for _ in 1..cylinders {
            let numerator = dice.below(2 * denominator.unsigned_abs());
            angles.push(BigRational::new(numerator.into(), denominator.into()));
        }
        let engine = of_angles(&angles, Cycle::FourStroke);
        let deltas: Vec<BigRational> =
            (0..cylinders).map(|_| BigRational::new((dice.below(9) as i64 - 4).into(), 3.into())).collect();
        let weights = Weights::ModeShape(deltas.clone());
        if deltas.iter().all(Zero::is_zero) {
            assert!(pattern(&engine, &weights).is_err(), "it deflects nothing");
            continue;
        }
        let pattern = pattern(&engine, &weights).expect("a short period");
        for halves in [1, 2, 3, 5, 8, 13, 40] {
            let at = CycleOrder::of_halves(halves).expect("an order");
            let stars = firing_stars(&engine, &[at], &weights).expect("stars");
            let (mut re, mut im) = (0.0, 0.0);
            for (angle, delta) in angles.iter().zip(&deltas) {
                let turn = -f64::from(halves) / 2.0 * angle.to_f64().expect("small") * TAU;
                let delta = delta.to_f64().expect("small");
                re += delta * turn.cos();
                im += delta * turn.sin();
            }
            let star = stars[0].only().expect("one class");
            let sum = crankstar::numbers::evaluate(&star.sum);
            assert!((sum.re - re).abs() + (sum.im - im).abs() < 1e-9);
            assert_eq!(star.vanishes(), re.hypot(im) < 1e-9, "{angles:?} at {at}");
            assert_eq!(star_of(&pattern, at), star.vanishes());
        }
    }
}

fn star_of(pattern: &FiringPattern, at: CycleOrder) -> bool {
    // It is that of the same place in the first period.
    let index = (at.halves() / pattern.cycle.lowest_order().halves()) as usize;
    pattern.orders[(index + pattern.orders.len() - 1) % pattern.orders.len()].vanishes()
}

/// Cylinders with other rods make another torque from the same pressure: their stars do not cancel.
#[test]
fn unequal_rods_are_judged_apart() {
    let head = "title = \"Two\"\ncycle = \"four-stroke\"\nfiring_angles = [0, 180]\n[inline]\nthrows = [0, 180]\nspacing = \"0.1 m\"\n[mechanism]\n";
    let rods = "reciprocating_mass = \"1 kg\"\ncrank_radius = \"40 mm\"\nrod_length = [\"140 mm\", \"150 mm\"]\n";
    match file::parse("two.toml", &format!("{head}{rods}")) {
        Ok(engine) => {
            let stars = firing_stars(&engine, &[order("1")], &Weights::Rigid).expect("stars");
            assert_eq!(stars[0].stars.len(), 2);
            assert!(!stars[0].vanishes(), "with equal rods order 1 would vanish");
        }
        Err(error) => panic!("{error}"),
    }
}

/// One pressure in two cylinders gives one torque where the pistons move alike, and only there. Motions of endless rods of several slopes are all
/// made of the same two: nothing is said of them.
#[test]
fn a_star_is_that_of_pistons_which_move_alike() {
    let rods = ["0", "1/4", "1/3"].into_iter().flat_map(|ratio| ["0", "3/5", "-3/5"].map(|offset| [ratio, offset]));
    let rods: Vec<[&str; 2]> = rods.collect();
    let moves = |rod: [&str; 2], angle: f64| {
        let crank = SliderCrank::new(ratio(rod[0]), ratio(rod[1])).expect("it turns round");
        crank.position(angle)
    };
    for (one, other) in rods.iter().flat_map(|one| rods.iter().map(move |other| (*one, *other))) {
        let text = format!(
            "cycle = \"four-stroke\"\nfiring_angles = [0, 180]\n[inline]\nthrows = [0, 180]\nspacing = 1\n[mechanism]\n\
             rod_ratio = [\"{}\", \"{}\"]\noffset_ratio = [\"{}\", \"{}\"]\n",
            one[0], other[0], one[1], other[1]
        );
        let engine = file::parse("two.toml", &text).unwrap_or_else(|error| panic!("{error}"));
        let found = firing_stars(&engine, &[order("1")], &Weights::Rigid);
        if one != other && [one[0], other[0]] == ["0", "0"] {
            assert_eq!(found.expect_err("two slopes"), NoStar::EndlessRods, "{one:?} {other:?}");
            continue;
        }
        let pattern = found.expect("stars");
        let alike = (1..7).all(|step| (moves(one, f64::from(step)) - moves(other, f64::from(step))).abs() < 1e-9);
        assert_eq!(pattern[0].stars.len(), if alike { 1 } else { 2 }, "{one:?} {other:?}");
        assert_eq!(pattern[0].vanishes(), alike, "{one:?} {other:?}");
    }
}

#[test]
fn orders_of_a_cycle_are_read_in_every_spelling_and_nothing_else() {
    for (text, halves) in [
        ("1/2", 1),
        ("½", 1),
        ("0.5", 1),
        (".5", 1),
        ("1½", 3),
        ("3/2", 3),
        ("1.5", 3),
        ("2", 4),
        ("4/2", 4),
        ("2.0", 4),
    ] {
        assert_eq!(order(text).halves(), halves, "{text}");
    }
    for text in
        ["", "0", "0/2", "-1", "+1", "1/3", "1.25", "1 2", "½½", "1000.5", "1001", "99999999999", "1e2", "/2", "."]
    {
        assert!(text.parse::<CycleOrder>().is_err(), "{text}");
    }
}
