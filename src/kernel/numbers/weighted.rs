//! In which bounds lies `Σ coefficient · sum`?

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::evaluate::fixed_ends;
use crate::exact::PhasorSum;
use crate::motion::{Coefficient, Enclosure};

/// Bits behind the point of the sums: more than the coefficients are known to.
const BITS: u32 = 192;

/// Real and imaginary part of sums that are multiplied by coefficients of the motion.
pub fn enclose_weighted<'a>(pairs: impl IntoIterator<Item = (Coefficient, &'a PhasorSum)>) -> [Enclosure; 2] {
    let mut total = [Span::zero(), Span::zero()];
    for (c, sum) in pairs {
        let (ends, scale) = fixed_ends(sum, BITS);
        let [re, im] = ends.map(|ends| Span::over(ends, &scale, BITS));
        let (cos, sin) = (Span::around(&c.re), Span::around(&c.im));
        total[0].add(&cos.times(&re));
        total[0].add(&sin.times(&im).negative());
        total[1].add(&cos.times(&im));
        total[1].add(&sin.times(&re));
    }
    total.map(Span::enclosure)
}

/// All numbers of `low ..= high` in units of `2^−bits`. Fractions over powers of two need no common divisors, which rational numbers spend their
/// time on.
struct Span {
    low: BigInt,
    high: BigInt,
    bits: u64,
}

impl Span {
    /// Zero, exactly.
    fn zero() -> Self {
        Span { low: BigInt::zero(), high: BigInt::zero(), bits: 0 }
    }

    /// From ends in units of `2^−bits` over `scale`, rounded outward where the scale is not 1.
    fn over([low, high]: [BigInt; 2], scale: &BigInt, bits: u32) -> Self {
        if scale.is_one() {
            return Span { low, high, bits: bits.into() };
        }
        let more = scale.bits();
        Span { low: (low << more).div_floor(scale), high: (high << more).div_ceil(scale), bits: u64::from(bits) + more }
    }

    /// A coefficient, rounded outward where an end is no fraction over a power of two.
    fn around(number: &Enclosure) -> Self {
        let denominator = number.low.denom().lcm(number.high.denom());
        let whole = |end: &BigRational| end.numer() * (&denominator / end.denom());
        let ends = [whole(&number.low), whole(&number.high)];
        let twos = denominator.bits() - 1;
        if denominator.trailing_zeros() == Some(twos) {
            let [low, high] = ends;
            return Span { low, high, bits: twos };
        }
        Span::over(ends.map(|end| end << BITS), &denominator, BITS)
    }

    /// The product of two numbers: its ends are among the products of their ends.
    fn times(&self, other: &Span) -> Span {
        let ends = [&self.low * &other.low, &self.low * &other.high, &self.high * &other.low, &self.high * &other.high];
        let [first, rest @ ..] = ends;
        let (mut low, mut high) = (first.clone(), first);
        for end in rest {
            if end < low {
                low = end;
            } else if end > high {
                high = end;
            }
        }
        Span { low, high, bits: self.bits + other.bits }
    }

    fn negative(self) -> Span {
        Span { low: -self.high, high: -self.low, bits: self.bits }
    }

    fn add(&mut self, other: &Span) {
        let bits = self.bits.max(other.bits);
        let (own, others) = (bits - self.bits, bits - other.bits);
        self.low = (&self.low << own) + (&other.low << others);
        self.high = (&self.high << own) + (&other.high << others);
        self.bits = bits;
    }

    fn enclosure(self) -> Enclosure {
        let end = |number: BigInt| {
            let common = number.trailing_zeros().map_or(self.bits, |twos| twos.min(self.bits));
            // In lowest terms: the numerator is odd, or the denominator 1.
            BigRational::new_raw(number >> common, BigInt::one() << (self.bits - common))
        };
        Enclosure { low: end(self.low), high: end(self.high) }
    }
}
