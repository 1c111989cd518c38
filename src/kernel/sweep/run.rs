//! How is a sweep computed whole, for a page? On all cores, with its curve and exact zeros.

use std::collections::BTreeSet;
use std::sync::atomic::AtomicBool;

use num_rational::BigRational;

use super::SweepError;
use super::envelope::Geometry;
use super::firing::found;
use super::opened::{is_angle, zeros};
use super::parameter::Parameter;
use super::range::MOST_POINTS;
use super::reader::on_all_cores;
use super::record::Sweep;
use super::stream::Stream;
use super::swept_engine::{Motions, SweptEngine};
use crate::file::Template;

/// Curves between the points of a coarse grid are drawn from about this many points.
const SMOOTH: usize = 180;
/// Of a finer grid a curve shows this many at most.
const MOST_OF_CURVE: usize = 2000;

/// Computes a sweep over one or two parameters at these orders; at those of the file where none are given.
///
/// # Errors
/// More than two parameters or none, too many points, or the first layout that cannot be read.
pub fn sweep(
    template: &Template,
    parameters: &[Parameter],
    orders: &[u32],
    geometry: &Geometry,
) -> Result<Sweep, SweepError> {
    Stream::new(template, parameters, orders, &[], geometry)?.whole(&AtomicBool::new(false))
}

impl Stream<'_> {
    /// All points, with the curve and the zeros, until a flag is set, which stops it.
    ///
    /// # Errors
    /// Too many points, the first layout that cannot be read, or that it was stopped.
    pub fn whole(&self, stop: &AtomicBool) -> Result<Sweep, SweepError> {
        let (parameters, template) = (self.parameters, &self.template);
        if self.count() > MOST_POINTS {
            let sizes: Vec<String> = parameters.iter().map(|parameter| parameter.range.count().to_string()).collect();
            let message = format!(
                "the sweep has {} points; up to {MOST_POINTS} are kept for a page; the table of points has no such limit: \
                 --format csv or parquet with --output naming a file",
                sizes.join(" × ")
            );
            return Err(SweepError::new(message));
        }
        let points = on_all_cores(self.count(), self.fewest(), stop, &|index, motions| self.point(index, motions))?;
        let mut sweep = self.of(points);
        sweep.angles = parameters.iter().map(|parameter| is_angle(template, parameter)).collect();
        if let [one] = parameters {
            sweep.zeros = zeros(template, one, &sweep.orders);
            sweep.zeros.iter_mut().flatten().for_each(|set| set.take_from(&sweep.points));
            sweep.curve = self.curve(one, &sweep, stop)?;
            self.firing_between(one, &mut sweep)?;
        }
        Ok(sweep)
    }

    /// The points from which curves are drawn.
    fn curve(&self, one: &Parameter, sweep: &Sweep, stop: &AtomicBool) -> Result<Vec<SweptEngine>, SweepError> {
        let at = |value: &BigRational, motions: &mut Motions| Ok(self.swept(vec![value.clone()], motions)?.0);
        let mut curve = match one.range.count() {
            count @ 2..=SMOOTH => {
                let finer = one.range.finer(SMOOTH.div_ceil(count - 1));
                let finer = on_all_cores(finer.count(), 64, stop, &|index, motions| at(&finer.value(index), motions));
                // Between whole numbers there may be no engine.
                finer.unwrap_or_else(|_| sweep.points.clone())
            }
            count => sweep.points.iter().step_by(count.div_ceil(MOST_OF_CURVE)).cloned().collect(),
        };
        let known: BTreeSet<&BigRational> = curve.iter().flat_map(|point| &point.values).collect();
        let at_zeros: BTreeSet<&BigRational> = sweep.zeros.iter().flatten().flat_map(|set| &set.at).collect();
        let mut motions = Motions::default();
        let between = at_zeros.difference(&known).map(|value| at(value, &mut motions));
        let between = between.collect::<Result<Vec<SweptEngine>, SweepError>>()?;
        curve.extend(between);
        curve.sort_by(|a, b| a.values.cmp(&b.values));
        Ok(curve)
    }

    /// The firing stars along the curve, and where they vanish.
    fn firing_between(&self, one: &Parameter, sweep: &mut Sweep) -> Result<(), SweepError> {
        let Some(firing) = &mut sweep.firing else { return Ok(()) };
        firing.zeros = found(&self.template, one, &firing.orders);
        let at_zeros = firing.zeros.iter().flatten().flat_map(|zeros| &zeros.at);
        let values: BTreeSet<&BigRational> =
            sweep.curve.iter().flat_map(|point| &point.values).chain(at_zeros).collect();
        let on_curve = |value: &BigRational| {
            let engine = self.reader.engine(std::slice::from_ref(value))?;
            Ok((value.clone(), self.stars(&engine)))
        };
        firing.curve = values.into_iter().map(on_curve).collect::<Result<_, SweepError>>()?;
        Ok(())
    }
}
