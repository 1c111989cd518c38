//! Is a zero firm or accidental: which disturbances of the engine does it survive?
//!
//! What is disturbed becomes independent symbols: one a position, a bank, a cylinder. The order stays zero for all
//! their values iff the coefficient of every symbol, again a phasor sum, is zero; that is decided exactly.

use std::collections::{BTreeMap, BTreeSet};

use num_traits::{Signed, Zero};

use super::{Balance, Verdict};
use crate::engine::{Cylinder, Engine};
use crate::exact::{PhasorSum, Term, fraction};
use crate::order::{self, Source};
use crate::proof::Quantity;

/// What is changed on the engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Disturbance {
    /// Uneven spacing, symmetric about the reference plane: positions at equal distances from it move alike.
    SymmetricSpacing,
    /// Any spacing: each position moves by itself.
    AnySpacing,
    /// Each bank moves along the shaft as a whole, about their common middle.
    BankOffset,
    /// Masses that differ from bank to bank.
    BankMasses,
    /// Masses that differ from cylinder to cylinder.
    CylinderMasses,
}

impl Disturbance {
    /// All of them, spacing first.
    pub const ALL: [Disturbance; 5] = [
        Disturbance::SymmetricSpacing,
        Disturbance::AnySpacing,
        Disturbance::BankOffset,
        Disturbance::BankMasses,
        Disturbance::CylinderMasses,
    ];
}

/// What becomes of a zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FirmnessOutcome {
    /// It stays zero, however large the disturbance.
    Survives,
    /// It is zero no longer, but for special values of the disturbance.
    Breaks,
    /// The engine or the quantity leaves nothing to disturb.
    DoesNotApply,
}

/// What becomes of one zero under every disturbance.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Firmness {
    outcomes: [FirmnessOutcome; 5],
}

impl Firmness {
    /// What becomes of the zero under this disturbance.
    pub fn outcome(&self, disturbance: Disturbance) -> FirmnessOutcome {
        self.outcomes[disturbance as usize]
    }

    /// Whether the zero breaks under this disturbance.
    pub fn breaks(&self, disturbance: Disturbance) -> bool {
        self.outcome(disturbance) == FirmnessOutcome::Breaks
    }

    /// Whether only masses that differ from cylinder to cylinder can break the zero.
    pub fn is_firm(&self) -> bool {
        Disturbance::ALL.into_iter().all(|one| one == Disturbance::CylinderMasses || !self.breaks(one))
    }
}

/// How firm the zero of a balance is; `None` where something is left, and where it is not about the pistons of all cylinders.
pub fn firmness(engine: &Engine, balance: &Balance) -> Option<Firmness> {
    let outcome = |disturbance| {
        let coefficients = balance.verdicts().map(|verdict| coefficients(engine, verdict, disturbance));
        match coefficients.into_iter().collect::<Option<Vec<_>>>() {
            None => FirmnessOutcome::DoesNotApply,
            Some(sums) if sums.iter().flatten().all(PhasorSum::vanishes) => FirmnessOutcome::Survives,
            Some(_) => FirmnessOutcome::Breaks,
        }
    };
    let pistons = (0..engine.cylinders().len()).map(Source::Piston);
    let of_pistons = balance.verdicts().into_iter().all(|verdict| verdict.sources.iter().copied().eq(pistons.clone()));
    // A link has terms before several numbers, but in order 1 of one at the angle of its cylinder, and no disturbance moves those of one alone.
    let is_one_star = engine.has_one_vector_per_order() || (balance.direct.order == 1 && engine.is_centric());
    (of_pistons && is_one_star && balance.is_balanced()).then(|| Firmness { outcomes: Disturbance::ALL.map(outcome) })
}

/// The coefficient of every symbol of a disturbance; `None` where it does not apply.
fn coefficients(engine: &Engine, verdict: &Verdict, disturbance: Disturbance) -> Option<Vec<PhasorSum>> {
    let moves_cylinders = !matches!(disturbance, Disturbance::BankMasses | Disturbance::CylinderMasses);
    if moves_cylinders && verdict.quantity != Quantity::MOMENT {
        return None;
    }
    let banks = distinct(engine, |cylinder| cylinder.bank.clone()).len();
    let force = || order::star(engine, Quantity::FORCE, verdict.order, verdict.sense);
    let bank = |cylinder: &Cylinder| cylinder.bank.clone();
    match disturbance {
        Disturbance::SymmetricSpacing => {
            let arms = distinct(engine, |cylinder| engine.arm(cylinder));
            let is_symmetric = arms.iter().all(|arm| arms.contains(&-arm));
            let sums = || grouped(engine, &either_side(engine, &force()), |cylinder| engine.arm(cylinder).abs());
            (is_symmetric && arms.iter().any(|arm| !arm.is_zero())).then(sums)
        }
        Disturbance::AnySpacing => {
            let positions = distinct(engine, |cylinder| cylinder.position.clone()).len();
            (positions > 1).then(|| grouped(engine, &force(), |cylinder| cylinder.position.clone()))
        }
        Disturbance::BankOffset => (banks > 1).then(|| differences(&grouped(engine, &force(), bank))),
        // Where every bank is one cylinder, this is no disturbance of its own.
        Disturbance::BankMasses => {
            (banks > 1 && banks < engine.cylinders().len()).then(|| grouped(engine, &verdict.sum, bank))
        }
        Disturbance::CylinderMasses => {
            Some(verdict.sum.terms().iter().map(|term| PhasorSum::new(vec![term.clone()])).collect())
        }
    }
}

/// The sum with the terms below the reference plane reversed, and those in it omitted.
fn either_side(engine: &Engine, sum: &PhasorSum) -> PhasorSum {
    let terms = engine.cylinders().iter().zip(sum.terms());
    let signed = |(cylinder, term): (&Cylinder, &Term)| Term {
        angle: term.angle.clone(),
        weight: fraction::times(&term.weight, &engine.arm(cylinder).signum()),
    };
    PhasorSum::new(terms.map(signed).collect())
}

/// Offsets `b` of the banks add `Σ b_j S_j` to the moment. Moving all banks alike is a change of the reference plane, so
/// `Σ b_j = 0`: then it is zero for all offsets iff all `S_j` are equal (and all zero, where the force vanishes).
fn differences(sums: &[PhasorSum]) -> Vec<PhasorSum> {
    sums.windows(2).map(|pair| pair[1].minus(&pair[0])).collect()
}

fn distinct<K: Ord>(engine: &Engine, key: impl Fn(&Cylinder) -> K) -> BTreeSet<K> {
    engine.cylinders().iter().map(key).collect()
}

/// The sums over the cylinders that share something.
fn grouped<K: Ord>(engine: &Engine, sum: &PhasorSum, key: impl Fn(&Cylinder) -> K) -> Vec<PhasorSum> {
    let mut groups: BTreeMap<K, Vec<Term>> = BTreeMap::new();
    for (cylinder, term) in engine.cylinders().iter().zip(sum.terms()) {
        groups.entry(key(cylinder)).or_default().push(term.clone());
    }
    groups.into_values().map(PhasorSum::new).collect()
}
