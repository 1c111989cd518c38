//! How does a value change with the angle? With its first and its second derivative, carried through sums, products and roots.

use std::ops::{Add, Mul, Neg, Sub};

/// A value with its derivatives by ψ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet {
    /// The value.
    pub value: f64,
    /// `d/dψ`.
    pub first: f64,
    /// `d²/dψ²`.
    pub second: f64,
}

impl Jet {
    /// What does not change.
    pub(super) fn constant(value: f64) -> Self {
        Jet { value, first: 0.0, second: 0.0 }
    }

    /// Cosine and sine of an angle.
    pub(super) fn circle(psi: f64) -> [Self; 2] {
        let (sin, cos) = psi.sin_cos();
        [Jet { value: cos, first: -sin, second: -cos }, Jet { value: sin, first: cos, second: -sin }]
    }

    pub(super) fn times(self, factor: f64) -> Self {
        Jet { value: self.value * factor, first: self.first * factor, second: self.second * factor }
    }

    pub(super) fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        let first = self.first / (2.0 * value);
        Jet { value, first, second: (self.second / 2.0 - first * first) / value }
    }

    pub(super) fn over(self, other: Self) -> Self {
        let value = self.value / other.value;
        let first = (self.first - value * other.first) / other.value;
        Jet { value, first, second: (self.second - 2.0 * first * other.first - value * other.second) / other.value }
    }

    /// `1 − √(1 − x²)`, without cancellation, and the root.
    pub(super) fn versed(self) -> [Self; 2] {
        let one = Jet::constant(1.0);
        let root = ((one - self) * (one + self)).sqrt();
        [(self * self).over(one + root), root]
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Jet { value: self.value + other.value, first: self.first + other.first, second: self.second + other.second }
    }
}

impl Neg for Jet {
    type Output = Self;
    fn neg(self) -> Self {
        self.times(-1.0)
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Jet {
            value: self.value * other.value,
            first: self.first * other.value + self.value * other.first,
            second: self.second * other.value + 2.0 * self.first * other.first + self.value * other.second,
        }
    }
}
