//! What is in the title block of a calculation report? What the table `[document]` says, word for word.

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
