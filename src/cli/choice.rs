//! How is one of several things asked for? By its name; `--help` tells of each.

use std::ffi::OsStr;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::error::ErrorKind;
use clap::{Arg, Command, Error};

/// Things that are asked for by their names.
#[derive(Clone)]
pub struct Choices<T>(Vec<(PossibleValue, T)>);

impl<T> Choices<T> {
    /// Each with its name, and what is told of it.
    pub fn new(all: impl IntoIterator<Item = (&'static str, &'static str, T)>) -> Self {
        Choices(all.into_iter().map(|(name, about, one)| (PossibleValue::new(name).help(about), one)).collect())
    }

    /// The same things as a part of others.
    pub fn each<U>(self, of: impl Fn(T) -> U) -> Choices<U> {
        Choices(self.0.into_iter().map(|(name, one)| (name, of(one))).collect())
    }

    /// With more behind them.
    pub fn and(mut self, more: Choices<T>) -> Self {
        self.0.extend(more.0);
        self
    }

    /// The thing of this name.
    pub fn named(&self, name: &str, ignore_case: bool) -> Option<&T> {
        self.0.iter().find(|(known, _)| known.matches(name, ignore_case)).map(|(_, one)| one)
    }
}

impl<T: Clone + Send + Sync + 'static> TypedValueParser for Choices<T> {
    type Value = T;

    fn parse_ref(&self, command: &Command, argument: Option<&Arg>, value: &OsStr) -> Result<T, Error> {
        let names = PossibleValuesParser::new(self.0.iter().map(|(name, _)| name.clone()));
        let name = names.parse_ref(command, argument, OsStr::new(&*value.to_string_lossy()))?;
        self.named(&name, false).cloned().ok_or_else(|| Error::new(ErrorKind::InvalidValue))
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(self.0.iter().map(|(name, _)| name.clone())))
    }
}
