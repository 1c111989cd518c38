//! `sweep`: how does the balance change with a value of the layout file?

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crankstar::engine::{CycleOrder, Engine};
use crankstar::file::{self, Layout, Template};
use crankstar::report::{ValueName, values_of};
use crankstar::shard::Question;
use crankstar::sweep::{self, Geometry, Observer, Parameter, Stream};

use super::answer::Answer;
use super::failure::Failure;
use super::pieces::Pieces;
use super::{layouts, progress, write};

/// Arguments of `sweep`.
#[derive(clap::Args)]
pub struct Sweep {
    /// A name of the catalogue, or the path of a layout file
    layout: PathBuf,
    #[command(flatten)]
    ranges: Ranges,
    /// The orders to decide [default: those of the layout file, else 1,2,4,6]
    #[arg(long, value_delimiter = ',', value_parser = clap::value_parser!(u32).range(1..=i64::from(crankstar::engine::HIGHEST_ORDER)))]
    orders: Vec<u32>,
    /// Decide the firing stars, the orders of the gas torque, too: 1/2,1,3/2
    #[arg(long, value_delimiter = ',', value_name = "ORDERS")]
    firing_orders: Vec<CycleOrder>,
    /// A value of any question by its name, beside each point of the tables: bearings.worst.force, torsion.modes.1.frequency
    #[arg(long, value_name = "NAME")]
    value: Vec<ValueName>,
    #[command(flatten)]
    pieces: Pieces,
    #[command(flatten)]
    answer: Answer,
}

/// The values that are swept.
#[derive(clap::Args)]
pub struct Ranges {
    /// The angle between the banks of a V: 0..180:10
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    bank_angle: Option<String>,
    /// How far the pin of bank 2 is ahead, in degrees
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    pin_split: Option<String>,
    /// The distance between neighbouring pins: "80..120:5 mm"
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    spacing: Option<String>,
    /// The rod ratio r/l
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    rod_ratio: Option<String>,
    /// The balance factor of the counterweights
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    balance_factor: Option<String>,
    /// The speed in revolutions per minute
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    speed: Option<String>,
    /// Any key of the layout file, with its unit: "mechanism.rod_length=120..160:5 mm", vee.throws.2=0..120:10; a second sweep makes a map
    #[arg(long, value_name = "KEY=RANGE")]
    set: Vec<String>,
}

impl Sweep {
    /// Prints the points, or writes the page into the folder.
    pub fn run(&self) -> Result<(), Failure> {
        if let Some(shard) = self.pieces.shard()? {
            let output = self.answer.nothing_but_output("--shard")?;
            return self.streamed(|stream, question| self.pieces.keep(stream, question, shard, output));
        }
        let wanted = self.answer.wanted("sweep")?;
        if let Some(output) = self.pieces.merged_into_one(self.answer.output()) {
            return self.streamed(|_, question| self.pieces.merge(question, output));
        }
        if let Some(wanted) = wanted.as_ref().filter(|wanted| wanted.is_streamed("points")) {
            return self.streamed(|stream, question| self.pieces.write(stream, question, wanted));
        }
        self.pieces.are_for_tables()?;
        self.answer
            .give("sweep", false, || self.ranges.sweep(&self.layout, &self.orders, &self.firing_orders, &self.value))
    }

    /// Sweeps for a table of any length, which `then` writes.
    fn streamed(&self, then: impl FnOnce(&Stream, &Question) -> Result<(), Failure>) -> Result<(), Failure> {
        layouts::warn_of(&self.layout);
        let (name, text) = layouts::source(&self.layout)?;
        let read = |path: &str| layouts::beside(&self.layout, path);
        let template = Template::new(&name, &text)?.with_beside(layouts::resolver(&self.layout, &read));
        let parameters = self.ranges.parameters(&template)?;
        let (orders, firing) = (rising(&self.orders), rising(&self.firing_orders));
        let stream = Stream::new(&template, &parameters, &orders, &firing, &Geometry::default());
        let (names, find) = (named(&self.value), |engine: &Engine| values_of(engine, &self.value));
        let stream = stream.and_then(|stream| match self.value.is_empty() {
            true => Ok(stream),
            false => stream.observing(Observer { names: &names, find: &find }),
        });
        let stream = stream.map_err(Failure::new)?;
        then(&stream, &stream.question(&text))
    }
}

