//! Do the numbers of `loads` agree with the verdicts beside them, and with each other?

use std::collections::BTreeSet;

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::agreement::{agrees, check_title};
use super::audit::{Audit, Fault, demand, refuse_if};
use super::decimals::Size;
use super::document::Document;
use super::engine::Masses;
use super::judged::Judged;
use super::motion::Motion;
use super::outside::{Effect, LOADS_NOT_CHECKED, Loads, LoadsTorque, Scale};
use super::quantity::{Quantity, Sense};
use super::sizes::{Length, Shown, Swing, is_near, of_rod};

/// Every order of the evidence has its numbers: those of the force, the same of the moment, those of the torque.
pub(super) fn check_loads(loads: &Loads, evidence: &Document, judged: &[Judged], audit: &Audit) -> Result<(), Fault> {
    check_title("title", &loads.title, evidence)?;
    demand(loads.not_checked == LOADS_NOT_CHECKED, Fault::new("not_checked", "these are not all, or more"))?;
    let why = "they are newtons where there is a scale, and multiples where there is none";
    demand(loads.units.are_newtons() == Some(loads.scale.is_some()), Fault::new("units", why))?;
    let one = BigRational::one();
    let scale = loads.scale.as_ref().map(|scale| check_scale("scale", scale)).transpose()?;
    let [force, of_torque] = scale.unwrap_or_else(|| [one.clone(), one.clone()]);
    let is_at_rest = force.is_zero();
    let motion = Motion::new(audit);
    let find = |at: &str, quantity: Quantity, order: u32| {
        let found = judged.iter().find(|one| (one.quantity, one.order) == (quantity, order));
        found.ok_or_else(|| Fault::new(at, "the evidence says nothing of it"))
    };
    // The quantities of which something is left in the orders that are listed.
    let mut left = BTreeSet::new();
    for (index, entry) in loads.orders.iter().enumerate() {
        let at = |key: &str| format!("orders[{index}].{key}");
        let found = find(&at("order"), entry.quantity, entry.order)?;
        if found.wholes.len() != 2 {
            return Err(Fault::new(at("quantity"), "it has no sense"));
        }
        let swing = Swing::of(found, &motion).map_err(|reason| Fault { place: at("order"), reason })?;
        let vanish = [0, 1].map(|sense| found.vanishes(sense));
        for (sense, vector) in [&entry.direct, &entry.reverse].into_iter().enumerate() {
            let at = |key: &str| at(&format!("{}.{key}", Sense::BOTH[sense].name()));
            let (sum, vanishes) = (&swing.sums[sense], vanish[sense]);
            sum.length.is_size(&at("amplitude"), vector.amplitude, &force, vanishes == Some(true))?;
            sum.points(&at("angle_deg"), vector.angle_deg, 360, vanishes, audit)?;
            if let Some(below) = vector.below {
                refuse_if(vanishes.is_some(), Fault::new(at("below"), "what is decided has no bound"))?;
                agrees(&at("below"), below, is_at_rest)?;
            }
        }
        let is_zero = vanish == [Some(true); 2];
        swing.largest.is_size(&at("largest"), entry.largest, &force, is_zero)?;
        swing.largest.is_size(&at("dimensionless"), entry.dimensionless, &one, is_zero)?;
        // It is a circle where one is zero, and has an axis where neither is.
        let has_none = if vanish.contains(&Some(true)) { Some(true) } else { vanish[0].and(vanish[1]) };
        swing.axis.points(&at("direction_deg"), entry.direction_deg, 180, has_none, audit)?;
        let [along, across] = &swing.parts;
        for (key, size, right) in [
            ("smallest", entry.smallest, &swing.smallest),
            ("along", entry.along, along),
            ("across", entry.across, across),
        ] {
            is_near(&at(key), size.shown(), &(right * &force), &(&swing.largest.slack * &force))?;
        }
        if !is_zero {
            left.insert(entry.quantity);
        }
    }
    for (name, quantity, entries) in
        [("torque", Quantity::TORQUE, &loads.torque), ("roll", Quantity::ROLL, &loads.roll)]
    {
        for (index, entry) in entries.iter().enumerate() {
            let at = |key: &str| format!("{name}[{index}].{key}");
            let found = find(&at("order"), quantity, entry.order)?;
            let sum = Shown::of(found, 0, &motion).map_err(|reason| Fault { place: at("order"), reason })?;
            let is_zero = found.vanishes(0) == Some(true);
            sum.length.is_size(&at("amplitude"), entry.amplitude, &of_torque, is_zero)?;
            sum.length.is_size(&at("dimensionless"), entry.dimensionless, &one, is_zero)?;
            sum.points(&at("phase_deg"), entry.phase_deg, 360, found.vanishes(0), audit)?;
            if !is_zero {
                left.insert(quantity);
            }
        }
    }
    // Those of which something is left in any order of the evidence.
    let is_left = |one: &&Judged| !(0..one.wholes.len()).all(|sense| one.vanishes(sense) == Some(true));
    let of_all: BTreeSet<Quantity> = judged.iter().filter(is_left).map(|one| one.quantity).collect();
    check_peaks(loads, evidence, is_at_rest, [&left, &of_all])?;
    check_coefficients(loads, evidence, &motion)?;
    check_orders(loads, evidence)
}

