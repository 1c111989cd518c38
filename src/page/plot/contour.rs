//! Where has a map a given value? Lines between the middles of its cells, by marching squares.

use std::collections::BTreeMap;

use super::super::figure::Point;

/// An edge of the grid of middles: from which column and row, and whether it goes upwards.
type Edge = (usize, usize, bool);

/// The lines of one value over a grid of values in rows; places are columns and rows, the middle of the first cell at 0.
///
/// No line crosses a square with a value that is not finite.
pub(super) fn contour(rows: &[Vec<f64>], level: f64) -> Vec<Vec<Point>> {
    let mut next: BTreeMap<Edge, Vec<Edge>> = BTreeMap::new();
    let mut join = |a: Edge, b: Edge| {
        next.entry(a).or_default().push(b);
        next.entry(b).or_default().push(a);
    };
    for (y, pair) in rows.windows(2).enumerate() {
        for x in 1..pair[0].len().min(pair[1].len()) {
            let x = x - 1;
            let corners = [pair[0][x], pair[0][x + 1], pair[1][x + 1], pair[1][x]];
            if corners.iter().any(|value| !value.is_finite()) {
                continue;
            }
            let above = corners.map(|value| value > level);
            let edges: [Edge; 4] = [(x, y, false), (x + 1, y, true), (x, y + 1, false), (x, y, true)];
            let crossed: Vec<Edge> =
                (0..4).filter(|side| above[*side] != above[(side + 1) % 4]).map(|side| edges[side]).collect();
            match crossed[..] {
                [a, b] => join(a, b),
                [a, b, c, d] => {
                    // A saddle: its middle says which corners belong together.
                    let middle = corners.iter().sum::<f64>() / 4.0 > level;
                    let (first, second) = if middle == above[0] { ((a, b), (c, d)) } else { ((d, a), (b, c)) };
                    join(first.0, first.1);
                    join(second.0, second.1);
                }
                _ => {}
            }
        }
    }
    chains(next).into_iter().map(|chain| chain.into_iter().map(|edge| place(rows, level, edge)).collect()).collect()
}

/// Edges in the order in which lines cross them: open lines first, then rings.
fn chains(mut next: BTreeMap<Edge, Vec<Edge>>) -> Vec<Vec<Edge>> {
    let mut starts: Vec<Edge> = next.iter().filter(|(_, ends)| ends.len() == 1).map(|(edge, _)| *edge).collect();
    starts.extend(next.keys());
    let mut chains = Vec::new();
    for start in starts {
        let (mut at, mut chain) = (start, vec![start]);
        while let Some(to) = next.get_mut(&at).and_then(Vec::pop) {
            if let Some(back) = next.get_mut(&to)
                && let Some(index) = back.iter().position(|edge| *edge == at)
            {
                back.remove(index);
            }
            chain.push(to);
            at = to;
        }
        if chain.len() > 1 {
            chains.push(chain);
        }
    }
    chains
}

/// Where the value is on an edge, between the values of its ends.
fn place(rows: &[Vec<f64>], level: f64, (x, y, up): Edge) -> Point {
    let (to_x, to_y) = if up { (x, y + 1) } else { (x + 1, y) };
    let (from, to) = (rows[y][x], rows[to_y][to_x]);
    let part = ((level - from) / (to - from)).clamp(0.0, 1.0);
    let (x, y) = (x as f64, y as f64);
    if up { Point::new(x, y + part) } else { Point::new(x + part, y) }
}
