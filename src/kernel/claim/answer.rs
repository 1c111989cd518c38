//! What is the answer to a claim? A status, what is the case, and the evidence.

use std::borrow::Cow;

use num_rational::BigRational;

use super::finding::Finding;
use crate::engine::CycleOrder;
use crate::exact::PhasorSum;
use crate::firing::FiringStar;
use crate::proof::Certificate;
use crate::verdict::Verdict;

/// Whether a claim holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Status {
    /// It holds, exactly as written or within its tolerance.
    True,
    /// As an exact statement it is false, but its decimals are those of the true value, rounded.
    TrueAsRounded,
    /// It depends on something that the claim leaves unsaid.
    TrueOnlyIf {
        /// What it depends on.
        conditions: Vec<Condition>,
        /// Whether the engine as described meets all of it.
        met: bool,
    },
    /// It does not hold.
    False,
    /// It could not be decided; counted as not holding.
    NotDecided,
}

impl Status {
    /// That of what is decided.
    pub(super) fn of(is_so: bool) -> Self {
        if is_so { Status::True } else { Status::False }
    }

    /// Whether the claim counts as holding.
    pub fn holds(&self) -> bool {
        matches!(self, Status::True | Status::TrueAsRounded | Status::TrueOnlyIf { met: true, .. })
    }
}

/// What a claim may leave unsaid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Condition {
    /// Moments are taken about the plane at this position.
    AboutPlane(BigRational),
    /// Moments are not taken about the plane at this position.
    NotAboutPlane(BigRational),
    /// The two cylinders of a crankpin are in one plane.
    NoBankOffset,
    /// The firing order is one of those that are even: the layout names none.
    FiringOrder,
    /// Of the series of c_k the first term is taken, as textbooks do: c_2 = r/l.
    FirstTermAlone,
}

/// What a status rests on.
#[derive(Clone, Debug)]
pub enum Evidence {
    /// A verdict of the engine.
    Verdict(Verdict),
    /// A firing star of an order.
    FiringStar(CycleOrder, FiringStar),
    /// A further sum that vanishes or does not.
    Comparison {
        /// What the sum is.
        about: &'static str,
        /// The sum.
        sum: PhasorSum,
        /// The proof.
        certificate: Certificate,
    },
}

impl Evidence {
    pub(super) fn comparison(about: &'static str, sum: PhasorSum) -> Self {
        let sum = PhasorSum::new(sum.collected());
        Evidence::Comparison { about, certificate: sum.certificate(), sum }
    }

    /// The sum that the certificate is about.
    pub fn sum(&self) -> &PhasorSum {
        match self {
            Evidence::Verdict(verdict) => &verdict.sum,
            Evidence::FiringStar(_, star) => &star.sum,
            Evidence::Comparison { sum, .. } => sum,
        }
    }

    /// The proof.
    pub fn certificate(&self) -> &Certificate {
        match self {
            Evidence::Verdict(verdict) => &verdict.certificate,
            Evidence::FiringStar(_, star) => &star.certificate,
            Evidence::Comparison { certificate, .. } => certificate,
        }
    }

    /// Whether the sum is zero.
    pub fn vanishes(&self) -> bool {
        self.certificate().claims_zero()
    }
}

/// The answer to a claim.
#[derive(Clone, Debug)]
pub struct Answer {
    /// Whether it holds.
    pub status: Status,
    /// What is the case.
    pub finding: Finding,
    /// What both rest on.
    pub evidence: Vec<Evidence>,
}

impl Answer {
    pub(super) fn nothing(reason: impl Into<Cow<'static, str>>) -> Self {
        Answer { status: Status::NotDecided, finding: Finding::Nothing(reason.into()), evidence: Vec::new() }
    }
}
