//! What does a report cost? Judging the orders of an engine, and judging and writing its report.
//!
//! `cargo bench --bench report`

use crankstar::engine::Engine;
use crankstar::file;
use crankstar::report::{self, Dialect};
use crankstar::verdict;
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

const ENGINES: [&str; 6] = ["I4", "I5-12453", "V6-90-split", "V8-crossplane", "V12-60", "radial-18"];

fn engine(name: &str) -> Engine {
    file::find(name).expect("in the catalogue").engine().expect("it reads")
}

#[divan::bench(args = ENGINES)]
fn verdicts(bencher: Bencher, name: &str) {
    let layout = engine(name);
    bencher.bench_local(|| verdict::classify(black_box(&layout), layout.orders(), false).len());
}

#[divan::bench(args = ENGINES)]
fn verdicts_and_report(bencher: Bencher, name: &str) {
    let layout = engine(name);
    bencher.bench_local(|| {
        let orders = verdict::classify(black_box(&layout), layout.orders(), false);
        let subject = report::Subject { layout: &layout, orders: &orders, family: None, needed: None, accuracy: None };
        report::report(subject, Dialect::GithubMarkdown).len()
    });
}