/// Checks a scale; returns m r ω² and m r² ω², which are 0 of an engine at rest.
pub(super) fn check_scale(place: &str, scale: &Scale) -> Result<[BigRational; 2], Fault> {
    let at = |key: &str| format!("{place}.{key}");
    let exact = |size: Size| BigRational::from_float(size.shown()).unwrap_or_default();
    let [mass, radius, speed] = [scale.mass_kg, scale.crank_radius_m, scale.speed_rpm].map(exact);
    agrees(&at("mass_kg"), scale.mass_kg, false)?;
    agrees(&at("crank_radius_m"), scale.crank_radius_m, false)?;
    let (omega, force) = (scale.angular_speed_rad_s, scale.m_r_omega_squared_n);
    let one = BigRational::one();
    // 2π/60, to 20 digits.
    let a_minute = BigRational::new(10_471_975_511_965_977_462_u128.into(), 100_000_000_000_000_000_000_u128.into());
    Length::of(a_minute * speed, BigRational::zero()).is_size(
        &at("angular_speed_rad_s"),
        omega,
        &one,
        scale.speed_rpm.is_nothing(),
    )?;
    let omega = exact(omega);
    let right = Length::of(&mass * &radius * &omega * omega, BigRational::zero());
    right.is_size(&at("m_r_omega_squared_n"), force, &one, scale.speed_rpm.is_nothing())?;
    let force = exact(force);
    Ok([force.clone(), force * radius])
}

/// The number of the motion that all cylinders have: of a rod that all have, on cranks that turn equally fast.
fn check_coefficients(loads: &Loads, evidence: &Document, motion: &Motion<'_>) -> Result<(), Fault> {
    for (index, entry) in loads.coefficients.iter().enumerate() {
        let at = format!("coefficients[{index}]");
        let mut cylinders = evidence.cylinders.iter().map(|one| (&one.rod, one.speed));
        let common = cylinders.next().filter(|first| first.1 == 1 && cylinders.all(|other| other == *first));
        let rod = common.and_then(|(rod, _)| rod.on_the_pin());
        let rod = rod.ok_or_else(|| Fault::new(at.as_str(), "the cylinders have no number in common"))?;
        let number = of_rod(rod, entry.order, motion).map_err(|reason| Fault { place: at.clone(), reason })?;
        number.has_parts(&at, [entry.re, entry.im])?;
    }
    Ok(())
}

