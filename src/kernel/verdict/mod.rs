//! How does the engine balance? For each order a verdict with its evidence, and the shape of what is left.

mod balance;
mod firmness;
mod judgement;
mod reason;
mod recurrence;
mod theorem;
mod whole;

pub use balance::{Balance, Class, JudgedStar, Verdict};
pub use firmness::{Disturbance, Firmness, FirmnessOutcome, firmness};
pub use judgement::{Judgement, NotJudged, quantities};
pub use reason::{
    Component, Reason, Size, corners, drawn_polygons, mirror_axis, mirror_partners, opposed_partners, reason,
};
pub use recurrence::{
    AtOrder, ClassPattern, EveryOrderTheorem, FactorPattern, FirstLeft, MOST_CANDIDATES, NextLeft, Recurrence,
    Recurrences, Stars, every_order,
};
pub use theorem::{EveryOrder, LONGEST_PERIOD, LONGEST_SIEVED, NoTheorem, Theorem, period, survivors};
pub use whole::{Outcome, WholeOrder, both_vanish};

use crate::engine::{Engine, NotAnOrder, are_orders};
use crate::order::{Coefficients, Factor, Group, Masses, Sources};
use crate::proof::{Axial, Planar, Quantity, ShapeEvidence};
use whole::Part;

/// The verdicts on one order: the whole of it, and the sums that it is made of.
#[derive(Clone, Debug)]
pub struct OrderVerdict {
    /// The order k.
    pub order: u32,
    /// Whose masses it is about.
    pub masses: Masses,
    /// Force and moment by what their sums are multiplied by: one where all sources have it in common.
    pub parts: Vec<OrderBalance>,
    /// The shaking force.
    pub force: WholeOrder,
    /// The moment about the reference plane; a free couple where the force of this order vanishes.
    pub moment: WholeOrder,
    /// The inertia torque, where it was asked for; that of crankshafts that are geared together at the reference one.
    pub torque: Option<TorqueVerdict>,
    /// The roll moment on the frame about the middle of the engine, where it was asked for.
    pub roll: Option<TorqueVerdict>,
}

/// Force and moment of sources whose terms are multiplied by one number.
#[derive(Clone, Debug)]
pub struct OrderBalance {
    /// The order k.
    pub order: u32,
    /// The number.
    pub factor: Factor,
    /// Whether the number is not zero; else force and moment are 0 whatever the sums are.
    pub exists: bool,
    /// Which sources it is about; none where it is about all, before the number of this order.
    pub class: Option<Class>,
    /// The shaking force.
    pub force: Balance,
    /// The moment about the reference plane.
    pub moment: Balance,
}

/// The inertia torque of one order, or the roll moment: what has one vector.
#[derive(Clone, Debug)]
pub struct TorqueVerdict {
    /// The sums by what they are multiplied by, and whether that is not zero.
    pub parts: Vec<TorquePart>,
    /// Whether it vanishes.
    pub outcome: Outcome,
}

/// What is multiplied by one number of it.
#[derive(Clone, Debug)]
pub struct TorquePart {
    /// Whether its coefficient is not zero.
    pub exists: bool,
    /// Which sources it is about; none where it is about all.
    pub class: Option<Class>,
    /// The verdict.
    pub verdict: Verdict,
}

impl OrderVerdict {
    /// Whether some source has the order; else its force and moment are 0 whatever the sums are.
    pub fn exists(&self) -> bool {
        self.parts.iter().any(|part| part.exists)
    }

    /// The force or the moment.
    pub fn whole(&self, quantity: Planar) -> &WholeOrder {
        quantity.choose(&self.force, &self.moment)
    }

    /// The torque or the roll moment, where it was asked for.
    pub fn about_the_axis(&self, quantity: Axial) -> Option<&TorqueVerdict> {
        match quantity {
            Axial::Torque => self.torque.as_ref(),
            Axial::Roll => self.roll.as_ref(),
        }
    }

    /// Whether the moment is the same about every plane: the force of this order vanishes.
    pub fn moment_is_couple(&self) -> bool {
        !self.exists() || self.force.is_balanced()
    }
}

impl OrderBalance {
    /// Of the force or the moment.
    pub fn balance(&self, quantity: Planar) -> &Balance {
        quantity.choose(&self.force, &self.moment)
    }

    /// Whether the moment is the same about every plane: the force of this order vanishes.
    pub fn moment_is_couple(&self) -> bool {
        self.force.is_balanced()
    }
}

impl TorqueVerdict {
    /// Whether some cylinder has the order.
    pub fn exists(&self) -> bool {
        self.parts.iter().any(|part| part.exists)
    }
}

