//! What does an order more, or a sample more, cost and buy beyond force, moment and torque of inertia? Bearings, and what has gas.

use super::methods;
use crate::accuracy::{self, PeakRow, Timing, measured};
use crate::engine::{CycleOrder, Engine};
use crate::journal::LoadPeak;
use crate::loads::{Missing, PeakMethod};
use crate::page::{Piece, Table, Text, Unit, phrase};
use crate::proof::Quantity;
use crate::report::texts::accuracy as text;
use crate::torque::{self, Peak};

/// A largest value by several methods.
#[derive(Clone, Debug)]
pub struct Further {
    /// Of what.
    pub load: FurtherLoad,
    /// The methods, the reference last.
    pub rows: Vec<PeakRow>,
    /// What a page counts it in.
    pub(in crate::report) unit: Unit,
    /// How many of these are one of the rows.
    pub(in crate::report) factor: f64,
}

/// What is largest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FurtherLoad {
    /// The load of a main bearing, of the masses.
    Bearing,
    /// The torque of gas and inertia.
    Torque,
    /// The load of a main bearing, of gas and masses.
    BearingWithGas,
}

impl FurtherLoad {
    /// All of them.
    pub const ALL: [FurtherLoad; 3] = [FurtherLoad::Bearing, FurtherLoad::Torque, FurtherLoad::BearingWithGas];

    /// Above it, with its λ.
    fn heading(self) -> &'static str {
        match self {
            FurtherLoad::Bearing => "Largest bearing load of inertia, {}",
            FurtherLoad::Torque => "Largest torque in magnitude, gas and inertia, {}",
            FurtherLoad::BearingWithGas => "Largest bearing load, gas and masses, {}",
        }
    }

    /// Above its largest values, with their unit.
    fn value(self) -> &'static str {
        match self {
            FurtherLoad::Bearing => "Peak in {}",
            FurtherLoad::Torque => "Largest torque in {}",
            FurtherLoad::BearingWithGas => "Largest load in {}",
        }
    }
}

/// Errors below this are those of the search for the peak.
const ROUNDING: f64 = 1e-9;

impl Further {
    /// Compares the methods; none where the layout does not ask for such a load, or lacks what it needs.
    ///
    /// # Errors
    /// What the layout lacks for the loads of its masses.
    pub(super) fn new(engine: &Engine, load: FurtherLoad, timing: Timing) -> Result<Option<Self>, Missing> {
        let newtons = |unit| move |rows| Further { load, rows, unit, factor: 1.0 };
        Ok(match load {
            FurtherLoad::Bearing => accuracy::bearings(engine, timing)?.map(|rows| {
                let (unit, factor) = methods::unit(engine, Quantity::FORCE);
                Further { load, rows, unit, factor }
            }),
            FurtherLoad::Torque => of_torque(engine, timing).map(newtons(Unit::NEWTON_METRE)),
            FurtherLoad::BearingWithGas => of_bearings_with_gas(engine, timing).map(newtons(Unit::NEWTON)),
        })
    }

    /// What the methods are, and what their errors mean.
    pub(super) fn how(&self) -> Text {
        match self.load {
            FurtherLoad::Bearing => text::bearing_loads(),
            FurtherLoad::Torque => text::torque(),
            FurtherLoad::BearingWithGas => text::bearing_loads_with_gas(),
        }
    }

    /// `Largest bearing load of inertia, λ 0.3`.
    pub(super) fn heading(&self, label: Text) -> Text {
        phrase!(self.load.heading(), label)
    }

    fn name(&self, method: PeakMethod) -> Text {
        let by_closed_form = self.load == FurtherLoad::Bearing;
        match method {
            PeakMethod::Orders(order) if by_closed_form => phrase!("orders up to {}", order.halves() / 2),
            PeakMethod::Orders(order) => phrase!("orders of the gas up to {}", Text::label(order.to_string())),
            PeakMethod::Samples(steps) if by_closed_form => phrase!("closed form, {} angles", steps),
            PeakMethod::Samples(steps) => phrase!("time law, {} angles a revolution", steps),
            PeakMethod::Refined if by_closed_form => "closed form, its largest value refined".into(),
            PeakMethod::Refined => "time law, its largest value refined".into(),
        }
    }

