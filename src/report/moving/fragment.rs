//! How is a scene put in a page? As a fragment of HTML with its numbers in JSON beside it.

use std::sync::LazyLock;

use serde::Serialize;
use tera::{Context, Tera};

use super::scene::{Body, Scene};
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

/// A cylinder in the row of pistons.
#[derive(Serialize)]
struct Column {
    name: String,
    colour: usize,
}

/// Colours that the style has for cranks.
const COLOURS: usize = 4;

fn column(body: &Body) -> Column {
    Column { name: text::xml(&body.name), colour: body.colour % COLOURS }
}

/// The HTML of a scene; `id` is its own on the page, of letters, digits and hyphens.
///
/// It is hidden until [`MOVING_SCRIPT`] runs: a page without scripts has its still figures.
pub fn moving_fragment(scene: &Scene, id: &str, language: Language) -> String {
    let scene = scene.spoken(language);
    let json = serde_json::to_string(&scene).unwrap_or_default();
    let orders: Vec<u32> = scene.orders.iter().map(|order| order.order).collect();
    let notes: Vec<String> = scene.notes.iter().map(|note| text::xml(&note.plain_in(language))).collect();
    let columns: Vec<Column> = scene.bodies.iter().map(column).collect();
    let mut context = Context::new();
    context.insert("id", &text::xml(id));
    context.insert("title", &text::xml(&scene.title));
    context.insert("seen", &scene.seen);
    context.insert("orders", &orders);
    context.insert("start", &scene.start.0);
    context.insert("quantity", scene.start.1);
    context.insert("has_total", &scene.units.is_some());
    context.insert("notes", &notes);
    context.insert("angle", &scene.angle);
    context.insert("columns", &columns);
    context.insert("json", &text::json_in_script(&json));
    context.insert("language", language.code());
    TEMPLATE.render("moving", &context).expect(OURS)
}
