//! How large is an order of a swept engine? Amplitudes in floats, with what is proved to be zero.

use std::f64::consts::TAU;

use num_complex::Complex;
use num_traits::Signed;

use crate::exact::PhasorSum;
use crate::numbers;

/// An amplitude, zero to peak.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Amplitude {
    /// In multiples of m r ω², for moments times the unit of the positions; of m r ω² c_k where no rod is given.
    pub value: f64,
    /// Whether it is proved to be zero.
    pub vanishes: bool,
    /// Whether neither that is proved nor, of sums with several coefficients, that it is other than zero: it is as small as roundings.
    pub is_undecided: bool,
}

impl Amplitude {
    /// One that is proved to be zero.
    pub const ZERO: Amplitude = Amplitude { value: 0.0, vanishes: true, is_undecided: false };

    /// One that is known to be other than zero, or is a sum before one coefficient.
    pub fn decided(value: f64) -> Self {
        Amplitude { value, vanishes: false, is_undecided: false }
    }

    /// The same in another unit, of which one of this is so many.
    pub(super) fn times(self, factor: f64) -> Self {
        Amplitude { value: self.value * factor, ..self }
    }

    /// Whether it is zero; none where that is not decided.
    pub fn is_zero(self) -> Option<bool> {
        (!self.is_undecided).then_some(self.vanishes)
    }
}

/// What an order of the force or the moment comes to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Amplitudes {
    /// The half of P⁺ that turns with the crank.
    pub direct: Amplitude,
    /// The half of P⁻ that turns against it.
    pub reverse: Amplitude,
    /// Largest length in a revolution.
    pub largest: Amplitude,
    /// Smallest length: zero where both vectors are equally long.
    pub smallest: Amplitude,
    /// Along the reference direction: vertical.
    pub along: Amplitude,
    /// Across it: horizontal.
    pub across: Amplitude,
}

/// One of the amplitudes.
pub type AmplitudeOf = fn(&Amplitudes) -> Amplitude;

impl Amplitudes {
    /// Those of what is proved to be zero.
    pub const ZERO: Amplitudes = {
        let zero = Amplitude::ZERO;
        Amplitudes { direct: zero, reverse: zero, largest: zero, smallest: zero, along: zero, across: zero }
    };

    /// Each of them by name, as columns and curves have them.
    pub const NAMED: [(&'static str, AmplitudeOf); 6] = [
        ("largest", |all| all.largest),
        ("smallest", |all| all.smallest),
        ("along", |all| all.along),
        ("across", |all| all.across),
        ("direct", |all| all.direct),
        ("reverse", |all| all.reverse),
    ];

    /// All of them in another unit, of which one of theirs is so many.
    pub fn scale(&mut self, factor: f64) {
        let Amplitudes { direct, reverse, largest, smallest, along, across } = self;
        for part in [direct, reverse, largest, smallest, along, across] {
            *part = part.times(factor);
        }
    }

    /// All of them by name.
    pub fn named(&self) -> [(&'static str, Amplitude); 6] {
        Amplitudes::NAMED.map(|(name, part)| (name, part(self)))
    }
}

/// A sum in floats.
pub(super) fn float(sum: &PhasorSum) -> Complex<f64> {
    let vectors = sum.terms().iter().map(|term| {
        let weight = numbers::float(&term.weight);
        let vector = Complex::from_polar(weight.abs(), TAU * numbers::float(term.angle.turns()));
        if term.weight.is_negative() { -vector } else { vector }
    });
    vectors.sum()
}
