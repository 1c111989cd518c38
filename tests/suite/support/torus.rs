//! Where on the torus of bank angle φ and pin split δ do lines meet, and how is it drawn?

use std::collections::BTreeSet;

use crankstar::family::{OpenVerdict, When};
use crankstar::page::figure::{Anchor, Dash, Figure, Ink, Point, Stroke};
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// φ and δ in turns, both in [0, 1).
pub type Place = [BigRational; 2];

/// `phi·φ + delta·δ ≡ turn`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    pub phi: BigRational,
    pub delta: BigRational,
    pub turn: BigRational,
}

/// Where something vanishes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Places {
    Everywhere,
    At(BTreeSet<Place>),
}

impl Places {
    /// Where both vanish.
    pub fn and(&self, other: &Places) -> Places {
        match (self, other) {
            (Places::Everywhere, places) | (places, Places::Everywhere) => places.clone(),
            (Places::At(one), Places::At(other)) => Places::At(one.intersection(other).cloned().collect()),
        }
    }
}

/// The line on which a verdict vanishes; none where it always does.
pub fn line(verdict: &OpenVerdict) -> Option<Line> {
    if verdict.always() {
        return None;
    }
    let [sum] = verdict.sums.as_slice() else { panic!("one sum: {verdict:?}") };
    let When::Where(angles) = &sum.when else { panic!("a line: {:?}", sum.when) };
    let [alternative] = angles.alternatives.as_slice() else { panic!("one line: {angles:?}") };
    let [only] = alternative.conditions.as_slice() else { panic!("one condition: {alternative:?}") };
    Some(Line { phi: only.phi.clone(), delta: only.delta.clone(), turn: only.turn.clone() })
}

/// Where two lines cross, all of their windings.
pub fn meetings(one: &Line, other: &Line) -> BTreeSet<Place> {
    let determinant = &one.phi * &other.delta - &one.delta * &other.phi;
    assert!(!determinant.is_zero(), "{one:?} and {other:?} do not cross");
    let most = [one, other].map(|line| (line.phi.abs() + line.delta.abs()).ceil().to_integer().to_i64().expect("few"));
    let turned = |line: &Line, windings: i64| &line.turn + BigRational::from_integer(windings.into());
    let mut found = BTreeSet::new();
    for (m, n) in (-most[0] - 1..=most[0]).flat_map(|m| (-most[1] - 1..=most[1]).map(move |n| (m, n))) {
        let [u, v] = [turned(one, m), turned(other, n)];
        let place =
            [(&u * &other.delta - &v * &one.delta) / &determinant, (&v * &one.phi - &u * &other.phi) / &determinant];
        if place.iter().all(|turns| !turns.is_negative() && *turns < BigRational::one()) {
            found.insert(place);
        }
    }
    found
}

/// Where both vectors of a force or a moment vanish.
pub fn balanced(verdicts: &[OpenVerdict; 2]) -> Places {
    match verdicts.each_ref().map(line) {
        [None, None] => Places::Everywhere,
        [Some(direct), Some(reverse)] => Places::At(meetings(&direct, &reverse)),
        alone => panic!("one of two always vanishes: {alone:?}"),
    }
}

/// Side of the torus, in millimetres.
const SIDE: f64 = 46.0;
/// A panel: the torus with its names.
pub const PANEL: [f64; 2] = [62.0, 66.0];

fn on_panel(corner: Point, [phi, delta]: [f64; 2]) -> Point {
    corner + Point::new(13.0 + SIDE * phi, 9.0 + SIDE * delta)
}

/// Frame, name and degrees of a torus whose panel has this lower left corner.
pub fn frame(figure: &mut Figure, corner: Point, name: &str) {
    let thin = Stroke::solid(Ink::Grey, 0.2);
    let at = |phi, delta| on_panel(corner, [phi, delta]);
    figure.polygon(vec![at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)], thin, None);
    for quarter in 0..=4 {
        let turns = f64::from(quarter) / 4.0;
        figure.text(at(turns, 0.0) - Point::new(0.0, 2.6), format!("{}", 90 * quarter), Anchor::Middle);
        figure.text(at(0.0, turns) - Point::new(2.6, 0.0), format!("{}", 90 * quarter), Anchor::End);
    }
    figure.text(at(0.5, 0.0) - Point::new(0.0, 6.4), "bank angle φ in degrees", Anchor::Middle);
    figure.text(at(0.0, 1.0) + Point::new(-1.2, 4.0), "δ", Anchor::End);
    figure.heading(at(0.5, 1.0) + Point::new(0.0, 4.0), name);
}

/// All windings of a line.
pub fn draw_line(figure: &mut Figure, corner: Point, line: &Line, stroke: Stroke) {
    let [p, d, turn] = [&line.phi, &line.delta, &line.turn].map(|value| value.to_f64().expect("a number"));
    let most = (p.abs() + d.abs()).ceil() as i64 + 1;
    for winding in -most..=most {
        let level = turn + winding as f64;
        let ends = [0.0, 1.0].into_iter();
        let across = ends.clone().filter(|_| d != 0.0).map(|phi| [phi, (level - p * phi) / d]);
        let along = ends.filter(|_| p != 0.0).map(|delta| [(level - d * delta) / p, delta]);
        let inside = |at: &[f64; 2]| at.iter().all(|turns| (-1e-9..=1.0 + 1e-9).contains(turns));
        let mut found: Vec<[f64; 2]> = across.chain(along).filter(inside).collect();
        found.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        if let (Some(&first), Some(&last)) = (found.first(), found.last()) {
            let apart = (first[0] - last[0]).abs() + (first[1] - last[1]).abs();
            if apart > 1e-6 {
                figure.line(on_panel(corner, first), on_panel(corner, last), stroke);
            }
        }
    }
}

/// A point, on both sides where it lies on the border.
pub fn images(corner: Point, place: &Place) -> Vec<Point> {
    let turns = place.each_ref().map(|value| value.to_f64().expect("a number"));
    let both = |value: f64| if value == 0.0 { vec![0.0, 1.0] } else { vec![value] };
    let rows = both(turns[0]).into_iter().flat_map(|phi| both(turns[1]).into_iter().map(move |delta| [phi, delta]));
    rows.map(|at| on_panel(corner, at)).collect()
}

/// A broken line.
pub fn dashed(ink: Ink, width: f64) -> Stroke {
    Stroke { ink, width, dash: Dash::Dashed }
}
