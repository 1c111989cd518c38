//! Is every verdict on any engine that can be written the oracle's, and does every document about it verify?
//!
//! The oracle (dense reduction modulo the cyclotomic polynomial) shares nothing with the solver, and the sums that it reduces
//! are put together here, from the formulas. Some hundreds of engines are tried every time;
//! `CRANKSTAR_RENEW=1 cargo test --release --test suite -- --ignored a_hundred_thousand` tries 100,000 and writes
//! `reports/trust/README.md` anew, `CRANKSTAR_ENGINES` as many as it says.

use std::collections::BTreeMap;
use std::env;

use crate::support::dice::Dice;
use crate::support::trust::{grouped, renew};
use crate::support::verdicts::{self, judged};
use crate::support::{engines, oracle};
use crankstar::engine::{Cylinder, Engine};
use crankstar::file::{Layout, parse_layout};
use crankstar::order::{Factor, Source};
use crankstar::proof::{self, Document, OpenDocument, Quantity, Sense, Shape};
use crankstar::verdict::{Balance, Class, OrderVerdict, Verdict};
use crankstar::{family, report};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};

const ORDERS: [u32; 8] = [1, 2, 3, 4, 5, 6, 7, 8];
const USUAL: u64 = 240;
const MANY: u64 = 100_000;

/// What a run came to, for one form.
#[derive(Default)]
struct Tally {
    engines: usize,
    zero: usize,
    other: usize,
    planar: usize,
    elliptical: usize,
    certificates: usize,
    refused: Vec<String>,
}

/// Cyclotomic polynomials, each computed once.
#[derive(Default)]
struct Oracle(BTreeMap<u64, Vec<i128>>);

/// Terms `weight · e^{2πi·angle}`.
type Terms = Vec<(BigRational, BigRational)>;

impl Oracle {
    fn vanishes(&mut self, terms: &Terms) -> bool {
        let conductor = terms.iter().fold(BigInt::one(), |all, (angle, _)| all.lcm(angle.denom()));
        let scale = terms.iter().fold(BigInt::one(), |all, (_, weight)| all.lcm(weight.denom()));
        let n = conductor.to_u64().expect("a small conductor");
        let whole = |ratio: &BigRational, of: &BigInt| ratio.numer() * (of / ratio.denom());
        let term = |(angle, weight): &(BigRational, BigRational)| {
            let exponent = whole(angle, &conductor).mod_floor(&conductor).to_u64().expect("below the conductor");
            (exponent, whole(weight, &scale).to_i64().expect("a small weight"))
        };
        let terms: Vec<(u64, i64)> = terms.iter().map(term).collect();
        let polynomial = self.0.entry(n).or_insert_with(|| oracle::cyclotomic(n as usize));
        oracle::vanishes(n as usize, polynomial, &terms)
    }
}

/// The vectors of an order from the definition: the force along the axis of its cylinder, at the cylinder's own crank angle.
fn terms(layout: &Engine, of: &[&Cylinder], verdict: &Verdict, class: Option<&Class>) -> Terms {
    let k = BigRational::from_integer(verdict.order.into());
    let vector = |cylinder: &&Cylinder| {
        let (throw, bank) = (cylinder.throw.turns(), cylinder.bank.turns());
        let own = &k * (throw - bank);
        let angle = match verdict.sense {
            Some(Sense::Direct) => own + bank,
            Some(Sense::Reverse) => bank - own,
            None => own,
        };
        let (mass, radius) = (&cylinder.reciprocating_mass, &cylinder.crank_radius);
        let weight = match verdict.quantity {
            Quantity::FORCE => mass * radius,
            Quantity::MOMENT => mass * radius * (&cylinder.position - layout.reference_plane()),
            Quantity::TORQUE => mass * radius * radius,
            Quantity::ROLL => unreachable!("it is not asked for"),
        };
        // Cylinders whose axes pass the shaft on either side are judged together: odd c_k above 1 change their sign with the offset, and so
        // does the imaginary part of c_1.
        let is_aside = class.is_some_and(|class| matches!(class.factor, Factor::Quadrature(_)));
        let is_mirrored = is_aside || (verdict.sense.is_some() && verdict.order > 1 && verdict.order % 2 == 1);
        let passes_behind = cylinder.rod().is_some_and(|rod| rod.offset.is_negative());
        let weight = if is_mirrored && passes_behind { -weight } else { weight };
        (angle, weight)
    };
    of.iter().map(vector).collect()
}

