//! Linear equations in complex numbers, by elimination with rows exchanged: knows nothing of trees.

use num_complex::Complex;

/// `x` of `A x = b`.
pub fn solve(mut rows: Vec<Vec<Complex<f64>>>, mut right: Vec<Complex<f64>>) -> Vec<Complex<f64>> {
    let count = right.len();
    for column in 0..count {
        let size = |row: &usize| rows[*row][column].norm();
        let pivot = (column..count).max_by(|one, other| size(one).total_cmp(&size(other))).expect("a row");
        rows.swap(column, pivot);
        right.swap(column, pivot);
        let (above, below) = rows.split_at_mut(column + 1);
        let first = &above[column];
        for (row, at) in below.iter_mut().zip(column + 1..) {
            let factor = row[column] / first[column];
            row.iter_mut().zip(first).for_each(|(value, one)| *value -= factor * one);
            let known = right[column];
            right[at] -= factor * known;
        }
    }
    for column in (0..count).rev() {
        let known: Complex<f64> = (column + 1..count).map(|other| rows[column][other] * right[other]).sum();
        right[column] = (right[column] - known) / rows[column][column];
    }
    right
}
