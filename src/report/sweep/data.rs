//! Which columns hold a sweep? A row a point.

use num_rational::BigRational;

use super::amounts::newtons;
use super::zero_data::{firing_zeros, zeros};
use crate::engine::CycleOrder;
use crate::exact::fraction;
use crate::loads::Arm;
use crate::numbers::float;
use crate::page::File;
use crate::proof::Planar;
use crate::report::data::cells::{decimals, exact, truths};
use crate::report::data::{Filling, value_columns};
use crate::report::value::column_of;
use crate::sweep::{Amplitude, Amplitudes, Envelope, Evenness, Sweep, SweptEngine};
use crate::table::{Column, Table, Unit, csv};

/// The tables of a sweep: the points, the exact zeros where the parameter is an angle, those of the firing stars where they are asked for.
pub fn tables(sweep: &Sweep) -> Vec<Table> {
    let zeros = sweep.zeros.as_ref().map(|_| zeros(sweep));
    let firing_zeros = sweep.firing.as_ref().filter(|firing| firing.zeros.is_some()).map(|_| firing_zeros(sweep));
    [points(sweep)].into_iter().chain(zeros).chain(firing_zeros).collect()
}

/// The points as `sweep.csv`.
pub fn sweep_csv(sweep: &Sweep) -> File {
    File { name: "sweep.csv".into(), text: csv(&points(sweep)) }
}

/// The patterns of the amplitudes of an order, as [`Amplitudes::named`] has them: in multiples, in newtons, whether it is zero.
const PARTS: [([&str; 3], &str); 6] = [
    (
        ["{quantity}_{order}_largest", "{quantity}_{order}_largest_{unit}", "{quantity}_{order}_largest_vanishes"],
        "largest length in a revolution, zero to peak",
    ),
    (
        ["{quantity}_{order}_smallest", "{quantity}_{order}_smallest_{unit}", "{quantity}_{order}_smallest_vanishes"],
        "smallest length in a revolution; 0 where the path is a line",
    ),
    (
        ["{quantity}_{order}_along", "{quantity}_{order}_along_{unit}", "{quantity}_{order}_along_vanishes"],
        "amplitude along the reference direction y, zero to peak",
    ),
    (
        ["{quantity}_{order}_across", "{quantity}_{order}_across_{unit}", "{quantity}_{order}_across_vanishes"],
        "amplitude across it, along x, zero to peak",
    ),
    (
        ["{quantity}_{order}_direct", "{quantity}_{order}_direct_{unit}", "{quantity}_{order}_direct_vanishes"],
        "length ½|P⁺| of the vector that turns with the crank, zero to peak",
    ),
    (
        ["{quantity}_{order}_reverse", "{quantity}_{order}_reverse_{unit}", "{quantity}_{order}_reverse_vanishes"],
        "length ½|P⁻| of the vector that turns against it, zero to peak",
    ),
];

/// What is said of a column that tells whether another is zero.
const VANISHES: &str = "whether it is proved to be 0";
/// What is said of a column that holds another as it is exactly.
const EXACT: &str = "the same, exact";

/// The points: first the columns that `sweep.csv` always had, then which amplitudes vanish and what is exact.
pub fn points(sweep: &Sweep) -> Table {
    let mut table = Filling::new("sweep.points", &sweep.points).done();
    let mut last = Vec::new();
    for (index, parameter) in sweep.parameters.iter().enumerate() {
        let value = |point: &SweptEngine| point.values.get(index).cloned();
        // Two places of one list have one name.
        let is_alone = sweep.parameters.iter().filter(|other| other.column() == parameter.column()).count() == 1;
        let name = if is_alone { parameter.column() } else { parameter.key.to_string().replace('.', "_") };
        let about = "the value of the parameter, in the unit of the range";
        let values = decimals(sweep.points.iter().map(|point| value(point).as_ref().map(float)));
        table.push(Column::named("{parameter}", &[&name], Unit::NONE, about, values));
        let values = exact(sweep.points.iter().map(value));
        last.push(Column::named("{parameter}_exact", &[&name], Unit::NONE, EXACT, values));
    }
    for (place, order) in sweep.orders.iter().enumerate() {
        for quantity in Planar::BOTH {
            last.extend(amplitudes(sweep, &mut table, place, *order, quantity));
        }
    }
    last.extend(intervals(sweep, &mut table));
    last.extend(counterweights(sweep, &mut table));
    for (pattern, about, side) in SIDES {
        let values = decimals(sweep.points.iter().map(|point| point.envelope.as_ref().and_then(side)));
        table.push(Column::new(pattern, Unit::CRANK_RADIUS, about, values));
    }
    for (place, order) in sweep.firing.iter().flat_map(|firing| firing.orders.iter().enumerate()) {
        last.push(star(sweep, &mut table, place, *order));
    }
    last.into_iter().for_each(|column| table.push(column));
    if let Some(observed) = &sweep.observed {
        for (place, (name, like)) in observed.names.iter().zip(&observed.first).enumerate() {
            let all: Vec<_> = observed.points.iter().map(|values| &values[place]).collect();
            value_columns(&column_of(name), Some(like), &all).into_iter().for_each(|column| table.push(column));
        }
    }
    table
}

