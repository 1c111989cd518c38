//! How is an exact number written, and read back? `2√3`, `(3√2 − √6)/4`, `√(5 − 2√5)`, `3·cos(40°)`, `2√3·sin²(4.5°)`.

use std::fmt;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::form::{Form, MOST_COSINES, Root};
use crate::exact::{Turn, fraction};
use crate::file::parse_number;

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&write(self, &TEXT))
    }
}

impl Form {
    /// The number in TeX, for the mathematics mode.
    pub fn tex(&self) -> String {
        write(self, &TEX)
    }

    /// Reads what is printed, and what a person would write: `sqrt(3)/2`, `1/2*√10`, `1.5`.
    ///
    /// ```standalone_crate
    /// # use crankstar_kernel as crankstar;
    /// use crankstar::numbers::Form;
    /// assert_eq!(Form::parse("sqrt(12)").unwrap().to_string(), "2√3");
    /// assert_eq!(Form::parse("½√(50 − 22√5)").unwrap().to_string(), "√(50 − 22√5)/2");
    /// assert!(Form::parse("2√").is_none());
    /// ```
    ///
    /// Numbers, `+ − · * /` with a rational divisor, `√`, `sqrt`, `cos(…°)`, `sin 36°`, `sin² 36°` or `sin 36 deg`, and brackets are understood;
    /// `None` for all else, and for the root of a negative number.
    pub fn parse(text: &str) -> Option<Form> {
        let spaced =
            text.replace("sqrt", "√").replace('−', "-").replace('·', "*").replace('½', "(1/2)").replace("deg", "°");
        let mut parser =
            Parser { letters: spaced.chars().filter(|letter| !letter.is_whitespace()).collect(), at: 0, depth: 0 };
        let form = parser.sum()?;
        (parser.at == parser.letters.len()).then_some(form)
    }
}

/// How the parts of a form are put down.
struct Style {
    minus: &'static str,
    /// A minus between two terms.
    less: &'static str,
    fraction: fn(&str, &BigInt, bool) -> String,
    root: fn(&str, bool) -> String,
    /// Name, power, degrees.
    function: fn(&str, usize, &str) -> String,
    times: &'static str,
}

