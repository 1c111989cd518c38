//! How does an open angle move the engine, and at which values, as whole numbers, does each sum vanish?

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::super::family_page::{only_open_angle, summary};
use super::super::typeset;
use super::scene::{Mark, MovingAngle, Zeros};
use crate::engine::{Engine, Family, Linear, PHI};
use crate::exact::Turn;
use crate::family::{self, OpenOrder, OpenVerdict, Solutions};
use crate::order::{Masses, Source};
use crate::proof::{Planar, Sense};
use crate::verdict::{Balance, Judgement, Verdict};

/// Steps of the slider in a degree.
const STEPS: i64 = 2;
/// Where a zero is irrational the slider stops at this many places of a degree: rounded, and said so.
const PLACES: i64 = 1000;
/// Whole numbers up to here are exact in every script.
const LARGEST: i64 = 1 << 50;
/// An angle that enters more often is not moved.
const MOST_TIMES: i64 = 1000;

/// The one open angle of a family, at the value that it has in a member.
pub(super) struct OpenAngle<'a> {
    family: &'a Family,
    orders: &'a [OpenOrder],
    unknown: &'static str,
    start: BigRational,
    /// Whether lengths are open beside it: then a list of zeros is about all lengths and not complete for those drawn.
    lengths_open: bool,
    /// This many whole numbers are a turn.
    per_turn: i64,
}

/// The values that an unknown is moved through, in turns: φ inside (0°, 360°), δ in [−180°, 180°].
fn range(unknown: &str) -> [BigRational; 2] {
    let [low, high] = if unknown == PHI { [0, 2] } else { [-1, 1] };
    [low, high].map(|halves| BigRational::new(halves.into(), 2.into()))
}

