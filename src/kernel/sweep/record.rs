//! What is known of a sweep?

use super::ZeroSet;
use super::envelope::Geometry;
use super::firing::FiringSweep;
use super::multiples::Multiples;
use super::observed::ObservedSweep;
use super::parameter::Parameter;
use super::swept_engine::SweptEngine;
use crate::engine::Engine;
use crate::loads::Arm;
use crate::text::Untrusted;

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
    /// The firing stars, where they are asked for: see [`super::Stream::new`].
    pub firing: Option<FiringSweep>,
    /// Values of other questions, where they are asked for: see [`super::Stream::observing`].
    pub observed: Option<ObservedSweep>,
    /// What moments are counted in.
    pub arm: Arm,
    /// The m and r of the first point, which all multiples are counted in, where another point has others.
    pub multiples: Option<Multiples>,
    /// Whether the amplitudes hold the coefficients c_k; else they are in multiples of them.
    pub rods_known: bool,
    /// Whether offsets move the dead centres apart from the crankpins' positions in line with the cylinders: at the first point, in the middle
    /// or at the last.
    pub dead_centres_apart: bool,
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
            multiples: None,
            rods_known: !first.mechanisms().is_empty(),
            dead_centres_apart: false,
            geometry: geometry.clone(),
        }
    }

    /// The parameters, and whether each is an angle of the engine.
    pub fn axes(&self) -> impl Iterator<Item = (&Parameter, bool)> {
        self.parameters.iter().zip(self.angles.iter().copied())
    }
}
