//! What is a student given, and what is to be found? The engine in pictures and numbers, and the tables to fill in.

use super::super::convention::seen;
use super::super::mechanism_words::centres;
use super::super::residual;
use super::super::table;
use super::super::views::{end_view, end_view_caption, side_view, side_view_caption};
use super::unit_of;
use crate::classroom::{Pupil, Scheme};
use crate::page::{Block, Choice, Document, Picture, Table, Text, phrase};
use crate::proof::Planar;
use crate::report::texts::sheet as text;

/// The sheet of a student, to be marked by this scheme; `table` is the name of the file with the table to fill in.
pub fn exercise_sheet(pupil: &Pupil, orders: &[u32], table: &str, scheme: &Scheme) -> Document {
    text::Page {
        student: (&pupil.name).into(),
        given: given(pupil).into(),
        orders: residual::orders_in_words(orders),
        formulas: [(PHASES, 1), (SUMS, 2)]
            .map(|(tex, number)| Block::Formula(tex.to_owned(), Some(number)))
            .into_iter()
            .collect(),
        tables: tables(pupil, orders).into(),
        file: Text::code(table),
        digits: scheme.digits.into(),
    }
    .document()
}

/// The engine.
pub(super) fn given(pupil: &Pupil) -> Vec<Block> {
    let engine = &pupil.engine;
    let end = Picture::new("end-view", end_view_caption(engine), end_view(engine));
    let side = Picture::new("side-view", side_view_caption(engine), side_view(engine));
    let vectors = if engine.has_unit_masses() { text::equal_pistons() } else { text::unequal_pistons() };
    let plane = text::moments_about(table::place(engine, engine.reference_plane()));
    vec![
        Block::Heading(1, "Given".into()),
        text::cylinders(engine.cylinders().len(), Choice::one_or_more(engine.cylinders().len())).into(),
        Block::Pictures(vec![end, side]),
        table::cylinders(engine).into(),
        Block::List(vec![seen(engine.convention()), centres(engine), vectors, plane]),
    ]
}

const PHASES: &str =
    "\\varphi_{j}^{+} = k\\beta_j - (k-1)\\alpha_j, \\qquad \\varphi_{j}^{-} = -k\\beta_j + (k+1)\\alpha_j";
const SUMS: &str = "P_k^{\\pm} = \\sum_j w_j\\, e^{i\\varphi_{j}^{\\pm}}, \\qquad C_k^{\\pm} = \\sum_j w_j\\, z_j\\, e^{i\\varphi_{j}^{\\pm}}";

/// A table to fill in for each order.
fn tables(pupil: &Pupil, orders: &[u32]) -> Vec<Block> {
    let engine = &pupil.engine;
    let mut blocks = Vec::new();
    for order in orders {
        let mut empty = Table::new(["Cylinder", "Direct phase", "Reverse phase"]);
        let row = |name: Text| vec![name, Text::default(), Text::default()];
        engine.cylinders().iter().for_each(|cylinder| empty.push(row(cylinder.name.clone().into())));
        for (name, quantity) in [("**Σ force**", Planar::Force), ("**Σ moment**", Planar::Moment)] {
            empty.push(row(phrase!("{}, {}", name, unit_of(engine, quantity))));
        }
        blocks.extend([Block::Heading(2, phrase!("Order {}", *order)), empty.into()]);
    }
    blocks
}
