//! How long does a person wait for `classify`, `report` and the other commands? Over random engines of every form.
//!
//! `cargo bench -p benches --bench random_engines [-- COUNT [COMMAND]]`. Each engine is a layout file at whole degrees with up to 24 cylinders; the
//! program, of `cargo build --release` or the one that `CRANKSTAR` names, is run on it as from a shell, alone, and what is printed
//! is the median, the 95th percentile, and the slowest with its file.
#![allow(clippy::disallowed_types)]

#[path = "../tests/suite/support/dice.rs"]
#[allow(dead_code)]
mod dice;
#[path = "../tests/suite/support/whole_degrees.rs"]
mod whole_degrees;

use std::process::Command;
use std::time::{Duration, Instant};

use dice::Dice;

/// Commands that answer at once, with their arguments around the file.
const COMMANDS: [(&str, &[&str], &[&str]); 9] = [
    ("classify", &["classify"], &[]),
    ("classify --json", &["classify"], &["--json", "--torque"]),
    ("report", &["report"], &[]),
    ("loads", &["loads"], &[]),
    ("remedy", &["remedy"], &[]),
    ("bearings", &["bearings"], &[]),
    ("compare", &["compare", "V8-crossplane"], &[]),
    ("sweep", &["sweep"], &["--rod-ratio", "0.2..0.3:0.02"]),
    ("check", &["check"], &[]),
];

/// What `check` is asked of each engine.
const CLAIMS: &str = "[[claim]]\nlayout = \"engine.toml\"\nsays = \"second-order moment = √3\"\n\
    [[claim]]\nlayout = \"engine.toml\"\nsays = \"every order of the force vanishes\"\n";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1).filter(|argument| !argument.starts_with("--"));
    let count = arguments.next().map_or(Ok(300), |text| text.parse())?;
    let only = arguments.next();
    let folder = std::env::temp_dir().join(format!("crankstar-bench-{}", std::process::id()));
    std::fs::create_dir_all(&folder)?;
    println!("{count} engines of up to 24 cylinders; milliseconds\n");
    println!("{:<16} {:>6} {:>8} {:>8} {:>8}", "command", "ends 0", "median", "95 %", "slowest");
    let mut slowest_files = Vec::new();
    for (name, before, after) in COMMANDS.into_iter().filter(|(name, ..)| only.as_ref().is_none_or(|only| only == name))
    {
        let mut dice = Dice::new(24);
        let mut runs = Vec::new();
        for index in 0..count {
            let file = whole_degrees::file(&mut dice, whole_degrees::FORMS[index % whole_degrees::FORMS.len()], 24);
            runs.push((run(&folder, &file, before, after)?, file));
        }
        let answered = runs.iter().filter(|((_, done), _)| *done).count();
        runs.sort_by_key(|((time, _), _)| *time);
        let at = |part: usize| milliseconds(runs[(runs.len() - 1) * part / 100].0.0);
        println!("{name:<16} {answered:>6} {:>8.1} {:>8.1} {:>8.1}", at(50), at(95), at(100));
        slowest_files.extend(runs.pop().map(|((time, _), file)| (name, time, file)));
    }
    for (name, time, file) in slowest_files {
        println!("\nslowest {name}, {:.1} ms:\n{file}", milliseconds(time));
    }
    std::fs::remove_dir_all(&folder)?;
    Ok(())
}

/// How long the program takes on a file, and whether it answers.
fn run(
    folder: &std::path::Path,
    file: &str,
    before: &[&str],
    after: &[&str],
) -> Result<(Duration, bool), std::io::Error> {
    let (engine, claims) = (folder.join("engine.toml"), folder.join("claims.toml"));
    std::fs::write(&engine, file)?;
    std::fs::write(&claims, CLAIMS)?;
    // Another program can be named, to compare.
    let built = concat!(env!("CARGO_MANIFEST_DIR"), "/../target/release/crankstar");
    let program = std::env::var("CRANKSTAR").unwrap_or_else(|_| built.to_owned());
    let mut command = Command::new(program);
    command.args(before).arg(if before == ["check"] { &claims } else { &engine }).args(after);
    let start = Instant::now();
    let output = command.output()?;
    Ok((start.elapsed(), output.status.success()))
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
