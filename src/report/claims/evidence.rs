//! On which certificates does an answer rest?

use super::super::argument;
use crate::claim::{Answer, Evidence};
use crate::page::{Text, phrase};

/// The certificates of an answer.
pub(super) fn evidence(answer: &Answer) -> Vec<Text> {
    answer.evidence.iter().map(one).collect()
}

fn one(evidence: &Evidence) -> Text {
    let certificate = argument::certificate_of(evidence.sum(), evidence.certificate());
    let about = match evidence {
        Evidence::Verdict(verdict) => {
            let quantity = super::super::old::capital(verdict.quantity.name());
            match verdict.sense {
                Some(sense) => phrase!("{}, order {}, {}", quantity, verdict.order, sense.name()),
                None => phrase!("{}, order {}", quantity, verdict.order),
            }
        }
        Evidence::Comparison { about, .. } => super::super::old::capital(about).into(),
    };
    match evidence.vanishes() {
        true => phrase!("{}: {}, proved. {}", about, Text::zero(), certificate),
        false => phrase!("{}: not 0, proved. {}", about, certificate),
    }
}
