//! Which tables show a sweep? Where each vector vanishes, the least and the greatest values, every point.

use super::amounts::{self, Side, number_of, place_cells, place_headings, size, unit};
use super::findings::Finding;
use super::observed;
use super::plots::amplitudes;
use super::sentences::dead_centres;
use crate::engine::DOES_NOT_EXIST;
use crate::page::{Block, Number, Table, Text, Unit, number, phrase};
use crate::proof::Planar;
use crate::report::texts::sweep as text;
use crate::sweep::{Parameter, Sweep, SweptEngine, ZeroSet, Zeros};

/// A row for each order and quantity that does not vanish everywhere: where each vector does.
pub(super) fn zeros(parameter: &Parameter, sets: &[ZeroSet]) -> Table {
    let mut table = Table::new(["Order", "Quantity"].into_iter().chain(Zeros::ALL.map(Zeros::name)));
    for of in sets.chunk_by(|a, b| (a.order, a.quantity) == (b.order, b.quantity)) {
        if of.iter().all(|set| set.exists && set.everywhere) {
            continue;
        }
        let first = [of[0].order.into(), of[0].quantity.name().into()];
        table.push(first.into_iter().chain(of.iter().map(|set| zero_cell(parameter, set))).collect());
    }
    table
}

fn zero_cell(parameter: &Parameter, set: &ZeroSet) -> Text {
    if !set.exists {
        return DOES_NOT_EXIST.into();
    }
    places_of_zeros(amounts::zeros(parameter, &set.at, &set.irrational), set.everywhere, set.complete)
}

/// Where something vanishes, in a cell.
pub(super) fn places_of_zeros(places: Vec<Text>, everywhere: bool, complete: bool) -> Text {
    let is_empty = places.is_empty();
    let at = || Text::joined(places, ", ");
    match (everywhere, complete, is_empty) {
        (true, ..) => "everywhere".into(),
        (_, true, true) => "never".into(),
        (_, true, false) => at(),
        (_, false, true) => "not solved".into(),
        (_, false, false) => phrase!("{} at least", at()),
    }
}

/// The least and the greatest value of each order, and where they are.
pub(super) fn extremes(sweep: &Sweep, findings: &[Finding]) -> Table {
    Table::of(findings)
        .column("Order", |finding| finding.order)
        .column("Largest in a revolution", |finding| in_unit(sweep, finding.quantity))
        .column("Greatest", |finding| size(sweep, finding.quantity, finding.greatest.amplitude))
        .column("at", |finding| finding.greatest.places(sweep))
        .column("Least", |finding| size(sweep, finding.quantity, finding.least.amplitude))
        .column("at", |finding| finding.least.places(sweep))
        .done()
}

fn in_unit(sweep: &Sweep, quantity: Planar) -> Text {
    match quantity {
        Planar::Moment => phrase!("moment in {}", unit(sweep, quantity)),
        Planar::Force => phrase!("force in {}", unit(sweep, quantity)),
    }
}

/// Every point: a table of each order that is not zero everywhere, then of what else changes.
pub(super) fn points(sweep: &Sweep) -> Vec<Block> {
    let mut folds = Vec::new();
    for quantity in Planar::BOTH {
        let tables = sweep.orders.iter().enumerate().filter_map(|(index, &order)| {
            let has_value =
                |point| amplitudes(point, index, quantity).is_some_and(|amplitudes| !amplitudes.largest.vanishes);
            let about = text::amplitudes(order, unit(sweep, quantity));
            let table = sweep.points.iter().any(has_value).then(|| of_order(sweep, quantity, index))?;
            Some([Block::Paragraph(about), table.into()])
        });
        let tables: Vec<Block> = tables.flatten().collect();
        let summary = text::amplitudes_at_points(quantity, sweep.points.len());
        folds.extend((!tables.is_empty()).then(|| Block::folded(summary, tables)));
    }
    let others = others(sweep);
    if others.header.len() > sweep.parameters.len() {
        let summary = text::others_at_points(sweep.points.len());
        folds.push(Block::folded(summary, vec![others.into()]));
    }
    folds.extend(observed::table(sweep).map(|table| {
        let summary = text::values_at_points(sweep.points.len());
        Block::folded(summary, vec![table.into()])
    }));
    folds
}

fn of_order(sweep: &Sweep, quantity: Planar, index: usize) -> Table {
    let names = ["largest", "smallest", "along", "across"].map(Text::from);
    let mut table = Table::new(place_headings(sweep).chain(names));
    let cell = |part| size(sweep, quantity, part);
    for point in &sweep.points {
        let parts = amplitudes(point, index, quantity).map(|a| [a.largest, a.smallest, a.along, a.across].map(cell));
        table.push(place_cells(point).chain(parts.unwrap_or_else(|| [(); 4].map(|()| "–".into()))).collect());
    }
    table
}

/// Firing, counterweights and size: the columns in which some point has a value.
fn others(sweep: &Sweep) -> Table {
    let mut columns: Vec<(Text, Vec<Option<Text>>)> = Vec::new();
    let mut add = |heading: Text, cell: &dyn Fn(&SweptEngine) -> Option<Text>| {
        columns.push((heading, sweep.points.iter().map(cell).collect()));
    };
    add("Firing intervals".into(), &|point| {
        let evenness = point.evenness.as_ref()?;
        Some(phrase!("{} to {}", number::turns(&evenness.shortest), number::turns(&evenness.longest)))
    });
    add("longest less shortest".into(), &|point| Some(number::turns(&point.evenness.as_ref()?.unevenness()).into()));
    if sweep.dead_centres_apart {
        add("Top dead centres apart by".into(), &|point| {
            let [least, most] = dead_centres(point)?.map(Text::figures);
            Some(phrase!("≈ {}° to ≈ {}°", least, most))
        });
    }
    match sweep.points.iter().all(|point| point.kilograms.is_some()) {
        true => add(phrase!("Counterweight in {} at the crank radius", Unit::KILOGRAM), &|point| {
            let (part, kilograms) = point.counterweight.zip(point.kilograms)?;
            Some(if part.vanishes { Text::zero() } else { Text::measured(part.value * kilograms, Unit::KILOGRAM) })
        }),
        false => add("Counterweight in $m r$".into(), &|point| point.counterweight.map(number_of)),
    }
    let metres = |point: &SweptEngine| point.envelope?.metres;
    let in_millimetres = sweep.points.iter().all(|point| metres(point).is_some());
    for (in_units, in_radii, side) in SIDES {
        let heading = if in_millimetres { phrase!(in_units, Unit::MILLIMETRE) } else { in_radii.into() };
        add(heading, &|point| {
            let size = side(&point.envelope?)?;
            Some(match in_millimetres {
                true => Text::measured(size * metres(point)? * 1000.0, Unit::MILLIMETRE),
                false => Number::Decimal(size).into(),
            })
        });
    }
    columns.retain(|(_, cells)| cells.iter().any(Option::is_some));
    let mut table = Table::new(place_headings(sweep).chain(columns.iter().map(|(heading, _)| heading.clone())));
    for (index, point) in sweep.points.iter().enumerate() {
        let cells = columns.iter().map(|(_, cells)| Text::or_dash(cells[index].clone()));
        table.push(place_cells(point).chain(cells).collect());
    }
    table
}

/// The sides of what an engine fits into.
const SIDES: [(&str, &str, Side); 3] = [
    ("Length in {}", "Length in $r$", |envelope| envelope.length),
    ("Width in {}", "Width in $r$", |envelope| Some(envelope.breadth)),
    ("Height in {}", "Height in $r$", |envelope| Some(envelope.height)),
];
