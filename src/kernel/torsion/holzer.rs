//! Which frequencies and modes has a train of discs? By the signs of Holzer's residuals, and a bisection.
//!
//! H. Holzer, Die Berechnung der Drehschwingungen, 1921. The number of negative pivots of `K − ω²J` is that of the natural
//! frequencies below ω (Sylvester's law of inertia), in a row and in a tree, so each is enclosed between neighbouring numbers.

use super::Train;

/// A way in which the train vibrates by itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Angular frequency in radians a second.
    pub omega: f64,
    /// Deflection of each disc, 1 at the first; 1 at the largest where the first is a node.
    pub shape: Vec<f64>,
    /// Where it stands still.
    pub nodes: Vec<Node>,
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
/// A disc that moves less than this part of those on both sides of it is a node but for rounding.
const ROUNDING: f64 = 1e-13;

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

/// The elastic modes, rising; those in which the train or a ring without a spring turns as a whole are omitted.
pub fn modes(train: &Train) -> Vec<Mode> {
    (1 + train.loose()..train.inertias.len()).map(|number| mode(train, number)).collect()
}

/// The mode with this many others below it, the rigid ones counted.
fn mode(train: &Train, below: usize) -> Mode {
    let (mut low, mut high) = (0.0, no_square_above(train));
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        match pivots(train, middle).into_iter().filter(|pivot| *pivot < 0.0).count() > below {
            true => high = middle,
            false => low = middle,
        }
    }
    let shape = shape(train, high);
    Mode { omega: high.sqrt(), nodes: nodes(train, &shape), shape }
}

/// No square of a natural frequency is above this (Gershgorin).
fn no_square_above(train: &Train) -> f64 {
    let at = |node: usize| 2.0 * train.held(node) / train.inertias[node];
    (0..train.inertias.len()).map(at).fold(0.0, f64::max) * (1.0 + 1e-12)
}

/// A pivot of zero is taken for one as small as its rounding: the next is huge, and of the other sign.
fn not_zero(train: &Train, node: usize, pivot: f64) -> f64 {
    if pivot == 0.0 { f64::EPSILON * train.held(node) } else { pivot }
}

/// The diagonal of `K − ω²J`.
fn diagonal(train: &Train, node: usize, square: f64) -> f64 {
    train.held(node) - square * train.inertias[node]
}

/// The pivot of each node where all that hangs on it is eliminated: as many are negative as squares of natural frequencies are below.
fn pivots(train: &Train, square: f64) -> Vec<f64> {
    let mut pivots = vec![f64::INFINITY; train.inertias.len()];
    for &node in &train.order {
        let hanging: f64 =
            train.children(node).map(|(child, link)| train.stiffness(link).powi(2) / pivots[child]).sum();
        pivots[node] = not_zero(train, node, diagonal(train, node, square) - hanging);
    }
    pivots
}

/// The deflections at the square of a natural frequency: outwards from the node at which the equations fit best.
fn shape(train: &Train, square: f64) -> Vec<f64> {
    let up = pivots(train, square);
    // The pivot of what a node hangs on, where all beyond that is eliminated, but not the node.
    let mut down = vec![f64::INFINITY; up.len()];
    let beyond = |node: usize, down: &[f64]| {
        train.parents[node].map_or(0.0, |(_, link)| train.stiffness(link).powi(2) / down[node])
    };
    for &node in train.order.iter().rev() {
        let Some((parent, _)) = train.parents[node] else { continue };
        let others = train.children(parent).filter(|(child, _)| *child != node);
        let hanging: f64 = others.map(|(child, link)| train.stiffness(link).powi(2) / up[child]).sum();
        let pivot = diagonal(train, parent, square) - hanging - beyond(parent, &down);
        down[node] = not_zero(train, parent, pivot);
    }
    let misfit = |node: usize| (up[node] - beyond(node, &down)).abs();
    let start = (0..up.len()).min_by(|one, other| misfit(*one).total_cmp(&misfit(*other))).unwrap_or(0);
    let mut shape = vec![0.0; up.len()];
    shape[start] = 1.0;
    let mut next = vec![(start, start)];
    while let Some((node, from)) = next.pop() {
        for &(other, link) in train.around[node].iter().filter(|(other, _)| *other != from) {
            let is_parent = train.parents[node].is_some_and(|(parent, _)| parent == other);
            shape[other] = train.stiffness(link) / if is_parent { down[node] } else { up[other] } * shape[node];
            next.push((other, node));
        }
    }
    let shape = at_rest(train, train.of_discs(&shape));
    let largest =
        shape.iter().copied().fold(0.0_f64, |most, value| if value.abs() > most.abs() { value } else { most });
    let first = shape.first().copied().unwrap_or(1.0);
    let unit = if first.abs() > NODE * largest.abs() { first } else { largest };
    shape.into_iter().map(|value| value / unit).collect()
}

/// The discs that shafts and springs join to a disc.
fn around(train: &Train, disc: usize) -> impl Iterator<Item = usize> {
    train.links.iter().filter_map(move |link| match link.ends {
        [one, other] if one == disc => Some(other),
        [one, other] if other == disc => Some(one),
        _ => None,
    })
}

/// The deflections of the discs, 0 where only rounding moves one between others that swing against each other.
fn at_rest(train: &Train, mut shape: Vec<f64>) -> Vec<f64> {
    for disc in 0..shape.len() {
        let far = |sign: f64| around(train, disc).map(|other| sign * shape[other]).fold(0.0, f64::max);
        if shape[disc].abs() < ROUNDING * far(1.0).min(far(-1.0)) {
            shape[disc] = 0.0;
        }
    }
    shape
}

/// In each shaft whose ends swing against each other there is one, and at each disc at rest between such discs.
fn nodes(train: &Train, shape: &[f64]) -> Vec<Node> {
    let in_shaft = |(index, link): (usize, &super::Link)| {
        let [one, other] = link.ends.map(|disc| shape[disc]);
        (one * other < 0.0).then(|| Node::Shaft(index, one / (one - other)))
    };
    let at_disc = |disc: usize| {
        let swings = |sign: f64| around(train, disc).any(|other| shape[other] * sign > 0.0);
        (shape[disc] == 0.0 && swings(1.0) && swings(-1.0)).then_some(Node::Disc(disc))
    };
    let springs = train.links.iter().enumerate().filter(|(_, link)| link.stiffness > 0.0);
    springs.filter_map(in_shaft).chain((0..shape.len()).filter_map(at_disc)).collect()
}
