//! On which certificates does an answer rest?

use super::super::argument;
use crate::claim::{Answer, Evidence};
use crate::page::{Text, phrase};
use crate::proof::{Quantity, Sense};

/// The certificates of an answer.
pub fn evidence(answer: &Answer) -> Vec<Text> {
    answer.evidence.iter().map(one).collect()
}

fn one(evidence: &Evidence) -> Text {
    let certificate = argument::certificate_of(evidence.sum(), evidence.certificate());
    let about = match evidence {
        Evidence::Verdict(verdict) => {
            let words = match (verdict.quantity, verdict.sense) {
                (Quantity::Force, Some(Sense::Direct)) => "Force, order {}, direct",
                (Quantity::Force, Some(Sense::Reverse)) => "Force, order {}, reverse",
                (Quantity::Force, None) => "Force, order {}",
                (Quantity::Moment, Some(Sense::Direct)) => "Moment, order {}, direct",
                (Quantity::Moment, Some(Sense::Reverse)) => "Moment, order {}, reverse",
                (Quantity::Moment, None) => "Moment, order {}",
                (Quantity::Torque | Quantity::Roll, _) => "Torque, order {}",
            };
            phrase!(words, verdict.order)
        }
        Evidence::FiringStar(order, _) => phrase!("Firing star of order {}", order.to_string()),
        Evidence::Comparison { about, .. } => (*about).into(),
    };
    match evidence.vanishes() {
        true => phrase!("{}: {}, proved. {}", about, Text::zero(), certificate),
        false => phrase!("{}: not 0, proved. {}", about, certificate),
    }
}
