//! `sweep`: how does the balance change with a value of the layout file?

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::sync::{Mutex, PoisonError};

use crankstar::engine::CycleOrder;
use crankstar::file::{self, Layout, Template};
use crankstar::report::{ValueName, observer};
use crankstar::shard::Question;
use crankstar::sweep::{self, Geometry, Parameter, Stream};

use super::answer::Answer;
use super::failure::Failure;
use super::orders::whole_order;
use super::pieces::Pieces;
use super::{layouts, progress, write};

/// Arguments of `sweep`.
#[derive(clap::Args)]
pub struct Sweep {
    /// A name of the catalogue, or the path of a layout file
    layout: PathBuf,
    #[command(flatten)]
    ranges: Ranges,
    /// The orders to decide [default: those of the layout file, else 1,2,4,6 and other large ones]
    #[arg(long, value_delimiter = ',', value_parser = whole_order)]
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
    /// How far the pin of bank 2 is ahead, in degrees; behind where the file says that the crank turns clockwise
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
        if let Some(wanted) = wanted.as_ref().filter(|_| !self.value.is_empty()) {
            wanted.tell_what_is_in("points", "--value");
        }
        self.pieces.are_kept_apart(self.answer.output())?;
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
        let then = |stream: &Stream, text: &str| then(stream, &stream.question(text));
        self.ranges.streamed(&self.layout, &self.orders, &self.firing_orders, &self.value, then)
    }
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
        self.streamed(layout, orders, firing, values, |stream, _| {
            progress::doing("sweeping");
            stream.whole(&AtomicBool::new(false)).map_err(Failure::new)
        })
    }

    /// What `then` makes of the sweep and of the text of its layout, with that of every file which the layout names.
    fn streamed<T>(
        &self,
        layout: &Path,
        orders: &[u32],
        firing: &[CycleOrder],
        values: &[ValueName],
        then: impl FnOnce(&Stream, &str) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        layouts::warn_of(layout);
        let (name, text) = layouts::source(layout)?;
        let named = Mutex::new(BTreeMap::new());
        let read = |path: &str| {
            let text = layouts::beside(layout, path)?;
            named.lock().unwrap_or_else(PoisonError::into_inner).insert(path.to_owned(), text.clone());
            Ok(text)
        };
        let template = Template::new(&name, &text)?.with_beside(layouts::resolver(layout, &read));
        let parameters = self.parameters(&template)?;
        let stream = Stream::new(&template, &parameters, orders, firing, &Geometry::default());
        let stream = stream.and_then(|stream| stream.observing(observer(values)));
        let stream = stream.map_err(Failure::new)?;
        let named = named.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let all = named.iter().fold(text.clone(), |all, (path, text)| format!("{all}; {path}: {text}"));
        then(&stream, &all)
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
        if !self.are_given() {
            return Err(Failure::misuse(sweep::NOTHING_SWEPT));
        }
        let given = self.flags().into_iter().filter_map(|(flag, range)| Some((flag, range?)));
        let short = given.map(|(flag, range)| Parameter::short_cut(flag, range, template));
        let set = self.set.iter().map(|text| Parameter::parse(text));
        let parameters: Vec<Parameter> = short.chain(set).collect::<Result<_, _>>().map_err(Failure::misuse)?;
        let first = |one: &Parameter| format!("{} {}", one.range.value(0), one.range.unit()).trim().to_owned();
        let first: Vec<String> = parameters.iter().map(first).collect();
        let values: Vec<_> = parameters.iter().zip(&first).map(|(one, text)| (&one.key, text.as_str())).collect();
        for odd in values.iter().filter_map(|(key, text)| file::odd_value(&key.to_string(), text, None)) {
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
