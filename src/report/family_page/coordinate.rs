//! How is a zero told at which multiples of φ and δ come to angles?

use num_rational::BigRational;

use super::circle_words::middle;
use super::unknowns::{alternatives, exactly, name, near};
use crate::exact::Turn;
use crate::family::{Place, Root, is_in_range};
use crate::numbers::Direction;
use crate::page::number::Bearing;
use crate::page::{Text, phrase};

/// What a multiple of φ and one of δ add up to at a zero: `δ ≡ 90°`.
pub(super) struct Coordinate {
    place: Place,
    told: Text,
}

impl Coordinate {
    pub fn exact(times: &[BigRational; 2], turns: &BigRational) -> Self {
        let told = exactly(name(times), &Turn::new(turns.clone()));
        Coordinate { place: Place::exact(times, turns), told: Text::label(told) }
    }

    pub fn near(times: &[BigRational; 2], degrees: f64) -> Self {
        Coordinate { place: Place::near(times, degrees), told: near(&name(times), degrees) }
    }

    /// Between two ends, told by their middle.
    pub fn between(times: &[BigRational; 2], ends: [&BigRational; 2]) -> Self {
        let told = near(&name(times), middle(ends));
        Coordinate { place: Place { times: times.clone(), ends: ends.map(Clone::clone) }, told }
    }

    pub fn of(times: &[BigRational; 2], Root { exact, degrees }: &Root) -> Self {
        match exact {
            Some(Direction::Turn(turn)) => Coordinate::exact(times, turn.turns()),
            None => Coordinate::near(times, degrees.rem_euclid(360.0)),
            Some(_) => {
                let told = phrase!("{} ≡ {}", name(times), Bearing { exact: exact.clone(), decimal: *degrees });
                Coordinate { place: Place::near(times, *degrees), told }
            }
        }
    }
}

/// `δ ≡ 90° and φ ≡ 60°, or δ ≡ 180°`: those with φ and δ in the range; none where there is none.
pub(super) fn in_words(zeros: impl IntoIterator<Item = Vec<Coordinate>>) -> Option<Text> {
    let told = |zero: Vec<Coordinate>| {
        let (places, told): (Vec<Place>, Vec<Text>) = zero.into_iter().map(|one| (one.place, one.told)).unzip();
        is_in_range(&places).then(|| Text::joined(told, " and "))
    };
    alternatives(zeros.into_iter().filter_map(told))
}
