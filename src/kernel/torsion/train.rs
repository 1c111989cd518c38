//! What are discs, shafts and gears to whoever computes with them? A tree in decimals, reduced to the speed of the crankshaft.

use num_complex::Complex;
use num_rational::BigRational;

use crate::engine::Torsion;
use crate::numbers::float;

/// A disc, or the ring of a damper.
#[derive(Clone, Debug, PartialEq)]
pub struct Disc {
    /// Moment of inertia in kg m².
    pub inertia: f64,
    /// Absolute damping in N m s per radian.
    pub damping: f64,
    /// Its speed over that of the crankshaft.
    pub ratio: f64,
    /// Discs in mesh turn as one: the number of that one.
    pub(super) node: usize,
}

/// A massless shaft between two discs, or what joins the ring of a damper to its disc.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// The discs.
    pub ends: [usize; 2],
    /// Stiffness k in N m per radian; 0 of a viscous damper.
    pub stiffness: f64,
    /// Loss factor η.
    pub loss_factor: f64,
    /// Relative damping c in N m s per radian.
    pub damping: f64,
}

impl Link {
    /// `k (1 + iη) + iΩc`.
    pub fn complex_stiffness(&self, omega: f64) -> Complex<f64> {
        Complex::new(self.stiffness, self.stiffness * self.loss_factor + omega * self.damping)
    }
}

/// Discs on massless shafts, which are free at all ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Train {
    /// The discs, then the rings of the dampers.
    pub discs: Vec<Disc>,
    /// The shafts, then the springs of the dampers.
    pub links: Vec<Link>,
    /// How many of the links are shafts.
    pub shafts: usize,
    /// The discs that are in mesh.
    pub gears: Vec<[usize; 2]>,
    pub(super) inertias: Vec<f64>,
    /// The nodes, each before the one that it hangs on; the last hangs on none.
    pub(super) order: Vec<usize>,
    /// What each node hangs on, and by which link.
    pub(super) parents: Vec<Option<(usize, usize)>>,
    /// The nodes around each, with the links to them, those of lower number first.
    pub(super) around: Vec<Vec<(usize, usize)>>,
}

impl Train {
    /// 1 of a disc that turns as the first crankpin does, −1 of one that gears turn against it: a torque turns its crank in the sense in which that
    /// turns.
    pub fn sense(&self, disc: usize) -> f64 {
        self.discs[disc].ratio.signum()
    }

    /// The shaft of an engine without its dampers, in decimals; [`Train::new`] has them.
    pub fn bare(torsion: &Torsion) -> Self {
        let ratios: Vec<f64> = torsion.ratios().iter().map(|ratio| ratio.as_ref().map_or(1.0, float)).collect();
        // A disc in mesh with one of lower number turns as that one.
        let mut first: Vec<usize> = (0..ratios.len()).collect();
        for gear in &torsion.gears {
            let [one, other] = gear.ends.map(|disc| first[disc]);
            first.iter_mut().filter(|at| [one, other].contains(at)).for_each(|at| *at = one.min(other));
        }
        let nodes: Vec<usize> = (0..ratios.len()).filter(|disc| first[*disc] == *disc).collect();
        let node = |disc: usize| nodes.binary_search(&first[disc]).unwrap_or(0);
        let damping = |disc: usize| torsion.dampings.get(disc).map_or(0.0, float);
        let disc = |(disc, inertia): (usize, &BigRational)| Disc {
            inertia: float(inertia),
            damping: damping(disc),
            ratio: ratios[disc],
            node: node(disc),
        };
        let link = |shaft: &crate::engine::ElasticShaft| Link {
            ends: shaft.ends,
            stiffness: float(&shaft.stiffness),
            loss_factor: float(&shaft.loss_factor),
            damping: float(&shaft.damping),
        };
        Train {
            discs: torsion.inertias.iter().enumerate().map(disc).collect(),
            links: torsion.shafts.iter().map(link).collect(),
            shafts: torsion.shafts.len(),
            gears: torsion.gears.iter().map(|gear| gear.ends).collect(),
            inertias: vec![0.0; nodes.len()],
            order: Vec::new(),
            parents: Vec::new(),
            around: Vec::new(),
        }
        .joined()
    }

    /// With its tree: which node hangs on which.
    pub(super) fn joined(mut self) -> Self {
        let count = self.inertias.len();
        self.inertias.fill(0.0);
        for disc in &self.discs {
            self.inertias[disc.node] += disc.ratio * disc.ratio * disc.inertia;
        }
        self.around = vec![Vec::new(); count];
        for (index, link) in self.links.iter().enumerate() {
            let [one, other] = link.ends.map(|disc| self.discs[disc].node);
            self.around[one].push((other, index));
            self.around[other].push((one, index));
        }
        self.around.iter_mut().for_each(|around| around.sort_unstable());
        self.parents = vec![None; count];
        self.order.clear();
        let mut next: Vec<usize> = count.checked_sub(1).into_iter().collect();
        while let Some(node) = next.pop() {
            self.order.push(node);
            for &(other, link) in &self.around[node] {
                if self.parents[node].is_none_or(|(parent, _)| parent != other) {
                    self.parents[other] = Some((node, link));
                    next.push(other);
                }
            }
        }
        self.order.reverse();
        self
    }

    /// By how much a stiffness or a damping of this link counts where all turns as fast as the crankshaft: ν².
    pub(super) fn weight(&self, link: usize) -> f64 {
        let ratio = self.discs[self.links[link].ends[0]].ratio;
        ratio * ratio
    }

    /// The reduced stiffness of a link.
    pub(super) fn stiffness(&self, link: usize) -> f64 {
        self.links[link].stiffness * self.weight(link)
    }

    /// The reduced stiffness of all that is joined to a node.
    pub(super) fn held(&self, node: usize) -> f64 {
        self.around[node].iter().map(|(_, link)| self.stiffness(*link)).sum()
    }

    /// The nodes that hang on this one, with the links.
    pub(super) fn children(&self, node: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
        let parent = self.parents[node].map(|(parent, _)| parent);
        self.around[node].iter().copied().filter(move |(other, _)| Some(*other) != parent)
    }

    /// The deflection of each disc from those of the nodes.
    pub(super) fn of_discs<T: Copy + std::ops::Mul<f64, Output = T>>(&self, nodes: &[T]) -> Vec<T> {
        self.discs.iter().map(|disc| nodes[disc.node] * disc.ratio).collect()
    }

    /// The node of a disc: discs in mesh turn as one, and have one.
    pub fn node(&self, disc: usize) -> usize {
        self.discs[disc].node
    }

    /// Rings that no spring holds: each may turn by itself.
    pub(super) fn loose(&self) -> usize {
        self.links.iter().filter(|link| link.stiffness == 0.0).count()
    }

    /// `Σ J Θ²` of a mode with these deflections of the discs.
    pub fn inertia_of(&self, shape: &[f64]) -> f64 {
        self.discs.iter().zip(shape).map(|(disc, deflection)| disc.inertia * deflection * deflection).sum()
    }
}
