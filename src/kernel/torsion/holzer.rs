//! Which frequencies and modes has a train of discs? By the signs of Holzer's residuals, and a bisection.
//!
//! H. Holzer, Die Berechnung der Drehschwingungen, 1921. The number of negative pivots of `K − ω²J` is that of the natural
//! frequencies below ω (Sylvester's law of inertia), in a row and in a tree, so each is enclosed between neighbouring numbers.

use std::ops::Range;

use super::Train;
use super::branch::count_below;
use super::shapes::{Enclosure, shapes};

/// A way in which the train vibrates by itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Angular frequency in radians a second.
    pub omega: f64,
    /// Deflection of each disc, 1 at the first; 1 at the disc that moves most where the first is a node.
    pub shape: Vec<f64>,
    /// Where it stands still.
    pub nodes: Vec<Node>,
    /// The numbers, from 0, of the modes of this frequency, this one included.
    pub alike: Range<usize>,
}

impl Mode {
    /// Whether the first disc is a node: the disc that moves most has the deflection 1 then.
    pub fn is_first_a_node(&self) -> bool {
        self.shape.first() != Some(&1.0)
    }
}

/// A place of a train that stands still in a mode.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// In a shaft, by its number from 0: at this part of the way from its first disc to its second.
    Shaft(usize, f64),
    /// At a disc, by its number from 0, whose neighbours swing against each other.
    Disc(usize),
}

impl Node {
    /// The discs it is between, by their numbers from 0; twice the disc that it is at.
    pub fn ends(&self, train: &Train) -> [usize; 2] {
        match self {
            Node::Shaft(link, _) => train.links[*link].ends,
            Node::Disc(disc) => [*disc; 2],
        }
    }
}

/// A first disc that moves less than this part of the largest deflection is taken for a node.
const NODE: f64 = 1e-9;
/// Squares of frequencies that differ by less than this part are equal but for rounding, which is less in 200 discs.
const EQUAL: f64 = 1e-12;

impl Mode {
    /// Frequency in oscillations a second.
    pub fn hertz(&self) -> f64 {
        self.omega / std::f64::consts::TAU
    }

    /// How many nodes it has.
    pub fn nodes(&self) -> usize {
        self.nodes.len()
    }
}

/// The elastic modes, rising; those in which the train or a ring without a spring turns as a whole are omitted. Those of equal frequency
/// are orthogonal in the inertias: any sum of them is a mode too.
pub fn modes(train: &Train) -> Vec<Mode> {
    let rigid = 1 + train.loose();
    let squares: Vec<f64> = (rigid..train.inertias.len()).map(|number| square(train, number)).collect();
    let mut modes = Vec::new();
    for equal in squares.chunk_by(|one, other| other - one <= EQUAL * other) {
        let omega = equal[equal.len() / 2].sqrt();
        let shapes = shapes_of(train, equal);
        let alike = modes.len()..modes.len() + shapes.len();
        modes.extend(shapes.into_iter().map(|shape| {
            let shape = scaled(train.of_discs(&shape));
            Mode { omega, nodes: nodes(train, &shape), shape, alike: alike.clone() }
        }));
    }
    modes
}

/// The square of the frequency of the mode with this many others below it, the rigid ones counted.
fn square(train: &Train, below: usize) -> f64 {
    let (mut low, mut high) = (0.0, no_square_above(train));
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return high;
        }
        match count_below(train, middle) > below {
            true => high = middle,
            false => low = middle,
        }
    }
}

/// No square of a natural frequency is above this (Gershgorin).
fn no_square_above(train: &Train) -> f64 {
    let at = |node: usize| 2.0 * train.held(node) / train.inertias[node];
    (0..train.inertias.len()).map(at).fold(0.0, f64::max) * (1.0 + 1e-12)
}

/// The deflections of the nodes in the modes of equal frequency, one each.
fn shapes_of(train: &Train, equal: &[f64]) -> Vec<Vec<f64>> {
    let held = vec![false; train.inertias.len()];
    let (first, last) = (equal[0], equal[equal.len() - 1]);
    let bounds =
        Enclosure { below: first * (1.0 - 0.5 * EQUAL), at: equal[equal.len() / 2], above: last * (1.0 + 0.5 * EQUAL) };
    shapes(train, &bounds, &held, train.inertias.len() - 1)
}

/// With 1 at the first disc; at the largest where the first is a node.
fn scaled(shape: Vec<f64>) -> Vec<f64> {
    let larger = |most: f64, value: f64| if value.abs() > most.abs() { value } else { most };
    let largest = shape.iter().copied().fold(0.0, larger);
    let first = shape.first().copied().unwrap_or(1.0);
    let unit = if first.abs() > NODE * largest.abs() { first } else { largest };
    // A zero has no sign.
    shape.into_iter().map(|value| value / unit + 0.0).collect()
}

/// The discs that shafts and springs join to a disc.
fn around(train: &Train, disc: usize) -> impl Iterator<Item = usize> {
    train.links.iter().filter_map(move |link| match link.ends {
        [one, other] if one == disc => Some(other),
        [one, other] if other == disc => Some(one),
        _ => None,
    })
}

/// In each shaft whose ends swing against each other there is one, and at each disc at rest between such discs.
fn nodes(train: &Train, shape: &[f64]) -> Vec<Node> {
    let in_shaft = |(index, link): (usize, &super::Link)| {
        let [one, other] = link.ends.map(|disc| shape[disc]);
        (one * other < 0.0).then(|| Node::Shaft(index, one / (one - other)))
    };
    // Discs in mesh turn as one: a node there is told at the first of them.
    let at_disc = |disc: usize| {
        let node = train.node(disc);
        let is_first = (0..disc).all(|other| train.node(other) != node);
        let in_mesh = || (0..shape.len()).filter(|one| train.node(*one) == node);
        let swings = |sign: f64| {
            let mut beside = in_mesh().flat_map(|one| around(train, one));
            beside.any(|other| sign * train.discs[other].ratio * shape[other] > 0.0)
        };
        (is_first && shape[disc] == 0.0 && swings(1.0) && swings(-1.0)).then_some(Node::Disc(disc))
    };
    let springs = train.links.iter().enumerate().filter(|(_, link)| link.stiffness > 0.0);
    springs.filter_map(in_shaft).chain((0..shape.len()).filter_map(at_disc)).collect()
}
