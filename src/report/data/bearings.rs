//! Which columns hold what the main bearings feel? A row a bearing, an order, a crank angle, a crankpin.

use num_complex::Complex;

use super::super::bearings::before;
use super::super::bearings::document::{Bearing, BearingsDocument, LeftOut, Order, PeakEntry, Pin, Turning};
use super::cells::exact_number;
use super::filling::Filling;
use super::gas_loads;
use super::loads::Units;
use crate::engine::{Cylinder, Engine};
use crate::journal::CycleLoads;
use crate::loads::{Arm, BearingLoads, Circle};
use crate::numbers;
use crate::order::OrderSum;
use crate::table::{Table, Unit};
use crate::text::Untrusted;

/// The unit of the positions of a layout.
pub(super) fn position_unit(engine: &Engine) -> Unit {
    match Arm::of(engine) {
        Arm::Metre => Unit::METRE,
        Arm::Spacing => Unit::SPACING,
    }
}

/// Where a main bearing stands, by its number.
pub(super) fn position(engine: &Engine, number: usize) -> Option<String> {
    number.checked_sub(1).and_then(|index| engine.bearings().get(index)).map(exact_number)
}

/// The tables of the bearing loads: those of the masses, and those of gas and masses where the layout asks for the gas.
pub fn bearings(
    engine: &Engine,
    both: [&BearingLoads; 2],
    document: &BearingsDocument,
    with_gas: Option<&CycleLoads>,
) -> Vec<Table> {
    let unit = Units::new(engine, both[0].scale.as_ref());
    let solutions = [("continuous", &document.continuous), ("determinate", &document.determinate)];
    let rows: Vec<Row> = solutions
        .into_iter()
        .zip(both)
        .flat_map(|((method, solution), loads)| {
            let left_out = solution.left_out.as_ref();
            let row = move |(index, bearing)| Row {
                method,
                bearing,
                is_worst: loads.worst.contains(&index),
                left_out,
                sums: loads.bearings[index].orders.iter().map(|order| &order.sums).collect(),
            };
            solution.bearings.iter().enumerate().map(row)
        })
        .collect();
    let masses = [
        of_bearings(engine, &rows, unit),
        orders(&rows, unit),
        theta(both[0], unit),
        pins(engine, &document.pins, unit),
    ];
    let gas = document.with_gas.as_ref().zip(with_gas);
    let gas = gas.into_iter().flat_map(|(document, loads)| gas_loads::tables(engine, document, loads));
    masses.into_iter().chain(gas).collect()
}

/// A bearing by one of the methods.
struct Row<'a> {
    method: &'static str,
    bearing: &'a Bearing,
    is_worst: bool,
    left_out: Option<&'a LeftOut>,
    sums: Vec<&'a [OrderSum; 2]>,
}

const METHOD: &str = "continuous: one beam on all bearings; determinate: each span a beam of its own";

fn of_bearings(engine: &Engine, rows: &[Row], unit: Units) -> Table {
    let mut table = Filling::new(
        "bearings",
        "a main bearing: the largest load of the masses in a revolution, all orders together",
        rows,
    );
    table.words("method", METHOD, |row| Some(row.method.to_owned()));
    table.whole("bearing", "its number in the file, from 1", |row| row.bearing.bearing);
    table.exact("position_{unit}", position_unit(engine), "where it stands along the shaft, exact", |row| {
        position(engine, row.bearing.bearing)
    });
    peak(
        &mut table,
        ["force_zero_to_peak_{unit}", "theta_{unit}"],
        unit.force,
        "largest force that the bearing feels",
        |row| &row.bearing.peak,
    );
    peak(
        &mut table,
        ["force_y_zero_to_peak_{unit}", "force_y_theta_{unit}"],
        unit.force,
        "largest size of its component along the reference direction y",
        |row| &row.bearing.y,
    );
    peak(
        &mut table,
        ["force_x_zero_to_peak_{unit}", "force_x_theta_{unit}"],
        unit.force,
        "largest size of its component across it, along x",
        |row| &row.bearing.x,
    );
    table.truth("worst", "whether no bearing feels more by this method", |row| Some(row.is_worst));
    table.decimal(
        "left_out_{unit}",
        unit.force,
        "the orders that are not listed add at most this to the load; empty where they add nothing",
        |row| row.left_out.map(|bound| bound.at_most),
    );
    table.done()
}

const THETA: &str = "crank angle where it stands; empty where it stands at all, or is 0";

