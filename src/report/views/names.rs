//! Where are the names in the view from the free end? Beside what they name, clear of rods and of each other.

use std::collections::BTreeMap;

use super::super::figure::{Anchor, Extent, Figure, Ink, Point, Stroke};
use super::super::plot::labels::{LINE, Labels, Place};
use super::super::typeset;
use super::linkage::{CROWN, HEAD, Linkage, SKIRT};
use super::signed_angle;

/// More banks than this are named by their cylinders and not by their angles.
const MOST_ANGLES: usize = 4;
/// Pins that are closer than this on the page share their names, as do pistons that nearly cover each other.
const TOUCHING: f64 = 2.0;
const COVERING: f64 = 0.9;

/// A place for a text on this side of a point.
fn beside(at: Point, way: Point, far: f64) -> Place {
    let anchor = match way.re {
        x if x > 0.35 => Anchor::Start,
        x if x < -0.35 => Anchor::End,
        _ => Anchor::Middle,
    };
    let up = if anchor == Anchor::Middle { way.im.signum() * LINE / 2.0 } else { way.im * LINE / 3.0 };
    (at + way * far + Point::new(0.0, up), anchor)
}

/// Writes a name at the best of these places, with a thin line where it is far off.
fn write(figure: &mut Figure, labels: &mut Labels, name: &str, from: Point, places: &[Place]) {
    let Some((at, anchor)) = labels.write(figure, name, places) else { return };
    let inwards =
        if anchor == Anchor::Middle { Point::new(0.0, (from - at).im.signum() * LINE / 2.0) } else { Point::default() };
    draw_leader(figure, (from, at + inwards), [1.4, 0.5], 5.0);
}

/// A thin line, that much shorter at both ends; none between points that are no farther apart than this.
fn draw_leader(figure: &mut Figure, (from, to): (Point, Point), [begin, end]: [f64; 2], least: f64) {
    let way = to - from;
    if way.norm() > least {
        let along = way / way.norm();
        figure.line(from + along * begin, to - along * end, Stroke::solid(Ink::Grey, 0.15));
    }
}

/// The cylinders of each crankpin, outside its circle where there is room.
pub(super) fn name_pins(figure: &mut Figure, labels: &mut Labels, linkages: &[Linkage]) {
    let mut pins: Vec<(Point, Vec<&str>)> = Vec::new();
    for linkage in linkages {
        match pins.iter_mut().find(|(pin, _)| (pin - linkage.pin).norm() < TOUCHING) {
            Some((_, names)) => names.extend(&linkage.names),
            None => pins.push((linkage.pin, linkage.names.clone())),
        }
    }
    for (pin, names) in pins {
        let out = if pin.norm() > 0.0 { pin / pin.norm() } else { Point::new(0.0, -1.0) };
        let turns = [0.0_f64, 25.0, -25.0, 50.0, -50.0, 80.0, -80.0, 110.0, -110.0, 150.0, -150.0, 180.0];
        let ways = |far: f64| turns.map(|degrees| beside(pin, out * Point::from_polar(1.0, degrees.to_radians()), far));
        let places: Vec<Place> = [2.0, 4.5, 7.5, 11.0].into_iter().flat_map(ways).collect();
        write(figure, labels, &typeset::names(&names), pin, &places);
    }
}

/// Linkages by what they share, in their order.
fn gathered<'a, 'b, K: Ord>(
    linkages: &'b [Linkage<'a>],
    key: impl Fn(&Linkage<'a>) -> K,
) -> BTreeMap<K, Vec<&'b Linkage<'a>>> {
    let mut groups: BTreeMap<K, Vec<&Linkage>> = BTreeMap::new();
    for linkage in linkages {
        groups.entry(key(linkage)).or_default().push(linkage);
    }
    groups
}

