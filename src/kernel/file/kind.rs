//! Which of the files that questions read is it: a layout, masses on a shaft, a turning-moment diagram, claims?

use serde::de::DeserializeOwned;
use toml::de::DeValue;

use super::error::LayoutError;
use super::schema::tables;
use super::written;

/// What a file describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// An engine.
    Layout,
    /// Masses on a shaft.
    Shaft,
    /// A turning-moment diagram.
    Diagram,
    /// Claims about engines.
    Claims,
}

/// The keys of a turning-moment diagram of which it has one.
const OF_A_DIAGRAM: [&str; 5] = ["areas", "points", "triangles", "harmonics", "mean"];
/// The lists of a file of claims.
const OF_CLAIMS: [&str; 3] = ["claim", "statement", "table"];

impl Kind {
    /// That of a file, by its keys; what is no TOML is a layout, whose reader tells what is wrong with it.
    pub fn of(source: &str) -> Self {
        Kind::certain(source).unwrap_or(Kind::Layout)
    }

    /// That which the keys tell; none where they could be of any.
    fn certain(source: &str) -> Option<Self> {
        let table = written::table(source).ok()?;
        let keys = table.get_ref();
        let is_list = |key: &str| keys.get(key).is_some_and(|value| matches!(value.get_ref(), DeValue::Array(_)));
        let is_below = |key: &str| match keys.get(key).map(|value| value.get_ref()) {
            Some(DeValue::Table(_)) => true,
            Some(DeValue::Array(list)) => list.iter().any(|value| matches!(value.get_ref(), DeValue::Table(_))),
            _ => false,
        };
        let (_, of_a_layout) = tables().next()?;
        let kinds = [
            (Kind::Layout, of_a_layout.into_iter().any(is_below)),
            (Kind::Diagram, OF_A_DIAGRAM.into_iter().any(|key| keys.contains_key(key))),
            (Kind::Shaft, is_list("mass")),
            (Kind::Claims, OF_CLAIMS.into_iter().any(is_list)),
        ];
        kinds.into_iter().find_map(|(kind, is_it)| is_it.then_some(kind))
    }

    /// The keys of a file of this kind, or the first mistake: that it is a file of another kind, if it is.
    pub(crate) fn read<T: DeserializeOwned>(self, source: &str) -> Result<T, LayoutError> {
        written::read(source).map_err(|error| self.refused(source, error))
    }

    /// Why a file is not read as one of this kind: where it is one of another, that is the reason.
    pub(crate) fn refused(self, source: &str, error: LayoutError) -> LayoutError {
        let start = source.len() - source.trim_start().len();
        if source[start..].starts_with('{') {
            let right = "`crankstar verify` reads JSON; other files are TOML";
            return LayoutError::new("this file is JSON, and TOML is expected", right, Some(start..start + 1));
        }
        let Some(found) = Kind::certain(source).filter(|found| *found != self) else { return error };
        let [(expected, _), (what, right)] = [self, found].map(Kind::words);
        LayoutError::new(format!("this file holds {what}, and {expected} is expected"), right, None)
    }

    /// What it holds, and who reads it.
    fn words(self) -> (&'static str, &'static str) {
        match self {
            Kind::Layout => ("the layout of an engine", "most commands read it, such as `crankstar classify`"),
            Kind::Shaft => ("a list of masses on a shaft", "`crankstar rotor` reads it"),
            Kind::Diagram => ("a turning-moment diagram", "`crankstar flywheel` reads it"),
            Kind::Claims => ("a list of claims", "`crankstar check` reads it"),
        }
    }
}
