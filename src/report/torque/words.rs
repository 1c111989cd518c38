//! What is said of the torque first, and what has to be known of it?

use num_traits::Zero;

use crate::engine::{Cycle, DeadCentre, Engine, Heat, PressureLaw};
use crate::gas::Warning;
use crate::page::{Number, Piece, Setting, Text, Unit, number, phrase};
use crate::report::texts::torque as text;
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
        Some(PressureLaw::Table(_)) => text::misfire_of_a_table(name),
        Some(_) => text::misfire(name),
        None => text::misfire_of_harmonics(name),
    })
}

/// The lines of the box.
pub(super) fn answer(engine: &Engine, torque: &EngineTorque) -> Vec<Text> {
    let newton_metres = |value: f64| quantity(value, Unit::NEWTON_METRE);
    let mut lines: Vec<Text> = misfire(engine).into_iter().collect();
    lines.push(match torque.highest.value == 0.0 && torque.lowest.value == 0.0 {
        true => text::no_torque(),
        false => text::torque(
            newton_metres(torque.mean),
            newton_metres(torque.highest.value),
            angle(torque.highest.angle),
            newton_metres(torque.lowest.value),
            angle(torque.lowest.angle),
        ),
    });
    lines.extend(torque.unevenness().map(|part| text::unevenness(Number::Decimal(part), torque.mean > 0.0)));
    if let (Some(power), Some(speed)) = (torque.power, &engine.dimensions().speed) {
        let kilowatts = quantity(power.abs() / 1e3, Unit::KILOWATT);
        lines.push(text::power(number::given(speed), power < 0.0, kilowatts));
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
    // A shaft that keeps turning has a coefficient of at most 2.
    let stops = evenness.given.is_some_and(|given| given.irregularity > 2.0);
    match (evenness.given, &asked.irregularity) {
        (Some(given), None) if stops => text::stops(energy, inertia(given.inertia)),
        (Some(given), Some(wanted)) if stops => {
            text::stops_and_wanted(energy, inertia(given.inertia), number::given(wanted), inertia(needed.inertia))
        }
        (Some(given), None) => {
            text::given_flywheel(energy, inertia(given.inertia), Number::Decimal(given.irregularity))
        }
        (Some(given), Some(wanted)) => text::given_and_wanted(
            energy,
            inertia(given.inertia),
            Number::Decimal(given.irregularity),
            number::given(wanted),
            inertia(needed.inertia),
        ),
        (None, Some(wanted)) => text::wanted(energy, number::given(wanted), inertia(needed.inertia)),
        (None, None) => text::example_flywheel(energy, inertia(needed.inertia)),
    }
}

/// What is missing in the numbers, for the layout does not say enough.
fn left_out(engine: &Engine, torque: &EngineTorque) -> Option<Text> {
    if engine.dimensions().speed.is_none() {
        return Some(text::no_speed());
    }
    (!torque.has_inertia()).then(text::no_masses)
}

/// What the frame feels.
pub(super) fn roll(engine: &Engine, torque: &EngineTorque) -> Text {
    let Some(roll) = torque.roll else {
        return text::no_roll();
    };
    let [highest, lowest] = roll.map(|extreme| quantity(extreme.value, Unit::NEWTON_METRE));
    if !engine.geared_cranks().is_empty() {
        return text::roll_of_crankshafts(lowest, highest);
    }
    let knuckles = engine.cylinders().iter().any(|cylinder| !cylinder.knuckle_mass.is_zero());
    let told = match (knuckles, engine.has_offset()) {
        (true, _) => text::roll_with_knuckle_pins(lowest, highest),
        (false, true) => text::roll_with_offset(lowest, highest),
        (false, false) => text::roll(lowest, highest),
    };
    match engine.crankshaft().balancers.is_empty() {
        true => told,
        false => told.and(" ").and(text::without_balancer_shafts()),
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
        Warning::Peak(pascals) => text::warned_peak(
            of,
            quantity(pascals / 1e5, Unit::BAR),
            Text::from(Piece::Measured(5.0, Unit::BAR, Setting::Usual(number::sensible))),
            quantity(400.0, Unit::BAR),
        ),
        Warning::PeakAngle(degrees) => text::warned_peak_angle(of, angle(*degrees)),
        Warning::TakesWork(mean) => text::warned_work(of, quantity(*mean, Unit::NEWTON_METRE)),
        Warning::Coarse(degrees) => text::warned_rows(of, angle(*degrees)),
    }
}

/// The names of the cylinders of a class.
pub(super) fn cylinders(engine: &Engine, torque: &EngineTorque, class: usize) -> Text {
    names(engine, &torque.classes[class].cylinders)
}

/// The names of these cylinders.
pub(in crate::report) fn names(engine: &Engine, cylinders: &[usize]) -> Text {
    let names: Vec<&str> = cylinders.iter().map(|&index| engine.cylinders()[index].name.as_str()).collect();
    Text::label(number::names(&names))
}

/// What the numbers rest on.
pub(in crate::report) fn assumptions(engine: &Engine) -> Vec<Text> {
    let mut list: Vec<Text> = text::assumptions().into();
    list.extend((!engine.has_yokes_alone()).then(text::rod));
    list.extend(own_angles(engine));
    if let Some(sides) = double_acting(engine) {
        list.extend([sides, text::double_acting_mean()]);
    }
    list.extend(opposed(engine));
    let laws = engine.gas().map_or(&[][..], |gas| &gas.laws);
    let heats: Vec<bool> = laws.iter().filter_map(finds_heat).collect();
    if !heats.is_empty() {
        list.push(text::ideal_cycle(engine.cycle() != Some(Cycle::TwoStroke)));
    }
    if heats.contains(&true) {
        list.push(text::heat(!heats.contains(&false)));
    }
    list
}

/// Whether the heat of an ideal cycle is found from its pressure; none of another law.
fn finds_heat(law: &PressureLaw) -> Option<bool> {
    match law {
        PressureLaw::Cycle(ideal) => Some(!matches!(ideal.heat, Heat::Released(_))),
        _ => None,
    }
}

/// Where the angle 0 of the gas is in a cylinder.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum OwnZero {
    Crank,
    Piston,
    /// Between two pistons.
    Volume,
}

