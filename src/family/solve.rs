//! When does `S_1 e^{ix_1} + S_2 e^{ix_2} + … = 0`, with x linear in φ and δ?
//!
//! One part never vanishes. Two do iff |S_1| = |S_2| and `x_2 − x_1 ≡ arg S_1 − arg S_2 + 180°`. Three of equal length do
//! iff they stand 120° apart. Of three, two may be mirror images of each other about the third: then a cosine decides. All
//! else in one unknown is solved on the circle ([`circle`]); two unknowns that enter on their own, as a triangle or as two classes
//! ([`plane`]), and where neither fits it is said so.

use std::collections::BTreeSet;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::Part;
use super::circle::{self, Circle, Coprime, Solved};
use super::plane::{self, Boxes, Classes, Product, Quadratic, Triangle};
use super::remaining::ratio;
use crate::engine::PHI;
use crate::exact::{PhasorSum, Turn};
use crate::numbers::{self, Direction};
use crate::proof::Certificate;

/// When a sum vanishes.
#[derive(Clone, Debug)]
pub enum When {
    /// For all angles: every part is gone.
    Always,
    /// For no angles.
    Never(Never),
    /// Exactly where one of these conditions holds.
    Where(Angles),
    /// Exactly where a cosine has a value that no rational turn gives.
    Cosine(Box<Cosine>),
    /// Exactly at the zeros on the arcs of a circle, where it is [complete](Circle::is_complete).
    Circle(Box<Circle>),
    /// Exactly where `phi·φ + delta·δ` is an angle, in degrees, for which no rational turn was found: two parts of which the
    /// unknowns turn one too many times for arcs.
    Irrational {
        /// How many times φ enters.
        phi: BigRational,
        /// How many times δ enters.
        delta: BigRational,
        /// The angle in degrees, approximately.
        degrees: f64,
        /// Evidence that the two parts are equally long.
        equal_lengths: Certificate,
    },
    /// Exactly where three parts, turned by two unknowns on their own, make a triangle.
    Triangle(Box<Triangle>),
    /// Exactly where two classes of parts, in two unknowns, are equally long and opposite, where their circle is
    /// [complete](Circle::is_complete).
    Classes(Box<Classes>),
    /// Exactly where one of two sums vanishes, in two unknowns, whose product it is.
    Product(Box<Product>),
    /// Exactly where three classes of parts, in two unknowns, cancel, where their circle is [complete](Circle::is_complete).
    Quadratic(Box<Quadratic>),
    /// At the zeros of the boxes into which the torus of two unknowns is cut, exactly where they are [complete](Boxes::is_complete).
    Boxes(Box<Boxes>),
    /// This many parts in two unknowns of more than three classes, or of three that are not equally far apart, which vanish on more than a few
    /// small boxes, or an unknown that enters too many times.
    NotSolved(usize),
}

/// Three parts, the second and third mirror images about the first: `S_1 (1 − cos(phi·φ + delta·δ + turn) / cosine)`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cosine {
    /// Which of the parts that are left is the one in the middle.
    pub middle: usize,
    /// How many times φ enters.
    pub phi: BigRational,
    /// How many times δ enters.
    pub delta: BigRational,
    /// What is added to them.
    pub turn: Turn,
    /// The value at which the sum vanishes: between −1 and 1, none of 0, ±1/2, ±1, whose angles are rational turns.
    pub cosine: BigRational,
    /// Evidence that the others are `−1/(2 cosine)` of the middle one, turned by `turn` and back.
    pub multiples: [Certificate; 2],
}

/// Why a sum never vanishes.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Never {
    /// One part is left.
    OnePart,
    /// Two parts of different length: evidence that `|S_1|² − |S_2|²` is not zero.
    UnequalLengths(Certificate),
    /// Parts in one unknown, which have no zero on the circle: evidence by one prime.
    Coprime(Box<Coprime>),
    /// Parts in one unknown, whose arcs hold no zero.
    Circle(Box<Circle>),
    /// Three parts in two unknowns, one of them longer than the others together.
    Triangle(Box<Triangle>),
    /// Two classes of parts in two unknowns, which are nowhere equally long.
    Classes(Box<Classes>),
    /// Three classes of parts in two unknowns, which nowhere cancel.
    Quadratic(Box<Quadratic>),
    /// Parts in two unknowns, whose boxes hold no zero.
    Boxes(Box<Boxes>),
    /// A product of two sums in two unknowns, neither of which vanishes.
    Product(Box<Product>),
}

