//! How is a point of a sweep computed, and how a million of them? Piece by piece, each by itself, so that no more than a few are in memory.

use std::collections::BTreeSet;

use num_rational::BigRational;

use super::firing::{FiringSweep, StarLength, can_be_judged, lengths};
use super::multiples::Multiples;
use super::observed::{Observed, ObservedSweep, Observer};
use super::parameter::Parameter;
use super::range::MOST_COUNTED;
use super::reader::Reader;
use super::record::Sweep;
use super::swept_engine::{Motions, SweptEngine, judge_with};
use super::{Geometry, SweepError};
use crate::engine::{CycleOrder, Engine};
use crate::file::Template;
use crate::loads;
use crate::shard::Question;

/// The fewest and the most points of a piece, and how many pieces there are between.
const FEWEST: usize = 256;
const MOST: usize = 4096;
const PIECES: usize = 64;
/// What the words of a question begin with: another number where a piece changes.
const VERSION: &str = concat!("sweep 2 of crankstar ", env!("CARGO_PKG_VERSION"));

/// What a sweep asks, to be computed in pieces or whole.
pub struct Stream<'a> {
    pub(super) template: Template<'a>,
    pub(super) reader: Reader<'a>,
    pub(super) parameters: &'a [Parameter],
    firing: Vec<CycleOrder>,
    observer: Option<Observer<'a>>,
    count: usize,
    /// Points of a piece: a number that follows from the question alone.
    points: usize,
    /// What all points are counted in.
    multiples: Multiples,
    /// The sweep without its points.
    empty: Sweep,
}

impl<'a> Stream<'a> {
    /// A sweep over one or two parameters at these orders; at those of the file where none are given. The firing stars of these
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
        // What the first point has not, an offset of 0, the middle or the last one has.
        let others = [count / 2, count - 1].map(|index| reader.engine(&reader.values(index)).ok());
        let some = || std::iter::once(&first).chain(others.iter().flatten());
        let usual = || some().flat_map(loads::usual_orders).collect::<Vec<u32>>();
        let orders = rising(&if orders.is_empty() { usual() } else { orders.to_vec() });
        let firing = rising(firing);
        let star = FiringSweep { orders: firing.clone(), points: Vec::new(), curve: Vec::new(), zeros: None };
        let empty = Sweep::without_points(&first, parameters, orders, geometry);
        let dead_centres_apart = some().any(Engine::has_dead_centres_apart);
        let empty = Sweep { firing: (!firing.is_empty()).then_some(star), dead_centres_apart, ..empty };
        let points = count.div_ceil(PIECES).clamp(FEWEST, MOST);
        let (template, multiples) = (template.clone(), Multiples::of(&first));
        Ok(Stream { template, reader, parameters, firing, observer: None, count, points, multiples, empty })
    }

    /// The same with values of other questions beside each point, where they are asked for.
    ///
    /// # Errors
    /// A first point that lacks one.
    pub fn observing(mut self, observer: Option<Observer<'a>>) -> Result<Self, SweepError> {
        if let Some(observer) = &observer {
            self.empty.observed = Some(ObservedSweep::new(observer, &self.reader.engine(&self.reader.values(0))?)?);
        }
        self.observer = observer;
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
        let values = self.observer.as_ref().map_or_else(String::new, |of| format!("values {}; ", of.names.join(", ")));
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
        Ok(self.of((from..to).map(|index| self.point(index, &mut motions)).collect::<Result<_, SweepError>>()?))
    }

    /// How many points a core has at least: values of other questions take long.
    pub(super) fn fewest(&self) -> usize {
        if self.observer.is_some() { 1 } else { 64 }
    }

    /// The balance with these values, and the engine that has it.
    pub(super) fn swept(
        &self,
        values: Vec<BigRational>,
        motions: &mut Motions,
    ) -> Result<(SweptEngine, Engine), SweepError> {
        let Sweep { orders, geometry, .. } = &self.empty;
        let engine = self.reader.engine(&values)?;
        let judged = judge_with(&engine, self.reader.template.cycle(), orders, geometry, motions);
        let judged = judged.map_err(|missing| SweepError::new(missing.to_string()))?;
        let mut swept = SweptEngine { values, ..judged };
        if let Some(own) = self.own_multiples(&engine) {
            self.multiples.count(&mut swept, &own);
        }
        Ok((swept, engine))
    }

    /// The firing stars of an engine.
    pub(super) fn stars(&self, engine: &Engine) -> Vec<StarLength> {
        let mut stars = lengths(engine, &self.firing);
        if let Some(own) = self.own_multiples(engine) {
            self.multiples.count_stars(&mut stars, &own);
        }
        stars
    }

    /// What an engine by itself is counted in, where that is not what the sweep is.
    fn own_multiples(&self, engine: &Engine) -> Option<Multiples> {
        Some(Multiples::of(engine)).filter(|own| *own != self.multiples)
    }

    /// All that is asked of one point.
    pub(super) fn point(&self, index: usize, motions: &mut Motions) -> Result<Point, SweepError> {
        let (swept, engine) = self.swept(self.reader.values(index), motions)?;
        let observed = self.observer.as_ref().map_or_else(Vec::new, |observer| (observer.find)(&engine));
        let differs = self.own_multiples(&engine).is_some();
        Ok(Point { swept, stars: self.stars(&engine), observed, differs })
    }

    /// The sweep with these points.
    pub(super) fn of(&self, points: Vec<Point>) -> Sweep {
        let mut sweep = self.empty.clone();
        for Point { swept, stars, observed, differs } in points {
            if differs {
                sweep.multiples = Some(self.multiples.clone());
            }
            sweep.points.push(swept);
            if let Some(firing) = &mut sweep.firing {
                firing.points.push(stars);
            }
            if let Some(all) = &mut sweep.observed {
                all.points.push(observed);
            }
        }
        sweep
    }
}

/// What is known of a point.
pub(super) struct Point {
    swept: SweptEngine,
    stars: Vec<StarLength>,
    observed: Observed,
    /// Whether its own m and r are not those that it is counted in.
    differs: bool,
}

/// Each once.
fn rising<T: Ord + Copy>(all: &[T]) -> Vec<T> {
    all.iter().copied().collect::<BTreeSet<T>>().into_iter().collect()
}

/// What is said of a sweep without a range.
pub const NOTHING_SWEPT: &str = "nothing is swept; give --bank-angle 0..180:10 or --set KEY=FROM..TO:STEP";

/// How many points a sweep over these parameters has.
fn count(parameters: &[Parameter]) -> Result<usize, SweepError> {
    let too_many = || SweepError::new(format!("the map has more than {MOST_COUNTED} points; take larger steps"));
    match parameters {
        [] => Err(SweepError::new(NOTHING_SWEPT)),
        [one] => Ok(one.range.count()),
        [one, other] if one.key == other.key => {
            Err(SweepError::new(format!("`{}` is swept twice; two different keys make a map", one.key)))
        }
        [one, other] => {
            let count = one.range.count().checked_mul(other.range.count());
            count.filter(|count| *count <= MOST_COUNTED).ok_or_else(too_many)
        }
        several => Err(SweepError::new(format!("{} parameters are swept; one makes curves, two a map", several.len()))),
    }
}
