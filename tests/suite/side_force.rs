//! Do crankpins and main bearings feel what Newton's law says of each body, the side forces of the pistons with it?
//!
//! The model here knows nothing of orders: at one crank angle the rod's fixed length gives positions, speeds and accelerations, and
//! the equations of motion of piston and rod, a rigid body, give the forces on their pins and on the wall.

use std::f64::consts::TAU;

use crankstar::engine::Engine;
use crankstar::loads::{
    BearingLoads, Method, bearing_loads, bearing_orders, left_out_of_bearings, loads, pin_loads, usual_bearing_orders,
};
use crankstar::motion::{Enclosure, SliderCrank, Tail};
use num_bigint::BigInt;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::support::dice::Dice;
use crate::support::piston::decimal;
use crate::support::side::SIDE;
use crate::support::stiffness;
use crate::support::written::{engine as layout, float};

fn crank(ratio: &str, offset: &str) -> SliderCrank {
    SliderCrank::new(decimal(ratio), decimal(offset)).expect("a crank that turns")
}

/// Whether it holds the reference of 40 digits, to a relative 2⁻⁶⁴.
fn holds(enclosure: &Enclosure, reference: &str) -> bool {
    let reference = decimal(reference);
    if reference.is_zero() {
        return *enclosure == Enclosure::zero();
    }
    let doubt = reference.abs() * decimal("1e-39");
    let two_to_64 = BigRational::from_integer(BigInt::one() << 64);
    enclosure.low <= &reference + &doubt
        && &reference - &doubt <= enclosure.high
        && enclosure.width() * two_to_64 <= enclosure.low.abs().max(enclosure.high.abs())
}

#[test]
fn enclosures_of_the_side_force_hold_the_references() {
    for (ratio, offset, order, re, im) in SIDE {
        let n = crank(ratio, offset).side_coefficient(order);
        assert!(holds(&n.re, re) && holds(&n.im, im), "λ = {ratio}, δ = {offset}, order {order}: {n:?}");
    }
}

#[test]
fn figures_of_the_theory_at_three_tenths() {
    let n = |order| crank("0.3", "0").side_coefficient(order).re.to_float();
    for (order, figure) in [(1, -0.0482848367219), (2, 0.1535253295311), (3, 0.0488405372818)] {
        assert!((n(order) - figure).abs() < 1e-13, "{order}");
    }
}

#[test]
fn even_orders_of_a_centric_crank_have_the_kth_part_of_the_shaking_force() {
    let crank = crank("0.3", "0");
    for order in [2, 4, 6, 20] {
        let part = crank.coefficient(order).re.times(&BigRational::new(1.into(), order.into()));
        assert_eq!(crank.side_coefficient(order).re, part);
        assert!(!crank.has_side_part(order) && crank.side_part(order).re == Enclosure::zero());
    }
}

#[test]
fn no_part_of_the_side_force_vanishes_but_the_even_ones_without_an_offset() {
    for offset in ["1e-12", "-1e-12", "0.2", "-0.2"] {
        for order in 0..12 {
            let crank = crank("0.3", offset);
            let part = crank.side_part(order);
            let [zero, other] = if order % 2 == 1 { [part.im, part.re] } else { [part.re, part.im] };
            assert!(
                crank.has_side_part(order) && !other.contains_zero() && zero == Enclosure::zero(),
                "{offset} {order}"
            );
        }
    }
    for order in 0..12 {
        assert_eq!(crank("0.3", "0").side_part(order).re.contains_zero(), order % 2 == 0);
        assert_eq!(crank("0", "0.2").has_side_part(order), order == 1);
        assert!(!crank("0", "0").has_side_part(order));
    }
}

