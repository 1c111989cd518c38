//! Between which bounds do cosine and sine of a turn lie?

use num_rational::BigRational;
use num_traits::One;

use super::ball::Ball;

/// The cosine of a number of turns.
pub(super) fn cosine(turns: &BigRational, bits: u32) -> Ball {
    let half = BigRational::new(1.into(), 2.into());
    let part = turns - turns.floor();
    let folded = if part > half { BigRational::one() - part } else { part };
    let angle = tau(bits).times(&Ball::rational(&folded, bits));
    let square = angle.times(&angle);
    let (mut sum, mut term) = (Ball::integer(1, bits), Ball::integer(1, bits));
    // The angle is at most π: from the second term on they fall, and alternate.
    for n in 1_u64..=u64::from(bits) {
        term = -term.times(&square).over_integer((2 * n - 1) * 2 * n);
        sum = &sum + &term;
    }
    let rest = term.high().max(-term.low());
    sum.widened(rest)
}

/// The sine of a number of turns.
pub(super) fn sine(turns: &BigRational, bits: u32) -> Ball {
    cosine(&(turns - BigRational::new(1.into(), 4.into())), bits)
}

/// 2π, by Machin's formula: π/4 = 4 arctan(1/5) − arctan(1/239).
fn tau(bits: u32) -> Ball {
    let arctan = |q: u64| {
        let mut power = Ball::integer(1, bits).over_integer(q);
        let mut sum = power.clone();
        for n in 1_u64..=u64::from(bits) / 2 {
            power = -power.over_integer(q * q);
            sum = &sum + &power.over_integer(2 * n + 1);
        }
        // Alternating terms that fall: what follows is smaller than the last.
        let rest = power.high().max(-power.low());
        sum.widened(rest)
    };
    &arctan(5).times_integer(32) - &arctan(239).times_integer(8)
}
