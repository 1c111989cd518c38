//! How are newtons shown? Decimals of six digits after ≈, in the unit that the layout file allows; 0 is proved.

use crate::engine::{DOES_NOT_EXIST, Engine};
use crate::loads::{self, Loads, Outcome, Peak, Scale, Swing, Torque, TorqueOrder, Vector, Waveform};
use crate::numbers;
use crate::page::{self, Piece, Setting, Text, number as typeset, phrase};
use crate::proof::{Axial, Planar, Quantity};

/// Digits of a value in a table.
const DIGITS: usize = 6;

/// In what a page counts a quantity: as documents and scripts do, or as it is read best.
pub(crate) type UnitOf = fn(&Engine, &Loads, Quantity) -> Unit;

/// The unit of one quantity: its name, and how many of it are one multiple of the loads.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Unit {
    /// What it is counted in.
    pub unit: page::Unit,
    /// Units a multiple.
    pub factor: f64,
}

impl Unit {
    /// Its name on a page, in the units of the reader.
    pub fn label(self) -> Text {
        self.unit.into()
    }

    /// So many multiples in it, with its name.
    pub fn sized(self, multiples: f64, setting: Setting) -> Text {
        Text::set_in(multiples * self.factor, self.unit, setting)
    }

    /// The same in which a person reads all values of a quantity best: its orders, and what they add up to.
    pub fn as_read(engine: &Engine, of: &Loads, quantity: impl Into<Quantity>) -> Self {
        let quantity = quantity.into();
        let turning = of.torque.iter().chain(&of.roll);
        let amplitudes = |torque: &Torque| torque.orders.iter().map(|order| order.vector.value.norm()).sum();
        let largest = match quantity {
            Quantity::Planar(planar) => of.orders.iter().map(|order| order.swing(planar).largest()).sum(),
            Quantity::Axial(_) => turning.map(amplitudes).fold(0.0, f64::max),
        };
        Unit::of(engine, of, quantity).for_values_up_to(largest)
    }

    /// The unit in which values are read best whose largest is this many multiples: kN in place of thousands of N.
    pub fn for_values_up_to(self, largest: f64) -> Self {
        let (unit, size) = self.unit.for_values_up_to(largest * self.factor);
        Unit { unit, factor: self.factor / size }
    }

    /// The unit of forces: newtons where the scale is known.
    pub fn of_force(scale: Option<&Scale>) -> Self {
        match scale {
            Some(scale) => Unit { unit: page::Unit::NEWTON, factor: scale.force() },
            None => Unit { unit: page::Unit::MULTIPLE, factor: 1.0 },
        }
    }

    /// The unit of forces, moments or the torque of a layout.
    pub fn of(engine: &Engine, of: &Loads, quantity: impl Into<Quantity>) -> Self {
        Unit::at(engine, of.scale.as_ref(), quantity.into())
    }

    /// The same where the scale is known, or not.
    pub fn at(engine: &Engine, scale: Option<&Scale>, quantity: Quantity) -> Self {
        let factor = match quantity {
            Quantity::Planar(_) => Scale::force,
            Quantity::Axial(_) => Scale::torque,
        };
        Unit { unit: loads::unit(engine, scale, quantity), factor: scale.map_or(1.0, factor) }
    }
}

/// A decimal of six digits, `−` for minus.
pub(crate) fn digits(value: f64) -> String {
    let power = |power: i32| format!("·{}", typeset::power_of_ten(power.into()));
    super::expression::figures(value, DIGITS, power).replace('-', "−")
}

/// A value of six digits, whose unit is beside it.
pub(crate) fn in_digits(value: f64, unit: Unit) -> Text {
    Piece::Measured(value, unit.unit, Setting::Usual(digits)).into()
}

/// No less than a bound, to six digits.
pub(crate) fn bound(most: f64, unit: Unit) -> Text {
    let raised = |value| digits(typeset::raised_to(value, DIGITS));
    Piece::Measured((most * unit.factor).next_up(), unit.unit, Setting::Fixed(raised)).into()
}

/// A value in its unit, which the heading of the column names.
pub(crate) fn amount(value: f64, unit: Unit) -> Text {
    match unit.factor == 0.0 {
        // At rest, and without masses, every force is exactly zero.
        true => Text::zero(),
        false => Text::measured(value * unit.factor, unit.unit),
    }
}

