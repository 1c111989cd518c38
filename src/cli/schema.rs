//! `schema`: which keys has a layout file, which a document? As JSON Schemas, for editors.

use clap::builder::PossibleValuesParser;

use crankstar::report;

use super::failure::Failure;
use super::write::print_json;

/// Arguments of `schema`.
#[derive(clap::Args)]
pub struct Schema {
    /// Of layout files, or of the documents that --json prints
    #[arg(value_name = "WHAT", value_parser = PossibleValuesParser::new(report::schema_names()))]
    what: String,
}

impl Schema {
    /// Prints the schema.
    pub fn run(&self) -> Result<(), Failure> {
        match report::schema(&self.what) {
            Some(schema) => print_json(&schema),
            None => unreachable!("it was one of the names"),
        }
    }
}
