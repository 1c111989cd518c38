//! Is it true, what is said about the forces of gas and masses together: a formula of one cylinder, a largest load?

use std::cell::RefCell;

use super::answer::{Answer, Status};
use super::error::ClaimError;
use super::finding::{Agreement, Finding, LargestOf};
use super::formula::{Formula, Measured};
use super::masses;
use super::moving_parts::Parts;
use super::statement::{Loaded, OfCylinder, Statement, Unit, Value};
use super::written_value::{part_of_the_largest, value};
use crate::engine::Engine;
use crate::file::parse_number;
use crate::journal::cycle_loads;
use crate::numbers;
use crate::proof::Quantity;
use crate::torque::{self, Extreme};

const LOADED: [(&str, Loaded); 4] = [
    ("largest main-bearing load with gas ", Loaded::MainBearing),
    ("largest crankpin load with gas ", Loaded::Crankpin),
    ("largest rod force with gas ", Loaded::Rod),
    ("largest side force with gas ", Loaded::Cylinder),
];

/// What each that a formula is said of is called at the beginning of a claim.
const MEASURED: [(&str, Measured); 19] = [
    ("sine of the rod angle", Measured::RodSine),
    ("piston displacement", Measured::Displacement),
    ("piston velocity", Measured::Velocity),
    ("piston acceleration", Measured::Acceleration),
    ("gas force", Measured::GasForce),
    ("inertia force", Measured::InertiaForce),
    ("centrifugal force", Measured::CentrifugalForce),
    ("piston effort", Measured::PistonEffort),
    ("side force", Measured::SideForce),
    ("rod force", Measured::RodForce),
    ("radial force", Measured::RadialForce),
    ("crank effort", Measured::CrankEffort),
    ("force on the frame along the axis", Measured::FrameAlong),
    ("force on the frame across the axis", Measured::FrameAcross),
    ("cylinder torque", Measured::Torque),
    ("reaction torque", Measured::ReactionTorque),
    ("reciprocating mass", Measured::ReciprocatingMass),
    ("rotating mass", Measured::RotatingMass),
    ("rod length", Measured::RodLength),
];

/// Reads a claim about forces; none where the words are about something else.
pub(super) fn parse(words: &str) -> Option<Result<Statement, ClaimError>> {
    // Names are ASCII, so that they are as long in lower case.
    let behind = |name: &str| {
        let begins = words.get(..name.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(name));
        begins.then(|| &words[name.len()..])
    };
    if let Some((rest, of)) = LOADED.iter().find_map(|(name, of)| Some((behind(name)?, *of))) {
        return Some(load(rest).map(|value| Statement::LargestLoad(of, value)));
    }
    let (rest, what) = MEASURED.iter().find_map(|(name, what)| Some((behind(name)?.trim_start(), *what)))?;
    Some(of_cylinder(rest, what).map(Statement::Formula))
}

fn load(rest: &str) -> Result<Value, ClaimError> {
    let right = "such as \"largest side force with gas = 3520 N ± 1 %\"";
    let Some(written) = rest.strip_prefix(['=', '≈']) else {
        return Err(ClaimError::new(format!("`{rest}` is not understood"), right));
    };
    let value = value(written.trim(), rest.starts_with('≈'), Quantity::FORCE)?;
    match value.unit {
        Some(Unit::Newton) => Ok(value),
        Some(Unit::NewtonMetre | Unit::Spacing) | None => Err(ClaimError::new("a load with gas is in N", right)),
    }
}

fn of_cylinder(rest: &str, what: Measured) -> Result<OfCylinder, ClaimError> {
    let right = "such as \"side force = F tan β\" or \"cylinder torque ≈ F r (sin θ + λ/2 sin 2θ) ± 3 %\"; its letters are in the README of the room";
    let formula = |text: &str| {
        // `146 mm` would be 146 times the mass m twice.
        let is_length = matches!(what, Measured::RodLength | Measured::Displacement);
        let number = text.trim().trim_end_matches(['c', 'm', ' ']);
        if is_length && number.len() < text.trim().len() && parse_number(number).is_ok() {
            let right = "a length in metres without a unit: m is the mass";
            return Err(ClaimError::new(format!("`{}` has a unit", text.trim()), right));
        }
        Formula::read(text).map_err(|mistake| ClaimError::new(mistake, right))
    };
    if let Some(text) = rest.strip_prefix('=') {
        return Ok(OfCylinder { what, formula: formula(text)?, within: None });
    }
    let about = rest.strip_prefix('≈').and_then(|rest| rest.split_once('±').or_else(|| rest.split_once("+/-")));
    let Some((text, part)) = about else {
        return Err(ClaimError::new(
            format!("`{rest}` is not a formula that can be checked"),
            "= FORMULA, or ≈ FORMULA ± PART of the largest value in percent, such as ± 3 %",
        ));
    };
    Ok(OfCylinder { what, formula: formula(text)?, within: Some(part_of_the_largest(part.trim())?) })
}