#[test]
fn the_first_order_that_turns_with_the_crank_is_the_mean_of_one_over_the_squared_cosine_of_the_rod() {
    // 1/√(1−λ²) without an offset; against the crank 2 − 1/√(1−λ²), which only λ = √3/2 would make zero.
    for ratio in ["0.25", "0.3", "0.866", "0.8660254037844386"] {
        let crank = crank(ratio, "0");
        let n = crank.side_coefficient(1).re;
        let one = Enclosure::point(BigRational::one());
        let minus = |e: &Enclosure| e.times(&-BigRational::one());
        let root = 1.0 / (1.0 - float(&decimal(ratio)).powi(2)).sqrt();
        assert!((one.plus(&minus(&n)).to_float() - root).abs() < 1e-14 * root);
        assert!(!one.plus(&n).contains_zero(), "{ratio}");
    }
}

#[test]
fn rods_with_a_rational_root_have_exact_side_forces() {
    let crank = crank("0.28", "0");
    let n = |order| crank.side_coefficient(order).re;
    assert_eq!(n(1), Enclosure::point(BigRational::new((-1).into(), 24.into())));
    assert_eq!(n(3), Enclosure::point(BigRational::new(2425.into(), 57624.into())));
    assert_eq!(crank.rational_side_part(2), Some(BigRational::zero()));
    assert_eq!(self::crank("0.3", "0").rational_side_part(1), None);
}

#[test]
fn what_is_cut_off_of_a_pin_load_is_below_its_bound_and_not_far_below() {
    for (ratio, offset) in [("0.1", "0"), ("0.3", "0"), ("0.3", "0.1"), ("0.25", "-0.05"), ("0.9", "0"), ("0.6", "0.2")]
    {
        let crank = crank(ratio, offset);
        let (tail, size) = (Tail::new(&crank), |order| crank.side_part(order).to_complex().norm());
        for highest in [1, 2, 4, 8, 12] {
            let cut: f64 = (highest + 1..highest + 200)
                .map(|order| crank.coefficient(order).to_complex().norm() + size(order))
                .sum();
            let bound = tail.pin(highest);
            assert!(cut <= bound, "λ = {ratio}, δ = {offset}, {highest}: {cut} {bound}");
            assert!(highest < 8 || bound < 100.0 * cut, "λ = {ratio}, δ = {offset}, {highest}: {cut} {bound}");
        }
    }
    assert_eq!(Tail::new(&crank("0", "0.2")).pin(1), 0.0);
}

/// One cylinder in metres and kilograms at ω = 1.
struct Body {
    throw: f64,
    bank: f64,
    position: BigRational,
    radius: f64,
    rod: f64,
    offset: f64,
    piston: f64,
    /// The rod as two masses: at the piston, at the crankpin.
    ends: [f64; 2],
}

/// The forces of one cylinder, as complex numbers in the frame of the engine.
struct Forces {
    /// Of the rod on the crankpin.
    pin: Complex<f64>,
    /// Of the piston on the wall.
    wall: Complex<f64>,
    /// Of all inertia, by the accelerations alone.
    shaking: Complex<f64>,
}

impl Body {
    /// Piston: `m ü = −f_u`, `0 = −f_v + N`. Rod: `Σ m a = f + g`, and the moments about the crankpin; f is the force of the piston on
    /// the rod, g that of the crankpin on it.
    fn forces(&self, theta: f64) -> Forces {
        let axis = Complex::cis(self.bank);
        let psi = theta + self.throw - self.bank;
        let crankpin = Complex::from_polar(self.radius, psi);
        let height = (self.rod.powi(2) - (self.offset - crankpin.im).powi(2)).sqrt();
        let piston = Complex::new(crankpin.re + height, self.offset);
        let (speed_of_pin, pin_acceleration) = (crankpin * Complex::i(), -crankpin);
        let along = piston - crankpin;
        let dot = |a: Complex<f64>, b: Complex<f64>| (a.conj() * b).re;
        let cross = |a: Complex<f64>, b: Complex<f64>| (a.conj() * b).im;
        let speed = Complex::new(dot(along, speed_of_pin) / along.re, 0.0);
        let apart = (speed - speed_of_pin).norm_sqr();
        let acceleration = Complex::new((dot(along, pin_acceleration) - apart) / along.re, 0.0);
        // f_u from the piston, f_v from the moments about the crankpin: along × f = along × m a of the rod's upper end.
        let f_u = -self.piston * acceleration.re;
        let moment = cross(along, acceleration * self.ends[0]);
        let f_v = (moment + along.im * f_u) / along.re;
        let f = Complex::new(f_u, f_v);
        let rod = acceleration * self.ends[0] + pin_acceleration * self.ends[1];
        let g = rod - f;
        Forces {
            pin: -g * axis,
            wall: Complex::new(0.0, -f_v) * axis,
            shaking: -(rod + acceleration * self.piston) * axis,
        }
    }
}

