//! What is known of engines that were built, what is found of them, and do the two agree?

mod page;

pub use page::engines_page;

use super::claims::needs;
use super::family_page::exact_angles;
use super::remedy::remedy_cures;
use super::residual;
use crate::claim::{Answer, Claim, Claims, Published};
use crate::engine::{Engine, Firing};
use crate::family::OpenOrder;
use crate::page::{Text, phrase};
use crate::remedy::{self, Wish};
use crate::verdict::Judgement;

/// The orders that balancer shafts are built for.
const CURED: [u32; 2] = [1, 2];

/// An engine that was built, with what is known of it.
#[derive(Clone, Debug)]
pub struct BuiltEngine {
    /// The name of its folder.
    pub name: String,
    /// The engine, as its layout file describes it.
    pub engine: Engine,
    /// The family that it is a member of, judged, where its file gives values to unknowns.
    pub family: Vec<OpenOrder>,
    /// What is known of it: sentences with their sources, and what has to be answered true for each.
    pub facts: Claims,
}

/// A statement of the facts with the answer to it.
struct Checked<'a> {
    claim: &'a Claim,
    answer: Answer,
}

impl BuiltEngine {
    /// The statements of a fact, answered.
    fn checked<'a>(fact: &'a Published) -> impl Iterator<Item = Checked<'a>> {
        fact.claims.iter().map(|claim| Checked { claim, answer: claim.answer() })
    }

    /// How many statements there are, and how many of them are answered true.
    pub fn agreement(&self) -> [usize; 2] {
        let claims = self.facts.statements.iter().flat_map(Self::checked);
        let held: Vec<bool> = claims.map(|checked| checked.answer.status.holds()).collect();
        [held.len(), held.iter().filter(|holds| **holds).count()]
    }

    /// Whether what is known and what is found agree: every statement is answered true.
    pub fn agrees(&self) -> bool {
        let [all, hold] = self.agreement();
        all == hold
    }

    /// What is known, a sentence each with its source.
    fn known(&self) -> Text {
        let one = |fact: &Published| match (&fact.text, &fact.source) {
            (Some(text), Some(source)) => phrase!("{} [{}]", text, source),
            (Some(text), None) => text.into(),
            (None, _) => Text::default(),
        };
        Text::joined(self.facts.statements.iter().map(one), " ")
    }

    /// What is found: what is left of each order that shafts are built for, what takes it away, and how the engine fires.
    fn found(&self, judged: &Judgement) -> Text {
        let orders = judged.orders.iter().filter(|order| order.exists()).map(|order| {
            let [force, moment] = residual::whole(order);
            phrase!("Order {}: force {}; moment: {}.", order.order, force, moment)
        });
        let firing = self.engine.firing().map(|firing| match firing.is_even() {
            true => Text::from("It fires evenly."),
            false => "It fires unevenly.".into(),
        });
        let needs = CURED.iter().flat_map(|order| self.needs(*order));
        let sentences = orders.chain(needs).chain(exact_angles(&self.family)).chain(firing);
        Text::joined(sentences, " ")
    }

    /// What an order needs; nothing where that is not decided. Where rods differ it says the sizes, which no exact number tells.
    fn needs(&self, order: u32) -> Vec<Text> {
        let wish = Wish { orders: vec![order], ..Wish::default() };
        let Ok(remedy) = remedy::remedy(&self.engine, &wish) else { return Vec::new() };
        let told = usize::from(remedy.crankshaft.is_some()) + usize::from(!remedy.shafts.is_empty());
        match self.engine.mechanisms().len() > 1 && told > 0 {
            true => remedy_cures(&remedy).into_iter().take(told).collect(),
            false => vec![needs(&remedy)],
        }
    }
}

/// How an engine fires, in a word.
fn firing(firing: Option<&Firing>) -> Text {
    match firing {
        Some(firing) if firing.is_even() => "even".into(),
        Some(_) => "uneven".into(),
        None => "not given".into(),
    }
}
