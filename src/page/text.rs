//! What is in a line: words, values, symbols, formulas, a person's words?

use std::borrow::Cow;

use num_rational::BigRational;

use super::Unit;
use super::number::{Amount, Bearing, Number};
use crate::engine::{Cycle, SeenFrom};
use crate::numbers::Form;
use crate::proof::{Axial, Planar, Quantity, Sense};
use crate::text::Untrusted;

/// What a paragraph, a cell or a caption holds.
#[derive(Clone, Debug, Default)]
pub struct Text {
    pieces: Vec<Piece>,
}

/// A part of a text.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Piece {
    /// Words of the program, with `$formulas$` in TeX, `**bold**` and `{}` for each value.
    Phrase(Cow<'static, str>, Vec<Text>),
    /// Signs of the program that are no words: names in a row, an angle, a list of orders.
    Label(String),
    /// A person's words: nothing in them is markup.
    Person(Untrusted),
    /// A number.
    Number(Number),
    /// An exact number alone, without decimals.
    Form(Form),
    /// A direction.
    Bearing(Bearing),
    /// A decimal with its unit, to sensible figures: a unit says that it is one.
    Quantity(f64, Unit),
    /// A bound with its unit, which is never rounded down, whatever figures the reader asks for.
    AtMost(f64, Unit),
    /// A decimal whose unit is given elsewhere, as over its column, and how it is set.
    Measured(f64, Unit, Setting),
    /// An irrational number with its decimals, whose unit is given elsewhere: the form holds in that unit alone.
    Closed(Form, f64, Unit),
    /// An exact number whose unit is given elsewhere.
    Exactly(BigRational, Unit),
    /// The same in little room: a long number in decimals after ≈.
    Shortly(BigRational, Unit),
    /// What holds in this unit alone: nothing where the reader counts in another.
    InUnit(Box<Text>, Unit),
    /// The name of a unit alone.
    Unit(Unit),
    /// A formula in TeX.
    Formula(String),
    /// What is typed: a command, a name of a file.
    Code(String),
    /// Which of the words of its place are said: `{with|against}`, counted from 0.
    Choice(usize),
    /// Words that lead elsewhere: a file, or `#` and the name of a heading.
    Link(Box<Text>, String),
}

/// How a decimal is set whose unit is elsewhere.
#[derive(Clone, Copy, Debug)]
pub enum Setting {
    /// After ≈, to four figures or those that the reader asks for.
    About,
    /// So, or to the figures that the reader asks for.
    Usual(fn(f64) -> String),
    /// So, whatever the reader asks for: a bound is never rounded down, and what is compared keeps its figures.
    Fixed(fn(f64) -> String),
}

impl Text {
    /// Words of the program with values in their places.
    pub fn phrase(words: impl Into<Cow<'static, str>>, values: Vec<Text>) -> Self {
        Text { pieces: vec![Piece::Phrase(words.into(), values)] }
    }

    /// Signs of the program that are no words.
    pub fn label(text: impl Into<String>) -> Self {
        Piece::Label(text.into()).into()
    }

    /// Exactly zero, proved.
    pub fn zero() -> Self {
        Piece::Number(Number::Zero).into()
    }

    /// A formula in TeX.
    pub fn formula(tex: impl Into<String>) -> Self {
        Piece::Formula(tex.into()).into()
    }

    /// A decimal after ≈, whose unit is given elsewhere.
    pub fn measured(value: f64, unit: Unit) -> Self {
        Piece::Measured(value, unit, Setting::About).into()
    }

    /// A decimal after ≈ with its unit.
    pub fn measured_in(value: f64, unit: Unit) -> Self {
        Text::set_in(value, unit, Setting::About)
    }

    /// A decimal that is set so, with its unit.
    pub fn set_in(value: f64, unit: Unit, setting: Setting) -> Self {
        Text::from(Piece::Measured(value, unit, setting)).and(Piece::Label("\u{202f}".to_owned())).and(unit)
    }

    /// A value of a table; a dash where there is none.
    pub fn or_dash(value: Option<impl Into<Text>>) -> Self {
        value.map_or_else(|| "–".into(), Into::into)
    }

    /// A decimal without a sign before it, to four figures or those that the reader asks for.
    pub fn figures(value: f64) -> Self {
        Piece::Measured(value, Unit::NONE, Setting::Usual(super::number::decimal)).into()
    }

    /// What is typed.
    pub fn code(text: impl Into<String>) -> Self {
        Piece::Code(text.into()).into()
    }

    /// Words that lead elsewhere.
    pub fn link(text: impl Into<Text>, target: impl Into<String>) -> Self {
        Piece::Link(Box::new(text.into()), target.into()).into()
    }

    /// Which of the words of its place it chooses.
    pub(super) fn choice(&self) -> Option<usize> {
        match self.pieces[..] {
            [Piece::Choice(choice)] => Some(choice),
            _ => None,
        }
    }

