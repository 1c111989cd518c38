//! What do the main bearings feel, as a person reads it? Tables, plots, a page.

mod amounts;
mod columns;
mod data;
mod gas_data;
mod links;
mod page;
mod plots;
mod question;
mod study;
mod tables;

pub(super) use amounts::orders_of;
pub(super) use columns::crankshafts;
pub(super) use page::{
    beam_assumptions, by_orders, called, first_lines, left_out, left_out_in_short, parts_of_a_load, peaks_in_words,
    worst,
};
pub use page::{bearings_answer, bearings_page};
pub(super) use plots::{drawings, farthest, largest_at, over_crank_angle, path, style, tip};
pub use study::BearingsStudy;
pub(super) use tables::{orders, peaks};
