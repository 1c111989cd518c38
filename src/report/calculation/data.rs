//! Which columns hold the loads of an engine? A row an order, a row a crank angle, and the largest values.

use crate::engine::Engine;
use crate::loads::{self, Circle, Scale};
use crate::proof::Quantity;
use crate::report::calculation::Numbers;
use crate::report::data::Filling;
use crate::report::loads_document::{BoundEntry, LargestEntry, LoadsDocument, OrderEntry, TorqueEntry, VectorEntry};
use crate::table::{Table, Unit};

/// What forces, moments and torques are counted in, and how many of it are one multiple.
#[derive(Clone, Copy)]
pub struct Units {
    pub force: Unit,
    pub moment: Unit,
    pub torque: Unit,
    pub newtons: f64,
    pub newton_metres: f64,
}

impl Units {
    pub fn new(engine: &Engine, scale: Option<&Scale>) -> Self {
        let [force, moment, torque] =
            [Quantity::FORCE, Quantity::MOMENT, Quantity::TORQUE].map(|quantity| loads::unit(engine, scale, quantity));
        let newtons = scale.map_or(1.0, Scale::force);
        Units { force, moment, torque, newtons, newton_metres: scale.map_or(1.0, Scale::torque) }
    }
}

/// The tables of the loads: by order, over the crank angle, the largest values; of the torque and the roll moment where the layout asks for
/// them.
pub fn tables(engine: &Engine, numbers: &Numbers, document: &LoadsDocument) -> Vec<Table> {
    let units = Units::new(engine, numbers.loads.scale.as_ref());
    let about_the_axis = [("loads.torque", &document.torque), ("loads.roll", &document.roll)];
    let about_the_axis = about_the_axis.into_iter().filter(|(_, entries)| !entries.is_empty());
    let first = [orders(document, units)].into_iter().chain(about_the_axis.map(|(path, of)| torque(path, of, units)));
    first.chain([theta(numbers, units), largest(document, units)]).collect()
}

fn orders(document: &LoadsDocument, units: Units) -> Table {
    let of = |quantity| document.orders.iter().filter(move |entry| entry.quantity == quantity);
    let rows = of("force").zip(of("moment")).map(|(force, moment)| [force, moment]);
    let mut table = Filling::new("loads.orders", rows);
    table.whole("order", |[force, _]| force.order as usize);
    table.truth("exists", |[force, _]| Some(force.exists));
    for (place, quantity, unit) in [(0, "force", units.force), (1, "moment", units.moment)] {
        table.truth(("{quantity}_vanishes", quantity), |row| row[place].vanishes);
        let mut sizes = |pattern, of: fn(&OrderEntry) -> f64| {
            table.decimal((pattern, quantity), unit, |row| Some(of(row[place])));
        };
        sizes("{quantity}_zero_to_peak_{unit}", |entry| entry.largest);
        sizes("{quantity}_smallest_{unit}", |entry| entry.smallest);
        sizes("{quantity}_y_zero_to_peak_{unit}", |entry| entry.along);
        sizes("{quantity}_x_zero_to_peak_{unit}", |entry| entry.across);
        table.decimal(("{quantity}_axis_{unit}", quantity), Unit::DEGREE, |row| row[place].direction_deg);
        vectors(&mut table, quantity, unit, |row| [&row[place].direct, &row[place].reverse]);
    }
    table.done()
}

