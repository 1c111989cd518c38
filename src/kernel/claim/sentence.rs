//! Which claim does a sentence make, by the grammar or in everyday words?

use super::error::ClaimError;
use super::everyday;
use super::grammar::strict;
use super::statement::Statement;

/// Reads a claim.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// use crankstar::claim::{parse_statement, Statement};
/// assert!(parse_statement("second-order force vanishes").is_ok());
/// assert_eq!(parse_statement("fires evenly"), Ok(Statement::FiresEvenly { evenly: true }));
/// ```
///
/// # Errors
/// The first word that fits nowhere, with what would fit; or what a sentence that may mean two things has to say.
pub fn parse_statement(text: &str) -> Result<Statement, ClaimError> {
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let words = words.trim_end_matches('.');
    // "The half order" is a name, "the second-order moment" that moment.
    let bare = words.strip_prefix("the ").or_else(|| words.strip_prefix("The ")).unwrap_or(words);
    let claim = strict(words).or_else(|error| if bare == words { Err(error) } else { strict(bare) });
    claim.or_else(|error| everyday::parse(words).unwrap_or(Err(error)))
}
