//! `search`: which crank stars balance best?

use std::ops::ControlFlow;
use std::path::PathBuf;

use clap::ValueEnum;
use comfy_table::Table;
use comfy_table::presets::UTF8_HORIZONTAL_ONLY;

use crankstar::engine;
use crankstar::exact::Turn;
use crankstar::file::parse_angle;
use crankstar::search::{self, Front, FrontDocument, MomentDocument, Options, Problem, Progress, StarDocument};

use super::failure::Failure;
use super::{print_json, progress, write};

/// Arguments of `search`.
#[derive(clap::Args)]
pub struct Search {
    /// Number of cylinders
    #[arg(long)]
    cylinders: u32,
    /// The working cycle
    #[arg(long, value_enum)]
    cycle: Cycle,
    /// The orders whose moments are compared
    #[arg(long, value_delimiter = ',', default_value = "1,2")]
    orders: Vec<u32>,
    /// A V of this many degrees on shared pins, instead of an in-line engine
    #[arg(long, value_name = "DEGREES")]
    bank_angle: Option<String>,
    /// For a V: the number of different directions of its pins [default: one per pin]
    #[arg(long, value_name = "COUNT")]
    directions: Option<u32>,
    /// Throws at any multiples of 1/N turn, as often as they like, with balanced first-order force
    #[arg(long, value_name = "N")]
    grid: Option<u32>,
    /// Compare by neighbours that fire in succession too
    #[arg(long)]
    neighbours: bool,
    /// Keep every finished piece in this file, and go on from it; interrupt at will
    #[arg(long, value_name = "FILE")]
    resume: Option<PathBuf>,
    /// Number of threads [default: one per core]
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Print the front as JSON
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Cycle {
    /// Every cylinder fires once a revolution
    TwoStroke,
    /// Every cylinder fires once in two revolutions
    FourStroke,
}

impl Search {
    /// Searches, and prints the front.
    pub fn run(&self) -> Result<(), Failure> {
        let problem = self.problem()?;
        let bar = progress::bar("pieces");
        let progress = |progress: Progress| {
            bar.set_length(progress.pieces as u64);
            bar.set_position(progress.done as u64);
            ControlFlow::Continue(())
        };
        let usual = Options::default();
        let threads = self.threads.map_or(usual.threads, usize::from);
        let options = Options { threads, resume: self.resume.clone(), progress: &progress };
        let front = search::search(&problem, &options);
        bar.finish_and_clear();
        let front = front.map_err(Failure::new)?;
        let document = search::document(&front);
        if self.json {
            return print_json(&document);
        }
        write::to_stdout(&table(&front, &document))
    }

    fn problem(&self) -> Result<Problem, Failure> {
        let cycle = match self.cycle {
            Cycle::TwoStroke => engine::Cycle::TwoStroke,
            Cycle::FourStroke => engine::Cycle::FourStroke,
        };
        let mut orders = self.orders.clone();
        orders.sort_unstable();
        orders.dedup();
        let degrees = |text: &String| {
            let turns = parse_angle(text).map_err(|right| Failure::new(format!("--bank-angle `{text}`: {right}")))?;
            Ok::<_, Failure>(Turn::new(turns))
        };
        let bank_angle = self.bank_angle.as_ref().map(degrees).transpose()?;
        let (directions, grid, neighbours) = (self.directions, self.grid, self.neighbours);
        Ok(Problem { cylinders: self.cylinders, cycle, bank_angle, directions, grid, orders, neighbours })
    }
}

fn table(front: &Front, document: &FrontDocument) -> String {
    let mut table = Table::new();
    table.load_style(UTF8_HORIZONTAL_ONLY);
    let with_neighbours = document.neighbours;
    let mut header = vec!["Firing order".to_owned(), "Throws (°)".to_owned()];
    header.extend(document.stars.first().into_iter().flat_map(|star| star.moments.iter().map(moment_title)));
    header.extend(with_neighbours.then(|| "Neighbours".to_owned()));
    header.push("Stars".to_owned());
    table.set_header(header);
    for (star, found) in document.stars.iter().zip(&front.stars) {
        table.add_row(row(star, found, with_neighbours));
    }
    let spread = match document.stars.is_empty() {
        true => "No star has balanced first-order force.\n".to_owned(),
        false => {
            let of_vees = if front.problem.bank_angle.is_some() { LEGEND_OF_VEES } else { "" };
            format!("{table}\n{LEGEND}\n{of_vees}")
        }
    };
    let Front { all, judged, cut, .. } = front;
    format!(
        "{}, {}: the best of {all} stars by the moments of orders {}\n{spread}Judged one by one: {judged}; starts left out by the bound: {cut}.\n",
        document.engine,
        document.cycle,
        document.orders.iter().map(u32::to_string).collect::<Vec<_>>().join(", "),
    )
}

const LEGEND: &str = "\
Moments about the mid-plane, in m r ω² c_k times the spacing; = exact, ≈ decimal. No other star is as good in all and better in one.
Stars: how many share these values, up to rotation, mirror and reversal.";

const LEGEND_OF_VEES: &str = "C⁺ and C⁻ are the direct and the reverse vector: the largest moment is half their sum.\n";

fn moment_title(moment: &MomentDocument) -> String {
    let order = moment.order;
    match moment.sense {
        None => format!("M{order}"),
        Some(crankstar::proof::Sense::Direct) => format!("C{order}⁺"),
        Some(crankstar::proof::Sense::Reverse) => format!("C{order}⁻"),
    }
}

fn row(star: &StarDocument, found: &search::FoundStar, with_neighbours: bool) -> Vec<String> {
    let throws: Vec<String> = found.throws.iter().map(|throw| throw.degrees().to_string()).collect();
    let order = star.firing_order.clone().unwrap_or_else(|| "uneven".to_owned());
    let moment = |moment: &MomentDocument| match moment.exact.as_deref() {
        Some(exact) if exact.parse::<i64>().is_ok() => format!("= {exact}"),
        Some(exact) if exact.chars().count() <= LONGEST_FORM => format!("= {exact} ≈ {:.4}", moment.decimal),
        _ => format!("≈ {:.4}", moment.decimal),
    };
    let mut row = vec![order, throws.join(" ")];
    row.extend(star.moments.iter().map(moment));
    row.extend(with_neighbours.then(|| star.neighbours.map_or_else(String::new, |count| count.to_string())));
    row.push(star.classes.to_string());
    row
}

/// Longer closed forms are left to the JSON.
const LONGEST_FORM: usize = 24;
