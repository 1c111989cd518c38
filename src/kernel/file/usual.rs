//! Which quantities of a layout are none that engines have? A number without its unit is read in metres or kilograms, whatever was meant:
//! it is not refused, for an exercise may have any engine, but told.

use std::fmt;
use std::ops::{Range, RangeInclusive};

use annotate_snippets::Level;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use serde_spanned::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::LayoutError;
use super::layout::Layout;
use super::quantities::integer;
use super::rewritten::{bare_number, exact_number};
use super::{quantities, units, written};
use crate::engine::{Engine, PressureLaw};

/// Something odd in a layout file, with its place. It changes no result.
#[derive(Clone, Debug)]
pub struct LayoutWarning(LayoutError);

impl fmt::Display for LayoutWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.shown(&Level::WARNING))
    }
}

/// A kind of quantity: the unit that a number alone has, and those that may be meant.
struct Kind {
    read: fn(&str) -> Option<BigRational>,
    unit: &'static str,
    meant: &'static [&'static str],
    asked: &'static str,
    alone: Alone,
}

/// What a number without a unit counts.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Alone {
    BaseUnit,
    /// Metres where positions are in metres.
    Spacing,
    CrankRadius,
}

const IS_THE_UNIT_RIGHT: &str = "is the unit right?";

const LENGTH: Kind = Kind {
    read: |text| Some(units::length(text).ok()?.value),
    unit: " m",
    meant: &["mm", "cm", "in", "ft", "m"],
    asked: IS_THE_UNIT_RIGHT,
    alone: Alone::BaseUnit,
};
const OF_SPACING: Kind = Kind { alone: Alone::Spacing, ..LENGTH };
const OF_CRANK: Kind = Kind { alone: Alone::CrankRadius, ..LENGTH };
const MASS: Kind =
    Kind { read: |text| units::mass(text).ok(), unit: " kg", meant: &["g", "oz", "lb", "kg", "t"], ..LENGTH };
const SPEED: Kind =
    Kind { read: |text| units::speed(text).ok(), unit: " rpm", meant: &["rev/s", "rad/s", "rpm"], ..LENGTH };

const PRESSURE: Kind = Kind {
    read: |text| Some(units::pressure(text, None).ok()? / integer(100_000)),
    unit: " bar",
    meant: &[],
    ..LENGTH
};
/// A share of masses that counterweights balance.
const SHARE: Kind = Kind {
    read: |text| quantities::plain(text, "0.5").ok(),
    unit: "",
    meant: &[],
    asked: "is it in per cent? 50 % is 0.5",
    alone: Alone::BaseUnit,
};

/// What is read of a key: a value below 0 of one of `Positive` is refused, whatever its unit.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Sign {
    Positive,
    Either,
}

/// Largest pressures that engines have, in bar.
pub const USUAL_PEAK_BAR: RangeInclusive<i64> = 5..=400;
/// Where they have them, in degrees from the firing dead centre.
pub const USUAL_PEAK_DEGREES: RangeInclusive<i64> = -5..=40;

