//! Which tables tell of an engine on its mounts?

use num_complex::Complex;
use num_traits::Zero;

use super::super::typeset;
use super::words::{place, rpm};
use super::{MountsStudy, OrderMotion, Place, peak};
use crate::mounts::Phasors;
use crate::page::{Columns, Number, Piece, Table, Text, Unit, number, phrase};

/// One row per mode: frequency, kinetic energy shares.
pub(super) fn modes(study: &MountsStudy) -> Table {
    // Below the roundings of the modes.
    let share = |value: f64| match value.abs() < 1e-10 {
        true => phrase!("≈ 0 {}", Unit::PERCENT),
        false => Piece::Quantity(100.0 * value, Unit::PERCENT).into(),
    };
    let names = ["x", "y", "z"].map(Text::label).into_iter();
    let names = names.chain(["rotation about x", "rotation about y", "rotation about z"].map(Text::from));
    let table = Table::of(study.modes.iter().enumerate())
        .column("Mode", |(index, _)| index + 1)
        .column("Frequency (Hz)", |(_, mode)| Number::Decimal(mode.hertz()));
    let table = names
        .enumerate()
        .fold(table, |table, (index, name)| table.column(name, move |(_, mode)| share(mode.shares[index])));
    table.done()
}

/// The axes, above columns of what is along each.
const ALONG: [&str; 3] = ["x ({})", "y ({})", "z ({})"];

/// A column for each axis.
fn axes<R>(table: Columns<R>, headings: [&'static str; 3], unit: Unit, cell: impl Fn(&R, usize) -> Text) -> Columns<R> {
    let all = headings.into_iter().enumerate();
    all.fold(table, |table, (axis, heading)| table.column(phrase!(heading, unit), |row| cell(row, axis)))
}

fn zero_or(vanishes: bool, value: Text) -> Text {
    if vanishes { Text::zero() } else { value }
}

/// One row per order: what shakes, and whether it vanishes exactly.
pub(super) fn orders(study: &MountsStudy) -> Table {
    orders_of(study.orders.iter())
}

/// The same without those that leave the engine still, for a terminal.
pub(super) fn orders_that_move(study: &MountsStudy) -> Table {
    orders_of(study.moving().map(|(_, one)| one))
}

/// The largest length through a revolution of what has components along x and y.
fn through_revolution(&[x, y, _]: &Phasors) -> f64 {
    let across = Complex::<f64>::i() * y;
    (peak(&(x + across)) + peak(&(x - across))) / 2.0
}

fn orders_of<'a>(orders: impl Iterator<Item = &'a OrderMotion>) -> Table {
    Table::of(orders)
        .column("Order κ", |one| one.excitation.order.to_string())
        .column(phrase!("Force ({})", Unit::NEWTON), |one| {
            zero_or(one.excitation.still.force, Text::measured(through_revolution(&one.load[0]), Unit::NEWTON))
        })
        .column(phrase!("Moment about x, y ({})", Unit::NEWTON_METRE), |one| {
            let still = one.excitation.still;
            zero_or(still.force && still.moment, Text::measured(through_revolution(&one.load[1]), Unit::NEWTON_METRE))
        })
        .column(phrase!("Moment about z ({})", Unit::NEWTON_METRE), |one| {
            let still = one.excitation.still;
            zero_or(still.force && still.roll, Text::measured(peak(&one.load[1][2]), Unit::NEWTON_METRE))
        })
        .column("Engine", |one| if one.excitation.still.is_whole() { "still" } else { "moves" })
        .done()
}

fn moved(one: &OrderMotion, of: impl Fn(&crate::mounts::Motion) -> Text) -> Text {
    match &one.motion {
        None => "resonance".into(),
        Some(motion) => of(motion),
    }
}

/// One row per order that moves it.
fn by_order(study: &MountsStudy) -> Columns<&OrderMotion> {
    Table::of(study.moving().map(|(_, one)| one)).column("Order κ", |one| one.excitation.order.to_string())
}

/// The same with the centre of gravity and the rotation.
pub(super) fn motions(study: &MountsStudy) -> Table {
    let part = |value: Complex<f64>, unit| Text::measured(peak(&value) * 1e3, unit);
    let table = axes(by_order(study), ALONG, Unit::MILLIMETRE, |one, axis| {
        moved(one, |motion| part(motion.centre[axis], Unit::MILLIMETRE))
    });
    let rotations = ["Rotation about x ({})", "Rotation about y ({})", "Rotation about z ({})"];
    let table = axes(table, rotations, Unit::MILLIRADIAN, |one, axis| {
        moved(one, |motion| part(motion.turned[axis], Unit::MILLIRADIAN))
    });
    table
        .column(phrase!("Velocity, {} ({})", place(study.watched()), Unit::MILLIMETRE_PER_SECOND), |one| {
            moved(one, |motion| Text::measured(study.velocity(motion) * 1e3, Unit::MILLIMETRE_PER_SECOND))
        })
        .done()
}

/// One row per mount and order that moves the engine: the force along x, y and z.
pub(super) fn forces(study: &MountsStudy) -> Table {
    let mounts = 0..study.body.mounts();
    let rows = mounts.flat_map(|mount| study.moving().map(move |(_, order)| (mount, order)));
    let force = |mount: usize, one: &OrderMotion, axis: usize| {
        moved(one, |motion| {
            let force: Phasors = study.body.mount_force(mount, motion);
            Text::measured(peak(&force[axis]), Unit::NEWTON)
        })
    };
    let table = Table::of(rows)
        .column("Mount", |(mount, _)| mount + 1)
        .column("Order κ", |(_, one)| one.excitation.order.to_string());
    axes(table, ALONG, Unit::NEWTON, |(mount, one), axis| force(*mount, one, axis)).done()
}