/// `|P⁺|² − |P⁻|²`.
fn difference(direct: &Terms, reverse: &Terms) -> Terms {
    let square = |terms: &Terms, sign: i64| -> Terms {
        let product = |(a, b): &(BigRational, BigRational), (c, d): &(BigRational, BigRational)| {
            (a - c, b * d * BigRational::from_integer(sign.into()))
        };
        terms.iter().flat_map(|one| terms.iter().map(move |other| product(one, other))).collect()
    };
    [square(direct, 1), square(reverse, -1)].concat()
}

impl Tally {
    fn judge(&mut self, oracle: &mut Oracle, layout: &Engine, text: &str) {
        let orders = judged(layout, &ORDERS, true);
        let of = |verdict: &Verdict| -> Vec<&Cylinder> {
            let cylinder = |source: &Source| match source {
                Source::Piston(index) => &layout.cylinders()[*index],
                _ => panic!("only pistons were asked for"),
            };
            verdict.sources.iter().map(cylinder).collect()
        };
        for order in &orders {
            for part in &order.parts {
                let class = part.class.as_ref();
                self.shape(oracle, (layout, class), &of(&part.force.direct), &part.force, text);
                self.shape(oracle, (layout, class), &of(&part.moment.direct), &part.moment, text);
            }
            for part in &order.torque.as_ref().expect("a torque was asked for").parts {
                self.verdict(oracle, &terms(layout, &of(&part.verdict), &part.verdict, None), &part.verdict, text);
            }
        }
        self.verify(layout, &orders, text);
    }

    fn verdict(&mut self, oracle: &mut Oracle, terms: &Terms, verdict: &Verdict, text: &str) {
        let Verdict { quantity, order, sense, .. } = verdict;
        assert_eq!(verdict.vanishes(), oracle.vanishes(terms), "{quantity:?} of order {order}, {sense:?}:\n{text}");
        *(if verdict.vanishes() { &mut self.zero } else { &mut self.other }) += 1;
    }

    fn shape(
        &mut self,
        oracle: &mut Oracle,
        (layout, class): (&Engine, Option<&Class>),
        of: &[&Cylinder],
        balance: &Balance,
        text: &str,
    ) {
        let [direct, reverse] = balance.verdicts().map(|verdict| {
            let terms = terms(layout, of, verdict, class);
            self.verdict(oracle, &terms, verdict, text);
            terms
        });
        let shape = match (balance.direct.vanishes(), balance.reverse.vanishes()) {
            (true, true) => Shape::Balanced,
            (false, true) => Shape::Rotating,
            (true, false) => Shape::CounterRotating,
            (false, false) if oracle.vanishes(&difference(&direct, &reverse)) => {
                self.planar += 1;
                Shape::Planar
            }
            (false, false) => {
                self.elliptical += 1;
                Shape::Elliptical
            }
        };
        assert_eq!(balance.shape, shape, "{:?} of order {}:\n{text}", balance.direct.quantity, balance.direct.order);
    }

    /// The document as `verify` reads it: from its text.
    fn verify(&mut self, layout: &Engine, orders: &[OrderVerdict], text: &str) {
        let json = serde_json::to_string(&verdicts::document(layout, orders, true, None)).expect("a document");
        let document: Document = serde_json::from_str(&json).expect("the same document");
        self.count(proof::check_document(&document), text);
    }

    fn verify_open(&mut self, family: &crankstar::engine::Family, text: &str) {
        let verdicts = family::classify(family, &[1, 2]).expect("orders");
        let json = serde_json::to_string(&report::open_document(family, &verdicts)).expect("a document");
        let document: OpenDocument = serde_json::from_str(&json).expect("the same document");
        self.count(proof::check_open_document(&document), text);
    }

