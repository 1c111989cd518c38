//! In which order does a star fire, and how many neighbours fire in succession?

use num_rational::BigRational;

use super::problem::Problem;
use crate::engine::{Cycle, Firing, Shot};
use crate::exact::Turn;

/// The steps of the cycle that lie at this crank angle, whole revolutions omitted.
///
/// Step j comes j intervals after cylinder 1; who fires later has the throw behind (theory, section 1).
pub(super) fn steps(angle: &Turn, problem: &Problem) -> Vec<usize> {
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
    are_even(&lists.iter().map(Vec::as_slice).collect::<Vec<_>>()).then_some(lists)
}

/// Whether cylinders that may fire at these steps can fire evenly: as many at each angle as steps.
pub(super) fn are_even(lists: &[&[usize]]) -> bool {
    let fits = |list: &&[usize]| !list.is_empty() && lists.iter().filter(|other| *other == list).count() == list.len();
    lists.iter().all(fits)
}

/// The firing order with the fewest neighbours in succession, the first of them by number, and their count.
///
/// `steps` says for each cylinder when it may fire, bank after bank of this many throws; cylinder 0 starts.
pub(super) fn best_order(steps: &[&[usize]], throws: usize) -> (Vec<usize>, usize) {
    let mut candidates = vec![Vec::new(); steps.len()];
    for (cylinder, list) in steps.iter().enumerate() {
        list.iter().for_each(|&step| candidates[step].push(cylinder));
    }
    if let Some(first) = candidates.first_mut() {
        *first = vec![0];
    }
    let mut best = (Vec::new(), usize::MAX);
    extend(&candidates, throws, &mut Vec::with_capacity(steps.len()), 0, &mut best);
    best
}

fn extend(
    candidates: &[Vec<usize>],
    throws: usize,
    order: &mut Vec<usize>,
    count: usize,
    best: &mut (Vec<usize>, usize),
) {
    if count >= best.1 {
        return;
    }
    if order.len() == candidates.len() {
        let count = in_succession(order, throws);
        if count < best.1 {
            *best = (order.clone(), count);
        }
        return;
    }
    for &cylinder in &candidates[order.len()] {
        if !order.contains(&cylinder) {
            let next = count + usize::from(are_neighbours(order.last(), Some(&cylinder), throws));
            order.push(cylinder);
            extend(candidates, throws, order, next, best);
            order.pop();
        }
    }
}

/// Pairs of neighbours that fire in succession in an even order.
pub(super) fn in_succession(order: &[usize], throws: usize) -> usize {
    let closing = order.len() > 2 && are_neighbours(order.first(), order.last(), throws);
    let pairs = order.windows(2).filter(|pair| are_neighbours(pair.first(), pair.last(), throws));
    pairs.count() + usize::from(closing)
}

/// Whether two cylinders are on neighbouring throws of one bank.
fn are_neighbours(one: Option<&usize>, other: Option<&usize>, throws: usize) -> bool {
    one.zip(other).is_some_and(|(one, other)| one.abs_diff(*other) == 1 && one / throws == other / throws)
}

/// The firings of an even order, whose first cylinder fires at 0.
pub(super) fn even(order: &[usize], cycle: Cycle) -> Firing {
    let interval = cycle.turns() / BigRational::from_integer(order.len().into());
    let shot = |(step, &cylinder): (usize, &usize)| Shot {
        cylinder,
        angle: &interval * BigRational::from_integer(step.into()),
    };
    Firing { cycle, shots: order.iter().enumerate().map(shot).collect(), first_revolution: BigRational::default() }
}

/// All orders in which cylinders can fire that may do so at these steps.
pub(super) fn orders_of(steps: &[&[usize]]) -> Vec<Vec<usize>> {
    let mut orders: Vec<Vec<usize>> = vec![vec![0]];
    for step in 1..steps.len() {
        let fires_then = |cylinder: &usize| steps[*cylinder].contains(&step);
        let candidates: Vec<usize> = (0..steps.len()).filter(fires_then).collect();
        let longer = |order: Vec<usize>| {
            let free = candidates.iter().filter(|cylinder| !order.contains(cylinder)).copied().collect::<Vec<_>>();
            free.into_iter().map(move |next| order.iter().copied().chain([next]).collect())
        };
        orders = orders.into_iter().flat_map(longer).collect();
    }
    orders
}
