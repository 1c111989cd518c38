//! What does a layout file hold? TOML: general keys, then one form of engine.

use std::collections::BTreeMap;
use std::ops::Range;

use num_rational::BigRational;
use serde::Deserialize;
use serde_spanned::Spanned;
use toml::de::DeTable;

use super::above::{Above, Throws};
use super::articulated_keys;
use super::balancer_keys;
use super::bearings;
use super::beside::Beside;
use super::convention_keys;
use super::counterweight_keys;
use super::crankshaft_keys;
use super::error::LayoutError;
use super::firing_order::{self, FiringOrder};
use super::firing_throws;
use super::flywheel_keys;
use super::forms::{self, Expanded};
use super::gas_keys;
use super::geared_forms;
use super::geared_keys;
use super::known_firing;
use super::mechanism_keys;
use super::narrow;
use super::numbering::cylinder_name;
use super::quantities;
use super::title_block_keys;
use super::torsion_keys;
use super::written::{Table, Text, place, read, read_table};
use crate::engine::{
    BuildError, Crankshaft, Cycle, Cylinder, DELTA, Dimensions, Draft, Effects, Engine, Family, Form, LengthUnit,
    Linear, MOST_CYLINDERS, ORDERS, PHI, ReferencePlane,
};
use crate::text::Untrusted;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    title: Option<Text>,
    source: Option<Text>,
    orders: Option<Spanned<Vec<Text>>>,
    reference_plane: Option<Text>,
    rotation: Option<Text>,
    seen_from: Option<Text>,
    cycle: Option<Text>,
    firing_order: Option<Spanned<FiringOrder>>,
    firing_angles: Option<Spanned<Vec<Text>>>,
    speed: Option<Text>,
    bearings: Option<quantities::List>,
    effects: Option<Vec<Text>>,
    document: Option<Table<title_block_keys::Keys>>,
    mechanism: Option<Table<mechanism_keys::Keys>>,
    articulated: Option<Spanned<Table<articulated_keys::Keys>>>,
    crankshaft: Option<Spanned<geared_keys::Tables>>,
    counterweight: Option<Spanned<Vec<Spanned<Table<counterweight_keys::CounterweightKeys>>>>>,
    balancer: Option<Spanned<Vec<Spanned<Table<balancer_keys::Keys>>>>>,
    gas: Option<Spanned<Table<gas_keys::Keys>>>,
    flywheel: Option<Table<flywheel_keys::Keys>>,
    torsion: Option<Spanned<Table<torsion_keys::Keys>>>,
    values: Option<BTreeMap<String, Text>>,
    cylinder: Option<Spanned<Vec<Spanned<Table<CylinderTable>>>>>,
    inline: Option<Spanned<Table<forms::Inline>>>,
    vee: Option<Spanned<Table<forms::Vee>>>,
    flat: Option<Spanned<Table<forms::Flat>>>,
    boxer: Option<Spanned<Table<forms::Boxer>>>,
    fan: Option<Spanned<Table<forms::Fan>>>,
    vr: Option<Spanned<Table<narrow::Vr>>>,
    w: Option<Spanned<Table<narrow::W>>>,
    radial: Option<Spanned<Table<forms::Radial>>>,
    opposed_piston: Option<Spanned<Table<geared_forms::OpposedPiston>>>,
    u: Option<Spanned<Table<geared_forms::U>>>,
    square_four: Option<Spanned<Table<geared_forms::SquareFour>>>,
    h: Option<Spanned<Table<geared_forms::H>>>,
    delta: Option<Spanned<Table<geared_forms::Delta>>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CylinderTable {
    name: Option<Text>,
    throw: Option<Text>,
    bank: Text,
    position: Text,
    reciprocating_mass: Option<Text>,
    pin: Option<Text>,
    crankshaft: Option<Text>,
}

