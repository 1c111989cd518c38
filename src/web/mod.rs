//! What does the page in a browser ask for? Texts in, texts out: a question as JSON, the answer as JSON.
//!
//! `question → layout → verdict, proof, sliders, report, claim → answer`
//!
//! The page decides nothing: every word and number that it shows comes from here, and it is what the program prints for the same
//! layout. [`answer`] is all of it; in WebAssembly `memory` hands the texts over.

mod catalogue;
mod claim;
mod look;
#[cfg(target_arch = "wasm32")]
pub mod memory;
mod mistake;
mod pages;
mod proof;
mod slider;

use serde::Deserialize;
use serde_json::{Value, json};

use crate::engine::{Engine, Family};
use crate::family::{self, OpenOrder};
use crate::file::{self, FileResolver, Layout};
use crate::loads;
use crate::page::Language;
use crate::verdict::{self, Judgement};
use mistake::Mistake;

/// Larger texts are no layouts.
const LARGEST: usize = 1 << 20;

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
        format: pages::Format,
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

/// A layout file as it was written.
#[derive(Deserialize)]
struct Written {
    /// What messages call it, and its title where it has none.
    name: String,
    text: String,
}

impl Written {
    fn read(&self) -> Result<Layout, Mistake> {
        if self.text.len() > LARGEST {
            return Err(Mistake::plain("the layout is larger than 1 MiB", "a layout file is a page or two"));
        }
        let beside = FileResolver::nothing().of_catalogue(file::is_of_catalogue(&self.name, &self.text));
        file::parse_layout_beside(&self.name, &self.text, beside)
            .map_err(|error| Mistake::in_layout(&error, &self.text))
    }

    fn judged(&self) -> Result<Judged, Mistake> {
        Judged::of(self.read()?)
    }
}

/// What a layout describes, with its verdicts.
enum Judged {
    /// An engine, and the family that it is a member of, judged at the same orders.
    Known { engine: Box<Engine>, judged: Judgement, family: Option<(Box<Family>, Vec<OpenOrder>)> },
    /// A family.
    Open { family: Box<Family>, orders: Vec<OpenOrder> },
}

impl Judged {
    /// As the commands judge it where nothing else is asked for.
    fn of(layout: Layout) -> Result<Self, Mistake> {
        match layout {
            Layout::Known(engine, family) => {
                let mut orders = loads::usual_orders(&engine);
                orders.sort_unstable();
                orders.dedup();
                let quantities = verdict::quantities(&engine, false);
                let judged = Judgement::new(&engine, &orders, &quantities).map_err(Mistake::of)?;
                // Where the rods differ nothing is said of other values than those given.
                let family = family.filter(|family| family::comparable(family).is_ok());
                let open = |family: Box<Family>| {
                    let orders = family::classify(&family, &orders).map_err(Mistake::of)?;
                    Ok::<_, Mistake>((family, orders))
                };
                Ok(Judged::Known { engine, judged, family: family.map(open).transpose()? })
            }
            Layout::Open(family) => {
                family::comparable(&family).map_err(Mistake::of)?;
                let mut orders = family.orders().to_vec();
                orders.sort_unstable();
                orders.dedup();
                let orders = family::classify(&family, &orders).map_err(Mistake::of)?;
                Ok(Judged::Open { family, orders })
            }
        }
    }
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
        Question::Look { layout, set } => look::look(layout, set.as_ref()),
        Question::Proof(layout) => proof::proof(&layout.judged()?),
        Question::Sliders(layout) => slider::sliders(&layout),
        Question::Report { layout, format, language, moving } => {
            Ok(pages::report(&layout.judged()?, format, language, moving))
        }
        Question::Claim { layout, says } => claim::claim(&layout, &says),
    }
}
