//! Which shapes have the modes of one frequency? As many as there are modes, orthogonal in the inertias.
//!
//! A branch that swings by itself at the frequency of the train needs another one that holds its foot still: the disc between them is at
//! rest in every mode, and the branches swing against each other. Of three alike there are two such modes: a frequency that is
//! multiple in a tree always has such a disc (Parter 1960, Wiener 1984). So the tree is cut at discs that are found at rest by
//! counting, which rounding does not disturb, and the shapes of its branches are put together.

use super::Train;
use super::branch::Branches;

/// Bounds of the squares of one or several equal frequencies, and one of them.
pub(super) struct Enclosure {
    pub below: f64,
    pub at: f64,
    pub above: f64,
}

/// The modes within these bounds of what is joined to a node without passing one that is held fast: the deflections of all nodes,
/// orthogonal in the inertias, `Σ J Θ²` 1 each.
pub(super) fn shapes(train: &Train, squares: &Enclosure, held: &[bool], start: usize) -> Vec<Vec<f64>> {
    let [below, above] = [squares.below, squares.above].map(|square| Branches::new(train, held, square));
    let count = above.below(start).saturating_sub(below.below(start));
    if count == 0 {
        return Vec::new();
    }
    let around = |node: usize| {
        let pairs = above.below_around(node).zip(below.below_around(node));
        pairs.map(|(above, below)| above.saturating_sub(below)).collect::<Vec<_>>()
    };
    let joined = joined(train, held, start);
    let is_at_rest = |node: &usize| {
        let around = around(*node);
        around.iter().sum::<usize>() > count && around.iter().filter(|own| **own > 0).count() > 1
    };
    if let Some(&node) = joined.iter().find(|node| is_at_rest(node)) {
        return balanced(train, node, beside(train, squares, held, node));
    }
    let at = Branches::new(train, held, squares.at);
    let mut starts = joined;
    starts.sort_by(|one, other| at.misfit(*one).total_cmp(&at.misfit(*other)));
    if count == 1 {
        return vec![unit(train, at.shape_from(starts[0]))];
    }
    // Frequencies that decimals do not tell apart, of ends that hardly feel each other: in all modes but one the disc that swings
    // most in that one may be taken to be at rest.
    let leaves_the_others = |node: &&usize| around(**node).iter().sum::<usize>() + 1 == count;
    let first = starts.iter().find(leaves_the_others).copied().unwrap_or(starts[0]);
    let mut found: Vec<Vec<f64>> = beside(train, squares, held, first).into_iter().map(|(_, shape)| shape).collect();
    let mut own = at.shape_from(first);
    for other in &found {
        let part = product(train, &own, other);
        own.iter_mut().zip(other).for_each(|(own, other)| *own -= part * other);
    }
    found.push(unit(train, own));
    found
}

/// The modes of the branches around a node that is held fast, with the torque of each on it.
fn beside(train: &Train, squares: &Enclosure, held: &[bool], node: usize) -> Vec<(f64, Vec<f64>)> {
    let mut held = held.to_vec();
    held[node] = true;
    let free = train.around[node].iter().filter(|(other, _)| !held[*other]);
    let of_branch = |&(other, link): &(usize, usize)| {
        let shapes = shapes(train, squares, &held, other);
        shapes.into_iter().map(move |shape| (train.stiffness(link) * shape[other], shape)).collect::<Vec<_>>()
    };
    free.flat_map(of_branch).collect()
}

/// The combinations of modes of branches whose torques on the node between them are balanced: each against all before it.
fn balanced(train: &Train, node: usize, modes: Vec<(f64, Vec<f64>)>) -> Vec<Vec<f64>> {
    let largest = modes.iter().map(|(torque, _)| torque.abs()).fold(0.0, f64::max);
    let mut found = Vec::new();
    // All before together, of the same proportions as their torques, with the square of their torque.
    let (mut before, mut square) = (vec![0.0; train.inertias.len()], 0.0);
    for (torque, shape) in modes {
        let torque = torque / largest;
        if torque.abs() <= f64::EPSILON {
            found.push(shape);
            continue;
        }
        if square > 0.0 {
            let against = before.iter().zip(&shape).map(|(before, own)| torque * before - square * own);
            found.push(unit(train, against.collect()));
        }
        before.iter_mut().zip(&shape).for_each(|(before, own)| *before += torque * own);
        square += torque * torque;
    }
    debug_assert!(found.iter().all(|shape: &Vec<f64>| shape[node] == 0.0));
    found
}

/// What is joined to a node without passing one that is held fast, the node itself first.
fn joined(train: &Train, held: &[bool], start: usize) -> Vec<usize> {
    let mut joined = vec![start];
    let mut next = vec![(start, start)];
    while let Some((node, from)) = next.pop() {
        let around = train.around[node].iter().filter(|(other, _)| *other != from && !held[*other]);
        for &(other, _) in around {
            joined.push(other);
            next.push((other, node));
        }
    }
    joined
}

fn product(train: &Train, one: &[f64], other: &[f64]) -> f64 {
    train.inertias.iter().zip(one.iter().zip(other)).map(|(inertia, (one, other))| inertia * one * other).sum()
}

/// With `Σ J Θ²` of 1.
fn unit(train: &Train, mut shape: Vec<f64>) -> Vec<f64> {
    let size = product(train, &shape, &shape).sqrt();
    shape.iter_mut().for_each(|value| *value /= size);
    shape
}
