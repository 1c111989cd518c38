//! How fast does a number change with the crank angle? Numbers that carry their derivative along.

use super::real::Real;

/// A number and its derivative; a jet of jets has the second derivative too.
#[derive(Clone, Debug)]
pub(super) struct Jet<T> {
    pub value: T,
    pub slope: T,
}

impl<T: Real> Jet<T> {
    /// A number that does not change.
    pub fn constant(value: &T) -> Self {
        Jet { value: value.clone(), slope: value.zero_like() }
    }
}

/// Cosine and sine of an angle, with their derivatives.
pub(super) fn turning<T: Real>([cos, sin]: &[T; 2]) -> [Jet<T>; 2] {
    let minus_sin = sin.zero_like().minus(sin);
    [Jet { value: cos.clone(), slope: minus_sin }, Jet { value: sin.clone(), slope: cos.clone() }]
}

impl<T: Real> Real for Jet<T> {
    fn zero_like(&self) -> Self {
        Jet { value: self.value.zero_like(), slope: self.value.zero_like() }
    }

    fn plus(&self, other: &Self) -> Self {
        Jet { value: self.value.plus(&other.value), slope: self.slope.plus(&other.slope) }
    }

    fn minus(&self, other: &Self) -> Self {
        Jet { value: self.value.minus(&other.value), slope: self.slope.minus(&other.slope) }
    }

    fn times(&self, other: &Self) -> Self {
        let slope = self.slope.times(&other.value).plus(&self.value.times(&other.slope));
        Jet { value: self.value.times(&other.value), slope }
    }

    fn squared(&self) -> Self {
        let half = self.value.times(&self.slope);
        Jet { value: self.value.squared(), slope: half.plus(&half) }
    }

    fn root(&self) -> Self {
        let root = self.value.root();
        let slope = self.slope.times(&root.inverse()).over(2);
        Jet { value: root, slope }
    }

    fn inverse(&self) -> Self {
        let inverse = self.value.inverse();
        let slope = self.slope.zero_like().minus(&self.slope.times(&inverse.squared()));
        Jet { value: inverse, slope }
    }

    fn over(&self, divisor: u32) -> Self {
        Jet { value: self.value.over(divisor), slope: self.slope.over(divisor) }
    }
}
