//! At which exact angles does each vector of a sweep vanish, on its grid or between its points?
//!
//! Any angle of a layout file may be the unknown φ, or is the unknown δ of the file itself, so that the room [`crate::family`] tells where a vector vanishes,
//! exactly and completely. Each such angle is put into the file and judged once more, with all masses that turn.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::parameter::Parameter;
use super::reader::Reader;
use super::zeros::{ZeroSet, Zeros};
use crate::engine::{DELTA, Engine, Family, PHI};
use crate::exact::fraction;
use crate::family::{self, Component, OpenVerdict, Solutions, component_zeros};
use crate::file::{self, Layout, Template};
use crate::order::{self, MassGroup, Path, Source, TurningMass};
use crate::proof::{Planar, Quantity, Sense};

/// An engine whose angle is not known.
pub(super) struct OpenAngle {
    pub family: Family,
    /// Which of its unknowns is the parameter: φ or δ.
    pub unknown: &'static str,
    /// How many turns the unit of the parameter is.
    pub per_unit: BigRational,
}

/// The family whose unknown is the parameter; `None` where the parameter is no angle.
fn opened(template: &Template, parameter: &Parameter) -> Option<OpenAngle> {
    opened_without(template, parameter, &["firing_order", "firing_angles"])
}

/// The same with what the file says of its firing, where that fits every value.
pub(super) fn opened_with_firing(template: &Template, parameter: &Parameter) -> Option<OpenAngle> {
    opened_without(template, parameter, &[]).or_else(|| opened(template, parameter))
}

fn opened_without(template: &Template, parameter: &Parameter, keys: &[&str]) -> Option<OpenAngle> {
    let per_unit = file::turns_per_unit(parameter.range.unit())?;
    let open = template.without(&["bearings", "crankshaft", "counterweight", "balancer", "torsion"]).without(keys);
    // The file itself may have an unknown angle, whose values are swept.
    let (layout, unknown) = match parameter.key.to_string().strip_prefix("values.") {
        Some(PHI) => (open.without(&["values.phi"]).layout(&[]), PHI),
        Some(DELTA) => (open.without(&["values.delta"]).layout(&[]), DELTA),
        _ => (open.layout(&[(&parameter.key, PHI)]), PHI),
    };
    let Ok(Layout::Open(family)) = layout else { return None };
    family.unknowns().into_iter().eq([unknown]).then_some(OpenAngle { family: *family, unknown, per_unit })
}

/// Whether a parameter is an angle of the engine.
pub(super) fn is_angle(template: &Template, parameter: &Parameter) -> bool {
    opened(template, parameter).is_some()
}

/// Where the vectors of these orders vanish; `None` where the parameter is no angle.
pub fn zeros(template: &Template, parameter: &Parameter, orders: &[u32]) -> Option<Vec<ZeroSet>> {
    let open = opened(template, parameter)?;
    let parameters = [parameter.clone()];
    let reader = Reader::new(template, &parameters);
    let engine = reader.engine(&reader.values(0)).ok()?;
    let (range, is_whole) = range(parameter, &open.per_unit)?;
    let opened = Opened { reader, engine, open, range, is_whole };
    let orders = family::classify(&opened.open.family, orders).ok()?;
    let sets = orders.iter().flat_map(|order| {
        let vectors = [(Planar::Force, &order.force), (Planar::Moment, &order.moment)];
        vectors.into_iter().flat_map(|(quantity, verdicts)| opened.sets(quantity, order.order, verdicts))
    });
    Some(sets.collect())
}

/// The engine of a sweep whose angle is unknown.
struct Opened<'a> {
    reader: Reader<'a>,
    /// At the first point.
    engine: Engine,
    /// Its pistons, at any angle.
    open: OpenAngle,
    /// In turns.
    range: [BigRational; 2],
    is_whole: bool,
}

