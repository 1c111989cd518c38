//! Which tables tell the values at crank angles? Motion, forces, torque, main bearings.

use super::super::torque::angle;
use super::AngleStudy;
use crate::journal::PistonAt;
use crate::page::{Table, Text, Unit, phrase};
use crate::report::mechanism_words;

/// A page shows this many rows of a table; the data have all.
pub(super) const MOST_SHOWN: usize = 360;

/// An angle as it was asked for, without the digits that only binary fractions have.
pub(super) fn degrees(angle: f64) -> Text {
    Text::label(format!("{}°", (angle * 1e9).round() / 1e9))
}

fn cell(value: Option<f64>, unit: Unit) -> Text {
    value.map_or_else(|| "–".into(), |value| Text::measured(value, unit))
}

/// A value of a piston; none where it is not known.
pub(super) type Value<'a> = &'a dyn Fn(&PistonAt) -> Option<f64>;

/// One row per angle and piston, with these columns of which some value is known.
fn pistons(study: &AngleStudy, columns: &[(&'static str, Unit, Value)]) -> Table {
    let rows = || study.pistons().take(MOST_SHOWN);
    let known: Vec<_> = columns.iter().filter(|(.., of)| rows().any(|(_, piston)| of(piston).is_some())).collect();
    let one = study.engine.cylinders().len() == 1;
    let name = |piston: &PistonAt| Text::label(study.engine.cylinders()[piston.cylinder].name.clone());
    let first = if one { Text::label("θ") } else { "θ, cylinder".into() };
    let mut table = Table::of(rows()).column(first, |(theta, piston)| match one {
        true => degrees(*theta),
        false => phrase!("{}, {}", degrees(*theta), name(piston)),
    });
    for (words, unit, of) in known {
        table = table.column(phrase!(*words, *unit), |(_, piston)| cell(of(piston), *unit));
    }
    table.done()
}

/// Way, velocity, acceleration.
pub(super) fn motion(study: &AngleStudy) -> Table {
    let textbook = |place: usize| move |piston: &PistonAt| piston.textbook.map(|both| both[place]);
    pistons(
        study,
        &[
            ("ψ in {}", Unit::DEGREE, &|piston| Some(piston.psi)),
            ("Displacement from top dead centre in {}", Unit::MILLIMETRE, &|piston| Some(1e3 * piston.way)),
            ("Velocity in {}", Unit::METRE_PER_SECOND, &|piston| piston.velocity),
            ("Velocity by two terms in {}", Unit::METRE_PER_SECOND, &textbook(0)),
            ("Acceleration in {}", Unit::METRE_PER_SQUARE_SECOND, &|piston| piston.acceleration),
            ("Acceleration by two terms in {}", Unit::METRE_PER_SQUARE_SECOND, &textbook(1)),
        ],
    )
}

/// What acts on piston, rod, wall and crankpin.
pub(super) fn forces(study: &AngleStudy) -> Table {
    pistons(
        study,
        &[
            ("Gas in {}", Unit::NEWTON, &|piston| piston.gas),
            ("Inertia in {}", Unit::NEWTON, &|piston| piston.inertia),
            ("Weight in {}", Unit::NEWTON, &|piston| piston.weight),
            ("Piston effort in {}", Unit::NEWTON, &PistonAt::effort),
            ("Rod thrust in {}", Unit::NEWTON, &PistonAt::rod),
            ("Side force in {}", Unit::NEWTON, &PistonAt::side),
            (mechanism_words::pin_loads(&study.engine), Unit::NEWTON, &|piston| piston.pin.map(|pin| pin.norm())),
            ("Torque in {}", Unit::NEWTON_METRE, &PistonAt::torque),
        ],
    )
}

/// The torque of all cylinders.
pub(super) fn torque(study: &AngleStudy) -> Table {
    let unit = Unit::NEWTON_METRE;
    Table::of(study.instants.iter().take(MOST_SHOWN))
        .column(Text::label("θ"), |instant| degrees(instant.theta))
        .column(phrase!("Gas in {}", unit), |instant| cell(instant.torque_of(|piston| piston.gas), unit))
        .column(phrase!("Inertia in {}", unit), |instant| cell(instant.torque_of_inertia(), unit))
        .column(phrase!("Torque in {}", unit), |instant| cell(instant.sum(PistonAt::torque), unit))
        .done()
}

/// One row per angle and main bearing.
pub(super) fn bearings(study: &AngleStudy) -> Table {
    Table::of(study.bearings().take(MOST_SHOWN))
        .column(Text::label("θ"), |(theta, ..)| degrees(*theta))
        .column("Main bearing", |(_, number, _)| Text::label(study.bearing_name(*number)))
        .column(phrase!("Force in {}", Unit::NEWTON), |(.., force)| Text::measured(force.norm(), Unit::NEWTON))
        .column("towards", |(.., force)| if force.norm() == 0.0 { "–".into() } else { angle(force.arg().to_degrees()) })
        .done()
}
