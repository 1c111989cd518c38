//! How does a search grow with the number of cylinders, and what is each idea worth?
#![allow(clippy::disallowed_types)]
//!
//! `cargo bench -p benches --bench search_growth -- 8 10 12` prints a table for in-line two-stroke engines of this many cylinders, orders 1 and 2: a
//! line for each way to go through the stars. Seconds are those that one core worked for this process (`utime` of Linux; elapsed elsewhere), so
//! other work on the machine counts little. Ways that would take hours are left out: see `most`.
//!
//! `cargo bench -p benches --bench search_growth -- --sample 20 11/400` judges the pieces of a shard, and extrapolates from their seconds to all of them.

use std::env;
use std::fs;
use std::ops::ControlFlow;
use std::sync::Mutex;
use std::time::Instant;

use crankstar::engine::Cycle;
use crankstar::search::{Front, Options, Pieces, Problem, Way, every_value, search};
use crankstar::shard::Shard;

/// Each way, what it is called, and the most cylinders that it is asked for.
type Entry = (&'static str, u32, fn(&Problem) -> Front);

const WAYS: [Entry; 3] = [
    ("symmetry alone", 10, |problem| every_value(problem).expect("a question")),
    ("and the bound (walk)", 14, |problem| with(problem, Way::Walk)),
    ("halves that meet (join)", 20, |problem| with(problem, Way::Join)),
];

fn with(problem: &Problem, way: Way) -> Front {
    search(problem, &Options { threads: 1, way, ..Options::default() }).expect("a front")
}

fn main() {
    let words: Vec<String> = env::args().skip(1).collect();
    if let Some(place) = words.iter().position(|word| word == "--sample") {
        let [cylinders, shard] = &words[place + 1..place + 3] else { panic!("--sample CYLINDERS i/N") };
        return sample(cylinders.parse().expect("a number"), Shard::parse(shard).expect("a shard"));
    }
    let asked: Vec<u32> = env::args().skip(1).filter_map(|word| word.parse().ok()).collect();
    let asked = if asked.is_empty() { vec![8, 10, 12, 14] } else { asked };
    println!(
        "| cylinders | stars | way | judged | front | seconds | memory |\n| --- | --- | --- | --- | --- | --- | --- |"
    );
    for cylinders in asked {
        let problem = Problem::inline(cylinders, Cycle::TwoStroke, &[1, 2]);
        for (name, _, run) in WAYS.iter().filter(|(_, most, _)| cylinders <= *most) {
            let (from, start) = (worked(), Instant::now());
            let front = run(&problem);
            let seconds = worked().zip(from).map_or(start.elapsed().as_secs_f64(), |(to, from)| to - from);
            let points = front.stars.iter().filter(|star| !front.stars.iter().any(|other| beats(other, star))).count();
            let memory = memory().map_or(String::new(), |kilobytes| format!("{} MB", kilobytes / 1024));
            println!(
                "| {cylinders} | {} | {name} | {} | {points} | {seconds:.2} | {memory} |",
                front.all, front.judged
            );
        }
    }
}

/// The seconds of each piece of a shard, and what all pieces would take: mean and standard error of the mean, times their number.
fn sample(cylinders: u32, shard: Shard) {
    let problem = Problem::inline(cylinders, Cycle::TwoStroke, &[1, 2]);
    let pieces = Pieces::new(&problem, Way::Join).expect("a question");
    let path = env::temp_dir().join(format!("crankstar-sample-{}.shard", std::process::id()));
    let seconds = || worked().expect("Linux tells how long this process worked");
    let ends = Mutex::new(Vec::new());
    let note = |_| {
        ends.lock().expect("one thread").push(seconds());
        ControlFlow::Continue(())
    };
    pieces.keep(shard, &path, &Options { threads: 1, progress: &note, ..Options::default() }).expect("a shard");
    fs::remove_file(&path).expect("the file of this sample");
    let (ends, all) = (ends.into_inner().expect("one thread"), pieces.question().pieces as f64);
    // Before the first piece ends stand those that every shard judges for itself.
    let each: Vec<f64> = ends.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let count = each.len() as f64;
    let mean = each.iter().sum::<f64>() / count;
    let spread = each.iter().map(|time| (time - mean).powi(2)).sum::<f64>() / (count - 1.0);
    let error = (spread / count).sqrt();
    println!(
        "{cylinders} cylinders, shard {shard} of {all} pieces, {count} timed: {mean:.2} s each, standard error {error:.2}"
    );
    println!("all: {:.2} core hours, standard error {:.2}", mean * all / 3600.0, error * all / 3600.0);
    println!("until the first piece of the shard: {:.1} s; memory {:?} KB", ends[0], memory());
}

/// Every value is listed where there is no bound; by decimals this is enough for a count.
fn beats(one: &crankstar::search::FoundStar, other: &crankstar::search::FoundStar) -> bool {
    let pairs = || one.moments.iter().zip(&other.moments);
    pairs().all(|(a, b)| a.decimal <= b.decimal + 1e-9) && pairs().any(|(a, b)| a.decimal < b.decimal - 1e-9)
}

/// Seconds that this process worked so far, where Linux tells.
fn worked() -> Option<f64> {
    let text = fs::read_to_string("/proc/self/stat").ok()?;
    let after_name = text.rsplit_once(')')?.1;
    // The twelfth field after the name, in hundredths.
    after_name.split_whitespace().nth(11)?.parse::<f64>().ok().map(|ticks| ticks / 100.0)
}

/// The most memory so far, in kilobytes, where Linux tells.
fn memory() -> Option<u64> {
    let text = fs::read_to_string("/proc/self/status").ok()?;
    text.lines().find_map(|line| line.strip_prefix("VmHWM:"))?.split_whitespace().next()?.parse().ok()
}
