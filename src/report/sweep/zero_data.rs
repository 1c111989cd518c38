//! Which columns hold where a sweep vanishes? A row a value, exact, of each vector and of each firing star.

use num_rational::BigRational;

use crate::numbers::float;
use crate::report::data::Filling;
use crate::report::data::exact_number;
use crate::sweep::Sweep;
use crate::table::{Table, Unit};

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
    let mut table = Filling::new("sweep.zeros", rows);
    table.words("quantity", |row| Some(row.quantity.to_owned()));
    table.whole("order", |row| (row.halves / 2) as usize);
    table.words("of", |row| Some(row.of.to_owned()));
    table.truth("exists", |row| Some(row.exists));
    with_values(sweep, table)
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
    let mut table = Filling::new("sweep.firing_zeros", rows);
    table.exact("order", Unit::NONE, |row| Some(exact_number(&BigRational::new(row.halves.into(), 2.into()))));
    table.truth("fires", |row| Some(row.exists));
    with_values(sweep, table)
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

fn with_values(sweep: &Sweep, mut table: Filling<Zero>) -> Table {
    let name = sweep.parameters.first().map(|parameter| parameter.column()).unwrap_or_default();
    table.truth("everywhere", |row| Some(row.everywhere));
    table.truth("complete", |row| Some(row.complete));
    table.decimal(("{parameter}", &name), Unit::NONE, |row| row.at.as_ref().map(At::decimal));
    table.exact(("{parameter}_exact", &name), Unit::NONE, |row| {
        row.at.as_ref().and_then(At::exact).as_ref().map(exact_number)
    });
    table.done()
}
