//! What does an effect cost that is not asked for, and one that is? The same engine with a gas in its file, without, and asked for it.
//!
//! `cargo bench -p benches --bench effects`. The first of each three is the baseline: an effect that is not asked for costs what it takes to
//! read its lines, and nothing after that.

use crankstar::engine::Engine;
use crankstar::file;
use crankstar::loads;
use crankstar::page::{self, Format, Options};
use crankstar::proof::Quantity;
use crankstar::report;
use crankstar::verdict::Judgement;
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

const V8: &str = include_str!("../reports/examples/v8-gas/layout.toml");

const FILES: [Gas; 3] = [Gas::None, Gas::Given, Gas::AskedFor];

/// What the file says of the gas.
#[derive(Clone, Copy, Debug)]
enum Gas {
    None,
    Given,
    AskedFor,
}

impl Gas {
    fn text(self) -> String {
        let effects = V8.lines().find(|line| line.starts_with("effects")).expect("the effects of the example");
        let (engine, _) = V8.split_once("[gas]").expect("the gas of the example");
        match self {
            Gas::None => engine.replace(effects, ""),
            Gas::Given => V8.replace(effects, ""),
            Gas::AskedFor => V8.replace(effects, "effects = [\"gas\"]"),
        }
    }

    fn engine(self) -> Engine {
        file::parse("layout.toml", &self.text()).expect("it reads")
    }
}

#[divan::bench(args = FILES)]
fn a_reading_the_file(bencher: Bencher, gas: Gas) {
    let text = gas.text();
    bencher.bench_local(|| file::parse("layout.toml", black_box(&text)).expect("it reads").cylinders().len());
}

#[divan::bench(args = FILES)]
fn b_loads(bencher: Bencher, gas: Gas) {
    let engine = gas.engine();
    let orders = loads::usual_orders(&engine);
    bencher.bench_local(|| loads::loads(black_box(&engine), &orders).expect("numbers").coefficients);
}

#[divan::bench(args = FILES)]
fn c_report(bencher: Bencher, gas: Gas) {
    let engine = gas.engine();
    bencher.bench_local(|| {
        let judged = Judgement::new(black_box(&engine), engine.orders(), &Quantity::PLANAR);
        let contents = report::Contents {
            engine: &engine,
            judged: &judged.expect("orders"),
            family: None,
            needed: None,
            in_motion: false,
            accuracy: None,
            weighing: report::Weighing::usual(),
        };
        page::write(&report::engine_page(contents), Format::GITHUB, &Options::default()).len()
    });
}
