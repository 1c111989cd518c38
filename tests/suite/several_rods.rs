//! Are engines with several rods, and with offsets to both sides, decided? Beside the motion of each piston on its exact path, sampled.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use num_complex::Complex;

use crate::support::dice::Dice;
use crate::support::verdicts;
use crate::support::written::engine;
use crankstar::engine::Engine;
use crankstar::exact::Turn;
use crankstar::file::FileResolver;
use crankstar::motion::SliderCrank;
use crankstar::numbers::{Direction, float};
use crankstar::order::Masses;
use crankstar::proof::{Shape, check_document};
use crankstar::remedy::{Request, corrected_file, remedy};
use crankstar::verdict::{OrderVerdict, classify};

const ORDERS: [u32; 6] = [1, 2, 3, 4, 5, 6];
const POINTS: usize = 128;
const ENGINES: u64 = 60;

/// Cylinders of throw, bank, position, rod ratio and offset ratio.
fn file(cylinders: &[(i64, i64, i64, &str, String)], more: &str) -> String {
    let list =
        |of: fn(&(i64, i64, i64, &str, String)) -> String| cylinders.iter().map(of).collect::<Vec<_>>().join(", ");
    let (ratios, offsets) = (list(|one| format!("{:?}", one.3)), list(|one| format!("{:?}", one.4)));
    let mut text = format!("[mechanism]\nrod_ratio = [{ratios}]\noffset_ratio = [{offsets}]\n{more}");
    for (throw, bank, position, ..) in cylinders {
        write!(text, "[[cylinder]]\nthrow = {throw}\nbank = {bank}\nposition = {position}\n").expect("a string");
    }
    text
}

/// Radials, rows, Vs and others with rods of two ratios and offsets of one size to either side, some turned from the reference direction.
fn random(dice: &mut Dice) -> String {
    let mut pick = |bound: usize| dice.below(bound as u64) as usize;
    let count = [1, 2, 2, 3, 4, 4, 5, 6][pick(8)];
    let step = [30, 45, 60, 90, 120][pick(5)];
    let (kind, kinds) = (pick(4), pick(4));
    let (offset, tilt) = (["1/20", "1/40", "3/25"][pick(3)], [0, 0, 15, 7][pick(4)]);
    let (ratios, angle) = ([["1/4", "2/7"], ["3/10", "1/4"]][pick(2)], [30, 60, 90, 180][pick(4)]);
    let (one, masses) = (step * pick(360 / step as usize) as i64, pick(3));
    let mut cylinders = Vec::new();
    for at in 0..count {
        let own = step * pick(360 / step as usize) as i64;
        let [throw, bank, position] = match kind {
            0 => [one, 360 * at / count, 0],
            1 => [own, 0, at],
            2 => [own, if at % 2 == 0 { -angle / 2 } else { angle / 2 }, at / 2],
            _ => [own, step * pick(360 / step as usize) as i64, at],
        };
        let ratio = if kinds == 0 { ratios[0] } else { ratios[pick(2)] };
        let offset = match (kinds, pick(2)) {
            (1, _) => "0".to_owned(),
            (_, 0) => offset.to_owned(),
            _ => format!("-{offset}"),
        };
        cylinders.push((throw + tilt, bank + tilt, position, ratio, offset));
    }
    let more = if masses == 0 { "reciprocating_mass = 1\nrotating_mass = \"1/2\"\n" } else { "" };
    file(&cylinders, more)
}

/// `P⁺` and `P⁻` of force and moment of an order, from the forces at points of a turn.
fn sampled(engine: &Engine, order: u32) -> [[Complex<f64>; 2]; 2] {
    let mut sums = [[Complex::default(); 2]; 2];
    for cylinder in engine.cylinders() {
        let rod = cylinder.rod().expect("a rod");
        let crank = SliderCrank::new(rod.ratio.clone(), rod.offset.clone()).expect("it turns round");
        let [throw, bank] = [&cylinder.throw, &cylinder.bank].map(|angle| float(angle.turns()) * TAU);
        let (mass, turning) = (float(&cylinder.reciprocating_mass), float(&cylinder.rotating_mass));
        let arm = float(&(&cylinder.position - engine.reference_plane()));
        for point in 0..POINTS {
            let theta = TAU * point as f64 / POINTS as f64;
            let swinging = Complex::from_polar(-mass * crank.acceleration(theta + throw - bank), bank);
            let force = swinging + Complex::from_polar(turning, theta + throw);
            for (sense, way) in [-1.0, 1.0].into_iter().enumerate() {
                let part = force * Complex::from_polar(2.0 / POINTS as f64, way * f64::from(order) * theta);
                sums[0][sense] += part;
                sums[1][sense] += part * arm;
            }
        }
    }
    sums
}

/// What two vectors leave together.
fn shape_of([direct, reverse]: [Complex<f64>; 2]) -> Shape {
    let [one, other] = [direct.norm(), reverse.norm()];
    match (one < 1e-10, other < 1e-10) {
        (true, true) => Shape::Balanced,
        (false, true) => Shape::Rotating,
        (true, false) => Shape::CounterRotating,
        _ if (one - other).abs() < 1e-10 => Shape::Planar,
        _ => Shape::Elliptical,
    }
}

