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
                (Quantity::FORCE, Some(Sense::Direct)) => "Force, order {}, direct",
                (Quantity::FORCE, Some(Sense::Reverse)) => "Force, order {}, reverse",
                (Quantity::FORCE, None) => "Force, order {}",
                (Quantity::MOMENT, Some(Sense::Direct)) => "Moment, order {}, direct",
                (Quantity::MOMENT, Some(Sense::Reverse)) => "Moment, order {}, reverse",
                (Quantity::MOMENT, None) => "Moment, order {}",
                (Quantity::Axial(_), _) => "Torque, order {}",
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
