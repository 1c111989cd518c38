//! How does the engine balance? For each order a verdict with its evidence, and the shape of what is left.

mod firmness;
mod reason;
mod theorem;

pub use firmness::{Disturbance, Firmness, Outcome, firmness};
pub use reason::{Reason, mirror_partners, opposed_partners, reason};
pub use theorem::{EveryOrder, LONGEST_PERIOD, NoTheorem, Theorem, period, survivors, theorem};

use crate::engine::{Engine, Mechanism};
use crate::exact::PhasorSum;
use crate::order;
use crate::proof::{Certificate, Quantity, Sense, Shape};

/// Whether one phasor sum of the engine vanishes, with the evidence.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// Force, moment or torque.
    pub quantity: Quantity,
    /// The order k.
    pub order: u32,
    /// Direct or reverse; none for the torque.
    pub sense: Option<Sense>,
    /// The sum, one term a cylinder.
    pub sum: PhasorSum,
    /// The evidence.
    pub certificate: Certificate,
}

impl Verdict {
    fn new(layout: &Engine, quantity: Quantity, order: u32, sense: Option<Sense>) -> Self {
        Verdict::of(quantity, order, sense, order::star(layout, quantity, order, sense))
    }

    fn of(quantity: Quantity, order: u32, sense: Option<Sense>, sum: PhasorSum) -> Self {
        let certificate = sum.certificate();
        Verdict { quantity, order, sense, sum, certificate }
    }

    /// Whether the sum is zero.
    pub fn vanishes(&self) -> bool {
        self.certificate.claims_zero()
    }
}

/// The two vectors of one order of the force or the moment, and what their sum traces.
#[derive(Clone, Debug)]
pub struct Balance {
    /// The vector that turns with the crank.
    pub direct: Verdict,
    /// The vector that turns against it.
    pub reverse: Verdict,
    /// What is left.
    pub shape: Shape,
    /// Where neither vanishes: whether `|direct|² − |reverse|²` does.
    pub comparison: Option<Certificate>,
}

impl Balance {
    fn new(layout: &Engine, quantity: Quantity, order: u32) -> Self {
        let sum = |sense| order::star(layout, quantity, order, Some(sense));
        Balance::of(quantity, order, sum(Sense::Direct), sum(Sense::Reverse))
    }

    /// Judges any two sums as the vectors of one order: those of other masses than the reciprocating ones.
    pub fn of(quantity: Quantity, order: u32, direct: PhasorSum, reverse: PhasorSum) -> Self {
        let direct = Verdict::of(quantity, order, Some(Sense::Direct), direct);
        let reverse = Verdict::of(quantity, order, Some(Sense::Reverse), reverse);
        let (shape, comparison) = match (direct.vanishes(), reverse.vanishes()) {
            (true, true) => (Shape::Balanced, None),
            (false, true) => (Shape::Rotating, None),
            (true, false) => (Shape::CounterRotating, None),
            (false, false) => {
                let difference = direct.sum.squared_modulus().minus(&reverse.sum.squared_modulus());
                let certificate = PhasorSum::new(difference.collected()).certificate();
                let shape = if certificate.claims_zero() { Shape::Planar } else { Shape::Elliptical };
                (shape, Some(certificate))
            }
        };
        Balance { direct, reverse, shape, comparison }
    }

    /// Whether both vectors vanish.
    pub fn is_balanced(&self) -> bool {
        self.shape == Shape::Balanced
    }

    /// Both verdicts, direct first.
    pub fn verdicts(&self) -> [&Verdict; 2] {
        [&self.direct, &self.reverse]
    }
}

/// Cylinders with equal rods: only they have the coefficient c_k in common, so that their sum is judged by itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Class {
    /// What moves their pistons.
    pub mechanism: Mechanism,
    /// The names of the cylinders.
    pub cylinders: Vec<String>,
}

/// All verdicts on one order.
#[derive(Clone, Debug)]
pub struct OrderBalance {
    /// The order k.
    pub order: u32,
    /// Whether some of these pistons have the order; else its force and moment are 0 whatever the sums are.
    pub exists: bool,
    /// The same of the torque.
    pub torque_exists: bool,
    /// Which cylinders it is about, where the engine has rods that differ; none where it is about all.
    pub class: Option<Class>,
    /// The shaking force.
    pub force: Balance,
    /// The moment about the reference plane; a free couple where the force of this order vanishes.
    pub moment: Balance,
    /// The inertia torque, where it was asked for.
    pub torque: Option<Verdict>,
}

impl OrderBalance {
    /// Whether the moment is the same about every plane: the force of this order vanishes.
    pub fn moment_is_couple(&self) -> bool {
        self.force.is_balanced()
    }
}

/// Judges the given orders of an engine; the inertia torque only where it is asked for. There is no order 0: it gets no verdict.
///
/// Where rods differ, each class of equal ones is judged by itself: the sum of an order vanishes, whatever the
/// coefficients, where each class does. All centric cranks have `c_1 = 1` in common.
pub fn classify(layout: &Engine, orders: &[u32], with_torque: bool) -> Vec<OrderBalance> {
    let rods = layout.mechanisms();
    let judge = |layout: &Engine, order: u32, class: Option<Class>| OrderBalance {
        order,
        exists: has_order(layout, class.as_ref(), Quantity::Force, order),
        torque_exists: has_order(layout, class.as_ref(), Quantity::Torque, order),
        class,
        force: Balance::new(layout, Quantity::Force, order),
        moment: Balance::new(layout, Quantity::Moment, order),
        torque: with_torque.then(|| Verdict::new(layout, Quantity::Torque, order, None)),
    };
    let by_class = |order: u32| match rods.as_slice() {
        rods if rods.len() > 1 && (order > 1 || layout.has_offset() || with_torque) => {
            rods.iter().map(|rod| judge(&layout.only_with(rod), order, Some(Class::new(layout, rod)))).collect()
        }
        _ => vec![judge(layout, order, None)],
    };
    judged(orders).flat_map(by_class).collect()
}

/// The orders that the inertia torque is judged at: the first four, and those of force and moment.
pub fn torque_orders(orders: &[u32]) -> Vec<u32> {
    let mut all: Vec<u32> = [1, 2, 3, 4].into_iter().chain(orders.iter().copied()).collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// Judges the inertia torque of an engine with equal rods at these orders; 0 is no order and is not judged.
pub fn torque(layout: &Engine, orders: &[u32]) -> Vec<Verdict> {
    judged(orders).map(|order| Verdict::new(layout, Quantity::Torque, order, None)).collect()
}

fn has_order(layout: &Engine, class: Option<&Class>, quantity: Quantity, order: u32) -> bool {
    match class {
        Some(class) => class.mechanism.has_order(quantity, order),
        None => layout.pistons_have_order(quantity, order),
    }
}

/// The numbers of a list that are orders.
fn judged(orders: &[u32]) -> impl Iterator<Item = u32> {
    orders.iter().copied().filter(|order| *order > 0)
}

impl Class {
    fn new(layout: &Engine, mechanism: &Mechanism) -> Self {
        let of = layout.cylinders().iter().filter(|cylinder| cylinder.mechanism.as_ref() == Some(mechanism));
        Class { mechanism: mechanism.clone(), cylinders: of.map(|cylinder| cylinder.name.clone()).collect() }
    }
}
