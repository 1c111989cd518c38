//! How is a certificate written in Coq? In whole numbers: angles times a conductor, weights times a scale.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::proof::{Certificate, Document, Polygon, Step, Vector};

/// What all angles and all weights of some vectors become whole by.
#[derive(Clone)]
pub(super) struct Grid {
    pub conductor: BigInt,
    pub scale: BigInt,
}

impl Grid {
    /// That of the vectors of a sum.
    pub fn of<'a>(vectors: impl Iterator<Item = &'a Vector>) -> Self {
        Grid::of_pairs(vectors.map(|vector| (&vector.angle, &vector.weight)))
    }

    /// That of angles with weights.
    pub fn of_pairs<'a>(pairs: impl Iterator<Item = (&'a BigRational, &'a BigRational)>) -> Self {
        pairs.fold(Grid::one(), |grid, (angle, weight)| Grid {
            conductor: grid.conductor.lcm(angle.denom()),
            scale: grid.scale.lcm(weight.denom()),
        })
    }

    /// That of whole numbers.
    pub fn one() -> Self {
        Grid { conductor: BigInt::one(), scale: BigInt::one() }
    }

    /// That of the products of a vector of each.
    pub fn product(self, other: Self) -> Self {
        Grid { conductor: self.conductor.lcm(&other.conductor), scale: self.scale * other.scale }
    }

    /// That of the vectors of both.
    pub fn common(&self, other: &Self) -> Self {
        Grid { conductor: self.conductor.lcm(&other.conductor), scale: self.scale.lcm(&other.scale) }
    }

    /// That of the products of two vectors.
    pub fn squared(self) -> Self {
        Grid { scale: &self.scale * &self.scale, ..self }
    }

    fn with(self, certificate: &Certificate) -> Self {
        let Grid { mut conductor, mut scale } = self;
        match certificate {
            Certificate::Polygons { polygons } => {
                for Polygon { sides, rotation, weight } in polygons {
                    conductor = conductor.lcm(&BigInt::from(*sides)).lcm(rotation.denom());
                    scale = scale.lcm(weight.denom());
                }
            }
            Certificate::Residue(residue) => conductor = conductor.lcm(&residue.conductor),
            Certificate::Splitting { .. } => (),
        }
        Grid { conductor, scale }
    }

    fn angle(&self, angle: &BigRational) -> BigInt {
        (angle * BigRational::from_integer(self.conductor.clone())).to_integer()
    }

    fn weight(&self, weight: &BigRational) -> BigInt {
        (weight * BigRational::from_integer(self.scale.clone())).to_integer()
    }
}

/// The certificate as `Evidence` of Checker.v; nothing where the image of a residue would vanish, because the
/// scale that all terms need holds its prime once more than that of the collected ones.
pub(super) fn evidence(grid: Grid, certificate: &Certificate) -> Option<String> {
    let grid = grid.with(certificate);
    let certified = match certificate {
        Certificate::Polygons { polygons } => {
            let polygon = |polygon: &Polygon| {
                let (corner, weight) = (grid.angle(&polygon.rotation), grid.weight(&polygon.weight));
                format!("({}, {corner}, {weight})", polygon.sides)
            };
            format!("Polygons {}", list(polygons.iter().map(polygon).collect()))
        }
        Certificate::Residue(residue) if (&grid.scale / &residue.scale % &residue.prime).is_zero() => return None,
        Certificate::Residue(residue) => {
            format!("Residue {} {} {}", residue.conductor, residue.prime, residue.root)
        }
        Certificate::Splitting { steps } => {
            let step = |step: &Step| match step {
                Step::Class { angle, modulus } => {
                    format!("Class {} {} {modulus}", whole(angle.numer()), angle.denom())
                }
                Step::Compare { prime, first, second } => format!("Compare {prime} {first} {second}"),
            };
            format!("Split {}", list(steps.iter().map(step).collect()))
        }
    };
    Some(format!("(Evidence {} {} ({certified}))", grid.conductor, grid.scale))
}

fn whole(number: &BigInt) -> String {
    if number < &BigInt::zero() { format!("({number})") } else { number.to_string() }
}

/// A fraction; its numerator may be negative.
pub(super) fn fraction(number: &BigRational) -> String {
    format!("({} # {})", number.numer(), number.denom())
}

/// A list of Coq.
pub(super) fn list(entries: Vec<String>) -> String {
    if entries.is_empty() { "nil".to_owned() } else { format!("[:: {}]", entries.join("; ")) }
}

/// That of every order: an angle of order k is a whole combination of throws and banks, a weight one of masses times arms.
pub(super) fn grid_of(document: &Document) -> Grid {
    let arm = |position: &BigRational| position - &document.reference_plane;
    let cylinders = document.cylinders.iter().flat_map(|cylinder| {
        let weight = &cylinder.reciprocating_mass * &cylinder.crank_radius;
        let moment = &weight * arm(&cylinder.position);
        [(&cylinder.throw, weight), (&cylinder.bank, moment)]
    });
    let turning = document.turning_masses.iter().flat_map(|mass| {
        let moment = &mass.mass_radius * arm(&mass.position);
        [(&mass.angle, mass.mass_radius.clone()), (&mass.angle, moment)]
    });
    let all: Vec<(&BigRational, BigRational)> = cylinders.chain(turning).collect();
    Grid::of_pairs(all.iter().map(|(angle, weight)| (*angle, weight)))
}
