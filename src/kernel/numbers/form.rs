//! What does an exact real number look like? A sum of rational multiples of square roots and cosines.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::evaluate::direction;
use crate::exact::{Turn, fraction};
use crate::motion::rational_root;

/// A root that a coefficient is multiplied by.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Root {
    /// 1: the coefficient alone.
    One,
    /// The square root of a whole number above 1, free of square factors.
    Whole(BigInt),
    /// The square root of a form that is no rational number.
    Nested(Form),
    /// The cosine of an angle between 0 and a quarter of a turn.
    Cosine(Turn),
    /// The product of one of the first three and cosines in rising order of their angles: two or more with 1.
    Product(Box<Root>, Vec<Turn>),
}

/// `Σ coefficient · root`, each root once, no coefficient zero.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Form {
    terms: Vec<(Root, BigRational)>,
}

/// Products of more terms, or of more cosines, are nobody's number.
const MOST_TERMS: usize = 64;
pub(super) const MOST_COSINES: usize = 8;
/// Square factors of larger numbers than this are not looked for: the form is right, though perhaps not the shortest.
const LARGEST_FACTOR: u32 = 10_000;

impl Form {
    /// A rational number.
    pub fn rational(value: BigRational) -> Self {
        Form::new([(Root::One, value)])
    }

    /// A rational multiple of a cosine; those of whole multiples of 30° and 45° are roots.
    pub fn cosine(coefficient: BigRational, angle: Turn) -> Self {
        let (angle, sign) = in_first_quarter(&angle);
        let known = [(0, 1), (1, 12), (1, 8), (1, 6), (1, 4)].map(|(part, of)| Turn::fraction(part, of));
        // 2 cos of 0°, 30°, 45°, 60°, 90° are the roots of 4, 3, 2, 1, 0.
        match known.iter().zip([4, 3, 2, 1, 0]).find(|(known, _)| **known == angle) {
            Some((_, square)) => {
                let root = root_of_rational(&BigRational::from_integer(square.into()));
                root.scaled(&(coefficient * sign / BigRational::from_integer(2.into())))
            }
            None => Form::new([(Root::Cosine(angle), coefficient * sign)]),
        }
    }

    fn new(terms: impl IntoIterator<Item = (Root, BigRational)>) -> Self {
        let mut collected: BTreeMap<Root, BigRational> = BTreeMap::new();
        for (root, coefficient) in terms {
            *collected.entry(root).or_insert_with(BigRational::zero) += coefficient;
        }
        Form { terms: collected.into_iter().filter(|(_, coefficient)| !coefficient.is_zero()).collect() }
    }

    /// The terms: roots with their coefficients.
    pub fn terms(&self) -> &[(Root, BigRational)] {
        &self.terms
    }

    /// The number itself, where it is rational.
    pub fn as_rational(&self) -> Option<BigRational> {
        match self.terms.as_slice() {
            [] => Some(BigRational::zero()),
            [(Root::One, value)] => Some(value.clone()),
            _ => None,
        }
    }

    /// The sum of two numbers.
    pub fn plus(&self, other: &Form) -> Form {
        Form::new(self.terms.iter().chain(&other.terms).cloned())
    }

    /// A rational multiple of the number.
    pub fn scaled(&self, by: &BigRational) -> Form {
        Form::new(self.terms.iter().map(|(root, coefficient)| (root.clone(), coefficient * by)))
    }

    /// The product of two numbers; `None` where it has too many terms or cosines to be one that is written.
    pub fn times(&self, other: &Form) -> Option<Form> {
        if self.terms.len() * other.terms.len() > MOST_TERMS {
            return None;
        }
        let mut sum = Form::new([]);
        for (root, coefficient) in &self.terms {
            for (other_root, other_coefficient) in &other.terms {
                sum = sum.plus(&product(root, other_root)?.scaled(&(coefficient * other_coefficient)));
            }
        }
        Some(sum)
    }

    /// The square root of a number that is not negative.
    pub fn square_root(&self) -> Form {
        if let Some(value) = self.as_rational() {
            return root_of_rational(&value);
        }
        if let Some(denested) = self.denested_root() {
            return denested;
        }
        // √(g·f) with rational g and whole, coprime coefficients in f: √g = q√n, so q·√(n f).
        let content = self.content();
        let primitive = self.scaled(&content.recip());
        let (outside, inside) = without_squares(&content);
        Form::new([(Root::Nested(primitive.scaled(&BigRational::from_integer(inside))), outside)])
    }

    /// `√(a + b√d) = √x ± √y` with `x + y = a` and `4xy = b²d`, where `a² − b²d` is a rational square.
    fn denested_root(&self) -> Option<Form> {
        let zero = BigRational::zero();
        let (a, b, d) = match self.terms.as_slice() {
            [(Root::One, a), (Root::Whole(d), b)] => (a, b, d),
            [(Root::Whole(d), b)] => (&zero, b, d),
            _ => return None,
        };
        let square = a * a - b * b * BigRational::from_integer(d.clone());
        let difference = rational_root(&square)?;
        let two = BigRational::from_integer(2.into());
        let larger = root_of_rational(&((a + &difference) / &two));
        let smaller = root_of_rational(&((a - &difference) / &two));
        Some(larger.plus(&smaller.scaled(&b.signum())))
    }

    /// The rational number whose product with whole, coprime coefficients makes the form.
    fn content(&self) -> BigRational {
        fraction::common_unit(self.terms.iter().map(|(_, coefficient)| coefficient))
    }