/// Judges the given orders of an engine, force and moment, and the inertia torque where it is among the quantities.
///
/// Terms that are multiplied by one number are one sum; it is decided by itself, and all sums of an order together.
///
/// # Errors
/// A number that is no order.
pub fn classify(
    engine: &Engine,
    orders: &[u32],
    masses: Masses,
    quantities: &[Quantity],
) -> Result<Vec<OrderVerdict>, NotAnOrder> {
    are_orders(orders)?;
    let sources = Sources::new(engine, masses);
    let known = Coefficients::default();
    Ok(orders.iter().map(|&order| of_order(&sources, order, quantities, &known)).collect())
}

fn of_order(sources: &Sources, order: u32, quantities: &[Quantity], known: &Coefficients) -> OrderVerdict {
    let about_the_axis = |quantity: Axial| {
        quantities.contains(&Quantity::Axial(quantity)).then(|| one_vector(sources, quantity, order, known))
    };
    let terms = sources.force_terms(order);
    let groups = terms.groups();
    let class = |group: &Group| Class::of(sources, group, groups.len(), order);
    let part = |group: &Group| OrderBalance {
        order,
        factor: group.factor.clone(),
        exists: group.exists,
        class: class(group),
        force: Balance::new(&terms, group, Planar::Force),
        moment: Balance::new(&terms, group, Planar::Moment),
    };
    let parts: Vec<OrderBalance> = groups.iter().map(part).collect();
    let exists = parts.iter().any(|part| part.exists);
    let whole = |balance: fn(&OrderBalance) -> &Balance| match parts.as_slice() {
        _ if !exists => WholeOrder::of_none(),
        [only] => of_one(balance(only)),
        several => {
            let of_sense = |sense: usize| -> Vec<Part> {
                let pairs = groups.iter().zip(several);
                let part = |(group, part)| Part::new(group, balance(part).verdicts()[sense]);
                pairs.map(part).collect()
            };
            WholeOrder::new([&of_sense(0), &of_sense(1)], order, known)
        }
    };
    OrderVerdict {
        order,
        masses: sources.masses(),
        force: whole(|part| &part.force),
        moment: whole(|part| &part.moment),
        torque: about_the_axis(Axial::Torque),
        roll: about_the_axis(Axial::Roll),
        parts,
    }
}

impl<'a> Part<'a> {
    fn new(group: &'a Group, verdict: &'a Verdict) -> Self {
        Part { factor: &group.factor, exists: group.exists, verdict }
    }
}

/// The whole of one sum is that sum.
fn of_one(balance: &Balance) -> WholeOrder {
    WholeOrder {
        outcomes: balance.verdicts().map(Outcome::of_one),
        shape: balance.shape,
        evidence: balance.comparison.clone().map(ShapeEvidence::Certificate),
    }
}

/// Of the torque or the roll moment.
fn one_vector(sources: &Sources, quantity: Axial, order: u32, known: &Coefficients) -> TorqueVerdict {
    let terms = match quantity {
        Axial::Torque => sources.torque_terms(order),
        Axial::Roll => sources.roll_terms(order),
    };
    let groups = terms.groups();
    let part = |group: &Group| TorquePart {
        exists: group.exists,
        class: Class::of(sources, group, groups.len(), order),
        verdict: Verdict::new(&terms, group, Quantity::Axial(quantity), None),
    };
    let parts: Vec<TorquePart> = groups.iter().map(part).collect();
    let outcome = match parts.as_slice() {
        [only] => Outcome::of_one(&only.verdict),
        several => {
            let pairs = groups.iter().zip(several).map(|(group, part)| Part::new(group, &part.verdict));
            whole::outcome(&pairs.collect::<Vec<_>>(), order, known)
        }
    };
    TorqueVerdict { parts, outcome }
}

/// The orders that the inertia torque is decided at: the first four, and those of force and moment.
pub fn torque_orders(orders: &[u32]) -> Vec<u32> {
    let mut all: Vec<u32> = [1, 2, 3, 4].into_iter().chain(orders.iter().copied()).collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// Judges the inertia torque of an engine at these orders.
///
/// # Errors
/// A number that is no order.
pub fn torque(engine: &Engine, orders: &[u32]) -> Result<Vec<TorqueVerdict>, NotAnOrder> {
    are_orders(orders)?;
    let sources = Sources::new(engine, Masses::Reciprocating);
    let known = Coefficients::default();
    Ok(orders.iter().map(|&order| one_vector(&sources, Axial::Torque, order, &known)).collect())
}
