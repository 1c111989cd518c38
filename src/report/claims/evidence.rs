//! On which certificates does an answer rest?

use super::super::argument;
use crate::claim::{Answer, Evidence};
use crate::page::{Text, phrase};
use crate::proof::Quantity;

/// The certificates of an answer.
pub(super) fn evidence(answer: &Answer) -> Vec<Text> {
    answer.evidence.iter().map(one).collect()
}

fn one(evidence: &Evidence) -> Text {
    let certificate = argument::certificate_of(evidence.sum(), evidence.certificate());
    let about = match evidence {
        Evidence::Verdict(verdict) => {
            let quantity = match verdict.quantity {
                Quantity::Force => "Force",
                Quantity::Moment => "Moment",
                Quantity::Torque => "Torque",
            };
            match verdict.sense {
                Some(sense) => phrase!("{}, order {}, {}", quantity, verdict.order, sense.name()),
                None => phrase!("{}, order {}", quantity, verdict.order),
            }
        }
        Evidence::Comparison { about, .. } => (*about).into(),
    };
    match evidence.vanishes() {
        true => phrase!("{}: {}, proved. {}", about, Text::zero(), certificate),
        false => phrase!("{}: not 0, proved. {}", about, certificate),
    }
}
