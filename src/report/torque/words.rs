//! What is said of the torque first, and what has to be known of it?

use num_traits::Zero;

use crate::engine::{Engine, Heat, PressureLaw};
use crate::gas::Warning;
use crate::page::{Number, Piece, Setting, Text, Unit, number, phrase};
use crate::torque::{EngineTorque, Evenness};

/// A decimal with its unit.
pub(in crate::report) fn quantity(value: f64, unit: Unit) -> Text {
    Piece::Quantity(value, unit).into()
}

/// An angle of the crank.
pub(in crate::report) fn angle(degrees: f64) -> Text {
    phrase!("≈ {}°", Text::figures(degrees))
}

/// Which cylinder does not fire, and what its gas does.
pub(in crate::report) fn misfire(engine: &Engine) -> Option<Text> {
    let index = engine.misfire()?;
    let name = names(engine, &[index]);
    let law = engine.gas().map(|gas| &gas.laws[gas.chambers[index].law]);
    Some(match law {
        Some(PressureLaw::Table(_)) => phrase!(
            "**Misfire.** Cylinder {} does not fire: no pressure difference acts on its piston, since a table of pressures does not give that of compression alone.",
            name
        ),
        Some(_) => phrase!(
            "**Misfire.** Cylinder {} does not fire: its charge is compressed, and expands with the same exponent.",
            name
        ),
        None => phrase!(
            "**Misfire.** Cylinder {} does not fire: it gives no torque, neither of gas nor of inertia, since harmonics do not give that of compression alone.",
            name
        ),
    })
}

/// The lines of the box.
pub(super) fn answer(engine: &Engine, torque: &EngineTorque) -> Vec<Text> {
    let newton_metres = |value: f64| quantity(value, Unit::NEWTON_METRE);
    let mut lines: Vec<Text> = misfire(engine).into_iter().collect();
    lines.push(phrase!(
        "**Torque.** The mean is {}, the largest {} at θ {}, the smallest {} at θ {}.",
        newton_metres(torque.mean),
        newton_metres(torque.highest.value),
        angle(torque.highest.angle),
        newton_metres(torque.lowest.value),
        angle(torque.lowest.angle)
    ));
    lines.extend(torque.unevenness().map(|part| {
        phrase!("**Unevenness.** The largest less the smallest is {} times the mean.", Number::Decimal(part))
    }));
    if let (Some(power), Some(speed)) = (torque.power, &engine.dimensions().speed) {
        let kilowatts = quantity(power.abs() / 1e3, Unit::KILOWATT);
        lines.push(phrase!(
            "**Power.** At {1} rpm the gas {2:takes|delivers} {3} {2:from|to} the crank.",
            number::given(speed),
            power < 0.0,
            kilowatts
        ));
    }
    lines.extend(torque.evenness.as_ref().map(|evenness| flywheel(engine, evenness)));
    lines.extend(left_out(engine, torque));
    lines
}

/// What the flywheel has to do, and does.
fn flywheel(engine: &Engine, evenness: &Evenness) -> Text {
    let energy = quantity(evenness.energy, Unit::JOULE);
    let inertia = |value: f64| quantity(value, Unit::KILOGRAM_SQUARE_METRE);
    let asked = engine.flywheel();
    let needed = evenness.needed;
    match (evenness.given, &asked.irregularity) {
        (Some(given), None) => phrase!(
            "**Flywheel.** Energy fluctuation: {}. With an inertia of {} the coefficient of fluctuation of speed is {}.",
            energy,
            inertia(given.inertia),
            Number::Decimal(given.irregularity)
        ),
        (Some(given), Some(wanted)) => phrase!(
            "**Flywheel.** Energy fluctuation: {}. With an inertia of {} the coefficient of fluctuation of speed is {}; for {} it has to be {}.",
            energy,
            inertia(given.inertia),
            Number::Decimal(given.irregularity),
            number::given(wanted),
            inertia(needed.inertia)
        ),
        (None, Some(wanted)) => phrase!(
            "**Flywheel.** Energy fluctuation: {}. For a coefficient of fluctuation of {} all that turns with the crank needs the inertia {}.",
            energy,
            number::given(wanted),
            inertia(needed.inertia)
        ),
        (None, None) => phrase!(
            "**Flywheel.** Energy fluctuation: {}. For a coefficient of fluctuation of 0.01, as an example, all that turns with the crank needs the inertia {}.",
            energy,
            inertia(needed.inertia)
        ),
    }
}

/// What is missing in the numbers, for the layout does not say enough.
fn left_out(engine: &Engine, torque: &EngineTorque) -> Option<Text> {
    if engine.dimensions().speed.is_none() {
        return Some("The layout gives no speed: power, inertia torque and flywheel are omitted.".into());
    }
    (!torque.has_inertia())
        .then(|| "The layout gives no reciprocating masses: this is the torque of the gas alone.".into())
}