/// The largest length of an order: zero, a decimal, or how little it is known to be below.
pub(crate) fn largest(swing: &Swing, unit: Unit) -> Text {
    if swing.vanishes() {
        return Text::zero();
    }
    if is_left(swing) { amount(swing.largest(), unit) } else { bounded(&[&swing.direct, &swing.reverse], unit) }
}

/// Whether one of its vectors is proved not to be zero.
pub(super) fn is_left(swing: &Swing) -> bool {
    let is_told = |vector: &&&Vector| matches!(vector.outcome, Outcome::NotZero | Outcome::Computed);
    [&swing.direct, &swing.reverse].iter().any(|vector| is_told(&vector))
}

/// How little vectors that are not decided are known to be below.
fn bounded(vectors: &[&Vector], unit: Unit) -> Text {
    let bound = |vector: &&Vector| match vector.outcome {
        Outcome::Undecided { below } => below,
        Outcome::Zero | Outcome::NotZero | Outcome::Computed => 0.0,
    };
    undecided(vectors.iter().map(bound).sum::<f64>() / 2.0, unit)
}

/// That only so much is known of a value.
pub(super) fn undecided(below: f64, unit: Unit) -> Text {
    if unit.factor == 0.0 { Text::zero() } else { phrase!("not decided, below {}", bound(below, unit)) }
}

/// A vector: zero, or its length and its angle at θ = 0.
pub(crate) fn vector(vector: &Vector, unit: Unit) -> Text {
    match vector.outcome {
        Outcome::Zero => Text::zero(),
        // At rest no force points anywhere.
        Outcome::NotZero | Outcome::Computed | Outcome::Undecided { .. } if unit.factor == 0.0 => Text::zero(),
        Outcome::NotZero | Outcome::Computed => {
            let angle = super::expression::rounded(numbers::degrees(vector.value), DIGITS);
            // Half a turn has two names.
            let angle = if angle == -180.0 { 180.0 } else { angle };
            phrase!("{} at {}°", amount(vector.value.norm() / 2.0, unit), typeset::decimal(angle))
        }
        Outcome::Undecided { .. } => bounded(&[vector], unit),
    }
}

/// A peak with its crank angle.
pub(super) fn peak(peak: &Peak, unit: Unit) -> Text {
    match peak.angle {
        _ if peak.value == 0.0 || unit.factor == 0.0 => Text::zero(),
        Some(angle) => {
            phrase!("≈ {} {} at θ ≈ {}°", in_digits(peak.value * unit.factor, unit), unit.label(), digits(angle))
        }
        None => phrase!("≈ {} {} at every crank angle", in_digits(peak.value * unit.factor, unit), unit.label()),
    }
}

/// What an effect adds along the direction of the peak, at its angle.
pub(in crate::report) fn share(waveform: &Waveform, peak: &Peak) -> f64 {
    if peak.value == 0.0 {
        return 0.0;
    }
    let along = peak.vector / peak.value;
    let there = waveform.at(peak.angle.unwrap_or(0.0).to_radians());
    there.re * along.re + there.im * along.im
}

/// The force or the moment through a revolution.
pub(super) fn waveform(loads: &Loads, quantity: Planar) -> &Waveform {
    quantity.choose(&loads.force, &loads.moment)
}

/// The torque or the roll moment; none where it is not known.
pub(in crate::report) fn about_the_axis(loads: &Loads, quantity: Axial) -> Option<&Torque> {
    match quantity {
        Axial::Torque => loads.torque.as_ref(),
        Axial::Roll => loads.roll.as_ref(),
    }
}

/// The amplitude of an order of the torque, or of the roll moment, which forces with arms make as well as torques; or that there is none.
pub(super) fn axial_cell(engine: &Engine, quantity: Axial, order: &TorqueOrder, unit: Unit) -> Text {
    let has = |part| engine.pistons_have_order(part, order.order);
    match (has(Quantity::TORQUE), quantity, &order.vector.outcome) {
        (false, Axial::Torque, _) => DOES_NOT_EXIST.into(),
        (false, Axial::Roll, Outcome::Zero) if !has(Quantity::FORCE) => DOES_NOT_EXIST.into(),
        (.., Outcome::Zero) => Text::zero(),
        (.., Outcome::NotZero | Outcome::Computed) => amount(order.vector.value.norm(), unit),
        (.., Outcome::Undecided { below }) => undecided(*below, unit),
    }
}
