//! All tests that need a Rust toolchain and nothing else, as one program: one link instead of forty.

#![allow(clippy::disallowed_types)]

mod accuracy;
mod arguments;
mod atlas;
mod beam;
mod bearings;
mod certificate_cheats;
mod certificate_words;
mod citation;
mod claims;
mod claims_files;
mod claims_of_numbers;
mod classes;
mod closed_forms;
mod command_line;
mod compare;
mod crankshaft;
mod decision_laws;
mod document_limits;
mod document_mutations;
mod documents_verify;
mod examples;
mod families;
mod figure_command;
mod figures;
mod firmness;
mod formulas;
mod fragments;
mod fuzzed;
mod gas;
mod gas_files;
mod grigoryev;
mod ground_truth;
mod hard_cases;
mod help;
mod hostile_text;
mod languages;
mod largest;
mod layout_files;
mod layout_mistakes;
mod layout_random;
mod loads;
mod mechanism_files;
mod motion;
mod moving;
mod odd_surroundings;
mod open_certificate_cheats;
#[cfg(feature = "optimise")]
mod optimise;
mod output_folder;
mod plots;
mod printed_lines;
mod random_engines;
mod remedy;
mod remedy_cheats;
mod reports;
mod rooms;
mod search;
mod sweep;
mod symbols;
mod theorems;
mod theory;
mod thesis;
mod torque;
mod views;
mod whole_cheats;

mod support {
    pub mod decimals;
    pub mod dice;
    pub mod engines;
    pub mod every_form;
    pub mod every_verdict;
    pub mod hard;
    pub mod imports;
    pub mod oracle;
    pub mod pages;
    pub mod piston;
    pub mod plain_search;
    pub mod program;
    pub mod stiffness;
    pub mod verdicts;
    pub mod whole_degrees;
    pub mod whole_documents;
    pub mod written;
}
