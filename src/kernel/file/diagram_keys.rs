//! How is a turning-moment diagram written? A file of points, triangles, areas or harmonics, with the scales of the drawing.

use num_rational::BigRational;
use num_traits::{Signed, Zero};
use serde::Deserialize;
use serde_spanned::Spanned;

use super::error::LayoutError;
use super::flywheel_keys::irregularity;
use super::kind::Kind;
use super::quantities::{List, integer, known_angle, mass, misread, positive, positive_metres, value, whole};
use super::rewritten::exact_number;
use super::units::{self, Area};
use super::written::{Table, Text, place};
use crate::engine::CycleOrder;
use crate::text::Untrusted;

/// Points of a diagram, or areas, are at most this many, and all cylinders together have at most this many.
const MOST_POINTS: usize = 2000;
/// A cycle is at most so long, in turns.
const LONGEST_CYCLE: i64 = 100;

const ONE_KIND: &str = "one of points = [[angle, torque], …], triangles = [{ width, peak or area }, …], areas = [\"52 mm²\", …], or mean with harmonics = [{ order, cos, sin }]";

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    title: Option<Text>,
    speed: Option<Text>,
    irregularity: Option<Text>,
    inertia: Option<Text>,
    mass: Option<Text>,
    radius_of_gyration: Option<Text>,
    torque_scale: Option<Text>,
    angle_scale: Option<Text>,
    area_scale: Option<Text>,
    points: Option<Points>,
    triangles: Option<Spanned<Vec<Spanned<Table<TriangleKeys>>>>>,
    areas: Option<List>,
    mean: Option<Text>,
    harmonics: Option<Harmonics>,
    load_points: Option<Points>,
    load_harmonics: Option<Harmonics>,
    cylinders: Option<Text>,
    interval: Option<Text>,
    angles: Option<List>,
}

type Points = Spanned<Vec<Spanned<Vec<Text>>>>;
type Harmonics = Spanned<Vec<Spanned<Table<HarmonicKeys>>>>;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TriangleKeys {
    width: Option<Text>,
    peak: Option<Text>,
    area: Option<Text>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct HarmonicKeys {
    order: Option<Text>,
    cos: Option<Text>,
    sin: Option<Text>,
}

/// A part of the cycle in which the torque is a straight line: angles in turns from 0, torques at both ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Where it begins.
    pub from: BigRational,
    /// Where it ends, later.
    pub to: BigRational,
    /// Torque where it begins.
    pub first: BigRational,
    /// Torque where it ends.
    pub last: BigRational,
}

/// `cos · cos κθ + sin · sin κθ`, in N m.
#[derive(Clone, Debug, PartialEq)]
pub struct Harmonic {
    /// The order κ.
    pub order: CycleOrder,
    /// Before the cosine.
    pub cos: BigRational,
    /// Before the sine.
    pub sin: BigRational,
}

/// A torque through the cycle.
#[derive(Clone, Debug, PartialEq)]
pub enum Torque {
    /// Straight lines that follow each other through the cycle.
    Lines(Vec<Line>),
    /// Areas between the torque and the load in turn, above it positive, in N m times turns.
    Areas(Vec<BigRational>),
    /// A mean in N m, and harmonics.
    Harmonics(BigRational, Vec<Harmonic>),
}

/// A turning-moment diagram.
#[derive(Clone, Debug)]
pub struct Diagram {
    /// The title; the name of the file where it has none.
    pub title: Untrusted,
    /// Speed in revolutions a minute.
    pub speed: Option<BigRational>,
    /// Coefficient of fluctuation of speed that is wanted: largest speed less smallest, over the mean.
    pub irregularity: Option<BigRational>,
    /// Moment of inertia in kilograms times square metres.
    pub inertia: Option<BigRational>,
    /// Radius of gyration of the flywheel in metres.
    pub radius_of_gyration: Option<BigRational>,
    /// The torque of the engine, or of one cylinder.
    pub torque: Torque,
    /// Whether torques are in multiples of 1/π N m, as areas in joules give them.
    pub over_pi: bool,
    /// What is driven, where that is not the mean.
    pub load: Option<Torque>,
    /// This many equal cylinders, this far apart in turns.
    pub cylinders: (usize, BigRational),
    /// Angles in turns at which values are wanted.
    pub angles: Vec<BigRational>,
}

