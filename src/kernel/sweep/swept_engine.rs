//! What does one engine of a sweep come to? Its amplitudes in floats, its zeros exactly.

use std::collections::BTreeMap;

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::amplitude::{Amplitude, Amplitudes, float};
use super::counterweight::counterweight;
use super::envelope::{Envelope, Geometry, envelope};
use super::evenness::{Evenness, dead_centre_intervals, evenness};
use super::integers::{IntegerEngine, KnownWeights, Pair};
use crate::engine::{self, Cycle, Engine, Rod};
use crate::loads::{self, Missing};
use crate::motion::coefficients_fast;
use crate::numbers;
use crate::order::{self, Coefficients, Factor, OrderSum, Path};
use crate::proof::{Planar, Sense};

/// One order.
#[derive(Clone, Debug, PartialEq)]
pub struct SweptOrder {
    /// The order k.
    pub order: u32,
    /// The shaking force.
    pub force: Amplitudes,
    /// Its moment about the reference plane.
    pub moment: Amplitudes,
}

impl SweptOrder {
    /// The force or the moment.
    pub fn amplitudes(&self, quantity: Planar) -> &Amplitudes {
        quantity.choose(&self.force, &self.moment)
    }
}

/// One engine of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct SweptEngine {
    /// The values of the parameters, in their units.
    pub values: Vec<BigRational>,
    /// The orders, rising.
    pub orders: Vec<SweptOrder>,
    /// Newtons per multiple of m r ω²; none where the engine does not say. In a sweep m and r are those of its first point.
    pub newtons: Option<f64>,
    /// Kilograms at the crank radius per multiple of m r; none where the engine does not say.
    pub kilograms: Option<f64>,
    /// How evenly the cylinders fire, where that is known.
    pub evenness: Option<Evenness>,
    /// Whether offsets move the top dead centres apart, so that these do not come at the firing intervals.
    pub dead_centres_apart: bool,
    /// Then the shortest and the longest interval between those of the file's firing order, in degrees; none without one.
    pub dead_centres: Option<[f64; 2]>,
    /// Mass-radius, in multiples of m r, of the larger of two counterweights in the outermost throws that cancel what
    /// of order 1 turns with the crank; none where one plane would have to hold a couple.
    pub counterweight: Option<Amplitude>,
    /// What the engine fits into.
    pub envelope: Option<Envelope>,
}

/// The coefficients of the motion by rod, each computed once, the numbers of other mechanisms, and the weights of the pistons of the engine
/// before.
#[derive(Default)]
pub(super) struct Motions {
    by_rod: BTreeMap<Rod, Vec<Complex<f64>>>,
    others: Coefficients,
    weights: KnownWeights,
}

impl Motions {
    fn coefficient(&mut self, rod: &Rod, order: u32, highest: u32) -> Complex<f64> {
        if !self.by_rod.contains_key(rod) {
            // A sweep over rods would collect one entry per point.
            if self.by_rod.len() > 64 {
                self.by_rod.clear();
            }
            self.by_rod.insert(rod.clone(), coefficients(rod, highest));
        }
        self.by_rod.get(rod).and_then(|all| all.get(order as usize)).copied().unwrap_or_default()
    }

    /// A number of what is no rod on the crankpin.
    fn number(&mut self, factor: &Factor, order: u32) -> Complex<f64> {
        // Nor are those of a sweep kept, of which each may cost the points of a turn.
        if self.others.computed() > 256 {
            self.others = Coefficients::default();
        }
        self.others.of(factor, order).map(|number| number.to_complex()).unwrap_or_default()
    }
}

fn coefficients(rod: &Rod, highest: u32) -> Vec<Complex<f64>> {
    if rod.offset.is_zero() {
        let real = coefficients_fast(numbers::float(&rod.ratio), highest);
        return real.into_iter().map(|value| Complex::new(value, 0.0)).collect();
    }
    let crank = order::crank_of(rod);
    (0..=highest).map(|order| crank.coefficient(order).to_complex()).collect()
}

/// Judges one engine at these orders.
///
/// # Errors
/// What the engine lacks for its masses to be compared.
pub fn judge(
    engine: &Engine,
    cycle: Option<Cycle>,
    orders: &[u32],
    geometry: &Geometry,
) -> Result<SweptEngine, Missing> {
    judge_with(engine, cycle, orders, geometry, &mut Motions::default())
}

pub(super) fn judge_with(
    engine: &Engine,
    cycle: Option<Cycle>,
    orders: &[u32],
    geometry: &Geometry,
    motions: &mut Motions,
) -> Result<SweptEngine, Missing> {
    order::comparable(engine)?;
    engine::are_orders(orders)?;
    // Without rods amplitudes are in multiples of c_k, which is another number for each speed.
    if engine.faster_crank().is_some() && engine.mechanisms().is_empty() {
        return Err(Missing::Rods);
    }
    let whole = IntegerEngine::new(engine, &mut motions.weights);
    let highest = orders.iter().copied().max().unwrap_or(1).max(1);
    let rods_known = !engine.mechanisms().is_empty();
    let judged = orders.iter().map(|&order| {
        // An order that does not exist has the coefficient 0, which those of rods that are known say themselves.
        if !rods_known && !engine.has_order(order) {
            return SweptOrder { order, force: Amplitudes::ZERO, moment: Amplitudes::ZERO };
        }
        let [force, moment] = match whole.as_ref().filter(|whole| whole.knows(order)) {
            Some(whole) => from_words(engine, whole, order, highest, motions),
            None => Planar::BOTH.map(|quantity| from_sums(engine, quantity, order, highest, motions)),
        };
        SweptOrder { order, force, moment }
    });
    let orders: Vec<SweptOrder> = judged.collect();
    let mechanism = engine.dimensions();
    Ok(SweptEngine {
        values: Vec::new(),
        orders,
        newtons: loads::scale(engine).filter(|_| rods_known).map(|scale| scale.force()),
        kilograms: mechanism.mass.as_ref().and_then(|_| engine.unit_mass().to_f64()),
        evenness: evenness(engine, cycle, whole.as_ref()),
        dead_centres_apart: engine.has_dead_centres_apart(),
        dead_centres: dead_centre_intervals(engine),
        counterweight: counterweight(engine, whole.as_ref()),
        envelope: envelope(engine, geometry),
    })
}

