//! How does the engine balance? For each order a verdict with its evidence, and the shape of what is left.

mod firmness;
mod reason;
mod theorem;

pub use firmness::{Disturbance, Firmness, Outcome, firmness};
pub use reason::{Reason, mirror_partners, opposed_partners, reason};
pub use theorem::{EveryOrder, LONGEST_PERIOD, PeriodTooLong, Theorem, period, survivors, theorem};

use crate::exact::PhasorSum;
use crate::layout::Layout;
use crate::phasor;
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
    fn new(layout: &Layout, quantity: Quantity, order: u32, sense: Option<Sense>) -> Self {
        Verdict::of(quantity, order, sense, phasor::sum(layout, quantity, order, sense))
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
    fn new(layout: &Layout, quantity: Quantity, order: u32) -> Self {
        let sum = |sense| phasor::sum(layout, quantity, order, Some(sense));
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

/// All verdicts on one order.
#[derive(Clone, Debug)]
pub struct OrderBalance {
    /// The order k.
    pub order: u32,
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

/// Judges the given orders of an engine; the inertia torque only where it is asked for.
pub fn classify(layout: &Layout, orders: &[u32], with_torque: bool) -> Vec<OrderBalance> {
    let judge = |&order: &u32| OrderBalance {
        order,
        force: Balance::new(layout, Quantity::Force, order),
        moment: Balance::new(layout, Quantity::Moment, order),
        torque: with_torque.then(|| Verdict::new(layout, Quantity::Torque, order, None)),
    };
    orders.iter().map(judge).collect()
}