impl<'a> OpenAngle<'a> {
    /// The open angle; none where not just one is open, or where the verdicts are about more than the pistons.
    pub fn new(
        engine: &Engine,
        judged: &Judgement,
        family: &'a Family,
        orders: &'a [OpenOrder],
    ) -> Option<OpenAngle<'a>> {
        if judged.masses != Masses::Reciprocating || family::comparable(family).is_err() {
            return None;
        }
        let unknown = only_open_angle(family)?;
        let start = value_in(family, engine, unknown)?;
        let lengths_open = family.unknowns().len() > 1;
        let mut open = OpenAngle { family, orders, unknown, start, lengths_open, per_turn: 360 * STEPS };
        open.per_turn = open.finest()?;
        Some(open)
    }

    /// This many whole numbers a turn that the start, every zero and every step of the slider are whole.
    fn finest(&self) -> Option<i64> {
        let each = self.orders.iter().flat_map(|order| order.force.iter().chain(&order.moment));
        let found: Vec<Solutions> = each.filter_map(|verdict| self.solutions(verdict)).collect();
        let rounded = found.iter().any(|zeros| !zeros.irrational.is_empty());
        let rounded = rounded.then(|| BigRational::new(1.into(), (360 * PLACES).into()));
        let exact = found.iter().flat_map(|zeros| zeros.exact.iter().cloned());
        let all = exact.chain([self.start.clone()]).chain(rounded);
        let unit = all.fold(BigInt::from(360 * STEPS), |unit, value| unit.lcm(value.denom()));
        unit.to_i64().filter(|unit| *unit <= LARGEST)
    }

    /// Where a sum vanishes, the ends of the slider omitted; none where that is not solved, or everywhere.
    fn solutions(&self, verdict: &OpenVerdict) -> Option<Solutions> {
        let [low, high] = range(self.unknown);
        match verdict.zeros(self.unknown, [&low, &high]) {
            family::Zeros::At(mut found) => {
                found.exact.retain(|value| self.unknown != PHI || (*value != low && *value != high));
                Some(found)
            }
            family::Zeros::Everywhere | family::Zeros::NotSolved => None,
        }
    }

    /// A value in turns as a whole number: exact for the start, the ends and every zero.
    fn whole(&self, turns: &BigRational) -> i64 {
        let whole = turns * BigRational::from_integer(self.per_turn.into());
        whole.to_integer().to_i64().unwrap_or(0)
    }

    /// The middle of two ends, to the nearest place where the slider stops.
    fn nearest(&self, [low, high]: &[BigRational; 2]) -> i64 {
        let twice = (low + high) * BigRational::from_integer(self.per_turn.into());
        let middle = twice / BigRational::from_integer(2.into());
        middle.round().to_integer().to_i64().unwrap_or(0)
    }

    /// How many times the angle enters the throw and the bank of a cylinder.
    pub fn enters_cylinder(&self, index: usize) -> [f64; 2] {
        let of = |angle: &Linear| decimal(&angle.coefficient(self.unknown));
        self.family.cylinders().get(index).map_or([0.0; 2], |cylinder| [of(&cylinder.throw), of(&cylinder.bank)])
    }

    /// How many times the angle enters the direction of a vector.
    pub fn enters_vector(&self, source: Source, verdict: &Verdict) -> BigRational {
        // A family is decided without masses that turn.
        let cylinder = source.piston().and_then(|index| self.family.cylinders().get(index));
        let phase = cylinder.zip(verdict.sense).map(|(one, sense)| family::phase(one, verdict.order, sense));
        phase.map_or_else(BigRational::zero, |phase| phase.coefficient(self.unknown))
    }

    /// The verdict of the family on the same sum; none where it was not judged at its order.
    fn open_verdict(&self, verdict: &Verdict) -> Option<&'a OpenVerdict> {
        let order = self.orders.iter().find(|order| order.order == verdict.order)?;
        let [direct, reverse] = order.verdicts(verdict.quantity.planar()?);
        Some(match verdict.sense? {
            Sense::Direct => direct,
            Sense::Reverse => reverse,
        })
    }

    /// Where the sum of a verdict vanishes.
    pub fn zeros_of(&self, verdict: &Verdict) -> Option<Zeros> {
        let open = self.open_verdict(verdict)?;
        let found = self.solutions(open);
        let is_solved = found.as_ref().is_some_and(|found| found.open.is_empty());
        let found = found.unwrap_or_default();
        let of_lengths_drawn = self.lengths_open && verdict.quantity == Planar::Moment.into();
        Some(Zeros {
            everywhere: open.always(),
            complete: open.always() || is_solved && !of_lengths_drawn,
            at: found.exact.iter().map(|value| self.whole(value)).collect(),
            near: found.irrational.iter().map(|ends| self.nearest(ends)).collect(),
            words: summary(open).plain(),
        })
    }

    /// The values at which a sum of force or moment vanishes that does not everywhere, with what vanishes there.
    pub fn marks(&self, balance: &Balance) -> Vec<Mark> {
        let mut found: BTreeMap<BigRational, Vec<&'static str>> = BTreeMap::new();
        // Irrational ones that look alike are not known to be the same.
        let mut near: Vec<([BigRational; 2], &'static str)> = Vec::new();
        let mut always = 0;
        for verdict in balance.verdicts() {
            let (Some(open), Some(sense)) = (self.open_verdict(verdict), verdict.sense) else { continue };
            always += usize::from(open.always());
            let zeros = self.solutions(open).unwrap_or_default();
            for value in zeros.exact {
                found.entry(value).or_default().push(sense.name());
            }
            near.extend(zeros.irrational.into_iter().map(|ends| (ends, sense.name())));
        }
        let exact = found.into_iter().map(|(value, of)| (self.whole(&value), typeset::turns(&value), of));
        let rounded = near.into_iter().map(|(ends, of)| (self.nearest(&ends), about(&ends), vec![of]));
        let mark =
            |(at, text, of): (i64, String, Vec<&'static str>)| Mark { at, text, both: of.len() + always == 2, of };
        let mut marks: Vec<Mark> = exact.chain(rounded).map(mark).collect();
        marks.sort_by_key(|mark| mark.at);
        marks
    }

    /// The slider.
    pub fn into_angle(self) -> MovingAngle {
        let step = self.per_turn / (360 * STEPS);
        let [low, high] = range(self.unknown).map(|end| self.whole(&end));
        let (symbol, name, margin) = match self.unknown {
            PHI if self.family.has_open_banks() => ("φ", "Bank angle φ", step),
            PHI => ("φ", "Angle φ", step),
            _ if self.family.has_open_splits() => ("δ", "Pin split δ", 0),
            _ => ("δ", "Angle δ", 0),
        };
        let text = typeset::turns(&self.start);
        let start = Mark { at: self.whole(&self.start), text, of: Vec::new(), both: false };
        MovingAngle { symbol, name, unit: step * STEPS, low: low + margin, high: high - margin, step, start }
    }
}

/// `≈ 75.522°`: the middle of two ends in turns.
fn about([low, high]: &[BigRational; 2]) -> String {
    format!("≈ {}°", typeset::decimal(decimal(&((low + high) * BigRational::from_integer(180.into())))))
}

/// The value of an unknown, in turns, at which the family is this engine.
fn value_in(family: &Family, engine: &Engine, unknown: &str) -> Option<BigRational> {
    let both = family.cylinders().iter().zip(engine.cylinders());
    let angles: Vec<(&Linear, &Turn)> =
        both.flat_map(|(open, known)| [(&open.throw, &known.throw), (&open.bank, &known.bank)]).collect();
    let (first, turn) = angles.iter().find(|(open, _)| !open.coefficient(unknown).is_zero())?;
    let times = first.coefficient(unknown);
    let most = times.abs().ceil().to_integer().to_i64().filter(|times| *times <= MOST_TIMES)? + 2;
    let [low, high] = range(unknown);
    let candidates = (-most..=most)
        .map(|whole| (turn.turns() - first.known() + BigRational::from_integer(whole.into())) / &times)
        .filter(|value| *value >= low && *value <= high && (unknown != PHI || (*value != low && *value != high)));
    let is_so = |value: &BigRational| {
        let at = |open: &Linear| Turn::new(open.known() + open.coefficient(unknown) * value);
        angles.iter().all(|(open, turn)| at(open) == **turn)
    };
    // Of several, that nearest to no split or no bank angle.
    let mut fitting: Vec<BigRational> = candidates.filter(is_so).collect();
    fitting.sort_by_key(|value| value.abs());
    fitting.into_iter().next()
}

/// A number in decimals.
pub(super) fn decimal(value: &BigRational) -> f64 {
    value.to_f64().unwrap_or(0.0)
}
