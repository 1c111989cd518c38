//! What is said of the torque in the teeth of gears? Tables of data and of the page, the answer.

use super::Vibration;
use super::amounts::{given_rpm, rpm, torque};
use super::study::TorsionStudy;
use crate::numbers::float;
use crate::page::{self, Number, Text, Unit, phrase};
use crate::report::data::Filling;
use crate::report::texts::torsion as text;
use crate::table;
use crate::torsion::first_of_largest;

/// Torques of a gear at its first disc and at its second, in newton-metres, and the speed.
type Torques = ([f64; 2], f64);

/// A gear with its torques.
struct InMesh {
    gear: usize,
    /// At the speed of the study.
    own: Option<Torques>,
    /// The largest in the range.
    largest: Option<Torques>,
}

impl TorsionStudy {
    /// A torque in the teeth of a gear as both its discs feel it.
    fn at_both(&self, gear: usize, torque: f64) -> [f64; 2] {
        [torque, torque / float(&self.torsion().gears[gear].ratio).abs()]
    }

    fn in_mesh(&self) -> Vec<InMesh> {
        let of_gear = |gear: usize| {
            let at = self.over_range().iter().map(|at| (at.meshes[gear], at.speed));
            let largest = at.max_by(|one, other| one.0.total_cmp(&other.0));
            InMesh {
                gear,
                own: self.at_speed().map(|vibration| (self.at_both(gear, vibration.mesh(gear)), vibration.speed)),
                largest: largest.map(|(torque, speed)| (self.at_both(gear, torque), speed)),
            }
        };
        (0..self.train.gears.len()).map(of_gear).collect()
    }

    /// The discs of a gear: `2–3`.
    fn gear(&self, gear: usize) -> String {
        let [one, other] = self.train.gears[gear];
        format!("{}–{}", one + 1, other + 1)
    }
}

/// The largest at the speed and in the range.
pub(super) fn answer(study: &TorsionStudy) -> Vec<Text> {
    let gears = study.in_mesh();
    let size = |([first, second], _): Torques| first.max(second);
    let most = |of: fn(&InMesh) -> Option<Torques>| {
        let all = gears.iter().filter_map(|one| Some((one.gear, of(one)?)));
        // Where nothing twists, teeth may be loaded, or not.
        let all = all.filter(|(_, torques)| !study.is_still() || size(*torques) > 0.0);
        first_of_largest(all, |one| size(one.1))
    };
    let disc = |gear: usize, end: usize| study.train.gears[gear][end] + 1;
    let mut lines = Vec::new();
    if let Some((gear, ([first, second], speed))) = most(|one| one.own) {
        lines.push(text::teeth(given_rpm(speed), torque(first), disc(gear, 0), torque(second), disc(gear, 1)));
    }
    if let Some((gear, ([first, second], speed))) = most(|one| one.largest) {
        lines.push(text::worst_teeth(torque(first), disc(gear, 0), torque(second), disc(gear, 1), rpm(speed)));
    }
    lines
}

/// One row per gear: the torque in its teeth, of all orders together.
pub(super) fn gears(study: &TorsionStudy) -> page::Table {
    let rows = study.in_mesh();
    let has = |of: fn(&InMesh) -> bool| rows.iter().any(of);
    let (has_own, has_range) = (has(|one| one.own.is_some()), has(|one| one.largest.is_some()));
    let shown = |torques: Option<Torques>, end: usize| {
        Text::or_dash(torques.map(|(torques, _)| Text::measured(torques[end], Unit::NEWTON_METRE)))
    };
    let own = |end: usize| move |one: &InMesh| shown(one.own, end);
    let largest = |end: usize| move |one: &InMesh| shown(one.largest, end);
    page::Table::of(rows)
        .column("Gear", |one| study.gear(one.gear))
        .column_if(has_own, phrase!("At its first disc ({})", Unit::NEWTON_METRE), own(0))
        .column_if(has_own, phrase!("At its second disc ({})", Unit::NEWTON_METRE), own(1))
        .column_if(has_range, phrase!("Largest at the first ({})", Unit::NEWTON_METRE), largest(0))
        .column_if(has_range, phrase!("Largest at the second ({})", Unit::NEWTON_METRE), largest(1))
        .column_if(has_range, "At (rpm)", |one| Text::or_dash(one.largest.map(|(_, speed)| Number::Decimal(speed))))
        .done()
}

