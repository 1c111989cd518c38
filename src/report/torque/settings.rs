//! What was given of the gas, and what was assumed?

use num_rational::BigRational;

use super::words::{OwnZero, names};
use crate::engine::{Cycle, Engine, Heat, PressureLaw, Setting};
use crate::page::{Table, Text, Unit, number};
use crate::report::texts::torque as text;
use crate::torque::EngineTorque;

/// How a value of the gas is written.
type Written = fn(&BigRational) -> Text;

/// The settings of a process, in the order in which they are shown: what each is called, and how it is written.
const SHOWN: [(Setting, &str, Written); 14] = [
    (Setting::CompressionRatio, "compression ratio", number::given),
    (Setting::Clearance, "clearance, part of the swept volume", number::given),
    (Setting::IntakePressure, "pressure of the intake", bar),
    (Setting::ExhaustPressure, "pressure of the exhaust", bar),
    (Setting::DeliveryPressure, "pressure of delivery", bar),
    (Setting::CompressionExponent, "exponent of the compression", number::given),
    (Setting::ExpansionExponent, "exponent of the expansion", number::given),
    (Setting::Heat, "heat of a cycle", joules),
    (Setting::WiebeExponent, "exponent m of the Wiebe function", number::given),
    (Setting::IntakeCloses, "the intake closes at", degrees),
    (Setting::CombustionStarts, "burning starts at", degrees),
    (Setting::CombustionLasts, "burning lasts", degrees),
    (Setting::ExhaustOpens, "the exhaust opens at", degrees),
    (Setting::Blowdown, "the pressure falls for", degrees),
];

/// The pressure that the heat is found from, where that is given in its place.
fn in_place_of_heat(heat: &Heat) -> Option<(&'static str, Written)> {
    match heat {
        Heat::Released(_) => None,
        Heat::PeakPressure(_) => Some(("largest pressure", bar)),
        Heat::MeanPressure(_) => Some(("mean indicated pressure", bar)),
    }
}

/// Every value of the gas, with the cylinders that it holds for.
pub(super) fn table(engine: &Engine, torque: &EngineTorque) -> Table {
    let Some(gas) = engine.gas() else { return Table::new(["Value", "", "Given or assumed"]) };
    // Classes that differ in their rods alone have their settings in common.
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for class in &torque.classes {
        let chamber = &gas.chambers[class.cylinders[0]];
        match groups.iter_mut().find(|group| gas.chambers[group[0]] == *chamber) {
            Some(group) => group.extend(&class.cylinders),
            None => groups.push(class.cylinders.clone()),
        }
    }
    // One group needs no names.
    let named = groups.len() > 1;
    let header = ["Cylinders", "Value", "", "Given or assumed"];
    let mut table = Table::new(header.into_iter().skip(usize::from(!named)));
    for group in &groups {
        let chamber = &gas.chambers[group[0]];
        let mut row = |name: Text, value: Text, assumed: bool| {
            let how = if assumed { "**assumed**" } else { "given" };
            let names = named.then(|| names(engine, group));
            table.push(names.into_iter().chain([name, value, how.into()]).collect());
        };
        row("bore".into(), millimetres(&chamber.bore), false);
        // Where crank and piston have dead centres of their own the file has to say which.
        let has_two = |index: &usize| {
            engine.cylinders()[*index].mechanism.as_ref().is_some_and(|mechanism| !mechanism.is_centric())
        };
        if engine.only_rods().is_err() || group.iter().any(has_two) {
            let from = match OwnZero::of(engine, group[0]) {
                OwnZero::Crank => "the crank along the axis",
                OwnZero::Piston => "the piston farthest out",
                OwnZero::Volume => "the least volume",
            };
            row("angles of the gas count from".into(), from.into(), false);
        }
        row("pressure in the crankcase".into(), bar(&chamber.crankcase), chamber.crankcase_assumed);
        if let Some(below) = &chamber.below {
            row("diameter of the piston rod".into(), millimetres(&below.rod), false);
            if let PressureLaw::Table(rows) = &gas.laws[below.law] {
                row(text::rows_below(), rows.given().into(), false);
            }
        }
        match &gas.laws[chamber.law] {
            PressureLaw::Table(_) if engine.misfire() == Some(group[0]) => {
                row("pressure".into(), "that of the crankcase".into(), true);
            }
            PressureLaw::Table(rows) => {
                row("rows of the table of pressures".into(), rows.given().into(), false);
            }
            PressureLaw::Cycle(ideal) => {
                // After its blowdown a two-stroke has the pressure of the intake, and no other.
                let is_of_cycle =
                    |of: Setting| of != Setting::ExhaustPressure || engine.cycle() != Some(Cycle::TwoStroke);
                for (setting, name, written) in SHOWN.into_iter().filter(|(setting, ..)| is_of_cycle(*setting)) {
                    let pressure = in_place_of_heat(&ideal.heat).filter(|_| setting == Setting::Heat);
                    let (name, written) = pressure.unwrap_or((name, written));
                    if let Some(value) = ideal.value(setting) {
                        row(name.into(), written(value), ideal.assumed.contains(&setting));
                    }
                }
            }
            PressureLaw::Stage(stage) => {
                for (setting, name, written) in SHOWN {
                    if let Some(value) = stage.value(setting) {
                        row(name.into(), written(value), stage.assumed.contains(&setting));
                    }
                }
            }
        }
    }
    table
}

fn millimetres(metres: &BigRational) -> Text {
    number::given_with(&(metres * BigRational::from_integer(1000.into())), Unit::MILLIMETRE)
}

fn joules(value: &BigRational) -> Text {
    number::given_with(value, Unit::JOULE)
}

fn degrees(turns: &BigRational) -> Text {
    Text::label(number::turns(turns))
}

fn bar(pascals: &BigRational) -> Text {
    let bar = pascals / BigRational::from_integer(100_000.into());
    number::given_with(&bar, Unit::BAR)
}
