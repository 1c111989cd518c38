//! Is the sum a product of two, so that it vanishes where either does? Groups of parts that are multiples of each other.

use std::collections::BTreeMap;

use num_rational::BigRational;

use super::super::part::Part;
use super::split::{apart, directions};
use crate::proof::Certificate;

/// The places of the parts of each group, and the evidence for them; `None` where the sum is no product.
pub(in super::super) fn groups(parts: &[&Part]) -> Option<(Vec<Vec<usize>>, Vec<Certificate>)> {
    directions(parts).find_map(|direction| factored(parts, &direction))
}

/// The groups of parts on lines in a direction, where all are multiples of the first, with evidence.
fn factored(parts: &[&Part], [phi, delta]: &[BigRational; 2]) -> Option<(Vec<Vec<usize>>, Vec<Certificate>)> {
    let mut lines: BTreeMap<BigRational, Vec<usize>> = BTreeMap::new();
    for (place, part) in parts.iter().enumerate() {
        lines.entry(&part.phi * delta - &part.delta * phi).or_default().push(place);
    }
    let mut groups: Vec<Vec<usize>> = lines.into_values().collect();
    groups.sort();
    let (first, others) = groups.split_first()?;
    if others.is_empty() || first.len() < 2 || others.iter().any(|group| group.len() != first.len()) {
        return None;
    }
    let mut certificates = Vec::new();
    for group in others {
        for (&place, &like) in group.iter().zip(first).skip(1) {
            if apart(parts[place], parts[group[0]]) != apart(parts[like], parts[first[0]]) {
                return None;
            }
            let [outer, inner] = [[place, first[0]], [group[0], like]].map(|[a, b]| parts[a].sum.times(&parts[b].sum));
            let difference = outer.minus(&inner).tidied();
            if !difference.vanishes() {
                return None;
            }
            certificates.push(difference.certificate());
        }
    }
    Some((groups, certificates))
}
