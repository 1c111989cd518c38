//! Into which two classes, or three, do the parts fall, so that one angle turns the parts in each, and another the classes?

use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::super::part::Part;
use crate::exact::fraction;

/// u may enter this many times in one class; in the squared lengths it enters twice as often.
const HIGHEST_TIMES: i64 = 2048;

/// Two angles, `[phi, delta]` times φ and δ, and the parts of two classes, or three.
pub(super) struct Split<const N: usize> {
    /// What turns the parts of one class against each other.
    pub u: [BigRational; 2],
    /// What turns the first part of the second class against that of the first.
    pub v: [BigRational; 2],
    /// How many times u turns a part, with its place: of two classes against the first of its own; of three against the first of the first class,
    /// turned by v once in the second class, and twice in the third.
    pub classes: [Vec<(i64, usize)>; N],
}

/// How many times more φ and δ turn a part than another.
pub(super) fn apart(part: &Part, other: &Part) -> [BigRational; 2] {
    [&part.phi - &other.phi, &part.delta - &other.delta]
}

/// Splits parts in rising order.
pub(super) fn split(parts: &[&Part]) -> Option<Split<2>> {
    directions(parts).find_map(|direction| along(parts, direction))
}

/// Along δ, along φ, and along the lines from one part to another, each direction once.
pub(super) fn directions(parts: &[&Part]) -> impl Iterator<Item = [BigRational; 2]> {
    let axes = [[0, 1], [1, 0]].map(|axis: [i64; 2]| axis.map(|times| BigRational::from_integer(times.into())));
    let pairs = parts.iter().enumerate().flat_map(|(i, low)| parts[i + 1..].iter().map(|high| apart(high, low)));
    let mut tried: BTreeSet<Option<BigRational>> = BTreeSet::new();
    let is_new = move |[phi, delta]: &[BigRational; 2]| tried.insert((!phi.is_zero()).then(|| delta / phi));
    let all: Vec<[BigRational; 2]> = axes.into_iter().chain(pairs).collect();
    all.into_iter().filter(is_new)
}

/// The two classes of parts that are on lines in a direction, where there are two.
fn along(parts: &[&Part], direction: [BigRational; 2]) -> Option<Split<2>> {
    let start = *parts.first()?;
    let across = |part: &Part| {
        let [phi, delta] = apart(part, start);
        phi * &direction[1] - delta * &direction[0]
    };
    let (first, second): (Vec<usize>, Vec<usize>) = (0..parts.len()).partition(|&place| across(parts[place]).is_zero());
    let other = *parts.get(*second.first()?)?;
    let line = across(other);
    if second.iter().any(|&place| across(parts[place]) != line) {
        return None;
    }
    let axis = usize::from(direction[0].is_zero());
    let times = |place: usize, from: &Part| &apart(parts[place], from)[axis] / &direction[axis];
    let placed = [(first, start), (second, other)]
        .map(|(places, from)| places.into_iter().map(|place| (times(place, from), place)).collect::<Vec<_>>());
    let (u, classes) = in_whole_times(&placed, direction, 0..=HIGHEST_TIMES)?;
    Some(Split { u, v: apart(other, start), classes })
}

/// Parts of a class, each by how many whole times a direction it is turned, and its place.
type InWholeTimes = Vec<(i64, usize)>;

/// The largest multiple of a direction that all parts of these classes are turned by whole times, and how many times that is.
fn in_whole_times<const N: usize>(
    placed: &[Vec<(BigRational, usize)>; N],
    direction: [BigRational; 2],
    range: RangeInclusive<i64>,
) -> Option<([BigRational; 2], [InWholeTimes; N])> {
    let unit = fraction::common_unit(placed.iter().flatten().map(|(times, _)| times));
    if unit.is_zero() {
        return None;
    }
    let whole = |(times, place): &(BigRational, usize)| {
        Some(((times / &unit).to_integer().to_i64().filter(|times| range.contains(times))?, *place))
    };
    let classes = placed.iter().map(|class| class.iter().map(whole).collect()).collect::<Option<Vec<_>>>()?;
    Some((direction.map(|times| times * &unit), classes.try_into().ok()?))
}

/// u may enter this many times in one of three classes.
const HIGHEST_OF_THREE: i64 = 256;

/// Splits parts in rising order into three classes on lines that are equally far apart.
pub(super) fn three(parts: &[&Part]) -> Option<Split<3>> {
    directions(parts).find_map(|direction| three_along(parts, direction))
}

fn three_along(parts: &[&Part], direction: [BigRational; 2]) -> Option<Split<3>> {
    let start = *parts.first()?;
    let mut lines: BTreeMap<BigRational, Vec<usize>> = BTreeMap::new();
    for (place, part) in parts.iter().enumerate() {
        let [phi, delta] = apart(part, start);
        lines.entry(phi * &direction[1] - delta * &direction[0]).or_default().push(place);
    }
    let offsets: Vec<&BigRational> = lines.keys().collect();
    let [low, middle, high] = offsets.as_slice() else { return None };
    if *middle - *low != *high - *middle {
        return None;
    }
    let lines: Vec<Vec<usize>> = lines.into_values().collect();
    let [first, second, third] = <[Vec<usize>; 3]>::try_from(lines).ok()?;
    let of = |places: &[usize]| places.first().map(|place| parts[*place]);
    let v = apart(of(&second)?, of(&first)?);
    let axis = usize::from(direction[0].is_zero());
    let from = of(&first)?;
    let times = |place: usize, turns: i64| {
        let turned = &v[axis] * BigRational::from_integer(turns.into());
        (&apart(parts[place], from)[axis] - turned) / &direction[axis]
    };
    let placed = [(first, 0), (second, 1), (third, 2)]
        .map(|(places, turns)| places.into_iter().map(|place| (times(place, turns), place)).collect::<Vec<_>>());
    let (u, classes) = in_whole_times(&placed, direction, -HIGHEST_OF_THREE..=HIGHEST_OF_THREE)?;
    Some(Split { u, v, classes })
}
