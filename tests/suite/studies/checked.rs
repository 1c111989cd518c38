//! Does a check of a study hold, and what is the case?

use crankstar::claim::{self, Provenance, parse_statement};
use crankstar::engine::{Engine, throws};
use crankstar::exact::PhasorSum;
use crankstar::file::{Template, parse_number};
use crankstar::numbers::{self, Form};
use crankstar::order::Factor;
use crankstar::proof::Sense;
use crankstar::remedy::{self, ComparableEngine};
use crankstar::sweep::{self, Sweep, Zeros};
use crankstar::text::Untrusted;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::check::{Check, CheckTable, Firing, Part, Values};
use super::flywheels::Flywheels;
use super::study::{Checked, Found, Studied, known};

fn flywheels(family: &Studied) -> Result<&Flywheels, String> {
    family.flywheels.as_ref().ok_or_else(|| format!("`{}` has no [family.flywheel]", family.name))
}

/// Where a part of a quantity of the family vanishes.
fn zeros<'a>(family: &'a Studied, part: &Part, of: Zeros) -> Result<&'a sweep::ZeroSet, String> {
    let sets = family.sweep.zeros.iter().flatten();
    let mut sets = sets.filter(|set| set.quantity == part.quantity && set.order == part.order && set.of == of);
    sets.next().ok_or_else(|| format!("`{}` was not computed", part.words))
}

/// Answers a check; `texts` are the layout files of the families.
pub(super) fn checked(
    check: &CheckTable,
    provenance: Provenance,
    families: &[Studied],
    texts: &[String],
    read_file: &dyn Fn(&str) -> Result<String, String>,
) -> Result<Checked, String> {
    let engine = check.engine.0.clone();
    let family = families.iter().position(|family| family.name == engine);
    let of_family = || family.map(|index| &families[index]).ok_or_else(|| format!("there is no family `{engine}`"));
    let layout = || {
        let text = match family {
            Some(index) => texts[index].clone(),
            None => read_file(&engine)?,
        };
        let template = Template::new(&engine, &text).map_err(|error| error.to_string())?;
        match (&check.at, family) {
            (Some(at), Some(index)) => {
                let key = &families[index].sweep.parameters[0].key;
                known(&template, &[(key, &at.0)])
            }
            (Some(_), None) => Err(format!("`{engine}` is not a family, so it has no `at`")),
            (None, _) => known(&template, &[]),
        }
    };
    let at_words = check.at.as_ref().map_or_else(String::new, |at| format!("at {}°: ", at.0));
    let (claim, holds, found) = match check.read()? {
        Check::Says(says) => {
            let statement =
                parse_statement(&says).map_err(|mistake| format!("{}; {}", mistake.message, mistake.right))?;
            let answer = claim::answer(&layout()?, &statement, None);
            (format!("{at_words}{says}"), answer.status.holds(), Found::Claim(Box::new((statement, answer))))
        }
        Check::Counterweight(expected) => {
            let sum = couple(&layout()?).ok_or_else(|| format!("`{engine}` needs no counterweights"))?;
            let (exact, decimal) = (numbers::modulus(&sum), numbers::evaluate(&sum).norm());
            let holds = is_written_so(&expected, exact.as_ref(), decimal);
            (format!("{at_words}m_cw ρ b = {expected} m r a"), holds, Found::Counterweight(exact))
        }
        Check::VolumeBelow(limit) => {
            let below = parse_number(&limit).map_err(|error| error.to_string())?.to_f64();
            let volumes = &of_family()?.volumes;
            let largest = volumes.iter().skip(1).flatten().copied().reduce(f64::max);
            let part = largest.zip(volumes.first().copied().flatten()).map(|(largest, in_line)| largest / in_line);
            let part = part.ok_or_else(|| format!("`{engine}` has no volumes"))?;
            let claim = format!("every volume is below {limit} times that in line");
            (claim, below.is_some_and(|below| part < below), Found::Volume(part))
        }
        Check::Flywheel { how, at } => {
            let found = flywheels(of_family()?)?.weigh(how);
            (format!("{} {}", how.in_words(), at.in_words()), at.are(&found, true), Found::Grid(found))
        }
        Check::TorqueVanishes { order, at } => {
            let found = flywheels(of_family()?)?.vanishing(order);
            let claim = format!("order {order} of the gas torque vanishes {}", at.in_words());
            (claim, at.are(&found, true), Found::Grid(found))
        }
        Check::Fires { how, at } => {
            let (difference, found) = fires(&of_family()?.sweep, how).ok_or("the cycle is not given")?;
            let claim = format!("{} {}", how.in_words(), at.in_words());
            (claim, at.are(&found, true), Found::Firing { difference, at: found })
        }
        Check::Vanishes { part, at } => {
            let set = zeros(of_family()?, &part, part.of)?;
            let mut found = set.at.clone();
            found.sort();
            let claim = at.as_ref().map_or_else(|| "everywhere".to_owned(), Values::in_words);
            // A zero at no rational turn is none of the values.
            let complete = set.complete && set.irrational.is_empty();
            let holds = match &at {
                None => set.everywhere,
                Some(Values::Among(_)) if set.everywhere => true,
                Some(values) => !set.everywhere && values.are(&found, complete),
            };
            let found = Found::Values { at: found, everywhere: set.everywhere, complete };
            (format!("{} vanishes {claim}", part.words), holds, found)
        }
        Check::Constant { part, at } => {
            // Of constant length where exactly one of the two vectors is left.
            let set = |of| zeros(of_family()?, &part, of);
            let (direct, reverse, both) = (set(Zeros::Direct)?, set(Zeros::Reverse)?, set(Zeros::Largest)?);
            let one_left = direct.at.iter().chain(&reverse.at).filter(|value| !both.at.contains(value));
            let mut found: Vec<BigRational> = one_left.cloned().collect();
            found.sort();
            let all_told = |set: &sweep::ZeroSet| set.complete && set.irrational.is_empty() && !set.everywhere;
            let complete = all_told(direct) && all_told(reverse);
            let claim = format!("{} is of constant length {}", part.words, at.in_words());
            (claim, at.are(&found, complete), Found::Values { at: found, everywhere: false, complete })
        }
    };
    let [engine, claim] = [engine, claim].map(Untrusted::new);
    Ok(Checked { engine, provenance, claim, holds, found })
}