/// The peaks are those of the listed orders, and the largest of all orders: neither is 0 where something is left in these, of an engine
/// that moves.
fn check_peaks(
    loads: &Loads,
    evidence: &Document,
    is_at_rest: bool,
    [left, left_of_all]: [&BTreeSet<Quantity>; 2],
) -> Result<(), Fault> {
    let (peaks, largest) = (&loads.peaks, &loads.largest);
    let effects: BTreeSet<Effect> = loads.effects.iter().copied().collect();
    refuse_if(effects.len() < loads.effects.len(), Fault::new("effects", "an effect is here twice"))?;
    let is_alone = loads.effects.len() == 1;
    if !effects.contains(&Effect::Reciprocating) || is_alone != (evidence.masses == Masses::Reciprocating) {
        return Err(Fault::new("effects", "these are not those of the masses that the evidence is about"));
    }
    for (quantity, peak, largest, effects) in [
        (Quantity::FORCE, Some(&peaks.force), Some(&largest.force), &loads.effects[..]),
        (Quantity::MOMENT, Some(&peaks.moment), Some(&largest.moment), &loads.effects[..]),
        (Quantity::TORQUE, peaks.torque.as_ref(), largest.inertia_torque.as_ref(), &[]),
    ] {
        let name = quantity.name();
        if peak.is_some() != evidence.quantities.contains(&quantity) || peak.is_none() && largest.is_some() {
            return Err(Fault::new(
                format!("peaks.{name}"),
                "it is here where the evidence is about it, and only there",
            ));
        }
        if let Some(peak) = peak {
            agrees(&format!("peaks.{name}.value"), peak.value, is_at_rest || !left.contains(&quantity))?;
            if !peak.effects.iter().map(|(effect, _)| effect).eq(effects) {
                return Err(Fault::new(format!("peaks.{name}.effects"), "these are not the effects of the loads"));
            }
        }
        let is_wrong = |value: Size| match value.is_nothing() {
            true => !is_at_rest && left_of_all.contains(&quantity),
            false => is_at_rest,
        };
        if largest.is_some_and(|largest| is_wrong(largest.value)) {
            return Err(Fault::new(format!("largest.{name}"), "it is not what the evidence says"));
        }
    }
    Ok(())
}

fn check_orders(loads: &Loads, evidence: &Document) -> Result<(), Fault> {
    let said: Vec<(Quantity, u32)> = loads.orders.iter().map(|entry| (entry.quantity, entry.order)).collect();
    let shaking: Vec<u32> =
        said.iter().filter(|(quantity, _)| *quantity == Quantity::FORCE).map(|(_, order)| *order).collect();
    let orders = |entries: &[LoadsTorque]| entries.iter().map(|entry| entry.order).collect();
    let [torque, roll]: [Vec<u32>; 2] = [orders(&loads.torque), orders(&loads.roll)];
    let numbered: Vec<u32> = loads.coefficients.iter().map(|entry| entry.order).collect();
    let of = |quantity: Quantity| shaking.iter().map(move |order| (quantity, *order));
    let mut all = [&shaking[..], &torque].concat();
    all.sort_unstable();
    all.dedup();
    let rise = |orders: &[u32]| orders.windows(2).all(|pair| pair[0] < pair[1]);
    let are_due = said.into_iter().eq(of(Quantity::FORCE).chain(of(Quantity::MOMENT)));
    if !are_due || all != evidence.orders || !rise(&shaking) || !rise(&torque) {
        return Err(Fault::new("orders", "these are not the orders of the evidence, force and then moment, each once"));
    }
    let of_roll = if evidence.quantities.contains(&Quantity::ROLL) { &torque[..] } else { &[] };
    if roll != of_roll {
        return Err(Fault::new("roll", "it has the orders of the torque where the evidence is about it, else none"));
    }
    if !rise(&numbered) || !numbered.iter().all(|order| shaking.contains(order)) {
        return Err(Fault::new("coefficients", "these are of orders that are listed, rising"));
    }
    match &loads.auto {
        Some(auto) if auto.kept != shaking || auto.torque_kept != torque => {
            Err(Fault::new("auto", "the orders that are kept are those that are listed"))
        }
        Some(auto)
            if auto.dropped.iter().any(|order| shaking.contains(order))
                || auto.torque_dropped.iter().any(|order| torque.contains(order)) =>
        {
            Err(Fault::new("auto", "an order is kept and dropped"))
        }
        Some(_) | None => Ok(()),
    }
}
