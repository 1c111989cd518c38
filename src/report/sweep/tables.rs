//! Which tables show a sweep? Where each vector vanishes, the least and the greatest values, every point.

use super::amounts::{self, number_of, place_cells, place_headings, size, unit};
use super::findings::Finding;
use super::observed;
use super::plots::amplitudes;
use crate::engine::DOES_NOT_EXIST;
use crate::page::{Block, Number, Table, Text, Unit, number, phrase};
use crate::proof::Planar;
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
    let zeros = amounts::zeros(parameter, &set.at, &set.irrational);
    let is_empty = zeros.is_empty();
    let at = || Text::joined(zeros, ", ");
    match (set.everywhere, set.complete, is_empty) {
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
            let about = phrase!("Order {}, in {}:", order, unit(sweep, quantity));
            let table = sweep.points.iter().any(has_value).then(|| of_order(sweep, quantity, index))?;
            Some([Block::Paragraph(about), table.into()])
        });
        let tables: Vec<Block> = tables.flatten().collect();
        let summary = phrase!("The {force|moment} at each of the {} points", quantity, sweep.points.len());
        folds.extend((!tables.is_empty()).then(|| Block::folded(summary, tables)));
    }
    let others = others(sweep);
    if others.header.len() > sweep.parameters.len() {
        let summary = phrase!("Firing, counterweights and size at each of the {} points", sweep.points.len());
        folds.push(Block::folded(summary, vec![others.into()]));
    }
    folds.extend(observed::table(sweep).map(|table| {
        let summary = phrase!("The values of other questions at each of the {} points", sweep.points.len());
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
        table.push(place_cells(point).chain(parts.unwrap_or_else(|| [(); 4].map(|()| DASH.into()))).collect());
    }
    table
}

/// What stands where a point has no value.
const DASH: &str = "–";

/// A column of the other values: its heading, and its cell at a point that has one.
type Column = (Text, Box<dyn Fn(&SweptEngine) -> Option<Text>>);

/// Firing, counterweights and size: the columns in which some point has a value.
fn others(sweep: &Sweep) -> Table {
    let mut columns = columns(sweep);
    columns.retain(|(_, cell)| sweep.points.iter().any(|point| cell(point).is_some()));
    let mut table = Table::new(place_headings(sweep).chain(columns.iter().map(|(heading, _)| heading.clone())));
    for point in &sweep.points {
        let cells = columns.iter().map(|(_, cell)| cell(point).unwrap_or_else(|| DASH.into()));
        table.push(place_cells(point).chain(cells).collect());
    }
    table
}

fn columns(sweep: &Sweep) -> Vec<Column> {
    let decimal = |value: f64| Text::from(Number::Decimal(value));
    let has = |known: fn(&SweptEngine) -> bool| sweep.points.iter().all(known);
    let firing: [Column; 2] = [
        (
            "Firing intervals".into(),
            Box::new(|point| {
                let evenness = point.evenness.as_ref()?;
                Some(phrase!("{} to {}", number::turns(&evenness.shortest), number::turns(&evenness.longest)))
            }),
        ),
        (
            "longest less shortest".into(),
            Box::new(|point| Some(number::turns(&point.evenness.as_ref()?.unevenness()).into())),
        ),
    ];
    let counterweight: Column = match has(|point| point.kilograms.is_some()) {
        true => (
            phrase!("Counterweight in {} at the crank radius", Unit::KILOGRAM),
            Box::new(move |point| {
                let (part, kilograms) = point.counterweight.zip(point.kilograms)?;
                Some(if part.vanishes { Text::zero() } else { Text::measured(part.value * kilograms, Unit::KILOGRAM) })
            }),
        ),
        false => ("Counterweight in $m r$".into(), Box::new(|point| point.counterweight.map(number_of))),
    };
    let in_millimetres = has(|point| point.envelope.is_some_and(|envelope| envelope.metres.is_some()));
    let names: [Text; 3] = match in_millimetres {
        true => [
            phrase!("Length in {}", Unit::MILLIMETRE),
            phrase!("Breadth in {}", Unit::MILLIMETRE),
            phrase!("Height in {}", Unit::MILLIMETRE),
        ],
        false => ["Length in $r$".into(), "Breadth in $r$".into(), "Height in $r$".into()],
    };
    let sides: [fn(&crate::sweep::Envelope) -> Option<f64>; 3] =
        [|envelope| envelope.length, |envelope| Some(envelope.breadth), |envelope| Some(envelope.height)];
    let side = |(name, side): (Text, fn(&crate::sweep::Envelope) -> Option<f64>)| -> Column {
        let cell = move |point: &SweptEngine| {
            let envelope = point.envelope?;
            let size = side(&envelope)?;
            Some(match in_millimetres {
                true => Text::measured(size * envelope.metres? * 1000.0, Unit::MILLIMETRE),
                false => decimal(size),
            })
        };
        (name, Box::new(cell))
    };
    firing.into_iter().chain([counterweight]).chain(names.into_iter().zip(sides).map(side)).collect()
}
