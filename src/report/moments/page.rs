//! What is on the page of external and guide-force moments, and on the terminal?

use super::{Amplitude, External, LAST_COLUMN, LAST_TWISTING, MomentsRow, MomentsStudy, order_of_firing};
use crate::engine::CycleOrder;
use crate::page::{Block, Document, Number, Piece, Table, Text, Unit, number, phrase};
use crate::report::calculation::inputs_table;
use crate::report::engine_cells;
use crate::report::mechanism_words;
use crate::report::rising;
use crate::report::texts::moments as text;
use crate::torque::GuideMoments;

/// The short answer.
pub(super) fn answer(study: &MomentsStudy) -> Document {
    let mut answer = Document::new("moments", text::title());
    answer.blocks.extend(tables(study));
    answer.push(text::conventions());
    answer
}

/// The page.
pub(super) fn page(study: &MomentsStudy) -> Document {
    text::Page {
        answer: Block::Answer(study.built().map(said).collect()).into(),
        tables: tables(study).into(),
        inputs: inputs(study).into(),
        conventions: text::conventions().into(),
    }
    .document()
}

/// The engines as they are built, those together that have something in common.
fn alike<'a, K: PartialEq>(
    study: &'a MomentsStudy,
    common: impl Fn(&'a MomentsRow) -> Option<K>,
) -> Vec<(K, Vec<&'a MomentsRow>)> {
    let mut all: Vec<(K, Vec<&MomentsRow>)> = Vec::new();
    for row in study.built() {
        let Some(common) = common(row) else { continue };
        match all.iter_mut().find(|(of_others, _)| *of_others == common) {
            Some((_, rows)) => rows.push(row),
            None => all.push((common, vec![row])),
        }
    }
    all
}

fn names(rows: &[&MomentsRow]) -> Text {
    Text::joined(rows.iter().map(|row| (&row.name).into()), ", ")
}

/// What the layouts give: one table for engines that are given alike, under their names where there are several tables.
fn inputs(study: &MomentsStudy) -> Vec<Block> {
    let tables = alike(study, |row| Some(&row.engine.dimensions().given));
    let are_several = tables.len() > 1;
    let of_alike = |(_, rows): (_, Vec<&MomentsRow>)| {
        let names = are_several.then(|| Block::Paragraph(phrase!("**{}**", names(&rows))));
        names.into_iter().chain([inputs_table(&rows[0].engine).into()]).collect::<Vec<_>>()
    };
    tables.into_iter().flat_map(of_alike).collect()
}

/// The largest external moment of an engine.
fn said(row: &MomentsRow) -> Text {
    let size = |moment: &External| moment.components.iter().flatten().copied().fold(0.0, f64::max);
    let largest = row.moments.iter().max_by(|one, other| size(one).total_cmp(&size(other)));
    match largest.filter(|moment| moment.components.iter().any(Option::is_some)) {
        None => text::all_vanish(&row.name),
        Some(moment) => {
            text::largest(&row.name, moment.order, Piece::Quantity(size(moment) / 1e3, Unit::KILONEWTON_METRE))
        }
    }
}

fn tables(study: &MomentsStudy) -> Vec<Block> {
    let mut blocks = vec![
        Block::Heading(1, "External moments".into()),
        external(study, Unit::KILONEWTON_METRE, |row| &row.moments, true).into(),
        text::with_counterweights().into(),
        Block::Heading(1, "External forces".into()),
    ];
    blocks.push(match study.rows.iter().any(|row| row.forces.iter().any(|force| force.components != [None; 2])) {
        true => external(study, Unit::KILONEWTON, |row| &row.forces, false).into(),
        false if study.rows.len() == 1 => text::no_forces().into(),
        false => text::no_forces_in_each().into(),
    });
    blocks.push(Block::Heading(1, "Guide-force moments".into()));
    let has_guides = study.rows.iter().any(|row| row.guides.is_ok());
    if has_guides {
        blocks.push(text::guides().into());
        let of_mechanisms = study.rows.iter().find_map(|row| mechanism_words::in_guides(&row.engine));
        blocks.extend(of_mechanisms.map(Block::Paragraph));
        blocks.push(guides(study, ("H, {}", LAST_COLUMN), |moments| moments.rocking).into());
        blocks.extend(of_firing(study).map(Block::from));
        blocks.push(guides(study, ("X, {}", LAST_TWISTING), |moments| moments.twisting).into());
        if study.rows.iter().any(|row| row.per_kilowatt().is_some()) {
            blocks.push(text::per_kilowatt().into());
        }
    }
    blocks.extend(without_guides(study));
    blocks
}

/// Which engines have no guide-force moments, and why: one line a reason, however many it holds for.
fn without_guides(study: &MomentsStudy) -> impl Iterator<Item = Block> {
    let reasons = alike(study, |row| row.guides.as_ref().err());
    reasons.into_iter().map(|(why, rows)| Block::Note(text::without_guides(names(&rows), Text::label(why.clone()))))
}

