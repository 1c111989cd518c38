//! What is left of another order where the first is lost? Theorem 6.

use super::factors::two_primes;
use super::fate::Pins;

/// Where the moment of order 1 is zero, that of this order is at least `factor` times the least first-order moment of `of` throws; some star has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Least {
    /// The order.
    pub order: u32,
    /// A prime.
    pub factor: u32,
    /// The other prime.
    pub of: u32,
}

/// The bounds of these orders where the first-order moment of a product of two primes is zero.
pub fn least(pins: Pins, orders: &[u32]) -> Vec<Least> {
    let Some([p, q]) = two_primes(pins.directions).filter(|_| pins.each == 1) else { return Vec::new() };
    let of_order = |&order: &u32| {
        let of = pins.root(order);
        [p, q].contains(&of).then(|| Least { order, factor: pins.directions / of, of })
    };
    orders.iter().filter_map(of_order).collect()
}
