//! On what does an engine stand? A rigid body on springs with dampers.

use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// More mounts are not read.
pub const MOST_MOUNTS: usize = 100;

/// The engine as one rigid body, and the mounts that hold it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mounting {
    /// The body.
    pub block: Block,
    /// The mounts.
    pub mounts: Vec<Mount>,
}

/// The engine as one rigid body: x along angle 0, y along angle 90°, z along the crankshaft towards the free end, from the axis of the
/// crankshaft and where positions are counted from; in the sense of rotation, as all angles.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// Mass in kilograms.
    pub mass: BigRational,
    /// Moments of inertia about axes x, y, z through the centre of gravity, in kg m².
    pub moments: [BigRational; 3],
    /// Products of inertia `∫ xy dm`, `∫ xz dm`, `∫ yz dm` there, in kg m²: minus the entries of the tensor.
    pub products: [BigRational; 3],
    /// Centre of gravity in metres.
    pub centre: [BigRational; 3],
    /// Another point whose motion is asked about, in metres.
    pub point: Option<[BigRational; 3]>,
}

/// A mount: three springs, each with a damper beside it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mount {
    /// Where it stands, in metres.
    pub place: [BigRational; 3],
    /// Stiffness along its own three axes, in newtons a metre.
    pub stiffness: [BigRational; 3],
    /// Viscous damping along them, in newton seconds a metre.
    pub damping: [BigRational; 3],
    /// Loss factor η of its springs: the stiffness is `k(1 + iη)`.
    pub loss_factor: BigRational,
    /// Its axes are x, y and z turned by these angles, in turns, about the fixed axes x, y and z one after the other.
    pub turned: [BigRational; 3],
}