    /// A row per method, with the columns that some of them have.
    pub(super) fn table(&self) -> Table {
        let has = |of: fn(&PeakRow) -> bool| self.rows.iter().any(of);
        let (far, sure, timed) =
            (has(|row| row.farthest.is_some()), has(|row| row.bound.is_some()), has(|row| row.time.is_some()));
        let part = |part: Option<f64>| part.map_or_else(Text::default, |part| methods::power(part).into());
        Table::of(&self.rows)
            .column("Method", |row| self.name(row.method))
            .column(phrase!(self.load.value(), self.unit), |row| methods::to_digits(row.value * self.factor, self.unit))
            .column("Error", |row| error(row))
            .column_if(far, "Anywhere", |row| part(row.farthest))
            .column_if(sure, "Guaranteed", |row| part(row.bound))
            .column_if(timed, "Time", |row| row.time.map_or_else(Text::default, |time| methods::time(time).into()))
            .done()
    }

    /// The first order with which the largest value is within 0.1 %: guaranteed where there are guarantees; else it is, and so it is
    /// with every higher one that is compared.
    fn enough(&self) -> Option<CycleOrder> {
        let orders = self.rows.iter().filter_map(|row| match row.method {
            PeakMethod::Orders(order) => Some((order, row)),
            PeakMethod::Samples(_) | PeakMethod::Refined => None,
        });
        match self.load {
            FurtherLoad::Bearing => {
                let mut guaranteed = orders.filter(|(_, row)| row.bound.is_some_and(|bound| bound <= methods::USUAL));
                guaranteed.next().map(|(order, _)| order)
            }
            FurtherLoad::Torque | FurtherLoad::BearingWithGas => {
                orders.fold(None, |first, (order, row)| (row.error <= methods::USUAL).then(|| first.unwrap_or(order)))
            }
        }
    }

    /// The largest value, and the orders that have it.
    pub(super) fn answer(&self, label: Text) -> Text {
        let peak = self.rows.last().map_or(f64::NAN, |row| row.value) * self.factor;
        let (heading, peak) = (self.heading(label), Piece::Quantity(peak, self.unit));
        let is_of_gas = self.load != FurtherLoad::Bearing;
        match self.enough() {
            Some(order) if is_of_gas => text::enough_of_gas(heading, peak, order.to_string()),
            None if is_of_gas => text::none_enough_of_gas(heading, peak),
            Some(order) => text::enough_of_load(heading, peak, order.halves() / 2),
            None => text::none_enough_of_load(heading, peak),
        }
    }
}

/// The part of the largest value by which a method is off; nothing for the reference itself.
fn error(row: &PeakRow) -> Text {
    match row.method {
        PeakMethod::Refined => Text::default(),
        PeakMethod::Orders(_) | PeakMethod::Samples(_) if row.error < ROUNDING => {
            phrase!("below {}", methods::power_of_ten(-9))
        }
        PeakMethod::Orders(_) | PeakMethod::Samples(_) => methods::power(row.error).into(),
    }
}

/// The largest torque by all methods; none where the layout has no gas, or not all that its torque needs.
fn of_torque(engine: &Engine, timing: Timing) -> Option<Vec<PeakRow>> {
    engine.gas()?;
    let torque = torque::torque(engine).ok()?;
    let peak = Peak::new(&torque);
    let row = |method: PeakMethod| {
        let (value, time) = measured(timing, || peak.value(method));
        let part = |torques: Option<f64>| torques.map(|value| peak.part(value));
        let (farthest, bound) = (part(peak.farthest(method)), part(peak.bound(method)));
        PeakRow { method, value, error: peak.error(value), farthest, bound, time }
    };
    Some(peak.methods().into_iter().map(row).collect())
}

/// The largest bearing load by all methods; none where the layout does not ask for the gas, or has not all that this needs.
fn of_bearings_with_gas(engine: &Engine, timing: Timing) -> Option<Vec<PeakRow>> {
    let asked = engine.effects().gas && !engine.bearings().is_empty();
    let peak = asked.then(|| LoadPeak::new(engine).ok().flatten())??;
    let row = |method: PeakMethod| {
        let (value, time) = measured(timing, || peak.value(method));
        let error = (value - peak.largest).abs() / peak.largest;
        let farthest = peak.farthest(method).map(|far| far / peak.largest);
        PeakRow { method, value, error, farthest, bound: None, time }
    };
    Some(peak.methods().into_iter().map(row).collect())
}
