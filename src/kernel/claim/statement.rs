//! What can be claimed? One order of a quantity, many orders at once, the firing.

use num_rational::BigRational;

use super::formula::{Formula, Measured, Series};
use crate::engine::CycleOrder;
use crate::firing::Weights;
use crate::numbers::Form;
use crate::order::Masses;
use crate::proof::{Quantity, Sense, Shape};

/// What a statement is about, as far as answers and pages differ by it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Topic {
    /// Orders of force, moment and torque.
    Orders,
    /// A moment that stays wherever the reference plane stands.
    FreeMoment,
    /// Forces of gas and masses through the cycle.
    Forces,
    /// Cures, masses, loads of the masses alone, firing.
    Other,
}

impl Statement {
    /// What it is about.
    pub fn topic(&self) -> Topic {
        match self {
            Statement::Order { .. } | Statement::Vanish { .. } => Topic::Orders,
            Statement::NoFreeMoment => Topic::FreeMoment,
            Statement::Formula(_) | Statement::LargestLoad(..) => Topic::Forces,
            Statement::ShakingForce(_)
            | Statement::Shafts { .. }
            | Statement::CanBalance(_)
            | Statement::CrankshaftMass(_)
            | Statement::BearingLoad(_)
            | Statement::WorstBearings(_)
            | Statement::GasTorque { .. }
            | Statement::FiresEvenly { .. } => Topic::Other,
        }
    }
}

/// A claim about an engine, as the grammar reads it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Statement {
    /// One order of the force, the moment or the torque.
    Order {
        /// What the claim is about.
        subject: Subject,
        /// What it says.
        predicate: Predicate,
    },
    /// Orders that are all said to vanish.
    Vanish {
        /// Which orders.
        orders: Orders,
        /// Force, moment, or both where it is empty of a name.
        quantities: Vec<Quantity>,
    },
    /// No order leaves a moment that stays wherever the reference plane stands.
    NoFreeMoment,
    /// What cancels an order: the least set of balancer shafts beside counterweights.
    Shafts {
        /// The order.
        order: u32,
        /// What it is said to need.
        shafts: Shafts,
    },
    /// Counterweights that do it exist.
    CanBalance(Possible),
    /// The crankshaft's mass in the thesis's sense, in kilograms ([`crate::engine::Engine::crankshaft_mass`]).
    CrankshaftMass(Value),
    /// The largest force on any main bearing.
    BearingLoad(Value),
    /// The main bearings, by their numbers from 1, each of which feels a larger force than any other.
    WorstBearings(Vec<usize>),
    /// A largest load of gas and masses together through the cycle.
    LargestLoad(Loaded, Value),
    /// The shaking force of the pistons as a Fourier series.
    ShakingForce(ShakingForce),
    /// A formula of one cylinder, through its cycle.
    Formula(OfCylinder),
    /// Orders of the gas torque, for every pressure law that the cylinders share.
    GasTorque {
        /// Which orders.
        orders: Vec<CycleOrder>,
        /// What is said of them.
        says: GasTorque,
        /// For a rigid crankshaft, or in a mode of torsional vibration.
        weights: Weights,
    },
    /// Whether the firing intervals are equal.
    FiresEvenly {
        /// False where the claim denies it.
        evenly: bool,
    },
}

/// What feels a load of gas and masses together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loaded {
    /// A main bearing.
    MainBearing,
    /// A crankpin, of the rod of one cylinder.
    Crankpin,
    /// A rod that is pressed.
    Rod,
    /// A cylinder, of its piston's side force.
    Cylinder,
}

/// What is said of one cylinder: a formula for what it measures, at every crank angle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OfCylinder {
    /// What the formula is said of.
    pub what: Measured,
    /// The formula.
    pub formula: Formula,
    /// How far it may be off, as a part of the largest value; none where it is said to be equal.
    pub within: Option<BigRational>,
}

