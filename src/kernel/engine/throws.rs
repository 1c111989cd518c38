//! Which throws has the crankshaft? Each is a crankpin, with the cylinders that share it.

use num_rational::BigRational;

use super::model::Engine;
use crate::exact::Turn;

/// One throw: a crankpin between its webs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Throw {
    /// Its angle β: where its pin is at θ = 0.
    pub angle: Turn,
    /// Which crankshaft it is on, where several are geared together; else 0.
    pub crank: usize,
    /// Where it stands: the middle between its outermost cylinders.
    pub position: BigRational,
    /// Crank radius, in multiples of that of the layout.
    pub crank_radius: BigRational,
    /// The cylinders that work on it, by their index.
    pub cylinders: Vec<usize>,
}

/// The throws of a crankshaft, in the order of its pins; the parts of a split pin are throws of their own, from the free end on, and
/// where they are at one place in the order of their cylinders.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// let v8 = crankstar::file::find("V8-crossplane").unwrap().engine().unwrap();
/// let throws = crankstar::engine::throws(&v8);
/// assert_eq!(throws.len(), 4);
/// assert_eq!(throws[0].cylinders, [0, 4]);
/// ```
pub fn throws(engine: &Engine) -> Vec<Throw> {
    let mut order: Vec<usize> = (0..engine.cylinders().len()).collect();
    order.sort_by_key(|&index| engine.cylinders()[index].pin);
    let mut throws: Vec<(usize, Throw)> = Vec::new();
    for index in order {
        let cylinder = &engine.cylinders()[index];
        let angle = engine.pin_angle(cylinder);
        let shares = |(pin, throw): &(usize, Throw)| {
            let own = (&throw.angle, throw.crank, &throw.crank_radius);
            *pin == cylinder.pin && own == (&angle, cylinder.crank, &cylinder.crank_radius)
        };
        // The throws of a pin stand together at the end of the list.
        let candidates = throws.iter_mut().rev().take_while(|(pin, _)| *pin == cylinder.pin);
        match candidates.into_iter().find(|throw| shares(throw)) {
            Some((_, throw)) => throw.cylinders.push(index),
            None => throws.push((
                cylinder.pin,
                Throw {
                    angle: angle.clone(),
                    crank: cylinder.crank,
                    position: cylinder.position.clone(),
                    crank_radius: cylinder.crank_radius.clone(),
                    cylinders: vec![index],
                },
            )),
        }
    }
    for (_, throw) in &mut throws {
        let positions = || throw.cylinders.iter().map(|&index| &engine.cylinders()[index].position);
        if let Some((low, high)) = positions().min().zip(positions().max()) {
            throw.position = (low + high) / BigRational::from_integer(2.into());
        }
    }
    throws.sort_by(|(pin, one), (other_pin, other)| pin.cmp(other_pin).then(other.position.cmp(&one.position)));
    throws.into_iter().map(|(_, throw)| throw).collect()
}