/// Powers as they are written behind a name: no more than a product has cosines.
const RAISED: [&str; MOST_COSINES + 1] = ["", "", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸"];

const TEXT: Style = Style {
    minus: "−",
    less: " − ",
    fraction: |numerator, denominator, is_sum| match is_sum {
        true => format!("({numerator})/{denominator}"),
        false => format!("{numerator}/{denominator}"),
    },
    root: |inside, is_number| if is_number { format!("√{inside}") } else { format!("√({inside})") },
    function: |name, power, degrees| format!("{name}{}({degrees}°)", RAISED.get(power).copied().unwrap_or_default()),
    times: "·",
};

const TEX: Style = Style {
    minus: "-",
    less: " - ",
    fraction: |numerator, denominator, _| format!("\\tfrac{{{numerator}}}{{{denominator}}}"),
    root: |inside, _| format!("\\sqrt{{{inside}}}"),
    function: |name, power, degrees| match power {
        1 => format!("\\{name}({degrees}^\\circ)"),
        _ => format!("\\{name}^{power}({degrees}^\\circ)"),
    },
    times: "",
};

fn write(form: &Form, style: &Style) -> String {
    let denominator = fraction::common_denominator(form.terms().iter().map(|(_, coefficient)| coefficient));
    let common = BigRational::from_integer(denominator.clone());
    let mut text = String::new();
    // `√5 − 1` reads better than `−1 + √5`.
    let first = form.terms().iter().position(|(_, coefficient)| coefficient.is_positive()).unwrap_or(0);
    let (before, from) = form.terms().split_at(first);
    for (root, coefficient) in from.iter().take(1).chain(before).chain(from.iter().skip(1)) {
        let whole = (coefficient * &common).to_integer();
        text.push_str(match (text.is_empty(), whole.is_negative()) {
            (true, true) => style.minus,
            (true, false) => "",
            (false, true) => style.less,
            (false, false) => " + ",
        });
        text.push_str(&term(root, &whole.abs(), style));
    }
    if text.is_empty() {
        return "0".to_owned();
    }
    if denominator.is_one() {
        return text;
    }
    match (text.strip_prefix(style.minus), form.terms().len()) {
        (Some(positive), 1) => format!("{}{}", style.minus, (style.fraction)(positive, &denominator, false)),
        (_, count) => (style.fraction)(&text, &denominator, count > 1),
    }
}

fn term(root: &Root, coefficient: &BigInt, style: &Style) -> String {
    let (root, cosines): (&Root, &[Turn]) = match root {
        Root::One | Root::Whole(_) | Root::Nested(_) => (root, &[]),
        Root::Cosine(angle) => (&Root::One, std::slice::from_ref(angle)),
        Root::Product(root, cosines) => (root, cosines),
    };
    let root = match root {
        Root::One => String::new(),
        Root::Whole(n) => (style.root)(&n.to_string(), true),
        Root::Nested(form) => (style.root)(&write(form, style), false),
        Root::Cosine(_) | Root::Product(..) => unreachable!("cosines are behind a root of numbers"),
    };
    let number = if coefficient.is_one() && !(root.is_empty() && cosines.is_empty()) {
        String::new()
    } else {
        coefficient.to_string()
    };
    let first = format!("{number}{root}");
    // Equal angles are beside each other.
    let factors = cosines.chunk_by(|a, b| a == b).map(|alike| function(&alike[0], alike.len(), style));
    let factors: Vec<String> = Some(first).filter(|first| !first.is_empty()).into_iter().chain(factors).collect();
    factors.join(style.times)
}

/// A power of a cosine, of an angle above 45° the sine of what is missing to 90°.
fn function(angle: &Turn, power: usize, style: &Style) -> String {
    let degrees = angle.degrees();
    let right = BigRational::from_integer(90.into());
    match &degrees + &degrees > right {
        true => (style.function)("sin", power, &plain_degrees(&(right - degrees))),
        false => (style.function)("cos", power, &plain_degrees(&degrees)),
    }
}

/// `22.5`, `180/7`: a decimal where it ends after three places.
fn plain_degrees(degrees: &BigRational) -> String {
    fraction::written(degrees, 3)
}

/// Brackets and roots nested deeper than this are nobody's number.
const DEEPEST: usize = 32;

struct Parser {
    letters: Vec<char>,
    at: usize,
    depth: usize,
}

impl Parser {
    fn peek(&self) -> Option<char> {
        self.letters.get(self.at).copied()
    }

    fn takes(&mut self, letter: char) -> bool {
        let found = self.peek() == Some(letter);
        self.at += usize::from(found);
        found
    }

    fn sum(&mut self) -> Option<Form> {
        let mut sum = Form::rational(BigRational::from_integer(0.into()));
        let mut sign = if self.takes('-') { -1 } else { 1 };
        loop {
            let part = self.product()?;
            sum = sum.plus(&part.scaled(&BigRational::from_integer(sign.into())));
            sign = match self.peek() {
                Some('+') => 1,
                Some('-') => -1,
                _ => return Some(sum),
            };
            self.at += 1;
        }
    }

    fn product(&mut self) -> Option<Form> {
        let mut product = self.factor()?;
        loop {
            if self.takes('/') {
                let divisor = self.factor()?.as_rational().filter(|divisor| *divisor.numer() != BigInt::from(0))?;
                product = product.scaled(&divisor.recip());
            } else if self.takes('*') || matches!(self.peek(), Some('√' | '(' | 'c' | 's')) {
                product = product.times(&self.factor()?)?;
            } else {
                return Some(product);
            }
        }
    }

    fn factor(&mut self) -> Option<Form> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return None;
        }
        let factor = self.root_bracket_or_number();
        self.depth -= 1;
        factor
    }

    fn root_bracket_or_number(&mut self) -> Option<Form> {
        if self.takes('√') {
            let inside = self.factor()?;
            return (inside.to_float() >= 0.0).then(|| inside.square_root());
        }
        if self.takes('(') {
            let inside = self.sum()?;
            return self.takes(')').then_some(inside);
        }
        for (name, is_sine) in [("cos", false), ("sin", true)] {
            if self.letters[self.at..].iter().copied().take(3).eq(name.chars()) {
                self.at += 3;
                let power = (2..RAISED.len()).find(|&power| RAISED[power].chars().all(|sign| self.takes(sign)));
                let bracket = self.takes('(');
                let degrees = self.number()?;
                (self.takes('°') && (!bracket || self.takes(')'))).then_some(())?;
                let angle = Turn::from_degrees(&degrees);
                let angle = if is_sine { &Turn::fraction(1, 4) - &angle } else { angle };
                let value = Form::cosine(BigRational::one(), angle);
                return (1..power.unwrap_or(1)).try_fold(value.clone(), |product, _| product.times(&value));
            }
        }
        self.number().map(Form::rational)
    }

    fn number(&mut self) -> Option<BigRational> {
        let digits =
            self.letters[self.at..].iter().take_while(|letter| letter.is_ascii_digit() || **letter == '.').count();
        let text: String = self.letters[self.at..self.at + digits].iter().collect();
        self.at += digits;
        let slash = self.peek() == Some('/') && self.letters.get(self.at + 1).is_some_and(char::is_ascii_digit);
        let number = parse_number(&text).ok()?;
        // Inside a cosine the angle may be a fraction of degrees.
        if slash
            && self.letters[self.at..].iter().find(|letter| !letter.is_ascii_digit() && **letter != '/') == Some(&'°')
        {
            self.at += 1;
            return Some(number / self.number()?);
        }
        Some(number)
    }
}
