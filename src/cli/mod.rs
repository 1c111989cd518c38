//! What can be asked on the command line?

mod accuracy;
mod angle;
mod answer;
mod atlas;
mod bearings;
mod check;
mod choice;
mod classify;
mod closed;
mod compare;
mod cycle;
mod exercise;
mod failure;
mod figure;
mod firing;
mod flywheel;
mod folder;
mod language;
mod layouts;
mod list;
mod loads;
mod lock;
mod man;
mod mark;
mod masses;
mod measures;
mod moments;
mod mounts;
mod notation;
mod optimise;
mod orders;
mod pages;
mod pieces;
mod progress;
mod questions;
mod remedy;
mod report;
mod rotor;
mod schema;
mod search;
mod stars;
mod sweep;
mod tables;
mod torque;
mod torsion;
mod values;
mod verify;
mod weigh;
mod write;

use std::ffi::OsString;

use clap::{Arg, CommandFactory, FromArgMatches, Parser, Subcommand};

use crankstar::text;
use failure::Failure;

/// Decides exactly how a reciprocating engine balances, and writes the proof.
#[derive(Parser)]
#[command(version, after_help = EXAMPLES, max_term_width = 80)]
struct Arguments {
    /// Print neither warnings nor progress, only errors
    #[arg(long, global = true)]
    quiet: bool,
    #[command(subcommand)]
    command: Command,
}

const EXAMPLES: &str = "\
Examples:
  crankstar list                                     the engines known by name
  crankstar classify V8-crossplane                   a table of verdicts
  crankstar classify my-engine.toml --orders 1,2,4   a layout file of your own
  crankstar report I4 --output I4-report             a report with its pictures
  crankstar search --cylinders 8 --cycle two-stroke  the best crank stars
  crankstar compare I5-12453 I5-15234 V6-60-even     engines side by side
  crankstar sweep V6-60-shared --bank-angle 0..180:10 --output V6
  crankstar classify I4 --json > i4.json && crankstar verify i4.json

A layout file in its shortest form:
  title = \"In-line four\"
  [inline]
  throws = [0, 180, 180, 0]

Exit status: 0 done, whatever the verdicts are; 1 the input is wrong,
a certificate fails or a claim does not hold; 2 wrong usage.";

/// The commands as `--help` lists them; [`questions`] says which question begins where.
#[derive(Subcommand)]
enum Command {
    /// List the engines known by name, with their lowest residual order
    List(list::List),
    /// Write the catalogue and the best in-line stars, or a poster
    Atlas(atlas::Atlas),
    /// Decide force and moment, order by order
    Classify(classify::Classify),
    /// Decide the orders of the gas torque by their firing stars
    Firing(firing::Firing),
    /// Write the report, with pictures and proofs
    Report(report::Report),
    /// Write one drawing, for a document of your own
    Figure(figure::Figure),
    /// Compute forces, moments and torque in newtons
    Loads(loads::Loads),
    /// Compute the loads of the main bearings
    Bearings(bearings::Bearings),
    /// Compute the torque of gas and inertia, and the flywheel
    Torque(torque::Torque),
    /// Find the flywheel that a turning-moment diagram needs
    Flywheel(flywheel::Flywheel),
    /// Compute motion, forces and torque at crank angles
    Angle(angle::Angle),
    /// List external and guide-force moments, as a project guide does
    Moments(moments::Moments),
    /// Find natural frequencies and critical speeds of torsion
    Torsion(torsion::Torsion),
    /// Compute how an engine shakes on its mounts
    Mounts(mounts::Mounts),
    /// Compare methods for the peak loads: error, guarantee and time
    Accuracy(accuracy::Accuracy),
    /// Find counterweights and balancer shafts that cancel the residual
    Remedy(remedy::Remedy),
    /// Find the counterweights with the smallest bearing loads
    Optimise(optimise::Optimise),
    /// Find the masses that balance a shaft, a rotor or a locomotive
    Rotor(rotor::Rotor),
    /// Vary the bank angle, or any value of a layout file
    Sweep(sweep::Sweep),
    /// Compare engines: sizes and cures, exact verdicts
    Compare(compare::Compare),
    /// Tabulate any values of engines, by their names
    Values(values::Values),
    /// Find the crank stars that balance best
    Search(search::Search),
    /// Show which moments crank stars can balance, with proofs
    Stars(stars::Stars),
    /// Check claims about engines: of books, of homework
    Check(check::Check),
    /// Check a JSON document of this program and its certificates
    Verify(verify::Verify),
    /// Write an exercise with solutions, other numbers for each student
    Exercise(exercise::Exercise),
    /// Mark the tables that a class hands in
    Mark(mark::Mark),
    /// Print completions for a shell
    Completions {
        /// Which shell
        shell: clap_complete::Shell,
    },
    /// Write the pages of the manual
    Man(man::Man),
    /// Print the JSON Schema of layout files, or of a document
    Schema(schema::Schema),
}