/// A largest value, and the crank angle where it stands.
fn peak<R>(
    table: &mut Filling<R>,
    [size, angle]: [&'static str; 2],
    unit: Unit,
    about: &'static str,
    of: impl Fn(&R) -> &PeakEntry,
) {
    table.decimal(size, unit, about, |row| Some(of(row).value));
    table.decimal(angle, Unit::DEGREE, THETA, |row| of(row).crank_angle_deg);
}

fn orders(rows: &[Row], unit: Units) -> Table {
    let rows: Vec<(&Row, &Order, &[OrderSum; 2])> = rows
        .iter()
        .flat_map(|row| row.bearing.orders.iter().zip(&row.sums).map(move |(order, sums)| (row, order, *sums)))
        .collect();
    let mut table = Filling::new(
        "orders",
        "an order k of what a main bearing feels of the masses; order 0 is a constant force",
        &rows,
    );
    table.words("method", METHOD, |(row, ..)| Some(row.method.to_owned()));
    table.whole("bearing", "its number in the file, from 1", |(row, ..)| row.bearing.bearing);
    table.whole("order", "the order k", |(_, order, _)| order.order as usize);
    table.decimal("force_zero_to_peak_{unit}", unit.force, "largest length in a revolution", |(_, order, _)| {
        Some(order.largest)
    });
    let both: [(usize, [&'static str; 4], &'static str); 2] = [
        (
            0,
            ["direct_zero_to_peak_{unit}", "direct_exact", "direct_angle_{unit}", "direct_vanishes"],
            "½|P⁺|, the vector that turns with the crank",
        ),
        (
            1,
            ["reverse_zero_to_peak_{unit}", "reverse_exact", "reverse_angle_{unit}", "reverse_vanishes"],
            "½|P⁻|, the vector that turns against the crank",
        ),
    ];
    for (place, [size, exact, angle, vanishes], about) in both {
        table.decimal(size, unit.force, about, |(_, order, _)| Some(turning(order, place).amplitude));
        table.exact(
            exact,
            Unit::MASS_RADIUS,
            "the length |P| in closed form, in multiples of m r, each sum with the number of the motion that it stands before: c_k, n_k or u_k; empty where one has none",
            |(_, order, sums)| lengths(&sums[place], order.order),
        );
        table.decimal(
            angle,
            Unit::DEGREE,
            "where it points at θ = 0, from y in the sense of rotation; empty where it is 0",
            |(_, order, _)| turning(order, place).angle_deg,
        );
        table.truth(vanishes, "whether it is proved to be 0; empty where that is not decided", |(_, order, _)| {
            turning(order, place).vanishes
        });
    }
    table.done()
}

/// The direct vector, or the reverse one.
fn turning(order: &Order, place: usize) -> &Turning {
    [&order.direct, &order.reverse][place]
}

/// The length of each sum in closed form, with what it stands before: `√2 c_2, 1/2`; none where one has no closed form or the rods differ.
fn lengths(sum: &OrderSum, order: u32) -> Option<String> {
    if sum.vanishes() {
        return Some("0".to_owned());
    }
    let letters: Vec<Option<char>> = sum.parts().keys().map(before).collect();
    let differ = letters.iter().enumerate().any(|(index, letter)| letters[..index].contains(letter));
    let part = |(letter, sum): (&Option<char>, &crate::exact::PhasorSum)| {
        let length = numbers::modulus(sum)?;
        Some(letter.map_or_else(|| length.to_string(), |letter| format!("{length} {letter}_{order}")))
    };
    let parts: Option<Vec<String>> = letters.iter().zip(sum.parts().values()).map(part).collect();
    parts.filter(|_| !differ).map(|parts| parts.join(", "))
}

/// Steps of a revolution: a degree each.
const STEPS: usize = 360;

fn theta(loads: &BearingLoads, unit: Units) -> Table {
    let circle = Circle::new(STEPS);
    let all: Vec<Vec<Complex<f64>>> = loads.bearings.iter().map(|bearing| bearing.waveform.sample(&circle)).collect();
    let rows: Vec<usize> = (0..STEPS).collect();
    let mut table = Filling::new(
        "theta",
        "a crank angle: what each bearing feels of the masses on a continuous beam, all orders of `orders` together",
        &rows,
    );
    table.decimal("theta_{unit}", Unit::DEGREE, "the crank angle θ, every degree of a revolution", |theta| {
        Some(*theta as f64)
    });
    for (index, tips) in all.iter().enumerate() {
        let number = index + 1;
        table.decimal(
            ("bearing_{bearing}_y_{unit}", number),
            unit.force,
            "force on this bearing along the reference direction y",
            |theta| Some(tips[*theta].re * unit.newtons),
        );
        table.decimal(
            ("bearing_{bearing}_x_{unit}", number),
            unit.force,
            "force on it along x, to the right of y",
            |theta| Some(-tips[*theta].im * unit.newtons),
        );
    }
    table.done()
}

fn pins(engine: &Engine, pins: &[Pin], unit: Units) -> Table {
    let rows: Vec<(&Cylinder, &Pin)> = engine.cylinders().iter().zip(pins).collect();
    let mut table = Filling::new("pins", "what the rod of a cylinder loads its crankpin with, of the masses", &rows);
    table.person("cylinder", "the cylinder", |(_, pin)| Some(Untrusted::new(&*pin.cylinder)));
    table.exact(
        "position_{unit}",
        position_unit(engine),
        "where its crankpin stands along the shaft, exact",
        |(cylinder, _)| Some(exact_number(&cylinder.position)),
    );
    peak(
        &mut table,
        ["force_zero_to_peak_{unit}", "theta_{unit}"],
        unit.force,
        "largest load in a revolution",
        |(_, pin)| &pin.peak,
    );
    peak(
        &mut table,
        ["along_throw_zero_to_peak_{unit}", "along_throw_theta_{unit}"],
        unit.force,
        "largest size of its component along the throw",
        |(_, pin)| &pin.along_the_throw,
    );
    peak(
        &mut table,
        ["across_throw_zero_to_peak_{unit}", "across_throw_theta_{unit}"],
        unit.force,
        "largest size of its component across the throw",
        |(_, pin)| &pin.across_the_throw,
    );
    table.done()
}
