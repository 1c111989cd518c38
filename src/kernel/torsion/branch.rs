//! How does a branch of a train resist being turned at a frequency? By Holzer's residuals, from the ends of the tree inwards.
//!
//! A residual is a sum, and what a spring hands on of it a quotient: no stiffness is added and taken off again. So rounding is as if
//! inertias and stiffnesses were others by a few units in their last place, and low frequencies lose no digits beside stiff shafts.

use super::Train;

/// What hangs on a node by a link, at the square of a frequency.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Branch {
    /// The torque that turns its nearest node by 1, without the link.
    residual: f64,
    /// The same with the far end of the link held fast: the pivot of that node where all behind it is eliminated.
    pub pivot: f64,
    /// How many squares of its natural frequencies are below, held so.
    pub below: usize,
}

impl Branch {
    fn new(stiffness: f64, residual: f64, behind: usize) -> Self {
        let sum = stiffness + residual;
        // A pivot of zero is taken for one as small as its rounding: the next is huge, and of the other sign.
        let pivot = if sum == 0.0 { f64::EPSILON * stiffness } else { sum };
        Branch { residual, pivot, below: behind + usize::from(pivot < 0.0) }
    }

    /// What a node feels of it over the link.
    fn felt(&self, stiffness: f64) -> f64 {
        stiffness * self.residual / self.pivot
    }
}

/// How many squares of natural frequencies are below this one, that of the rigid motion among them (Sylvester's law of inertia).
pub(super) fn count_below(train: &Train, square: f64) -> usize {
    let mut branches = vec![Branch::default(); train.inertias.len()];
    let mut below = 0;
    for &node in &train.order {
        let (mut residual, mut behind) = (-square * train.inertias[node], 0);
        for (child, link) in train.children(node) {
            residual += branches[child].felt(train.stiffness(link));
            behind += branches[child].below;
        }
        below = behind + usize::from(residual < 0.0);
        if let Some((_, link)) = train.parents[node] {
            branches[node] = Branch::new(train.stiffness(link), residual, behind);
        }
    }
    below
}

/// All branches of a train some of whose nodes are held fast, at the square of a frequency.
pub(super) struct Branches<'a> {
    train: &'a Train,
    held: &'a [bool],
    square: f64,
    /// Around each node those that hang on it there, in the order of its links.
    around: Vec<Vec<Branch>>,
}

impl<'a> Branches<'a> {
    pub fn new(train: &'a Train, held: &'a [bool], square: f64) -> Self {
        let around = train.around.iter().map(|around| vec![Branch::default(); around.len()]).collect();
        let mut branches = Branches { train, held, square, around };
        for &node in &train.order {
            if let Some((parent, link)) = train.parents[node] {
                branches.hang(node, parent, link);
            }
        }
        for &node in train.order.iter().rev() {
            if let Some((parent, link)) = train.parents[node] {
                branches.hang(parent, node, link);
            }
        }
        branches
    }

    /// The branch that begins with a node and hangs on another, once all behind it is known.
    fn hang(&mut self, node: usize, on: usize, link: usize) {
        let (residual, behind) = self.without(node, Some(on));
        let place = self.train.around[on].iter().position(|(other, _)| *other == node);
        if let Some(place) = place {
            self.around[on][place] = Branch::new(self.train.stiffness(link), residual, behind);
        }
    }

    /// The residual of a node, with how many pivots behind it are below 0; one of its neighbours left out.
    fn without(&self, node: usize, left_out: Option<usize>) -> (f64, usize) {
        let mut sum = (-self.square * self.train.inertias[node], 0);
        let around = self.train.around[node].iter().zip(&self.around[node]);
        for ((other, link), branch) in around.filter(|((other, _), _)| Some(*other) != left_out) {
            let stiffness = self.train.stiffness(*link);
            sum.0 += if self.held[*other] { stiffness } else { branch.felt(stiffness) };
            sum.1 += if self.held[*other] { 0 } else { branch.below };
        }
        sum
    }

    /// How far from 0 the equation of a node is, as a square of a frequency.
    pub fn misfit(&self, node: usize) -> f64 {
        (self.without(node, None).0 / self.train.inertias[node]).abs()
    }

    /// How many squares are below that of what is joined to a node without passing one that is held fast.
    pub fn below(&self, node: usize) -> usize {
        let (residual, behind) = self.without(node, None);
        behind + usize::from(residual < 0.0)
    }

    /// The same of each branch around a node, which is held fast itself.
    pub fn below_around(&self, node: usize) -> impl Iterator<Item = usize> + '_ {
        let around = self.train.around[node].iter().zip(&self.around[node]);
        around.map(|((other, _), branch)| if self.held[*other] { 0 } else { branch.below })
    }

    /// Deflections that satisfy the equations of all nodes but this one, which is turned by 1.
    pub fn shape_from(&self, start: usize) -> Vec<f64> {
        let mut shape = vec![0.0; self.held.len()];
        shape[start] = 1.0;
        let mut next = vec![(start, start)];
        while let Some((node, from)) = next.pop() {
            for (&(other, link), branch) in self.train.around[node].iter().zip(&self.around[node]) {
                if other != from && !self.held[other] {
                    shape[other] = self.train.stiffness(link) / branch.pivot * shape[node];
                    next.push((other, node));
                }
            }
        }
        shape
    }
}
