//! Which areas lie between a torque and its load, and what do they add up to? Exactly, of straight lines.

use std::cmp::Ordering;

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::drawn::{Drawn, Lobe, NoFluctuation};
use super::with_pi::WithPi;
use crate::file::{Diagram, Line, Torque};
use crate::numbers;

/// An area in N m times turns, with the angle where it begins.
type Part = (Option<BigRational>, BigRational);

pub(super) fn drawn(diagram: &Diagram) -> Result<Drawn, NoFluctuation> {
    let (mean, cycle, parts) = match &diagram.torque {
        Torque::Areas(areas) if diagram.angles.is_empty() => {
            (None, None, areas.iter().map(|area| (None, area.clone())).collect())
        }
        Torque::Areas(_) | Torque::Harmonics(..) => return Err(NoFluctuation::NoAngles),
        Torque::Lines(_) => {
            let torque = all_cylinders(diagram)?;
            let Line { to: cycle, first: mean, .. } = mean_line(&torque);
            let parts = parts(&excess(&torque, diagram, &mean)?);
            (Some(mean), Some(cycle), parts)
        }
    };
    let power = i32::from(!diagram.over_pi);
    let two = BigRational::from_integer(2.into());
    let energy = |area: &BigRational| WithPi::rational(area * &two, power);
    let mut sum = BigRational::zero();
    let (mut highest, mut lowest) = ((BigRational::zero(), 0), (BigRational::zero(), 0));
    let mut lobes = Vec::new();
    for (index, (from, area)) in parts.iter().enumerate() {
        sum += area;
        // Behind the last area is the first again.
        let behind = (index + 1) % parts.len();
        if sum > highest.0 {
            highest = (sum.clone(), behind);
        }
        if sum < lowest.0 {
            lowest = (sum.clone(), behind);
        }
        lobes.push(Lobe { from: from.clone(), work: energy(area), sum: energy(&sum) });
    }
    let angle = |index: usize| parts.get(index)?.0.as_ref().map(|turns| numbers::float(turns) * 360.0);
    Ok(Drawn {
        mean: mean.map(|mean| WithPi::rational(mean, power - 1)),
        cycle,
        energy: energy(&(&highest.0 - &lowest.0)),
        fastest_and_slowest: angle(highest.1).zip(angle(lowest.1)).map(|(fastest, slowest)| [fastest, slowest]),
        lobes,
    })
}

/// A torque at any angle in turns; at a step the value behind it.
pub(super) fn at_any(lines: &[Line], angle: &BigRational) -> BigRational {
    let cycle = end(lines);
    let angle = angle - (angle / &cycle).floor() * &cycle;
    at(lines, &angle, &angle)
}

/// The mean of a torque through its cycle.
pub(super) fn mean_line(lines: &[Line]) -> Line {
    let to = end(lines);
    let mean = integral(lines) / &to;
    Line { from: BigRational::zero(), to, first: mean.clone(), last: mean }
}

fn end(lines: &[Line]) -> BigRational {
    lines.last().map_or_else(BigRational::zero, |line| line.to.clone())
}

fn integral(lines: &[Line]) -> BigRational {
    let two = BigRational::from_integer(2.into());
    lines.iter().map(|line| (&line.first + &line.last) * (&line.to - &line.from) / &two).sum()
}

/// The value at an angle, of the line in which another angle is.
fn at(lines: &[Line], angle: &BigRational, inside: &BigRational) -> BigRational {
    let place = lines.partition_point(|line| line.to <= *inside).min(lines.len() - 1);
    let line = &lines[place];
    &line.first + (&line.last - &line.first) * (angle - &line.from) / (&line.to - &line.from)
}

