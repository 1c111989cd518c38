//! Between which fractions does a number lie? Intervals of fractions over a power of two, every end rounded outward.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::real::Real;
use crate::exact::{PhasorSum, Term, Turn};
use crate::numbers;

/// Lower and upper end, in units of `2^−bits`.
type Ends = (BigInt, BigInt);

/// All numbers from `low/2^bits` to `high/2^bits`; without ends every number, where nothing is known.
#[derive(Clone, Debug)]
pub(super) struct Fixed {
    ends: Option<Ends>,
    bits: u32,
}

impl Fixed {
    /// The tightest interval around a rational number.
    pub fn around(number: &BigRational, bits: u32) -> Self {
        Fixed::between(number, number, bits)
    }

    fn between(low: &BigRational, high: &BigRational, bits: u32) -> Self {
        let ends = ((low.numer() << bits).div_floor(low.denom()), (high.numer() << bits).div_ceil(high.denom()));
        Fixed { ends: Some(ends), bits }
    }

    /// Cosine and sine of an angle.
    pub fn direction(angle: &Turn, bits: u32) -> [Fixed; 2] {
        let vector = PhasorSum::new(vec![Term { angle: angle.clone(), weight: BigRational::one() }]);
        // The roundings of the series take less than 32 bits.
        numbers::enclose(&vector, bits + 32).map(|part| Fixed::between(&part.low, &part.high, bits))
    }

    /// Both ends; none where nothing is known.
    pub fn ends(&self) -> Option<[BigRational; 2]> {
        let (low, high) = self.ends.as_ref()?;
        let unit = BigInt::one() << self.bits;
        Some([low, high].map(|end| BigRational::new(end.clone(), unit.clone())))
    }

    fn with(&self, ends: Option<Ends>) -> Self {
        Fixed { ends, bits: self.bits }
    }

    fn both<'a>(&'a self, other: &'a Self) -> Option<(&'a Ends, &'a Ends)> {
        self.ends.as_ref().zip(other.ends.as_ref())
    }
}

impl Real for Fixed {
    fn zero_like(&self) -> Self {
        self.with(Some((BigInt::zero(), BigInt::zero())))
    }

    fn plus(&self, other: &Self) -> Self {
        self.with(self.both(other).map(|((a, b), (c, d))| (a + c, b + d)))
    }

    fn minus(&self, other: &Self) -> Self {
        self.with(self.both(other).map(|((a, b), (c, d))| (a - d, b - c)))
    }

    fn times(&self, other: &Self) -> Self {
        self.with(self.both(other).map(|((a, b), (c, d))| {
            let products = [a * c, a * d, b * c, b * d];
            let low = products.iter().min().cloned().unwrap_or_default();
            let high = products.iter().max().cloned().unwrap_or_default();
            (low >> self.bits, -((-high) >> self.bits))
        }))
    }

    fn root(&self) -> Self {
        let root = |number: &BigInt| (number.max(&BigInt::zero()) << self.bits).sqrt();
        self.with(self.ends.as_ref().map(|(low, high)| (root(low), root(high) + 1)))
    }

    fn inverse(&self) -> Self {
        let one = BigInt::one() << (2 * self.bits);
        let positive = self.ends.as_ref().filter(|(low, _)| low.is_positive());
        self.with(positive.map(|(low, high)| (one.div_floor(high), one.div_ceil(low))))
    }

    fn over(&self, divisor: u32) -> Self {
        let divisor = BigInt::from(divisor);
        self.with(self.ends.as_ref().map(|(low, high)| (low.div_floor(&divisor), high.div_ceil(&divisor))))
    }
}
