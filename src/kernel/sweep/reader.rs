//! How are the engines of a sweep read, and computed on all cores?

use std::num::NonZero;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

use num_rational::BigRational;

use super::SweepError;
use super::parameter::Parameter;
use crate::engine::Engine;
use crate::file::{Key, Layout, Template};

/// Reads the engines of a sweep.
pub(super) struct Reader<'a> {
    pub template: Template<'a>,
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