/// A model engine of 5 mm of stroke and a beam engine of 3.7 m, a piston of a gram and the crosshead engine of 14 cylinders are within these;
/// in thousandths of the base unit, and of either sign. 0 is always one.
#[rustfmt::skip]
const USUAL: &[(&str, Kind, Sign, i64, i64)] = &[
    ("stroke", LENGTH, Sign::Positive, 2, 6_000),
    ("crank_radius", LENGTH, Sign::Positive, 1, 3_000),
    ("rod_length", LENGTH, Sign::Positive, 2, 20_000),
    ("rod_centre", LENGTH, Sign::Positive, 0, 20_000),
    ("pin_offset", LENGTH, Sign::Either, 0, 2_000),
    ("knuckle_radius", LENGTH, Sign::Positive, 1, 3_000),
    ("link_length", LENGTH, Sign::Positive, 2, 20_000),
    ("bore", LENGTH, Sign::Positive, 2, 4_000),
    ("web_radius", LENGTH, Sign::Either, 0, 5_000),
    ("web_offset", LENGTH, Sign::Either, 0, 2_000),
    ("counterweight_radius", LENGTH, Sign::Positive, 0, 5_000),
    ("radius", LENGTH, Sign::Positive, 0, 5_000),
    ("radius_of_gyration", LENGTH, Sign::Positive, 1, 10_000),
    ("spacing", OF_SPACING, Sign::Positive, 2, 10_000),
    ("row_spacing", OF_SPACING, Sign::Either, 2, 10_000),
    ("bank_offset", OF_SPACING, Sign::Either, 0, 2_000),
    ("bank_offsets", OF_SPACING, Sign::Either, 0, 2_000),
    ("stagger", OF_SPACING, Sign::Either, 0, 2_000),
    ("place", LENGTH, Sign::Either, 0, 50_000),
    ("centre", LENGTH, Sign::Either, 0, 50_000),
    ("point", LENGTH, Sign::Either, 0, 50_000),
    ("position", OF_SPACING, Sign::Either, 0, 50_000),
    ("height", OF_SPACING, Sign::Either, 0, 20_000),
    ("offset", OF_SPACING, Sign::Either, 0, 20_000),
    ("distance", OF_CRANK, Sign::Either, 2, 20_000),
    ("circumradius", OF_CRANK, Sign::Either, 2, 20_000),
    ("length", LENGTH, Sign::Positive, 1, 60_000),
    ("outer_diameter", LENGTH, Sign::Positive, 2, 3_000),
    ("inner_diameter", LENGTH, Sign::Positive, 0, 3_000),
    ("mass", MASS, Sign::Positive, 0, 100_000_000),
    ("speed", SPEED, Sign::Positive, 10_000, 100_000_000),
    ("rated_speed", SPEED, Sign::Positive, 10_000, 100_000_000),
    ("peak_pressure", PRESSURE, Sign::Positive, 1_000 * *USUAL_PEAK_BAR.start(), 1_000 * *USUAL_PEAK_BAR.end()),
    ("mean_pressure", PRESSURE, Sign::Positive, 10, 60_000),
    ("balance_factor", SHARE, Sign::Positive, 0, 5_000),
    ("rotating", SHARE, Sign::Positive, 0, 5_000),
    ("reciprocating", SHARE, Sign::Positive, 0, 5_000),
    ("rotating_and_half_reciprocating", SHARE, Sign::Positive, 0, 5_000),
];

/// What ends so is a mass: `piston_mass`.
const MASS_ENDS: &str = "_mass";
/// Tables whose keys are names of other things.
const OTHERS: [&str; 3] = ["document", "values", "flywheel"];

/// Mean piston speeds above this, in metres a second, are none: a racing engine has 27.
const FASTEST: i64 = 40;
/// No piston is accelerated more than this, in metres a second squared: that of a racing engine by 100,000.
const MOST_ACCELERATION: i64 = 300_000;
/// No piston weighs more than this times the cube of its stroke, in kilograms a cubic metre.
const HEAVIEST: i64 = 100_000;

/// What is odd about the quantities of a layout file, which was read as `layout`.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// let text = "inline.throws = [0]\nmechanism.crank_radius = 46";
/// let layout = crankstar::parse_layout("single.toml", text).unwrap();
/// let warnings = crankstar::file::warnings("single.toml", text, &layout);
/// assert!(warnings[0].to_string().contains("crank_radius") && warnings[0].to_string().contains("\"46 mm\""));
/// ```
pub fn warnings(name: &str, source: &str, layout: &Layout) -> Vec<LayoutWarning> {
    let Ok(table) = written::table(source) else { return Vec::new() };
    let is_metric = matches!(layout, Layout::Known(engine, _) if engine.is_in_metres());
    let mut odd = odd_quantities(table.get_ref(), has_parts(layout), is_metric);
    // What follows from an odd quantity is odd as well, and says nothing more.
    if let (true, Layout::Known(engine, _)) = (odd.is_empty(), layout) {
        odd.extend(together(engine, table.get_ref()));
    }
    odd.into_iter().map(|odd| LayoutWarning(odd.in_file(name, source))).collect()
}

/// What is odd about quantities by themselves: of a file that is refused, for the reason may be a unit, or of one that describes no engine.
pub fn warnings_of_values(name: &str, source: &str) -> Vec<LayoutWarning> {
    let Ok(table) = written::table(source) else { return Vec::new() };
    let odd = odd_quantities(table.get_ref(), false, false);
    odd.into_iter().map(|odd| LayoutWarning(odd.in_file(name, source))).collect()
}

