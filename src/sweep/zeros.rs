//! At which exact angles does each vector of a sweep vanish, on its grid or between its points?
//!
//! Any angle of a layout file may be the unknown φ, so that the room [`crate::family`] tells where a vector vanishes,
//! exactly and completely. Each such angle is put into the file and judged once more, with all masses that turn.

use std::collections::BTreeSet;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::parameter::Parameter;
use super::run::Reader;
use crate::engine::{self, Engine, Family, PHI};
use crate::exact::Turn;
use crate::family::{self, Component, OpenVerdict, component_zeros};
use crate::file::{self, Layout, Template};
use crate::order::{self, Path};
use crate::proof::{Quantity, Sense};

/// What vanishes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Zeros {
    /// The vector that turns with the crank.
    Direct,
    /// The vector that turns against it.
    Reverse,
    /// Both.
    Largest,
    /// The part along the reference direction.
    Along,
    /// The part across it.
    Across,
}

impl Zeros {
    /// All of them.
    pub const ALL: [Zeros; 5] = [Zeros::Direct, Zeros::Reverse, Zeros::Largest, Zeros::Along, Zeros::Across];
}

/// Where one of them vanishes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ZeroSet {
    /// Force or moment.
    pub quantity: Quantity,
    /// The order k.
    pub order: u32,
    /// What vanishes.
    pub of: Zeros,
    /// Whether the engine has the order at all.
    pub exists: bool,
    /// Whether it vanishes for every value of the parameter.
    pub everywhere: bool,
    /// The values in the range at which it vanishes, rising, in the unit of the range; empty where it does everywhere.
    pub at: Vec<BigRational>,
    /// Whether these are proved to be all; else they are those found.
    pub complete: bool,
}

impl ZeroSet {
    fn everywhere(quantity: Quantity, order: u32, of: Zeros) -> Self {
        ZeroSet { quantity, order, of, exists: true, everywhere: true, at: Vec::new(), complete: true }
    }
}

/// The family whose unknown is the parameter, and how many turns its unit is; `None` where the parameter is no angle.
fn opened(template: &Template, parameter: &Parameter) -> Option<(Family, BigRational)> {
    opened_without(template, parameter, &["firing_order", "firing_angles"])
}

/// The same with what the file says of its firing, where that fits every value.
pub(super) fn opened_with_firing(template: &Template, parameter: &Parameter) -> Option<(Family, BigRational)> {
    opened_without(template, parameter, &[]).or_else(|| opened(template, parameter))
}

fn opened_without(template: &Template, parameter: &Parameter, keys: &[&str]) -> Option<(Family, BigRational)> {
    let per_unit = file::turns_per_unit(parameter.range.unit())?;
    let open = template.without(&["bearings", "crankshaft", "counterweight", "balancer", "torsion"]).without(keys);
    // The file itself may have an unknown angle, whose values are swept.
    let layout = match parameter.key.to_string().strip_prefix("values.") {
        Some(PHI) => open.without(&["values.phi"]).layout(&[]),
        _ => open.layout(&[(&parameter.key, PHI)]),
    };
    let Ok(Layout::Open(open)) = layout else { return None };
    open.unknowns().into_iter().eq([PHI]).then_some((*open, per_unit))
}

/// Whether a parameter is an angle of the engine.
pub(super) fn is_angle(template: &Template, parameter: &Parameter) -> bool {
    opened(template, parameter).is_some()
}

/// Where the vectors of these orders vanish; `None` where the parameter is no angle.
pub fn zeros(template: &Template, parameter: &Parameter, orders: &[u32]) -> Option<Vec<ZeroSet>> {
    let (open, per_unit) = opened(template, parameter)?;
    let parameters = [parameter.clone()];
    let reader = Reader::new(template, &parameters);
    let engine = reader.engine(&reader.values(0)).ok()?;
    let same_rods = engine.mechanisms().len() < 2;
    let mut sets = Vec::new();
    for order in family::classify(&open, orders).ok()? {
        for (quantity, verdicts) in [(Quantity::Force, &order.force), (Quantity::Moment, &order.moment)] {
            for of in Zeros::ALL {
                if !has_order(&engine, order.order) {
                    sets.push(ZeroSet { exists: false, ..ZeroSet::everywhere(quantity, order.order, of) });
                    continue;
                }
                let found = find(&open, quantity, order.order, verdicts, of);
                let turns = same_rods && !with_turning_masses(&engine, order.order, of);
                let is_so = |value: &BigRational| {
                    let engine = reader.engine(std::slice::from_ref(value));
                    engine.is_ok_and(|engine| vanishes(&engine, quantity, order.order, of))
                };
                let by_points = || {
                    let mut places = distinct(&open, order.order, &per_unit);
                    places.len() > 0 && places.all(|value| is_so(&value))
                };
                let found = match found {
                    Found::Everywhere | Found::NotSolved if !turns && by_points() => {
                        sets.push(ZeroSet::everywhere(quantity, order.order, of));
                        continue;
                    }
                    other => other,
                };
                let (found, complete) = match found {
                    Found::NotSolved => (BTreeSet::new(), false),
                    Found::Everywhere if turns => {
                        sets.push(ZeroSet::everywhere(quantity, order.order, of));
                        continue;
                    }
                    Found::Everywhere => (BTreeSet::new(), false),
                    Found::At(set) => (set, turns),
                };
                let at = in_range(&found, parameter, &per_unit).into_iter().filter(is_so).collect();
                sets.push(ZeroSet { quantity, order: order.order, of, exists: true, everywhere: false, at, complete });
            }
        }
    }
    Some(sets)
}