/// Answers a claim that a formula holds at every crank angle of the first cylinder's cycle.
pub(super) fn formula(engine: &Engine, says: &OfCylinder) -> Answer {
    let parts = match Parts::new(engine) {
        Ok(parts) => parts,
        Err(lack) => return Answer::nothing(lack),
    };
    let nowhere = || Extreme { value: 0.0, angle: 0.0 };
    let (mut largest, mut off, mut angles) = (nowhere(), nowhere(), 0);
    for psi in torque::angles(parts.period()) {
        let lack = RefCell::new(None);
        let known = |value: Result<f64, String>| {
            value.unwrap_or_else(|why| {
                lack.replace(Some(why));
                f64::NAN
            })
        };
        let measured = known(parts.measured(says.what, psi));
        let told = says.formula.value(&|letter| known(parts.letter(letter, psi)));
        if let Some(lack) = lack.into_inner() {
            return Answer::nothing(lack);
        }
        if !(measured.is_finite() && told.is_finite()) {
            return Answer::nothing("the formula has no value at some crank angle");
        }
        let keep = |most: &mut Extreme, value: f64| {
            if value > most.value {
                *most = Extreme { value, angle: psi.to_degrees() };
            }
        };
        keep(&mut largest, measured.abs());
        keep(&mut off, (measured - told).abs());
        angles += 1;
    }
    let agreement = Agreement { what: says.what, largest, off, angles, equal: false };
    let agreement = Agreement { equal: agreement.part() <= numbers::ALIKE, ..agreement };
    let within = says.within.as_ref().map_or(numbers::ALIKE, numbers::float);
    let holds = agreement.equal || agreement.part() <= within;
    Answer { status: Status::of(holds), finding: Finding::Agreement(agreement), evidence: Vec::new() }
}

/// Answers a claim about a largest load of gas and masses together.
pub(super) fn largest(engine: &Engine, of: Loaded, value: &Value) -> Answer {
    let found = cycle_loads(engine).map_err(|lack| lack.to_string()).and_then(|loads| {
        let cylinder = |index: usize| engine.cylinders()[index].name.clone();
        let cylinders = loads.cylinders.iter().map(|cylinder| &cylinder.peaks).enumerate();
        let mut known: Vec<LargestOf> = match of {
            Loaded::MainBearing => {
                let [continuous, _] = loads.bearings.as_ref().ok_or("the layout gives no main bearings")?;
                let bearing = |(index, bearing): (usize, &crate::journal::CycleBearing)| LargestOf {
                    of,
                    which: (index + 1).to_string(),
                    peak: Extreme { value: bearing.peak.value, angle: bearing.peak.angle },
                    without_gas: Some(bearing.inertia.value),
                };
                continuous.bearings.iter().enumerate().map(bearing).collect()
            }
            Loaded::Crankpin => cylinders
                .map(|(index, peaks)| LargestOf {
                    of,
                    which: cylinder(index),
                    peak: Extreme { value: peaks.pin.value, angle: peaks.pin.angle },
                    without_gas: Some(peaks.pin_of_inertia.value),
                })
                .collect(),
            Loaded::Rod => cylinders
                .map(|(index, peaks)| LargestOf { of, which: cylinder(index), peak: peaks.rod[0], without_gas: None })
                .collect(),
            Loaded::Cylinder => cylinders
                .map(|(index, peaks)| {
                    let [left, right] = peaks.side;
                    let right = Extreme { value: -right.value, ..right };
                    let peak = if right.value > left.value { right } else { left };
                    LargestOf { of, which: cylinder(index), peak, without_gas: None }
                })
                .collect(),
        };
        let most = known.iter().map(|one| one.peak.value).fold(f64::NEG_INFINITY, f64::max);
        // Of loads that are equal but for roundings the first is named.
        let place = known.iter().position(|one| one.peak.value >= most - numbers::ALIKE * most.abs());
        let found = known.swap_remove(place.ok_or("the engine has no cylinders")?);
        Ok((masses::decimal(value, found.peak.value)?, found))
    });
    match found {
        Err(reason) => Answer::nothing(reason),
        Ok((status, found)) => Answer { status, finding: Finding::Largest(found), evidence: Vec::new() },
    }
}
