//! How is the title block of a calculation report written? `[document]`.

use serde::Deserialize;

use super::written::Text;
use crate::engine::TitleBlock;

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
