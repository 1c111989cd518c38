//! What is the body on its mounts in matrices, which modes has it, and how does it answer a force?

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Matrix3x6, Matrix6, Vector3, Vector6};
use num_complex::Complex;
use num_rational::BigRational;

use super::Phasors;
use crate::engine::{Mount, Mounting};
use crate::exact::Turn;
use crate::numbers;

/// A mode whose loss factor is no larger has none.
const LEAST_LOSS: f64 = 1e-12;

/// A rigid body on springs and dampers.
#[derive(Clone, Debug)]
pub struct Body {
    pub(super) mass: Matrix6<f64>,
    pub(super) stiffness: Matrix6<f64>,
    pub(super) damping: Matrix6<f64>,
    /// `Σ η_j K_j`: what the loss factors add to K, times i.
    pub(super) loss: Matrix6<f64>,
    mounts: Vec<Holder>,
    centre: Vector3<f64>,
}

/// A mount: how far the body moves it, and what it answers, along x, y and z.
#[derive(Clone, Debug)]
struct Holder {
    place: Vector3<f64>,
    moves: Matrix3x6<f64>,
    stiffness: Matrix3<f64>,
    damping: Matrix3<f64>,
    loss_factor: f64,
}

/// A way in which the body vibrates on undamped mounts.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Angular frequency in radians a second.
    pub omega: f64,
    /// x, y, z of the centre of gravity and the rotations about them, so that `φᵀMφ = 1`.
    pub shape: [f64; 6],
    /// The part of the kinetic energy in each of these: `φ_i (Mφ)_i`. They add up to 1; one may be below 0.
    pub shares: [f64; 6],
}

impl Mode {
    /// Frequency in oscillations a second.
    pub fn hertz(&self) -> f64 {
        self.omega / TAU
    }
}

/// How the body moves at one frequency, `Re(· e^{iΩt})`.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// Ω in radians a second.
    pub omega: f64,
    /// The centre of gravity, in metres.
    pub centre: Phasors,
    /// The rotation, in radians.
    pub turned: Phasors,
}

fn vector(values: &[BigRational; 3]) -> Vector3<f64> {
    Vector3::from(values.each_ref().map(numbers::float))
}

/// `[1, −[arm]×]`: how far a point at this arm moves with the body.
fn moves(arm: &Vector3<f64>) -> Matrix3x6<f64> {
    let mut moves = Matrix3x6::zeros();
    moves.fixed_columns_mut::<3>(0).copy_from(&Matrix3::identity());
    moves.fixed_columns_mut::<3>(3).copy_from(&-arm.cross_matrix());
    moves
}

/// The axes of a mount as columns.
fn axes(mount: &Mount) -> Matrix3<f64> {
    let turn = |axis: usize| {
        let direction = numbers::direction(&Turn::new(mount.turned[axis].clone()));
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut matrix = Matrix3::identity();
        matrix[(next, next)] = direction.re;
        matrix[(last, last)] = direction.re;
        matrix[(next, last)] = -direction.im;
        matrix[(last, next)] = direction.im;
        matrix
    };
    turn(2) * turn(1) * turn(0)
}

impl Body {
    /// The matrices of an engine on its mounts.
    pub fn new(mounting: &Mounting) -> Self {
        let block = &mounting.block;
        let centre = vector(&block.centre);
        let mut mass = Matrix6::from_diagonal_element(numbers::float(&block.mass));
        let tensor = block.tensor();
        mass.fixed_view_mut::<3, 3>(3, 3)
            .copy_from(&Matrix3::from_fn(|row, column| numbers::float(&tensor[row][column])));
        let holder = |mount: &Mount| {
            let (place, axes) = (vector(&mount.place), axes(mount));
            let along = |values| axes * Matrix3::from_diagonal(&vector(values)) * axes.transpose();
            Holder {
                moves: moves(&(place - centre)),
                stiffness: along(&mount.stiffness),
                damping: along(&mount.damping),
                loss_factor: numbers::float(&mount.loss_factor),
                place,
            }
        };
        let mounts: Vec<Holder> = mounting.mounts.iter().map(holder).collect();
        let sum = |of: &dyn Fn(&Holder) -> Matrix3<f64>| {
            let add = |sum: Matrix6<f64>, mount: &Holder| sum + mount.moves.transpose() * of(mount) * mount.moves;
            let sum = mounts.iter().fold(Matrix6::zeros(), add);
            (sum + sum.transpose()) * 0.5
        };
        Body {
            mass,
            stiffness: sum(&|mount| mount.stiffness),
            damping: sum(&|mount| mount.damping),
            loss: sum(&|mount| mount.stiffness * mount.loss_factor),
            centre,
            mounts,
        }
    }

