//! What turns with a crank as fast as it does, which counterweights have to hold? An exact sum, and with offsets sums before irrational numbers.

use num_bigint::BigInt;
use num_complex::Complex;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::error::OptimiseError;
use crate::engine::{Engine, GearedCrank};
use crate::exact::PhasorSum;
use crate::loads::Missing;
use crate::motion::{Coefficient, Enclosure};
use crate::numbers;
use crate::order::{self, Coefficients, Factor, OrderSum, exactly_one};
use crate::proof::Sense;

/// Half the first-order sum that turns with a crankshaft, which is the vector itself, in kilogram-metres: the sums of an engine stand for
/// `P⁺ = 2 · vector` (theory, section 3). Of rods with an offset `c_1 = 1 + iy`, and y is irrational.
pub(super) struct First(Vec<(Coefficient, PhasorSum)>);

/// How a crankshaft turns.
#[derive(Clone, Copy)]
pub(super) struct Turning {
    /// How many times it turns while the reference one turns once.
    pub speed: u32,
    /// In which sense, seen from that.
    pub sense: Sense,
}

impl Turning {
    /// That of one of several crankshafts, or of the only one.
    pub fn of(engine: &Engine, crank: usize) -> Self {
        let of_crank = |crank: &GearedCrank| Turning { speed: crank.speed, sense: crank.sense };
        engine.geared_cranks().get(crank).map_or(Turning { speed: 1, sense: Sense::Direct }, of_crank)
    }

    /// The square of the speed, with which the force of a mass rises.
    pub fn force(self) -> f64 {
        f64::from(self.speed).powi(2)
    }

    /// What turns the other way as fast: a force times this, at a crank angle of the reference, is seen from the turning crank.
    pub fn seen_from(self, theta: f64) -> Complex<f64> {
        let angle = f64::from(self.speed) * theta;
        Complex::cis(if self.sense == Sense::Direct { -angle } else { angle })
    }
}

/// What is left of a vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Residual {
    /// Nothing, proved: its exact sum vanishes.
    Zero,
    /// Its length is between these two, by an enclosure of the exact sum, and of the irrational numbers that offsets put before it.
    Between(f64, f64),
}

impl Residual {
    /// The larger of two.
    pub(super) fn larger(self, other: Self) -> Self {
        match (self, other) {
            (Residual::Zero, one) | (one, Residual::Zero) => one,
            (Residual::Between(a, b), Residual::Between(c, d)) => Residual::Between(a.max(c), b.max(d)),
        }
    }
}

/// Irrational numbers are held in balance to this part of them: far below what a workshop makes.
const DIGITS: i32 = 12;
/// Bits behind the point of an enclosure.
const BITS: u32 = 192;
/// Part that the floats of a product may be off by.
const ROUNDING: f64 = 1e-12;

impl First {
    /// That of one of several crankshafts, or of the only one, each force weighed by its position, in units of m r.
    pub fn new(
        (engine, crank): (&Engine, usize),
        weighing: &dyn Fn(&BigRational) -> BigRational,
        unit: &BigRational,
    ) -> Result<Self, OptimiseError> {
        let Turning { speed, sense } = Turning::of(engine, crank);
        let half = unit / BigRational::from_integer((2 * u64::from(speed) * u64::from(speed)).into());
        let own = order::crankshaft_contributions(engine, crank, speed, sense);
        let all = OrderSum::new(own.iter().map(|one| one.weighed(weighing)));
        let terms = all.parts().iter().flat_map(|(factor, sum)| {
            let real = factor.real_parts(speed).into_iter();
            real.flat_map(move |(factor, turn)| {
                let turn = if sense == Sense::Direct { turn } else { -&turn };
                sum.turned(&turn).terms().iter().map(|term| (factor.clone(), term.clone())).collect::<Vec<_>>()
            })
        });
        // Opposed offsets leave nothing before y.
        let all = OrderSum::new(terms);
        let coefficients = Coefficients::default();
        let part = |(factor, sum): (&Factor, &PhasorSum)| {
            let value = coefficients.of(factor, speed).ok_or(OptimiseError::Missing(Missing::Rods))?;
            Ok((value, sum.scaled(&half)))
        };
        all.parts().iter().map(part).collect::<Result<_, OptimiseError>>().map(First)
    }

    /// Whether it is one exact sum, which counterweights may hold exactly.
    pub fn is_exact(&self) -> bool {
        self.0.iter().all(|(value, _)| *value == exactly_one())
    }

    /// The sum, with irrational numbers rounded.
    pub fn rounded(&self) -> PhasorSum {
        let tens = BigRational::from_integer(10.into()).pow(DIGITS);
        let whole = |number: &Enclosure| -> BigInt {
            ((&number.low + &number.high) * &tens / BigInt::from(2)).round().to_integer()
        };
        let part = |(value, sum): &(Coefficient, PhasorSum)| match *value == exactly_one() {
            true => sum.clone(),
            false => sum.scaled(&(BigRational::from_integer(whole(&value.re)) / &tens)),
        };
        self.0.iter().map(part).fold(PhasorSum::new(Vec::new()), |all, one| all.plus(&one))
    }

    /// How long it is in multiples of m r, this one, times a factor.
    pub fn left(&self, unit: &BigRational, factor: f64) -> Residual {
        if self.0.is_empty() {
            return Residual::Zero;
        }
        let scaled: Vec<_> = self.0.iter().map(|(value, sum)| (value.clone(), sum.scaled(&unit.recip()))).collect();
        let parts = match (scaled.as_slice(), self.is_exact()) {
            ([(_, only)], true) => numbers::enclose(only, BITS),
            _ => numbers::enclose_weighted(scaled.iter().map(|(value, sum)| (value.clone(), sum))),
        };
        let length = |end: fn(&Enclosure) -> BigRational| {
            let [re, im] = parts.each_ref().map(|part| end(part).to_f64().unwrap_or(f64::INFINITY));
            re.hypot(im) * factor
        };
        let [low, high] = [length(Enclosure::smallest), length(Enclosure::largest)];
        Residual::Between(low * (1.0 - ROUNDING), high * (1.0 + ROUNDING))
    }
}
