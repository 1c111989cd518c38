//! `optimise`: which counterweights are best?

use super::EngineAndOrders;
use super::failure::Failure;
use super::pages::Pages;

/// Arguments of `optimise`.
#[derive(clap::Args)]
pub struct Optimise {
    #[command(flatten)]
    about: EngineAndOrders,
    /// What may be left of the first-order couple that turns with the crank: zero, or a bound in N·m
    #[arg(long, value_name = "zero|N·m", default_value = "zero")]
    couple: String,
    /// How many points from the lightest crankshaft to that with the least load
    #[arg(long, default_value_t = 9, value_name = "COUNT")]
    points: usize,
    /// Print the points as JSON
    #[arg(long, conflicts_with = "output")]
    json: bool,
    #[command(flatten)]
    pages: Pages,
}

#[cfg(not(feature = "optimise"))]
impl Optimise {
    /// Says what the program lacks.
    pub fn run(&self) -> Result<(), Failure> {
        let Optimise { about: _, couple: _, points: _, json: _, pages: _ } = self;
        Err(Failure::new("this program was built without its optimiser; build it with --features optimise"))
    }
}

#[cfg(feature = "optimise")]
mod run {
    use std::collections::BTreeMap;
    use std::sync::Mutex;

    use crankstar::file::{Beside, Layout, parse_number};
    use crankstar::optimise::{Couple, Wish, front_beside};
    use crankstar::page::File;
    use crankstar::report;
    use num_traits::Signed;

    use super::super::{layouts, print_json, progress, write};
    use super::{Failure, Optimise};

    /// More points than this say nothing more.
    const MOST_POINTS: usize = 200;

    impl Optimise {
        /// Prints the front, and writes page and layout files into the folder.
        pub fn run(&self) -> Result<(), Failure> {
            let (layout, orders) = self.about.read_for_bearings()?;
            let Layout::Known(engine, _) = layout else {
                return Err(Failure::new(
                    "bearing loads need an engine without unknowns; give them values below [values]",
                ));
            };
            if self.points > MOST_POINTS {
                return Err(Failure::new(format!("{} points; ask for {MOST_POINTS} at most", self.points)));
            }
            let wish = Wish { couple: couple(&self.couple)?, points: self.points, orders };
            progress::doing("finding the best counterweights");
            // What the layout names beside itself stands beside the layouts that are written, too.
            let named = Mutex::new(BTreeMap::new());
            let read = |path: &str| {
                let text = layouts::beside(&self.about.layout, path)?;
                if let Ok(mut named) = named.lock() {
                    named.insert(path.to_owned(), text.clone());
                }
                Ok(text)
            };
            let front = front_beside(&engine, &wish, Beside::new(&read));
            let front = front.map_err(Failure::new)?;
            if self.json {
                return print_json(&report::optimise_document(&engine, &front, &wish.couple));
            }
            let page = || report::optimise_page(&engine, &front, &wish.couple);
            let beside = named.into_inner().unwrap_or_default().into_iter().map(|(name, text)| File { name, text });
            let written =
                self.pages.write(page, || report::optimise_layouts(&front).into_iter().chain(beside).collect())?;
            let answer = report::optimise_answer(&engine, &front, &wish.couple);
            write::to_stdout(&(self.pages.shown(&answer)? + &written))
        }
    }

    /// `zero`, or newton-metres.
    fn couple(text: &str) -> Result<Couple, Failure> {
        let text = text.trim();
        if text == "zero" {
            return Ok(Couple::Zero);
        }
        let unit = ["N·m", "N m", "Nm"].into_iter().find(|unit| text.ends_with(unit));
        let number = unit.map_or(text, |unit| text[..text.len() - unit.len()].trim_end());
        match parse_number(number) {
            Ok(most) if most.is_positive() => Ok(Couple::AtMost(most)),
            Ok(most) if most.is_negative() => Err(Failure::new("a couple is bounded by 0 N·m or more")),
            Ok(_) => Ok(Couple::Zero),
            Err(_) => Err(Failure::new(format!(
                "`{}` is no bound of a couple; write zero, or newton-metres such as 50",
                text.chars().take(40).collect::<String>()
            ))),
        }
    }
}
