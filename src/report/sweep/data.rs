//! Which columns hold a sweep? A row a point.

use num_rational::BigRational;

use super::amounts::{Side, newtons};
use super::sentences::dead_centres;
use super::zero_data::{firing_zeros, zeros};
use crate::exact::fraction;
use crate::loads::Arm;
use crate::numbers::float;
use crate::page::File;
use crate::proof::Planar;
use crate::report::data::{Filling, exact_number, value_columns};
use crate::report::value::column_of;
use crate::sweep::{Amplitude, Amplitudes, Evenness, Parameter, StarLength, Sweep, SweptEngine};
use crate::table::{Table, Unit, csv};

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

/// The points, each with its number from 0.
type Points<'a> = Filling<(usize, &'a SweptEngine)>;

/// The points: first the columns that `sweep.csv` always had, then which amplitudes vanish and what is exact.
pub fn points(sweep: &Sweep) -> Table {
    let mut table = Filling::new("sweep.points", sweep.points.iter().enumerate());
    let parameters: Vec<String> = sweep.parameters.iter().map(|parameter| column(sweep, parameter)).collect();
    for (index, name) in parameters.iter().enumerate() {
        table.decimal(("{parameter}", name), Unit::NONE, |(_, point)| point.values.get(index).map(float));
    }
    let orders = || sweep.orders.iter().enumerate().flat_map(|one| Planar::BOTH.map(|quantity| (one, quantity)));
    orders().for_each(|((place, order), quantity)| amplitudes(sweep, &mut table, (place, *order), quantity));
    for ([pattern, _], interval) in INTERVALS {
        table.decimal(pattern, Unit::DEGREE, |(_, point)| degrees(point, interval).as_ref().map(float));
    }
    if sweep.dead_centres_apart {
        for (index, pattern) in DEAD_CENTRES.into_iter().enumerate() {
            table.decimal(pattern, Unit::DEGREE, |(_, point)| dead_centres(point).map(|ends| ends[index]));
        }
    }
    counterweights(&mut table);
    for (pattern, side) in SIDES {
        table.decimal(pattern, Unit::CRANK_RADIUS, |(_, point)| point.envelope.as_ref().and_then(side));
    }
    let stars = || sweep.firing.iter().flat_map(|firing| firing.orders.iter().enumerate());
    for (place, order) in stars() {
        let name = ("firing_star_{order}_{unit}", order.exact());
        table.decimal(name, Unit::CRANK_RADIUS, |(index, _)| star(sweep, *index, place)?.amplitude().map(size));
    }
    for (index, name) in parameters.iter().enumerate() {
        table.exact(("{parameter}_exact", name), Unit::NONE, |(_, point)| point.values.get(index).map(exact_number));
    }
    orders().for_each(|((place, order), quantity)| vanishing(&mut table, (place, *order), quantity));
    for ([_, pattern], interval) in INTERVALS {
        table.exact(pattern, Unit::DEGREE, |(_, point)| degrees(point, interval).as_ref().map(exact_number));
    }
    table.truth("counterweight_vanishes", |(_, point)| point.counterweight.map(|part| part.vanishes));
    for (place, order) in stars() {
        let name = ("firing_star_{order}_vanishes", order.exact());
        table.truth(name, |(index, _)| star(sweep, *index, place)?.vanishes());
    }
    with_observed(sweep, table.done())
}

/// What the column of a parameter is called.
fn column(sweep: &Sweep, parameter: &Parameter) -> String {
    // Two places of one list have one name.
    let is_alone = sweep.parameters.iter().filter(|other| other.column() == parameter.column()).count() == 1;
    if is_alone { parameter.column() } else { parameter.key.to_string().replace('.', "_") }
}

/// The values of other questions behind all else.
fn with_observed(sweep: &Sweep, mut table: Table) -> Table {
    if let Some(observed) = &sweep.observed {
        for (place, (name, like)) in observed.names.iter().zip(&observed.first).enumerate() {
            let all: Vec<_> = observed.points.iter().map(|values| &values[place]).collect();
            value_columns(&column_of(name), Some(like), &all).into_iter().for_each(|column| table.push(column));
        }
    }
    table
}

