//! At which exact angles does each vector of a sweep vanish, on its grid or between its points?
//!
//! Any angle of a layout file may be the unknown φ, so that the room [`crate::family`] tells where a vector vanishes,
//! exactly and completely. Each such angle is put into the file and judged once more, with all masses that turn.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::parameter::Parameter;
use super::reader::Reader;
use super::swept_engine::{SweptEngine, has_order};
use crate::engine::{Engine, Family, PHI};
use crate::exact::fraction;
use crate::family::{self, Component, OpenVerdict, Solutions, component_zeros};
use crate::file::{self, Layout, Template};
use crate::order::{self, MassGroup, Path};
use crate::proof::{Planar, Quantity, Sense};

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

    /// Which vector it is, where it is one.
    fn vector(self) -> Option<Sense> {
        match self {
            Zeros::Direct => Some(Sense::Direct),
            Zeros::Reverse => Some(Sense::Reverse),
            Zeros::Largest | Zeros::Along | Zeros::Across => None,
        }
    }

    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Zeros::Direct => "direct",
            Zeros::Reverse => "reverse",
            Zeros::Largest => "all",
            Zeros::Along => "along",
            Zeros::Across => "across",
        }
    }
}

/// Where one of them vanishes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ZeroSet {
    /// Force or moment.
    pub quantity: Planar,
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
    /// Ends, narrow ones, between which it vanishes once each, at an angle that is no rational turn.
    pub irrational: Vec<[BigRational; 2]>,
    /// Whether these are proved to be all; else they are those found.
    pub complete: bool,
}

impl ZeroSet {
    fn everywhere(quantity: Planar, order: u32, of: Zeros) -> Self {
        ZeroSet {
            quantity,
            order,
            of,
            exists: true,
            everywhere: true,
            at: Vec::new(),
            irrational: Vec::new(),
            complete: true,
        }
    }

    /// Whether it vanishes nowhere in the range, proved.
    fn is_never(&self) -> bool {
        self.complete && self.exists && !self.everywhere && self.at.is_empty() && self.irrational.is_empty()
    }