/// What a layout file describes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Layout {
    /// One engine, and the family that it is a member of where the file gives values to symbols.
    Known(Box<Engine>, Option<Box<Family>>),
    /// A family: some angle or position is left open.
    Open(Box<Family>),
}

/// Reads a layout file without unknowns.
///
/// `name` is the path that messages show, and the title where the file has none.
///
/// ```standalone_crate
/// let i4 = crankstar::file::parse("i4.toml", "inline.throws = [0, 180, 180, 0]").unwrap();
/// assert_eq!(i4.cylinders().len(), 4);
/// assert_eq!(i4.arm(&i4.cylinders()[0]).to_string(), "3/2");
/// ```
///
/// # Errors
/// The first mistake, with its place and what would be right; an unknown without a value is one.
pub fn parse(name: &str, source: &str) -> Result<Engine, LayoutError> {
    parse_beside(name, source, Beside::nothing())
}

/// The same of a layout that may name a file beside itself, which `beside` reads.
///
/// # Errors
/// The first mistake, with its place in the file where it stands, and what would be right.
pub fn parse_beside(name: &str, source: &str, beside: Beside<'_>) -> Result<Engine, LayoutError> {
    match parse_layout_beside(name, source, beside)? {
        Layout::Known(layout, _) => Ok(*layout),
        Layout::Open(family) => {
            let unknowns: Vec<&str> = family.unknowns().into_iter().collect();
            let message = format!("the layout leaves {} open", unknowns.join(", "));
            Err(LayoutError::new(message, "give them values below [values]", None).in_file(name, source))
        }
    }
}

/// Reads a layout file that may leave angles (`phi`, `delta`) and lengths (`a`, `b`, …) open.
///
/// # Errors
/// The first mistake, with its place and what would be right.
pub fn parse_layout(name: &str, source: &str) -> Result<Layout, LayoutError> {
    parse_layout_beside(name, source, Beside::nothing())
}

/// The same of a layout that may name a file beside itself, a table of pressures, which `beside` reads.
///
/// # Errors
/// The first mistake, with its place in the file where it stands, and what would be right.
pub fn parse_layout_beside(name: &str, source: &str, beside: Beside<'_>) -> Result<Layout, LayoutError> {
    let layout = read::<File>(source).and_then(|file| layout(name, source, file, beside));
    layout.map_err(|error| error.in_file(name, source))
}

/// Reads the tables of a layout file, whose text `source` is, numbers as texts.
pub(super) fn read_layout(
    name: &str,
    source: &str,
    table: Spanned<DeTable<'_>>,
    beside: Beside<'_>,
) -> Result<Layout, LayoutError> {
    let layout = read_table::<File>(table).and_then(|file| layout(name, source, file, beside));
    layout.map_err(|error| error.in_file(name, source))
}

