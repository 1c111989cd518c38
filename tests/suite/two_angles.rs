//! Where two angles are open: does a sum vanish exactly where it is said, as a dense search without the solver finds it?

use std::f64::consts::TAU;

use crankstar::family::{self, Boxes, Circle, Corner, Never, Root, When};
use crankstar::file::{self, Layout};
use crankstar::proof::{AlternativeClaim, RootsClaim, TriangleShape, check_open_document};
use crankstar::report;
use num_rational::BigRational;

use crate::support::dice::Dice;
use crate::support::plane_star::{Star, float};
use crate::support::two_angles::{
    broad_arrow, curves, family, fan, mixed, quadratics, random_twist, regular_vee, split_broad_arrow, tori, twists,
    vanishing_twist, vee,
};

/// How far a number of turns is from another, modulo a turn.
fn apart(turns: f64, other: f64) -> f64 {
    let difference = (turns - other).rem_euclid(1.0);
    difference.min(1.0 - difference)
}

/// `[phi, delta]` times φ and δ.
fn times([phi, delta]: &[BigRational; 2], [at, other]: [f64; 2]) -> f64 {
    float(phi) * at + float(delta) * other
}

/// φ and δ at which two angles have their turns.
fn solved([one, other]: [&[BigRational; 2]; 2], [u, v]: [f64; 2]) -> [f64; 2] {
    let [[a, b], [c, d]] = [one, other].map(|multiples| multiples.each_ref().map(float));
    let determinant = a * d - b * c;
    [(d * u - b * v) / determinant, (a * v - c * u) / determinant]
}