    /// Takes in the points of a grid at which it is proved to vanish: what is zero there is in the list, even where nothing is proved
    /// of what lies between.
    pub(super) fn take_from(&mut self, points: &[SweptEngine]) {
        if !self.exists || self.everywhere {
            return;
        }
        for point in points {
            let Some(order) = point.orders.iter().find(|swept| swept.order == self.order) else { continue };
            let part = order.amplitudes(self.quantity);
            let vanishes = match self.of {
                Zeros::Direct => part.direct.vanishes,
                Zeros::Reverse => part.reverse.vanishes,
                Zeros::Largest => part.largest.vanishes,
                Zeros::Along => part.along.vanishes,
                Zeros::Across => part.across.vanishes,
            };
            if let (true, [value]) = (vanishes, point.values.as_slice())
                && let Err(place) = self.at.binary_search(value)
            {
                self.at.insert(place, value.clone());
                // What a complete list lacks would be a mistake of the list.
                self.complete = false;
            }
        }
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
    let (range, is_whole) = range(parameter, &per_unit)?;
    let mut sets = Vec::new();
    for order in family::classify(&open, orders).ok()? {
        // A balancer shaft may have an order that no piston has: the star of the pistons says nothing there.
        let of_pistons = engine.pistons_have_order(Quantity::FORCE, order.order);
        for (quantity, verdicts) in [(Planar::Force, &order.force), (Planar::Moment, &order.moment)] {
            for of in Zeros::ALL {
                if !has_order(&engine, order.order) {
                    sets.push(ZeroSet { exists: false, ..ZeroSet::everywhere(quantity, order.order, of) });
                    continue;
                }
                if let Some(set) = with_the_other(&sets, quantity, order.order, of) {
                    sets.push(set);
                    continue;
                }
                let found = find(&open, quantity, order.order, verdicts, of, range.each_ref());
                let turns = same_rods && of_pistons && !with_turning_masses(&engine, order.order, of);
                let is_so = |value: &BigRational| {
                    let engine = reader.engine(std::slice::from_ref(value)).ok()?;
                    Some(vanishes(&engine, quantity, order.order, of))
                };
                let is_of_shafts = !of_pistons && only_shafts(&engine, order.order);
                let is_fixed = is_of_shafts || is_fixed(&open, order.order, of);
                // Not known where the file does not read one of them.
                let by_points = || {
                    let mut places = distinct(&open, order.order, &per_unit, range.each_ref()).peekable();
                    places.peek()?;
                    places.map(|value| is_so(&value)).find(|is_so| *is_so != Some(true)).unwrap_or(Some(true))
                };
                let is_everywhere = match (turns, is_fixed) {
                    (true, _) => Some(found == family::Zeros::Everywhere),
                    (false, true) => Some(vanishes(&engine, quantity, order.order, of)),
                    (false, false) => by_points(),
                };
                if is_everywhere == Some(true) {
                    sets.push(ZeroSet::everywhere(quantity, order.order, of));
                    continue;
                }
                let (found, complete) = match found {
                    family::Zeros::Everywhere | family::Zeros::NotSolved => (Solutions::default(), false),
                    family::Zeros::At(found) if turns => {
                        let complete = is_whole && found.open.is_empty();
                        (found, complete)
                    }
                    // Masses that turn beside the pistons may cancel what is not zero.
                    family::Zeros::At(found) => (Solutions { irrational: Vec::new(), ..found }, false),
                };
                let own = |set: &ZeroSet| set.quantity == quantity && set.order == order.order;
                let one_never = of == Zeros::Largest && sets.iter().any(|set| own(set) && set.is_never());
                let complete = complete || one_never || is_fixed;
                let value = |turns: &BigRational| turns / &per_unit;
                let at = found.exact.iter().map(value).filter(|value| is_so(value) == Some(true)).collect();
                let irrational = found.irrational.iter().map(|ends| ends.each_ref().map(value)).collect();
                let order = order.order;
                sets.push(ZeroSet { quantity, order, of, exists: true, everywhere: false, at, irrational, complete });
            }
        }
    }
    Some(sets)
}

/// Where one vector vanishes everywhere, all of the order vanishes where the other does, and so does each of its parts.
fn with_the_other(sets: &[ZeroSet], quantity: Planar, order: u32, of: Zeros) -> Option<ZeroSet> {
    let vectors =
        || sets.iter().filter(|set| (set.quantity, set.order) == (quantity, order) && set.of.vector().is_some());
    let is_of_both = of.vector().is_none() && vectors().any(|set| set.everywhere);
    let other = vectors().find(|set| !set.everywhere).or_else(|| vectors().next()).filter(|_| is_of_both)?;
    Some(ZeroSet { of, ..other.clone() })
}

/// Whether the parameter turns no term of this vector, so that it is one at every value.
fn is_fixed(open: &Family, order: u32, of: Zeros) -> bool {
    let turns = |sense, cylinder| !family::phase(cylinder, order, sense).coefficient(PHI).is_zero();
    of.vector().is_some_and(|sense| !open.cylinders().iter().any(|cylinder| turns(sense, cylinder)))
}

/// Whether all masses that turn at an order are on balancer shafts, which no angle of the engine turns.
fn only_shafts(engine: &Engine, order: u32) -> bool {
    let turning = order::turning_masses(engine);
    turning.iter().filter(|mass| mass.order == order).all(|mass| mass.source.group() == MassGroup::Balancers)
}

/// More values than this are not tried.
const MOST_TRIED: i64 = 2000;

/// Values of the parameter in its range, at so many different angles that a vector of this order which vanishes at each vanishes everywhere;
/// none where they would be too many.
///
/// Every term, of a piston or of a mass on a throw, turns by `kβ ± (k±1)α`, and β and α by whole multiples of φ/d. So each sum is a
/// polynomial in `e^{±iφ/d}`, with at most twice its degree of zeros.
fn distinct(
    open: &Family,
    order: u32,
    per_unit: &BigRational,
    [low, high]: [&BigRational; 2],
) -> impl Iterator<Item = BigRational> {
    let angles = || open.cylinders().iter().flat_map(|cylinder| [&cylinder.throw, &cylinder.bank]);
    let steps = angles().map(|angle| angle.coefficient(PHI));
    let divisor = fraction::common_denominator(steps.clone());
    let widest = steps.map(|step| step.abs()).max().unwrap_or_else(BigRational::zero);
    let degree = widest * BigRational::from_integer(&divisor * BigInt::from(2 * order + 1));
    let count = (degree.ceil().to_integer() * 2_i32 + 1_i32).to_i64().filter(|count| *count <= MOST_TRIED).unwrap_or(0);
    // Inside the range, which the layout file reads, and inside one turn, so that no two of them are alike.
    let turn = (high - low).min(BigRational::one());
    let (first, step) = (low / per_unit, turn / per_unit / BigRational::from_integer((count + 1).into()));
    let is_wide = !step.is_zero();
    (0..count as i32)
        .filter(move |_| is_wide)
        .map(move |place| &first + &step * BigRational::from_integer((place + 1).into()))
}

fn find(
    open: &Family,
    quantity: Planar,
    order: u32,
    [direct, reverse]: &[OpenVerdict; 2],
    of: Zeros,
    range: [&BigRational; 2],
) -> family::Zeros {
    let component = |component| component_zeros(open, quantity, order, component, range);
    match of {
        Zeros::Direct => direct.zeros(PHI, range),
        Zeros::Reverse => reverse.zeros(PHI, range),
        Zeros::Along => component(Component::Along),
        Zeros::Across => component(Component::Across),
        Zeros::Largest => direct.zeros(PHI, range).and(reverse.zeros(PHI, range)),
    }
}

/// No plot shows more turns.
const MOST_TURNS: i64 = 1000;

/// The range in turns, and whether it is the whole one.
fn range(parameter: &Parameter, per_unit: &BigRational) -> Option<([BigRational; 2], bool)> {
    let ends = [parameter.range.value(0), parameter.range.last()].map(|end| end * per_unit);
    let (low, high) = (ends.iter().min()?.clone(), ends.iter().max()?.clone());
    let last = &low + BigRational::from_integer(MOST_TURNS.into());
    let is_whole = high <= last;
    Some(([low, if is_whole { high } else { last }], is_whole))
}

/// Whether masses that turn enter this vector beside the pistons.
fn with_turning_masses(engine: &Engine, order: u32, of: Zeros) -> bool {
    let enters = |sense: Sense| of.vector().is_none_or(|own| own == sense);
    order::turning_masses(engine).iter().any(|mass| mass.order == order && enters(mass.sense))
}

/// Whether a vector of this engine vanishes, decided exactly.
fn vanishes(engine: &Engine, quantity: Planar, order: u32, of: Zeros) -> bool {
    let [direct, reverse] = Sense::BOTH.map(|sense| order::all_masses(engine, quantity, order, sense));
    match of {
        Zeros::Direct => direct.vanishes(),
        Zeros::Reverse => reverse.vanishes(),
        Zeros::Largest => direct.vanishes() && reverse.vanishes(),
        Zeros::Along => Path::has_nothing_along(&direct, &reverse),
        Zeros::Across => Path::has_nothing_across(&direct, &reverse),
    }
}
