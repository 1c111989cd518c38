//! Which part of the engine does a sum speak of? All of it, or what is multiplied by one number of the motion, where rods differ.

use super::evidence::list;
use super::not_stated::has_pistons;
use crate::proof::{Document, VerdictClaim};

/// The parts that sums speak of, in the order in which they first do.
pub(super) struct Parts<'a> {
    of: Vec<&'a [String]>,
    /// How many cylinders and turning masses all of the engine has.
    all: usize,
}

impl<'a> Parts<'a> {
    pub fn of(document: &'a Document) -> Self {
        let pistons = document.cylinders.iter().filter(|_| has_pistons(document)).count();
        let mut parts = Parts { of: Vec::new(), all: pistons + document.turning_masses.len() };
        let verdicts = document.verdicts.iter().map(|verdict| verdict.of.as_slice());
        let classes = document.recurrences.iter().flat_map(|claim| claim.even.iter().chain(&claim.odd));
        for of in verdicts.chain(classes.map(|class| class.of.as_slice())) {
            if !parts.is_all(of) && !parts.of.contains(&of) {
                parts.of.push(of);
            }
        }
        parts
    }

    fn is_all(&self, of: &[String]) -> bool {
        of.is_empty() || of.len() == self.all
    }

    /// What the part is called in the file.
    pub fn engine(&self, of: &[String]) -> String {
        if self.is_all(of) { "the_engine".to_owned() } else { format!("part_{}", self.number(of)) }
    }

    /// What a theorem on a verdict ends with, so that each has a name of its own.
    pub fn order(&self, verdict: &VerdictClaim) -> String {
        match self.is_all(&verdict.of) {
            true => format!("order_{}", verdict.order),
            false => format!("order_{}_{}", verdict.order, self.engine(&verdict.of)),
        }
    }

    fn number(&self, of: &[String]) -> usize {
        1 + self.of.iter().position(|part| *part == of).unwrap_or_else(|| unreachable!("every part is collected"))
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
        let definitions: String = self.of.iter().map(part).collect();
        match definitions.as_str() {
            "" => definitions,
            _ => format!(
                "\n(* What is multiplied by one number of the motion: which cylinders, which turning masses. *)\n{definitions}"
            ),
        }
    }
}