/// An engine with what the model has to know of it.
struct Case {
    layout: Engine,
    bodies: Vec<Body>,
    /// Mass-radius, angle, position.
    weights: Vec<(f64, f64, BigRational)>,
    unit: f64,
}

/// A random engine: masses, radii, rods and offsets differ, some cylinders stand beyond the outer bearings.
fn random(dice: &mut Dice) -> Case {
    let count = dice.below(5) + 1;
    let (mut tables, mut keys, mut bodies): (String, [Vec<String>; 6], Vec<Body>) = Default::default();
    let centric = dice.below(3) == 0;
    for _ in 0..count {
        let (throw, bank, position) = (dice.below(28), dice.below(24) * 15, dice.below(90) as i64 - 45);
        tables += &format!("[[cylinder]]\nthrow = '{throw}/7 turn'\nbank = {bank}\nposition = '{position}/100'\n");
        let values = [
            dice.below(40) + 40,
            dice.below(80) + 300,
            if centric { 0 } else { dice.below(31) },
            dice.below(900),
            dice.below(700),
            dice.below(200),
        ];
        let offset = values[2] as f64 - if centric { 0.0 } else { 15.0 };
        for (key, value) in keys.iter_mut().zip(values) {
            key.push(format!("'{value}/1000'"));
        }
        if let Some(last) = keys[2].last_mut() {
            *last = format!("'{offset}/1000'");
        }
        let [radius, rod, _, piston, rod_mass, centre] = values.map(|value| value as f64 / 1000.0);
        bodies.push(Body {
            throw: throw as f64 / 7.0 * TAU,
            bank: (bank as f64).to_radians(),
            position: BigRational::new(position.into(), 100.into()),
            radius,
            rod,
            offset: offset / 1000.0,
            piston,
            ends: [rod_mass * centre / rod, rod_mass * (rod - centre) / rod],
        });
    }
    let mut bearings = vec![-0.4];
    for _ in 0..=dice.below(4) {
        bearings.push(bearings[bearings.len() - 1] + (dice.below(20) + 1) as f64 / 64.0);
    }
    let mut weights = Vec::new();
    for _ in 0..dice.below(4) {
        let (mass, radius, angle, at) =
            (dice.below(900) + 1, dice.below(90) + 10, dice.below(72) * 5, dice.below(81) as i64 - 40);
        tables += &format!(
            "[[counterweight]]\nmass = '{mass}/1000'\nradius = '{radius}/1000'\nangle = {angle}\nposition = '{at}/100'\n"
        );
        let position = BigRational::new(at.into(), 100.into());
        weights.push((mass as f64 * radius as f64 / 1e6, (angle as f64).to_radians(), position));
    }
    let names = ["crank_radius", "rod_length", "pin_offset", "piston_mass", "rod_mass", "rod_centre"];
    let keys: Vec<String> =
        names.iter().zip(&keys).map(|(name, values)| format!("{name} = [{}]", values.join(", "))).collect();
    let length = if weights.is_empty() { "" } else { "[crankshaft]\nlength = 2\n" };
    let text = format!("speed = 3000\nbearings = {bearings:?}\n{tables}[mechanism]\n{}\n{length}", keys.join("\n"));
    let layout = layout(&text);
    let unit = layout.unit_mass() * layout.unit_radius();
    Case { unit: float(&unit), layout, bodies, weights }
}

/// All orders that engines of these rods have to a billionth.
fn many() -> Vec<u32> {
    (1..=12).collect()
}

