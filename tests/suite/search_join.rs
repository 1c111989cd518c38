//! Does the join of outer and inner sums find the front that the walk over all stars finds?

use crankstar::engine::Cycle;
use crankstar::exact::Turn;
use crankstar::search::{Front, Options, Problem, Way, document, every_value, search};
use num_bigint::BigUint;

fn by(way: Way, problem: &Problem) -> Front {
    search(problem, &Options { way, ..Options::default() }).expect("a front")
}

/// The stars with values, first throws, classes and counts, and how many stars there are.
fn stars(front: &Front) -> String {
    let document = document(front);
    serde_json::to_string(&(document.all_stars, document.stars)).expect("a text")
}

fn agree(problem: &Problem) {
    let join = by(Way::Join, problem);
    assert_eq!(stars(&join), stars(&by(Way::Walk, problem)), "{problem:?}");
    assert!(join.stars.iter().filter_map(|star| star.classes).sum::<u64>() <= join.judged);
}

#[test]
fn join_and_walk_find_the_same_fronts_of_up_to_twelve_cylinders() {
    for cycle in [Cycle::TwoStroke, Cycle::FourStroke] {
        for cylinders in 1..=12 {
            for orders in [&[1, 2][..], &[1, 2, 4], &[1], &[2]] {
                // All twelve-cylinder stars without second-order moment are many thousands, each taken by the walk one by one.
                if cylinders <= 8 || orders[0] == 1 {
                    agree(&Problem::inline(cylinders, cycle, orders));
                }
            }
        }
    }
}

#[test]
fn join_and_walk_find_the_same_fronts_where_neighbours_count() {
    for cycle in [Cycle::TwoStroke, Cycle::FourStroke] {
        for cylinders in 1..=9 {
            for orders in [&[1, 2][..], &[2, 3]] {
                agree(&Problem { neighbours: true, ..Problem::inline(cylinders, cycle, orders) });
            }
        }
    }
}

#[test]
fn join_and_walk_find_the_same_fronts_of_vees_whose_pins_share_directions() {
    for pins in 1..=10 {
        for directions in (1..=pins).filter(|directions| pins % directions == 0) {
            for angle in [Turn::fraction(1, 4), Turn::fraction(1, 6)] {
                let vee = Problem::vee(2 * pins, Cycle::FourStroke, angle, &[1, 2]);
                agree(&Problem { directions: Some(directions), ..vee });
            }
        }
    }
}

#[test]
fn where_nothing_is_beaten_the_join_counts_every_star() {
    // Moments of order n are zero for all n directions: every star ties.
    for cycle in [Cycle::TwoStroke, Cycle::FourStroke] {
        for cylinders in 2..=8 {
            let problem = Problem::inline(cylinders, cycle, &[cylinders]);
            let (front, every) = (by(Way::Join, &problem), every_value(&problem).expect("a question"));
            assert_eq!(front.stars.len(), 1);
            assert_eq!(
                front.stars[0].stars.map(BigUint::from),
                Some(front.all.clone()),
                "{cylinders} cylinders, {cycle:?}"
            );
            assert_eq!((front.judged, front.stars[0].classes), (every.judged, Some(every.judged)));
            assert_eq!(front.cut, 0);
        }
    }
}

#[test]
fn sixteen_cylinders_four_stroke_have_stars_without_moments_and_mirrors_among_them() {
    let front = by(Way::Join, &Problem::inline(16, Cycle::FourStroke, &[1, 2]));
    assert_eq!(front.stars.len(), 1, "no star is better than one without moments");
    let star = &front.stars[0];
    assert!(star.moments.iter().all(|moment| moment.sum.vanishes()));
    // Equal halves back to back cancel every moment; all of them are counted.
    let halves = mirror_stars(8);
    let stars = star.stars.expect("counted");
    assert!(stars >= halves, "{stars} stars, and {halves} of equal halves");
}

/// Stars of 2n cylinders whose second half mirrors the first: a permutation of the n directions with the first at 0.
fn mirror_stars(directions: u64) -> u64 {
    (1..directions).product()
}