    fn count(&mut self, checked: Result<proof::Checked, proof::Fault>, text: &str) {
        match checked {
            Ok(checked) => self.certificates += checked.counts.certificates(),
            Err(fault) => self.refused.push(format!("{fault}\n{text}")),
        }
    }
}

fn run(count: u64) -> BTreeMap<&'static str, Tally> {
    let mut oracle = Oracle::default();
    let mut tallies: BTreeMap<&str, Tally> = BTreeMap::new();
    for number in 0..count {
        let form = engines::FORMS[number as usize % engines::FORMS.len()];
        let text = engines::file(&mut Dice::new(number), form);
        let tally = tallies.entry(form).or_default();
        tally.engines += 1;
        match parse_layout("engine.toml", &text).unwrap_or_else(|error| panic!("{error}\n{text}")) {
            Layout::Known(layout, _) => tally.judge(&mut oracle, &layout, &text),
            Layout::Open(family) => tally.verify_open(&family, &text),
        }
    }
    tallies
}

#[track_caller]
fn assert_all_verify(tallies: &BTreeMap<&str, Tally>) {
    let refused: Vec<&String> = tallies.values().flat_map(|tally| &tally.refused).collect();
    assert!(refused.is_empty(), "{} documents are refused; the first:\n{}", refused.len(), refused[0]);
}

#[test]
fn verdicts_on_random_engines_of_every_form_are_those_of_the_oracle() {
    let tallies = run(USUAL);
    let sum = |of: fn(&Tally) -> usize| tallies.values().map(of).sum::<usize>();
    let (zero, other) = (sum(|tally| tally.zero), sum(|tally| tally.other));
    assert!(zero > 1_000 && other > 1_000, "{zero} zero, {other} not");
    assert!(sum(|tally| tally.planar) > 100 && sum(|tally| tally.elliptical) > 100);
    assert!(sum(|tally| tally.certificates) > 1_000);
    assert_all_verify(&tallies);
}

#[test]
#[ignore = "some minutes"]
fn a_hundred_thousand_random_engines_are_judged_as_the_oracle_judges_them() {
    let count = env::var("CRANKSTAR_ENGINES").map_or(MANY, |count| count.parse().expect("a number of engines"));
    let tallies = run(count);
    let page = page(count, &tallies);
    renew("README.md", &page);
    assert_all_verify(&tallies);
}

fn page(count: u64, tallies: &BTreeMap<&str, Tally>) -> String {
    let row = |name: &str, tallies: &[&Tally]| {
        let sum = |of: &dyn Fn(&Tally) -> usize| grouped(tallies.iter().map(|tally| of(tally)).sum());
        let cells = [
            sum(&|tally| tally.engines),
            sum(&|tally| tally.zero),
            sum(&|tally| tally.other),
            sum(&|tally| tally.planar),
            sum(&|tally| tally.elliptical),
            sum(&|tally| tally.engines - tally.refused.len()),
            sum(&|tally| tally.certificates),
        ];
        format!("| {name} | {} |\n", cells.join(" | "))
    };
    let rows: String = tallies.iter().map(|(form, tally)| row(form, &[tally])).collect();
    let all = row("**all**", &tallies.values().collect::<Vec<_>>());
    format!(
        "# Random engines against an independent method\n\n\
         {} layout files, pseudo-random and the same every time: every form, angles of 20 denominators, splits and offsets of pins and \
         banks, unequal masses and rods, and `open` ones with unknown angles and lengths. Force and moment of orders 1 to 8, direct and reverse, \
         and the inertia torque were decided, and each verdict compared with a dense reduction modulo the cyclotomic polynomial, which shares \
         no code with the program's decision; so was each shape, by the difference of the squared lengths. No verdict differs. \
         Each `classify --json` document was written, read again and checked as `verify` does.\n\n\
         | Form | Engines | Zero | Not zero | Planar | Elliptical | Documents that verify | Certificates |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- |\n{rows}{all}\n\
         `CRANKSTAR_RENEW=1 cargo test --release --test suite -- --ignored a_hundred_thousand` writes this page anew. \
         Beside it: [documents of engines in every detail](documents.md), [changed documents](checkers.md).\n",
        grouped(usize::try_from(count).expect("a small number")),
    )
}
