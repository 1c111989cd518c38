//! What does a layout file hold? TOML: general keys, then one form of engine.

use std::collections::BTreeMap;
use std::ops::Range;

use serde::Deserialize;
use serde_spanned::Spanned;
use toml::de::DeTable;

use super::articulated_keys;
use super::asked::{check_values, cycle, effects, orders, threshold, values};
use super::balancer_keys;
use super::bearings;
use super::convention_keys;
use super::counterweight_keys;
use super::crankshaft_keys;
use super::cylinder_keys;
use super::error::{LayoutError, built};
use super::file_resolver::FileResolver;
use super::firing_order::{self, FiringOrder};
use super::firing_throws;
use super::flywheel_keys;
use super::forms::{self, Expanded};
use super::gas_keys;
use super::gas_layers;
use super::geared_forms;
use super::geared_keys;
use super::kind::Kind;
use super::known_firing;
use super::mechanism_keys;
use super::mounting_keys;
use super::narrow;
use super::quantities;
use super::shared_keys::SharedKeys;
use super::title_block_keys;
use super::torsion_keys;
use super::written::{Table, Text, place, read_table};
use crate::engine::{Crankshaft, Dimensions, Draft, Effects, Engine, Family, LengthUnit, ReferencePlane};
use crate::text::Untrusted;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    title: Option<Text>,
    source: Option<Text>,
    orders: Option<Spanned<Vec<Text>>>,
    above: Option<Text>,
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
    gas: Option<Spanned<Table<gas_layers::Keys>>>,
    flywheel: Option<Table<flywheel_keys::Keys>>,
    torsion: Option<Spanned<Table<torsion_keys::Keys>>>,
    block: Option<Spanned<Table<mounting_keys::BlockKeys>>>,
    mount: Option<Spanned<Vec<Spanned<Table<mounting_keys::MountKeys>>>>>,
    values: Option<BTreeMap<String, Text>>,
    cylinder: Option<Spanned<Vec<Spanned<Table<cylinder_keys::Keys>>>>>,
    inline: Option<Spanned<Table<forms::Inline>>>,
    vee: Option<Spanned<Table<forms::Vee>>>,
    flat: Option<Spanned<Table<forms::Flat>>>,
    boxer: Option<Spanned<Table<forms::Boxer>>>,
    fan: Option<Spanned<Table<forms::Fan>>>,
    vr: Option<Spanned<Table<narrow::Vr>>>,
    w: Option<Spanned<Table<narrow::W>>>,
    radial: Option<Spanned<Table<forms::Radial>>>,
    opposed_piston: Option<Spanned<Table<geared_forms::OpposedPiston>>>,
    u: Option<Spanned<Table<geared_forms::Pair>>>,
    square_four: Option<Spanned<Table<geared_forms::SquareFour>>>,
    h: Option<Spanned<Table<geared_forms::Pair>>>,
    delta: Option<Spanned<Table<geared_forms::Delta>>>,
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
/// # use crankstar_kernel as crankstar;
/// let i4 = crankstar::file::parse("i4.toml", "inline.throws = [0, 180, 180, 0]").unwrap();
/// assert_eq!(i4.cylinders().len(), 4);
/// assert_eq!(i4.arm(&i4.cylinders()[0]).to_string(), "3/2");
/// ```
///
/// # Errors
/// The first mistake, with its place and what would be right; an unknown without a value is one.
pub fn parse(name: &str, source: &str) -> Result<Engine, LayoutError> {
    parse_beside(name, source, FileResolver::nothing())
}

/// The same of a layout that may name a file beside itself, which `beside` reads.
///
/// # Errors
/// The first mistake, with its place in the file where it is, and what would be right.
pub fn parse_beside(name: &str, source: &str, beside: FileResolver<'_>) -> Result<Engine, LayoutError> {
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
    parse_layout_beside(name, source, FileResolver::nothing())
}

/// The same of a layout that may name a file beside itself, a table of pressures, which `beside` reads.
///
/// # Errors
/// The first mistake, with its place in the file where it is, and what would be right.
pub fn parse_layout_beside(name: &str, source: &str, beside: FileResolver<'_>) -> Result<Layout, LayoutError> {
    let file = Kind::Layout.read::<File>(source);
    let layout = file.and_then(|file| layout(name, source, file, beside));
    layout.map_err(|error| error.in_file(name, source))
}

/// Reads the tables of a layout file, whose text `source` is, numbers as texts.
pub(super) fn read_layout(
    name: &str,
    source: &str,
    table: Spanned<DeTable<'_>>,
    beside: FileResolver<'_>,
) -> Result<Layout, LayoutError> {
    let file = read_table::<File>(table).map_err(|error| Kind::Layout.refused(source, error));
    let layout = file.and_then(|file| layout(name, source, file, beside));
    layout.map_err(|error| error.in_file(name, source))
}

