//! Which columns hold external and guide-force moments, as project guides list them? A row an engine, and a row an engine and order.

use num_traits::ToPrimitive;

use crate::report::data::Filling;
use crate::report::moments::{External, MomentsRow, MomentsStudy};
use crate::table::{Table, Unit};

/// A table of the moments of engines.
pub fn table(study: &MomentsStudy, name: &str) -> Option<Table> {
    match name {
        "moments" => Some(external(study)),
        "guides" => guides(study),
        _ => None,
    }
}

/// A single engine needs no name.
fn keys(study: &MomentsStudy) -> usize {
    if study.built().count() == 1 { 1 } else { 2 }
}

fn external(study: &MomentsStudy) -> Table {
    let mut table = Filling::new("moments.moments", &study.rows).keyed(keys(study));
    table.words("state", |row| Some(if row.is_bare { "bare" } else { "built" }.to_owned()));
    table.person("engine", |row| Some(row.name.clone()));
    table.whole("cylinders", |row| row.engine.cylinders().len());
    table.words("firing_order", |row| row.engine.firing_order());
    table.decimal("speed_{unit}", Unit::PER_MINUTE, |row| row.engine.dimensions().speed.as_ref()?.to_f64());
    type Pick = fn(&MomentsRow) -> &[External];
    let kinds: [(Pick, Unit, [[&'static str; 2]; 2]); 2] = [
        (
            |row| &row.forces,
            Unit::KILONEWTON,
            [
                ["force_{order}_v_{unit}", "force_{order}_v_vanishes"],
                ["force_{order}_h_{unit}", "force_{order}_h_vanishes"],
            ],
        ),
        (
            |row| &row.moments,
            Unit::KILONEWTON_METRE,
            [
                ["moment_{order}_v_{unit}", "moment_{order}_v_vanishes"],
                ["moment_{order}_h_{unit}", "moment_{order}_h_vanishes"],
            ],
        ),
    ];
    for order in super::ORDERS {
        for (of, unit, names) in kinds {
            for (component, [size, vanishes]) in names.into_iter().enumerate() {
                let value = move |row: &MomentsRow| {
                    of(row).iter().find(|one| one.order == order).and_then(|one| one.components[component])
                };
                table.decimal((size, order), unit, |row| Some(value(row).unwrap_or(0.0) / 1e3));
                table.truth((vanishes, order), |row| Some(value(row).is_none()));
            }
        }
    }
    table.decimal("moment_1_with_counterweights_{unit}", Unit::KILONEWTON_METRE, |row| {
        Some(row.countered.unwrap_or(0.0) / 1e3)
    });
    table.truth("moment_1_with_counterweights_vanishes", |row| Some(row.countered.is_none()));
    table.decimal("moment_2_per_kilowatt", Unit::NONE, |row| row.per_kilowatt());
    table.done()
}

fn guides(study: &MomentsStudy) -> Option<Table> {
    let all = study.built().filter_map(|row| Some((row, &row.guides.as_ref().ok()?.0)));
    let rows = all.flat_map(|(row, all)| all.iter().map(move |moments| (row, moments)));
    let mut table = Filling::new("moments.guides", rows).keyed(keys(study));
    table.decimal("order", Unit::NONE, |row| row.1.order.exact().to_f64());
    table.person("engine", |row| Some(row.0.name.clone()));
    let unit = Unit::KILONEWTON_METRE;
    table.decimal("h_{unit}", unit, |row| Some(row.1.rocking.unwrap_or(0.0) / 1e3));
    table.truth("h_vanishes", |row| Some(row.1.rocking.is_none()));
    table.decimal("x_{unit}", unit, |row| Some(row.1.twisting.unwrap_or(0.0) / 1e3));
    table.truth("x_vanishes", |row| Some(row.1.twisting.is_none()));
    table.done_if_any()
}
