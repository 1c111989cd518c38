//! Which values of a layout can be moved, through which exact values, and where on the way does something vanish?

use std::collections::{BTreeMap, BTreeSet};

use num_rational::BigRational;
use num_traits::{One, ToPrimitive};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::mistake::Mistake;
use super::written::Written;
use crate::engine::{Engine, PHI};
use crate::file::{self, Layout, Template, exact_number};
use crate::loads;
use crate::page::number;
use crate::sweep::{self, Parameter, ZeroSet, Zeros};

/// A value to be set in a layout.
#[derive(Deserialize)]
pub(super) struct Set {
    /// Its key, as a slider names it.
    key: String,
    /// The value, as a layout file has it.
    value: String,
}

impl Set {
    /// The text of the layout with the value.
    pub fn within(&self, layout: &Written) -> Result<String, Mistake> {
        let rod = self.key == ROD_RATIO;
        let instead_of: &[&str] = if rod { &["rod_length"] } else { &[] };
        file::with_value(&layout.name, &layout.text, &self.key, &self.value, instead_of)
            .map_err(|error| Mistake::in_layout(&error, &layout.text))
    }
}

/// A value that can be moved.
#[derive(Serialize)]
struct Slider {
    key: String,
    label: &'static str,
    /// The values that it stops at, rising: those of a grid, the one it has, and every exact zero.
    stops: Vec<Stop>,
    /// The stop at which it stands.
    at: usize,
    marks: Vec<Mark>,
    /// What is to be known of the marks.
    note: String,
}

/// A value: as a layout file has it, and as a person reads it.
#[derive(Serialize)]
struct Stop {
    value: String,
    shown: String,
}

/// What vanishes at a stop.
#[derive(Serialize)]
struct Mark {
    stop: usize,
    /// A phrase each.
    what: Vec<String>,
    /// Whether a force or a moment vanishes whole, not one of its vectors alone.
    whole: bool,
}

/// What may be moved in a form, and how far: an angle in degrees.
struct Angle {
    key: &'static str,
    label: &'static str,
    /// What it is where the file leaves it out; none where it has to be there.
    left_out: Option<i64>,
    range: [i64; 2],
}

const BANK: &str = "Bank angle φ";
const SPLIT: &str = "Pin split";
const SPLAY: &str = "Pin splay";

const fn angle(key: &'static str, label: &'static str, left_out: Option<i64>, range: [i64; 2]) -> Angle {
    Angle { key, label, left_out, range }
}

const ANGLES: [Angle; 7] = [
    angle("values.phi", BANK, None, [1, 359]),
    angle("vee.bank_angle", BANK, None, [0, 180]),
    angle("vr.bank_angle", BANK, None, [0, 90]),
    angle("w.bank_angle", BANK, None, [0, 180]),
    angle("vee.pin_split", SPLIT, Some(0), [-180, 180]),
    angle("w.pin_split", SPLIT, Some(0), [-180, 180]),
    angle("vr.pin_splay", SPLAY, Some(0), [-90, 90]),
];

const ROD_RATIO: &str = "mechanism.rod_ratio";

/// The sliders of a layout.
pub(super) fn sliders(layout: &Written) -> Result<Value, Mistake> {
    let Layout::Known(engine, _) = layout.read()? else { return Ok(json!([])) };
    let template =
        Template::new(&layout.name, &layout.text).map_err(|error| Mistake::in_layout(&error, &layout.text))?;
    let angles = ANGLES.iter().filter_map(|angle| of_angle(&template, &engine, angle));
    let all: Vec<Slider> = angles.chain(of_rods(&template, &engine)).collect();
    serde_json::to_value(all).map_err(Mistake::of)
}

fn integer(number: i64) -> BigRational {
    BigRational::from_integer(number.into())
}

fn of_angle(template: &Template, engine: &Engine, angle: &Angle) -> Option<Slider> {
    let (table, name) = angle.key.split_once('.')?;
    let now = match template.value(angle.key) {
        Some(written) => degrees(&written)?,
        // A split that follows from the firing is none to be set.
        None if template.has(table) && template.has(&format!("{table}.throws")) => integer(angle.left_out?),
        None => return None,
    };
    if name == PHI && !template.has(table) {
        return None;
    }
    let [low, high] = angle.range.map(integer);
    // An angle beyond the usual ones takes the range to both sides.
    let wanted = if now < low || now > high { [-359, 359] } else { angle.range };
    let ends = readable(template, angle.key, &now, wanted)?;
    let held = ends[0] > integer(wanted[0]) + integer(1) || ends[1] < integer(wanted[1]) - integer(1);
    let by_firing = template.has("firing_order") || template.has("firing_angles");
    let range = format!("{}={}..{}:1", angle.key, ends[0], ends[1]);
    let orders = loads::usual_orders(engine);
    let parameter = Parameter::parse(&range).ok()?;
    let found = sweep::zeros(template, &parameter, &orders);
    let zeros = found.as_deref().unwrap_or_default();
    let shown = |value: &BigRational| number::degrees(value);
    let slider = slider(angle.key, angle.label, [&ends[0], &ends[1], &BigRational::one()], &now, zeros, &shown);
    // Where another value is a symbol of the file, its zeros are not solved for this one.
    let note = if found.is_some() { slider.note } else { "Zeros along the range are not known here.".to_owned() };
    let note = match held && by_firing {
        true => format!("{note} Beyond the ends the firing that the file names is not possible."),
        false => note,
    };
    Some(Slider { note, ..slider })
}

