//! Do the facts that are known about real engines come out, exactly?
use std::collections::BTreeSet;

use crankstar::engine::Engine;
use crankstar::exact::{PhasorSum, Term, Turn};
use crankstar::file::{catalogue, parse};
use crankstar::numbers::evaluate;
use crankstar::proof::Shape::{self, Balanced, CounterRotating, Planar, Rotating};
use crankstar::proof::{
    self,
    Planar::{Force, Moment},
};
use crankstar::text::Untrusted;
use crankstar::verdict::Balance;
use num_rational::BigRational;

use crate::support::verdicts::pistons;
use crate::support::written::of_catalogue as engine;

fn balance(layout: &Engine, quantity: proof::Planar, order: u32) -> Balance {
    let order = pistons(layout, &[order]).remove(0);
    order.balance(quantity).clone()
}

/// `weight · e^{2πi·angle}` for each pair, the angle as a fraction of a turn.
fn sum(terms: &[((i64, i64), i64)]) -> PhasorSum {
    let term = |&((turns, of), weight): &((i64, i64), i64)| Term {
        angle: Turn::fraction(turns, of),
        weight: BigRational::from_integer(weight.into()),
    };
    PhasorSum::new(terms.iter().map(term).collect())
}

fn whole(number: i64) -> PhasorSum {
    sum(&[((0, 1), number)])
}

fn quarters(number: i64) -> PhasorSum {
    whole(number).scaled(&BigRational::new(1.into(), 4.into()))
}

/// `a + b√3`, for √3 = 2 cos 30°.
fn with_root_3(a: i64, b: i64) -> PhasorSum {
    sum(&[((0, 1), a), ((1, 12), b), ((-1, 12), b)])
}

/// `(a + b√5) / 2`, for √5 = 1 + 4 cos 72°.
fn half_with_root_5(a: i64, b: i64) -> PhasorSum {
    sum(&[((0, 1), a + b), ((1, 5), 2 * b), ((-1, 5), 2 * b)]).scaled(&BigRational::new(1.into(), 2.into()))
}

#[track_caller]
fn assert_equal(left: &PhasorSum, right: &PhasorSum, what: &str) {
    let (l, r) = (evaluate(left), evaluate(right));
    assert!(left.minus(right).vanishes(), "{what}: {l} instead of {r}");
}

/// The coefficient `½(|direct| + |reverse|)` squared, where one vector vanishes or both are equal.
fn coefficient_squared(balance: &Balance) -> PhasorSum {
    let quarter = BigRational::new(1.into(), 4.into());
    match balance.shape {
        Planar => balance.direct.sum.squared_modulus(),
        Rotating => balance.direct.sum.squared_modulus().scaled(&quarter),
        CounterRotating => balance.reverse.sum.squared_modulus().scaled(&quarter),
        other => panic!("a coefficient of one vector was asked of a shape {other:?}"),
    }
}

#[track_caller]
fn assert_left(layout: &Engine, quantity: proof::Planar, order: u32, shape: Shape, squared: &PhasorSum) {
    let what = format!("{}, {quantity:?} of order {order}", layout.title().written());
    let balance = balance(layout, quantity, order);
    assert_eq!(balance.shape, shape, "{what}");
    assert_equal(&coefficient_squared(&balance), squared, &what);
}

/// What is left: engine, quantity, order, shape, the coefficient squared, who says so.
#[rustfmt::skip]
fn left() -> Vec<(&'static str, proof::Planar, u32, Shape, PhasorSum, &'static str)> {
    vec![
        ("I2-180",         Force,  2, Planar,   whole(4),                  "Stabile 4.1.1"),
        ("I2-180",         Moment, 1, Planar,   whole(1),                  "Stabile 4.1.1"),
        ("I2-270",         Force,  1, Planar,   whole(2),                  "Stabile 4.1.3"),
        ("I2-270",         Moment, 2, Planar,   whole(1),                  "by hand; Stabile 4.1.3 says balanced"),
        ("I2-360",         Force,  1, Planar,   whole(4),                  "Stabile 4.1.2"),
        ("I3",             Moment, 1, Planar,   whole(3),                  "Stabile 4.2.1"),
        ("I3",             Moment, 2, Planar,   whole(3),                  "Stabile 4.2.1"),
        ("I4",             Force,  2, Planar,   whole(16),                 "NPTEL, in-line four: 10966 N"),
        ("I4",             Force,  4, Planar,   whole(16),                 "theory"),
        ("I4-crossplane",  Moment, 1, Planar,   whole(10),                 "Stabile 4.3.2"),
        ("I4-crossplane",  Force,  4, Planar,   whole(16),                 "theory"),
        ("I5-12453",       Moment, 1, Planar,   half_with_root_5(25, -11), "theory: 0.4490"),
        ("I5-12453",       Moment, 2, Planar,   half_with_root_5(25, 11),  "theory: 4.9798"),
        ("I6",             Force,  6, Planar,   whole(36),                 "theory"),
        ("V2-90",          Force,  1, Rotating, whole(1),                  "Stabile 5.1"),
        ("V6-60-even",     Moment, 1, Rotating, quarters(9),               "theory: 1.5"),
        ("V8-crossplane",  Moment, 1, Rotating, whole(10),                 "Stabile 5.4.2"),
        ("V8-crossplane",  Force,  4, Planar,   whole(32),                 "theory"),
        ("V8-flatplane",   Force,  2, Planar,   whole(32),                 "Stabile 5.4.1"),
        ("boxer-4",        Moment, 2, Planar,   whole(4),                  "theory"),
        ("radial-14",      Moment, 1, Rotating, quarters(49),              "two cranks of 7/2, half a spacing either way"),
    ]
}

