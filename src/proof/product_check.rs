//! Is a sum the product of two, and does it vanish where one of them does?
//!
//! With `S_{gj} S_{00} = S_{g0} S_{0j}` and each group turned within itself as the first, `S_{00} Σ_g Σ_j S_{gj} e^{i(y_g + x_j)}` is
//! `(Σ_g S_{g0} e^{iy_g}) (Σ_j S_{0j} e^{ix_j})`, and `S_{00}` is not zero.

use super::audit::{Audit, Reason};
use super::check::certify;
use super::collected::collect;
use super::plane::ProductClaim;
use super::unknown::times;
use super::when::{Part, check_when};

/// Checks the groups, and when both factors vanish.
pub(super) fn check_product(claim: &ProductClaim, left: &[Part<'_>], audit: &Audit) -> Result<(), Reason> {
    let mut places: Vec<usize> = claim.groups.iter().flatten().copied().collect();
    places.sort_unstable();
    if !places.into_iter().eq(0..left.len()) {
        return Err("the groups do not hold each part that does not vanish once".into());
    }
    let (Some(first), [_, _, ..]) = (claim.groups.first(), claim.groups.as_slice()) else {
        return Err("there are two groups at least".into());
    };
    // So that both factors have fewer parts than the whole.
    if first.len() < 2 || claim.groups.iter().any(|group| group.len() != first.len()) {
        return Err("the groups have equally many parts, two at least".into());
    }
    let others = claim.groups.iter().skip(1);
    let pairs: Vec<[usize; 3]> = others
        .flat_map(|group| group.iter().zip(first).skip(1).map(|(&place, &like)| [group[0], place, like]))
        .collect();
    if pairs.len() != claim.certificates.len() {
        return Err(format!("{} certificates for {} parts", claim.certificates.len(), pairs.len()).into());
    }
    let start = &left[first[0]];
    for ([group, place, like], certificate) in pairs.into_iter().zip(&claim.certificates) {
        let [part, base, other] = [place, group, like].map(|at| &left[at]);
        if part.turned_against(base) != other.turned_against(start) {
            return Err("a group is not turned within itself as the first".into());
        }
        let mut terms = times(part.sum(), start.sum(), |s, t| s + t, audit)?;
        terms.extend(
            times(base.sum(), other.sum(), |s, t| s + t, audit)?.into_iter().map(|(angle, weight)| (angle, -weight)),
        );
        certify(&collect(terms, audit)?, true, certificate, audit)?;
    }
    let parts = |places: &mut dyn Iterator<Item = usize>| places.map(|at| left[at].clone()).collect::<Vec<_>>();
    check_when(&claim.group, &parts(&mut first.iter().copied()), audit)?;
    check_when(&claim.firsts, &parts(&mut claim.groups.iter().map(|group| group[0])), audit)
}
