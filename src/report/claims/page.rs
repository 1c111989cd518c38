//! What is on a page of claims, and on the terminal? Each statement with its claims, who says them and where, the
//! answers, and what they rest on; the file's own cross-checks stand apart and are not counted as claims.

use super::evidence::evidence;
use super::finding::{claim_finding_on, claim_status};
use super::student;
use crate::claim::{Answer, Claim, Claims, Finding, Provenance, Published, Quote, Statement, Status, Topic};
use crate::engine::{Engine, LengthUnit};
use crate::page::{Block, Document, Table, Text, phrase};
use crate::proof::Quantity;
use crate::report::texts::claims as text;
use crate::text::Untrusted;

/// A claim with its answer.
type Answered<'a> = (&'a Claim, Answer);

/// The short answer: each claim with its answer.
pub fn claims_answer(claims: &Claims) -> Document {
    let mut page = Document::new("claims", &claims.title);
    page.push(Block::Answer(counts(claims)));
    let mut answered: Vec<Answered> = answered(all(claims));
    answered.sort_by_key(|(_, answer)| rank(&answer.status));
    if !answered.is_empty() {
        page.push(narrow(&answered));
    }
    page.blocks.extend(tables(claims).map(Block::Table));
    page.blocks.extend(of_moments(claims));
    page
}

/// The page that answers a claims file.
pub fn claims_page(claims: &Claims) -> Document {
    text::Page {
        title: (&claims.title).into(),
        answer: Block::Answer(counts(claims)).into(),
        exceptions: exceptions(claims).into(),
        about_formulas: of_forces(claims).into(),
        about_moments: of_moments(claims).into(),
        statements: claims.statements.iter().flat_map(statement).collect(),
        star_tables: tables(claims).into(),
    }
    .document()
}

/// The claims of all statements.
fn all(claims: &Claims) -> impl Iterator<Item = &Claim> {
    claims.statements.iter().flat_map(|statement| &statement.claims)
}

/// What does not hold stands first, then what is not decided.
fn rank(status: &Status) -> u8 {
    match status {
        Status::NotDecided => 1,
        other if other.holds() => 2,
        _ => 0,
    }
}

/// The claims that do not hold, and those that are not decided: before the statements, which are in the order of their file.
fn exceptions(claims: &Claims) -> Vec<Block> {
    let answered = answered(all(claims));
    let of = |(wanted, heading): (u8, &'static str)| {
        let those: Vec<&Answered> = answered.iter().filter(|(_, answer)| rank(&answer.status) == wanted).collect();
        (!those.is_empty()).then(|| [Block::Heading(1, heading.into()), table(those).into()])
    };
    [(0, "What does not hold"), (1, "What is not decided")].into_iter().filter_map(of).flatten().collect()
}

/// How claims about forces of gas and masses are answered, where there are some.
fn of_forces(claims: &Claims) -> Option<Text> {
    let is_of_forces = |statement: &Statement| statement.topic() == Topic::Forces;
    all(claims).any(|claim| is_of_forces(&claim.statement)).then(text::formulas)
}

/// What moments are counted in, where some answer tells one of an engine with positions in metres.
fn of_moments(claims: &Claims) -> Option<Block> {
    let in_metres = |engine: &Engine| engine.length_unit() == LengthUnit::Metre;
    let is_moment = |statement: &Statement| matches!(statement, Statement::Order { subject, .. } if subject.quantity == Quantity::MOMENT);
    let is_told = all(claims).any(|claim| in_metres(&claim.layout) && is_moment(&claim.statement))
        || claims.tables.iter().any(|table| in_metres(&table.layout));
    is_told.then(|| Block::Note(text::in_metres()))
}

fn answered<'a>(claims: impl Iterator<Item = &'a Claim>) -> Vec<Answered<'a>> {
    claims.map(|claim| (claim, claim.answer())).collect()
}

/// How many claims hold, those of sources, of nobody and of the file apart.
fn counts(claims: &Claims) -> Vec<Text> {
    let [mut quoted, mut folklore, mut own] = [[0_usize; 2]; 3];
    for claim in all(claims) {
        let [all, hold] = match claim.provenance {
            Provenance::Quoted(_) => &mut quoted,
            Provenance::Folklore => &mut folklore,
            Provenance::Own => &mut own,
        };
        *all += 1;
        *hold += usize::from(claim.answer().status.holds());
    }
    let tables = claims.judged_tables();
    let tables = [tables.len(), tables.iter().filter(|verdict| verdict.holds()).count()];
    let told = |[all, hold]: [usize; 2], words: fn(usize, usize) -> Text| (all > 0).then(|| words(hold, all));
    let told = [
        told(quoted, text::quoted),
        told(folklore, text::without_source),
        told(own, text::own_checks),
        told(tables, text::tables_right),
    ];
    let not_read = (claims.unread > 0).then(|| text::not_read(claims.unread));
    told.into_iter().flatten().chain(not_read).collect()
}

