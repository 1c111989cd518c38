//! Which columns hold what balances an engine? A row a weight.

use num_traits::ToPrimitive;

use super::filling::Filling;
use crate::engine::LengthUnit;
use crate::remedy::{Remedy, Weight};
use crate::table::{Table, Unit};

/// The weights of a remedy.
pub fn remedy(remedy: &Remedy) -> Table {
    let weights = remedy.weights();
    let weights: Vec<(usize, Weight)> =
        weights.iter().filter_map(|weight| remedy.as_built(weight)).enumerate().collect();
    let position = match remedy.subject.engine().length_unit() {
        LengthUnit::Metre => Unit::METRE,
        LengthUnit::Spacing => Unit::SPACING,
    };
    let polar = |weight: &Weight, place: usize| weight.decimals(&remedy.subject).map(|polar| polar[place]);
    let mut table = Filling::new("weights", "a weight of the remedy", &weights);
    table.whole("weight", "its number in the answer", |(index, _)| index + 1);
    table.whole("order", "how many times it turns in a revolution of the crankshaft", |(_, weight)| {
        weight.order as usize
    });
    table.words("sense", "direct: with the crank; reverse: against it", |(_, weight)| {
        Some(weight.sense.name().to_owned())
    });
    table.decimal("position_{unit}", position, "its position along the crankshaft", |(_, weight)| {
        weight.position.to_f64()
    });
    let about = "its mass times radius in closed form, in m r, or in m r |c_k| where a coefficient multiplies it";
    table.exact("mass_radius_exact", Unit::NONE, about, |(_, weight)| weight.modulus().map(|form| form.to_string()));
    let about = "its mass times radius; empty without rods";
    table.decimal("mass_radius_{unit}", Unit::MASS_RADIUS, about, |(_, weight)| polar(weight, 0));
    table.decimal("angle_{unit}", Unit::DEGREE, "its direction at a crank angle of 0", |(_, weight)| polar(weight, 1));
    let about = "its mass times radius, where the layout gives masses and a crank radius";
    table.decimal("mass_radius_{unit}", Unit::KILOGRAM_METRE, about, |(_, weight)| weight.mass_radius(&remedy.subject));
    table.done()
}