/// The points `[u, v]` of two classes or three, v none where all of a line vanishes.
fn points<'a>(
    rational: impl Iterator<Item = (&'a BigRational, &'a Option<Vec<Root>>)>,
    irrational: impl Iterator<Item = ([&'a BigRational; 2], f64)>,
) -> Vec<(f64, Option<f64>)> {
    let rational = rational.flat_map(|(at, roots)| {
        let v = match roots {
            None => vec![None],
            Some(roots) => roots.iter().map(|root| Some(root.degrees / 360.0)).collect(),
        };
        v.into_iter().map(move |v| (float(at), v))
    });
    let irrational = irrational.map(|([low, high], degrees)| ((float(low) + float(high)) / 2.0, Some(degrees / 360.0)));
    rational.chain(irrational).collect()
}

/// How far u and v are from points that are told; none beside an open arc.
fn from_points(points: &[(f64, Option<f64>)], circle: Option<&Circle>, [u, v]: [f64; 2]) -> Option<f64> {
    let each = points.iter().map(|(x, y)| y.map_or(0.0, |y| apart(v, y)).max(apart(u, *x)));
    let distance = each.fold(f64::INFINITY, f64::min);
    let is_open = circle.into_iter().flat_map(Circle::open).any(|[low, high]| {
        let middle = (float(low) + float(high)) / 2.0;
        apart(u, middle) < (float(high) - float(low)) / 2.0 + 1e-3
    });
    (distance <= 1e-3 || !is_open).then_some(distance)
}

fn of_alternative(alternative: &AlternativeClaim, at: [f64; 2]) -> f64 {
    let each = alternative
        .conditions
        .iter()
        .map(|condition| apart(times(&[condition.phi.clone(), condition.delta.clone()], at), float(&condition.turn)));
    each.fold(0.0, f64::max)
}

/// How far a zero is from those that are told, in turns; none where nothing is told of the place.
fn from_told(when: &When, at: [f64; 2]) -> Option<f64> {
    let least = |all: &mut dyn Iterator<Item = f64>| all.fold(f64::INFINITY, f64::min);
    Some(match when {
        When::Always => 0.0,
        When::Never(_) => f64::INFINITY,
        When::Where(angles) => least(&mut angles.alternatives.iter().map(|one| of_alternative(one, at))),
        When::Cosine(found) => {
            let x = times(&[found.phi.clone(), found.delta.clone()], at) + float(&found.turn);
            ((TAU * x).cos() - float(&found.cosine)).abs()
        }
        When::Circle(circle) => {
            assert!(circle.is_complete());
            let u = times(&[circle.polynomial.phi.clone(), circle.polynomial.delta.clone()], at);
            let rational = circle.rational().map(|turn| apart(u, float(turn.turns())));
            let irrational = circle.irrational().map(|[low, high]| apart(u, (float(low) + float(high)) / 2.0));
            least(&mut rational.chain(irrational))
        }
        When::Irrational { phi, delta, degrees, .. } => {
            apart(times(&[phi.clone(), delta.clone()], at), degrees / 360.0)
        }
        When::Triangle(triangle) => least(&mut triangle.corners.iter().map(|corner| match corner {
            Corner::Exact(exact) => of_alternative(exact, at),
            Corner::Near(degrees) => {
                let each = triangle.multiples.iter().zip(degrees);
                each.map(|(multiples, degrees)| apart(times(multiples, at), degrees / 360.0)).fold(0.0, f64::max)
            }
        })),
        When::Classes(classes) if classes.is_curve() => 0.0,
        When::Classes(classes) => {
            let place = [times(&classes.u, at), times(&classes.v, at)];
            return from_points(&points(classes.rational(), classes.irrational()), classes.circle.as_ref(), place);
        }
        When::Quadratic(found) if found.is_curve() => 0.0,
        When::Quadratic(found) => {
            let place = [times(&found.u, at), times(&found.v, at)];
            return from_points(&points(found.rational(), found.irrational()), found.circle.as_ref(), place);
        }
        When::Product(product) => {
            let [one, other] = [&product.group, &product.firsts].map(|factor| from_told(factor, at));
            match (one, other) {
                (Some(one), Some(other)) => one.min(other),
                (one, other) => return one.or(other).filter(|distance| *distance < 1e-3),
            }
        }
        When::Boxes(found) => {
            let distance = least(&mut found.near.iter().map(|zero| far(*zero, of_boxes(found, at))));
            return (distance < 1e-3 || !is_open(found, at)).then_some(distance);
        }
        When::NotSolved(_) => return None,
    })
}

/// s and t.
fn of_boxes(found: &Boxes, at: [f64; 2]) -> [f64; 2] {
    let [s, t] = [&found.claim.phi, &found.claim.delta].map(float);
    [s * at[0], t * at[1]]
}

fn far(one: [f64; 2], other: [f64; 2]) -> f64 {
    apart(one[0], other[0]).max(apart(one[1], other[1]))
}

/// Whether a point is in a box that is left open, or next to one.
fn is_open(found: &Boxes, at: [f64; 2]) -> bool {
    let turns = of_boxes(found, at);
    found.open.iter().any(|ends| {
        ends.iter().zip(turns).all(|([low, high], turns)| {
            let (middle, half) = ((float(low) + float(high)) / 2.0, (float(high) - float(low)) / 2.0);
            apart(turns, middle) < half + 1e-3
        })
    })
}

/// A point of the line where an angle has its turn.
fn on_line([phi, delta]: &[BigRational; 2], turn: f64) -> [f64; 2] {
    let [p, d] = [float(phi), float(delta)];
    if p == 0.0 { [0.217, turn / d] } else { [(turn - d * 0.217) / p, 0.217] }
}

/// How many points, lines, curves and triangles were told, and how many sums have open arcs, or were not solved.
#[derive(Debug, Default)]
struct Told {
    never: usize,
    points: usize,
    /// Also of one unknown.
    lines: usize,
    curves: usize,
    triangles: usize,
    products: usize,
    quadratics: usize,
    boxes: usize,
    exact: usize,
    /// Sums of three classes, the outer ones equally long throughout.
    twists: usize,
    /// What stands at irrational u of these: none, and two.
    signs: [usize; 2],
    /// What stands at rational u: all v, none, one; of classes of one length none, one, two.
    roots: [usize; 6],
    open: usize,
    not_solved: usize,
}

/// Whether the sum vanishes at the points, and on the lines, that are told.
fn check_points(
    star: &Star,
    points: &[(f64, Option<f64>)],
    at: impl Fn(f64, f64) -> [f64; 2],
    told: &mut Told,
    place: &str,
) {
    for (u, v) in points {
        let all = [v.unwrap_or(0.123), v.unwrap_or(0.789)];
        if v.is_some() {
            told.points += 1
        } else {
            told.lines += 1
        }
        assert!(all.iter().all(|v| star.length(at(*u, *v)) < 1e-8), "{place}: u = {u}, v = {v:?}");
    }
}

/// Whether the sum vanishes at this many v for some u that are nothing special.
fn check_curve(star: &Star, at: impl Fn(f64, f64) -> [f64; 2], count: usize, place: &str) {
    for u in [0.113, 0.377, 0.591, 0.873] {
        let length = |step: i32, part: f64| star.length(at(u, (f64::from(step) + part) / 400.0));
        let is_least = |step: &i32| (-1..=1).all(|apart| length(*step, 0.0) <= length(step + apart, 0.0));
        let vanishes = |step: &i32| {
            let (mut low, mut high) = (-1.0, 1.0);
            for _ in 0..90 {
                let [one, other] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
                if length(*step, one) < length(*step, other) { high = other } else { low = one }
            }
            length(*step, low) < 1e-9
        };
        assert_eq!((0..400).filter(is_least).filter(vanishes).count(), count, "{place}: u = {u}");
    }
}

/// Whether the sum vanishes wherever it is told to.
fn check_told(star: &Star, when: &When, told: &mut Told, place: &str) {
    let mut vanishes = |multiples: &[BigRational; 2], turn: f64| {
        told.lines += 1;
        assert!(star.length(on_line(multiples, turn)) < 1e-8, "{place}: {when:?}");
    };
    match when {
        When::Where(angles) => {
            for alternative in &angles.alternatives {
                if let [only] = alternative.conditions.as_slice() {
                    vanishes(&[only.phi.clone(), only.delta.clone()], float(&only.turn));
                }
            }
        }
        When::Circle(circle) => {
            let multiples = [circle.polynomial.phi.clone(), circle.polynomial.delta.clone()];
            circle.rational().for_each(|turn| vanishes(&multiples, float(turn.turns())));
            circle.irrational().for_each(|[low, high]| vanishes(&multiples, (float(low) + float(high)) / 2.0));
        }
        When::Irrational { phi, delta, degrees, .. } => vanishes(&[phi.clone(), delta.clone()], degrees / 360.0),
        When::Product(product) => {
            told.products += 1;
            check_told(star, &product.group, told, place);
            check_told(star, &product.firsts, told, place);
        }
        When::Triangle(triangle) => {
            told.triangles += 1;
            let [one, other] = triangle.multiples.each_ref();
            for corner in &triangle.corners {
                let turns = match corner {
                    Corner::Exact(exact) => [0, 1].map(|at: usize| float(&exact.conditions[at].turn)),
                    Corner::Near(degrees) => degrees.map(|degrees| degrees / 360.0),
                };
                let at = solved([one, other], turns);
                assert!(star.length(at) < 1e-9, "{place}: {triangle:?}");
            }
        }
        When::Classes(classes) => {
            let at = |u: f64, v: f64| solved([&classes.u, &classes.v], [u, v]);
            if classes.is_curve() {
                told.curves += 1;
                check_curve(star, at, 1, place);
            }
            check_points(star, &points(classes.rational(), classes.irrational()), at, told, place);
            told.open += usize::from(classes.circle.as_ref().is_some_and(|circle| !circle.is_complete()));
        }
        When::Quadratic(found) => {
            told.quadratics += 1;
            let at = |u: f64, v: f64| solved([&found.u, &found.v], [u, v]);
            if found.is_curve() {
                told.curves += 1;
                check_curve(star, at, 1 + usize::from(found.is_mirrored()), place);
            }
            check_points(star, &points(found.rational(), found.irrational()), at, told, place);
            told.open += usize::from(found.circle.as_ref().is_some_and(|circle| !circle.is_complete()));
            if let Some(twist) = &found.claim.twist {
                told.twists += 1;
                for sign in &twist.signs {
                    told.signs[usize::from(matches!(sign, TriangleShape::Two { .. }))] += 1;
                }
            }
            for (roots, at) in found.claim.roots.iter().zip(&found.at) {
                told.roots[match roots {
                    RootsClaim::All { .. } => 0,
                    RootsClaim::None { .. } => 1,
                    RootsClaim::One { .. } => 2,
                    RootsClaim::Mirror { .. } => 3 + at.iter().flatten().count(),
                }] += 1;
            }
        }
        When::Boxes(found) => {
            told.boxes += 1;
            told.open += usize::from(!found.is_complete());
            for (zero, near) in found.claim.zeros.iter().zip(&found.near) {
                told.points += 1;
                told.exact += usize::from(zero.certificate.is_some());
                let at = [near[0] / float(&found.claim.phi), near[1] / float(&found.claim.delta)];
                assert!(star.length(at) < 1e-8, "{place}: {zero:?}");
            }
        }
        When::Never(Never::Boxes(_)) => {
            told.boxes += 1;
            told.never += 1;
        }
        When::Never(_) => told.never += 1,
        When::NotSolved(_) => told.not_solved += 1,
        When::Always | When::Cosine(_) => (),
    }
}

fn search(text: &str, orders: &[u32], told: &mut Told) {
    let family = family(text);
    let orders = family::classify(&family, orders).expect("orders");
    for verdict in orders.iter().flat_map(|order| order.force.iter().chain(&order.moment)) {
        let [sum] = verdict.sums.as_slice() else { continue };
        let place = format!("{text}\norder {} {:?} {:?}", verdict.order, verdict.quantity, verdict.sense);
        let star = Star::of(&family, verdict);
        check_told(&star, &sum.when, told, &place);
        for at in star.zeros() {
            let distance = from_told(&sum.when, at).unwrap_or(0.0);
            assert!(distance < 1e-3, "{place}: a zero at {at:?}, {distance} from {:?}", sum.when);
        }
    }
    let checked = check_open_document(&report::open_document(&family, &orders));
    checked.unwrap_or_else(|fault| panic!("{text}: {fault}"));
}

#[test]
fn v_engines_with_pins_split_in_any_sense_vanish_exactly_where_it_is_told() {
    let (mut dice, mut told) = (Dice::new(2), Told::default());
    for round in 0..40 {
        search(&vee(&mut dice), if round % 4 == 0 { &[1, 2, 4] } else { &[1, 2] }, &mut told);
    }
    assert_eq!([told.not_solved, told.open], [0, 0], "{told:?}");
    assert!(told.points > 300 && told.never > 100 && told.triangles > 20 && told.lines > 5, "{told:?}");
}

#[test]
fn v_engines_with_pins_split_alike_make_products_and_curves() {
    let (mut dice, mut told) = (Dice::new(4), Told::default());
    for _ in 0..40 {
        search(&regular_vee(&mut dice), &[1, 2], &mut told);
    }
    assert_eq!([told.not_solved, told.open], [0, 0], "{told:?}");
    assert!(told.products > 50 && told.curves > 3 && told.lines > 100, "{told:?}");
}

#[test]
fn w_engines_with_pins_split_in_one_sense_vanish_exactly_where_it_is_told() {
    let (mut dice, mut told) = (Dice::new(3), Told::default());
    for _ in 0..20 {
        search(&broad_arrow(&mut dice), &[1, 2], &mut told);
    }
    assert_eq!([told.not_solved, told.open], [0, 0], "{told:?}");
    assert!(told.points > 150 && told.never > 30, "{told:?}");
}

#[test]
fn w_engines_with_pins_split_in_both_senses_vanish_exactly_where_it_is_told() {
    let (mut dice, mut told) = (Dice::new(9), Told::default());
    for _ in 0..20 {
        search(&split_broad_arrow(&mut dice), &[1, 2], &mut told);
    }
    assert_eq!([told.not_solved, told.open], [0, 0], "{told:?}");
    assert!(told.quadratics > 50 && told.points > 150 && told.never > 20, "{told:?}");
}

#[test]
fn four_parts_that_no_reduction_fits_vanish_exactly_where_their_boxes_say() {
    let mut told = Told::default();
    for text in tori() {
        search(&text, &[1], &mut told);
    }
    // Where all four parts of one length are on one line they make a double zero, and its box stays open.
    assert!(told.not_solved == 0 && told.open > 0 && told.never > 0, "{told:?}");
    assert!(told.boxes >= 3 && told.exact > 3 && told.points > told.exact, "{told:?}");
}

#[test]
fn engines_with_banks_in_a_fan_vanish_exactly_where_their_boxes_say() {
    let (mut dice, mut told) = (Dice::new(5), Told::default());
    for round in 0..6 {
        search(&if round % 2 == 0 { fan(&mut dice) } else { mixed(&mut dice) }, &[1], &mut told);
    }
    assert!(told.boxes > 0 && told.points > 50, "{told:?}");
}

#[test]
fn three_classes_cancel_along_a_curve_at_as_many_turns_as_it_is_told() {
    let mut told = Told::default();
    for text in curves() {
        search(&text, &[1], &mut told);
    }
    assert!(told.curves >= 2 && told.not_solved == 0, "{told:?}");
}

#[test]
fn three_classes_vanish_at_all_turns_or_none_or_some_where_their_lengths_say_so() {
    let mut told = Told::default();
    for text in quadratics() {
        search(&text, &[1], &mut told);
    }
    // Beside the zero of h four times over where all three classes vanish, arcs stay open.
    assert_eq!([told.not_solved, told.open], [0, 2], "{told:?}");
    let [all, none, one, mirrors @ ..] = told.roots;
    assert!(all > 0 && none > 0 && one > 0 && mirrors.iter().all(|count| *count > 0), "{told:?}");
}

#[test]
fn outer_classes_of_one_length_throughout_cancel_exactly_where_it_is_told() {
    let mut told = Told::default();
    for text in twists() {
        search(&text, &[1], &mut told);
    }
    assert_eq!([told.not_solved, told.open], [0, 0], "{told:?}");
    // In both senses: two turns at each of two irrational angles, nowhere, and at rational angles alone.
    assert_eq!((told.twists, told.signs, told.never), (6, [0, 4], 2), "{told:?}");
}

#[test]
fn random_outer_classes_of_one_length_throughout_cancel_exactly_where_it_is_told() {
    let (mut dice, mut told) = (Dice::new(26), Told::default());
    for _ in 0..30 {
        search(&random_twist(&mut dice), &[1], &mut told);
    }
    assert_eq!([told.not_solved, told.open], [0, 0], "{told:?}");
    assert!(told.twists > 40 && told.signs.iter().all(|count| *count > 10) && told.never > 2, "{told:?}");
}

#[test]
fn where_three_classes_vanish_at_an_irrational_turn_its_arc_stays_open() {
    let mut told = Told::default();
    search(&vanishing_twist(), &[1], &mut told);
    assert_eq!([told.not_solved, told.open, told.twists], [0, 2, 2], "{told:?}");
}

/// What is small at both ends of an arc is smaller still as a product: the checker once lost its sign in rounding.
#[test]
fn the_checker_tells_the_sides_of_small_ends_apart() {
    let cylinder = |(position, [throw, pins, banks]): (usize, &[i32; 3])| {
        format!("[[cylinder]]\nthrow = \"{throw} + {pins} delta\"\nbank = \"{banks} phi\"\nposition = {position}\n")
    };
    let engines: [&[[i32; 3]]; 2] = [
        &[[345, 1, 0], [225, 2, 3], [210, 0, 2], [150, 1, 1], [60, 1, 1]],
        &[[300, 2, 2], [90, 2, 2], [315, 0, 2], [105, 0, 3], [270, 1, 2], [90, 2, 1], [240, 1, 2]],
    ];
    for engine in engines {
        let text: String = engine.iter().enumerate().map(cylinder).collect();
        let Ok(Layout::Open(family)) = file::parse_layout("test", &text) else { panic!("not a family: {text}") };
        let verdicts = family::classify(&family, &[1, 2]).expect("orders");
        check_open_document(&report::open_document(&family, &verdicts)).expect("it holds");
    }
}
