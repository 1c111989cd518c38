//! Does one phasor sum vanish, and what do the two sums of an order trace together?

use crate::exact::PhasorSum;
use crate::order::{Factor, Group, OrderTerms, Source, Sources};
use crate::proof::{Certificate, Planar, Quantity, Sense, Shape};

/// Whether one phasor sum of the engine vanishes, with the evidence.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// Force, moment or torque.
    pub quantity: Quantity,
    /// The order k.
    pub order: u32,
    /// Direct or reverse; none for the torque.
    pub sense: Option<Sense>,
    /// Whose terms they are.
    pub sources: Vec<Source>,
    /// The sum, one term per source.
    pub sum: PhasorSum,
    /// The evidence.
    pub certificate: Certificate,
}

impl Verdict {
    /// Judges the sum of one group of sources.
    pub(super) fn new(terms: &OrderTerms, group: &Group, quantity: Quantity, sense: Option<Sense>) -> Self {
        let (sources, sum) = terms.sum(group, quantity, sense);
        let certificate = sum.certificate();
        Verdict { quantity, order: terms.order, sense, sources, sum, certificate }
    }

    /// Whether the sum is zero.
    pub fn vanishes(&self) -> bool {
        self.certificate.claims_zero()
    }
}

/// A star with its evidence, whatever order it is of: what an argument is made from, and a drawing.
#[derive(Clone, Copy, Debug)]
pub struct JudgedStar<'a> {
    /// Of force, moment or torque.
    pub quantity: Quantity,
    /// Whose vectors they are.
    pub sources: &'a [Source],
    /// The sum, one term per source.
    pub sum: &'a PhasorSum,
    /// The evidence.
    pub certificate: &'a Certificate,
}

impl JudgedStar<'_> {
    /// Whether the sum is zero.
    pub fn vanishes(&self) -> bool {
        self.certificate.claims_zero()
    }
}

impl<'a> From<&'a Verdict> for JudgedStar<'a> {
    fn from(verdict: &'a Verdict) -> Self {
        let Verdict { quantity, sources, sum, certificate, .. } = verdict;
        JudgedStar { quantity: *quantity, sources, sum, certificate }
    }
}

/// The two vectors of one order of the force or the moment, and what their sum traces.
#[derive(Clone, Debug)]
pub struct Balance {
    /// Of which it is.
    pub quantity: Planar,
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
    pub(super) fn new(terms: &OrderTerms, group: &Group, quantity: Planar) -> Self {
        let judge = |sense| Verdict::new(terms, group, quantity.into(), Some(sense));
        let (direct, reverse) = (judge(Sense::Direct), judge(Sense::Reverse));
        let (shape, comparison) = match (direct.vanishes(), reverse.vanishes()) {
            (true, true) => (Shape::Balanced, None),
            (false, true) => (Shape::Rotating, None),
            (true, false) => (Shape::CounterRotating, None),
            (false, false) => {
                let (shape, certificate) = compared(&direct.sum, &reverse.sum);
                (shape, Some(certificate))
            }
        };
        Balance { quantity, direct, reverse, shape, comparison }
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

/// Planar or elliptical: whether two sums that are multiplied by equally large numbers are equally long, with the evidence.
pub(super) fn compared(direct: &PhasorSum, reverse: &PhasorSum) -> (Shape, Certificate) {
    let certificate = direct.squared_modulus().minus(&reverse.squared_modulus()).tidied().certificate();
    (if certificate.claims_zero() { Shape::Planar } else { Shape::Elliptical }, certificate)
}

/// Sources of an order whose terms are multiplied by one number, where an engine has several such numbers in the order, or crankshafts of
/// several speeds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Class {
    /// The number.
    pub factor: Factor,
    /// The sources.
    pub sources: Vec<Source>,
    /// What the cylinders among them are called.
    pub cylinders: Vec<String>,
    /// What the others are called.
    pub turning: Vec<String>,
}

impl Class {
    /// That of a group of an order among this many; none of the only one, but where it is of a crankshaft that turns faster than the
    /// reference: there it tells before which number the sum stands.
    pub(super) fn of(sources: &Sources, group: &Group, groups: usize, order: u32) -> Option<Self> {
        let is_one_of_faster = || group.factor == Factor::One && order > 1 && sources.engine().faster_crank().is_some();
        let is_of_faster = group.factor.is_geared() || (is_one_of_faster() && !group.sources.is_empty());
        (groups > 1 || is_of_faster).then(|| Class::new(sources, group))
    }

    fn new(sources: &Sources, group: &Group) -> Self {
        let (pistons, others): (Vec<Source>, Vec<Source>) =
            group.sources.iter().partition(|source| source.piston().is_some());
        let names = |of: Vec<Source>| of.into_iter().map(|source| source.name(sources.engine())).collect();
        Class {
            factor: group.factor.clone(),
            sources: group.sources.clone(),
            cylinders: names(pistons),
            turning: names(others),
        }
    }
}