/// More values than this are not tried.
const MOST_TRIED: i64 = 2000;

/// Values of the parameter at so many different angles that a vector of this order which vanishes at each vanishes everywhere; none
/// where they would be too many.
///
/// Every term, of a piston or of a mass on a throw, turns by `kβ ± (k±1)α`, and β and α by whole multiples of φ/d. So each sum is a
/// polynomial in `e^{±iφ/d}`, with at most twice its degree of zeros.
fn distinct(open: &Family, order: u32, per_unit: &BigRational) -> impl ExactSizeIterator<Item = BigRational> {
    let angles = || open.cylinders().iter().flat_map(|cylinder| [&cylinder.throw, &cylinder.bank]);
    let steps = angles().map(|angle| angle.coefficient(PHI));
    let divisor = steps.clone().fold(BigInt::one(), |all, step| all.lcm(step.denom()));
    let widest = steps.map(|step| step.abs()).max().unwrap_or_else(BigRational::zero);
    let degree = widest * BigRational::from_integer(&divisor * BigInt::from(2 * order + 1));
    let count = (degree.ceil().to_integer() * 2_i32 + 1_i32).to_i64().filter(|count| *count <= MOST_TRIED).unwrap_or(0);
    // Inside one turn, so that no two of them are alike and every layout file reads them.
    let step = BigRational::one() / per_unit / BigRational::from_integer((count + 1).into());
    (0..count as i32).map(move |place| &step * BigRational::from_integer((place + 1).into()))
}

enum Found {
    Everywhere,
    At(BTreeSet<Turn>),
    NotSolved,
}

fn find(open: &engine::Family, quantity: Quantity, order: u32, verdicts: &[OpenVerdict; 2], of: Zeros) -> Found {
    let one = |verdict: &OpenVerdict| match (verdict.always(), verdict.bank_angles()) {
        (true, _) => Found::Everywhere,
        (false, Some(set)) => Found::At(set),
        (false, None) => Found::NotSolved,
    };
    let component = |component| match component_zeros(open, quantity, order, component) {
        family::Zeros::Everywhere => Found::Everywhere,
        family::Zeros::At(set) => Found::At(set),
        family::Zeros::NotSolved => Found::NotSolved,
    };
    match of {
        Zeros::Direct => one(&verdicts[0]),
        Zeros::Reverse => one(&verdicts[1]),
        Zeros::Along => component(Component::Along),
        Zeros::Across => component(Component::Across),
        Zeros::Largest => match (one(&verdicts[0]), one(&verdicts[1])) {
            (Found::Everywhere, other) | (other, Found::Everywhere) => other,
            (Found::At(some), Found::At(others)) => Found::At(some.intersection(&others).cloned().collect()),
            // Where one vector never vanishes, both never do.
            (Found::At(none), _) | (_, Found::At(none)) if none.is_empty() => Found::At(none),
            _ => Found::NotSolved,
        },
    }
}

/// Whether the engine has the order: odd ones of centric rods have the coefficient 0, but for balancer shafts.
fn has_order(engine: &Engine, order: u32) -> bool {
    let balanced = engine.crankshaft().balancers.iter().any(|shaft| shaft.order == order);
    let geared = engine.geared_cranks().iter().any(|crank| crank.speed == order);
    balanced || geared || engine.pistons_have_order(Quantity::Force, order)
}

/// Whether masses that turn enter this vector beside the pistons.
fn with_turning_masses(engine: &Engine, order: u32, of: Zeros) -> bool {
    let enters = |sense: Sense| match of {
        Zeros::Direct => sense == Sense::Direct,
        Zeros::Reverse => sense == Sense::Reverse,
        _ => true,
    };
    order::turning_masses(engine).iter().any(|mass| mass.order == order && enters(mass.sense))
}

/// Whether a vector of this engine vanishes, decided exactly.
fn vanishes(engine: &Engine, quantity: Quantity, order: u32, of: Zeros) -> bool {
    let [direct, reverse] =
        [Sense::Direct, Sense::Reverse].map(|sense| order::all_masses(engine, quantity, order, sense));
    match of {
        Zeros::Direct => direct.vanishes(),
        Zeros::Reverse => reverse.vanishes(),
        Zeros::Largest => direct.vanishes() && reverse.vanishes(),
        Zeros::Along => Path::has_nothing_along(&direct, &reverse),
        Zeros::Across => Path::has_nothing_across(&direct, &reverse),
    }
}

/// The angles in the range, whole turns added, and those of a whole number of turns.
fn in_range(found: &BTreeSet<Turn>, parameter: &Parameter, per_unit: &BigRational) -> BTreeSet<BigRational> {
    let range = &parameter.range;
    let ends = [range.value(0), range.last()];
    let (Some(low), Some(high)) = (ends.iter().min(), ends.iter().max()) else { return BTreeSet::new() };
    let mut values = BTreeSet::new();
    for angle in found.iter().map(|turn| turn.turns().clone()).chain([BigRational::zero()]) {
        let mut turns = &angle + (low * per_unit - &angle).ceil();
        // A range has as many turns as it has, but no plot shows more.
        for _ in 0..1000 {
            let value = &turns / per_unit;
            if value > *high {
                break;
            }
            values.insert(value);
            turns += BigRational::one();
        }
    }
    values
}
