//! Which part of the engine does a sum speak of? All of it, or what stands before one number of the motion, where rods differ.

use super::evidence::list;
use super::not_stated::has_pistons;
use crate::proof::{Document, VerdictClaim};

/// The parts that verdicts speak of, in the order in which they first do.
pub(super) struct Parts<'a>(Vec<&'a [String]>);

impl<'a> Parts<'a> {
    pub fn of(document: &'a Document) -> Self {
        let mut parts: Vec<&[String]> = Vec::new();
        for verdict in document.verdicts.iter().filter(|verdict| !verdict.of.is_empty()) {
            if !parts.contains(&verdict.of.as_slice()) {
                parts.push(&verdict.of);
            }
        }
        Parts(parts)
    }

    /// What the part is called in the file.
    pub fn engine(&self, of: &[String]) -> String {
        if of.is_empty() { "the_engine".to_owned() } else { format!("part_{}", self.number(of)) }
    }

    /// What a theorem on a verdict ends with, so that each has a name of its own.
    pub fn order(&self, verdict: &VerdictClaim) -> String {
        match verdict.of.as_slice() {
            [] => format!("order_{}", verdict.order),
            of => format!("order_{}_{}", verdict.order, self.engine(of)),
        }
    }

    fn number(&self, of: &[String]) -> usize {
        1 + self.0.iter().position(|part| *part == of).unwrap_or_else(|| unreachable!("every part is collected"))
    }

    /// Each part, by which cylinders and which masses that turn are in it.
    pub fn definitions(&self, document: &Document) -> String {
        let cylinders = document.cylinders.iter().filter(|_| has_pistons(document)).map(|cylinder| &cylinder.name);
        let (cylinders, turning): (Vec<&String>, Vec<&String>) =
            (cylinders.collect(), document.turning_masses.iter().map(|mass| &mass.name).collect());
        let mask =
            |names: &[&String], of: &[String]| list(names.iter().map(|name| of.contains(name).to_string()).collect());
        let part = |of: &&[String]| {
            let (cylinders, turning) = (mask(&cylinders, of), mask(&turning, of));
            format!("Definition {} : engine := part_of the_engine {cylinders} {turning}.\n", self.engine(of))
        };
        let definitions: String = self.0.iter().map(part).collect();
        match definitions.as_str() {
            "" => definitions,
            _ => format!(
                "\n(* What stands before one number of the motion: which cylinders, which turning masses. *)\n{definitions}"
            ),
        }
    }
}