#[test]
fn crankpins_feel_what_the_equations_of_motion_of_piston_and_rod_give() {
    let mut dice = Dice::new(31);
    for _ in 0..100 {
        let Case { layout, bodies, unit, .. } = random(&mut dice);
        let found = pin_loads(&layout, &many()).expect("loads");
        let size = found.pins.iter().map(|pin| pin.peak.value).fold(1e-9, f64::max);
        for (pin, body) in found.pins.iter().zip(&bodies) {
            for step in 0..8 {
                let theta = f64::from(step) * 0.83;
                let expected = body.forces(theta).pin / unit;
                let crank = Complex::cis(theta + body.throw);
                assert!((pin.waveform.at(theta) - expected).norm() < 1e-9 * size);
                assert!((pin.on_the_crank.at(theta) * crank - expected).norm() < 1e-9 * size);
            }
        }
    }
}

/// Reactions at a crank angle from the model, by the stiffness method.
fn reactions(case: &Case, theta: f64) -> Vec<Complex<f64>> {
    let mut bearings: Vec<BigRational> = case.layout.bearings().to_vec();
    bearings.sort();
    let mut all: Vec<(Complex<f64>, &BigRational)> =
        case.bodies.iter().map(|body| (body.forces(theta).pin / case.unit, &body.position)).collect();
    all.extend(case.weights.iter().map(|(size, angle, at)| (Complex::from_polar(size / case.unit, theta + angle), at)));
    let mut places: Vec<&BigRational> = all.iter().map(|(_, at)| *at).collect();
    places.sort();
    places.dedup();
    let unit = stiffness::fixed(&BigRational::one());
    let parts = stiffness::parts(&bearings, &places);
    let part = |bearing: usize, at: &BigRational| {
        let place = places.binary_search(&at).expect("a place");
        float(&BigRational::new(parts[bearing][place].clone(), unit.clone()))
    };
    (0..bearings.len()).map(|bearing| all.iter().map(|(force, at)| force * part(bearing, at)).sum()).collect()
}

#[test]
fn bearings_feel_what_a_beam_hands_on_of_the_equations_of_motion() {
    let mut dice = Dice::new(41);
    for _ in 0..100 {
        let case = random(&mut dice);
        let found = bearing_loads(&case.layout, &many(), Method::Continuous).expect("loads");
        let size = found.bearings.iter().map(|bearing| bearing.peak.value).fold(1e-9, f64::max);
        for theta in [0.4, 2.9, 5.1] {
            for (bearing, expected) in found.bearings.iter().zip(reactions(&case, theta)) {
                let difference = (bearing.waveform.at(theta) - expected).norm();
                assert!(difference < 1e-9 * size, "{difference:e} of {size}");
            }
        }
    }
}

#[test]
fn walls_and_bearings_together_feel_the_shaking_force_and_bearings_alone_do_not() {
    let mut dice = Dice::new(53);
    let mut differ = 0;
    for _ in 0..10 {
        let case = random(&mut dice);
        let found = bearing_loads(&case.layout, &many(), Method::Determinate).expect("loads");
        let whole = loads(&case.layout, &many()).expect("loads");
        for theta in [0.2, 1.7, 4.4] {
            let bearings: Complex<f64> = found.bearings.iter().map(|bearing| bearing.waveform.at(theta)).sum();
            let walls: Complex<f64> = case.bodies.iter().map(|body| body.forces(theta).wall / case.unit).sum();
            let by_hand: Complex<f64> = case.bodies.iter().map(|body| body.forces(theta).shaking / case.unit).sum();
            let weights: Complex<f64> =
                case.weights.iter().map(|(size, angle, _)| Complex::from_polar(size / case.unit, theta + angle)).sum();
            let shaking = whole.force.at(theta);
            assert!((shaking - by_hand - weights).norm() < 1e-9 * (1.0 + shaking.norm()));
            assert!(
                (bearings + walls - shaking).norm() < 1e-9 * (1.0 + shaking.norm()),
                "{bearings} {walls} {shaking}"
            );
            differ += usize::from((bearings - shaking).norm() > 1e-3 * (1.0 + shaking.norm()));
        }
    }
    assert!(differ > 20, "{differ}");
}