impl OwnZero {
    /// That of a cylinder, by its index.
    pub fn of(engine: &Engine, index: usize) -> OwnZero {
        let zero = engine.gas().map_or(DeadCentre::Crank, |gas| gas.chambers[index].zero);
        match (zero, engine.cylinders()[index].shared.is_some()) {
            (DeadCentre::Crank, _) => OwnZero::Crank,
            (DeadCentre::Piston, false) => OwnZero::Piston,
            (DeadCentre::Piston, true) => OwnZero::Volume,
        }
    }
}

/// From where the own angles of the cylinders count: a sentence for all, or one for each kind.
fn own_angles(engine: &Engine) -> Vec<Text> {
    let of = |zero: OwnZero| -> Vec<usize> {
        engine.firing_pistons().into_iter().filter(|&index| OwnZero::of(engine, index) == zero).collect()
    };
    let kinds = [
        (OwnZero::Crank, text::own_angle_of_crank as fn() -> Text),
        (OwnZero::Piston, text::own_angle_of_piston),
        (OwnZero::Volume, text::own_angle_of_volume),
    ];
    let found = kinds.map(|(zero, sentence)| (of(zero), sentence())).into_iter();
    let found: Vec<(Vec<usize>, Text)> = found.filter(|(cylinders, _)| !cylinders.is_empty()).collect();
    let is_one = found.len() == 1;
    let line = |(cylinders, sentence): (Vec<usize>, Text)| match is_one {
        true => sentence,
        false => text::of_cylinders(names(engine, &cylinders), sentence),
    };
    found.into_iter().map(line).collect()
}

/// What presses on double-acting pistons.
pub(in crate::report) fn double_acting(engine: &Engine) -> Option<Text> {
    let has_two = engine.gas()?.chambers.iter().any(|chamber| chamber.below.is_some());
    has_two.then(text::double_acting)
}

/// What two pistons in one cylinder share.
pub(in crate::report) fn opposed(engine: &Engine) -> Option<Text> {
    engine.has_opposed_pistons().then(text::opposed)
}