/// What is odd about the value of a key that is not in a file, in one line.
pub fn odd_value(key: &str, text: &str, engine: Option<&Engine>) -> Option<String> {
    let name = key.rsplit('.').find(|part| part.parse::<usize>().is_err())?;
    let table = key.split('.').next().filter(|table| !OTHERS.contains(table))?;
    let odd = of_table(table, name, text, 0..0, engine.is_some_and(Engine::is_in_metres))?;
    Some(format!("{}: {}", odd.message(), odd.right()))
}

/// A position of an engine that is beyond any, in one line.
pub fn odd_position(engine: &Engine) -> Option<String> {
    let odd = longest(engine, &DeTable::new())?;
    Some(format!("{}: {}", odd.message(), odd.right()))
}

/// Whether counterweights are written in parts: the radius of a part may be any, that of all together is one of an engine.
fn has_parts(layout: &Layout) -> bool {
    let Layout::Known(engine, _) = layout else { return false };
    let weights = &engine.crankshaft().counterweights;
    weights.iter().enumerate().any(|(index, one)| {
        weights[..index].iter().any(|other| (&other.position, other.crank) == (&one.position, one.crank))
    })
}

/// Those that are odd by themselves.
fn odd_quantities(table: &DeTable<'_>, has_parts: bool, is_metric: bool) -> Vec<LayoutError> {
    let mut odd = Vec::new();
    for (name, value) in table {
        let name = name.get_ref();
        each_in(name, value, &mut |key, text, span| {
            let is_of_a_part = has_parts && key == "radius";
            odd.extend(of_table(name, key, text, span, is_metric).filter(|_| !is_of_a_part));
        });
    }
    odd
}

/// What is odd about a value in a table.
fn of_table(table: &str, key: &str, text: &str, span: Range<usize>, is_metric: bool) -> Option<LayoutError> {
    match (table, key) {
        // How often it turns while the first one turns once.
        ("crankshaft", "speed") => None,
        // Here a number alone counts crank radii, and one of the crankshafts may be in the middle.
        ("crankshaft", _) => quantity(key, text, span, false),
        _ => apart(key, text, span.clone()).or_else(|| quantity(key, text, span, is_metric)),
    }
}

/// Shows every text of a value, with its key and its place.
fn each_in(key: &str, value: &Spanned<DeValue<'_>>, then: &mut impl FnMut(&str, &str, Range<usize>)) {
    match value.get_ref() {
        _ if OTHERS.contains(&key) => {}
        DeValue::String(text) => then(key, text, value.span()),
        // There is one speed; a list of them is refused.
        DeValue::Array(_) if key == "speed" => {}
        DeValue::Array(list) => list.iter().for_each(|value| each_in(key, value, then)),
        DeValue::Table(table) => table.iter().for_each(|(key, value)| each_in(key.get_ref(), value, then)),
        _ => {}
    }
}

/// What is odd about how far throws or crankshafts are apart.
fn apart(key: &str, text: &str, span: Range<usize>) -> Option<LayoutError> {
    let (at_zero, below) = match key {
        "spacing" => (
            "throws one spacing apart are then in one plane",
            "the throws then stand in the opposite order along the shaft",
        ),
        "distance" | "circumradius" => {
            ("the crankshafts are then on one axis", "the crankshafts have then changed sides")
        }
        _ => return None,
    };
    let length = (LENGTH.read)(text).filter(|length| !length.is_positive())?;
    let (message, right) = match length.is_zero() {
        true => (format!("{key} is 0"), format!("{at_zero}: how far are they apart?")),
        false => (format!("{key} is below 0"), format!("{below}: is the sign right?")),
    };
    Some(LayoutError::new(message, right, Some(span)))
}

