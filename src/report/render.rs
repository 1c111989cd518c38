//! How do the templates make a page?

use serde::Serialize;
use tera::{Context, Delimiters, Tera};

const ACCURACY: &str = include_str!("../../templates/accuracy.md");
#[cfg(feature = "optimise")]
const OPTIMISE: &str = include_str!("../../templates/optimise.md");
#[cfg(feature = "optimise")]
const OPTIMISE_SUMMARY: &str = include_str!("../../templates/optimise-summary.md");
const MOVING: &str = include_str!("../../templates/html/moving.html");

/// The templates are part of the program, so that a mistake in one is a mistake of ours.
const OURS: &str = "a template of the program";

/// Fills the template of a page on accuracy.
pub(super) fn accuracy(page: &impl Serialize) -> String {
    fill(ACCURACY, page, false)
}

/// Fills the template of a page of best crankshafts.
#[cfg(feature = "optimise")]
pub(super) fn optimise(page: &impl Serialize) -> String {
    fill(OPTIMISE, page, false)
}

/// Fills the template of what that page begins with.
#[cfg(feature = "optimise")]
pub(super) fn optimise_summary(summary: &impl Serialize) -> String {
    fill(OPTIMISE_SUMMARY, summary, false)
}

/// Fills the template of an engine in motion.
pub(super) fn moving(fragment: &impl Serialize) -> String {
    fill(MOVING, fragment, false)
}

fn fill(template: &str, page: &impl Serialize, latex: bool) -> String {
    let mut tera = Tera::default();
    tera.autoescape_on(Vec::<&str>::new());
    if latex {
        tera.set_delimiters(Delimiters {
            block_start: "<%".into(),
            block_end: "%>".into(),
            variable_start: "<<".into(),
            variable_end: ">>".into(),
            comment_start: "<#".into(),
            comment_end: "#>".into(),
        })
        .expect(OURS);
    }
    tera.add_raw_template("page", template).expect(OURS);
    tera.render("page", &Context::from_serialize(page).expect(OURS)).expect(OURS)
}