fn layout(name: &str, source: &str, file: File, beside: FileResolver<'_>) -> Result<Layout, LayoutError> {
    let cycle = file.cycle.as_ref().map(cycle).transpose()?;
    let convention = convention_keys::read(file.rotation.as_ref(), file.seen_from.as_ref())?;
    let above =
        SharedKeys { order: file.firing_order.as_ref(), angles: file.firing_angles.as_ref(), cycle, convention };
    let mut expanded = expand(&file, &above)?;
    let faster = geared_keys::faster(geared_keys::several(file.crankshaft.as_ref()));
    if let Some(span) = faster.and(above.order.and_then(place).or_else(|| above.angles.and_then(place))) {
        let message = "when cylinders fire, in an engine with a crankshaft that turns faster than the first";
        let right = "leave it out: it is known where all crankshafts turn equally fast so far";
        return Err(LayoutError::new(message, right, Some(span)));
    }
    convention_keys::turn(&mut expanded.cylinders, &mut expanded.geared, convention);
    firing_throws::follow(&mut expanded, &above)?;
    let dimensions = dimensions(&file, &mut expanded)?;
    let geared_cranks = geared_keys::placed(&expanded.geared, &dimensions)?;
    let mut length_unit = expanded.length_unit;
    let values = values(&file.values, &mut length_unit)?;
    let plane = file.reference_plane.as_ref().map(|text| quantities::length(text, &mut length_unit)).transpose()?;
    let lengths = || file.reference_plane.iter().chain(file.values.iter().flat_map(|values| values.values()));
    let among_spacings = match length_unit == LengthUnit::Metre && !expanded.positions_given {
        true => lengths().find(|text| quantities::has_unit(text)).map(quantities::among_spacings),
        false => None,
    };
    let gas = file
        .gas
        .as_ref()
        .map(|table| gas_keys::read(table, &expanded.cylinders, cycle, file.articulated.is_some(), beside))
        .transpose()?;
    let given_bearings = file.bearings.as_ref();
    let bearings = given_bearings.map(|list| bearings::read(list, &mut length_unit, expanded.positions_given));
    let draft = Draft {
        title: file
            .title
            .as_ref()
            .map_or_else(|| Untrusted::new(name), |title| beside.title(title.get_ref().untrusted())),
        source: file.source.as_ref().map(|source| source.get_ref().untrusted()),
        form: expanded.form,
        convention,
        cylinders: expanded.cylinders,
        // How fast they turn is said once no angle or length is open.
        geared_cranks: geared_cranks.iter().map(|crank| crank.clone().turning(1)).collect(),
        reference_plane: plane.map_or(ReferencePlane::Middle, ReferencePlane::Named),
        length_unit,
        positions_given: expanded.positions_given,
        orders: file.orders.as_ref().map_or_else(|| Ok(Vec::new()), orders)?,
        above: file.above.as_ref().map(threshold).transpose()?,
        cycle,
        firing: None,
        open_firing: None,
        gas,
        misfire: None,
        flywheel: file.flywheel.as_ref().map_or_else(|| Ok(Default::default()), |table| table.0.read())?,
        bearings: bearings.transpose()?.unwrap_or_default(),
        dimensions,
        crankshaft: Crankshaft::default(),
        torsion: None,
        mounting: mounting_keys::read(file.block.as_ref(), file.mount.as_ref(), convention)?,
        effects: file.effects.as_deref().map_or(Ok(Effects::default()), effects)?,
        title_block: file.document.as_ref().map_or_else(Default::default, |table| table.0.read()),
        file: Untrusted::new(source),
    };
    let family = built(draft.build())?;
    check_values(&file.values, &family)?;
    if let Some(error) = among_spacings {
        return Err(error);
    }
    if let Some(speed) = faster.filter(|_| !family.unknowns().is_empty()) {
        let message = "a crankshaft that turns faster than the first, in an engine whose angles or positions are open";
        return Err(LayoutError::new(message, "write numbers in place of the unknowns", place(speed)));
    }
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
            let message = "a torsional model in an engine whose angles or positions are open";
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
    if faster.is_some() {
        engine = built(Draft { geared_cranks, ..engine.into_draft() }.build())?;
    }
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
        let torsion = Some(torsion_keys::read(table, &engine)?);
        engine = built(Draft { torsion, ..engine.into_draft() }.build())?;
    }
    let firing = if faster.is_some() { None } else { known_firing::read(&above, &values, &engine)? };
    if let Some(firing) = firing {
        engine = built(Draft { firing: Some(firing), ..engine.into_draft() }.build())?;
    }
    let symbolic = (!family.unknowns().is_empty()).then(|| Box::new(family));
    Ok(Layout::Known(Box::new(engine), symbolic))
}