/// What is odd about a quantity by itself, where positions are in metres or in multiples of the spacing.
fn quantity(key: &str, text: &str, span: Range<usize>, is_metric: bool) -> Option<LayoutError> {
    let name = if key.ends_with(MASS_ENDS) { "mass" } else { key };
    let (_, kind, sign, least, most) = USUAL.iter().find(|(known, ..)| *known == name)?;
    let thousandths = |number: i64| BigRational::new(number.into(), 1000.into());
    let (least, most) = (thousandths(*least), thousandths(*most));
    let is_usual = |value: &BigRational| value.is_zero() || (value.abs() >= least && value.abs() <= most);
    let is_read = |value: &BigRational| !value.is_negative() || *sign == Sign::Either;
    let counts_a_length = kind.alone == Alone::BaseUnit || kind.alone == Alone::Spacing && is_metric;
    if !counts_a_length && units::length(text).is_ok_and(|length| !length.has_unit) {
        return None;
    }
    let value = (kind.read)(text).filter(|value| is_read(value) && !is_usual(value))?;
    let meant = kind.meant.iter().map(|unit| format!("{} {unit}", text.trim()));
    let meant = meant.into_iter().find(|text| (kind.read)(text).is_some_and(|value| is_usual(&value)));
    let shown = |value: &BigRational| format!("{}{}", bare_number(value), kind.unit);
    let engines = match least.is_zero() {
        true => format!("engines have at most {}", shown(&most)),
        false => format!("engines have {} to {}", shown(&least), shown(&most)),
    };
    let such = meant.map_or_else(String::new, |meant| format!(" such as \"{meant}\""));
    let right = format!("{engines}: {}{such}", kind.asked);
    Some(LayoutError::new(format!("{key} is read as {}", shown(&value)), right, Some(span)))
}

/// What is odd about quantities that are usual by themselves.
fn together(engine: &Engine, table: &DeTable<'_>) -> Vec<LayoutError> {
    let dimensions = engine.dimensions();
    if let Some(odd) = longest(engine, table).or_else(|| measured(engine, table)) {
        return vec![odd];
    }
    let Some(unit) = &dimensions.crank_radius else { return Vec::new() };
    let radii = || engine.cylinders().iter().map(|cylinder| &cylinder.crank_radius * unit);
    let mut odd = Vec::new();
    if let (Some(speed), Some(span)) = (&dimensions.speed, place(table, &["speed"])) {
        let fastest = radii().map(|radius| radius * speed / integer(15)).max().unwrap_or_default();
        // ω² = (2π n/60)², π as 355/113.
        let omega = speed / integer(30) * BigRational::new(355.into(), 113.into());
        let accelerated = engine.cylinders().iter().zip(radii()).map(|(cylinder, radius)| {
            let ratio = cylinder.rod().map_or_else(BigRational::zero, |rod| rod.ratio.clone());
            radius * &omega * &omega * (integer(1) + ratio)
        });
        let right = "are stroke and speed in the units that they are meant in?";
        let limits = [
            ("a mean piston speed of", fastest, FASTEST, "m/s"),
            ("a piston's acceleration", accelerated.max().unwrap_or_default(), MOST_ACCELERATION, "m/s²"),
        ];
        if let Some((what, value, most, unit)) = limits.into_iter().find(|(_, value, most, _)| *value > integer(*most))
        {
            let message =
                format!("speed makes {what} {} {unit}, and engines have at most {most} {unit}", value.round());
            odd.push(LayoutError::new(message, right, Some(span)));
        }
    }
    if let (Some(mass), Some(span)) = (&dimensions.mass, mechanism(table).and_then(|keys| place(keys, &MASSES))) {
        let heavy = engine.cylinders().iter().zip(radii()).find(|(cylinder, radius)| {
            let stroke = radius * integer(2);
            mass * &cylinder.reciprocating_mass > integer(HEAVIEST) * &stroke * &stroke * &stroke
        });
        if let Some((cylinder, radius)) = heavy {
            let message = format!(
                "a reciprocating mass of {} kg at a stroke of {} mm is heavier than that of any engine",
                bare_number(&(mass * &cylinder.reciprocating_mass)),
                bare_number(&(radius * integer(2000)))
            );
            odd.push(LayoutError::new(message, "is the unit right? such as \"450 g\"", Some(span)));
        }
    }
    odd
}

/// An engine is no longer than this, in metres.
const LONGEST: i64 = 50;