/// A statement with its claims, each place that is quoted with its words above them.
fn statement(published: &Published) -> Vec<Block> {
    let first = published.claims.first();
    let first = first.map(|claim| phrase!("{}: {}", &claim.engine, &claim.says));
    let heading = published.text.as_ref().map(Text::from).or(first).unwrap_or_default();
    let mut blocks = vec![Block::Heading(1, heading)];
    blocks.extend(published.source.as_ref().map(|source| Block::Paragraph(phrase!("Source: {}.", source))));
    let answered = answered(published.claims.iter());
    let (claimed, own): (Vec<&Answered>, Vec<&Answered>) =
        answered.iter().partition(|(claim, _)| claim.provenance.is_claimed());
    for group in claimed.chunk_by(|one, other| one.0.provenance == other.0.provenance) {
        blocks.extend(group.first().map(|one| Block::Paragraph(said(&one.0.provenance, published.source.as_ref()))));
        blocks.push(table(group.iter().copied()).into());
    }
    if !own.is_empty() {
        blocks.push(text::cross_checks().into());
        blocks.push(table(own.iter().copied()).into());
    }
    blocks.extend(published.conclusion.as_ref().map(|words| Block::Paragraph(phrase!("**Conclusion.** {}", words))));
    blocks.extend(certificates(claimed.into_iter().chain(own)));
    blocks
}

/// Where it is said, with its source where that is not the one that is above.
fn said(provenance: &Provenance, above: Option<&Untrusted>) -> Text {
    match provenance {
        Provenance::Quoted(Quote { source, place, words }) if above == Some(source) => {
            phrase!("**{}:** “{}”", place, words)
        }
        Provenance::Quoted(Quote { source, place, words }) => phrase!("**{}, {}:** “{}”", source, place, words),
        Provenance::Folklore => text::no_source_found(),
        Provenance::Own => Text::default(),
    }
}

fn table<'a>(claims: impl IntoIterator<Item = &'a Answered<'a>>) -> Table {
    Table::of(claims)
        .column("Engine", |(claim, _)| &claim.engine)
        .column("Claim", |(claim, _)| &claim.says)
        .column("Answer", |(_, answer)| phrase!("**{}**", claim_status(answer)))
        .column("Finding", |(claim, answer)| found(claim, answer))
        .done()
}

fn found(claim: &Claim, answer: &Answer) -> Text {
    claim_finding_on((&claim.layout, claim.numbers.as_ref()), &claim.statement, answer)
}

/// The same in two columns, which a terminal has room for.
fn narrow(claims: &[Answered]) -> Table {
    let words = |answer: &Answer| if matches!(answer.finding, Finding::Nothing(_)) { "{}: {}" } else { "{}. {}" };
    Table::of(claims)
        .column("Claim", |(claim, _)| phrase!("{}: {}", &claim.engine, &claim.says))
        .column("Answer", |(claim, answer)| phrase!(words(answer), claim_status(answer), found(claim, answer)))
        .done()
}

/// The certificates of all claims of a statement, folded.
fn certificates<'a>(claims: impl Iterator<Item = &'a Answered<'a>>) -> Option<Block> {
    let mut blocks = Vec::new();
    for (claim, answer) in claims {
        let proofs = evidence(answer);
        if !proofs.is_empty() {
            blocks.push(Block::Paragraph(phrase!("{}, {}:", &claim.engine, &claim.says)));
            blocks.push(Block::List(proofs));
        }
    }
    (!blocks.is_empty()).then(|| Block::folded("Certificates", blocks))
}

/// The students' tables with their answers.
fn tables(claims: &Claims) -> Option<Table> {
    let mut judged: Vec<_> = claims.tables.iter().zip(claims.judged_tables()).collect();
    judged.sort_by_key(|(_, verdict)| verdict.holds());
    Table::of(judged)
        .column("Engine", |(table, _)| &table.engine)
        .column("Vector-star table of order", |(table, _)| table.order)
        .column("Answer", |(_, verdict)| if verdict.holds() { "**true**" } else { "**false**" })
        .column("Finding", |(table, verdict)| student::table_finding(table, verdict))
        .done_if_any()
}