/// What of a range can be read without a gap about the value that is there, in whole degrees.
///
/// A firing order, which holds for some values alone, narrows it.
fn readable(template: &Template, key: &str, now: &BigRational, [low, high]: [i64; 2]) -> Option<[BigRational; 2]> {
    let key = file::Key::parse(key).ok()?;
    let is_read = |value: i64| template.layout(&[(&key, &value.to_string())]).is_ok();
    let below = now.floor().to_integer().to_i64()?;
    let downwards = (low..=below).rev().take_while(|value| is_read(*value)).last();
    let upwards = (below + 1..=high).take_while(|value| is_read(*value)).last();
    Some([downwards, upwards].map(|end| end.map_or_else(|| now.clone(), integer)))
}

/// The rod ratio, where all rods have one: it changes sizes, and no verdict.
fn of_rods(template: &Template, engine: &Engine) -> Option<Slider> {
    let written = [ROD_RATIO, "mechanism.rod_length"].map(|key| template.has(key));
    let mechanisms = engine.mechanisms();
    let [only] = mechanisms.as_slice() else { return None };
    if written == [false, false] || template.has("articulated") {
        return None;
    }
    let now = only.rod()?.ratio.clone();
    let [low, high, step] = [(1, 10), (1, 2), (1, 200)].map(|(of, parts)| BigRational::new(of.into(), parts.into()));
    let shown = |value: &BigRational| number::number(value);
    Some(slider(ROD_RATIO, "Rod ratio r/l", [&low, &high, &step], &now, &[], &shown))
}

fn slider(
    key: &str,
    label: &'static str,
    [low, high, step]: [&BigRational; 3],
    now: &BigRational,
    zeros: &[ZeroSet],
    shown: &dyn Fn(&BigRational) -> String,
) -> Slider {
    let mut marks: BTreeMap<BigRational, (Vec<String>, bool)> = BTreeMap::new();
    let mut rounded_stops: BTreeSet<BigRational> = BTreeSet::new();
    let sets = || zeros.iter().filter(|set| set.exists && !set.everywhere);
    for set in sets() {
        let is_whole =
            |other: &ZeroSet| (other.quantity, other.order, other.of) == (set.quantity, set.order, Zeros::Largest);
        let mut mark = |stop: &BigRational, whole: bool, how: &str| {
            let Some(what) = vanishing(set, whole) else { return false };
            let (all, any_whole) = marks.entry(stop.clone()).or_default();
            all.push(format!("{what}{how}"));
            *any_whole |= whole;
            true
        };
        for value in &set.at {
            mark(value, sets().any(|other| is_whole(other) && other.at.contains(value)), "");
        }
        for ends in &set.irrational {
            let (stop, whole) = (rounded(ends), sets().any(|other| is_whole(other) && other.irrational.contains(ends)));
            if mark(&stop, whole, " (at an irrational angle, rounded here)") {
                rounded_stops.insert(stop);
            }
        }
    }
    let mut values = vec![now.clone()];
    let mut value = low.clone();
    while value <= *high {
        values.push(value.clone());
        value += step;
    }
    let of_grid: BTreeSet<BigRational> = values.iter().cloned().collect();
    let is_of_grid = |value: &BigRational| of_grid.contains(value);
    values.extend(marks.keys().cloned());
    values.sort();
    values.dedup();
    let place = |value: &BigRational| values.binary_search(value).unwrap_or_default();
    let judged = |set: &ZeroSet| match set.of {
        Zeros::Direct | Zeros::Reverse | Zeros::Largest => true,
        Zeros::Along | Zeros::Across => false,
    };
    let judged_sets = || sets().filter(|set| judged(set));
    let (complete, all_rational) =
        (judged_sets().all(|set| set.complete), judged_sets().all(|set| set.irrational.is_empty()));
    let note = match (zeros.is_empty(), complete, all_rational) {
        (true, ..) => "It changes how large things are; no exact zero depends on it.",
        (false, true, true) => "The marks are exact and are all the zeros in the range.",
        (false, true, false) => "The marks are all the zeros in the range: exact, or ≈ where the angle is irrational.",
        (false, false, _) => "The marks are exact; there may be others.",
    };
    // A stop of the grid, or the value of the file, is what it is, whatever vanishes beside it.
    let told = |value: &BigRational| match rounded_stops.contains(value) && !is_of_grid(value) {
        true => format!("≈ {}", shown(value)),
        false => shown(value),
    };
    Slider {
        key: key.to_owned(),
        label,
        at: place(now),
        marks: marks.into_iter().map(|(value, (what, whole))| Mark { stop: place(&value), what, whole }).collect(),
        stops: values.iter().map(|value| Stop { value: exact_number(value), shown: told(value) }).collect(),
        note: note.to_owned(),
    }
}

/// The middle of two ends in the unit of a slider, to three places.
fn rounded([low, high]: &[BigRational; 2]) -> BigRational {
    let places = integer(1000);
    ((low + high) / integer(2) * &places).round() / places
}

/// `order 2: force`, `order 2: direct force`; nothing of a part of what vanishes whole, nor of directions.
fn vanishing(set: &ZeroSet, whole: bool) -> Option<String> {
    let quantity = set.quantity.name();
    match (set.of, whole) {
        (Zeros::Largest, _) => Some(format!("order {}: {quantity}", set.order)),
        (Zeros::Direct, false) => Some(format!("order {}: direct {quantity}", set.order)),
        (Zeros::Reverse, false) => Some(format!("order {}: reverse {quantity}", set.order)),
        (Zeros::Direct | Zeros::Reverse, true) | (Zeros::Along | Zeros::Across, _) => None,
    }
}

/// An angle of a file in degrees, where it has no unknowns.
fn degrees(written: &str) -> Option<BigRational> {
    file::parse_angle(written).ok().map(|turns| turns * integer(360))
}