/// What these values are called.
fn named(values: &[ValueName]) -> Vec<String> {
    values.iter().map(ValueName::to_string).collect()
}

impl Ranges {
    /// Whether some value is swept.
    pub fn are_given(&self) -> bool {
        !self.set.is_empty() || self.flags().iter().any(|(_, range)| range.is_some())
    }

    /// Sweeps a layout.
    pub fn sweep(
        &self,
        layout: &Path,
        orders: &[u32],
        firing: &[CycleOrder],
        values: &[ValueName],
    ) -> Result<sweep::Sweep, Failure> {
        layouts::warn_of(layout);
        let (name, text) = layouts::source(layout)?;
        let read = |path: &str| layouts::beside(layout, path);
        let template = Template::new(&name, &text)?.with_beside(layouts::resolver(layout, &read));
        let parameters = self.parameters(&template)?;
        let orders = rising(orders);
        progress::doing("sweeping");
        let sweep = sweep::sweep(&template, &parameters, &orders, &Geometry::default());
        let sweep = sweep.and_then(|mut sweep| {
            let firing = rising(firing);
            if !firing.is_empty() {
                sweep.firing = Some(sweep::firing_stars(&template, &sweep, &firing)?);
            }
            if !values.is_empty() {
                let (names, find) = (named(values), |engine: &Engine| values_of(engine, values));
                sweep.observed = Some(sweep::observed(&template, &sweep, &Observer { names: &names, find: &find })?);
            }
            Ok(sweep)
        });
        sweep.map_err(Failure::new)
    }

    fn flags(&self) -> [(&'static str, Option<&String>); 6] {
        [
            ("bank-angle", self.bank_angle.as_ref()),
            ("pin-split", self.pin_split.as_ref()),
            ("spacing", self.spacing.as_ref()),
            ("rod-ratio", self.rod_ratio.as_ref()),
            ("balance-factor", self.balance_factor.as_ref()),
            ("speed", self.speed.as_ref()),
        ]
    }

    /// The sweeps of the flags, then those of the keys.
    fn parameters(&self, template: &Template) -> Result<Vec<Parameter>, Failure> {
        let given = self.flags().into_iter().filter_map(|(flag, range)| Some((flag, range?)));
        let short = given.map(|(flag, range)| Parameter::short_cut(flag, range, template));
        let set = self.set.iter().map(|text| Parameter::parse(text));
        let parameters: Vec<Parameter> = short.chain(set).collect::<Result<_, _>>().map_err(Failure::new)?;
        let first = |one: &Parameter| format!("{} {}", one.range.value(0), one.range.unit()).trim().to_owned();
        let first: Vec<String> = parameters.iter().map(first).collect();
        let values: Vec<_> = parameters.iter().zip(&first).map(|(one, text)| (&one.key, text.as_str())).collect();
        for odd in values.iter().filter_map(|(key, text)| file::odd_value(key.name(), text)) {
            write::warn(&format!("warning: {odd}"));
        }
        // What is wrong with the engine is reported by whoever reads it.
        if let Ok(Layout::Known(engine, _)) = template.layout(&values)
            && let Some(odd) = file::odd_position(&engine)
        {
            write::warn(&format!("warning: {odd}"));
        }
        Ok(parameters)
    }
}

/// Each once.
fn rising<T: Ord + Copy>(all: &[T]) -> Vec<T> {
    all.iter().copied().collect::<BTreeSet<T>>().into_iter().collect()
}
