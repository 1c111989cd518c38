//! Which columns hold what balances an engine? A row a weight.

use num_traits::ToPrimitive;

use crate::engine::LengthUnit;
use crate::remedy::{Remedy, Weight};
use crate::report::data::Filling;
use crate::table::{Table, Unit};

/// The weights of a remedy.
pub fn table(remedy: &Remedy) -> Table {
    let weights = remedy.weights();
    let weights: Vec<(usize, Weight)> =
        weights.iter().filter_map(|weight| remedy.as_built(weight)).enumerate().collect();
    let position = match remedy.subject.engine().length_unit() {
        LengthUnit::Metre => Unit::METRE,
        LengthUnit::Spacing => Unit::SPACING,
    };
    let polar = |weight: &Weight, place: usize| weight.decimals(&remedy.subject).map(|polar| polar[place]);
    let mut table = Filling::new("remedy.weights", &weights);
    table.whole("weight", |(index, _)| index + 1);
    table.whole("order", |(_, weight)| weight.order as usize);
    table.words("sense", |(_, weight)| Some(weight.sense.name().to_owned()));
    table.decimal("position_{unit}", position, |(_, weight)| weight.position.to_f64());
    table.exact("mass_radius_exact", Unit::NONE, |(_, weight)| weight.modulus().map(|form| form.to_string()));
    table.decimal("mass_radius_{unit}", Unit::MASS_RADIUS, |(_, weight)| polar(weight, 0));
    table.decimal("angle_{unit}", Unit::DEGREE, |(_, weight)| polar(weight, 1));
    table.decimal("mass_radius_{unit}", Unit::KILOGRAM_METRE, |(_, weight)| weight.mass_radius(&remedy.subject));
    table.done()
}
