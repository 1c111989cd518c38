//! What do 28 verdicts cost over growing conductors? Writes the sums that the peers read, and prints the program's own times.
//!
//! `benches/peers/run` runs this beside FLINT, PARI/GP, GAP and NumPy. The sums are those of the cross-plane V8: orders 1, 2, 4, 6, 8, 10,
//! 12; force and moment; direct and reverse. Over a conductor above 8 the second bank is turned by one part of it, so that
//! no smaller one would do. A line is `who; what; conductor; nanoseconds a sum; sums that vanish`.

#![allow(clippy::disallowed_types)]

use std::fmt::Write as _;
use std::hint::black_box;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use crankstar::exact::{PhasorSum, Term, Turn, vanishes};
use crankstar::order;
use crankstar::proof::{Quantity, Sense};
use num_rational::BigRational;
use num_traits::ToPrimitive;

const ORDERS: [u32; 7] = [1, 2, 4, 6, 8, 10, 12];
const CONDUCTORS: [u64; 6] = [8, 24, 72, 360, 5040, 8 * 1_000_000_007];
/// Batches of which the least time counts: what else the machine does only adds to it.
const BATCHES: usize = 41;
const BATCH: Duration = Duration::from_millis(4);

/// The terms of one sum: exponents and twice the weights.
type Sum = Vec<(u64, i64)>;

fn main() {
    // Cargo adds `--bench`.
    let folder = std::env::args().skip(1).find(|argument| !argument.starts_with("--")).map(PathBuf::from);
    let mut files = [String::new(), "sums = [".to_owned(), "sums := [".to_owned()];
    for conductor in CONDUCTORS {
        let sums = sums(conductor);
        write_down(&mut files, conductor, &sums);
        let phasors: Vec<PhasorSum> = sums.iter().map(|sum| phasors(conductor, sum)).collect();
        print("verdict", conductor, &sums, |sum| vanishes(black_box(&conductor), sum));
        print("verdict from rational angles", conductor, &phasors, PhasorSum::vanishes);
        print("verdict and certificate from rational angles", conductor, &phasors, |sum| {
            sum.certificate().claims_zero()
        });
    }
    let [plain, gp, gap] = files;
    let Some(folder) = folder else { return };
    let gp = format!("{}]\n", gp.trim_end_matches(','));
    for (name, text) in [("sums", plain), ("sums.gp", gp), ("sums.g", format!("{gap}];\n"))] {
        std::fs::write(folder.join(name), text).expect("the folder for the sums");
    }
}

fn sums(conductor: u64) -> Vec<Sum> {
    let v8 = crankstar::file::find("V8-crossplane").expect("in the catalogue").engine().expect("reads");
    let banks: Vec<bool> = v8.cylinders().iter().map(|cylinder| cylinder.bank == v8.cylinders()[0].bank).collect();
    let mut sums = Vec::new();
    for order in ORDERS {
        for quantity in [Quantity::FORCE, Quantity::MOMENT] {
            for sense in [Sense::Direct, Sense::Reverse] {
                let star = order::star(&v8, quantity, order, Some(sense));
                let terms = star.terms().iter().zip(&banks).map(|(term, first)| {
                    let whole =
                        |number: &BigRational, by: u64| (number * BigRational::from_integer(by.into())).to_integer();
                    let exponent = whole(term.angle.turns(), conductor).to_u64().expect("below the conductor");
                    let turned = if *first || conductor == 8 { exponent } else { (exponent + 1) % conductor };
                    (turned, whole(&term.weight, 2).to_i64().expect("small"))
                });
                sums.push(terms.collect());
            }
        }
    }
    sums
}

/// Over the least denominators, with halves as they are: what an engine gives.
fn phasors(conductor: u64, sum: &Sum) -> PhasorSum {
    let ratio = |over: i64, under: u64| BigRational::new(over.into(), under.into());
    let term = |(exponent, weight): &(u64, i64)| Term {
        angle: Turn::new(ratio(i64::try_from(*exponent).expect("small"), conductor)),
        weight: ratio(*weight, 2),
    };
    PhasorSum::new(sum.iter().map(term).collect())
}

/// A sum a line, `conductor exponent weight exponent weight …`; and the same as lists of PARI/GP and of GAP.
fn write_down([plain, gp, gap]: &mut [String; 3], conductor: u64, sums: &[Sum]) {
    for sum in sums {
        let numbers = |between: &str| {
            let terms: Vec<String> =
                sum.iter().map(|(exponent, weight)| format!("{exponent}{between}{weight}")).collect();
            terms.join(between)
        };
        let _ = writeln!(plain, "{conductor} {}", numbers(" "));
        let _ = write!(gp, "[{conductor},{}],", numbers(","));
        let _ = write!(gap, "[{conductor},{}],", numbers(","));
    }
}

/// The least time of a batch, for one sum of it.
fn print<T>(what: &str, conductor: u64, sums: &[T], is_zero: impl Fn(&T) -> bool) {
    let all = || sums.iter().filter(|sum| is_zero(black_box(sum))).count();
    let start = Instant::now();
    let zeros = all();
    let rounds = (BATCH.as_nanos() / start.elapsed().as_nanos().max(1)).clamp(1, 100_000);
    let batch = || {
        let start = Instant::now();
        (0..rounds).for_each(|_| {
            black_box(all());
        });
        start.elapsed().as_nanos() as f64 / (rounds as f64 * sums.len() as f64)
    };
    let least = (0..BATCHES).map(|_| batch()).fold(f64::INFINITY, f64::min);
    println!("crankstar; {what}; {conductor}; {least:.1}; {zeros}");
}
