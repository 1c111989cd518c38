//! How does the front look? The moment of one order against that of the next, a dot for each star of the front.

use num_traits::Zero;

use crate::page::plot::{Axis, Curve, Plot, PointMark};
use crate::page::{File, Picture};
use crate::proof::Sense;
use crate::report::texts::search as text;
use crate::search::{FoundStar, Front};

/// The first two orders that can differ; none where just one star or one order is there to be shown.
pub(super) fn front_picture(front: &Front) -> Option<Picture> {
    let shown = two_moments(front)?;
    let orders = shown.map(|place| front.stars[0].moments[place].order);
    let axis = |place: usize| {
        let moment = &front.stars[0].moments[place];
        Axis::amplitude(match moment.sense {
            None => format!("Moment of order {} in m r ω² c a", moment.order),
            Some(Sense::Direct) => format!("Direct vector of order {} in m r ω² c a", moment.order),
            Some(Sense::Reverse) => format!("Reverse vector of order {} in m r ω² c a", moment.order),
        })
    };
    let mut plot = Plot::new(format!("Orders {} and {}", orders[0], orders[1]), axis(shown[0]), axis(shown[1]));
    let at = |star: &FoundStar| (length(star, shown[0]), length(star, shown[1]));
    let compared = front.problem.orders.iter().filter(|&&order| !vanishes_everywhere(front, order)).count();
    let moments_alone = !front.problem.neighbours && front.problem.minor_orders.is_empty();
    // Of a V with both vectors of an order compared more than the two are.
    let only_these = compared == 2 && moments_alone && !is_entangled(front);
    if only_these {
        plot.curves.push(Curve::new(0, "", front.stars.iter().map(at).collect()).stepped());
    }
    for (index, star) in front.stars.iter().enumerate() {
        let label = match star.classes {
            None | Some(1) => (index + 1).to_string(),
            Some(classes) => format!("{} ({classes}×)", index + 1),
        };
        plot.marks.push(PointMark::dot(at(star), label));
    }
    let caption = text::front(if only_these { text::steps() } else { text::better_elsewhere() });
    Some(Picture::new("front", caption, plot.figure()))
}

/// Places of the moments of two different orders, each of which some star leaves.
fn two_moments(front: &Front) -> Option<[usize; 2]> {
    let moments = &front.stars.first().filter(|_| front.stars.len() > 1)?.moments;
    let is_left = |place: &usize| front.stars.iter().any(|star| !star.moments[*place].sum.vanishes());
    let mut places = (0..moments.len()).filter(is_left);
    let first = places.next()?;
    let second = places.find(|place| moments[*place].order != moments[first].order)?;
    Some([first, second])
}

/// Whether direct and reverse vectors are compared each: of a grid whose banks are offset.
fn is_entangled(front: &Front) -> bool {
    let problem = &front.problem;
    problem.grid.is_some() && problem.bank_offset.as_ref().is_some_and(|offset| !offset.is_zero())
}

fn vanishes_everywhere(front: &Front, order: u32) -> bool {
    let of_order = |star: &FoundStar| star.moments.iter().filter(|m| m.order == order).all(|m| m.sum.vanishes());
    front.stars.iter().all(of_order)
}

/// A length as it is drawn: 0 where that is proved.
fn length(star: &FoundStar, place: usize) -> f64 {
    let moment = &star.moments[place];
    if moment.sum.vanishes() { 0.0 } else { moment.decimal }
}

/// Each star of the front as a layout file, which every other command reads: `star-1.toml` and on, as the table counts them.
pub fn search_layouts(front: &Front) -> Vec<File> {
    let file = |(index, star): (usize, &FoundStar)| File {
        name: format!("star-{}.toml", index + 1),
        text: star.layout_file(&front.problem),
    };
    front.stars.iter().enumerate().map(file).collect()
}