/// What the file says of crank, rods, masses and speed.
fn dimensions(file: &File, expanded: &mut Expanded) -> Result<Dimensions, LayoutError> {
    let tables = file.cylinder.iter().flat_map(|tables| tables.get_ref());
    let masses_given = tables.into_iter().any(|table| table.get_ref().0.reciprocating_mass.is_some());
    let mut dimensions = match &file.mechanism {
        Some(table) => table.0.read(&mut expanded.cylinders, masses_given, expanded.pin_offsets.as_ref())?,
        None => {
            expanded.pin_offsets.as_ref().map_or(Ok(()), mechanism_keys::no_offset_without_rod)?;
            Dimensions::default()
        }
    };
    if let Some(text) = &file.speed {
        let (speed, given) = mechanism_keys::speed(text)?;
        dimensions.speed = Some(speed);
        dimensions.given.insert(0, given);
    }
    Ok(dimensions)
}

/// How far the banks of its forms are apart along the crankshaft.
fn bank_offsets(file: &File) -> Vec<&Text> {
    let vee = file.vee.iter().filter_map(|form| form.get_ref().0.bank_offset.as_ref());
    let flat = file.flat.iter().filter_map(|form| form.get_ref().0.bank_offset.as_ref());
    let w = file.w.iter().filter_map(|form| form.get_ref().0.bank_offset.as_ref());
    let fan = file.fan.iter().filter_map(|form| form.get_ref().0.bank_offsets.as_ref());
    vee.chain(flat).chain(w).chain(fan.flat_map(|list| list.get_ref())).collect()
}

/// The one form that the file uses, as cylinders.
fn expand(file: &File, above: &SharedKeys<'_>) -> Result<Expanded, LayoutError> {
    let mut forms: Vec<(Range<usize>, Result<Expanded, LayoutError>)> = Vec::new();
    let several = geared_keys::several(file.crankshaft.as_ref());
    if let Some(table) = several.first().filter(|_| file.cylinder.is_none()) {
        let right = "[[crankshaft]] goes with [[cylinder]] tables, which name theirs; a short form has its own, and takes [crankshaft]";
        return Err(LayoutError::new("crankshafts that no cylinder can name", right, place(table)));
    }
    forms.extend(file.cylinder.as_ref().map(|tables| (tables.span(), cylinder_keys::expand(tables, several, above))));
    forms.extend(file.inline.as_ref().map(|form| (form.span(), form.get_ref().0.expand(form.span(), above))));
    forms.extend(file.vee.as_ref().map(|form| (form.span(), form.get_ref().0.expand(form.span(), above))));
    forms.extend(file.flat.as_ref().map(|form| (form.span(), form.get_ref().0.expand(form.span(), above))));
    forms.extend(file.boxer.as_ref().map(|form| (form.span(), form.get_ref().0.expand(form.span(), above))));
    forms.extend(file.fan.as_ref().map(|form| (form.span(), form.get_ref().0.expand(form.span(), above))));
    forms.extend(file.vr.as_ref().map(|form| (form.span(), form.get_ref().0.expand(form.span(), above))));
    forms.extend(file.w.as_ref().map(|form| (form.span(), form.get_ref().0.expand(form.span(), above))));
    forms.extend(file.radial.as_ref().map(|form| (form.span(), form.get_ref().0.expand(above))));
    forms.extend(file.opposed_piston.as_ref().map(|form| (form.span(), form.get_ref().0.expand(above.convention))));
    forms.extend(file.u.as_ref().map(|form| (form.span(), form.get_ref().0.side_by_side(above.convention))));
    forms.extend(file.square_four.as_ref().map(|form| (form.span(), form.get_ref().0.expand())));
    forms.extend(file.h.as_ref().map(|form| (form.span(), form.get_ref().0.flat(above.convention))));
    forms.extend(file.delta.as_ref().map(|form| (form.span(), form.get_ref().0.expand(above.convention))));
    let right = "one of [[cylinder]], [inline], [vee], [flat], [boxer], [fan], [vr], [w], [radial], [opposed_piston], [u], [square_four], [h] or [delta] says what the engine is";
    match (forms.pop(), forms.pop()) {
        (Some((span, only)), None) => match only? {
            form if form.length_unit == LengthUnit::Metre && !form.positions_given => {
                let with_unit = bank_offsets(file).into_iter().find(|text| quantities::has_unit(text));
                let right = "give the engine its spacing or positions";
                Err(with_unit.map_or_else(
                    || LayoutError::new("lengths without the distance of the cylinders", right, Some(span)),
                    quantities::among_spacings,
                ))
            }
            form => Ok(form),
        },
        (None, _) => Err(LayoutError::new("the file describes no engine", right, None)),
        (Some((span, _)), Some(_)) => {
            Err(LayoutError::new("the file describes more than one engine", "one form is enough", Some(span)))
        }
    }
}