fn worst(loads: &BearingLoads) -> f64 {
    loads.bearings.iter().map(|bearing| bearing.peak.value).fold(0.0, f64::max)
}

/// A cross-plane V8 on five bearings, its pins midway.
fn v8(ratio: &str, factor: &str) -> Engine {
    layout(&format!(
        "bearings = [4, 2, 0, -2, -4]\n[vee]\nbank_angle = 90\nthrows = [0, 270, 90, 180]\npositions = [3, 1, -1, -3]\n[mechanism]\n\
         rod_ratio = {ratio}\nreciprocating_mass = 1\ncrank_radius = 1\n[crankshaft]\nbalance_factor = {factor}\ncounterweight_radius = 1\n"
    ))
}

/// The loads of the bearings by the forces along the cylinder axes alone, sampled.
fn along_the_axes(engine: &Engine, ratio: f64, factor: f64) -> Vec<f64> {
    let beam = crankstar::beam::Beam::new(engine.bearings().to_vec()).expect("a beam");
    let mut peaks = vec![0.0_f64; engine.bearings().len()];
    let cylinders: Vec<(f64, f64, Vec<f64>)> = engine
        .cylinders()
        .iter()
        .map(|cylinder| {
            let turn = |turn: &crankstar::exact::Turn| float(turn.turns()) * TAU;
            let parts = beam.influence(&cylinder.position);
            (turn(&cylinder.throw), turn(&cylinder.bank), parts.iter().map(float).collect())
        })
        .collect();
    for step in 0..720 {
        let theta = f64::from(step) / 720.0 * TAU;
        let mut sums = vec![Complex::new(0.0, 0.0); peaks.len()];
        for (throw, bank, parts) in &cylinders {
            let body = Body {
                throw: *throw,
                bank: *bank,
                position: BigRational::zero(),
                radius: 1.0,
                rod: 1.0 / ratio,
                offset: 0.0,
                piston: 1.0,
                ends: [0.0; 2],
            };
            // Half the reciprocating mass of each cylinder for a factor of 1.
            let force = body.forces(theta).shaking - Complex::from_polar(factor / 2.0, theta + throw);
            sums.iter_mut().zip(parts).for_each(|(sum, part)| *sum += force * part);
        }
        peaks.iter_mut().zip(sums).for_each(|(peak, sum)| *peak = peak.max(sum.norm()));
    }
    peaks
}

#[test]
fn without_the_side_force_the_inner_bearings_of_a_cross_plane_v8_come_out_a_third_too_low() {
    for (ratio, factor, percent) in [("0.25", "0", 5.6), ("0.25", "1", 36.0), ("0.325", "1", 43.0)] {
        let engine = v8(ratio, factor);
        let complete = bearing_loads(&engine, &usual_bearing_orders(&engine), Method::Continuous).expect("loads");
        let short = along_the_axes(&engine, ratio.parse().expect("λ"), factor.parse().expect("a factor"));
        for bearing in [1, 3] {
            let low = 100.0 * (1.0 - short[bearing] / complete.bearings[bearing].peak.value);
            assert!((low - percent).abs() < 0.5, "λ = {ratio}, factor {factor}: {low} %");
        }
    }
}

#[test]
fn bearings_call_for_the_odd_orders_that_the_shaking_force_does_not_have() {
    let engine = v8("0.25", "1");
    let orders = usual_bearing_orders(&engine);
    assert!([1, 2, 3, 4, 5].iter().all(|order| orders.contains(order)), "{orders:?}");
    assert_eq!(bearing_orders(&engine, &[1, 2, 4, 6]), orders);
    let given = layout("orders = [1, 2]\nbearings = [1, -1]\n[inline]\nthrows = [0]\n[mechanism]\nrod_ratio = 0.3");
    assert_eq!(usual_bearing_orders(&given), [1, 2]);
}