/// Reads a file of a turning-moment diagram.
///
/// # Errors
/// The first mistake, with its place and what would be right.
pub fn parse_diagram(name: &str, source: &str) -> Result<Diagram, LayoutError> {
    let file = Kind::Diagram.read::<File>(source);
    file.and_then(|file| file.diagram(name)).map_err(|error| error.in_file(name, source))
}

/// What the drawing shows per length: torque up, angle along; or work per area.
struct Scales {
    torque: Option<BigRational>,
    angle: Option<BigRational>,
    area: Option<BigRational>,
}

impl File {
    fn diagram(self, name: &str) -> Result<Diagram, LayoutError> {
        let scales = Scales {
            torque: optional(self.torque_scale.as_ref(), |text| positive(text, "torque scale", units::torque_scale))?,
            angle: optional(self.angle_scale.as_ref(), |text| positive(text, "angle scale", units::angle_scale))?,
            area: optional(self.area_scale.as_ref(), |text| positive(text, "area scale", units::area_scale))?,
        };
        let (torque, over_pi) = self.torque(&scales)?;
        self.scales_are_needed()?;
        let load = match (&self.load_points, &self.load_harmonics) {
            (None, None) => None,
            (Some(points), None) => Some((lines(points)?, points.span())),
            (None, Some(all)) => Some((Torque::Harmonics(BigRational::zero(), harmonics(all)?), all.span())),
            (Some(_), Some(all)) => {
                let right = "load_points or load_harmonics, not both";
                return Err(LayoutError::new("two loads", right, place(all)));
            }
        };
        // A load by harmonics has the mean of the engine.
        let load = match (load, &torque) {
            (None, _) => None,
            (Some((Torque::Lines(load), _)), Torque::Lines(_)) if !over_pi => Some(Torque::Lines(load)),
            (Some((Torque::Harmonics(_, load), _)), Torque::Harmonics(mean, _)) => {
                Some(Torque::Harmonics(mean.clone(), load))
            }
            (Some((_, span)), _) => {
                let right = "load_points beside points or triangles with peaks, load_harmonics beside harmonics; without both the load is the mean";
                return Err(LayoutError::new("a load of another kind than the torque", right, Some(span)));
            }
        };
        if let (Torque::Areas(_), Some(list)) = (&torque, &self.angles) {
            let right = "areas alone do not give the torque at an angle: give points, triangles or harmonics";
            return Err(LayoutError::new("angles beside areas", right, place(list)));
        }
        let angles = self.angles.iter().flat_map(|list| list.get_ref()).map(known_angle);
        Ok(Diagram {
            cylinders: self.cylinders(&torque)?,
            speed: optional(self.speed.as_ref(), |text| positive(text, "speed", units::speed))?,
            irregularity: optional(self.irregularity.as_ref(), irregularity)?,
            radius_of_gyration: optional(self.radius_of_gyration.as_ref(), positive_metres)?,
            inertia: self.inertia()?,
            torque,
            over_pi,
            load,
            angles: angles.collect::<Result<_, _>>()?,
            title: self.title.map_or_else(|| Untrusted::new(name), |title| title.get_ref().untrusted()),
        })
    }

    /// Scales measure areas of a drawing, in one of two ways.
    fn scales_are_needed(&self) -> Result<(), LayoutError> {
        let named = |key, text| Option::map(text, |text| (key, text));
        let torque = named("torque_scale", self.torque_scale.as_ref());
        let side = torque.or(named("angle_scale", self.angle_scale.as_ref()));
        if let (Some((key, _)), Some(area)) = (side, &self.area_scale) {
            let right = "torque_scale with angle_scale, or area_scale alone: either gives the work of an area";
            return Err(LayoutError::new(format!("both {key} and area_scale are given"), right, place(area)));
        }
        let Some((key, scale)) = side.or(named("area_scale", self.area_scale.as_ref())) else { return Ok(()) };
        let of_triangles = self.triangles.iter().flat_map(|all| all.get_ref());
        let of_triangles = of_triangles.filter_map(|one| one.get_ref().0.area.as_ref());
        let mut areas = self.areas.iter().flat_map(|list| list.get_ref()).chain(of_triangles);
        match areas.any(|text| matches!(units::area(&text.get_ref().0), Ok(Area::Square(_)))) {
            true => Ok(()),
            false => {
                let right = "scales belong to areas of the drawing, such as \"52 mm²\"; torques in N m and areas in joules need none";
                Err(LayoutError::new(format!("{key} without an area that it measures"), right, place(scale)))
            }
        }
    }

