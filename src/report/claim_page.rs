//! What stands on a page of claims? Each statement with its claims, the answers, and what they rest on.

use serde::Serialize;

use super::claim_words;
use super::dialect::Dialect;
use super::folder::File;
use super::render;
use crate::claim::{Claim, Claims, Published};
use crate::text::Untrusted;

#[derive(Serialize)]
struct Page {
    title: String,
    summary: String,
    statements: Vec<Statement>,
}

#[derive(Serialize)]
struct Statement {
    text: Option<String>,
    source: Option<String>,
    conclusion: Option<String>,
    claims: Vec<Answered>,
    proved: bool,
}

#[derive(Serialize)]
struct Answered {
    engine: String,
    says: String,
    status: String,
    finding: String,
    evidence: Vec<String>,
}

/// The page that answers a claims file, in Markdown.
pub fn claims_page(claims: &Claims) -> File {
    let dialect = Dialect::GithubMarkdown;
    let all: Vec<bool> = claims
        .statements
        .iter()
        .flat_map(|statement| &statement.claims)
        .map(|claim| claim.answer().status.holds())
        .collect();
    let page = Page {
        title: dialect.quoted(&claims.title),
        summary: format!(
            "{} claims about engines: {} hold, {} do not.",
            all.len(),
            count(&all, true),
            count(&all, false)
        ),
        statements: claims.statements.iter().map(|published| statement(published, dialect)).collect(),
    };
    File { name: "README.md".into(), text: render::claims(&page) }
}

fn count(all: &[bool], wanted: bool) -> usize {
    all.iter().filter(|holds| **holds == wanted).count()
}

fn statement(published: &Published, dialect: Dialect) -> Statement {
    let quoted = |text: &Option<Untrusted>| text.as_ref().map(|text| dialect.quoted(text));
    let claims: Vec<Answered> = published.claims.iter().map(|claim| answered(claim, dialect)).collect();
    Statement {
        text: quoted(&published.text),
        source: quoted(&published.source),
        conclusion: quoted(&published.conclusion),
        proved: claims.iter().any(|claim| !claim.evidence.is_empty()),
        claims,
    }
}

fn answered(claim: &Claim, dialect: Dialect) -> Answered {
    let answer = claim.answer();
    Answered {
        engine: dialect.quoted(&claim.engine),
        says: dialect.quoted(&claim.says),
        status: claim_words::claim_status(&answer),
        finding: dialect.prose(&claim_words::claim_finding(&claim.statement, &answer)),
        evidence: claim_words::evidence(&answer).iter().map(|text| dialect.prose(text)).collect(),
    }
}