/// The angles at which parts of equal length cancel: for φ alone a list, for φ and δ a line of solutions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Angles {
    /// One for two parts, two for three.
    pub alternatives: Vec<Alternative>,
    /// For three parts: evidence that they are equally long, `|S_1|² − |S_j|² = 0`.
    pub equal_lengths: Vec<Certificate>,
}

/// Conditions that hold together, one for each part after the first, on how it is turned against the first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Alternative {
    /// `x_j − x_1 ≡ turn`, for j = 2 (and 3).
    pub conditions: Vec<Condition>,
    /// Evidence that the parts turned so cancel.
    pub certificate: Certificate,
}

/// `phi·φ + delta·δ ≡ turn` modulo a turn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Condition {
    /// How many times φ enters.
    pub phi: BigRational,
    /// How many times δ enters.
    pub delta: BigRational,
    /// What it must be.
    pub turn: Turn,
}

impl Condition {
    /// The values of one unknown in a range, its ends among them, in turns; `None` where the other one enters.
    fn values(&self, unknown: &str, [low, high]: [&BigRational; 2]) -> Option<BTreeSet<BigRational>> {
        let (own, other) = if unknown == PHI { (&self.phi, &self.delta) } else { (&self.delta, &self.phi) };
        if !other.is_zero() || own.is_zero() {
            return None;
        }
        // px = t + m with low ≤ x ≤ high: m runs over the whole numbers between p low − t and p high − t.
        let ends = [own * low - self.turn.turns(), own * high - self.turn.turns()];
        let (mut m, last) = match own.is_positive() {
            true => (ends[0].ceil().to_integer(), ends[1].floor().to_integer()),
            false => (ends[1].ceil().to_integer(), ends[0].floor().to_integer()),
        };
        let mut values = BTreeSet::new();
        while m <= last {
            values.insert((self.turn.turns() + BigRational::from_integer(m.clone())) / own);
            m += BigInt::from(1);
        }
        Some(values)
    }
}

impl Angles {
    /// The values of one unknown, φ or δ, in a range at which a condition holds, in turns and with the ends of the range;
    /// `None` where the other one enters.
    pub fn values(&self, unknown: &str, range: [&BigRational; 2]) -> Option<BTreeSet<BigRational>> {
        let mut all = BTreeSet::new();
        for alternative in &self.alternatives {
            let of = |condition: &Condition| condition.values(unknown, range);
            let sets = alternative.conditions.iter().map(of).collect::<Option<Vec<_>>>()?;
            all.extend(sets.into_iter().reduce(|common, set| common.intersection(&set).cloned().collect())?);
        }
        Some(all)
    }
}

/// When the parts sum to zero.
pub(super) fn when(parts: &[&Part]) -> When {
    match parts {
        [] => When::Always,
        [_] => When::Never(Never::OnePart),
        [first, second] => two(first, second),
        [first, second, third] => three(first, second, third),
        more => general(more),
    }
}

/// Any number of parts.
fn general(parts: &[&Part]) -> When {
    match circle::solve(parts) {
        Some(Solved::Never(coprime)) => When::Never(Never::Coprime(coprime)),
        Some(Solved::Circle(circle)) if circle.is_free() => When::Never(Never::Circle(circle)),
        Some(Solved::Circle(circle)) => When::Circle(circle),
        None => plane::when(parts).unwrap_or(When::NotSolved(parts.len())),
    }
}

fn length_difference(a: &PhasorSum, b: &PhasorSum) -> Certificate {
    PhasorSum::new(a.squared_modulus().minus(&b.squared_modulus()).collected()).certificate()
}

