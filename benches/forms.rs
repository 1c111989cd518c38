//! How long do all closed forms of a page take? Over the 300 layouts of `reports/forms`, each with nothing remembered.
//!
//! `cargo bench -p benches --bench forms`. A page has, for force and moment of orders 1, 2, 4 and 6, both lengths, both directions and the largest value.
#![allow(clippy::disallowed_types)]

#[path = "../tests/suite/support/books.rs"]
mod books;
#[path = "../tests/suite/support/dice.rs"]
#[allow(dead_code)]
mod dice;

use std::time::{Duration, Instant};

use crankstar::engine::Engine;
use crankstar::file;
use crankstar::numbers;
use crankstar::order;
use crankstar::proof::{Quantity, Sense};
use dice::Dice;

const LAYOUTS: usize = 300;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut dice = Dice::new(LAYOUTS as u64);
    let mut times = Vec::new();
    for make in books::MAKES.iter().cycle().take(LAYOUTS) {
        let text = books::file(&mut dice, make);
        let engine = file::parse("book.toml", &text)?;
        // What was found of a star is remembered by thread.
        let time = std::thread::spawn(move || forms(&engine)).join().map_err(|_| format!("no forms of\n{text}"))?;
        times.push((time, text));
    }
    times.sort();
    let at = |place: usize| times[place].0.as_secs_f64() * 1e3;
    println!("{LAYOUTS} layouts, all closed forms of a page; milliseconds\n");
    println!("median {:.2}, 95 % {:.1}, slowest {:.1}", at(LAYOUTS / 2), at(LAYOUTS * 95 / 100), at(LAYOUTS - 1));
    println!(
        "{} above 50\n\nthe slowest:\n{}",
        times.iter().filter(|(time, _)| time.as_millis() >= 50).count(),
        times[LAYOUTS - 1].1
    );
    Ok(())
}

fn forms(engine: &Engine) -> Duration {
    let start = Instant::now();
    for order in [1, 2, 4, 6] {
        for quantity in [Quantity::FORCE, Quantity::MOMENT] {
            let vectors =
                [Sense::Direct, Sense::Reverse].map(|sense| order::star(engine, quantity, order, Some(sense)));
            for sum in vectors.iter().filter(|sum| !sum.vanishes()) {
                std::hint::black_box((numbers::modulus(sum), numbers::direction_of(sum)));
            }
            std::hint::black_box(numbers::half_of_lengths(&vectors[0], &vectors[1]));
        }
    }
    start.elapsed()
}