/// A position in metres that is beyond any engine, or beyond this one.
fn longest(engine: &Engine, table: &DeTable<'_>) -> Option<LayoutError> {
    let most = integer(LONGEST);
    if !engine.is_in_metres() {
        return None;
    }
    let is_far = |at: &&BigRational| at.abs() > most;
    let bearing =
        || Some(("a main bearing is at", engine.bearings().iter().find(is_far)?, place(table, &["bearings"])));
    let forms = || table.values().filter_map(|value| value.get_ref().as_table());
    let spacing = || forms().find_map(|form| place(form, &["spacing"]));
    let positions = || engine.cylinders().iter().map(|cylinder| &cylinder.position);
    let found = bearing().or_else(|| Some(("a cylinder is at", positions().find(is_far)?, spacing())));
    let (first, last) = (positions().min()?, positions().max()?);
    let apart = last - first;
    if let Some((what, at, span)) = (apart > most).then(|| ("the cylinders reach over", &apart, spacing())).or(found) {
        let right = format!("no engine is longer than {LONGEST} m: is the unit right? such as \"88 mm\"");
        return Some(LayoutError::new(format!("{what} {} m", bare_number(at)), right, span));
    }
    // Moments are taken about no plane that is farther from the engine than ten of its lengths.
    let farthest = if apart.is_zero() { most } else { most.min(&apart * integer(10)) };
    let plane = Some(engine.reference_plane()).filter(|_| engine.reference_plane_given())?;
    let right =
        format!("the cylinders stand from {} m to {} m: is the unit right?", bare_number(first), bare_number(last));
    let message = format!("the reference plane is at {} m", bare_number(plane));
    let odd = LayoutError::new(message, right, place(table, &["reference_plane"]));
    ((plane - last).max(first - plane) > farthest).then_some(odd)
}

/// What is odd about a table of pressures: its largest one, or where that is. Steam and pumps, double-acting as a rule, have theirs elsewhere.
fn measured(engine: &Engine, table: &DeTable<'_>) -> Option<LayoutError> {
    let (gas, cycle) = (engine.gas()?, engine.cycle()?);
    let gas_keys = table.get("gas")?.get_ref().as_table()?;
    let span = place(gas_keys, &["table", "pressure"]);
    let is_usual = |value: &BigRational, usual: &RangeInclusive<i64>| {
        *value >= integer(*usual.start()) && *value <= integer(*usual.end())
    };
    let odd = |law: &PressureLaw| {
        let PressureLaw::Table(rows) = law else { return None };
        let (angle, pascals) = rows.rows().iter().max_by(|one, other| one.1.cmp(&other.1))?;
        let bar = pascals / integer(100_000);
        if !is_usual(&bar, &USUAL_PEAK_BAR) {
            // In thousandths, but for what has none.
            let rounded = (&bar * integer(1000)).round() / integer(1000);
            let shown = exact_number(if rounded.is_zero() { &bar } else { &rounded });
            let message = format!("the largest pressure of the table is {shown} bar");
            let (least, most) = (USUAL_PEAK_BAR.start(), USUAL_PEAK_BAR.end());
            let right = format!("engines have {least} to {most} bar: is the unit right?");
            return Some(LayoutError::new(message, right, span.clone()));
        }
        let turns = cycle.turns();
        let within = angle / &turns - (angle / &turns + BigRational::new(1.into(), 2.into())).floor();
        let degrees = within * turns * integer(360);
        let message = format!("the largest pressure of the table is at {}° of the firing dead centre", degrees.round());
        let (first, last) = (USUAL_PEAK_DEGREES.start(), USUAL_PEAK_DEGREES.end());
        let right = format!(
            "{first}° to {last}° is usual: 0 is the firing dead centre; where the table has it at 360, subtract 360"
        );
        (!rows.is_constant() && !is_usual(&degrees, &USUAL_PEAK_DEGREES))
            .then(|| LayoutError::new(message, right, span.clone()))
    };
    let is_of_engine = gas.chambers.iter().all(|chamber| chamber.below.is_none());
    gas.laws.iter().filter(|_| is_of_engine).find_map(odd)
}

/// What the reciprocating mass is written as.
const MASSES: [&str; 2] = ["reciprocating_mass", "piston_mass"];

fn mechanism<'a, 'b>(table: &'a DeTable<'b>) -> Option<&'a DeTable<'b>> {
    table.get("mechanism")?.get_ref().as_table()
}

/// Where the value of the first of these keys stands.
fn place(table: &DeTable<'_>, keys: &[&str]) -> Option<Range<usize>> {
    keys.iter().find_map(|key| Some(table.get(*key)?.span()))
}