fn two(first: &Part, second: &Part) -> When {
    let comparison = length_difference(&first.sum, &second.sum);
    if !comparison.claims_zero() {
        return When::Never(Never::UnequalLengths(comparison));
    }
    let quotient = first.sum.times(&second.sum.conjugate());
    match numbers::direction_of(&quotient) {
        Some(Direction::Turn(turn)) => {
            let alternatives = vec![alternative(first, &[(second, turn.opposite())])];
            When::Where(Angles { alternatives, equal_lengths: Vec::new() })
        }
        Some(Direction::Arctangent { .. } | Direction::Turned { .. }) | None => match circle::arcs_of(&[first, second])
        {
            // An angle beyond the digits of the arcs is named without them.
            Some(circle) if circle.is_complete() => When::Circle(Box::new(circle)),
            Some(_) | None => irrational(first, second, &quotient, comparison),
        },
    }
}

fn irrational(first: &Part, second: &Part, quotient: &PhasorSum, equal_lengths: Certificate) -> When {
    When::Irrational {
        phi: &second.phi - &first.phi,
        delta: &second.delta - &first.delta,
        degrees: numbers::evaluate(quotient).arg().to_degrees() + 180.0,
        equal_lengths,
    }
}

/// The parts after the first, each turned against it by its angle.
pub(super) fn alternative(first: &Part, others: &[(&Part, Turn)]) -> Alternative {
    let conditions = others.iter().map(|(part, turn)| Condition {
        phi: &part.phi - &first.phi,
        delta: &part.delta - &first.delta,
        turn: turn.clone(),
    });
    let sum = others.iter().fold(first.sum.clone(), |sum, (part, turn)| sum.plus(&part.sum.turned(turn)));
    Alternative { conditions: conditions.collect(), certificate: sum.certificate() }
}

/// Three vectors of equal length sum to zero iff they stand 120° apart, in either order.
fn three(first: &Part, second: &Part, third: &Part) -> When {
    let equal_lengths = [second, third].map(|part| length_difference(&first.sum, &part.sum)).to_vec();
    let relative = |part: &Part| match numbers::direction_of(&first.sum.times(&part.sum.conjugate())) {
        Some(Direction::Turn(turn)) => Some(turn),
        _ => None,
    };
    let equal = equal_lengths.iter().all(Certificate::claims_zero);
    let (true, Some(to_second), Some(to_third)) = (equal, relative(second), relative(third)) else {
        let middles = [(first, [second, third]), (second, [first, third]), (third, [first, second])];
        let mut found = middles.iter().enumerate().filter_map(|(at, (middle, others))| mirrored(at, middle, *others));
        return found.next().map_or_else(|| general(&[first, second, third]), |cosine| When::Cosine(Box::new(cosine)));
    };
    let alternatives = [1, 2].map(|thirds| {
        let turned = |relative: &Turn, thirds: i64| relative + &Turn::fraction(thirds, 3);
        alternative(first, &[(second, turned(&to_second, thirds)), (third, turned(&to_third, -thirds))])
    });
    When::Where(Angles { alternatives: alternatives.to_vec(), equal_lengths })
}

/// Two parts that turn against the one in the middle by opposite angles, and are mirror images about it: `S (1 + 2q cos x)`.
fn mirrored(at: usize, middle: &Part, [one, other]: [&Part; 2]) -> Option<Cosine> {
    let (phi, delta) = (&one.phi - &middle.phi, &one.delta - &middle.delta);
    if &other.phi - &middle.phi != -&phi || &other.delta - &middle.delta != -&delta {
        return None;
    }
    let turn = match numbers::direction_of(&one.sum.times(&middle.sum.conjugate()))? {
        // Half a turn is the sign of the multiple.
        Direction::Turn(turn) if turn.times(2) == Turn::zero() => Turn::zero(),
        Direction::Turn(turn) => turn,
        _ => return None,
    };
    let back = &Turn::zero() - &turn;
    let [forward, backward] = [one.sum.turned(&back), other.sum.turned(&turn)];
    let multiple = ratio(&forward, &middle.sum).filter(|multiple| !multiple.is_zero())?;
    let cosine = -(&multiple + &multiple).recip();
    let angle_is_rational = (&cosine + &cosine).is_integer();
    if angle_is_rational || cosine.abs() > BigRational::one() || ratio(&backward, &middle.sum)? != multiple {
        return None;
    }
    let scaled = middle.sum.scaled(&multiple);
    let multiples = [forward, backward].map(|sum| PhasorSum::new(sum.minus(&scaled).collected()).certificate());
    Some(Cosine { middle: at, phi, delta, turn, cosine, multiples })
}