/// The cylinders whose pistons are at one height, beside the cylinder; outside it where a bank has but one.
pub(super) fn name_pistons(figure: &mut Figure, labels: &mut Labels, linkages: &[Linkage], half: f64) {
    let banks = gathered(linkages, |linkage| linkage.bank);
    let has_angles = (2..=MOST_ANGLES).contains(&banks.len());
    for bank in banks.values() {
        let mut bank = bank.clone();
        let place = |linkage: &Linkage| ((linkage.foot * linkage.across.conj()).re, linkage.height());
        bank.sort_by(|a, b| place(a).0.total_cmp(&place(b).0).then(place(a).1.total_cmp(&place(b).1)));
        let heights: Vec<&[&Linkage]> = bank.chunk_by(|a, b| (a.piston - b.piston).norm() < COVERING).collect();
        let is_alone = heights.len() == 1 && !has_angles;
        for at_height in heights {
            let Linkage { along, across, piston, foot, stroke, .. } = at_height[0];
            let names: Vec<&str> = at_height.iter().flat_map(|linkage| linkage.names.iter().copied()).collect();
            let head = foot + along * (stroke.1 + CROWN + HEAD);
            let outside = is_alone.then(|| [1.2, 4.0, 7.0].map(|far| beside(head, *along, far)));
            let middle = piston + along * ((CROWN - SKIRT) / 2.0);
            let sideways = |far: f64| {
                [0.0, 2.6, -2.6, 5.2, -5.2].into_iter().flat_map(move |shift| {
                    [-1.0, 1.0].map(|side| beside(middle + along * shift, across * side, half + far))
                })
            };
            let places: Vec<Place> =
                outside.into_iter().flatten().chain([1.0, 4.0, 8.0, 12.0].into_iter().flat_map(sideways)).collect();
            let from = if is_alone { head } else { middle };
            if !is_alone {
                // The names of a bank stay outside its cylinders.
                let bank = Extent::around([half, -half].map(|side| middle + across * side));
                bank.into_iter().for_each(|bank| labels.avoid_area(bank));
            }
            // The line begins at the wall of the cylinder.
            if let Some((at, _)) = labels.write(figure, &typeset::names(&names), &places) {
                draw_leader(figure, (from, at), [half, 0.4], half + 3.6);
            }
        }
    }
}

/// The angle of each bank outside its cylinder, where there are few.
pub(super) fn name_banks(figure: &mut Figure, labels: &mut Labels, linkages: &[Linkage], half: f64) {
    let banks = gathered(linkages, |linkage| linkage.bank);
    if !(2..=MOST_ANGLES).contains(&banks.len()) {
        return;
    }
    for (bank, linkages) in banks {
        let Linkage { along, across, foot, stroke, .. } = linkages[0];
        let head = foot + along * (stroke.1 + CROWN + HEAD);
        let shifts = [0.0, half, -half].map(|side| head + across * side);
        let places = [1.6, 4.5, 8.0].into_iter().flat_map(|far| shifts.map(|at| beside(at, *along, far)));
        write(figure, labels, &signed_angle(bank), head, &places.collect::<Vec<_>>());
    }
}

/// How far the axes pass the shaft, each at its foot, where there are few.
pub(super) fn name_offsets(figure: &mut Figure, labels: &mut Labels, linkages: &[Linkage]) {
    let mut feet: Vec<(&Linkage, &str)> = Vec::new();
    for linkage in linkages {
        let is_new = feet.iter().all(|(other, _)| (other.foot - linkage.foot).norm() > 1e-6);
        feet.extend(linkage.dimension.as_deref().filter(|_| is_new).map(|dimension| (linkage, dimension)));
    }
    for (linkage, dimension) in feet.iter().filter(|_| feet.len() <= MOST_ANGLES) {
        let out = linkage.foot / linkage.foot.norm();
        let back = -linkage.along;
        let ways = |far: f64| {
            [back + out, back + out * 0.3, out, out - back * 0.5, back - out]
                .map(|way| beside(linkage.foot, way / way.norm(), far))
        };
        let places: Vec<Place> = [3.0, 6.0, 9.0, 13.0, 17.0].into_iter().flat_map(ways).collect();
        write(figure, labels, dimension, linkage.foot, &places);
    }
}
