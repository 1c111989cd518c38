//! What are the exact values of a star?

use super::front::StarValues;
use super::space::Space;
use super::symmetry;
use super::tables::{AXES, Tables};
use super::value::{self, Value};

/// The exact values of the stars of a class, of which one is given with enclosures of its moments: one point where all its images have the
/// same values and firing orders do not count.
pub(super) fn points(space: &Space, throws: Vec<u16>, bounds: &[(i128, i128)], stars: u64) -> Vec<StarValues> {
    if space.keeps == symmetry::EVERY_IMAGE {
        return of_star(space, throws, bounds, stars);
    }
    let variants = symmetry::variants(&throws, space.directions, space.keeps);
    variants.into_iter().flat_map(|(throws, stars)| of_star(space, throws, bounds, stars)).collect()
}

/// The points of one star, one for each of its firing orders where they count.
fn of_star(space: &Space, throws: Vec<u16>, bounds: &[(i128, i128)], stars: u64) -> Vec<StarValues> {
    let of_pins = space.orders.iter().zip(bounds).map(|(&order, &bounds)| Value::new(space, &throws, order, bounds));
    let mut values: Vec<Value> = of_pins.collect();
    values.extend(space.entangled.iter().flat_map(|entangled| entangled.values(&throws)));
    let Some(twist) = &space.twist else {
        let neighbours = space.clock.as_ref().map_or(0, |clock| clock.neighbours(&throws));
        return vec![StarValues { values, neighbours, throws, firing_order: None, classes: 1, stars }];
    };
    let fired = twist.of(&throws, space.clock.is_some()).into_iter();
    fired
        .map(|fired| StarValues {
            values: values.iter().cloned().chain(fired.values).collect(),
            neighbours: fired.neighbours,
            throws: throws.clone(),
            firing_order: Some(fired.order),
            classes: 1,
            stars,
        })
        .collect()
}

/// The exact values of one star: one point for each of its firing orders where they count.
pub(super) fn judge(space: &Space, tables: &Tables, throws: &[u16]) -> Vec<StarValues> {
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
    of_star(space, throws.to_vec(), &bounds, 1)
}

impl Value {
    /// The value of a star at an order, with an enclosure of it.
    pub fn new(space: &Space, throws: &[u16], order: u32, bounds: (i128, i128)) -> Self {
        let exponents = throws.iter().map(|&throw| usize::from(throw) * order as usize % space.directions);
        Value::of(space.directions, &exponents.zip(space.weights.iter().copied()).collect::<Vec<_>>(), bounds)
    }
}
