//! How are the statements on every order written as data, class by class?

use num_traits::ToPrimitive;

use crate::engine::Engine;
use crate::order::Source;
use crate::proof::{ClassClaim, FirstOrderClaim, RecurrenceClaim, Sense, SumVerdict, WholeOutcome};
use crate::verdict::{ClassPattern, OrderBalance, Outcome, Recurrence, Recurrences};

/// One claim for each quantity and sense, with the verdicts that prove it.
pub(super) fn claims(engine: &Engine, all: &Recurrences) -> Vec<RecurrenceClaim> {
    let class = |class: &ClassPattern| class_claim(engine, class);
    let claim = |one: &Recurrence| RecurrenceClaim {
        quantity: one.quantity.into(),
        sense: one.sense,
        first: first(all, one),
        even: one.even.iter().map(class).collect(),
        odd: one.odd.iter().map(class).collect(),
    };
    all.force.iter().chain(&all.moment).map(claim).collect()
}

fn first(all: &Recurrences, one: &Recurrence) -> FirstOrderClaim {
    let place = usize::from(one.sense == Sense::Reverse);
    let verdict = |part: &OrderBalance| {
        let verdict = part.balance(one.quantity).verdicts()[place];
        SumVerdict { vanishes: verdict.vanishes(), certificate: verdict.certificate.clone() }
    };
    let has_several = all.first.parts.len() > 1;
    FirstOrderClaim {
        sums: all.first.parts.iter().map(verdict).collect(),
        outcome: has_several.then(|| outcome_claim(&all.first.whole(one.quantity).outcomes[place])),
    }
}

fn class_claim(engine: &Engine, class: &ClassPattern) -> ClassClaim {
    let name = |source: &Source| source.name(engine);
    ClassClaim {
        of: class.sources.iter().map(name).collect(),
        factors: class.stars.factors().into_iter().map(|factor| factor.claim.clone()).collect(),
    }
}

pub(super) fn outcome_claim(outcome: &Outcome) -> WholeOutcome {
    match outcome {
        Outcome::Zero => WholeOutcome::Zero,
        Outcome::NotZero => WholeOutcome::NotZero,
        Outcome::NotZeroByEnclosure { bits } => WholeOutcome::NotZeroByEnclosure { bits: *bits },
        Outcome::NotDecided { below } => {
            WholeOutcome::NotDecided { below: below.to_f64().unwrap_or(f64::MAX).next_up() }
        }
        Outcome::Open => WholeOutcome::Open,
    }
}