impl Opened<'_> {
    /// What vanishes where, of one order of force or moment.
    fn sets(&self, quantity: Planar, order: u32, verdicts: &[OpenVerdict; 2]) -> Vec<ZeroSet> {
        let exists = self.engine.has_order(order);
        let mut sets = Vec::new();
        for of in Zeros::ALL {
            let is_never = || of == Zeros::Largest && sets.iter().any(ZeroSet::is_never);
            sets.push(match with_the_other(&sets, of) {
                _ if !exists => ZeroSet { exists, ..ZeroSet::everywhere(quantity, order, of) },
                Some(set) => set,
                None => self.set(Vector { quantity, order, of }, verdicts, is_never()),
            });
        }
        sets
    }

    /// Whether the star of the pistons alone tells where it vanishes: a balancer shaft may have an order that no piston has.
    fn is_of_pistons(&self, vector: Vector) -> bool {
        let same_rods = self.engine.mechanisms().len() < 2;
        let alone = self.pistons_enter(vector.order) && !vector.has_turning_masses(&self.engine);
        same_rods && (alone || self.is_of_big_ends(vector))
    }

    /// Whether the pistons have the order, and weigh something.
    fn pistons_enter(&self, order: u32) -> bool {
        !self.is_weightless() && self.engine.pistons_have_order(Quantity::FORCE, order)
    }

    fn is_weightless(&self) -> bool {
        self.engine.dimensions().mass.as_ref().is_some_and(Zero::is_zero)
    }

    /// Whether it is that of equal big ends alone, whose star is that of pistons that weigh the same.
    fn is_of_big_ends(&self, vector: Vector) -> bool {
        let cylinders = self.engine.cylinders();
        let turning = vector.turning_masses(&self.engine);
        self.is_weightless()
            && (vector.order, vector.of) == (1, Zeros::Direct)
            && self.engine.geared_cranks().is_empty()
            && turning.len() == cylinders.len()
            && turning.iter().all(|mass| matches!(mass.source, Source::BigEnd(_)))
            && cylinders.iter().all(|cylinder| cylinder.rotating_mass == cylinders[0].rotating_mass)
    }

    /// Whether it is the same at every value of the parameter.
    fn is_fixed(&self, vector: Vector) -> bool {
        // No angle of the engine turns a balancer shaft.
        let is_shaft = |mass: &TurningMass| mass.source.group() == MassGroup::Balancers;
        let only_shafts = || vector.turning_masses(&self.engine).iter().all(is_shaft);
        !self.pistons_enter(vector.order) && only_shafts() || is_fixed(&self.open, vector.order, vector.of)
    }

    /// Where it vanishes; `is_never`: it is that of two vectors of which one never does.
    fn set(&self, vector: Vector, verdicts: &[OpenVerdict; 2], is_never: bool) -> ZeroSet {
        let Vector { quantity, order, of } = vector;
        let (found, of_pistons, is_fixed) =
            (self.found(vector, verdicts), self.is_of_pistons(vector), self.is_fixed(vector));
        let is_everywhere = match (of_pistons, is_fixed) {
            (true, _) => found == family::Zeros::Everywhere,
            (false, true) => vector.vanishes(&self.engine),
            (false, false) => self.vanishes_at_enough(vector),
        };
        if is_everywhere {
            return ZeroSet::everywhere(quantity, order, of);
        }
        let (found, all) = match found {
            family::Zeros::Everywhere | family::Zeros::NotSolved => (Solutions::default(), false),
            family::Zeros::At(found) if of_pistons => {
                let all = self.is_whole && found.open.is_empty();
                (found, all)
            }
            // Masses that turn beside the pistons may cancel what is not zero.
            family::Zeros::At(found) => (Solutions { irrational: Vec::new(), ..found }, false),
        };
        let value = |turns: &BigRational| turns / &self.open.per_unit;
        let at = found.exact.iter().map(value).filter(|value| self.vanishes_at(vector, value)).collect();
        let irrational = found.irrational.iter().map(|ends| ends.each_ref().map(value)).collect();
        let complete = all || is_never || is_fixed;
        ZeroSet { quantity, order, of, exists: true, everywhere: false, at, irrational, complete }
    }

    /// Whether it vanishes at so many values that it does so at every one.
    fn vanishes_at_enough(&self, vector: Vector) -> bool {
        let mut places = distinct(&self.open, vector.order, self.range.each_ref()).peekable();
        places.peek().is_some() && places.all(|value| self.vanishes_at(vector, &value))
    }

    /// Where the pistons' part of it vanishes.
    fn found(&self, vector: Vector, [direct, reverse]: &[OpenVerdict; 2]) -> family::Zeros {
        let range = self.range.each_ref();
        let unknown = self.open.unknown;
        let component =
            |part| component_zeros(&self.open.family, vector.quantity, vector.order, part, (unknown, range));
        match vector.of {
            Zeros::Direct => direct.zeros(unknown, range),
            Zeros::Reverse => reverse.zeros(unknown, range),
            Zeros::Along => component(Component::Along),
            Zeros::Across => component(Component::Across),
            Zeros::Largest => direct.zeros(unknown, range).and(reverse.zeros(unknown, range)),
        }
    }

    /// Whether the engine with this value has none of it; a value that the file does not read decides nothing.
    fn vanishes_at(&self, vector: Vector, value: &BigRational) -> bool {
        self.reader.engine(std::slice::from_ref(value)).is_ok_and(|engine| vector.vanishes(&engine))
    }
}

