//! Which columns hold what balances an engine? A row a weight.

use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::engine::LengthUnit;
use crate::remedy::{self, Cure, Kind, Remedy, Weight};
use crate::report::data::Filling;
use crate::report::typeset;
use crate::table::{Table, Unit};

/// The table of this name.
pub fn table(remedy: &Remedy, name: &str) -> Option<Table> {
    match name {
        "weights" => Some(weights(remedy)),
        "cures" => Some(cures(remedy)),
        _ => None,
    }
}

fn weights(remedy: &Remedy) -> Table {
    let weights = remedy.weights();
    let weights = weights.iter().filter_map(|weight| remedy.as_built(weight)).enumerate();
    let position = match remedy.subject.engine().length_unit() {
        LengthUnit::Metre => Unit::METRE,
        LengthUnit::Spacing => Unit::SPACING,
    };
    let polar = |weight: &Weight, place: usize| weight.decimals(&remedy.subject).map(|polar| polar[place]);
    let mut table = Filling::new("remedy.weights", weights);
    table.whole("weight", |(index, _)| index + 1);
    table.whole("order", |(_, weight)| weight.order as usize);
    table.words("sense", |(_, weight)| Some(weight.sense.name().to_owned()));
    table.decimal("position_{unit}", position, |(_, weight)| weight.position.to_f64());
    table.exact("mass_radius_exact", Unit::NONE, |(_, weight)| weight.modulus().map(|form| form.to_string()));
    table.decimal("mass_radius_{unit}", Unit::MASS_RADIUS, |(_, weight)| polar(weight, 0));
    table.decimal("angle_{unit}", Unit::DEGREE, |(_, weight)| polar(weight, 1));
    table.decimal("mass_radius_{unit}", Unit::KILOGRAM_METRE, |(_, weight)| weight.mass_radius(&remedy.subject));
    let radius = remedy.radius.as_ref().and_then(BigRational::to_f64);
    table.decimal("radius_{unit}", Unit::METRE, |_| radius);
    table.decimal("mass_{unit}", Unit::KILOGRAM, |(_, weight)| remedy.mass(weight));
    table.done()
}

/// The cures of its orders, those first that remove most for each shaft.
fn cures(remedy: &Remedy) -> Table {
    let rows = remedy::cures(&remedy.subject, &remedy.orders).into_iter().enumerate();
    let is_force = |cure: &Cure| cure.kind == Kind::Force;
    let mut table = Filling::new("remedy.cures", rows);
    table.whole("rank", |(index, _)| index + 1);
    table.whole("order", |(_, cure)| cure.order as usize);
    table.words("cancels", |(_, cure)| Some(if is_force(cure) { "force" } else { "couple" }.to_owned()));
    table.words("senses", |(_, cure)| Some(typeset::listed(cure.senses.iter().map(|sense| sense.name()))));
    table.whole("shafts", |(_, cure)| cure.shafts);
    table.decimal("removed_{unit}", Unit::PERCENT, |(_, cure)| Some(100.0 * cure.removed));
    table.truth("is_exact", |(_, cure)| Some(cure.is_exact));
    table.decimal("residual_{unit}", Unit::MULTIPLE, |(_, cure)| is_force(cure).then_some(cure.peak[1]));
    table.decimal("removed_per_shaft_{unit}", Unit::MULTIPLE, |(_, cure)| cure.per_shaft().filter(|_| is_force(cure)));
    table.decimal("mass_radius_{unit}", Unit::KILOGRAM_METRE, |(_, cure)| remedy.cure_mass_radius(cure));
    table.decimal("mass_{unit}", Unit::KILOGRAM, |(_, cure)| remedy.cure_mass(cure));
    table.decimal("removed_per_kilogram_{unit}", Unit::MULTIPLE, |(_, cure)| {
        remedy.cure_mass(cure).map(|mass| cure.removes() / mass)
    });
    table.done()
}
