//! How are all points of a sweep computed? Each file is read anew from parsed tables, on all cores.

use std::collections::BTreeSet;
use std::sync::atomic::AtomicBool;

use num_rational::BigRational;

use super::envelope::Geometry;
use super::firing::{FiringSweep, can_be_judged, found, lengths};
use super::observed::{ObservedSweep, Observer};
use super::parameter::Parameter;
use super::range::{MOST_COUNTED, MOST_POINTS};
use super::reader::{Reader, on_all_cores};
use super::swept_engine::{Motions, SweptEngine};
use super::zeros::{is_angle, zeros};
use super::{SweepError, ZeroSet};
use crate::engine::{CycleOrder, Engine};
use crate::file::Template;
use crate::loads::{self, Arm};
use crate::text::Untrusted;

/// Curves between the points of a coarse grid are drawn from about this many points.
const SMOOTH: usize = 180;
/// Of a finer grid a curve shows this many at most.
const MOST_OF_CURVE: usize = 2000;

/// A sweep over one parameter, or over two.
#[derive(Clone, Debug)]
pub struct Sweep {
    /// Title of the engine.
    pub title: Untrusted,
    /// The parameters; the last one runs fastest.
    pub parameters: Vec<Parameter>,
    /// Whether each parameter is an angle of the engine.
    pub angles: Vec<bool>,
    /// The orders, rising.
    pub orders: Vec<u32>,
    /// The points, in order.
    pub points: Vec<SweptEngine>,
    /// For one parameter: points on the grid, between its points, and at the exact zeros, from which curves are drawn.
    pub curve: Vec<SweptEngine>,
    /// For one angle: where each vector vanishes, exactly; none for other parameters.
    pub zeros: Option<Vec<ZeroSet>>,
    /// The firing stars, where they are asked for: see [`super::firing_stars`].
    pub firing: Option<FiringSweep>,
    /// Values of other questions, where they are asked for: see [`super::observed`].
    pub observed: Option<ObservedSweep>,
    /// What moments are counted in.
    pub arm: Arm,
    /// Whether the amplitudes hold the coefficients c_k; else they are in multiples of them.
    pub rods_known: bool,
    /// The assumptions behind the envelope.
    pub geometry: Geometry,
}

impl Sweep {
    /// What all points have in common with the engine of the first.
    pub(super) fn without_points(
        first: &Engine,
        parameters: &[Parameter],
        orders: Vec<u32>,
        geometry: &Geometry,
    ) -> Self {
        Sweep {
            title: first.title().clone(),
            parameters: parameters.to_vec(),
            angles: vec![false; parameters.len()],
            orders,
            points: Vec::new(),
            curve: Vec::new(),
            zeros: None,
            firing: None,
            observed: None,
            arm: Arm::of(first),
            rods_known: !first.mechanisms().is_empty(),
            geometry: geometry.clone(),
        }
    }

    /// The parameters, and whether each is an angle of the engine.
    pub fn axes(&self) -> impl Iterator<Item = (&Parameter, bool)> {
        self.parameters.iter().zip(self.angles.iter().copied())
    }
}

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
    sweep_until(template, parameters, orders, geometry, &AtomicBool::new(false))
}

