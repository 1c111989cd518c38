//! Which columns hold the verdicts of `classify`? A row an order, and a row a sum with its kind of evidence.

use super::super::remaining::RemainingOrder;
use super::super::typeset::signed_degrees;
use super::cells::exact_number;
use super::filling::Filling;
use super::verdicts::{of_orders, units};
use crate::engine::Engine;
use crate::exact::{PhasorSum, Term, Turn};
use crate::loads::Arm;
use crate::numbers::{self, Direction};
use crate::order::Masses;
use crate::proof::{Certificate, Document, Quantity, VerdictClaim};
use crate::table::{Table, Unit};
use crate::verdict::Judgement;

/// The tables of the verdicts: the orders, the sums that they are made of, those of torque and roll moment where they are asked for.
pub fn classify(engine: &Engine, judged: &Judgement, document: &Document) -> Vec<Table> {
    let of = |quantity| -> Vec<&VerdictClaim> {
        document.verdicts.iter().filter(|verdict| verdict.quantity == quantity).collect()
    };
    let (force, moment) = (of(Quantity::FORCE), of(Quantity::MOMENT));
    let both: Vec<[&VerdictClaim; 2]> = force.into_iter().zip(moment).map(|(force, moment)| [force, moment]).collect();
    let about_the_axis =
        [("classify.torque", "torque", of(Quantity::TORQUE)), ("classify.roll", "roll", of(Quantity::ROLL))];
    let about_the_axis = about_the_axis.into_iter().filter(|(_, _, rows)| !rows.is_empty());
    let tables = about_the_axis.map(|(path, name, rows)| axis_sums(path, name, &rows));
    [orders(engine, judged), sums(engine, &both)].into_iter().chain(tables).collect()
}

fn orders(engine: &Engine, judged: &Judgement) -> Table {
    let pistons = judged.pistons.iter().flatten().map(|order| (masses_name(Masses::Reciprocating), order));
    let all = judged.orders.iter().map(|order| (masses_name(judged.masses), order)).chain(pistons);
    let rows = all.flat_map(|(masses, verdict)| {
        let order = RemainingOrder::new(verdict);
        let parts = order.parts.clone();
        [order].into_iter().chain(parts).map(move |order| (masses, order))
    });
    let [_, moment] = units(engine);
    let mut table = Filling::new("classify.orders", rows);
    table.whole("order", |(_, order)| order.order as usize);
    table.words("masses", |(masses, _)| Some((*masses).to_owned()));
    table.words("of", |(_, order)| order.of.clone());
    of_orders(&mut table, |(_, order)| order, &[moment], |_| moment);
    table.done()
}

fn masses_name(masses: Masses) -> &'static str {
    match masses {
        Masses::Reciprocating => "reciprocating",
        Masses::Rotating => "rotating",
        Masses::Counterweights => "counterweights",
        Masses::All => "all",
    }
}

/// A row a vector of an order: the direct, the reverse, of each class of sources.
fn sums(engine: &Engine, rows: &[[&VerdictClaim; 2]]) -> Table {
    let mut table = Filling::new("classify.sums", rows).keyed(2);
    table.whole("order", |[force, _]| force.order as usize);
    table.words("sense", |[force, _]| force.sense.map(|sense| sense.name().to_owned()));
    of(&mut table, |[force, _]| force);
    let moment = match Arm::of(engine) {
        Arm::Metre => Unit::MASS_RADIUS_METRE,
        Arm::Spacing => Unit::MASS_RADIUS_SPACING,
    };
    sum(&mut table, "force", Unit::MASS_RADIUS, |[force, _]| force);
    sum(&mut table, "moment", moment, |[_, moment]| moment);
    table.done()
}

fn axis_sums(path: &'static str, name: &'static str, rows: &[&VerdictClaim]) -> Table {
    let mut table = Filling::new(path, rows);
    table.whole("order", |verdict| verdict.order as usize);
    of(&mut table, |verdict| verdict);
    sum(&mut table, name, Unit::MASS_RADIUS_SQUARED, |verdict| verdict);
    table.done()
}

fn of<R>(table: &mut Filling<R>, verdict: impl Fn(&R) -> &VerdictClaim) {
    table.words("of", |row| Some(verdict(row).of.join(" ")).filter(|of| !of.is_empty()));
}

/// The length of a sum, its direction, its evidence.
fn sum<R>(table: &mut Filling<R>, quantity: &'static str, unit: Unit, verdict: impl Fn(&R) -> &VerdictClaim) {
    table.truth(("{quantity}_vanishes", quantity), |row| Some(verdict(row).vanishes));
    table.decimal(("{quantity}_modulus_{unit}", quantity), unit, |row| Some(verdict(row).modulus));
    table.exact(("{quantity}_modulus_exact", quantity), Unit::NONE, |row| modulus(verdict(row)));
    table.decimal(("{quantity}_angle_{unit}", quantity), Unit::DEGREE, |row| verdict(row).angle_deg);
    table.exact(("{quantity}_angle_{unit}_exact", quantity), Unit::DEGREE, |row| angle(verdict(row)));
    table.words(("{quantity}_evidence", quantity), |row| Some(evidence(&verdict(row).certificate).to_owned()));
}

fn star(verdict: &VerdictClaim) -> PhasorSum {
    let term = |term: &crate::proof::Vector| Term { angle: Turn::new(term.angle.clone()), weight: term.weight.clone() };
    PhasorSum::new(verdict.terms.iter().map(term).collect())
}

fn modulus(verdict: &VerdictClaim) -> Option<String> {
    if verdict.vanishes { Some("0".to_owned()) } else { numbers::modulus(&star(verdict)).map(|form| form.to_string()) }
}

fn angle(verdict: &VerdictClaim) -> Option<String> {
    if verdict.vanishes {
        return None;
    }
    match numbers::direction_of(&star(verdict))? {
        Direction::Turn(turn) => Some(exact_number(&signed_degrees(&turn))),
        Direction::Arctangent { .. } | Direction::Turned { .. } => None,
    }
}

fn evidence(certificate: &Certificate) -> &'static str {
    match certificate {
        Certificate::Polygons { .. } => "polygons",
        Certificate::Residue(_) => "residue",
        Certificate::Splitting { .. } => "splitting",
    }
}
