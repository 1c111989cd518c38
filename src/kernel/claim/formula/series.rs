//! Which Fourier series is a formula? Cosines and sines of multiples of θ, before products of m, r, ω and λ with exact numbers.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{Formula, Function, Letter, Measured, Operation};
use crate::exact::Turn;
use crate::numbers::Form;

/// A cosine or sine of a multiple of θ; the constant is the cosine of none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Wave {
    /// The multiple.
    pub order: u32,
    /// Whether it is a sine.
    pub is_sine: bool,
}

/// How often m, r, ω and λ are factors.
pub type Powers = [i32; 4];

/// What stands before a product of letters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Factor {
    /// The number, exactly as written.
    pub form: Form,
    /// How far it may be off because decimals in it are rounded; 0 where it has none, nothing where that is not known.
    pub rounding: Option<BigRational>,
}

impl Factor {
    pub(in super::super) fn exact(form: Form) -> Self {
        Factor { form, rounding: Some(BigRational::zero()) }
    }

    pub(in super::super) fn scaled(&self, by: &BigRational) -> Self {
        let rounding = self.rounding.as_ref().map(|rounding| rounding * by.abs());
        Factor { form: self.form.scaled(by), rounding }
    }

    pub(in super::super) fn plus(&self, other: &Self) -> Self {
        let rounding = self.rounding.as_ref().zip(other.rounding.as_ref()).map(|(one, other)| one + other);
        Factor { form: self.form.plus(&other.form), rounding }
    }

    fn times(&self, other: &Self) -> Option<Self> {
        // (x + p)(y + q) is off from x y by up to |x| q + |y| p + p q; a length that is no fraction is not known as a number.
        let off = |one: &Self, other: &Self| match other.rounding.as_ref()? {
            none if none.is_zero() => Some(BigRational::zero()),
            some => Some(one.form.as_rational()?.abs() * some),
        };
        let both = self.rounding.as_ref().zip(other.rounding.as_ref()).map(|(one, other)| one * other);
        let rounding = both.and_then(|both| Some(off(self, other)? + off(other, self)? + both));
        Some(Factor { form: self.form.times(&other.form)?, rounding })
    }

    /// Whether it is 0.
    pub(in super::super) fn is_zero(&self) -> bool {
        self.form.terms().is_empty()
    }

    /// That of its form where nothing in it is rounded.
    fn of_exact(&self, form: Form) -> Self {
        Factor { form, rounding: self.rounding.clone().filter(Zero::is_zero) }
    }
}

/// Σ number · m^a r^b ω^c λ^d · cos kθ or sin kθ, each product once; those before which 0 stands, for what is claimed to be 0 is claimed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Series(BTreeMap<(Wave, Powers), Factor>);

/// Higher multiples than this, and more terms, are nobody's series.
const HIGHEST: u32 = 100;
const MOST_TERMS: usize = 200;

const CONSTANT: Wave = Wave { order: 0, is_sine: false };

impl Series {
    /// Multiplies a formula out.
    ///
    /// # Errors
    /// What in it is no Fourier series.
    pub fn of(formula: &Formula) -> Result<Self, String> {
        Ok(match formula {
            Formula::Number(number, half) => {
                let form = Form::rational(number.clone());
                Series::constant(Factor { form, rounding: Some(half.clone()) }, [0; 4])
            }
            Formula::Pi => return Err("π is in a series only within a sine or cosine".to_owned()),
            Formula::Letter(letter) => {
                Series::constant(Factor::exact(Form::rational(BigRational::one())), powers(*letter)?)
            }
            Formula::Negative(one) => Series::of(one)?.scaled(&-BigRational::one()),
            Formula::Both(operation, pair) => {
                let [one, other] = [Series::of(&pair.0)?, Series::of(&pair.1)?];
                match operation {
                    Operation::Plus => one.plus(&other),
                    Operation::Minus => one.plus(&other.scaled(&-BigRational::one())),
                    Operation::Times => one.times(&other)?,
                    Operation::Over => one.times(&other.inverse()?)?,
                }
            }
            Formula::Power(one, exponent) => {
                let one = Series::of(one)?;
                let mut power = one.clone();
                for _ in 1..*exponent {
                    power = power.times(&one)?;
                }
                power
            }
            Formula::Of(function, one) => match function {
                Function::Sine => wave(one, true)?,
                Function::Cosine => wave(one, false)?,
                Function::Tangent => return Err("a series has sines and cosines, and no tangent".to_owned()),
                Function::Root => {
                    let inside = Series::of(one)?;
                    let number = inside.number().filter(|number| *number >= BigRational::zero());
                    let number = number.ok_or("a root in a series is that of a number, 0 or more")?;
                    let root = Form::rational(number).square_root();
                    let factor = match inside.not_zero().first() {
                        Some((_, one)) => one.of_exact(root),
                        None => Factor::exact(root),
                    };
                    Series::constant(factor, [0; 4])
                }
            },
        })
    }