    /// The parts.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Whether it is empty.
    pub fn is_empty(&self) -> bool {
        self.pieces.is_empty()
    }

    /// Whether it is empty, or a value in its words is.
    pub(super) fn lacks_a_value(&self) -> bool {
        let lacks = |piece: &Piece| matches!(piece, Piece::Phrase(_, values) if values.iter().any(Text::is_empty));
        self.is_empty() || self.pieces.iter().any(lacks)
    }

    /// Whether it says no more than that something is exactly zero.
    pub fn is_zero(&self) -> bool {
        self.pieces.iter().all(|piece| matches!(piece, Piece::Number(Number::Zero))) && !self.pieces.is_empty()
    }

    /// With more behind it.
    pub fn and(mut self, more: impl Into<Text>) -> Self {
        self.pieces.extend(more.into().pieces);
        self
    }

    /// Texts with the same words between them.
    pub fn joined(texts: impl IntoIterator<Item = Text>, between: &'static str) -> Self {
        let mut out = Text::default();
        for text in texts {
            if !out.is_empty() {
                out.pieces.push(Piece::Phrase(between.into(), Vec::new()));
            }
            out.pieces.extend(text.pieces);
        }
        out
    }
}

/// Words of the program with values: `phrase!("vanishes at {} of {}", here, there)`, `phrase!("turns {with|against} the crank", sense)`.
macro_rules! phrase {
    ($words:expr $(, $value:expr)* $(,)?) => {
        $crate::page::Text::phrase($words, vec![$($crate::page::Text::from($value)),*])
    };
}

pub(crate) use phrase;

impl From<Piece> for Text {
    fn from(piece: Piece) -> Self {
        Text { pieces: vec![piece] }
    }
}

impl From<&'static str> for Text {
    fn from(words: &'static str) -> Self {
        if words.is_empty() { Text::default() } else { Text::phrase(words, Vec::new()) }
    }
}

/// Signs that are no words.
impl From<String> for Text {
    fn from(label: String) -> Self {
        Text::label(label)
    }
}

impl From<u32> for Text {
    fn from(number: u32) -> Self {
        Text::label(number.to_string())
    }
}

impl From<usize> for Text {
    fn from(number: usize) -> Self {
        Text::label(number.to_string())
    }
}

/// Which of the words of a place are said: of `{with|against}` the first or the second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice(usize);

impl Choice {
    /// For a place such as `{order|orders}`: the first words for one, the second for more.
    pub fn one_or_more(count: usize) -> Self {
        Choice::from(count == 1)
    }

    /// The words of this number, counted from 0.
    pub fn of(number: usize) -> Self {
        Choice(number)
    }
}

impl From<Choice> for Text {
    fn from(choice: Choice) -> Self {
        Piece::Choice(choice.0).into()
    }
}

/// For a place such as `{if it holds|if not}`.
impl From<bool> for Choice {
    fn from(holds: bool) -> Self {
        Choice(usize::from(!holds))
    }
}

/// For a place such as `{with|against}`.
impl From<Sense> for Choice {
    fn from(sense: Sense) -> Self {
        Choice::from(sense == Sense::Direct)
    }
}

/// For a place such as `{force|moment}`.
impl From<Planar> for Choice {
    fn from(quantity: Planar) -> Self {
        Choice::from(quantity == Planar::Force)
    }
}

/// For a place such as `{force|moment|inertia torque|roll moment}`.
impl From<Quantity> for Choice {
    fn from(quantity: Quantity) -> Self {
        match quantity {
            Quantity::Planar(quantity) => quantity.into(),
            Quantity::Axial(Axial::Torque) => Choice(2),
            Quantity::Axial(Axial::Roll) => Choice(3),
        }
    }
}

/// For a place such as `{from the free end|from the flywheel}`.
impl From<SeenFrom> for Choice {
    fn from(end: SeenFrom) -> Self {
        Choice::from(end == SeenFrom::FreeEnd)
    }
}

/// For a place such as `{two|four}`.
impl From<Cycle> for Choice {
    fn from(cycle: Cycle) -> Self {
        Choice::from(cycle == Cycle::TwoStroke)
    }
}

impl From<&Untrusted> for Text {
    fn from(words: &Untrusted) -> Self {
        Piece::Person(words.clone()).into()
    }
}

impl From<Unit> for Text {
    fn from(unit: Unit) -> Self {
        Piece::Unit(unit).into()
    }
}

impl From<Number> for Text {
    fn from(number: Number) -> Self {
        Piece::Number(number).into()
    }
}

impl From<Amount> for Text {
    fn from(amount: Amount) -> Self {
        amount.number().into()
    }
}

impl From<Bearing> for Text {
    fn from(bearing: Bearing) -> Self {
        Piece::Bearing(bearing).into()
    }
}
