//! How does the template of an engine in motion make its part of a page?

use serde::Serialize;
use tera::{Context, Tera};

const MOVING: &str = include_str!("../../templates/html/moving.html");

/// The template is part of the program, so that a mistake in it is a mistake of ours.
const OURS: &str = "a template of the program";

/// Fills the template of an engine in motion.
pub(super) fn moving(fragment: &impl Serialize) -> String {
    let mut tera = Tera::default();
    tera.autoescape_on(Vec::<&str>::new());
    tera.add_raw_template("page", MOVING).expect(OURS);
    tera.render("page", &Context::from_serialize(fragment).expect(OURS)).expect(OURS)
}
