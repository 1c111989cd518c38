//! In which bounds lies `Σ coefficient · sum`?

use num_rational::BigRational;

use super::evaluate::enclose;
use crate::exact::PhasorSum;
use crate::motion::{Coefficient, Enclosure};

/// Bits behind the point of the sums: more than the coefficients are known to.
const BITS: u32 = 192;

/// Real and imaginary part of sums that stand before coefficients of the motion.
pub fn enclose_weighted<'a>(pairs: impl IntoIterator<Item = (Coefficient, &'a PhasorSum)>) -> [Enclosure; 2] {
    let minus = BigRational::from_integer((-1).into());
    let mut total = [Enclosure::zero(), Enclosure::zero()];
    for (c, sum) in pairs {
        let [re, im] = enclose(sum, BITS).map(|(low, high)| Enclosure { low, high });
        total[0] = total[0].plus(&c.re.product(&re)).plus(&c.im.product(&im).times(&minus));
        total[1] = total[1].plus(&c.re.product(&im)).plus(&c.im.product(&re));
    }
    total
}