/// The shaking force of the pistons, as a series.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ShakingForce {
    /// Whether the part across the reference direction is meant, to the left, or that along it; none where the claim does not say.
    pub across: Option<bool>,
    /// The series.
    pub series: Series,
}

/// What is said of orders of the gas torque.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GasTorque {
    /// Each of them vanishes, or (false) none of them does.
    Vanishes(bool),
    /// They are the minor orders with the longest stars, mirror images not counted.
    StrongestMinor,
}

/// What an order is said to need for force and moment to vanish.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shafts {
    /// Neither counterweights nor a shaft.
    Nothing,
    /// No shaft; at order 1 perhaps counterweights.
    None,
    /// Counterweights and no shaft, at order 1.
    Counterweights,
    /// One that turns with the crank, above order 1.
    With,
    /// One that turns against the crank; at order 1 perhaps counterweights besides.
    Against,
    /// One that turns with the crank, above order 1, and perhaps another.
    AmongThemWith,
    /// One that turns against the crank, and perhaps another.
    AmongThemAgainst,
    /// One each way, above order 1.
    Two,
    /// One each way with one weight each, both alike.
    Lanchester,
}

/// What counterweights in one plane or two are said to be able to do, each at the crank radius and turned as it may.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Possible {
    /// Where they stand along the crankshaft, in the unit of the positions: one plane or two.
    pub planes: Vec<BigRational>,
    /// What they cancel of all that turns with the crank at order 1.
    pub balanced: Balanced,
    /// The crankshaft's mass in kilograms that it stays below with them.
    pub lighter_than: Option<BigRational>,
}

/// What is taken away of the direct vectors of order 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Balanced {
    /// The force and the moment.
    ForceAndMoment,
    /// The moment about the reference plane; the force stays as it is.
    Moment,
}

/// One order of one quantity, or one of its two vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Subject {
    /// The order k.
    pub order: u32,
    /// The direct or the reverse vector alone; none means both together.
    pub sense: Option<Sense>,
    /// Force, moment or torque.
    pub quantity: Quantity,
    /// Whose.
    pub masses: Masses,
}

/// Which orders a claim about many is about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Orders {
    /// All that exist from this one on: from 1, or from 2.
    From(u32),
    /// These.
    Listed(Vec<u32>),
}

/// What is said about one order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Predicate {
    /// It vanishes, or (false) it does not.
    Vanishes(bool),
    /// What is left has this shape.
    Is(Shape),
    /// Its largest value, and perhaps its direction.
    Equals(Value, Option<Angle>),
    /// The line it is on, modulo 180°.
    Plane(Angle),
}

/// A length as claimed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Value {
    /// The number, exactly as written.
    pub form: Form,
    /// How near it has to be.
    pub tolerance: Tolerance,
    /// Newtons, newton-metres or spacings; none counts in m r ω² c_k and the unit of the positions.
    pub unit: Option<Unit>,
    /// Whether m r ω² is named without c_1.
    pub is_bare: bool,
}

/// A direction as claimed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Angle {
    /// The direction, exactly as written.
    pub bearing: Bearing,
    /// How near it has to be, in degrees.
    pub tolerance: Tolerance,
}

/// A direction in one of the two ways of writing it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Bearing {
    /// In turns.
    Turns(BigRational),
    /// The angle in (−90°, 90°) of this tangent.
    Arctangent(Form),
}

/// How near a number has to be to the true one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Tolerance {
    /// It is the number; where decimals are written, half of the last place is kept separately as rounding.
    Exact {
        /// Half a unit of the last decimal written, where there are decimals.
        rounding: Option<BigRational>,
    },
    /// Within this much.
    Within(BigRational),
    /// Within this part of the claimed number.
    Part(BigRational),
}

/// Units of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// N.
    Newton,
    /// N·m.
    NewtonMetre,
    /// m r ω² c_k a, where a is the spacing of the engine.
    Spacing,
}
