//! What is said, and drawn, of each question? A short answer and a page, both of blocks, and a JSON document.
//!
//! `verdicts → words, tables, pictures → page::Document`, which [`crate::page`] writes in every format.

mod accuracy;
mod angle;
mod argument;
mod asked;
mod atlas;
mod bearings;
mod calculation;
mod catalogue;
mod claims;
mod classroom;
mod compare;
mod convention;
mod coq;
pub mod data;
mod dead_centres;
mod document;
mod engine_cells;
mod engine_page;
mod example;
mod family_page;
mod figures;
mod firing;
mod firmness;
mod flywheel;
mod in_order;
mod journal;
mod loads_document;
mod mechanism_words;
mod moments;
mod mounts;
pub mod moving;
mod multiples;
#[cfg(feature = "optimise")]
mod optimise;
mod poster;
mod question;
mod recurrence_claims;
mod recurrence_words;
mod remaining;
mod remedy;
mod residual;
mod residual_words;
mod roll_asked;
mod rotor;
mod schema;
mod search;
mod star;
mod stars;
mod sweep;
mod table;
mod texts;
mod theorem;
mod theorem_words;
mod torque;
mod torsion;
mod value;
mod values;
mod views;

pub use views::{end_view, side_view};

use crate::page::{figure, number as typeset, plot};

pub use crate::page::File;
pub use accuracy::{AccuracyCase, AccuracyStudy, Further, FurtherLoad, accuracy_section};
pub use angle::{AngleStudy, AnglesAsked, NoAngles};
pub use argument::{argument as verdict_argument, certificate as verdict_certificate};
pub use asked::{ask, questions};
pub use atlas::{ATLAS_CYLINDERS, Atlas};
pub use bearings::{BearingsStudy, bearings_answer, bearings_page};
pub use calculation::{LoadsStudy, Numbers, loads_answer, loads_page};
pub use catalogue::{
    CatalogueDocument, CatalogueFamily, FirstOrderLeft, KnownEngine, catalogue_answer, catalogue_document,
    catalogue_families, catalogue_pictures, catalogue_summary,
};
pub use claims::{
    claim_evidence, claim_finding, claim_finding_on, claim_needs, claim_status, claims_answer, claims_page,
    table_finding,
};
pub use classroom::{exercise_sheet, exercise_solutions, marked_page, marks_answer, marks_page};
pub use compare::{
    CompareDocument, CompareStudy, Compared, compare_answer, compare_document, compare_page, numbers_of,
};
pub use coq::{NotStated, coq_file, coq_file_of_firing};
pub use document::document;
pub use engine_cells::firing as firing_cell;
pub use engine_page::{
    Contents, Weighing, engine_answer, engine_answer_weighed, engine_at_a_glance, engine_page, engine_proofs,
    engine_summary, worth_curing,
};
pub use example::worked as worked_example;
pub use family_page::{
    amplitudes, amplitudes_caption, exact_angles, family_answer, family_page, family_proofs, family_summary,
    open_document,
};
pub use figures::{NamedPicture, figures, sweep_figures};
pub use firing::{
    FiringStudy, OpenFiringStudy, firing_answer, firing_catalogue_answer, firing_catalogue_page, firing_document,
    firing_engine, firing_page, open_firing_answer, open_firing_page, run_as as run_in_cycle,
};
pub use flywheel::FlywheelStudy;
pub use in_order::rising;
pub use journal::{complete_bearings_answer, complete_bearings_page, without_gas};
pub use loads_document::{LoadsDocument, loads_document};
pub use moments::{Amplitude, External, MomentsRow, MomentsStudy, NoMoments};
pub use mounts::{AtSpeed, MountsAsked, MountsStudy, NoMounts, OrderMotion, Place};
pub use multiples::{Column, multiples};
#[cfg(feature = "optimise")]
pub use optimise::{OptimiseStudy, optimise_answer, optimise_layouts, optimise_page};
pub use poster::{poster, poster_sheet};
pub use question::{Question, Unanswered};
pub use remedy::{remedy_answer, remedy_cures, remedy_document, remedy_engine, remedy_page, remedy_section};
pub use residual::{
    class_sources, force as force_left, largest as largest_length, modulus as star_length, moment as moment_left,
    order_name, roll as roll_left, shape_name, torque as torque_left, torque_part as torque_part_left,
    whole as force_and_moment_left,
};
pub use rotor::RotorStudy;
pub use schema::{schema, schema_names};
pub use search::{SearchStudy, search_answer, search_layouts, search_page, search_theorems, search_torsion};
pub use star::{small_star, small_stars, star_figure, told, torque_figure};
pub use stars::{
    StarAtlas, StarredEngine, StarsStudy, star_atlas_answer, star_atlas_page, stars_answer, stars_layouts, stars_page,
};
pub use sweep::{sweep_answer, sweep_csv, sweep_page};
pub use torque::TorqueStudy;
pub use torsion::{
    Barred, DamperStudy, Excess, ForcedTwist, FoundDamper, HeatPlace, LargestTorque, NoTorsion, ResonanceOrder,
    TorsionStudy, TwistAtSpeed, Vibration, VibrationOrder,
};
pub use value::{ValueName, Valued, observer, values_of};
pub use values::ValuesStudy;
