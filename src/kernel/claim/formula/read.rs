//! Which formula do these signs make? Sums of products of factors; factors may stand side by side, as on paper.

use num_rational::BigRational;
use num_traits::{Pow, Zero};

use super::{Formula, Function, Letter, Operation};
use crate::file::parse_number;

/// A formula has no more signs than this, so that its brackets nest no deeper.
const LONGEST: usize = 300;

/// Names of functions, longest first.
const FUNCTIONS: [(&str, Function); 5] = [
    ("sqrt", Function::Root),
    ("sin", Function::Sine),
    ("cos", Function::Cosine),
    ("tan", Function::Tangent),
    ("√", Function::Root),
];

impl Formula {
    /// Reads a formula.
    ///
    /// # Errors
    /// What cannot be read.
    pub(in super::super) fn read(text: &str) -> Result<Self, String> {
        if text.chars().count() > LONGEST {
            return Err(format!("a formula of more than {LONGEST} signs"));
        }
        let mut rest = Rest(text);
        let formula = rest.sum()?;
        match rest.0.trim() {
            "" => Ok(formula),
            more => Err(format!("cannot read the formula at `{more}`")),
        }
    }
}

/// Half a unit of the last of so many decimal places.
pub fn half_of_place(places: usize) -> BigRational {
    BigRational::new(1.into(), 2.into()) / BigRational::from_integer(10.into()).pow(places)
}

/// What is not read yet.
struct Rest<'a>(&'a str);

impl Rest<'_> {
    /// Goes on behind one of these signs, if it stands next.
    fn sign<T: Copy>(&mut self, signs: &[(&str, T)]) -> Option<T> {
        let next = self.0.trim_start();
        let (sign, meant) = signs.iter().find(|(sign, _)| next.starts_with(sign))?;
        self.0 = &next[sign.len()..];
        Some(*meant)
    }

    fn sum(&mut self) -> Result<Formula, String> {
        let negative = self.sign(&[("−", true), ("-", true), ("+", false)]).unwrap_or(false);
        let first = self.product()?;
        let mut sum = if negative { Formula::Negative(Box::new(first)) } else { first };
        let signs = [("+", Operation::Plus), ("−", Operation::Minus), ("-", Operation::Minus)];
        while let Some(operation) = self.sign(&signs) {
            sum = Formula::Both(operation, Box::new((sum, self.product()?)));
        }
        Ok(sum)
    }

    fn product(&mut self) -> Result<Formula, String> {
        let mut product = self.factor()?;
        loop {
            let signs = [("·", Operation::Times), ("*", Operation::Times), ("/", Operation::Over)];
            let operation = match self.sign(&signs) {
                Some(operation) => operation,
                None if self.begins_a_factor() => Operation::Times,
                None => return Ok(product),
            };
            product = Formula::Both(operation, Box::new((product, self.factor()?)));
        }
    }

    fn begins_a_factor(&self) -> bool {
        self.0.trim_start().chars().next().is_some_and(|next| !"+−-·*/)]".contains(next))
    }

    fn factor(&mut self) -> Result<Formula, String> {
        let formula = match self.sign(&FUNCTIONS) {
            Some(function) => {
                // sin² θ is the square of sin θ.
                let exponent = self.exponent()?;
                // √2 m is √2 times m, cos 2θ is of 2θ.
                let argument = match function {
                    Function::Root => self.simple()?,
                    Function::Sine | Function::Cosine | Function::Tangent => self.argument()?,
                };
                let of = Formula::Of(function, Box::new(argument));
                match exponent {
                    Some(exponent) => Formula::Power(Box::new(of), exponent),
                    None => of,
                }
            }
            None => self.simple()?,
        };
        Ok(match self.exponent()? {
            Some(exponent) => Formula::Power(Box::new(formula), exponent),
            None => formula,
        })
    }

    /// What a function is of: what is in brackets, or a letter with perhaps a number before it.
    fn argument(&mut self) -> Result<Formula, String> {
        let first = self.simple()?;
        let is_number = |formula: &Formula| match formula {
            Formula::Number(..) => true,
            Formula::Pi
            | Formula::Letter(_)
            | Formula::Negative(_)
            | Formula::Both(..)
            | Formula::Power(..)
            | Formula::Of(..) => false,
        };
        match is_number(&first) && self.begins_a_factor() {
            true => Ok(Formula::Both(Operation::Times, Box::new((first, self.simple()?)))),
            false => Ok(first),
        }
    }

    /// Brackets, a number or a letter.
    fn simple(&mut self) -> Result<Formula, String> {
        if let Some(closing) = self.sign(&[("(", ")"), ("[", "]")]) {
            let inside = self.sum()?;
            return match self.sign(&[(closing, ())]) {
                Some(()) => Ok(inside),
                None => Err(format!("a bracket of the formula is not closed by `{closing}`")),
            };
        }
        let next = self.0.trim_start();
        let digits = next.find(|sign: char| !sign.is_ascii_digit() && sign != '.').unwrap_or(next.len());
        if digits > 0 {
            self.0 = &next[digits..];
            let number = parse_number(&next[..digits]).map_err(|error| error.to_string())?;
            return Ok(match self.sign(&[("°", ())]) {
                // Angles are in radians.
                Some(()) => {
                    let part = Formula::Number(number / BigRational::from_integer(180.into()), BigRational::zero());
                    Formula::Both(Operation::Times, Box::new((part, Formula::Pi)))
                }
                None => {
                    let places = next[..digits].split_once('.').map(|(_, places)| places.len());
                    Formula::Number(number, places.map_or_else(BigRational::zero, half_of_place))
                }
            });
        }
        if self.sign(&[("π", ()), ("pi", ())]).is_some() {
            return Ok(Formula::Pi);
        }
        let letter = self.sign(&Letter::NAMES).map(Formula::Letter);
        letter.ok_or_else(|| match next.split_whitespace().next() {
            Some(word) => format!("`{word}` is not a letter of a formula"),
            None => "the formula ends too early".to_owned(),
        })
    }

    fn exponent(&mut self) -> Result<Option<u8>, String> {
        if let Some(exponent) = self.sign(&[("²", 2), ("³", 3)]) {
            return Ok(Some(exponent));
        }
        match self.sign(&[("^", ())]) {
            None => Ok(None),
            Some(()) => match self.sign(&[("2", 2), ("3", 3), ("4", 4)]) {
                Some(exponent) => Ok(Some(exponent)),
                None => Err("an exponent of a formula is 2, 3 or 4".to_owned()),
            },
        }
    }
}
