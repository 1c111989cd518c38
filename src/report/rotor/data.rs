//! Which columns hold what balances masses on a shaft? A row a mass of a solution, and what is left or what a locomotive does.

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use crate::numbers;
use crate::report::data::Filling;
use crate::report::rotor::{LeftOver, RotorStudy};
use crate::rotor::Found;
use crate::table::{Table, Unit};

/// A table of masses on a shaft.
pub fn table(study: &RotorStudy, name: &str) -> Option<Table> {
    match name {
        "masses" => Some(masses(study)),
        "left" => Some(left(study)),
        _ => None,
    }
}

fn masses(study: &RotorStudy) -> Table {
    let rows =
        study.solutions().iter().enumerate().flat_map(|(place, all)| all.iter().map(move |one| (place + 1, one)));
    let mut table = Filling::new("rotor.masses", rows).keyed(2);
    let of = |one: &Found| &study.rotor.masses[one.index];
    table.whole("solution", |row| row.0);
    table.person("mass", |row| Some(of(row.1).name.clone()));
    table.decimal("mass_{unit}", Unit::KILOGRAM, |row| {
        let mass = of(row.1);
        let by_radius = mass.radius.as_ref().map(|radius| row.1.mass_radius.decimal / numbers::float(radius));
        mass.mass.as_ref().and_then(BigRational::to_f64).or(by_radius)
    });
    table.decimal("radius_{unit}", Unit::METRE, |row| {
        let mass = of(row.1);
        let by_mass = mass
            .mass
            .as_ref()
            .filter(|mass| mass.is_positive())
            .map(|mass| row.1.mass_radius.decimal / numbers::float(mass));
        mass.radius.as_ref().and_then(BigRational::to_f64).or(by_mass)
    });
    table.decimal("mass_radius_{unit}", Unit::KILOGRAM_METRE, |row| Some(row.1.mass_radius.decimal));
    table.decimal("angle_{unit}", Unit::DEGREE, |row| (row.1.mass_radius.decimal != 0.0).then_some(row.1.angle));
    table.exact("cosine_exact", Unit::NONE, |row| row.1.cosine.as_ref().map(ToString::to_string));
    table.decimal("position_{unit}", Unit::METRE, |row| row.1.position.as_ref().map(|one| one.decimal));
    table.done()
}

fn left(study: &RotorStudy) -> Table {
    let rows = study.left().into_iter().chain(study.of_second_order()).chain(study.of_locomotive());
    let mut table = Filling::new("rotor.left", rows);
    table.words("what", |row| Some(row.column.to_owned()));
    table.truth("vanishes", |row| Some(row.vanishes()));
    let of = |is_couple: bool, by: f64| move |row: &LeftOver| (row.is_couple == is_couple).then(|| by * row.length());
    table.decimal("mass_radius_{unit}", Unit::KILOGRAM_METRE, of(false, 1.0));
    table.decimal("couple_{unit}", Unit::KILOGRAM_SQUARE_METRE, of(true, 1.0));
    let at_speed = |is_couple: bool| {
        let omega_squared = study.omega_squared();
        move |row: &LeftOver| omega_squared.filter(|_| !row.is_secondary).and_then(|by| of(is_couple, by)(row))
    };
    table.decimal("force_{unit}", Unit::NEWTON, at_speed(false));
    table.decimal("moment_{unit}", Unit::NEWTON_METRE, at_speed(true));
    table.done()
}
