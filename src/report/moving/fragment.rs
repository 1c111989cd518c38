//! How does a scene stand in a page? As a fragment of HTML with its numbers in JSON beside it.

use std::sync::LazyLock;

use serde::Serialize;
use tera::{Context, Tera};

use super::scene::{Body, MovingAngle, Scene};
use crate::page::{Language, say};
use crate::text;

/// The script that moves every scene of a page: once a page, at the end of its body, between `<script>` and `</script>`.
pub const MOVING_SCRIPT: &str = include_str!("../../../templates/html/moving.js");

/// The style of the fragments: once a page, in its head, between `<style>` and `</style>`.
pub const MOVING_STYLE: &str = include_str!("../../../templates/html/moving.css");

/// The template is part of the program, so that a mistake in it is a mistake of ours.
const OURS: &str = "a template of the program";

static TEMPLATE: LazyLock<Tera> = LazyLock::new(|| {
    let mut tera = Tera::default();
    tera.autoescape_on(Vec::<&str>::new());
    tera.register_filter("say", say);
    tera.add_raw_template("moving", include_str!("../../../templates/html/moving.html")).expect(OURS);
    tera
});

/// What the template of the fragment places.
#[derive(Serialize)]
struct Fragment<'a> {
    id: String,
    title: String,
    seen: &'static str,
    orders: Vec<String>,
    notes: Vec<String>,
    angle: Option<&'a MovingAngle>,
    strip: usize,
    columns: Vec<Column>,
    json: String,
    language: &'static str,
}

/// A cylinder in the row of pistons.
#[derive(Serialize)]
struct Column {
    name: String,
    x: usize,
    colour: usize,
    letters: usize,
}

/// Width of a column, in the units of the drawing.
const COLUMN: usize = 10;
/// A row of fewer columns is as wide as one of so many.
const FEWEST: usize = 6;
/// Colours that the style has for cranks.
const COLOURS: usize = 4;

fn column((index, body): (usize, &Body), inset: usize) -> Column {
    let letters = 13_usize.checked_div(body.name.chars().count()).unwrap_or(5).clamp(1, 5);
    Column { name: text::xml(&body.name), x: inset + index * COLUMN + 1, colour: body.crank % COLOURS, letters }
}

/// The HTML of a scene; `id` is its own on the page, of letters, digits and hyphens.
///
/// It is hidden until [`MOVING_SCRIPT`] runs: a page without scripts has its still figures.
pub fn moving_fragment(scene: &Scene, id: &str, language: Language) -> String {
    let scene = scene.spoken(language);
    let json = serde_json::to_string(&scene).unwrap_or_default();
    let strip = scene.bodies.len().max(FEWEST) * COLUMN;
    let inset = (strip - scene.bodies.len() * COLUMN) / 2;
    let fragment = Fragment {
        id: text::xml(id),
        title: text::xml(&scene.title),
        seen: scene.seen,
        orders: scene.orders.iter().map(|order| text::xml(&order.name)).collect(),
        notes: scene.notes.iter().map(|note| text::xml(note)).collect(),
        angle: scene.angle.as_ref(),
        strip,
        columns: scene.bodies.iter().enumerate().map(|body| column(body, inset)).collect(),
        json: text::json_in_script(&json),
        language: language.code(),
    };
    let context = Context::from_serialize(&fragment).expect(OURS);
    TEMPLATE.render("moving", &context).expect(OURS)
}