fn layout(name: &str, source: &str, file: File, beside: Beside<'_>) -> Result<Layout, LayoutError> {
    let cycle = file.cycle.as_ref().map(cycle).transpose()?;
    let convention = convention_keys::read(file.rotation.as_ref(), file.seen_from.as_ref())?;
    let above = Above { order: file.firing_order.as_ref(), angles: file.firing_angles.as_ref(), cycle, convention };
    let mut expanded = expand(&file, &above)?;
    if !expanded.geared.is_empty() {
        convention_keys::of_one_crankshaft(file.rotation.as_ref().or(file.seen_from.as_ref()))?;
        let given = [
            ("gas", file.gas.as_ref().and_then(place)),
            ("main bearings", file.bearings.as_ref().and_then(place)),
            ("a shaft that twists", file.torsion.as_ref().and_then(place)),
        ];
        if let Some((what, span)) = given.into_iter().find(|(_, span)| span.is_some()) {
            let message = format!("{what} in an engine with several crankshafts");
            return Err(LayoutError::new(message, "leave it out: it is known of one crankshaft alone, as yet", span));
        }
    }
    if expanded.form.has_two_pistons_in_a_cylinder() {
        firing_order::without_pistons_of_their_own(above.order, above.angles)?;
    }
    convention_keys::turn(&mut expanded.cylinders, convention);
    firing_throws::follow(&mut expanded, &above)?;
    let dimensions = dimensions(&file, &mut expanded)?;
    let geared_cranks = geared_keys::placed(&expanded.geared, &dimensions, &mut expanded.cylinders)?;
    let mut length_unit = expanded.length_unit;
    let values = values(&file.values, &mut length_unit)?;
    let plane = file.reference_plane.as_ref().map(|text| quantities::length(text, &mut length_unit)).transpose()?;
    let gas = file.gas.as_ref().map(|table| gas_keys::read(table, &expanded.cylinders, cycle, beside)).transpose()?;
    let given_bearings = file.bearings.as_ref();
    let bearings = given_bearings.map(|list| bearings::read(list, &mut length_unit, expanded.positions_given));
    let draft = Draft {
        title: file.title.as_ref().map_or_else(|| Untrusted::new(name), |title| title.get_ref().untrusted()),
        source: file.source.as_ref().map(|source| source.get_ref().untrusted()),
        form: expanded.form,
        convention,
        cylinders: expanded.cylinders,
        geared_cranks,
        reference_plane: plane.map_or(ReferencePlane::Middle, ReferencePlane::Named),
        length_unit,
        positions_given: expanded.positions_given,
        orders: file.orders.as_ref().map_or_else(|| Ok(Vec::new()), orders)?,
        cycle,
        firing: None,
        open_firing: None,
        gas,
        flywheel: file.flywheel.as_ref().map_or_else(|| Ok(Default::default()), |table| table.0.read())?,
        bearings: bearings.transpose()?.unwrap_or_default(),
        dimensions,
        crankshaft: Crankshaft::default(),
        torsion: None,
        effects: file.effects.as_deref().map_or(Ok(Effects::default()), effects)?,
        title_block: file.document.as_ref().map_or_else(Default::default, |table| table.0.read()),
        file: Untrusted::new(source),
    };
    let family = built(draft.build())?;
    check_values(&file.values, &family)?;
    let turning = crankshaft_keys::Tables {
        crankshaft: file.crankshaft.as_ref().and_then(geared_keys::masses),
        counterweights: &file.counterweight,
        balancers: &file.balancer,
        values: &values,
    };
    let valued = if values.is_empty() { None } else { Some(built(family.with(&values))?) };
    let Some(engine) = valued.as_ref().unwrap_or(&family).only() else {
        if let Some(span) = turning.place() {
            return Err(LayoutError::new(
                "masses on the crankshaft in an engine whose angles or positions are open",
                "give the unknowns values below [values]",
                Some(span),
            ));
        }
        if let Some(list) = given_bearings {
            return Err(bearings::of_open_layout(list));
        }
        if let Some(table) = &file.articulated {
            return Err(articulated_keys::of_open_layout(table));
        }
        if let Some(table) = &file.torsion {
            let message = "a shaft that twists in an engine whose angles or positions are open";
            return Err(LayoutError::new(message, "give the unknowns values below [values]", place(table)));
        }
        let open = valued.unwrap_or(family);
        let said = firing_order::open_firing(above.order, above.angles, &values, &open)?;
        let open = match said {
            Some(said) => built(Draft { open_firing: Some(said), ..open.into_draft() }.build())?,
            None => open,
        };
        return Ok(Layout::Open(Box::new(open)));
    };
    let mut engine = built(engine)?;
    if let Some(table) = &file.articulated {
        if !family.unknowns().is_empty() {
            return Err(articulated_keys::of_open_layout(table));
        }
        engine = articulated_keys::read(table, engine)?;
    }
    if turning.place().is_some() {
        engine = turning.read(engine)?;
    }
    bearings::check_ends(given_bearings, &engine)?;
    if let Some(table) = &file.torsion {
        let torsion = Some(torsion_keys::read(table, engine.cylinders())?);
        engine = built(Draft { torsion, ..engine.into_draft() }.build())?;
    }
    let firing = match engine.form().has_two_pistons_in_a_cylinder() {
        true => None,
        false => known_firing::read(&above, &values, &engine)?,
    };
    if let Some(firing) = firing {
        engine = built(Draft { firing: Some(firing), ..engine.into_draft() }.build())?;
    }
    let symbolic = (!family.unknowns().is_empty()).then(|| Box::new(family));
    Ok(Layout::Known(Box::new(engine), symbolic))
}

