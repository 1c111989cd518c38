//! What was given of the gas, and what was assumed?

use num_rational::BigRational;

use super::words::names;
use crate::engine::{Engine, Heat, PressureLaw, Setting};
use crate::page::{Table, Text, Unit, number};
use crate::torque::EngineTorque;

/// The settings of a process, in the order in which they are shown.
const SHOWN: [Setting; 14] = [
    Setting::CompressionRatio,
    Setting::Clearance,
    Setting::IntakePressure,
    Setting::ExhaustPressure,
    Setting::DeliveryPressure,
    Setting::CompressionExponent,
    Setting::ExpansionExponent,
    Setting::Heat,
    Setting::WiebeExponent,
    Setting::IntakeCloses,
    Setting::CombustionStarts,
    Setting::CombustionLasts,
    Setting::ExhaustOpens,
    Setting::Blowdown,
];

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
        row("bore".into(), in_unit(&chamber.bore, 1000, Unit::MILLIMETRE), false);
        row("pressure in the crankcase".into(), bar(&chamber.crankcase), chamber.crankcase_assumed);
        if let Some(below) = &chamber.below {
            row("diameter of the piston rod".into(), in_unit(&below.rod, 1000, Unit::MILLIMETRE), false);
            if let PressureLaw::Table(rows) = &gas.laws[below.law] {
                row("rows of the table of pressures below the piston".into(), rows.rows().len().into(), false);
            }
        }
        match &gas.laws[chamber.law] {
            PressureLaw::Table(_) if engine.misfire() == Some(group[0]) => {
                row("pressure".into(), "that of the crankcase".into(), true);
            }
            PressureLaw::Table(rows) => {
                row("rows of the table of pressures".into(), rows.rows().len().into(), false);
            }
            PressureLaw::Cycle(ideal) => {
                for setting in SHOWN {
                    if let Some(value) = ideal.value(setting) {
                        row(
                            name(setting, &ideal.heat),
                            shown(setting, &ideal.heat, value),
                            ideal.assumed.contains(&setting),
                        );
                    }
                }
            }
            PressureLaw::Stage(stage) => {
                let heat = Heat::Released(BigRational::from_integer(0.into()));
                for setting in SHOWN {
                    if let Some(value) = stage.value(setting) {
                        row(name(setting, &heat), shown(setting, &heat, value), stage.assumed.contains(&setting));
                    }
                }
            }
        }
    }
    table
}

fn in_unit(value: &BigRational, factor: i64, unit: Unit) -> Text {
    number::given_with(&(value * BigRational::from_integer(factor.into())), unit)
}

fn bar(pascals: &BigRational) -> Text {
    let bar = pascals / BigRational::from_integer(100_000.into());
    number::given_with(&bar, Unit::BAR)
}

fn name(setting: Setting, heat: &Heat) -> Text {
    match setting {
        Setting::Bore => "bore",
        Setting::Crankcase => "pressure in the crankcase",
        Setting::PistonRod => "diameter of the piston rod",
        Setting::CompressionRatio => "compression ratio",
        Setting::IntakePressure => "pressure of the intake",
        Setting::ExhaustPressure => "pressure of the exhaust",
        Setting::DeliveryPressure => "pressure of delivery",
        Setting::Clearance => "clearance, part of the swept volume",
        Setting::CompressionExponent => "exponent of the compression",
        Setting::ExpansionExponent => "exponent of the expansion",
        Setting::Heat => match heat {
            Heat::Released(_) => "heat of a cycle",
            Heat::PeakPressure(_) => "largest pressure",
            Heat::MeanPressure(_) => "mean indicated pressure",
        },
        Setting::WiebeExponent => "exponent m of the Wiebe function",
        Setting::IntakeCloses => "the intake closes at",
        Setting::CombustionStarts => "burning starts at",
        Setting::CombustionLasts => "burning lasts",
        Setting::ExhaustOpens => "the exhaust opens at",
        Setting::Blowdown => "the pressure falls for",
    }
    .into()
}

fn shown(setting: Setting, heat: &Heat, value: &BigRational) -> Text {
    match setting {
        Setting::Bore | Setting::PistonRod => in_unit(value, 1000, Unit::MILLIMETRE),
        Setting::Crankcase | Setting::IntakePressure | Setting::ExhaustPressure | Setting::DeliveryPressure => {
            bar(value)
        }
        Setting::CompressionRatio
        | Setting::Clearance
        | Setting::CompressionExponent
        | Setting::ExpansionExponent
        | Setting::WiebeExponent => number::given(value),
        Setting::Heat => match heat {
            Heat::Released(_) => in_unit(value, 1, Unit::JOULE),
            Heat::PeakPressure(_) | Heat::MeanPressure(_) => bar(value),
        },
        Setting::IntakeCloses
        | Setting::CombustionStarts
        | Setting::CombustionLasts
        | Setting::ExhaustOpens
        | Setting::Blowdown => Text::label(number::turns(value)),
    }
}