    /// The six modes, rising, damping left out; none where decimals cannot hold the body's inertia.
    pub fn modes(&self) -> Vec<Mode> {
        let Some(roots) = self.mass.cholesky() else { return Vec::new() };
        let lower = roots.l();
        let Some(inverse) = lower.try_inverse() else { return Vec::new() };
        let scaled = inverse * self.stiffness * inverse.transpose();
        let eigen = ((scaled + scaled.transpose()) * 0.5).symmetric_eigen();
        let mut modes: Vec<Mode> = (0..6)
            .map(|number| {
                let shape: Vector6<f64> = inverse.transpose() * eigen.eigenvectors.column(number);
                let shares = shape.component_mul(&(self.mass * shape));
                let sign = if shape[shares.imax()] < 0.0 { -1.0 } else { 1.0 };
                Mode {
                    omega: eigen.eigenvalues[number].max(0.0).sqrt(),
                    shape: (shape * sign).into(),
                    shares: shares.into(),
                }
            })
            .collect();
        modes.sort_by(|one, other| one.omega.total_cmp(&other.omega));
        modes
    }

    /// Whether nothing damps it.
    pub fn is_undamped(&self) -> bool {
        self.damping == Matrix6::zeros() && self.loss == Matrix6::zeros()
    }

    /// Whether a mode loses energy in the mounts, beyond rounding.
    pub fn is_damped(&self, mode: &Mode) -> bool {
        let shape = Vector6::from(mode.shape);
        let lost = shape.dot(&((self.loss + self.damping * mode.omega) * shape));
        lost > LEAST_LOSS * mode.omega * mode.omega
    }

    /// The motion under forces in newtons and moments about the centre of gravity in newton-metres at Ω; none at a natural frequency of
    /// an undamped body.
    pub fn motion(&self, omega: f64, force: Phasors, moment: Phasors) -> Option<Motion> {
        let real = self.stiffness - self.mass * (omega * omega);
        let imaginary = self.loss + self.damping * omega;
        let impedance = real.zip_map(&imaginary, Complex::new);
        let [fx, fy, fz] = force;
        let [mx, my, mz] = moment;
        let [x, y, z, rx, ry, rz]: [Complex<f64>; 6] =
            impedance.lu().solve(&Vector6::new(fx, fy, fz, mx, my, mz))?.into();
        let motion = Motion { omega, centre: [x, y, z], turned: [rx, ry, rz] };
        motion.all().iter().all(|part| part.is_finite()).then_some(motion)
    }

    /// What a mount passes on to the ground, `(K(1 + iη) + iΩC) B q` in newtons, along x, y and z.
    pub fn mount_force(&self, mount: usize, motion: &Motion) -> Phasors {
        let holder = &self.mounts[mount];
        let deflection = self.at(&holder.place, motion);
        let complex = |real: f64, imaginary: f64| Complex::new(real, imaginary);
        let answer = (holder.stiffness)
            .zip_map(&(holder.stiffness * holder.loss_factor + holder.damping * motion.omega), complex);
        (answer * Vector3::from(deflection)).into()
    }

    /// How many mounts there are.
    pub fn mounts(&self) -> usize {
        self.mounts.len()
    }

    /// How far the seat of a mount moves, in metres.
    pub fn at_mount(&self, mount: usize, motion: &Motion) -> Phasors {
        self.at(&self.mounts[mount].place, motion)
    }

    /// How far a point of the body moves, in metres.
    pub fn at_point(&self, point: &[BigRational; 3], motion: &Motion) -> Phasors {
        self.at(&vector(point), motion)
    }

    fn at(&self, place: &Vector3<f64>, motion: &Motion) -> Phasors {
        let moves = moves(&(place - self.centre)).map(|part| Complex::new(part, 0.0));
        (moves * Vector6::from(motion.all())).into()
    }
}

impl Motion {
    /// Centre of gravity and rotation.
    pub fn all(&self) -> [Complex<f64>; 6] {
        let ([x, y, z], [rx, ry, rz]) = (self.centre, self.turned);
        [x, y, z, rx, ry, rz]
    }
}
