//! What is a firing study to whoever asks it? Its table, its document, its pages.

use super::super::question::question;
use super::data;
use super::{FiringStudy, firing_answer, firing_document, firing_page};

question!(FiringStudy, "firing", |study| Some(study.engine.title()), data::table, firing_answer, firing_page, {
    fn is_certified(&self) -> bool {
        true
    }

    fn json(&self) -> serde_json::Result<String> {
        serde_json::to_string_pretty(&firing_document(self, false))
    }
});
