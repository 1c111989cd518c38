//! Which of all orders vanish? One period of verdicts proves a statement on every order that exists.
//!
//! In each term the order k multiplies an angle, so where L times every throw and bank is whole the sums of order k
//! depend on k only modulo L. A centric engine has order 1 and the even ones.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;

use super::recurrence::MOST_CANDIDATES;
use super::{Balance, Verdict};
use crate::engine::Engine;
use crate::order::{Masses, OrderTerms, Sources};
use crate::proof::{Planar, Quantity, Sense, Survivors};

/// Of longer periods only the orders that may be zero are decided.
pub const LONGEST_PERIOD: u32 = 720;

/// The statements on every order of the force and the moment, with the verdicts that prove them.
#[derive(Clone, Debug)]
pub struct Theorem {
    /// Whose masses they are about.
    pub masses: Masses,
    /// The sums of order k depend on k only modulo this even number.
    pub period: u32,
    /// The shaking force.
    pub force: EveryOrder,
    /// The moment about the reference plane.
    pub moment: EveryOrder,
}

/// Force or moment at every order.
#[derive(Clone, Debug)]
pub struct EveryOrder {
    /// The vectors that turn with the crank: orders 1, 2, 4, … up to the period.
    pub direct: Vec<Verdict>,
    /// The vectors that turn against it, at the same orders.
    pub reverse: Vec<Verdict>,
    /// The lowest order that is left.
    pub first: Option<Balance>,
}

/// Longer periods are not gone through.
pub const LONGEST_SIEVED: u32 = 1_000_000;

/// Why there is no statement on every order.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoTheorem {
    /// The pattern repeats only after this many orders, more than are gone through.
    #[error("the pattern repeats only after {0} orders; at most {LONGEST_SIEVED} are examined")]
    PeriodTooLong(BigInt),
    /// The pattern repeats only after this many orders, and too many of these may be zero.
    #[error(
        "the pattern repeats only after {0} orders, of which more than {MOST_CANDIDATES} may be zero, too many to decide"
    )]
    TooManyCandidates(u32),
    /// Rods are links, which add sums of other kinds.
    #[error("the rods differ, so no order is a single sum")]
    RodsDiffer,
    /// A crankshaft turns this many times while the reference turns once: its pistons have other orders.
    #[error(
        "a crankshaft turns {0} times while the reference turns once, so that its pistons have other orders than those of the reference"
    )]
    FasterCrank(u32),
    /// A balancer shaft turns at this order, beside pistons that have another coefficient.
    #[error(
        "a balancer shaft turns at order {0}, which is not in the pattern of the cylinders; use the reciprocating masses only (`--masses reciprocating`)"
    )]
    Shaft(u32),
}

/// The least even number that makes every throw and bank whole: the sums of order k depend on k only modulo it.
pub fn period(engine: &Engine) -> BigInt {
    let angles = engine.cylinders().iter().flat_map(|cylinder| [&cylinder.throw, &cylinder.bank]);
    angles.fold(BigInt::from(2), |period, angle| period.lcm(angle.denominator()))
}

/// Judges one period of orders; none where the pattern is long, or the engine not one of equal centric rods, whose even orders exist.
pub(super) fn theorem(engine: &Engine, sources: &Sources) -> Option<Theorem> {
    if engine.mechanisms().len() > 1 || engine.has_offset() || !engine.pistons_have_order(Quantity::FORCE, 2) {
        return None;
    }
    let period = period(engine).to_u32().filter(|&period| period <= LONGEST_PERIOD)?;
    let orders = std::iter::once(1).chain((2..=period).step_by(2));
    let terms: Vec<OrderTerms> = orders.map(|order| sources.force_terms(order)).collect();
    let judge = |quantity| EveryOrder::new(&terms, quantity);
    Some(Theorem { masses: sources.masses(), period, force: judge(Planar::Force), moment: judge(Planar::Moment) })
}

impl EveryOrder {
    fn new(orders: &[OrderTerms], quantity: Planar) -> Self {
        // Equal centric cranks have one coefficient in every order, and what turns with them has that of order 1.
        let verdict = |terms: &OrderTerms, sense| Verdict::new(terms, &terms.groups()[0], quantity.into(), Some(sense));
        let judge = |sense| orders.iter().map(|terms| verdict(terms, sense)).collect();
        let mut every = EveryOrder { direct: judge(Sense::Direct), reverse: judge(Sense::Reverse), first: None };
        let survivals = every.survivals();
        let first = orders.iter().zip(survivals).find(|(_, (_, survives))| *survives);
        every.first = first.map(|(terms, _)| Balance::new(terms, &terms.groups()[0], quantity));
        every
    }

    /// The orders at which either vector is left.
    pub fn survivors(&self) -> Survivors {
        shortest(&self.survivals())
    }

    /// Each order of the period, and whether either vector is left.
    fn survivals(&self) -> Vec<(u32, bool)> {
        let pairs = self.direct.iter().zip(&self.reverse);
        pairs.map(|(direct, reverse)| (direct.order, !direct.vanishes() || !reverse.vanishes())).collect()
    }
}

/// The orders at which one vector is left, from its verdicts on one period: orders 1, 2, 4, …
pub fn survivors(verdicts: &[Verdict]) -> Survivors {
    let survivals: Vec<_> = verdicts.iter().map(|verdict| (verdict.order, !verdict.vanishes())).collect();
    shortest(&survivals)
}

/// The statement with the smallest modulus, from order 1 and then the even orders of one period.
fn shortest(survivals: &[(u32, bool)]) -> Survivors {
    let order_one = survivals.first().is_some_and(|(_, survives)| *survives);
    let even: Vec<bool> = survivals.iter().skip(1).map(|(_, survives)| *survives).collect();
    let repeats = |length: &usize| even.len().is_multiple_of(*length) && even[*length..] == even[..even.len() - length];
    let length = (1..=even.len()).find(repeats).unwrap_or(1);
    let modulus = 2 * u32::try_from(length).unwrap_or(u32::MAX / 2);
    let orders = survivals.iter().skip(1).take(length);
    let mut residues: Vec<u32> = orders.filter(|(_, left)| *left).map(|(order, _)| order % modulus).collect();
    residues.sort_unstable();
    Survivors { order_one, modulus, residues }
}