/// What the keys do not keep from happening, in the words of the builder.
pub(super) fn built<E>(engine: Result<E, BuildError>) -> Result<E, LayoutError> {
    engine.map_err(|error| LayoutError::new(error.to_string(), "all that a file says has to fit together", None))
}

/// What the file says of crank, rods, masses and speed.
fn dimensions(file: &File, expanded: &mut Expanded) -> Result<Dimensions, LayoutError> {
    let tables = file.cylinder.iter().flat_map(|tables| tables.get_ref());
    let masses_given = tables.into_iter().any(|table| table.get_ref().0.reciprocating_mass.is_some());
    let mut dimensions = match &file.mechanism {
        Some(table) => table.0.read(&mut expanded.cylinders, masses_given, expanded.pin_offsets.as_ref())?,
        None => match &expanded.pin_offsets {
            None => Dimensions::default(),
            Some(list) => return Err(mechanism_keys::offset_without_rod(list)),
        },
    };
    if let Some(text) = &file.speed {
        let (speed, given) = mechanism_keys::speed(text)?;
        dimensions.speed = Some(speed);
        dimensions.given.insert(0, given);
    }
    Ok(dimensions)
}

fn effects(list: &[Text]) -> Result<Effects, LayoutError> {
    let mut effects = Effects::default();
    for text in list {
        match text.get_ref().0.as_str() {
            "torque" => effects.torque = true,
            "remedy" => effects.remedy = true,
            "gas" => effects.gas = true,
            "firing" => effects.firing = true,
            "torsion" => effects.torsion = true,
            other => {
                let right = "\"torque\", \"remedy\", \"gas\", \"firing\" or \"torsion\"";
                return Err(quantities::misread("effect", other, right.to_owned(), text));
            }
        }
    }
    Ok(effects)
}

/// The values that the file gives to its unknowns.
fn values(
    table: &Option<BTreeMap<String, Text>>,
    unit: &mut LengthUnit,
) -> Result<BTreeMap<String, BigRational>, LayoutError> {
    let value = |(name, text): (&String, &Text)| {
        let value = if name == PHI || name == DELTA {
            quantities::known_angle(text)?
        } else {
            let length = quantities::length(text, unit)?;
            let known = length.as_known().cloned();
            known.ok_or_else(|| quantities::misread("value", &text.get_ref().0, "a known length".to_owned(), text))?
        };
        Ok((name.clone(), value))
    };
    table.iter().flatten().map(value).collect()
}

/// A value for what does not occur is a mistake, in the name most likely.
fn check_values(table: &Option<BTreeMap<String, Text>>, family: &Family) -> Result<(), LayoutError> {
    let unknowns = family.unknowns();
    match table.iter().flatten().find(|(name, _)| !unknowns.contains(name.as_str())) {
        None => Ok(()),
        Some((name, text)) => {
            let known: Vec<&str> = unknowns.into_iter().collect();
            let right =
                if known.is_empty() { "it has no unknown".to_owned() } else { format!("it has {}", known.join(", ")) };
            Err(LayoutError::new(format!("the layout has no unknown `{name}`"), right, place(text)))
        }
    }
}

