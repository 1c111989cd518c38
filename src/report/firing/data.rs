//! Which columns hold the firing stars? A row a star: an order has one, or one for each class of equal cylinders.

use num_traits::ToPrimitive;

use crate::report::data::Filling;
use crate::report::{FiringStudy, star_length};
use crate::table::{Table, Unit};

/// The table of this name.
pub fn table(study: &FiringStudy, name: &str) -> Option<Table> {
    (name == "orders").then(|| orders(study))
}

fn orders(study: &FiringStudy) -> Table {
    let stars = study.orders.iter().flat_map(|order| order.stars.iter().map(move |star| (order, star)));
    let mut table = Filling::new("firing.orders", stars.map(|(order, star)| (order, star, star_length(star))));
    table.decimal("order", Unit::NONE, |(order, ..)| order.order.exact().to_f64());
    table.words("of", |(_, star, _)| {
        let names: Vec<String> = star.sources.iter().map(|source| source.name(&study.engine)).collect();
        Some(names.join(" "))
    });
    table.truth("vanishes", |(_, star, _)| Some(star.vanishes()));
    table.decimal("length_{unit}", Unit::CRANK_RADIUS, |(.., length)| Some(length.decimal));
    table.exact("length_exact", Unit::NONE, |(.., length)| length.exact.as_ref().map(ToString::to_string));
    table.truth("major", |(order, ..)| Some(order.is_major()));
    table.done()
}