    fn constant(factor: Factor, powers: Powers) -> Self {
        Series::new([((CONSTANT, powers), factor)])
    }

    fn new(terms: impl IntoIterator<Item = ((Wave, Powers), Factor)>) -> Self {
        let mut all: BTreeMap<(Wave, Powers), Factor> = BTreeMap::new();
        for (key, factor) in terms {
            let sum = all.get(&key).map_or_else(|| factor.clone(), |there| there.plus(&factor));
            all.insert(key, sum);
        }
        // The sine of no angle is no wave.
        all.retain(|(wave, _), _| wave.order > 0 || !wave.is_sine);
        Series(all)
    }

    fn plus(&self, other: &Self) -> Self {
        Series::new(self.0.iter().chain(&other.0).map(|(key, factor)| (*key, factor.clone())))
    }

    fn scaled(&self, by: &BigRational) -> Self {
        Series::new(self.0.iter().map(|(key, factor)| (*key, factor.scaled(by))))
    }

    fn times(&self, other: &Self) -> Result<Self, String> {
        let mut terms = Vec::new();
        for ((wave, powers), factor) in &self.0 {
            for ((other_wave, other_powers), other_factor) in &other.0 {
                let product = factor.times(other_factor).ok_or("the numbers of the series are too long")?;
                let powers = [0, 1, 2, 3].map(|at| powers[at] + other_powers[at]);
                for (wave, half) in product_of(*wave, *other_wave) {
                    if wave.order > HIGHEST || terms.len() > 4 * MOST_TERMS {
                        return Err("the series is too long".to_owned());
                    }
                    terms.push(((wave, powers), product.scaled(&half)));
                }
            }
        }
        Ok(Series::new(terms))
    }

    /// One over a product of numbers and letters.
    fn inverse(&self) -> Result<Self, String> {
        let no = || "a series is divided by a product of numbers and letters only".to_owned();
        let [((wave, powers), factor)] = self.not_zero()[..] else { return Err(no()) };
        let number = factor.form.as_rational().filter(|_| *wave == CONSTANT);
        let number = number.filter(|number| !number.is_zero()).ok_or_else(no)?;
        let inverse = factor.of_exact(Form::rational(number.recip()));
        Ok(Series::constant(inverse, powers.map(|power| -power)))
    }

    fn not_zero(&self) -> Vec<(&(Wave, Powers), &Factor)> {
        self.0.iter().filter(|(_, factor)| !factor.is_zero()).collect()
    }

    /// The number that it is, where it is one.
    fn number(&self) -> Option<BigRational> {
        match self.not_zero().as_slice() {
            [] => Some(BigRational::zero()),
            [((wave, powers), factor)] if *wave == CONSTANT && *powers == [0; 4] => factor.form.as_rational(),
            _ => None,
        }
    }

    /// Its waves, rising, each with what stands before it: products of letters and their numbers.
    pub fn waves(&self) -> BTreeMap<Wave, Vec<(Powers, Factor)>> {
        let mut waves: BTreeMap<Wave, Vec<(Powers, Factor)>> = BTreeMap::new();
        for ((wave, powers), factor) in &self.0 {
            waves.entry(*wave).or_default().push((*powers, factor.clone()));
        }
        waves
    }
}

/// Which of m, r, ω and λ a letter is; L is r/λ.
fn powers(letter: Letter) -> Result<Powers, String> {
    match letter {
        Letter::Of(Measured::ReciprocatingMass) => Ok([1, 0, 0, 0]),
        Letter::Radius => Ok([0, 1, 0, 0]),
        Letter::Omega => Ok([0, 0, 1, 0]),
        Letter::Lambda => Ok([0, 0, 0, 1]),
        Letter::Of(Measured::RodLength) => Ok([0, 1, 0, -1]),
        Letter::Theta => Err("θ is in a series only within a sine or cosine".to_owned()),
        Letter::Beta
        | Letter::Delta
        | Letter::Height
        | Letter::Bore
        | Letter::Pressure
        | Letter::Crankcase
        | Letter::Of(_) => Err("the letters of a shaking force are m, r, ω, λ, L and θ".to_owned()),
    }
}

