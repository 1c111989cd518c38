//! When does a sum vanish: always, never, or where?

use num_rational::BigRational;

use super::angles::Angles;
use super::circle::Circle;
use super::plane::{Boxes, Classes, Quadratic, Triangle};
use crate::proof::{Certificate, CoprimeClaim, CosineClaim};

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
    Cosine(Box<CosineClaim>),
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

/// Why a sum never vanishes.
#[derive(Clone, Debug)]
pub enum Never {
    /// One part is left.
    OnePart,
    /// Two parts of different length: evidence that `|S_1|² − |S_2|²` is not zero.
    UnequalLengths(Certificate),
    /// Parts in one unknown, which have no zero on the circle: evidence by one prime.
    Coprime(Box<CoprimeClaim>),
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

/// `(Σ_j S_{0j} e^{ix_j}) · (Σ_g S_{g0} e^{iy_g}) / S_{00}`: the first group, times the first parts of all.
#[derive(Clone, Debug)]
pub struct Product {
    /// The places of the parts of each group among those that are left.
    pub groups: Vec<Vec<usize>>,
    /// Evidence that `S_{gj} S_{00} − S_{g0} S_{0j}` is zero, group by group from the second on, without the first part of each.
    pub certificates: Vec<Certificate>,
    /// When the first group vanishes.
    pub group: When,
    /// When the first parts cancel.
    pub firsts: When,
}
