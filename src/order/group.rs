//! Which terms of an order stand before one number?

use super::contribution::Sources;
use super::factor::Factor;
use super::source::Source;
use crate::exact::{PhasorSum, Term};
use crate::proof::{Quantity, Sense};

/// The sources of an order whose terms stand before one number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// The number.
    pub factor: Factor,
    /// Whether it is not zero; else the terms add nothing, whatever their sum is.
    pub exists: bool,
    /// The sources: cylinders first, then the others that have the order, in either sense.
    pub sources: Vec<Source>,
}

impl Sources<'_> {
    /// The groups of an order, in the order of their first source; one without sources where nothing has the order.
    pub fn groups(&self, quantity: Quantity, order: u32) -> Vec<Group> {
        let senses: &[Option<Sense>] = match quantity {
            Quantity::Force | Quantity::Moment => &[Some(Sense::Direct), Some(Sense::Reverse)],
            Quantity::Torque => &[None],
        };
        let mut groups: Vec<Group> = Vec::new();
        for (source, factor, _) in senses.iter().flat_map(|sense| self.terms(quantity, order, *sense)) {
            match groups.iter_mut().find(|group| group.factor == factor) {
                Some(group) if group.sources.contains(&source) => {}
                Some(group) => group.sources.push(source),
                None => {
                    let exists = factor.exists(quantity, order);
                    groups.push(Group { factor, exists, sources: vec![source] });
                }
            }
        }
        if groups.is_empty() {
            groups.push(Group { factor: Factor::One, exists: false, sources: Vec::new() });
        }
        groups
    }

    /// The sum of a group, one term per source, and whose terms they are.
    pub fn sum(&self, group: &Group, quantity: Quantity, order: u32, sense: Option<Sense>) -> (Vec<Source>, PhasorSum) {
        let terms = self.terms(quantity, order, sense).into_iter().filter(|(_, factor, _)| *factor == group.factor);
        let (sources, terms): (Vec<Source>, Vec<Term>) = terms.map(|(source, _, term)| (source, term)).unzip();
        (sources, PhasorSum::new(terms))
    }
}
