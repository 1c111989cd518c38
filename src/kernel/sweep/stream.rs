//! How is a sweep of a million points computed? Piece by piece, each by itself, so that no more than a few are in memory.

use super::firing::{FiringSweep, can_be_judged, lengths};
use super::observed::{ObservedSweep, Observer};
use super::parameter::Parameter;
use super::reader::Reader;
use super::run::{Sweep, count};
use super::swept_engine::Motions;
use super::{Geometry, SweepError};
use crate::engine::CycleOrder;
use crate::file::Template;
use crate::loads;
use crate::shard::Question;

/// The fewest and the most points of a piece, and how many pieces there are between.
const FEWEST: usize = 256;
const MOST: usize = 4096;
const PIECES: usize = 64;
/// What the words of a question begin with: another number where a piece changes.
const VERSION: &str = concat!("sweep 1 of crankstar ", env!("CARGO_PKG_VERSION"));

/// A sweep that is computed in pieces.
pub struct Stream<'a> {
    reader: Reader<'a>,
    parameters: &'a [Parameter],
    firing: Vec<CycleOrder>,
    observer: Option<Observer<'a>>,
    count: usize,
    /// Points of a piece: a number that follows from the question alone.
    points: usize,
    /// The sweep without its points.
    empty: Sweep,
}

impl<'a> Stream<'a> {
    /// A sweep over one or two parameters at these orders, rising; at those of the file where none are given. The firing stars of these
    /// orders of the cycle are evaluated beside them.
    ///
    /// # Errors
    /// More than two parameters or none, a first layout that cannot be read, or a firing order of which the file does not tell enough.
    pub fn new(
        template: &Template<'a>,
        parameters: &'a [Parameter],
        orders: &[u32],
        firing: &[CycleOrder],
        geometry: &Geometry,
    ) -> Result<Self, SweepError> {
        let count = count(parameters)?;
        can_be_judged(template, firing)?;
        let reader = Reader::new(template, parameters);
        let first = reader.engine(&reader.values(0))?;
        let orders = if orders.is_empty() { loads::usual_orders(&first) } else { orders.to_vec() };
        let star = FiringSweep { orders: firing.to_vec(), points: Vec::new(), curve: Vec::new(), zeros: None };
        let empty = Sweep::without_points(&first, parameters, orders, geometry);
        let empty = Sweep { firing: (!firing.is_empty()).then_some(star), ..empty };
        let points = count.div_ceil(PIECES).clamp(FEWEST, MOST);
        Ok(Stream { reader, parameters, firing: firing.to_vec(), observer: None, count, points, empty })
    }

    /// The same with values of other questions beside each point.
    ///
    /// # Errors
    /// A first point that lacks one.
    pub fn observing(mut self, observer: Observer<'a>) -> Result<Self, SweepError> {
        self.empty.observed = Some(ObservedSweep::new(&observer, &self.reader.engine(&self.reader.values(0))?)?);
        self.observer = Some(observer);
        Ok(self)
    }

    /// How many points it has.
    pub fn count(&self) -> usize {
        self.count
    }

    /// What is asked, in words that no other sweep shares, and its number of pieces. `file` is the text of the layout.
    pub fn question(&self, file: &str) -> Question {
        let ranges = self.parameters.iter().map(|parameter| {
            let (range, gives_way) = (&parameter.range, parameter.instead_of.join(" "));
            let ends = (range.value(0), range.last());
            format!(
                "{}={}..{} {}, {} values, for {gives_way}",
                parameter.key,
                ends.0,
                ends.1,
                range.unit(),
                range.count()
            )
        });
        let ranges: Vec<String> = ranges.collect();
        let firing: Vec<String> = self.firing.iter().map(ToString::to_string).collect();
        let (orders, geometry) = (&self.empty.orders, &self.empty.geometry);
        let (ranges, firing, points) = (ranges.join("; "), firing.join(","), self.points);
        let values =
            self.observer.map_or_else(String::new, |observer| format!("values {}; ", observer.names.join(", ")));
        let words = format!(
            "{VERSION}: {ranges}; orders {orders:?}; firing orders {firing}; {values}{points} points a piece; {geometry:?}; {file}"
        );
        Question { words, pieces: self.count.div_ceil(self.points) }
    }

    /// The sweep of the first point alone: what all have in common.
    ///
    /// # Errors
    /// A first layout that cannot be read.
    pub fn first(&self) -> Result<Sweep, SweepError> {
        self.between(0, 1)
    }

    /// The sweep of one piece; of none where there is no such piece. It has neither a curve nor zeros.
    ///
    /// # Errors
    /// The first layout that cannot be read.
    pub fn piece(&self, number: usize) -> Result<Sweep, SweepError> {
        let from = self.count.min(number.saturating_mul(self.points));
        self.between(from, self.count.min(from.saturating_add(self.points)))
    }

    fn between(&self, from: usize, to: usize) -> Result<Sweep, SweepError> {
        let mut motions = Motions::default();
        let mut sweep = self.empty.clone();
        sweep.points.reserve(to - from);
        for index in from..to {
            let values = self.reader.values(index);
            let point = self.reader.point(&values, &sweep.orders, &sweep.geometry, &mut motions)?;
            if let Some(firing) = &mut sweep.firing {
                firing.points.push(lengths(&self.reader, &values, &self.firing)?);
            }
            if let (Some(observed), Some(observer)) = (&mut sweep.observed, self.observer) {
                observed.points.push((observer.find)(&self.reader.engine(&values)?));
            }
            sweep.points.push(point);
        }
        Ok(sweep)
    }
}
