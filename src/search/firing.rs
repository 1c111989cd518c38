//! In which order does a star fire, and how many neighbours fire in succession?

use num_rational::BigRational;

use crate::engine::{Cycle, Firing, Shot};
use crate::exact::Turn;

use super::problem::Problem;

/// For each direction of an even in-line star the steps of the cycle at which a cylinder on it fires.
///
/// Step j comes j intervals after cylinder 1, whose direction is 0; who fires later has the throw behind (theory, section 1).
pub(super) fn slots(problem: &Problem) -> Vec<Vec<usize>> {
    let (directions, _) = problem.supply();
    let direction = |direction| Turn::fraction(-i64::from(direction), i64::from(directions));
    (0..directions).map(|d| steps(&direction(d), problem)).collect()
}

/// The steps of the cycle that lie at this crank angle, whole revolutions left out.
fn steps(angle: &Turn, problem: &Problem) -> Vec<usize> {
    let interval = problem.cycle.turns() / BigRational::from_integer(problem.cylinders.into());
    let at = |step: &u32| Turn::new(&interval * BigRational::from_integer((*step).into())) == *angle;
    (0..problem.cylinders).filter(at).map(|step| step as usize).collect()
}

/// For each cylinder the steps at which it may fire; `None` where the engine cannot fire evenly.
///
/// `dead_centres` are the crank angles of top dead centre, the first cylinder's first.
pub(super) fn even_steps(dead_centres: &[Turn], problem: &Problem) -> Option<Vec<Vec<usize>>> {
    let first = dead_centres.first()?;
    let lists: Vec<Vec<usize>> = dead_centres.iter().map(|angle| steps(&(angle - first), problem)).collect();
    // As many cylinders at each angle as steps.
    let fits =
        |list: &Vec<usize>| !list.is_empty() && lists.iter().filter(|other| *other == list).count() == list.len();
    lists.iter().all(fits).then_some(lists)
}

/// The firing order with the fewest neighbours in succession, the first of them by number, and their count.
///
/// `steps` says for each cylinder when it may fire; cylinder 0 starts.
pub(super) fn best_order(steps: &[&[usize]]) -> (Vec<usize>, usize) {
    let mut candidates = vec![Vec::new(); steps.len()];
    for (cylinder, list) in steps.iter().enumerate() {
        list.iter().for_each(|&step| candidates[step].push(cylinder));
    }
    if let Some(first) = candidates.first_mut() {
        *first = vec![0];
    }
    let mut best = (Vec::new(), usize::MAX);
    extend(&candidates, &mut Vec::with_capacity(steps.len()), 0, &mut best);
    best
}

fn extend(candidates: &[Vec<usize>], order: &mut Vec<usize>, count: usize, best: &mut (Vec<usize>, usize)) {
    if count >= best.1 {
        return;
    }
    if order.len() == candidates.len() {
        // Around the end of the cycle; two cylinders are one pair.
        let closing = order.len() > 2 && are_neighbours(order.first(), order.last());
        let count = count + usize::from(closing);
        if count < best.1 {
            *best = (order.clone(), count);
        }
        return;
    }
    for &cylinder in &candidates[order.len()] {
        if !order.contains(&cylinder) {
            let next = count + usize::from(are_neighbours(order.last(), Some(&cylinder)));
            order.push(cylinder);
            extend(candidates, order, next, best);
            order.pop();
        }
    }
}

fn are_neighbours(one: Option<&usize>, other: Option<&usize>) -> bool {
    one.zip(other).is_some_and(|(one, other)| one.abs_diff(*other) == 1)
}

/// The firings of an even order, whose first cylinder fires at 0.
pub(super) fn even(order: &[usize], cycle: Cycle) -> Firing {
    let interval = cycle.turns() / BigRational::from_integer(order.len().into());
    let shot = |(step, &cylinder): (usize, &usize)| Shot {
        cylinder,
        angle: &interval * BigRational::from_integer(step.into()),
    };
    Firing { cycle, shots: order.iter().enumerate().map(shot).collect() }
}

/// The name of a cycle in a layout file.
pub(super) fn cycle_name(cycle: Cycle) -> &'static str {
    match cycle {
        Cycle::TwoStroke => "two-stroke",
        Cycle::FourStroke => "four-stroke",
    }
}
