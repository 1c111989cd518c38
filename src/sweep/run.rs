//! How are all points of a sweep computed? Each file is read anew from parsed tables, on all cores.

use std::collections::BTreeSet;
use std::num::NonZero;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

use num_rational::BigRational;

use super::envelope::Geometry;
use super::firing::FiringSweep;
use super::observed::ObservedSweep;
use super::parameter::Parameter;
use super::range::{MOST_COUNTED, MOST_POINTS};
use super::swept_engine::{Motions, SweptEngine, judge_with};
use super::zeros::{is_angle, zeros};
use super::{SweepError, ZeroSet};
use crate::engine::Engine;
use crate::file::{Key, Layout, Template};
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
    Ok(Sweep {
        title: first.title().clone(),
        parameters: parameters.to_vec(),
        angles: parameters.iter().map(|parameter| is_angle(template, parameter)).collect(),
        orders: orders.to_vec(),
        points,
        curve,
        zeros,
        firing: None,
        observed: None,
        arm: Arm::of(&first),
        rods_known: !first.mechanisms().is_empty(),
        geometry: geometry.clone(),
    })
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

/// Reads the engines of a sweep.
pub(super) struct Reader<'a> {
    template: Template<'a>,
    /// The file without a firing order, for values whose throws cannot fire in it.
    unfired: Option<Template<'a>>,
    parameters: &'a [Parameter],
}

impl<'a> Reader<'a> {
    pub fn new(template: &Template<'a>, parameters: &'a [Parameter]) -> Self {
        let template = parameters.iter().fold(template.clone(), |template, parameter| parameter.prepared(&template));
        // The throws of an in-line engine may follow from its firing order.
        let order_makes_throws = template.form() == Some("inline") && !template.has("inline.throws");
        let fires = template.has("firing_order") || template.has("firing_angles");
        let unfired = (fires && !order_makes_throws).then(|| template.without(&["firing_order", "firing_angles"]));
        Reader { template, unfired, parameters }
    }

    /// The values of a point.
    pub fn values(&self, index: usize) -> Vec<BigRational> {
        match self.parameters {
            [slow, fast] => {
                let count = fast.range.count();
                vec![slow.range.value(index / count), fast.range.value(index % count)]
            }
            _ => self.parameters.iter().map(|parameter| parameter.range.value(index)).collect(),
        }
    }

    /// The engine with these values.
    pub fn engine(&self, values: &[BigRational]) -> Result<Engine, SweepError> {
        let pairs = || self.parameters.iter().zip(values);
        let texts: Vec<String> = pairs().map(|(parameter, value)| parameter.range.written(value)).collect();
        let put: Vec<(&Key, &str)> =
            self.parameters.iter().zip(&texts).map(|(parameter, text)| (&parameter.key, text.as_str())).collect();
        let read = self.template.layout(&put).or_else(|error| match &self.unfired {
            Some(unfired) => unfired.layout(&put).map_err(|_| error),
            None => Err(error),
        });
        let at = || pairs().map(|(parameter, value)| parameter.at(value)).collect::<Vec<_>>().join(", ");
        match read.map_err(|error| SweepError::at(&at(), &error))? {
            Layout::Known(engine, _) => Ok(*engine),
            Layout::Open(family) => {
                let unknowns: Vec<&str> = family.unknowns().into_iter().collect();
                let message = format!("the layout leaves {} open; give values below [values]", unknowns.join(", "));
                Err(SweepError::new(message))
            }
        }
    }

    pub fn point(
        &self,
        values: &[BigRational],
        orders: &[u32],
        geometry: &Geometry,
        motions: &mut Motions,
    ) -> Result<SweptEngine, SweepError> {
        let engine = self.engine(values)?;
        let judged = judge_with(&engine, self.template.cycle(), orders, geometry, motions);
        let judged = judged.map_err(|missing| SweepError::new(missing.to_string()))?;
        Ok(SweptEngine { values: values.to_vec(), ..judged })
    }
}

/// Computes `count` points on all cores, of which each has at least `fewest`, until `stop` is set; the first that fails is the one to tell.
/// What a core knows of the points before is handed to the next.
pub(super) fn on_all_cores<K: Default, P: Send>(
    count: usize,
    fewest: usize,
    stop: &AtomicBool,
    point: &(dyn Fn(usize, &mut K) -> Result<P, SweepError> + Sync),
) -> Result<Vec<P>, SweepError> {
    let threads = thread::available_parallelism().map_or(1, NonZero::get).min(count.div_ceil(fewest)).max(1);
    let failed = AtomicBool::new(false);
    let part = |thread: usize| {
        let mut known = K::default();
        let (from, to) = (count * thread / threads, count * (thread + 1) / threads);
        let mut points = Vec::with_capacity(to - from);
        for index in from..to {
            if thread > 0 && failed.load(Ordering::Relaxed) {
                break;
            }
            let point = match stop.load(Ordering::Relaxed) {
                true => Err(SweepError::new("stopped")),
                false => point(index, &mut known),
            };
            match point {
                Ok(point) => points.push(point),
                Err(error) => {
                    failed.store(true, Ordering::Relaxed);
                    return Err(error);
                }
            }
        }
        Ok(points)
    };
    let parts: Vec<Result<Vec<P>, SweepError>> = thread::scope(|scope| {
        let part = &part;
        let others: Vec<_> = (1..threads).map(|thread| scope.spawn(move || part(thread))).collect();
        let first = part(0);
        let rest =
            others.into_iter().map(|other| other.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        [first].into_iter().chain(rest).collect()
    });
    let mut points = Vec::with_capacity(count);
    for part in parts {
        points.extend(part?);
    }
    Ok(points)
}