/// A vector of an order, both, or a part of their sum.
#[derive(Clone, Copy)]
struct Vector {
    quantity: Planar,
    order: u32,
    of: Zeros,
}

impl Vector {
    /// The masses that turn and enter it beside the pistons.
    fn turning_masses(self, engine: &Engine) -> Vec<TurningMass> {
        let enters = |sense: Sense| self.of.vector().is_none_or(|own| own == sense);
        let all = order::turning_masses(engine).into_iter();
        all.filter(|mass| mass.order == self.order && enters(mass.sense)).collect()
    }

    fn has_turning_masses(self, engine: &Engine) -> bool {
        !self.turning_masses(engine).is_empty()
    }

    /// Whether it vanishes in this engine, decided exactly.
    fn vanishes(self, engine: &Engine) -> bool {
        let [direct, reverse] = Sense::BOTH.map(|sense| order::all_masses(engine, self.quantity, self.order, sense));
        match self.of {
            Zeros::Direct => direct.vanishes(),
            Zeros::Reverse => reverse.vanishes(),
            Zeros::Largest => direct.vanishes() && reverse.vanishes(),
            Zeros::Along => Path::has_nothing_along(&direct, &reverse),
            Zeros::Across => Path::has_nothing_across(&direct, &reverse),
        }
    }
}

/// Where one vector vanishes everywhere, all of the order vanishes where the other does, and so does each of its parts.
fn with_the_other(sets: &[ZeroSet], of: Zeros) -> Option<ZeroSet> {
    let vectors = || sets.iter().filter(|set| set.of.vector().is_some());
    let is_of_both = of.vector().is_none() && vectors().any(|set| set.everywhere);
    let other = vectors().find(|set| !set.everywhere).or_else(|| vectors().next()).filter(|_| is_of_both)?;
    Some(ZeroSet { of, ..other.clone() })
}

/// Whether the parameter turns no term of this vector, so that it is one at every value.
fn is_fixed(open: &OpenAngle, order: u32, of: Zeros) -> bool {
    let turns = |sense, cylinder| !family::phase(cylinder, order, sense).coefficient(open.unknown).is_zero();
    of.vector().is_some_and(|sense| !open.family.cylinders().iter().any(|cylinder| turns(sense, cylinder)))
}

/// More values than this are not tried.
const MOST_TRIED: i64 = 2000;

/// Values of the parameter in its range, at so many different angles that a vector of this order which vanishes at each vanishes everywhere;
/// none where they would be too many.
///
/// Every term, of a piston or of a mass on a throw, turns by `kβ ± (k±1)α`, and β and α by whole multiples of φ/d (φ: the unknown). So each sum is a
/// polynomial in `e^{±iφ/d}`, with at most twice its degree of zeros.
fn distinct(open: &OpenAngle, order: u32, [low, high]: [&BigRational; 2]) -> impl Iterator<Item = BigRational> {
    let OpenAngle { family, unknown, per_unit } = open;
    let angles = || family.cylinders().iter().flat_map(|cylinder| [&cylinder.throw, &cylinder.bank]);
    let steps = angles().map(|angle| angle.coefficient(unknown));
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
