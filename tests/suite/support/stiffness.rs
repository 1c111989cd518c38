//! What carries a load by the direct stiffness method? Cubic beam elements, in fixed point with 900 binary places.
//!
//! An oracle that shares nothing with the room: unknown deflections and slopes instead of moments, nodes at the supports
//! and under the load, Gauss elimination. Floats would not do: spans at 10⁶ : 1 put 10¹⁸ between the stiffnesses.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;

const PLACES: usize = 900;

/// A number in whole parts of 2⁻⁹⁰⁰, rounded.
pub fn fixed(number: &BigRational) -> BigInt {
    (number.numer() << PLACES) / number.denom()
}

fn times(a: &BigInt, b: &BigInt) -> BigInt {
    (a * b) >> PLACES
}

fn over(a: &BigInt, b: &BigInt) -> BigInt {
    (a << PLACES) / b
}

/// Stiffness of a beam element with EI = 1: rows and columns are deflection and slope of its left and its right end.
fn element(length: &BigRational) -> [[BigInt; 4]; 4] {
    let inverse = length.recip();
    let (squared, cubed) = (&inverse * &inverse, &inverse * &inverse * &inverse);
    let (a, b, c, d): (BigInt, BigInt, BigInt, BigInt) =
        (fixed(&cubed) * 12, fixed(&squared) * 6, fixed(&inverse) * 4, fixed(&inverse) * 2);
    [
        [a.clone(), b.clone(), -&a, b.clone()],
        [b.clone(), c.clone(), -&b, d.clone()],
        [-&a, -&b, a, -&b],
        [b.clone(), d, -b, c],
    ]
}

/// Solves a symmetric positive definite system for several right-hand sides, one a column; entries of a row further than
/// `band` from its diagonal are zero.
fn solve(mut matrix: Vec<Vec<BigInt>>, mut right: Vec<Vec<BigInt>>, band: usize) -> Vec<Vec<BigInt>> {
    let size = right.len();
    for pivot in 0..size {
        let (done, below) = matrix.split_at_mut(pivot + 1);
        let (solved, sides) = right.split_at_mut(pivot + 1);
        for (row, side) in below.iter_mut().zip(sides).take(band) {
            let factor = over(&row[pivot], &done[pivot][pivot]);
            subtract(&mut row[pivot..size.min(pivot + band + 1)], &factor, &done[pivot][pivot..]);
            subtract(side, &factor, &solved[pivot]);
        }
    }
    for row in (0..size).rev() {
        let (side, solved) = right[row..].split_first_mut().expect("a row");
        for (entry, known) in matrix[row][row + 1..].iter().zip(solved.iter()).take(band) {
            subtract(side, entry, known);
        }
        side.iter_mut().for_each(|value| *value = over(value, &matrix[row][row]));
    }
    right
}

fn subtract(from: &mut [BigInt], factor: &BigInt, what: &[BigInt]) {
    from.iter_mut().zip(what).for_each(|(entry, value)| *entry -= times(factor, value));
}

/// What the supports, in ascending order, carry of a unit load at each of these positions: for each support one row, for
/// each load one column, in parts of 2⁻⁹⁰⁰ with rounding errors far below the 200th decimal place.
pub fn parts(supports: &[BigRational], positions: &[&BigRational]) -> Vec<Vec<BigInt>> {
    let mut nodes: Vec<_> = supports.iter().chain(positions.iter().copied()).collect();
    nodes.sort();
    nodes.dedup();
    let deflection = |place: &BigRational| 2 * nodes.binary_search(&place).expect("a node of its own");
    let size = 2 * nodes.len();
    let mut stiffness = vec![vec![BigInt::zero(); size]; size];
    for (left, ends) in nodes.windows(2).enumerate() {
        for (row, values) in element(&(ends[1] - ends[0])).into_iter().enumerate() {
            for (column, value) in values.into_iter().enumerate() {
                stiffness[2 * left + row][2 * left + column] += value;
            }
        }
    }
    let mut loads = vec![vec![BigInt::zero(); positions.len()]; size];
    for (load, position) in positions.iter().enumerate() {
        loads[deflection(position)][load] = fixed(&BigRational::from_integer(1.into()));
    }
    // Deflections of the supports are zero: their rows and columns fall out.
    let held: Vec<usize> = supports.iter().map(deflection).collect();
    let free: Vec<usize> = (0..size).filter(|freedom| !held.contains(freedom)).collect();
    let matrix = free.iter().map(|&row| free.iter().map(|&column| stiffness[row][column].clone()).collect()).collect();
    let displacements = solve(matrix, free.iter().map(|&row| loads[row].clone()).collect(), 3);
    // A support carries what is loaded on it and what the bent elements beside it do not hold up.
    let mut carried: Vec<_> = held.iter().map(|&row| loads[row].clone()).collect();
    for (&row, parts) in held.iter().zip(&mut carried) {
        for (&column, bent) in free.iter().zip(&displacements).filter(|(column, _)| column.abs_diff(row) <= 3) {
            subtract(parts, &stiffness[row][column], bent);
        }
    }
    carried
}
