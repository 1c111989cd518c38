//! Which columns hold what balances masses on a shaft? A row a mass of a solution, and what is left or what a locomotive does.

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::filling::Filling;
use crate::exact::PhasorSum;
use crate::numbers;
use crate::report::rotor::RotorStudy;
use crate::rotor::{Answer, Found};
use crate::table::{Table, Unit};

/// A table of masses on a shaft.
pub fn rotor(study: &RotorStudy, name: &str) -> Option<Table> {
    match name {
        "masses" => Some(masses(study)),
        "left" => Some(left(study)),
        _ => None,
    }
}

fn masses(study: &RotorStudy) -> Table {
    let rows: Vec<(usize, &Found)> = study
        .solutions()
        .iter()
        .enumerate()
        .flat_map(|(place, all)| all.iter().map(move |one| (place + 1, one)))
        .collect();
    let mut table = Filling::new("rotor.masses", &rows).keyed(2);
    let of = |one: &Found| study.rotor.masses[one.index].clone();
    table.whole("solution", |row| row.0);
    table.person("mass", |row| Some(of(row.1).name));
    table.decimal("mass_{unit}", Unit::KILOGRAM, |row| {
        let mass = of(row.1);
        let by_radius = mass.radius.as_ref().map(|radius| row.1.mass_radius.decimal / numbers::float(radius));
        mass.mass.as_ref().and_then(BigRational::to_f64).or(by_radius)
    });
    table.decimal("radius_{unit}", Unit::METRE, |row| {
        let mass = of(row.1);
        let by_mass =
            mass.mass.filter(Signed::is_positive).map(|mass| row.1.mass_radius.decimal / numbers::float(&mass));
        mass.radius.as_ref().and_then(BigRational::to_f64).or(by_mass)
    });
    table.decimal("mass_radius_{unit}", Unit::KILOGRAM_METRE, |row| Some(row.1.mass_radius.decimal));
    table.decimal("angle_{unit}", Unit::DEGREE, |row| (row.1.mass_radius.decimal != 0.0).then_some(row.1.angle));
    table.exact("cosine_exact", Unit::NONE, |row| row.1.cosine.as_ref().map(ToString::to_string));
    table.decimal("position_{unit}", Unit::METRE, |row| row.1.position.as_ref().map(|one| one.decimal));
    table.done()
}

fn left(study: &RotorStudy) -> Table {
    let mut rows: Vec<(&'static str, &PhasorSum, bool)> = Vec::new();
    if let Answer::Left(sums) = &study.answer {
        rows.extend([("force", &sums[0], true), ("couple", &sums[1], false)]);
    }
    if let Some(locomotive) = &study.locomotive {
        let [one, other] = &locomotive.hammer_blow;
        rows.extend([("hammer_blow_1", one, true), ("hammer_blow_2", other, true)]);
        rows.extend([("tractive", &locomotive.tractive, true), ("swaying", &locomotive.swaying, false)]);
    }
    let mut table = Filling::new("rotor.left", &rows);
    table.words("what", |row| Some(row.0.to_owned()));
    table.truth("vanishes", |row| Some(row.1.vanishes()));
    let size = |row: &(&'static str, &PhasorSum, bool)| match row.1.vanishes() {
        true => 0.0,
        false => numbers::length(numbers::evaluate(row.1)),
    };
    table.decimal("mass_radius_{unit}", Unit::KILOGRAM_METRE, |row| row.2.then(|| size(row)));
    table.decimal("couple_{unit}", Unit::KILOGRAM_SQUARE_METRE, |row| (!row.2).then(|| size(row)));
    let omega_squared = study.omega_squared();
    table.decimal("force_{unit}", Unit::NEWTON, |row| omega_squared.filter(|_| row.2).map(|by| by * size(row)));
    table.decimal("moment_{unit}", Unit::NEWTON_METRE, |row| omega_squared.filter(|_| !row.2).map(|by| by * size(row)));
    table.done()
}