/// The amplitudes of an order, in newtons too where they are known; gives the columns that tell which are zero.
fn amplitudes(sweep: &Sweep, table: &mut Table, place: usize, order: u32, quantity: Planar) -> Vec<Column> {
    let (name, order) = (quantity.name(), order.to_string());
    let column = |part: usize, pattern: usize, unit: Unit, about, values| {
        Column::named(PARTS[part].0[pattern], &[name, &order], unit, about, values)
    };
    let part = |point: &SweptEngine, part: usize| {
        let order = point.orders.get(place)?;
        Some(Amplitudes::NAMED[part].1(order.amplitudes(quantity)))
    };
    for (index, (_, about)) in PARTS.into_iter().enumerate() {
        let values = decimals(sweep.points.iter().map(|point| part(point, index).map(size)));
        table.push(column(index, 0, multiple(sweep, quantity), about, values));
    }
    if sweep.points.iter().any(|point| point.newtons.is_some()) {
        for (index, (_, about)) in PARTS.into_iter().enumerate() {
            let value = |point: &SweptEngine| match part(point, index)? {
                Amplitude { vanishes: true, .. } => Some(0.0),
                Amplitude { value, .. } => Some(value * point.newtons?),
            };
            let values = decimals(sweep.points.iter().map(value));
            table.push(column(index, 1, newtons(sweep, quantity), about, values));
        }
    }
    let vanishes = |index: usize| truths(sweep.points.iter().map(|point| part(point, index).map(|part| part.vanishes)));
    (0..PARTS.len()).map(|index| column(index, 2, Unit::NONE, VANISHES, vanishes(index))).collect()
}

/// What the multiples of a sweep are multiples of.
fn multiple(sweep: &Sweep, quantity: Planar) -> Unit {
    match (quantity == Planar::Moment, sweep.rods_known, sweep.arm) {
        (false, true, _) => Unit::MULTIPLE,
        (false, false, _) => Unit::OPEN,
        (true, true, Arm::Spacing) => Unit::MULTIPLE_SPACING,
        (true, true, Arm::Metre) => Unit::MULTIPLE_METRE,
        (true, false, Arm::Spacing) => Unit::OPEN_SPACING,
        (true, false, Arm::Metre) => Unit::OPEN_METRE,
    }
}

type Interval = fn(&Evenness) -> BigRational;

/// The firing intervals; gives what they are exactly.
fn intervals(sweep: &Sweep, table: &mut Table) -> Vec<Column> {
    const ALL: [([&str; 2], &str, Interval); 3] = [
        (
            ["longest_firing_interval_{unit}", "longest_firing_interval_{unit}_exact"],
            "longest interval between firings, of the file's firing order, else of the most even one",
            |evenness| evenness.longest.clone(),
        ),
        (
            ["shortest_firing_interval_{unit}", "shortest_firing_interval_{unit}_exact"],
            "shortest interval between firings; 0 where two cylinders fire together",
            |evenness| evenness.shortest.clone(),
        ),
        (
            ["firing_unevenness_{unit}", "firing_unevenness_{unit}_exact"],
            "the longest interval less the shortest",
            Evenness::unevenness,
        ),
    ];
    let full = BigRational::from_integer(360.into());
    let columns = ALL.into_iter().map(|([pattern, pattern_exact], about, interval)| {
        let degrees =
            |point: &SweptEngine| point.evenness.as_ref().map(|evenness| fraction::times(&interval(evenness), &full));
        let all: Vec<Option<BigRational>> = sweep.points.iter().map(degrees).collect();
        let values = decimals(all.iter().map(|degrees| degrees.as_ref().map(float)));
        table.push(Column::new(pattern, Unit::DEGREE, about, values));
        Column::new(pattern_exact, Unit::DEGREE, EXACT, exact(all))
    });
    columns.collect()
}

/// The counterweights; gives whether none is needed.
fn counterweights(sweep: &Sweep, table: &mut Table) -> Vec<Column> {
    let values = decimals(sweep.points.iter().map(|point| point.counterweight.map(size)));
    let about = "mass times radius of the larger of two counterweights in the outermost throws that cancel the part of order 1 that turns with the crank";
    table.push(Column::new("counterweight_{unit}", Unit::MASS_RADIUS, about, values));
    let kilograms = |point: &SweptEngine| match point.counterweight? {
        Amplitude { vanishes: true, .. } => Some(0.0).filter(|_| point.kilograms.is_some()),
        Amplitude { value, .. } => Some(value * point.kilograms?),
    };
    let values = decimals(sweep.points.iter().map(kilograms));
    let about = "its mass where it is at the crank radius";
    table.push(Column::new("counterweight_{unit}_at_crank_radius", Unit::KILOGRAM, about, values));
    let values = truths(sweep.points.iter().map(|point| point.counterweight.map(|part| part.vanishes)));
    vec![Column::new("counterweight_vanishes", Unit::NONE, VANISHES, values)]
}

type Side = fn(&Envelope) -> Option<f64>;

/// The sides of what the engine fits into.
const SIDES: [(&str, &str, Side); 3] = [
    ("length_{unit}", "length of what the engine fits into, by the simple geometry of the page", |envelope| {
        envelope.length
    }),
    ("breadth_{unit}", "its breadth", |envelope| Some(envelope.breadth)),
    ("height_{unit}", "its height", |envelope| Some(envelope.height)),
];

/// The length of a firing star; gives where it is zero.
fn star(sweep: &Sweep, table: &mut Table, place: usize, order: CycleOrder) -> Column {
    let points =
        || sweep.firing.iter().flat_map(|firing| &firing.points).map(|stars| stars.get(place).copied().flatten());
    let order = order.exact().to_string();
    let about = "length of the firing star of this order of the gas torque; empty where the cylinders cannot fire as the file says";
    let values = decimals(points().map(|star| star.map(size)));
    table.push(Column::named("firing_star_{order}_{unit}", &[&order], Unit::CRANK_RADIUS, about, values));
    let values = truths(points().map(|star| star.map(|star| star.vanishes)));
    Column::named("firing_star_{order}_vanishes", &[&order], Unit::NONE, VANISHES, values)
}

/// An amplitude, 0 where it is proved.
fn size(part: Amplitude) -> f64 {
    if part.vanishes { 0.0 } else { part.value }
}
