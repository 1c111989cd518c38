//! What are the exact values of a star?

use super::firing;
use super::front::StarValues;
use super::space::Space;
use super::tables::{AXES, Tables};
use super::value::{self, Value};

/// The exact values of a star, with their enclosures.
pub(super) fn point(space: &Space, throws: Vec<u16>, bounds: &[(i128, i128)], stars: u64) -> StarValues {
    let values = space.orders.iter().zip(bounds).map(|(&order, &bounds)| Value::new(space, &throws, order, bounds));
    let neighbours = space.slots.as_ref().map_or(0, |slots| {
        let steps: Vec<&[usize]> = throws.iter().map(|&throw| slots[usize::from(throw)].as_slice()).collect();
        firing::best_order(&steps).1
    });
    StarValues { values: values.collect(), neighbours, throws, classes: 1, stars }
}

/// The exact values of one star.
pub(super) fn judge(space: &Space, tables: &Tables, throws: &[u16]) -> StarValues {
    let bounds = |row: usize| {
        let mut sums = [0_i64; 2];
        for (&throw, weight) in throws.iter().zip(&space.weights) {
            let projections = tables.projections(row, usize::from(throw));
            sums[0] += weight * projections[0];
            sums[1] += weight * projections[AXES / 2];
        }
        value::square(sums[0], sums[1], tables.doubt)
    };
    let bounds: Vec<(i128, i128)> = (0..space.orders.len()).map(bounds).collect();
    point(space, throws.to_vec(), &bounds, 1)
}
