//! What is known of engines that were built, what is found of them, and do the two agree? The page `reports/engines/README.md`.

use crankstar::claim::{Answer, Claim, Claims, Published};
use crankstar::engine::{Engine, Firing};
use crankstar::family::OpenOrder;
use crankstar::page::{Block, Document, Fold, Table, Text};
use crankstar::proof::Quantity;
use crankstar::remedy::{self, Request};
use crankstar::report::{claim_finding, claim_needs, claim_status, exact_angles, force_and_moment_left, remedy_cures};
use crankstar::verdict::Judgement;

use super::phrase;

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
            let [force, moment] = force_and_moment_left(order);
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
        let request = Request { orders: vec![order], ..Request::default() };
        let Ok(remedy) = remedy::remedy(&self.engine, &request) else { return Vec::new() };
        let told = usize::from(remedy.crankshaft.is_some()) + usize::from(!remedy.shafts.is_empty());
        match self.engine.mechanisms().len() > 1 && told > 0 {
            true => remedy_cures(&remedy).into_iter().take(told).collect(),
            false => vec![claim_needs(&remedy)],
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

/// The page over the reports.
pub fn engines_page(engines: &[BuiltEngine]) -> Document {
    let mut page = Document::new("README", "Engines of the world");
    page.push(Block::Answer(counts(engines)));
    page.push(Block::Heading(1, "All of them".into()));
    page.push(overview(engines));
    page.push(Block::Heading(1, "What is known, and what is found".into()));
    for engine in engines {
        page.blocks.extend(section(engine));
    }
    page.push(Block::Heading(1, "How to read it".into()));
    page.push(Block::List(READ.map(Text::from).into()));
    page
}

const READ: [&str; 4] = [
    "What is known is in facts.toml beside each layout file, each sentence with its source in brackets; what was not found in a source says so there.",
    "What is found is what `classify` and `remedy` say of the layout file: 0 is proved; any other number is the largest value through a revolution, forces in $m r \\omega^2 c_k$, moments in that times the spacing of the cylinders.",
    "They agree where every statement that follows from what is known is answered true. A shaft that the engine has is needed; a shaft that is needed and that the engine does not have is omitted by its makers, who live with what it would cancel.",
    "A builder balances as much as is felt, so that one order may be answered and another left; needs are stated for each order separately.",
];

/// How many agree.
fn counts(engines: &[BuiltEngine]) -> Vec<Text> {
    let agree = engines.iter().filter(|engine| engine.agrees()).count();
    let [all, hold] = engines.iter().map(BuiltEngine::agreement).fold([0, 0], |[a, b], [c, d]| [a + c, b + d]);
    vec![
        phrase!(
            "{} engines that were built, a report each; what is known of {} and what is found agree.",
            engines.len(),
            agree
        ),
        phrase!("Of {} statements that follow from what is known, {} are answered true.", all, hold),
    ]
}

/// The verdicts on the orders that shafts are built for.
fn judged(engine: &BuiltEngine) -> Option<Judgement> {
    Judgement::new(&engine.engine, &CURED, &Quantity::PLANAR).ok()
}

/// A row per engine.
fn overview(engines: &[BuiltEngine]) -> Table {
    let mut table = Table::new([
        "Engine",
        "Firing",
        "Force, order 1",
        "Moment, order 1",
        "Force, order 2",
        "Moment, order 2",
        "Agree",
    ]);
    for engine in engines {
        let mut row = vec![link(engine), firing(engine.engine.firing())];
        for order in judged(engine).iter().flat_map(|judged| &judged.orders) {
            row.extend(force_and_moment_left(order));
        }
        row.push(if engine.agrees() { "yes".into() } else { "**no**".into() });
        table.push(row);
    }
    table
}

fn link(engine: &BuiltEngine) -> Text {
    Text::link(Text::from(engine.engine.title()), format!("{}/report.md", engine.name))
}

/// The three lines of an engine, and the statements with their answers.
fn section(engine: &BuiltEngine) -> Vec<Block> {
    let [all, hold] = engine.agreement();
    let agree = match engine.agrees() {
        true => phrase!("**Agree.** Yes: all {} statements are answered true.", all),
        false => phrase!("**Agree.** No: {} of {} statements are answered true. {}", hold, all, why(engine)),
    };
    let found = judged(engine).map_or_else(Text::default, |judged| engine.found(&judged));
    vec![
        Block::Heading(2, link(engine)),
        Block::List(vec![phrase!("**Known.** {}", engine.known()), phrase!("**Found.** {}", found), agree]),
        Block::Folded(Fold { summary: "Statements and answers".into(), blocks: vec![answers(engine).into()] }),
    ]
}

/// What is the case where a statement is answered otherwise, with what the author of the facts says of it.
fn why(engine: &BuiltEngine) -> Text {
    let of_fact = |fact: &Published| -> Vec<Text> {
        let wrong = BuiltEngine::checked(fact).filter(|checked| !checked.answer.status.holds());
        let wrong: Vec<Text> = wrong
            .map(|Checked { claim, answer }| phrase!("“{}”: {}", &claim.says, claim_finding(&claim.statement, &answer)))
            .collect();
        let conclusion = fact.conclusion.as_ref().filter(|_| !wrong.is_empty());
        wrong.into_iter().chain(conclusion.map(Text::from)).collect()
    };
    Text::joined(engine.facts.statements.iter().flat_map(of_fact), " ")
}

/// Each statement with its answer.
fn answers(engine: &BuiltEngine) -> Table {
    let mut table = Table::new(["Statement", "Answer", "Finding"]);
    for Checked { claim, answer } in engine.facts.statements.iter().flat_map(BuiltEngine::checked) {
        let finding = claim_finding(&claim.statement, &answer);
        table.push(vec![(&claim.says).into(), phrase!("**{}**", claim_status(&answer)), finding]);
    }
    table
}