/// The one form that the file uses, as cylinders.
fn expand(file: &File, above: &Above<'_>) -> Result<Expanded, LayoutError> {
    let mut forms: Vec<(Range<usize>, Result<Expanded, LayoutError>)> = Vec::new();
    let several = geared_keys::several(file.crankshaft.as_ref());
    if let Some(table) = several.first().filter(|_| file.cylinder.is_none()) {
        let right = "[[crankshaft]] goes with [[cylinder]] tables, which name theirs; a short form has its own, and takes [crankshaft]";
        return Err(LayoutError::new("crankshafts that no cylinder can name", right, place(table)));
    }
    forms.extend(file.cylinder.as_ref().map(|tables| (tables.span(), general(tables, several, above))));
    forms.extend(file.inline.as_ref().map(|form| (form.span(), form.get_ref().0.expand(form.span(), above))));
    forms.extend(file.vee.as_ref().map(|form| (form.span(), form.get_ref().0.expand(form.span(), above))));
    forms.extend(file.flat.as_ref().map(|form| (form.span(), form.get_ref().0.expand(form.span(), above))));
    forms.extend(file.boxer.as_ref().map(|form| (form.span(), form.get_ref().0.expand(form.span(), above))));
    forms.extend(file.fan.as_ref().map(|form| (form.span(), form.get_ref().0.expand(form.span(), above))));
    forms.extend(file.vr.as_ref().map(|form| (form.span(), form.get_ref().0.expand(above.convention))));
    forms.extend(file.w.as_ref().map(|form| (form.span(), form.get_ref().0.expand(above.convention))));
    forms.extend(file.radial.as_ref().map(|form| (form.span(), form.get_ref().0.expand(above))));
    forms.extend(file.opposed_piston.as_ref().map(|form| (form.span(), form.get_ref().0.expand())));
    forms.extend(file.u.as_ref().map(|form| (form.span(), form.get_ref().0.expand())));
    forms.extend(file.square_four.as_ref().map(|form| (form.span(), form.get_ref().0.expand())));
    forms.extend(file.h.as_ref().map(|form| (form.span(), form.get_ref().0.expand())));
    forms.extend(file.delta.as_ref().map(|form| (form.span(), form.get_ref().0.expand())));
    let right = "one of [[cylinder]], [inline], [vee], [flat], [boxer], [fan], [vr], [w], [radial], [opposed_piston], [u], [square_four], [h] or [delta] says what the engine is";
    match (forms.pop(), forms.pop()) {
        (Some((_, only)), None) => only,
        (None, _) => Err(LayoutError::new("the file describes no engine", right, None)),
        (Some((span, _)), Some(_)) => {
            Err(LayoutError::new("the file describes more than one engine", "one form is enough", Some(span)))
        }
    }
}

fn general(
    list: &Spanned<Vec<Spanned<Table<CylinderTable>>>>,
    several: &[Spanned<Table<geared_keys::Keys>>],
    above: &Above<'_>,
) -> Result<Expanded, LayoutError> {
    let tables = list.get_ref();
    if tables.is_empty() || tables.len() > MOST_CYLINDERS {
        let message = format!("{} cylinders", tables.len());
        return Err(LayoutError::new(message, format!("between 1 and {MOST_CYLINDERS} are read"), place(list)));
    }
    let without = tables.iter().find(|table| table.get_ref().0.throw.is_none());
    let throws = match without {
        None => Throws::Listed,
        Some(_) if tables.iter().all(|table| table.get_ref().0.throw.is_none()) && above.firing_place().is_some() => {
            Throws::Follow { splits_given: false }
        }
        Some(table) => {
            let right =
                "every cylinder needs it; or leave out all of them, with a firing_order and its cycle above the tables";
            return Err(LayoutError::new("the key `throw` is missing", right, place(table)));
        }
    };
    let mut length_unit = LengthUnit::Spacing;
    let cranks = geared_keys::read(several)?;
    let cylinders = tables.iter().enumerate().map(|(index, spanned)| {
        let table = &spanned.get_ref().0;
        let pin = table.pin.as_ref().map_or(Ok(0), |pin| quantities::whole(pin, "number of the pin"))? as usize;
        let position = quantities::length(&table.position, &mut length_unit)?;
        let (throw, bank) = (quantities::optional_angle(&table.throw)?, quantities::angle(&table.bank)?);
        let crank = geared_keys::named(&cranks, table.crankshaft.as_ref(), || place(spanned))?;
        let throw = match cranks.get(crank) {
            Some((geared, phase)) => {
                geared_keys::equivalent(&throw.plus(&Linear::constant(phase.clone())), &bank, geared.sense)
            }
            None => throw,
        };
        let cylinder = Cylinder::new(throw, bank, position, pin);
        Ok(Cylinder {
            crank,
            name: table.name.as_ref().map_or(Ok((index + 1).to_string()), cylinder_name)?,
            reciprocating_mass: table
                .reciprocating_mass
                .as_ref()
                .map_or(Ok(BigRational::from_integer(1.into())), quantities::mass)?,
            ..cylinder
        })
    });
    let mut cylinders = cylinders.collect::<Result<Vec<_>, LayoutError>>()?;
    number_pins(&mut cylinders);
    check_names(&cylinders, tables)?;
    let geared = cranks.into_iter().map(|(geared, _)| geared).collect();
    let pin_offsets = None;
    Ok(Expanded { form: Form::General, cylinders, length_unit, positions_given: true, throws, pin_offsets, geared })
}

