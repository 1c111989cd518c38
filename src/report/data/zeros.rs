//! Which columns hold where a sweep vanishes? A row a value, exact, of each vector and of each firing star.

use num_rational::BigRational;

use super::cells::{decimals, exact, truths, whole, words};
use super::sweep::EXACT;
use crate::numbers::float;
use crate::sweep::Sweep;
use crate::table::{Column, Table, Unit};

/// A value at which something vanishes, or none where it never does, or everywhere.
struct Zero {
    quantity: &'static str,
    /// The order, in halves.
    halves: u32,
    of: &'static str,
    exists: bool,
    everywhere: bool,
    complete: bool,
    at: Option<At>,
}

/// Where: exact, or the decimals of an angle that is no rational turn.
#[derive(Clone)]
enum At {
    Exact(BigRational),
    About(f64),
}

/// Where each vector vanishes.
pub(super) fn zeros(sweep: &Sweep) -> Table {
    let rows = sweep.zeros.iter().flatten().flat_map(|set| {
        spread(&set.at, &set.irrational).map(move |at| Zero {
            quantity: set.quantity.name(),
            halves: 2 * set.order,
            of: set.of.name(),
            exists: set.exists,
            everywhere: set.everywhere,
            complete: set.complete,
            at,
        })
    });
    let rows: Vec<Zero> = rows.collect();
    let table = Table::new(
        "zeros",
        "a value at which a vector vanishes; one row without a value where there is none, and no exact value at an angle that is no rational turn",
        rows.len(),
    )
    .with(Column::new("quantity", Unit::NONE, "force or moment", words(rows.iter().map(|row| row.quantity))))
    .with(Column::new("order", Unit::NONE, "the order k", whole(rows.iter().map(|row| row.halves / 2))))
    .with(Column::new(
        "of",
        Unit::NONE,
        "what vanishes: the direct or the reverse vector, all (both), the part along y or across it",
        words(rows.iter().map(|row| row.of)),
    ))
    .with(Column::new(
        "exists",
        Unit::NONE,
        "whether the engine has the order at all",
        truths(rows.iter().map(|row| Some(row.exists))),
    ));
    with_values(sweep, table, &rows)
}

/// Where each firing star does.
pub(super) fn firing_zeros(sweep: &Sweep) -> Table {
    let sets = sweep.firing.iter().flat_map(|firing| firing.zeros.iter().flatten());
    let rows = sets.flat_map(|set| {
        spread(&set.at, &set.irrational).map(move |at| Zero {
            quantity: "firing star",
            halves: set.order.halves(),
            of: "all",
            exists: set.fires,
            everywhere: set.everywhere,
            complete: set.complete,
            at,
        })
    });
    let rows: Vec<Zero> = rows.collect();
    let about = "a value at which a firing star vanishes; one row without a value where there is none, and no exact value at an angle that is no rational turn";
    let table = Table::new("firing_zeros", about, rows.len())
        .with(Column::new(
            "order",
            Unit::NONE,
            "the order of the gas torque, halves too: 3/2",
            exact(rows.iter().map(|row| Some(BigRational::new(row.halves.into(), 2.into())))),
        ))
        .with(Column::new(
            "fires",
            Unit::NONE,
            "whether the cylinders can fire as the file says somewhere in the range",
            truths(rows.iter().map(|row| Some(row.exists))),
        ));
    with_values(sweep, table, &rows)
}

/// Each value, or none where there is none.
fn spread<'a>(at: &'a [BigRational], irrational: &'a [[BigRational; 2]]) -> impl Iterator<Item = Option<At>> + use<'a> {
    let about =
        |[low, high]: &[BigRational; 2]| At::About(float(&((low + high) / BigRational::from_integer(2.into()))));
    let none = (at.is_empty() && irrational.is_empty()).then_some(None);
    let exact = at.iter().cloned().map(At::Exact);
    exact.chain(irrational.iter().map(about)).map(Some).chain(none)
}

impl At {
    fn decimal(&self) -> f64 {
        match self {
            At::Exact(at) => float(at),
            At::About(at) => *at,
        }
    }

    fn exact(&self) -> Option<BigRational> {
        match self {
            At::Exact(at) => Some(at.clone()),
            At::About(_) => None,
        }
    }
}

fn with_values(sweep: &Sweep, table: Table, rows: &[Zero]) -> Table {
    let name = sweep.parameters.first().map(|parameter| parameter.column()).unwrap_or_default();
    table
        .with(Column::new(
            "everywhere",
            Unit::NONE,
            "whether it vanishes at every value of the range",
            truths(rows.iter().map(|row| Some(row.everywhere))),
        ))
        .with(Column::new(
            "complete",
            Unit::NONE,
            "whether the values are proved to be all in the range; else they are those found",
            truths(rows.iter().map(|row| Some(row.complete))),
        ))
        .with(Column::named(
            "{parameter}",
            &[&name],
            Unit::NONE,
            "the value of the parameter, in the unit of the range",
            decimals(rows.iter().map(|row| row.at.as_ref().map(At::decimal))),
        ))
        .with(Column::named(
            "{parameter}_exact",
            &[&name],
            Unit::NONE,
            EXACT,
            exact(rows.iter().map(|row| row.at.as_ref().and_then(At::exact))),
        ))
}
