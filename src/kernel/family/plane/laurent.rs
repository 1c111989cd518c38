//! What are the coefficients of polynomials in `y = e^{iu}` and its inverse, multiplied with each other's conjugates?

use std::collections::BTreeMap;

use num_rational::BigRational;

use crate::exact::{PhasorSum, Turn};

/// Sums by the power of y before them.
pub(super) type Laurent = BTreeMap<i64, PhasorSum>;

/// `conj(p)·q`.
pub(super) fn conjugate_times(p: &Laurent, q: &Laurent) -> Laurent {
    let mut product = Laurent::new();
    for (i, a) in p {
        for (j, b) in q {
            add(&mut product, j - i, &b.times(&a.conjugate()));
        }
    }
    product
}

/// `p − q`.
pub(super) fn less(mut p: Laurent, q: &Laurent) -> Laurent {
    for (power, sum) in q {
        add(&mut p, *power, &sum.scaled(&BigRational::from_integer((-1).into())));
    }
    p
}

fn add(to: &mut Laurent, power: i64, sum: &PhasorSum) {
    let all = to.entry(power).or_insert_with(|| PhasorSum::new(Vec::new()));
    *all = PhasorSum::new(all.plus(sum).collected());
}

/// Its value at a turn of u.
pub(super) fn value(p: &Laurent, turn: &BigRational) -> PhasorSum {
    let turned = |(power, sum): (&i64, &PhasorSum)| {
        sum.turned(&Turn::new(turn * BigRational::from_integer((*power).into()))).terms().to_vec()
    };
    PhasorSum::new(PhasorSum::new(p.iter().flat_map(turned).collect()).collected())
}