#[test]
fn what_is_left_has_the_known_shape_and_size() {
    for (name, quantity, order, shape, squared, _source) in left() {
        assert_left(&engine(name), quantity, order, shape, &squared);
    }
}

/// What vanishes: engine, quantity, orders, who says so.
#[rustfmt::skip]
const BALANCED: &[(&str, proof::Planar, &[u32], &str)] = &[
    ("I2-180",        Force,  &[1],                 "Stabile 4.1.1"),
    ("I2-180",        Moment, &[2],                 "Stabile 4.1.1"),
    ("I2-270",        Force,  &[2],                 "Stabile 4.1.3"),
    ("I2-360",        Moment, &[1, 2],              "Stabile 4.1.2"),
    ("I3",            Force,  &[1, 2, 4],           "Stabile 4.2.1"),
    ("I4",            Force,  &[1],                 "NPTEL, in-line four"),
    ("I4",            Moment, &[1, 2],              "NPTEL, in-line four"),
    ("I4-crossplane", Force,  &[1, 2],              "Stabile 4.3.2"),
    ("I5-12453",      Force,  &[1, 2, 4, 6, 8],     "worked example of the in-line five"),
    ("I5-15234",      Force,  &[1, 2, 4, 6, 8],     "by hand; Stabile 4.4.1 says order 2 is not balanced"),
    ("I5-14532",      Force,  &[1, 2, 4, 6, 8],     "worked example of the in-line five"),
    ("I6",            Force,  &[1, 2, 4],           "Stabile 4.5.1"),
    ("I6",            Moment, &[1, 2, 4, 6, 8, 10], "mirror plane"),
    ("V4-90",         Force,  &[1],                 "Stabile 5.2.1"),
    ("V6-60-shared",  Force,  &[1, 2, 4],           "Stabile 5.3.1"),
    ("V6-60-even",    Force,  &[1, 2, 4],           "theory"),
    ("V6-90-split",   Force,  &[1, 2, 4],           "theory"),
    ("V8-crossplane", Force,  &[1, 2],              "Stabile 5.4.2"),
    ("V8-crossplane", Moment, &[2, 4, 6],           "Stabile 5.4.2"),
    ("V8-flatplane",  Force,  &[1],                 "Stabile 5.4.1"),
    ("V8-flatplane",  Moment, &[1, 2, 4],           "Stabile 5.4.1, without bank offset"),
    ("V12-60",        Force,  &[1, 2, 4],           "two in-line sixes"),
    ("V12-60",        Moment, &[1, 2, 4, 6],        "two in-line sixes"),
    ("boxer-4",       Force,  &[1, 2, 4, 6],        "opposed pairs"),
    ("boxer-4",       Moment, &[1],                 "theory"),
    ("boxer-6",       Force,  &[1, 2, 4, 6],        "opposed pairs"),
    ("radial-14",     Force,  &[1],                 "opposed throws"),
];

#[test]
fn what_is_known_to_vanish_vanishes() {
    for (name, quantity, orders, _source) in BALANCED {
        for order in *orders {
            let shape = balance(&engine(name), *quantity, *order).shape;
            assert_eq!(shape, Balanced, "{name}, {quantity:?} of order {order}");
        }
    }
}

#[test]
fn in_line_six_has_only_forces_whose_order_is_a_multiple_of_6() {
    let orders: Vec<u32> = [1].into_iter().chain((2..=60).step_by(2)).collect();
    for order in pistons(&engine("I6"), &orders) {
        assert_eq!(order.force.is_balanced(), order.order % 6 != 0, "order {}", order.order);
        assert!(order.moment.is_balanced(), "order {}", order.order);
    }
}

