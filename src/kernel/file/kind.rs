//! Which of the files that questions read is it: a layout, masses on a shaft, a turning-moment diagram?

use toml::de::DeValue;

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
}

/// The keys of a turning-moment diagram of which it has one.
const OF_A_DIAGRAM: [&str; 5] = ["areas", "points", "triangles", "harmonics", "mean"];

impl Kind {
    /// That of a file, by its keys; what is no TOML is a layout, whose reader tells what is wrong with it.
    pub fn of(source: &str) -> Self {
        let Ok(table) = written::table(source) else { return Kind::Layout };
        let keys = table.get_ref();
        let has_masses = keys.get("mass").is_some_and(|value| matches!(value.get_ref(), DeValue::Array(_)));
        match OF_A_DIAGRAM.into_iter().any(|key| keys.contains_key(key)) {
            true => Kind::Diagram,
            false if has_masses => Kind::Shaft,
            false => Kind::Layout,
        }
    }
}