    fn torque(&self, scales: &Scales) -> Result<(Torque, bool), LayoutError> {
        let kinds = [
            self.points.as_ref().and_then(place),
            self.triangles.as_ref().and_then(place),
            self.areas.as_ref().and_then(place),
            self.harmonics.as_ref().and_then(place),
        ];
        let mut given = kinds.into_iter().flatten();
        if let (_, Some(second)) = (given.next(), given.next()) {
            return Err(LayoutError::new("two diagrams", ONE_KIND, Some(second)));
        }
        match (&self.points, &self.triangles, &self.areas, &self.harmonics, &self.mean) {
            (_, _, _, Some(all), Some(mean)) => {
                Ok((Torque::Harmonics(value(mean, "torque", units::torque)?, harmonics(all)?), false))
            }
            (_, _, _, Some(all), None) => {
                let right = "the mean torque, such as mean = \"20 kN m\"; 0 where there is none";
                Err(LayoutError::new("harmonics without a mean", right, place(all)))
            }
            (_, _, _, None, Some(mean)) => {
                Err(LayoutError::new("a mean without harmonics", "of points and triangles it is computed", place(mean)))
            }
            (Some(points), ..) => Ok((lines(points)?, false)),
            (_, Some(all), ..) => triangles(all, scales),
            (_, _, Some(list), ..) => areas(list, scales),
            (None, None, None, None, None) => Err(LayoutError::new("no turning-moment diagram", ONE_KIND, None)),
        }
    }

    fn inertia(&self) -> Result<Option<BigRational>, LayoutError> {
        let inertia = optional(self.inertia.as_ref(), |text| positive(text, "moment of inertia", units::inertia))?;
        match (&inertia, &self.mass, &self.radius_of_gyration) {
            (Some(_), Some(text), _) => {
                Err(LayoutError::new("two inertias", "inertia, or mass with radius_of_gyration", place(text)))
            }
            (None, Some(text), Some(radius)) => {
                let (mass, radius) = (mass(text)?, positive_metres(radius)?);
                if mass.is_zero() { Err(misread(text, "mass", "above 0")) } else { Ok(Some(mass * &radius * radius)) }
            }
            (None, Some(text), None) => Err(LayoutError::new(
                "a mass without its radius of gyration",
                "radius_of_gyration = \"0.5 m\"",
                place(text),
            )),
            (_, None, _) => Ok(inertia),
        }
    }

    fn cylinders(&self, torque: &Torque) -> Result<(usize, BigRational), LayoutError> {
        match (&self.cylinders, &self.interval) {
            (None, None) => Ok((1, BigRational::zero())),
            (Some(count), Some(interval)) => {
                let number = usize::try_from(whole(count, "number of cylinders")?).unwrap_or(1);
                let Torque::Lines(lines) = torque else {
                    let right = "points or triangles of one cylinder";
                    return Err(LayoutError::new("cylinders of no diagram that can be added", right, place(count)));
                };
                if lines.len() * number > MOST_POINTS {
                    let right = format!("up to {MOST_POINTS} points of all cylinders together");
                    return Err(LayoutError::new("too many points", right, place(count)));
                }
                Ok((number, known_angle(interval)?))
            }
            (Some(text), None) | (None, Some(text)) => {
                let right = "cylinders = 3 with interval = \"240\", the crank angle from one to the next";
                Err(LayoutError::new("cylinders and their interval belong together", right, place(text)))
            }
        }
    }
}

fn optional<T>(text: Option<&Text>, read: impl Fn(&Text) -> Result<T, LayoutError>) -> Result<Option<T>, LayoutError> {
    text.map(read).transpose()
}

fn not_too_many<T>(list: &Spanned<Vec<T>>) -> Result<&[T], LayoutError> {
    match list.get_ref().len() {
        0 => Err(LayoutError::new("an empty list", "values in it, or no such key", place(list))),
        1..=MOST_POINTS => Ok(list.get_ref()),
        _ => Err(LayoutError::new("too many points", format!("up to {MOST_POINTS}"), place(list))),
    }
}

