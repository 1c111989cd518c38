//! What is a student given, and what is to be found? The engine in pictures and numbers, and the tables to fill in.

use super::super::convention::seen;
use super::super::mechanism_words::centres;
use super::super::residual;
use super::super::table;
use super::super::views::{end_view, end_view_caption, side_view, side_view_caption};
use super::unit_of;
use crate::classroom::{Pupil, Scheme};
use crate::page::{Block, Document, Picture, Table, Text, phrase};
use crate::proof::Planar;

/// The sheet of a student, to be marked by this scheme; `table` is the name of the file with the table to fill in.
pub fn exercise_sheet(pupil: &Pupil, orders: &[u32], table: &str, scheme: &Scheme) -> Document {
    let mut page = Document::new("sheet", phrase!("Vector-star exercise: {}", &pupil.name));
    page.blocks.extend(given(pupil));
    page.blocks.extend(to_find(pupil, orders));
    page.section(
        "How to hand it in",
        phrase!("Write your results into the file {}, and hand that file in.", Text::code(table)),
    );
    let digits = phrase!(
        "A rounded length needs at least {} significant digits, and a rounded angle a digit behind the point: with fewer an entry does not earn all its points.",
        scheme.digits
    );
    let [angle, length, rounded, check, convention] = HINTS.map(Text::from);
    page.push(Block::List(vec![angle, length, rounded, digits, check, convention]));
    page
}

/// The engine.
pub(super) fn given(pupil: &Pupil) -> Vec<Block> {
    let engine = &pupil.engine;
    let end = Picture::new("end-view", end_view_caption(engine), end_view(engine));
    let side = Picture::new("side-view", side_view_caption(engine), side_view(engine));
    let vectors: Text = match engine.has_unit_masses() {
        true => "All pistons weigh the same: each vector has the length 1, counted in m r.".into(),
        false => "The reciprocating mass of a cylinder is the length of its vectors, counted in m r.".into(),
    };
    let plane = phrase!("Moments are taken about the plane z = {}.", table::place(engine, engine.reference_plane()));
    vec![
        Block::Heading(1, "Given".into()),
        Block::Paragraph(phrase!("An engine with {} cylinders.", engine.cylinders().len())),
        Block::Pictures(vec![end, side]),
        table::cylinders(engine).into(),
        Block::List(vec![seen(engine.convention()), centres(engine), vectors, plane]),
    ]
}

const PHASES: &str =
    "\\varphi_{j}^{+} = k\\beta_j - (k-1)\\alpha_j, \\qquad \\varphi_{j}^{-} = -k\\beta_j + (k+1)\\alpha_j";
const SUMS: &str = "P_k^{\\pm} = \\sum_j m_j\\, e^{i\\varphi_{j}^{\\pm}}, \\qquad C_k^{\\pm} = \\sum_j m_j\\, z_j\\, e^{i\\varphi_{j}^{\\pm}}";

fn to_find(pupil: &Pupil, orders: &[u32]) -> Vec<Block> {
    let engine = &pupil.engine;
    let mut blocks = vec![
        Block::Heading(1, "To find".into()),
        Block::Paragraph(phrase!(
            "The vector stars of the pistons at {}. For each order, the phases of the direct and of the reverse vector of every \
             cylinder at θ = 0, and the lengths of their sums: of the force, and of the moment, in which each vector is multiplied by its arm z from the plane above.",
            residual::orders_in_words(orders)
        )),
        Block::Formula(PHASES.to_owned(), Some(1)),
        Block::Formula(SUMS.to_owned(), Some(2)),
    ];
    for order in orders {
        let mut empty = Table::new(["Cylinder", "Direct phase", "Reverse phase"]);
        let row = |name: Text| vec![name, Text::default(), Text::default()];
        engine.cylinders().iter().for_each(|cylinder| empty.push(row(cylinder.name.clone().into())));
        for (name, quantity) in [("**Σ force**", Planar::Force), ("**Σ moment**", Planar::Moment)] {
            empty.push(row(phrase!("{}, {}", name, unit_of(engine, quantity))));
        }
        blocks.extend([Block::Heading(2, phrase!("Order {}", *order)), empty.into()]);
    }
    blocks.push(Block::Paragraph(
        "Which sums vanish, and why? What does each order that remains feel like to the engine mounts?".into(),
    ));
    blocks
}

const HINTS: [&str; 5] = [
    "An angle is in degrees and counts modulo 360°: 240, −120, 51.43, or 1/7 turn.",
    "A length is a number of 0 or more: 4, 3.16, sqrt(10), 2 sin 36°. What vanishes is 0.",
    "Decimals are right where they equal the true value, rounded: for √10 both 3.2 and 3.162 are right, 3.15 is not. A number without a point is taken as exact.",
    "Check a star before you add it up: the two vectors of a cylinder are equally long and turn in opposite senses.",
    "If you draw angles clockwise, count the throws the other way, exchange direct and reverse, or take moments about another plane, say so in the lines of the table that ask for your convention; then your table is marked in your convention.",
];
