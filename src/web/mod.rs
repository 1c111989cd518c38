//! What does the page in a browser ask for? Texts in, texts out: a question as JSON, the answer as JSON.
//!
//! `question → layout → verdict, proof, sliders, report, claim → answer`
//!
//! The page decides nothing: every word and number that it shows comes from here, and it is what the program prints for the same
//! layout. [`answer`] is all of it; in WebAssembly `memory` hands the texts over.

mod catalogue;
mod claim;
mod judged;
mod look;
#[cfg(target_arch = "wasm32")]
pub mod memory;
mod mistake;
mod pages;
mod proof;
mod slider;
mod written;

use serde::Deserialize;
use serde_json::{Value, json};

use crate::page::{self, Language};
use mistake::Mistake;
use written::Written;

/// What is asked of a layout.
#[derive(Deserialize)]
#[serde(tag = "ask", rename_all = "kebab-case", deny_unknown_fields)]
enum Question {
    /// What the page needs before anything is asked of a layout.
    Begin,
    /// An engine known by name, in upper or lower case.
    Engine { name: String },
    /// The engines known by name.
    Catalogue,
    /// The verdicts alone, in words.
    Verdicts(Written),
    /// The verdicts and the engine in motion, perhaps after one value was set.
    Look {
        #[serde(flatten)]
        layout: Written,
        set: Option<slider::Set>,
    },
    /// The proofs in words, and as the JSON that the checker accepts.
    Proof(Written),
    /// The values that may be moved, with the exact zeros on their way.
    Sliders(Written),
    /// The report in a format.
    Report {
        #[serde(flatten)]
        layout: Written,
        #[serde(deserialize_with = "pages::format")]
        format: page::Format,
        #[serde(default, deserialize_with = "pages::language")]
        language: Language,
        /// Whether the engine moves in it, where a format can show that.
        moving: bool,
    },
    /// Whether a claim holds.
    Claim {
        #[serde(flatten)]
        layout: Written,
        says: String,
    },
}

/// The answer to a question: `{"ok": …}`, or `{"mistake": …}` with what is wrong, where, and what would be right.
///
/// ```standalone_crate
/// let asked = r#"{"ask": "claim", "name": "mine", "text": "inline.throws = [0, 180, 180, 0]", "says": "second-order force vanishes"}"#;
/// let answer = crankstar::web::answer(asked);
/// assert!(answer.starts_with(r#"{"ok":{"#) && answer.contains(r#""status":"false""#), "{answer}");
/// ```
pub fn answer(question: &str) -> String {
    let found = match serde_json::from_str::<Question>(question) {
        Ok(question) => answered(question),
        Err(error) => Err(Mistake::plain("the page made a request that this module does not know", &error.to_string())),
    };
    let answer = match found {
        Ok(answer) => json!({ "ok": answer }),
        Err(mistake) => json!({ "mistake": mistake }),
    };
    answer.to_string()
}

fn answered(question: Question) -> Result<Value, Mistake> {
    match question {
        Question::Begin => Ok(catalogue::begin()),
        Question::Engine { name } => catalogue::engine(&name),
        Question::Catalogue => catalogue::catalogue(),
        Question::Verdicts(layout) => Ok(look::verdicts(&layout.judged()?)),
        Question::Look { layout, set } => look::look(layout, set.as_ref()),
        Question::Proof(layout) => proof::proof(&layout.judged()?),
        Question::Sliders(layout) => slider::sliders(&layout),
        Question::Report { layout, format, language, moving } => {
            Ok(pages::report(&layout.judged()?, format, language, moving))
        }
        Question::Claim { layout, says } => claim::claim(&layout, &says),
    }
}
