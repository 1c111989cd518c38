//! What does a claims file hold? TOML: claims, published statements with the claims they rest on, students' tables.

use num_rational::BigRational;
use num_traits::Zero;
use serde::Deserialize;
use serde_spanned::Spanned;

use super::absolute::Numbers;
use super::error::ClaimError;
use super::find::{Find, engine};
use super::provenance::{Keys, Provenance};
use super::sentence::parse_statement;
use super::statement::Statement;
use super::student::{self, StarTable, Verdict};
use crate::engine::{Engine, Rod};
use crate::file::quantities::positive;
use crate::file::written::{Table, Text, place};
use crate::file::{Kind, LayoutError, units};
use crate::text::Untrusted;

/// A claims file.
#[derive(Clone, Debug)]
pub struct Claims {
    /// Title of the page.
    pub title: Untrusted,
    /// Statements with their claims; a plain `[[claim]]` is a statement of its own.
    pub statements: Vec<Published>,
    /// Students' vector-star tables.
    pub tables: Vec<StarTable>,
    /// How many claims and tables of the file cannot be read.
    pub unread: usize,
}

/// A statement as it was published, and what has to hold for it.
#[derive(Clone, Debug)]
pub struct Published {
    /// The statement in words; none for a claim by itself.
    pub text: Option<Untrusted>,
    /// Who says it; where in it, each claim tells.
    pub source: Option<Untrusted>,
    /// What the author of the file concludes from the answers.
    pub conclusion: Option<Untrusted>,
    /// The claims.
    pub claims: Vec<Claim>,
}

/// One claim about one engine.
#[derive(Clone, Debug)]
pub struct Claim {
    /// The engine's name or path, as written.
    pub engine: Untrusted,
    /// The engine.
    pub layout: Engine,
    /// Who says so, and where.
    pub provenance: Provenance,
    /// The claim, as written.
    pub says: Untrusted,
    /// The claim, as read.
    pub statement: Statement,
    /// What the engine weighs and measures, where a claim is in newtons.
    pub numbers: Option<Numbers>,
}

