//! What is handed in, whose is it, and what is filled in there?

use super::convention::Convention;
use crate::claim::Filled;

/// Whose table it is, as it says.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Owner {
    pub sheet: Option<String>,
    pub student: Option<String>,
}

/// A table that was handed in, not read yet beyond whose it is.
pub(super) enum Submission {
    Toml(String),
    Rows(Vec<Record>),
}

/// What is filled in: the convention, and the tables by their orders.
pub(super) struct Answers {
    pub convention: Convention,
    pub tables: Vec<(u32, Filled)>,
    /// What is wrong with rows that belong nowhere, each with its line.
    pub not_read: Vec<String>,
}

/// What is wrong with an order that is not one of these, and what would be right.
pub(super) fn not_asked_for(order: u32, orders: &[u32]) -> Option<(String, String)> {
    let asked: Vec<String> = orders.iter().map(u32::to_string).collect();
    let told = || (format!("order {order} is not asked for"), format!("the orders are {}", asked.join(", ")));
    (!orders.contains(&order)).then(told)
}

/// A row that somebody filled in.
pub(super) struct Record {
    pub row_number: usize,
    pub order: String,
    pub row: String,
    pub values: [String; 2],
    /// Whether something is filled in, and there are more cells than columns: nobody knows what belongs where.
    pub is_too_long: bool,
}