/// What the frame feels.
pub(super) fn roll(engine: &Engine, torque: &EngineTorque) -> Text {
    let Some(roll) = torque.roll else {
        return "The roll moment of the frame is not given: the layout does not say where the axis of a crankshaft stands.".into();
    };
    let [highest, lowest] = roll.map(|extreme| quantity(extreme.value, Unit::NEWTON_METRE));
    if !engine.geared_cranks().is_empty() {
        return phrase!(
            "The frame takes the opposite of the torque of each crankshaft, in the sense in which that turns, and the shaking forces at their arms: together a roll moment from {} to {}, without that of masses that turn. Assumed: each crankshaft has its own flywheel, and the mean torque of all leaves at the first. The gas causes no shaking force: it acts on the cylinder head as much as on the piston.",
            lowest,
            highest
        );
    }
    if engine.cylinders().iter().any(|cylinder| !cylinder.knuckle_mass.is_zero()) {
        return phrase!(
            "The frame takes the opposite of the torque as a roll moment, and that of the masses at the knuckle pins, whose angular momentum changes: together from {} to {}. The gas causes no shaking force: it acts on the cylinder head as much as on the piston.",
            lowest,
            highest
        );
    }
    match engine.has_offset() {
        false => phrase!(
            "The frame takes the opposite of the torque as a roll moment, from {} to {}. The gas causes no shaking force: it acts on the cylinder head as much as on the piston.",
            lowest,
            highest
        ),
        true => phrase!(
            "The frame takes the opposite of the torque as a roll moment, and the shaking forces at the offset of their axes: together from {} to {}. The gas causes no shaking force: it acts on the cylinder head as much as on the piston.",
            lowest,
            highest
        ),
    }
}

/// What a person should look at, by cylinders.
pub(super) fn warnings(engine: &Engine, torque: &EngineTorque) -> Vec<Text> {
    let of = |class: usize| torque.classes[class].cylinders.as_slice();
    torque.warnings.iter().map(|(class, odd)| warning(engine, of(*class), odd)).collect()
}

/// What is odd about the pressure of these cylinders.
pub(in crate::report) fn warning(engine: &Engine, cylinders: &[usize], warning: &Warning) -> Text {
    let of = match cylinders {
        [_] => phrase!("cylinder {}", names(engine, cylinders)),
        _ => phrase!("cylinders {}", names(engine, cylinders)),
    };
    match warning {
        Warning::Peak(pascals) => phrase!(
            "In {}: the largest pressure is {}. Engines have {} to {}: is the unit right?",
            of,
            quantity(pascals / 1e5, Unit::BAR),
            Text::from(Piece::Measured(5.0, Unit::BAR, Setting::Usual(number::sensible))),
            quantity(400.0, Unit::BAR)
        ),
        Warning::PeakAngle(degrees) => phrase!(
            "In {}: the largest pressure is at {} of the firing dead centre. Usual is −5° to 40°: does the table count from another dead centre (where firing is at 360°, subtract 360°), or backwards?",
            of,
            angle(*degrees)
        ),
        Warning::TakesWork(mean) => phrase!(
            "In {}: the mean torque of the gas is negative, {}: is the dead centre a revolution off, or does the table count backwards?",
            of,
            quantity(*mean, Unit::NEWTON_METRE)
        ),
        Warning::Coarse(degrees) => phrase!(
            "In {}: the rows of the table are {} apart; the straight lines between them decide the higher orders.",
            of,
            angle(*degrees)
        ),
    }
}

/// The names of the cylinders of a class.
pub(super) fn cylinders(engine: &Engine, torque: &EngineTorque, class: usize) -> Text {
    names(engine, &torque.classes[class].cylinders)
}

/// The names of these cylinders.
pub(in crate::report) fn names(engine: &Engine, cylinders: &[usize]) -> Text {
    let names: Vec<&str> = cylinders.iter().map(|&index| engine.cylinders()[index].name.as_str()).collect();
    Text::label(names.join(", "))
}

/// What the numbers rest on.
pub(in crate::report) fn assumptions(engine: &Engine) -> Vec<Text> {
    let mut list: Vec<Text> = vec![
        "The torque is computed at constant speed; the shaft is rigid; friction, the valve gear and the pumps take no power.".into(),
        "All cylinders of a class have the same pressure in each cycle.".into(),
        "A connecting rod is two masses, at its eyes; the torque of its remaining moment of inertia is neglected.".into(),
        "Crank angles θ are those of the other reports; a cylinder's own angle ψ is 0 where its crank points along its axis and it fires.".into(),
    ];
    if let Some(sides) = double_acting(engine) {
        list.extend([sides, "The mean pressure of a double-acting cylinder is the work of both sides over the volume that the outer side sweeps.".into()]);
    }
    list.extend(opposed(engine));
    let laws = engine.gas().map_or(&[][..], |gas| &gas.laws);
    if laws.iter().any(|law| matches!(law, PressureLaw::Cycle(_))) {
        list.push("The ideal cycle: polytropic compression; heat by the Wiebe function, a = ln 1000, at a constant exponent and without loss to the walls; half a cosine where the pressure falls to that of the exhaust and, in 20°, to that of the intake.".into());
    }
    let finds_heat =
        |law: &PressureLaw| matches!(law, PressureLaw::Cycle(ideal) if !matches!(ideal.heat, Heat::Released(_)));
    if laws.iter().any(finds_heat) {
        list.push("The heat is computed from the given pressure.".into());
    }
    list
}

/// What presses on double-acting pistons.
pub(in crate::report) fn double_acting(engine: &Engine) -> Option<Text> {
    let has_two = engine.gas()?.chambers.iter().any(|chamber| chamber.below.is_some());
    has_two.then(|| "On a double-acting piston $F_g = p_1 A - p_2 (A - a) - p_c a$: $p_2$ is the pressure below it, by the angles of the outer side, $a$ the section of its rod, $p_c$ the pressure of the crankcase.".into())
}

/// What two pistons in one cylinder share.
pub(in crate::report) fn opposed(engine: &Engine) -> Option<Text> {
    engine.has_opposed_pistons().then(|| "Two pistons in one cylinder share its pressure and the volume between them: angles of the gas count from where that is least, unless the file says dead_centre = \"crank\", which is the crank of the first of them; pressure, work and heat are those of the whole cylinder, the torque that of each piston.".into())
}
