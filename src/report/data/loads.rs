//! Which columns hold the loads of an engine? A row an order, a row a crank angle, and the largest values.

use num_complex::Complex;

use super::super::calculation::Numbers;
use super::super::loads_document::{BoundEntry, LargestEntry, LoadsDocument, OrderEntry, TorqueEntry, VectorEntry};
use super::filling::Filling;
use crate::engine::Engine;
use crate::loads::{self, Circle, Scale, Waveform};
use crate::proof::Quantity;
use crate::table::{Table, Unit};

/// What forces, moments and torques are counted in, and how many of it are one multiple.
#[derive(Clone, Copy)]
pub(super) struct Units {
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
pub fn loads(engine: &Engine, numbers: &Numbers, document: &LoadsDocument) -> Vec<Table> {
    let units = Units::new(engine, numbers.loads.scale.as_ref());
    let torque = (!document.torque.is_empty()).then(|| torque("torque", "the inertia torque", &document.torque, units));
    let roll = (!document.roll.is_empty()).then(|| torque_of_roll(&document.roll, units));
    let first = [orders(document, units)].into_iter().chain(torque).chain(roll);
    first.chain([theta(numbers, units), largest(document, units)]).collect()
}

fn orders(document: &LoadsDocument, units: Units) -> Table {
    let of = |quantity| document.orders.iter().filter(move |entry| entry.quantity == quantity);
    let rows: Vec<[&OrderEntry; 2]> = of("force").zip(of("moment")).map(|(force, moment)| [force, moment]).collect();
    let mut table = Filling::new("orders", "an order k of force and moment", &rows);
    table.whole("order", "the order k", |[force, _]| force.order as usize);
    table.truth("exists", "whether some piston or shaft has the order at all", |[force, _]| Some(force.exists));
    for (place, quantity, unit) in [(0, "force", units.force), (1, "moment", units.moment)] {
        table.truth(("{quantity}_vanishes", quantity), VANISHES, |row| row[place].vanishes);
        let mut sizes = |pattern, about, of: fn(&OrderEntry) -> f64| {
            table.decimal((pattern, quantity), unit, about, |row| Some(of(row[place])));
        };
        sizes("{quantity}_zero_to_peak_{unit}", "largest length in a revolution, ½(|P⁺| + |P⁻|)", |entry| {
            entry.largest
        });
        sizes(
            "{quantity}_smallest_{unit}",
            "smallest length in a revolution, ½||P⁺| − |P⁻||; 0 where the path is a line",
            |entry| entry.smallest,
        );
        sizes("{quantity}_y_zero_to_peak_{unit}", "amplitude along the reference direction y", |entry| entry.along);
        sizes("{quantity}_x_zero_to_peak_{unit}", "amplitude across it, along x", |entry| entry.across);
        table.decimal(
            ("{quantity}_axis_{unit}", quantity),
            Unit::DEGREE,
            "direction of the longer axis of the path, in (−90, 90], from y in the sense of rotation; empty where the path is a circle or a point",
            |row| row[place].direction_deg,
        );
        vectors(&mut table, quantity, unit, |row| [&row[place].direct, &row[place].reverse]);
    }
    table.done()
}

const VANISHES: &str = "whether it is proved to be 0; empty where that is not decided";

/// The two vectors of an order: amplitude, angle, whether it is zero, how short one that is not decided is.
pub(super) fn vectors<R>(
    table: &mut Filling<R>,
    quantity: &'static str,
    unit: Unit,
    of: impl Fn(&R) -> [&VectorEntry; 2],
) {
    type Patterns = [&'static str; 4];
    let both: [(usize, Patterns, &'static str); 2] = [
        (
            0,
            [
                "{quantity}_direct_zero_to_peak_{unit}",
                "{quantity}_direct_angle_{unit}",
                "{quantity}_direct_vanishes",
                "{quantity}_direct_below_{unit}",
            ],
            "½|P⁺|, the vector that turns with the crank",
        ),
        (
            1,
            [
                "{quantity}_reverse_zero_to_peak_{unit}",
                "{quantity}_reverse_angle_{unit}",
                "{quantity}_reverse_vanishes",
                "{quantity}_reverse_below_{unit}",
            ],
            "½|P⁻|, the vector that turns against the crank",
        ),
    ];
    for (place, [size, angle, vanishes, below], about) in both {
        table.decimal((size, quantity), unit, about, |row| Some(of(row)[place].amplitude));
        table.decimal((angle, quantity), Unit::DEGREE, ANGLE, |row| of(row)[place].angle_deg);
        table.truth((vanishes, quantity), VANISHES, |row| of(row)[place].vanishes);
        table.decimal((below, quantity), unit, BELOW, |row| of(row)[place].below);
    }
}

const ANGLE: &str = "where it points at θ = 0, from y in the sense of rotation; empty where it is 0";
const BELOW: &str = "where it is not decided whether it is 0: it is shorter than this";

fn torque(name: &'static str, about: &'static str, entries: &[TorqueEntry], units: Units) -> Table {
    let rows: Vec<&TorqueEntry> = entries.iter().collect();
    let mut table = Filling::new(name, about, &rows);
    table.whole("order", "the order k", |entry| entry.order as usize);
    table.truth("vanishes", VANISHES, |entry| entry.vanishes);
    table.decimal("zero_to_peak_{unit}", units.torque, "amplitude A of A cos(kθ + φ)", |entry| Some(entry.amplitude));
    table.decimal("phase_{unit}", Unit::DEGREE, "phase φ; empty where it is 0", |entry| entry.phase_deg);
    table.done()
}

fn torque_of_roll(entries: &[TorqueEntry], units: Units) -> Table {
    torque("roll", "an order of the roll moment on the frame", entries, units)
}

/// Steps of a revolution: a degree each.
const STEPS: usize = 360;

/// What stands at one crank angle.
struct At {
    theta: usize,
    force: Complex<f64>,
    moment: Complex<f64>,
    torque: f64,
    roll: f64,
}

fn theta(numbers: &Numbers, units: Units) -> Table {
    let loads = &numbers.loads;
    let circle = Circle::new(STEPS);
    let sampled = |waveform: &Waveform| waveform.sample(&circle);
    let (force, moment) = (sampled(&loads.force), sampled(&loads.moment));
    let about_the_axis = |torque: &Option<crate::loads::Torque>| {
        let samples = torque.as_ref().map(|torque| sampled(&torque.waveform)).unwrap_or_default();
        samples.into_iter().map(|vector| vector.re).collect::<Vec<f64>>()
    };
    let (torque, roll) = (about_the_axis(&loads.torque), about_the_axis(&loads.roll));
    let at = |theta: usize| At {
        theta,
        force: force[theta] * units.newtons,
        moment: moment[theta] * units.newtons,
        torque: torque.get(theta).copied().unwrap_or_default() * units.newton_metres,
        roll: roll.get(theta).copied().unwrap_or_default() * units.newton_metres,
    };
    let rows: Vec<At> = (0..STEPS).map(at).collect();
    let mut table =
        Filling::new("theta", "a crank angle; all orders of the table `orders` together, and all of `torque`", &rows);
    table.decimal("theta_{unit}", Unit::DEGREE, "the crank angle θ, every degree of a revolution", |at| {
        Some(at.theta as f64)
    });
    table.decimal("force_y_{unit}", units.force, "shaking force along the reference direction y", |at| {
        Some(at.force.re)
    });
    table.decimal("force_x_{unit}", units.force, "shaking force along x, to the right of y", |at| Some(-at.force.im));
    table.decimal(
        "moment_y_{unit}",
        units.moment,
        "moment of the forces along y about the reference plane, Σ z F_y (pitching)",
        |at| Some(at.moment.re),
    );
    table.decimal(
        "moment_x_{unit}",
        units.moment,
        "moment of the forces along x about the reference plane, Σ z F_x (yawing)",
        |at| Some(-at.moment.im),
    );
    if loads.torque.is_some() {
        table.decimal("torque_{unit}", units.torque, "inertia torque on the crankshaft", |at| Some(at.torque));
    }
    if loads.roll.is_some() {
        table.decimal("roll_{unit}", units.torque, "roll moment on the frame", |at| Some(at.roll));
    }
    table.done()
}

fn largest(document: &LoadsDocument, units: Units) -> Table {
    let rows = [document];
    let mut table = Filling::new("largest", "the largest values of the exact motion, all orders", &rows).keyed(0);
    type Entry = fn(&LoadsDocument) -> Option<&LargestEntry>;
    type Left = fn(&LoadsDocument) -> Option<&BoundEntry>;
    let all: [(&str, Unit, Entry, Left); 3] = [
        ("force", units.force, |document| Some(&document.largest.force), |document| document.left_out.force.as_ref()),
        (
            "moment",
            units.moment,
            |document| Some(&document.largest.moment),
            |document| document.left_out.moment.as_ref(),
        ),
        (
            "torque",
            units.torque,
            |document| document.largest.inertia_torque.as_ref(),
            |document| document.left_out.inertia_torque.as_ref(),
        ),
    ];
    for (quantity, unit, entry, left) in all.into_iter().filter(|(_, _, entry, _)| entry(document).is_some()) {
        let value =
            |of: fn(&LargestEntry) -> Option<f64>| move |document: &&LoadsDocument| entry(document).and_then(of);
        table.decimal(
            ("{quantity}_zero_to_peak_{unit}", quantity),
            unit,
            "largest length in a revolution",
            value(|entry| Some(entry.value)),
        );
        table.decimal(
            ("{quantity}_theta_{unit}", quantity),
            Unit::DEGREE,
            "crank angle where it stands; empty where it stands at all, or is 0",
            value(|entry| entry.theta_deg),
        );
        table.decimal(
            ("{quantity}_error_bound_{unit}", quantity),
            unit,
            "the truth lies within this of it, guaranteed",
            value(|entry| Some(entry.error_bound)),
        );
        table.truth(
            ("{quantity}_vanishes", quantity),
            "whether it is proved to be 0 at every order; empty where that is not decided",
            |document| entry(document).and_then(|entry| entry.vanishes),
        );
        table.decimal(
            ("{quantity}_left_out_{unit}", quantity),
            unit,
            "the orders that are not listed add at most this; empty where they add nothing",
            |document| left(document).map(|bound| bound.at_most),
        );
    }
    table.done()
}