#[test]
fn what_the_orders_shown_leave_out_is_bounded() {
    for ratio in ["0.1", "0.25", "0.4", "0.8"] {
        let engine = v8(ratio, "1");
        let all = bearing_loads(&engine, &(1..=60).collect::<Vec<u32>>(), Method::Continuous).expect("loads");
        for orders in [vec![1], vec![1, 2], vec![1, 2, 4, 6], usual_bearing_orders(&engine)] {
            let shown = bearing_loads(&engine, &orders, Method::Continuous).expect("loads");
            let bound = left_out_of_bearings(&engine, &shown).expect("numbers").expect("orders are omitted");
            assert!(bound.peak <= worst(&all) * (1.0 + 1e-9), "{ratio} {orders:?}");
            for (shown, all) in shown.bearings.iter().zip(&all.bearings) {
                let missing = (0..90).map(|step| {
                    let theta = f64::from(step) * TAU / 90.0;
                    (all.waveform.at(theta) - shown.waveform.at(theta)).norm()
                });
                let missing = missing.fold(0.0, f64::max);
                assert!(missing <= bound.most, "{ratio} {orders:?}: {missing} {}", bound.most);
            }
        }
    }
    let engine = v8("0.25", "1");
    let usual = bearing_loads(&engine, &usual_bearing_orders(&engine), Method::Continuous).expect("loads");
    assert!(left_out_of_bearings(&engine, &usual).expect("numbers").expect("a bound").part().expect("a part") < 1.1e-4);
}

#[test]
fn a_piston_with_an_offset_leans_on_its_pin_at_every_angle() {
    let engine = layout("bearings = [1, -1]\n[inline]\nthrows = [0]\n[mechanism]\nrod_ratio = 0.3\noffset_ratio = 0.1");
    let found = bearing_loads(&engine, &[1, 2], Method::Continuous).expect("loads");
    let orders: Vec<u32> = found.bearings[0].orders.iter().map(|order| order.order).collect();
    assert_eq!(orders, [0, 1, 2]);
    let constant = &found.bearings[0].orders[0];
    let side = crank("0.3", "0.1").side_coefficient(0).to_complex();
    assert!((constant.swing.largest() - side.norm() / 2.0).abs() < 1e-15 && side.im != 0.0);
    assert!(constant.swing.path.nothing_along && !constant.swing.path.nothing_across);
    let centric = layout("bearings = [1, -1]\n[inline]\nthrows = [0]\n[mechanism]\nrod_ratio = 0.3");
    let found = bearing_loads(&centric, &[2], Method::Continuous).expect("loads");
    assert_eq!(found.bearings[0].orders.len(), 1);
}

#[test]
fn opposed_pistons_over_one_place_leave_nothing() {
    let engine = layout(
        "bearings = [1, -1]\n[[cylinder]]\nthrow = 0\nbank = 0\nposition = 0\n[[cylinder]]\nthrow = 180\nbank = 180\nposition = 0\n\
         [mechanism]\nrod_ratio = 0.3\noffset_ratio = 0.1",
    );
    let found = bearing_loads(&engine, &[1, 2, 3, 4, 5], Method::Continuous).expect("loads");
    assert!(found.bearings.iter().all(|bearing| bearing.orders.iter().all(|order| order.swing.vanishes())));
}

#[test]
fn counterweights_that_cancel_a_rational_first_order_leave_a_proved_zero() {
    // λ = 7/25: the first order that turns with the crank is 25/24 of half the mass.
    let engine = layout(
        "bearings = [1, -1]\norders = [1]\n[inline]\nthrows = [0]\npositions = [0]\n[mechanism]\nrod_ratio = '7/25'\n\
         reciprocating_mass = 1\ncrank_radius = 1\n[[counterweight]]\nangle = 180\nmass = '25/48'\nradius = 1\nposition = 0",
    );
    let found = bearing_loads(&engine, &[1], Method::Continuous).expect("loads");
    let order = &found.bearings[0].orders[0];
    assert!(order.swing.direct.vanishes() && !order.swing.reverse.vanishes());
    let pin = pin_loads(&engine, &[1]).expect("loads");
    assert!(!pin.pins[0].orders[0].swing.direct.vanishes());
}