/// `cos a cos b = ½cos(a − b) + ½cos(a + b)`, and so on.
fn product_of(one: Wave, other: Wave) -> Vec<(Wave, BigRational)> {
    let half = || BigRational::new(1.into(), 2.into());
    let (sum, difference) = (one.order + other.order, one.order.abs_diff(other.order));
    let wave = |order, is_sine| Wave { order, is_sine };
    match (one.is_sine, other.is_sine) {
        (false, false) => vec![(wave(difference, false), half()), (wave(sum, false), half())],
        (true, true) => vec![(wave(difference, false), half()), (wave(sum, false), -half())],
        // sin a cos b = ½ sin(a + b) + ½ sin(a − b), and the sine of a negative angle is negative.
        (true, false) | (false, true) => {
            let (sine, cosine) = if one.is_sine { (one.order, other.order) } else { (other.order, one.order) };
            let sign = if sine >= cosine { half() } else { -half() };
            vec![(wave(sum, true), half()), (wave(difference, true), sign)]
        }
    }
}

/// `cos(kθ + φ) = cos φ cos kθ − sin φ sin kθ`.
fn wave(argument: &Formula, is_sine: bool) -> Result<Series, String> {
    let no = || {
        "a sine or cosine of a series is of a whole multiple of θ, and perhaps an angle: cos 2θ, cos(2θ + 2π/3), cos(θ + 120°)".to_owned()
    };
    let (multiple, turns) = linear(argument).ok_or_else(no)?;
    let order =
        Some(&multiple).filter(|multiple| multiple.is_integer()).and_then(|multiple| multiple.to_integer().to_i64());
    let order = order.filter(|order| order.unsigned_abs() <= u64::from(HIGHEST)).ok_or_else(no)?;
    let turn = Turn::new(turns);
    let cosine = Form::cosine(BigRational::one(), turn.clone());
    let sine = Form::cosine(BigRational::one(), &turn - &Turn::fraction(1, 4));
    let minus = |form: &Form| form.scaled(&-BigRational::one());
    let sign = |form: Form| if order < 0 { minus(&form) } else { form };
    let k = u32::try_from(order.unsigned_abs()).map_err(|_| no())?;
    let [of_cosine, of_sine] = if is_sine { [sine, sign(cosine)] } else { [cosine, sign(minus(&sine))] };
    let term = |is_sine, form| ((Wave { order: k, is_sine }, [0; 4]), Factor::exact(form));
    let terms = [term(false, of_cosine), term(true, of_sine)];
    Ok(Series::new(terms.into_iter().filter(|(_, factor)| !factor.is_zero())))
}

/// How often θ, and how many turns beside it.
fn linear(formula: &Formula) -> Option<(BigRational, BigRational)> {
    let zero = BigRational::zero;
    match formula {
        Formula::Letter(Letter::Theta) => Some((BigRational::one(), zero())),
        Formula::Pi => Some((zero(), BigRational::new(1.into(), 2.into()))),
        // An angle of 0; other numbers would be radians that are no part of a turn.
        Formula::Number(number, _) => number.is_zero().then(|| (zero(), zero())),
        Formula::Negative(one) => linear(one).map(|(theta, turns)| (-theta, -turns)),
        Formula::Both(operation @ (Operation::Plus | Operation::Minus), pair) => {
            let (one, other) = (linear(&pair.0)?, linear(&pair.1)?);
            Some(match operation {
                Operation::Minus => (one.0 - other.0, one.1 - other.1),
                _ => (one.0 + other.0, one.1 + other.1),
            })
        }
        Formula::Both(Operation::Times, pair) => {
            let by =
                |number: BigRational, (theta, turns): (BigRational, BigRational)| (theta * &number, turns * number);
            match (number(&pair.0), number(&pair.1)) {
                (Some(factor), _) => linear(&pair.1).map(|one| by(factor, one)),
                (None, Some(factor)) => linear(&pair.0).map(|one| by(factor, one)),
                (None, None) => None,
            }
        }
        Formula::Both(Operation::Over, pair) => {
            let by = number(&pair.1).filter(|by| !by.is_zero())?;
            linear(&pair.0).map(|(theta, turns)| (theta / &by, turns / by))
        }
        Formula::Letter(_) | Formula::Power(..) | Formula::Of(..) => None,
    }
}

/// A rational number.
fn number(formula: &Formula) -> Option<BigRational> {
    Series::of(formula).ok()?.number()
}