/// The amplitudes of an order, in the order of [`Amplitudes::NAMED`]: in multiples, in newtons, whether each is zero.
const PARTS: [[&str; 3]; 6] = [
    ["{quantity}_{order}_largest", "{quantity}_{order}_largest_{unit}", "{quantity}_{order}_largest_vanishes"],
    ["{quantity}_{order}_smallest", "{quantity}_{order}_smallest_{unit}", "{quantity}_{order}_smallest_vanishes"],
    ["{quantity}_{order}_along", "{quantity}_{order}_along_{unit}", "{quantity}_{order}_along_vanishes"],
    ["{quantity}_{order}_across", "{quantity}_{order}_across_{unit}", "{quantity}_{order}_across_vanishes"],
    ["{quantity}_{order}_direct", "{quantity}_{order}_direct_{unit}", "{quantity}_{order}_direct_vanishes"],
    ["{quantity}_{order}_reverse", "{quantity}_{order}_reverse_{unit}", "{quantity}_{order}_reverse_vanishes"],
];

/// One of the amplitudes of the order at this place.
fn part(point: &SweptEngine, place: usize, quantity: Planar, index: usize) -> Option<Amplitude> {
    Some(Amplitudes::NAMED[index].1(point.orders.get(place)?.amplitudes(quantity)))
}

/// The amplitudes of an order, in newtons too where they are known.
fn amplitudes(sweep: &Sweep, table: &mut Points, (place, order): (usize, u32), quantity: Planar) {
    let part = |point: &SweptEngine, index: usize| part(point, place, quantity, index);
    for (index, [pattern, ..]) in PARTS.into_iter().enumerate() {
        let name = (pattern, quantity.name(), order);
        table.decimal(name, multiple(sweep, quantity), |(_, point)| part(point, index).map(size));
    }
    if sweep.points.iter().all(|point| point.newtons.is_none()) {
        return;
    }
    for (index, [_, pattern, _]) in PARTS.into_iter().enumerate() {
        let name = (pattern, quantity.name(), order);
        table.decimal(name, newtons(sweep, quantity), |(_, point)| match part(point, index)? {
            Amplitude { vanishes: true, .. } => Some(0.0),
            Amplitude { value, .. } => Some(value * point.newtons?),
        });
    }
}

/// Which of them are zero.
fn vanishing(table: &mut Points, (place, order): (usize, u32), quantity: Planar) {
    for (index, [.., pattern]) in PARTS.into_iter().enumerate() {
        let name = (pattern, quantity.name(), order);
        table.truth(name, |(_, point)| part(point, place, quantity, index)?.is_zero());
    }
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

/// The firing intervals, in decimals and exactly.
const INTERVALS: [([&str; 2], Interval); 3] = [
    (["longest_firing_interval_{unit}", "longest_firing_interval_{unit}_exact"], |evenness| evenness.longest.clone()),
    (["shortest_firing_interval_{unit}", "shortest_firing_interval_{unit}_exact"], |evenness| {
        evenness.shortest.clone()
    }),
    (["firing_unevenness_{unit}", "firing_unevenness_{unit}_exact"], Evenness::unevenness),
];

/// The intervals from one top dead centre to the next, where they are not the firing intervals.
const DEAD_CENTRES: [&str; 2] = ["shortest_dead_centre_interval_{unit}", "longest_dead_centre_interval_{unit}"];

fn degrees(point: &SweptEngine, interval: Interval) -> Option<BigRational> {
    point.evenness.as_ref().map(|evenness| fraction::times(&interval(evenness), &BigRational::from_integer(360.into())))
}

fn counterweights(table: &mut Points) {
    table.decimal("counterweight_{unit}", Unit::MASS_RADIUS, |(_, point)| point.counterweight.map(size));
    table.decimal("counterweight_{unit}_at_crank_radius", Unit::KILOGRAM, |(_, point)| match point.counterweight? {
        Amplitude { vanishes: true, .. } => Some(0.0).filter(|_| point.kilograms.is_some()),
        Amplitude { value, .. } => Some(value * point.kilograms?),
    });
}

/// The sides of what the engine fits into.
const SIDES: [(&str, Side); 3] = [
    ("length_{unit}", |envelope| envelope.length),
    ("breadth_{unit}", |envelope| Some(envelope.breadth)),
    ("height_{unit}", |envelope| Some(envelope.height)),
];

/// The length of the firing star of an order at a point.
fn star(sweep: &Sweep, point: usize, place: usize) -> Option<StarLength> {
    sweep.firing.as_ref()?.points.get(point)?.get(place).copied()
}

/// An amplitude, 0 where it is proved.
fn size(part: Amplitude) -> f64 {
    if part.vanishes { 0.0 } else { part.value }
}