/// The two vectors of an order: amplitude, angle, whether it is zero, how short one that is not decided is.
pub(super) fn vectors<R>(
    table: &mut Filling<R>,
    quantity: &'static str,
    unit: Unit,
    of: impl Fn(&R) -> [&VectorEntry; 2],
) {
    let both: [[&'static str; 4]; 2] = [
        [
            "{quantity}_direct_zero_to_peak_{unit}",
            "{quantity}_direct_angle_{unit}",
            "{quantity}_direct_vanishes",
            "{quantity}_direct_below_{unit}",
        ],
        [
            "{quantity}_reverse_zero_to_peak_{unit}",
            "{quantity}_reverse_angle_{unit}",
            "{quantity}_reverse_vanishes",
            "{quantity}_reverse_below_{unit}",
        ],
    ];
    for (place, [size, angle, vanishes, below]) in both.into_iter().enumerate() {
        table.decimal((size, quantity), unit, |row| Some(of(row)[place].amplitude));
        table.decimal((angle, quantity), Unit::DEGREE, |row| of(row)[place].angle_deg);
        table.truth((vanishes, quantity), |row| of(row)[place].vanishes);
        table.decimal((below, quantity), unit, |row| of(row)[place].below);
    }
}

fn torque(path: &'static str, entries: &[TorqueEntry], units: Units) -> Table {
    let mut table = Filling::new(path, entries);
    table.whole("order", |entry| entry.order as usize);
    table.truth("vanishes", |entry| entry.vanishes);
    table.decimal("zero_to_peak_{unit}", units.torque, |entry| Some(entry.amplitude));
    table.decimal("phase_{unit}", Unit::DEGREE, |entry| entry.phase_deg);
    table.decimal("below_{unit}", units.torque, |entry| entry.below);
    table.done()
}

/// Steps of a revolution: a degree each.
const STEPS: usize = 360;

fn theta(numbers: &Numbers, units: Units) -> Table {
    let loads = &numbers.loads;
    let circle = Circle::new(STEPS);
    let mut table = Filling::new("loads.theta", 0..STEPS);
    table.decimal("theta_{unit}", Unit::DEGREE, |theta| Some(*theta as f64));
    let vectors = [
        (["force_y_{unit}", "force_x_{unit}"], units.force, &loads.force),
        (["moment_y_{unit}", "moment_x_{unit}"], units.moment, &loads.moment),
    ];
    for ([along, across], unit, waveform) in vectors {
        let tips = waveform.sample(&circle);
        table.decimal(along, unit, |theta| Some(tips[*theta].re * units.newtons));
        table.decimal(across, unit, |theta| Some(-(tips[*theta].im * units.newtons)));
    }
    for (name, torque) in [("torque_{unit}", &loads.torque), ("roll_{unit}", &loads.roll)] {
        if let Some(torque) = torque {
            let values = torque.waveform.sample(&circle);
            table.decimal(name, units.torque, |theta| Some(values[*theta].re * units.newton_metres));
        }
    }
    table.done()
}

fn largest(document: &LoadsDocument, units: Units) -> Table {
    let mut table = Filling::new("loads.largest", [document]).keyed(0);
    type Entry = fn(&LoadsDocument) -> Option<&LargestEntry>;
    type Remaining = fn(&LoadsDocument) -> Option<&BoundEntry>;
    let all: [(&str, Unit, Entry, Remaining); 3] = [
        ("force", units.force, |all| Some(&all.largest.force), |all| all.left_out.force.as_ref()),
        ("moment", units.moment, |all| Some(&all.largest.moment), |all| all.left_out.moment.as_ref()),
        ("torque", units.torque, |all| all.largest.inertia_torque.as_ref(), |all| all.left_out.inertia_torque.as_ref()),
    ];
    for (quantity, unit, entry, left) in all.into_iter().filter(|(_, _, entry, _)| entry(document).is_some()) {
        let value =
            |of: fn(&LargestEntry) -> Option<f64>| move |document: &&LoadsDocument| entry(document).and_then(of);
        table.decimal(("{quantity}_zero_to_peak_{unit}", quantity), unit, value(|entry| Some(entry.value)));
        table.decimal(("{quantity}_theta_{unit}", quantity), Unit::DEGREE, value(|entry| entry.theta_deg));
        table.decimal(("{quantity}_error_bound_{unit}", quantity), unit, value(|entry| Some(entry.error_bound)));
        table.truth(("{quantity}_vanishes", quantity), |document| entry(document).and_then(|entry| entry.vanishes));
        table.decimal(("{quantity}_left_out_{unit}", quantity), unit, |document| {
            left(document).map(|bound| bound.at_most)
        });
    }
    table.done()
}
