//! What stands on a page of claims? Each statement with its claims, who says them and where, the answers, and what they
//! rest on; what the file reckons beside them stands apart and is not counted as a claim.

use serde::Serialize;

use super::claim_words;
use super::dialect::Dialect;
use super::folder::File;
use super::render;
use crate::claim::{Claim, Claims, Provenance, Published};
use crate::text::Untrusted;

#[derive(Serialize)]
struct Page {
    title: String,
    summary: String,
    statements: Vec<Statement>,
}

#[derive(Serialize)]
struct Statement {
    heading: String,
    source: Option<String>,
    conclusion: Option<String>,
    /// What is claimed, by a source or by nobody in particular.
    claimed: Vec<Answered>,
    /// What is reckoned beside it.
    own: Vec<Answered>,
    proved: bool,
}

#[derive(Serialize)]
struct Answered {
    engine: String,
    said: String,
    says: String,
    status: String,
    finding: String,
    evidence: Vec<String>,
}

/// How many claims of one provenance hold.
#[derive(Default)]
struct Count {
    all: usize,
    hold: usize,
}

impl Count {
    fn add(&mut self, holds: bool) {
        self.all += 1;
        self.hold += usize::from(holds);
    }
}

/// The page that answers a claims file, in Markdown.
pub fn claims_page(claims: &Claims) -> File {
    let dialect = Dialect::GithubMarkdown;
    let page = Page {
        title: dialect.quoted(&claims.title),
        summary: summary(claims),
        statements: claims.statements.iter().map(|published| statement(published, dialect)).collect(),
    };
    File { name: "README.md".into(), text: render::claims(&page) }
}

/// How many claims hold, those of sources, of nobody and of the file apart.
fn summary(claims: &Claims) -> String {
    let [mut quoted, mut folklore, mut own] = [(); 3].map(|()| Count::default());
    for claim in claims.statements.iter().flat_map(|statement| &statement.claims) {
        let holds = claim.answer().status.holds();
        match claim.provenance {
            Provenance::Quoted(_) => quoted.add(holds),
            Provenance::Folklore => folklore.add(holds),
            Provenance::Own => own.add(holds),
        }
    }
    let kinds = [
        (quoted, "claims quoted from their sources"),
        (folklore, "claims of folklore, for which no source was found,"),
        (own, "statements that are reckoned here, and claimed by no source,"),
    ];
    let counted = kinds.iter().filter(|(count, _)| count.all > 0);
    let sentences: Vec<String> =
        counted.map(|(count, what)| format!("Of {} {what} {} hold.", count.all, count.hold)).collect();
    sentences.join(" ")
}

fn statement(published: &Published, dialect: Dialect) -> Statement {
    let quoted = |text: &Option<Untrusted>| text.as_ref().map(|text| dialect.quoted(text));
    let (claimed, own): (Vec<&Claim>, Vec<&Claim>) =
        published.claims.iter().partition(|claim| claim.provenance.is_claimed());
    let answers = |claims: Vec<&Claim>| {
        claims.into_iter().map(|claim| answered(claim, published.source.as_ref(), dialect)).collect()
    };
    let [claimed, own]: [Vec<Answered>; 2] = [claimed, own].map(answers);
    let first = published.claims.first();
    let first = first.map(|claim| format!("{}: {}", dialect.quoted(&claim.engine), dialect.quoted(&claim.says)));
    Statement {
        heading: quoted(&published.text).or(first).unwrap_or_default(),
        source: quoted(&published.source),
        conclusion: quoted(&published.conclusion),
        proved: claimed.iter().chain(&own).any(|claim| !claim.evidence.is_empty()),
        claimed,
        own,
    }
}

fn answered(claim: &Claim, above: Option<&Untrusted>, dialect: Dialect) -> Answered {
    let answer = claim.answer();
    Answered {
        engine: dialect.quoted(&claim.engine),
        said: claim_words::said(&claim.provenance, above, dialect).unwrap_or_default(),
        says: dialect.quoted(&claim.says),
        status: claim_words::claim_status(&answer),
        finding: dialect.prose(&claim_words::claim_finding(&claim.statement, &answer)),
        evidence: claim_words::evidence(&answer).iter().map(|text| dialect.prose(text)).collect(),
    }
}
