//! How long does a sweep of 10,000 layouts take, and what does it save to parse the file once and to sum in floats?
//!
//! `cargo bench -p benches --bench sweep`. The cross-plane V8 over its bank angle in 10,000 steps, orders 1, 2, 4 and 6, on all cores.
//! The baseline, in the same run: 100 of these layouts from their text, one by one, judged by the decision procedure.

use crankstar::file::{self, Template};
use crankstar::order::Masses;
use crankstar::proof::Quantity;
use crankstar::sweep::{Geometry, Parameter, sweep};
use crankstar::verdict;
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

const V8: &str = "cycle = \"four-stroke\"\n[vee]\nbank_angle = 90\nthrows = [0, 270, 90, 180]\n";

/// The V8 with its rods, or with its counterweights too.
fn file(with_masses: bool) -> String {
    let masses = "[mechanism]\ncrank_radius = \"45 mm\"\nrod_ratio = 0.25\nreciprocating_mass = 0.65\nrotating_mass = 0.4\n\
        [crankshaft]\nbalance_factor = 0.5\ncounterweight_radius = \"45 mm\"\n";
    if with_masses { format!("{V8}{masses}") } else { V8.to_owned() }
}

fn ten_thousand(bencher: Bencher, with_masses: bool, parameter: &str) {
    let text = file(with_masses);
    let template = Template::new("v8.toml", &text).expect("it reads");
    let parameters = [Parameter::parse(parameter).expect("a parameter")];
    bencher.counter(ItemsCount::new(10_000_u32)).bench_local(|| {
        sweep(black_box(&template), &parameters, &[1, 2, 4, 6], &Geometry::default()).expect("a sweep")
    });
}

/// The bank angle.
#[divan::bench(sample_count = 3)]
fn a_bank_angle(bencher: Bencher) {
    ten_thousand(bencher, false, "vee.bank_angle=0..179.982:0.018");
}

/// The rod ratio: the coefficients are new at each point.
#[divan::bench(sample_count = 3)]
fn b_rod_ratio(bencher: Bencher) {
    ten_thousand(bencher, false, "mechanism.rod_ratio=0.0001..0.5:0.00005");
}

/// The bank angle of an engine with counterweights: exact sums of all masses.
#[divan::bench(sample_count = 3)]
fn c_bank_angle_with_counterweights(bencher: Bencher) {
    ten_thousand(bencher, true, "vee.bank_angle=0..179.982:0.018");
}

/// A hundred layouts from their text, judged one by one.
#[divan::bench(sample_count = 3)]
fn d_hundred_layouts_from_their_text(bencher: Bencher) {
    let texts: Vec<String> =
        (0..100).map(|index| V8.replace("= 90", &format!("= {}.{}", index * 18 / 10, index * 18 % 10))).collect();
    bencher.counter(ItemsCount::new(100_u32)).bench_local(|| {
        texts
            .iter()
            .map(|text| {
                let layout = file::parse("v8.toml", black_box(text)).expect("it reads");
                verdict::classify(&layout, &[1, 2, 4, 6], Masses::Reciprocating, &Quantity::PLANAR)
                    .expect("orders")
                    .len()
            })
            .sum::<usize>()
    });
}