/// One row per place: all orders together, rms along each axis.
pub(super) fn rms(study: &MountsStudy) -> Table {
    let value = |of: Place, derivative: i32, scale: f64, unit: Unit, of_axes: &dyn Fn([f64; 3]) -> f64| match study
        .rms(of, derivative)
    {
        None => "resonance".into(),
        Some(parts) => Text::measured(of_axes(parts) * scale, unit),
    };
    let most = |parts: [f64; 3]| parts.into_iter().fold(0.0, f64::max);
    let table = Table::of(study.places())
        .column("Place", |of| place(*of))
        .column(phrase!("Displacement, largest ({})", Unit::MILLIMETRE), |of| {
            value(*of, 0, 1e3, Unit::MILLIMETRE, &most)
        });
    let (velocities, unit) = (["Velocity x ({})", "Velocity y ({})", "Velocity z ({})"], Unit::MILLIMETRE_PER_SECOND);
    let table = axes(table, velocities, unit, |of, axis| value(*of, 1, 1e3, unit, &|parts| parts[axis]));
    let unit = Unit::METRE_PER_SQUARE_SECOND;
    table.column(phrase!("Acceleration, largest ({})", unit), |of| value(*of, 2, 1.0, unit, &most)).done()
}

/// One row per order that moves the engine: where in the range it moves the watched place most, and the mounts.
pub(super) fn range(study: &MountsStudy) -> Table {
    let worst = |place: usize, of: fn(&super::AtSpeed) -> Option<f64>| {
        let size = |at: &super::AtSpeed| of(at).unwrap_or(f64::INFINITY);
        let at = || study.range().iter().filter(|at| at.order == place).map(|at| (size(at), at.rpm));
        let most = at().max_by(|one, other| one.0.total_cmp(&other.0))?;
        // Without damping there is no bound at several speeds, none of which is the largest.
        let endless: Vec<f64> = at().filter(|(size, _)| size.is_infinite()).map(|(_, speed)| speed).collect();
        Some((most.0, if endless.is_empty() { vec![most.1] } else { endless }))
    };
    let told = |found: Option<(f64, Vec<f64>)>, scale: f64, unit: Unit| match found {
        None => ["–".into(), "–".into()],
        Some((value, speeds)) => {
            let size = if value.is_infinite() { "no bound".into() } else { Text::measured(value * scale, unit) };
            [size, Text::joined(speeds.into_iter().map(rpm), ", ")]
        }
    };
    let rows = study.moving().map(|(place, one)| {
        let velocity = told(worst(place, |at| at.velocity), 1e3, Unit::MILLIMETRE_PER_SECOND);
        (one.excitation.order, velocity, told(worst(place, |at| at.force), 1.0, Unit::NEWTON))
    });
    Table::of(rows)
        .column("Order κ", |(order, ..)| order.to_string())
        .column(phrase!("Largest velocity ({})", Unit::MILLIMETRE_PER_SECOND), |(_, [value, _], _)| value.clone())
        .column("at", |(_, [_, speed], _)| speed.clone())
        .column(phrase!("Largest mount force ({})", Unit::NEWTON), |(.., [value, _])| value.clone())
        .column("at", |(.., [_, speed])| speed.clone())
        .done()
}

/// The speeds at which an order that moves the engine meets a mode.
pub(super) fn critical(study: &MountsStudy) -> Table {
    let table = study.modes.iter().enumerate().fold(by_order(study), |table, (index, mode)| {
        table.column(phrase!("Mode {} at (rpm)", index + 1), move |one| {
            Number::Decimal(one.excitation.order.rpm(mode.hertz()))
        })
    });
    table.done()
}

/// One row per mount: place, stiffness, damping, and how its axes are turned where any are.
pub(super) fn mounts(study: &MountsStudy) -> Table {
    let three = |values: &[num_rational::BigRational; 3], unit| {
        Text::joined(values.iter().map(|value| number::given_in(value, unit)), "; ")
    };
    let mounts = &study.mounting().mounts;
    let is_turned = mounts.iter().any(|mount| mount.turned.iter().any(|angle| !angle.is_zero()));
    Table::of(mounts.iter().enumerate())
        .column("Mount", |(index, _)| index + 1)
        .column(phrase!("Place x; y; z ({})", Unit::METRE), |(_, mount)| three(&mount.place, Unit::METRE))
        .column(phrase!("Stiffness ({})", Unit::NEWTON_PER_METRE), |(_, mount)| {
            three(&mount.stiffness, Unit::NEWTON_PER_METRE)
        })
        .column(phrase!("Damping ({})", Unit::NEWTON_SECOND_PER_METRE), |(_, mount)| {
            three(&mount.damping, Unit::NEWTON_SECOND_PER_METRE)
        })
        .column_if(is_turned, "Turned about x; y; z", |(_, mount)| {
            Text::joined(mount.turned.iter().map(typeset::turns).map(Text::from), "; ")
        })
        .column("Loss factor", |(_, mount)| number::given_in(&mount.loss_factor, Unit::NONE))
        .done()
}
