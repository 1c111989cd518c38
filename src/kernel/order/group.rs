//! Which terms of an order are multiplied by one number?

use super::contribution::{Contribution, Sources};
use super::factor::Factor;
use super::source::Source;
use crate::engine::Engine;
use crate::exact::{PhasorSum, Term};
use crate::proof::{Quantity, Sense};

/// The sources of an order whose terms are multiplied by one number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// The number.
    pub factor: Factor,
    /// Whether it is not zero; else the terms add nothing, whatever their sum is.
    pub exists: bool,
    /// The sources: cylinders first, then the others that have the order, in either sense.
    pub sources: Vec<Source>,
}

/// All terms of one order, of the force and the moment, of the torque or of the roll moment.
#[derive(Clone, Debug)]
pub struct OrderTerms<'a> {
    engine: &'a Engine,
    /// The order k.
    pub order: u32,
    by_sense: Vec<(Option<Sense>, Vec<Contribution>)>,
    groups: Vec<Group>,
}

impl<'a> Sources<'a> {
    /// The terms of an order of the force and the moment.
    pub fn force_terms(&self, order: u32) -> OrderTerms<'a> {
        let of = |sense| (Some(sense), self.of_force(order, sense).collect());
        OrderTerms::new(self.engine(), order, vec![of(Sense::Direct), of(Sense::Reverse)])
    }

    /// The terms of an order of the inertia torque.
    pub fn torque_terms(&self, order: u32) -> OrderTerms<'a> {
        OrderTerms::new(self.engine(), order, vec![(None, self.of_torque(order).collect())])
    }

    /// The terms of an order of the roll moment.
    pub fn roll_terms(&self, order: u32) -> OrderTerms<'a> {
        OrderTerms::new(self.engine(), order, vec![(None, self.of_roll(order))])
    }
}

impl<'a> OrderTerms<'a> {
    fn new(engine: &'a Engine, order: u32, by_sense: Vec<(Option<Sense>, Vec<Contribution>)>) -> Self {
        let mut groups: Vec<Group> = Vec::new();
        for Contribution { source, factor, .. } in by_sense.iter().flat_map(|(_, all)| all) {
            match groups.iter_mut().find(|group| group.factor == *factor) {
                Some(group) if group.sources.contains(source) => {}
                Some(group) => group.sources.push(*source),
                None => {
                    let exists = factor.exists(order);
                    groups.push(Group { factor: factor.clone(), exists, sources: vec![*source] });
                }
            }
        }
        if groups.is_empty() {
            groups.push(Group { factor: Factor::One, exists: false, sources: Vec::new() });
        }
        OrderTerms { engine, order, by_sense, groups }
    }

    /// The groups, in the order of their first source; one without sources where nothing has the order.
    pub fn groups(&self) -> &[Group] {
        &self.groups
    }

    /// The sum of a group, one term per source, and whose terms they are.
    pub fn sum(&self, group: &Group, quantity: Quantity, sense: Option<Sense>) -> (Vec<Source>, PhasorSum) {
        let of_sense = self.by_sense.iter().filter(|(own, _)| *own == sense).flat_map(|(_, all)| all);
        let of_group = of_sense.filter(|one| one.factor == group.factor);
        let terms = of_group.map(|one| (one.source, one.term_of(self.engine, quantity)));
        let (sources, terms): (Vec<Source>, Vec<Term>) = terms.unzip();
        (sources, PhasorSum::new(terms))
    }
}