/// One row per order at the speed: the torque in the teeth of each gear, at its first disc.
pub(super) fn orders(study: &TorsionStudy, vibration: &Vibration) -> page::Table {
    let table = page::Table::of(vibration.orders.iter()).column("Order κ", |one| one.order.to_string());
    let of_gears = (0..study.train.gears.len()).fold(table, |table, gear| {
        table.column(phrase!("Gear {} ({})", study.gear(gear), Unit::NEWTON_METRE), move |one| {
            match one.meshes[gear].norm() {
                // Where the order twists nothing, and no torque is on the discs behind.
                0.0 if study.is_still_at(one.order) => Text::zero(),
                torque => Text::measured(torque, Unit::NEWTON_METRE),
            }
        })
    });
    of_gears.done()
}

/// The gears as data.
pub(super) fn data(study: &TorsionStudy) -> Option<table::Table> {
    let moment = table::Unit::NEWTON_METRE;
    let mut table = Filling::new("torsion.gears", study.in_mesh());
    table.whole("gear", |one| one.gear + 1);
    table.whole("from_disc", |one| study.train.gears[one.gear][0] + 1);
    table.whole("to_disc", |one| study.train.gears[one.gear][1] + 1);
    table.exact("ratio", table::Unit::NONE, |one| Some(study.torsion().gears[one.gear].ratio.to_string()));
    for (name, end) in [("torque_half_range_{unit}", 0), ("to_torque_half_range_{unit}", 1)] {
        table.decimal(name, moment, move |one| Some(one.own?.0[end]));
    }
    for (name, end) in [("largest_half_range_{unit}", 0), ("to_largest_half_range_{unit}", 1)] {
        table.decimal(name, moment, move |one| Some(one.largest?.0[end]));
    }
    table.decimal("largest_speed_{unit}", table::Unit::PER_MINUTE, |one| Some(one.largest?.1));
    table.done_if_any()
}

/// The torque in the teeth by orders at the speed.
pub(super) fn data_of_orders(study: &TorsionStudy) -> Option<table::Table> {
    let gears = 0..study.train.gears.len();
    let orders = &study.at_speed().filter(|_| !gears.is_empty())?.orders;
    let rows = orders.iter().flat_map(|order| gears.clone().map(move |gear| (order, gear)));
    let mut table = Filling::new("torsion.meshes", rows).keyed(2);
    table.exact("order", table::Unit::NONE, |(one, _)| Some(one.order.exact().to_string()));
    table.whole("gear", |(_, gear)| gear + 1);
    for (name, end) in [("torque_zero_to_peak_{unit}", 0), ("to_torque_zero_to_peak_{unit}", 1)] {
        table.decimal(name, table::Unit::NEWTON_METRE, move |(one, gear)| {
            Some(study.at_both(*gear, one.meshes[*gear].norm())[end])
        });
    }
    Some(table.done())
}

/// The torque in the teeth over the range.
pub(super) fn data_of_speeds(study: &TorsionStudy) -> Option<table::Table> {
    let speeds = study.over_range().iter();
    let mut table =
        Filling::new("torsion.mesh_speeds", speeds.flat_map(|at| (0..at.meshes.len()).map(move |gear| (at, gear))))
            .keyed(2);
    table.decimal("speed_{unit}", table::Unit::PER_MINUTE, |(at, _)| Some(at.speed));
    table.whole("gear", |(_, gear)| gear + 1);
    for (name, end) in [("torque_half_range_{unit}", 0), ("to_torque_half_range_{unit}", 1)] {
        table.decimal(name, table::Unit::NEWTON_METRE, move |(at, gear)| {
            Some(study.at_both(*gear, at.meshes[*gear])[end])
        });
    }
    table.done_if_any()
}