/// Answers a command line, whose first word is the name of the program; the exit status.
pub fn run(arguments: impl Iterator<Item = OsString>) -> u8 {
    let done = |()| 0;
    let Arguments { quiet, command } = match asked(loads::spelled_out(arguments)) {
        Ok(asked) => asked,
        Err(told) if told.use_stderr() => return misused(&told),
        Err(help) => return ended(write::to_stdout(&help.render().ansi().to_string()).map(done)),
    };
    if quiet {
        progress::silence();
    }
    progress::doing("computing");
    let answer = match command {
        Command::List(list) => list.run().map(done),
        Command::Atlas(atlas) => atlas.run().map(done),
        Command::Classify(classify) => classify.run().map(done),
        Command::Firing(firing) => firing.run().map(done),
        Command::Report(report) => report.run().map(done),
        Command::Figure(figure) => figure.run().map(done),
        Command::Loads(loads) => loads.run().map(done),
        Command::Bearings(bearings) => bearings.run().map(done),
        Command::Torque(torque) => torque.run().map(done),
        Command::Flywheel(flywheel) => flywheel.run().map(done),
        Command::Angle(angle) => angle.run().map(done),
        Command::Moments(moments) => moments.run().map(done),
        Command::Torsion(torsion) => torsion.run().map(done),
        Command::Mounts(mounts) => mounts.run().map(done),
        Command::Accuracy(accuracy) => accuracy.run().map(done),
        Command::Remedy(remedy) => remedy.run().map(done),
        Command::Optimise(optimise) => optimise.run().map(done),
        Command::Rotor(rotor) => rotor.run().map(done),
        Command::Sweep(sweep) => sweep.run().map(done),
        Command::Compare(compare) => compare.run().map(done),
        Command::Values(values) => values.run().map(done),
        Command::Search(search) => search.run().map(done),
        Command::Stars(stars) => stars.run().map(done),
        Command::Check(check) => check.run(),
        Command::Verify(verify) => verify.run().map(done),
        Command::Exercise(exercise) => exercise.run().map(done),
        Command::Mark(mark) => mark.run().map(done),
        Command::Completions { shell } => completions(shell).map(done),
        Command::Man(man) => man.run(Arguments::command()).map(done),
        Command::Schema(schema) => schema.run().map(done),
    };
    ended(answer)
}

/// The exit status; why there is no answer is reported.
fn ended(answer: Result<u8, Failure>) -> u8 {
    match answer {
        Ok(status) => status,
        Err(failure) => {
            write::to_stderr(&failure.to_string());
            failure.status()
        }
    }
}

/// What is asked for, read with the help that groups the commands.
fn asked(arguments: Vec<OsString>) -> Result<Arguments, clap::Error> {
    // A value below 0 is refused by who reads it, with what would be right.
    let signed = |option: Arg| match option.is_positional() || !option.get_action().takes_values() {
        true => option,
        false => option.allow_negative_numbers(true),
    };
    let program = Arguments::command().mut_subcommands(|command| command.mut_args(signed));
    let asked = questions::by_question(program).try_get_matches_from(arguments)?;
    Arguments::from_arg_matches(&asked)
}

/// Tells what is wrong with the arguments, which may be repeated in it.
fn misused(told: &clap::Error) -> u8 {
    write::to_stderr(text::harmless_lines(&in_words(&told.render().to_string())).trim_end());
    2
}

/// What readers of numbers say, in the words of a person.
fn in_words(told: &str) -> String {
    let said = [
        ("invalid digit found in string", "a whole number is needed, without sign and unit"),
        ("cannot parse integer from empty string", "a whole number is needed"),
        ("invalid float literal", "a number is needed, such as 0.5, without a unit"),
        ("cannot parse float from empty string", "a number is needed"),
        ("number too large to fit in target type", "this number is too large"),
    ];
    let told = said.iter().fold(told.to_owned(), |told, (said, words)| told.replace(said, words));
    // No layout is named as an option is.
    let told = told.split("\n\n").filter(|part| !part.starts_with("  tip: to pass '")).collect::<Vec<_>>().join("\n\n");
    let range = told.split_once(" is not in ").and_then(|(before, after)| Some((before, after.split_once("..=")?)));
    range.map_or(told.clone(), |(before, (least, rest))| format!("{before} is not from {least} to {rest}"))
}

fn completions(shell: clap_complete::Shell) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "crankstar", &mut script);
    write::to_stdout(&String::from_utf8_lossy(&script))
}
