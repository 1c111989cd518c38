//! Is the sum a product of two, so that it vanishes where either does? Groups of parts that are multiples of each other.

use std::collections::BTreeMap;

use num_rational::BigRational;

use super::super::Part;
use super::super::solve::{self, Never, When};
use super::split::{apart, directions};
use crate::exact::PhasorSum;
use crate::proof::Certificate;

/// `(Σ_j S_{0j} e^{ix_j}) · (Σ_g S_{g0} e^{iy_g}) / S_{00}`: the first group, times the first parts of all.
#[derive(Clone, Debug)]
pub struct Product {
    /// The places of the parts of each group among those that are left.
    pub groups: Vec<Vec<usize>>,
    /// Evidence that `S_{gj} S_{00} − S_{g0} S_{0j}` is zero, group by group from the second on, without the first part of each.
    pub certificates: Vec<Certificate>,
    /// When the first group vanishes.
    pub group: When,
    /// When the first parts cancel.
    pub firsts: When,
}

/// When a product vanishes; `None` where the sum is none.
pub(super) fn when(parts: &[&Part]) -> Option<When> {
    let (groups, certificates) = directions(parts).find_map(|direction| factored(parts, &direction))?;
    let of_places = |places: Vec<usize>| solve::when(&places.into_iter().map(|at| parts[at]).collect::<Vec<_>>());
    let group = of_places(groups.first()?.clone());
    let firsts = of_places(groups.iter().filter_map(|group| group.first().copied()).collect());
    let is_never = |when: &When| matches!(when, When::Never(_));
    let never = is_never(&group) && is_never(&firsts);
    let product = Box::new(Product { groups, certificates, group, firsts });
    Some(if never { When::Never(Never::Product(product)) } else { When::Product(product) })
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
            let difference = PhasorSum::new(outer.minus(&inner).collected());
            if !difference.vanishes() {
                return None;
            }
            certificates.push(difference.certificate());
        }
    }
    Some((groups, certificates))
}