/// Whether a number is the one that is written: as a closed form, or as a decimal rounded to its last place.
fn is_written_so(written: &str, exact: Option<&Form>, decimal: f64) -> bool {
    let places = written.split_once('.').map_or(0, |(_, places)| places.len() as i32);
    let half_a_place = 0.5 * 0.1_f64.powi(places);
    match written.parse::<f64>() {
        Ok(value) => (decimal - value).abs() <= half_a_place,
        Err(_) => exact.is_some_and(|form| form.to_string() == written),
    }
}

/// `m_cw ρ b` of two counterweights in the outermost throws, in multiples of m r and the unit of the positions.
fn couple(layout: &Engine) -> Option<PhasorSum> {
    let subject = ComparableEngine::new(layout).ok()?;
    let throws = throws(subject.engine());
    let ends = [throws.iter().map(|t| &t.position).max()?.clone(), throws.iter().map(|t| &t.position).min()?.clone()];
    let apart = (&ends[0] - &ends[1]).abs();
    let (force, moment) = (subject.force(1, Sense::Direct), subject.moment(1, Sense::Direct));
    let weights = remedy::two_planes(1, Sense::Direct, &force, &moment, &ends);
    // What stands before a number of the motion is no mass-radius.
    let (_, plain) = weights.first()?.vector.only().filter(|(factor, _)| **factor == Factor::One)?;
    Some(plain.scaled(&apart))
}

/// Where on the grid the firing is so, with the least or the greatest difference of its intervals.
fn fires(sweep: &Sweep, how: Firing) -> Option<(Option<BigRational>, Vec<BigRational>)> {
    let differences: Vec<(BigRational, BigRational)> = sweep
        .points
        .iter()
        .filter_map(|point| Some((point.values.first()?.clone(), point.evenness.as_ref()?.unevenness())))
        .collect();
    let all = differences.iter().map(|(_, difference)| difference);
    let met_by = |bound: &BigRational| {
        let met = differences.iter().filter(|(_, difference)| difference == bound);
        (Some(bound.clone()), met.map(|(value, _)| value.clone()).collect())
    };
    Some(match how {
        Firing::LeastUneven => met_by(all.min()?),
        Firing::MostUneven => met_by(all.max()?),
        Firing::MoreEvenThanBefore => {
            let steps = differences.windows(2).filter(|pair| pair[1].1 < pair[0].1);
            (None, steps.map(|pair| pair[1].0.clone()).collect())
        }
    })
}
