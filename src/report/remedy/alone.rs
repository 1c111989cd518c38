//! What can counterweights alone do? The first-order force over the part of the reciprocating masses that they balance.

use num_rational::BigRational;
use num_traits::Zero;

use super::super::plot::{Axis, Curve, Plot};
use crate::loads::{self, Scale};
use crate::numbers::float;
use crate::order;
use crate::page::number::{Amount, given};
use crate::page::{Block, Picture, Piece, Table, Text, Unit, phrase};
use crate::remedy::{Ellipse, Partial, Remedy};
use crate::report::texts::remedy as text;

/// Steps of the curves.
const STEPS: u32 = 40;
/// Balanced parts in the table, in percent.
const PARTS: [u32; 7] = [0, 20, 35, 50, 65, 80, 100];

/// Words, a picture and a table, where counterweights change the first order and one throw carries all, or a part is left
/// that they cannot reach.
pub(super) fn blocks(remedy: &Remedy) -> Vec<Block> {
    let Some(partial) = partial(remedy) else { return Vec::new() };
    let scale = loads::scale(remedy.subject.engine());
    let scale = scale.as_ref();
    let turning = !order::turning_masses(remedy.subject.engine()).is_empty();
    vec![
        Block::Paragraph(words(&partial, scale, turning)),
        picture(&partial, scale).into(),
        table(&partial, scale).into(),
    ]
}

fn words(partial: &Partial, scale: Option<&Scale>, turning: bool) -> Text {
    let at = |part: &BigRational| force(peak(&partial.ellipse(part)), scale);
    let (bare, half) = (at(&BigRational::zero()), at(&BigRational::new(1.into(), 2.into())));
    match partial.reverse.vanishes() {
        true => text::partial_balance_vanishing(turning, bare, half),
        false => text::partial_balance(turning, bare, half),
    }
}

/// A first-order force: newtons where the layout gives numbers.
fn force(amount: Amount, scale: Option<&Scale>) -> Text {
    let is_zero = amount.exact.as_ref().and_then(|form| form.as_rational()).is_some_and(|value| value.is_zero());
    match scale {
        _ if is_zero => Text::zero(),
        Some(scale) => Piece::Quantity(amount.decimal * scale.force(), Unit::NEWTON).into(),
        None => phrase!("{} $m\\,r\\,\\omega^2$", amount),
    }
}

fn peak(ellipse: &Ellipse) -> Amount {
    Amount { exact: ellipse.peak.clone(), decimal: ellipse.peak_decimal }
}

fn least(ellipse: &Ellipse) -> Amount {
    Amount { exact: ellipse.least.clone(), decimal: ellipse.least_decimal }
}

fn table(partial: &Partial, scale: Option<&Scale>) -> Table {
    let parts = PARTS.into_iter().map(|percent| BigRational::new(percent.into(), 100.into()));
    let rows = parts.map(|part| (given(&part), partial.ellipse(&part)));
    Table::of(rows)
        .column("Balanced part f", |(part, _)| part.clone())
        .column("Largest, in m r ω²", |(_, ellipse)| peak(ellipse))
        .column("Smallest, in m r ω²", |(_, ellipse)| least(ellipse))
        .column_if(scale.is_some(), "Largest force", |(_, ellipse)| force(peak(ellipse), scale))
        .column_if(scale.is_some(), "Smallest force", |(_, ellipse)| force(least(ellipse), scale))
        .done()
}

/// The largest and the smallest first-order force in a revolution over the balanced part.
fn picture(partial: &Partial, scale: Option<&Scale>) -> Picture {
    let curve = partial.curve(STEPS);
    let factor = scale.map_or(1.0, Scale::force);
    let points = |axis: fn(&Ellipse) -> f64| -> Vec<(f64, f64)> {
        curve.iter().map(|(part, ellipse)| (float(part), axis(ellipse) * factor)).collect()
    };
    let force = match scale.is_some() {
        true => Axis::linear("Force in {}").counted_in(Unit::NEWTON),
        false => Axis::linear("Force in m r ω²"),
    };
    let x = Axis::linear("Balanced part f of the reciprocating masses");
    let mut plot = Plot::new("First-order force", x, force);
    plot.curves.push(Curve::new(0, "largest in a revolution", points(|ellipse| ellipse.peak_decimal)));
    plot.curves.push(Curve::new(1, "smallest in a revolution", points(|ellipse| ellipse.least_decimal)));
    Picture::new("partial-balance", text::largest_and_smallest(), plot.figure())
}

/// The partial balance, where the first order is asked for and counterweights change it but leave a reverse vector, or
/// one throw carries all.
fn partial(remedy: &Remedy) -> Option<Partial> {
    let engine = remedy.subject.engine();
    let partial = Partial::new(engine)?;
    let tells = crate::engine::throws(engine).len() == 1 || !partial.reverse.vanishes();
    (tells && remedy.orders.contains(&1) && !partial.direct.vanishes()).then_some(partial)
}
