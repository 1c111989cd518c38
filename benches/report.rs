//! What does a report cost? Judging the orders of an engine, and judging and writing its report.
//!
//! `cargo bench -p benches --bench report`

use crankstar::engine::Engine;
use crankstar::file;
use crankstar::order::Masses;
use crankstar::page::{self, Format, Options};
use crankstar::proof::Quantity;
use crankstar::report;
use crankstar::verdict::{self, Judgement};
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

const ENGINES: [&str; 6] = ["I4", "I5-12453", "V6-90-split", "V8-crossplane", "V12-60", "radial-18"];

const QUANTITIES: [Quantity; 2] = [Quantity::FORCE, Quantity::MOMENT];

fn engine(name: &str) -> Engine {
    file::find(name).expect("in the catalogue").engine().expect("it reads")
}

#[divan::bench(args = ENGINES)]
fn verdicts(bencher: Bencher, name: &str) {
    let layout = engine(name);
    bencher.bench_local(|| {
        verdict::classify(black_box(&layout), layout.orders(), Masses::Reciprocating, &QUANTITIES)
            .expect("orders")
            .len()
    });
}

#[divan::bench(args = ENGINES)]
fn verdicts_and_report(bencher: Bencher, name: &str) {
    let layout = engine(name);
    bencher.bench_local(|| {
        let judged = Judgement::new(black_box(&layout), layout.orders(), &QUANTITIES).expect("orders");
        let subject = report::Contents {
            engine: &layout,
            judged: &judged,
            family: None,
            needed: None,
            in_motion: false,
            accuracy: None,
            weighing: report::Weighing::usual(),
        };
        page::write(&report::engine_page(subject), Format::GITHUB, &Options::default()).len()
    });
}