fn name(row: &MomentsRow) -> Text {
    if row.is_bare { phrase!("{}, without counterweights and shafts", &row.name) } else { (&row.name).into() }
}

/// In which order the cylinders fire, where the name of the engine is not that, and how evenly.
fn firing(row: &MomentsRow) -> Text {
    let evenly = engine_cells::firing(row.engine.firing());
    match row.engine.firing_order().filter(|order| row.name != order.as_str()) {
        Some(_) => phrase!("{}; {}", engine_cells::firing_order(&row.engine), evenly),
        None => evenly,
    }
}

fn amount(value: Amplitude, unit: Unit) -> Text {
    value.map_or_else(Text::zero, |value| Text::measured(value / 1e3, unit))
}

/// A row an engine: V and H of each order, those columns that are 0 in all engines omitted but for V.
fn external(study: &MomentsStudy, unit: Unit, of: fn(&MomentsRow) -> &[External], is_moment: bool) -> Table {
    let sign = if is_moment { "M{}{}, {}" } else { "F{}{}, {}" };
    let speed = |row: &MomentsRow| row.engine.dimensions().speed.as_ref().map_or_else(Text::default, number::given);
    let mut table = Table::of(&study.rows)
        .column("Engine", |row| name(row))
        .column("Cylinders", |row| engine_cells::cylinders(&row.engine))
        .column("Firing", |row| firing(row))
        .column(phrase!("Speed, {}", Unit::PER_MINUTE), |row| speed(row));
    for (place, order) in super::ORDERS.into_iter().enumerate() {
        for (component, letter) in ["V", "H"].into_iter().enumerate() {
            let value = |row: &MomentsRow| of(row).get(place).and_then(|one| one.components[component]);
            let is_there = component == 0 || study.rows.iter().any(|row| value(row).is_some());
            let head = phrase!(sign, order, Text::label(letter), unit);
            table = table.column_if(is_there, head, |row| amount(value(row), unit));
        }
    }
    let per_kilowatt = is_moment && study.rows.iter().any(|row| row.per_kilowatt().is_some());
    table
        .column_if(is_moment, phrase!("M1 with counterweights, {}", unit), |row| amount(row.countered, unit))
        .column_if(per_kilowatt, "M2V over power, N·m/kW", |row| -> Text {
            let is_zero = row.moments.iter().any(|moment| moment.order == 2 && moment.components[0].is_none());
            match row.per_kilowatt() {
                Some(_) if is_zero => Text::zero(),
                Some(value) => Number::Decimal(value).into(),
                None => "–".into(),
            }
        })
        .done()
}

/// The engines as they are built that have guide-force moments.
fn with_guides(study: &MomentsStudy) -> impl Iterator<Item = &MomentsRow> {
    study.built().filter(|row| row.guides.is_ok())
}

/// H at one, two and three times the firing frequency, where it is largest; none where no engine fires evenly.
fn of_firing(study: &MomentsStudy) -> Option<Table> {
    let unit = Unit::KILONEWTON_METRE;
    let even = with_guides(study).filter_map(|row| Some((row, order_of_firing(&row.engine)?)));
    let mut table = Table::of(even)
        .column(phrase!("H at the firing frequency, {}", unit), |(row, _)| name(row))
        .column("Order", |(_, order)| Text::label(order.to_string()));
    for (times, head) in [(1, "1 ×"), (2, "2 ×"), (3, "3 ×")] {
        table = table.column(head, |(row, order)| {
            let moments = CycleOrder::of_halves(times * order.halves()).and_then(|order| row.guide(order));
            moments.map_or_else(|| "–".into(), |moments| amount(moments.rocking, unit))
        });
    }
    table.done_if_any()
}

/// A row an engine, a column an order that some engine has, up to the last column and this order.
fn guides(study: &MomentsStudy, (head, last): (&'static str, u32), of: fn(&GuideMoments) -> Amplitude) -> Table {
    let rows = || with_guides(study);
    let mut orders =
        rising(rows().flat_map(|row| row.guides.iter().flat_map(|(all, _)| all.iter().map(|one| one.order))));
    let has_any = |order: CycleOrder| rows().any(|row| row.guide(order).and_then(of).is_some());
    orders.retain(|order| match order.halves() <= 2 * LAST_COLUMN {
        true => order.is_whole() || has_any(*order),
        false => order.halves() == 2 * last && has_any(*order),
    });
    let mut table = Table::of(rows()).column(phrase!(head, Unit::KILONEWTON_METRE), |row| name(row));
    for order in orders {
        table = table.column(Text::label(order.to_string()), |row| {
            row.guide(order).map_or_else(|| "–".into(), |moments| amount(of(moments), Unit::KILONEWTON_METRE))
        });
    }
    table.done()
}