fn from_words(
    engine: &Engine,
    whole: &IntegerEngine,
    order: u32,
    highest: u32,
    motions: &mut Motions,
) -> [Amplitudes; 2] {
    let coefficient = match engine.mechanisms().first().and_then(|mechanism| mechanism.rod()) {
        Some(rod) => motions.coefficient(rod, order, highest),
        None => Complex::new(1.0, 0.0),
    };
    if coefficient.is_zero() {
        return [Amplitudes::ZERO; 2];
    }
    let pairs = whole.pairs(order);
    Planar::BOTH.map(|quantity| {
        let Pair { direct, mirrored, zeros, total_length } = pairs[usize::from(quantity == Planar::Moment)];
        let total_length = total_length * coefficient.norm();
        amplitudes([direct * coefficient, mirrored * coefficient], zeros, (total_length, true), &|| {
            let [direct, reverse] = Sense::BOTH.map(|sense| order::all_masses(engine, quantity, order, sense));
            direct.is_as_long_as(&reverse, order)
        })
    })
}

/// The amplitudes of `½(P⁺, P̄⁻)`; which of P⁺, P⁻, P⁺ + P̄⁻ and P⁺ − P̄⁻ are zero is known, and whether both are equally
/// long is decided where it may be: where they differ by little of `total_length`, the length of all their terms end to end. Where they are not
/// `one_sum` each, before one coefficient, so small a value may be zero without a proof.
fn amplitudes(
    [direct, mirrored]: [Complex<f64>; 2],
    [plus, minus, along, across]: [bool; 4],
    (total_length, one_sum): (f64, bool),
    equally_long: &dyn Fn() -> bool,
) -> Amplitudes {
    let amplitude = |value: f64, vanishes: bool| match vanishes {
        true => Amplitude::ZERO,
        false => {
            let is_undecided = !one_sum && value <= numbers::ALIKE * total_length;
            Amplitude { is_undecided, ..Amplitude::decided(value) }
        }
    };
    let part = |value: Complex<f64>, vanishes: bool| amplitude(value.norm() / 2.0, vanishes);
    let (one, other) = (part(direct, plus), part(mirrored, minus));
    let (direct, mirrored) =
        (if plus { Complex::zero() } else { direct }, if minus { Complex::zero() } else { mirrored });
    let largest = one.value + other.value;
    let smallest = (one.value - other.value).abs();
    let none = plus && minus;
    // Where P⁺ = ±P̄⁻ both are equally long.
    let flat = none || along || across || (smallest <= numbers::ALIKE * total_length && equally_long());
    Amplitudes {
        direct: one,
        reverse: other,
        largest: amplitude(largest, none),
        smallest: amplitude(smallest, flat),
        along: part(direct + mirrored, along),
        across: part(direct - mirrored, across),
    }
}

fn from_sums(engine: &Engine, quantity: Planar, order: u32, highest: u32, motions: &mut Motions) -> Amplitudes {
    let [direct, reverse] = Sense::BOTH.map(|sense| order::all_masses(engine, quantity, order, sense));
    let mirrored = reverse.mirrored();
    let (plus, minus) = (direct.vanishes(), mirrored.vanishes());
    let [along, across] = match (plus, minus) {
        (true, true) => [true, true],
        (false, false) => [Path::has_nothing_along(&direct, &reverse), Path::has_nothing_across(&direct, &reverse)],
        _ => [false, false],
    };
    let mut coefficient = |factor: &Factor| match factor.own(order) {
        (Factor::Motion(rod), order) => motions.coefficient(rod, order, highest),
        (Factor::Quadrature(rod), _) => Complex::new(motions.coefficient(rod, 1, highest).im, 0.0),
        // Of rods that are not given, amplitudes are in multiples of c_k.
        (Factor::One | Factor::Open, _) => Complex::new(1.0, 0.0),
        (other, order) => motions.number(other, order),
    };
    let mut value = |sum: &OrderSum| -> Complex<f64> {
        sum.parts().iter().map(|(factor, sum)| coefficient(factor) * float(sum)).sum()
    };
    let (direct_value, mirrored_value) = (value(&direct), value(&mirrored));
    let mut total_length = 0.0;
    for (factor, sum) in direct.parts().iter().chain(mirrored.parts()) {
        let weights = sum.terms().iter().map(|term| term.weight.abs().to_f64().unwrap_or(f64::INFINITY));
        total_length += coefficient(factor).norm() * weights.sum::<f64>();
    }
    let one_sum = direct.parts().len() <= 1 && mirrored.parts().len() <= 1;
    amplitudes([direct_value, mirrored_value], [plus, minus, along, across], (total_length, one_sum), &|| {
        direct.is_as_long_as(&reverse, order)
    })
}