fn judged(engine: &Engine) -> Vec<OrderVerdict> {
    classify(engine, &ORDERS, Masses::All, &verdicts::quantities(false)).expect("orders")
}

#[test]
fn every_shape_of_several_rods_is_decided_as_the_sampled_motion_has_it() {
    let (mut open, mut several, mut planar) = (Vec::new(), 0, 0);
    for number in 0..ENGINES {
        let text = random(&mut Dice::new(number));
        let engine = engine(&text);
        let orders = judged(&engine);
        for order in orders.iter().filter(|order| order.exists()) {
            let vectors = sampled(&engine, order.order);
            for (whole, vectors) in [&order.force, &order.moment].into_iter().zip(vectors) {
                let right = shape_of(vectors);
                several += usize::from(order.parts.len() > 1);
                planar += usize::from(order.parts.len() > 1 && whole.shape == Shape::Planar);
                match whole.shape {
                    Shape::NotDecided => open.push(format!("order {} is {right:?}:\n{text}", order.order)),
                    shape => assert_eq!(shape, right, "order {}:\n{text}", order.order),
                }
            }
        }
        let document = crankstar::report::document(&engine, Masses::All, &orders, &verdicts::quantities(false), None);
        check_document(&document).unwrap_or_else(|fault| panic!("{fault}\n{text}"));
    }
    assert!(open.is_empty(), "{} of {several} are not decided: {}", open.len(), open[0]);
    assert!(several > 200 && planar > 80, "{several} {planar}");
}

#[test]
fn a_radial_four_with_two_rod_lengths_is_planar() {
    let star: Vec<_> = (0..4).map(|at| (0, 90 * at, 0, if at < 2 { "1/4" } else { "2/7" }, "0".to_owned())).collect();
    let turned: Vec<_> = star.iter().cloned().map(|(throw, bank, z, l, d)| (throw + 15, bank + 15, z, l, d)).collect();
    for cylinders in [star, turned] {
        let orders = judged(&engine(&file(&cylinders, "")));
        for order in [2, 4] {
            assert_eq!(orders[order - 1].force.shape, Shape::Planar, "order {order}");
        }
    }
}

/// Two cylinders on one pin, whose axes pass the crankshaft on either side.
fn opposed() -> Engine {
    let [ahead, behind] = ["1/20", "-1/20"].map(|offset| (0, 0, 0, "1/4", offset.to_owned()));
    engine(&file(&[ahead, behind], ""))
}

#[test]
fn of_opposed_offsets_the_first_order_has_an_exact_weight() {
    let first = &judged(&opposed())[0];
    let classes: Vec<bool> = first.parts.iter().map(|part| part.force.is_balanced()).collect();
    assert_eq!(classes, [false, true], "2 before 1, and 0 before the imaginary part");
    assert_eq!(first.force.shape, Shape::Planar);
    let found = remedy(&opposed(), &Request { orders: vec![1], ..Request::default() }).expect("a remedy");
    assert!(found.holds());
    for weight in found.weights() {
        assert_eq!(weight.modulus().map(|form| form.to_string()).as_deref(), Some("1"));
        assert_eq!(weight.direction(), Some(Direction::Turn(Turn::fraction(1, 2))));
    }
}

#[test]
fn a_file_names_the_weights_against_imaginary_parts_exactly() {
    let cylinders = [(270, 0, 0, "2/7", "-1/20".to_owned()), (210, 0, 1, "3/10", "1/20".to_owned())];
    let found =
        remedy(&engine(&file(&cylinders, "")), &Request { orders: vec![1], ..Request::default() }).expect("a remedy");
    let written = corrected_file(&found, "engine.toml", FileResolver::nothing()).expect("a file");
    assert!(!written.is_rounded);
    let first = &judged(&engine(&written.text))[0];
    assert!(first.force.is_balanced() && first.moment.is_balanced(), "{}", written.text);
}

#[test]
fn the_first_coefficient_of_every_rod_is_one_and_an_imaginary_part_that_is_odd_in_the_offset() {
    let first = |ratio: &str, offset: &str| {
        let number = |text: &str| text.parse().expect("a fraction");
        SliderCrank::new(number(ratio), number(offset)).expect("it turns round").coefficient(1)
    };
    for (ratio, offset) in [("1/4", "1/20"), ("3/10", "2/5"), ("1/100", "9/10"), ("0", "3/5")] {
        let [ahead, behind] = [first(ratio, offset), first(ratio, &format!("-{offset}"))];
        for one in [&ahead, &behind] {
            assert!(one.re.low == one.re.high && one.re.low == "1".parse().expect("one"));
        }
        let [ahead, behind] = [ahead, behind].map(|one| one.to_complex().im);
        assert!(ahead < 0.0 && ahead == -behind, "{ratio} {offset}: {ahead} {behind}");
    }
}

#[test]
fn rods_that_are_all_alike_keep_one_sum_in_the_first_order() {
    let alike: Vec<_> = [0, 90].map(|throw| (throw, 0, 0, "1/4", "1/20".to_owned())).into();
    let first = &judged(&engine(&file(&alike, "")))[0];
    assert_eq!((first.parts.len(), first.force.shape), (1, Shape::Planar));
}