impl Claims {
    /// Answers to all students' tables, in their order.
    pub fn judged_tables(&self) -> Vec<Verdict> {
        self.tables.iter().map(student::judge).collect()
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    title: Option<Text>,
    /// The source of every statement that names no other.
    source: Option<Text>,
    claim: Option<Vec<Spanned<Table<ClaimTable>>>>,
    statement: Option<Vec<Spanned<Table<StatementTable>>>>,
    table: Option<Vec<Spanned<Table<student::Written>>>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StatementTable {
    text: Text,
    kind: Option<Text>,
    source: Option<Text>,
    place: Option<Text>,
    words: Option<Text>,
    conclusion: Option<Text>,
    claim: Vec<Spanned<Table<ClaimTable>>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ClaimTable {
    layout: Text,
    says: Text,
    kind: Option<Text>,
    source: Option<Text>,
    place: Option<Text>,
    words: Option<Text>,
    numbers: Option<Table<NumbersTable>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct NumbersTable {
    reciprocating_mass: Text,
    crank_radius: Text,
    rod_length: Text,
    speed: Text,
    spacing: Option<Text>,
}

/// Reads a claims file; `name` is the path that messages show, `find` looks up engines.
///
/// # Errors
/// Each mistake, with its place and what would be right.
pub fn parse_claims(name: &str, source: &str, find: Find) -> Result<Claims, LayoutError> {
    let (claims, unread) = readable_claims(name, source, find)?;
    unread.map_or(Ok(claims), Err)
}

/// The claims of a file that can be read, and what is wrong with the others.
///
/// # Errors
/// Each mistake, where nothing can be read.
pub fn readable_claims(name: &str, source: &str, find: Find) -> Result<(Claims, Option<LayoutError>), LayoutError> {
    let read = Kind::Claims.read::<File>(source).and_then(|file| claims(name, file, find));
    let in_file = |error: LayoutError| error.in_file(name, source);
    read.map(|(claims, unread)| (claims, unread.map(in_file))).map_err(in_file)
}

fn claims(name: &str, file: File, find: Find) -> Result<(Claims, Option<LayoutError>), LayoutError> {
    let whole = Keys { source: file.source.as_ref(), ..Keys::default() };
    let (mut statements, mut mistakes) = (Vec::new(), Vec::new());
    for table in file.claim.iter().flatten() {
        let table = &table.get_ref().0;
        let source = table.source.as_ref().map(text);
        let claims = kept(claim(table, whole, find), &mut mistakes).into_iter().collect();
        statements.push(Published { text: None, source, conclusion: None, claims });
    }
    for table in file.statement.iter().flatten() {
        let table = &table.get_ref().0;
        let around = Keys::of([&table.kind, &table.source, &table.place, &table.words]).within(whole);
        let claims = table.claim.iter().map(|table| claim(&table.get_ref().0, around, find));
        statements.push(Published {
            text: Some(text(&table.text)),
            source: around.source.map(text),
            conclusion: table.conclusion.as_ref().map(text),
            claims: claims.filter_map(|claim| kept(claim, &mut mistakes)).collect(),
        });
    }
    let tables = file.table.iter().flatten().map(|table| student::read(&table.get_ref().0, find));
    let tables: Vec<StarTable> = tables.filter_map(|table| kept(table, &mut mistakes)).collect();
    statements.retain(|statement| !statement.claims.is_empty());
    let unread = mistakes.len();
    let mut mistakes = mistakes.into_iter();
    let mistakes = mistakes.next().map(|first: LayoutError| first.and(mistakes));
    if statements.is_empty() && tables.is_empty() {
        let right = "add a [[claim]] with layout and says, a [[statement]] or a [[table]]";
        return Err(mistakes.unwrap_or_else(|| LayoutError::new("the file claims nothing", right, None)));
    }
    let title = file.title.as_ref().map_or_else(|| Untrusted::new(name), text);
    Ok((Claims { title, statements, tables, unread }, mistakes))
}

/// What can be read; else what is wrong is put to the other mistakes.
fn kept<T>(read: Result<T, LayoutError>, mistakes: &mut Vec<LayoutError>) -> Option<T> {
    read.map_err(|mistake| mistakes.push(mistake)).ok()
}

fn text(text: &Text) -> Untrusted {
    text.get_ref().untrusted()
}

fn claim(table: &ClaimTable, around: Keys, find: Find) -> Result<Claim, LayoutError> {
    let says = text(&table.says);
    let mistake = |mistake: ClaimError| LayoutError::new(mistake.message, mistake.right, place(&table.says));
    let layout = engine(&table.layout, find)?;
    let numbers = table.numbers.as_ref().map(|table| numbers(&table.0, &layout)).transpose()?;
    Ok(Claim {
        engine: text(&table.layout),
        layout,
        provenance: Keys::of([&table.kind, &table.source, &table.place, &table.words]).within(around).provenance()?,
        statement: parse_statement(says.written()).map_err(mistake)?,
        says,
        numbers,
    })
}

/// What a claim says of its engine, which is not other than what the layout says.
fn numbers(table: &NumbersTable, layout: &Engine) -> Result<Numbers, LayoutError> {
    let crank_radius = positive(&table.crank_radius, "crank radius", units::metres)?;
    let ratio = &crank_radius / positive(&table.rod_length, "rod length", units::metres)?;
    let numbers = Numbers {
        rod: Rod { ratio, offset: BigRational::zero() },
        crank_radius,
        reciprocating_mass: positive(&table.reciprocating_mass, "mass", units::mass)?,
        speed: positive(&table.speed, "speed", revolutions)?,
        spacing: table.spacing.as_ref().map(|text| positive(text, "spacing", units::metres)).transpose()?,
    };
    let own = layout.dimensions();
    let is_other = |own: &Option<BigRational>, said: &BigRational| own.as_ref().is_some_and(|own| own != said);
    let others = [
        (is_other(&own.mass, &numbers.reciprocating_mass), "reciprocating mass", &table.reciprocating_mass),
        (is_other(&own.crank_radius, &numbers.crank_radius), "crank radius", &table.crank_radius),
        (layout.rods().any(|rod| rod.ratio != numbers.rod.ratio), "ratio of crank radius and rod", &table.rod_length),
        (is_other(&own.speed, &numbers.speed), "speed", &table.speed),
    ];
    if let Some((_, what, text)) = others.into_iter().find(|(is_other, ..)| *is_other) {
        let right = "the same value as in the layout; where the layout gives all, omit `numbers`";
        return Err(LayoutError::new(format!("the layout gives another {what}"), right, place(text)));
    }
    match &table.spacing {
        Some(text) if layout.is_in_metres() => {
            let right = "omit `spacing` here: moments are of those positions";
            Err(LayoutError::new("the layout gives positions in metres", right, place(text)))
        }
        _ => Ok(numbers),
    }
}

/// Revolutions a minute.
fn revolutions(text: &str) -> Result<BigRational, String> {
    let number = text.trim().trim_end_matches("rpm").trim_end();
    crate::file::parse_number(number).map_err(|error| format!("{error}; revolutions a minute, as in \"600 rpm\""))
}