fn lines(points: &Points) -> Result<Torque, LayoutError> {
    let mut read = Vec::new();
    for point in not_too_many(points)? {
        let [angle, torque] = point.get_ref().as_slice() else {
            return Err(LayoutError::new("a point of a diagram", "[angle, torque], such as [90, 3000]", place(point)));
        };
        read.push((known_angle(angle)?, value(torque, "torque", units::torque)?, point));
    }
    let start = read[0].0.clone();
    let mut lines = Vec::new();
    for pair in read.windows(2) {
        let ((from, first, _), (to, last, at)) = (&pair[0], &pair[1]);
        if to < from {
            return Err(LayoutError::new("an angle before the one above it", "angles that rise", place(at)));
        }
        if to > from {
            let line = Line { from: from - &start, to: to - &start, first: first.clone(), last: last.clone() };
            lines.push(line);
        }
    }
    cycle(from_zero(lines, &start), points.span())
}

/// The lines of a cycle that begins at this angle as those from θ = 0 on: the one that the end of the cycle falls into is cut there.
fn from_zero(lines: Vec<Line>, start: &BigRational) -> Vec<Line> {
    let Some(length) = lines.last().map(|line| line.to.clone()) else { return lines };
    let shift = start - (start / &length).floor() * &length;
    let moved = |line: Line, by: &BigRational| Line { from: line.from + by, to: line.to + by, ..line };
    let (mut early, mut late) = (Vec::new(), Vec::new());
    for line in lines {
        let line = moved(line, &shift);
        if line.to <= length {
            late.push(line);
        } else if line.from >= length {
            early.push(moved(line, &-&length));
        } else {
            let part = (&length - &line.from) / (&line.to - &line.from);
            let there = &line.first + (&line.last - &line.first) * part;
            late.push(Line { to: length.clone(), last: there.clone(), ..line.clone() });
            early.push(moved(Line { from: length.clone(), first: there, ..line }, &-&length));
        }
    }
    early.extend(late);
    early
}

/// The lines, where they go through a cycle that is neither empty nor too long.
fn cycle(lines: Vec<Line>, span: std::ops::Range<usize>) -> Result<Torque, LayoutError> {
    match lines.last() {
        Some(line) if line.to <= BigRational::from_integer(LONGEST_CYCLE.into()) => Ok(Torque::Lines(lines)),
        Some(_) => Err(LayoutError::new("a very long cycle", format!("up to {LONGEST_CYCLE} turns"), Some(span))),
        None => {
            let right = "the last point ends the cycle, at 360 or 720 degrees after the first";
            Err(LayoutError::new("a diagram without a width", right, Some(span)))
        }
    }
}

/// Work in N m times turns, or in joules over 2 where `in_joules`: times 2π or 2 that is the energy.
fn area(text: &Text, scales: &Scales) -> Result<(BigRational, bool), LayoutError> {
    let written = &text.get_ref().0;
    let refuse = |right: String| misread(text, "area", right);
    let half = |joules: BigRational| joules / BigRational::from_integer(2.into());
    match (units::area(written).map_err(refuse)?, scales) {
        (Area::Joules(joules), _) => Ok((half(joules), true)),
        (Area::Square(square), Scales { area: Some(scale), .. }) => Ok((half(square * scale), true)),
        (Area::Square(square), Scales { torque: Some(torque), angle: Some(angle), .. }) => {
            Ok((square * torque * angle, false))
        }
        (Area::Square(_), _) => {
            let right = "the scales of the drawing, such as torque_scale = \"600 N m/mm\" and angle_scale = \"3°/mm\", or area_scale = \"1400 J/cm²\"";
            Err(LayoutError::new("an area without a scale", right, place(text)))
        }
    }
}

fn areas(list: &List, scales: &Scales) -> Result<(Torque, bool), LayoutError> {
    let read: Vec<(BigRational, bool)> =
        not_too_many(list)?.iter().map(|text| area(text, scales)).collect::<Result<_, _>>()?;
    let in_joules = same_kind(read.iter().map(|(_, in_joules)| *in_joules), list.span())?;
    let areas: Vec<BigRational> = read.into_iter().map(|(area, _)| area).collect();
    let sum: BigRational = areas.iter().sum();
    if !sum.is_zero() {
        let size: BigRational = areas.iter().map(Signed::abs).sum();
        let percent = &sum / size * integer(100);
        // As many places as show that it is not 0.
        let places = |unit: &BigRational| (&percent * unit).round() / unit;
        let units = std::iter::successors(Some(integer(10)), |unit| Some(unit * integer(10)));
        let part = units.map(|unit| places(&unit)).find(|part| !part.is_zero()).unwrap_or_default();
        let (rest, part) = (remaining(&sum, in_joules, scales), exact_number(&part));
        let right = format!("areas above and below the mean whose sum is 0; {rest} remains, {part} % of all of them");
        return Err(LayoutError::new("the areas do not close over the cycle", right, place(list)));
    }
    Ok((Torque::Areas(areas), in_joules))
}

