//! What stands in the title block of a calculation report? What the table `[document]` says, word for word.

use serde::Deserialize;

use super::written::Text;
use crate::text::Untrusted;

/// Title block and objective, as far as the file gives them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TitleBlock {
    /// Rows of the title block: what it is, and what was written.
    pub rows: Vec<(&'static str, Untrusted)>,
    /// What the calculation is for.
    pub objective: Option<Untrusted>,
    /// What was assumed by the author of the file.
    pub assumptions: Vec<Untrusted>,
}

/// `[document]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Keys {
    number: Option<Text>,
    revision: Option<Text>,
    project: Option<Text>,
    author: Option<Text>,
    checked: Option<Text>,
    date: Option<Text>,
    objective: Option<Text>,
    assumptions: Option<Vec<Text>>,
}

impl Keys {
    pub fn read(&self) -> TitleBlock {
        let rows = [
            ("Document", &self.number),
            ("Revision", &self.revision),
            ("Project", &self.project),
            ("Author", &self.author),
            ("Checked", &self.checked),
            ("Date", &self.date),
        ];
        let written = |text: &Text| text.get_ref().untrusted();
        TitleBlock {
            rows: rows.into_iter().filter_map(|(name, text)| Some((name, written(text.as_ref()?)))).collect(),
            objective: self.objective.as_ref().map(written),
            assumptions: self.assumptions.iter().flatten().map(written).collect(),
        }
    }
}