/// The same until a flag is set, which stops it.
///
/// # Errors
/// As [`sweep`], and that it was stopped.
pub fn sweep_until(
    template: &Template,
    parameters: &[Parameter],
    orders: &[u32],
    geometry: &Geometry,
    stop: &AtomicBool,
) -> Result<Sweep, SweepError> {
    let count = count(parameters)?;
    if count > MOST_POINTS {
        let sizes: Vec<String> = parameters.iter().map(|parameter| parameter.range.count().to_string()).collect();
        let message = format!(
            "the sweep has {} points; up to {MOST_POINTS} are kept for a page; the table of points has no such limit: \
             --format csv or parquet with --output naming a file",
            sizes.join(" × ")
        );
        return Err(SweepError::new(message));
    }
    let reader = Reader::new(template, parameters);
    let first = reader.engine(&reader.values(0))?;
    let usual = loads::usual_orders(&first);
    let orders = if orders.is_empty() { usual.as_slice() } else { orders };
    let points = on_all_cores(count, 64, stop, &|index, motions| {
        reader.point(&reader.values(index), orders, geometry, motions)
    })?;
    let zeros = match parameters {
        [one] => zeros(template, one, orders).map(|mut sets| {
            sets.iter_mut().for_each(|set| set.take_from(&points));
            sets
        }),
        _ => None,
    };
    let mut curve = match parameters {
        [one] if one.range.count() > 1 && one.range.count() <= SMOOTH => {
            let finer = Parameter { range: one.range.finer(SMOOTH.div_ceil(one.range.count() - 1)), ..one.clone() };
            let finer = [finer];
            let between = Reader::new(template, &finer);
            let finer = on_all_cores(finer[0].range.count(), 64, stop, &|index, motions| {
                between.point(&between.values(index), orders, geometry, motions)
            });
            // Between whole numbers there may be no engine.
            finer.unwrap_or_else(|_| points.clone())
        }
        [_] => points.iter().step_by(points.len().div_ceil(MOST_OF_CURVE)).cloned().collect(),
        _ => Vec::new(),
    };
    let known: BTreeSet<&BigRational> = curve.iter().flat_map(|point| &point.values).collect();
    let at_zeros: BTreeSet<&BigRational> = zeros.iter().flatten().flat_map(|set| &set.at).collect();
    let mut motions = Motions::default();
    let between = at_zeros
        .difference(&known)
        .map(|value| reader.point(std::slice::from_ref(*value), orders, geometry, &mut motions));
    let between = between.collect::<Result<Vec<SweptEngine>, SweepError>>()?;
    curve.extend(between);
    curve.sort_by(|a, b| a.values.cmp(&b.values));
    let angles = parameters.iter().map(|parameter| is_angle(template, parameter)).collect();
    Ok(Sweep { angles, points, curve, zeros, ..Sweep::without_points(&first, parameters, orders.to_vec(), geometry) })
}

/// How many points a sweep over these parameters has.
pub(super) fn count(parameters: &[Parameter]) -> Result<usize, SweepError> {
    let too_many = || SweepError::new(format!("the map has more than {MOST_COUNTED} points; take larger steps"));
    match parameters {
        [] => Err(SweepError::new("nothing is swept; give --bank-angle 0..180:10 or --set KEY=FROM..TO:STEP")),
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

/// The firing stars of these orders at the points of a sweep.
///
/// # Errors
/// A half order of a two-stroke engine, or of a file that does not say when the cylinders fire.
pub fn firing_stars(template: &Template, sweep: &Sweep, orders: &[CycleOrder]) -> Result<FiringSweep, SweepError> {
    can_be_judged(template, orders)?;
    let reader = Reader::new(template, &sweep.parameters);
    let lengths = |values: &[BigRational]| lengths(&reader, values, orders);
    let zeros = match sweep.parameters.as_slice() {
        [one] => found(template, one, orders),
        _ => None,
    };
    let mut curve: Vec<BigRational> = match sweep.parameters.len() {
        1 => sweep.curve.iter().filter_map(|point| point.values.first()).cloned().collect(),
        _ => Vec::new(),
    };
    curve.extend(zeros.iter().flatten().flat_map(|zeros| zeros.at.iter().cloned()));
    curve.sort();
    curve.dedup();
    let on_curve = |value: BigRational| Ok((value.clone(), lengths(&[value])?));
    Ok(FiringSweep {
        orders: orders.to_vec(),
        points: sweep.points.iter().map(|point| lengths(&point.values)).collect::<Result<_, SweepError>>()?,
        curve: curve.into_iter().map(on_curve).collect::<Result<_, SweepError>>()?,
        zeros,
    })
}

/// The values at the points of a sweep, on all cores.
///
/// # Errors
/// A first point that lacks one, or a layout that cannot be read.
pub fn observed(template: &Template, sweep: &Sweep, observer: &Observer<'_>) -> Result<ObservedSweep, SweepError> {
    let reader = Reader::new(template, &sweep.parameters);
    let at = |place: usize| Ok((observer.find)(&reader.engine(&sweep.points[place].values)?));
    let mut all = ObservedSweep::new(observer, &reader.engine(&reader.values(0))?)?;
    all.points = on_all_cores(sweep.points.len(), 1, &AtomicBool::new(false), &|place, _: &mut ()| at(place))?;
    Ok(all)
}