/// The torque of all cylinders, each behind the one before it.
pub(super) fn all_cylinders(diagram: &Diagram) -> Result<Vec<Line>, NoFluctuation> {
    let Torque::Lines(one) = &diagram.torque else { return Err(NoFluctuation::NoAngles) };
    let (count, interval) = &diagram.cylinders;
    if *count == 1 {
        return Ok(one.clone());
    }
    let cycle = end(one);
    let shifts: Vec<BigRational> = (0..*count)
        .map(|index| {
            let shift = interval * BigRational::from_integer(index.into());
            &shift - (&shift / &cycle).floor() * &cycle
        })
        .collect();
    let into = |angle: BigRational| if angle < cycle { angle } else { angle - &cycle };
    let starts = shifts.iter().flat_map(|shift| one.iter().map(move |line| into(&line.from + shift)));
    let between = |from: &BigRational, to: &BigRational| {
        let middle = (from + to) / BigRational::from_integer(2.into());
        let value = |angle: &BigRational| -> BigRational {
            shifts
                .iter()
                .map(|shift| {
                    let by = if middle < *shift { &cycle - shift } else { -shift };
                    at(one, &(angle + &by), &(&middle + &by))
                })
                .sum()
        };
        Line { from: from.clone(), to: to.clone(), first: value(from), last: value(to) }
    };
    Ok(pieces(starts, &cycle).windows(2).map(|pair| between(&pair[0], &pair[1])).collect())
}

/// Angles through the cycle, rising, each once, with both ends.
fn pieces(starts: impl Iterator<Item = BigRational>, cycle: &BigRational) -> Vec<BigRational> {
    let mut all: Vec<BigRational> = starts.chain([BigRational::zero(), cycle.clone()]).collect();
    all.sort();
    all.dedup();
    all
}

/// The torque less its load.
fn excess(torque: &[Line], diagram: &Diagram, mean: &BigRational) -> Result<Vec<Line>, NoFluctuation> {
    let Some(Torque::Lines(load)) = &diagram.load else {
        let less = |line: &Line| Line { first: &line.first - mean, last: &line.last - mean, ..line.clone() };
        return Ok(torque.iter().map(less).collect());
    };
    let cycle = end(torque);
    if end(load) != cycle {
        return Err(NoFluctuation::OtherCycle);
    }
    let [of_load, of_torque] = [load, torque].map(|lines| mean_line(lines).first);
    if of_load != of_torque {
        return Err(NoFluctuation::Unequal { load: Box::new(of_load), torque: Box::new(of_torque) });
    }
    let between = |pair: &[BigRational]| {
        let middle = (&pair[0] + &pair[1]) / BigRational::from_integer(2.into());
        let value = |angle: &BigRational| at(torque, angle, &middle) - at(load, angle, &middle);
        Line { from: pair[0].clone(), to: pair[1].clone(), first: value(&pair[0]), last: value(&pair[1]) }
    };
    let starts = torque.iter().chain(load).map(|line| line.from.clone());
    Ok(pieces(starts, &cycle).windows(2).map(between).collect())
}

/// The areas between crossings, from the first crossing of the cycle on.
fn parts(excess: &[Line]) -> Vec<Part> {
    let mut parts: Vec<(BigRational, BigRational)> = Vec::new();
    let mut add = |from: &BigRational, area: BigRational| match parts.last_mut() {
        _ if area.is_zero() => {}
        Some((_, sum)) if sum.is_positive() == area.is_positive() => *sum += area,
        _ => parts.push((from.clone(), area)),
    };
    let two = BigRational::from_integer(2.into());
    for Line { from, to, first, last } in excess {
        if (first * last).cmp(&BigRational::zero()) == Ordering::Less {
            let crossing = from + (to - from) * first / (first - last);
            add(from, first * (&crossing - from) / &two);
            add(&crossing, last * (to - &crossing) / &two);
        } else {
            add(from, (first + last) * (to - from) / &two);
        }
    }
    // The cycle's ends are no crossing where the torque is on one side of the load there.
    if parts.len() > 1 && parts.len() % 2 == 1 {
        let (_, area) = parts.remove(0);
        if let Some((_, last)) = parts.last_mut() {
            *last += area;
        }
    }
    parts.into_iter().map(|(from, area)| (Some(from), area)).collect()
}