/// Cylinders that name no pin, which a file numbers from 1, share one where they stand at the same position of a crankshaft; then the pins
/// are numbered from 0 without gaps.
fn number_pins(cylinders: &mut [Cylinder<Linear, Linear>]) {
    let mut pins: BTreeMap<(usize, Linear), usize> = BTreeMap::new();
    for (index, cylinder) in cylinders.iter_mut().enumerate().filter(|(_, cylinder)| cylinder.pin == 0) {
        let place = (cylinder.crank, cylinder.position.clone());
        cylinder.pin = *pins.entry(place).or_insert(MOST_CYLINDERS + 1 + index);
    }
    let mut numbers: Vec<usize> = cylinders.iter().map(|cylinder| cylinder.pin).collect();
    numbers.sort_unstable();
    numbers.dedup();
    for cylinder in cylinders {
        cylinder.pin = numbers.partition_point(|&number| number < cylinder.pin);
    }
}

fn check_names(
    cylinders: &[Cylinder<Linear, Linear>],
    tables: &[Spanned<Table<CylinderTable>>],
) -> Result<(), LayoutError> {
    let mut seen = BTreeMap::new();
    for (index, cylinder) in cylinders.iter().enumerate() {
        if let Some(first) = seen.insert(&cylinder.name, index) {
            let message = format!("cylinders {} and {} have the same name `{}`", first + 1, index + 1, cylinder.name);
            return Err(LayoutError::new(message, "every cylinder needs a name of its own", place(&tables[index])));
        }
    }
    Ok(())
}

fn cycle(text: &Text) -> Result<Cycle, LayoutError> {
    match text.get_ref().0.as_str() {
        "four-stroke" => Ok(Cycle::FourStroke),
        "two-stroke" => Ok(Cycle::TwoStroke),
        other => Err(quantities::misread("cycle", other, "\"four-stroke\" or \"two-stroke\"".to_owned(), text)),
    }
}

fn orders(list: &Spanned<Vec<Text>>) -> Result<Vec<u32>, LayoutError> {
    let right = || format!("whole numbers from 1 to {}, such as [1, 2, 4, 6]", ORDERS.end());
    let mut orders = Vec::new();
    for text in list.get_ref() {
        let written = &text.get_ref().0;
        match written.parse() {
            Ok(order) if ORDERS.contains(&order) => orders.push(order),
            _ => return Err(quantities::misread("order", written, right(), text)),
        }
    }
    if orders.is_empty() {
        return Err(LayoutError::new("the list of orders is empty", right(), place(list)));
    }
    orders.sort_unstable();
    orders.dedup();
    Ok(orders)
}