/// What is left of areas, in joules or, where torque and angle have scales, in square millimetres of the drawing.
fn remaining(sum: &BigRational, in_joules: bool, scales: &Scales) -> String {
    match scales {
        Scales { torque: Some(torque), angle: Some(angle), .. } if !in_joules => {
            format!("{} mm²", rounded(&(sum / (torque * angle) * integer(1_000_000))))
        }
        _ => format!("{} J", rounded(&(sum * integer(2)))),
    }
}

/// To six places; what that makes 0 stays a fraction.
fn rounded(value: &BigRational) -> String {
    let millionths = (value * BigRational::from_integer(1_000_000.into())).round().to_integer();
    if millionths.is_zero() {
        return value.to_string();
    }
    let digits = format!("{:07}", millionths.abs());
    let (before, after) = digits.split_at(digits.len() - 6);
    let after = after.trim_end_matches('0');
    let sign = if millionths.is_negative() { "-" } else { "" };
    let point = if after.is_empty() { "" } else { "." };
    format!("{sign}{before}{point}{after}")
}

/// Whether all are written in joules, or none is.
fn same_kind(kinds: impl Iterator<Item = bool>, span: std::ops::Range<usize>) -> Result<bool, LayoutError> {
    let kinds: Vec<bool> = kinds.collect();
    match kinds.iter().all(|kind| *kind == kinds[0]) {
        true => Ok(kinds[0]),
        false => Err(LayoutError::new("works in joules beside torques", "all in one way", Some(span))),
    }
}

fn triangles(all: &Spanned<Vec<Spanned<Table<TriangleKeys>>>>, scales: &Scales) -> Result<(Torque, bool), LayoutError> {
    let half = BigRational::new(1.into(), 2.into());
    let (mut lines, mut kinds) = (Vec::new(), Vec::new());
    let mut from = BigRational::zero();
    for one in not_too_many(all)? {
        let keys = &one.get_ref().0;
        let Some(width) = &keys.width else {
            return Err(LayoutError::new("a triangle without a width", "width = 180, in degrees", place(one)));
        };
        let wide = positive(width, "width", units::angle)?;
        let (peak, in_joules) = match (&keys.peak, &keys.area) {
            (Some(peak), None) => (value(peak, "torque", units::torque)?, false),
            (None, Some(text)) => {
                let (area, in_joules) = area(text, scales)?;
                (area / (&wide * &half), in_joules)
            }
            _ => {
                return Err(LayoutError::new("a triangle of no height, or of two", "its peak or its area", place(one)));
            }
        };
        kinds.push(in_joules);
        let (top, to) = (&from + &wide * &half, &from + wide);
        let zero = BigRational::zero();
        lines.push(Line { from, to: top.clone(), first: zero.clone(), last: peak.clone() });
        lines.push(Line { from: top, to: to.clone(), first: peak, last: zero });
        from = to;
    }
    let in_joules = same_kind(kinds.into_iter(), all.span())?;
    Ok((cycle(lines, all.span())?, in_joules))
}

fn harmonics(all: &Harmonics) -> Result<Vec<Harmonic>, LayoutError> {
    let harmonic = |one: &Spanned<Table<HarmonicKeys>>| {
        let keys = &one.get_ref().0;
        let Some(order) = &keys.order else {
            return Err(LayoutError::new("a harmonic without an order", "order = 2", place(one)));
        };
        let part = |text: &Option<Text>| {
            optional(text.as_ref(), |text| value(text, "torque", units::torque)).map(Option::unwrap_or_default)
        };
        Ok(Harmonic {
            order: order.get_ref().0.parse().map_err(|_| misread(order, "order", "such as 2, or 1/2"))?,
            cos: part(&keys.cos)?,
            sin: part(&keys.sin)?,
        })
    };
    not_too_many(all)?.iter().map(harmonic).collect()
}