#[test]
fn v6_with_split_pins_keeps_a_large_direct_and_a_small_reverse_moment() {
    let moment = balance(&engine("V6-90-split"), Moment, 1);
    assert_eq!(moment.shape, Shape::Elliptical);
    assert_equal(&moment.direct.sum.squared_modulus(), &with_root_3(6, 3), "direct, twice the coefficient, squared");
    assert_equal(&moment.reverse.sum.squared_modulus(), &with_root_3(6, -3), "reverse, twice the coefficient, squared");
    assert_eq!(decimals(&moment), ("1.6730".to_owned(), "0.4483".to_owned()));
}

#[test]
fn in_line_five_has_the_decimals_of_the_table() {
    let i5 = engine("I5-12453");
    for (order, each) in [(1, "0.2245"), (2, "2.4899")] {
        assert_eq!(decimals(&balance(&i5, Moment, order)), (each.to_owned(), each.to_owned()));
    }
}

/// `½|direct|` and `½|reverse|` to four places.
fn decimals(balance: &Balance) -> (String, String) {
    let half = |sum: &PhasorSum| format!("{:.4}", evaluate(sum).norm() / 2.0);
    (half(&balance.direct.sum), half(&balance.reverse.sum))
}

#[test]
fn even_firing_v6_of_60_degrees_differs_from_its_mirror_wrong_twin() {
    let v6 = |throws: &str, split: i64| {
        let text = format!("[vee]\nbank_angle = 60\nthrows = {throws}\npin_split = {split}");
        parse("v6.toml", &text).unwrap()
    };
    for throws in ["[0, 120, 240]", "[0, 240, 120]"] {
        assert_left(&v6(throws, -60), Moment, 1, Rotating, &quarters(9));
        assert_left(&v6(throws, 60), Moment, 1, Planar, &whole(9));
    }
}

#[test]
fn radial_of_n_odd_keeps_order_1_and_the_even_orders_next_to_multiples_of_n() {
    for n in (3..=15).step_by(2) {
        let radial = radial(n);
        let half_n_squared = quarters(i64::from(n * n));
        assert_left(&radial, Force, 1, Rotating, &half_n_squared);
        for order in (2..=60).step_by(2) {
            // The even orders (2j − 1)n + 1 turn with the crank, (2j − 1)n − 1 against it.
            let shape = match order % n {
                1 => Rotating,
                rest if rest == n - 1 => CounterRotating,
                _ => Balanced,
            };
            if shape == Balanced {
                assert_eq!(balance(&radial, Force, order).shape, Balanced, "{n} cylinders, order {order}");
            } else {
                assert_left(&radial, Force, order, shape, &half_n_squared);
            }
            assert_eq!(balance(&radial, Moment, order).shape, Balanced, "{n} cylinders, order {order}");
        }
    }
}

#[test]
fn radial_of_n_even_keeps_order_1_alone() {
    for n in (4..=16).step_by(2) {
        let radial = radial(n);
        assert_eq!(balance(&radial, Force, 1).shape, Rotating);
        for order in (2..=60).step_by(2) {
            assert_eq!(balance(&radial, Force, order).shape, Balanced, "{n} cylinders, order {order}");
        }
    }
}

fn radial(cylinders: u32) -> Engine {
    parse("radial.toml", &format!("radial.cylinders = {cylinders}")).unwrap()
}

#[test]
fn every_engine_of_the_catalogue_reads_and_names_its_source() {
    let engines = catalogue().unwrap();
    for (entry, layout) in &engines {
        let source = layout.source().map(Untrusted::written).unwrap_or("");
        assert!(source.len() > 10, "{} names no source", entry.name);
        assert_ne!(layout.title().written(), entry.name, "{} has no title", entry.name);
    }
    let names: BTreeSet<String> = engines.iter().map(|(entry, _)| entry.name.to_lowercase()).collect();
    let titles: BTreeSet<&str> = engines.iter().map(|(_, layout)| layout.title().written()).collect();
    assert_eq!((names.len(), titles.len()), (engines.len(), engines.len()), "a name or a title stands twice");
}

#[test]
fn the_catalogue_has_the_usual_engines() {
    let usual = "I1 I2-180 I2-270 I2-360 I3 I4 I4-crossplane I5-12453 I5-15234 I5-14532 I6 I6-two-stroke I8-242 I8-44 \
                 V2-45 V2-60 V2-90 V4-90 V6-60-shared V6-60-even V6-90-split V8-crossplane V8-flatplane V10-72 V12-60 \
                 boxer-2 boxer-4 boxer-6 radial-3 radial-4 radial-5 radial-6 radial-7 radial-8 radial-9 radial-14 \
                 radial-18";
    for name in usual.split_whitespace() {
        engine(name);
    }
}
