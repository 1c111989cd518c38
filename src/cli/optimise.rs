//! `optimise`: which counterweights are best?

use super::answer::Answer;
use super::failure::Failure;
use super::orders::EngineAndOrders;

/// Arguments of `optimise`.
#[derive(clap::Args)]
pub struct Optimise {
    #[command(flatten)]
    about: EngineAndOrders,
    /// Largest residual first-order couple that turns with the crank: zero, or a bound in N·m
    #[arg(long, value_name = "zero|N·m", default_value = "zero")]
    couple: String,
    /// How many points from the lightest crankshaft to that with the least load
    #[arg(long, default_value_t = 9, value_name = "COUNT")]
    points: usize,
    /// Print the points as JSON
    #[arg(long, conflicts_with_all = ["output", "format"])]
    json: bool,
    #[command(flatten)]
    answer: Answer,
}

#[cfg(not(feature = "optimise"))]
impl Optimise {
    /// Says what the program lacks.
    pub fn run(&self) -> Result<(), Failure> {
        let Optimise { about: _, couple: _, points: _, json: _, answer: _ } = self;
        Err(Failure::new("this program was built without its optimiser; build it with --features optimise"))
    }
}

#[cfg(feature = "optimise")]
mod run {
    use std::collections::BTreeMap;
    use std::sync::Mutex;

    use crankstar::optimise::Request;
    use crankstar::page::File;
    use crankstar::report::OptimiseStudy;

    use super::super::{layouts, progress};
    use super::{Failure, Optimise};

    impl Optimise {
        /// Prints the front, and writes page and layout files into the folder.
        pub fn run(&self) -> Result<(), Failure> {
            self.answer.give("optimise", self.json, || {
                let (layout, orders) = self.about.read_for_bearings()?;
                let engine = layouts::without_unknowns(layout, "bearing loads need")?;
                let couple = self.couple.parse().map_err(Failure::new)?;
                progress::doing("finding the best counterweights");
                // What the layout names beside itself is beside the layouts that are written, too.
                let named = Mutex::new(BTreeMap::new());
                let read = |path: &str| {
                    let text = layouts::beside(&self.about.layout, path)?;
                    if let Ok(mut named) = named.lock() {
                        named.insert(path.to_owned(), text.clone());
                    }
                    Ok(text)
                };
                let request = Request { couple, points: self.points, orders };
                let study = OptimiseStudy::new(&engine, request, layouts::resolver(&self.about.layout, &read))
                    .map_err(Failure::new)?;
                let named = named.into_inner().unwrap_or_default();
                Ok(OptimiseStudy {
                    files: named.into_iter().map(|(name, text)| File { name, text }).collect(),
                    ..study
                })
            })
        }
    }
}