/// Why a body and springs are no engine on its mounts.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoMounting {
    /// No mount, or more than [`MOST_MOUNTS`].
    #[error("{0} mounts; an engine stands on 1 to {MOST_MOUNTS}")]
    Mounts(usize),
    /// A mass that is not above 0.
    #[error("the mass of the block is not above 0")]
    Mass,
    /// Moments and products that are no inertia tensor.
    #[error("the inertia tensor is not positive definite")]
    NotPositiveDefinite,
    /// One moment of inertia is above the sum of the two others, by their letters.
    #[error("I_{} + I_{} < I_{}: no body has that", .0[0], .0[1], .0[2])]
    Triangle([&'static str; 3]),
    /// Products of inertia that no masses make.
    #[error("no body has these products of inertia beside these moments")]
    Products,
    /// A stiffness that is not above 0, by the number of the mount from 1.
    #[error("a stiffness of mount {0} is not above 0")]
    Stiffness(usize),
    /// A damping or a loss factor below 0.
    #[error("the damping or the loss factor of mount {0} is below 0")]
    Damping(usize),
    /// The mounts are at one place, about which the engine turns freely.
    #[error("all mounts are at one place: the engine is free to turn about every axis through it")]
    OnePlace,
    /// The mounts stand on one line of this direction, about which the engine turns freely.
    #[error("all mounts lie on one line: the engine is free along the rotation about its direction ({}, {}, {})", .0[0], .0[1], .0[2])]
    OneLine(Box<[BigRational; 3]>),
}

impl Block {
    /// The inertia tensor about the centre of gravity, in kg m².
    pub fn tensor(&self) -> [[BigRational; 3]; 3] {
        let [xx, yy, zz] = self.moments.clone();
        let [xy, xz, yz] = self.products.clone().map(|product| -product);
        [[xx, xy.clone(), xz.clone()], [xy, yy, yz.clone()], [xz, yz, zz]]
    }

    /// Whether masses can make it: the tensor is positive definite, and so, or zero, is `∫ r rᵀ dm = ½ tr(I) − I`.
    fn check(&self) -> Result<(), NoMounting> {
        if !self.mass.is_positive() {
            return Err(NoMounting::Mass);
        }
        if !minors(&self.moments, &self.products.clone().map(|product| -product)).iter().all(Signed::is_positive) {
            return Err(NoMounting::NotPositiveDefinite);
        }
        const NAMES: [&str; 3] = ["xx", "yy", "zz"];
        let half = BigRational::new(1.into(), 2.into());
        let trace: BigRational = self.moments.iter().sum::<BigRational>() * half;
        let masses: [BigRational; 3] = std::array::from_fn(|axis| &trace - &self.moments[axis]);
        if let Some(axis) = masses.iter().position(Signed::is_negative) {
            let [one, other] = [(axis + 1) % 3, (axis + 2) % 3];
            return Err(NoMounting::Triangle([NAMES[one.min(other)], NAMES[one.max(other)], NAMES[axis]]));
        }
        if minors(&masses, &self.products).iter().any(Signed::is_negative) { Err(NoMounting::Products) } else { Ok(()) }
    }
}

/// The principal minors of a symmetric matrix, from its diagonal and the entries xy, xz, yz.
fn minors([a, b, c]: &[BigRational; 3], [xy, xz, yz]: &[BigRational; 3]) -> [BigRational; 7] {
    let two = |one: &BigRational, other: &BigRational, beside: &BigRational| one * other - beside * beside;
    let triple = xy * xz * yz * BigRational::from_integer(2.into());
    let three = a * two(b, c, yz) - b * xz * xz - c * xy * xy + triple;
    [a.clone(), b.clone(), c.clone(), two(a, b, xy), two(a, c, xz), two(b, c, yz), three]
}

impl Mounting {
    /// Whether masses make the body, and the mounts hold it.
    ///
    /// # Errors
    /// The first thing that does not fit.
    pub fn check(&self) -> Result<(), NoMounting> {
        if !(1..=MOST_MOUNTS).contains(&self.mounts.len()) {
            return Err(NoMounting::Mounts(self.mounts.len()));
        }
        self.block.check()?;
        for (mount, number) in self.mounts.iter().zip(1..) {
            if !mount.stiffness.iter().all(Signed::is_positive) {
                return Err(NoMounting::Stiffness(number));
            }
            if mount.damping.iter().chain([&mount.loss_factor]).any(Signed::is_negative) {
                return Err(NoMounting::Damping(number));
            }
        }
        self.is_held()
    }

    /// Three springs in three directions at each place hold the body unless all places are on one line.
    fn is_held(&self) -> Result<(), NoMounting> {
        let from_first = |mount: &Mount| -> [BigRational; 3] {
            std::array::from_fn(|axis| &mount.place[axis] - &self.mounts[0].place[axis])
        };
        let mut apart = self.mounts.iter().map(from_first).filter(|arm| arm.iter().any(|part| !part.is_zero()));
        let Some(line) = apart.next() else { return Err(NoMounting::OnePlace) };
        let is_beside = |arm: [BigRational; 3]| {
            (0..3).any(|axis| {
                let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
                &arm[next] * &line[last] != &arm[last] * &line[next]
            })
        };
        if apart.any(is_beside) {
            return Ok(());
        }
        let longest = line.iter().max_by_key(|part| part.abs()).cloned().unwrap_or_default();
        Err(NoMounting::OneLine(Box::new(line.map(|part| part / &longest))))
    }

    /// The planes x = 0, y = 0, z = 0 through the centre of gravity about which body and mounts are symmetric, exactly.
    pub fn mirrors(&self) -> [bool; 3] {
        std::array::from_fn(|axis| self.is_mirrored(axis))
    }

    fn is_mirrored(&self, axis: usize) -> bool {
        let [xy, xz, yz] = &self.block.products;
        let beside = [[xy, xz], [xy, yz], [xz, yz]][axis];
        let centre = &self.block.centre[axis];
        let image = |mount: &Mount| {
            let mut image = mount.clone();
            image.place[axis] = centre + centre - &mount.place[axis];
            // A mirror turns the sense of every angle about an axis in its plane.
            for about in (0..3).filter(|about| *about != axis) {
                image.turned[about] = -&image.turned[about];
            }
            image
        };
        beside.iter().all(|product| product.is_zero())
            && self.mounts.iter().all(|mount| {
                let count = |of: &Mount| self.mounts.iter().filter(|other| *other == of).count();
                count(mount) == count(&image(mount))
            })
    }
}