    /// The number in decimals, to nearly the accuracy of a float.
    pub fn to_float(&self) -> f64 {
        let root = |root: &Root| match root {
            Root::One => 1.0,
            Root::Whole(n) => n.to_f64().unwrap_or(f64::NAN).sqrt(),
            Root::Nested(form) => form.to_float().max(0.0).sqrt(),
            Root::Cosine(angle) => direction(angle).re,
            Root::Product(root, cosines) => {
                let root = Form::new([((**root).clone(), BigRational::one())]).to_float();
                cosines.iter().fold(root, |product, angle| product * direction(angle).re)
            }
        };
        self.terms.iter().map(|(r, coefficient)| coefficient.to_f64().unwrap_or(f64::NAN) * root(r)).sum()
    }
}

/// The angle of the first quarter that has the same cosine but for its sign, and that sign.
pub(super) fn in_first_quarter(angle: &Turn) -> (Turn, BigRational) {
    let (half, quarter) = (Turn::fraction(1, 2), Turn::fraction(1, 4));
    let upper = if angle > &half { -angle } else { angle.clone() };
    if upper > quarter { (&half - &upper, -BigRational::one()) } else { (upper, One::one()) }
}

/// Multiplies what stands before the cosines, and puts the cosines of both behind it; of `cos t · sin t` it makes `½ sin 2t`.
fn product(a: &Root, b: &Root) -> Option<Form> {
    let ((a, mut cosines), (b, others)) = (a.parts(), b.parts());
    cosines.extend(others);
    cosines.sort_unstable();
    let roots = product_of_roots(&a, &b)?;
    if cosines.is_empty() {
        return Some(roots);
    }
    if let Some([t, u]) = complements(&cosines) {
        // With u = 90° − t it is ½ sin 2t = ½ cos(u − t).
        let merged = Form::cosine(BigRational::new(1.into(), 2.into()), &cosines.remove(u) - &cosines.remove(t));
        let one = |angle: &Turn| Form::cosine(BigRational::one(), angle.clone());
        return cosines.iter().try_fold(roots, |form, angle| form.times(&one(angle)))?.times(&merged);
    }
    let with_cosines = |(root, coefficient): (Root, BigRational)| {
        let (root, mut all) = root.parts();
        all.extend(cosines.iter().cloned());
        all.sort_unstable();
        let root = match (&root, all.as_slice()) {
            (Root::One, [only]) => Root::Cosine(only.clone()),
            _ => Root::Product(Box::new(root), all),
        };
        (root, coefficient)
    };
    (cosines.len() <= MOST_COSINES).then(|| Form::new(roots.terms.into_iter().map(with_cosines)))
}

/// The places of two angles that make a quarter of a turn together.
fn complements(angles: &[Turn]) -> Option<[usize; 2]> {
    let quarter = Turn::fraction(1, 4);
    let larger = |t: usize| (t + 1..angles.len()).find(|&u| &angles[t] + &angles[u] == quarter);
    (0..angles.len()).find_map(|t| larger(t).map(|u| [t, u]))
}

fn product_of_roots(a: &Root, b: &Root) -> Option<Form> {
    let one = BigRational::one();
    Some(match (a, b) {
        (Root::One, other) | (other, Root::One) => Form::new([(other.clone(), one)]),
        (Root::Whole(m), Root::Whole(n)) => root_of_rational(&BigRational::from_integer(m * n)),
        (Root::Whole(n), Root::Nested(form)) | (Root::Nested(form), Root::Whole(n)) => {
            form.scaled(&BigRational::from_integer(n.clone())).square_root()
        }
        (Root::Nested(f), Root::Nested(g)) if f == g => f.clone(),
        (Root::Nested(f), Root::Nested(g)) => f.times(g)?.square_root(),
        (Root::Cosine(_) | Root::Product(..), _) | (_, Root::Cosine(_) | Root::Product(..)) => return None,
    })
}

impl Root {
    /// Whether a cosine is in it.
    pub(super) fn has_cosine(&self) -> bool {
        match self {
            Root::One | Root::Whole(_) | Root::Nested(_) => false,
            Root::Cosine(_) | Root::Product(..) => true,
        }
    }

    /// The root before the cosines, and the cosines.
    fn parts(&self) -> (Root, Vec<Turn>) {
        match self {
            Root::One | Root::Whole(_) | Root::Nested(_) => (self.clone(), Vec::new()),
            Root::Cosine(angle) => (Root::One, vec![angle.clone()]),
            Root::Product(root, cosines) => ((**root).clone(), cosines.clone()),
        }
    }
}

fn root_of_rational(value: &BigRational) -> Form {
    let (outside, inside) = without_squares(value);
    let root = if inside.is_one() { Root::One } else { Root::Whole(inside) };
    Form::new([(root, outside)])
}

/// `√value = q √n` with n whole and free of square factors up to [`LARGEST_FACTOR`].
fn without_squares(value: &BigRational) -> (BigRational, BigInt) {
    // √(a/b) = √(ab)/b.
    let mut inside = value.numer() * value.denom();
    let mut outside = BigInt::one();
    if inside.is_zero() {
        return (BigRational::zero(), BigInt::one());
    }
    let whole = inside.magnitude().sqrt();
    if &whole * &whole == *inside.magnitude() {
        return (BigRational::new(whole.into(), value.denom().clone()), BigInt::one());
    }
    for factor in 2..=LARGEST_FACTOR {
        let square = BigInt::from(u64::from(factor).pow(2));
        if square > inside {
            break;
        }
        while inside.is_multiple_of(&square) {
            inside /= &square;
            outside *= factor;
        }
    }
    (BigRational::new(outside, value.denom().clone()), inside)
}
